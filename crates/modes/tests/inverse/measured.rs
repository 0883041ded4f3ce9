//! A subject's walk, measured, and what another program makes of it; skipped where the data is not at hand.

use serde_json::Value;
use solaris_io::{Table, record, sto};
use solaris_model::{
    Axis, Contact, Figure, FigureBuilder, ForceRecord, Inertia, Isometry3, Joint, LinkSpec, Matrix3,
    Rotation3, UnitQuaternion, Vector3,
};
use solaris_modes::{Completed, Filter, InverseOptions, complete, inverse_motion};
use std::fs::read_to_string;
use std::io::{Write, stderr};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/subject01_walk");

/// A file of the data; says so where it is not there.
fn file(name: &str) -> Option<String> {
    let path = format!("{FOLDER}/{name}");
    let text = read_to_string(&path).ok();
    if text.is_none() {
        // Straight to the terminal: what a test prints is not shown where it passes.
        let _ =
            writeln!(stderr(), "SKIPPED: {path} is not there, so nothing was compared with measured data");
    }
    text
}

/// Shown with `--nocapture`.
#[allow(clippy::print_stderr, reason = "numbers for who asks for them")]
fn say(text: &str) {
    eprintln!("{text}");
}

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(numbers).collect(),
        other => vec![other.as_f64().expect("a number")],
    }
}

fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from_row_slice(&numbers(value))
}

fn matrix(value: &Value) -> Matrix3<f64> {
    Matrix3::from_row_slice(&numbers(value))
}

fn text(value: &Value) -> &str {
    value.as_str().expect("a string")
}

/// A tree of one-dof joints.
struct Pinned {
    json: Value,
    figure: Figure,
}

impl Pinned {
    fn read(name: &str) -> Option<Self> {
        let json: Value = serde_json::from_str(&file(name)?).expect("JSON");
        let links = json["links"].as_array().expect("links");
        let mut builder = FigureBuilder::new(text(&json["source"]));
        for link in links {
            let rotation =
                UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(matrix(&link["R"])));
            let axis = vector(&link["axis"]);
            let axis =
                if link["type"] == "prismatic" { Axis::translation(axis) } else { Axis::rotation(axis) };
            let placed = Isometry3::from_parts(vector(&link["p"]).into(), rotation);
            let joint = Joint::new(text(&link["name"])).placed(placed).axis(axis).named(text(&link["name"]));
            let name = format!("link_{}", text(&link["name"]));
            let spec = match link["parent"].as_i64().expect("an index") {
                -1 => LinkSpec::root(name, joint),
                parent => {
                    LinkSpec::child(name, format!("link_{}", text(&links[parent as usize]["name"])), joint)
                }
            };
            let mass = link["mass"].as_f64().expect("a mass");
            builder = builder.link(
                spec.mass(mass)
                    .com(vector(&link["com"]))
                    .inertia(Inertia::Tensor(matrix(&link["inertia_com"]))),
            );
        }
        Some(Self { figure: builder.build().expect("valid"), json })
    }

    /// Its own motion.
    fn motion(&self) -> Completed {
        let [time, q, v, a] = ["time", "q", "qd", "qdd"].map(|key| numbers(&self.json[key]));
        Completed { time, q, v, a, ..Completed::default() }
    }

    /// The name of the link that carries a body.
    fn carrier(&self, body: &str) -> String {
        let index = self.json["body_of"][body].as_u64().expect("an index") as usize;
        format!("link_{}", text(&self.json["links"][index]["name"]))
    }

    /// Its own forces, at the times of its motion.
    fn wrenches(&self) -> Vec<ForceRecord> {
        let wrench = |body: &str| {
            let rows = numbers(&self.json[format!("wrench_{body}")]);
            let contact = |w: &[f64]| Contact {
                force: Vector3::new(w[0], w[1], w[2]),
                moment: Vector3::new(w[3], w[4], w[5]),
                cop: Vector3::zeros(),
            };
            let samples = rows.chunks_exact(6).map(contact).collect();
            ForceRecord { links: vec![self.carrier(body)], time: numbers(&self.json["time"]), samples }
        };
        ["calcn_r", "calcn_l"].map(wrench).to_vec()
    }

    fn gravity(&self) -> Vector3<f64> {
        vector(&self.json["gravity"])
    }
}

fn worst(ours: &[f64], theirs: &[f64]) -> f64 {
    assert_eq!(ours.len(), theirs.len());
    ours.iter().zip(theirs).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Same tree, same states, same wrenches, twice other programs' torques.
#[test]
fn pinned_trees_need_the_torques_that_others_find() {
    for (name, tolerance) in [("gait10dof_pinned.json", 1e-6), ("gait2354_pinned.json", 1e-5)] {
        let Some(pinned) = Pinned::read(name) else { return };
        let found = |loads: &[ForceRecord]| {
            let options = InverseOptions::default();
            let motion = pinned.motion();
            inverse_motion(&pinned.figure, pinned.gravity(), &motion, loads, options)
                .expect("finite states")
                .tau
        };
        let loaded = worst(&found(&pinned.wrenches()), &numbers(&pinned.json["tau_with_grf"]));
        let free = worst(&found(&[]), &numbers(&pinned.json["tau_no_external"]));
        say(&format!("{name}: {loaded:e} with, {free:e} N m without ground forces"));
        assert!(loaded < tolerance && free < tolerance, "{name}: {loaded:e} {free:e}");
    }
}

fn table(name: &str) -> Option<Table> {
    Some(sto::read(&file(name)?).expect("a table"))
}

fn filtered(pinned: &Pinned, motion: &Table, order: usize) -> Completed {
    let recorded = record::read(&pinned.figure, motion).expect("all coordinates");
    complete(&pinned.figure, &recorded.record, Some(Filter { cutoff: 6.0, order })).expect("equal steps")
}

/// Greatest differences in the rows of a window (s).
fn within(time: &[f64], window: (f64, f64), ours: &[f64], theirs: &[f64]) -> f64 {
    let width = ours.len() / time.len();
    let rows = time.iter().enumerate().filter(|(_, t)| (window.0..=window.1).contains(*t));
    rows.map(|(row, _)| worst(&ours[row * width..][..width], &theirs[row * width..][..width]))
        .fold(0.0, f64::max)
}

/// The trees' own states: `scipy`'s filter of order 2 with 30 samples of padding and a spline with other ends. Inside,
/// ends do not matter.
#[test]
fn filter_and_spline_give_the_states_of_another_chain() {
    let cases = [
        ("gait10dof_pinned.json", "subject01_walk_ik_planar10.mot", (0.3, 2.2), [1e-7, 1e-5, 5e-5]),
        ("gait2354_pinned.json", "subject01_walk_ik_3d23.mot", (0.6, 1.4), [1e-7, 1e-5, 1e-3]),
    ];
    for (tree, motion, window, tolerances) in cases {
        let (Some(pinned), Some(motion)) = (Pinned::read(tree), table(motion)) else { return };
        let (ours, theirs) = (filtered(&pinned, &motion, 2), pinned.motion());
        let pairs = [(&ours.q, &theirs.q), (&ours.v, &theirs.v), (&ours.a, &theirs.a)];
        for (i, (ours, theirs)) in pairs.into_iter().enumerate() {
            let (inside, whole) = (within(&theirs_time(&pinned), window, ours, theirs), worst(ours, theirs));
            say(&format!("{tree}, derivative {i}: {inside:e} in {window:?} s, {whole:e} to the ends"));
            assert!(inside < tolerances[i], "{tree}, derivative {i}: {inside:e}");
        }
    }
}

fn theirs_time(pinned: &Pinned) -> Vec<f64> {
    numbers(&pinned.json["time"])
}

/// What the trunk needs does not depend on the knees: it tells whether filter and spline are `OpenSim`'s, to the ends of
/// the record.
#[test]
fn the_lumbar_moment_is_that_of_opensim() {
    let cases = [
        (
            "gait10dof_pinned.json",
            "subject01_walk_ik_planar10.mot",
            "opensim46_id_planar10.sto",
            3.5e-4,
            &["lumbar_extension"][..],
        ),
        (
            "gait2354_pinned.json",
            "subject01_walk_ik_3d23.mot",
            "opensim46_id_3d23.sto",
            3e-3,
            &["lumbar_extension", "lumbar_bending", "lumbar_rotation"],
        ),
    ];
    for (tree, motion, reference, tolerance, joints) in cases {
        let (Some(pinned), Some(motion), Some(grf)) =
            (Pinned::read(tree), table(motion), table("subject01_walk_grf.mot"))
        else {
            return;
        };
        let Some(reference) = table(reference) else { return };
        let loads = [("calcn_r", ""), ("calcn_l", "1_")].map(|(body, prefix)| {
            record::forces(&grf, &[pinned.carrier(body)], prefix).expect("its columns")
        });
        let motion = filtered(&pinned, &motion, 3);
        let options = InverseOptions::default();
        let report = inverse_motion(&pinned.figure, pinned.gravity(), &motion, &loads, options)
            .expect("finite states");
        let nv = pinned.figure.layout().nv();
        for (dof, name) in pinned.figure.layout().v_names().iter().enumerate() {
            let heading = [format!("{name}_moment"), format!("{name}_force")];
            let Some(column) = heading.iter().find_map(|name| reference.column(name)) else { continue };
            let ours: Vec<f64> = report.tau.iter().skip(dof).step_by(nv).copied().collect();
            let theirs: Vec<f64> = reference.values_of(column).collect();
            let squares: f64 = ours.iter().zip(&theirs).map(|(a, b)| (a - b).powi(2)).sum();
            let (rms, worst) = ((squares / ours.len() as f64).sqrt(), worst(&ours, &theirs));
            say(&format!("{tree} {name}: rms {rms:.2e}, greatest {worst:.2e}"));
            assert!(!joints.contains(&name.as_str()) || worst < tolerance, "{name}: {worst:e}");
        }
    }
}
