//! The others' side: MuJoCo and Drake, each in a Python of its own.

use super::scenes::{Scene, Told};
use crate::mjcf;
use crate::workspace::root;
use serde_json::{Map, Value, json};
use solaris_model::{Figure, JointKind, Vector3};
use solaris_modes::Simulation;
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::PathBuf;
use std::process::{Child, ChildStdout, Command, Stdio};

/// What runs Python where the environment does not say.
const PYTHON: &str = "python3";

/// An engine that is at hand.
pub(super) struct Peer {
    child: Child,
    said: BufReader<ChildStdout>,
    /// Its name and version.
    pub(super) version: String,
}

/// What a run is asked for.
pub(super) struct Ask<'a> {
    /// `shipped` or `hard` of MuJoCo; an approximation of contact by its name in Drake.
    pub(super) setting: &'a str,
    /// Of time (s).
    pub(super) step: f64,
    pub(super) duration: f64,
    /// After the first.
    pub(super) frames: usize,
    pub(super) settle: Option<Vector3<f64>>,
    pub(super) forces: &'a [(String, f64)],
    /// Of a spring without a damper (N/m), or 0.
    pub(super) elastic: f64,
    pub(super) links: &'a [usize],
    /// Whether one run is enough for its time.
    pub(super) once: bool,
}

/// A run: the seconds that it took, its places and turns (w, x, y, z) by frame and link, and its energies by frame.
pub(super) struct Answer {
    pub(super) seconds: f64,
    pub(super) poses: Vec<Vec<[f64; 7]>>,
    pub(super) energy: Vec<[f64; 2]>,
}

impl Peer {
    /// Begins to talk to one; nothing where there is no package for it, which is said.
    pub(super) fn find(engine: &str) -> Result<Option<Self>, String> {
        let python = PathBuf::from(std::env::var_os("PYTHON").unwrap_or_else(|| PYTHON.into()));
        let skipped = || {
            eprintln!(
                "contacts: {engine} is skipped: {} has no such package (PYTHON names another)",
                python.display()
            );
            Ok(None)
        };
        let mut command = Command::new(&python);
        command.arg(root().join("lab/peers/contacts.py")).arg(engine);
        let Ok(mut child) =
            command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null()).spawn()
        else {
            return skipped();
        };
        let Some(said) = child.stdout.take() else { return skipped() };
        let mut peer = Self { child, said: BufReader::new(said), version: String::new() };
        match peer.hear() {
            Ok(first) => {
                first["version"].as_str().unwrap_or(engine).clone_into(&mut peer.version);
                Ok(Some(peer))
            }
            Err(_) => skipped(),
        }
    }

    fn hear(&mut self) -> Result<Value, String> {
        let mut line = String::new();
        self.said.read_line(&mut line).map_err(|error| error.to_string())?;
        serde_json::from_str(&line).map_err(|_| "it says nothing any more".to_owned())
    }

    /// Runs a scene.
    pub(super) fn told(
        &mut self,
        scene: &Scene,
        setting: &str,
        step: f64,
        frames: usize,
    ) -> Result<Told, String> {
        let ask = Ask {
            setting,
            step,
            duration: scene.duration,
            frames,
            settle: scene.settle,
            forces: &scene.forces,
            elastic: scene.elastic,
            links: &scene.watched,
            once: false,
        };
        let Answer { seconds, poses, energy } = self.ask(&scene.rigid, &ask)?;
        let place = |pose: &[f64; 7]| Vector3::new(pose[0], pose[1], pose[2]);
        let places = poses.iter().map(|links| links.iter().map(place).collect()).collect();
        Ok(Told { seconds, places, energy })
    }

    /// Runs a simulation, or says why not.
    pub(super) fn ask(&mut self, simulation: &Simulation, ask: &Ask) -> Result<Answer, String> {
        let figure = simulation.figure();
        let folder = root().join("target/lab/contacts");
        let path = folder.join(format!("{}.xml", figure.name().replace(' ', "_")));
        let written = fs::create_dir_all(&folder).and_then(|()| fs::write(&path, mjcf::text(simulation)));
        written.map_err(|error| format!("{}: {error}", path.display()))?;
        let names: Vec<&str> = ask.links.iter().map(|link| figure.links()[*link].name()).collect();
        let forces: Map<String, Value> =
            ask.forces.iter().map(|(dof, force)| (dof.clone(), json!(force))).collect();
        let text = json!({
            "setting": ask.setting, "step": ask.step, "model": path, "duration": ask.duration, "frames": ask.frames,
            "gravity": simulation.gravity().as_slice(), "settle": ask.settle.map(|gravity| gravity.as_slice().to_vec()),
            "start": start(figure, simulation.state().0), "velocity": velocity(figure, simulation.state()),
            "forces": forces, "elastic": ask.elastic, "collides": simulation.collisions().is_some(),
            "links": names, "once": ask.once,
        });
        let stdin = self.child.stdin.as_mut().ok_or("it does not listen")?;
        writeln!(stdin, "{text}").and_then(|()| stdin.flush()).map_err(|error| error.to_string())?;
        let said = self.hear()?;
        if let Some(error) = said["error"].as_str() {
            return Err(error.to_owned());
        }
        let of = |name: &str| said[name].clone();
        let faulty = |error: serde_json::Error| error.to_string();
        Ok(Answer {
            seconds: serde_json::from_value(of("seconds")).map_err(faulty)?,
            poses: serde_json::from_value(of("poses")).map_err(faulty)?,
            energy: serde_json::from_value(of("energy")).map_err(faulty)?,
        })
    }
}

impl Drop for Peer {
    fn drop(&mut self) {
        // It ends with its input.
        drop(self.child.stdin.take());
        let _ = self.child.wait();
    }
}

/// Where each joint begins; quaternions with `w` first.
fn start(figure: &Figure, q: &[f64]) -> Value {
    let (mut free, mut ball, mut dofs) = (Map::new(), Map::new(), Map::new());
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        let q = &q[at.q..at.q + at.nq];
        match link.joint().kind() {
            JointKind::Free { .. } => {
                free.insert(link.name().to_owned(), json!([q[0], q[1], q[2], q[6], q[3], q[4], q[5]]));
            }
            JointKind::Ball { .. } => {
                ball.insert(link.joint().name().to_owned(), json!([q[3], q[0], q[1], q[2]]));
            }
            _ => {
                let names = &figure.layout().v_names()[at.v..at.v + at.nv];
                dofs.extend(names.iter().cloned().zip(q.iter().map(|x| json!(x))));
            }
        }
    }
    json!({"free": free, "ball": ball, "dof": dofs})
}

/// How what flies begins: its turning, then its moving, both in the world, for it stands as the world does.
fn velocity(figure: &Figure, (_, v): (&[f64], &[f64])) -> Value {
    let flying = figure.links().iter().zip(figure.layout().joints());
    let flying = flying.filter(|(link, _)| matches!(link.joint().kind(), JointKind::Free { .. }));
    let moving = flying.map(|(link, at)| (link, &v[at.v..at.v + at.nv]));
    let moving = moving.filter(|(_, v)| v.iter().any(|x| x.abs() > 0.0));
    let all = moving.map(|(link, v)| (link.name().to_owned(), json!([v[3], v[4], v[5], v[0], v[1], v[2]])));
    Value::Object(all.collect())
}
