//! What a package says of itself: its README is all that somebody who finds it alone will read.

use crate::workspace::Package;
use std::fs;
use std::path::Path;

/// Blocks that count as an example; each kind is run by tests.
const EXAMPLES: [&str; 3] = ["\n```rust\n", "\n```console\n", "\n```c\n"];

/// What a README lacks.
pub(super) fn faults(package: &Package) -> Vec<String> {
    let folder = package.manifest_path.parent().unwrap_or(Path::new("."));
    let Ok(text) = fs::read_to_string(folder.join("README.md")) else {
        return vec!["no README.md".to_owned()];
    };
    let features = package.features.keys().map(String::as_str);
    lacking(&text, &package.name, features, |link| folder.join(link).is_file())
}

fn lacking<'a>(
    text: &str,
    name: &str,
    features: impl Iterator<Item = &'a str>,
    is_there: impl Fn(&str) -> bool,
) -> Vec<String> {
    let mut faults = Vec::new();
    if !text.starts_with(&format!("# {name}\n")) {
        faults.push(format!("its README.md does not begin with '# {name}'"));
    }
    if !EXAMPLES.iter().any(|block| text.contains(block)) {
        faults.push("its README.md has no example".to_owned());
    }
    for feature in features.filter(|feature| *feature != "default" && !text.contains(&format!("`{feature}`")))
    {
        faults.push(format!("its README.md does not say what the feature `{feature}` is"));
    }
    let links = text.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(link, _)| link);
    // Others are addresses, places on the page, or Rust's names.
    let files =
        links.filter(|link| !link.starts_with("http") && !link.starts_with('#') && !link.contains("::"));
    for link in files.filter(|link| link.contains(['/', '.'])) {
        if link.starts_with("..") || !is_there(link) {
            faults.push(format!("its README.md leads to {link}, which is not in the package"));
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(text: &str) -> Vec<String> {
        lacking(text, "sun", ["default", "warm"].into_iter(), |link| link == "here.h")
    }

    #[test]
    fn a_readme_that_is_enough_has_no_faults() {
        let text = "# sun\n\nIt is `warm`: [here](here.h), [there](https://example.org), [A](sun::A), [B](B).\n\n```rust\n```\n";
        assert_eq!(found(text), Vec::<String>::new());
    }

    #[test]
    fn each_thing_that_lacks_is_named() {
        let text = "# moon\n\n[up](../README.md) [gone](gone.h)\n";
        let found = found(text);
        for lacking in ["'# sun'", "no example", "`warm`", "../README.md", "gone.h"] {
            assert!(found.iter().any(|fault| fault.contains(lacking)), "{lacking}: {found:?}");
        }
        assert_eq!(found.len(), 5);
    }
}
