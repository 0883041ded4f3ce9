//! The state of the active contacts in a run.

use crate::contact::ContactPatch;

/// What stands on the ground.
#[derive(Clone, Default)]
pub(crate) struct ActiveContacts {
    pub(crate) holds: Vec<ContactPatch>,
    /// For each of them the link that it counts as on: of a rigid part, the one nearest to the root that touches.
    pub(crate) links: Vec<usize>,
    /// What is not held but could come down: touches, each with how far below the ground (m) it is seen.
    pub(crate) open: Vec<(usize, f64)>,
    /// Rigid parts, by their first links, that slide: held they would be pulled, and let go they would sink.
    pub(super) sliding: Vec<usize>,
    pub(super) begun: bool,
}

impl ActiveContacts {
    /// Nothing stands any more, until it is found anew that it does.
    pub(crate) fn forget(&mut self) {
        self.holds.clear();
        self.links.clear();
        self.begun = false;
    }
}
