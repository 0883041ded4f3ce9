//! Settings of a run.

use std::fmt;

/// How a simulation is to be run.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// How long (s).
    pub duration: f64,
    /// Frames a second of the result (1/s); intensive mode analyses as often.
    pub rate: f64,
    /// By which method.
    pub method: Method,
    /// Whether the joint forces of every frame are wanted: those of the drives, and where something rests at a limit, with what
    /// the limit adds.
    pub forces: bool,
    /// Whether the run also tells how far off it may be, by a coarser run beside it. [`Method::Automatic`] always does.
    pub estimate: bool,
    /// When a run is ended.
    pub guard: Guard,
    /// Whether what stands still, and what nothing that is computed depends on, is left out of the dynamics; no result
    /// changes by more than rounding. For measurements of what that saves.
    pub leave_out: bool,
}

impl Settings {
    /// With joint forces, an error estimate, and the usual method.
    pub fn new(duration: f64, rate: f64) -> Self {
        Self {
            duration,
            rate,
            method: Method::Usual,
            forces: true,
            estimate: true,
            guard: Guard::default(),
            leave_out: true,
        }
    }
}

/// A method of stepping through time.
#[doc(alias = "integrator")]
#[doc(alias = "solver")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Method {
    /// What is meant where nothing is said: impulses in steps of a millisecond where links touch each other or are held together by
    /// loops, else whichever meets a tolerance of 1e-6. On [`Rigid`](crate::ContactLaw::Rigid) ground forces that keep all that
    /// stands may not be found, or not in a bounded number of evaluations, as for a heap of light links, or feet that are dragged
    /// along: then it is impulses, too, and a [`Remark`](crate::Remark) says so.
    Usual,
    /// Whichever meets the tolerance: what positions (rad or m) may be off by.
    Automatic {
        /// The tolerance.
        tolerance: f64,
    },
    /// One rule, at one step: the longest that divides a frame and is not longer than this (s).
    Fixed {
        /// The rule.
        rule: Rule,
        /// The longest step (s).
        step: f64,
    },
    /// Steps in which contact, friction and hard limits act by the impulses that they need: never refused, whatever touches and
    /// however it is held, and of order one. What falls does not bounce; off limits it
    /// does by their restitution.
    ///
    /// Every step solves one convex problem, with Coulomb's friction and the figure's whole inertia. A ground that is
    /// [`Rigid`](crate::ContactLaw::Rigid) gives way by a fraction of what gravity moves in a step; one that is
    /// [`Compliant`](crate::ContactLaw::Compliant) by its stiffness, its damping and slip not being asked. Joints with hard limits
    /// are held by the same problem. What slides at `v` does so `μ·v·h` above the ground.
    Impulses {
        /// The longest step (s).
        step: f64,
    },
    /// An explicit method of order eight that chooses its steps.
    Adaptive {
        /// Relative and absolute tolerance of a step.
        tolerance: f64,
    },
    /// An implicit method that chooses its steps, for stiff scenes; feature `stiff`.
    Stiff {
        /// Relative and absolute tolerance of a step.
        tolerance: f64,
    },
}

/// A rule for one step of fixed length `h`.
#[doc(alias = "runge-kutta")]
#[doc(alias = "rk4")]
#[doc(alias = "euler")]
#[doc(alias = "semi-implicit euler")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Rule {
    /// `q ← q + h·q̇`, `v ← v + h·a`: the thesis's (6.4).
    ExplicitEuler,
    /// `v ← v + h·a`, then `q` with the new velocity: the thesis's (6.1).
    SemiImplicitEuler,
    /// `q ← q + h·v + h²·a/2`, `v ← v + h·a`: exact where the acceleration is constant; what §6.2.2 of the thesis means.
    ConstantAcceleration,
    /// The classical rule of order four.
    RungeKutta4,
}

impl Rule {
    /// All of them, the simplest first.
    pub const ALL: [Self; 4] =
        [Self::ExplicitEuler, Self::SemiImplicitEuler, Self::ConstantAcceleration, Self::RungeKutta4];

    /// The power of the step with which the error of a whole run falls.
    pub fn order(self) -> i32 {
        if self == Self::RungeKutta4 { 4 } else { 1 }
    }

    /// The longest stable step times the magnitude of a real negative eigenvalue.
    pub fn stability(self) -> f64 {
        // The zero of 1 + z + z²/2 + z³/6 + z⁴/24 = 1 on the negative axis.
        if self == Self::RungeKutta4 { 2.785_293_563_405_282 } else { 2.0 }
    }

    /// Evaluations of a step.
    pub fn evaluations(self) -> u64 {
        if self == Self::RungeKutta4 { 4 } else { 1 }
    }
}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::ExplicitEuler => "explicit Euler",
            Self::SemiImplicitEuler => "semi-implicit Euler",
            Self::ConstantAcceleration => "constant acceleration",
            Self::RungeKutta4 => "Runge-Kutta 4",
        })
    }
}

/// When a run is ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guard {
    /// The least distance from gimbal lock (rad) of a joint that dynamics move.
    pub gimbal: f64,
    /// The greatest condition of the mass matrix, each degree of freedom in units in which its own inertia is 1.
    pub condition: f64,
    /// The greatest part of the energy at play that may be gained or lost by error.
    pub energy: f64,
    /// The most evaluations of the dynamics in a run.
    pub evaluations: u64,
}

impl Default for Guard {
    fn default() -> Self {
        Self { gimbal: 5e-3, condition: 1e14, energy: 0.2, evaluations: 10_000_000 }
    }
}
