//! The smallest change of the root's path that makes a motion's ground reactions possible.
//!
//! The whole figure is moved by `δ(t)` and nothing else. Of a figure of mass m, with force `F` and moment `M` of the ground,
//! centre of mass `c` at the height `h` above the ground and `n` up,
//!
//! ```text
//! F' = F + m δ̈        c' = c + δ        Ḣ' = Ḣ = M − c × F
//! ```
//!
//! since a shift that is the same everywhere changes no angular momentum about the centre of mass. Of a centre of pressure `P`
//! on the ground (`n·P = n·c − h`), `Ḣ = (P − c) × F + τn`, so that
//!
//! ```text
//! n × Ḣ = Fₙ (P − c)_t + h F_t          P_t = c_t + (n × Ḣ − h F_t)/Fₙ
//! ```
//!
//! and of the shifted figure, whose height is `h' = h + δₙ` over the same ground and whose force is `Fₙ' = Fₙ + m δ̈ₙ`,
//!
//! ```text
//! P'_t − δ_t = c_t + (n × Ḣ − h' F_t)/Fₙ' − (h' m/Fₙ') δ̈_t
//! ```
//!
//! The soles go with the root, so it is `P' − δ` that has to lie in the outline of what stands. With `δₙ` known this is linear
//! in `δ̈_t`, and no place of the world occurs in it. Hence two stages, the vertical one first, each a least path within
//! linear bounds (`interior.rs`).
//!
//! What is least is `Σ |δ|² + θ⁴ |δ̈|²` over the frames. The first term alone has no useful answer: in flight it would put the
//! root back within one frame, and in stance it would throw the centre of pressure from edge to edge ever faster. θ is the time
//! within which the path may settle; with θ² = h/g both terms would weigh the root's way and the centre of pressure's alike.
//!
//! Over frames of length `1/f`: `δ̈_k = f² (δ_{k+1} − 2δ_k + δ_{k−1})` and `δ̇_k = f (δ_{k+1} − δ_{k−1})/2`, with a place
//! beyond either end that nothing holds.

mod error;
mod interior;
mod scene;
mod shift;
mod sweep;

pub use error::{ConsistencyError, ShiftError};
pub use shift::shift_root;

use crate::ground::BalanceFrame;
use crate::ground::consistency::{interior::YIELD, scene::Scene};
use nalgebra::{Vector1, Vector2, Vector3};
use solaris_model::GroundAxes;

/// What may be changed, and how well it is to be done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConsistencyOptions {
    /// How far (m) the root may be moved; infinite for as far as it takes.
    pub limit: f64,
    /// How far (m) inside of the outline the centre of pressure is to stay.
    pub margin: f64,
    /// The least normal force of what stands, as a share of the weight; above 0, at most 1.
    pub least_force: f64,
    /// The time θ (s) within which the shift may come and go.
    pub smoothing: f64,
    /// Most iterations of the search for a path; where the limit matters, a stage takes several searches.
    pub iterations: usize,
    /// How far (m) the shift may be from the least one, and the centre of pressure from where it has to be.
    pub tolerance: f64,
}

impl Default for ConsistencyOptions {
    fn default() -> Self {
        let (limit, margin, least_force) = (0.05, 0.005, 0.01);
        Self { limit, margin, least_force, smoothing: 0.1, iterations: 100, tolerance: 1e-7 }
    }
}

/// How impossible the ground's reaction is.
///
/// With the feature `serde` its keys are `frames`, `cop_outside_mm` and `pull_n`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Violation {
    /// Frames at fault: pulling, or outside by more than the tolerance.
    pub frames: usize,
    /// How far (m) the centre of pressure is outside of the outline, at worst.
    #[cfg_attr(feature = "serde", serde(rename = "cop_outside_mm", serialize_with = "millimetres"))]
    pub outside: f64,
    /// With what force (N) the ground would have to pull, at worst; there is no centre of pressure then.
    #[cfg_attr(feature = "serde", serde(rename = "pull_n"))]
    pub pull: f64,
}

/// A length (m) in mm.
#[cfg(feature = "serde")]
#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde hands over a reference")]
fn millimetres<S: serde::Serializer>(length: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(length * 1e3)
}

/// How it ended.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ConsistencyOutcome {
    /// Every frame is possible, within the limit.
    Reached,
    /// The limit does not suffice: the shift stops at it, and leaves frames impossible. It is the one that makes every frame possible and
    /// goes beyond the limit by as little as it can (by sum of squares over the frames, of which a metre beyond weighs 10³ times
    /// one within), made smaller as a whole until it keeps the limit.
    Short {
        /// The frame that goes furthest, from 0.
        frame: usize,
        /// How far (m) beyond the limit it would have to go.
        by: f64,
    },
    /// The iterations ran out, or the numbers did; the shift is the best so far and may leave frames impossible.
    Unsettled,
}

/// The shift, and what it does.
#[derive(Clone, Debug, PartialEq)]
pub struct Consistency {
    /// By how much (m) the root is moved, in world axes, one a frame.
    pub shift: Vec<Vector3<f64>>,
    /// Its velocity (m/s).
    pub velocity: Vec<Vector3<f64>>,
    /// Its acceleration (m/s²).
    pub acceleration: Vec<Vector3<f64>>,
    /// The greatest length (m) of the shift. Feet that stood slide by as much, and the vertical part lifts or sinks them.
    pub greatest: f64,
    /// Root of the mean square (m) of its length.
    pub rms: f64,
    /// What was impossible.
    pub before: Violation,
    /// What still is, worked out from the shifted motion's whole wrench.
    pub after: Violation,
    /// Iterations of all searches, in both stages.
    pub iterations: usize,
    /// How it ended.
    pub outcome: ConsistencyOutcome,
}

/// The smallest shift of the root's path that keeps the ground from pulling and the centre of pressure inside of what stands.
///
/// `rate` in frames/s, `mass` in kg, `gravity` in m/s², `level` the ground's height (m) along up, which is against gravity. Of
/// every frame its balance and the convex outline (m, world) of what stands on the ground, counter-clockwise as seen from
/// above; an empty one where nothing stands: of flight nothing is asked, so its force is not made zero. Only the outline's
/// horizontal place counts.
///
/// A motion that needs no change gets exactly zero. Without a limit there is always an answer; with one, no frame is moved further.
///
/// # Errors
///
/// Numbers that are not finite or out of range, fewer than three frames, nothing that stands in any of them, outlines that are none or too
/// narrow for the margin, and a centre of mass that is not above the ground it stands on.
pub fn consistent(
    rate: f64,
    mass: f64,
    gravity: &Vector3<f64>,
    level: f64,
    frames: &[BalanceFrame],
    outlines: &[Vec<Vector3<f64>>],
    options: &ConsistencyOptions,
) -> Result<Consistency, ConsistencyError> {
    let numbers = [("rate", rate), ("mass", mass), ("gravity", gravity.norm())];
    check_numbers(&numbers, level, options)?;
    check_frames(frames, outlines)?;
    let weight = mass * gravity.norm();
    let ground = GroundAxes::new(&(-gravity / gravity.norm()));
    let scene =
        Scene { rate, mass, weight, level, ground, frames, options, edges: vec![] }.stand(outlines)?;
    let before = scene.violation(None)?;
    let up = scene.upwards();
    let across = scene.across(&up)?;
    let compose = |across: &[Vector2<f64>], up: &[Vector1<f64>], scale: f64| -> Vec<Vector3<f64>> {
        across.iter().zip(up).map(|(across, up)| scene.ground.raise(across, up.x) * scale).collect()
    };
    let (mut shift, mut acceleration) = (
        compose(&across.path.place, &up.path.place, 1.0),
        compose(&across.path.second, &up.path.second, rate * rate),
    );
    let differences = compose(&across.path.first, &up.path.first, rate);
    let mut velocity: Vec<_> =
        differences.iter().zip(&acceleration).map(|(e, a)| e + a * (0.5 / rate)).collect();
    let (mut furthest, mut greatest) = (0, 0.0);
    for (frame, shift) in shift.iter().enumerate() {
        if shift.norm() > greatest {
            (furthest, greatest) = (frame, shift.norm());
        }
    }
    let by = greatest - options.limit;
    if by > YIELD + options.tolerance {
        let part = options.limit / greatest;
        for way in [&mut shift, &mut velocity, &mut acceleration] {
            for frame in way.iter_mut() {
                *frame *= part;
            }
        }
        greatest = options.limit;
    }
    let after = scene.violation(Some([&shift, &acceleration]))?;
    let rms = (shift.iter().map(Vector3::norm_squared).sum::<f64>() / shift.len() as f64).sqrt();
    let outcome = match (up.converged && across.converged, by > YIELD + options.tolerance) {
        (false, _) => ConsistencyOutcome::Unsettled,
        (true, true) => ConsistencyOutcome::Short { frame: furthest, by },
        (true, false) => ConsistencyOutcome::Reached,
    };
    let iterations = up.iterations + across.iterations;
    Ok(Consistency { shift, velocity, acceleration, greatest, rms, before, after, iterations, outcome })
}

fn check_numbers(
    positive: &[(&'static str, f64)],
    level: f64,
    options: &ConsistencyOptions,
) -> Result<(), ConsistencyError> {
    let ConsistencyOptions { limit, margin, least_force, smoothing, tolerance, iterations: _ } = *options;
    let over = "finite and above 0";
    let above = |x: f64| x > 0.0 && x.is_finite();
    let own = [
        ("the level", level, level.is_finite(), "finite"),
        ("the limit", limit, limit > 0.0, "above 0, or infinite for none"),
        ("the margin", margin, margin >= 0.0 && margin.is_finite(), "finite and not below 0"),
        ("the least force", least_force, least_force > 0.0 && least_force <= 1.0, "above 0 and at most 1"),
        ("the smoothing", smoothing, above(smoothing), over),
        ("the tolerance", tolerance, above(tolerance), over),
    ];
    let given = positive.iter().map(|&(what, value)| (what, value, above(value), over));
    match given.chain(own).find(|(_, _, right, _)| !right) {
        Some((what, value, _, needed)) => Err(ConsistencyError::Number { what, value, needed }),
        None => Ok(()),
    }
}

fn check_frames(frames: &[BalanceFrame], outlines: &[Vec<Vector3<f64>>]) -> Result<(), ConsistencyError> {
    if frames.len() < 3 {
        return Err(ConsistencyError::TooShort { frames: frames.len() });
    }
    if outlines.len() != frames.len() {
        return Err(ConsistencyError::Length { frames: frames.len(), outlines: outlines.len() });
    }
    if outlines.iter().all(Vec::is_empty) {
        return Err(ConsistencyError::NothingStands);
    }
    for (frame, (balance, outline)) in frames.iter().zip(outlines).enumerate() {
        let whole = |v: &Vector3<f64>| v.iter().all(|x| x.is_finite());
        let parts = [
            ("the force", balance.force),
            ("the moment", balance.moment),
            ("the centre of mass", balance.com),
        ];
        let bad = parts.iter().find(|(_, v)| !whole(v)).map(|(what, _)| *what);
        if let Some(what) = bad.or((!outline.iter().all(whole)).then_some("the outline")) {
            return Err(ConsistencyError::NotFinite { frame, what });
        }
    }
    Ok(())
}
