//! Names that an unknown one may be meant for.

/// The name in `names` that is nearest to `wanted`, if any is near: what a message about an unknown name can suggest.
pub fn nearest<'a>(wanted: &str, names: impl Iterator<Item = &'a str>) -> Option<String> {
    // So far is near: of four letters two would be half of the name. Lengths differ by no more than the names do, and nobody mistypes a name of many lines.
    let near = if wanted.len() < 5 { 1 } else { 2.max(wanted.len() / 3) };
    let is_close = |name: &&str| name.len().abs_diff(wanted.len()) <= 4 * near;
    names
        .filter(|name| wanted.len() <= LONGEST_NAME && is_close(name))
        .map(|name| (edit_distance(wanted, name), name))
        .min()
        .filter(|(distance, _)| *distance <= near)
        .map(|(_, name)| name.to_owned())
}

/// The longest name (bytes) for which a near one is sought.
const LONGEST_NAME: usize = 200;

/// Letters to add, leave out, replace, or exchange with the next one.
fn edit_distance(a: &str, b: &str) -> usize {
    let [a, b] = [a, b].map(|text| text.chars().collect::<Vec<char>>());
    let mut rows = vec![(0..=b.len()).collect::<Vec<usize>>()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = replaced.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

/// What a message about the unknown name `wanted` ends with: `; did you mean 'NEAREST'?`, or nothing where none is near.
pub fn did_you_mean<'a>(wanted: &str, names: impl Iterator<Item = &'a str>) -> String {
    nearest(wanted, names).map_or_else(String::new, |near| format!("; did you mean '{near}'?"))
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn what_is_near_depends_on_how_long_a_name_is() {
        let names = ["tilt", "height", "left_thigh"];
        let near = |wanted: &str| nearest(wanted, names.into_iter());
        assert_eq!(near("hieght").as_deref(), Some("height"));
        assert_eq!(near("lft_thihg").as_deref(), Some("left_thigh"));
        assert_eq!((near("tit").as_deref(), near("tlit").as_deref()), (Some("tilt"), Some("tilt")));
        assert_eq!((near("time"), near("thigh")), (None, None));
    }
}
