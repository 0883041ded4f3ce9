//! Moments that keep the trunk near to what it is drawn to.

use super::{Before, EXACT, Laws};
use crate::running::chain::basis::Expected;
use crate::running::chain::fit::Fit;
use crate::running::chain::seam::{LEAD, MET};
use crate::running::forces::TRUNK_SPREAD;

/// Every how many nodes the trunk is looked at.
const LOOKED_AT: usize = 6;

/// A moment (N m) for an amplitude of 1: over the nodes from the first on.
pub(super) struct Column {
    pub(super) from: usize,
    pub(super) moment: Vec<f64>,
    pub(super) expected: Option<Expected>,
}

impl Laws<'_> {
    /// Amplitudes of moments about an axis (x, y, z) that keep the trunk's angle about it near to what it is drawn to, and by how much
    /// the trunk then turns.
    pub(super) fn fit(
        &self,
        axis: usize,
        base: Vec<f64>,
        columns: &[Column],
        rows: &[(Vec<f64>, f64)],
        before: Option<&Before<'_>>,
    ) -> Option<Fitted> {
        let nodes = self.nodes();
        let inertia = self.inertia[axis];
        let angle = 2 - axis;
        let unknowns = columns.len();
        let responses: Vec<Response> = columns.iter().map(|column| self.response(column, inertia)).collect();
        let momentum: Vec<f64> = before.map_or_else(
            || vec![0.0; nodes],
            |before| before.momentum.iter().map(|h| h[axis] / inertia).collect(),
        );
        let bodily = self.open.integral(&momentum);
        let rates = self.open.integral(&base.iter().map(|m| m / inertia).collect::<Vec<f64>>());
        let mut base_turn = self.open.integral(&rates);
        base_turn.iter_mut().zip(&bodily).for_each(|(turn, h)| *turn -= h);
        // Amplitudes, then the trunk's angle and rate at the first node.
        let mut fit = Fit::new(unknowns + 2);
        let spread = TRUNK_SPREAD * (self.steps[0].style.stride_time / self.step / LOOKED_AT as f64).sqrt();
        let row = |i: usize| {
            let mut row: Vec<f64> = responses.iter().map(|response| response.at(i, self.step)).collect();
            row.extend([1.0, self.time(i)]);
            row
        };
        let wanted = |i: usize| before.map_or(0.0, |before| before.drawn[i][angle] - before.thorax[i][angle]);
        for i in (0..nodes).step_by(LOOKED_AT) {
            fit.row(&row(i), wanted(i) - base_turn[i], spread);
        }
        if self.stands.last {
            // At rest as it is drawn to, and balanced.
            let end = nodes - 1;
            fit.exactly(&row(end), wanted(end) - base_turn[end]);
            let mut rate: Vec<f64> = responses.iter().map(|response| response.rate_after).collect();
            rate.extend([0.0, 1.0]);
            fit.exactly(&rate, momentum[end] - rates[end]);
            let mut moment: Vec<f64> = columns
                .iter()
                .map(|column| {
                    end.checked_sub(column.from).and_then(|i| column.moment.get(i)).copied().unwrap_or(0.0)
                })
                .collect();
            moment.extend([0.0, 0.0]);
            if moment.iter().any(|moment| *moment != 0.0) {
                fit.exactly(&moment, -base[end]);
            }
        }
        if self.stands.first {
            fit.expect(unknowns, 0.0, EXACT);
            fit.expect(unknowns + 1, 0.0, EXACT);
        }
        let rate_at = |node: usize| {
            let rate = |response: &Response| self.grid.first(node, |i| response.at(i, self.step));
            let mut row: Vec<f64> = responses.iter().map(rate).collect();
            row.extend([0.0, 1.0]);
            row
        };
        if let Some((met, ..)) = self.met(1) {
            fit.exactly(&row(met), -base_turn[met]);
            fit.exactly(&rate_at(met), momentum[met] - rates[met]);
        }
        if self.seams[0].is_some() {
            // As the walk has it.
            fit.expect(unknowns, 0.0, 1.0);
            fit.expect(unknowns + 1, 0.0, 10.0);
            fit.exactly(&row(MET), -base_turn[MET]);
            fit.exactly(&rate_at(MET), momentum[MET] - rates[MET]);
        }
        for (row, value) in rows {
            let row = [row, &[0.0, 0.0][..]].concat();
            fit.exactly(&row, *value);
        }
        for (k, column) in columns.iter().enumerate() {
            if let Some((value, spread)) = column.expected {
                fit.expect(k, value, spread);
            }
        }
        let found = fit.solve()?;
        let mut rate = base;
        for (column, a) in columns.iter().zip(&found) {
            rate[column.from..].iter_mut().zip(&column.moment).for_each(|(rate, moment)| *rate += a * moment);
        }
        let turn = before.map(|_| {
            let rates = self.open.integral(&rate.iter().map(|m| m / inertia).collect::<Vec<f64>>());
            let turned = self.open.integral(&rates);
            let [before, after] = self.seams.map(|seam| if seam.is_some() { LEAD } else { 0 });
            let own = before..nodes - after;
            let turn =
                |i: usize| turned[i] - bodily[i] + found[unknowns] + found[unknowns + 1] * self.time(i);
            (0..nodes).map(|i| if own.contains(&i) { turn(i) } else { 0.0 }).collect()
        });
        Some(Fitted { amplitudes: found[..unknowns].to_vec(), rate, turn })
    }

    /// How far a moment turns the trunk.
    fn response(&self, column: &Column, inertia: f64) -> Response {
        // Some nodes before and after, where there is nothing, for the formula's sake.
        const MARGIN: usize = 4;
        let nodes = self.nodes();
        let before = column.from.min(MARGIN);
        let after = (nodes - column.from - column.moment.len()).min(MARGIN);
        let mut moment = vec![0.0; before + column.moment.len() + after];
        moment[before..before + column.moment.len()]
            .iter_mut()
            .zip(&column.moment)
            .for_each(|(to, from)| *to = from / inertia);
        let rates = self.open.integral(&moment);
        let turns = self.open.integral(&rates);
        Response { from: column.from - before, rate_after: rates[rates.len() - 1], turns }
    }
}

/// How far a moment has turned the trunk by node.
struct Response {
    from: usize,
    turns: Vec<f64>,
    rate_after: f64,
}

impl Response {
    fn at(&self, node: usize, step: f64) -> f64 {
        let Some(i) = node.checked_sub(self.from) else { return 0.0 };
        let last = self.turns.len() - 1;
        if i <= last { self.turns[i] } else { self.turns[last] + self.rate_after * step * (i - last) as f64 }
    }
}

/// What was found.
pub(super) struct Fitted {
    pub(super) amplitudes: Vec<f64>,
    pub(super) rate: Vec<f64>,
    pub(super) turn: Option<Vec<f64>>,
}
