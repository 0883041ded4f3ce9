//! Limits that push back.

use crate::element::LimitLaw;
use solaris_model::{Figure, Limits};
use solaris_profiles::Elementary;

/// The limits of one degree of freedom that push back.
///
/// ```text
/// τ = ∓max(0, k·x + c·ẋ)      x > 0 the depth beyond the limit
/// ```
///
/// Where the damper would pull, the limit lets go, and what is left in its spring is lost as heat. The damper acts from the
/// limit on, so that the force jumps there; what is at the limit but for rounding and on its way out is beyond it, or a step
/// that begins there would have the force of the wrong side.
#[derive(Clone, Debug)]
pub(super) struct Stop<T> {
    dof: usize,
    coordinate: usize,
    limits: Limits,
    stiffness: T,
    damping: T,
}

/// How near, of 1 and of the limit, a position is at it.
const NEAR: f64 = 1e-13;

impl<T: Elementary> Stop<T> {
    /// Those of `figure` whose law, by degree of freedom, is a spring.
    pub(super) fn of(figure: &Figure, laws: &[LimitLaw]) -> Vec<Self> {
        let number = T::from_f64;
        let mut stops = Vec::new();
        for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
            for (i, dof) in link.joint().kind().axes().iter().enumerate() {
                if let (Some(limits), LimitLaw::Spring { stiffness, damping }) = (dof.limits, laws[at.v + i])
                {
                    let (dof, coordinate) = (at.v + i, at.q + i);
                    let (stiffness, damping) = (number(stiffness), number(damping));
                    stops.push(Self { dof, coordinate, limits, stiffness, damping });
                }
            }
        }
        stops
    }

    /// Adds the force to `force`; what the damper takes (W).
    pub(super) fn act(&self, q: &[T], v: &[T], force: &mut [T]) -> T {
        let Some((depth, outwards)) = self.depth(q, v[self.dof].value()) else { return T::zero() };
        let rate = v[self.dof] * outwards;
        let spring = self.stiffness * depth;
        let push = spring + self.damping * rate;
        let push = if push.value() > 0.0 { push } else { T::zero() };
        force[self.dof] -= push * outwards;
        (push - spring) * rate
    }

    /// What is in the spring (J).
    pub(super) fn energy(&self, q: &[T]) -> T {
        let half = T::from_f64(0.5);
        self.depth(q, 0.0).map_or_else(T::zero, |(depth, _)| half * self.stiffness * depth * depth)
    }

    /// How far beyond a limit, and 1 or −1 for the way out; none inside.
    fn depth(&self, q: &[T], rate: f64) -> Option<(T, T)> {
        let (q, number) = (q[self.coordinate], T::from_f64);
        let Limits { lower, upper } = self.limits;
        // As near as an event is located.
        let near = |limit: f64| if limit.is_finite() { NEAR * (1.0 + limit.abs()) } else { 0.0 };
        if q.value() > upper || (rate > 0.0 && q.value() > upper - near(upper)) {
            Some((q - number(upper), number(1.0)))
        } else if q.value() < lower || (rate < 0.0 && q.value() < lower + near(lower)) {
            Some((number(lower) - q, number(-1.0)))
        } else {
            None
        }
    }
}
