//! A link that reaches for something while the figure walks.

use crate::error::LiveError;
use nalgebra::Vector3;
use solaris_analysis::{Goal, Reach};
use solaris_model::Figure;

/// The most steps that a frame takes: from where it was a moment ago, two or three are enough.
const MOST_STEPS: usize = 8;
/// The farthest that anything is to be reached for, and a point lies from its link (m).
const FARTHEST: f64 = 1e6;

/// A point of a link that is brought somewhere, or a link that is turned.
#[derive(Clone)]
pub(super) struct Reaching {
    /// Which it is among all there were.
    pub(super) id: usize,
    pub(super) link: usize,
    point: Vector3<f64>,
    /// The names by which it was told what to move.
    by: Vec<String>,
    solver: Reach,
    goal: Goal,
    /// The coordinates that it moves, and where they were in the last solution.
    moves: Vec<(usize, f64)>,
    q: Vec<f64>,
    off: f64,
}

impl Reaching {
    /// By these degrees of freedom, whose names were `by`, from a configuration on.
    pub(super) fn new(
        figure: &Figure,
        id: usize,
        (link, point): (usize, Vector3<f64>),
        (by, dofs): (&[&str], &[usize]),
        goal: Goal,
        q: &[f64],
    ) -> Result<Self, LiveError> {
        check(&point, &goal)?;
        let refused = |error: solaris_analysis::ReachError| LiveError::Reach { why: error.to_string() };
        let mut solver = Reach::new(figure, link, point, dofs).map_err(refused)?;
        let mut solved = q.to_vec();
        let off = solver.solve(&mut solved, &goal).map_err(refused)?.off;
        let moves = solver.moves().map(|(_, at, _)| (at, solved[at])).collect();
        let by = by.iter().map(|name| (*name).to_owned()).collect();
        Ok(Self { id, link, point, by, solver, goal, moves, q: solved, off })
    }

    /// Whether the same point is brought somewhere by what has the same names.
    pub(super) fn is_of(&self, link: usize, point: &Vector3<f64>, by: &[&str]) -> bool {
        self.link == link && self.point == *point && self.by == by
    }

    /// Goes on to another goal.
    pub(super) fn aim(&mut self, goal: Goal) -> Result<(), LiveError> {
        check(&self.point, &goal)?;
        self.goal = goal;
        Ok(())
    }

    /// The coordinates that it moves.
    pub(super) fn moves(&self) -> impl Iterator<Item = usize> {
        self.moves.iter().map(|(at, _)| *at)
    }

    /// What is still missing to the goal (m or rad).
    pub(super) fn off(&self) -> f64 {
        self.off
    }

    /// Writes where its coordinates have to be in a configuration, as near to where they were as that is.
    pub(super) fn solve(&mut self, q: &mut [f64]) {
        self.q.copy_from_slice(q);
        for (at, was) in &self.moves {
            self.q[*at] = *was;
        }
        // A walk's numbers are finite, and goals are checked: should it be refused all the same, they stay as they were.
        if let Ok(reached) = self.solver.follow(&mut self.q, &self.goal, MOST_STEPS) {
            self.off = reached.off;
            for (at, is) in &mut self.moves {
                *is = self.q[*at];
            }
        }
        for (at, is) in &self.moves {
            q[*at] = *is;
        }
    }
}

/// Refuses what is no point and no goal.
fn check(point: &Vector3<f64>, goal: &Goal) -> Result<(), LiveError> {
    let (place, axis) = match goal {
        Goal::Place(at) => (*at, Vector3::zeros()),
        Goal::Look { at, axis } => (*at, axis.into_inner()),
        Goal::Turned(turned) => (turned.scaled_axis(), Vector3::zeros()),
        other => return Err(LiveError::Reach { why: format!("{other:?} is no goal of a walker") }),
    };
    let wrong = |value: &&f64| value.is_nan() || value.abs() > FARTHEST;
    match point.iter().chain(&place).chain(&axis).find(wrong) {
        Some(value) => Err(LiveError::NotFinite { what: "place to reach for", value: *value }),
        None => Ok(()),
    }
}
