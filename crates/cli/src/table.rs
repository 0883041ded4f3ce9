//! The table of a planned motion's numbers, as it is printed and as it stands on a page.

use solaris::gait::{JointPeaks, Peak};
use solaris::view::TableRow;

/// One line: what, how much, unit, and what to hold it against.
pub(crate) struct Row {
    label: &'static str,
    value: String,
    unit: &'static str,
    note: String,
}

pub(crate) fn row(
    label: &'static str,
    value: impl Into<String>,
    unit: &'static str,
    note: impl Into<String>,
) -> Row {
    Row { label, value: value.into(), unit, note: note.into() }
}

/// As it is printed.
pub(crate) fn lines(rows: &[Row]) -> String {
    let line = |Row { label, value, unit, note }: &Row| {
        // A long label leaves less to its value.
        let room = 40 - label.chars().count().min(40);
        let line = format!("  {label} {value:>room$} {unit:<9} {note}");
        line.trim_end().to_owned() + "\n"
    };
    rows.iter().map(line).collect()
}

/// As it stands on a page.
pub(crate) fn on_page(rows: &[Row]) -> Vec<TableRow> {
    rows.iter().map(|r| TableRow::new(r.label, &r.value, r.unit, &r.note)).collect()
}

/// When it was.
pub(crate) fn at(peak: Peak) -> String {
    format!("at {:.2} s", peak.time)
}

/// Moments and powers of hips, knees and ankles.
pub(crate) fn joint_rows(joints: &[JointPeaks]) -> impl Iterator<Item = Row> {
    joints.iter().flat_map(|joint| {
        let (moment, power, names) = match joint.joint {
            "hip" => ("hip moment, peaks", "hip power, peaks", "extensor / flexor"),
            "knee" => ("knee moment, peaks", "knee power, peaks", "extensor / flexor"),
            _ => ("ankle moment, peaks", "ankle power, peaks", "plantarflexor / dorsiflexor"),
        };
        [
            row(moment, pair(joint.extension, joint.flexion, 2), "N m/kg", names),
            row(power, pair(joint.generated, joint.absorbed, 2), "W/kg", "generated / absorbed"),
        ]
    })
}

/// Two numbers.
pub(crate) fn pair(a: Peak, b: Peak, decimals: usize) -> String {
    format!("{} / {}", fixed(a.value, decimals), fixed(b.value, decimals))
}

/// So many decimals; a rounded zero has no sign.
pub(crate) fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let is_zero = !text.bytes().any(|byte| matches!(byte, b'1'..=b'9'));
    if is_zero { text.trim_start_matches('-').to_owned() } else { text }
}
