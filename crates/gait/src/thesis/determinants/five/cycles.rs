//! Key postures of the starting, intermediate and finishing cycle.

use super::super::cycle::{Cycle, KeyPhase, PhaseRoot};
use super::super::posture::{KeyPosture, LegAngles, Pelvis, Root};
use super::arms::ArmCoefficients;
use super::closed::FiveAngles;
use super::trunk::TrunkAmplitudes;

/// What arms and trunk do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Upper {
    /// The arms.
    pub arms: ArmCoefficients,
    /// The trunk.
    pub trunk: TrunkAmplitudes,
}

impl Upper {
    /// Arms by [`ArmCoefficients::nearest`] and the trunk by [`TrunkAmplitudes::at_speed`] (m/s).
    pub fn automatic(angles: &FiveAngles, speed: f64) -> Self {
        Self { arms: ArmCoefficients::nearest(angles), trunk: TrunkAmplitudes::at_speed(speed) }
    }
}

/// Parts of δ at the ends of phases 0 to 4.
const TILT: [f64; 5] = [0.0, 1.0, 0.4, 0.0, 0.0];
/// Parts of τ: the leading hip is ahead as its heel strikes.
const ROTATION: [f64; 5] = [1.0, 0.6, 0.0, -0.6, -1.0];

/// A leg whose foot is at a right angle to its shank, the toes straight with it.
fn rigid(thigh: f64, shank: f64) -> LegAngles {
    LegAngles { thigh, shank, foot: shank, toes: shank }
}

/// The posture at the end of a phase, 1 to 4.
fn posture(angles: &FiveAngles, upper: &Upper, phase: usize) -> KeyPosture {
    let q = &angles.parameters;
    let (theta, kappa) = (q.heel_strike_angle, q.thigh_swing);
    let flat = |thigh: f64, shank: f64| LegAngles { thigh, shank, foot: 0.0, toes: 0.0 };
    // On its ball: the toes stay flat.
    let on_ball = |pitch: f64| LegAngles { toes: 0.0, ..rigid(pitch, pitch) };
    let (name, legs) = match phase {
        1 => ("heel strike", [rigid(-angles.alpha, -angles.alpha), on_ball(angles.beta)]),
        2 => ("lift-off", [flat(-angles.xi, 0.0), rigid(q.thigh_lift_off, angles.omega)]),
        3 => ("passing", [flat(-angles.mu, angles.psi), rigid(-kappa, angles.epsilon)]),
        _ => ("stretch", [on_ball(theta), flat(-angles.chi, 0.0)]),
    };
    KeyPosture {
        name,
        legs,
        pelvis: Pelvis { tilt: TILT[phase] * q.tilt, rotation: ROTATION[phase] * q.rotation },
        arms: upper.arms.at(angles, phase),
        trunk: upper.trunk.at(phase),
    }
}

/// The posture that a cycle's first phase starts from, in that cycle's parts of the legs: standing, or the end of phase 4 with
/// the parts exchanged.
pub fn posture_before(angles: &FiveAngles, upper: &Upper, cycle: Cycle) -> KeyPosture {
    match cycle {
        Cycle::Starting => KeyPosture { name: "rest", ..KeyPosture::default() },
        Cycle::Intermediate | Cycle::Finishing => posture(angles, upper, 4).exchanged(),
    }
}

/// The phases of a cycle.
///
/// | phase | ends in | root |
/// |---|---|---|
/// | 1 | heel strike | ball of the swing leg's foot: the rear one |
/// | 2 | lift-off | heel of the stance leg's foot, which comes flat |
/// | 3 | passing, or rest | flat foot of the stance leg |
/// | 4 | stretch | ball of the stance leg's foot |
///
/// The intermediate cycle has all four, the starting cycle 3 and 4, the finishing cycle 1, 2 and 3, that to rest. The pelvis
/// tilts by δ, 2δ/5, 0, 0 and turns by 3τ/5, 0, −3τ/5, −τ, from τ before.
///
/// # Source
///
/// Vasilonikolidakis (1991), tables 8.1–8.3 and 8.6–8.7, corrected ([`super::table`]). Theirs are differences of joint angles;
/// these are pitches at the ends of phases.
pub fn phases(angles: &FiveAngles, upper: &Upper, cycle: Cycle) -> Vec<KeyPhase> {
    let root = |number: usize| match number {
        1 => PhaseRoot { swing: true, point: Root::Ball },
        2 => PhaseRoot { swing: false, point: Root::Heel },
        3 => PhaseRoot { swing: false, point: Root::Sole },
        _ => PhaseRoot { swing: false, point: Root::Ball },
    };
    let phase = |number: usize| KeyPhase { number, root: root(number), end: posture(angles, upper, number) };
    match cycle {
        Cycle::Starting => vec![phase(3), phase(4)],
        Cycle::Intermediate => (1..=4).map(phase).collect(),
        Cycle::Finishing => {
            let rest = KeyPosture { name: "rest", ..KeyPosture::default() };
            vec![phase(1), phase(2), KeyPhase { number: 3, root: root(3), end: rest }]
        }
    }
}
