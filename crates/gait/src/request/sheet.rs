//! A style sheet: what a manner changes of a walk's style.

/// The number that is a part of the population's step length at the same step frequency.
pub(crate) const STEP_LENGTH: &str = "step_length";
/// The number that is a part of the step frequency where none is asked for.
pub(crate) const CADENCE: &str = "cadence";

/// How a number changes: to `factor` times its value and `add` more, in the number's unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// What it is multiplied by.
    pub factor: f64,
    /// What is added then (°, m or none).
    pub add: f64,
}

impl Change {
    /// No change.
    pub const NONE: Self = Self { factor: 1.0, add: 0.0 };

    /// A part of it: 0 is none, 1 all.
    #[must_use]
    pub fn scaled(self, part: f64) -> Self {
        Self { factor: 1.0 + part * (self.factor - 1.0), add: part * self.add }
    }

    /// Both: what their factors differ from 1 by is added, so that their order is nothing.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self { factor: self.factor + other.factor - 1.0, add: self.add + other.add }
    }
}

/// Changes of a style's numbers by name (see [`crate::SHEET_NUMBERS`]): a manner of walking, for any body and any pace.
///
/// ```
/// use solaris_gait::{StyleSheet, WalkRequest, manner, walk};
///
/// let (sad, heavy) = (manner("sad")?, manner("heavy")?);
/// let sheet = sad.scaled(0.6).plus(&heavy.scaled(0.3));
/// let bo = solaris_model::human(1.75, 73.0)?;
/// let [plain, blue] = [StyleSheet::default(), sheet].map(|sheet| {
///     walk(&bo, &WalkRequest { sheet, ..WalkRequest::default() }).map(|plan| *plan.style())
/// });
/// assert!(blue?.arm_swing < plain?.arm_swing);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[doc(alias = "mood")]
#[doc(alias = "manner")]
pub struct StyleSheet {
    changes: Vec<(&'static str, Change)>,
}

impl StyleSheet {
    /// Whether it changes nothing.
    pub fn is_empty(&self) -> bool {
        self.changes.iter().all(|(_, change)| *change == Change::NONE)
    }

    /// How a number changes.
    pub fn get(&self, name: &str) -> Change {
        self.changes.iter().find(|(known, _)| *known == name).map_or(Change::NONE, |(_, change)| *change)
    }

    /// Changes a number, besides what it is changed by already.
    #[must_use]
    pub fn with(mut self, name: &'static str, change: Change) -> Self {
        match self.changes.iter_mut().find(|(known, _)| *known == name) {
            Some((_, known)) => *known = known.plus(change),
            None => self.changes.push((name, change)),
        }
        self
    }

    /// A part of all changes: 0 is none, 1 is as it is, more exaggerates.
    #[must_use]
    pub fn scaled(&self, part: f64) -> Self {
        Self { changes: self.changes.iter().map(|(name, change)| (*name, change.scaled(part))).collect() }
    }

    /// This and another, summed.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        other.changes.iter().fold(self.clone(), |sum, (name, change)| sum.with(name, *change))
    }

    /// This without some numbers.
    pub(crate) fn without(&self, names: &[&str]) -> Self {
        let changes = self.changes.iter().filter(|(name, _)| !names.contains(name));
        Self { changes: changes.copied().collect() }
    }

    /// All changes.
    pub fn changes(&self) -> &[(&'static str, Change)] {
        &self.changes
    }
}
