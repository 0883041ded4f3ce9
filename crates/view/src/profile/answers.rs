//! Answers of a whole curve, as rows of a table.

use super::{Labels, ORDER, number, unit};
use crate::TableRow;
use solaris_profiles::{Answers, Peak, Stationary, Turn};

/// Digits of the numbers of a table.
const DIGITS: usize = 6;
/// The most instants that are listed.
const MOST: usize = 12;

/// The answers of a curve as rows: ends, standstills, peaks.
pub(super) fn rows(curve: &dyn Answers, labels: &Labels) -> Vec<TableRow> {
    let row = |label: &str, value: f64, unit: &str, note: String| {
        TableRow::new(label, number(value, DIGITS), unit, note)
    };
    let duration = curve.duration();
    let mut rows = vec![row("duration", duration, "s", String::new())];
    for (order, (name, quantity)) in ORDER.iter().enumerate() {
        let ends = [curve.at(0.0), curve.before(duration)].map(|sample| number(quantity.of(&sample), DIGITS));
        let value = if ends[0] == ends[1] { ends[0].clone() } else { ends.join(" to ") };
        rows.push(TableRow::new(format!("{name}, ends"), value, unit(&labels.unit, order), ""));
    }
    rows.extend(standstill(&curve.stationary(), duration));
    let peaks = curve.peaks();
    for (order, peak) in (1..).zip([peaks.velocity, peaks.acceleration, peaks.jerk]) {
        let Peak { time, value } = peak;
        let at = format!("at {} s", number(time, DIGITS));
        rows.push(row(&format!("greatest {}", ORDER[order].0), value, &unit(&labels.unit, order), at));
    }
    rows.extend(labels.rows.iter().cloned());
    rows
}

/// Where the motion turns round, touches standstill and rests.
fn standstill(stationary: &Stationary, duration: f64) -> Vec<TableRow> {
    let mut rows = Vec::new();
    for (turn, label) in [(Turn::Reversal, "turns round"), (Turn::Touch, "touches standstill")] {
        let times: Vec<f64> =
            stationary.points.iter().filter(|point| point.turn == turn).map(|point| point.time).collect();
        let value = match (times.len(), turn) {
            (0, Turn::Reversal) => "never".to_owned(),
            (0, Turn::Touch) => continue,
            (1, _) => "once".to_owned(),
            (2, _) => "twice".to_owned(),
            (count, _) => format!("{count} times"),
        };
        let listed: Vec<String> = times.iter().take(MOST).map(|&time| number(time, DIGITS)).collect();
        let more = if times.len() > MOST { ", …" } else { "" };
        let note = if times.is_empty() { String::new() } else { format!("at {}{more} s", listed.join(", ")) };
        rows.push(TableRow::new(label, value, "", note));
    }
    for &(start, end) in stationary.rests.iter().take(MOST) {
        let all = start <= 0.0 && end >= duration;
        let note = format!("from {} to {} s", number(start, DIGITS), number(end, DIGITS));
        let (value, note) = if all { ("all the time", String::new()) } else { ("", note) };
        rows.push(TableRow::new("rests", value, "", note));
    }
    rows
}
