//! Robots and a free humanoid from their models' text, against what Pinocchio and MuJoCo find.

use crate::inverse::{column, data, difference, json, largest, read, solaris, succeeded, table, write};
use serde_json::Value;
use solaris::io::mjcf::{self, forces_from_mujoco, state_from_mujoco};
use solaris::model::Figure;
use std::fs;
use tempfile::TempDir;

/// Of the largest torque.
const TOLERANCE: f64 = 1e-9;
/// Coordinates and speeds of the joint that `--base free` adds.
const FREE: [&[&str]; 2] = [
    &["root.px", "root.py", "root.pz", "root.qx", "root.qy", "root.qz", "root.qw"],
    &["root.vx", "root.vy", "root.vz", "root.wx", "root.wy", "root.wz"],
];

/// A model in a folder of its own, and states of it with their torques.
struct Robot {
    folder: TempDir,
    model: &'static str,
    reference: Value,
}

impl Robot {
    fn read(model: &'static str, reference: &str) -> Option<Self> {
        let [from, reference] = [model, reference].map(|name| data(&format!("robots/{name}")));
        let (from, reference) = (from?, json(&read(&reference?)));
        let folder = tempfile::tempdir().expect("a folder");
        fs::copy(from, folder.path().join(model)).expect("copied");
        Some(Self { folder, model, reference })
    }

    /// The numbers called `key`, sample by sample.
    fn numbers(&self, key: &str) -> Vec<Vec<f64>> {
        let samples = self.reference["samples"].as_array().expect("samples");
        samples.iter().map(|sample| numbers(&sample[key])).collect()
    }

    /// Names of the coordinates and of the speeds, in the reference's order: one-dof joints by their names in the file.
    fn names(&self) -> [Vec<String>; 2] {
        FREE.map(|free| {
            let joints = self.reference["joints"].as_array().expect("joints").iter();
            let names = joints.map(|joint| joint.as_str().expect("a name"));
            names
                .flat_map(|name| if name == "root_joint" { free.to_vec() } else { vec![name] })
                .map(str::to_owned)
                .collect()
        })
    }

    /// Writes states, as rows that have nothing to do with each other.
    fn write_states(&self, time: Option<f64>, [q, v, a]: &[Vec<Vec<f64>>; 3]) {
        let [q_names, v_names] = self.names();
        let heads = [(&q_names, "q"), (&v_names, "v"), (&v_names, "a")];
        let mut heads: Vec<String> = heads
            .iter()
            .flat_map(|(names, ending)| names.iter().map(move |name| format!("{name}.{ending}")))
            .collect();
        let mut rows: Vec<Vec<f64>> =
            (0..q.len()).map(|i| [&q[i][..], &v[i][..], &a[i][..]].concat()).collect();
        if let Some(step) = time {
            heads.insert(0, "time".to_owned());
            rows.iter_mut().enumerate().for_each(|(i, row)| row.insert(0, step * i as f64));
        }
        write(self.folder.path(), "states.csv", &text(&heads, &rows));
    }

    /// The wrench of each state, its moment about the world's origin.
    fn write_wrenches(&self, step: f64) {
        let heads = ["time", "w.fx", "w.fy", "w.fz", "w.mx", "w.my", "w.mz"].map(str::to_owned);
        let wrenches = self.numbers("wrench_world_origin");
        let rows: Vec<_> =
            wrenches.iter().enumerate().map(|(i, w)| [&[step * i as f64], &w[..]].concat()).collect();
        write(self.folder.path(), "wrenches.csv", &text(&heads, &rows));
    }

    /// The torques that `solaris inverse` finds, sample by sample in the reference's order.
    fn torques(&self, options: &str) -> Vec<Vec<f64>> {
        let line = format!("inverse {} states.csv --gravity=0,0,-9.81 {options} -o tau.csv", self.model);
        succeeded(&solaris(self.folder.path(), &line));
        let tau = table(self.folder.path(), "tau.csv");
        let [_, names] = self.names();
        let columns: Vec<_> = names.iter().map(|name| column(&tau, &format!("{name}.tau"))).collect();
        assert_eq!(tau.columns.len(), 1 + names.len(), "time and these: {:?}", tau.columns);
        (0..tau.len()).map(|row| columns.iter().map(|column| column[row]).collect()).collect()
    }

    fn states(&self) -> [Vec<Vec<f64>>; 3] {
        ["q", "v", "a"].map(|key| self.numbers(key))
    }

    /// Compares with Pinocchio: without time, with times of no meaning, and with a wrench on the links `pushed`.
    fn agrees(&self, options: &str, pushed: &[&str]) {
        let [free, loaded] = ["tau", "tau_with_wrench"].map(|key| self.numbers(key));
        assert!(free.len() >= 10);
        self.write_states(None, &self.states());
        agree(&self.torques(options), &free);
        self.write_wrenches(0.37);
        self.write_states(Some(0.37), &self.states());
        agree(&self.torques(options), &free);
        for link in pushed {
            let options = format!("{options} --external wrenches.csv --plate {link}=w");
            agree(&self.torques(&options), &loaded);
        }
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|number| number.as_f64().expect("a number")).collect()
}

/// Comma-separated values that read back equal.
fn text(heads: &[String], rows: &[Vec<f64>]) -> String {
    let line = |row: &Vec<f64>| row.iter().map(ToString::to_string).collect::<Vec<_>>().join(",");
    let lines = std::iter::once(heads.join(",")).chain(rows.iter().map(line));
    lines.map(|line| line + "\n").collect()
}

fn agree(ours: &[Vec<f64>], theirs: &[Vec<f64>]) {
    let (ours, theirs) = (ours.concat(), theirs.concat());
    let (off, scale) = (difference(&ours, &theirs), largest(&theirs));
    assert!(off <= TOLERANCE * scale, "{off:e} of {scale} N m");
}

#[test]
fn ur5() {
    let Some(robot) = Robot::read("ur5_robot.urdf", "ur5_robot_rnea.json") else { return };
    // A body that is fused with another is still known by its name.
    robot.agrees("", &["wrist_3_link", "tool0", "ee_link"]);
}

#[test]
fn panda() {
    let Some(robot) = Robot::read("panda.urdf", "panda_rnea.json") else { return };
    // Its file gives some of its joints dampers, which the reference leaves out.
    robot.agrees("--passive off", &["panda_rightfinger"]);
}

#[test]
fn double_pendulum() {
    let Some(robot) = Robot::read("double_pendulum.urdf", "double_pendulum_rnea.json") else { return };
    robot.agrees("--base fixed --passive off", &["link2"]);
    // Each joint's damper of 0.05 N m s takes its part unless it is left out.
    let mut damped = robot.numbers("tau");
    for (tau, v) in damped.iter_mut().flatten().zip(robot.numbers("v").iter().flatten()) {
        *tau += 0.05 * v;
    }
    agree(&robot.torques(""), &damped);
}

#[test]
fn simple_humanoid() {
    let Some(robot) = Robot::read("simple_humanoid.urdf", "simple_humanoid_ff_rnea.json") else { return };
    // Pinocchio's free joint is ours: quaternion x y z w, velocities along the link's own axes.
    robot.agrees("--base free", &["r_wrist"]);
}

/// MuJoCo's states and forces in our coordinates.
fn from_mujoco(figure: &Figure, robot: &Robot) -> ([Vec<Vec<f64>>; 3], Vec<Vec<f64>>) {
    let [qpos, qvel, qacc, forces] = ["qpos", "qvel", "qacc", "tau"].map(|key| robot.numbers(key));
    let (mut states, mut tau) = ([const { Vec::new() }; 3], Vec::new());
    for i in 0..qpos.len() {
        let (q, v, a) = state_from_mujoco(figure, &qpos[i], &qvel[i], &qacc[i]).expect("a state");
        tau.push(forces_from_mujoco(figure, &q, &forces[i]).expect("forces"));
        for (kind, numbers) in states.iter_mut().zip([q, v, a]) {
            kind.push(numbers);
        }
    }
    (states, tau)
}

#[test]
fn mujoco_humanoid() {
    let Some(mut robot) = Robot::read("mujoco_humanoid.xml", "mujoco_humanoid_inverse.json") else { return };
    let figure = mjcf::read(&read(&robot.folder.path().join(robot.model))).expect("a model").figure;
    let (states, theirs) = from_mujoco(&figure, &robot);
    let bodies = robot.reference["tree"].as_array().expect("a tree");
    let joints = bodies.iter().flat_map(|body| body["joints"].as_array().expect("joints"));
    let name =
        |joint: &Value| if joint["type"] == "free" { "root_joint".into() } else { joint["name"].clone() };
    let joints: Value = joints.map(name).collect();
    robot.reference["joints"] = joints;
    robot.write_states(None, &states);
    let ours = robot.torques("--passive off");
    agree(&ours, &theirs);
    // With armature, dampers and springs they are others.
    let passive = robot.torques("");
    assert!(difference(&passive.concat(), &ours.concat()) > 1.0);
}
