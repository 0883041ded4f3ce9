//! Where the energy went, in words.

use solaris::modes::{Energy, EnergyReport};

/// Label, value and note of each line.
pub(super) fn rows(report: &EnergyReport) -> Vec<[String; 3]> {
    let row =
        |label: &str, value: f64, note: String| [label.to_owned(), format!("{} J", digits(value)), note];
    // What rounding leaves of nothing.
    let least = 1e-9 * report.scale;
    let row = |label, value: f64, note| row(label, if value.abs() < least { 0.0 } else { value }, note);
    let parts = |parts: &Energy| {
        let named =
            [("kinetic", parts.kinetic), ("in gravity", parts.potential), ("in springs", parts.elastic)];
        let there = named.iter().filter(|(_, value)| value.abs() > least);
        there.map(|(name, value)| format!("{name} {}", digits(*value))).collect::<Vec<_>>().join(", ")
    };
    let mut rows = vec![
        row("energy at the beginning", report.start.total(), parts(&report.start)),
        row("energy at the end", report.end.total(), parts(&report.end)),
    ];
    for (label, value) in [
        ("work of the drives", report.work),
        ("work of pushes", report.pushes),
        ("lost as heat", report.heat),
        ("lost in impacts", report.impacts),
        ("with links left out", report.moved),
    ] {
        if value.abs() > least {
            rows.push(row(label, value, String::new()));
        }
    }
    if report.scale > 0.0 {
        let share = format!(
            "{:.0e} of the energy at play: gained or lost by error, at most",
            report.imbalance / report.scale
        );
        rows.push(["energy imbalance".to_owned(), format!("{:.1e} J", report.imbalance), share]);
    }
    rows
}

/// Four digits that count, without zeros at the end.
pub(super) fn digits(value: f64) -> String {
    let size = value.abs();
    if size < 5e-13 {
        return "0".to_owned();
    }
    if !(1e-3..1e6).contains(&size) {
        return format!("{value:.2e}");
    }
    let decimals = (3 - size.log10().floor() as i32).clamp(0, 6) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::digits;

    #[test]
    fn four_digits_count() {
        let cases = [
            (0.0, "0"),
            (1.0, "1"),
            (-12.3456, "-12.35"),
            (0.012_345_6, "0.01235"),
            (123_456.0, "123456"),
            (2.5e-7, "2.50e-7"),
            (3.2e7, "3.20e7"),
        ];
        for (value, text) in cases {
            assert_eq!(digits(value), text);
        }
    }
}
