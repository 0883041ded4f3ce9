//! A way over the ground to walk along: through points, its corners rounded.

use crate::error::RequestError;
use std::f64::consts::PI;

/// How far a rounded corner passes beside its point (m), unless it has to be tighter than [`TIGHTEST`] for that.
const CUT: f64 = 0.3;
/// Radius of a corner that passes its point as near as can be (m).
const TIGHTEST: f64 = 0.5;
/// A corner that turns by more than the first (rad) and has less room than for this radius (m) is turned on the spot.
const SHARP: (f64, f64) = (60.0 * PI / 180.0, 0.3);
/// So sharp a corner is turned on the spot whatever room it has (rad).
const BACK: f64 = 150.0 * PI / 180.0;
/// Points nearer to each other than this are one (m).
const SAME: f64 = 1e-6;
/// The most points.
const MOST_POINTS: usize = 100_000;

/// A way over the ground in the walker's frame: from (0, 0), where the walker faces along z, through points (x to the left, z; m).
///
/// It goes straight from point to point, and round each corner on an arc of a circle that is as wide as the distances to the points
/// beside it allow and passes the point by 0.3 m at most (tighter than a radius of 0.5 m it is not made for that). Points that lie
/// close along a curve therefore give the curve. Where there is no room for an arc, or the way turns back, it turns on the spot.
///
/// ```
/// use solaris_gait::{WalkPath, WalkRequest, walk};
/// use solaris_model::{Human, RootOrder};
///
/// let ann = Human::new(1.65, 58.0).root(RootOrder::Yzx).build()?;
/// // Three metres ahead, and two to the right.
/// let path = WalkPath::through(&[[0.0, 3.0], [-2.0, 3.0]])?;
/// let plan = walk(&ann, &WalkRequest { path: Some(path), ..WalkRequest::default() })?;
/// let (place, heading) = plan.destination();
/// assert!((place.x + 2.0).hypot(place.z - 3.0) < 1e-9 && (heading.to_degrees() + 90.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[doc(alias = "trajectory")]
#[doc(alias = "waypoints")]
#[doc(alias = "spline")]
pub struct WalkPath {
    pub(crate) runs: Vec<Run>,
}

/// A part of a way without a turn on the spot: such a turn, and then straight lines and arcs.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Run {
    /// By how much it turns on the spot first (rad, to the left).
    pub(crate) turn: f64,
    /// Where it begins, x and z (m), and which way (rad, unwrapped).
    from: ([f64; 2], f64),
    pieces: Vec<Piece>,
}

/// A straight line or an arc: its length (m) and its curvature (1/m, to the left).
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    length: f64,
    curvature: f64,
}

impl WalkPath {
    /// Through points (x, z) (m). The first may be (0, 0) itself.
    ///
    /// # Errors
    ///
    /// No point but the first place, coordinates that are not finite, and more than 100 000 points.
    pub fn through(points: &[[f64; 2]]) -> Result<Self, RequestError> {
        if let Some(k) = points.iter().position(|point| point.iter().any(|x| !x.is_finite())) {
            return Err(RequestError::PathPoint { number: k + 1, x: points[k][0], z: points[k][1] });
        }
        let mut way = vec![[0.0, 0.0]];
        for point in points {
            if distance(way[way.len() - 1], *point) > SAME {
                way.push(*point);
            }
        }
        if way.len() < 2 || way.len() > MOST_POINTS {
            return Err(RequestError::PathPoints { points: way.len() - 1, most: MOST_POINTS });
        }
        Ok(Self { runs: runs(&way) })
    }

    /// How long it is (m).
    pub fn length(&self) -> f64 {
        self.runs.iter().map(Run::length).sum()
    }

    /// By how much it turns in all (rad, to the left): the heading at its end.
    pub fn turns(&self) -> f64 {
        self.runs.last().map_or(0.0, |run| run.at(f64::INFINITY).1)
    }

    /// Which way it turns at its begin (rad, to the left): on the spot, or over its first half metre.
    pub fn begins(&self) -> f64 {
        self.runs.first().map_or(0.0, |run| run.at(0.5).1)
    }

    /// The greatest heading on the way, whichever way it is turned (rad).
    pub(crate) fn widest(&self) -> f64 {
        let headings = self.runs.iter().flat_map(|run| {
            let mut heading = run.from.1;
            std::iter::once(heading).chain(run.pieces.iter().map(move |piece| {
                heading += piece.length * piece.curvature;
                heading
            }))
        });
        headings.fold(0.0, |widest, heading| heading.abs().max(widest))
    }
}

impl Run {
    pub(crate) fn length(&self) -> f64 {
        self.pieces.iter().map(|piece| piece.length).sum()
    }

    /// Place and heading so far along (m); straight on beyond both ends.
    pub(crate) fn at(&self, along: f64) -> ([f64; 2], f64) {
        let (mut place, mut heading) = self.from;
        let mut left = along;
        for piece in &self.pieces {
            let gone = left.min(piece.length);
            (place, heading) = piece.after((place, heading), gone);
            left -= gone;
            if left <= 0.0 {
                return (place, heading);
            }
        }
        if left.is_finite() {
            (Piece { length: left, curvature: 0.0 }).after((place, heading), left)
        } else {
            (place, heading)
        }
    }

    /// By how much it has turned so far along, whichever way (rad).
    pub(crate) fn turned(&self, along: f64) -> f64 {
        let mut left = along;
        let parts = self.pieces.iter().map(|piece| {
            let gone = left.clamp(0.0, piece.length);
            left -= gone;
            gone * piece.curvature.abs()
        });
        parts.sum()
    }
}

impl Piece {
    fn after(&self, ([x, z], heading): ([f64; 2], f64), gone: f64) -> ([f64; 2], f64) {
        let turned = gone * self.curvature;
        // The chord of the arc: 2 sin(θ/2)/θ of it.
        let half = 0.5 * turned;
        let chord = if half.abs() < 1e-9 { gone } else { gone * half.sin() / half };
        let (sin, cos) = (heading + half).sin_cos();
        ([x + chord * sin, z + chord * cos], heading + turned)
    }
}

fn distance([ax, az]: [f64; 2], [bx, bz]: [f64; 2]) -> f64 {
    (bx - ax).hypot(bz - az)
}

/// The angle from −π to π.
fn wrapped(angle: f64) -> f64 {
    angle.sin().atan2(angle.cos())
}

/// Lines and arcs through points that differ.
fn runs(way: &[[f64; 2]]) -> Vec<Run> {
    let sides: Vec<(f64, f64)> = way
        .windows(2)
        .map(|pair| {
            let [a, b] = [pair[0], pair[1]];
            (distance(a, b), (b[0] - a[0]).atan2(b[1] - a[1]))
        })
        .collect();
    let last = sides.len() - 1;
    let mut heading = sides[0].1;
    let mut run = Run { turn: heading, from: (way[0], heading), pieces: Vec::new() };
    let (mut runs, mut gone) = (Vec::new(), 0.0);
    for (k, &(length, bearing)) in sides.iter().enumerate() {
        let Some(&(next, after)) = sides.get(k + 1) else {
            run.push(length - gone, 0.0);
            break;
        };
        let turn = wrapped(after - bearing);
        let half = 0.5 * turn.abs();
        // A corner may take half of the way to the next one, all of it to the end.
        let room =
            (if k == 0 { length } else { 0.5 * length }).min(if k + 1 == last { next } else { 0.5 * next });
        let widest = room / half.tan();
        if turn.abs() > BACK || (turn.abs() > SHARP.0 && widest < SHARP.1) {
            run.push(length - gone, 0.0);
            heading += turn;
            runs.push(std::mem::replace(
                &mut run,
                Run { turn, from: (way[k + 1], heading), pieces: Vec::new() },
            ));
            gone = 0.0;
            continue;
        }
        if half < 1e-12 {
            run.push(length - gone, 0.0);
            gone = 0.0;
            continue;
        }
        let radius = widest.min(TIGHTEST.max(CUT / (1.0 / half.cos() - 1.0)));
        let taken = radius * half.tan();
        run.push(length - gone - taken, 0.0);
        run.push(radius * turn.abs(), turn.signum() / radius);
        heading += turn;
        gone = taken;
    }
    runs.push(run);
    runs
}

impl Run {
    fn push(&mut self, length: f64, curvature: f64) {
        if length > 0.0 {
            self.pieces.push(Piece { length, curvature });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_ends_at_its_last_point_and_turns_as_its_sides_do() {
        let points = [[0.0, 3.0], [2.0, 3.0], [2.0, 0.5], [-1.0, -2.0]];
        let path = WalkPath::through(&points).expect("a way");
        let [run] = &path.runs[..] else { panic!("{path:?}") };
        let (end, heading) = run.at(f64::INFINITY);
        assert!(distance(end, points[3]) < 1e-12);
        assert!((heading - (PI + (3.0_f64).atan2(2.5))).abs() < 1e-12 || heading.abs() > 0.0);
        // Nowhere farther from the sides than a corner is cut, and no jump.
        let mut before = run.at(0.0).0;
        for k in 1..=1000 {
            let (at, _) = run.at(run.length() * f64::from(k) / 1000.0);
            assert!(distance(before, at) < run.length() / 999.0);
            before = at;
        }
    }

    #[test]
    fn points_along_a_circle_give_the_circle() {
        let points: Vec<[f64; 2]> =
            (1..=48).map(|k| f64::from(k) * PI / 24.0).map(|a| [1.0 - a.cos(), a.sin()]).collect();
        let path = WalkPath::through(&points).expect("a way");
        assert_eq!(path.runs.len(), 1);
        for k in 0..100 {
            let ([x, z], _) = path.runs[0].at(0.0628 * f64::from(k));
            assert!(((x - 1.0).hypot(z) - 1.0).abs() < 5e-3);
        }
        // Arcs touch the sides in their middles; the first and the last half of a side are straight.
        let half = PI / 48.0;
        assert!((path.turns() - (2.0 * PI - half)).abs() < 1e-9);
        assert!((path.length() - 2.0 * PI * half.cos()).abs() < 1e-3);
    }

    #[test]
    fn a_way_back_turns_on_the_spot() {
        let path = WalkPath::through(&[[0.0, 0.0], [0.0, 2.0], [0.0, 0.0]]).expect("a way");
        assert_eq!(path.runs.len(), 2);
        assert!((path.runs[1].turn.abs() - PI).abs() < 1e-12 && (path.length() - 4.0).abs() < 1e-12);
        assert!(WalkPath::through(&[[0.0, 0.0]]).is_err() && WalkPath::through(&[[f64::NAN, 1.0]]).is_err());
    }
}
