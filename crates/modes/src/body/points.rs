//! Springs and dampers between two points.

use crate::element::{Anchor, PointSpring};
use nalgebra::Vector3;
use solaris_dynamics::{Workspace, Wrench};
use solaris_profiles::Elementary;

/// How near (m) two points count as one: between them there is no direction.
const ONE_POINT: f64 = 1e-12;

/// A spring and damper between two points.
///
/// ```text
/// d = x₂ − x₁      l = |d|      F = k·(l − l₀) + c·l̇      on the first point:  F·d/l
/// ```
///
/// Two points in one place have no direction between them: nothing acts there, whatever the spring's rest length; the
/// pull of a spring without one is zero there in any case.
#[derive(Clone, Debug)]
pub(super) struct PointElement<T> {
    ends: [End<T>; 2],
    stiffness: T,
    damping: T,
    rest: T,
}

#[derive(Clone, Debug)]
struct End<T> {
    link: Option<usize>,
    point: Vector3<T>,
}

/// Where the ends are and how they move.
struct State<T> {
    /// In the world.
    points: [Vector3<T>; 2],
    /// The way from the first to the second.
    way: Vector3<T>,
    /// Its square.
    squared: T,
}

impl<T: Elementary> PointElement<T> {
    /// That of `spring`.
    pub(super) fn of(spring: &PointSpring) -> Self {
        let number = T::from_f64;
        Self {
            ends: spring.between.map(|Anchor { link, point }| End { link, point: point.map(number) }),
            stiffness: number(spring.stiffness),
            damping: number(spring.damping),
            rest: number(spring.rest),
        }
    }

    /// Adds to `external` what acts on the links, at the poses and velocities in `workspace`; what the damper takes (W).
    pub(super) fn act(&self, workspace: &Workspace<T>, external: &mut Vec<(usize, Wrench<T>)>) -> T {
        let State { points, way, squared } = self.state(workspace);
        let apart = squared.value() > ONE_POINT * ONE_POINT;
        let (mut pull, mut heat) = (T::zero(), T::zero());
        if self.rest.is_zero() {
            // In one place too, so that the derivatives are there.
            pull = self.stiffness;
        } else if apart {
            pull = self.stiffness - self.stiffness * self.rest / squared.sqrt();
        }
        if apart && !self.damping.is_zero() {
            // l·l̇ = d·ḋ
            let rate = way.dot(&(self.velocity(1, workspace) - self.velocity(0, workspace)));
            let damping = self.damping * rate / squared;
            pull += damping;
            heat = damping * rate;
        }
        let force = way * pull;
        for (end, point, force) in [(&self.ends[0], &points[0], force), (&self.ends[1], &points[1], -force)] {
            if let Some(link) = end.link {
                external.push((link, Wrench::at(point, force, Vector3::zeros())));
            }
        }
        heat
    }

    /// What is in the spring (J), at the poses in `workspace`.
    pub(super) fn energy(&self, workspace: &Workspace<T>) -> T {
        let stretch = self.state(workspace).squared.sqrt() - self.rest;
        T::from_f64(0.5) * self.stiffness * stretch * stretch
    }

    fn state(&self, workspace: &Workspace<T>) -> State<T> {
        let place =
            |end: &End<T>| end.link.map_or(end.point, |link| workspace.pose(link).transform(&end.point));
        let points = [place(&self.ends[0]), place(&self.ends[1])];
        let way = points[1] - points[0];
        State { points, way, squared: way.dot(&way) }
    }

    /// Of an end, in the world.
    fn velocity(&self, end: usize, workspace: &Workspace<T>) -> Vector3<T> {
        let End { link, point } = &self.ends[end];
        let Some(link) = *link else { return Vector3::zeros() };
        let (pose, twist) = (workspace.pose(link), workspace.velocity(link));
        twist.linear + twist.angular.cross(&(pose.rotation * point))
    }
}
