//! What inverse kinematics is asked, checked and laid out for the solver.

use super::matched::Matched;
use super::options::{CoordinateTask, IkError, IkOptions};
use nalgebra::Vector3;
use solaris_dynamics::{Frame, Tree};
use solaris_model::{Curve, Figure, JointKind, Marker, MarkerTrial};

/// A marker that takes part.
pub(super) struct Sight {
    pub(super) frame: Frame<f64>,
    pub(super) weight: f64,
    /// Its index among the figure's markers.
    pub(super) marker: usize,
    /// Its index in the trial.
    pub(super) column: usize,
    /// The degrees of freedom that move it, from the root on.
    pub(super) path: Vec<usize>,
}

/// What becomes of a degree of freedom.
pub(super) enum Role<'a> {
    Free(usize),
    Follows { unknown: usize, coordinate: usize, leader: usize, curve: &'a Curve },
    Held,
}

/// A degree of freedom that is to be found.
pub(super) struct Unknown {
    pub(super) dof: usize,
    /// Its coordinate in `q`, unless it is one of a ball or free joint.
    pub(super) coordinate: Option<usize>,
    pub(super) bounds: Option<(f64, f64)>,
    /// Where it is drawn to, and how strongly.
    pub(super) task: Option<(f64, f64)>,
    /// Whether it is a degree of freedom of the root.
    pub(super) is_root: bool,
}

pub(super) struct Problem<'a> {
    pub(super) figure: &'a Figure,
    pub(super) markers: &'a [Marker],
    pub(super) trial: &'a MarkerTrial,
    pub(super) tree: Tree<f64>,
    pub(super) sights: Vec<Sight>,
    pub(super) roles: Vec<Role<'a>>,
    pub(super) unknowns: Vec<Unknown>,
    /// For each degree of freedom of a ball or free joint, its link.
    pub(super) spheres: Vec<Option<usize>>,
    pub(super) rest: Vec<f64>,
    pub(super) matched: Matched,
}

impl<'a> Problem<'a> {
    pub(super) fn new(
        figure: &'a Figure,
        markers: &'a [Marker],
        trial: &'a MarkerTrial,
        options: &IkOptions,
    ) -> Result<Self, IkError> {
        if trial.is_empty() {
            return Err(IkError::NoFrames);
        }
        check_markers(figure, markers)?;
        let matched = Matched::of(markers, trial);
        let weights = weights(markers, options)?;
        let sights: Vec<Sight> = matched
            .pairs
            .iter()
            .filter(|(marker, _)| weights[*marker] > 0.0)
            .map(|&(marker, column)| {
                let Marker { link, position, .. } = markers[marker];
                let frame = Frame::at(link, position);
                Sight { frame, weight: weights[marker], marker, column, path: path(figure, link) }
            })
            .collect();
        if sights.is_empty() {
            let model = listed(markers.iter().map(|marker| marker.name.as_str()));
            let trial = listed(trial.names().iter().map(String::as_str));
            return Err(IkError::NoMarkers { model, trial, weighted: !matched.pairs.is_empty() });
        }
        let rest = rest(figure, options)?;
        let mut problem = Self {
            figure,
            markers,
            trial,
            tree: Tree::new(figure, Vector3::zeros())?,
            sights,
            roles: Vec::new(),
            unknowns: Vec::new(),
            spheres: spheres(figure),
            rest,
            matched,
        };
        problem.give_roles(options)?;
        Ok(problem)
    }

    /// The trial's points in a frame, out of those of all frames.
    pub(super) fn row<'p>(&self, points: &'p [Vector3<f64>], frame: usize) -> &'p [Vector3<f64>] {
        let width = self.trial.names().len();
        &points[frame * width..][..width]
    }

    /// Puts what is held, followed and bounded where it belongs.
    pub(super) fn settle(&self, q: &mut [f64]) {
        for unknown in &self.unknowns {
            if let (Some(at), Some((lower, upper))) = (unknown.coordinate, unknown.bounds) {
                q[at] = q[at].clamp(lower, upper);
            }
        }
        for role in &self.roles {
            if let Role::Follows { coordinate, leader, curve, .. } = role {
                q[*coordinate] = curve.at(q[*leader])[0];
            }
        }
    }

    fn give_roles(&mut self, options: &IkOptions) -> Result<(), IkError> {
        let layout = self.figure.layout();
        let nv = layout.nv();
        let name = |dof: usize| layout.v_names().get(dof).cloned().unwrap_or_else(|| format!("dof {dof}"));
        let refuse = |dof: usize, value: String, why| Err(IkError::Value { name: name(dof), value, why });
        let coordinate = |dof: usize, value: String| {
            let of = (dof < nv).then(|| layout.coordinate(dof)).flatten();
            let ball = "it is no coordinate with a value of its own";
            of.map_or_else(|| refuse(dof, value.clone(), ball).map(|()| 0), Ok)
        };
        let mut is_held = vec![false; nv];
        for &(dof, value) in &options.held {
            let at = coordinate(dof, format!("at {value}"))?;
            if !value.is_finite() {
                return refuse(dof, format!("at {value}"), "give a number");
            }
            is_held[dof] = true;
            self.rest[at] = value;
        }
        let mut bounds = vec![None; nv];
        for &(dof, lower, upper) in &options.bounds {
            let told = || format!("between {lower} and {upper}");
            coordinate(dof, told())?;
            if lower.is_nan() || upper.is_nan() || lower > upper {
                return refuse(dof, told(), "give the smaller bound first");
            }
            bounds[dof] = Some((lower, upper));
        }
        let mut tasks = vec![None; nv];
        for &CoordinateTask { dof, value, weight } in &options.tasks {
            coordinate(dof, format!("near {value}"))?;
            if !(weight >= 0.0 && weight.is_finite()) {
                return Err(IkError::Weight { name: name(dof), weight });
            }
            if !value.is_finite() {
                return refuse(dof, format!("near {value}"), "give a number");
            }
            tasks[dof] = (weight > 0.0).then_some((value, weight));
        }
        let root_end = layout.joints()[0].nv;
        let mut unknown_of = vec![None; nv];
        for dof in (0..nv).filter(|dof| !is_held[*dof] && !self.figure.follows(*dof)) {
            unknown_of[dof] = Some(self.unknowns.len());
            let (bounds, task) = (bounds[dof], tasks[dof]);
            self.unknowns.push(Unknown {
                dof,
                coordinate: layout.coordinate(dof),
                bounds,
                task,
                is_root: dof < root_end,
            });
        }
        self.roles = unknown_of.iter().map(|found| found.map_or(Role::Held, Role::Free)).collect();
        for follower in self.figure.followers() {
            if let Some(unknown) = unknown_of[follower.leader] {
                let (coordinate, leader, curve) =
                    (follower.coordinate, follower.leader_coordinate, &follower.curve);
                self.roles[follower.dof] = Role::Follows { unknown, coordinate, leader, curve };
            } else {
                self.rest[follower.coordinate] = follower.curve.at(self.rest[follower.leader_coordinate])[0];
            }
        }
        if self.unknowns.is_empty() {
            return Err(IkError::NothingMoves { figure: self.figure.name().to_owned() });
        }
        let mut rest = std::mem::take(&mut self.rest);
        self.settle(&mut rest);
        self.rest = rest;
        Ok(())
    }
}

fn check_markers(figure: &Figure, markers: &[Marker]) -> Result<(), IkError> {
    let is_bad = |marker: &&Marker| {
        marker.link >= figure.links().len() || !marker.position.iter().all(|x| x.is_finite())
    };
    markers.iter().find(is_bad).map_or(Ok(()), |marker| {
        let [x, y, z] = marker.position.into();
        Err(IkError::Marker {
            name: marker.name.clone(),
            position: format!("({x}, {y}, {z})"),
            link: marker.link,
        })
    })
}

/// The weight of each of the figure's markers.
fn weights(markers: &[Marker], options: &IkOptions) -> Result<Vec<f64>, IkError> {
    let Some(told) = &options.weights else { return Ok(vec![1.0; markers.len()]) };
    if let Some((name, weight)) = told.iter().find(|(_, weight)| !(*weight >= 0.0 && weight.is_finite())) {
        return Err(IkError::Weight { name: name.clone(), weight: *weight });
    }
    // As with settings everywhere, the last one counts.
    let of = |marker: &Marker| told.iter().rev().find(|(name, _)| *name == marker.name);
    Ok(markers.iter().map(|marker| of(marker).map_or(0.0, |(_, weight)| *weight)).collect())
}

fn rest(figure: &Figure, options: &IkOptions) -> Result<Vec<f64>, IkError> {
    let mut rest = vec![0.0; figure.layout().nq()];
    figure.neutral(&mut rest)?;
    if let Some(given) = &options.rest {
        // Checks lengths and numbers, too.
        figure.integrate(given, &vec![0.0; figure.layout().nv()], &mut rest)?;
    }
    Ok(rest)
}

/// The degrees of freedom between the world and a link, from the root on.
fn path(figure: &Figure, link: usize) -> Vec<usize> {
    let mut path = Vec::new();
    let mut next = Some(link);
    while let Some(link) = next {
        let at = figure.layout().joints()[link];
        path.extend((at.v..at.v + at.nv).rev());
        next = figure.links()[link].parent();
    }
    path.reverse();
    path
}

fn spheres(figure: &Figure) -> Vec<Option<usize>> {
    let of = figure.links().iter().zip(figure.layout().joints()).enumerate();
    of.flat_map(|(link, (it, at))| {
        let sphere = (!matches!(it.joint().kind(), JointKind::Axes(_))).then_some(link);
        std::iter::repeat_n(sphere, at.nv)
    })
    .collect()
}

fn listed<'n>(names: impl Iterator<Item = &'n str>) -> String {
    const MOST: usize = 5;
    let names: Vec<&str> = names.collect();
    match names.len() {
        0 => "none".to_owned(),
        n if n > MOST => format!("{} … ({n} in all)", names[..MOST].join(", ")),
        _ => names.join(", "),
    }
}
