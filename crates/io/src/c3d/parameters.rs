//! The parameters: named values in named groups.

use super::bytes::Bytes;
use super::header::{BLOCK, Header};
use std::collections::HashMap;

/// All parameters of a file, by group and name in capitals.
pub(super) struct Parameters<'a> {
    found: HashMap<(String, String), Parameter<'a>>,
    bytes: Bytes<'a>,
    /// Where they end too early, and why, if they do.
    pub(super) broken: Option<Broken>,
}

/// Where the list of parameters makes no sense any more.
#[derive(Clone, Debug)]
pub(super) struct Broken {
    pub(super) offset: usize,
    pub(super) why: String,
}

/// One parameter.
pub(super) struct Parameter<'a> {
    /// −1 letters, 1 bytes, 2 words, 4 reals.
    kind: i8,
    pub(super) dimensions: Vec<usize>,
    data: &'a [u8],
    /// Where its data begin.
    pub(super) offset: usize,
}

/// Reads the parameters as far as they make sense.
pub(super) fn parameters<'a>(bytes: Bytes<'a>, header: &Header) -> Parameters<'a> {
    let mut all = Parameters { found: HashMap::new(), bytes, broken: None };
    let mut groups: HashMap<i8, String> = HashMap::new();
    let mut own: Vec<(i8, String, Parameter<'a>)> = Vec::new();
    let mut at = header.parameters + 4;
    // Some files have a last record that says where a next one would be.
    let data = usize::from(header.data).saturating_sub(1) * BLOCK;
    let end = if data > header.parameters { data } else { bytes.bytes.len() };
    while at < end {
        match record(bytes, at) {
            Ok(Some((id, name, parameter, next))) => {
                match parameter {
                    None => drop(groups.insert(id, name)),
                    Some(parameter) if parameter.offset + parameter.data.len() > end => {
                        all.broken =
                            Some(Broken { offset: at, why: format!("'{name}' runs into the frames") });
                        break;
                    }
                    Some(parameter) => own.push((id, name, parameter)),
                }
                match next {
                    Some(next) => at = next,
                    None => break,
                }
            }
            Ok(None) => break,
            Err(why) => {
                all.broken = Some(Broken { offset: at, why });
                break;
            }
        }
    }
    for (id, name, parameter) in own {
        // A parameter may stand before its group, so that names come last.
        let group = groups.get(&-id).cloned().unwrap_or_default();
        all.found.entry((group, name)).or_insert(parameter);
    }
    all
}

/// A group (without a parameter) or a parameter with its group's number and name, and where the next one begins.
type Record<'a> = (i8, String, Option<Parameter<'a>>, Option<usize>);

/// The record at `at`, or why it is none.
fn record(bytes: Bytes<'_>, at: usize) -> Result<Option<Record<'_>>, String> {
    let cut = |_| "the file ends there".to_owned();
    let get = |offset: usize, length: usize| bytes.slice("", offset, length).map_err(cut);
    let head = get(at, 2)?;
    let (length, id) = (usize::from((head[0] as i8).unsigned_abs()), head[1] as i8);
    if length == 0 || id == 0 {
        return Ok(None);
    }
    let name = get(at + 2, length)?;
    if !name.iter().all(|letter| letter.is_ascii_graphic() || *letter == b' ') {
        return Err("its name has bytes that are no letters".to_owned());
    }
    let name = String::from_utf8_lossy(name).trim().to_ascii_uppercase();
    let link = at + 2 + length;
    get(link, 2)?;
    let step = bytes.word("", link).map_err(cut)? as i16;
    if step < 0 {
        return Err(format!("the next one of '{name}' is {step} bytes away"));
    }
    let next = (step > 0).then(|| link + step as usize);
    if id < 0 {
        return Ok(Some((id, name, None, next)));
    }
    let shape = get(link + 2, 2)?;
    let (kind, count) = (shape[0] as i8, usize::from(shape[1]));
    if !matches!(kind, -1 | 1 | 2 | 4) || count > 7 {
        return Err(format!("'{name}' is of type {kind} with {count} dimensions"));
    }
    let dimensions: Vec<usize> = get(link + 4, count)?.iter().map(|size| usize::from(*size)).collect();
    let items = dimensions.iter().try_fold(1_usize, |product, size| product.checked_mul(*size));
    let length = items.and_then(|items| items.checked_mul(usize::from(kind.unsigned_abs())));
    let offset = link + 4 + count;
    let data = length.and_then(|length| bytes.slice("", offset, length).ok());
    let data = data.ok_or_else(|| format!("'{name}' is longer than the file"))?;
    Ok(Some((id, name, Some(Parameter { kind, dimensions, data, offset }), next)))
}

impl<'a> Parameters<'a> {
    /// The parameter `name` of `group`.
    pub(super) fn get(&self, group: &str, name: &str) -> Option<&Parameter<'a>> {
        self.found.get(&(group.to_owned(), name.to_owned()))
    }

    /// Whether the group has any parameter.
    pub(super) fn has_group(&self, group: &str) -> bool {
        self.found.keys().any(|(known, _)| known == group)
    }

    /// The numbers of a parameter as they stand; whole ones with their sign.
    pub(super) fn numbers(&self, group: &str, name: &str) -> Vec<f64> {
        let Some(parameter) = self.get(group, name) else { return Vec::new() };
        let machine = self.bytes.machine;
        match parameter.kind {
            1 => parameter.data.iter().map(|byte| f64::from(*byte)).collect(),
            2 => parameter
                .data
                .as_chunks()
                .0
                .iter()
                .map(|pair| f64::from(machine.word(*pair) as i16))
                .collect(),
            4 => parameter.data.as_chunks().0.iter().map(|four| f64::from(machine.real(*four))).collect(),
            _ => Vec::new(),
        }
    }

    /// The numbers of a parameter; whole ones without a sign, as counts are.
    pub(super) fn counts(&self, group: &str, name: &str) -> Vec<f64> {
        let is_whole = self.get(group, name).is_some_and(|parameter| parameter.kind == 2);
        let plain = |value: f64| if is_whole && value < 0.0 { value + 65536.0 } else { value };
        self.numbers(group, name).into_iter().map(plain).collect()
    }

    /// The first number of a parameter as a count, which a word holds.
    pub(super) fn count(&self, group: &str, name: &str) -> Option<usize> {
        let count = self.counts(group, name).first().copied()?;
        (0.0..=65535.0).contains(&count).then_some(count as usize)
    }

    /// The first number of a parameter, if it is finite.
    pub(super) fn number(&self, group: &str, name: &str) -> Option<f64> {
        self.numbers(group, name).first().copied().filter(|value| value.is_finite())
    }

    /// The texts of a parameter, without the blanks around them.
    pub(super) fn texts(&self, group: &str, name: &str) -> Vec<String> {
        let Some(parameter) = self.get(group, name).filter(|parameter| parameter.kind == -1) else {
            return Vec::new();
        };
        let length = parameter.dimensions.first().copied().unwrap_or(1).max(1);
        let clean = |text: &[u8]| {
            let text: String = text.iter().map(|byte| char::from(*byte)).collect();
            text.trim_matches(|c: char| c.is_whitespace() || c == '\0').to_owned()
        };
        parameter.data.chunks(length).map(clean).collect()
    }

    /// What `list` gives of `name`, `name2`, `name3`, … one after the other: a parameter holds no more than 255.
    pub(super) fn continued<T>(
        &self,
        group: &str,
        name: &str,
        list: impl Fn(&Self, &str, &str) -> Vec<T>,
    ) -> Vec<T> {
        let mut all = list(self, group, name);
        for number in 2.. {
            let name = format!("{name}{number}");
            if self.get(group, &name).is_none() {
                break;
            }
            all.extend(list(self, group, &name));
        }
        all
    }
}
