//! A ragdoll that gets up: somebody limp falls by physics, lies, is led from there into standing, and walks on under command.
//!
//! Getting up is a blend of postures with a lift off the ground and no more: it is not physics, and nobody rises like that who has to
//! push the ground. All of it is one figure, the limp one, whose ball joints turn the short way from any posture to any other.
//!
//! ```sh
//! cargo run --release -p solaris --example getting_up
//! ```

use solaris::model::{AxisKind, JointKind, Rotation3, UnitQuaternion};
use solaris::modes::{ContactPoint, contact_points};
use solaris::prelude::*;
use std::error::Error;

const RATE: f64 = 60.0;
/// How long somebody falls and lies, gets up, and walks (s).
const LASTS: [f64; 3] = [2.5, 1.5, 4.0];

/// A walker's coordinates as those of its limp twin: the same rotations in other joints.
fn as_limp(walker: &Figure, limp: &Figure, q: &[f64], out: &mut [f64]) {
    for (i, (own, at)) in limp.links().iter().zip(limp.layout().joints()).enumerate() {
        let (joint, from) = (walker.links()[i].joint(), walker.layout().joints()[i]);
        let q = &q[from.q..from.q + from.nq];
        let (mut place, mut turn) = (Vector3::zeros(), Rotation3::identity());
        for (dof, x) in joint.kind().axes().iter().zip(q) {
            match dof.axis.kind {
                AxisKind::Translation => place += dof.axis.direction * *x,
                AxisKind::Rotation => turn *= Rotation3::new(dof.axis.direction * *x),
            }
        }
        let out = &mut out[at.q..at.q + at.nq];
        let quaternion = UnitQuaternion::from_rotation_matrix(&turn);
        match own.joint().kind() {
            JointKind::Free { .. } => {
                out[..3].copy_from_slice(place.as_slice());
                out[3..].copy_from_slice(quaternion.coords.as_slice());
            }
            JointKind::Ball { .. } => out.copy_from_slice(quaternion.coords.as_slice()),
            kind if kind.axes().iter().zip(joint.kind().axes()).all(|(own, of)| own.axis == of.axis) => {
                out.copy_from_slice(q);
            }
            // The elbows: R = Rx(a)·Rz(b)·Ry(c).
            _ => {
                let r = turn.matrix();
                let (b, a) = ((-r[(0, 1)]).asin(), r[(2, 1)].atan2(r[(1, 1)]));
                out.copy_from_slice(&[a, b, r[(0, 2)].atan2(r[(0, 0)])]);
            }
        }
    }
}

/// The height (m) of the lowest point that can touch the ground.
fn lowest(tree: &Tree<f64>, workspace: &mut Workspace<f64>, touches: &[ContactPoint], q: &[f64]) -> f64 {
    if forward_kinematics(tree, workspace, q).is_err() {
        return f64::NAN;
    }
    let height = |touch: &ContactPoint| workspace.pose(touch.link).transform(&touch.center).y - touch.radius;
    touches.iter().map(height).fold(f64::INFINITY, f64::min)
}

/// Somebody falls over backward: the frames, each with all coordinates.
fn fall(limp: &Figure, stands: &[f64], touches: &[ContactPoint]) -> Result<Vec<Vec<f64>>, Box<dyn Error>> {
    let mut simulation = Simulation::new(limp, Vector3::y() * -9.80665);
    let mut v = vec![0.0; limp.layout().nv()];
    v[2] = -1.0;
    simulation.set_start(stands, &v)?;
    let plane = GroundPlane::under(limp, simulation.gravity(), 0.8)?;
    simulation.set_ground(GroundPlane { law: ContactLaw::Rigid, ..plane }, touches.to_vec())?;
    let method = Method::Impulses { step: 1.0 / 480.0 };
    let settings = Settings { method, forces: false, estimate: false, ..Settings::new(LASTS[0], RATE) };
    let motion = simulation.run(&settings)?.motion;
    Ok((0..motion.len()).map(|frame| motion.q(frame).to_vec()).collect())
}

#[allow(clippy::print_stdout, reason = "what a game would draw")]
pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let who = Human::new(1.65, 58.0);
    let (limp, walking) = (who.clone().limp().build()?, who.root(RootOrder::Yzx).build()?);
    let touches = contact_points(&limp);
    let tree = Tree::new(&limp, Vector3::zeros())?;
    let mut workspace = Workspace::new(&tree);
    let mut walker = Walker::new(&walking)?;
    let mut stands = vec![0.0; limp.layout().nq()];
    as_limp(&walking, &limp, walker.step(1.0 / RATE, &Command::stop())?, &mut stands);

    // The walker waits where the pelvis comes to lie, so that all of the fall is moved there.
    let mut frames = fall(&limp, &stands, &touches)?;
    let lies = frames.last().ok_or("no frames")?.clone();
    for q in &mut frames {
        (q[0], q[2]) = (q[0] - lies[0] + stands[0], q[2] - lies[2] + stands[2]);
    }
    let (fallen, lies) = (frames.len(), frames[frames.len() - 1].clone());
    for frame in 1..=(LASTS[1] * RATE) as usize {
        let t = frame as f64 / (LASTS[1] * RATE);
        let share = t * t * t * (10.0 + t * (6.0 * t - 15.0));
        let mut q = vec![0.0; lies.len()];
        limp.interpolate(&lies, &stands, share, &mut q)?;
        // What would be in the ground is lifted out.
        q[1] -= lowest(&tree, &mut workspace, &touches, &q).min(0.0);
        frames.push(q);
    }
    let risen = frames.len();
    for _ in 0..(LASTS[2] * RATE) as usize {
        let mut q = vec![0.0; lies.len()];
        as_limp(&walking, &limp, walker.step(1.0 / RATE, &Command::velocity(0.0, 1.1))?, &mut q);
        frames.push(q);
    }

    println!("time,pelvis_height,pelvis_z,lowest");
    let mut before: Option<&[f64]> = None;
    for (frame, q) in frames.iter().enumerate() {
        // … here a game gives `q` to its skeleton.
        let low = lowest(&tree, &mut workspace, &touches, q);
        if frame % 15 == 0 {
            println!("{:.2},{:.3},{:.3},{:.4}", frame as f64 / RATE, q[1], q[2], low);
        }
        assert!(low > if frame < fallen { -0.02 } else { -1e-3 }, "frame {frame}: {low} m");
        let jump = before.map_or(Ok(0.0), |before| limp.distance(before, q))?;
        assert!(jump < 1.0, "frame {frame} jumps by {jump}");
        before = Some(q);
    }
    let heights = [fallen - 1, risen - 1].map(|frame| frames[frame][1]);
    let walked = frames[frames.len() - 1][2] - stands[2];
    assert!(
        heights[0] < 0.35 && (heights[1] - stands[1]).abs() < 1e-3 && walked > 3.0,
        "{heights:?} {walked}"
    );
    Ok(())
}
