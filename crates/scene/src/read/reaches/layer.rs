//! One thing that is asked of a link, moment by moment: over what its joints would otherwise do.

use super::asked::{Asked, Spot, What};
use super::way::{Way, share};
use crate::read::apart::{Nudge, way};
use nalgebra::{Rotation3, Unit, UnitQuaternion, Vector3};
use solaris_analysis::{Goal, Reach, ReachError};
use solaris_dynamics::{Pose, Tree, Workspace, forward_kinematics};
use std::collections::HashMap;

/// The farthest that a point is led from its way (m), so that links do not cut each other.
const MOST_DETOUR: f64 = 0.3;

/// While what keeps links apart comes in, it is made up for by no more than one over this.
const LEAST_SHARE: f64 = 0.2;

/// Places all links of a figure in a configuration.
pub(super) struct Placed {
    pub(super) tree: Tree<f64>,
    pub(super) workspace: Workspace<f64>,
}

impl Placed {
    pub(super) fn at(&mut self, q: &[f64]) -> Result<&Workspace<f64>, String> {
        forward_kinematics(&self.tree, &mut self.workspace, q).map_err(|error| error.to_string())?;
        Ok(&self.workspace)
    }
}

/// What a layer has found last: for which goal, from which positions of the whole figure, and the positions of its joints.
struct Solved {
    goal: Goal,
    otherwise: Vec<f64>,
    /// What was added to the positions of its joints before they were found.
    added: Vec<f64>,
    q: Vec<f64>,
    off: f64,
}

/// One thing that is asked.
pub(super) struct Layer<'a> {
    pub(super) asked: &'a Asked,
    solver: Reach,
    /// Coordinates of the joints that move.
    coordinates: Vec<usize>,
    begun: Option<Begun>,
    solved: Option<Solved>,
    /// What keeps links apart.
    pub(super) nudges: Vec<Nudge>,
    /// What is to be, by time of the run (the bits of s).
    goals: HashMap<u64, Goal>,
    /// The farthest that it is off (m or rad), and when (s).
    pub(super) worst: (f64, f64),
}

/// How a layer begins.
struct Begun {
    /// Where the point is (m, world).
    place: Vector3<f64>,
    way: Option<Way>,
    turned: UnitQuaternion<f64>,
}

impl<'a> Layer<'a> {
    pub(super) fn new(asked: &'a Asked, solver: Reach) -> Self {
        let coordinates = solver.moves().map(|(_, coordinate, _)| coordinate).collect();
        Self {
            asked,
            solver,
            coordinates,
            begun: None,
            solved: None,
            nudges: Vec::new(),
            goals: HashMap::new(),
            worst: (0.0, 0.0),
        }
    }

    /// Begins anew.
    pub(super) fn rewind(&mut self) {
        (self.begun, self.solved, self.worst) = (None, None, (0.0, 0.0));
    }

    /// How much of what is found its joints do at a time of the run (s): nothing before it begins, and after it has been given up.
    pub(super) fn share_at(&self, time: f64) -> f64 {
        let asked = self.asked;
        let left = if time > asked.until { 1.0 - share((time - asked.until) / asked.back)[0] } else { 1.0 };
        if time < asked.from { 0.0 } else { asked.weight * left }
    }

    /// Adds a way that takes two links `by` (m) farther apart at a time, where the whole figure is at `q` and their distance changes by
    /// `slopes` with degrees of freedom: one that changes nothing of what is asked, or a `detour` of a point that is on its way; whether
    /// there is any.
    pub(super) fn nudge(
        &mut self,
        (q, time): (&[f64], f64),
        slopes: &[(usize, f64)],
        by: f64,
        mut nudge: Nudge,
        detour: bool,
    ) -> Result<bool, String> {
        let Some(goal) = self.goals.get(&time.to_bits()).copied() else { return Ok(false) };
        nudge = self.within(nudge);
        let slope = |dof: usize| slopes.iter().find(|(own, _)| *own == dof).map_or(0.0, |(_, slope)| *slope);
        let own: Vec<f64> = self.moves().map(|(dof, ..)| slope(dof)).collect();
        let by = by / (self.share_at(time) * nudge.at(time)[0].max(LEAST_SHARE));
        let text = |error: ReachError| error.to_string();
        if detour {
            if !self.asked.what.is_of_a_place() {
                return Ok(false);
            }
            let along = self.solver.along_goal(q, &goal, &own).map_err(text)?;
            let Some(way) = way(along.as_slice(), along.as_slice().to_vec(), by) else { return Ok(false) };
            if self.detour(time).norm() > MOST_DETOUR {
                return Ok(false);
            }
            let on_the_way = [self.asked.from, self.asked.from + self.asked.over];
            let Some(found) = Nudge::detour(on_the_way, Vector3::from_column_slice(&way), &nudge) else {
                return Ok(false);
            };
            nudge = found;
        } else {
            let mut free = own.clone();
            self.solver.spare(q, &goal, &mut free).map_err(text)?;
            let Some(by) = way(&own, free, by) else { return Ok(false) };
            nudge.by = by;
        }
        self.nudges.push(nudge);
        Ok(true)
    }

    /// Adds a way of this size (rad, m) that changes nothing of what is asked at a time, where the whole figure is at `q`: of all of them that
    /// which moves one joint most; whether there is any.
    pub(super) fn turn(
        &mut self,
        (q, time): (&[f64], f64),
        by: f64,
        mut nudge: Nudge,
    ) -> Result<bool, String> {
        let Some(goal) = self.goals.get(&time.to_bits()).copied() else { return Ok(false) };
        let mut best = (0.0, Vec::new());
        for i in 0..self.coordinates.len() {
            let mut way = vec![0.0; self.coordinates.len()];
            way[i] = 1.0;
            self.solver.spare(q, &goal, &mut way).map_err(|error| error.to_string())?;
            let size = way.iter().map(|x| x * x).sum::<f64>().sqrt();
            if size > best.0 {
                best = (size, way);
            }
        }
        let (size, mut way) = best;
        if size < 0.1 {
            return Ok(false);
        }
        for way in &mut way {
            *way *= by / size;
        }
        nudge = self.within(nudge);
        nudge.by = way;
        self.nudges.push(nudge);
        Ok(true)
    }

    /// A nudge that has nothing before this begins, unless it begins as it is to be.
    fn within(&self, nudge: Nudge) -> Nudge {
        if self.asked.over > 0.0 { nudge.not_before(self.asked.from) } else { nudge }
    }

    /// How far the point is led from its way at a time (m).
    fn detour(&self, time: f64) -> Vector3<f64> {
        self.nudges.iter().map(|nudge| nudge.detour * nudge.at(time)[0]).sum()
    }

    /// What is added to the positions of its joints at a time (s).
    fn added(&self, time: f64) -> Vec<f64> {
        let mut added = vec![0.0; self.coordinates.len()];
        for nudge in &self.nudges {
            let [much, ..] = nudge.at(time);
            added.iter_mut().zip(&nudge.by).for_each(|(added, by)| *added += much * by);
        }
        added
    }

    /// Degrees of freedom that it moves, with their coordinates and limits.
    pub(super) fn moves(&self) -> impl Iterator<Item = (usize, usize, [f64; 2])> {
        self.solver.moves()
    }

    /// Moves its joints in `q`, where they are as they would otherwise be at a time of the run (s):
    ///
    /// ```text
    /// q = q₀ + w·(q* − q₀)
    /// ```
    ///
    /// where `q*` meets the goal, and `w` is the weight until it is given up and falls to zero after that.
    pub(super) fn apply(&mut self, q: &mut [f64], time: f64, placed: &mut Placed) -> Result<(), String> {
        let asked = self.asked;
        let left = if time > asked.until { 1.0 - share((time - asked.until) / asked.back)[0] } else { 1.0 };
        if time < asked.from || left <= 0.0 {
            return Ok(());
        }
        let goal = self.goal(q, time, placed)?;
        self.goals.insert(time.to_bits(), goal);
        let (otherwise, added) = (q.to_vec(), self.added(time));
        // What does not change is not found anew.
        let is_same =
            |last: &mut Solved| last.goal == goal && last.otherwise == otherwise && last.added == added;
        let solved = match self.solved.take_if(is_same) {
            Some(same) => same,
            None => self.solve(q, goal, otherwise, added)?,
        };
        let weight = asked.weight * left;
        for (&coordinate, new) in self.coordinates.iter().zip(&solved.q) {
            let own = solved.otherwise[coordinate];
            q[coordinate] = own + weight * (new - own);
        }
        if solved.off > self.worst.0 {
            self.worst = (solved.off, time);
        }
        self.solved = Some(solved);
        Ok(())
    }

    /// The positions that meet a goal, from those found last, moved on by as much as its joints would otherwise have moved and by what is
    /// added.
    fn solve(
        &mut self,
        q: &mut [f64],
        goal: Goal,
        otherwise: Vec<f64>,
        added: Vec<f64>,
    ) -> Result<Solved, String> {
        for (i, &coordinate) in self.coordinates.iter().enumerate() {
            let (from, by) = match &self.solved {
                Some(last) => (
                    last.q[i] + (otherwise[coordinate] - last.otherwise[coordinate]),
                    added[i] - last.added[i],
                ),
                None => (q[coordinate], added[i]),
            };
            q[coordinate] = from + by;
        }
        let reached = self.solver.solve(q, &goal).map_err(|error| error.to_string())?;
        let found = self.coordinates.iter().map(|coordinate| q[*coordinate]).collect();
        Ok(Solved { goal, otherwise, added, q: found, off: reached.off })
    }

    /// What is to be at a time of the run (s): from what would otherwise be it goes over into what is asked.
    fn goal(&mut self, q: &[f64], time: f64, placed: &mut Placed) -> Result<Goal, String> {
        let asked = self.asked;
        let links = placed.at(q)?;
        let own = links.pose(asked.link);
        let eye = own.transform(&asked.point);
        let turned = orientation(own);
        if self.begun.is_none() {
            let way = match &asked.what {
                What::Along(keys) => Some(Way::through(eye, keys)?),
                _ => None,
            };
            self.begun = Some(Begun { place: eye, way, turned });
        }
        let detour = self.detour(time);
        let begun = self.begun.as_ref().ok_or("nothing has begun")?;
        let since = time - asked.from;
        let s = if asked.over > 0.0 { share(since / asked.over)[0] } else { 1.0 };
        let spot = |spot: &Spot| match spot {
            Spot::Place(place) => *place,
            Spot::Of(link, point) => links.pose(*link).transform(point),
        };
        Ok(match &asked.what {
            What::Reach(to) => Goal::Place(eye + (spot(to) - eye) * s + detour),
            What::Along(keys) => {
                let first = keys.first().map_or(asked.over, |(time, _)| *time);
                let way = begun.way.as_ref().map_or(eye, |way| way.at(since));
                Goal::Place(way + (eye - begun.place) * (1.0 - share(since / first)[0]) + detour)
            }
            What::Look(axis, to) => {
                let way = spot(to) - eye;
                let along = turned * axis.into_inner();
                let part = part_of_turn(&along, &way, s);
                Goal::Look { axis: *axis, at: eye + part * along * way.norm() }
            }
            What::Hold(wanted) => {
                let wanted = wanted.unwrap_or(begun.turned);
                let left = (wanted * turned.inverse()).scaled_axis();
                Goal::Turned(UnitQuaternion::from_scaled_axis(left * s) * turned)
            }
        })
    }
}

/// How a link is turned against the world.
fn orientation(pose: &Pose<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(pose.rotation))
}

/// A part `s` of the shortest turn from one direction to another; of opposite ones about any axis square to them.
fn part_of_turn(from: &Vector3<f64>, to: &Vector3<f64>, s: f64) -> UnitQuaternion<f64> {
    let normal = from.cross(to);
    let angle = normal.norm().atan2(from.dot(to));
    let aside = || Unit::try_new(from.cross(&Vector3::ith(from.iamin(), 1.0)), 0.0);
    match Unit::try_new(normal, 0.0).or_else(aside) {
        Some(axis) => UnitQuaternion::from_axis_angle(&axis, s * angle),
        None => UnitQuaternion::identity(),
    }
}
