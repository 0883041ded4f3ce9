//! Impulses of contact, friction and limits in one step: a convex problem that always has one answer.

pub(crate) mod cholesky;
mod cone;
mod island;
mod search;

use cholesky::Envelope;
use cone::Law;
use island::{Condition, Island};
use nalgebra::DMatrix;

/// The velocities after a step, with the impulses of what touches and what is at its limits.
///
/// ```text
/// v⁺ = argmin ½(v − v*)ᵀM(v − v*) + Σ ℓᵢ(Jᵢv + bᵢ)          γᵢ = −∂ℓᵢ/∂u
/// ```
///
/// `v*` are the velocities without impulses. Each condition has a velocity `u = J·v + b` of one number (a limit) or three (two along
/// the ground, one out of it), and an impulse `γ(u)` that is the projection of `R⁻¹(û − u)` onto what it can be: pushes, and
/// Coulomb's cone. `R` is a small compliance of the step, so that the problem is strictly convex. It is solved by Newton's method
/// with an exact line search, for each island of it by itself: trees of the figure that conditions join. What one does is the same to
/// the bit whatever others stand before it or after it.
///
/// # Source
///
/// A. M. Castro, F. N. Permenter, X. Han, "An Unconstrained Convex Formulation of Compliant Contact", IEEE Transactions on
/// Robotics 39 (2023). That friction is bound by a push known before: D. M. Kaufman, S. Sueda, D. L. James, D. K. Pai, "Staggered
/// projections for frictional contact in multibody systems", ACM Transactions on Graphics 27 (2008).
#[derive(Clone, Debug, Default)]
pub(crate) struct Convex {
    /// How many velocities.
    n: usize,
    /// The lower triangle of the mass matrix, and what of it may not be zero.
    mass: Vec<f64>,
    of_mass: Envelope,
    factors: Vec<f64>,
    /// Whether they are those of the mass.
    is_factored: bool,
    /// The velocities without impulses.
    free: Vec<f64>,
    /// The velocities.
    pub(crate) v: Vec<f64>,
    direction: Vec<f64>,
    momentum: Vec<f64>,
    conditions: Vec<Condition>,
    /// The entries of all rows that are not zero, with their columns.
    entries: Vec<(usize, [f64; 3])>,
    /// By velocity, the tree of the figure that it is of.
    trees: Vec<usize>,
    /// By tree, the least of the trees of its island.
    joined: Vec<usize>,
    /// Velocities and conditions in the order of islands, and the places of velocities in their islands.
    rows: Vec<usize>,
    order: Vec<usize>,
    places: Vec<usize>,
    island: Island,
}

impl Convex {
    /// Room for a problem whose mass matrix has this envelope; kept from step to step. `trees` tells by velocity which tree of the figure
    /// it is of: no entry of the mass matrix joins two. Rows have at most `width` entries that are not zero.
    pub(crate) fn new(of_mass: Envelope, trees: Vec<usize>, conditions: usize, width: usize) -> Self {
        let n = of_mass.len();
        let zeros = || vec![0.0; n];
        let entries = conditions * width.min(n);
        Self {
            n,
            mass: vec![0.0; n * n],
            of_mass,
            factors: vec![0.0; n * n],
            is_factored: false,
            free: zeros(),
            v: zeros(),
            direction: zeros(),
            momentum: zeros(),
            conditions: Vec::with_capacity(conditions),
            entries: Vec::with_capacity(entries),
            joined: vec![0; trees.iter().max().map_or(0, |most| most + 1)],
            trees,
            rows: (0..n).collect(),
            order: Vec::with_capacity(conditions),
            places: vec![0; n],
            island: Island::with_room(n, conditions, entries),
        }
    }

    /// More momentum for the velocities without impulses.
    pub(crate) fn push(&mut self, momentum: impl Iterator<Item = f64>) {
        self.direction.iter_mut().zip(momentum).for_each(|(to, from)| *to = from);
        if !self.is_factored {
            self.factor_mass();
        }
        self.of_mass.solve(&self.factors, &mut self.direction);
        for (free, direction) in self.free.iter_mut().zip(&self.direction) {
            *free += direction;
        }
    }

    fn factor_mass(&mut self) {
        self.of_mass.copy((&self.of_mass, &self.mass), &mut self.factors);
        self.of_mass.factor(&mut self.factors);
        self.is_factored = true;
    }

    /// The velocities without impulses.
    pub(crate) fn free(&self) -> &[f64] {
        &self.free
    }

    /// Begins a problem without conditions: the mass matrix of `matrix` for the degrees of freedom `of`, the velocities before the
    /// step, and the change of them that forces would make if they stayed as they are; of these forces `−d·v − k·q` are those of the
    /// end of the step, with `held` = `(h·d, h²·k)` by degree of freedom:
    ///
    /// ```text
    /// (M + h·D + h²·K)·(v* − v) = M·Δv − h²·K·v
    /// ```
    pub(crate) fn begin(
        &mut self,
        matrix: &DMatrix<f64>,
        of: &[usize],
        before: &[f64],
        change: impl Iterator<Item = f64>,
        held: impl Fn(usize) -> (f64, f64),
    ) {
        let n = self.n;
        for (i, &row) in of.iter().enumerate() {
            for (j, &column) in of.iter().enumerate().take(i + 1).skip(self.of_mass.first(i)) {
                self.mass[i * n + j] = matrix[(column, row)];
            }
        }
        self.v.copy_from_slice(before);
        self.conditions.clear();
        self.entries.clear();
        self.direction.iter_mut().zip(change).for_each(|(to, from)| *to = from);
        self.is_factored = false;
        if of.iter().any(|k| held(*k) != (0.0, 0.0)) {
            self.of_mass.times(&self.mass, &self.direction, &mut self.momentum);
            for (i, k) in of.iter().enumerate() {
                let (damping, stiffness) = held(*k);
                self.momentum[i] -= stiffness * before[i];
                self.mass[i * n + i] += damping + stiffness;
            }
            self.factor_mass();
            self.direction.copy_from_slice(&self.momentum);
            self.of_mass.solve(&self.factors, &mut self.direction);
        }
        for (free, (before, change)) in self.free.iter_mut().zip(before.iter().zip(&self.direction)) {
            *free = before + change;
        }
    }

    /// Begins a condition; its entries follow.
    pub(crate) fn condition(&mut self) {
        self.conditions.push(Condition::at(self.entries.len()));
    }

    /// An entry of the condition's rows that is not zero.
    pub(crate) fn entry(&mut self, column: usize, rows: [f64; 3]) {
        self.entries.push((column, rows));
        if let Some(last) = self.conditions.last_mut() {
            last.count += 1;
        }
    }

    /// The compliance that a unit mass would have at each row of the condition: `Σ J²/M_kk`.
    fn lightness(&self, condition: &Condition) -> [f64; 3] {
        let mut sum = [0.0; 3];
        for (column, rows) in &self.entries[condition.first..][..condition.count] {
            let mass = self.mass[column * self.n + column];
            for (sum, row) in sum.iter_mut().zip(rows) {
                *sum += row * row / mass;
            }
        }
        sum
    }

    /// Ends a contact: `bias` is the velocity that is not the unknowns', `gap` how far it is off (m), in a step of `h` (s); its spring
    /// has a stiffness (N/m) and a time of relaxation (s). Friction is bound by `push` (N s) to begin with, where that is above zero: a
    /// guess, such as the push of the step before.
    pub(crate) fn contact(
        &mut self,
        bias: [f64; 3],
        friction: f64,
        gap: f64,
        (stiffness, relaxation): (f64, f64),
        push: f64,
        h: f64,
    ) {
        let Some(last) = self.conditions.last().copied() else { return };
        let [x, y, z] = self.lightness(&last);
        let law = Law::contact([0.5 * (x + y), z], friction, gap, (stiffness, relaxation), h);
        let law = if push > 0.0 { law.bound_by(push) } else { law };
        if let Some(last) = self.conditions.last_mut() {
            (last.law, last.bias) = (law, bias);
        }
    }

    /// Ends a limit that is `gap` (rad or m) away and pushes along its one row; what comes with the speed `[speed, e]` (rad/s or m/s) bounces
    /// off it with `e` times that.
    pub(crate) fn limit(&mut self, gap: f64, bounce: [f64; 2], h: f64) {
        let Some(last) = self.conditions.last().copied() else { return };
        let law = Law::limit(self.lightness(&last)[2], gap, bounce, h);
        if let Some(last) = self.conditions.last_mut() {
            last.law = law;
        }
    }

    /// Ends three velocities that are held at a target; `bias` is the part of them that is not the unknowns'.
    pub(crate) fn hold(&mut self, bias: [f64; 3], target: [f64; 3]) {
        let Some(last) = self.conditions.last().copied() else { return };
        let law = Law::hold(self.lightness(&last), target);
        if let Some(last) = self.conditions.last_mut() {
            (last.law, last.bias) = (law, bias);
        }
    }

    /// The impulse and the mean velocity (before and after the step, if `before` are the velocities before it) of each condition.
    pub(crate) fn impulses<'a>(
        &'a self,
        before: &'a [f64],
    ) -> impl Iterator<Item = ([f64; 3], [f64; 3])> + 'a {
        self.conditions.iter().map(|condition| {
            let old = condition.along(&self.entries, before);
            let mean = [0, 1, 2].map(|i| 0.5 * (old[i] + condition.bias[i] + condition.u[i]));
            (condition.pushed.impulse, mean)
        })
    }

    /// Solves it; the number of Newton's steps.
    pub(crate) fn solve(&mut self) -> usize {
        self.join();
        let (mut steps, mut solved, mut begun) = (0, 0, 0);
        while solved < self.rows.len() || begun < self.order.len() {
            // What moves nothing comes last, without any velocity.
            let island = self.rows.get(solved).map(|row| self.joined[self.trees[*row]]);
            let end =
                self.rows[solved..].partition_point(|row| Some(self.joined[self.trees[*row]]) == island);
            let last = self.order[begun..].partition_point(|index| self.island_of(*index) == island);
            let (rows, conditions) = (solved..solved + end, begun..begun + last);
            (solved, begun) = (rows.end, conditions.end);
            if conditions.is_empty() {
                for row in &self.rows[rows] {
                    self.v[*row] = self.free[*row];
                }
                continue;
            }
            self.gather(rows.clone(), conditions.clone());
            steps += self.island.solve();
            for (row, v) in self.rows[rows].iter().zip(&self.island.v) {
                self.v[*row] = *v;
            }
            for (index, found) in self.order[conditions].iter().zip(&self.island.conditions) {
                let condition = &mut self.conditions[*index];
                (condition.law, condition.u, condition.pushed) = (found.law, found.u, found.pushed);
            }
        }
        steps
    }

    /// Finds which trees conditions join, and puts velocities and conditions in the order of islands.
    fn join(&mut self) {
        self.joined.iter_mut().enumerate().for_each(|(tree, joined)| *joined = tree);
        for condition in &self.conditions {
            let entries = &self.entries[condition.first..][..condition.count];
            for pair in entries.windows(2) {
                let [a, b] = [0, 1].map(|i| self.trees[pair[i].0]).map(|tree| root(&self.joined, tree));
                self.joined[a.max(b)] = a.min(b);
            }
        }
        for tree in 0..self.joined.len() {
            // Those before it are at their roots already.
            self.joined[tree] = self.joined[self.joined[tree]];
        }
        let (joined, trees) = (&self.joined, &self.trees);
        self.rows.sort_unstable_by_key(|row| (joined[trees[*row]], *row));
        let mut order = std::mem::take(&mut self.order);
        order.clear();
        order.extend(0..self.conditions.len());
        order.sort_unstable_by_key(|index| (self.island_of(*index).unwrap_or(usize::MAX), *index));
        self.order = order;
    }

    /// The island of a condition; none where nothing is moved by it.
    fn island_of(&self, condition: usize) -> Option<usize> {
        let Condition { first, count, .. } = self.conditions[condition];
        self.entries[first..][..count].first().map(|(column, _)| self.joined[self.trees[*column]])
    }

    /// Puts velocities and conditions of an island in its place.
    fn gather(&mut self, rows: std::ops::Range<usize>, conditions: std::ops::Range<usize>) {
        let (island, rows) = (&mut self.island, &self.rows[rows]);
        let n = rows.len();
        island.resize(n);
        for (place, row) in rows.iter().enumerate() {
            self.places[*row] = place;
            let first = self.places[self.of_mass.first(*row)];
            island.of_mass.begin(place, first);
            let own = &self.mass[row * self.n..][..self.n];
            let entries = &mut island.mass[place * n..][first..=place];
            entries.iter_mut().zip(&rows[first..]).for_each(|(to, column)| *to = own[*column]);
            (island.free[place], island.v[place]) = (self.free[*row], self.v[*row]);
        }
        for index in &self.order[conditions] {
            let condition = self.conditions[*index];
            let entries = &self.entries[condition.first..][..condition.count];
            let first = island.entries.len();
            island.entries.extend(entries.iter().map(|(column, rows)| (self.places[*column], *rows)));
            island.conditions.push(Condition { first, ..condition });
        }
    }
}

/// The least tree that one is joined to.
fn root(joined: &[usize], mut tree: usize) -> usize {
    while joined[tree] != tree {
        tree = joined[tree];
    }
    tree
}

#[cfg(test)]
mod tests;
