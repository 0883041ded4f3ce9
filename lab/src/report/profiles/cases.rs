//! The cases that are measured, and what is claimed of them.

use super::accuracy::{self, Accuracy};
use super::family::{
    Circle, Exponential, ExponentialFade, ExponentialVelocities, HyperbolicVelocities, QuarterEllipse, Sine,
    SinhFade, Trigonometric, TrigonometricVelocities,
};
use super::reference::Reference;
use super::speed::{self, Speed};

/// A kind of curve.
pub(super) struct Kind {
    pub(super) name: &'static str,
    /// The library's form.
    pub(super) stable: &'static str,
    /// The name of a case where the printed form has nothing to lose.
    pub(super) ordinary: &'static str,
    pub(super) accuracy: fn(&Reference, &str) -> Result<Accuracy, String>,
    pub(super) speed: fn(&Reference, &str) -> Result<Speed, String>,
}

macro_rules! kind {
    ($family:ident, $name:literal, $stable:literal, $ordinary:literal) => {
        Kind {
            name: $name,
            stable: $stable,
            ordinary: $ordinary,
            accuracy: accuracy::measure::<$family>,
            speed: speed::measure::<$family>,
        }
    };
}

pub(super) const KINDS: [Kind; 10] = [
    kind!(Trigonometric, "trigonometric", "displacement::Trigonometric", "trigonometric, 1 → 4"),
    kind!(
        TrigonometricVelocities,
        "trigonometric with velocities",
        "displacement::TrigonometricVelocities",
        "trigonometric with velocities, 1 → 4, v = 1.5, 0.5"
    ),
    kind!(Exponential, "exponential", "displacement::Exponential", "exponential, n = 5, s = −2"),
    kind!(
        ExponentialVelocities,
        "exponential with velocities",
        "displacement::ExponentialVelocities",
        "exponential with velocities, n = 5, s = −2"
    ),
    kind!(
        HyperbolicVelocities,
        "hyperbolic with velocities",
        "displacement::Tension",
        "hyperbolic with velocities, T = 2"
    ),
    kind!(Sine, "sine", "acceleration::Trigonometric", "sine, aₘ = 2"),
    kind!(QuarterEllipse, "quarter ellipse", "acceleration::Ellipse", "quarter ellipse, aₘ = 2"),
    kind!(Circle, "circle", "velocity::Circle", "circle, T₁ = 0.4"),
    kind!(SinhFade, "fade by sinh", "blend::Fade", "fade by sinh, 0 to 1 s"),
    kind!(ExponentialFade, "fade by exponentials", "blend::Fade", "fade by exponentials, 0 to 0.5 s"),
];

/// A case in which the printed form is known to lose digits.
#[cfg_attr(not(test), expect(dead_code, reason = "claims are what the tests hold"))]
pub(super) struct Case {
    pub(super) name: &'static str,
    /// What the printed form is known to lose, in f64 and in f32; zero where nothing is said.
    pub(super) printed: [f64; 2],
    /// What the library's form loses at most.
    pub(super) stable: [f64; 2],
}

const fn case(name: &'static str, printed: [f64; 2], stable: [f64; 2]) -> Case {
    Case { name, printed, stable }
}

/// Where a form gives no number.
const FAILS: f64 = f64::INFINITY;

/// A last digit or two of the largest value.
const SPAN: [f64; 2] = [2.0 * f64::EPSILON, 2.0 * f32::EPSILON as f64];

/// The same of the way itself, near rest: it goes with the third power of a time that is rounded.
const REST: [f64; 2] = [4.0 * f64::EPSILON, 4.0 * f32::EPSILON as f64];

/// A polynomial of high degree.
const HIGH: [f64; 2] = [6e-15, 1.4e-6];

#[rustfmt::skip]
pub(super) const HARD: [Case; 47] = [
    case("trigonometric, u = 1e-3", [0.0, 2.5e-3], REST),
    case("trigonometric, u = 1e-4", [8.0e-10, 0.0], REST),
    case("trigonometric, u = 1e-8", [0.10, 1.0], REST),
    case("trigonometric, 5 → 0", [FAILS, FAILS], SPAN),
    case("trigonometric, 5 → 1e-310", [FAILS, 0.0], SPAN),
    case("trigonometric with velocities, v₀ − v₁ = 1e-6", [5.0e-11, 1.3e-2], SPAN),
    case("trigonometric with velocities, v₀ − v₁ = 1e-10", [1.0e-7, 0.0], SPAN),
    case("trigonometric with velocities, v₀ − v₁ = 1e-14", [4.0e-3, 0.0], SPAN),
    case("trigonometric with velocities, v₀ − v₁ = 0", [0.12, 0.12], SPAN),
    case("exponential, n = 5, s = 1e-4", [9.0e-13, 4.0e-4], SPAN),
    case("exponential, n = 5, s = 1e-8", [6.0e-9, FAILS], SPAN),
    case("exponential, n = 5, s = 1e-12", [8.0e-5, FAILS], SPAN),
    case("exponential, n = 100, T = 1e-3", [FAILS, FAILS], SPAN),
    case("exponential, n = 60, T = 1e6", [FAILS, FAILS], SPAN),
    case("exponential, n = 60, T = 1e-6", [FAILS, FAILS], SPAN),
    case("exponential with velocities, n = 5, s = 0.01", [5.0e-10, 0.17], SPAN),
    case("exponential with velocities, n = 5, s = 1e-4", [4.5e-4, 2.1], SPAN),
    case("exponential with velocities, n = 20, s = −0.5", [1.0e-13, 0.0], HIGH),
    case("exponential with velocities, n = 30, s = −0.5", [2.0e-13, 0.0], HIGH),
    case("exponential with velocities, n = 40, s = −0.5", [1.4e-12, 3.0e-4], HIGH),
    case("hyperbolic with velocities, T = 0.9999", [1.0e-12, 0.0], SPAN),
    case("hyperbolic with velocities, T = 1.0001", [1.0e-12, 4.0e-4], SPAN),
    case("hyperbolic with velocities, T = 1 − 1e-8", [6.0e-9, 0.0], SPAN),
    case("hyperbolic with velocities, T = 1", [FAILS, FAILS], SPAN),
    case("hyperbolic with velocities, T = 2.82718175", [2.0e-7, 0.0], SPAN),
    case("hyperbolic with velocities, T = 90", [0.0, FAILS], SPAN),
    case("hyperbolic with velocities, T = 720", [FAILS, FAILS], SPAN),
    case("hyperbolic with velocities, T = 1e4", [FAILS, FAILS], SPAN),
    case("hyperbolic with velocities, T = 1e-8", [0.0, 0.0], SPAN),
    case("sine, u = 1e-2", [7.0e-13, 9.0e-5], REST),
    case("sine, u = 1e-5", [3.0e-7, 1.0], REST),
    case("quarter ellipse, u = 1e-2", [2.0e-11, 1.3e-2], REST),
    case("quarter ellipse, u = 1e-4", [1.7e-6, 1.0], REST),
    case("quarter ellipse, u = 1e-6", [0.27, 1.0], REST),
    case("circle, T₁ = 0.5 − 1e-3", [0.0, 1.2e-3], SPAN),
    case("circle, T₁ = 0.5 − 1e-4", [3.0e-10, 0.0], SPAN),
    case("circle, T₁ = 0.5 − 1e-6", [6.0e-6, 1.0], SPAN),
    case("circle, T₁ = 0.5 − 1e-8", [0.14, 0.0], SPAN),
    case("circle, T₁ = 0.5 − 1e-12", [1.0e7, 0.0], SPAN),
    case("circle, T₁ = 0.5", [FAILS, FAILS], SPAN),
    case("fade by sinh, 5 to 6 s", [2.0e-13, 0.0], SPAN),
    case("fade by sinh, 10 to 11 s", [9.0e-10, 1.0], SPAN),
    case("fade by sinh, 20 to 21 s", [0.44, 1.0], SPAN),
    case("fade by sinh, 360 to 361 s", [FAILS, FAILS], SPAN),
    case("fade by exponentials, 45 to 46 s", [0.0, FAILS], SPAN),
    case("fade by exponentials, 360 to 361 s", [FAILS, FAILS], SPAN),
    case("fade by exponentials, 0 to 1e-6 s", [9.0e-11, 0.06], SPAN),
];

impl Case {
    /// What kind of curve it is of: the one whose name its own begins with.
    pub(super) fn kind(&self) -> &'static Kind {
        let begins =
            |kind: &&Kind| self.name.strip_prefix(kind.name).is_some_and(|rest| rest.starts_with(','));
        KINDS.iter().find(begins).expect("every case is of a kind")
    }
}

/// A line over 40 ms, so long after the beginning of time.
pub(super) const CLIPS: [&str; 4] = ["clip at 0 s", "clip at 10 s", "clip at 1e3 s", "clip at 1e5 s"];
