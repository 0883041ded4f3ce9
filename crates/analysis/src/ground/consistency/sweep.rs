//! One Newton step of a path of least squares: a sweep back over its frames, and one forth.

use nalgebra::{SMatrix, SVector};

/// A path by frames: places, their differences `e_k = δ_k − δ_{k−1}` and second differences `a_k = e_{k+1} − e_k`.
///
/// All three have one entry a frame, so a path of n frames is known one frame beyond either end.
#[derive(Clone, Debug)]
pub(super) struct Path<const D: usize> {
    pub(super) place: Vec<SVector<f64, D>>,
    pub(super) first: Vec<SVector<f64, D>>,
    pub(super) second: Vec<SVector<f64, D>>,
}

impl<const D: usize> Path<D> {
    /// A path that stays at zero.
    pub(super) fn still(frames: usize) -> Self {
        let zeros = vec![SVector::zeros(); frames];
        Self { place: zeros.clone(), first: zeros.clone(), second: zeros }
    }

    /// Goes on by `step` times `way`.
    pub(super) fn advance(&mut self, step: f64, way: &Self) {
        let parts =
            [(&mut self.place, &way.place), (&mut self.first, &way.first), (&mut self.second, &way.second)];
        for (to, by) in parts {
            to.iter_mut().zip(by).for_each(|(to, by)| *to += by * step);
        }
    }
}

/// What a frame of the path costs: `½ δᵀQδ + qᵀδ + ½ aᵀRa + rᵀa`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cost<const D: usize> {
    pub(super) place: SMatrix<f64, D, D>,
    pub(super) place_pull: SVector<f64, D>,
    pub(super) second: SMatrix<f64, D, D>,
    pub(super) second_pull: SVector<f64, D>,
}

/// The path of least cost, for given `Q` and `R`.
///
/// What frames k, k+1, … cost at least is a quadratic function of the state `(δ_k, e_k)`. From that of frame k+1, with its
/// matrices `P` written for `(δ_k, e_{k+1})`,
///
/// ```text
/// M_d = P_d     M_c = P_c + P_d     M_e = P_e + P_c + P_cᵀ + P_d     (δ_{k+1} = δ_k + e_{k+1})
/// a = −G⁻¹ (r + m_e + M_cᵀ δ + M_e e)     G = R + M_e                (e_{k+1} = e_k + a_k)
/// P_d = Q + M_d − M_c G⁻¹ M_cᵀ     P_c = M_c − M_c G⁻¹ M_e     P_e = M_e − M_e G⁻¹ M_e
/// ```
///
/// (the Riccati recursion). Its numbers stay of the size of the curve that they describe; the normal equations of second
/// differences lose the fourth power of the number of frames. The first state is free: it is the least of what frame 0
/// costs.
#[derive(Clone, Debug)]
pub(super) struct Sweep<const D: usize> {
    /// Of each frame `G⁻¹`, `G⁻¹ M_cᵀ` and `G⁻¹ M_e`.
    gains: Vec<[SMatrix<f64, D, D>; 3]>,
    /// Of each frame `G⁻¹ (r + m_e)`.
    offsets: Vec<SVector<f64, D>>,
    /// Of the first state: `P_e⁻¹`, `P_e⁻¹ P_cᵀ` and `(P_d − P_c P_e⁻¹ P_cᵀ)⁻¹`.
    start: [SMatrix<f64, D, D>; 3],
}

impl<const D: usize> Sweep<D> {
    /// Scratch memory.
    pub(super) fn new() -> Self {
        Self { gains: vec![], offsets: vec![], start: [SMatrix::zeros(); 3] }
    }

    /// Works out the gains; `None` where the costs have no least value.
    pub(super) fn factor(&mut self, costs: &[Cost<D>]) -> Option<()> {
        let zero = SMatrix::<f64, D, D>::zeros();
        self.gains.clear();
        self.gains.resize(costs.len(), [zero; 3]);
        let [mut place, mut cross, mut first] = [zero; 3];
        for (cost, gains) in costs.iter().zip(&mut self.gains).rev() {
            let m_first = symmetric(first + cross + cross.transpose() + place);
            let m_cross = cross + place;
            let inverse = (cost.second + m_first).cholesky()?.inverse();
            *gains = [inverse, inverse * m_cross.transpose(), inverse * m_first];
            place = symmetric(cost.place + place - m_cross * gains[1]);
            cross = m_cross - m_cross * gains[2];
            first = symmetric(m_first - m_first * gains[2]);
        }
        let inverse = first.cholesky()?.inverse();
        let carried = inverse * cross.transpose();
        self.start = [inverse, carried, symmetric(place - cross * carried).cholesky()?.inverse()];
        Some(())
    }

    /// The path of least cost, written to `path`; the matrices of `costs` are those that were factored.
    pub(super) fn solve(&mut self, costs: &[Cost<D>], path: &mut Path<D>) {
        self.offsets.clear();
        self.offsets.resize(costs.len(), SVector::zeros());
        let [mut place, mut first] = [SVector::<f64, D>::zeros(); 2];
        for ((cost, [inverse, by_place, by_first]), offset) in
            costs.iter().zip(&self.gains).zip(&mut self.offsets).rev()
        {
            let m_first = first + place;
            let pull = cost.second_pull + m_first;
            *offset = inverse * pull;
            place += cost.place_pull - by_place.transpose() * pull;
            first = m_first - by_first.transpose() * pull;
        }
        let [inverse, carried, rest] = &self.start;
        let mut delta = rest * (carried.transpose() * first - place);
        let mut e = -(inverse * first + carried * delta);
        for (k, ([_, by_place, by_first], offset)) in self.gains.iter().zip(&self.offsets).enumerate() {
            let a = -(offset + by_place * delta + by_first * e);
            path.place[k] = delta;
            path.first[k] = e;
            path.second[k] = a;
            e += a;
            delta += e;
        }
    }
}

fn symmetric<const D: usize>(matrix: SMatrix<f64, D, D>) -> SMatrix<f64, D, D> {
    (matrix + matrix.transpose()) * 0.5
}
