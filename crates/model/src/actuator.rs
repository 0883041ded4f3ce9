//! Motors of joints, as files of robots have them.

/// A motor of one degree of freedom.
#[derive(Clone, Debug, PartialEq)]
pub struct Actuator {
    /// What the file calls it.
    pub name: String,
    /// The degree of freedom, or the joint of one.
    pub dof: String,
    /// What it does.
    pub law: ActuatorLaw,
    /// The greatest force at the degree of freedom (N m or N), the same both ways, if it has one.
    pub limit: Option<f64>,
}

/// What an [`Actuator`] does with what it is told; all numbers are those at the degree of freedom, gears included.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ActuatorLaw {
    /// `τ = k·(q* − q) + d·(q̇* − q̇)`; MuJoCo's has no `q̇*`, which is the same where it rests.
    Position {
        /// `k` (N m/rad or N/m).
        stiffness: f64,
        /// `d` (N m s/rad or N s/m).
        damping: f64,
    },
    /// `τ = d·(q̇* − q̇)`
    Velocity {
        /// `d` (N m s/rad or N s/m).
        damping: f64,
    },
    /// Any force within its limit.
    Force,
    /// Something else, by the word of the file.
    Other(String),
}
