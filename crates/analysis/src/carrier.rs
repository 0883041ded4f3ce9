//! The carrier of a force on a foot: the foot's link or its toes'.

use nalgebra::Vector3;
use solaris_dynamics::Workspace;
use solaris_model::{Figure, SolePart};

/// One link, or a foot and its toes, which take over where the centre of pressure has passed the ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Carrier {
    link: usize,
    /// The toes' link, with the ball and the tip of its sole (m, in its frame).
    toes: Option<(usize, Vector3<f64>, Vector3<f64>)>,
}

impl Carrier {
    /// The link, of two the first.
    pub(crate) const fn first(&self) -> usize {
        self.link
    }

    /// Always the same link.
    pub(crate) const fn of_one(link: usize) -> Self {
        Self { link, toes: None }
    }

    /// A foot with toes; `None` where the toes' sole has no ball or no tip.
    pub(crate) fn of_two(figure: &Figure, link: usize, toes: usize) -> Option<Self> {
        let point = |part| figure.links()[toes].sole_point(part).copied();
        let (ball, tip) = (point(SolePart::Ball)?, point(SolePart::ToeTip)?);
        Some(Self::of_points(link, toes, [ball, tip]))
    }

    /// A foot with toes whose ball and tip (m) are in the toes' frame.
    pub(crate) const fn of_points(link: usize, toes: usize, [ball, tip]: [Vector3<f64>; 2]) -> Self {
        Self { link, toes: Some((toes, ball, tip)) }
    }

    /// Whether it depends on where the links are.
    pub(crate) fn moves(&self) -> bool {
        self.toes.is_some()
    }

    /// The link that a centre of pressure `cop` (m, world) acts on, where the links stand as `workspace` has placed them:
    /// the toes once it has passed the ball, in the direction from the ball to the tip.
    pub(crate) fn link(&self, workspace: &Workspace<f64>, cop: &Vector3<f64>) -> usize {
        let Some((toes, ball, tip)) = self.toes else { return self.link };
        let pose = workspace.pose(toes);
        let place = |point: Vector3<f64>| pose.rotation * point + pose.translation;
        let (ball, tip) = (place(ball), place(tip));
        if (cop - ball).dot(&(tip - ball)) > 0.0 { toes } else { self.link }
    }
}
