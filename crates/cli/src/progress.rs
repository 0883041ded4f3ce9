//! Progress on a terminal; nothing anywhere else.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
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

    /// Of work that is a part of other work, which shows its own.
    pub(crate) fn hidden() -> Self {
        Self(ProgressBar::hidden())
    }

    /// Says what is done now.
    pub(crate) fn stage(&self, what: &'static str) {
        self.0.set_message(what);
        self.0.inc(1);
    }
}

impl Progress {
    /// A bar of its own for so many rows, in place of the stages.
    pub(crate) fn rows(&self, count: usize) -> Rows {
        let bar = ProgressBar::new(count as u64);
        // Many rows only: a bar that flashes tells nothing.
        if count < MANY_ROWS || self.0.is_hidden() {
            bar.set_draw_target(ProgressDrawTarget::hidden());
        } else {
            self.0.finish_and_clear();
        }
        Rows(bar)
    }
}

/// Rows from which on their progress is shown.
const MANY_ROWS: usize = 20_000;

/// A bar over the rows of a table.
pub(crate) struct Rows(ProgressBar);

impl Rows {
    /// A bar over so many rows that take their time.
    pub(crate) fn shown(count: usize) -> Self {
        let bar = ProgressBar::new(count as u64);
        if let Ok(style) = ProgressStyle::with_template("{spinner} [{bar:30}] {pos} of {len}, {eta} left") {
            bar.set_style(style);
        }
        Self(bar)
    }

    /// So many more are done.
    pub(crate) fn add(&self, done: usize) {
        self.0.inc(done as u64);
    }

    /// So many are done.
    pub(crate) fn at(&self, done: usize) {
        self.0.set_position(done as u64);
    }
}

impl Drop for Rows {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
