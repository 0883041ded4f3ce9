//! A figure posed by a walk at a time.

use nalgebra::Vector3;
use solaris_dynamics::{Pose, Tree, Workspace, forward_kinematics};
use solaris_model::{Figure, SolePart, Trajectory};

/// A figure posed by a walk.
pub(crate) struct Posed<'a> {
    walk: &'a dyn Trajectory,
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    q: Vec<f64>,
}

impl<'a> Posed<'a> {
    pub(crate) fn new(figure: &Figure, walk: &'a dyn Trajectory) -> Self {
        let tree = Tree::<f64>::new(figure, Vector3::zeros()).expect("a tree");
        Self { walk, workspace: Workspace::new(&tree), tree, q: vec![0.0; figure.layout().nq()] }
    }

    pub(crate) fn pose(&mut self, t: f64) {
        self.walk.configuration(t, &mut self.q);
        forward_kinematics(&self.tree, &mut self.workspace, &self.q).expect("a configuration");
    }

    /// World position of a link's point.
    pub(crate) fn at(&self, link: usize, point: &Vector3<f64>) -> Vector3<f64> {
        self.workspace.pose(link).transform(point)
    }

    /// Height of the lowest point of both soles.
    pub(crate) fn lowest(&self, figure: &Figure) -> f64 {
        let mut lowest = f64::INFINITY;
        for name in ["left_foot", "right_foot", "left_toes", "right_toes"] {
            let link = figure.link_index(name).expect("a foot");
            for part in [SolePart::Heel, SolePart::Ball, SolePart::ToeTip] {
                let Some(point) = figure.links()[link].sole_point(part) else { continue };
                lowest = lowest.min(self.at(link, point).y);
            }
        }
        lowest
    }

    /// A link's pose.
    pub(crate) fn pose_of(&self, link: usize) -> &Pose<f64> {
        self.workspace.pose(link)
    }
}
