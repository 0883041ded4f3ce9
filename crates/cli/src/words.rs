//! Numbers and names as people read them.

/// A mass as people read it: to a milligram. JSON has all digits.
pub(crate) fn rounded(mass: f64) -> String {
    let text = format!("{mass:.6}");
    text.trim_end_matches('0').trim_end_matches('.').trim_start_matches('-').to_owned()
}

/// Names as far as a person reads them.
pub(crate) fn some(names: &[String]) -> String {
    const MANY: usize = 8;
    let shown = names[..names.len().min(MANY)].join(", ");
    if names.len() > MANY { format!("{shown} and {} more", names.len() - MANY) } else { shown }
}
