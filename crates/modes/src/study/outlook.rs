//! Looking on for somebody who wants to see the whole study as one.

use crate::report::Observer;

/// Passes on to a observer, with the progress of a part as a span of the whole.
pub(super) struct Outlook<'a> {
    observer: &'a mut dyn Observer,
    from: f64,
    to: f64,
    progress: f64,
}

impl<'a> Outlook<'a> {
    pub(super) fn new(observer: &'a mut dyn Observer, from: f64, to: f64) -> Self {
        observer.progress(from);
        Self { observer, from, to, progress: from }
    }
}

impl Observer for Outlook<'_> {
    fn now(&self) -> Option<f64> {
        self.observer.now()
    }

    /// Never backwards: of several runs in a part the first one shows.
    fn progress(&mut self, share: f64) {
        let progress = self.from + (self.to - self.from) * share.clamp(0.0, 1.0);
        if progress > self.progress {
            self.progress = progress;
            self.observer.progress(progress);
        }
    }

    fn is_cancelled(&self) -> bool {
        self.observer.is_cancelled()
    }
}
