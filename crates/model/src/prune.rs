//! Pruning: a smaller figure without some links and all that hangs from them.

use crate::figure::Figure;
use crate::fuse::with_links;
use crate::link::Link;

/// A figure without some of its branches, with the maps between it and the full figure.
///
/// What is left is as it was: links, joints and the names of degrees of freedom, masses, springs. Where a degree of freedom
/// followed one that has left, it follows none.
///
/// States: `q`, `v`, `a` of the small figure are those of the full one without the entries of the joints that left. Forces are
/// others: nothing carries the branches any more.
#[doc(alias = "submodel")]
#[derive(Clone, Debug)]
pub struct Pruned {
    figure: Figure,
    links: Vec<Option<usize>>,
    kept_q: Vec<usize>,
    kept_v: Vec<usize>,
}

/// The error of pruning: why a figure cannot be pruned.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PruneError {
    /// No link has this index.
    #[error("link {link} cannot be pruned: the figure has {count}, numbered from 0")]
    NoSuchLink {
        /// What was asked for.
        link: usize,
        /// Number of links.
        count: usize,
    },
    /// Nothing would be left.
    #[error("the root, link 0, cannot be pruned: nothing would be left of the figure")]
    Root,
}

impl Figure {
    /// The figure without `links`, by index, and all that hangs from them.
    ///
    /// # Errors
    ///
    /// [`PruneError`] for an index that does not exist, and for the root.
    ///
    /// # Examples
    ///
    /// ```
    /// let ann = solaris_model::human(1.65, 58.0)?;
    /// let arm = ann.link_index("left_upper_arm").expect("a link of the human");
    /// let pruned = ann.prune(&[arm])?;
    /// assert!(pruned.figure().link("left_hand").is_none() && pruned.figure().link("right_hand").is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "remove links")]
    pub fn prune(&self, links: &[usize]) -> Result<Pruned, PruneError> {
        let count = self.links.len();
        let mut leaves = vec![false; count];
        for &link in links {
            *leaves.get_mut(link).ok_or(PruneError::NoSuchLink { link, count })? = true;
        }
        if leaves.first() == Some(&true) {
            return Err(PruneError::Root);
        }
        let (mut places, mut small): (Vec<Option<usize>>, Vec<Link>) =
            (Vec::with_capacity(count), Vec::new());
        let (mut kept_q, mut kept_v, mut dofs) = (Vec::new(), Vec::new(), vec![None; self.layout.nv()]);
        for (i, (link, at)) in self.links.iter().zip(self.layout.joints()).enumerate() {
            // Parents come first, so that theirs are known.
            let parent = link.parent.map(|parent| places[parent]);
            if leaves[i] || parent == Some(None) {
                places.push(None);
                continue;
            }
            places.push(Some(small.len()));
            small.push(Link { parent: parent.flatten(), ..link.clone() });
            kept_q.extend(at.q..at.q + at.nq);
            for (offset, dof) in dofs[at.v..at.v + at.nv].iter_mut().enumerate() {
                *dof = Some(kept_v.len());
                kept_v.push(at.v + offset);
            }
        }
        Ok(Pruned { figure: with_links(self, small, &dofs), links: places, kept_q, kept_v })
    }
}

impl Pruned {
    /// The small figure.
    pub fn figure(&self) -> &Figure {
        &self.figure
    }

    /// For each link of the full figure its index in the small one; `None` where it has left.
    pub fn links(&self) -> &[Option<usize>] {
        &self.links
    }

    /// For each entry of the small figure's `q`, its index in the full figure's; increasing.
    pub fn kept_q(&self) -> &[usize] {
        &self.kept_q
    }

    /// For each entry of the small figure's `v`, `a` and `tau`, its index in the full figure's; increasing.
    pub fn kept_v(&self) -> &[usize] {
        &self.kept_v
    }
}

#[cfg(test)]
mod tests {
    use super::PruneError;
    use crate::{Curve, Figure, FigureBuilder, Joint, LinkSpec};

    fn tree() -> Figure {
        FigureBuilder::new("tree")
            .link(LinkSpec::root("base", Joint::free("root")).mass(1.0))
            .link(LinkSpec::child("left", "base", Joint::new("l").rx().ry()).mass(1.0))
            .link(LinkSpec::child("right", "base", Joint::ball("r")).mass(1.0))
            .link(LinkSpec::child("left tip", "left", Joint::new("lt").tz()).mass(1.0))
            .link(
                LinkSpec::child(
                    "right tip",
                    "right",
                    Joint::new("rt").rx().following("lt", Curve::linear(2.0, 0.0)),
                )
                .mass(1.0),
            )
            .angle("bend", "lt", true)
            .angle("tip", "rt", false)
            .build()
            .expect("valid")
    }

    #[test]
    fn a_branch_leaves_with_all_that_hangs_from_it() {
        let full = tree();
        let pruned = full.prune(&[1]).expect("not the root");
        assert_eq!(pruned.links(), [Some(0), None, Some(1), None, Some(2)]);
        assert_eq!(pruned.kept_q(), [0, 1, 2, 3, 4, 5, 6, 9, 10, 11, 12, 14]);
        assert_eq!(pruned.kept_v(), [0, 1, 2, 3, 4, 5, 8, 9, 10, 12]);
        let small = pruned.figure();
        let names = pruned.kept_v().iter().map(|v| &full.layout().v_names()[*v]);
        assert!(names.eq(small.layout().v_names()));
        assert_eq!(small.link("right tip").and_then(crate::Link::parent), Some(1));
        // What led it is gone, and so is one of the angles.
        assert!(small.followers().is_empty() && full.followers().len() == 1);
        let [angle] = small.anatomical_angles() else { panic!("one angle") };
        assert_eq!((angle.name.as_str(), angle.dof), ("tip", 9));
    }

    #[test]
    fn nothing_pruned_is_the_same_figure() {
        assert_eq!(tree().prune(&[]).expect("valid").figure(), &tree());
    }

    #[test]
    fn the_root_and_links_that_are_not_there_are_refused() {
        assert_eq!(tree().prune(&[0]).err(), Some(PruneError::Root));
        assert_eq!(tree().prune(&[2, 9]).err(), Some(PruneError::NoSuchLink { link: 9, count: 5 }));
    }
}
