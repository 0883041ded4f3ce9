//! Frames fixed to links.

use crate::error::DynamicsError;
use crate::kinematics::acceleration::carried;
use crate::scalar::Scalar;
use crate::spatial::direction::{apply, cross};
use crate::spatial::{Pose, Twist};
use crate::tree::Tree;
use crate::workspace::Workspace;
use nalgebra::{Matrix3, Vector3};
use solaris_model::{Figure, nearest};

/// A frame fixed to a link: what a Jacobian is asked about.
///
/// ```
/// use solaris_dynamics::Frame;
/// use solaris_model::{Vector3, human};
///
/// let ann = human(1.65, 58.0)?;
/// let hand = Frame::<f64>::named(&ann, "left_hand")?;
/// assert_eq!(hand, Frame::of_link(ann.link_index("left_hand").unwrap()));
/// let error = Frame::<f64>::named(&ann, "left_hnd").unwrap_err();
/// assert!(error.to_string().ends_with("did you mean 'left_hand'?"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "operational frame")]
#[doc(alias = "site")]
#[doc(alias = "end effector")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<T> {
    /// Index of the link.
    pub link: usize,
    /// Where the frame stands in the link's frame (m).
    pub placement: Pose<T>,
}

impl<T: Scalar> Frame<T> {
    /// The link's own frame.
    pub fn of_link(link: usize) -> Self {
        Self { link, placement: Pose::identity() }
    }

    /// A frame with the link's axes at a `point` of the link (m, the link's frame).
    pub fn at(link: usize, point: Vector3<T>) -> Self {
        Self { link, placement: Pose { rotation: Matrix3::identity(), translation: point } }
    }

    /// The frame of the figure called `name`, or, if no frame is, the own frame of the link called so.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::UnknownFrame`] with the nearest name.
    pub fn named(figure: &Figure, name: &str) -> Result<Self, DynamicsError> {
        let frames = || {
            let links = figure.links().iter().enumerate();
            links.flat_map(|(index, link)| link.frames().iter().map(move |frame| (index, frame)))
        };
        if let Some((link, frame)) = frames().find(|(_, frame)| frame.name == name) {
            return Ok(Self { link, placement: Pose::of(&frame.placement) });
        }
        figure.link_index(name).map(Self::of_link).ok_or_else(|| {
            let links = figure.links().iter().map(solaris_model::Link::name);
            let names = frames().map(|(_, frame)| frame.name.as_str()).chain(links);
            DynamicsError::UnknownFrame { name: name.to_owned(), nearest: nearest(name, names) }
        })
    }

    /// The pose of the frame in the world, since the last operation on the workspace that is said to place the links.
    ///
    /// # Panics
    ///
    /// Where the tree has no such link; so the others.
    pub fn pose(&self, workspace: &Workspace<T>) -> Pose<T> {
        workspace.poses[self.link].then(&self.placement)
    }

    /// The velocity of the frame, in world axes, since the last operation that is said to find the links' velocities.
    pub fn velocity(&self, workspace: &Workspace<T>) -> Twist<T> {
        let Twist { linear, angular } = workspace.twists[self.link];
        Twist { linear: linear + cross(&angular, &self.arm(workspace)), angular }
    }

    /// The acceleration of the frame, in world axes, since the last operation that is said to find the links' accelerations:
    ///
    /// ```text
    /// ẍ + α × r + ω × (ω × r)
    /// ```
    pub fn acceleration(&self, workspace: &Workspace<T>) -> Twist<T> {
        let (spin, Twist { linear, angular }) =
            (workspace.twists[self.link].angular, workspace.accelerations[self.link]);
        Twist { linear: linear + carried(&spin, &angular, &self.arm(workspace)), angular }
    }

    /// From the link's origin to the frame's, in world axes.
    pub(crate) fn arm(&self, workspace: &Workspace<T>) -> Vector3<T> {
        apply(&workspace.poses[self.link].rotation, &self.placement.translation)
    }

    /// Refuses a link that the tree does not have.
    pub(crate) fn check(&self, tree: &Tree<T>) -> Result<(), DynamicsError> {
        let last = tree.link_count() - 1;
        if self.link > last {
            return Err(DynamicsError::UnknownLink { link: self.link, last });
        }
        let Pose { rotation, translation } = &self.placement;
        match rotation.iter().chain(translation.iter()).find(|x| !x.is_finite()) {
            None => Ok(()),
            Some(x) => Err(DynamicsError::FrameNotFinite {
                link: tree.link_name(self.link),
                value: format!("{x:?}"),
            }),
        }
    }
}
