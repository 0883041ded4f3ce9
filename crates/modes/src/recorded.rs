//! A recorded motion as a drive: curves through its samples.

use crate::failure::SetupError;
use solaris_model::Motion;
use solaris_profiles::Sample;

/// A motion that degrees of freedom can follow: between two samples, the polynomial of degree five that meets position,
/// velocity and acceleration of both.
///
/// Before its first sample and after its last it stands still there.
#[doc(alias = "motion capture")]
#[doc(alias = "playback")]
#[derive(Clone, Debug)]
pub struct RecordedMotion {
    motion: Motion,
}

impl PartialEq for RecordedMotion {
    /// The same motion object, not one with equal numbers.
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

impl RecordedMotion {
    /// The curves of `motion`.
    ///
    /// # Errors
    ///
    /// [`SetupError::Range`] for a motion without samples.
    pub fn new(motion: Motion) -> Result<Self, SetupError> {
        if motion.is_empty() {
            let what = "the number of samples of a recorded motion".to_owned();
            return Err(SetupError::Range { what, value: 0.0, range: "1 or more" });
        }
        Ok(Self { motion })
    }

    /// The motion.
    pub fn motion(&self) -> &Motion {
        &self.motion
    }

    /// The times of the first and of the last sample (s).
    pub fn span(&self) -> (f64, f64) {
        let time = self.motion.time();
        // There is a first sample: `new` saw it.
        (time[0], time[time.len() - 1])
    }

    /// The time (s) of the first sample after `time`, infinite after the last; one within rounding of it is at it.
    pub(crate) fn next_sample(&self, time: f64) -> f64 {
        let times = self.motion.time();
        let after = times.partition_point(|&t| t <= time + 1e-12 * (1.0 + time.abs()));
        times.get(after).copied().unwrap_or(f64::INFINITY)
    }

    /// Position, velocity, acceleration and jerk of a degree of freedom (index in `v`, and of its coordinate in `q`) at a
    /// time (s), which gives NaN if it is NaN.
    pub fn at(&self, dof: usize, coordinate: usize, time: f64) -> Sample {
        let times = self.motion.time();
        let (first, last) = self.span();
        if time.is_nan() {
            return Sample::from_array([f64::NAN; 4]);
        }
        if time < first || time > last || times.len() == 1 {
            let sample = if time < first { 0 } else { times.len() - 1 };
            return Sample::rest(self.motion.q(sample)[coordinate]);
        }
        let next = times.partition_point(|&t| t <= time).clamp(1, times.len() - 1);
        let end = |sample: usize| {
            [self.motion.q(sample)[coordinate], self.motion.v(sample)[dof], self.motion.a(sample)[dof]]
        };
        between(times[next] - times[next - 1], time - times[next - 1], end(next - 1), end(next))
    }
}

/// The polynomial of degree five in `u = t/T` that meets position, velocity and acceleration at both ends.
///
/// ```text
/// x = x₀ + v₀T·u + a₀T²/2·u² + (10D − 4V + A/2)·u³ − (15D − 7V + A)·u⁴ + (6D − 3V + A/2)·u⁵
/// D = x₁ − x₀ − v₀T − a₀T²/2      V = (v₁ − v₀)·T − a₀T²      A = (a₁ − a₀)·T²
/// ```
fn between(duration: f64, t: f64, [x0, v0, a0]: [f64; 3], [x1, v1, a1]: [f64; 3]) -> Sample {
    let (u, rate) = (t / duration, duration.recip());
    let (v, a) = (v0 * duration, a0 * duration * duration);
    let way = x1 - x0 - v - 0.5 * a;
    let gain = (v1 - v0) * duration - a;
    let change = (a1 - a0) * duration * duration;
    let c3 = 10.0 * way - 4.0 * gain + 0.5 * change;
    let c4 = 7.0 * gain - 15.0 * way - change;
    let c5 = 6.0 * way - 3.0 * gain + 0.5 * change;
    Sample {
        position: x0 + u * (v + u * (0.5 * a + u * (c3 + u * (c4 + u * c5)))),
        velocity: rate * (v + u * (a + u * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5)))),
        acceleration: rate * rate * (a + u * (6.0 * c3 + u * (12.0 * c4 + u * 20.0 * c5))),
        jerk: rate * rate * rate * (6.0 * c3 + u * (24.0 * c4 + u * 60.0 * c5)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;
    use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, MotionInfo};

    fn slider() -> Figure {
        let link = LinkSpec::root("block", Joint::new("slide").tx()).mass(1.0);
        FigureBuilder::new("slider").link(link).build().expect("valid")
    }

    fn motion(time: Vec<f64>, curve: impl Fn(f64) -> [f64; 3]) -> Motion {
        let figure = slider();
        let column = |k: usize| time.iter().map(|&t| curve(t)[k]).collect::<Vec<f64>>();
        let columns = [column(0), column(1), column(2)];
        Motion::new(&figure, MotionInfo::on_earth(&figure, 10.0), time, columns).expect("valid")
    }

    #[test]
    fn a_polynomial_of_degree_five_comes_back_between_uneven_samples() {
        let curve = |t: f64| [t.powi(5) - 2.0 * t, 5.0 * t.powi(4) - 2.0, 20.0 * t.powi(3)];
        let recorded = RecordedMotion::new(motion(vec![-0.5, 0.1, 0.25, 1.0], curve)).expect("has samples");
        for t in [-0.5, -0.2, 0.1, 0.2, 0.25, 0.7, 1.0] {
            let (found, [x, v, a]) = (recorded.at(0, 0, t), curve(t));
            assert_abs_diff_eq!(found.position, x, epsilon = 1e-14);
            assert_abs_diff_eq!(found.velocity, v, epsilon = 1e-13);
            assert_abs_diff_eq!(found.acceleration, a, epsilon = 1e-12);
            assert_abs_diff_eq!(found.jerk, 60.0 * t * t, epsilon = 1e-10);
        }
    }

    #[test]
    fn before_and_after_it_stands_still_and_nan_stays_nan() {
        let recorded = RecordedMotion::new(motion(vec![1.0, 2.0], |t| [t, 1.0, 0.0])).expect("has samples");
        assert_eq!(recorded.span(), (1.0, 2.0));
        assert_eq!(recorded.at(0, 0, 0.5), Sample::rest(1.0));
        assert_eq!(recorded.at(0, 0, 2.5), Sample::rest(2.0));
        assert!(recorded.at(0, 0, f64::NAN).position.is_nan());
    }

    #[test]
    fn one_sample_is_a_pose_and_none_is_refused() {
        let pose = RecordedMotion::new(motion(vec![1.0], |_| [0.3, 2.0, 5.0])).expect("has a sample");
        assert_eq!(pose.at(0, 0, 1.0), Sample::rest(0.3));
        let refused = RecordedMotion::new(motion(Vec::new(), |_| [0.0; 3])).expect_err("empty");
        assert_eq!(
            refused.to_string(),
            "the number of samples of a recorded motion is 0; it must be 1 or more"
        );
    }
}
