//! What a frame asks of the ground and of the joints.

use crate::body::FEET;
use crate::body::roles::TOES;
use crate::error::GaitError;
use crate::walking::G;
use nalgebra::Vector3;
use solaris_analysis::{FootSupport, split_at_pivot};
use solaris_dynamics::{DynamicsError, Tree, Workspace, Wrench, center_of_mass, inverse_dynamics};
use solaris_model::{Contact, Figure, SolePart};

/// A foot, and its toes, which bear the load once the centre of pressure has passed the ball.
#[derive(Clone)]
struct Sole {
    foot: usize,
    toes: usize,
    /// In the toes' frame (m).
    ball: Vector3<f64>,
    tip: Vector3<f64>,
}

/// An inverse dynamics of the walker, and room for a frame.
#[derive(Clone)]
pub(super) struct Forces {
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    feet: Vec<Sole>,
    pub(super) v: Vec<f64>,
    pub(super) a: Vec<f64>,
}

impl Forces {
    pub(super) fn new(figure: &Figure) -> Result<Self, GaitError> {
        let tree: Tree<f64> = Tree::new(figure, Vector3::new(0.0, -G, 0.0))?;
        let sole = |(foot, toes): (&str, &str)| {
            let (foot, toes) = (figure.link_index(foot)?, figure.link_index(toes)?);
            let point = |part| figure.links()[toes].sole_point(part).copied();
            Some(Sole { foot, toes, ball: point(SolePart::Ball)?, tip: point(SolePart::ToeTip)? })
        };
        Ok(Self {
            workspace: Workspace::new(&tree),
            // Whoever walks has them: that was looked at before.
            feet: FEET.into_iter().zip(TOES).filter_map(sole).collect(),
            v: vec![0.0; tree.nv()],
            a: vec![0.0; tree.nv()],
            tree,
        })
    }

    /// The ground's force on each foot (left, right) in a configuration, with the velocities and accelerations in `v` and `a`, a push, and the feet's shares; writes
    /// the joints' forces.
    pub(super) fn solve(
        &mut self,
        q: &[f64],
        push: Option<(usize, Wrench<f64>)>,
        supports: &[FootSupport; 2],
        pivot: f64,
        tau: &mut [f64],
    ) -> Result<[Contact; 2], DynamicsError> {
        let Self { tree, workspace, feet, v, a } = self;
        let mut acts = [(0, Wrench::zero()); 3];
        let pushes = usize::from(push.is_some());
        if let Some(push) = push {
            acts[0] = push;
        }
        inverse_dynamics(tree, workspace, q, v, a, &acts[..pushes], tau)?;
        let total = workspace.base_wrench();
        let com = center_of_mass(tree, workspace, q)?;
        let up = Vector3::y();
        let Some(contacts) = split_at_pivot(&total, &com, &up, pivot, supports) else {
            return Ok([Contact::default(); 2]);
        };
        for (i, (sole, contact)) in feet.iter().zip(&contacts).enumerate() {
            let pose = workspace.pose(sole.toes);
            let place = |point: Vector3<f64>| pose.rotation * point + pose.translation;
            let (ball, tip) = (place(sole.ball), place(sole.tip));
            let link = if (contact.cop - ball).dot(&(tip - ball)) > 0.0 { sole.toes } else { sole.foot };
            acts[pushes + i] = (link, Wrench { force: contact.force, moment: contact.moment });
        }
        inverse_dynamics(tree, workspace, q, v, a, &acts[..pushes + feet.len()], tau)?;
        Ok(contacts)
    }
}
