//! Limp people who are dropped in random poses, by every model of contact: nothing drives them, so that their energy only falls.

use super::ours::{method, settings, tree};
use super::peers::Ask;
use super::{Engine, MODELS, Peers};
use crate::report::page::duration;
use crate::table::{Cell, Table};
use nalgebra::{Quaternion, Rotation3, UnitQuaternion};
use solaris_dynamics::{Workspace, forward_kinematics, kinetic_energy, potential_energy};
use solaris_model::{Figure, Human, Vector3};
use solaris_modes::{ContactLaw, ContactPoint, GroundPlane, LimitLaw, Simulation, contact_points};
use std::time::Instant;

/// From how high the lowest point falls (m), for how long (s), and in how many frames.
const HEIGHT: f64 = 0.5;
const DURATION: f64 = 3.0;
const FRAMES: usize = 150;
/// Steps (s) of each model.
const STEPS: [f64; 3] = [5e-3, 2e-3, 1e-3];
/// Of springs: what weighs next to nothing needs such steps there, and nobody waits for more people than a few.
const FEW: u64 = 5;
const SHORT: [f64; 2] = [4e-5, 2e-5];
const FRICTION: f64 = 0.8;
const G: f64 = 9.81;

/// What one person came to: energies as shares of what the fall sets free.
struct Fall {
    /// In motion at the end.
    left: f64,
    /// The most that a frame's mechanical energy is above an earlier one's.
    grown: f64,
    /// How deep the deepest point went (m).
    depth: f64,
    /// The run's seconds for one simulated.
    seconds: f64,
}

/// All people by a model and a step; those that failed, told by why.
pub(super) struct Group {
    model: usize,
    step: f64,
    falls: Vec<Result<Fall, String>>,
}

struct Person {
    figure: Figure,
    touches: Vec<ContactPoint>,
}

/// Drops them.
pub(super) fn measured(poses: u64, peers: &mut Peers) -> Result<Vec<Group>, String> {
    let figure = Human::new(1.75, 73.0).limp().build().map_err(|error| error.to_string())?;
    let person = Person { touches: contact_points(&figure), figure };
    let mut groups = Vec::new();
    for (model, of) in MODELS.iter().enumerate() {
        let by_springs = of.engine == Engine::Ours { by_springs: true };
        let (steps, poses) = if by_springs { (&SHORT[..], FEW.min(poses)) } else { (&STEPS[..], poses) };
        for &step in steps {
            let falls = (0..poses).map(|seed| {
                let simulation = person.dropped(seed, by_springs)?;
                match of.engine {
                    Engine::Ours { .. } => Ok(Some(person.ours(&simulation, by_springs, step))),
                    engine => Ok(peers.of(engine).map(|(peer, setting)| {
                        let links: Vec<usize> = (0..person.figure.links().len()).collect();
                        let ask = Ask {
                            setting,
                            step,
                            duration: DURATION,
                            frames: FRAMES,
                            settle: None,
                            forces: &[],
                            elastic: 0.0,
                            links: &links,
                            once: true,
                        };
                        let answer = peer.ask(&simulation, &ask)?;
                        Ok(person.fall(&answer.poses, &answer.energy, answer.seconds))
                    })),
                }
            });
            let falls: Vec<_> = falls.collect::<Result<Vec<_>, String>>()?.into_iter().flatten().collect();
            if falls.is_empty() {
                continue;
            }
            let group = Group { model, step, falls };
            eprintln!(
                "contacts: dropped, {}",
                group.row().iter().map(Cell::markdown).collect::<Vec<_>>().join(", ")
            );
            if let Some(Err(why)) = group.falls.iter().find(|fall| fall.is_err()) {
                eprintln!("  {why}");
            }
            groups.push(group);
        }
    }
    Ok(groups)
}

/// Numbers in [0, 1), the same ones for the same seed.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

impl Person {
    /// In a random pose within its limits.
    fn dropped(&self, seed: u64, by_springs: bool) -> Result<Simulation, String> {
        let say = |error: &dyn std::fmt::Display| error.to_string();
        let figure = &self.figure;
        let down = Vector3::y() * -G;
        let mut simulation = Simulation::new(figure, down);
        let mut numbers = Numbers(seed);
        (0..10).for_each(|_| {
            numbers.next();
        });
        let mut q = vec![0.0; figure.layout().nq()];
        figure.random(&mut q, || numbers.next()).map_err(|error| say(&error))?;
        q[..3].fill(0.0);
        let tree = tree(figure, &down)?;
        let mut workspace = Workspace::new(&tree);
        forward_kinematics(&tree, &mut workspace, &q).map_err(|error| say(&error))?;
        let height =
            |touch: &ContactPoint| workspace.pose(touch.link).transform(&touch.center).y - touch.radius;
        q[1] = HEIGHT - self.touches.iter().map(height).fold(f64::INFINITY, f64::min);
        simulation.set_start(&q, &vec![0.0; figure.layout().nv()]).map_err(|error| say(&error))?;
        let mut plane = GroundPlane::under(figure, &down, FRICTION).map_err(|error| say(&error))?;
        plane.law = ContactLaw::Rigid;
        if by_springs {
            // As in `cargo lab falls`.
            plane.law = ContactLaw::Compliant { stiffness: 1e5, damping: ContactLaw::DAMPING, slip: 0.1 };
            let law = LimitLaw::Spring { stiffness: 1000.0, damping: 0.0 };
            simulation.set_limits(law).map_err(|error| say(&error))?;
        }
        simulation.set_ground(plane, self.touches.clone()).map_err(|error| say(&error))?;
        Ok(simulation)
    }

    fn ours(&self, simulation: &Simulation, by_springs: bool, step: f64) -> Result<Fall, String> {
        let settings = settings(method(by_springs, step), DURATION, FRAMES);
        let from = Instant::now();
        let motion = simulation.run(&settings).map_err(|error| error.to_string())?.motion;
        let seconds = from.elapsed().as_secs_f64();
        let tree = tree(&self.figure, simulation.gravity())?;
        let mut workspace = Workspace::new(&tree);
        let (mut poses, mut energy) = (Vec::new(), Vec::new());
        let say = |error: solaris_dynamics::DynamicsError| error.to_string();
        for frame in 0..motion.len() {
            let (q, v) = (motion.q(frame), motion.v(frame));
            let kinetic = kinetic_energy(&tree, &mut workspace, q, v).map_err(say)?;
            energy.push([kinetic, potential_energy(&tree, &mut workspace, q).map_err(say)?]);
            forward_kinematics(&tree, &mut workspace, q).map_err(say)?;
            let pose = |link: usize| {
                let pose = workspace.pose(link);
                let (at, turn) = (pose.translation, Rotation3::from_matrix_unchecked(pose.rotation));
                let turn = UnitQuaternion::from_rotation_matrix(&turn);
                [at.x, at.y, at.z, turn.w, turn.i, turn.j, turn.k]
            };
            poses.push((0..self.figure.links().len()).map(pose).collect());
        }
        Ok(self.fall(&poses, &energy, seconds))
    }

    fn fall(&self, poses: &[Vec<[f64; 7]>], energy: &[[f64; 2]], seconds: f64) -> Fall {
        let free = self.figure.mass() * G * HEIGHT;
        let mut depth = 0.0_f64;
        for links in poses {
            for touch in &self.touches {
                let [x, y, z, w, i, j, k] = links[touch.link];
                let turn = UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k));
                let at = Vector3::new(x, y, z) + turn * touch.center;
                depth = depth.max(touch.radius - at.y);
            }
        }
        let (mut least, mut grown) = (f64::INFINITY, 0.0_f64);
        for [kinetic, potential] in energy {
            grown = grown.max(kinetic + potential - least);
            least = least.min(kinetic + potential);
        }
        let left = energy.last().map_or(0.0, |energy| energy[0]);
        Fall { left: left / free, grown: grown / free, depth, seconds: seconds / DURATION }
    }
}

impl Group {
    fn row(&self) -> Vec<Cell> {
        let done: Vec<&Fall> = self.falls.iter().filter_map(|fall| fall.as_ref().ok()).collect();
        let sorted = |of: fn(&Fall) -> f64| {
            let mut all: Vec<f64> = done.iter().map(|fall| of(fall)).collect();
            all.sort_by(f64::total_cmp);
            [all.get(all.len() / 2), all.last()].map(|x| x.copied().unwrap_or(f64::NAN))
        };
        let numbers = |of| Cell::Numbers(sorted(of).to_vec());
        let seconds = sorted(|fall| fall.seconds)[0];
        vec![
            Cell::text(MODELS[self.model].name),
            Cell::text(format!("{:.0e} s", self.step)),
            Cell::text(format!("{} of {}", done.len(), self.falls.len())),
            numbers(|fall| fall.left),
            numbers(|fall| fall.grown),
            numbers(|fall| fall.depth),
            Cell::Time(duration(1e9 * seconds)),
        ]
    }
}

pub(super) fn table(groups: &[Group]) -> Table {
    let header = vec![
        "by",
        "step",
        "came to the end",
        "in motion at the end",
        "energy grown",
        "deepest (m)",
        "a second takes",
    ];
    Table { header, rows: groups.iter().map(Group::row).collect() }
}
