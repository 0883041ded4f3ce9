//! Looks on while a study goes on: a clock, and a bar on a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use solaris::modes::Observer;
use std::time::{Duration, Instant};

/// Steps of the bar.
const STEPS: u64 = 1000;

/// A clock and a bar. Hidden where standard error is no terminal.
pub(super) struct Watching {
    bar: ProgressBar,
    begun: Instant,
}

impl Watching {
    pub(super) fn new() -> Self {
        let bar = ProgressBar::new(STEPS);
        if let Ok(style) = ProgressStyle::with_template("{spinner} [{bar:30}] {percent} % {msg} {elapsed}") {
            bar.set_style(style);
        }
        bar.set_message("finding the answer");
        bar.enable_steady_tick(Duration::from_millis(100));
        Self { bar, begun: Instant::now() }
    }
}

impl Observer for Watching {
    fn now(&self) -> Option<f64> {
        Some(self.begun.elapsed().as_secs_f64())
    }

    fn progress(&mut self, share: f64) {
        self.bar.set_position((share * STEPS as f64) as u64);
        // The reference is a fifth.
        self.bar.set_message(if share < 0.2 { "finding the answer" } else { "comparing methods" });
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
