//! Several figures as one.

use crate::anatomy::AnatomicalAngle;
use crate::figure::Figure;
use crate::follower::followers;
use crate::inertia::Inertia;
use crate::joint::{Joint, JointKind, Placement};
use crate::layout::StateLayout;
use crate::link::Link;
use crate::{FigureBuilder, FigureError, LinkSpec};
use std::collections::HashMap;

/// The link, and the joint, that carries figures that are one.
const WORLD: &str = "world";

impl Figure {
    /// Several figures as one: a link `world` without mass, which stands still, carries the roots of all, each where its placement says.
    /// All names have the name of their figure and a point before them: `ann.left_knee.rx`.
    ///
    /// What one figure does to another is then as within one: springs, pushes, nearness. Each moves as it would alone where
    /// nothing joins them.
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use solaris_model::{Figure, Placement, human};
    ///
    /// let (ann, bob) = (human(1.65, 58.0)?, human(1.8, 80.0)?);
    /// let apart = Placement::translation(0.0, 0.0, 1.5);
    /// let both = Figure::together(&[("ann", &ann, Placement::identity()), ("bob", &bob, apart)])?;
    /// assert!((both.mass() - 138.0).abs() < 1e-9);
    /// assert!(both.layout().dof_index("bob.left_knee.rx").is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`FigureError`] where two figures have the same name, or one has none.
    pub fn together(figures: &[(&str, &Figure, Placement)]) -> Result<Self, FigureError> {
        // The builder says what is wrong with names.
        let weld = |name: &str| Joint::new(name);
        let mut names =
            FigureBuilder::new("together").link(LinkSpec::root(WORLD, weld(WORLD)).inertia(Inertia::Point));
        for (name, ..) in figures {
            names = names.link(LinkSpec::child(*name, WORLD, weld(name)));
        }
        let carrier = names.build()?;
        let mut links = vec![carrier.links()[0].clone()];
        let mut angles = Vec::new();
        for (name, figure, placement) in figures {
            let first = links.len();
            links.extend(figure.links().iter().map(|link| renamed(link, name, first, placement)));
            angles.extend(figure.anatomical_angles().iter().map(|angle| {
                (
                    format!("{name}.{}", angle.name),
                    format!("{name}.{}", figure.layout().v_names()[angle.dof]),
                    angle.sign,
                )
            }));
        }
        let layout = StateLayout::of(&links);
        let angles = angles.into_iter().filter_map(|(name, dof, sign)| {
            let dof = layout.dof_index(&dof)?;
            layout.coordinate(dof).map(|coordinate| AnatomicalAngle { name, dof, coordinate, sign })
        });
        let by_name: HashMap<String, usize> =
            links.iter().enumerate().map(|(i, link)| (link.name.clone(), i)).collect();
        let all: Vec<&str> = figures.iter().map(|(name, ..)| *name).collect();
        Ok(Self {
            name: match &all[..] {
                [first, second, third, rest @ ..] if rest.len() > 1 => {
                    format!("{first}, {second}, {third} and {} more", rest.len())
                }
                few => few.join(" and "),
            },
            followers: followers(&links, &layout),
            angles: angles.collect(),
            layout,
            links,
            by_name,
            stature: None,
            gravity: figures.iter().find_map(|(_, figure, _)| figure.gravity().copied()),
        })
    }

    /// The figure elsewhere in the world: the joint of its root stands so placed.
    #[must_use]
    pub fn placed(&self, placement: &Placement) -> Self {
        let mut placed = self.clone();
        let joint = &mut placed.links[0].joint;
        joint.placement = placement * joint.placement;
        joint.placement.rotation.renormalize();
        placed
    }
}

/// A link of a figure that is one of several: its index moves up by `first`, and its root is carried by the world.
fn renamed(link: &Link, name: &str, first: usize, placement: &Placement) -> Link {
    let of = |own: &str| format!("{name}.{own}");
    let mut link = link.clone();
    link.name = of(&link.name);
    link.joint.name = of(&link.joint.name);
    for frame in &mut link.frames {
        frame.name = of(&frame.name);
    }
    if let JointKind::Axes(dofs) = &mut link.joint.kind {
        for dof in dofs {
            dof.name = dof.name.as_deref().map(of);
            if let Some(follow) = &mut dof.follows {
                follow.dof = of(&follow.dof);
            }
        }
    }
    if let Some(parent) = link.parent {
        link.parent = Some(parent + first);
    } else {
        link.parent = Some(0);
        link.joint.placement = placement * link.joint.placement;
        link.joint.placement.rotation.renormalize();
    }
    link
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    fn arm() -> Figure {
        let base =
            LinkSpec::root("base", Joint::free("root")).mass(2.0).inertia(Inertia::diagonal(0.1, 0.1, 0.1));
        let arm = Joint::new("shoulder").at(Vector3::new(0.0, 0.3, 0.0)).rx();
        let arm = LinkSpec::child("arm", "base", arm).mass(1.0).com(Vector3::new(0.0, -0.2, 0.0));
        FigureBuilder::new("arm").link(base).link(arm).build().expect("valid")
    }

    #[test]
    fn names_say_whose_they_are_and_roots_stand_where_they_are_put() {
        let at = Placement::translation(1.0, 0.0, 2.0);
        let both =
            Figure::together(&[("a", &arm(), Placement::identity()), ("b", &arm(), at)]).expect("valid");
        let names: Vec<&str> = both.links().iter().map(Link::name).collect();
        assert_eq!(names, ["world", "a.base", "a.arm", "b.base", "b.arm"]);
        assert_eq!(both.layout().nv(), 14);
        assert_eq!(both.layout().dof_index("b.shoulder.rx"), Some(13));
        assert_eq!(both.links()[4].parent(), Some(3));
        assert!(
            (both.links()[3].joint().placement().translation.vector - Vector3::new(1.0, 0.0, 2.0)).norm()
                < 1e-15
        );
        assert_eq!(both.link_index("b.arm"), Some(4));
    }

    #[test]
    fn two_of_one_name_are_refused() {
        let refused =
            Figure::together(&[("a", &arm(), Placement::identity()), ("a", &arm(), Placement::identity())]);
        assert!(refused.expect_err("two").to_string().contains("'a'"));
    }
}
