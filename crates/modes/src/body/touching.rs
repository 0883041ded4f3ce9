//! What the ground does to links that touch it.

use crate::contact::{ContactLaw, Surface};
use nalgebra::Vector3;
use solaris_dynamics::{Real, Workspace, Wrench};
use solaris_profiles::Scalar;

/// The ground and the spheres of links that can touch it; see [`ContactLaw`] for the law.
#[derive(Clone, Debug)]
pub(super) struct GroundElement<T> {
    up: Vector3<T>,
    height: T,
    friction: T,
    stiffness: T,
    damping: T,
    /// `v_s²`.
    slip: T,
    touches: Vec<Sphere<T>>,
}

#[derive(Clone, Debug)]
struct Sphere<T> {
    link: usize,
    center: Vector3<T>,
    /// From the centre to the lowest point, in the world.
    down: Vector3<T>,
}

/// What the ground does at one touch.
#[derive(Clone, Debug)]
pub(crate) struct Pressed<T> {
    /// How deep the lowest point is (m), negative above the ground.
    pub(crate) depth: T,
    /// The lowest point, in the world (m).
    pub(crate) point: Vector3<T>,
    /// The velocity of the material there along the ground (m/s).
    pub(crate) slip: Vector3<T>,
    /// On the link, in the world (N).
    pub(crate) force: Vector3<T>,
    /// What damping takes (W).
    pub(crate) damping: T,
    /// What friction takes (W).
    pub(crate) friction: T,
}

/// What the ground does altogether.
#[derive(Clone, Debug)]
pub(crate) struct Pressure<T> {
    /// On all links, in the world (N).
    pub(crate) force: Vector3<T>,
    /// What damping takes (W).
    pub(crate) damping: T,
    /// What friction takes (W).
    pub(crate) friction: T,
}

impl<T: Real + Scalar> Pressure<T> {
    pub(super) fn none() -> Self {
        Self { force: Vector3::zeros(), damping: T::zero(), friction: T::zero() }
    }
}

impl<T: Real + Scalar> Sphere<T> {
    /// The lowest point, in the world.
    fn lowest(&self, workspace: &Workspace<T>) -> Vector3<T> {
        workspace.pose(self.link).transform(&self.center) + self.down
    }
}

impl<T: Real + Scalar> GroundElement<T> {
    /// That of `surface`.
    pub(super) fn of(surface: &Surface) -> Self {
        let number = <T as Real>::from_f64;
        let plane = &surface.plane;
        let ContactLaw::Spring { stiffness, damping, slip } = plane.law;
        let sphere = |touch: &crate::contact::Touch| Sphere {
            link: touch.link,
            center: touch.center.map(number),
            down: (plane.up.into_inner() * -touch.radius).map(number),
        };
        Self {
            up: plane.up.map(number),
            height: number(plane.height),
            friction: number(plane.friction),
            stiffness: number(stiffness),
            damping: number(damping),
            slip: number(slip * slip),
            touches: surface.touches.iter().map(sphere).collect(),
        }
    }

    /// How many spheres can touch it.
    pub(super) fn len(&self) -> usize {
        self.touches.len()
    }

    /// Adds to `external` what acts on the links, at the poses and velocities in `workspace`.
    pub(super) fn act(
        &self,
        workspace: &Workspace<T>,
        external: &mut Vec<(usize, Wrench<T>)>,
    ) -> Pressure<T> {
        let mut all = Pressure::none();
        for sphere in &self.touches {
            let pressed = self.pressed(sphere, workspace);
            if pressed.depth.value() > 0.0 {
                let Pressed { point, force, damping, friction, .. } = pressed;
                external.push((sphere.link, Wrench::at(&point, force, Vector3::zeros())));
                all.force += force;
                all.damping += damping;
                all.friction += friction;
            }
        }
        all
    }

    /// What it does at each touch, by its index, at the poses and velocities in `workspace`.
    pub(super) fn each(&self, workspace: &Workspace<T>) -> impl Iterator<Item = Pressed<T>> {
        self.touches.iter().map(|sphere| self.pressed(sphere, workspace))
    }

    /// What is in the springs (J), at the poses in `workspace`.
    pub(super) fn energy(&self, workspace: &Workspace<T>) -> T {
        let squares = self.touches.iter().map(|sphere| {
            let depth = self.height - sphere.lowest(workspace).dot(&self.up);
            if depth.value() > 0.0 { depth * depth } else { T::zero() }
        });
        <T as Real>::from_f64(0.5) * self.stiffness * squares.fold(T::zero(), |sum, square| sum + square)
    }

    fn pressed(&self, sphere: &Sphere<T>, workspace: &Workspace<T>) -> Pressed<T> {
        let point = sphere.lowest(workspace);
        let depth = self.height - point.dot(&self.up);
        let (pose, twist) = (workspace.pose(sphere.link), workspace.velocity(sphere.link));
        let arm = pose.rotation * sphere.center + sphere.down;
        let velocity = twist.linear + twist.angular.cross(&arm);
        let rate = -velocity.dot(&self.up);
        let slip = velocity + self.up * rate;
        let mut pressed =
            Pressed { depth, point, slip, force: Vector3::zeros(), damping: T::zero(), friction: T::zero() };
        let push = self.stiffness * depth * (<T as Real>::from_f64(1.0) + self.damping * rate);
        if depth.value() > 0.0 {
            // Where it comes out so fast that the damper would pull, the ground lets go, and the spring's energy is lost.
            let normal = if push.value() > 0.0 { push } else { T::zero() };
            pressed.damping = (normal - self.stiffness * depth) * rate;
            // v_t² + v_s² is never zero.
            let squared = slip.dot(&slip);
            let drag = self.friction * normal / (squared + self.slip).sqrt();
            pressed.friction = drag * squared;
            pressed.force = self.up * normal - slip * drag;
        }
        pressed
    }
}
