//! Inverse kinematics of a point: where joints have to be so that it is at a place, or its link is turned so that it looks at one.

mod goal;

pub use goal::Goal;

use nalgebra::{Cholesky, DMatrix, DVector, Matrix3, Vector3};
use solaris_dynamics::{DynamicsError, Frame, Pose, Tree, Workspace, joint_jacobians, point_columns};
use solaris_model::Figure;

/// A point this near (m) to its target is there, a link that is turned so nearly (rad) as it is to be is so.
pub const REACHED: f64 = 1e-9;
/// The least and the greatest damping, as parts of the greatest diagonal of `Jᵀ·J`.
const DAMPING: (f64, f64) = (1e-14, 1e8);
/// The farthest that one step goes in any coordinate (rad or m).
const STRIDE: f64 = 0.5;
const MOST_STEPS: usize = 300;
/// Directions in which the goal changes by less than this part of the most, in squares, are not taken out of a way.
const SPARE: f64 = 1e-12;
/// A step that lowers the square of the distance by less than this part of it is the last one.
const PROMISE: f64 = 1e-13;
/// How far (rad or m) coordinates are moved aside where they are in a position from which no small step leads on, such as a straight arm
/// whose target is on its line.
const ASIDE: f64 = 0.05;

/// Brings a point of a figure to places, or turns the link that carries it, by some of its degrees of freedom.
///
/// ```text
/// min |e(q)|²      over the degrees of freedom that are named, within their limits
/// ```
///
/// where `e` is what is missing to a [`Goal`]: of a place `x* − x`, of a direction or an orientation the rotation vector that is left. By
/// damped least squares, `(Jᵀ·J + λ·E)·Δq = Jᵀ·e`, from where the figure is: each step lowers `|e|`, so that of the
/// many ways to be there a near one is found. Coordinates at a limit that the step would pass are left out of it.
///
/// # Source
///
/// C. W. Wampler, "Manipulator inverse kinematic solutions based on vector formulations and damped least-squares methods", IEEE Trans.
/// Systems, Man, and Cybernetics 16 (1986) 93–101; the damping is chosen as Levenberg and Marquardt do; limits as in D. P. Bertsekas,
/// "Projected Newton methods for optimization problems with simple constraints", SIAM J. Control Optim. 20 (1982) 221–246.
///
/// # Examples
///
/// ```
/// use solaris_analysis::{Goal, Reach};
/// use solaris_model::{Vector3, human};
///
/// let ann = human(1.65, 58.0)?;
/// let hand = ann.link_index("right_hand").expect("a hand");
/// let arm: Vec<usize> = ["right_shoulder.rz", "right_shoulder.ry", "right_shoulder.rx", "right_elbow.rx"]
///     .iter()
///     .filter_map(|name| ann.layout().dof_index(name))
///     .collect();
/// let mut reach = Reach::new(&ann, hand, Vector3::new(0.0, -0.08, 0.0), &arm)?;
/// let mut q = vec![0.0; ann.layout().nq()];
/// q[ann.layout().dof_index("right_elbow.rx").expect("an elbow")] = -0.5;
/// let reached = reach.solve(&mut q, &Goal::Place(Vector3::new(-0.24, 0.36, 0.36)))?;
/// assert!(reached.off < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "inverse kinematics")]
#[doc(alias = "IK")]
#[derive(Clone, Debug)]
pub struct Reach {
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    tip: Frame<f64>,
    unknowns: Vec<Unknown>,
    /// For each degree of freedom of the figure, which unknown it is.
    unknown_of: Vec<Option<usize>>,
    room: Room,
}

/// Room for the steps: with `n` unknowns, 3 × `n`, `n` × `n` twice, `n` and `nq`.
#[derive(Clone, Debug)]
struct Room {
    jacobian: DMatrix<f64>,
    normal: DMatrix<f64>,
    damped: DMatrix<f64>,
    slope: DVector<f64>,
    step: DVector<f64>,
    next: Vec<f64>,
}

/// A coordinate that may be moved.
#[derive(Clone, Copy, Debug)]
struct Unknown {
    dof: usize,
    coordinate: usize,
    lower: f64,
    upper: f64,
}

/// What came of a [`Reach`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// How far the point still is from its place (m), or its link from being turned as it is to be (rad): below [`REACHED`] it is there,
    /// else this is the nearest that was found.
    pub off: f64,
    /// How many steps it took.
    pub steps: usize,
}

/// Why a point cannot be brought anywhere.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ReachError {
    /// No such link.
    #[error("figure '{figure}' has no link number {link}")]
    NoLink {
        /// The figure.
        figure: String,
        /// The index.
        link: usize,
    },
    /// A degree of freedom that cannot be placed.
    #[error(
        "'{dof}' has no coordinate of its own to be placed; name the axes of joints of rotations and slides"
    )]
    NoCoordinate {
        /// The degree of freedom.
        dof: String,
    },
    /// None of the degrees of freedom moves the point.
    #[error("nothing that is named moves '{link}'; name joints between it and the root")]
    NothingMoves {
        /// The link of the point.
        link: String,
    },
    /// The dynamics refuse the figure or the state.
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
}

impl Reach {
    /// That of a `point` (m, in the link's frame) of a link by degrees of freedom (indices in `v`).
    ///
    /// # Errors
    ///
    /// [`ReachError`] for a link that there is not, degrees of freedom without a coordinate or that follow others, and none that moves
    /// the point.
    pub fn new(
        figure: &Figure,
        link: usize,
        point: Vector3<f64>,
        dofs: &[usize],
    ) -> Result<Self, ReachError> {
        if link >= figure.links().len() {
            return Err(ReachError::NoLink { figure: figure.name().to_owned(), link });
        }
        let mut carries = vec![false; figure.links().len()];
        let mut at = Some(link);
        while let Some(carrier) = at {
            carries[carrier] = true;
            at = figure.links()[carrier].parent();
        }
        let layout = figure.layout();
        let mut unknowns = Vec::new();
        for (i, (carrier, joint)) in figure.links().iter().zip(layout.joints()).enumerate() {
            for dof in (joint.v..joint.v + joint.nv).filter(|dof| dofs.contains(dof)) {
                let coordinate = layout.coordinate(dof).filter(|_| !figure.follows(dof));
                let Some(coordinate) = coordinate else {
                    return Err(ReachError::NoCoordinate { dof: layout.v_names()[dof].clone() });
                };
                let limits = carrier.joint().kind().axes().get(dof - joint.v).and_then(|axis| axis.limits);
                let (lower, upper) =
                    limits.map_or((f64::NEG_INFINITY, f64::INFINITY), |limits| (limits.lower, limits.upper));
                if carries[i] {
                    unknowns.push(Unknown { dof, coordinate, lower, upper });
                }
            }
        }
        if unknowns.is_empty() {
            return Err(ReachError::NothingMoves { link: figure.links()[link].name().to_owned() });
        }
        let tree = Tree::new(figure, Vector3::zeros())?;
        let n = unknowns.len();
        let unknown_of = (0..layout.nv()).map(|dof| unknowns.iter().position(|known| known.dof == dof));
        Ok(Self {
            workspace: Workspace::new(&tree),
            tip: Frame::at(link, point),
            unknown_of: unknown_of.collect(),
            room: Room {
                jacobian: DMatrix::zeros(3, n),
                normal: DMatrix::zeros(n, n),
                damped: DMatrix::zeros(n, n),
                slope: DVector::zeros(n),
                step: DVector::zeros(n),
                next: vec![0.0; tree.nq()],
            },
            tree,
            unknowns,
        })
    }

    /// Where the point is (m, world) in a configuration, and how its link is turned.
    ///
    /// # Errors
    ///
    /// [`ReachError::Dynamics`] for a configuration that is none.
    pub fn pose(&mut self, q: &[f64]) -> Result<Pose<f64>, ReachError> {
        joint_jacobians(&self.tree, &mut self.workspace, q)?;
        Ok(self.tip.pose(&self.workspace))
    }

    /// The degrees of freedom that it moves (indices in `v`), each with its coordinate (index in `q`) and its limits (rad, m), which may
    /// be infinite; those of the ones named that carry the point.
    pub fn moves(&self) -> impl Iterator<Item = (usize, usize, [f64; 2])> {
        self.unknowns.iter().map(|unknown| (unknown.dof, unknown.coordinate, [unknown.lower, unknown.upper]))
    }

    /// Moves the coordinates in `q` (rad, m; length `nq`) so that the goal is met, or as nearly as steps from there lead.
    ///
    /// # Errors
    ///
    /// As for [`pose`](Self::pose).
    pub fn solve(&mut self, q: &mut [f64], target: &Goal) -> Result<Reached, ReachError> {
        let mut best = self.follow(q, target, MOST_STEPS)?;
        let mut sides = [1.0, -1.0].into_iter();
        while best.off > REACHED
            && let Some(side) = sides.next()
        {
            let mut aside = q.to_vec();
            for (i, unknown) in self.unknowns.iter().enumerate() {
                let way = side * ASIDE * (1.0 + i as f64 / self.unknowns.len() as f64);
                let entry = &mut aside[unknown.coordinate];
                *entry = (*entry + way).clamp(unknown.lower, unknown.upper);
            }
            let other = self.descend(&mut aside, target, MOST_STEPS)?;
            let steps = best.steps + other.steps;
            // Where nothing nearer is found it stays as it was.
            if other.off < best.off - 0.01 * REACHED.max(best.off) {
                q.copy_from_slice(&aside);
                best = other;
            }
            best.steps = steps;
        }
        Ok(best)
    }

    /// The same from a solution of a moment ago, by so many steps at most: without looking for a way out of places from which no small step leads
    /// on, and without allocating. What follows a target that moves takes two or three steps a frame.
    ///
    /// # Errors
    ///
    /// As for [`pose`](Self::pose).
    pub fn follow(&mut self, q: &mut [f64], target: &Goal, most_steps: usize) -> Result<Reached, ReachError> {
        for unknown in &self.unknowns {
            let entry = &mut q[unknown.coordinate];
            *entry = entry.clamp(unknown.lower, unknown.upper);
        }
        self.descend(q, target, most_steps)
    }

    /// Takes out of a way, one number for each degree of freedom that it [moves](Self::moves), what would change how the goal is met, to first
    /// order, and what would lead beyond limits: what is left is what the limb can do beside it.
    ///
    /// ```text
    /// w ← w − Jᵀ·(J·Jᵀ)⁻¹·J·w
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`pose`](Self::pose).
    pub fn spare(&mut self, q: &[f64], target: &Goal, way: &mut [f64]) -> Result<(), ReachError> {
        self.columns(q, target)?;
        // At a limit it stays, and the others do without it.
        for _ in 0..=self.unknowns.len() {
            let taken = self.taken_by(way);
            let jacobian = &mut self.room.jacobian;
            for (i, way) in way.iter_mut().enumerate() {
                *way -= taken.dot(&jacobian.fixed_view::<3, 1>(0, i));
            }
            let mut stuck = false;
            for (i, (unknown, way)) in self.unknowns.iter().zip(way.iter_mut()).enumerate() {
                let x = q[unknown.coordinate];
                if (x <= unknown.lower && *way < 0.0) || (x >= unknown.upper && *way > 0.0) {
                    jacobian.column_mut(i).fill(0.0);
                    *way = 0.0;
                    stuck = true;
                }
            }
            if !stuck {
                break;
            }
        }
        Ok(())
    }

    /// How a number, which changes by `slopes` with the degrees of freedom that it [moves](Self::moves), changes where what is missing to the
    /// goal is taken away by the least change of these: along world axes, for each m of a place.
    ///
    /// ```text
    /// (J·Jᵀ)⁻¹·J·g
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`pose`](Self::pose).
    pub fn along_goal(
        &mut self,
        q: &[f64],
        target: &Goal,
        slopes: &[f64],
    ) -> Result<Vector3<f64>, ReachError> {
        self.columns(q, target)?;
        Ok(self.taken_by(slopes))
    }

    /// `(J·Jᵀ)⁻¹·J·w`
    fn taken_by(&self, way: &[f64]) -> Vector3<f64> {
        let jacobian = &self.room.jacobian;
        let square: Matrix3<f64> = (jacobian * jacobian.transpose()).fixed_view::<3, 3>(0, 0).into();
        let damped = square + Matrix3::identity() * (SPARE * square.trace());
        let own = Vector3::from_fn(|i, _| jacobian.row(i).iter().zip(way).map(|(j, w)| j * w).sum());
        damped.try_inverse().map_or_else(Vector3::zeros, |inverse| inverse * own)
    }

    /// Steps that lower the distance, until none does.
    fn descend(&mut self, q: &mut [f64], target: &Goal, most_steps: usize) -> Result<Reached, ReachError> {
        let mut damping = 1e-6;
        let mut off = self.columns(q, target)?;
        for steps in 0..most_steps {
            if off.norm() <= 1e-3 * REACHED {
                return Ok(Reached { off: off.norm(), steps });
            }
            let scale = self.set_up(q, &off);
            if scale <= 0.0 || self.room.slope.amax() <= 1e-15 * scale.sqrt() * off.norm() {
                return Ok(Reached { off: off.norm(), steps });
            }
            let before = off.norm_squared();
            let mut taken = false;
            while damping <= DAMPING.1 {
                if !self.try_step(q, damping.max(DAMPING.0) * scale) {
                    damping *= 10.0;
                    continue;
                }
                let after = self.columns_of_next(target)?;
                if after.norm_squared() < before {
                    q.copy_from_slice(&self.room.next);
                    off = after;
                    damping = (0.1 * damping).max(DAMPING.0);
                    taken = true;
                    break;
                }
                damping *= 10.0;
            }
            let gained = before - off.norm_squared();
            if !taken || (gained <= PROMISE * before && off.norm() > REACHED) {
                return Ok(Reached { off: off.norm(), steps: steps + 1 });
            }
        }
        Ok(Reached { off: off.norm(), steps: most_steps })
    }

    /// Sets up `Jᵀ·J` and `Jᵀ·e` at `q`, and gives the greatest diagonal. What is at a limit and would go beyond it stays: its column is zero.
    fn set_up(&mut self, q: &[f64], off: &Vector3<f64>) -> f64 {
        let Room { jacobian, normal, slope, .. } = &mut self.room;
        jacobian.tr_mul_to(off, slope);
        for (i, unknown) in self.unknowns.iter().enumerate() {
            let x = q[unknown.coordinate];
            if (x <= unknown.lower && slope[i] < 0.0) || (x >= unknown.upper && slope[i] > 0.0) {
                jacobian.column_mut(i).fill(0.0);
                slope[i] = 0.0;
            }
        }
        jacobian.tr_mul_to(&*jacobian, normal);
        (0..self.unknowns.len()).fold(0.0, |most, i| normal[(i, i)].max(most))
    }

    /// Writes where `(Jᵀ·J + λ·E)·Δq = Jᵀ·e` leads from `q`, no farther than the limits; `false` where it is no system.
    fn try_step(&mut self, q: &[f64], damping: f64) -> bool {
        let Room { normal, damped, slope, step, next, .. } = &mut self.room;
        damped.copy_from(normal);
        for i in 0..self.unknowns.len() {
            damped[(i, i)] += damping;
        }
        let Some(root) = Cholesky::new(std::mem::take(damped)) else {
            *damped = normal.clone();
            return false;
        };
        step.copy_from(slope);
        root.solve_mut(step);
        *damped = root.unpack_dirty();
        let longest = step.amax();
        if longest > STRIDE {
            *step *= STRIDE / longest;
        }
        next.copy_from_slice(q);
        for (unknown, way) in self.unknowns.iter().zip(step.iter()) {
            let entry = &mut next[unknown.coordinate];
            *entry = (*entry + way).clamp(unknown.lower, unknown.upper);
        }
        true
    }

    fn columns_of_next(&mut self, target: &Goal) -> Result<Vector3<f64>, ReachError> {
        let next = std::mem::take(&mut self.room.next);
        let off = self.columns(&next, target);
        self.room.next = next;
        off
    }

    /// What is missing to the goal, and how each unknown takes it away.
    fn columns(&mut self, q: &[f64], target: &Goal) -> Result<Vector3<f64>, ReachError> {
        let pose = self.pose(q)?;
        let Self { tree, workspace, tip, unknown_of, room, .. } = self;
        room.jacobian.fill(0.0);
        point_columns(tree, workspace, tip, |dof, column| {
            if let Some(i) = unknown_of[dof] {
                room.jacobian.set_column(i, &target.column(&pose, &column));
            }
        });
        Ok(target.missing(&pose))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris_model::{FigureBuilder, Joint, LinkSpec};

    /// Two rods of 0.5 and 0.4 m that turn about z, along −y at zero.
    fn arm(limited: bool) -> Figure {
        let elbow = Joint::new("elbow").at(Vector3::new(0.0, -0.5, 0.0)).rz();
        let elbow = if limited { elbow.limited(0.0, 1.0) } else { elbow };
        FigureBuilder::new("arm")
            .link(LinkSpec::root("upper", Joint::new("shoulder").rz()).mass(1.0))
            .link(LinkSpec::child("lower", "upper", elbow).mass(1.0))
            .build()
            .expect("valid")
    }

    fn solved(figure: &Figure, from: [f64; 2], target: Vector3<f64>) -> ([f64; 2], Reached) {
        let mut reach = Reach::new(figure, 1, Vector3::new(0.0, -0.4, 0.0), &[0, 1]).expect("an arm");
        let mut q = from;
        let reached = reach.solve(&mut q, &Goal::Place(target)).expect("finite");
        (q, reached)
    }

    /// `cos q₂ = (r² − l₁² − l₂²)/(2·l₁·l₂)`.
    #[test]
    fn two_rods_bend_as_the_law_of_cosines_says() {
        for (x, y) in [(0.3, -0.6), (0.5, 0.2), (-0.4, -0.1), (0.0, 0.7)] {
            let (q, reached) = solved(&arm(false), [0.1, 0.2], Vector3::new(x, y, 0.0));
            let square: f64 = x * x + y * y;
            let bend = (square - 0.25 - 0.16) / (2.0 * 0.5 * 0.4);
            assert!(reached.off < REACHED, "{reached:?}");
            assert!((q[1].cos() - bend).abs() < 1e-8, "{q:?} {bend}");
        }
    }

    #[test]
    fn out_of_reach_it_points_there_and_out_of_the_plane_it_stays_below() {
        // At rest along the line of its target, from which no small step leads on, too.
        for from in [[0.3, 0.4], [0.0, 0.0]] {
            let (q, reached) = solved(&arm(false), from, Vector3::new(0.0, -2.0, 0.5));
            assert!((reached.off - f64::hypot(1.1, 0.5)).abs() < 1e-9, "{reached:?}");
            assert!(q[1].abs() < 1e-4, "{q:?}");
        }
        // A straight arm whose target is nearer, on its own line.
        let (_, reached) = solved(&arm(false), [0.0, 0.0], Vector3::new(0.0, -0.6, 0.0));
        assert!(reached.off < REACHED, "{reached:?}");
    }

    /// With the elbow at 1 rad at most the nearest distance is that of the triangle with this angle.
    #[test]
    fn within_its_limits_it_comes_as_near_as_they_let_it() {
        let (q, reached) = solved(&arm(true), [0.0, 0.5], Vector3::new(0.0, -0.2, 0.0));
        let length = (0.25 + 0.16 + 0.4 * 1.0_f64.cos()).sqrt();
        assert!((q[1] - 1.0).abs() < 1e-12, "{q:?}");
        assert!((reached.off - (length - 0.2)).abs() < 1e-9, "{reached:?} {length}");
    }

    /// Three rods in a plane and a place in it: one way is free, along which the place does not move, but by squares. What a place takes is
    /// what the law of forces says, by differences.
    #[test]
    fn what_is_spare_moves_nothing_of_the_goal() {
        let rod = |name: &str, parent: &str, y: f64| {
            let joint = Joint::new(format!("{name}_joint")).at(Vector3::new(0.0, y, 0.0)).rz();
            LinkSpec::child(name, parent, joint.limited(-2.0, 2.0)).mass(1.0)
        };
        let figure = FigureBuilder::new("arm")
            .link(LinkSpec::root("one", Joint::new("shoulder").rz()).mass(1.0))
            .link(rod("two", "one", -0.5))
            .link(rod("three", "two", -0.4))
            .build()
            .expect("valid");
        let mut reach = Reach::new(&figure, 2, Vector3::new(0.0, -0.3, 0.0), &[0, 1, 2]).expect("an arm");
        let q = [0.2, 0.5, -0.7];
        let place = reach.pose(&q).expect("finite").translation;
        let goal = Goal::Place(place);
        let mut way = vec![1.0, 0.3, -0.2];
        reach.spare(&q, &goal, &mut way).expect("finite");
        assert!(way.iter().map(|x| x * x).sum::<f64>() > 0.1, "{way:?}");
        let moved = |reach: &mut Reach, h: f64| {
            let moved: Vec<f64> = q.iter().zip(&way).map(|(x, way)| x + h * way).collect();
            (reach.pose(&moved).expect("finite").translation - place).norm()
        };
        assert!(moved(&mut reach, 1e-3) < 2e-6 && moved(&mut reach, 1e-2) < 2e-4);
        // Once more takes nothing away.
        let mut again = way.clone();
        reach.spare(&q, &goal, &mut again).expect("finite");
        assert!(again.iter().zip(&way).all(|(a, b)| (a - b).abs() < 1e-9), "{again:?} {way:?}");
        // At a limit that it would pass a joint stays.
        let mut stuck = vec![0.0, 1.0, 0.0];
        reach.spare(&[0.2, 2.0, -0.7], &goal, &mut stuck).expect("finite");
        assert!(stuck[1] <= 0.0, "{stuck:?}");
        // Of a number that is the place's own height, the slope along the place is (0, 1, 0).
        let height = |reach: &mut Reach, q: &[f64]| reach.pose(q).expect("finite").translation.y;
        let slopes: Vec<f64> = (0..3)
            .map(|i| {
                let at = |by: f64| {
                    let mut q = q;
                    q[i] += by;
                    q
                };
                (height(&mut reach, &at(1e-6)) - height(&mut reach, &at(-1e-6))) / 2e-6
            })
            .collect();
        let along = reach.along_goal(&q, &goal, &slopes).expect("finite");
        assert!((along - Vector3::y()).norm() < 1e-7, "{along}");
    }

    /// Two axes, one after the other, turn a link so that it looks as its heading and its pitch say, and not beyond a limit.
    #[test]
    fn it_looks_where_heading_and_pitch_say_and_not_beyond_its_limits() {
        let neck = Joint::new("neck").at(Vector3::new(0.0, 1.0, 0.0)).ry().rx().limited(-0.5, 0.5);
        let head = LinkSpec::root("head", neck).mass(1.0);
        let figure = FigureBuilder::new("f").link(head).build().expect("valid");
        let mut reach = Reach::new(&figure, 0, Vector3::zeros(), &[0, 1]).expect("a neck");
        let axis = Vector3::z_axis();
        for (heading, pitch, from) in [(0.7, 0.3, 0.0), (-2.0, -0.4, 0.2), (2.9, 0.45, -0.1), (0.4, 0.8, 0.0)]
        {
            let (sin, cos) = f64::sin_cos(pitch);
            let at = Vector3::new(0.0, 1.0, 0.0)
                + 2.5 * Vector3::new(cos * f64::sin(heading), -sin, cos * f64::cos(heading));
            let mut q = [from, from];
            let reached = reach.solve(&mut q, &Goal::Look { axis, at }).expect("finite");
            // Where the goal is not met, descent ends once the square of what is missing falls by less than 1e-13 of itself.
            let fine = if pitch > 0.5 { 3e-7 } else { 1e-9 };
            assert!((q[0] - heading).abs() < fine, "{q:?}");
            assert!((q[1] - f64::min(pitch, 0.5)).abs() < 1e-9, "{q:?}");
            // From behind it is as far off as the two directions are.
            assert!((reached.off - (pitch - q[1]).abs()).abs() < 1e-9, "{reached:?}");
        }
    }

    /// Three axes in any order give back the rotation that they are asked for.
    #[test]
    fn it_is_turned_as_it_is_asked() {
        let wrist = LinkSpec::root("hand", Joint::new("wrist").rx().rz().ry()).mass(1.0);
        let figure = FigureBuilder::new("f").link(wrist).build().expect("valid");
        let mut reach = Reach::new(&figure, 0, Vector3::zeros(), &[0, 1, 2]).expect("a wrist");
        let turned = nalgebra::UnitQuaternion::from_euler_angles(0.9, -1.2, 2.4);
        let mut q = [0.0; 3];
        let reached = reach.solve(&mut q, &Goal::Turned(turned)).expect("finite");
        assert!(reached.off < REACHED, "{reached:?}");
        let about = |axis: Vector3<f64>, angle| nalgebra::UnitQuaternion::from_scaled_axis(axis * angle);
        let product = about(Vector3::x(), q[0]) * about(Vector3::z(), q[1]) * about(Vector3::y(), q[2]);
        assert!(product.angle_to(&turned) < 1e-8);
    }

    #[test]
    fn what_cannot_be_moved_is_refused_by_name() {
        let figure = arm(false);
        let refused = |link, dofs: &[usize]| {
            Reach::new(&figure, link, Vector3::zeros(), dofs).expect_err("refused").to_string()
        };
        assert_eq!(refused(5, &[0]), "figure 'arm' has no link number 5");
        assert_eq!(
            refused(0, &[1]),
            "nothing that is named moves 'upper'; name joints between it and the root"
        );
    }
}
