//! Angles that go on from row to row: files cut them at 180°, and turn all three of them over where one passes 90°.

use std::f64::consts::{PI, TAU};

/// Brings the angles (rad) of one joint near to those `before`.
///
/// Whole turns are taken out of each. Three angles about different axes have a second set that is the same rotation,
///
/// ```text
/// R(α, β, γ) = R(α + π, π − β, γ + π)
/// ```
///
/// which is taken where it is nearer.
pub(super) fn go_on(angles: &mut [f64], before: &[f64], may_turn_over: bool) {
    let near = |angle: f64, before: f64| {
        let turns = ((before - angle) / TAU).round();
        // Adding no turn keeps every bit.
        if turns.abs() > 0.0 { angle + turns * TAU } else { angle }
    };
    let way = |angles: &[f64]| -> f64 { angles.iter().zip(before).map(|(a, b)| (a - b).abs()).sum() };
    let mut best: Vec<f64> = angles.iter().zip(before).map(|(a, b)| near(*a, *b)).collect();
    if let (true, &[first, second, third]) = (may_turn_over && way(&best) > PI, &*angles) {
        let over = [first + PI, PI - second, third + PI];
        let over: Vec<f64> = over.iter().zip(before).map(|(a, b)| near(*a, *b)).collect();
        if way(&over) < way(&best) {
            best = over;
        }
    }
    angles.copy_from_slice(&best);
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use solaris_model::{UnitQuaternion, Vector3};

    fn turned(angles: &[f64]) -> UnitQuaternion<f64> {
        [Vector3::z(), Vector3::x(), Vector3::y()]
            .iter()
            .zip(angles)
            .map(|(axis, angle)| UnitQuaternion::from_scaled_axis(axis * *angle))
            .fold(UnitQuaternion::identity(), |turned, turn| turned * turn)
    }

    #[test]
    fn cuts_and_turned_sets_are_undone_and_the_rotation_stays() {
        let before = [3.1, 1.5, -0.4];
        for same in [[3.15 - TAU, 1.52, -0.41], [3.15 + PI, PI - 1.52, -0.41 - PI], [3.15, 1.52, -0.41]] {
            let mut angles = same;
            go_on(&mut angles, &before, true);
            assert_relative_eq!(angles[..], [3.15, 1.52, -0.41][..], epsilon = 1e-12);
            assert!(turned(&angles).angle_to(&turned(&same)) < 1e-7);
        }
    }
}
