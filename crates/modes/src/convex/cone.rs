//! What can push, and how much: limits and Coulomb's cone, each with a small compliance.

use std::f64::consts::PI;

/// `β`: what is as stiff as a step allows has a natural period of `β` steps with the mass that it meets.
const NEAR_RIGID: f64 = 1.0;

/// The same of what is held.
const HELD: f64 = 2e-3;

/// Compliance of friction beside that of the push: how much of the velocity that friction stops is left.
const CREEP: f64 = 1e-3;

/// The law of one condition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Law {
    /// Three velocities that are held, by pushes and pulls: `γ = (û − u)·w`.
    Hold {
        /// `w = 1/R`.
        weight: [f64; 3],
        /// `û`.
        target: [f64; 3],
    },
    /// A limit, along the third number: `γ = max(0, (û − u)·w)`.
    Limit {
        /// `w = 1/R`.
        weight: f64,
        /// `û`.
        target: f64,
    },
    /// A contact whose friction is bound by its own push: a cone.
    Contact {
        /// `1/R` along the ground and out of it.
        weight: [f64; 2],
        /// `û` out of the ground.
        target: f64,
        friction: f64,
    },
    /// A contact whose friction is bound by a push that is known: a cylinder.
    Bound {
        /// `1/R` along the ground and out of it.
        weight: [f64; 2],
        /// `û` out of the ground.
        target: f64,
        friction: f64,
        /// The greatest impulse of friction.
        most: f64,
    },
}

/// An impulse, and how it falls with the velocity: `G = −∂γ/∂u`; none where nothing pushes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Pushed {
    pub(super) impulse: [f64; 3],
    pub(super) stiffness: Option<[[f64; 3]; 3]>,
}

impl Law {
    /// `lightness` is the inverse mass along and out of the ground.
    ///
    /// ```text
    /// R_n = max(w·β²/4π², 1/(h·k·(h + τ)))        û_n = −φ/(h + τ)        R_t = σ·w
    /// ```
    pub(super) fn contact(
        [along, out]: [f64; 2],
        friction: f64,
        gap: f64,
        (stiffness, relaxation): (f64, f64),
        h: f64,
    ) -> Self {
        if out.is_nan() || out <= 0.0 {
            // What cannot move is not pushed.
            return Self::Limit { weight: 0.0, target: 0.0 };
        }
        let time = h + relaxation;
        let rigid = NEAR_RIGID * NEAR_RIGID / (4.0 * PI * PI) * out;
        let compliance = rigid.max((h * stiffness * time).recip());
        let weight = [(CREEP * along.max(1e-6 * out)).recip(), compliance.recip()];
        // Off the ground it may come as near as it is within the step.
        let target = if gap > 0.0 { -gap / h } else { -gap / time };
        Self::Contact { weight, target, friction }
    }

    /// The same for a limit, as stiff as a step allows, off which what comes with the speed `[speed, e]` bounces with `e` times that; a
    /// speed of 0 for what does not.
    pub(super) fn limit(lightness: f64, gap: f64, [speed, restitution]: [f64; 2], h: f64) -> Self {
        let give = NEAR_RIGID * NEAR_RIGID / (4.0 * PI * PI);
        let weight = if lightness > 0.0 { (give * lightness).recip() } else { 0.0 };
        // With what the limit gives way by while it turns the speed round.
        let back = speed * (restitution + give * (1.0 + restitution));
        Self::Limit { weight, target: if speed > 0.0 { back.max(-gap / h) } else { -gap / h } }
    }

    /// Velocities that are held, stiffer than anything that pushes, so that it is not what gives way.
    pub(super) fn hold(lightness: [f64; 3], target: [f64; 3]) -> Self {
        let stiff = HELD * HELD / (4.0 * PI * PI);
        let weight = lightness.map(|light| if light > 0.0 { (stiff * light).recip() } else { 0.0 });
        Self::Hold { weight, target }
    }

    /// The same with friction bound by a push.
    pub(super) fn bound_by(self, push: f64) -> Self {
        match self {
            Self::Contact { weight, target, friction } | Self::Bound { weight, target, friction, .. } => {
                Self::Bound { weight, target, friction, most: friction * push }
            }
            Self::Limit { .. } | Self::Hold { .. } => self,
        }
    }

    /// The same with friction bound by a push, or where it is bound already, gone this share of the way there.
    pub(super) fn nearer_to(self, push: f64, share: f64) -> Self {
        match self {
            Self::Bound { weight, target, friction, most } => {
                Self::Bound { weight, target, friction, most: most + share * (friction * push - most) }
            }
            _ => self.bound_by(push),
        }
    }

    /// By how much what it does would change if friction were bound by what pushes now.
    pub(super) fn off_bound(&self, pushed: &Pushed) -> f64 {
        let [x, y, push] = pushed.impulse;
        let drag = (x * x + y * y).sqrt();
        match *self {
            // What sticks within the cone sticks within the bound.
            Self::Contact { friction, .. } if drag > 0.0 && drag >= friction * push * (1.0 - 1e-9) => {
                f64::INFINITY
            }
            Self::Bound { friction, most, .. } if drag >= most * (1.0 - 1e-9) || drag > friction * push => {
                (friction * push - most).abs()
            }
            _ => 0.0,
        }
    }

    /// What it does at a velocity: the projection of `y = R⁻¹(û − u)` onto what can push, in the norm of `R`.
    ///
    /// ```text
    /// stick   μ·y_n ≥ |y_t|             γ = y
    /// slide   else, y_n > −μ̂·|y_t|      γ_n = (y_n + μ̂·|y_t|)/(1 + μ·μ̂), γ_t = μ·γ_n·y_t/|y_t|        μ̂ = μ·R_t/R_n
    /// part    else                      γ = 0
    /// ```
    pub(super) fn push(&self, u: [f64; 3]) -> Pushed {
        match *self {
            Self::Hold { weight, target } => {
                let mut stiffness = [[0.0; 3]; 3];
                for i in 0..3 {
                    stiffness[i][i] = weight[i];
                }
                let impulse = [0, 1, 2].map(|i| weight[i] * (target[i] - u[i]));
                Pushed { impulse, stiffness: Some(stiffness) }
            }
            Self::Limit { weight, target } => {
                let push = weight * (target - u[2]);
                if push > 0.0 {
                    let mut stiffness = [[0.0; 3]; 3];
                    stiffness[2][2] = weight;
                    Pushed { impulse: [0.0, 0.0, push], stiffness: Some(stiffness) }
                } else {
                    Pushed::default()
                }
            }
            Self::Bound { weight: [along, out], target, most, .. } => {
                let mut stiffness = [[0.0; 3]; 3];
                let normal = (out * (target - u[2])).max(0.0);
                if normal > 0.0 {
                    stiffness[2][2] = out;
                }
                let (y, tangent) =
                    ([-along * u[0], -along * u[1]], along * (u[0] * u[0] + u[1] * u[1]).sqrt());
                // Inside of the bound it sticks, beyond it the bound is all there is.
                let share = if tangent <= most { 1.0 } else { most / tangent };
                for i in 0..2 {
                    for j in 0..2 {
                        let whole = f64::from(u8::from(i == j));
                        let kept = if share < 1.0 { y[i] * y[j] / (tangent * tangent) } else { 0.0 };
                        stiffness[i][j] = along * share * (whole - kept);
                    }
                }
                let stiffness = (normal > 0.0 || most > 0.0).then_some(stiffness);
                Pushed { impulse: [y[0] * share, y[1] * share, normal], stiffness }
            }
            Self::Contact { weight: [along, out], target, friction } => {
                let y = [-along * u[0], -along * u[1], out * (target - u[2])];
                let tangent = (y[0] * y[0] + y[1] * y[1]).sqrt();
                if y[2] > 0.0 && tangent <= friction * y[2] {
                    let stiffness = [[along, 0.0, 0.0], [0.0, along, 0.0], [0.0, 0.0, out]];
                    return Pushed { impulse: y, stiffness: Some(stiffness) };
                }
                // R_t/R_n is the inverse ratio of the weights.
                let scaled = friction * out / along;
                if y[2] <= -scaled * tangent || tangent <= 0.0 {
                    return Pushed::default();
                }
                let share = (1.0 + friction * scaled).recip();
                let normal = (y[2] + scaled * tangent) * share;
                let t = [y[0] / tangent, y[1] / tangent];
                let drag = friction * normal;
                // ∂γ/∂y, times R⁻¹.
                let mut stiffness = [[0.0; 3]; 3];
                for i in 0..2 {
                    for j in 0..2 {
                        let across = f64::from(u8::from(i == j)) - t[i] * t[j];
                        stiffness[i][j] =
                            along * (friction * scaled * share * t[i] * t[j] + drag / tangent * across);
                    }
                    stiffness[i][2] = out * friction * share * t[i];
                    stiffness[2][i] = stiffness[i][2];
                }
                stiffness[2][2] = out * share;
                Pushed { impulse: [drag * t[0], drag * t[1], normal], stiffness: Some(stiffness) }
            }
        }
    }
}
