//! Compliant contact: forces of the ground on links that touch it.

use crate::contact::{ContactLaw, Surface};
use nalgebra::Vector3;
use solaris_dynamics::{Workspace, Wrench};
use solaris_profiles::Elementary;

/// The ground and the spheres of links that can touch it; see [`ContactLaw`] for the law.
#[derive(Clone, Debug)]
pub(super) struct GroundElement<T> {
    up: Vector3<T>,
    height: T,
    friction: T,
    law: Law<T>,
    contact_points: Vec<Sphere<T>>,
}

#[derive(Clone, Debug)]
enum Law<T> {
    Spring {
        stiffness: T,
        damping: T,
        /// `v_s²`.
        slip: T,
    },
    /// What it does is found along with the accelerations.
    Planted,
}

/// A sphere of a link.
#[derive(Clone, Debug)]
pub(super) struct Sphere<T> {
    pub(super) link: usize,
    center: Vector3<T>,
    /// From the centre to the lowest point, in the world.
    down: Vector3<T>,
}

/// How the material at the lowest point of a sphere moves, in the world.
pub(super) struct Lowest<T> {
    /// Where it is (m).
    pub(super) point: Vector3<T>,
    /// Its velocity (m/s).
    pub(super) velocity: Vector3<T>,
    /// Its acceleration (m/s²) where the sphere rolls.
    pub(super) rolling: Vector3<T>,
}

/// What the ground does at one touch.
#[derive(Clone, Debug)]
pub(crate) struct Pressed<T> {
    /// How deep the lowest point is (m), negative above the ground.
    pub(crate) depth: T,
    /// How fast it gets deeper (m/s).
    pub(crate) rate: T,
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

impl<T: Elementary> Pressure<T> {
    pub(super) fn none() -> Self {
        Self { force: Vector3::zeros(), damping: T::zero(), friction: T::zero() }
    }
}

impl<T: Elementary> Sphere<T> {
    /// The lowest point, in the world.
    pub(super) fn lowest(&self, workspace: &Workspace<T>) -> Vector3<T> {
        workspace.pose(self.link).transform(&self.center) + self.down
    }

    /// The lowest point and the material there, at the poses and velocities in `workspace`. Of a sphere that rolls the centre `C` is
    /// accelerated with `−ω̇ × d`, `d` from there to the lowest point, and the material at the lowest point with `ω × (ω × d)`.
    pub(super) fn material(&self, workspace: &Workspace<T>) -> Lowest<T> {
        let (pose, twist) = (workspace.pose(self.link), workspace.velocity(self.link));
        let arm = pose.rotation * self.center + self.down;
        Lowest {
            point: pose.translation + arm,
            velocity: twist.linear + twist.angular.cross(&arm),
            rolling: twist.angular.cross(&twist.angular.cross(&self.down)),
        }
    }

    /// The acceleration (m/s²) of the lowest point away from the ground, at the accelerations in `workspace`: that of the centre.
    fn rise(&self, workspace: &Workspace<T>, up: &Vector3<T>) -> T {
        let (pose, twist) = (workspace.pose(self.link), workspace.velocity(self.link));
        let (arm, acceleration) = (pose.rotation * self.center, workspace.acceleration(self.link));
        let turning = acceleration.angular.cross(&arm) + twist.angular.cross(&twist.angular.cross(&arm));
        up.dot(&(acceleration.linear + turning))
    }
}

impl<T: Elementary> GroundElement<T> {
    /// That of `surface`.
    pub(super) fn of(surface: &Surface) -> Self {
        let number = T::from_f64;
        let plane = &surface.plane;
        let law = match plane.law {
            ContactLaw::Compliant { stiffness, damping, slip } => Law::Spring {
                stiffness: number(stiffness),
                damping: number(damping),
                slip: number(slip * slip),
            },
            ContactLaw::Rigid => Law::Planted,
        };
        let sphere = |touch: &crate::contact::ContactPoint| Sphere {
            link: touch.link,
            center: touch.center.map(number),
            down: (plane.up.into_inner() * -touch.radius).map(number),
        };
        Self {
            up: plane.up.map(number),
            height: number(plane.height),
            friction: number(plane.friction),
            law,
            contact_points: surface.contact_points.iter().map(sphere).collect(),
        }
    }

    /// How many spheres can touch it.
    pub(super) fn len(&self) -> usize {
        self.contact_points.len()
    }

    /// Adds to `external` what acts on the links, at the poses and velocities in `workspace`.
    pub(super) fn act(
        &self,
        workspace: &Workspace<T>,
        external: &mut Vec<(usize, Wrench<T>)>,
    ) -> Pressure<T> {
        let mut all = Pressure::none();
        if matches!(self.law, Law::Planted) {
            return all;
        }
        for sphere in &self.contact_points {
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
        self.contact_points.iter().map(|sphere| self.pressed(sphere, workspace))
    }

    /// Out of the ground, of length 1.
    pub(super) fn up(&self) -> &Vector3<T> {
        &self.up
    }

    /// The spheres.
    pub(super) fn spheres(&self) -> &[Sphere<T>] {
        &self.contact_points
    }

    /// How far above the ground the lowest point of a sphere is (m), at the poses in `workspace`.
    pub(super) fn gap(&self, touch: usize, workspace: &Workspace<T>) -> T {
        self.contact_points[touch].lowest(workspace).dot(&self.up) - self.height
    }

    /// The accelerations (m/s²) of all lowest points away from the ground, at the accelerations in `workspace`.
    pub(super) fn rises(&self, workspace: &Workspace<T>) -> impl Iterator<Item = T> {
        self.contact_points.iter().map(|sphere| sphere.rise(workspace, &self.up))
    }

    /// What is in the springs (J), at the poses in `workspace`.
    pub(super) fn energy(&self, workspace: &Workspace<T>) -> T {
        let Law::Spring { stiffness, .. } = self.law else { return T::zero() };
        let squares = self.contact_points.iter().map(|sphere| {
            let depth = self.height - sphere.lowest(workspace).dot(&self.up);
            if depth.value() > 0.0 { depth * depth } else { T::zero() }
        });
        T::from_f64(0.5) * stiffness * squares.fold(T::zero(), |sum, square| sum + square)
    }

    fn pressed(&self, sphere: &Sphere<T>, workspace: &Workspace<T>) -> Pressed<T> {
        let Lowest { point, velocity, .. } = sphere.material(workspace);
        let depth = self.height - point.dot(&self.up);
        let rate = -velocity.dot(&self.up);
        let slip = velocity + self.up * rate;
        let mut pressed = Pressed {
            depth,
            rate,
            point,
            slip,
            force: Vector3::zeros(),
            damping: T::zero(),
            friction: T::zero(),
        };
        let Law::Spring { stiffness, damping, slip: least } = self.law else { return pressed };
        let push = stiffness * depth * (T::from_f64(1.0) + damping * rate);
        if depth.value() > 0.0 {
            // Where it comes out so fast that the damper would pull, the ground lets go, and the spring's energy is lost.
            let normal = if push.value() > 0.0 { push } else { T::zero() };
            pressed.damping = (normal - stiffness * depth) * rate;
            // v_t² + v_s² is never zero.
            let squared = slip.dot(&slip);
            let drag = self.friction * normal / (squared + least).sqrt();
            pressed.friction = drag * squared;
            pressed.force = self.up * normal - slip * drag;
        }
        pressed
    }
}
