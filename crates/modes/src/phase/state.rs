//! Where the entries of a phase's state belong.

use super::Role;
use solaris_model::Figure;
use solaris_profiles::Elementary;

/// The state of a phase: positions of what dynamics move, in the order of `q`, its velocities in the order of `v`, and the
/// accounts: work, heat, and with a ground what it does ([`Pressure`](crate::body::Pressure)): its impulse along x, y and z, and
/// what its damping and its friction have taken; last, with pushes, what these have done, which the work has in it too.
///
/// Quaternions are plain numbers here: their rate `½ q⊗(ω, 0)` keeps their length but for the error of the steps, and whoever
/// reads them makes it 1.
#[derive(Clone)]
pub(super) struct StateMap {
    pieces: Vec<Piece>,
    /// For each entry that is a position, its index in the full `q`.
    coordinates: Vec<usize>,
    /// For each entry that is a velocity, its index in the full `v`.
    velocities: Vec<usize>,
    /// For each entry that is a position, the degree of freedom that it belongs to most.
    owners: Vec<usize>,
    /// By degree of freedom of the full figure.
    position_of: Vec<Option<usize>>,
    velocity_of: Vec<Option<usize>>,
    /// How many accounts the ground has.
    ground: usize,
    /// How many accounts pushes have.
    pushed: usize,
}

/// Accounts of a ground.
pub(crate) const GROUND: usize = 5;

/// How some positions go on; all indices are entries of the state.
#[derive(Clone)]
enum Piece {
    /// `q̇ = v`
    Axis { at: usize, rate: usize },
    /// `q̇ = ½ q⊗(ω, 0)`, from `ω` at `rate` on.
    Turn { at: usize, rate: usize },
    /// `ṗ = R(q)·v`, from `v` at `rate` on; the quaternion follows the place.
    Place { at: usize, rate: usize },
}

impl StateMap {
    /// That of `figure` with these roles, on a ground or not, pushed or not; those of a ball or free joint are equal.
    pub(super) fn new(figure: &Figure, roles: &[Role], (grounded, pushed): (bool, bool)) -> Self {
        let layout = figure.layout();
        let velocities: Vec<usize> = (0..roles.len()).filter(|dof| roles[*dof] == Role::Dynamic).collect();
        let (mut coordinates, mut owners) = (Vec::new(), Vec::new());
        for (link, at) in figure.links().iter().zip(layout.joints()) {
            let quaternion = link.joint().kind().quaternion();
            if quaternion.is_none() {
                let dynamic = (0..at.nv).filter(|i| roles[at.v + i] == Role::Dynamic);
                dynamic.for_each(|i| {
                    coordinates.push(at.q + i);
                    owners.push(at.v + i);
                });
            } else if roles[at.v] == Role::Dynamic {
                // The entries x, y, z belong to the turns about these axes, w to all three.
                coordinates.extend(at.q..at.q + at.nq);
                owners.extend((0..at.nq).map(|i| at.v + i.min(at.nv - 1)));
            }
        }
        let mut map = Self {
            pieces: Vec::new(),
            position_of: vec![None; roles.len()],
            velocity_of: vec![None; roles.len()],
            coordinates,
            velocities,
            owners,
            ground: if grounded { GROUND } else { 0 },
            pushed: usize::from(pushed),
        };
        map.find_pieces(figure);
        map
    }

    fn find_pieces(&mut self, figure: &Figure) {
        let layout = figure.layout();
        for (i, dof) in self.velocities.iter().enumerate() {
            self.velocity_of[*dof] = Some(self.coordinates.len() + i);
        }
        for (entry, coordinate) in self.coordinates.iter().enumerate() {
            let dof = self.owners[entry];
            if layout.coordinate(dof) == Some(*coordinate) {
                self.position_of[dof] = Some(entry);
                self.pieces.extend(self.velocity_of[dof].map(|rate| Piece::Axis { at: entry, rate }));
            }
        }
        for (link, at) in figure.links().iter().zip(layout.joints()) {
            let (Some(quaternion), Some(rate)) =
                (link.joint().kind().quaternion(), self.velocity_of.get(at.v))
            else {
                continue;
            };
            let (Some(first), Some(rate)) = (self.coordinates.iter().position(|q| *q == at.q), *rate) else {
                continue;
            };
            if quaternion > 0 {
                self.pieces.push(Piece::Place { at: first, rate });
            }
            self.pieces.push(Piece::Turn { at: first + quaternion, rate: rate + quaternion });
        }
    }

    /// Length of the state.
    pub(super) fn len(&self) -> usize {
        self.accounts() + 2 + self.ground + self.pushed
    }

    /// Number of entries that are positions or velocities: the index of the work, which heat and the ground's accounts follow.
    pub(super) fn accounts(&self) -> usize {
        self.coordinates.len() + self.velocities.len()
    }

    /// Number of entries that are positions.
    pub(super) fn positions(&self) -> usize {
        self.coordinates.len()
    }

    /// Number of degrees of freedom that dynamics move.
    pub(super) fn dofs(&self) -> usize {
        self.velocities.len()
    }

    /// For each entry that is a position, its index in the full `q`.
    pub(super) fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    /// For each entry that is a velocity, its index in the full `v`.
    pub(super) fn velocities(&self) -> &[usize] {
        &self.velocities
    }

    /// The entry that is the coordinate of a degree of freedom; none of one that is not in the state or has none.
    pub(super) fn position_of(&self, dof: usize) -> Option<usize> {
        self.position_of[dof]
    }

    /// The entry that is the velocity of a degree of freedom; none of one that is not in the state.
    pub(super) fn velocity_of(&self, dof: usize) -> Option<usize> {
        self.velocity_of[dof]
    }

    /// The degree of freedom that an entry belongs to.
    pub(super) fn dof_of(&self, entry: usize) -> Option<usize> {
        let velocity = || self.velocities.get(entry.wrapping_sub(self.coordinates.len()));
        self.owners.get(entry).or_else(velocity).copied()
    }

    /// The state of the full `q`, `v`; the accounts of the ground and of pushes begin at zero.
    pub(super) fn pack(&self, q: &[f64], v: &[f64], work: f64, heat: f64) -> Vec<f64> {
        let positions = self.coordinates.iter().map(|index| q[*index]);
        let velocities = self.velocities.iter().map(|index| v[*index]);
        let ground = std::iter::repeat_n(0.0, self.ground + self.pushed);
        positions.chain(velocities).chain([work, heat]).chain(ground).collect()
    }

    /// Writes what is in the state to the full `q`, `v`; quaternions with unit length.
    pub(super) fn unpack(&self, y: &[f64], q: &mut [f64], v: &mut [f64]) {
        let (positions, velocities) = y.split_at(self.coordinates.len());
        for (index, value) in self.coordinates.iter().zip(positions) {
            q[*index] = *value;
        }
        for (index, value) in self.velocities.iter().zip(velocities) {
            v[*index] = *value;
        }
        for at in self.quaternions() {
            let unit = unit([0, 1, 2, 3].map(|i| y[at + i]));
            for (index, value) in self.coordinates[at..at + 4].iter().zip(unit) {
                q[*index] = value;
            }
        }
    }

    /// Gives quaternions unit length.
    pub(super) fn settle(&self, y: &mut [f64]) {
        for at in self.quaternions() {
            let unit = unit([0, 1, 2, 3].map(|i| y[at + i]));
            y[at..at + 4].copy_from_slice(&unit);
        }
    }

    /// The first entries of the quaternions.
    pub(super) fn quaternions(&self) -> impl Iterator<Item = usize> {
        self.pieces
            .iter()
            .filter_map(|piece| if let Piece::Turn { at, .. } = piece { Some(*at) } else { None })
    }

    /// Writes the rates of the positions.
    pub(super) fn position_rates<T: Elementary>(&self, y: &[T], rate: &mut [T]) {
        let half = T::from_f64(0.5);
        for piece in &self.pieces {
            match *piece {
                Piece::Axis { at, rate: from } => rate[at] = y[from],
                Piece::Turn { at, rate: from } => {
                    let ([x, y_, z, w], turn) =
                        ([0, 1, 2, 3].map(|i| y[at + i]), [0, 1, 2].map(|i| y[from + i] * half));
                    rate[at] = w * turn[0] + y_ * turn[2] - z * turn[1];
                    rate[at + 1] = w * turn[1] + z * turn[0] - x * turn[2];
                    rate[at + 2] = w * turn[2] + x * turn[1] - y_ * turn[0];
                    rate[at + 3] = -(x * turn[0] + y_ * turn[1] + z * turn[2]);
                }
                Piece::Place { at, rate: from } => {
                    let q = unit([3, 4, 5, 6].map(|i| y[at + i]));
                    let moved = turned(q, [0, 1, 2].map(|i| y[from + i]));
                    rate[at..at + 3].copy_from_slice(&moved);
                }
            }
        }
    }
}

/// The quaternion (x, y, z, w) with unit length.
pub(super) fn unit<T: Elementary>(q: [T; 4]) -> [T; 4] {
    let length = q.iter().fold(T::zero(), |sum, x| sum + *x * *x).sqrt();
    q.map(|x| x / length)
}

/// `v` turned by a unit quaternion `(u, w)`: `v + 2·(w·(u × v) + u × (u × v))`.
fn turned<T: Elementary>([x, y, z, w]: [T; 4], v: [T; 3]) -> [T; 3] {
    let across = |v: [T; 3]| [y * v[2] - z * v[1], z * v[0] - x * v[2], x * v[1] - y * v[0]];
    let (once, two) = (across(v), T::from_f64(2.0));
    let twice = across(once);
    [0, 1, 2].map(|i| v[i] + two * (w * once[i] + twice[i]))
}
