//! Where every link is in every frame.

use crate::error::ViewError;
use crate::world::World;
use glam::{DQuat, DVec3};
use nalgebra::Vector3;
use solaris_dynamics::{Tree, Workspace, center_of_mass};
use solaris_model::{Figure, Link, Motion};

/// Most frames a second that a page holds (1/s).
pub const FRAME_RATE: f64 = 60.0;

/// The samples that become frames: every n-th from the first on.
pub(crate) fn chosen(motion: &Motion) -> Vec<usize> {
    let step = (motion.info.rate / FRAME_RATE - 1e-9).ceil().max(1.0) as usize;
    (0..motion.len()).step_by(step).collect()
}

/// Poses in the page's world, relative to the position of the root link (m).
pub(crate) struct Frames {
    /// Position of the root link, one a frame.
    pub(crate) root: Vec<DVec3>,
    /// Positions of the links, `links` a frame.
    pub(crate) positions: Vec<DVec3>,
    /// Orientations of the links, `links` a frame, without a change of sign from one frame to the next.
    pub(crate) turns: Vec<DQuat>,
    /// Centre of mass, one a frame; none for a figure without mass.
    pub(crate) com: Option<Vec<DVec3>>,
    /// Lowest and highest point of the figure's outline at any time, in the page's world (m).
    pub(crate) heights: (f64, f64),
    /// The same in the first frame.
    pub(crate) first_heights: (f64, f64),
}

impl Frames {
    /// Runs the forward kinematics for every chosen sample.
    ///
    /// # Errors
    ///
    /// What the kernel refuses.
    pub(crate) fn new(
        figure: &Figure,
        motion: &Motion,
        chosen: &[usize],
        world: &World,
    ) -> Result<Self, ViewError> {
        let tree = Tree::<f64>::new(figure, motion.info.gravity)?;
        let mut workspace = Workspace::new(&tree);
        let links = figure.links();
        let count = links.len();
        let mut frames = Self {
            root: Vec::with_capacity(chosen.len()),
            positions: Vec::with_capacity(chosen.len() * count),
            turns: Vec::with_capacity(chosen.len() * count),
            com: (figure.mass() > 0.0).then(Vec::new),
            heights: (f64::INFINITY, f64::NEG_INFINITY),
            first_heights: (0.0, 0.0),
        };
        for &sample in chosen {
            // Also runs the forward kinematics.
            let com = center_of_mass(&tree, &mut workspace, motion.q(sample))?;
            let root = world.vector(&workspace.pose(0).translation);
            frames.root.push(root);
            for (i, link) in links.iter().enumerate() {
                let pose = workspace.pose(i);
                frames.positions.push(world.vector(&pose.translation) - root);
                frames.push_turn(world.rotation(&pose.rotation), count);
                for point in outline(link) {
                    let height = world.vector(&pose.transform(&point)).y;
                    frames.heights = (frames.heights.0.min(height), frames.heights.1.max(height));
                }
            }
            if let Some(trail) = &mut frames.com {
                trail.push(world.vector(&com) - root);
            }
            if frames.root.len() == 1 {
                frames.first_heights = frames.heights;
            }
        }
        Ok(frames)
    }

    /// Adds a link's turn with the sign that is nearer to the frame before.
    fn push_turn(&mut self, turn: DQuat, links: usize) {
        let before = self.turns.len().checked_sub(links).map(|at| self.turns[at]);
        let flip = before.is_some_and(|before| before.dot(turn) < 0.0);
        self.turns.push(if flip { -turn } else { turn });
    }

    /// Greatest distance of a link from the root along an axis (m).
    pub(crate) fn extent(&self) -> f64 {
        self.positions.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max)
    }
}

/// Points of a link that say how high and low it reaches, in its frame (m).
fn outline(link: &Link) -> impl Iterator<Item = Vector3<f64>> + '_ {
    let shape = link.shape().map(|shape| shape.placement.translation.vector);
    let soles = link.sole().iter().map(|point| point.position);
    [Vector3::zeros()].into_iter().chain(link.tip().copied()).chain(shape).chain(soles)
}
