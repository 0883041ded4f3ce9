//! The scenes that both step.

use super::points::{End, distance};
use crate::report::simulation::figures::{DOWN, Faulty, G, built, ratio};
use crate::report::simulation::ground::{self, touches};
use nalgebra::Unit;
use solaris_model::{Inertia, Joint, LinkSpec, Vector3, human};
use solaris_modes::{ContactLaw, GroundPlane, LimitLaw, Simulation};

/// A scene. All coordinates are hinges and slides: numbers that both have.
pub(super) struct Scene {
    pub(super) name: &'static str,
    pub(super) simulation: Simulation,
    /// How long (s).
    pub(super) duration: f64,
    /// Where it ends, where that is known in closed form.
    pub(super) answer: Option<End>,
    /// Where friction is smooth: the same with another speed (m/s) below which it creeps.
    pub(super) with_slip: Option<fn(f64) -> Result<Simulation, Faulty>>,
}

impl Scene {
    /// The greatest errors of a position and of a velocity at the end; of what slides on a soft ground those along it.
    pub(super) fn error(&self, found: &End, answer: &End) -> [f64; 2] {
        let of = if self.with_slip.is_some() { 0..1 } else { 0..answer.0.len() };
        let part = |end: &End| (end.0[of.clone()].to_vec(), end.1[of.clone()].to_vec());
        distance(&part(found), &part(answer))
    }
}

/// Those in the air, then those on the ground.
pub(super) fn all() -> Result<Vec<Scene>, String> {
    let air =
        |name, simulation, duration| Scene { name, simulation, duration, answer: None, with_slip: None };
    let mut scenes = vec![
        air("double pendulum, 2 s", ratio(1.0)?, 2.0),
        air("chain of 30, 1 s", chain()?, 1.0),
        air("person in the air, 66 dofs, 1 s", person()?, 1.0),
    ];
    let known = [
        ("Rigid: a rod tips over", "a rod tips over, 0.4 s"),
        ("Rigid: a block rocks", "a block rocks, 0.8 s"),
    ];
    for scene in ground::scenes::all()? {
        let Some((_, name)) = known.iter().find(|known| known.0 == scene.name) else { continue };
        let (mut q, mut v) = (scene.simulation.state().0.to_vec(), scene.simulation.state().1.to_vec());
        (scene.solution)(scene.duration, &mut q, &mut v);
        let ground::Scene { simulation, duration, .. } = scene;
        scenes.push(Scene { name, simulation, duration, answer: Some((q, v)), with_slip: None });
    }
    // By Coulomb's law.
    let stops = SPEED * SPEED / (2.0 * FRICTION * G);
    scenes.push(Scene {
        name: "a block slides to rest, 0.6 s",
        simulation: sliding(ContactLaw::SLIP)?,
        duration: 0.6,
        answer: Some((vec![stops, 0.0], vec![0.0; 2])),
        with_slip: Some(sliding),
    });
    Ok(scenes)
}

/// Rods of 0.1 m on hinges that turn about z and x by turns, let go curled up.
fn chain() -> Result<Simulation, Faulty> {
    const COUNT: usize = 30;
    let name = |i: usize| format!("rod{i}");
    let links = (0..COUNT).map(|i| {
        let joint = Joint::new(format!("joint{i}"));
        let below = if i == 0 { joint } else { joint.at(Vector3::new(0.0, -0.1, 0.0)) };
        let joint = if i % 2 == 0 { below.rz() } else { below.rx() };
        let link = if i == 0 {
            LinkSpec::root(name(0), joint)
        } else {
            LinkSpec::child(name(i), name(i - 1), joint)
        };
        link.mass(0.1).com(Vector3::new(0.002, -0.05, 0.001)).inertia(Inertia::diagonal(9e-5, 1e-5, 8e-5))
    });
    let mut simulation = Simulation::new(&built("chain", links)?, DOWN);
    simulation.set_start(&[0.1; COUNT], &[0.0; COUNT])?;
    Ok(simulation)
}

/// All joints move, each with a velocity of its own.
fn person() -> Result<Simulation, Faulty> {
    let figure = human(1.75, 73.0)?;
    let spread = |i: usize, of: f64, by: f64| of * (1.0 + by * i as f64).sin();
    let nv = figure.layout().nv();
    let q: Vec<f64> = (0..nv).map(|i| spread(i, 0.2, 2.0)).collect();
    let v: Vec<f64> = (0..nv).map(|i| spread(i, 1.0, 3.0)).collect();
    let mut simulation = Simulation::new(&figure, DOWN);
    simulation.set_limits(LimitLaw::Ignore)?;
    simulation.set_start(&q, &v)?;
    Ok(simulation)
}

/// Of the block that slides (m/s), and its coefficient of friction.
const SPEED: f64 = 2.0;
pub(super) const FRICTION: f64 = 0.4;
/// Under the block (N/m).
const STIFFNESS: f64 = 1e4;

/// 1 kg, as deep as its weight presses it.
fn sliding(slip: f64) -> Result<Simulation, Faulty> {
    let joint = Joint::new("root").tx().ty();
    let block = LinkSpec::root("block", joint).mass(1.0).inertia(Inertia::diagonal(1e-2, 1e-2, 1e-2));
    let mut simulation = Simulation::new(&built("block", [block])?, DOWN);
    let law = ContactLaw::Compliant { stiffness: STIFFNESS, damping: ContactLaw::DAMPING, slip };
    let plane = GroundPlane { up: Unit::new_unchecked(Vector3::y()), height: 0.0, friction: FRICTION, law };
    simulation.set_ground(plane, touches(0, &[[0.0; 2]], 0.0))?;
    simulation.set_start(&[0.0, -G / STIFFNESS], &[SPEED, 0.0])?;
    Ok(simulation)
}
