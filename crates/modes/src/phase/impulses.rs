//! A step by impulses: contact, friction and hard limits of what is left of the figure as one convex problem.

use super::colliding::Colliding;
use super::loops::Loops;
use super::prescribed::Prescribed;
use super::reduction::{Reduction, Source};
use super::rows::{Rows, Sought};
use super::small::{Maps, Moving, Side, Small};
use super::state::StateMap;
use crate::between::{Between, Kind};
use crate::contact::ContactLaw;
use crate::convex::Convex;
use crate::convex::cholesky::Envelope;
use crate::element::LimitLaw;
use nalgebra::{DMatrix, Quaternion, UnitQuaternion, Vector3};
use solaris_dynamics::scalar::Dual;
use solaris_dynamics::{DynamicsError, Wrench};
use solaris_model::JointKind;

/// A limit this near (rad or m) may be come to within a step, whatever the velocity.
const CLOSE: f64 = 1e-3;

/// What comes to a limit with less than this many times what a step changes its speed by does not bounce.
const RESTS: f64 = 4.0;

/// Stiffness (N/m) and relaxation (s) of what is as stiff as a step allows.
const RIGID: (f64, f64) = (f64::INFINITY, 0.0);

/// How fast (m/s or rad/s) what begins in the ground or beyond a limit is brought out.
const RECOVERY: f64 = 0.1;

/// The least part of a step within which loops draw together what has come apart.
const LEAST_PART: f64 = 0.1;

/// What a step by impulses needs, kept from step to step.
#[derive(Clone)]
pub(super) struct Impulses {
    convex: Convex,
    /// Of a whole step (s).
    step: f64,
    matrix: DMatrix<f64>,
    /// What dynamics move of the small figure, the leaves of its tree first: factors of matrices then have hardly an entry that the
    /// matrix does not have.
    order: Vec<usize>,
    /// By degree of freedom of the small figure, its place in that order.
    places: Vec<Option<usize>>,
    limits: Vec<Limited>,
    ground: Option<Ground>,
    /// Spheres that may touch within the step: index, gap (m), lowest point.
    near: Vec<(usize, f64, Vector3<f64>)>,
    /// Links that touch each other.
    colliding: Option<Colliding>,
    /// Points that are held together.
    loops: Loops,
    rows: Rows,
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
    /// Free joints that dynamics move: the first degree of freedom in the small figure, and in the state.
    flying: Vec<(usize, usize)>,
    /// Velocities in the middle of the step, accelerations, and forces of inertia at the velocities before it and in its middle.
    middle: Vec<f64>,
    turning: Vec<f64>,
    inertial: [Vec<f64>; 2],
    /// How the ground pushed each sphere in the step before (N s).
    pushes: Vec<f64>,
    /// What the ground does to links (N, N m, about the world's origin), by sphere.
    wrenches: Vec<(usize, Wrench<f64>)>,
    /// The same by the links of the small figure.
    on_links: Vec<(usize, Wrench<f64>)>,
    /// What links do to each other.
    between: Vec<Between>,
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
    restitution: f64,
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
        let order: Vec<usize> = maps.velocities.iter().rev().copied().collect();
        for (place, k) in order.iter().enumerate() {
            places[*k] = Some(place);
        }
        let (mut limits, mut flying) = (Vec::new(), Vec::new());
        for (link, at) in reduction.figure.links().iter().zip(reduction.figure.layout().joints()) {
            let is_free = matches!(link.joint().kind(), JointKind::Free { .. });
            let in_state = maps.velocities.iter().position(|k| *k == at.v).filter(|_| is_free);
            flying.extend(in_state.map(|index| (at.v, index)));
            for (i, axis) in link.joint().kind().axes().iter().enumerate() {
                let LimitLaw::Hard { restitution } = reduction.limits[at.v + i] else { continue };
                // Ball joints have none.
                let coordinate = reduction.figure.layout().coordinate(at.v + i);
                if let (Some(range), Some(place), Some(coordinate)) =
                    (axis.limits, places[at.v + i], coordinate)
                {
                    let (lower, upper) = (range.lower, range.upper);
                    limits.push(Limited { place, coordinate, lower, upper, restitution });
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
        let loops = reduction.loops.conditions();
        let pairs = reduction.colliding.as_ref().map_or(0, Colliding::len);
        let (dofs, conditions) = (maps.velocities.len(), spheres + pairs + 2 * limits.len());
        // A condition is of two links, each with those that carry it.
        let mut carried: Vec<usize> = Vec::with_capacity(reduction.figure.links().len());
        for (link, at) in reduction.figure.links().iter().zip(reduction.figure.layout().joints()) {
            carried.push(at.nv + link.parent().map_or(0, |parent| carried[parent]));
        }
        let width = 2 * carried.into_iter().max().unwrap_or(0);
        let (of_mass, trees) = of_mass(reduction, &places, dofs);
        Self {
            convex: Convex::new(of_mass, trees, conditions + loops, width),
            step,
            order,
            matrix: DMatrix::zeros(nv, nv),
            places,
            limits,
            ground,
            near: Vec::with_capacity(spheres),
            colliding: reduction.colliding.clone(),
            loops: reduction.loops.clone(),
            rows: Rows::new(nv),
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
            pushes: vec![0.0; spheres],
            wrenches: Vec::with_capacity(spheres),
            on_links: Vec::with_capacity(spheres),
            between: Vec::with_capacity(pairs + loops),
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

    /// What links do to each other, in the step that was found last.
    pub(super) fn between(&self) -> &[Between] {
        &self.between
    }

    /// Finds the velocities after a step of `h` (s) and the impulses in it.
    fn find(&mut self, side: &mut Side<f64>, maps: &Maps, h: f64) -> Result<(), DynamicsError> {
        side.solve(maps)?;
        for (free, (v, a)) in self.free.iter_mut().zip(side.v.iter().zip(&side.a)) {
            *free = v + h * a;
        }
        for (before, k) in self.before.iter_mut().zip(&self.order) {
            *before = side.v[*k];
        }
        side.body.mass_matrix(&side.q, &mut self.matrix)?;
        side.body.holds_back(&side.q, &side.v, &mut self.damping, &mut self.stiffness);
        for (change, k) in self.change.iter_mut().zip(&self.order) {
            *change = h * side.a[*k];
        }
        for (k, _) in &self.flying {
            for (place, turn) in self.places[*k..].iter().zip(&turned(&side.v[*k..])) {
                place.map(|place| self.change[place] += h * turn);
            }
        }
        let held = |k: usize| {
            let (damping, stiffness) = self.led[k];
            (h * (self.damping[k] + damping), h * h * (self.stiffness[k] + stiffness))
        };
        let change = self.change.iter().copied();
        self.convex.begin(&self.matrix, &self.order, &self.before, change, held);
        self.go_half_way(side, h)?;
        self.meet(side, h)?;
        if !self.loops.is_empty() {
            // On the way of the step joints have the velocities of its end. What is prescribed does not: it falls short by h²·a/2.
            turn(&self.flying, &side.v, &mut self.turning);
            let given = |k: &usize| self.places[*k].is_none();
            for k in (0..self.turning.len()).filter(given) {
                self.turning[k] = -side.a[k];
            }
            side.body.accelerations((&side.q, &side.v, &self.turning))?;
            for k in (0..self.turning.len()).filter(given) {
                self.turning[k] = 0.0;
            }
        }
        let (rows, sought) = (&mut self.rows, Sought { places: &self.places, given: &self.free });
        // What came apart over a step is not to be drawn together in the moment before an event.
        let within = h.max(LEAST_PART * self.step);
        self.loops.hold(&side.body, rows, sought, &mut self.convex, (self.begun, h, within));
        let of_limits = self.allowed.len() - 2 * self.limits.len();
        let pairs = self.allowed[of_limits..].chunks_exact_mut(2);
        for (limited, allowed) in self.limits.iter().zip(pairs) {
            let &Limited { place, coordinate, lower, upper, restitution } = limited;
            let (q, reach) = (side.q[coordinate], CLOSE + 2.0 * h * self.before[place].abs());
            for ((gap, row), allowed) in [(q - lower, 1.0), (upper - q, -1.0)].into_iter().zip(allowed) {
                if !self.begun {
                    *allowed = (-gap).max(0.0);
                }
                let gap = gap + *allowed;
                if gap < reach {
                    self.convex.condition();
                    self.convex.entry(place, [0.0, 0.0, row]);
                    // What lies at the limit comes to it with what a step moves it by, and stays.
                    let lies = RESTS * (self.convex.free()[place] - self.before[place]).abs();
                    let speed = -row * self.before[place];
                    let bounces = speed > lies && gap < h * speed;
                    self.convex.limit(gap, [if bounces { speed } else { 0.0 }, restitution], h);
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
    fn go_half_way(&mut self, side: &mut Side<f64>, h: f64) -> Result<(), DynamicsError> {
        for (k, middle) in self.middle.iter_mut().enumerate() {
            let free = self.places[k].map_or(self.free[k], |place| self.convex.free()[place]);
            *middle = 0.5 * (side.v[k] + free);
        }
        let [before, middle] = &mut self.inertial;
        for (v, forces) in [(&side.v, before), (&self.middle, middle)] {
            turn(&self.flying, v, &mut self.turning);
            side.body.inertial_forces((&side.q, v, &self.turning), forces)?;
        }
        let [before, middle] = &self.inertial;
        self.convex.push(self.order.iter().map(|k| h * (before[*k] - middle[*k])));
        Ok(())
    }

    /// The conditions of what touches the ground, and of links that touch each other.
    ///
    /// ```text
    /// u = J₁·v − J₂·v
    /// ```
    fn meet(&mut self, side: &mut Side<f64>, h: f64) -> Result<(), DynamicsError> {
        self.near.clear();
        if self.ground.is_none() && self.colliding.is_none() && self.loops.is_empty() {
            return Ok(());
        }
        side.body.velocities(&side.q, &side.v)?;
        side.body.joint_jacobians(&side.q)?;
        let Self { convex, rows, allowed, begun, places, free, .. } = self;
        let (body, sought) = (&side.body, Sought { places, given: free });
        let mut of_pairs = 0;
        if let Some(ground) = &self.ground {
            of_pairs = ground.links.len();
            body.nearly_touching(2.0 * h, &mut self.near);
            for (sphere, gap, point) in &self.near {
                let allowed = &mut allowed[*sphere];
                if !*begun && ground.spring.0.is_infinite() {
                    *allowed = (-gap).max(0.0);
                }
                rows.add_point(body, (ground.links[*sphere].0, point), &ground.axes, 1.0);
                let bias = rows.begin(convex, sought);
                let push = self.pushes[*sphere];
                convex.contact(bias, ground.friction, gap + *allowed, ground.spring, push, h);
            }
        }
        if let Some(colliding) = &mut self.colliding {
            let allowed = &mut allowed[of_pairs..];
            colliding.find(body, 2.0 * h);
            for met in colliding.met.iter().filter(|_| !*begun) {
                allowed[met.pair] = allowed[met.pair].max(-met.gap);
            }
            for met in &colliding.met {
                for ((_, link), sign) in met.links.into_iter().zip([1.0, -1.0]) {
                    rows.add_point(body, (link, &met.point), &met.axes, sign);
                }
                let bias = rows.begin(convex, sought);
                let (gap, push) = (met.gap + allowed[met.pair], colliding.pushed_before(met));
                convex.contact(bias, colliding.friction, gap, RIGID, push, h);
            }
        }
        Ok(())
    }

    /// Keeps the pushes of the step, for the next one to begin with.
    fn remember(&mut self) {
        self.pushes.fill(0.0);
        let mut pushes = self.convex.impulses(&self.before).map(|(impulse, _)| impulse[2]);
        for ((sphere, ..), push) in self.near.iter().zip(pushes.by_ref()) {
            self.pushes[*sphere] = push;
        }
        if let Some(colliding) = &mut self.colliding {
            colliding.remember(pushes);
        }
    }

    /// Forces and losses of the impulses that were found.
    fn account(&mut self, h: f64) {
        self.wrenches.clear();
        self.on_links.clear();
        self.between.clear();
        (self.ground_sums, self.loss) = ([0.0; 5], 0.0);
        let mut impulses = self.convex.impulses(&self.before);
        let power = |(impulse, mean): &([f64; 3], [f64; 3])| [0, 1, 2].map(|i| impulse[i] * mean[i]);
        if let Some(ground) = &self.ground {
            for ((sphere, _, point), found) in self.near.iter().zip(impulses.by_ref()) {
                if found.0[2] <= 0.0 {
                    continue;
                }
                let total: Vector3<f64> = (0..3).map(|i| ground.axes[i] * found.0[i]).sum();
                let wrench = Wrench::at(point, total / h, Vector3::zeros());
                let (small, full) = ground.links[*sphere];
                add(&mut self.wrenches, full, &wrench);
                add(&mut self.on_links, small, &wrench);
                let power = power(&found);
                let parts = total.iter().copied().chain([-power[2], -power[0] - power[1]]);
                self.ground_sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part);
            }
        }
        for (met, found) in self.colliding.iter().flat_map(|all| &all.met).zip(impulses.by_ref()) {
            if found.0[2] <= 0.0 {
                continue;
            }
            self.loss -= power(&found).iter().sum::<f64>();
            let force: Vector3<f64> = (0..3).map(|i| met.axes[i] * (found.0[i] / h)).sum();
            let (points, kind) = ([met.point; 2], Kind::Touch { gap: met.gap });
            let links = met.links.map(|link| Some(link.0));
            let between = Between { links, points, force, moment: Vector3::zeros(), kind };
            for (link, wrench) in between.wrenches(met.links.map(|link| Some(link.1))) {
                add(&mut self.on_links, link, &wrench);
            }
            self.between.push(between);
        }
        let (on_links, all, loss) = (&mut self.on_links, &mut self.between, &mut self.loss);
        let held = impulses.by_ref().take(self.loops.conditions()).map(|found| {
            *loss -= power(&found).iter().sum::<f64>();
            found.0
        });
        self.loops.forces(held, h, |small, between| {
            for (link, wrench) in between.wrenches(small) {
                add(on_links, link, &wrench);
            }
            all.push(between);
        });
        // Limits, along the third number.
        self.loss -= impulses.map(|found| power(&found)[2]).sum::<f64>();
    }
}

/// What may not be zero of the mass matrix, at these places, and which tree each is of: a joint shares inertia with what it carries, and
/// with nothing else.
fn of_mass(reduction: &Reduction, places: &[Option<usize>], dofs: usize) -> (Envelope, Vec<usize>) {
    let (links, joints) = (reduction.figure.links(), reduction.figure.layout().joints());
    let own = |link: usize| places[joints[link].v..][..joints[link].nv].iter().flatten().copied();
    // The first place of what each link carries, itself included; children have greater indices than their parents.
    let mut carried = vec![dofs; links.len()];
    let mut first = vec![0; dofs];
    for link in (0..links.len()).rev() {
        carried[link] = own(link).fold(carried[link], usize::min);
        own(link).for_each(|place| first[place] = carried[link]);
        if let Some(parent) = links[link].parent() {
            carried[parent] = carried[parent].min(carried[link]);
        }
    }
    let (mut trees, mut tree_of, mut count) = (vec![0; dofs], vec![None; links.len()], 0);
    for link in 0..links.len() {
        let inherited = links[link].parent().and_then(|parent| tree_of[parent]);
        tree_of[link] = inherited.or_else(|| own(link).next().map(|_| count));
        count += usize::from(tree_of[link] != inherited);
        own(link).for_each(|place| trees[place] = tree_of[link].unwrap_or_default());
    }
    (Envelope::new(first), trees)
}

/// Accelerations of free joints whose velocities are told along axes that turn, and stay as they are along axes that do not: `−ω × v`.
fn turn(flying: &[(usize, usize)], v: &[f64], accelerations: &mut [f64]) {
    for (k, _) in flying {
        for (acceleration, turn) in accelerations[*k..].iter_mut().zip(&turned(&v[*k..])) {
            *acceleration = -turn;
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
        next.copy_from_slice(y);
        self.find_impulses(prescribed, (t, y), Some(h))?;
        let Self { maps, numbers, impulses, .. } = self;
        let Some(impulses) = impulses else { return Ok(()) };
        impulses.remember();
        for allowed in &mut impulses.allowed {
            *allowed = (*allowed - RECOVERY * h).max(0.0);
        }
        impulses.loops.draw(RECOVERY * h);
        let (positions, accounts) = (state.positions(), state.accounts());
        for (next, v) in next[positions..accounts].iter_mut().zip(impulses.convex.v.iter().rev()) {
            *next = *v;
        }
        state.position_rates(next, &mut impulses.rate);
        for (next, rate) in next[..positions].iter_mut().zip(&impulses.rate) {
            *next += h * rate;
        }
        for (_, index) in &impulses.flying {
            // The same velocity along the axes after the step, which have turned as q + h·q̇ has.
            let v = &mut next[positions + index..];
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
        let (mut work, mut heat) = (0.0, h * numbers.body.slackens(&numbers.q, &numbers.v));
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
