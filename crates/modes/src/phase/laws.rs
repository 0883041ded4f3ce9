//! Laws that hold for every phase.

mod governor;
mod reduced;

use super::{Phase, Role, Watched};
use crate::body::random::{Random, configuration, figure, ground, limits, springs};
use crate::drive::force::Force;
use crate::drive::path::Path;
use crate::simulation::Simulation;
use crate::time::System;
use approx::assert_relative_eq;
use nalgebra::{DMatrix, Vector3};
use solaris_model::Figure;
use solaris_profiles::{Boundary, Clip, Curve, Quintic};
use std::sync::Arc;

/// A scene in which degrees of freedom have random roles, forces and motions.
struct Scene {
    simulation: Simulation,
    roles: Vec<Role>,
    q: Vec<f64>,
    v: Vec<f64>,
    forces: Vec<Force>,
    paths: Vec<Path>,
}

fn curve(duration: f64, start: [f64; 3], end: [f64; 3]) -> Arc<dyn Curve + Send + Sync> {
    let boundary = |[x, v, a]: [f64; 3]| Boundary::new(x, v, a);
    Arc::new(Quintic::new(duration, boundary(start), boundary(end)).expect("a duration"))
}

fn roles(random: &mut Random, figure: &Figure) -> Vec<Role> {
    let mut roles = Vec::new();
    for (i, link) in figure.links().iter().enumerate() {
        let kind = link.joint().kind();
        // Half of the scenes stand on prescribed ground.
        let loose = if i == 0 && random.chance(0.5) { 0.0 } else { 0.5 };
        if kind.quaternion().is_some() {
            let role = if random.chance(loose) { Role::Dynamic } else { Role::Still };
            roles.extend(vec![role; kind.nv()]);
        } else {
            roles.extend(kind.axes().iter().map(|_| match random.next() {
                x if x < loose => Role::Dynamic,
                x if x < 0.75 => Role::Prescribed,
                _ => Role::Still,
            }));
        }
    }
    roles
}

impl Scene {
    fn random(random: &mut Random) -> Self {
        let figure = figure(random);
        let mut simulation = Simulation::new(&figure, Vector3::new(0.3, -9.81, 1.0));
        simulation.springs = springs(random, &figure);
        simulation.limits = limits(random, &figure);
        let (roles, q) = (roles(random, &figure), configuration(random, &figure));
        let n = roles.len();
        let force = |_| {
            let [from, to] = [0.0; 2].map(|_| random.between(-20.0, 20.0));
            if random.chance(0.5) {
                Force::Constant(from)
            } else {
                Force::Along(Path::Along(Clip::new(curve(1.0, [from, 0.0, 0.0], [to, 0.0, 0.0]))))
            }
        };
        let forces = (0..n).map(force).collect();
        let path = |dof| {
            let at = figure.layout().coordinate(dof).map_or(0.0, |coordinate| q[coordinate]);
            if random.chance(0.2) {
                return Path::Still(at);
            }
            let [rate, change, to] = [1.0, 5.0, 1.0].map(|most| random.between(-most, most));
            Path::Along(Clip::new(curve(1.0, [at, rate, change], [to, 0.0, 0.0])))
        };
        let paths = (0..n).map(path).collect();
        let v = random.numbers(n, 2.0);
        simulation.surface = ground(random, &figure);
        Self { simulation, roles, q, v, forces, paths }
    }

    fn phase(&self, leave_out: bool) -> Phase {
        let mut phase =
            Phase::with(&self.simulation, &self.roles, &self.q, leave_out).expect("a valid scene");
        for (dof, role) in self.roles.iter().enumerate() {
            match role {
                Role::Dynamic => phase.set_force(dof, self.forces[dof].clone()),
                Role::Prescribed => phase.set_path(dof, self.paths[dof].clone()),
                Role::Still => {}
            }
        }
        phase
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| most.max(x.abs()))
}

fn rate(phase: &mut Phase, t: f64, y: &[f64]) -> Vec<f64> {
    let mut rate = vec![0.0; y.len()];
    phase.rate(t, y, &mut rate).expect("a state with inertia");
    rate
}

#[test]
fn the_jacobian_is_the_slope_of_the_rate() {
    for seed in 0..100 {
        let scene = Scene::random(&mut Random(seed));
        let mut phase = scene.phase(true);
        let mut y = phase.pack(&scene.q, &scene.v, 1.0, 2.0);
        // Quaternions as an integrator leaves them.
        for y in &mut y {
            *y *= 1.0 + 1e-5;
        }
        let n = y.len();
        let mut jacobian = DMatrix::from_element(n, n, f64::NAN);
        phase.jacobian(0.4, &y, &mut jacobian).expect("a state with inertia");
        let h = 1e-6;
        for column in 0..n {
            let mut at = |by: f64| {
                let mut y = y.clone();
                y[column] += by;
                rate(&mut phase, 0.4, &y)
            };
            let (before, after) = (at(-h), at(h));
            let scale = 1.0 + largest(&after) + jacobian.column(column).amax();
            for row in 0..n {
                let slope = (after[row] - before[row]) / (2.0 * h);
                assert_relative_eq!(jacobian[(row, column)], slope, epsilon = 2e-7 * scale);
            }
        }
    }
}

#[test]
fn a_state_is_the_same_after_packing_and_unpacking() {
    for seed in 0..100 {
        let scene = Scene::random(&mut Random(seed));
        let phase = scene.phase(true);
        let y = phase.pack(&scene.q, &scene.v, 1.0, 2.0);
        assert_eq!(y.len(), phase.len());
        let (mut q, mut v) = (vec![f64::NAN; scene.q.len()], vec![f64::NAN; scene.v.len()]);
        phase.unpack(0.0, &y, &mut q, &mut v);
        // The paths begin where everything is, but with velocities of their own.
        for (found, given) in q.iter().zip(&scene.q) {
            assert_relative_eq!(found, given, epsilon = 1e-15);
        }
        let again = phase.pack(&q, &v, 1.0, 2.0);
        for (entry, (found, given)) in again.iter().zip(&y).enumerate() {
            assert_relative_eq!(found, given, epsilon = 1e-15);
            match phase.dof_of(entry) {
                Some(dof) => assert_eq!(scene.roles[dof], Role::Dynamic),
                None => assert!(entry >= phase.accounts()),
            }
        }
        for dof in 0..scene.roles.len() {
            let sample = scene.paths[dof].at(0.0);
            let expected = match scene.roles[dof] {
                Role::Dynamic => scene.v[dof],
                Role::Prescribed => sample.velocity,
                Role::Still => 0.0,
            };
            assert_relative_eq!(v[dof], expected, epsilon = 1e-14);
        }
    }
}

/// Positions go on as [`Figure::integrate`] moves them.
#[test]
fn rates_of_positions_are_those_of_the_figure() {
    for seed in 0..100 {
        let scene = Scene::random(&mut Random(seed));
        let phase = scene.phase(true);
        let y = phase.pack(&scene.q, &scene.v, 0.0, 0.0);
        let mut rates = vec![0.0; y.len()];
        assert!(phase.position_rate(&y, &mut rates));
        let h = 1e-6;
        let stepped = |by: f64| {
            let step: Vec<f64> = scene.v.iter().map(|v| v * by).collect();
            let mut q = scene.q.clone();
            scene.simulation.figure.integrate(&scene.q, &step, &mut q).expect("finite");
            phase.pack(&q, &scene.v, 0.0, 0.0)
        };
        let (before, after) = (stepped(-h), stepped(h));
        let positions = phase.accounts() - scene.roles.iter().filter(|role| **role == Role::Dynamic).count();
        for entry in 0..positions {
            let slope = (after[entry] - before[entry]) / (2.0 * h);
            assert_relative_eq!(rates[entry], slope, epsilon = 1e-8);
        }
        assert!(rates[positions..].iter().all(|rate| *rate == 0.0));
    }
}

/// As explicit steps leave them, far from unit length.
#[test]
fn the_length_of_a_quaternion_does_not_count() {
    let mut seen = 0;
    for seed in 0..50 {
        let scene = Scene::random(&mut Random(seed));
        let mut phase = scene.phase(true);
        let y = phase.pack(&scene.q, &scene.v, 0.0, 0.0);
        let mut long = y.clone();
        for first in phase.state.quaternions() {
            long[first..first + 4].iter_mut().for_each(|x| *x *= 1.25);
            seen += 1;
        }
        let positions = phase.state.positions();
        let (expected, found) = (rate(&mut phase, 0.3, &y), rate(&mut phase, 0.3, &long));
        let scale = 1.0 + largest(&expected);
        for (found, expected) in found[positions..].iter().zip(&expected[positions..]) {
            assert_relative_eq!(found, expected, epsilon = 1e-11 * scale);
        }
        phase.settle(&mut long);
        for (found, expected) in long.iter().zip(&y) {
            assert_relative_eq!(found, expected, epsilon = 1e-15);
        }
    }
    assert!(seen > 20);
}

/// What the energy grows by is what the drives do less what dampers take.
#[test]
fn work_and_heat_account_for_the_energy() {
    for seed in 0..100 {
        let scene = Scene::random(&mut Random(seed));
        let mut phase = scene.phase(true);
        let (t, y) = (0.3, phase.pack(&scene.q, &scene.v, 0.0, 0.0));
        let rates = rate(&mut phase, t, &y);
        let (end, [work, heat, ..]) = (phase.accounts(), &rates[phase.accounts()..]) else {
            panic!("two accounts")
        };
        let h = 1e-6 / (1.0 + largest(&rates[..end]));
        let mut at = |by: f64| {
            let y: Vec<f64> = y.iter().zip(&rates).map(|(y, rate)| y + rate * by).collect();
            phase.energy(t + by, &y).expect("finite")
        };
        let (before, after) = (at(-h), at(h));
        let found = (after.total() - before.total()) / (2.0 * h);
        let rounding = 1e-16 * (after.kinetic + after.potential.abs() + after.elastic) / h;
        assert_relative_eq!(found, work - heat, max_relative = 1e-5, epsilon = 1e-5 + 20.0 * rounding);
    }
}

#[test]
fn what_is_watched_is_measured_from_its_value() {
    let scene = Scene::random(&mut Random(3));
    let mut phase = scene.phase(true);
    let t = 0.2;
    let y = phase.pack(&scene.q, &scene.v, 0.0, 0.0);
    let (mut q, mut v) = (scene.q.clone(), scene.v.clone());
    phase.unpack(t, &y, &mut q, &mut v);
    let layout = scene.simulation.figure.layout();
    let mut watched: Vec<Watched> =
        (0..layout.nv()).map(|dof| Watched::Velocity { dof, value: 0.5 }).collect();
    let mut expected: Vec<f64> = v.iter().map(|v| v - 0.5).collect();
    for dof in 0..layout.nv() {
        if let Some(coordinate) = layout.coordinate(dof) {
            watched.push(Watched::Position { dof, value: 0.2 });
            expected.push(q[coordinate] - 0.2);
        }
    }
    phase.watch(watched, Vec::new()).expect("valid");
    let mut values = vec![f64::NAN; phase.events()];
    phase.event_values(t, &y, &mut values);
    for (found, expected) in values.iter().zip(&expected) {
        assert_relative_eq!(found, expected, epsilon = 1e-15);
    }
}

#[test]
fn a_state_that_is_none_is_refused() {
    let scene = Scene::random(&mut Random(8));
    let mut phase = scene.phase(true);
    let y = phase.pack(&scene.q, &scene.v, 0.0, 0.0);
    assert!(y.len() > 2);
    for entry in 0..phase.accounts() {
        let mut bad = y.clone();
        bad[entry] = f64::NAN;
        let (mut rate, mut jacobian) = (vec![0.0; y.len()], DMatrix::zeros(y.len(), y.len()));
        assert!(phase.rate(0.0, &bad, &mut rate).is_err());
        assert!(phase.jacobian(0.0, &bad, &mut jacobian).is_err());
    }
}
