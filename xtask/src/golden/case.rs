//! A golden case, as its file says it.

use serde::Deserialize;
use serde::de::{Deserializer, MapAccess, Visitor};
use std::fmt;

/// A case as `case.ron` has it.
///
/// ```ron
/// Case(
///     args: ["walk", "--steps", "4"],              // of `solaris`; `-o FILE.csv` is added
///     tolerances: { "time": 1e-12, "*.q": 1e-9 },  // absolute, in the column's unit; the first that fits counts
///     note: "where the numbers come from",
///     every: 10,                                   // keep each tenth row; all without this
///     columns: ["*.q", "*.fy"],                    // keep these and `time`; all without this
/// )
/// ```
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Case {
    pub(crate) args: Vec<String>,
    pub(crate) tolerances: Tolerances,
    pub(crate) note: String,
    #[serde(default = "one")]
    pub(crate) every: usize,
    #[serde(default)]
    pub(crate) columns: Vec<String>,
}

/// Patterns and absolute tolerances, in the order in which they are written.
#[derive(Debug, PartialEq)]
pub(crate) struct Tolerances(pub(crate) Vec<(String, f64)>);

impl Case {
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        let case: Self =
            ron::from_str(text).map_err(|error| format!("{}: {}", error.span.start, error.code))?;
        let bad =
            case.tolerances.0.iter().find(|(_, tolerance)| !(tolerance.is_finite() && *tolerance >= 0.0));
        if let Some((pattern, tolerance)) = bad {
            return Err(format!(
                "tolerance of \"{pattern}\" is {tolerance}; it must be a finite number, zero or more"
            ));
        }
        if case.every == 0 {
            return Err("every is 0; to keep all rows, write 1 or nothing".to_owned());
        }
        if case.note.trim().is_empty() {
            return Err("note is empty; say where the numbers come from".to_owned());
        }
        Ok(case)
    }
}

impl Tolerances {
    /// The tolerance of a column: that of the first pattern that fits.
    pub(crate) fn of(&self, column: &str) -> Option<f64> {
        self.0.iter().find(|(pattern, _)| fits(pattern, column)).map(|(_, tolerance)| *tolerance)
    }
}

impl<'de> Deserialize<'de> for Tolerances {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(InOrder)
    }
}

/// Reads a map without losing its order.
struct InOrder;

impl<'de> Visitor<'de> for InOrder {
    type Value = Tolerances;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a map of column patterns and tolerances")
    }

    fn visit_map<M: MapAccess<'de>>(self, mut map: M) -> Result<Tolerances, M::Error> {
        let mut entries = Vec::new();
        while let Some(entry) = map.next_entry()? {
            entries.push(entry);
        }
        Ok(Tolerances(entries))
    }
}

/// Whether `name` fits `pattern`, in which each `*` stands for any text.
pub(crate) fn fits(pattern: &str, name: &str) -> bool {
    let Some((before, after)) = pattern.split_once('*') else { return pattern == name };
    let Some(rest) = name.strip_prefix(before) else { return false };
    rest.char_indices().map(|(at, _)| at).chain([rest.len()]).any(|at| fits(after, &rest[at..]))
}

fn one() -> usize {
    1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_case_is_read_in_order() {
        let text =
            r#"Case(args: ["walk"], tolerances: {"root.*": 1e-6, "*.q": 1e-9, "*": 1.0}, note: "made up")"#;
        let case = Case::parse(text).expect("well-formed");
        assert_eq!((case.every, case.columns.len()), (1, 0));
        let of = |column| case.tolerances.of(column).map(f64::to_bits);
        assert_eq!(of("root.tx.q"), Some(1e-6_f64.to_bits()));
        assert_eq!(of("head.rx.q"), Some(1e-9_f64.to_bits()));
        assert_eq!(of("time"), Some(1.0_f64.to_bits()));
    }

    #[test]
    fn mistakes_in_a_case_are_answered() {
        let parse = |text| Case::parse(text).expect_err("a mistake");
        let answers = [
            parse("Case(args: [], tolerances: {}, note: \"x\",\n  evry: 3)"),
            parse("Case(args: [], tolerances: {\"*\": -1.0}, note: \"x\")"),
            parse("Case(args: [], tolerances: {\"*\": 1.0}, note: \" \")"),
            parse("Case(args: [], tolerances: {\"*\": 1.0}, note: \"x\", every: 0)"),
        ];
        insta::assert_snapshot!(answers.join("\n"), @r#"
        2:3: Unexpected field named `evry` in `Case`, expected one of `args`, `tolerances`, `note`, `every`, or `columns` instead
        tolerance of "*" is -1; it must be a finite number, zero or more
        note is empty; say where the numbers come from
        every is 0; to keep all rows, write 1 or nothing
        "#);
    }

    #[test]
    fn stars_stand_for_any_text() {
        for (pattern, name, expected) in [
            ("time", "time", true),
            ("time", "times", false),
            ("*", "", true),
            ("*.q", "root.tx.q", true),
            ("*.q", "root.tx.qq", false),
            ("left_*.r*.q", "left_hip.rx.q", true),
            ("left_*.r*.q", "right_hip.rx.q", false),
            ("*é*", "née", true),
        ] {
            assert_eq!(fits(pattern, name), expected, "{pattern} {name}");
        }
    }
}
