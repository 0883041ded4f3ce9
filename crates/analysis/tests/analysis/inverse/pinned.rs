//! Trees of one-dof joints with their motion and forces, from the measured data.

use crate::states::States;
use serde_json::Value;
use solaris_model::{
    Axis, Contact, Figure, FigureBuilder, Inertia, Isometry3, Joint, LinkSpec, Matrix3, MeasuredForce,
    Rotation3, UnitQuaternion, Vector3,
};
use std::fs::read_to_string;
use std::io::{Write, stderr};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/subject01_walk");

/// A file of the data; says so where it is not there.
pub(crate) fn file(name: &str) -> Option<String> {
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
pub(crate) fn say(text: &str) {
    eprintln!("{text}");
}

pub(crate) fn numbers(value: &Value) -> Vec<f64> {
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
pub(crate) struct Pinned {
    pub(crate) json: Value,
    pub(crate) figure: Figure,
}

impl Pinned {
    pub(crate) fn read(name: &str) -> Option<Self> {
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
    pub(crate) fn motion(&self) -> States {
        let [time, q, v, a] = ["time", "q", "qd", "qdd"].map(|key| numbers(&self.json[key]));
        States { time, q, v, a, ..States::default() }
    }

    /// The name of the link that carries a body.
    pub(crate) fn carrier(&self, body: &str) -> String {
        let index = self.json["body_of"][body].as_u64().expect("an index") as usize;
        format!("link_{}", text(&self.json["links"][index]["name"]))
    }

    /// Its own forces, at the times of its motion.
    pub(crate) fn wrenches(&self) -> Vec<MeasuredForce> {
        let wrench = |body: &str| {
            let rows = numbers(&self.json[format!("wrench_{body}")]);
            let contact = |w: &[f64]| Contact {
                force: Vector3::new(w[0], w[1], w[2]),
                moment: Vector3::new(w[3], w[4], w[5]),
                cop: Vector3::zeros(),
            };
            let samples = rows.chunks_exact(6).map(contact).collect();
            let (links, time) = (vec![self.carrier(body)], numbers(&self.json["time"]));
            MeasuredForce { links, ball_and_tip: None, time, samples }
        };
        ["calcn_r", "calcn_l"].map(wrench).to_vec()
    }

    pub(crate) fn gravity(&self) -> Vector3<f64> {
        vector(&self.json["gravity"])
    }
}
