//! One thing that is asked of a link, moment by moment: over what its joints would otherwise do.

use super::asked::{Asked, Spot, What};
use super::way::{Way, share};
use nalgebra::{Rotation3, Unit, UnitQuaternion, Vector3};
use solaris_analysis::{Goal, Reach};
use solaris_dynamics::{Pose, Tree, Workspace, forward_kinematics};

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
        Self { asked, solver, coordinates, begun: None, solved: None, worst: (0.0, 0.0) }
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
        let left = if time > asked.until { 1.0 - share((time - asked.until) / asked.back) } else { 1.0 };
        if time < asked.from || left <= 0.0 {
            return Ok(());
        }
        let goal = self.goal(q, time, placed)?;
        let otherwise = q.to_vec();
        // What does not change is not found anew.
        let same = self.solved.take_if(|last| last.goal == goal && last.otherwise == otherwise);
        let solved = match same {
            Some(same) => same,
            None => self.solve(q, goal, otherwise)?,
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

    /// The positions that meet a goal, from those found last, moved on by as much as its joints would otherwise have moved.
    fn solve(&mut self, q: &mut [f64], goal: Goal, otherwise: Vec<f64>) -> Result<Solved, String> {
        if let Some(last) = &self.solved {
            for (&coordinate, found) in self.coordinates.iter().zip(&last.q) {
                q[coordinate] = found + (otherwise[coordinate] - last.otherwise[coordinate]);
            }
        }
        let reached = self.solver.solve(q, &goal).map_err(|error| error.to_string())?;
        let found = self.coordinates.iter().map(|coordinate| q[*coordinate]).collect();
        Ok(Solved { goal, otherwise, q: found, off: reached.off })
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
        let begun = self.begun.as_ref().ok_or("nothing has begun")?;
        let since = time - asked.from;
        let s = if asked.over > 0.0 { share(since / asked.over) } else { 1.0 };
        let spot = |spot: &Spot| match spot {
            Spot::Place(place) => *place,
            Spot::Of(link, point) => links.pose(*link).transform(point),
        };
        Ok(match &asked.what {
            What::Reach(to) => Goal::Place(eye + (spot(to) - eye) * s),
            What::Along(keys) => {
                let first = keys.first().map_or(asked.over, |(time, _)| *time);
                let way = begun.way.as_ref().map_or(eye, |way| way.at(since));
                Goal::Place(way + (eye - begun.place) * (1.0 - share(since / first)))
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
