//! What feet stand on where the ground is not level: stairs, slopes, kerbs, boxes.

use super::{BalanceFrame, PlacedFeet, Stance, Stances};
use nalgebra::Vector3;
use solaris_dynamics::Wrench;

/// Feet that stand nearer in height than this (m) stand on level ground: as far off are guessed soles, and markers.
const APART: f64 = 0.05;
/// Soles that stand tilted by less than this (rad) stand on a tread: as far off are guessed soles.
const TILTED: f64 = 4.0 * std::f64::consts::PI / 180.0;
/// A sole steeper than this (rad), whose toes are bent by more (rad), or of which a point moves faster than this (m/s), stands on an edge: its lowest point alone is
/// on the ground.
const STEEPEST: f64 = 30.0 * std::f64::consts::PI / 180.0;
const BENT: f64 = 20.0 * std::f64::consts::PI / 180.0;
const STILL: f64 = 0.25;
/// The share of a stance's frames in which the sole is slowest: there it lies on the ground.
const SLOWEST: f64 = 0.2;

/// The plane that a foot stands on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footing {
    /// A point of it (m).
    pub point: Vector3<f64>,
    /// Its unit normal, up.
    pub normal: Vector3<f64>,
}

/// How a foot lies on what it stands on.
pub(super) struct Lying {
    pub(super) footing: Footing,
    /// How far (m) heel, ball and tip lie above it.
    pub(super) above: [f64; 3],
    /// The height (m, along up) of the lowest of them.
    lowest: f64,
}

impl Lying {
    /// How far (m) heel, ball and tip of the foot are above where they lie.
    pub(super) fn raised(&self, points: &[Vector3<f64>; 3], up: &Vector3<f64>) -> [f64; 3] {
        [0, 1, 2].map(|i| self.footing.above(&points[i], up) - self.above[i])
    }
}

impl Footing {
    /// Level ground at a height (m) along `up`.
    pub(super) fn level(level: f64, up: &Vector3<f64>) -> Self {
        Self { point: up * level, normal: *up }
    }

    /// The point of it above or below another one.
    pub(super) fn below(&self, point: Vector3<f64>, up: &Vector3<f64>) -> Vector3<f64> {
        point - up * self.above(&point, up)
    }

    /// How far (m) a point is above it.
    pub(super) fn above(&self, point: &Vector3<f64>, up: &Vector3<f64>) -> f64 {
        (point - self.point).dot(&self.normal) / up.dot(&self.normal)
    }

    /// The centre of pressure of a wrench on it, where its moment is along the normal; not finite without force.
    ///
    /// ```text
    /// P = p + n × (M − p × F)/(F·n)
    /// ```
    pub(super) fn center_of_pressure(&self, wrench: &Wrench<f64>) -> Vector3<f64> {
        let own = wrench.moment - self.point.cross(&wrench.force);
        self.point + self.normal.cross(&own) / wrench.force.dot(&self.normal)
    }

    /// The plane through two, and level aside.
    fn through(a: &Self, b: &Self, up: &Vector3<f64>) -> Self {
        let way = b.point - a.point;
        let rise = way.dot(up);
        let level = way - up * rise;
        let lean = level * (rise / level.norm_squared());
        let normal = if lean.iter().all(|x| x.is_finite()) { (up - lean).normalize() } else { *up };
        Self { point: a.point.lerp(&b.point, 0.5), normal }
    }
}

impl Stances {
    /// How low and how high (m, along `up`) feet stand; `None` on level ground.
    pub fn heights(&self, up: &Vector3<f64>) -> Option<(f64, f64)> {
        let heights = self.footings.iter().map(|footing| footing.point.dot(up));
        let range = |(low, high): (f64, f64), height: f64| (low.min(height), high.max(height));
        (!self.footings.is_empty()).then(|| heights.fold((f64::INFINITY, f64::NEG_INFINITY), range))
    }

    /// What a foot stands on at a time (s) at which it stands: the level ground where no [`Stances::footings`] say otherwise.
    pub(super) fn under(&self, foot: usize, time: f64, up: &Vector3<f64>) -> Footing {
        let stands = |stance: &Stance| stance.foot == foot && (stance.start..=stance.end).contains(&time);
        self.of(self.list.iter().position(stands), up)
    }

    /// The stance of a foot in each frame, by its index in the list; of two that meet the first.
    pub(super) fn by_frame(&self, foot: usize, time: &[f64]) -> Vec<Option<usize>> {
        let mut found = vec![None; time.len()];
        for (index, stance) in self.list.iter().enumerate().filter(|(_, stance)| stance.foot == foot) {
            let from = time.partition_point(|time| *time < stance.start);
            let to = time.partition_point(|time| *time <= stance.end);
            for row in found.get_mut(from..to).unwrap_or_default() {
                row.get_or_insert(index);
            }
        }
        found
    }

    /// What the foot of a stance of the list, if it is one, stands on.
    pub(super) fn of(&self, stance: Option<usize>, up: &Vector3<f64>) -> Footing {
        let own = stance.and_then(|stance| self.footings.get(stance));
        own.copied().unwrap_or_else(|| Footing::level(self.level, up))
    }
}

impl PlacedFeet<'_> {
    /// The whole wrench with centres of pressure on what feet stand on: of two on the plane through both.
    pub(super) fn whole_on(&self, stances: &Stances) -> Result<Vec<BalanceFrame>, super::GroundError> {
        let mut total = self.whole_at(stances.level)?;
        if stances.footings.is_empty() {
            return Ok(total);
        }
        let (up, time) = (&self.prepared().up, self.prepared().time());
        let of_feet: Vec<_> = (0..self.soles().len()).map(|foot| stances.by_frame(foot, time)).collect();
        for (row, frame) in total.iter_mut().enumerate().filter(|(_, frame)| frame.cop.is_some()) {
            let standing = of_feet.iter().enumerate().filter(|(_, stances)| stances[row].is_some());
            let planes = standing.map(|(foot, own)| {
                let plane = stances.of(own[row], up);
                let [heel, ball, _] = self.frame(row)[foot].points;
                Footing { point: plane.below(heel.lerp(&ball, 0.5), up), ..plane }
            });
            let plane = match planes.collect::<Vec<_>>()[..] {
                [] => continue,
                [only] => only,
                [a, b] => Footing::through(&a, &b, up),
                ref more => {
                    let heights: f64 = more.iter().map(|plane| plane.point.dot(up)).sum();
                    Footing::level(heights / more.len() as f64, up)
                }
            };
            frame.cop = Some(plane.center_of_pressure(&frame.wrench()));
        }
        Ok(total)
    }

    /// What the foot of each stance stands on, as its sole lies while it moves least against ground of the velocity `belt` (m/s); nothing where all
    /// stand on level ground. A plane has the sole's pitch, and is level aside.
    pub fn footings(&self, list: &[Stance], belt: &Vector3<f64>) -> Vec<Footing> {
        let found: Vec<Option<Lying>> = list.iter().map(|stance| self.lies(stance, belt)).collect();
        // A heel that is up already is not the ground: lowest points are.
        let lowest = || found.iter().flatten().map(|lying| lying.lowest);
        let (low, high) =
            (lowest().fold(f64::INFINITY, f64::min), lowest().fold(f64::NEG_INFINITY, f64::max));
        if found.iter().flatten().next().is_none() || high - low <= APART {
            return Vec::new();
        }
        // A stance that no frame shows is where the next one in time is.
        let away = |a: &Stance, b: &Stance| (a.start - b.end).max(b.start - a.end);
        let nearest = |stance: &Stance| {
            let known = list.iter().zip(&found).filter_map(|(other, lying)| Some((other, lying.as_ref()?)));
            let nearest = known.min_by(|a, b| away(stance, a.0).total_cmp(&away(stance, b.0)));
            nearest.map(|(_, lying)| lying.footing)
        };
        let all = list.iter().zip(&found);
        all.filter_map(|(stance, own)| own.as_ref().map(|own| own.footing).or_else(|| nearest(stance)))
            .collect()
    }

    /// How the foot of a stance lies while it moves least; `None` where no frame is of the stance.
    pub(super) fn lies(&self, stance: &Stance, belt: &Vector3<f64>) -> Option<Lying> {
        let (up, time) = (&self.prepared().up, self.prepared().time());
        let from = time.partition_point(|time| *time < stance.start);
        let to = time.partition_point(|time| *time <= stance.end);
        let mut rows: Vec<(f64, usize)> = (from..to)
            .map(|row| {
                let fastest = |v: &Vector3<f64>| (v - belt).norm();
                let speeds = self.frame(row)[stance.foot].velocities;
                (speeds.iter().map(fastest).fold(0.0, f64::max), row)
            })
            .collect();
        rows.sort_by(|a, b| a.0.total_cmp(&b.0));
        let slowest = ((rows.len() as f64 * SLOWEST).ceil() as usize).clamp(1, rows.len().max(1));
        let mut sums = [Vector3::zeros(); 3];
        for (_, row) in rows.get(..slowest)? {
            let points = self.frame(*row)[stance.foot].points;
            sums.iter_mut().zip(points).for_each(|(sum, point)| *sum += point / slowest as f64);
        }
        let [heel, ball, tip] = sums;
        let along = tip - heel;
        let side = up.cross(&along);
        // Of a sole that is one point nothing is tilted.
        let tilted = along.cross(&side).try_normalize(1e-9);
        let tilt = tilted.map_or(0.0, |tilted| tilted.angle(up));
        let bent = (ball - heel).angle(&(tip - ball));
        let is_on_edge = tilt > STEEPEST || bent > BENT || rows[slowest - 1].0 > STILL;
        let normal = tilted.filter(|_| tilt >= TILTED && !is_on_edge).unwrap_or(*up);
        let lowest = [heel, ball, tip].into_iter().min_by(|a, b| a.dot(up).total_cmp(&b.dot(up)))?;
        let point = if is_on_edge { lowest } else { heel.lerp(&ball, 0.5) };
        let footing = Footing { point, normal };
        let above = sums.map(|point| footing.above(&point, up));
        Some(Lying { footing, above, lowest: lowest.dot(up) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_foot_is_raised_by_what_it_is_above_where_it_lies() {
        let up = Vector3::y();
        let footing = Footing { point: Vector3::new(0.0, 0.3, 0.0), normal: Vector3::new(-0.6, 0.8, 0.0) };
        let lying = Lying { footing, above: [0.0, 0.01, -0.02], lowest: 0.3 };
        // The plane rises by 3 in 4.
        let points = [0.0, 0.4, 0.8].map(|x| Vector3::new(x, 0.3 + 0.75 * x + 0.05, 7.0));
        for (found, expected) in lying.raised(&points, &up).into_iter().zip([0.05, 0.04, 0.07]) {
            assert_relative_eq!(found, expected, epsilon = 1e-15);
        }
        assert_relative_eq!(footing.below(points[1], &up), Vector3::new(0.4, 0.6, 7.0), epsilon = 1e-15);
    }

    #[test]
    fn two_feet_stand_on_the_plane_through_both_that_is_level_aside() {
        let up = Vector3::y();
        let at = |x, y, z| Footing { point: Vector3::new(x, y, z), normal: Vector3::new(0.6, 0.8, 0.0) };
        let plane = Footing::through(&at(0.0, 0.1, 0.0), &at(0.3, 0.5, 0.4), &up);
        assert_relative_eq!(plane.point, Vector3::new(0.15, 0.3, 0.2), epsilon = 1e-15);
        for (point, above) in [((0.3, 0.5, 0.4), 0.0), ((0.4, 0.1, -0.3), 0.0), ((0.0, 0.3, 0.0), 0.2)] {
            let found = plane.above(&Vector3::new(point.0, point.1, point.2), &up);
            assert_relative_eq!(found, above, epsilon = 1e-15);
        }
        // One above the other says nothing of a tilt.
        assert_eq!(Footing::through(&at(0.0, 0.1, 0.0), &at(0.0, 0.5, 0.0), &up).normal, up);
    }
}
