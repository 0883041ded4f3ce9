//! Intensive mode: which acceleration leads to a target, and the force that gives it over a frame.

use super::{Law, Target};
use crate::body::Body;
use solaris_dynamics::DynamicsError;
use solaris_model::Figure;
use solaris_profiles::{Boundary, Curve, Quintic};

/// The way of one degree of freedom to a target, planned anew from where it is at each frame.
///
/// ```text
/// cubic     x(s) = q + v·s + c₂·s² + c₃·s³                      meets q, v now and q₁, v₁ in r
/// quintic   x(s) of degree five                                 meets q, v, a now and q₁, v₁, a₁ in r
/// wanted    ā = (ẋ(Δt) − v)/Δt
/// ```
///
/// with `r` the time that is left. What is wanted is the mean acceleration over the frame, not that at its beginning: a force
/// that is constant over the frame then brings about the plan's velocity at the frame's end, and stays finite in the last
/// frame. A quintic begins with the acceleration that the plan of the last frame ended with, which a velocity and a position
/// alone do not tell.
///
/// # Source
///
/// The cubic is the time-to-go law `a = 6·e/r² − (4·v + 2·v₁)/r` of a motion that has to arrive at a time, sampled. In the
/// thesis (Vasilonikolidakis (1991), §6.3) intensive mode holds the force of the target's state instead
/// ([`Law::Literal`]), which leads to the target only by chance.
#[derive(Clone, Debug)]
pub(crate) struct Tracker {
    law: Law,
    target: Target,
    /// When to be there (s).
    end: f64,
    /// The plan of the last call with the time when it began, and its acceleration where there is none.
    plan: Option<(Quintic, f64)>,
    planned: f64,
}

impl Tracker {
    /// From `start` (s), in a state of position, velocity and acceleration, to a target within `duration` (s).
    pub(crate) fn new(
        law: Law,
        target: Target,
        start: f64,
        duration: f64,
        (_, _, acceleration): (f64, f64, f64),
    ) -> Self {
        Self { law, target, end: start + duration, plan: None, planned: acceleration }
    }

    /// The mean acceleration (rad/s² or m/s²) over the frame of length `frame` (s) that begins at `time` (s) at a position
    /// with a velocity. Finite for a frame above zero; a frame beyond the end leads to the target's velocity.
    ///
    /// [`Law::Literal`] has no plan, and wants what the cubic does.
    pub(crate) fn wanted(&mut self, time: f64, frame: f64, position: f64, velocity: f64) -> f64 {
        let Target { position: q1, velocity: v1, acceleration: a1 } = self.target;
        let left = self.end - time;
        // The last frame, whose length may be the rest of the time but for rounding.
        if left <= frame * (1.0 + 1e-9) {
            (self.plan, self.planned) = (None, a1);
            return (v1 - velocity) / frame;
        }
        if self.law == Law::Quintic {
            // The last frame may have been cut short.
            let planned = self.plan.map_or(self.planned, |(plan, start)| plan.at(time - start).acceleration);
            let begin = Boundary::new(position, velocity, planned);
            // Refused are only numbers that overflow; the cubic then says what is left to say.
            if let Ok(plan) = Quintic::new(left, begin, Boundary::new(q1, v1, a1)) {
                self.plan = Some((plan, time));
                return (plan.at(frame).velocity - velocity) / frame;
            }
        }
        let way = (q1 - position) / left;
        let (c2, c3) =
            ((3.0 * way - 2.0 * velocity - v1) / left, (velocity + v1 - 2.0 * way) / (left * left));
        2.0 * c2 + 3.0 * c3 * frame
    }
}

/// The constant forces over the next frame that give the degrees of freedom in `wanted` these mean accelerations.
///
/// Found by hybrid dynamics in the state in the middle of the frame, where what changes over the frame has its mean but for
/// an error of the order of the frame's length squared. That state is predicted with the accelerations `a`: the wanted ones,
/// those of `prescribed` degrees of freedom, for which the mean over the frame or the one in its middle is to be given, and
/// the last ones of the others, which are corrected once. So what tracks, what is free and what has a force of its own, in
/// `tau`, act on one another, a floating root among them. Written are `tau` of the tracked and the prescribed, and `a` of
/// all.
#[allow(clippy::too_many_arguments, reason = "a state, what is known of it, and what is sought")]
pub(crate) fn frame_forces(
    body: &mut Body<f64>,
    figure: &Figure,
    q: &[f64],
    v: &[f64],
    prescribed: &[bool],
    a: &mut [f64],
    tau: &mut [f64],
    wanted: &[(usize, f64)],
    frame: f64,
) -> Result<(), DynamicsError> {
    let mut given = prescribed.to_vec();
    for &(dof, acceleration) in wanted {
        (given[dof], a[dof]) = (true, acceleration);
    }
    let mut middle = Middle::new(figure, q, v, 0.5 * frame);
    // The first pass finds the accelerations of what is free, the second the forces in the state that they lead to. Where
    // nothing is free there is nothing to find.
    if given.iter().any(|given| !given) {
        middle.predict(a);
        body.hybrid(&middle.q, &middle.v, &given, a, tau)?;
    }
    middle.predict(a);
    body.hybrid(&middle.q, &middle.v, &given, a, tau)
}

/// The state half a frame on.
struct Middle<'a> {
    figure: &'a Figure,
    start: (&'a [f64], &'a [f64]),
    half: f64,
    q: Vec<f64>,
    v: Vec<f64>,
    step: Vec<f64>,
}

impl<'a> Middle<'a> {
    fn new(figure: &'a Figure, q: &'a [f64], v: &'a [f64], half: f64) -> Self {
        Self { figure, start: (q, v), half, q: q.to_vec(), v: v.to_vec(), step: v.to_vec() }
    }

    /// With constant accelerations.
    fn predict(&mut self, a: &[f64]) {
        let (q, v) = self.start;
        for (k, &a) in a.iter().enumerate() {
            self.v[k] = v[k] + self.half * a;
            self.step[k] = self.half * (v[k] + 0.5 * self.half * a);
        }
        // Refused are only numbers that are not finite, which hybrid dynamics names better.
        if self.figure.integrate(q, &self.step, &mut self.q).is_err() {
            self.q.copy_from_slice(q);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::LimitLaw;
    use approx::assert_abs_diff_eq;
    use nalgebra::Vector3;
    use solaris_model::{FigureBuilder, Inertia, Joint, LinkSpec};

    /// Follows the plan with exactly what it wants; position and velocity at the end, and the greatest acceleration.
    fn follow(law: Law, target: Target, start: (f64, f64), duration: f64, rate: f64) -> (f64, f64, f64) {
        let (mut q, mut v) = start;
        let mut tracker = Tracker::new(law, target, 0.5, duration, (q, v, 0.0));
        let (mut t, mut most, end) = (0.5, 0.0_f64, 0.5 + duration);
        while t < end - 1e-12 {
            let frame = rate.recip().min(end - t);
            let a = tracker.wanted(t, frame, q, v);
            (q, v) = (q + frame * (v + 0.5 * frame * a), v + frame * a);
            (t, most) = (t + frame, most.max(a.abs()));
        }
        (q, v, most)
    }

    #[test]
    fn both_laws_arrive_and_their_errors_fall_as_the_square_of_the_frame() {
        let target = Target { position: 1.0, velocity: 0.4, acceleration: -0.3 };
        for law in [Law::Cubic, Law::Quintic] {
            let errors = [120.0, 240.0, 480.0].map(|rate| {
                let (q, v, _) = follow(law, target, (0.0, -0.2), 1.0, rate);
                assert_abs_diff_eq!(v, 0.4, epsilon = 1e-13);
                (q - 1.0).abs()
            });
            assert!(errors[1] <= 1e-6, "{law:?}: {errors:?}");
            // At the least as the square: the error of one frame is of the third power, and the others are made good.
            assert!(errors[0] >= 4.0 * errors[1] && errors[1] >= 4.0 * errors[2], "{law:?}: {errors:?}");
        }
    }

    #[test]
    fn the_greatest_acceleration_is_that_of_the_polynomial() {
        // From rest to rest: 6·D/T² of the cubic, 10/√3·D/T² of the quintic.
        let target = Target::at(2.0);
        assert_abs_diff_eq!(follow(Law::Cubic, target, (0.0, 0.0), 2.0, 1e3).2, 3.0, epsilon = 5e-3);
        assert_abs_diff_eq!(follow(Law::Quintic, target, (0.0, 0.0), 2.0, 1e3).2, 2.886_75, epsilon = 1e-4);
    }

    #[test]
    fn a_duration_that_is_no_whole_number_of_frames_ends_without_a_blow() {
        for rest in [1e-9, 1e-4, 0.7 / 240.0] {
            for law in [Law::Cubic, Law::Quintic] {
                let (q, v, most) = follow(law, Target::at(1.0), (0.0, 0.0), 1.0 + rest, 240.0);
                assert_abs_diff_eq!(q, 1.0, epsilon = 2e-6);
                assert_abs_diff_eq!(v, 0.0, epsilon = 1e-12);
                assert!(most < 7.0, "{law:?}, {rest:e}: {most}");
            }
        }
    }

    #[test]
    fn a_frame_force_gives_the_mean_acceleration_but_for_the_square_of_the_frame() {
        // Two bars on a free base; the forces of one frame, integrated finely.
        let base =
            LinkSpec::root("base", Joint::free("root")).mass(4.0).inertia(Inertia::diagonal(0.1, 0.1, 0.1));
        let bar = |name: &str, parent: &str| {
            let joint = Joint::new(format!("{name}_hinge")).rx().at(Vector3::new(0.0, -0.4, 0.0));
            LinkSpec::child(name, parent, joint).mass(1.0).com(Vector3::new(0.0, -0.2, 0.0))
        };
        let figure = FigureBuilder::new("f").link(base).link(bar("a", "base")).link(bar("b", "a"));
        let figure = figure.build().expect("valid");
        let mut body =
            Body::new(&figure, Vector3::new(0.0, -9.81, 0.0), &[], &[LimitLaw::Ignore; 8]).expect("valid");
        let start_q = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.5, -0.9];
        let start_v = [0.1, 0.0, 0.2, 1.0, 0.3, -0.5, 2.0, -1.0];
        let wanted = [(6, 5.0), (7, -8.0)];
        let mut missed = |frame: f64| {
            let (mut a, mut tau) = ([0.0; 8], [0.0; 8]);
            frame_forces(
                &mut body,
                &figure,
                &start_q,
                &start_v,
                &[false; 8],
                &mut a,
                &mut tau,
                &wanted,
                frame,
            )
            .expect("finite");
            let (mut q, mut v, steps) = (start_q, start_v, 400);
            let h = frame / f64::from(steps);
            for _ in 0..steps {
                // The midpoint rule, whose error here is far below that of the frame.
                let mut next = [0.0; 8];
                body.hybrid(&q, &v, &[false; 8], &mut next, &mut tau).expect("finite");
                let middle: Vec<f64> = v.iter().zip(&next).map(|(v, a)| v + 0.5 * h * a).collect();
                let (mut q_middle, mut q_next) = (q, q);
                figure.integrate(&q, &v.map(|v| 0.5 * h * v), &mut q_middle).expect("finite");
                body.hybrid(&q_middle, &middle, &[false; 8], &mut next, &mut tau).expect("finite");
                let step: Vec<f64> = middle.iter().map(|v| h * v).collect();
                figure.integrate(&q, &step, &mut q_next).expect("finite");
                q = q_next;
                v = std::array::from_fn(|k| v[k] + h * next[k]);
            }
            let off = |&(dof, a): &(usize, f64)| ((v[dof] - start_v[dof]) / frame - a).abs();
            wanted.iter().map(off).fold(0.0, f64::max)
        };
        let errors = [1.0 / 60.0, 1.0 / 120.0, 1.0 / 240.0].map(&mut missed);
        assert!(errors[2] < 2e-3, "{errors:?}");
        for pair in errors.windows(2) {
            assert!((3.5..4.5).contains(&(pair[0] / pair[1])), "{errors:?}");
        }
    }
}
