//! Floating and fixed bases: the joint that ties a figure's root to the world.

use crate::anatomy::AnatomicalAngle;
use crate::figure::Figure;
use crate::follower::followers;
use crate::joint::{Dof, Joint, JointKind};
use crate::layout::{StateLayout, velocity_names};
use crate::link::Link;

/// The base of a figure: how its root may move against the world.
#[doc(alias = "floating base")]
#[doc(alias = "fixed base")]
#[doc(alias = "root joint")]
#[doc(alias = "free flyer")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Base {
    /// As the figure has it.
    Fixed,
    /// By six degrees of freedom `root.tx`, `root.ty`, `root.tz`, `root.rz`, `root.ry`, `root.rx`, in this order.
    Floating,
    /// By a free joint `root`: see [`JointKind::Free`].
    Free,
}

/// The error of a change of base: why a figure cannot stand on a base.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BaseError {
    /// The root moves already, in another way.
    #[error(
        "joint '{joint}' moves the root '{root}' already, by {dofs}; leave the base as the figure has it (fixed), or weld \
         that joint first"
    )]
    Moves {
        /// The root's joint.
        joint: String,
        /// The root.
        root: String,
        /// Its degrees of freedom.
        dofs: String,
    },
    /// A name that the new joint needs is taken.
    #[error(
        "the base needs a joint 'root' with the dof '{dof}', but the figure has a {kind} '{name}' elsewhere; rename that one"
    )]
    Taken {
        /// What the base needs.
        dof: String,
        /// What has the name.
        kind: &'static str,
        /// The name.
        name: String,
    },
    /// A root that moves has to move some mass.
    #[error(
        "the figure '{figure}' has no mass, so no force could be found for a base that moves; give a link mass"
    )]
    Massless {
        /// The figure.
        figure: String,
    },
}

impl Figure {
    /// The figure with its root on another base.
    ///
    /// A root that is welded to the world gets a joint called `root` in the weld's place, which the first coordinates move;
    /// links, frames, angles and followers stay. A root that moves just so already stays as it is, whatever its joint is
    /// called.
    ///
    /// # Errors
    ///
    /// [`BaseError`] for a root that moves in another way, a name that is taken, and a figure without mass.
    ///
    /// # Examples
    ///
    /// ```
    /// use solaris_model::{Base, FigureBuilder, Joint, LinkSpec};
    /// let arm = FigureBuilder::new("arm")
    ///     .link(LinkSpec::root("base", Joint::new("ground")).mass(4.0))
    ///     .link(LinkSpec::child("boom", "base", Joint::new("shoulder").rx()).mass(1.0))
    ///     .build()?;
    /// let floating = arm.on_base(Base::Floating)?;
    /// assert_eq!(floating.layout().v_names()[5..], ["root.rx", "shoulder.rx"]);
    /// assert_eq!(arm.on_base(Base::Free)?.layout().nq(), 8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "floating base")]
    #[doc(alias = "fixed base")]
    pub fn on_base(&self, base: Base) -> Result<Self, BaseError> {
        let root = &self.links[0];
        let wanted = match base {
            Base::Fixed => return Ok(self.clone()),
            Base::Floating => Joint::new("root").tx().ty().tz().rz().ry().rx(),
            Base::Free => Joint::free("root"),
        };
        if same_motion(root.joint.kind(), wanted.kind()) {
            return Ok(self.clone());
        }
        if root.joint.kind().nv() > 0 {
            let dofs = velocity_names(root.joint.name(), root.joint.kind()).join(", ");
            let (joint, root) = (root.joint.name.clone(), root.name.clone());
            return Err(BaseError::Moves { joint, root, dofs });
        }
        if self.mass() <= 0.0 {
            return Err(BaseError::Massless { figure: self.name.clone() });
        }
        self.check_free_names(&wanted)?;
        let mut links = self.links.clone();
        links[0].joint = wanted.placed(root.joint.placement);
        Ok(self.with_links(links))
    }

    /// Whether the root's joint places the whole figure in the world, rather than hold it there as a hinge does: it is free, or it
    /// slides along two axes at least and turns besides. The forces of such a joint come out of the air.
    ///
    /// ```
    /// use solaris_model::{Base, FigureBuilder, Joint, LinkSpec};
    /// let arm = FigureBuilder::new("arm").link(LinkSpec::root("base", Joint::new("ground")).mass(4.0)).build()?;
    /// assert!(!arm.root_is_free() && arm.on_base(Base::Floating)?.root_is_free());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "floating base")]
    pub fn root_is_free(&self) -> bool {
        self.links[0].joint.kind().is_floating()
    }

    /// Refuses the joint of a base whose names the rest of the figure has.
    fn check_free_names(&self, wanted: &Joint) -> Result<(), BaseError> {
        let dofs = velocity_names(wanted.name(), wanted.kind());
        if self.links.iter().skip(1).any(|link| link.joint.name == wanted.name) {
            let (dof, name) = (dofs[0].clone(), wanted.name.clone());
            return Err(BaseError::Taken { dof, kind: "joint", name });
        }
        // A one-dof joint answers to its own name as well.
        match dofs.into_iter().find(|dof| self.layout.dof_index(dof).is_some()) {
            Some(dof) => Err(BaseError::Taken { name: dof.clone(), kind: "dof", dof }),
            None => Ok(()),
        }
    }

    /// The figure with other links in the same order, whose degrees of freedom have the same names as far as angles and
    /// followers name them.
    pub(crate) fn with_links(&self, links: Vec<Link>) -> Self {
        let layout = StateLayout::of(&links);
        let angles = self.angles.iter().filter_map(|angle| {
            let dof = layout.dof_index(&self.layout.v_names()[angle.dof])?;
            let coordinate = layout.coordinate(dof)?;
            Some(AnatomicalAngle { dof, coordinate, ..angle.clone() })
        });
        let (angles, followers) = (angles.collect(), followers(&links, &layout));
        Self { links, layout, angles, followers, ..self.clone() }
    }
}

/// Whether two joints have the same axes in the same order, or are both free; names and limits may differ.
fn same_motion(one: &JointKind, other: &JointKind) -> bool {
    match (one, other) {
        (JointKind::Free { .. }, JointKind::Free { .. }) => true,
        (JointKind::Axes(one), JointKind::Axes(other)) => {
            let axes = |dofs: &[Dof]| dofs.iter().map(|dof| dof.axis).collect::<Vec<_>>();
            axes(one) == axes(other)
        }
        _ => false,
    }
}
