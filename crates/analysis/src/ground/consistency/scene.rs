//! The problem behind a consistent motion: from balances and outlines to bounds of second differences.

use crate::ground::BalanceFrame;
use crate::ground::consistency::interior::{Of, Problem, Side, Solution};
use crate::ground::consistency::{ConsistencyError, ConsistencyOptions, Violation};
use crate::ground::outline::{Edge, edges, has_room, outside};
use nalgebra::{Vector1, Vector3};
use solaris_dynamics::Wrench;
use solaris_model::GroundAxes;

/// What all frames share.
pub(super) struct Scene<'a> {
    pub(super) rate: f64,
    pub(super) mass: f64,
    pub(super) weight: f64,
    pub(super) level: f64,
    pub(super) ground: GroundAxes,
    pub(super) frames: &'a [BalanceFrame],
    pub(super) options: &'a ConsistencyOptions,
    /// Of each frame the edges of what stands; none in flight.
    pub(super) edges: Vec<Vec<Edge>>,
}

impl Scene<'_> {
    pub(super) fn stand(mut self, outlines: &[Vec<Vector3<f64>>]) -> Result<Self, ConsistencyError> {
        let margin = self.options.margin;
        self.edges.reserve(outlines.len());
        for (frame, outline) in outlines.iter().enumerate() {
            let flat: Vec<_> = outline.iter().map(|point| self.ground.flat(point)).collect();
            if flat.is_empty() {
                self.edges.push(vec![]);
                continue;
            }
            let sides = edges(&flat).ok_or(ConsistencyError::Outline { frame })?;
            if !has_room(&flat, &sides, margin) {
                return Err(ConsistencyError::Narrow { frame, margin });
            }
            let height = self.height(frame);
            if height <= 0.0 {
                return Err(ConsistencyError::Low { frame, height });
            }
            self.edges.push(sides);
        }
        Ok(self)
    }

    fn height(&self, frame: usize) -> f64 {
        self.frames[frame].com.dot(self.ground.up()) - self.level
    }

    fn smooth(&self) -> f64 {
        (self.options.smoothing * self.rate).powi(4)
    }

    /// The vertical stage: `Fₙ + m δ̈ₙ ≥ f·m·g`, in terms of the way by which the centre of pressure of a standing figure would move: both
    /// sides times `h/(m g)`.
    pub(super) fn upwards(&self) -> Solution<1> {
        let standing = (0..self.frames.len()).filter(|frame| !self.edges[*frame].is_empty());
        let sides = standing.map(|frame| {
            let reach = self.height(frame) / self.weight;
            let normal = self.frames[frame].force.dot(self.ground.up());
            Side {
                of: Of::Second,
                frame,
                along: Vector1::new(-reach * self.mass * self.rate * self.rate),
                reach: reach * (normal - self.options.least_force * self.weight),
            }
        });
        let limits =
            if self.options.limit.is_finite() { vec![self.options.limit; self.frames.len()] } else { vec![] };
        let problem =
            Problem { frames: self.frames.len(), smooth: self.smooth(), sides: sides.collect(), limits };
        problem.solve(self.options.iterations, self.options.tolerance)
    }

    /// The horizontal stage: `P' − δ` inside of every edge, by the margin.
    pub(super) fn across(&self, up: &Solution<1>) -> Result<Solution<2>, ConsistencyError> {
        let mut sides = Vec::with_capacity(self.edges.iter().map(Vec::len).sum());
        for (frame, edges) in self.edges.iter().enumerate().filter(|(_, edges)| !edges.is_empty()) {
            let BalanceFrame { force, moment, com, .. } = &self.frames[frame];
            let height = self.height(frame) + up.path.place[frame].x;
            if height <= 0.0 {
                return Err(ConsistencyError::Low { frame, height });
            }
            let pressed = up.path.second[frame].x * self.rate * self.rate * self.mass;
            let least = 0.5 * self.options.least_force * self.weight;
            let normal = (force.dot(self.ground.up()) + pressed).max(least);
            let spin = self.ground.up().cross(&(moment - com.cross(force)));
            let centre = self.ground.flat(&(com + (spin - force * height) / normal));
            let lever = height * self.mass * self.rate * self.rate / normal;
            sides.extend(edges.iter().map(|edge| Side {
                of: Of::Second,
                frame,
                along: -edge.out * lever,
                reach: edge.out.dot(&(edge.point - centre)) - self.options.margin,
            }));
        }
        let left = |up: &Vector1<f64>| {
            let limit = self.options.limit;
            (limit * limit - up.x * up.x).max(0.0).sqrt()
        };
        let limits =
            if self.options.limit.is_finite() { up.path.place.iter().map(left).collect() } else { vec![] };
        let problem = Problem { frames: self.frames.len(), smooth: self.smooth(), sides, limits };
        Ok(problem.solve(self.options.iterations, self.options.tolerance))
    }

    /// What is impossible, with the root where it is or moved and accelerated.
    pub(super) fn violation(
        &self,
        moved: Option<[&[Vector3<f64>]; 2]>,
    ) -> Result<Violation, ConsistencyError> {
        let mut worst = Violation::default();
        for (frame, edges) in self.edges.iter().enumerate().filter(|(_, edges)| !edges.is_empty()) {
            let BalanceFrame { force, moment, com, .. } = &self.frames[frame];
            let zero = Vector3::zeros();
            let (shift, acceleration) = moved.map_or((zero, zero), |[shift, a]| (shift[frame], a[frame]));
            let total = force + acceleration * self.mass;
            let moment = moment - com.cross(force) + (com + shift).cross(&total);
            let normal = total.dot(self.ground.up());
            let wrench = Wrench { force: total, moment };
            let centre = wrench.center_of_pressure(self.ground.up(), self.level);
            let out = centre.map_or(0.0, |centre| {
                let corners = edges.iter().map(|edge| edge.point);
                outside(&corners, &self.ground.flat(&(centre - shift)))
            });
            if !out.is_finite() || !normal.is_finite() {
                return Err(ConsistencyError::NotFinite { frame, what: "the centre of pressure" });
            }
            worst.outside = worst.outside.max(out);
            worst.pull = worst.pull.max(-normal);
            worst.frames += usize::from(centre.is_none() || out > self.options.tolerance);
        }
        Ok(worst)
    }
}
