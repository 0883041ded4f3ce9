//! Names of markers, each one's own.

use std::collections::HashSet;

/// `names` with those that are empty called `unnamed_1`, … and those that are there before called `name_2`, …; beside them
/// what was changed, as it was and as it is.
pub(crate) fn unique(names: Vec<String>) -> (Vec<String>, Vec<(String, String)>) {
    let given: HashSet<String> = names.iter().cloned().collect();
    let mut taken = HashSet::new();
    let mut changed = Vec::new();
    let mut unnamed = 0;
    let own = names.into_iter().map(|name| {
        let mut own = name.clone();
        if own.is_empty() {
            unnamed += 1;
            own = format!("unnamed_{unnamed}");
        }
        let stem = own.clone();
        let mut count = 1;
        while taken.contains(&own) || (own != name && given.contains(&own)) {
            count += 1;
            own = format!("{stem}_{count}");
        }
        taken.insert(own.clone());
        if own != name {
            changed.push((name, own.clone()));
        }
        own
    });
    (own.collect(), changed)
}

/// A number of things: `1 line`, `2 lines`.
pub(crate) fn counted(count: usize, one: &str) -> String {
    if count == 1 { format!("1 {one}") } else { format!("{count} {one}s") }
}

#[cfg(test)]
mod tests {
    use super::unique;

    #[test]
    fn every_marker_gets_a_name_of_its_own() {
        let names = ["a", "", "a", "a_2", ""].map(str::to_owned).to_vec();
        let (own, changed) = unique(names);
        assert_eq!(own, ["a", "unnamed_1", "a_3", "a_2", "unnamed_2"]);
        assert_eq!(changed.len(), 3);
    }
}
