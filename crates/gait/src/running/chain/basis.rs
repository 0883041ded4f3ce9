//! The laws of a stance at one instant, and what their amplitudes are expected to be.

use crate::running::laws::TWIST;
use nalgebra::Vector3;

/// How many amplitudes a stance has at most: of the vertical force, of the fore-aft and the lateral one, of the way of the pressure.
pub(super) const LIFTS: usize = 2;
pub(super) const WAVES: usize = 5;
pub(super) const ROLLS: usize = 3;

/// A value and by how much it is expected to differ from it; an amplitude that does not differ at all is none, nor are those after it.
pub(super) type Expected = (f64, f64);

/// What amplitudes are expected to be.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Priors {
    pub(super) lifts: [Expected; LIFTS],
    pub(super) fore_aft: [Expected; WAVES],
    pub(super) lateral: [Expected; WAVES],
    pub(super) twist: [Expected; TWIST],
    pub(super) rolls: [Expected; ROLLS],
    pub(super) shift: Expected,
    /// Distance of the heel from the run's line (m).
    pub(super) aside: Expected,
}

/// The laws of a stance at one instant, in body weights but for what is said otherwise.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Basis {
    /// Vertical force without amplitude.
    pub(super) fixed: f64,
    pub(super) lifts: [f64; LIFTS],
    /// Fore-aft force of an impulse of 1 (1/s).
    pub(super) faster: f64,
    pub(super) fore_aft: [f64; WAVES],
    pub(super) lateral: [f64; WAVES],
    /// N m.
    pub(super) twist: [f64; TWIST],
    /// Centre of pressure from the heel over the foot's length, and what amplitudes add.
    pub(super) pressure: f64,
    pub(super) rolls: [f64; ROLLS],
    /// Part of the force that the other foot has, and vertical force that an amplitude brings to it.
    pub(super) other: f64,
    pub(super) shift: f64,
    /// As a walk is carried: horizontal force for a vertical one of 1 and free moment (N m) in the world, and how far to the outside of the
    /// foot's axis it presses (m).
    pub(super) towards: Vector3<f64>,
    pub(super) given_twist: f64,
    pub(super) outward: f64,
}
