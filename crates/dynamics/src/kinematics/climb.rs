//! The path from a link to the root, degree of freedom by degree of freedom.

use crate::scalar::Scalar;
use crate::tree::Tree;

/// What comes next on the way.
pub(crate) enum Step {
    /// A degree of freedom of the link.
    Dof(usize),
    /// On from this link to its parent.
    Parent(usize),
}

/// Visits the degrees of freedom of `link` before `end`, and all of every link before it; in each link the first comes
/// first.
pub(crate) fn climb<T: Scalar>(tree: &Tree<T>, link: usize, end: usize, mut visit: impl FnMut(Step)) {
    let (mut link, mut end) = (link, end);
    loop {
        let body = &tree.bodies[link];
        (body.first..end).for_each(|k| visit(Step::Dof(k)));
        let Some(parent) = body.parent else { return };
        visit(Step::Parent(link));
        link = parent;
        end = tree.bodies[link].end;
    }
}
