//! The resolution of a plan: nodes and passes.

use crate::error::RequestError;

/// How finely a plan is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Resolution {
    /// Nodes a stride; even.
    pub nodes: usize,
    /// Passes in which body and forces come to agree: the error falls to a third or less in each.
    pub stride_passes: usize,
    /// The same, for a whole walk; at least 8.
    pub walk_passes: usize,
}

impl Default for Resolution {
    /// 100 nodes and 5 passes are within 0.03 mm, 0.01° and 10 N of the limit.
    fn default() -> Self {
        Self { nodes: 100, stride_passes: 5, walk_passes: 14 }
    }
}

impl Resolution {
    pub(crate) fn check(self) -> Result<(), RequestError> {
        if !(20..=10_000).contains(&self.nodes) || !self.nodes.is_multiple_of(2) {
            return Err(RequestError::Nodes { nodes: self.nodes });
        }
        if self.walk_passes < 8 {
            return Err(RequestError::Passes { passes: self.walk_passes });
        }
        Ok(())
    }
}
