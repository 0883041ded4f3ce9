//! The dynamics of what is left of a figure, between the state and its rates.

use super::Role;
use super::impulses::Impulses;
use super::prescribed::Prescribed;
use super::reduction::{Reduction, Source};
use super::state::{GROUND, StateMap, unit};
use crate::between::Between;
use crate::body::{Body, Pressure, Pushing};
use crate::contact::{ContactPatch, count};
use crate::drive::force::Force;
use crate::failure::SetupError;
use crate::report::Energy;
use crate::time::RateError;
use nalgebra::{DMatrix, Vector3};
use solaris_dynamics::scalar::Dual;
use solaris_dynamics::{DynamicsError, Wrench};
use solaris_profiles::Elementary;

/// How many columns of a Jacobian are found at a time.
const COLUMNS: usize = 8;
/// The most degrees of freedom of a step by impulses: its matrices are full.
const MOST_MOVED: usize = 4096;

/// What is left of a figure, ready to be evaluated.
#[derive(Clone)]
pub(super) struct Small {
    reduction: Reduction,
    pub(super) maps: Maps,
    pub(super) numbers: Side<f64>,
    /// With derivatives; made when the first Jacobian is asked for.
    duals: Option<Box<Side<Dual<COLUMNS>>>>,
    /// What stands on the ground, with the contact points of the small figure.
    planted: Vec<ContactPatch>,
    /// Where the ground and hard limits act by impulses.
    pub(super) impulses: Option<Box<Impulses>>,
    /// What loops do otherwise, where [`tie`](Self::tie) found it last.
    between: Vec<Between>,
}

/// Where the entries of the state are in the small figure.
#[derive(Clone)]
pub(super) struct Maps {
    /// By degree of freedom of the small figure.
    prescribed: Vec<bool>,
    /// For each position of the state, its index in the small `q`.
    positions: Vec<usize>,
    /// For each velocity of the state, its index in the small `v`.
    pub(super) velocities: Vec<usize>,
    /// For each velocity of the state, the index in the small `q` of what it is the rate of; none in ball and free joints.
    pub(super) rates_of: Vec<Option<usize>>,
    /// The first entries of quaternions in the state.
    quaternions: Vec<usize>,
    pub(super) moving: Vec<Moving>,
}

/// A degree of freedom that has a motion of its own.
#[derive(Clone)]
pub(super) struct Moving {
    /// In the full figure.
    pub(super) dof: usize,
    /// In the small figure.
    pub(super) k: usize,
    /// In the small figure.
    coordinate: usize,
}

/// The small figure in one scalar.
#[derive(Clone)]
pub(super) struct Side<T> {
    pub(super) body: Body<T>,
    pub(super) q: Vec<T>,
    pub(super) v: Vec<T>,
    pub(super) a: Vec<T>,
    pub(super) tau: Vec<T>,
    /// The state, and its rate.
    y: Vec<T>,
    rate: Vec<T>,
}

impl Small {
    /// What `reduction` leaves, everything standing as `prescribed` says.
    pub(super) fn new(
        source: &Source,
        roles: &[Role],
        reduction: Reduction,
        state: &StateMap,
        prescribed: &Prescribed,
    ) -> Result<Self, SetupError> {
        let maps = Maps::new(source, roles, &reduction, state);
        let mut numbers = Side::new(source, &reduction, state)?;
        for (q, full) in numbers.q.iter_mut().zip(&reduction.kept_q) {
            *q = prescribed.standing()[*full];
        }
        Ok(Self {
            reduction,
            maps,
            numbers,
            duals: None,
            planted: Vec::new(),
            impulses: None,
            between: Vec::new(),
        })
    }

    /// From now on the ground and hard limits act by impulses, in steps of this length (s).
    pub(super) fn act_by_impulses(
        &mut self,
        source: &Source,
        state: &StateMap,
        step: f64,
    ) -> Result<(), SetupError> {
        let dofs = self.maps.velocities.len();
        if dofs > MOST_MOVED {
            return Err(SetupError::Range {
                what: "the number of degrees of freedom that dynamics move in steps by impulses".to_owned(),
                value: dofs as f64,
                range: "at most 4096: freeze what need not move, or simulate what does not touch by itself",
            });
        }
        self.numbers.body.touch_by_impulses(true);
        self.numbers.body.close(Vec::new());
        self.duals = None;
        let impulses = Impulses::new(source, &self.reduction, &self.maps, state, step);
        self.impulses = Some(Box::new(impulses));
        Ok(())
    }

    /// From now on these stand on the ground; contact points are those of the full figure, on links that dynamics move.
    pub(super) fn plant(&mut self, patches: &[ContactPatch]) {
        let place = |touch: &usize| self.touch(*touch);
        let small = |patch: &ContactPatch| ContactPatch {
            contact_points: patch.contact_points.iter().filter_map(place).collect(),
            corners: patch.corners.iter().filter_map(place).collect(),
            levers: Vec::new(),
            slides: patch.slides,
        };
        self.planted = patches.iter().map(small).collect();
        self.numbers.body.plant(&self.planted);
        if let Some(duals) = &mut self.duals {
            duals.body.plant(&self.planted);
        }
    }

    /// From now on the limits of a degree of freedom of the full figure, where they push back, do this.
    pub(super) fn hold_limit(&mut self, dof: usize, pushing: Pushing) {
        if let Ok(k) = self.reduction.kept_v.binary_search(&dof) {
            self.numbers.body.hold_limit(k, pushing);
        }
    }

    /// The index of a touch of the full figure among those of the small one.
    fn touch(&self, full: usize) -> Option<usize> {
        self.reduction.kept_touches.binary_search(&full).ok()
    }

    /// What the ground does to each contact patch (N, N m, about the world's origin), in the state that was [solved](Self::solve) last.
    pub(super) fn patch_wrenches(&self) -> impl Iterator<Item = Wrench<f64>> {
        self.numbers.body.patch_wrenches()
    }

    /// Where the lowest point of a touch of the full figure is (m), and how far above the ground, in that state; none where it was
    /// left out.
    pub(super) fn lowest(&self, touch: usize) -> Option<(Vector3<f64>, f64)> {
        let touch = self.touch(touch)?;
        Some((self.numbers.body.lowest(touch), self.numbers.body.gap(touch)))
    }

    /// Places the links as in a state.
    pub(super) fn place(&mut self, prescribed: &Prescribed, t: f64, y: &[f64]) -> Result<(), DynamicsError> {
        self.load(prescribed, t, y);
        let Side { body, q, .. } = &mut self.numbers;
        body.place(q)
    }

    /// Finds the accelerations of what dynamics move and the forces of the drives on all else.
    pub(super) fn solve(&mut self, prescribed: &Prescribed, t: f64, y: &[f64]) -> Result<(), DynamicsError> {
        self.load(prescribed, t, y);
        self.numbers.solve(&self.maps)
    }

    /// Finds what loops do, in the state that was [solved](Self::solve) last.
    pub(super) fn tie(&mut self) {
        let (between, body) = (&mut self.between, &self.numbers.body);
        between.clear();
        self.reduction.loops.closing(body, |tied| between.push(tied));
    }

    /// What links do to each other.
    pub(super) fn between(&self) -> &[Between] {
        self.impulses.as_ref().map_or(&self.between, |impulses| impulses.between())
    }

    /// Writes the rate of the state that was [solved](Self::solve) last.
    pub(super) fn write_rates(&mut self, state: &StateMap, rate: &mut [f64]) {
        self.numbers.find_rates(state, &self.maps);
        rate.copy_from_slice(&self.numbers.rate);
    }

    /// Writes the accelerations of the state that was [solved](Self::solve) last into the full `a`.
    pub(super) fn write_accelerations(&self, a: &mut [f64]) {
        for k in &self.maps.velocities {
            a[self.reduction.kept_v[*k]] = self.numbers.a[*k];
        }
    }

    /// The force of its drive on a degree of freedom of the full figure, in the state that was [solved](Self::solve) last; none
    /// where it was left out.
    pub(super) fn force(&self, dof: usize) -> Option<f64> {
        self.reduction.kept_v.binary_search(&dof).ok().map(|k| self.numbers.tau[k])
    }

    /// Whether no link, no spring and no touch was dropped, and the forces on these degrees of freedom of the full figure are known.
    pub(super) fn is_complete(&self, source: &Source, dofs: &[usize]) -> bool {
        let Reduction { dropped, springs, surface, .. } = &self.reduction;
        let all = dropped.is_empty()
            && springs.len() == source.springs.len()
            && count(surface.as_ref()) == count(source.surface.as_ref());
        all && dofs.iter().all(|dof| self.force(*dof).is_some())
    }

    /// The energy of a state.
    pub(super) fn energy(
        &mut self,
        prescribed: &Prescribed,
        t: f64,
        y: &[f64],
    ) -> Result<Energy, DynamicsError> {
        self.load(prescribed, t, y);
        let Side { body, q, v, .. } = &mut self.numbers;
        body.energy(q, v)
    }

    /// The part of the mass matrix that belongs to what dynamics move, in the order of the state.
    pub(super) fn mass_matrix(
        &mut self,
        prescribed: &Prescribed,
        t: f64,
        y: &[f64],
    ) -> Result<DMatrix<f64>, DynamicsError> {
        self.load(prescribed, t, y);
        let Side { body, q, v, .. } = &mut self.numbers;
        let mut matrix = DMatrix::zeros(v.len(), v.len());
        body.mass_matrix(q, &mut matrix)?;
        let moved = &self.maps.velocities;
        if moved.iter().copied().eq(0..matrix.nrows()) {
            return Ok(matrix);
        }
        Ok(DMatrix::from_fn(moved.len(), moved.len(), |i, j| matrix[(moved[i], moved[j])]))
    }

    /// Writes `∂ẏ/∂y`, by exact derivatives.
    pub(super) fn jacobian(
        &mut self,
        source: &Source,
        state: &StateMap,
        prescribed: &Prescribed,
        (t, y): (f64, &[f64]),
        jacobian: &mut DMatrix<f64>,
    ) -> Result<(), RateError> {
        self.load(prescribed, t, y);
        let duals = if let Some(duals) = self.duals.take() {
            duals
        } else {
            let mut duals = Box::new(Side::new(source, &self.reduction, state)?);
            duals.body.plant(&self.planted);
            if self.impulses.is_some() {
                duals.body.close(Vec::new());
            }
            duals
        };
        let duals = self.duals.insert(duals);
        duals.body.hold_limits_as(&self.numbers.body);
        duals.take_constants(&self.numbers);
        for (push, full) in self.reduction.kept_pushes.iter().enumerate() {
            duals.body.set_push(push, &prescribed.push(*full, t));
        }
        // Nothing depends on the accounts.
        let columns = state.accounts();
        for first in (0..columns).step_by(COLUMNS) {
            let seeded = first..columns.min(first + COLUMNS);
            for (i, (entry, value)) in duals.y.iter_mut().zip(y).enumerate() {
                *entry = if seeded.contains(&i) {
                    Dual::variable(*value, i - first)
                } else {
                    Dual::constant(*value)
                };
            }
            duals.read(&self.maps);
            for i in (0..self.maps.velocities.len()).filter(|i| prescribed.force(*i).feels()) {
                duals.drive(&self.maps, i, prescribed.force(i), t);
            }
            duals.solve(&self.maps)?;
            duals.find_rates(state, &self.maps);
            for (row, rate) in duals.rate.iter().enumerate() {
                for column in seeded.clone() {
                    jacobian[(row, column)] = rate.partial(column - first);
                }
            }
        }
        let bad = jacobian.iter().position(|value| !value.is_finite());
        bad.map_or(Ok(()), |bad| {
            Err(RateError::NotFinite { index: bad % state.len(), value: jacobian.as_slice()[bad] })
        })
    }

    /// Takes in a state, what has a motion of its own, and the forces of the drives.
    pub(super) fn load(&mut self, prescribed: &Prescribed, t: f64, y: &[f64]) {
        let numbers = &mut self.numbers;
        for &Moving { dof, k, coordinate } in &self.maps.moving {
            let [position, velocity, acceleration] = prescribed.at(dof, t);
            numbers.q[coordinate] = position;
            (numbers.v[k], numbers.a[k]) = (velocity, acceleration);
        }
        for (push, full) in self.reduction.kept_pushes.iter().enumerate() {
            numbers.body.set_push(push, &prescribed.push(*full, t));
        }
        numbers.y.copy_from_slice(y);
        numbers.read(&self.maps);
        for i in 0..self.maps.velocities.len() {
            numbers.drive(&self.maps, i, prescribed.force(i), t);
        }
    }
}

impl Maps {
    fn new(source: &Source, roles: &[Role], reduction: &Reduction, state: &StateMap) -> Self {
        let small_q = |full: &usize| reduction.kept_q.binary_search(full).ok();
        let small_v = |full: &usize| reduction.kept_v.binary_search(full).ok();
        let moving = |(k, dof): (usize, &usize)| {
            let coordinate = source.figure.layout().coordinate(*dof).as_ref().and_then(small_q)?;
            (roles[*dof] == Role::Prescribed).then_some(Moving { dof: *dof, k, coordinate })
        };
        Self {
            prescribed: reduction.kept_v.iter().map(|dof| roles[*dof] != Role::Dynamic).collect(),
            positions: state.coordinates().iter().filter_map(small_q).collect(),
            velocities: state.velocities().iter().filter_map(small_v).collect(),
            rates_of: state
                .velocities()
                .iter()
                .map(|dof| source.figure.layout().coordinate(*dof).as_ref().and_then(small_q))
                .collect(),
            quaternions: state.quaternions().collect(),
            moving: reduction.kept_v.iter().enumerate().filter_map(moving).collect(),
        }
    }
}

impl<T: Elementary> Side<T> {
    fn new(source: &Source, reduction: &Reduction, state: &StateMap) -> Result<Self, DynamicsError> {
        let Reduction { figure, springs, limits, surface, kept_q, kept_v, .. } = reduction;
        let zeros = |length: usize| vec![T::zero(); length];
        let mut body = Body::compile(figure, source.gravity, springs, limits)?
            .on(surface.as_ref())
            .pushed(&reduction.pushes);
        body.close(reduction.loops.closures());
        Ok(Self {
            body,
            q: zeros(kept_q.len()),
            v: zeros(kept_v.len()),
            a: zeros(kept_v.len()),
            tau: zeros(kept_v.len()),
            y: zeros(state.len()),
            rate: zeros(state.len()),
        })
    }

    /// Everything but the state as in `numbers`, without derivatives.
    fn take_constants(&mut self, numbers: &Side<f64>) {
        let copy = |to: &mut [T], from: &[f64]| {
            to.iter_mut().zip(from).for_each(|(to, from)| *to = T::from_f64(*from));
        };
        copy(&mut self.q, &numbers.q);
        copy(&mut self.v, &numbers.v);
        copy(&mut self.a, &numbers.a);
        copy(&mut self.tau, &numbers.tau);
    }

    /// Puts the state into `q` and `v`.
    fn read(&mut self, maps: &Maps) {
        let (positions, rest) = self.y.split_at(maps.positions.len());
        for (index, value) in maps.positions.iter().zip(positions) {
            self.q[*index] = *value;
        }
        for (index, value) in maps.velocities.iter().zip(rest) {
            self.v[*index] = *value;
        }
        for entry in &maps.quaternions {
            let turn = unit([0, 1, 2, 3].map(|i| self.y[entry + i]));
            self.q[maps.positions[*entry]..][..4].copy_from_slice(&turn);
        }
    }

    /// Lets a drive act on what the velocity `i` of the state belongs to, in the state that was read.
    fn drive(&mut self, maps: &Maps, i: usize, force: &Force, t: f64) {
        let k = maps.velocities[i];
        let position = maps.rates_of[i].map_or_else(T::zero, |coordinate| self.q[coordinate]);
        self.tau[k] = force.at(t, (position, self.v[k]));
    }

    pub(super) fn solve(&mut self, maps: &Maps) -> Result<(), DynamicsError> {
        self.body.hybrid(&self.q, &self.v, &maps.prescribed, &mut self.a, &mut self.tau)
    }

    fn find_rates(&mut self, state: &StateMap, maps: &Maps) {
        state.position_rates(&self.y, &mut self.rate);
        for (rate, k) in self.rate[maps.positions.len()..].iter_mut().zip(&maps.velocities) {
            *rate = self.a[*k];
        }
        let work = self.tau.iter().zip(&self.v).fold(T::zero(), |work, (force, rate)| work + *force * *rate);
        let accounts = &mut self.rate[state.accounts()..];
        (accounts[0], accounts[1]) = (work, self.body.heat());
        if self.body.has_pushes() {
            let power = self.body.power();
            accounts[0] += power;
            if let Some(pushed) = accounts.last_mut() {
                *pushed = power;
            }
        }
        if let [_, _, ground @ ..] = accounts
            && ground.len() >= GROUND
        {
            let Pressure { force, damping, friction } = self.body.pressure();
            ground[..3].copy_from_slice(force.as_slice());
            (ground[3], ground[4]) = (*damping, *friction);
        }
    }
}
