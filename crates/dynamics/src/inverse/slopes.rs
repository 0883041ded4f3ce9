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
use crate::inertia::mass_matrix::levers;
use crate::kinematics::place;
use crate::scalar::Scalar;
use crate::spatial::direction::{apply, cross, dot};
use crate::spatial::load::Load;
use crate::spatial::symmetric::Symmetric;
use crate::spatial::{Twist, Wrench};
use crate::tree::{Body, Tree};
use crate::workspace::{Composite, Flow, Workspace, check_result};
use nalgebra::{Matrix3, Vector3};

/// What is kept of each degree of freedom on the path from the root, one array a number: `S` (6), the angular part of `Ψ̇` (3), `Ψ̈` (6) and
/// `Ψ̇ + Ṡ` (6).
const FIELDS: usize = 21;

/// Scratch memory of the derivatives of one tree.
#[derive(Clone, Debug)]
pub(crate) struct Slopes<T> {
    /// The links, each with all that it carries right behind it.
    order: Vec<usize>,
    /// How many degrees of freedom are before each link's own on its path.
    above: Vec<usize>,
    /// The degrees of freedom on the path to the link at hand.
    path: Vec<usize>,
    /// [`FIELDS`] arrays along the path.
    fields: Vec<T>,
    /// Results along the path.
    rows: [Vec<T>; 5],
    /// The links on the way to the one at hand.
    open: Vec<usize>,
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

impl<T: Scalar> Slopes<T> {
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
            fields: vec![T::zero(); FIELDS * nv],
            rows: [(); 5].map(|()| vec![T::zero(); nv]),
            open: Vec::with_capacity(links),
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
        place(tree, workspace)?;
        levers(tree, workspace);
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
        for at in 0..self.order.len() {
            let link = self.order[at];
            while let Some(&last) = self.open.last().filter(|last| Some(**last) != tree.bodies[link].parent) {
                self.leave(tree, last, has_outside, partials);
            }
            self.enter(tree, workspace, link, &origin, v, a);
            self.open.push(link);
        }
        while let Some(&last) = self.open.last() {
            self.leave(tree, last, has_outside, partials);
        }
        for &(k, armature) in &tree.armature {
            partials.by_input[(k, k)] += armature;
        }
        for matrix in [&partials.by_q, &partials.by_v, &partials.by_input] {
            check_result("a derivative of inverse dynamics", matrix.as_slice())?;
        }
        Ok(())
    }

    /// Puts the degrees of freedom of a link on the path, and finds what moves its own mass.
    fn enter(
        &mut self,
        tree: &Tree<T>,
        ws: &Workspace<T>,
        link: usize,
        origin: &Vector3<T>,
        v: &[T],
        a: &[T],
    ) {
        let body = &tree.bodies[link];
        let rest = Twist { linear: -tree.gravity, angular: Vector3::zeros() };
        let (before, mut acceleration) = body.parent.map_or((Twist::zero(), rest), |parent| {
            (self.carried[parent].velocity, self.carried[parent].acceleration)
        });
        let pose = &ws.poses[link];
        let from = pose.translation - origin;
        let direction = |k: usize| {
            let axis = ws.axes[k];
            if !tree.dofs[k].kind.turns() {
                return Twist { linear: axis, angular: Vector3::zeros() };
            }
            Twist { linear: ws.levers[k] + cross(&from, &axis), angular: axis }
        };
        let mut velocity = before;
        if body.sphere.is_some() {
            let (mut along, mut pushed) = (Twist::zero(), Twist::zero());
            for k in body.first..body.end {
                let s = direction(k);
                along = sum(&along, &scaled(&s, v[k]));
                pushed = sum(&pushed, &scaled(&s, a[k]));
            }
            velocity = sum(&before, &along);
            for k in body.first..body.end {
                let s = direction(k);
                let past = crossed(&before, &s);
                let bent = sum(&crossed(&acceleration, &s), &crossed(&before, &past));
                self.put(body, link, k, &s, &past, &bent, &sum(&past, &crossed(&velocity, &s)));
            }
            acceleration = sum(&acceleration, &sum(&pushed, &crossed(&velocity, &along)));
        } else {
            for k in body.first..body.end {
                let s = direction(k);
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
            let first = apply(&pose.rotation, &mass.first);
            // About the root's origin: (2·h·r + m·r·r)·1 − (h·rᵀ + r·hᵀ + m·r·rᵀ) more.
            let u = first + from * (mass.mass * T::from_f64(0.5));
            let (x, y, z) = (u.x * from.x, u.y * from.y, u.z * from.z);
            let mut inertia = mass.inertia_at_origin.rotated(&pose.rotation);
            inertia.add(&Symmetric {
                xx: y + z + (y + z),
                yy: x + z + (x + z),
                zz: x + y + (x + y),
                xy: -(u.x * from.y + from.x * u.y),
                xz: -(u.x * from.z + from.x * u.z),
                yz: -(u.y * from.z + from.y * u.z),
            });
            carried.body = Composite { mass: mass.mass, first: first + from * mass.mass, inertia };
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
    #[inline]
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
        let nv = self.path.len();
        let values =
            [s.angular, s.linear, past.angular, bent.angular, bent.linear, rate.angular, rate.linear];
        for (field, value) in values.iter().flat_map(|v| [v.x, v.y, v.z]).enumerate() {
            self.fields[field * nv + at] = value;
        }
    }

    /// Writes the rows and columns of a link's degrees of freedom, and hands what it carries to its parent.
    fn leave(&mut self, tree: &Tree<T>, link: usize, has_outside: bool, partials: &mut Partials<T>) {
        let body = &tree.bodies[link];
        let (first, count) = (self.above[link], body.end - body.first);
        let carried = self.carried[link];
        for i in 0..count {
            let at = first + i;
            // Which degrees of freedom are before it or itself, and which are before it alone.
            let (rows, columns) = if body.sphere.is_some() { (first + count, first) } else { (at + 1, at) };
            self.along_path(&carried, at, rows, has_outside);
            self.write(at, rows, columns, partials);
        }
        self.open.pop();
        if let Some(parent) = body.parent {
            self.carried[parent].add(&carried);
        }
    }

    /// Finds what the degree of freedom at a place of the path does to those before it and they to it.
    fn along_path(&mut self, carried: &Carried<T>, at: usize, len: usize, has_outside: bool) {
        let nv = self.path.len();
        let field = |index: usize| &self.fields[index * nv..][..len];
        let vector = |index: usize| {
            let part = |i: usize| self.fields[(index + i) * nv + at];
            Vector3::new(part(0), part(1), part(2))
        };
        let twist = |index: usize| Twist { angular: vector(index), linear: vector(index + 3) };
        let (s, past, bent, rate) = (twist(0), vector(6), twist(9), twist(15));
        let (body, flow) = (&carried.body, &carried.flow);
        // I·S, (2B)ᵀ·S, and the two columns.
        let inert = carries(body, &s);
        let trace = flow.second.m11 + flow.second.m22 + flow.second.m33;
        let pull = s.angular * trace - transposed(&flow.second, &s.angular) + cross(&flow.first, &s.linear);
        let pull = pull + pull;
        let by_q = add(&add(&bends(flow, trace, &past), &carries(body, &bent)), &turned(&s, &carried.force));
        let by_v = add(&bends(flow, trace, &s.angular), &carries(body, &rate));
        let [row_q, column_q, row_v, column_v, mass] = &mut self.rows;
        let s: [&[T]; 6] = [0, 1, 2, 3, 4, 5].map(field);
        let past: [&[T]; 3] = [6, 7, 8].map(field);
        let bent: [&[T]; 6] = [9, 10, 11, 12, 13, 14].map(field);
        let rate: [&[T]; 6] = [15, 16, 17, 18, 19, 20].map(field);
        let (row_q, row_v) = (&mut row_q[..len], &mut row_v[..len]);
        for (p, out) in row_q.iter_mut().enumerate() {
            *out = three(&past, &pull, p) + six(&bent, &inert, p);
        }
        for (p, out) in row_v.iter_mut().enumerate() {
            *out = three(&[s[0], s[1], s[2]], &pull, p) + six(&rate, &inert, p);
        }
        for (p, out) in column_q[..len].iter_mut().enumerate() {
            *out = six(&s, &by_q, p);
        }
        for (p, out) in column_v[..len].iter_mut().enumerate() {
            *out = six(&s, &by_v, p);
        }
        for (p, out) in mass[..len].iter_mut().enumerate() {
            *out = six(&s, &inert, p);
        }
        if has_outside {
            let own = Twist { angular: vector(0), linear: vector(3) };
            let held = turned(&own, &carried.outside);
            for (p, out) in row_q.iter_mut().enumerate() {
                *out -= six(&s, &held, p);
            }
        }
    }

    /// Writes what was found along the path.
    fn write(&self, at: usize, rows: usize, columns: usize, partials: &mut Partials<T>) {
        let (nv, i) = (self.path.len(), self.path[at]);
        let [row_q, column_q, row_v, column_v, mass] = &self.rows;
        let by_q = partials.by_q.as_mut_slice();
        let by_v = partials.by_v.as_mut_slice();
        let by_input = partials.by_input.as_mut_slice();
        for (p, &j) in self.path[..rows].iter().enumerate() {
            by_q[j * nv + i] = row_q[p];
            by_v[j * nv + i] = row_v[p];
            by_input[j * nv + i] = mass[p];
        }
        for (p, &j) in self.path[..columns].iter().enumerate() {
            by_q[i * nv + j] = column_q[p];
            by_v[i * nv + j] = column_v[p];
            by_input[i * nv + j] = mass[p];
        }
    }
}

#[inline]
fn six<T: Scalar>(of: &[&[T]; 6], load: &Load<T>, p: usize) -> T {
    let (n, f) = (&load.moment, &load.force);
    of[0][p] * n.x + of[1][p] * n.y + of[2][p] * n.z + (of[3][p] * f.x + of[4][p] * f.y + of[5][p] * f.z)
}

#[inline]
fn three<T: Scalar>(of: &[&[T]; 3], pull: &Vector3<T>, p: usize) -> T {
    of[0][p] * pull.x + of[1][p] * pull.y + of[2][p] * pull.z
}

#[inline]
fn sum<T: Scalar>(a: &Twist<T>, b: &Twist<T>) -> Twist<T> {
    Twist { linear: a.linear + b.linear, angular: a.angular + b.angular }
}

#[inline]
fn scaled<T: Scalar>(a: &Twist<T>, by: T) -> Twist<T> {
    Twist { linear: a.linear * by, angular: a.angular * by }
}

#[inline]
fn add<T: Scalar>(a: &Load<T>, b: &Load<T>) -> Load<T> {
    Load { force: a.force + b.force, moment: a.moment + b.moment }
}

/// `a × b` of two motions.
#[inline]
fn crossed<T: Scalar>(a: &Twist<T>, b: &Twist<T>) -> Twist<T> {
    Twist {
        linear: cross(&a.angular, &b.linear) + cross(&a.linear, &b.angular),
        angular: cross(&a.angular, &b.angular),
    }
}

/// `s ×* f`: how a force that goes along with a motion changes.
#[inline]
fn turned<T: Scalar>(s: &Twist<T>, load: &Load<T>) -> Load<T> {
    Load {
        force: cross(&s.angular, &load.force),
        moment: cross(&s.angular, &load.moment) + cross(&s.linear, &load.force),
    }
}

/// `I·δ`
#[inline]
fn carries<T: Scalar>(body: &Composite<T>, motion: &Twist<T>) -> Load<T> {
    Load {
        force: motion.linear * body.mass + cross(&motion.angular, &body.first),
        moment: body.inertia.times(&motion.angular) + cross(&body.first, &motion.linear),
    }
}

/// `2B·δ`, which asks for the angular part of `δ` alone; `trace` is that of the flow.
#[inline]
fn bends<T: Scalar>(flow: &Flow<T>, trace: T, angular: &Vector3<T>) -> Load<T> {
    let (moment, force) = (angular * trace - apply(&flow.second, angular), cross(angular, &flow.first));
    Load { force: force + force, moment: moment + moment }
}

/// `∫ ṙ·rᵀ dm = u·hᵀ + [ω]×·∫ r·rᵀ dm` of a rigid body.
#[inline]
fn flow<T: Scalar>(body: &Composite<T>, velocity: &Twist<T>) -> Matrix3<T> {
    let Symmetric { xx, yy, zz, xy, xz, yz } = body.inertia;
    let half = (xx + yy + zz) * T::from_f64(0.5);
    // ∫ r·rᵀ dm = tr(I)/2·1 − I
    let columns = [
        Vector3::new(half - xx, -xy, -xz),
        Vector3::new(-xy, half - yy, -yz),
        Vector3::new(-xz, -yz, half - zz),
    ];
    let column = |i: usize| cross(&velocity.angular, &columns[i]) + velocity.linear * body.first[i];
    Matrix3::from_columns(&[column(0), column(1), column(2)])
}

/// `mᵀ·v`
#[inline]
fn transposed<T: Scalar>(m: &Matrix3<T>, v: &Vector3<T>) -> Vector3<T> {
    let column = |i: usize| dot(&m.column(i).into_owned(), v);
    Vector3::new(column(0), column(1), column(2))
}
