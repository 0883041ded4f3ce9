//! Poses for a picture that is drawn while its figure moves.

use crate::error::ViewError;
use crate::world::World;
use nalgebra::Vector3;
use solaris_dynamics::{Tree, Workspace, center_of_mass};
use solaris_model::Figure;

/// Where the links of a figure are in the page's world (x left, y up, z forward), configuration after configuration.
///
/// A picture is begun with the [`page_data`](crate::page_data) of one sample, and goes on with these poses.
///
/// ```
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
/// use solaris_view::Live;
///
/// // A slide along z, which is up.
/// let bob = LinkSpec::root("bob", Joint::new("slide").tz()).mass(1.0);
/// let figure = FigureBuilder::new("lift").link(bob).build()?;
/// let mut live = Live::new(&figure, Vector3::new(0.0, 0.0, -9.80665))?;
/// assert_eq!(live.poses(&[0.5])?[..3], [0.0, 0.5, 0.0]);
/// assert_eq!(live.own([0.0, 0.5, 0.0]), Vector3::new(0.0, 0.0, 0.5));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Live {
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    world: World,
    poses: Vec<f32>,
    com: [f64; 3],
}

impl Live {
    /// Of a figure under a gravity (m/s²), which says where up is.
    ///
    /// # Errors
    ///
    /// What the kernel refuses.
    pub fn new(figure: &Figure, gravity: Vector3<f64>) -> Result<Self, ViewError> {
        let tree = Tree::<f64>::new(figure, gravity)?;
        let (workspace, poses) = (Workspace::new(&tree), vec![0.0; 7 * tree.link_count()]);
        Ok(Self { workspace, world: World::new(&gravity, None), poses, com: [0.0; 3], tree })
    }

    /// The poses at a configuration (`nq`): seven numbers a link, its place (m) and its quaternion (x, y, z, w). Nothing is allocated.
    ///
    /// # Errors
    ///
    /// What the kernel refuses: another length, numbers that are none.
    pub fn poses(&mut self, q: &[f64]) -> Result<&[f32], ViewError> {
        // Also runs the forward kinematics.
        let com = center_of_mass(&self.tree, &mut self.workspace, q)?;
        self.com = self.world.vector(&com).into();
        for (link, out) in self.poses.chunks_exact_mut(7).enumerate() {
            let pose = self.workspace.pose(link);
            let place = self.world.vector(&pose.translation).as_vec3();
            let turn = self.world.rotation(&pose.rotation).as_quat();
            out[..3].copy_from_slice(&place.to_array());
            out[3..].copy_from_slice(&turn.to_array());
        }
        Ok(&self.poses)
    }

    /// The centre of mass (m) of the last configuration, in the page's world.
    pub fn com(&self) -> [f64; 3] {
        self.com
    }

    /// A vector of the figure's world in the page's.
    pub fn shown(&self, own: &Vector3<f64>) -> [f64; 3] {
        self.world.vector(own).into()
    }

    /// A vector of the page's world in the figure's own.
    pub fn own(&self, shown: [f64; 3]) -> Vector3<f64> {
        self.world.own(shown)
    }

    /// A point (m) of the page's world in the frame of a link, where the link was in the last configuration.
    pub fn in_link(&self, link: usize, shown: [f64; 3]) -> Vector3<f64> {
        let pose = self.workspace.pose(link);
        pose.rotation.transpose() * (self.own(shown) - pose.translation)
    }

    /// A point (m) in the frame of a link in the page's world, where the link was in the last configuration.
    pub fn from_link(&self, link: usize, point: &Vector3<f64>) -> [f64; 3] {
        self.shown(&self.workspace.pose(link).transform(point))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{PageOptions, page_data};
    use solaris_model::{Motion, MotionInfo, human};

    #[test]
    fn poses_are_those_of_a_page() {
        let ann = human(1.65, 58.0).expect("a person");
        let gravity = Vector3::new(0.0, -9.80665, 0.0);
        let mut live = Live::new(&ann, gravity).expect("a tree");
        let q: Vec<f64> = (0..ann.layout().nq()).map(|i| 0.01 * i as f64).collect();
        let poses = live.poses(&q).expect("poses").to_vec();
        // A point goes to a link and back.
        let hand = ann.link_index("left_hand").expect("a hand");
        let point = live.in_link(hand, [0.3, 1.0, -0.2]);
        let back = live.from_link(hand, &point);
        assert!(back.iter().zip([0.3, 1.0, -0.2]).all(|(a, b)| (a - b).abs() < 1e-12), "{back:?}");
        // The page holds places relative to the root's to 0.02 mm.
        let info = MotionInfo { fingerprint: ann.fingerprint(), gravity, ground: None, rate: 60.0 };
        let (nq, nv) = (ann.layout().nq(), ann.layout().nv());
        let motion = Motion::new(&ann, info, vec![0.0], [q[..nq].to_vec(), vec![0.0; nv], vec![0.0; nv]]);
        let data = page_data(&ann, &motion.expect("one sample"), &PageOptions::default()).expect("data");
        let data: serde_json::Value = serde_json::from_str(&data).expect("JSON");
        assert_eq!(data["links"].as_array().map(Vec::len), Some(poses.len() / 7));
        assert_eq!(data["links"][hand]["name"], "left_hand");
    }

    #[test]
    fn a_wrong_length_is_refused() {
        let ann = human(1.65, 58.0).expect("a person");
        let mut live = Live::new(&ann, Vector3::new(0.0, -9.80665, 0.0)).expect("a tree");
        assert!(live.poses(&[0.0; 3]).is_err());
    }
}
