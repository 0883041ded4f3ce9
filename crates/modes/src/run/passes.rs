//! The passes of a run, told to who looks on.

use super::describe;
use crate::report::{Observer, RunPass};
use crate::settings::Settings;
use crate::time::Stepping;

/// Numbers the passes of a run.
pub(super) struct Passes<'a> {
    observer: &'a mut dyn Observer,
    number: usize,
    duration: f64,
    rate: f64,
}

/// Looks on at one pass.
pub(super) struct OnePass<'a> {
    observer: &'a mut dyn Observer,
    number: usize,
    method: String,
    duration: f64,
    /// Whether its share is that of the whole run.
    is_main: bool,
}

impl<'a> Passes<'a> {
    pub(super) fn new(observer: &'a mut dyn Observer, settings: &Settings) -> Self {
        Self { observer, number: 0, duration: settings.duration, rate: settings.rate }
    }

    /// Looks on at the next pass.
    pub(super) fn next(&mut self, stepping: Stepping) -> OnePass<'_> {
        self.number += 1;
        let method = describe(stepping, self.rate);
        OnePass {
            observer: &mut *self.observer,
            number: self.number,
            method,
            duration: self.duration,
            is_main: false,
        }
    }

    /// The same where it is most of the run.
    pub(super) fn main(&mut self, stepping: Stepping) -> OnePass<'_> {
        OnePass { is_main: true, ..self.next(stepping) }
    }
}

impl Observer for OnePass<'_> {
    fn now(&self) -> Option<f64> {
        self.observer.now()
    }

    fn progress(&mut self, share: f64) {
        if self.is_main {
            self.observer.progress(share);
        }
        let (number, method, duration) = (self.number, &*self.method, self.duration);
        self.observer.pass(&RunPass { number, method, time: share * duration, duration });
    }

    fn is_cancelled(&self) -> bool {
        self.observer.is_cancelled()
    }
}
