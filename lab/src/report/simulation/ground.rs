//! Scenes that slide, drop, tip over and stand on a ground, by both laws of contact.

mod answers;
mod fine;
#[cfg(feature = "stiff")]
pub(super) mod picture;
pub(super) mod resting;
pub(super) mod scenes;
pub(super) mod tables;

use super::figures::{DOWN, Faulty};
use super::solutions::Solution;
use nalgebra::Unit;
use solaris_model::{Figure, Vector3};
use solaris_modes::{ContactLaw, ContactPoint, GroundPlane, Method, Run, Settings, Simulation};

/// Frames a second of all scenes on a ground.
const RATE: f64 = 100.0;

/// More evaluations are not spent on a run.
const MOST: u64 = 450_000;

/// A scene on a ground, and what it comes to. No coordinate of it is part of a quaternion.
pub(super) struct Scene {
    pub(super) name: String,
    pub(super) simulation: Simulation,
    /// How long (s).
    pub(super) duration: f64,
    pub(super) solution: Solution,
}

/// What a run came to.
pub(super) struct Found {
    /// The greatest error (rad or m) of a coordinate in a frame.
    pub(super) error: f64,
    pub(super) evaluations: f64,
    /// The error that the run itself told of, where it looked for one.
    pub(super) said: Option<f64>,
}

impl Scene {
    /// By a method, or what was said.
    pub(super) fn by(&self, method: Method) -> Result<Found, String> {
        let run = run(&self.simulation, method, self.duration).map_err(|error| error.to_string())?;
        let (mut q, mut v) = (run.motion.q(0).to_vec(), run.motion.v(0).to_vec());
        let mut error = 0.0_f64;
        for frame in 0..run.motion.len() {
            (self.solution)(run.motion.time()[frame], &mut q, &mut v);
            let off = q.iter().zip(run.motion.q(frame)).map(|(known, found)| (known - found).abs());
            error = off.fold(error, f64::max);
        }
        let said = run.report.error.map(|error| error.position);
        Ok(Found { error, evaluations: run.report.cost.counts.evaluations as f64, said })
    }
}

/// A run without joint forces.
fn run(simulation: &Simulation, method: Method, duration: f64) -> Result<Run, solaris_modes::RunError> {
    let mut settings = Settings { method, forces: false, estimate: false, ..Settings::new(duration, RATE) };
    settings.guard.evaluations = MOST;
    simulation.run(&settings)
}

/// A law of springs.
const fn springs(stiffness: f64, damping: f64) -> ContactLaw {
    ContactLaw::Compliant { stiffness, damping, slip: ContactLaw::SLIP }
}

/// Points, or spheres of a radius (m), of one link.
pub(super) fn touches(link: usize, points: &[[f64; 2]], radius: f64) -> Vec<ContactPoint> {
    let touch = |&[x, y]: &[f64; 2]| ContactPoint { link, center: Vector3::new(x, y, 0.0), radius };
    points.iter().map(touch).collect()
}

/// `figure` over a floor, from a start at rest or not.
fn over(
    figure: &Figure,
    (law, friction): (ContactLaw, f64),
    touches: Vec<ContactPoint>,
    (q, v): (&[f64], &[f64]),
) -> Result<Simulation, Faulty> {
    let mut simulation = Simulation::new(figure, DOWN);
    let plane = GroundPlane { up: Unit::new_unchecked(Vector3::y()), height: 0.0, friction, law };
    simulation.set_ground(plane, touches)?;
    simulation.set_start(q, v)?;
    Ok(simulation)
}
