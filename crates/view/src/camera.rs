//! The camera's path and box, so that the whole figure is in view at any time of the motion.

use glam::DVec3;

/// A box along the page's axes (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub(crate) low: DVec3,
    pub(crate) high: DVec3,
}

impl Bounds {
    /// From the middle and half of the edges.
    pub(crate) fn around(middle: DVec3, half: DVec3) -> Self {
        Self { low: middle - half, high: middle + half }
    }

    /// The smallest box around both.
    pub(crate) fn union(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    /// This box as seen from `origin`.
    fn seen_from(self, origin: DVec3) -> Self {
        Self { low: self.low - origin, high: self.high - origin }
    }

    /// The edges.
    pub(crate) fn edges(self) -> DVec3 {
        self.high - self.low
    }

    fn middle(self) -> DVec3 {
        self.low.midpoint(self.high)
    }
}

/// The path of the camera's aim, and the box around it that holds the figure in every frame.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Camera {
    /// Middle of the box, one a frame (m).
    pub(crate) aim: Vec<DVec3>,
    /// Half of the box's edges (m), never all zero.
    pub(crate) half: DVec3,
}

/// A camera that stands still may frame up to so many times the figure's own greatest edge more than one that follows; up and down
/// over ground that is not level, which shows how the camera moves.
const WORTH_FOLLOWING: f64 = 0.5;
const WORTH_CLIMBING: f64 = 0.2;
/// The aim is calm unless the figure then fills less of the box than one part in this many.
const FILLED: f64 = 4.0;
/// Half of the edge of a box around nothing (m).
const LEAST_HALF: f64 = 1e-6;

impl Camera {
    /// For `boxes`, the figure's in each frame (m), and `carrier`, a point that goes calmly where the figure goes: its
    /// centre of mass, or its root; `climbs`: whether the ground is not level.
    ///
    /// Along each axis the aim is the calmest of these three: it rests, it moves with the carrier, or it keeps to the
    /// middle of the box. The first is taken unless following spares half of the figure's size, up or down a slope a fifth.
    pub(crate) fn new(boxes: &[Bounds], carrier: &[DVec3], climbs: bool) -> Self {
        let still = joined(boxes.iter().copied());
        let carried = joined(boxes.iter().zip(carrier).map(|(bounds, at)| bounds.seen_from(*at)));
        let own = boxes.iter().map(|bounds| bounds.edges()).fold(DVec3::ZERO, DVec3::max);
        let size = own.max_element();
        let worth =
            DVec3::splat(WORTH_FOLLOWING).with_y(if climbs { WORTH_CLIMBING } else { WORTH_FOLLOWING });
        let rests = still.edges().cmple(carried.edges() + worth * size)
            & still.edges().cmple(DVec3::splat(FILLED * size));
        let goes_along = carried.edges().cmple(DVec3::splat(FILLED * size));
        let aim = |(bounds, at): (&Bounds, &DVec3)| {
            let follows = DVec3::select(goes_along, *at + carried.middle(), bounds.middle());
            DVec3::select(rests, still.middle(), follows)
        };
        let half = DVec3::select(rests, still.edges(), DVec3::select(goes_along, carried.edges(), own)) / 2.0;
        Self {
            aim: boxes.iter().zip(carrier).map(aim).collect(),
            half: if half.max_element() > LEAST_HALF { half } else { DVec3::splat(LEAST_HALF) },
        }
    }

    /// The greatest edge of the box (m).
    pub(crate) fn size(&self) -> f64 {
        2.0 * self.half.max_element()
    }
}

fn joined(boxes: impl Iterator<Item = Bounds>) -> Bounds {
    boxes.reduce(Bounds::union).unwrap_or(Bounds { low: DVec3::ZERO, high: DVec3::ZERO })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cube of 1 m around each point.
    fn cubes(path: &[DVec3]) -> Vec<Bounds> {
        path.iter().map(|at| Bounds::around(*at, DVec3::splat(0.5))).collect()
    }

    fn line(end: DVec3) -> Vec<DVec3> {
        (0..=20).map(|i| end * (f64::from(i) / 20.0)).collect()
    }

    /// Whether every box is in view in its frame.
    fn holds(camera: &Camera, boxes: &[Bounds]) -> bool {
        boxes.iter().zip(&camera.aim).all(|(bounds, aim)| {
            let seen = bounds.seen_from(*aim);
            seen.low.cmpge(-camera.half - 1e-9).all() && seen.high.cmple(camera.half + 1e-9).all()
        })
    }

    #[test]
    fn it_follows_down_as_well_as_along() {
        let path = line(DVec3::new(0.0, -20.0, 30.0));
        let camera = Camera::new(&cubes(&path), &path, false);
        assert!(holds(&camera, &cubes(&path)));
        assert!((camera.size() - 1.0).abs() < 1e-12, "{}", camera.size());
        assert!((camera.aim[20] - camera.aim[0]).distance(path[20]) < 1e-12);
    }

    #[test]
    fn it_rests_where_little_moves() {
        let path = line(DVec3::new(0.0, 0.4, 0.0));
        let camera = Camera::new(&cubes(&path), &path, false);
        assert!(holds(&camera, &cubes(&path)));
        assert_eq!((camera.aim[0], camera.half.y), (camera.aim[20], 0.7));
    }

    #[test]
    fn it_follows_sooner_where_the_ground_goes_up() {
        let path = line(DVec3::new(0.0, 0.4, 3.0));
        let camera = Camera::new(&cubes(&path), &path, true);
        assert!(holds(&camera, &cubes(&path)));
        assert!((camera.half.y - 0.5).abs() < 1e-12, "{}", camera.half);
    }

    #[test]
    fn a_carrier_that_stays_behind_loses_nobody() {
        let path = line(DVec3::new(0.0, -20.0, 0.0));
        let camera = Camera::new(&cubes(&path), &[DVec3::ZERO; 21], false);
        assert!(holds(&camera, &cubes(&path)));
        assert!((camera.size() - 1.0).abs() < 1e-12, "{}", camera.size());
    }

    #[test]
    fn what_swings_about_a_fixed_point_is_framed_by_all_of_its_swing() {
        let bob = |i: i32| DVec3::new((f64::from(i) * 0.3).sin(), -(f64::from(i) * 0.3).cos(), 0.0);
        let path: Vec<DVec3> = (0..21).map(bob).collect();
        let boxes: Vec<Bounds> =
            path.iter().map(|end| Bounds { low: end.min(DVec3::ZERO), high: end.max(DVec3::ZERO) }).collect();
        let camera = Camera::new(&boxes, &path, false);
        assert!(holds(&camera, &boxes));
        assert!(camera.aim.iter().all(|aim| *aim == camera.aim[0]));
    }

    #[test]
    fn a_point_that_rests_is_seen_from_somewhere() {
        let nothing = Bounds { low: DVec3::ONE, high: DVec3::ONE };
        let camera = Camera::new(&[nothing], &[DVec3::ZERO], false);
        assert!(camera.size() > 0.0 && camera.aim == [DVec3::ONE]);
    }
}
