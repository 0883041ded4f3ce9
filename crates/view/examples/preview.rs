//! Writes a page to look at: `cargo run --example preview -- page.html`.
//!
//! The walk is a sketch, not a simulation: angles of a stride by a few bumps, a pelvis that is as high as the lower foot
//! asks, forces of the textbook's shape, moments of springs, bands that are made up: none around the arms.

use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_model::{
    Contact, ContactTrack, Figure, Ground, Motion, MotionInfo, SolePart, Trajectory, Vector3, human,
};
use solaris_view::{PageOptions, TableRow, page};
use std::error::Error;

const STRIDE_TIME: f64 = 1.09;
const SPEED: f64 = 1.25;
const STEPS: f64 = 10.0;
/// Share of a stride that a foot is on the ground.
const STANCE: f64 = 0.62;
/// Where each side is in its stride at the start.
const SIDES: [(&str, f64); 2] = [("left", 0.0), ("right", 0.5)];

struct Sketch {
    figure: Figure,
    tree: Tree<f64>,
}

/// A bump of height 1 at `at`, once a stride; `phase` in strides.
fn bump(phase: f64, at: f64, width: f64) -> f64 {
    let away = (phase - at + 0.5).rem_euclid(1.0) - 0.5;
    (-0.5 * (away / width).powi(2)).exp()
}

impl Sketch {
    fn new() -> Result<Self, Box<dyn Error>> {
        let figure = human(1.75, 73.0)?;
        let tree = Tree::new(&figure, Vector3::new(0.0, -9.80665, 0.0))?;
        Ok(Self { figure, tree })
    }

    fn set(&self, q: &mut [f64], angle: &str, degrees: f64) {
        if let Some(angle) = self.figure.anatomical_angle(angle) {
            q[angle.coordinate] = angle.sign * degrees.to_radians();
        }
    }

    /// Height of the lowest point of the soles, and the ball of one foot.
    fn soles(&self, q: &[f64], foot: &str) -> (f64, Vector3<f64>) {
        let mut workspace = Workspace::new(&self.tree);
        let (mut lowest, mut ball) = (f64::INFINITY, Vector3::zeros());
        if forward_kinematics(&self.tree, &mut workspace, q).is_ok() {
            for (i, link) in self.figure.links().iter().enumerate() {
                for point in link.sole() {
                    let at = workspace.pose(i).transform(&point.position);
                    lowest = lowest.min(at.y);
                    if link.name() == foot && point.part == SolePart::Ball {
                        ball = at;
                    }
                }
            }
        }
        (lowest, ball)
    }
}

impl Trajectory for Sketch {
    fn duration(&self) -> f64 {
        STEPS * STRIDE_TIME / 2.0
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        q.fill(0.0);
        for (side, start) in SIDES {
            let phase = t / STRIDE_TIME + start;
            let swing = (std::f64::consts::TAU * phase).cos();
            let mut set = |angle: &str, degrees: f64| self.set(q, &format!("{side}_{angle}"), degrees);
            set("hip.flexion", 9.0 + 21.0 * swing);
            set("knee.flexion", 5.0 + 12.0 * bump(phase, 0.13, 0.06) + 56.0 * bump(phase, 0.73, 0.09));
            let push = bump(phase, 0.63, 0.05);
            set(
                "ankle.dorsiflexion",
                9.0 * bump(phase, 0.44, 0.11) - 6.0 * bump(phase, 0.07, 0.04) - 17.0 * push,
            );
            set("toes.extension", 28.0 * bump(phase, 0.57, 0.05));
            set("shoulder.flexion", 3.0 - 19.0 * swing);
            set("shoulder.abduction", 6.0);
            set("elbow.flexion", 24.0 - 9.0 * swing);
        }
        let turn = (std::f64::consts::TAU * t / STRIDE_TIME).cos();
        self.set(q, "pelvis.rotation", -4.0 * turn);
        self.set(q, "thorax.rotation", -7.0 * turn);
        q[2] = SPEED * t;
        q[1] = -self.soles(q, "").0;
    }
}

/// The force on a foot of `weight` (N) at a `phase` of its stride, or none in swing.
fn force(phase: f64, weight: f64) -> Option<Vector3<f64>> {
    let s = phase.rem_euclid(1.0) / STANCE;
    let arch = (std::f64::consts::PI * s).sin();
    let up = 1.35 * arch.powf(0.6) - 0.55 * bump(s, 0.5, 0.16);
    let along = -0.21 * (std::f64::consts::TAU * s).sin() * arch;
    (s < 1.0).then(|| weight * Vector3::new(0.04 * arch, up, along))
}

/// Half widths of bands around angles and moments of the legs: widest at the hips, wider where a joint turns fast, and none at
/// the left knee early in its stance.
fn bands(figure: &Figure, motion: &Motion) -> (Vec<f64>, Vec<f64>) {
    let mut angles = Vec::new();
    for (sample, &time) in motion.time().iter().enumerate() {
        let unseen = (0.2..0.4).contains(&(time / STRIDE_TIME).fract());
        for (name, speed) in figure.layout().v_names().iter().zip(motion.v(sample)) {
            let (_, joint) = name.split_once('_').unwrap_or_default();
            let least: f64 = match joint.split('.').next() {
                Some("hip") => 6.0,
                Some("knee") if name.starts_with("left") && unseen => 0.0,
                Some("knee" | "ankle") => 3.0,
                _ => 0.0,
            };
            angles.push(least.to_radians() * (1.0 + 0.2 * speed.abs()));
        }
    }
    let moments = angles.iter().map(|angle| 110.0 * angle).collect();
    (angles, moments)
}

fn main() -> Result<(), Box<dyn Error>> {
    let sketch = Sketch::new()?;
    let gravity = Vector3::new(0.0, -9.80665, 0.0);
    let ground = Some(Ground { height: 0.0, friction: Some(0.8) });
    let info = MotionInfo { fingerprint: sketch.figure.fingerprint(), gravity, ground, rate: 120.0 };
    let mut motion = Motion::sample(&sketch.figure, &sketch, info)?;
    let weight = sketch.figure.mass() * gravity.norm();
    for (side, start) in SIDES {
        let link = format!("{side}_foot");
        let inwards = if side == "left" { -1.0 } else { 1.0 };
        let contact = |sample: usize| {
            let phase = motion.time()[sample] / STRIDE_TIME + start;
            let force = force(phase, weight).map(|f| Vector3::new(inwards * f.x, f.y, f.z));
            let (_, ball) = sketch.soles(motion.q(sample), &link);
            let rolled = 0.22 * (1.0 - phase.rem_euclid(1.0) / STANCE);
            let cop = Vector3::new(ball.x, 0.0, ball.z - rolled + 0.03);
            force.map_or_else(Contact::default, |force| Contact { force, moment: cop.cross(&force), cop })
        };
        let samples = (0..motion.len()).map(contact).collect();
        motion.contacts.push(ContactTrack { link, samples });
    }
    let tau =
        (0..motion.len()).flat_map(|sample| motion.q(sample).iter().map(|q| -80.0 * q).collect::<Vec<_>>());
    motion.set_tau(tau.collect())?;
    let (angle_bands, moment_bands) = bands(&sketch.figure, &motion);

    let options = PageOptions {
        title: "A sketch of a walk, 10 steps".to_owned(),
        table: vec![
            TableRow::new("Step length", format!("{:.2}", SPEED * STRIDE_TIME / 2.0), "m", ""),
            TableRow::new("Step frequency", format!("{:.0}", 120.0 / STRIDE_TIME), "steps/min", "as asked"),
            TableRow::new("Speed", format!("{SPEED:.2}"), "m/s", ""),
            TableRow::new("Body mass", format!("{:.1}", sketch.figure.mass()), "kg", "1.75 m tall"),
        ],
        angle_bands: Some(angle_bands),
        moment_bands: Some(moment_bands),
        bands: "two standard errors".to_owned(),
        ..PageOptions::default()
    };
    let path =
        std::env::args().nth(1).ok_or("name the file to write: cargo run --example preview -- page.html")?;
    std::fs::write(path, page(&sketch.figure, &motion, &options)?)?;
    Ok(())
}
