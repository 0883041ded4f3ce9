//! The motion of what reaches, from its positions at some times.

use super::asked::{Asked, What};
use super::beforehand::Beforehand;
use super::layer::Layer;
use nalgebra::Vector3;
use solaris_model::{Figure, Motion, MotionInfo};
use solaris_profiles::{Curve, Profile};

/// Samples a second of the motion that is followed; between them it follows curves of degree five.
const RATE: f64 = 240.0;

/// The longest part of a run in which something is on its way, of which the motion is found before it (s).
const LONGEST_FOUND: f64 = 1800.0;

/// The fewest samples between two times at which something begins or ends.
const FEWEST: usize = 4;

/// A degree of freedom that is moved.
pub(super) struct Moved {
    pub(super) dof: usize,
    pub(super) coordinate: usize,
    /// Since when (s).
    pub(super) from: f64,
    /// Whether it is where it is to be as soon as that begins.
    pub(super) at_once: bool,
}

/// Positions of the whole figure at times of the run.
pub(super) struct Samples {
    pub(super) times: Vec<f64>,
    pub(super) positions: Vec<Vec<f64>>,
    pub(super) moved: Vec<Moved>,
    /// Whether nothing else moves.
    pub(super) still: bool,
}

/// Times of the run (s) that divide evenly what lies between the beginnings and ends of all that is asked; where nothing else moves, from the
/// first beginning to the last end, else all of it. Refused is what would be more samples than can be found in a moment.
pub(super) fn times(asked: &[Asked], duration: f64, still: bool) -> Result<Vec<f64>, String> {
    let mut marks = Vec::new();
    for one in asked {
        marks.extend([one.from, one.from + one.over, one.until, one.until + one.back]);
        if let What::Along(keys) = &one.what {
            marks.extend(keys.iter().map(|(time, _)| one.from + time));
        }
    }
    if !still {
        marks.extend([0.0, duration]);
        marks.retain(|mark| *mark <= duration);
    }
    marks.retain(|mark| mark.is_finite());
    marks.sort_by(f64::total_cmp);
    marks.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    if let [first, .., last] = marks[..]
        && last - first > LONGEST_FOUND
    {
        return Err(format!(
            "these are found from {first} s to {last} s of the run; that may be {LONGEST_FOUND} s at most: let them begin later, and end \
             earlier, or make the run shorter"
        ));
    }
    let mut times: Vec<f64> = marks.first().copied().into_iter().collect();
    for ends in marks.windows(2) {
        let length = ends[1] - ends[0];
        let count = ((length * RATE).ceil() as usize).max(FEWEST);
        times.extend((1..=count).map(|k| ends[0] + length * k as f64 / count as f64));
    }
    Ok(times)
}

impl Samples {
    pub(super) fn new(layers: &[Layer<'_>], times: Vec<f64>, still: bool) -> Self {
        let mut moved: Vec<Moved> = Vec::new();
        for layer in layers {
            let (from, at_once) = (layer.asked.from, layer.asked.over <= 0.0);
            for (dof, coordinate, _) in layer.moves() {
                match moved.iter_mut().find(|known| known.dof == dof) {
                    Some(known) if known.from <= from => {}
                    Some(known) => (known.from, known.at_once) = (from, at_once),
                    None => moved.push(Moved { dof, coordinate, from, at_once }),
                }
            }
        }
        Self { times, positions: Vec::new(), moved, still }
    }

    /// The degrees of freedom that are moved.
    pub(super) fn dofs(&self) -> Vec<usize> {
        self.moved.iter().map(|moved| moved.dof).collect()
    }

    /// The motion through the positions: by how much a coordinate is away from what it would otherwise do goes along a spline, from when it
    /// begins to move.
    pub(super) fn motion(
        &self,
        figure: &Figure,
        gravity: Vector3<f64>,
        beforehand: &Beforehand,
        duration: f64,
    ) -> Result<Motion, String> {
        let layout = figure.layout();
        let (nq, nv, count) = (layout.nq(), layout.nv(), self.times.len());
        let q = self.positions.concat();
        debug_assert_eq!(q.len(), nq * count);
        let (mut v, mut a) = (vec![0.0; nv * count], vec![0.0; nv * count]);
        for moved in &self.moved {
            let otherwise: Vec<_> =
                self.times.iter().map(|time| beforehand.at(moved.dof, moved.coordinate, *time)).collect();
            let away = |k: usize| self.positions[k][moved.coordinate] - otherwise[k].position;
            let first = self.times.partition_point(|time| *time < moved.from - 1e-9).min(count - 1);
            let since = |k: usize| self.times[k] - self.times[first];
            let keys: Vec<(f64, f64)> = (first..count).map(|k| (since(k), away(k))).collect();
            // What has come to rest ends at rest; the end of the run may be anywhere.
            let is_over = self.times[count - 1] < duration - 1e-9 || self.still;
            let start_velocity = if moved.at_once { slope(&keys) } else { 0.0 };
            let backwards: Vec<(f64, f64)> = keys.iter().rev().copied().collect();
            let end_velocity = if is_over { 0.0 } else { slope(&backwards) };
            let curve = match keys.len() {
                0 | 1 => None,
                _ => {
                    let spline = Profile::ClampedSpline { keys, start_velocity, end_velocity };
                    Some(spline.curve::<f64>().map_err(|error| error.to_string())?)
                }
            };
            for (k, base) in otherwise.iter().enumerate() {
                let begun = curve.as_ref().filter(|_| k >= first).map(|curve| curve.at(since(k)));
                let (rate, change) = begun.map_or((0.0, 0.0), |own| (own.velocity, own.acceleration));
                v[k * nv + moved.dof] = base.velocity + rate;
                a[k * nv + moved.dof] = base.acceleration + change;
            }
        }
        let info = MotionInfo { fingerprint: figure.fingerprint(), gravity, ground: None, rate: RATE };
        Motion::new(figure, info, self.times.clone(), [q, v, a]).map_err(|error| error.to_string())
    }
}

/// The slope at the first of some points, by the polynomial of degree four through the first five.
fn slope(points: &[(f64, f64)]) -> f64 {
    let points = &points[..points.len().min(5)];
    let Some((t0, x0)) = points.first().copied() else { return 0.0 };
    // Newton's divided differences of (x − x₀)/(t − t₀), at t₀: Neville's scheme.
    let mut found: Vec<(f64, f64)> = points[1..].iter().map(|(t, x)| (t - t0, (x - x0) / (t - t0))).collect();
    while found.len() > 1 {
        let width = points.len() - found.len();
        found = (0..found.len() - 1)
            .map(|i| {
                let (near, far) = (points[1 + i].0 - t0, points[1 + i + width].0 - t0);
                (near, (far * found[i].1 - near * found[i + 1].1) / (far - near))
            })
            .collect();
    }
    found.first().map_or(0.0, |(_, slope)| *slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_of_polynomials_of_degree_four_are_exact() {
        let curve = |t: f64| 3.0 - 2.0 * t + t * t * t - 0.5 * t.powi(4);
        let points: Vec<(f64, f64)> =
            [1.0, 1.1, 1.25, 1.3, 1.5, 1.7].iter().map(|t| (*t, curve(*t))).collect();
        assert!((slope(&points) - (-2.0 + 3.0 - 2.0)).abs() < 1e-10, "{}", slope(&points));
        assert!(slope(&points[..1]).abs() < 1e-300);
        assert!((slope(&points[..2]) - (curve(1.1) - curve(1.0)) / 0.1).abs() < 1e-12);
    }
}
