//! The cycles as absolute postures.

use super::angles::ThreeAngles;
use super::arms::ArmCoefficients;
use crate::thesis::determinants::{Cycle, KeyPhase, KeyPosture, LegAngles, Pelvis, PhaseRoot, Root};

/// Both phases of a cycle: what tables 7.1 to 7.3 and 7.6 add up to.
///
/// Each phase turns about the stance leg's flat foot. A lifting foot's toes lie on the ground, as its ball does.
///
/// # Source
///
/// Tables 7.1 to 7.3 and 7.6. They print rotations, and lack some: a hip of the stance leg, without which the pelvis would
/// pitch by 2α each step, and an ankle that puts the landing foot flat. The finishing cycle begins like the intermediate one, as
/// the text says, where the table has χ = 0. See [`table()`](super::table()).
pub fn phases(angles: &ThreeAngles, arms: &ArmCoefficients, cycle: Cycle) -> Vec<KeyPhase> {
    let ends = match cycle {
        Cycle::Starting => [first_lift_off(angles, arms), stride(angles, arms)],
        Cycle::Intermediate => [lift_off(angles, arms), stride(angles, arms)],
        Cycle::Finishing => [lift_off(angles, arms), standing()],
    };
    let root = PhaseRoot { swing: false, point: Root::Sole };
    ends.into_iter().zip(1..).map(|(end, number)| KeyPhase { number, root, end }).collect()
}

/// The posture that a cycle starts from, with the parts that the legs have in it.
pub fn start(angles: &ThreeAngles, arms: &ArmCoefficients, cycle: Cycle) -> KeyPosture {
    match cycle {
        Cycle::Starting => standing(),
        Cycle::Intermediate | Cycle::Finishing => stride(angles, arms).exchanged(),
    }
}

fn standing() -> KeyPosture {
    KeyPosture { name: "standing", ..KeyPosture::default() }
}

/// Both legs straight, both feet flat, stance leg behind.
fn stride(angles: &ThreeAngles, arms: &ArmCoefficients) -> KeyPosture {
    let straight = |pitch| LegAngles { thigh: pitch, shank: pitch, ..LegAngles::default() };
    KeyPosture {
        name: "stride",
        legs: [straight(angles.alpha), straight(-angles.alpha)],
        arms: arms.nine(angles).stride(),
        ..KeyPosture::default()
    }
}

fn first_lift_off(angles: &ThreeAngles, arms: &ArmCoefficients) -> KeyPosture {
    KeyPosture {
        name: "first lift-off",
        legs: [mid_stance(angles), lifting(-angles.theta1, angles.theta3)],
        pelvis: Pelvis { tilt: angles.tilt, rotation: 0.0 },
        arms: arms.nine(angles).first_lift_off(),
        ..KeyPosture::default()
    }
}

fn lift_off(angles: &ThreeAngles, arms: &ArmCoefficients) -> KeyPosture {
    KeyPosture {
        name: "lift-off",
        legs: [mid_stance(angles), lifting(angles.omega, angles.phi)],
        pelvis: Pelvis { tilt: angles.tilt, rotation: 0.0 },
        arms: arms.nine(angles).lift_off(),
        ..KeyPosture::default()
    }
}

/// Hip above the ankle of a flat foot.
fn mid_stance(angles: &ThreeAngles) -> LegAngles {
    LegAngles { thigh: -angles.xi, shank: angles.chi, ..LegAngles::default() }
}

/// Foot at right angles to the shank, on its ball; the toes lie flat.
fn lifting(thigh: f64, shank: f64) -> LegAngles {
    LegAngles { thigh, shank, foot: shank, toes: 0.0 }
}
