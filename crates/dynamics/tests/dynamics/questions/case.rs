//! A random figure in a random state, and differences along its motion.

use crate::support::Kernel;
use crate::support::random::{Joints, Random, random_configuration, tree_of};
use nalgebra::{DMatrix, Vector3};
use solaris_dynamics::{Frame, Wrench};
use solaris_model::Figure;

pub(crate) struct Case {
    pub(crate) figure: Figure,
    pub(crate) gravity: Vector3<f64>,
    pub(crate) kernel: Kernel<f64>,
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
    pub(crate) a: Vec<f64>,
    pub(crate) external: Vec<(usize, Wrench<f64>)>,
    pub(crate) random: Random,
}

impl Case {
    /// A tree with joints of every kind.
    pub(crate) fn random(seed: u64) -> Self {
        Self::with(Joints::Every, seed)
    }

    pub(crate) fn with(joints: Joints, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let links = 1 + random.below(8);
        let figure = tree_of(joints, &mut random, links, 0.5);
        let gravity = random.vector(10.0);
        Self::of(figure, gravity, random)
    }

    pub(crate) fn of(figure: Figure, gravity: Vector3<f64>, mut random: Random) -> Self {
        let n = figure.layout().nv();
        let q = random_configuration(&mut random, &figure);
        let (v, a) = (random.slice(n, 2.0), random.slice(n, 5.0));
        let links = figure.links().len();
        let external = vec![random.wrench(links), random.wrench(links)];
        Self { kernel: Kernel::new(&figure, gravity), figure, gravity, q, v, a, external, random }
    }

    pub(crate) fn nv(&self) -> usize {
        self.v.len()
    }

    /// The configuration a `step` of time away along `rates`.
    pub(crate) fn moved(&self, rates: &[f64], time: f64) -> Vec<f64> {
        let step: Vec<f64> = rates.iter().map(|rate| rate * time).collect();
        let mut q = vec![0.0; self.q.len()];
        self.figure.integrate(&self.q, &step, &mut q).expect("a valid step");
        q
    }

    /// Configuration and velocity a time `t` later, with constant `a`.
    pub(crate) fn after(&self, t: f64) -> (Vec<f64>, Vec<f64>) {
        let mean: Vec<f64> = self.v.iter().zip(&self.a).map(|(v, a)| v + a * t / 2.0).collect();
        (self.moved(&mean, t), self.v.iter().zip(&self.a).map(|(v, a)| v + a * t).collect())
    }

    /// Any frame of any link.
    pub(crate) fn frame(&mut self) -> Frame<f64> {
        let link = self.random.below(self.figure.links().len());
        Frame::named(&self.figure, &format!("f{link}")).expect("a frame of this name")
    }
}

/// The derivative of `f` at 0, with an error of `h⁶·f⁽⁷⁾/140`: what turns fast has large high derivatives.
pub(crate) fn derivative<V>(mut f: impl FnMut(f64) -> V) -> V
where
    V: std::ops::Sub<Output = V> + std::ops::Mul<f64, Output = V>,
{
    let h = 1e-3;
    let mut across = |k: f64| f(k * h) - f(-k * h);
    (across(1.0) * 45.0 - (across(2.0) * 9.0 - across(3.0))) * (1.0 / (60.0 * h))
}

/// The unit vector along entry `k`.
pub(crate) fn unit(n: usize, k: usize) -> Vec<f64> {
    (0..n).map(|i| if i == k { 1.0 } else { 0.0 }).collect()
}

/// The greatest difference between two matrices, relative to the largest entry of the second or to `least`.
pub(crate) fn difference<R: nalgebra::Dim, C: nalgebra::Dim, S, Z>(
    found: &nalgebra::Matrix<f64, R, C, S>,
    expected: &nalgebra::Matrix<f64, R, C, Z>,
    least: f64,
) -> f64
where
    S: nalgebra::RawStorage<f64, R, C>,
    Z: nalgebra::RawStorage<f64, R, C>,
{
    assert_eq!(found.shape(), expected.shape());
    let scale = expected.iter().fold(least, |scale, x| scale.max(x.abs()));
    let error = found.iter().zip(expected.iter()).fold(0.0_f64, |error, (a, b)| error.max((a - b).abs()));
    assert!(found.iter().all(|x| x.is_finite()), "not finite");
    error / scale
}

pub(crate) fn matrix(rows: usize, columns: usize) -> DMatrix<f64> {
    // Whatever is not written shows.
    DMatrix::from_element(rows, columns, f64::NAN)
}
