//! Limits that push back.

use crate::element::LimitLaw;
use crate::impact::Side;
use solaris_model::{Figure, Limits};
use solaris_profiles::Elementary;

/// The limits of one degree of freedom that push back.
///
/// ```text
/// τ = ∓max(0, k·x + c·ẋ)      x > 0 the depth beyond the limit
/// ```
///
/// Where the damper would pull, the limit lets go, and what is left in its spring is lost as heat. The damper acts from the
/// limit on, so that the force jumps there, and has a kink where the limit lets go. Between such events, which whoever steps
/// locates, the law is [held](Stop::hold): a step that ends at one and looks a little further finds the force from before.
#[derive(Clone, Debug)]
pub(super) struct Stop<T> {
    dof: usize,
    coordinate: usize,
    limits: Limits,
    stiffness: T,
    damping: T,
    held: Option<Pushing>,
}

/// What a limit that pushes back does until the next event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pushing {
    /// Nothing: what it limits is inside.
    Inside,
    /// It pushes back, by its spring and its damper.
    Back(Side),
    /// What it limits is beyond it and comes back so fast that the damper would pull.
    LetGo(Side),
}

/// How near, of 1 and of the limit, a position is at it: as near as an event is located, early in a run.
const NEAR: f64 = 1e-10;

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
                    stops.push(Self { dof, coordinate, limits, stiffness, damping, held: None });
                }
            }
        }
        stops
    }

    /// Whose limits these are.
    pub(super) fn dof(&self) -> usize {
        self.dof
    }

    /// From now on the limit does this, whatever the state says, until it is told otherwise; with `None`, what the state says.
    pub(super) fn hold(&mut self, pushing: Option<Pushing>) {
        self.held = pushing;
    }

    /// What it has been told to do.
    pub(super) fn held(&self) -> Option<Pushing> {
        self.held
    }

    /// Adds the force to `force`; what the damper takes (W).
    pub(super) fn act(&self, q: &[T], v: &[T], force: &mut [T]) -> T {
        let (side, pushes) = match self.held {
            None => (pushing(self.limits, q[self.coordinate].value(), v[self.dof].value(), 0.0), true),
            Some(Pushing::Inside) => (None, false),
            Some(Pushing::Back(side)) => (Some(side), true),
            Some(Pushing::LetGo(side)) => (Some(side), false),
        };
        let Some(side) = side else { return T::zero() };
        let (depth, outwards) = self.depth(q, side);
        let rate = v[self.dof] * outwards;
        let spring = self.stiffness * depth;
        let push = spring + self.damping * rate;
        let push = if pushes && (self.held.is_some() || push.value() > 0.0) { push } else { T::zero() };
        force[self.dof] -= push * outwards;
        (push - spring) * rate
    }

    /// How it holds back where it pushes: `each(dof, c, k)`.
    pub(super) fn holds_back(&self, q: &[T], v: &[T], mut each: impl FnMut(usize, T, T)) {
        let Some(side) = pushing(self.limits, q[self.coordinate].value(), v[self.dof].value(), 0.0) else {
            return;
        };
        let (depth, outwards) = self.depth(q, side);
        if (self.stiffness * depth + self.damping * v[self.dof] * outwards).value() > 0.0 {
            each(self.dof, self.damping, self.stiffness);
        }
    }

    /// What a spring gives up that pushes nothing, for its damper would pull (W).
    pub(super) fn slackens(&self, q: &[T], v: &[T]) -> T {
        let Some(side) = pushing(self.limits, q[self.coordinate].value(), v[self.dof].value(), 0.0) else {
            return T::zero();
        };
        let (depth, outwards) = self.depth(q, side);
        let (spring, rate) = (self.stiffness * depth, v[self.dof] * outwards);
        if (spring + self.damping * rate).value() > 0.0 { T::zero() } else { -spring * rate }
    }

    /// What is in the spring (J).
    pub(super) fn energy(&self, q: &[T]) -> T {
        let Some(side) = pushing(self.limits, q[self.coordinate].value(), 0.0, 0.0) else { return T::zero() };
        let (depth, _) = self.depth(q, side);
        T::from_f64(0.5) * self.stiffness * depth * depth
    }

    /// How far beyond the limit on a side, and 1 or −1 for the way out.
    fn depth(&self, q: &[T], side: Side) -> (T, T) {
        let (q, number) = (q[self.coordinate], T::from_f64);
        match side {
            Side::Upper => (q - number(self.limits.upper), number(1.0)),
            Side::Lower => (number(self.limits.lower) - q, number(-1.0)),
        }
    }
}

/// Beyond which limit a position is with its velocity, if beyond any: what is at one but for rounding, and for some more, and on its way out is.
pub(crate) fn pushing(Limits { lower, upper }: Limits, q: f64, rate: f64, more: f64) -> Option<Side> {
    let near = |limit: f64| if limit.is_finite() { NEAR * (1.0 + limit.abs()) + more } else { 0.0 };
    if q > upper + near(upper) || (q > upper - near(upper) && rate > 0.0) {
        Some(Side::Upper)
    } else if q < lower - near(lower) || (q < lower + near(lower) && rate < 0.0) {
        Some(Side::Lower)
    } else {
        None
    }
}
