//! A step by impulses: contact, friction and hard limits of what is left of the figure as one convex problem.

use super::colliding::Colliding;
use crate::collision::Collision;
use super::prescribed::Prescribed;
use super::reduction::{Reduction, Source};
use super::small::{Maps, Moving, Side, Small};
use super::state::StateMap;
use crate::contact::ContactLaw;
use crate::convex::Convex;
use crate::element::LimitLaw;
use nalgebra::{DMatrix, Quaternion, UnitQuaternion, Vector3};
use solaris_dynamics::scalar::Dual;
use solaris_dynamics::{DynamicsError, Wrench};
use solaris_model::JointKind;

/// A limit this near (rad or m) may be come to within a step, whatever the velocity.
const CLOSE: f64 = 1e-3;

/// A velocity (m/s) for a unit rate that is rounding.
const NOTHING: f64 = 1e-13;

/// Stiffness (N/m) and relaxation (s) of what is as stiff as a step allows.
const RIGID: (f64, f64) = (f64::INFINITY, 0.0);

/// How fast (m/s or rad/s) what begins in the ground or beyond a limit is brought out.
const RECOVERY: f64 = 0.1;

/// What a step by impulses needs, kept from step to step.
#[derive(Clone)]
pub(super) struct Impulses {
    convex: Convex,
    /// Of a whole step (s).
    step: f64,
    matrix: DMatrix<f64>,
    /// By degree of freedom of the small figure, its place among those that dynamics move.
    places: Vec<Option<usize>>,
    limits: Vec<Limited>,
    ground: Option<Ground>,
    /// Spheres that may touch within the step: index, gap (m), lowest point.
    near: Vec<(usize, f64, Vector3<f64>)>,
    /// Links that touch each other.
    colliding: Option<Colliding>,
    /// Rows of a touch by degree of freedom of the small figure, and which of these are not zero.
    rows: Vec<[f64; 3]>,
    columns: Vec<usize>,
    /// How deep in the ground each sphere may still be (m), in each other the links of each pair, and beyond each limit each degree of
    /// freedom, lower and upper (rad or m), for it began there; none before the first step.
    allowed: Vec<f64>,
    begun: bool,
    /// Velocities of the small figure after the step, without impulses.
    free: Vec<f64>,
    /// How joints hold each of its degrees of freedom back.
    damping: Vec<f64>,
    stiffness: Vec<f64>,
    /// How drives that feel the state do: damping and stiffness.
    led: Vec<(f64, f64)>,
    /// Of what dynamics move, before the step.
    before: Vec<f64>,
    /// What the velocities without impulses are changed by, at the velocities before the step.
    change: Vec<f64>,
    /// Free joints that dynamics move: the first degree of freedom in the small figure, and its place among those.
    flying: Vec<(usize, usize)>,
    /// Velocities in the middle of the step, accelerations, and forces of inertia at the velocities before it and in its middle.
    middle: Vec<f64>,
    turning: Vec<f64>,
    inertial: [Vec<f64>; 2],
    /// What the ground does to links (N, N m, about the world's origin), by sphere.
    wrenches: Vec<(usize, Wrench<f64>)>,
    /// The same by the links of the small figure.
    on_links: Vec<(usize, Wrench<f64>)>,
    /// What links do to each other.
    collisions: Vec<Collision>,
    tau: Vec<f64>,
    rate: Vec<f64>,
    /// What the ground does: impulse (N s), and what its push and its friction take (J).
    ground_sums: [f64; 5],
    /// What limits, and links that touch each other, take (J).
    loss: f64,
}

/// A degree of freedom with hard limits that dynamics move.
#[derive(Clone, Copy)]
struct Limited {
    place: usize,
    coordinate: usize,
    lower: f64,
    upper: f64,
}

/// The ground, and two directions along it.
#[derive(Clone)]
struct Ground {
    axes: [Vector3<f64>; 3],
    friction: f64,
    /// Stiffness (N/m) and relaxation (s).
    spring: (f64, f64),
    /// By sphere of the small figure: its link there, and in the full figure.
    links: Vec<(usize, usize)>,
}

impl Impulses {
    pub(super) fn new(
        source: &Source,
        reduction: &Reduction,
        maps: &Maps,
        state: &StateMap,
        step: f64,
    ) -> Self {
        let nv = reduction.kept_v.len();
        let mut places = vec![None; nv];
        for (place, k) in maps.velocities.iter().enumerate() {
            places[*k] = Some(place);
        }
        let (mut limits, mut flying) = (Vec::new(), Vec::new());
        for (link, at) in reduction.figure.links().iter().zip(reduction.figure.layout().joints()) {
            let is_free = matches!(link.joint().kind(), JointKind::Free { .. });
            flying.extend(places[at.v].filter(|_| is_free).map(|place| (at.v, place)));
            for (i, axis) in link.joint().kind().axes().iter().enumerate() {
                let is_hard = matches!(reduction.limits[at.v + i], LimitLaw::Hard { .. });
                // Ball joints have none.
                let coordinate = reduction.figure.layout().coordinate(at.v + i).filter(|_| is_hard);
                if let (Some(range), Some(place), Some(coordinate)) =
                    (axis.limits, places[at.v + i], coordinate)
                {
                    let (lower, upper) = (range.lower, range.upper);
                    limits.push(Limited { place, coordinate, lower, upper });
                }
            }
        }
        let ground = reduction.surface.as_ref().map(|surface| {
            let up = surface.plane.up.into_inner();
            let aside = up.cross(&Vector3::ith(up.iamin(), 1.0)).normalize();
            let stiffness = match surface.plane.law {
                ContactLaw::Compliant { stiffness, .. } => stiffness,
                ContactLaw::Rigid => f64::INFINITY,
            };
            let full = source.surface.as_ref().map_or(&[][..], |full| &full.contact_points);
            let spheres = surface.contact_points.iter().zip(&reduction.kept_touches);
            Ground {
                axes: [aside, up.cross(&aside), up],
                friction: surface.plane.friction,
                spring: (stiffness, 0.0),
                links: spheres.map(|(small, index)| (small.link, full[*index].link)).collect(),
            }
        });
        let spheres = ground.as_ref().map_or(0, |ground| ground.links.len());
        let pairs = reduction.colliding.as_ref().map_or(0, Colliding::len);
        let (dofs, conditions) = (maps.velocities.len(), spheres + pairs + 2 * limits.len());
        Self {
            convex: Convex::new(dofs, conditions),
            step,
            matrix: DMatrix::zeros(nv, nv),
            places,
            limits,
            ground,
            near: Vec::with_capacity(spheres),
            colliding: reduction.colliding.clone(),
            rows: vec![[0.0; 3]; nv],
            columns: Vec::with_capacity(nv),
            allowed: vec![0.0; conditions],
            begun: false,
            free: vec![0.0; nv],
            damping: vec![0.0; nv],
            stiffness: vec![0.0; nv],
            led: vec![(0.0, 0.0); nv],
            before: vec![0.0; dofs],
            change: vec![0.0; dofs],
            flying,
            middle: vec![0.0; nv],
            turning: vec![0.0; nv],
            inertial: [vec![0.0; nv], vec![0.0; nv]],
            wrenches: Vec::with_capacity(spheres),
            on_links: Vec::with_capacity(spheres),
            collisions: Vec::with_capacity(pairs),
            tau: vec![0.0; nv],
            rate: vec![0.0; state.len()],
            ground_sums: [0.0; 5],
            loss: 0.0,
        }
    }

    /// What the ground does to links of the full figure, in the step that was found last.
    pub(super) fn wrenches(&self) -> &[(usize, Wrench<f64>)] {
        &self.wrenches
    }

    /// What links do to each other that touch, in the step that was found last.
    pub(super) fn collisions(&self) -> &[Collision] {
        &self.collisions
    }

    /// Finds the velocities after a step of `h` (s) and the impulses in it.
    fn find(&mut self, side: &mut Side<f64>, maps: &Maps, h: f64) -> Result<(), DynamicsError> {
        side.solve(maps)?;
        for (free, (v, a)) in self.free.iter_mut().zip(side.v.iter().zip(&side.a)) {
            *free = v + h * a;
        }
        for (before, k) in self.before.iter_mut().zip(&maps.velocities) {
            *before = side.v[*k];
        }
        side.body.mass_matrix(&side.q, &mut self.matrix)?;
        side.body.holds_back(&side.q, &side.v, &mut self.damping, &mut self.stiffness);
        for (change, k) in self.change.iter_mut().zip(&maps.velocities) {
            *change = h * side.a[*k];
        }
        for (k, place) in &self.flying {
            for (change, turn) in self.change[*place..].iter_mut().zip(&turned(&side.v[*k..])) {
                *change += h * turn;
            }
        }
        let held = |k: usize| {
            let (damping, stiffness) = self.led[k];
            (h * (self.damping[k] + damping), h * h * (self.stiffness[k] + stiffness))
        };
        let change = self.change.iter().copied();
        self.convex.begin(&self.matrix, &maps.velocities, &self.before, change, held);
        self.go_half_way(side, maps, h)?;
        if let Some(ground) = &self.ground {
            side.body.nearly_touching((&side.q, &side.v), 2.0 * h, &mut self.near)?;
            side.body.joint_jacobians(&side.q)?;
            for (sphere, gap, point) in &self.near {
                let allowed = &mut self.allowed[*sphere];
                if !self.begun && ground.spring.0.is_infinite() {
                    *allowed = (-gap).max(0.0);
                }
                let gap = gap + *allowed;
                self.convex.condition();
                let mut bias = [0.0; 3];
                let link = side.body.link_of(*sphere).unwrap_or_default();
                side.body.columns(link, point, |k, velocity| {
                    let rows = [0, 1, 2].map(|i| ground.axes[i].dot(&velocity));
                    if let Some(place) = self.places[k] {
                        self.convex.entry(place, rows);
                    } else {
                        bias.iter_mut().zip(rows).for_each(|(bias, row)| *bias += row * self.free[k]);
                    }
                });
                self.convex.contact(bias, ground.friction, gap, ground.spring, h);
            }
        }
        self.collide(side, h)?;
        let of_limits = self.allowed.len() - 2 * self.limits.len();
        let pairs = self.allowed[of_limits..].chunks_exact_mut(2);
        for (&Limited { place, coordinate, lower, upper }, allowed) in self.limits.iter().zip(pairs) {
            let (q, reach) = (side.q[coordinate], CLOSE + 2.0 * h * self.before[place].abs());
            for ((gap, row), allowed) in [(q - lower, 1.0), (upper - q, -1.0)].into_iter().zip(allowed) {
                if !self.begun {
                    *allowed = (-gap).max(0.0);
                }
                let gap = gap + *allowed;
                if gap < reach {
                    self.convex.condition();
                    self.convex.entry(place, [0.0, 0.0, row]);
                    self.convex.limit(gap, h);
                }
            }
        }
        self.begun = true;
        self.convex.solve();
        self.account(h);
        for (k, a) in side.a.iter_mut().enumerate() {
            if let Some(place) = self.places[k] {
                *a = (self.convex.v[place] - self.before[place]) / h;
            }
        }
        for (k, _) in &self.flying {
            for (a, turn) in side.a[*k..].iter_mut().zip(&turned(&side.v[*k..])) {
                *a -= turn;
            }
        }
        Ok(())
    }

    /// Takes the forces of inertia that grow with the velocities in the middle of the step, for those at its beginning make whatever
    /// turns faster and faster:
    ///
    /// ```text
    /// v* ← v* − h·M⁻¹·(c(v_½) − c(v))        v_½ = (v + v*)/2        c(v) = C(q, v)·v − M·(ω × v)
    /// ```
    ///
    /// The last term is there for free joints, whose velocities are told along axes that turn and are stepped along axes that do not.
    fn go_half_way(&mut self, side: &mut Side<f64>, maps: &Maps, h: f64) -> Result<(), DynamicsError> {
        for (k, middle) in self.middle.iter_mut().enumerate() {
            let free = self.places[k].map_or(self.free[k], |place| self.convex.free()[place]);
            *middle = 0.5 * (side.v[k] + free);
        }
        for (v, forces) in [&side.v, &self.middle].into_iter().zip(&mut self.inertial) {
            for (k, _) in &self.flying {
                for (turning, turn) in self.turning[*k..].iter_mut().zip(&turned(&v[*k..])) {
                    *turning = -turn;
                }
            }
            side.body.inertial_forces((&side.q, v, &self.turning), forces)?;
        }
        let [before, middle] = &self.inertial;
        self.convex.push(maps.velocities.iter().map(|k| h * (before[*k] - middle[*k])));
        Ok(())
    }

    /// The conditions of links that touch each other.
    ///
    /// ```text
    /// u = J₁·v − J₂·v
    /// ```
    ///
    /// What both hang from moves the point alike, and has no part in it.
    fn collide(&mut self, side: &mut Side<f64>, h: f64) -> Result<(), DynamicsError> {
        let Self { colliding: Some(colliding), allowed, convex, rows, columns, .. } = self else { return Ok(()) };
        side.body.velocities(&side.q, &side.v)?;
        colliding.find(&side.body, 2.0 * h);
        if colliding.met.is_empty() {
            return Ok(());
        }
        if self.ground.is_none() || self.near.is_empty() {
            side.body.joint_jacobians(&side.q)?;
        }
        let allowed = &mut allowed[self.ground.as_ref().map_or(0, |ground| ground.links.len())..];
        if !self.begun {
            for met in &colliding.met {
                allowed[met.pair] = allowed[met.pair].max(-met.gap);
            }
        }
        for met in &colliding.met {
            for (link, sign) in [(met.links[0].1, 1.0), (met.links[1].1, -1.0)] {
                side.body.columns(link, &met.point, |k, velocity| {
                    if !columns.contains(&k) {
                        columns.push(k);
                    }
                    for (row, axis) in rows[k].iter_mut().zip(&met.axes) {
                        *row += sign * axis.dot(&velocity);
                    }
                });
            }
            convex.condition();
            let mut bias = [0.0; 3];
            for k in columns.drain(..) {
                let rows = std::mem::take(&mut rows[k]);
                if rows.iter().all(|row| row.abs() < NOTHING) {
                    continue;
                }
                if let Some(place) = self.places[k] {
                    convex.entry(place, rows);
                } else {
                    bias.iter_mut().zip(rows).for_each(|(bias, row)| *bias += row * self.free[k]);
                }
            }
            convex.contact(bias, colliding.friction, met.gap + allowed[met.pair], RIGID, h);
        }
        Ok(())
    }

    /// Forces and losses of the impulses that were found.
    fn account(&mut self, h: f64) {
        self.wrenches.clear();
        self.on_links.clear();
        (self.ground_sums, self.loss) = ([0.0; 5], 0.0);
        self.collisions.clear();
        for (index, (impulse, mean)) in self.convex.impulses(&self.before).enumerate() {
            let power: [f64; 3] = [0, 1, 2].map(|i| impulse[i] * mean[i]);
            let (Some((sphere, _, point)), Some(ground)) = (self.near.get(index), &self.ground) else {
                self.loss -= power.iter().sum::<f64>();
                let met = self.colliding.as_ref().and_then(|all| all.met.get(index - self.near.len()));
                if let Some(met) = met.filter(|_| impulse[2] > 0.0) {
                    let force: Vector3<f64> = (0..3).map(|i| met.axes[i] * (impulse[i] / h)).sum();
                    for (link, force) in met.links.into_iter().zip([force, -force]) {
                        add(&mut self.on_links, link.1, &Wrench::at(&met.point, force, Vector3::zeros()));
                    }
                    let (links, point, gap) = (met.links.map(|link| link.0), met.point, met.gap);
                    self.collisions.push(Collision { links, point, force, gap });
                }
                continue;
            };
            if impulse[2] <= 0.0 {
                continue;
            }
            let total: Vector3<f64> = (0..3).map(|i| ground.axes[i] * impulse[i]).sum();
            let wrench = Wrench::at(point, total / h, Vector3::zeros());
            let (small, full) = ground.links[*sphere];
            add(&mut self.wrenches, full, &wrench);
            add(&mut self.on_links, small, &wrench);
            for (sum, part) in self
                .ground_sums
                .iter_mut()
                .zip(total.iter().copied().chain([-power[2], -power[0] - power[1]]))
            {
                *sum += part;
            }
        }
    }
}

/// `ω × v` of a free joint's velocities.
fn turned(v: &[f64]) -> Vector3<f64> {
    Vector3::from_column_slice(&v[3..6]).cross(&Vector3::from_column_slice(&v[..3]))
}

/// Adds what acts on a link to what acts on it already.
fn add(all: &mut Vec<(usize, Wrench<f64>)>, link: usize, wrench: &Wrench<f64>) {
    if let Some((_, sum)) = all.iter_mut().find(|(other, _)| *other == link) {
        sum.force += wrench.force;
        sum.moment += wrench.moment;
    } else {
        all.push((link, *wrench));
    }
}

impl Small {
    /// Finds the accelerations of what dynamics move over a step of `h` (s), impulses and all, and the impulses; of a whole step where
    /// nothing is said.
    pub(super) fn find_impulses(
        &mut self,
        prescribed: &Prescribed,
        (t, y): (f64, &[f64]),
        h: Option<f64>,
    ) -> Result<(), DynamicsError> {
        self.load(prescribed, t, y);
        let Self { maps, numbers, impulses, .. } = self;
        let Some(impulses) = impulses else { return Ok(()) };
        let h = h.unwrap_or(impulses.step);
        for (i, &k) in maps.velocities.iter().enumerate() {
            let force = prescribed.force(i);
            if force.feels() {
                let position = maps.rates_of[i].map_or(0.0, |coordinate| numbers.q[coordinate]);
                let state = (Dual::<2>::variable(position, 0), Dual::variable(numbers.v[k], 1));
                let found = force.at(t, state);
                // What would drive it away is left as it is.
                impulses.led[k] = ((-found.partial(1)).max(0.0), (-found.partial(0)).max(0.0));
            }
        }
        for &Moving { dof, k, .. } in &maps.moving {
            numbers.a[k] = (prescribed.at(dof, t + h)[1] - numbers.v[k]) / h;
        }
        impulses.find(numbers, maps, h)
    }

    /// Writes the state a step of `h` (s) after `y`.
    ///
    /// ```text
    /// v⁺ = v + h·a + M⁻¹Jᵀγ        q⁺ = q + h·q̇(q, v⁺)
    /// ```
    pub(super) fn step_by_impulses(
        &mut self,
        state: &StateMap,
        prescribed: &Prescribed,
        (t, h): (f64, f64),
        y: &[f64],
        next: &mut [f64],
    ) -> Result<(), DynamicsError> {
        self.find_impulses(prescribed, (t, y), Some(h))?;
        let Self { maps, numbers, impulses, .. } = self;
        let Some(impulses) = impulses else { return Ok(()) };
        for allowed in &mut impulses.allowed {
            *allowed = (*allowed - RECOVERY * h).max(0.0);
        }
        let (positions, accounts) = (state.positions(), state.accounts());
        next.copy_from_slice(y);
        next[positions..accounts].copy_from_slice(&impulses.convex.v);
        state.position_rates(next, &mut impulses.rate);
        for (next, rate) in next[..positions].iter_mut().zip(&impulses.rate) {
            *next += h * rate;
        }
        for (_, place) in &impulses.flying {
            // The same velocity along the axes after the step, which have turned as q + h·q̇ has.
            let v = &mut next[positions + place..];
            let half = 0.5 * h * Vector3::from_column_slice(&v[3..6]);
            let turn = UnitQuaternion::from_quaternion(Quaternion::from_parts(1.0, half));
            let along = turn.inverse() * Vector3::from_column_slice(&v[..3]);
            v[..3].copy_from_slice(along.as_slice());
        }
        if !maps.moving.is_empty() {
            // What moves as prescribed bears what the ground does to it.
            let Side { body, q, v, a, .. } = &mut *numbers;
            body.inverse(q, v, a, &impulses.on_links, &mut impulses.tau)?;
        }
        // Dampers with the velocity at the end of the step, over the way of the step.
        let (mut work, mut heat) = (0.0, 0.0);
        for (k, force) in numbers.tau.iter().enumerate() {
            let (mean, end) = (numbers.v[k] + 0.5 * h * numbers.a[k], numbers.v[k] + h * numbers.a[k]);
            let (damping, stiffness) = impulses.led[k];
            let force = if impulses.places[k].is_some() {
                force - h * (damping * numbers.a[k] + stiffness * end)
            } else {
                impulses.tau[k]
            };
            work += force * h * mean;
            if impulses.places[k].is_some() {
                heat += impulses.damping[k] * end * h * mean;
            }
        }
        if numbers.body.has_pushes() {
            let power = h * numbers.body.power();
            work += power;
            if let Some(pushed) = next.last_mut() {
                *pushed += power;
            }
        }
        let [.., push, friction] = impulses.ground_sums;
        next[accounts] += work;
        next[accounts + 1] += heat + push + friction + impulses.loss;
        for (next, part) in next[accounts + 2..].iter_mut().zip(impulses.ground_sums) {
            *next += part;
        }
        Ok(())
    }
}
