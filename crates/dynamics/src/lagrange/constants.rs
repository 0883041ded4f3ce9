//! The constants of a figure in Denavit-Hartenberg frames.

use super::products::{Full, Products, Short};
use crate::denavit_hartenberg::{Base, Carried, DenavitHartenberg, Rationalized, exact_sin_cos};
use crate::error::DynamicsError;
use crate::scalar::Scalar;
use crate::tree::Tree;
use crate::tree::mass_distribution::constant;
use nalgebra::{IsometryMatrix3, Matrix3, Matrix4, Vector3};
use solaris_model::Figure;
use std::marker::PhantomData;

/// A figure under a gravity, compiled for the Lagrangian recursions: constant, shared between any number of
/// [`super::LagrangianWorkspace`]s.
#[derive(Clone, Debug)]
pub struct Lagrangian<T, P = Short> {
    /// Names, sizes, and what is checked of a state.
    pub(super) tree: Tree<T>,
    /// The rationalised links; number k is moved by degree of freedom k.
    pub(super) links: Vec<Link<T>>,
    /// By link of the figure, the rationalised link that carries it; `None` where nothing moves it.
    pub(super) carriers: Vec<Option<usize>>,
    pub(super) chains: Vec<Chain>,
    products: PhantomData<P>,
}

/// The constants of one rationalised link.
#[derive(Clone, Debug)]
pub(super) struct Link<T> {
    pub(super) parent: Option<usize>,
    /// Index of its coordinate in `q`; `None` for one that stays at zero.
    pub(super) coordinate: Option<usize>,
    pub(super) slides: bool,
    /// The first column of `∂W/∂q` that is not zero: the last one for a slide.
    pub(super) first_column: usize,
    pub(super) base: LinkBase<T>,
    pub(super) sine_alpha: T,
    pub(super) cosine_alpha: T,
    /// sin θ⁰ and cos θ⁰; `None` for θ⁰ = 0.
    pub(super) theta: Option<(T, T)>,
    /// a (m).
    pub(super) a: T,
    /// s⁰ (m).
    pub(super) s: T,
    /// The pseudo-inertia of all that it carries; `None` for a link without mass.
    pub(super) inertia: Option<Matrix4<T>>,
}

/// The constant or moving part before the axis.
#[derive(Clone, Debug)]
pub(super) enum LinkBase<T> {
    None,
    Constant(Matrix4<T>),
    /// `before · X(q) · after`, with `X` the motion of a ball or free joint.
    Moved {
        slot: usize,
        before: Matrix4<T>,
        after: Matrix4<T>,
    },
}

/// A way from the root to an end-effector.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    /// Rationalised links from the root outwards.
    pub(super) links: Vec<usize>,
    /// Those from here on are in no chain before this one: their masses are counted here.
    pub(super) first_new: usize,
}

impl<T: Scalar> Lagrangian<T> {
    /// Compiles `figure` under the acceleration of `gravity` (m/s², world axes).
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Constant`] where gravity is not finite or a constant of the figure is beyond the range of `T`;
    /// [`DynamicsError::Joint`] for a kind of joint that the recursions do not know.
    pub fn new(figure: &Figure, gravity: Vector3<f64>) -> Result<Self, DynamicsError> {
        let tree = Tree::new(figure, gravity)?;
        let frames = DenavitHartenberg::of(figure)?;
        let links = frames.links.iter().map(|link| compile(figure, &tree, link));
        let links = links.collect::<Result<Vec<_>, _>>()?;
        let mut carriers = vec![None; figure.links().len()];
        for (k, link) in frames.links.iter().enumerate() {
            for carried in &link.carried {
                carriers[carried.link] = Some(k);
            }
        }
        let chains = chains(&links);
        Ok(Self { tree, links, carriers, chains, products: PhantomData })
    }

    /// The same with [`Full`] products, to count what they cost.
    pub fn with_full_products(self) -> Lagrangian<T, Full> {
        let Self { tree, links, carriers, chains, .. } = self;
        Lagrangian { tree, links, carriers, chains, products: PhantomData }
    }
}

impl<T: Scalar, P: Products> Lagrangian<T, P> {
    /// Length of `q`.
    pub fn nq(&self) -> usize {
        self.tree.nq()
    }

    /// Length of `v`, `a` and `tau`, and number of rationalised links.
    pub fn nv(&self) -> usize {
        self.tree.nv()
    }

    /// Number of rationalised links of each chain, one chain for each rationalised link that no other follows.
    pub fn chain_lengths(&self) -> impl ExactSizeIterator<Item = usize> {
        self.chains.iter().map(|chain| chain.links.len())
    }
}

fn compile<T: Scalar>(
    figure: &Figure,
    tree: &Tree<T>,
    link: &Rationalized,
) -> Result<Link<T>, DynamicsError> {
    let joint = figure.links()[link.joint].joint().name();
    let pair = |(sine, cosine): (f64, f64)| (T::from_f64(sine), T::from_f64(cosine));
    let (sine_alpha, cosine_alpha) = pair(exact_sin_cos(link.alpha));
    let matrix = |placement: &IsometryMatrix3<f64>| {
        finite("the placement of joint ", joint, &placement.to_homogeneous())
    };
    let base = match &link.base {
        Base::Identity => LinkBase::None,
        Base::Constant(placement) => LinkBase::Constant(matrix(placement)?),
        Base::Moved { before, quaternion, after, .. } => {
            let slot = tree.spheres.iter().position(|sphere| sphere.quaternion == *quaternion);
            let slot = slot.ok_or_else(|| DynamicsError::Joint { joint: joint.to_owned() })?;
            LinkBase::Moved { slot, before: matrix(before)?, after: matrix(after)? }
        }
    };
    let is_heavy = |link: &solaris_model::Link| link.mass() > 0.0 || link.inertia().amax() > 0.0;
    let heavy = link.carried.iter().filter(|carried| is_heavy(&figure.links()[carried.link]));
    let inertia = heavy.map(|carried| pseudo_inertia(figure, carried)).reduce(|sum, j| sum + j);
    Ok(Link {
        parent: link.parent,
        coordinate: link.coordinate,
        slides: link.slides,
        first_column: if link.slides { 3 } else { 0 },
        base,
        sine_alpha,
        cosine_alpha,
        theta: (link.theta.abs() > 0.0).then(|| pair(exact_sin_cos(link.theta))),
        a: constant("a of joint ", joint, link.a)?,
        s: constant("s of joint ", joint, link.s)?,
        inertia: inertia.map(|j| finite("the inertia of joint ", joint, &j)).transpose()?,
    })
}

/// The pseudo-inertia of a link of the figure in the frame that carries it:
///
/// ```text
/// J = ∫ (r 1)ᵀ·(r 1) dm = | ½·tr(I)·1 − I + m·c·cᵀ   m·c |
///                         |         m·cᵀ              m  |
/// ```
///
/// with the centre of mass `c` and the inertia `I` about it.
///
/// # Source
///
/// Vasilonikolidakis (1991), §3.7, with slip 10 of the table in `docs/sources.md` put right.
fn pseudo_inertia(figure: &Figure, carried: &Carried) -> Matrix4<f64> {
    let link = &figure.links()[carried.link];
    let rotation = carried.placement.rotation.matrix();
    let inertia = rotation * link.inertia() * rotation.transpose();
    let (m, c) = (link.mass(), (carried.placement * nalgebra::Point3::from(*link.com())).coords);
    let second = Matrix3::identity() * (inertia.trace() / 2.0) - inertia + c * c.transpose() * m;
    let mut j = Matrix4::zeros();
    j.fixed_view_mut::<3, 3>(0, 0).copy_from(&((second + second.transpose()) / 2.0));
    j.fixed_view_mut::<3, 1>(0, 3).copy_from(&(c * m));
    j.fixed_view_mut::<1, 3>(3, 0).copy_from(&(c * m).transpose());
    j.m44 = m;
    j
}

fn finite<T: Scalar>(what: &str, name: &str, matrix: &Matrix4<f64>) -> Result<Matrix4<T>, DynamicsError> {
    for x in matrix.iter() {
        constant::<T>(what, name, *x)?;
    }
    Ok(matrix.map(T::from_f64))
}

/// One chain for each rationalised link that no other follows, in the order of these links.
fn chains<T>(links: &[Link<T>]) -> Vec<Chain> {
    let mut followed = vec![false; links.len()];
    links.iter().filter_map(|link| link.parent).for_each(|parent| followed[parent] = true);
    let mut seen = vec![false; links.len()];
    let ends = (0..links.len()).filter(|k| !followed[*k]);
    ends.map(|end| {
        let mut way: Vec<usize> = std::iter::successors(Some(end), |k| links[*k].parent).collect();
        way.reverse();
        let first_new = way.iter().take_while(|k| seen[**k]).count();
        for k in &way {
            seen[*k] = true;
        }
        Chain { links: way, first_new }
    })
    .collect()
}
