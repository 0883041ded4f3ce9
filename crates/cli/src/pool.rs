//! Threads for work of many parts.

use crate::error::CliError;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Stack of a thread (bytes): a thread that waits for the frames of one part may begin another part.
const STACK: usize = 16 << 20;

/// So many threads; 0: one a core.
pub(crate) fn pool(threads: usize) -> Result<ThreadPool, CliError> {
    ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK).build().map_err(CliError::other)
}
