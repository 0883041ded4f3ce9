//! Inverse dynamics in the formulation that the caller chooses.

use crate::error::DynamicsError;
use crate::inverse::inverse_dynamics;
use crate::lagrange::{Lagrangian, LagrangianWorkspace, chain_wise, tree_wise};
use crate::scalar::Scalar;
use crate::spatial::Wrench;
use crate::tree::Tree;
use crate::workspace::Workspace;
use nalgebra::Vector3;
use solaris_model::Figure;

/// A formulation of inverse dynamics: how the generalized forces of a motion are found. The answers are the same to rounding; the costs are not (see
/// `docs/operations.md`).
#[doc(alias = "Newton-Euler")]
#[doc(alias = "Lagrange")]
#[doc(alias = "rnea")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Formulation {
    /// The thesis's recursion of 4×4 matrices over every chain from the root to an end-effector:
    /// [`chain_wise`].
    ChainWise,
    /// The same with every quantity computed once over the tree: [`tree_wise`].
    TreeWise,
    /// Newton and Euler's equations in the links' own frames, the fastest: [`inverse_dynamics`].
    NewtonEuler,
}

impl Formulation {
    /// All of them, the slowest first.
    pub const ALL: [Self; 3] = [Self::ChainWise, Self::TreeWise, Self::NewtonEuler];
}

/// Inverse dynamics of one figure in the formulation that the caller chose, with the scratch memory it takes.
///
/// Each thread needs one of its own. Where several operations are asked of one figure, [`Tree`] and [`Workspace`] serve
/// them all.
///
/// # Examples
///
/// ```
/// use solaris_dynamics::{Formulation, InverseDynamics};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0));
/// let figure = FigureBuilder::new("pendulum").link(bob).build()?;
/// for formulation in Formulation::ALL {
///     let mut dynamics = InverseDynamics::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0), formulation)?;
///     let mut tau = [0.0];
///     dynamics.solve(&[-std::f64::consts::FRAC_PI_2], &[0.0], &[0.0], &[], &mut tau)?;
///     assert!((tau[0] - -9.81).abs() < 1e-12); // 2 kg · 9.81 m/s² · 0.5 m
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "rnea")]
#[derive(Clone, Debug)]
pub struct InverseDynamics<T> {
    formulation: Formulation,
    kernel: Kernel<T>,
}

#[derive(Clone, Debug)]
enum Kernel<T> {
    Lagrangian(Box<(Lagrangian<T>, LagrangianWorkspace<T>)>),
    NewtonEuler(Box<(Tree<T>, Workspace<T>)>),
}

impl<T: Scalar> InverseDynamics<T> {
    /// Compiles `figure` under the acceleration of `gravity` (m/s², world axes) for a `formulation`.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Constant`] where gravity is not finite or a constant of the figure is beyond the range of `T`;
    /// [`DynamicsError::Joint`] for a kind of joint that the recursions do not know.
    pub fn new(
        figure: &Figure,
        gravity: Vector3<f64>,
        formulation: Formulation,
    ) -> Result<Self, DynamicsError> {
        let kernel = match formulation {
            Formulation::ChainWise | Formulation::TreeWise => {
                let lagrangian = Lagrangian::new(figure, gravity)?;
                let workspace = LagrangianWorkspace::new(&lagrangian);
                Kernel::Lagrangian(Box::new((lagrangian, workspace)))
            }
            Formulation::NewtonEuler => {
                let tree = Tree::new(figure, gravity)?;
                let workspace = Workspace::new(&tree);
                Kernel::NewtonEuler(Box::new((tree, workspace)))
            }
        };
        Ok(Self { formulation, kernel })
    }

    /// The formulation chosen.
    pub fn formulation(&self) -> Formulation {
        self.formulation
    }

    /// The generalized forces `tau` (N m or N) that move the figure with accelerations `a` through the state `q`, `v`.
    ///
    /// `q` (rad, m) has length `nq`; `v`, `a` (per s, per s²) and `tau` length `nv`. `external` lists link index and wrench
    /// on the link, in world axes about the world's origin.
    ///
    /// # Errors
    ///
    /// As for [`inverse_dynamics`], in every formulation.
    pub fn solve(
        &mut self,
        q: &[T],
        v: &[T],
        a: &[T],
        external: &[(usize, Wrench<T>)],
        tau: &mut [T],
    ) -> Result<(), DynamicsError> {
        match &mut self.kernel {
            Kernel::NewtonEuler(kernel) => {
                let (tree, workspace) = &mut **kernel;
                inverse_dynamics(tree, workspace, q, v, a, external, tau)
            }
            Kernel::Lagrangian(kernel) => {
                let (lagrangian, workspace) = &mut **kernel;
                if self.formulation == Formulation::ChainWise {
                    chain_wise(lagrangian, workspace, q, v, a, external, tau)
                } else {
                    tree_wise(lagrangian, workspace, q, v, a, external, tau)
                }
            }
        }
    }
}
