//! Re-rooting: the same figure as a tree that hangs on another link.

mod build;
mod error;
mod reverse;

pub use error::RerootError;

use crate::figure::Figure;
use crate::fuse::LinkPlace;
use nalgebra::Vector3;
use solaris_text::nearest;

/// The point of a link that becomes the origin of the new root, whose axes are the link's.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum RootAt {
    /// The link's own origin, where its joint has moved it.
    Joint,
    /// The link's tip.
    Tip,
    /// A point in the link's frame (m), such as one of its sole.
    Point(Vector3<f64>),
}

/// A figure as a tree that hangs on another link: a view for computing, with the maps of links and joints.
///
/// The new root moves by a free joint against the world; the old root's joint is gone. On the path from the new root to
/// the old one every joint is turned round: it moves the link that was its parent. With `P` the joint's placement and
/// `E_k` what its degrees of freedom do,
///
/// ```text
/// (P·E(e₁, q₁)·…·E(eₙ, qₙ))⁻¹ = E(−eₙ, qₙ)·…·E(−e₁, q₁)·P⁻¹
/// ```
///
/// so that the coordinates keep their values, in the opposite order; the link that was the parent gets
/// the frame in which the joint was placed, and its own frame stays as a named frame, if its name is not taken. A ball
/// joint turned round has the conjugate quaternion. All joints and degrees of freedom keep their names but those of the
/// old root's joint; the new root's joint is called `world~LINK`.
///
/// A motion's columns are those of the figure as it was declared: `solaris-dynamics` has the maps of states and forces.
#[doc(alias = "change root")]
#[derive(Clone, Debug)]
pub struct Rerooted {
    figure: Figure,
    links: Vec<LinkPlace>,
    joints: Vec<Option<JointInView>>,
    path: Vec<usize>,
}

/// The place of a joint of the declared figure in a view.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JointInView {
    /// The view's link that it moves.
    pub link: usize,
    /// Whether it moves what was its parent.
    pub reversed: bool,
}

impl Figure {
    /// The figure as a tree that hangs on the link of index `link`.
    ///
    /// # Errors
    ///
    /// [`RerootError`] for a link that does not exist, a tip that the link has not, a point that is not finite, a joint that
    /// would move nothing of mass, and a free joint with armature on the way.
    ///
    /// # Examples
    ///
    /// ```
    /// use solaris_model::RootAt;
    /// let ann = solaris_model::human(1.65, 58.0)?;
    /// let view = ann.reroot_named("left_foot", RootAt::Joint)?;
    /// assert_eq!(view.figure().links()[0].name(), "left_foot");
    /// // The knee now moves the thigh against the shank, by the same angles in the opposite order.
    /// let thigh = view.figure().link("left_thigh").expect("a link");
    /// assert_eq!(thigh.joint().name(), "left_knee");
    /// assert_eq!(view.figure().layout().v_names()[9..12], ["left_knee.rx", "left_knee.ry", "left_knee.rz"]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "change root")]
    #[doc(alias = "floating base")]
    pub fn reroot(&self, link: usize, at: RootAt) -> Result<Rerooted, RerootError> {
        let Some(root) = self.links.get(link) else {
            return Err(RerootError::NoSuchLink { link, last: self.links.len() - 1 });
        };
        let origin = match at {
            RootAt::Joint => Vector3::zeros(),
            RootAt::Tip => *root.tip().ok_or_else(|| RerootError::NoTip { link: root.name().to_owned() })?,
            RootAt::Point(point) => point,
        };
        if let Some(value) = origin.iter().find(|x| !x.is_finite()) {
            return Err(RerootError::NotFinite { link: root.name().to_owned(), value: *value });
        }
        build::rerooted(self, link, &origin)
    }

    /// The figure as a tree that hangs on the link called `link`: see [`reroot`](Self::reroot).
    ///
    /// # Errors
    ///
    /// As for [`reroot`](Self::reroot); a name that is none comes with the nearest that is one.
    pub fn reroot_named(&self, link: &str, at: RootAt) -> Result<Rerooted, RerootError> {
        let Some(index) = self.link_index(link) else {
            let nearest = nearest(link, self.links.iter().map(|link| link.name.as_str()));
            return Err(RerootError::UnknownLink { name: link.to_owned(), nearest });
        };
        self.reroot(index, at)
    }
}

impl Rerooted {
    /// The figure that hangs on the new root; its link 0.
    pub fn figure(&self) -> &Figure {
        &self.figure
    }

    /// For each link of the declared figure, its index in the view, and where its declared frame stands in its frame there.
    pub fn links(&self) -> &[LinkPlace] {
        &self.links
    }

    /// For each joint of the declared figure, by the link that it moves there, where it is in the view; `None` for the
    /// declared root's.
    pub fn joints(&self) -> &[Option<JointInView>] {
        &self.joints
    }

    /// The links of the declared figure from the new root to the old one, both included.
    pub fn path(&self) -> &[usize] {
        &self.path
    }
}
