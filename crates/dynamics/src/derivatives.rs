//! Derivatives: of inverse and forward dynamics in closed form, of any other operation by the same recursion over dual numbers.

use crate::error::DynamicsError;
use crate::forward::{forward_dynamics, inverse_mass_matrix};
use crate::inertia::columns::LANES;
use crate::inertia::inverse::{divide, invert};
use crate::inverse::inverse_dynamics;
use crate::inverse::slopes::Slopes;
use crate::scalar::{Dual, Scalar};
use crate::spatial::Wrench;
use crate::spatial::direction::quaternion_rotation;
use crate::tree::Tree;
use crate::wide::wide;
use crate::workspace::{Workspace, check, check_length, check_result};
use nalgebra::{DMatrix, Vector3};
use solaris_model::Figure;

/// An operation of the kernel that can be differentiated: `(tree, workspace, q, v, input, external, output)`.
///
/// [`inverse_dynamics`] is one, its input `a` and its output `tau`; [`forward_dynamics`] is another, with these two swapped.
pub type Operation<T> = fn(
    &Tree<T>,
    &mut Workspace<T>,
    &[T],
    &[T],
    &[T],
    &[(usize, Wrench<T>)],
    &mut [T],
) -> Result<(), DynamicsError>;

/// Finds derivatives of one figure's dynamics, exact to rounding: [`Derivatives::inverse_dynamics`] and
/// [`Derivatives::forward_dynamics`] in closed form, [`Derivatives::of`] and [`Derivatives::along`] over dual numbers, `N` directions in a pass.
///
/// It owns a [`Tree`] and a [`Workspace`] over [`Dual<N>`] and the results; after [`Derivatives::new`] nothing allocates
/// (but a list of more external wrenches than there are links, the first time). The default `N` suits whole matrices; for
/// [`Derivatives::along`], one direction, take `Derivatives::<1>::of_width`.
///
/// # Derivatives by a configuration
///
/// `∂/∂q` is along the tangent: column `k` answers to the step that a unit rate of `v_k` takes,
///
/// ```text
/// one axis  q̇ = e_k          ball  q̇ = ½ q ⊗ (e, 0)          free  ṗ = R·e,  q̇ = ½ q ⊗ (e, 0)
/// ```
///
/// so that every matrix is `nv` × `nv` and a step `q ⊕ δ` ([`Figure::integrate`]) changes the output by `by_q·δ`. External
/// wrenches are constants in world axes.
///
/// # Examples
///
/// A pendulum of 2 kg at half a metre, hanging: the slope of its torque by the angle is m·g·l, by the acceleration m·l².
///
/// ```
/// use solaris_dynamics::Derivatives;
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0));
/// let figure = FigureBuilder::new("pendulum").link(bob).build()?;
/// let mut derivatives = Derivatives::new(&figure, Vector3::new(0.0, -9.81, 0.0))?;
/// let partials = derivatives.inverse_dynamics(&[0.0], &[0.0], &[0.0], &[])?;
/// assert!((partials.by_q[(0, 0)] - 9.81).abs() < 1e-15 && (partials.by_input[(0, 0)] - 0.5).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "computeRNEADerivatives")]
#[doc(alias = "computeABADerivatives")]
#[doc(alias = "linearization")]
#[doc(alias = "sensitivity")]
#[doc(alias = "autodiff")]
#[derive(Clone, Debug)]
pub struct Derivatives<const N: usize = 4> {
    tree: Tree<Dual<N>>,
    workspace: Workspace<Dual<N>>,
    plain: Tree<f64>,
    plain_workspace: Workspace<f64>,
    q: Vec<Dual<N>>,
    v: Vec<Dual<N>>,
    input: Vec<Dual<N>>,
    output: Vec<Dual<N>>,
    external: Vec<(usize, Wrench<Dual<N>>)>,
    partials: Partials,
    /// Of inverse dynamics in closed form, and what they are written to: what is zero in every state stays so.
    slopes: Slopes<f64>,
    inverse: Partials,
    /// For each degree of freedom those that are before or behind it, and itself: the rest of its column is zero. All of them one
    /// after the other, and where each one's begin.
    related: Vec<usize>,
    starts: Vec<usize>,
}

/// An output of length `nv` with its derivatives, each `nv` × `nv`: row, entry of the output; column, direction.
#[doc(alias = "gradient")]
#[doc(alias = "linearization")]
#[derive(Clone, Debug, PartialEq)]
pub struct Partials<T = f64> {
    /// The output itself: `tau` of inverse dynamics, `a` of forward dynamics.
    pub value: Vec<T>,
    /// By the configuration, along the tangent.
    pub by_q: DMatrix<T>,
    /// By the velocity.
    pub by_v: DMatrix<T>,
    /// By the input: the acceleration of inverse dynamics (this is the mass matrix), the force of forward dynamics (its
    /// inverse).
    pub by_input: DMatrix<T>,
}

/// A direction to differentiate along: how fast each argument changes. Each slice has length `nv`.
#[derive(Clone, Copy, Debug)]
pub struct Along<'a> {
    /// Rate of the configuration, along the tangent.
    pub q: &'a [f64],
    /// Rate of the velocity.
    pub v: &'a [f64],
    /// Rate of the input.
    pub input: &'a [f64],
}

/// Which argument the columns of a pass belong to.
#[derive(Clone, Copy)]
enum Argument {
    Q,
    V,
    Input,
}

impl Derivatives {
    /// The derivatives of `figure`'s dynamics under the acceleration of `gravity` (m/s², world axes).
    ///
    /// # Errors
    ///
    /// As for [`Tree::new`].
    pub fn new(figure: &Figure, gravity: Vector3<f64>) -> Result<Self, DynamicsError> {
        Self::of_width(figure, gravity)
    }
}

impl<const N: usize> Derivatives<N> {
    /// As [`Derivatives::new`], with any number of directions in a pass.
    ///
    /// # Errors
    ///
    /// As for [`Tree::new`].
    pub fn of_width(figure: &Figure, gravity: Vector3<f64>) -> Result<Self, DynamicsError> {
        const { assert!(N > 0, "a pass needs a direction") }
        let (tree, plain) = (Tree::new(figure, gravity)?, Tree::new(figure, gravity)?);
        let (nq, nv, zero) = (tree.nq(), tree.nv(), Dual::constant(0.0));
        let (related, starts) = related(&plain);
        Ok(Self {
            workspace: Workspace::new(&tree),
            plain_workspace: Workspace::new(&plain),
            q: vec![zero; nq],
            v: vec![zero; nv],
            input: vec![zero; nv],
            output: vec![zero; nv],
            external: Vec::with_capacity(tree.link_count()),
            partials: Partials::new(vec![0.0; nv], nv),
            slopes: Slopes::new(&plain),
            related,
            starts,
            inverse: Partials::new(vec![0.0; nv], nv),
            plain,
            tree,
        })
    }

    /// The forces of [`inverse_dynamics`] and their derivatives by `q`, `v` and `a`, in closed form.
    ///
    /// # Errors
    ///
    /// As for [`inverse_dynamics`]; [`DynamicsError::Overflow`] too where only a derivative is beyond the precision.
    pub fn inverse_dynamics(
        &mut self,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        external: &[(usize, Wrench<f64>)],
    ) -> Result<&Partials, DynamicsError> {
        let Self { plain, plain_workspace: workspace, slopes, inverse, .. } = self;
        inverse_dynamics(plain, workspace, q, v, a, external, &mut inverse.value)?;
        slopes.find(plain, workspace, v, a, external, inverse)?;
        Ok(inverse)
    }

    /// The accelerations of [`forward_dynamics`] and their derivatives by `q`, `v` and `tau`: those of inverse dynamics at these
    /// accelerations, divided by the mass matrix, `∂a/∂q = −M⁻¹·∂τ/∂q`. Where the mass matrix is so near to singular that its factors lose
    /// nine digits, by dual numbers.
    ///
    /// # Errors
    ///
    /// As for [`forward_dynamics`]; [`DynamicsError::Overflow`] too where only a derivative is beyond the precision.
    pub fn forward_dynamics(
        &mut self,
        q: &[f64],
        v: &[f64],
        tau: &[f64],
        external: &[(usize, Wrench<f64>)],
    ) -> Result<&Partials, DynamicsError> {
        let Self { plain, plain_workspace: workspace, slopes, inverse, partials, .. } = self;
        forward_dynamics(plain, workspace, q, v, tau, external, &mut partials.value)?;
        slopes.find(plain, workspace, v, &partials.value, external, inverse)?;
        if invert(plain, workspace, q, &mut partials.by_input)? {
            return wide::<f64, _>(
                #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
                || self.divide(),
            );
        }
        self.sweep(&[Argument::Q, Argument::V], forward_dynamics, q, v, tau, external)?;
        inverse_mass_matrix(&self.plain, &mut self.plain_workspace, q, &mut self.partials.by_input)?;
        Ok(&self.partials)
    }

    /// `∂a/∂q = −M⁻¹·∂τ/∂q` and `∂a/∂v = −M⁻¹·∂τ/∂v`.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn divide(&mut self) -> Result<&Partials, DynamicsError> {
        let sum = if self.related.len() > MANY * self.plain.nv() { self.solve() } else { self.multiply() };
        if !sum.is_finite() {
            // An entry is not, or their sum alone.
            for of in [&self.partials.by_q, &self.partials.by_v] {
                check_result("a derivative of forward dynamics", of.as_slice())?;
            }
        }
        Ok(&self.partials)
    }

    /// The quotients by the recursion, each column for itself; the sum of all entries.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn solve(&mut self) -> f64 {
        let Self {
            plain: tree,
            plain_workspace: workspace,
            inverse,
            partials: Partials { by_q, by_v, .. },
            ..
        } = self;
        let mut sum = 0.0;
        for (slopes, to) in [(&inverse.by_q, by_q), (&inverse.by_v, by_v)] {
            sum += divide::<f64, LANES>(tree, workspace, slopes.as_slice(), to.as_mut_slice());
        }
        sum
    }

    /// The quotients as products with the inverse; the sum of all entries.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn multiply(&mut self) -> f64 {
        let n = self.plain.nv();
        let Partials { by_q, by_v, by_input, .. } = &mut self.partials;
        let by_input = by_input.as_slice();
        let mut sum = 0.0;
        for k in 0..n {
            let column = k * n..(k + 1) * n;
            let product = Product {
                matrix: by_input,
                rows: &self.related[self.starts[k]..self.starts[k + 1]],
                factors: [&self.inverse.by_q, &self.inverse.by_v].map(|of| &of.as_slice()[column.clone()]),
            };
            let mut to = [by_q.as_mut_slice(), by_v.as_mut_slice()].map(|to| &mut to[column.clone()]);
            let mut at = 0;
            while at < n {
                // The last entries come once more rather than alone.
                let most = n.saturating_sub(TILE);
                at = if n < TILE {
                    sum += product.negated::<1>(at, &mut to);
                    at + 1
                } else {
                    sum += product.negated::<TILE>(at.min(most), &mut to);
                    at + TILE
                };
            }
        }
        sum
    }

    /// The output of any `operation` and its derivatives by `q`, `v` and its input, all through dual numbers.
    ///
    /// # Errors
    ///
    /// Those of the operation.
    pub fn of(
        &mut self,
        operation: Operation<Dual<N>>,
        q: &[f64],
        v: &[f64],
        input: &[f64],
        external: &[(usize, Wrench<f64>)],
    ) -> Result<&Partials, DynamicsError> {
        self.sweep(&[Argument::Q, Argument::V, Argument::Input], operation, q, v, input, external)?;
        Ok(&self.partials)
    }

    /// Finds the output and its derivatives by `arguments`.
    fn sweep(
        &mut self,
        arguments: &[Argument],
        operation: Operation<Dual<N>>,
        q: &[f64],
        v: &[f64],
        input: &[f64],
        external: &[(usize, Wrench<f64>)],
    ) -> Result<(), DynamicsError> {
        self.set(q, v, input, external)?;
        let nv = self.tree.nv();
        if nv == 0 {
            // No column would ask whether the call is right.
            self.run(operation)?;
        }
        for &argument in arguments {
            for from in (0..nv).step_by(N) {
                let columns = from..nv.min(from + N);
                self.still(q, v, input);
                columns.clone().for_each(|k| self.seed(argument, k, k - from, 1.0));
                self.run(operation)?;
                for k in columns {
                    let matrix = self.partials.of(argument);
                    for (row, output) in self.output.iter().enumerate() {
                        matrix[(row, k)] = output.partial(k - from);
                    }
                }
            }
        }
        Ok(())
    }

    /// The output of any `operation`, written to `value`, and its derivative along one `direction`, written to `slope`; both
    /// of length `nv`.
    ///
    /// # Errors
    ///
    /// Those of the operation, and for a direction or result of the wrong length.
    #[expect(clippy::too_many_arguments, reason = "a state, a direction, and what comes of them")]
    pub fn along(
        &mut self,
        operation: Operation<Dual<N>>,
        q: &[f64],
        v: &[f64],
        input: &[f64],
        external: &[(usize, Wrench<f64>)],
        direction: &Along<'_>,
        value: &mut [f64],
        slope: &mut [f64],
    ) -> Result<(), DynamicsError> {
        self.set(q, v, input, external)?;
        let nv = self.tree.nv();
        check_length("value", value.len(), nv)?;
        check_length("slope", slope.len(), nv)?;
        self.still(q, v, input);
        let arguments = [
            (Argument::Q, "the direction of q", direction.q),
            (Argument::V, "the direction of v", direction.v),
            (Argument::Input, "the direction of the input", direction.input),
        ];
        for (argument, what, rates) in arguments {
            check(what, rates, nv, |index| self.tree.v_name(index))?;
            rates.iter().enumerate().for_each(|(k, rate)| self.seed(argument, k, 0, *rate));
        }
        self.run(operation)?;
        value.copy_from_slice(&self.partials.value);
        slope.iter_mut().zip(&self.output).for_each(|(slope, output)| *slope = output.partial(0));
        Ok(())
    }

    /// Checks the lengths of the arguments and takes the wrenches over.
    fn set(
        &mut self,
        q: &[f64],
        v: &[f64],
        input: &[f64],
        external: &[(usize, Wrench<f64>)],
    ) -> Result<(), DynamicsError> {
        check_length("q", q.len(), self.tree.nq())?;
        check_length("v", v.len(), self.tree.nv())?;
        check_length("the input", input.len(), self.tree.nv())?;
        self.external.clear();
        self.external.extend(external.iter().map(|(link, Wrench { force, moment })| {
            (*link, Wrench { force: force.map(Dual::constant), moment: moment.map(Dual::constant) })
        }));
        Ok(())
    }

    /// Sets the arguments, without any derivative.
    fn still(&mut self, q: &[f64], v: &[f64], input: &[f64]) {
        for (to, from) in [(&mut self.q, q), (&mut self.v, v), (&mut self.input, input)] {
            to.iter_mut().zip(from).for_each(|(to, from)| *to = Dual::constant(*from));
        }
    }

    /// Adds `rate` times the unit rate of entry `k` of an argument to its derivatives along direction `lane`.
    fn seed(&mut self, argument: Argument, k: usize, lane: usize, rate: f64) {
        match argument {
            Argument::Q => self.seed_position(k, lane, rate),
            Argument::V => add_partial(&mut self.v[k], lane, rate),
            Argument::Input => add_partial(&mut self.input[k], lane, rate),
        }
    }

    /// Moves the configuration along the tangent of degree of freedom `k`.
    fn seed_position(&mut self, k: usize, lane: usize, rate: f64) {
        let dof = &self.tree.dofs[k];
        let Some((sphere, index)) = self.tree.sphere_of(k) else {
            return add_partial(&mut self.q[dof.q], lane, rate);
        };
        let quaternion = [0, 1, 2, 3].map(|i| self.q[sphere.quaternion + i].value());
        let e = dof.axis.map(Dual::value);
        if let Some(position) = sphere.position.filter(|_| index < 3) {
            let squared = quaternion.iter().map(|x| x * x).sum();
            let way = quaternion_rotation(quaternion, squared) * e * rate;
            (0..3).for_each(|i| add_partial(&mut self.q[position + i], lane, way[i]));
        } else {
            // ½ (u, w) ⊗ (e, 0) = ½ (w·e + u × e, −u·e)
            let ([x, y, z, w], half) = (quaternion, rate / 2.0);
            let u = Vector3::new(x, y, z);
            let turn = e * w + u.cross(&e);
            let parts = [turn.x, turn.y, turn.z, -u.dot(&e)];
            (0..4).for_each(|i| add_partial(&mut self.q[sphere.quaternion + i], lane, parts[i] * half));
        }
    }

    /// One pass.
    fn run(&mut self, operation: Operation<Dual<N>>) -> Result<(), DynamicsError> {
        let Self { tree, workspace, q, v, input, external, output, partials, .. } = self;
        operation(tree, workspace, q, v, input, external, output)?;
        partials.value.iter_mut().zip(output).for_each(|(value, output)| *value = output.value());
        Ok(())
    }
}

impl<T: Scalar> Partials<T> {
    /// Room for a value and for derivatives by `nv` degrees of freedom, all of them zero.
    pub(crate) fn new(value: Vec<T>, nv: usize) -> Self {
        let zeros = || DMatrix::zeros(nv, nv);
        Self { value, by_q: zeros(), by_v: zeros(), by_input: zeros() }
    }

    fn of(&mut self, argument: Argument) -> &mut DMatrix<T> {
        match argument {
            Argument::Q => &mut self.by_q,
            Argument::V => &mut self.by_v,
            Argument::Input => &mut self.by_input,
        }
    }
}

/// For each degree of freedom those that are before or behind it on a path, and itself, one after the other; and where each one's
/// begin.
fn related(tree: &Tree<f64>) -> (Vec<usize>, Vec<usize>) {
    let n = tree.nv();
    let mut lists = vec![Vec::new(); n];
    for k in 0..n {
        lists[k].push(k);
        let mut next = tree.before[k];
        while let Some(i) = next {
            lists[k].push(i);
            lists[i].push(k);
            next = tree.before[i];
        }
    }
    let mut starts = vec![0];
    for list in &mut lists {
        list.sort_unstable();
        starts.push(starts[starts.len() - 1] + list.len());
    }
    (lists.concat(), starts)
}

fn add_partial<const N: usize>(number: &mut Dual<N>, lane: usize, rate: f64) {
    let mut partials = number.partials();
    partials[lane] += rate;
    *number = Dual::new(number.value(), partials);
}

/// Columns with more entries than this that are not zero are divided by the recursion rather than by a product: where both take as long.
const MANY: usize = 70;

/// How many entries of a product are summed in registers.
const TILE: usize = 8;

/// The product of a symmetric matrix with two columns that are zero but in some `rows`.
struct Product<'a> {
    matrix: &'a [f64],
    rows: &'a [usize],
    factors: [&'a [f64]; 2],
}

impl Product<'_> {
    /// Puts `W` entries of each product, from `at` on and with the sign changed, into their places; the sum of all of them.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn negated<const W: usize>(&self, at: usize, to: &mut [&mut [f64]; 2]) -> f64 {
        let (n, [first, second]) = (to[0].len(), self.factors);
        let mut products = [[0.0; W]; 2];
        for &row in self.rows {
            let (entries, a, b) = (&self.matrix[row * n + at..][..W], first[row], second[row]);
            for i in 0..W {
                products[0][i] -= a * entries[i];
                products[1][i] -= b * entries[i];
            }
        }
        let mut sum = 0.0;
        for (to, product) in to.iter_mut().zip(&products) {
            to[at..][..W].copy_from_slice(product);
            sum += product.iter().sum::<f64>();
        }
        sum
    }
}
