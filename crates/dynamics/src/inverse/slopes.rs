//! Derivatives of inverse dynamics in closed form, by the configuration, the velocity and the acceleration.
//!
//! In world axes about the root's origin a velocity is `(ω, u)` and a force `(n, f)`; degree of freedom `j` moves along `S_j`, and with
//! `v`, `a` of what is before it (`a` less gravity)
//!
//! ```text
//! Ψ̇_j = v × S_j      Ψ̈_j = a × S_j + v × Ψ̇_j      Ṡ_j = v⁺ × S_j
//! ```
//!
//! where `v⁺` is the velocity behind its joint's own axes. Of all that `i` carries be `I` the inertia, `F` the force that moves it, `W` what acts
//! on it from outside, and `2B·δ = 2·∫ (r × (ω_δ × ṙ), ω_δ × ṙ) dm`. Then for every `j` before `i`, or `i` itself,
//!
//! ```text
//! ∂τ_i/∂q_j = S_iᵀ·(2B·Ψ̇_j + I·Ψ̈_j) − S_jᵀ·(S_i ×* W)         ∂τ_i/∂v_j = S_iᵀ·(2B·S_j + I·(Ψ̇_j + Ṡ_j))
//! ∂τ_j/∂q_i = S_jᵀ·(2B·Ψ̇_i + I·Ψ̈_i + S_i ×* F)                ∂τ_j/∂v_i = S_jᵀ·(2B·S_i + I·(Ψ̇_i + Ṡ_i))
//! ```
//!
//! the second row for `j` before `i` alone. Degrees of freedom of one ball or free joint are `i` itself for each other: their axes go with
//! the link. Wrenches from outside stay as they are in the world.
//!
//! J. Carpentier, N. Mansard, "Analytical derivatives of rigid body dynamics algorithms", Robotics: Science and Systems (2018);
//! S. Singh, R. P. Russell, P. M. Wensing, "Efficient analytical derivatives of rigid-body dynamics using spatial vector algebra", IEEE
//! Robotics and Automation Letters 7 (2022) 1776–1783. Here `B` is the flow `∫ ṙ·rᵀ dm` with the momentum, 12 numbers in place of 36.

use crate::derivatives::Partials;
use crate::error::DynamicsError;
use crate::inertia::mass_matrix::find_levers;
use crate::kinematics::place_links;
use crate::scalar::Scalar;
use crate::spatial::direction::{apply, apply_transposed, cross, of_columns};
use crate::spatial::load::Load;
use crate::spatial::symmetric::Symmetric;
use crate::spatial::{Twist, Wrench};
use crate::tree::{Body, Tree};
use crate::wide::wide;
use crate::workspace::{Composite, Flow, Workspace, check_result};
use nalgebra::{Matrix3, Vector3};

/// What is kept of each degree of freedom on the path from the root: `S` (6 numbers), the angular part of `Ψ̇` (3), `Ψ̈` (6) and `Ψ̇ + Ṡ` (6).
const FIELDS: usize = 21;

/// The fields of degrees of freedom side by side.
type Block<T, const LANES: usize> = [[T; LANES]; FIELDS];

/// Scratch memory of the derivatives of one tree.
///
/// As many degrees of freedom of the path as there are `LANES` stand side by side, so that what is done with one is done with all of them
/// at once: for numbers; a vector register has lanes of its own.
#[derive(Clone, Debug)]
pub(crate) struct Slopes<T, const LANES: usize = 4> {
    /// The links, each with all that it carries right behind it.
    order: Vec<usize>,
    /// How many degrees of freedom are before each link's own on its path.
    above: Vec<usize>,
    /// The degrees of freedom on the path to the link at hand.
    path: Vec<usize>,
    /// Its fields.
    blocks: Vec<Block<T, LANES>>,
    /// The sum of all that was found: finite if all of it is.
    sum: T,
    /// The links on the way to the one at hand.
    open: Vec<usize>,
    /// Where each link's origin is, from the root's, in world axes.
    ways: Vec<Vector3<T>>,
    carried: Vec<Carried<T>>,
}

/// A link with all that it carries and has been left, about the root's origin.
#[derive(Clone, Copy, Debug)]
struct Carried<T> {
    velocity: Twist<T>,
    acceleration: Twist<T>,
    body: Composite<T>,
    /// `∫ ṙ dm` and `∫ ṙ·rᵀ dm`
    flow: Flow<T>,
    /// What moves it.
    force: Load<T>,
    /// What acts on it from outside.
    outside: Load<T>,
}

impl<T: Scalar> Carried<T> {
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn nothing() -> Self {
        Self {
            velocity: Twist::zero(),
            acceleration: Twist::zero(),
            body: Composite::zero(),
            flow: Flow::zero(),
            force: Load::zero(),
            outside: Load::zero(),
        }
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn add(&mut self, other: &Self) {
        self.body.mass += other.body.mass;
        self.body.first += other.body.first;
        self.body.inertia.add(&other.body.inertia);
        self.flow.first += other.flow.first;
        self.flow.second += other.flow.second;
        self.force.add(&other.force);
        self.outside.add(&other.outside);
    }
}

impl<T: Scalar, const LANES: usize> Slopes<T, LANES> {
    pub(crate) fn new(tree: &Tree<T>) -> Self {
        let (nv, links) = (tree.nv(), tree.link_count());
        let mut above = vec![0; links];
        let mut children = vec![Vec::new(); links];
        for (i, body) in tree.bodies.iter().enumerate() {
            if let Some(parent) = body.parent {
                above[i] = above[parent] + tree.bodies[parent].end - tree.bodies[parent].first;
                children[parent].push(i);
            }
        }
        let (mut order, mut next) = (Vec::with_capacity(links), vec![0]);
        while let Some(link) = next.pop() {
            order.push(link);
            next.extend(children[link].iter().rev());
        }
        Self {
            order,
            above,
            path: vec![0; nv],
            blocks: vec![[[T::zero(); LANES]; FIELDS]; nv.div_ceil(LANES)],
            sum: T::zero(),
            open: Vec::with_capacity(links),
            ways: vec![Vector3::zeros(); links],
            carried: vec![Carried::nothing(); links],
        }
    }

    /// Writes the derivatives at the positions that `workspace` has been given, checked. What two degrees of freedom on different
    /// branches do to each other is zero and is not written.
    pub(crate) fn find(
        &mut self,
        tree: &Tree<T>,
        workspace: &mut Workspace<T>,
        v: &[T],
        a: &[T],
        external: &[(usize, Wrench<T>)],
        partials: &mut Partials<T>,
    ) -> Result<(), DynamicsError> {
        wide::<T, _>(
            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            || self.differentiate(tree, workspace, v, a, external, partials),
        )
    }

    /// [`find`](Self::find), compiled into whatever asks it.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn differentiate(
        &mut self,
        tree: &Tree<T>,
        workspace: &mut Workspace<T>,
        v: &[T],
        a: &[T],
        external: &[(usize, Wrench<T>)],
        partials: &mut Partials<T>,
    ) -> Result<(), DynamicsError> {
        place_links(tree, workspace)?;
        find_levers(tree, workspace);
        let origin = workspace.poses[0].translation;
        for carried in &mut self.carried {
            carried.outside = Load::zero();
        }
        for (link, Wrench { force, moment }) in external {
            let at_origin = Load { force: *force, moment: moment - cross(&origin, force) };
            self.carried[*link].outside.add(&at_origin);
        }
        let has_outside = !external.is_empty();
        self.open.clear();
        self.sum = T::zero();
        for at in 0..=self.order.len() {
            // After the last link all are left.
            let next = self.order.get(at).copied();
            let parent = match next {
                Some(link) => tree.bodies[link].parent,
                None => None,
            };
            while let Some(&last) = self.open.last() {
                if parent == Some(last) {
                    break;
                }
                self.leave(tree, last, has_outside, partials);
            }
            if let Some(link) = next {
                self.enter(tree, workspace, link, v, a);
                self.open.push(link);
            }
        }
        for &(k, armature) in &tree.armature {
            partials.by_input.as_mut_slice()[k * tree.nv() + k] += armature;
        }
        if self.sum.is_finite() { Ok(()) } else { check_partials(partials) }
    }

    /// Puts the degrees of freedom of a link on the path, and finds what moves its own mass.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn enter(&mut self, tree: &Tree<T>, ws: &Workspace<T>, link: usize, v: &[T], a: &[T]) {
        let body = &tree.bodies[link];
        let (before, mut acceleration, from) = match body.parent {
            Some(parent) => {
                let Carried { velocity, acceleration, .. } = &self.carried[parent];
                (*velocity, *acceleration, self.ways[parent] + ws.reaches[link])
            }
            None => {
                (Twist::zero(), Twist { linear: -tree.gravity, angular: Vector3::zeros() }, Vector3::zeros())
            }
        };
        self.ways[link] = from;
        let mut velocity = before;
        if body.sphere.is_some() {
            let (mut along, mut pushed) = (Twist::zero(), Twist::zero());
            for k in body.first..body.end {
                let s = direction(tree, ws, &from, k);
                along = sum(&along, &scaled(&s, v[k]));
                pushed = sum(&pushed, &scaled(&s, a[k]));
            }
            velocity = sum(&before, &along);
            for k in body.first..body.end {
                let s = direction(tree, ws, &from, k);
                let past = crossed(&before, &s);
                let bent = sum(&crossed(&acceleration, &s), &crossed(&before, &past));
                self.put(body, link, k, &s, &past, &bent, &sum(&past, &crossed(&velocity, &s)));
            }
            acceleration = sum(&acceleration, &sum(&pushed, &crossed(&velocity, &along)));
        } else {
            for k in body.first..body.end {
                let s = direction(tree, ws, &from, k);
                let past = crossed(&velocity, &s);
                let bent = sum(&crossed(&acceleration, &s), &crossed(&velocity, &past));
                self.put(body, link, k, &s, &past, &bent, &sum(&past, &past));
                acceleration = sum(&acceleration, &sum(&scaled(&s, a[k]), &scaled(&past, v[k])));
                velocity = sum(&velocity, &scaled(&s, v[k]));
            }
        }
        let outside = self.carried[link].outside;
        let mut carried = Carried { velocity, acceleration, outside, ..Carried::nothing() };
        if let Some(mass) = &body.mass_distribution {
            let rotation = &ws.poses[link].rotation;
            carried.body = Composite {
                mass: mass.mass,
                first: apply(rotation, &mass.first),
                inertia: mass.inertia_at_origin.rotated(rotation),
            };
            let shift = carried.body.shift(&from);
            carried.body.first += from * mass.mass;
            carried.body.inertia.add(&shift);
            let momentum = carries(&carried.body, &velocity);
            let moving = carries(&carried.body, &acceleration);
            carried.force = Load {
                force: moving.force + cross(&velocity.angular, &momentum.force),
                moment: moving.moment
                    + cross(&velocity.angular, &momentum.moment)
                    + cross(&velocity.linear, &momentum.force),
            };
            carried.flow = Flow { first: momentum.force, second: flow(&carried.body, &velocity) };
        }
        self.carried[link] = carried;
    }

    /// Puts a degree of freedom on the path.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    #[expect(clippy::too_many_arguments, reason = "a place and what is kept there")]
    fn put(
        &mut self,
        body: &Body<T>,
        link: usize,
        k: usize,
        s: &Twist<T>,
        past: &Twist<T>,
        bent: &Twist<T>,
        rate: &Twist<T>,
    ) {
        let at = self.above[link] + k - body.first;
        self.path[at] = k;
        let (block, lane) = (&mut self.blocks[at / LANES], at % LANES);
        let values =
            [&s.angular, &s.linear, &past.angular, &bent.angular, &bent.linear, &rate.angular, &rate.linear];
        for (i, value) in values.iter().enumerate() {
            block[3 * i][lane] = value.x;
            block[3 * i + 1][lane] = value.y;
            block[3 * i + 2][lane] = value.z;
        }
    }

    /// Writes the rows and columns of a link's degrees of freedom, and hands what it carries to its parent.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn leave(&mut self, tree: &Tree<T>, link: usize, has_outside: bool, partials: &mut Partials<T>) {
        let body = &tree.bodies[link];
        let (first, count) = (self.above[link], body.end - body.first);
        let carried = self.carried[link];
        for i in 0..count {
            let at = first + i;
            // Which degrees of freedom are before it or itself, and which are before it alone.
            let (rows, columns) = if body.sphere.is_some() { (first + count, first) } else { (at + 1, at) };
            self.along_path(&carried, at, rows, columns, has_outside, partials);
        }
        self.open.pop();
        if let Some(parent) = body.parent {
            self.carried[parent].add(&carried);
        }
    }

    /// Writes what the degree of freedom at a place of the path does to those before it and they to it: rows of as many, columns of
    /// as many.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn along_path(
        &mut self,
        carried: &Carried<T>,
        at: usize,
        rows: usize,
        columns: usize,
        has_outside: bool,
        partials: &mut Partials<T>,
    ) {
        let (block, lane) = (&self.blocks[at / LANES], at % LANES);
        let (s, bent, rate) = (motion(block, lane, 0), motion(block, lane, 9), motion(block, lane, 15));
        let past = vector(block, lane, 6);
        let (body, flow) = (&carried.body, &carried.flow);
        // I·S, (2B)ᵀ·S, and the two columns.
        let inert = carries(body, &s);
        let trace = flow.second.m11 + flow.second.m22 + flow.second.m33;
        let pull =
            s.angular * trace - apply_transposed(&flow.second, &s.angular) + cross(&flow.first, &s.linear);
        let pull = pull + pull;
        let by_q = add(&add(&bends(flow, trace, &past), &carries(body, &bent)), &turned(&s, &carried.force));
        let by_v = add(&bends(flow, trace, &s.angular), &carries(body, &rate));
        let held = if has_outside { turned(&s, &carried.outside) } else { Load::zero() };
        let (nv, i, mut place) = (self.path.len(), self.path[at], 0);
        let Partials { by_q: to_q, by_v: to_v, by_input: to_mass, .. } = partials;
        let (to_q, to_v, to_mass) = (to_q.as_mut_slice(), to_v.as_mut_slice(), to_mass.as_mut_slice());
        let (zero, mut sum) = ([T::zero(); LANES], [T::zero(); LANES]);
        for (block, path) in self.blocks.iter().zip(self.path[..rows].chunks(LANES)) {
            let mut row_q = six(block, 9, &inert, three(block, 6, &pull, zero));
            let row_v = six(block, 15, &inert, three(block, 0, &pull, zero));
            let column_q = six(block, 0, &by_q, zero);
            let column_v = six(block, 0, &by_v, zero);
            let mass = six(block, 0, &inert, zero);
            if has_outside {
                let outside = six(block, 0, &held, zero);
                for lane in 0..LANES {
                    row_q[lane] -= outside[lane];
                }
            }
            for lane in 0..LANES {
                sum[lane] += (row_q[lane] + row_v[lane]) + (column_q[lane] + column_v[lane]) + mass[lane];
            }
            for (lane, &j) in path.iter().enumerate() {
                let (row, column) = (j * nv + i, i * nv + j);
                (to_q[row], to_v[row], to_mass[row]) = (row_q[lane], row_v[lane], mass[lane]);
                if place < columns {
                    (to_q[column], to_v[column], to_mass[column]) =
                        (column_q[lane], column_v[lane], mass[lane]);
                }
                place += 1;
            }
        }
        for part in sum {
            self.sum += part;
        }
    }
}

/// One of them is not finite, or their sum alone.
#[cold]
#[inline(never)]
fn check_partials<T: Scalar>(partials: &Partials<T>) -> Result<(), DynamicsError> {
    let matrices = [&partials.by_q, &partials.by_v, &partials.by_input];
    matrices.iter().try_for_each(|matrix| check_result("a derivative of inverse dynamics", matrix.as_slice()))
}

/// A vector of one degree of freedom, in three fields from `first` on.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn vector<T: Scalar, const LANES: usize>(block: &Block<T, LANES>, lane: usize, first: usize) -> Vector3<T> {
    Vector3::new(block[first][lane], block[first + 1][lane], block[first + 2][lane])
}

/// A motion of one degree of freedom, in six fields from `first` on.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn motion<T: Scalar, const LANES: usize>(block: &Block<T, LANES>, lane: usize, first: usize) -> Twist<T> {
    Twist { angular: vector(block, lane, first), linear: vector(block, lane, first + 3) }
}

/// The product of a load with the motions in six fields from `first` on, and `more`.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn six<T: Scalar, const LANES: usize>(
    block: &Block<T, LANES>,
    first: usize,
    load: &Load<T>,
    more: [T; LANES],
) -> [T; LANES] {
    three(block, first + 3, &load.force, three(block, first, &load.moment, more))
}

/// The product of a vector with those in three fields from `first` on, and `more`.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn three<T: Scalar, const LANES: usize>(
    block: &Block<T, LANES>,
    first: usize,
    with: &Vector3<T>,
    more: [T; LANES],
) -> [T; LANES] {
    let mut product = more;
    for lane in 0..LANES {
        let x = block[first][lane].times_plus(with.x, more[lane]);
        let y = block[first + 1][lane].times_plus(with.y, x);
        product[lane] = block[first + 2][lane].times_plus(with.z, y);
    }
    product
}

/// The motion along degree of freedom `k` of a link whose origin is at `from`.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn direction<T: Scalar>(tree: &Tree<T>, ws: &Workspace<T>, from: &Vector3<T>, k: usize) -> Twist<T> {
    let axis = ws.axes[k];
    if !tree.dofs[k].kind.turns() {
        return Twist { linear: axis, angular: Vector3::zeros() };
    }
    Twist { linear: ws.levers[k] + cross(from, &axis), angular: axis }
}

#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn sum<T: Scalar>(a: &Twist<T>, b: &Twist<T>) -> Twist<T> {
    Twist { linear: a.linear + b.linear, angular: a.angular + b.angular }
}

#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn scaled<T: Scalar>(a: &Twist<T>, by: T) -> Twist<T> {
    Twist { linear: a.linear * by, angular: a.angular * by }
}

#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn add<T: Scalar>(a: &Load<T>, b: &Load<T>) -> Load<T> {
    Load { force: a.force + b.force, moment: a.moment + b.moment }
}

/// `a × b` of two motions.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn crossed<T: Scalar>(a: &Twist<T>, b: &Twist<T>) -> Twist<T> {
    Twist {
        linear: cross(&a.angular, &b.linear) + cross(&a.linear, &b.angular),
        angular: cross(&a.angular, &b.angular),
    }
}

/// `s ×* f`: how a force that goes along with a motion changes.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn turned<T: Scalar>(s: &Twist<T>, load: &Load<T>) -> Load<T> {
    Load {
        force: cross(&s.angular, &load.force),
        moment: cross(&s.angular, &load.moment) + cross(&s.linear, &load.force),
    }
}

/// `I·δ`
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn carries<T: Scalar>(body: &Composite<T>, motion: &Twist<T>) -> Load<T> {
    Load {
        force: motion.linear * body.mass + cross(&motion.angular, &body.first),
        moment: body.inertia.times(&motion.angular) + cross(&body.first, &motion.linear),
    }
}

/// `2B·δ`, which asks for the angular part of `δ` alone; `trace` is that of the flow.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn bends<T: Scalar>(flow: &Flow<T>, trace: T, angular: &Vector3<T>) -> Load<T> {
    let (moment, force) = (angular * trace - apply(&flow.second, angular), cross(angular, &flow.first));
    Load { force: force + force, moment: moment + moment }
}

/// `∫ ṙ·rᵀ dm = u·hᵀ + [ω]×·∫ r·rᵀ dm` of a rigid body.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn flow<T: Scalar>(body: &Composite<T>, velocity: &Twist<T>) -> Matrix3<T> {
    let Symmetric { xx, yy, zz, xy, xz, yz } = body.inertia;
    let half = (xx + yy + zz) * T::from_f64(0.5);
    // ∫ r·rᵀ dm = tr(I)/2·1 − I
    let (u, h) = (&velocity.linear, &body.first);
    of_columns(
        &(cross(&velocity.angular, &Vector3::new(half - xx, -xy, -xz)) + u * h.x),
        &(cross(&velocity.angular, &Vector3::new(-xy, half - yy, -yz)) + u * h.y),
        &(cross(&velocity.angular, &Vector3::new(-xz, -yz, half - zz)) + u * h.z),
    )
}
