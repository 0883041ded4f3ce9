//! The answers about a whole spline: stationary points, peaks.

use super::cubic::CubicSpline;
use super::piece::Piece;
use crate::answers::{Answers, Quantity, Stationary, StationaryPoint, Turn};
use crate::roots::quadratic;
use alloc::vec::Vec;

impl Answers for CubicSpline {
    /// A quadratic in each piece; at the keys, by the signs of the velocity on both sides.
    fn stationary(&self) -> Stationary {
        let mut found = Stationary::NONE;
        // The way in which the motion went when it last moved: −1, 1, or 0 before it has.
        let mut way = 0;
        for (i, piece) in self.pieces.iter().enumerate() {
            let (from, to) = (self.knots.times()[i], self.knots.times()[i + 1]);
            if piece.rests() {
                match found.rests.last_mut() {
                    Some(rest) if rest.1 >= from => rest.1 = to,
                    _ => found.rests.push((from, to)),
                }
                continue;
            }
            let [leaves, arrives] = piece.signs(to - from);
            if way != 0 {
                let turned = way != leaves;
                // What rested until now turned round, if it did, when the rest began.
                let rest = found.rests.last().filter(|rest| rest.1 >= from);
                let time = rest.map_or(from, |rest| rest.0);
                let still = is_zero(piece.ends[0].velocity) || is_zero(self.pieces[i - 1].ends[1].velocity);
                if turned {
                    found.points.push(StationaryPoint { time, turn: Turn::Reversal });
                } else if still && rest.is_none() {
                    found.points.push(StationaryPoint { time, turn: Turn::Touch });
                }
            }
            // A root next to an end of the curve may be rounded onto it.
            let inside = piece.turns(from, to).filter(|root| root.0 > 0.0 && root.0 < self.knots.end());
            found.points.extend(inside.map(|(time, turn)| StationaryPoint { time, turn }));
            way = arrives;
        }
        found
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        let mut times: Vec<f64> = self.knots.times()[1..self.pieces.len()].to_vec();
        let spans = self.knots.times().windows(2).map(|pair| (pair[0], pair[1]));
        match quantity {
            Quantity::Position => {
                for ((from, to), piece) in spans.zip(&self.pieces) {
                    times.extend(piece.turns(from, to).map(|(time, _)| time));
                }
            }
            Quantity::Velocity => {
                times.extend(
                    spans.zip(&self.pieces).filter_map(|((from, to), piece)| piece.inflection(from, to)),
                );
            }
            // Linear and constant between the keys.
            Quantity::Acceleration | Quantity::Jerk => {}
        }
        times.sort_by(f64::total_cmp);
        times
    }
}

impl Piece<f64> {
    /// The velocity as a quadratic of the shares u and w = 1 − u of the duration: `v = v₀ w² + 2b·u·w + v₁ u²`, where b
    /// is three times the mean velocity less those of both ends.
    fn velocity(&self, duration: f64) -> [f64; 3] {
        let [start, end] = self.ends;
        let mean = (end.position - start.position) / duration;
        [start.velocity, 3.0 * mean - start.velocity - end.velocity, end.velocity]
    }

    fn rests(&self) -> bool {
        let [start, end] = self.ends;
        is_zero(start.velocity) && is_zero(end.velocity) && is_zero(end.position - start.position)
    }

    /// The signs of the velocity just after the start and just before the end of a piece that does not rest.
    fn signs(&self, duration: f64) -> [i8; 2] {
        let [v0, b, v1] = self.velocity(duration);
        let way = self.ends[1].position - self.ends[0].position;
        // The way alone is left where its mean velocity is too small to be a number.
        let first = |all: [f64; 4]| {
            all.into_iter().find(|x| !is_zero(*x)).map_or(0, |x| if x < 0.0 { -1 } else { 1 })
        };
        [first([v0, b, v1, way]), first([v1, b, v0, way])]
    }

    /// Where the velocity is zero strictly between the ends: with r = u/w, `v₁ r² + 2b r + v₀ = 0` and r > 0.
    fn turns(&self, from: f64, to: f64) -> impl Iterator<Item = (f64, Turn)> {
        let [v0, b, v1] = self.velocity(to - from);
        let inside = quadratic(v1, 2.0 * b, v0).into_iter().filter(|root| root.0 > 0.0);
        inside.map(move |(r, turn)| {
            let share = (to - from) / (1.0 + r);
            (if r < 1.0 { from + r * share } else { to - share }, turn)
        })
    }

    /// Where the acceleration changes its sign strictly between the ends.
    fn inflection(&self, from: f64, to: f64) -> Option<f64> {
        let [v0, b, v1] = self.velocity(to - from);
        // At the start and at the end, over 2 and times the duration.
        let (a0, a1) = (b - v0, v1 - b);
        let changes = (a0 < 0.0 && a1 > 0.0) || (a0 > 0.0 && a1 < 0.0);
        changes.then(|| from + (to - from) * (a0 / (a0 - a1)))
    }
}

fn is_zero(x: f64) -> bool {
    x.abs() <= 0.0
}
