//! Motions of a person whose feet are told to stand, whatever they do.

use crate::states::{States, ground_forces};
use solaris_analysis::ground::{GroundForces, GroundOptions, Split, Stance, Stances, soles};
use solaris_model::{Figure, Vector3, human};

pub(crate) const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);

pub(crate) fn person() -> Figure {
    human(1.75, 73.0).expect("a person")
}

/// A hundred frames a second of swaying.
pub(crate) fn swaying(figure: &Figure, frames: usize, amplitude: f64) -> States {
    swaying_at(figure, frames, 100.0, amplitude)
}

/// Every coordinate swings about its middle with this amplitude (rad, and a tenth of it in m), each at its own pace.
pub(crate) fn swaying_at(figure: &Figure, frames: usize, rate: f64, amplitude: f64) -> States {
    let (nq, rows) = (figure.layout().nq(), 0..frames);
    assert_eq!(nq, figure.layout().nv());
    let mut out = States { time: rows.map(|i| i as f64 / rate).collect(), ..States::default() };
    for &t in &out.time {
        for dof in 0..nq {
            let pace = 3.0 + 0.37 * dof as f64;
            let size = if dof < 3 { 0.1 * amplitude } else { amplitude };
            let angle = pace * t + dof as f64;
            out.q.push(size * angle.sin() + if dof == 1 { 0.9 } else { 0.0 });
            out.v.push(size * pace * angle.cos());
            out.a.push(-size * pace * pace * angle.sin());
        }
    }
    out
}

/// Left, both, right, both, left, over a second.
pub(crate) fn steps() -> Stances {
    let stance = |foot, start, end| Stance { foot, start, end };
    let list = vec![stance(0, -1.0, 0.35), stance(0, 0.65, 2.0), stance(1, 0.2, 0.8)];
    Stances { list, belt: Vector3::zeros(), level: 0.0, footings: Vec::new(), method: "told" }
}

pub(crate) fn ground(figure: &Figure, states: &States, split: Split, stances: Stances) -> GroundForces {
    let options = GroundOptions { split, stances: Some(stances), ..GroundOptions::default() };
    ground_forces(figure, GRAVITY, states, &soles(figure), &options).expect("forces")
}
