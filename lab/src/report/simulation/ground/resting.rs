//! Scenes that come to rest: grounds from soft to hard, and feet from light to heavy.

use super::fine::{DAMPING, Drop, LEG, REST};
use super::{MOST, RATE, Scene, answers, over, springs, touches};
use crate::report::simulation::figures::{Faulty, G, built};
use crate::report::simulation::solutions::Solution;
use nalgebra::{Complex, Matrix4};
use solaris_model::{Joint, LinkSpec, Vector3};
use solaris_modes::{
    Anchor, ContactLaw, GroundPlane, Method, PointSpring, Run, RunError, Settings, Simulation,
};

/// From which mass and pogo fall (m), and how long they are watched (s).
const HEIGHT: f64 = 0.01;
const DURATION: f64 = 0.5;
/// Of the pogo (kg).
const BODY: f64 = 2.0;
const FOOT: f64 = 0.2;

/// What falls on grounds from soft to hard.
pub(in crate::report::simulation) struct Ground {
    pub(in crate::report::simulation) scene: Scene,
    /// The longest step (s) at which the classical rule of order four is stable where it rests; none that nothing swings.
    pub(super) longest: Option<f64>,
}

/// A mass of 1 kg and a pogo, on springs of growing stiffness and on what plants them.
pub(in crate::report::simulation) fn grounds() -> Result<Vec<Ground>, Faulty> {
    let mut all = Vec::new();
    for pogo in [false, true] {
        for power in [3, 4, 5, 6, 7] {
            all.push(on_springs(pogo, 10_f64.powi(power))?);
        }
        let solution: Solution = if pogo { Box::new(planted) } else { Box::new(stopped) };
        let (name, simulation) = (format!("{}, Rigid", what(pogo)), falling(pogo, ContactLaw::Rigid)?);
        let scene = Scene { name, simulation, duration: DURATION, solution };
        all.push(Ground { scene, longest: None });
    }
    Ok(all)
}

/// The mass on a ground of which a step of 1e-3 s makes nothing.
#[cfg(feature = "stiff")]
pub(super) fn hard() -> Result<Scene, Faulty> {
    Ok(on_springs(false, 1e6)?.scene)
}

fn what(pogo: bool) -> &'static str {
    if pogo { "pogo" } else { "mass" }
}

fn on_springs(pogo: bool, stiffness: f64) -> Result<Ground, Faulty> {
    let (foot, body) = if pogo { (FOOT, Some(BODY)) } else { (1.0, None) };
    let drop = Drop { foot, body, stiffness };
    let scene = Scene {
        name: format!("{}, springs of {stiffness:e} N/m", what(pogo)),
        simulation: falling(pogo, springs(stiffness, DAMPING))?,
        duration: DURATION,
        solution: drop.motion(HEIGHT, DURATION, RATE),
    };
    Ok(Ground { scene, longest: Some(drop.longest()) })
}

/// The mass where it stays.
fn stopped(t: f64, q: &mut [f64], v: &mut [f64]) {
    let falls = 0.5 * G * t * t < HEIGHT;
    (q[0], v[0]) = if falls { (HEIGHT - 0.5 * G * t * t, -G * t) } else { (0.0, 0.0) };
}

fn falling(pogo: bool, law: ContactLaw) -> Result<Simulation, Faulty> {
    if pogo {
        let mut simulation = stilt(FOOT, |simulation, touch| {
            let up = nalgebra::Unit::new_unchecked(Vector3::y());
            simulation.set_ground(GroundPlane { up, height: 0.0, friction: 0.0, law }, touch)
        })?;
        simulation.set_start(&[REST + HEIGHT, -REST], &[0.0; 2])?;
        return Ok(simulation);
    }
    let figure = built("mass", [LinkSpec::root("mass", Joint::new("fall").ty()).mass(1.0)])?;
    over(&figure, (law, 0.0), touches(0, &[[0.0; 2]], 0.0), (&[HEIGHT], &[0.0]))
}

/// A body of 2 kg on a springy leg with a foot of a mass (kg).
fn stilt(
    foot: f64,
    lay: impl FnOnce(&mut Simulation, Vec<solaris_modes::ContactPoint>) -> Result<(), solaris_modes::SetupError>,
) -> Result<Simulation, Faulty> {
    let links = [
        LinkSpec::root("body", Joint::new("up").ty()).mass(BODY),
        LinkSpec::child("foot", "body", Joint::new("leg").ty()).mass(foot),
    ];
    let figure = built("pogo", links)?;
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, -G, 0.0));
    let between = [0, 1].map(|link| Anchor { link: Some(link), point: Vector3::zeros() });
    simulation.add_spring(PointSpring { between, stiffness: LEG[0], damping: LEG[1], rest: REST })?;
    lay(&mut simulation, touches(1, &[[0.0; 2]], 0.0))?;
    Ok(simulation)
}

/// The pogo where its foot stays: it falls as one, and then the body springs on the leg.
fn planted(t: f64, q: &mut [f64], v: &mut [f64]) {
    let (fall, speed) = ((2.0 * HEIGHT / G).sqrt(), (2.0 * HEIGHT * G).sqrt());
    if t < fall {
        q.copy_from_slice(&[REST + HEIGHT - 0.5 * G * t * t, -REST]);
        v.copy_from_slice(&[-G * t, 0.0]);
        return;
    }
    let rest = REST - BODY * G / LEG[0];
    let (length, velocity) =
        answers::landed([REST, speed, rest], (LEG[0] / BODY).sqrt(), 0.5 * LEG[1] / BODY, t - fall);
    q.copy_from_slice(&[length, -length]);
    v.copy_from_slice(&[velocity, -velocity]);
}

impl Drop {
    /// The longest step (s) at which the classical rule of order four is stable where it rests.
    fn longest(&self) -> f64 {
        // There the ground is a spring, and the damper k·b·d with the depth of the weight, m·g·b.
        let (m, k) = (self.foot, self.stiffness);
        let (upper, [leg, damper]) =
            (self.body.unwrap_or(1.0), if self.body.is_some() { LEG } else { [0.0; 2] });
        let weight = (m + self.body.unwrap_or(0.0)) * G;
        let motion = Matrix4::new(
            0.0,
            0.0,
            1.0,
            0.0,
            0.0,
            0.0,
            0.0,
            1.0,
            -(k + leg) / m,
            leg / m,
            -(weight * DAMPING + damper) / m,
            damper / m,
            leg / upper,
            -leg / upper,
            damper / upper,
            -damper / upper,
        );
        let eigenvalues = motion.complex_eigenvalues();
        let is_stable = |h: f64| {
            eigenvalues.iter().filter(|x| x.norm() > 1e-6).all(|x: &Complex<f64>| {
                let z = x * h;
                (z * (z * (z * (z / 24.0 + 1.0 / 6.0) + 0.5) + 1.0) + 1.0).norm() <= 1.0
            })
        };
        let (mut low, mut high) = (1e-7_f64, 1.0_f64);
        for _ in 0..100 {
            let middle = (low * high).sqrt();
            if is_stable(middle) { low = middle } else { high = middle }
        }
        low
    }
}

/// A foot under a body: so many times its mass.
pub(super) const RATIOS: [f64; 5] = [1e-6, 1e-3, 1.0, 1e3, 1e6];

/// What standing on a foot came to.
pub(super) struct Stood {
    /// The ground's force at the end less the weight, as a part of the weight.
    pub(super) off: f64,
    /// Of the energy at play, what has come from nowhere or gone.
    pub(super) energy: f64,
    /// What the run says that positions may be off by (m).
    pub(super) said: f64,
    pub(super) evaluations: f64,
}

/// A body of 2 kg lowered on a foot of `ratio` times its mass, until both rest; `planted` or on the springs that are taken where none
/// are named.
pub(super) fn foot(ratio: f64, planted: bool, method: Method) -> Result<Stood, String> {
    let mut simulation = stilt(ratio * BODY, |simulation, touch| {
        let mut plane = GroundPlane::under(simulation.figure(), simulation.gravity(), 0.0)?;
        if planted {
            plane.law = ContactLaw::Rigid;
        }
        simulation.set_ground(plane, touch)
    })?;
    // The leg presses all the time: nothing leaves the ground.
    simulation.set_start(&[0.33, -0.33], &[0.0; 2]).map_err(|error| error.to_string())?;
    let mut settings = Settings { method, forces: false, ..Settings::new(2.0, RATE) };
    settings.guard.evaluations = MOST;
    let run: Result<Run, RunError> = simulation.run(&settings);
    let run = run.map_err(|error| error.to_string())?;
    let last = run.motion.len() - 1;
    let force = run.motion.contact("foot").map_or(0.0, |track| track.samples[last].force.y);
    let weight = BODY * (1.0 + ratio) * G;
    Ok(Stood {
        off: (force / weight - 1.0).abs(),
        energy: run.report.energy.imbalance / run.report.energy.scale,
        said: run.report.error.map_or(f64::INFINITY, |error| error.position),
        evaluations: run.report.cost.counts.evaluations as f64,
    })
}
