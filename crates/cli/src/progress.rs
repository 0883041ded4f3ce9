//! Progress on a terminal; nothing anywhere else.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// A bar that moves by stages.
pub(crate) struct Progress(ProgressBar);

impl Progress {
    /// Over so many stages. Hidden where standard error is no terminal.
    pub(crate) fn new(stages: u64) -> Self {
        let bar = ProgressBar::new(stages);
        if let Ok(style) = ProgressStyle::with_template("{spinner} [{bar:30}] {msg} {elapsed}") {
            bar.set_style(style);
        }
        bar.enable_steady_tick(Duration::from_millis(100));
        Self(bar)
    }

    /// Says what is done now.
    pub(crate) fn stage(&self, what: &'static str) {
        self.0.set_message(what);
        self.0.inc(1);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
