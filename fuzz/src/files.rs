//! Several files in one input, for models that name others.

use solaris_io::Loader;

/// Begins the line with the name of another file.
const MARK: &[u8] = b"\n==== ";

/// Files in memory.
pub struct Files<'a> {
    /// The first: the model's own.
    pub main: &'a [u8],
    others: Vec<(&'a [u8], &'a [u8])>,
}

impl<'a> Files<'a> {
    /// The files of an input: its beginning, then each after a line `==== NAME`.
    pub fn of(bytes: &'a [u8]) -> Self {
        let at = |bytes: &[u8]| bytes.windows(MARK.len()).position(|window| window == MARK);
        let (main, mut rest) = bytes.split_at(at(bytes).unwrap_or(bytes.len()));
        let mut others = Vec::new();
        while !rest.is_empty() {
            let part = &rest[MARK.len()..];
            let (part, next) = part.split_at(at(part).unwrap_or(part.len()));
            let end = part.iter().position(|byte| *byte == b'\n').unwrap_or(part.len());
            others.push((part[..end].trim_ascii(), &part[(end + 1).min(part.len())..]));
            rest = next;
        }
        Self { main, others }
    }
}

impl Loader for Files<'_> {
    fn load(&mut self, path: &str) -> Result<Vec<u8>, String> {
        let found = self.others.iter().find(|(name, _)| *name == path.as_bytes());
        found.map(|(_, bytes)| bytes.to_vec()).ok_or_else(|| "there is no such file".to_owned())
    }
}
