//! The closed forms of the leg, with bare numbers: the thesis's legs, whose ankles stand on the ground, and a person's.

use approx::assert_relative_eq;
use solaris_gait::LegGeometry;
use solaris_model::{Vector3, human};

/// Thigh .245 H, shank .246 H, foot .085 H, toe .035 H, for 1.75 m; the ankle is a point on the ground.
fn thesis() -> LegGeometry {
    LegGeometry {
        thigh: 0.245 * 1.75,
        shank: 0.246 * 1.75,
        thigh_lean: 0.0,
        shank_lean: 0.0,
        ankle_height: 0.0,
        heel_behind: 0.0,
        ball_ahead: 0.085 * 1.75,
        ball_below: 0.0,
        ball_height: 0.0,
        toe: 0.035 * 1.75,
        hip: Vector3::new(0.1, 0.0, 0.0),
    }
}

fn person() -> LegGeometry {
    LegGeometry::of(&human(1.75, 73.0).expect("a person")).expect("legs")
}

#[test]
fn the_knee_and_the_reach_are_inverse() {
    for leg in [thesis(), person()] {
        for degrees in [0.5_f64, 4.0, 20.0, 65.0, 140.0] {
            let knee = degrees.to_radians() + leg.thigh_lean - leg.shank_lean;
            assert_relative_eq!(leg.knee_for(leg.reach_squared(knee)), knee, epsilon = 1e-12);
        }
        // Out of reach, the leg is straight; on itself, folded.
        let straight = leg.thigh_lean - leg.shank_lean;
        assert_relative_eq!(leg.knee_for(4.0), straight, epsilon = 1e-12);
        assert_relative_eq!(leg.knee_for(0.0), straight + std::f64::consts::PI, epsilon = 1e-12);
    }
    // A right angle at the knee: ℓ² = L1² + L2².
    let leg = thesis();
    let right_angle = leg.reach_squared(std::f64::consts::FRAC_PI_2);
    assert_relative_eq!(right_angle, leg.thigh.powi(2) + leg.shank.powi(2), epsilon = 1e-15);
}

/// Puts the hip where a leg of a chosen pitch and knee has it, and asks the closed form for the pitch.
#[test]
fn pitch_about_the_heel_is_recovered() {
    let leg = person();
    for (pitch, knee, lean) in
        [(-17.0_f64, 7.0_f64, 15.0_f64), (-8.0, 15.0, 8.0), (0.0, 20.0, 3.0), (-25.0, 5.0, 25.0)]
    {
        let (sin, cos) = pitch.to_radians().sin_cos();
        let ankle =
            [leg.ankle_height * cos - leg.heel_behind * sin, leg.heel_behind * cos + leg.ankle_height * sin];
        // The leg leans back: the hip is behind the ankle.
        let reach = leg.reach_squared(knee.to_radians()).sqrt();
        let (back, up) = lean.to_radians().sin_cos();
        let hip = [0.0, ankle[0] + reach * up, ankle[1] - reach * back];
        let found = leg.pitch_about_heel(hip, knee.to_radians()).to_degrees();
        assert_relative_eq!(found, pitch, epsilon = 1e-9);
    }
}

#[test]
fn pitch_about_the_ball_is_recovered() {
    for leg in [thesis(), person()] {
        for (pitch, knee, lean, side) in
            [(5.0_f64, 10.0_f64, 12.0_f64, 0.0_f64), (30.0, 25.0, 25.0, 0.05), (60.0, 40.0, 30.0, 0.1)]
        {
            let angle = pitch.to_radians() + leg.ball_below.atan2(leg.ball_ahead);
            let r = leg.ball_ahead.hypot(leg.ball_below);
            let ankle = [r * angle.sin(), -r * angle.cos()];
            // The leg leans forward, and to the side by `side` metres.
            let reach = (leg.reach_squared(knee.to_radians()) - side * side).sqrt();
            let (ahead, up) = lean.to_radians().sin_cos();
            let hip = [side, ankle[0] + reach * up, ankle[1] + reach * ahead];
            let found = leg.pitch_about_ball(hip, knee.to_radians()).to_degrees();
            assert_relative_eq!(found, pitch, epsilon = 1e-9);
        }
    }
}

/// The thesis's symmetric double support has a closed form of its own: with straight legs of length a and pitch β about the
/// ball, `a cos α = a cos β + L3 sin β` keeps the hips level.
#[test]
fn a_straight_leg_on_the_ball_stands_as_the_thesis_says() {
    let leg = thesis();
    let (a, beta) = (leg.thigh + leg.shank, 0.4_f64);
    // Hip over the ball joint: ankle at L3 (−cos β, sin β), the leg at the angle β from the vertical.
    let hip =
        [0.0, leg.ball_ahead * beta.sin() + a * beta.cos(), -leg.ball_ahead * beta.cos() + a * beta.sin()];
    assert_relative_eq!(leg.pitch_about_ball(hip, 0.0), beta, epsilon = 1e-7);
}

#[test]
fn a_persons_leg_has_the_golden_measures() {
    let leg = person();
    assert_relative_eq!(leg.length(), 0.938_8, epsilon = 1e-3);
    assert_relative_eq!(leg.foot_length(), 0.26 * 1.75 / 1.741, epsilon = 1e-12);
    assert_relative_eq!(leg.ankle_height, 0.078 * 1.75 / 1.741, epsilon = 1e-12);
}
