//! Closed loops: three problems of the `IFToMM` multibody benchmark library.

use super::{Outcome, Problem, worst};
use crate::report::page::duration;
use crate::table::{Cell, Table};
use nalgebra::{Rotation3, Vector3};
use solaris_model::{FigureBuilder, Inertia, Joint, LinkSpec, Motion};
use solaris_modes::{Anchor, Loop, LoopKind, Method, Simulation};
use std::f64::consts::PI;
use std::fmt::Display;

const G: f64 = 9.81;

/// Those that a tolerance is asked of: of forty windows an evaluation takes milliseconds.
pub(super) fn all() -> Result<Vec<Problem>, String> {
    Ok(vec![windows(2)?, squeezer()?, bricard()?])
}

/// By impulses, in three steps (s) each, with how far loops come apart (m).
pub(super) fn by_impulses() -> Result<Table, String> {
    let millisecond = [1e-2, 1e-3, 1e-4];
    let steps = [millisecond, [2e-5, 2e-6, 2e-7], millisecond, millisecond, millisecond];
    let row = |(problem, steps): (&Problem, [f64; 3])| {
        let mut row = vec![Cell::text(problem.name)];
        for step in steps {
            let solved = problem.solve(Method::Impulses { step });
            let Outcome { off, run, time } = solved.map_err(|error| format!("{}: {error}", problem.name))?;
            let apart = run.report.loops.iter().map(|held| held.apart).fold(1e-10, f64::max);
            row.push(Cell::Numbers(vec![off, apart]));
            row.push(Cell::Time(duration(time * 1e6)));
        }
        Ok(row)
    };
    let problems: Vec<Problem> = all()?.into_iter().chain([windows(40)?, bowling()?]).collect();
    Ok(Table {
        header: vec![
            "off / apart",
            "10 ms (20 µs)",
            "time",
            "1 ms (2 µs)",
            "time",
            "0.1 ms (0.2 µs)",
            "time",
        ],
        rows: problems.iter().zip(steps).map(row).collect::<Result<_, String>>()?,
    })
}

/// Drake's bowling ball: along a parabola while it slides, and straight once it rolls.
fn bowling() -> Result<Problem, String> {
    const G: f64 = 9.8;
    let (radius, mass, inertia, friction) = (0.107_95, 6.35, 0.0296, 0.12);
    let (begun, spin) = (Vector3::z() * 8.0, Vector3::z() * (-8.0 * PI));
    let sliding = begun + spin.cross(&(Vector3::y() * -radius));
    let braking = sliding.normalize() * (friction * G);
    // The point that touches slows down by (1 + m·r²/I)·μ·g.
    let rolls = sliding.norm() / (friction * G * (1.0 + mass * radius * radius / inertia));
    let place = move |t: f64| {
        let slid = t.min(rolls);
        begun * t - braking * (0.5 * slid * slid + slid * (t - slid))
    };
    Problem::of_scene("bowling ball, 3 s", "bowling", move |motion| {
        worst(motion, |t, q| (Vector3::new(q[0], 0.0, q[2]) - place(t)).norm())
    })
}

/// A02: `n` windows of four uniform bars of 1 m and 1 kg that fall over together, beginning upright at 1 m/s, and what they do as one
/// body with the angle θ from the vertical:
///
/// ```text
/// ((n + 1)/3 + n)·θ̈ = ((n + 1)/2 + n)·g·sin θ
/// ```
fn windows(n: usize) -> Result<Problem, String> {
    let simulation = built_windows(n)?;
    let posts = (n + 1) as f64;
    let mass = posts / 3.0 + n as f64;
    let lift = (0.5 * posts + n as f64) * G;
    let seconds = if n == 2 { 10.0 } else { 20.0 };
    let known = Swing::new(seconds, -1.0, |_| mass, |angle| lift * angle.cos());
    // B₀, the top of the first post.
    let top = |angle: f64| Vector3::new(-angle.sin(), angle.cos(), 0.0);
    let off = move |motion: &Motion| worst(motion, |t, q| (top(q[0]) - top(known.at(t))).norm());
    let name = if n == 2 { "A02, two windows, 10 s" } else { "A02, forty windows, 20 s" };
    Ok(Problem { name, simulation, duration: seconds, rate: 20.0, off: Box::new(off) })
}

fn built_windows(n: usize) -> Result<Simulation, String> {
    let across = 1.0 / 12.0;
    let post = |i: usize| {
        LinkSpec::child(
            format!("post{i}"),
            "frame",
            Joint::new(format!("post{i}")).at(Vector3::x() * i as f64).rz(),
        )
        .mass(1.0)
        .com(Vector3::y() * 0.5)
        .inertia(Inertia::diagonal(across, 0.0, across))
    };
    let lintel = |i: usize| {
        let joint = Joint::new(format!("lintel{i}")).at(Vector3::y()).rz();
        LinkSpec::child(format!("lintel{i}"), format!("post{}", i - 1), joint)
            .mass(1.0)
            .com(Vector3::x() * 0.5)
            .inertia(Inertia::diagonal(0.0, across, across))
    };
    let mut builder =
        FigureBuilder::new("windows").link(LinkSpec::root("frame", Joint::new("frame"))).link(post(0));
    for i in 1..=n {
        builder = builder.link(lintel(i)).link(post(i));
    }
    let figure = builder.build().map_err(said)?;
    let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
    let layout = figure.layout();
    let velocities: Vec<f64> =
        layout.v_names().iter().map(|name| if name.starts_with("post") { -1.0 } else { 1.0 }).collect();
    simulation.set_start(&vec![0.0; velocities.len()], &velocities).map_err(said)?;
    for i in 1..=n {
        let anchor = |name: String, point| Anchor { link: figure.link_index(&name), point };
        let between = [anchor(format!("lintel{i}"), Vector3::x()), anchor(format!("post{i}"), Vector3::y())];
        simulation.add_loop(Loop::new(between, LoopKind::Connect)).map_err(said)?;
    }
    Ok(simulation)
}

/// A03, Andrews' squeezing mechanism: where its seven angles are after 30 ms, by the Test Set for IVP Solvers (Bari, release 2.4).
fn squeezer() -> Result<Problem, String> {
    const END: [(&str, f64); 7] = [
        ("beta", 15.810_771_196_299_04),
        ("theta", -15.756_371_059_842_98),
        ("gamma", 0.040_822_240_130_731_01),
        ("phi", -0.534_730_116_322_694_8),
        ("delta", 0.524_409_965_880_530_4),
        ("omega", 0.534_730_116_322_694_8),
        ("epsilon", 1.048_080_741_042_263),
    ];
    let mut problem = Problem::of_scene("A03, squeezer, 30 ms", "squeezer", |_| 0.0)?;
    let layout = problem.simulation.figure().layout().clone();
    let known: Vec<(usize, f64)> = END
        .iter()
        .map(|(name, angle)| {
            let index = layout.dof_index(&format!("{name}.rz")).and_then(|dof| layout.coordinate(dof));
            index.map(|i| (i, *angle)).ok_or_else(|| format!("no angle {name}"))
        })
        .collect::<Result<_, _>>()?;
    problem.off = Box::new(move |motion: &Motion| {
        let end = motion.q(motion.len() - 1);
        known.iter().map(|(i, angle)| (end[*i] - angle).abs()).fold(0.0, f64::max)
    });
    Ok(problem)
}

/// A04, Bricard's mechanism of five rods on a cube: where the rods' ends are, all of them told by the angle `q` of the first hinge,
///
/// ```text
/// q₁ = q₃ = q₅ = q     q₂ = −q₄ = … = −p     sin p = sin q/(1 + sin q)
/// ```
fn bricard() -> Result<Problem, String> {
    // Of a uniform rod with the ends a and b: m/6·(ȧ² + ȧ·ḃ + ḃ²) = ½M q̇².
    let mass = |q: f64| {
        const H: f64 = 1e-6;
        let (after, before) = (corners(q + H), corners(q - H));
        let rates: Vec<Vector3<f64>> = (0..6).map(|i| (after[i] - before[i]) / (2.0 * H)).collect();
        rates
            .windows(2)
            .map(|ends| (ends[0].norm_squared() + ends[0].dot(&ends[1]) + ends[1].norm_squared()) / 3.0)
            .sum()
    };
    let potential = |q: f64| G * corners(q).windows(2).map(|ends| 0.5 * (ends[0].y + ends[1].y)).sum::<f64>();
    let known = Swing::new(10.0, 0.0, mass, potential);
    let off = move |motion: &Motion| {
        // P₃, where the third rod ends.
        worst(motion, |t, q| (chain(&[q[0], q[1], q[2], q[3], q[4]])[3] - corners(known.at(t))[3]).norm())
    };
    Problem::of_scene("A04, Bricard, 10 s", "bricard", off)
}

/// The ends of the rods, the first at the origin.
fn corners(q: f64) -> [Vector3<f64>; 6] {
    let p = (q.sin() / (1.0 + q.sin())).asin();
    chain(&[q, -p, q, -p, q])
}

fn chain(angles: &[f64; 5]) -> [Vector3<f64>; 6] {
    let (x, y, z) = (Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis());
    let rods = [x.into_inner(), -y.into_inner(), z.into_inner(), -x.into_inner(), y.into_inner()];
    let mut turned = Rotation3::identity();
    let mut ends = [Vector3::zeros(); 6];
    for (i, (axis, rod)) in [y, z, x, y, z].iter().zip(rods).enumerate() {
        turned *= Rotation3::from_axis_angle(axis, angles[i]);
        ends[i + 1] = ends[i] + turned * rod;
    }
    ends
}

/// What moves with one degree of freedom: `½M(q)·q̇² + V(q)` stays, begun at zero with a rate, followed by the classical rule of order
/// four in steps that are fine enough.
struct Swing {
    /// Angles (rad), one a step.
    angles: Vec<f64>,
}

impl Swing {
    /// (s)
    const STEP: f64 = 1e-4;

    fn new(seconds: f64, rate: f64, mass: impl Fn(f64) -> f64, potential: impl Fn(f64) -> f64) -> Self {
        const H: f64 = 1e-4;
        let slope = |f: &dyn Fn(f64) -> f64, q: f64| {
            (8.0 * (f(q + H) - f(q - H)) - (f(q + 2.0 * H) - f(q - 2.0 * H))) / (12.0 * H)
        };
        let acceleration = |q: f64, v: f64| -(0.5 * slope(&mass, q) * v * v + slope(&potential, q)) / mass(q);
        let (mut q, mut v, h) = (0.0, rate, Self::STEP);
        let mut angles = vec![q];
        for _ in 0..(seconds / h).round() as usize {
            let (q1, v1) = (v, acceleration(q, v));
            let (q2, v2) = (v + 0.5 * h * v1, acceleration(q + 0.5 * h * q1, v + 0.5 * h * v1));
            let (q3, v3) = (v + 0.5 * h * v2, acceleration(q + 0.5 * h * q2, v + 0.5 * h * v2));
            let (q4, v4) = (v + h * v3, acceleration(q + h * q3, v + h * v3));
            q += h / 6.0 * (q1 + 2.0 * q2 + 2.0 * q3 + q4);
            v += h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
            angles.push(q);
        }
        Self { angles }
    }

    /// At a time (s), along a cubic through the nearest four.
    fn at(&self, time: f64) -> f64 {
        let place = time / Self::STEP;
        let first = (place.floor() as usize).clamp(1, self.angles.len() - 3) - 1;
        let x = place - first as f64;
        (0..4)
            .map(|i| {
                let weight = (0..4).filter(|j| *j != i).map(|j| (x - j as f64) / (i as f64 - j as f64));
                weight.product::<f64>() * self.angles[first + i]
            })
            .sum()
    }
}

fn said(error: impl Display) -> String {
    error.to_string()
}
