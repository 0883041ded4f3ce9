//! Errors of a motion against the answer.

use super::Solution;
use solaris_model::{Figure, Motion};

/// How far a run was off, at the worst frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Accuracy {
    /// Positions (rad or m); turns of ball and free joints as their angle.
    pub position: f64,
    /// Velocities (rad/s or m/s). A frame between the two instants at which two runs have the same impact differs by the
    /// whole jump.
    pub velocity: f64,
    /// The energy that came from nowhere or went, over the energy at play.
    pub energy: f64,
    /// What momentum did besides what gravity does to it; where nothing else acts from outside.
    pub momentum: Option<super::MomentumDrift>,
    /// What the run itself said that positions may be off by, where it was asked.
    pub estimate: Option<f64>,
}

/// What is compared with.
pub(super) enum Answer<'a> {
    Motion(&'a Motion),
    Solution(Solution<'a>),
}

/// The greatest differences of positions and of velocities over the frames up to `until` (s); frames that only one of the
/// two has are passed over.
pub(super) fn compare(figure: &Figure, motion: &Motion, answer: &Answer<'_>, until: f64) -> (f64, f64) {
    let mut worst = (0.0_f64, 0.0_f64);
    each(figure, motion, answer, |time, position, velocity| {
        if time <= until {
            worst = (worse(worst.0, position), worse(worst.1, velocity));
        }
    });
    worst
}

/// Calls `with` with the time and the differences of each common frame.
pub(super) fn each(
    figure: &Figure,
    motion: &Motion,
    answer: &Answer<'_>,
    mut with: impl FnMut(f64, f64, f64),
) {
    let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
    let (mut q, mut v, mut difference) = (vec![0.0; nq], vec![0.0; nv], vec![0.0; nv]);
    let mut other = 0;
    for sample in 0..motion.len() {
        let time = motion.time()[sample];
        match answer {
            Answer::Solution(solution) => solution(time, &mut q, &mut v),
            Answer::Motion(answer) => {
                let near = 1e-9 * (1.0 + time.abs());
                while other < answer.len() && answer.time()[other] < time - near {
                    other += 1;
                }
                if other == answer.len() || answer.time()[other] > time + near {
                    continue;
                }
                q.copy_from_slice(answer.q(other));
                v.copy_from_slice(answer.v(other));
            }
        }
        // Lengths are right and motions hold unit quaternions: what is refused all the same is beyond comparing.
        let position = match figure.difference(&q, motion.q(sample), &mut difference) {
            Ok(()) => difference.iter().fold(0.0, |worst, x| worse(worst, *x)),
            Err(_) => f64::INFINITY,
        };
        let velocity = v.iter().zip(motion.v(sample)).fold(0.0, |worst, (a, b)| worse(worst, a - b));
        with(time, position, velocity);
    }
}

/// The greater magnitude; infinity for what is no number, which `max` would drop.
fn worse(worst: f64, x: f64) -> f64 {
    if x.is_nan() { f64::INFINITY } else { worst.max(x.abs()) }
}
