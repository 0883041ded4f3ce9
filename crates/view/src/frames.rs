//! Where every link is in every frame.

use crate::camera::{Bounds, Camera};
use crate::draw::Drawn;
use crate::error::ViewError;
use crate::world::World;
use glam::{DQuat, DVec3};
use solaris_dynamics::{Tree, Workspace, center_of_mass};
use solaris_model::{Figure, Motion};

/// Most frames a second that a page holds (1/s), where these are more than 60 in all.
pub const FRAME_RATE: f64 = 60.0;

/// Frames that what lasts for less than a second may have all the same: it is looked at slowly.
const FEW: usize = 60;

/// The samples that become frames: every n-th from the first on.
pub(crate) fn chosen(motion: &Motion) -> Vec<usize> {
    let step = (motion.info.rate / FRAME_RATE - 1e-9).ceil().max(1.0) as usize;
    let step = step.min(motion.len().saturating_sub(1) / FEW).max(1);
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
    /// The box around all that is drawn of the links, one a frame, in the page's world (m).
    pub(crate) boxes: Vec<Bounds>,
}

impl Frames {
    /// Runs the forward kinematics for every chosen sample; `drawn` says what the links look like.
    ///
    /// # Errors
    ///
    /// What the kernel refuses.
    pub(crate) fn new(
        figure: &Figure,
        motion: &Motion,
        chosen: &[usize],
        world: &World,
        drawn: &[Drawn],
    ) -> Result<Self, ViewError> {
        let tree = Tree::<f64>::new(figure, motion.info.gravity)?;
        let mut workspace = Workspace::new(&tree);
        let count = drawn.len();
        let mut frames = Self {
            root: Vec::with_capacity(chosen.len()),
            positions: Vec::with_capacity(chosen.len() * count),
            turns: Vec::with_capacity(chosen.len() * count),
            com: (figure.mass() > 0.0).then(Vec::new),
            boxes: Vec::with_capacity(chosen.len()),
        };
        for &sample in chosen {
            // Also runs the forward kinematics.
            let com = center_of_mass(&tree, &mut workspace, motion.q(sample))?;
            let root = world.vector(&workspace.pose(0).translation);
            frames.root.push(root);
            let mut bounds: Option<Bounds> = None;
            for (i, link) in drawn.iter().enumerate() {
                let pose = workspace.pose(i);
                let (place, turn) = (world.vector(&pose.translation), world.rotation(&pose.rotation));
                frames.positions.push(place - root);
                frames.push_turn(turn, count);
                bounds = link
                    .bounds(place, turn)
                    .map(|link| bounds.map_or(link, |all| all.union(link)))
                    .or(bounds);
            }
            frames.boxes.push(bounds.unwrap_or(Bounds { low: root, high: root }));
            if let Some(trail) = &mut frames.com {
                trail.push(world.vector(&com) - root);
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

    /// The camera that has all of it in view; `climbs`: whether the ground is not level.
    pub(crate) fn camera(&self, climbs: bool) -> Camera {
        let com: Option<Vec<DVec3>> =
            self.com.as_ref().map(|com| com.iter().zip(&self.root).map(|(com, root)| *com + *root).collect());
        Camera::new(&self.boxes, com.as_ref().unwrap_or(&self.root), climbs)
    }

    /// Height of the lowest point at any time (m).
    pub(crate) fn lowest(&self) -> f64 {
        self.boxes.iter().map(|bounds| bounds.low.y).fold(f64::INFINITY, f64::min)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris_model::{FigureBuilder, Joint, LinkSpec, MotionInfo};

    fn frames(rate: f64, duration: f64) -> usize {
        let figure = FigureBuilder::new("hinge")
            .link(LinkSpec::root("rod", Joint::new("pivot").rz()).mass(1.0))
            .build()
            .expect("valid");
        let count = (rate * duration).round() as usize + 1;
        let times = (0..count).map(|i| i as f64 / rate).collect();
        let info = MotionInfo {
            fingerprint: figure.fingerprint(),
            gravity: nalgebra::Vector3::zeros(),
            ground: None,
            rate,
        };
        let columns = [vec![0.0; count], vec![0.0; count], vec![0.0; count]];
        chosen(&Motion::new(&figure, info, times, columns).expect("valid")).len()
    }

    #[test]
    fn sixty_a_second_and_all_of_what_is_short() {
        assert_eq!(frames(60.0, 2.0), 121);
        assert_eq!(frames(120.0, 2.0), 121);
        assert_eq!(frames(1000.0, 2.0), 118);
        assert_eq!(frames(120.0, 1.0), 61);
        assert_eq!(frames(120.0, 0.5), 61);
        assert_eq!(frames(2000.0, 0.03), 61);
        assert_eq!(frames(1e5, 0.03), 61);
        assert_eq!(frames(30.0, 0.1), 4);
    }
}
