//! Our side: by impulses, and by springs.

use super::scenes::{RULE, Scene, Told};
use solaris_dynamics::{Tree, Workspace, forward_kinematics, kinetic_energy, potential_energy};
use solaris_model::{Figure, Motion, Vector3};
use solaris_modes::{Method, RunError, Settings, Simulation};
use std::time::Instant;

/// For which something is left to itself before it is measured (s).
pub(super) const SETTLING: f64 = 0.5;

/// Runs of a setting are repeated for so long (s), but three times where that is no longer than the second.
const SPENT: [f64; 2] = [0.08, 0.5];

/// What a scene comes to by steps of `step` (s), by impulses or by springs, in so many `frames` after the first.
pub(super) fn told(scene: &Scene, by_springs: bool, step: f64, frames: usize) -> Result<Told, String> {
    let begun = if by_springs { scene.springs.as_ref() } else { Some(&scene.rigid) };
    let begun = begun.ok_or("links touch each other by impulses alone")?;
    let method = method(by_springs, step);
    let simulation = settled(scene, begun, method).map_err(|error| error.to_string())?;
    let run = |frames: usize| simulation.run(&settings(method, scene.duration, frames));
    let seconds = least(|| run(1).map(|_| ())).map_err(|error| error.to_string())?;
    let motion = run(frames).map_err(|error| error.to_string())?.motion;
    let [places, energy] = [&scene.watched[..], &[]].map(|links| seen(&simulation, &motion, links));
    let ((places, _), (_, energy)) = (places?, energy?);
    Ok(Told { seconds, places, energy })
}

pub(super) fn method(by_springs: bool, step: f64) -> Method {
    if by_springs { Method::Fixed { rule: RULE, step } } else { Method::Impulses { step } }
}

/// Without forces and without an error estimate.
pub(super) fn settings(method: Method, duration: f64, frames: usize) -> Settings {
    let rate = frames as f64 / duration;
    let mut settings = Settings { method, forces: false, estimate: false, ..Settings::new(duration, rate) };
    // Springs are measured with steps that nobody would wait for.
    settings.guard.evaluations = 100_000_000;
    settings
}

/// As it lies after a while under the gravity of [`Scene::settle`], with the velocities that it begins with.
fn settled(scene: &Scene, begun: &Simulation, method: Method) -> Result<Simulation, RunError> {
    let mut simulation = begun.clone();
    let Some(gravity) = scene.settle else { return Ok(simulation) };
    let figure = begun.figure();
    let (q, v) = begun.state();
    let mut calm = Simulation::new(figure, gravity);
    calm.set_start(q, &vec![0.0; v.len()])?;
    if let Some((plane, touches)) = begun.grounded() {
        calm.set_ground(*plane, touches.to_vec())?;
    }
    if let Some(collisions) = begun.collisions() {
        calm.set_collisions(collisions.clone())?;
    }
    for (dof, name) in figure.layout().v_names().iter().enumerate() {
        // Ball and free joints have one drive for all of a joint: they are free.
        if figure.layout().coordinate(dof).is_some() {
            calm.drive(name, begun.driven_by(dof).to_vec())?;
        }
    }
    let motion = calm.run(&settings(method, SETTLING, 1))?.motion;
    simulation.set_start(motion.q(motion.len() - 1), v)?;
    Ok(simulation)
}

/// The least time (s) of some runs, one after the other.
fn least<E>(mut run: impl FnMut() -> Result<(), E>) -> Result<f64, E> {
    let (mut least, mut spent, mut rounds) = (f64::INFINITY, 0.0, 0);
    while if spent < SPENT[0] { rounds < 1000 } else { rounds < 3 && spent < SPENT[1] } {
        let from = Instant::now();
        run()?;
        let seconds = from.elapsed().as_secs_f64();
        (least, spent, rounds) = (least.min(seconds), spent + seconds, rounds + 1);
    }
    Ok(least)
}

/// Where `links` are in every frame, and the energies of all.
type Seen = (Vec<Vec<Vector3<f64>>>, Vec<[f64; 2]>);

fn seen(simulation: &Simulation, motion: &Motion, links: &[usize]) -> Result<Seen, String> {
    let tree = tree(simulation.figure(), simulation.gravity())?;
    let mut workspace = Workspace::new(&tree);
    let (mut places, mut energies) = (Vec::new(), Vec::new());
    for frame in 0..motion.len() {
        let energy = [
            kinetic_energy(&tree, &mut workspace, motion.q(frame), motion.v(frame)),
            potential_energy(&tree, &mut workspace, motion.q(frame)),
        ];
        let [kinetic, potential] = energy.map(|energy| energy.map_err(|error| error.to_string()));
        energies.push([kinetic?, potential?]);
        forward_kinematics(&tree, &mut workspace, motion.q(frame)).map_err(|error| error.to_string())?;
        places.push(links.iter().map(|link| workspace.pose(*link).translation).collect());
    }
    Ok((places, energies))
}

pub(super) fn tree(figure: &Figure, gravity: &Vector3<f64>) -> Result<Tree<f64>, String> {
    Tree::new(figure, *gravity).map_err(|error| error.to_string())
}
