//! Simple mode: one dynamic analysis of a target, then a motion in closed form.

mod analysis;
mod curve;

pub(crate) use analysis::analyse;

use super::path::{Path, last_within};
use super::{Course, Target};
use crate::report::OutcomeKind;
use curve::{BangBang, Harmonic};
use solaris_profiles::{Curve, ProfileError, acceleration, displacement};
use std::f64::consts::{PI, TAU};

/// The magnitude (rad/s² or m/s²) below which an acceleration is none: with it a degree of freedom needs more than twenty
/// minutes for a radian. What rounding makes of an axis along which nothing acts is far smaller.
pub(crate) const STILL: f64 = 1e-6;

/// The magnitude (rad/s or m/s) below which a degree of freedom is at rest.
pub(crate) const REST: f64 = 1e-9;

/// How a simple drive begins.
#[derive(Clone)]
pub(crate) enum Begun {
    /// On a path that ends at a time of the run (s).
    Along { path: Path, end: f64 },
    /// Not at all, because of this.
    Not(OutcomeKind),
}

/// The motion of one degree of freedom that is now (s) at `position` (rad or m) with a `velocity`, and has been given an
/// `acceleration` by the analysis.
pub(crate) fn begin(
    course: Course,
    target: Target,
    position: f64,
    velocity: f64,
    acceleration: f64,
    now: f64,
) -> Begun {
    let way = target.position - position;
    let start = Start { position, velocity, now };
    let there = way.abs() <= 4.0 * f64::EPSILON * position.abs().max(target.position.abs());
    let begun = match course {
        Course::TimeOriented { duration } => {
            acceleration::Constant::reaching(duration, (position, velocity), target.position)
                .and_then(|curve| start.along(curve, Vec::new()))
        }
        _ if there => return Begun::Not(arrived(velocity, &target)),
        Course::TargetAngle => match hit(way, velocity, acceleration) {
            Ok(time) => acceleration::Constant::new(time, (position, velocity), acceleration)
                .and_then(|curve| start.along(curve, Vec::new())),
            Err(outcome) => return Begun::Not(outcome),
        },
        _ if velocity.abs() > REST => return Begun::Not(OutcomeKind::NeedsRest),
        _ if acceleration.abs() < STILL => return Begun::Not(OutcomeKind::NoMotion),
        Course::BangBang => {
            let time = 2.0 * (way / acceleration).abs().sqrt();
            BangBang::new(time, position, target.position)
                .and_then(|curve| start.along(curve, vec![0.5 * time]))
        }
        Course::HalfCosine => {
            let time = PI * (0.5 * way / acceleration).abs().sqrt();
            displacement::Trigonometric::new(time, position, target.position)
                .and_then(|curve| start.along(curve, Vec::new()))
        }
        Course::FullSine => {
            let time = (TAU * way / acceleration).abs().sqrt();
            Harmonic::new(time, position, target.position).and_then(|curve| start.along(curve, Vec::new()))
        }
    };
    // What a curve refuses are numbers that overflow: such an acceleration leads nowhere.
    begun.unwrap_or(Begun::Not(OutcomeKind::NoMotion))
}

/// Where a motion begins.
struct Start {
    position: f64,
    velocity: f64,
    now: f64,
}

impl Start {
    fn along(
        &self,
        curve: impl Curve + Send + Sync + 'static,
        inner: Vec<f64>,
    ) -> Result<Begun, ProfileError> {
        let end = last_within(self.now, curve.span());
        debug_assert!((curve.at(0.0).position - self.position).abs() <= 0.0);
        debug_assert!((curve.at(0.0).velocity - self.velocity).abs() <= REST);
        Ok(Begun::Along { path: Path::pieces(curve, self.now, inner)?, end })
    }
}

/// What is to be said of a drive that begins where it is to end.
fn arrived(velocity: f64, target: &Target) -> OutcomeKind {
    if (velocity - target.velocity).abs() <= REST {
        OutcomeKind::Reached
    } else {
        OutcomeKind::ReachedWithVelocity
    }
}

/// The smallest positive root of `α·t²/2 + V₀·t − δ = 0`, for `δ ≠ 0`.
///
/// ```text
/// V ≥ 0    t = 2d/(V + √(V² + 2A·d))
/// V < 0    t = (−V + √(V² + 2A·d))/A            d = |δ|, V and A towards the target
/// ```
///
/// Neither has a difference of numbers that may be nearly equal.
fn hit(way: f64, velocity: f64, acceleration: f64) -> Result<f64, OutcomeKind> {
    let (d, v, a) = (way.abs(), velocity * way.signum(), acceleration * way.signum());
    if acceleration.abs() < STILL && v <= REST {
        return Err(OutcomeKind::NoMotion);
    }
    if a < 0.0 && v <= REST {
        return Err(OutcomeKind::WrongSign);
    }
    let square = v * v + 2.0 * a * d;
    // A motion that turns round just there is one that arrives.
    if square < -4.0 * f64::EPSILON * v * v {
        return Err(OutcomeKind::Unreachable);
    }
    let root = square.max(0.0).sqrt();
    let time = if v >= 0.0 { 2.0 * d / (v + root) } else { (root - v) / a };
    if time.is_finite() && time > 0.0 { Ok(time) } else { Err(OutcomeKind::NoMotion) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;
    use solaris_profiles::Sample;

    /// From a position with a velocity to a target; the beginning, the end, and the duration.
    fn course(
        course: Course,
        (x, v): (f64, f64),
        to: f64,
        a: f64,
    ) -> Result<(Sample, Sample, f64), OutcomeKind> {
        match begin(course, Target::at(to), x, v, a, 0.1) {
            Begun::Along { path, end } => Ok((path.at(0.1), path.at(end), end - 0.1)),
            Begun::Not(outcome) => Err(outcome),
        }
    }

    #[test]
    fn each_course_takes_its_time_and_arrives() {
        let table = [
            (Course::TargetAngle, 1.0, 2.0),
            (Course::TimeOriented { duration: 0.7 }, 0.7, 2.0 / 0.7),
            (Course::BangBang, 2.0_f64.sqrt(), 0.0),
            (Course::HalfCosine, PI / 2.0, 0.0),
            (Course::FullSine, PI.sqrt(), 0.0),
        ];
        for (kind, time, velocity) in table {
            for way in [1.0, -1.0] {
                let (start, end, duration) =
                    course(kind, (0.25, 0.0), 0.25 + way, 2.0 * way).expect("goes there");
                assert_abs_diff_eq!(duration, time, epsilon = 1e-15);
                assert_abs_diff_eq!(start.position, 0.25, epsilon = 1e-16);
                assert_abs_diff_eq!(end.position, 0.25 + way, epsilon = 1e-15);
                assert_abs_diff_eq!(end.velocity, velocity * way, epsilon = 1e-14);
            }
        }
    }

    #[test]
    fn the_accelerations_begin_as_their_formulas_say() {
        // A = 2, δ = 1: A, A·(1 − 2φ) with φ = 0, and A·sin 0. The printed law of the second never starts.
        for (kind, expected) in [(Course::BangBang, 2.0), (Course::HalfCosine, 2.0), (Course::FullSine, 0.0)]
        {
            let (start, end, _) = course(kind, (0.0, 0.0), 1.0, -2.0).expect("the sign does not matter");
            assert_abs_diff_eq!(start.acceleration, expected, epsilon = 1e-14);
            assert_abs_diff_eq!(end.acceleration, -expected, epsilon = 1e-13);
        }
    }

    #[test]
    fn a_target_angle_is_met_the_first_time() {
        // Towards the target and back: θ = 3t − t², 2 at t = 1 and at t = 2.
        let (_, end, time) = course(Course::TargetAngle, (0.0, 3.0), 2.0, -2.0).expect("passes");
        assert_abs_diff_eq!(time, 1.0, epsilon = 1e-15);
        assert_abs_diff_eq!(end.velocity, 1.0, epsilon = 1e-14);
        // Away from it first: θ = t² − t, 2 at t = 2.
        let (_, end, time) = course(Course::TargetAngle, (0.0, -1.0), 2.0, 2.0).expect("comes back");
        assert_abs_diff_eq!(time, 2.0, epsilon = 1e-15);
        assert_abs_diff_eq!(end.velocity, 3.0, epsilon = 1e-14);
        // It turns round just there: θ = 2t − t², 1 at t = 1.
        let (_, end, time) = course(Course::TargetAngle, (0.0, 2.0), 1.0, -2.0).expect("arrives");
        assert_abs_diff_eq!(time, 1.0, epsilon = 1e-15);
        assert_abs_diff_eq!(end.velocity, 0.0, epsilon = 1e-14);
        // Two roots of very different size: t = δ/V₀ − α·δ²/(2·V₀³).
        let (_, _, time) = course(Course::TargetAngle, (0.0, 1e3), 1.0, 1e-4).expect("passes");
        assert_abs_diff_eq!(time, 1e-3 - 5e-14, epsilon = 1e-18);
    }

    #[test]
    fn what_cannot_be_reached_is_said() {
        let (angle, rest) = (Course::TargetAngle, (0.0, 0.0));
        let sine = Course::FullSine;
        let table = [
            (angle, rest, 1.0, 0.0, OutcomeKind::NoMotion),
            (angle, (0.0, -1.0), 1.0, 1e-9, OutcomeKind::NoMotion),
            (angle, rest, 1.0, -2.0, OutcomeKind::WrongSign),
            (angle, (0.0, -1.0), 1.0, -2.0, OutcomeKind::WrongSign),
            (angle, (0.0, 1.0), 1.0, -2.0, OutcomeKind::Unreachable),
            (angle, (1.0, 0.0), 1.0, -2.0, OutcomeKind::Reached),
            (angle, (1.0, 0.5), 1.0, -2.0, OutcomeKind::ReachedWithVelocity),
            (angle, rest, f64::MAX, 1e-5, OutcomeKind::NoMotion),
            (sine, rest, 1.0, 1e-9, OutcomeKind::NoMotion),
            (sine, (0.0, 0.1), 1.0, 2.0, OutcomeKind::NeedsRest),
            (Course::BangBang, (1.0, 0.0), 1.0, 0.0, OutcomeKind::Reached),
        ];
        for (kind, state, to, a, expected) in table {
            assert_eq!(
                course(kind, state, to, a).expect_err("is not reached"),
                expected,
                "{kind:?} {state:?} {a}"
            );
        }
    }

    #[test]
    fn time_oriented_motion_takes_its_time_whatever_the_acceleration() {
        let kind = Course::TimeOriented { duration: 2.0 };
        for a in [-5.0, 0.0, 1.0] {
            // θ = −1 + t + (3 − 2)·(t/2)²: acceleration 1/2, end velocity 2.
            let (start, end, time) = course(kind, (-1.0, 1.0), 2.0, a).expect("always goes");
            assert_abs_diff_eq!(time, 2.0, epsilon = 1e-15);
            assert_abs_diff_eq!(start.acceleration, 0.5, epsilon = 1e-15);
            assert_abs_diff_eq!(end.position, 2.0, epsilon = 1e-14);
            assert_abs_diff_eq!(end.velocity, 2.0, epsilon = 1e-14);
        }
    }
}
