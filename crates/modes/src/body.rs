//! A figure with everything that acts in it by itself: springs, dampers, limits, gravity.

use crate::element::{LimitLaw, PointSpring};
use crate::report::Energy;
use crate::trouble::SetupError;
use nalgebra::Vector3;
use solaris_dynamics::{DynamicsError, Real};
use solaris_model::Figure;
use solaris_profiles::Scalar;

/// A figure with everything that acts in it by itself, for one scalar: what the drives' forces come on top of.
///
/// Forces `tau` are those of the **drives**: springs, dampers, friction and limits of the joints, springs between points and gravity act
/// besides them.
#[derive(Clone, Debug)]
pub(crate) struct Body<T> {
    scalar: std::marker::PhantomData<T>,
}

impl<T: Real + Scalar> Body<T> {
    /// `springs` name links of `figure`; `limits` by degree of freedom.
    pub(crate) fn new(
        figure: &Figure,
        gravity: Vector3<f64>,
        springs: &[PointSpring],
        limits: &[LimitLaw],
    ) -> Result<Self, SetupError> {
        let _ = (figure, gravity, springs, limits);
        unimplemented!()
    }

    /// Hybrid dynamics: where `prescribed[k]`, `a[k]` is read and the drive's force `tau[k]` written, else the other way round.
    pub(crate) fn hybrid(
        &mut self,
        q: &[T],
        v: &[T],
        prescribed: &[bool],
        a: &mut [T],
        tau: &mut [T],
    ) -> Result<(), DynamicsError> {
        let _ = (q, v, prescribed, a, tau);
        unimplemented!()
    }

    /// The drives' forces of a motion.
    pub(crate) fn inverse(&mut self, q: &[T], v: &[T], a: &[T], tau: &mut [T]) -> Result<(), DynamicsError> {
        let _ = (q, v, a, tau);
        unimplemented!()
    }

    /// Impact: where `prescribed[k]`, the jump `jump[k]` of the velocity is read and the impulse `impulse[k]` written, else the
    /// other way round.
    pub(crate) fn impact(
        &mut self,
        q: &[T],
        prescribed: &[bool],
        jump: &mut [T],
        impulse: &mut [T],
    ) -> Result<(), DynamicsError> {
        let _ = (q, prescribed, jump, impulse);
        unimplemented!()
    }

    /// What dampers and friction take (W) in the state of the last call of [`hybrid`](Self::hybrid).
    pub(crate) fn heat(&self) -> T {
        unimplemented!()
    }

    /// The energy of a state.
    pub(crate) fn energy(&mut self, q: &[T], v: &[T]) -> Result<Energy, DynamicsError> {
        let _ = (q, v);
        unimplemented!()
    }
}
