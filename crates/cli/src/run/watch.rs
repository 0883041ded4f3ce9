//! Looks on while a scene runs: a clock, and a bar on a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use solaris::modes::{Observer, RunPass};
use std::time::{Duration, Instant};

/// Parts of the bar.
const PARTS: u64 = 1000;

/// A clock, and a bar where standard error is a terminal.
pub(super) struct Watcher {
    begun: Instant,
    bar: ProgressBar,
}

impl Watcher {
    pub(super) fn new() -> Self {
        let bar = ProgressBar::new(PARTS);
        if let Ok(style) = ProgressStyle::with_template("{spinner} [{bar:30}] {msg} {elapsed}") {
            bar.set_style(style);
        }
        bar.set_message("running");
        bar.enable_steady_tick(Duration::from_millis(100));
        Self { begun: Instant::now(), bar }
    }

    /// Says that the run is over.
    pub(super) fn writing(&self) {
        self.bar.set_message("writing");
        self.bar.set_position(PARTS);
    }
}

impl Observer for Watcher {
    fn now(&self) -> Option<f64> {
        Some(self.begun.elapsed().as_secs_f64())
    }

    fn progress(&mut self, share: f64) {
        self.bar.set_position((share * PARTS as f64) as u64);
    }

    /// The bar of each pass begins anew: how many there will be is not known.
    fn pass(&mut self, pass: &RunPass<'_>) {
        let RunPass { number, time, duration, .. } = *pass;
        if number > 1 {
            self.bar.set_message(format!("running, pass {number}"));
        }
        self.bar.set_position((time / duration * PARTS as f64) as u64);
    }
}

impl Drop for Watcher {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
