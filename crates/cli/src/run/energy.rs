//! Where the energy went.

use serde::Serialize;
use solaris::modes::{Energy, EnergyReport};

/// All in J.
#[derive(Debug, Serialize)]
pub(super) struct Energies {
    pub(super) start: Parts,
    pub(super) end: Parts,
    pub(super) work_of_drives: f64,
    pub(super) heat: f64,
    pub(super) lost_in_impacts: f64,
    pub(super) moved: f64,
    pub(super) imbalance: f64,
    pub(super) at_play: f64,
}

#[derive(Debug, Serialize)]
pub(super) struct Parts {
    pub(super) kinetic: f64,
    pub(super) in_gravity: f64,
    pub(super) in_springs: f64,
    pub(super) total: f64,
}

impl Energies {
    pub(super) fn of(report: &EnergyReport) -> Self {
        Self {
            start: Parts::of(&report.start),
            end: Parts::of(&report.end),
            work_of_drives: report.work,
            heat: report.heat,
            lost_in_impacts: report.impacts,
            moved: report.moved,
            imbalance: report.imbalance,
            at_play: report.scale,
        }
    }

    /// Label, value and note of each line.
    pub(super) fn rows(&self) -> Vec<[String; 3]> {
        let row =
            |label: &str, value: f64, note: String| [label.to_owned(), format!("{} J", digits(value)), note];
        // What rounding leaves of nothing.
        let least = 1e-9 * self.at_play;
        let row = |label, value: f64, note| row(label, if value.abs() < least { 0.0 } else { value }, note);
        let parts = |parts: &Parts| {
            let named = [
                ("kinetic", parts.kinetic),
                ("in gravity", parts.in_gravity),
                ("in springs", parts.in_springs),
            ];
            let there = named.iter().filter(|(_, value)| value.abs() > least);
            there.map(|(name, value)| format!("{name} {}", digits(*value))).collect::<Vec<_>>().join(", ")
        };
        let mut rows = vec![
            row("energy at the beginning", self.start.total, parts(&self.start)),
            row("energy at the end", self.end.total, parts(&self.end)),
        ];
        for (label, value) in [
            ("work of the drives", self.work_of_drives),
            ("lost as heat", self.heat),
            ("lost in impacts", self.lost_in_impacts),
            ("with links left out", self.moved),
        ] {
            if value.abs() > least {
                rows.push(row(label, value, String::new()));
            }
        }
        if self.at_play > 0.0 {
            let share = format!(
                "{:.0e} of the energy at play: gained or lost by error, at most",
                self.imbalance / self.at_play
            );
            rows.push(["energy imbalance".to_owned(), format!("{:.1e} J", self.imbalance), share]);
        }
        rows
    }
}

impl Parts {
    fn of(energy: &Energy) -> Self {
        let Energy { kinetic, potential, elastic } = *energy;
        Self { kinetic, in_gravity: potential, in_springs: elastic, total: energy.total() }
    }
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
