//! One of the four curves: its range, its panel, its lines and marks.

use super::line::lines;
use super::{Labels, ORDER, unit};
use crate::chart::{Axis, LETTERS, Panel, Picture, joined, path, short, shown, width};
use solaris_profiles::{Answers, Peak, Peaks, Stationary, Turn};

/// The most marks of a kind in a panel; where there are more, none is drawn.
const MOST_MARKS: usize = 150;

/// What was asked of the curve once, for all panels.
pub(super) struct Asked<'a> {
    pub(super) curve: &'a dyn Answers,
    pub(super) labels: &'a Labels,
    pub(super) stationary: Stationary,
    pub(super) peaks: Peaks,
    /// The least and the greatest of each of the four; what is nothing but rounding is zero.
    ranges: [(f64, f64); 4],
}

impl<'a> Asked<'a> {
    pub(super) fn of(curve: &'a dyn Answers, labels: &'a Labels) -> Self {
        let duration = curve.duration();
        let mut rounding = 0.0f64;
        let ranges = ORDER.map(|(_, quantity)| {
            let (low, high) = curve.range(quantity, 0.0, duration);
            let most = low.abs().max(high.abs());
            let nothing = most <= rounding;
            // What is unbounded says nothing about rounding.
            let unsure = if most.is_finite() { 1e-13 * most } else { 0.0 };
            rounding = if duration > 0.0 { rounding.max(unsure) / duration } else { f64::INFINITY };
            if nothing { (0.0, 0.0) } else { (low, high) }
        });
        Self { curve, labels, stationary: curve.stationary(), peaks: curve.peaks(), ranges }
    }

    /// The axis of a panel. Derivatives show zero; what has no bound is cut off where most of the rest is seen.
    pub(super) fn axis(&self, order: usize) -> Axis {
        let (mut low, mut high) = self.ranges[order];
        if !low.is_finite() || !high.is_finite() {
            let (quantity, duration) = (ORDER[order].1, self.curve.duration());
            let sampled =
                (0..400).map(|i| quantity.of(&self.curve.at(duration * (f64::from(i) + 0.5) / 400.0)));
            let mut values: Vec<f64> = sampled.filter(|x| x.is_finite()).collect();
            values.sort_by(f64::total_cmp);
            let at = |i: usize| values.get(i.min(values.len().saturating_sub(1))).copied().unwrap_or(0.0);
            let (few, many) = (at(values.len() / 16), at(values.len() - values.len() / 16));
            let beyond = 0.25 * (many - few);
            low = if low.is_finite() { low } else { few - beyond };
            high = if high.is_finite() { high } else { many + beyond };
        }
        if order > 0 {
            (low, high) = (low.min(0.0), high.max(0.0));
        }
        Axis::linear(low, high, 4.0).padded(0.11)
    }

    fn peak(&self, order: usize) -> Option<Peak> {
        let peak = [self.peaks.velocity, self.peaks.acceleration, self.peaks.jerk];
        order.checked_sub(1).map(|i| peak[i])
    }

    /// Whether the quantity is the same all the time.
    fn is_constant(&self, order: usize) -> bool {
        let (low, high) = self.ranges[order];
        (high - low).is_finite() && high - low <= 1e-12 * low.abs().max(high.abs())
    }

    /// The value at a peak, with its sign.
    fn signed(&self, order: usize, peak: Peak) -> f64 {
        let quantity = ORDER[order].1;
        let [before, after] =
            [self.curve.before(peak.time), self.curve.at(peak.time)].map(|sample| quantity.of(&sample));
        if before.abs() > after.abs() { before } else { after }
    }

    /// What is said at the right over a panel.
    fn remark(&self, order: usize, most: f64) -> String {
        let Some(peak) = self.peak(order) else { return self.remark_on_position(most) };
        let (low, _) = self.ranges[order];
        let unit = unit(&self.labels.unit, order);
        if self.is_constant(order) {
            let value = joined(&shown(low, 4), &unit);
            return if low.abs() > 0.0 {
                format!("{value} throughout")
            } else {
                "zero throughout".to_owned()
            };
        }
        let arrow = if self.signed(order, peak) < 0.0 { '▲' } else { '▼' };
        let (value, time) = (shown(peak.value, 4), shown(peak.time, 4));
        if !peak.value.is_finite() {
            return format!("unbounded at {time} s");
        }
        let long = format!("{arrow} peak {} at {time} s", joined(&value, &unit));
        if width(&long, LETTERS) <= most { long } else { format!("{arrow} peak {value} at {time} s") }
    }

    fn remark_on_position(&self, most: f64) -> String {
        let Stationary { points, rests } = &self.stationary;
        let say = |listed: bool| {
            let mut parts: Vec<String> = Vec::new();
            for (turn, mark, words) in
                [(Turn::Reversal, '●', "turns round"), (Turn::Touch, '○', "touches standstill")]
            {
                let times: Vec<String> = points
                    .iter()
                    .filter(|point| point.turn == turn)
                    .map(|point| shown(point.time, 4))
                    .collect();
                match times.len() {
                    0 if turn == Turn::Reversal => parts.push("never turns round".to_owned()),
                    0 => {}
                    _ if listed => parts.push(format!("{mark} {words} at {} s", times.join(", "))),
                    count => parts.push(format!("{mark} {words} {count} ×")),
                }
            }
            let of_rest = rests.iter().filter(|(start, end)| end > start).count();
            if of_rest > 0 {
                parts.push(format!(
                    "rests{}",
                    if of_rest > 1 { format!(" {of_rest} ×") } else { String::new() }
                ));
            }
            if !self.labels.keys.is_empty() {
                parts.push(format!("■ {} keys", self.labels.keys.len()));
            }
            parts.join("\u{a0}\u{a0} ")
        };
        let long = say(true);
        if width(&long, LETTERS) <= most { long } else { say(false) }
    }
}

/// Draws one of the four: heading, rests, grid, lines, marks.
pub(super) fn draw(picture: &mut Picture, asked: &Asked, order: usize, panel: &Panel) {
    let name = ORDER[order].0;
    let unit = panel.up.unit(&unit(&asked.labels.unit, order));
    let heading = if unit.is_empty() { name.to_owned() } else { format!("{name} ({unit})") };
    let remark = asked.remark(order, panel.beside(&heading));
    panel.heading(picture, &heading, &remark);
    if order < 2 {
        for &(start, end) in few(&asked.stationary.rests) {
            let x = panel.x(start);
            picture.rect("rest", (x, panel.top), (panel.x(end) - x, panel.height));
        }
    }
    panel.grid(picture);
    let lines = lines(asked.curve, order, panel);
    let ends = lines.windows(2).filter_map(|pair| Some([*pair[0].last()?, *pair[1].first()?]));
    let jumps: String = ends.map(|pair| path(&pair)).collect();
    let line: String = lines.iter().map(|line| path(line)).collect();
    panel.clipped(picture, |picture| {
        picture.path(&format!("jump s{order}"), &jumps);
        picture.path(&format!("line s{order}"), &line);
    });
    marks(picture, asked, order, panel);
}

/// Keys, standstills and the peak.
fn marks(picture: &mut Picture, asked: &Asked, order: usize, panel: &Panel) {
    let value = |t: f64| ORDER[order].1.of(&asked.curve.at(t));
    if order == 0 {
        for &(time, position) in few(&asked.labels.keys) {
            let start = asked.labels.keys.first().map_or(0.0, |first| first.0);
            picture.rect("ink", (panel.x(time - start) - 3.0, panel.y(position) - 3.0), (6.0, 6.0));
        }
    }
    if order < 2 {
        for point in few(&asked.stationary.points) {
            // A velocity that jumps over zero is marked at zero.
            let y = panel.y(if order == 0 { value(point.time) } else { 0.0 });
            let class = if point.turn == Turn::Reversal { "ink" } else { "open" };
            picture.circle(class, (panel.x(point.time), y), 4.0);
        }
    }
    let peak = asked.peak(order).filter(|peak| peak.value.is_finite() && !asked.is_constant(order));
    if let Some(peak) = peak {
        let signed = asked.signed(order, peak);
        let (x, y) = (short(panel.x(peak.time)), panel.y(signed));
        // A triangle that points at the peak from outside.
        let (y, d) = if signed < 0.0 { (y + 3.5, "l-3.6 6h7.2z") } else { (y - 3.5, "l-3.6-6h7.2z") };
        picture.path("peak", &format!("M{x} {}{d}", short(y)));
    }
}

/// All of them, or none where they would cover each other.
fn few<T>(marks: &[T]) -> &[T] {
    if marks.len() > MOST_MARKS { &[] } else { marks }
}
