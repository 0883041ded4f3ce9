//! Springs, dampers and friction of the joints.

use solaris_dynamics::rotation_vector;
use solaris_model::{Figure, JointKind};
use solaris_profiles::Elementary;

/// `v₀` of dry friction (rad/s or m/s).
const SLOW: f64 = 1e-2;

/// What acts in the joints of a figure by itself.
///
/// ```text
/// τ = −k·(q − rest) − d·v − f·v/√(v² + v₀²)
/// ```
///
/// Dry friction is smooth: it has nearly all of its magnitude from a few `v₀ = 0.01 rad/s` (or m/s) on and lets creep what
/// it ought to hold. On a ball joint the spring acts on the rotation vector of the shortest way from the neutral orientation.
#[derive(Clone, Debug)]
pub(super) struct JointElements<T> {
    dofs: Vec<DofElement<T>>,
    balls: Vec<BallSpring<T>>,
}

/// Of one degree of freedom.
#[derive(Clone, Debug)]
struct DofElement<T> {
    dof: usize,
    /// Where a spring acts on it.
    spring: Option<Spring<T>>,
    damping: T,
    /// Where there is any.
    friction: Option<T>,
}

#[derive(Clone, Debug)]
struct Spring<T> {
    coordinate: usize,
    stiffness: T,
    rest: T,
}

/// On the rotation vector of a ball joint.
#[derive(Clone, Debug)]
struct BallSpring<T> {
    /// First of the three degrees of freedom.
    dof: usize,
    /// First entry of the quaternion.
    quaternion: usize,
    stiffness: T,
}

impl<T: Elementary> JointElements<T> {
    /// Those of `figure`, by what its joints say.
    pub(super) fn of(figure: &Figure) -> Self {
        let (mut dofs, mut balls) = (Vec::new(), Vec::new());
        let number = T::from_f64;
        for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
            let kind = link.joint().kind();
            for i in (0..at.nv).filter(|i| !kind.passive(*i).is_none()) {
                let acts = kind.passive(i);
                let springs = !kind.axes().is_empty() && acts.stiffness != 0.0;
                let (coordinate, stiffness, rest) = (at.q + i, number(acts.stiffness), number(acts.rest));
                dofs.push(DofElement {
                    dof: at.v + i,
                    spring: springs.then_some(Spring { coordinate, stiffness, rest }),
                    damping: number(acts.damping),
                    friction: (acts.friction != 0.0).then(|| number(acts.friction)),
                });
            }
            if let JointKind::Ball { passive, .. } = kind
                && passive.stiffness != 0.0
            {
                balls.push(BallSpring { dof: at.v, quaternion: at.q, stiffness: number(passive.stiffness) });
            }
        }
        // A damper that does nothing, where there is only a ball's spring.
        dofs.retain(|element| {
            element.spring.is_some() || element.friction.is_some() || !element.damping.is_zero()
        });
        Self { dofs, balls }
    }

    /// Adds the forces to `force`; what dampers and friction take (W).
    pub(super) fn act(&self, q: &[T], v: &[T], force: &mut [T]) -> T {
        let mut heat = T::zero();
        for DofElement { dof, spring, damping, friction } in &self.dofs {
            let rate = v[*dof];
            let mut against = *damping * rate;
            if let Some(friction) = friction {
                against += *friction * smooth_sign(rate);
            }
            heat += against * rate;
            if let Some(Spring { coordinate, stiffness, rest }) = spring {
                against += *stiffness * (q[*coordinate] - *rest);
            }
            force[*dof] -= against;
        }
        for BallSpring { dof, quaternion, stiffness } in &self.balls {
            let turn = rotation_vector(&q[*quaternion..*quaternion + 4]);
            for (force, turn) in force[*dof..*dof + 3].iter_mut().zip(turn) {
                *force -= *stiffness * turn;
            }
        }
        heat
    }

    /// How each degree of freedom is held back: `each(dof, d, k)` for a force `−d·v − k·q`, dry friction with the `d` that it has at
    /// this velocity, `f/√(v² + v₀²)`.
    pub(super) fn holds_back(&self, v: &[T], mut each: impl FnMut(usize, T, T)) {
        for DofElement { dof, spring, damping, friction } in &self.dofs {
            let (rate, slow) = (v[*dof], T::from_f64(SLOW));
            let mut damping = *damping;
            if let Some(friction) = friction {
                damping += *friction / (rate * rate + slow * slow).sqrt();
            }
            each(*dof, damping, spring.as_ref().map_or_else(T::zero, |spring| spring.stiffness));
        }
        for BallSpring { dof, stiffness, .. } in &self.balls {
            (*dof..*dof + 3).for_each(|dof| each(dof, T::zero(), *stiffness));
        }
    }

    /// What is in the springs (J).
    pub(super) fn energy(&self, q: &[T]) -> T {
        let mut twice = T::zero();
        for Spring { coordinate, stiffness, rest } in
            self.dofs.iter().filter_map(|element| element.spring.as_ref())
        {
            let way = q[*coordinate] - *rest;
            twice += *stiffness * way * way;
        }
        for BallSpring { quaternion, stiffness, .. } in &self.balls {
            for turn in rotation_vector(&q[*quaternion..*quaternion + 4]) {
                twice += *stiffness * turn * turn;
            }
        }
        twice * T::from_f64(0.5)
    }
}

/// `v/√(v² + v₀²)`.
fn smooth_sign<T: Elementary>(rate: T) -> T {
    let slow = T::from_f64(SLOW);
    rate / (rate * rate + slow * slow).sqrt()
}
