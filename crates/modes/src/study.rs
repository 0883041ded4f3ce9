//! How far a run can be trusted: one simulation by many methods, steps and tolerances, against an answer that is known
//! better.

mod agreement;
mod compare;
mod ladder;
mod momentum;
mod outlook;
mod reference;
mod rows;
mod savings;
mod sensitivity;

pub use agreement::Agreement;
pub use compare::Accuracy;
pub use ladder::{ladder, method_name, setting};
pub use momentum::MomentumDrift;
pub use reference::Reference;
pub use rows::Row;
pub use savings::Savings;
pub use sensitivity::Sensitivity;

use crate::failure::RunError;
use crate::report::Observer;
use crate::settings::{Method, Settings};
use crate::simulation::Simulation;
use compare::Answer;
use outlook::Outlook;
use solaris_model::Motion;

/// A closed form: writes position and velocity at a time (s).
pub type Solution<'a> = &'a dyn Fn(f64, &mut [f64], &mut [f64]);

/// What a study tries.
#[derive(Clone)]
pub struct StudyOptions<'a> {
    /// The methods with their steps and tolerances, those of one method together and the coarsest first.
    pub methods: Vec<Method>,
    /// The error of positions (rad or m) that is wanted.
    pub wanted: f64,
    /// How often each is run where there is a clock; the best time counts. Runs above a second are not repeated.
    pub repeats: usize,
    /// The most evaluations of a run, those of the reference included.
    pub evaluations: u64,
    /// What is known of the answer beforehand.
    pub solution: Option<Solution<'a>>,
}

impl Default for StudyOptions<'_> {
    /// Every method from coarse to fine, for an error of 1e-6.
    fn default() -> Self {
        Self { methods: ladder(), wanted: 1e-6, repeats: 3, evaluations: 5_000_000, solution: None }
    }
}

/// What came of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// What the others were compared with.
    pub reference: Reference,
    /// Every setting that was tried, in the order of the methods.
    pub rows: Vec<Row>,
    /// The error of positions (rad or m) that is wanted.
    pub wanted: f64,
    /// Whether the motion can be compared to its end, and what a small change at the beginning comes to.
    pub sensitivity: Sensitivity,
    /// What leaving out saved; nothing where somebody stopped the study before.
    pub savings: Option<Savings>,
    /// Whether all was tried.
    pub is_complete: bool,
}

/// A setting that meets a wanted error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice<'a> {
    /// The error that is wanted.
    pub wanted: f64,
    /// The cheapest row that meets it; none where no row does.
    pub row: Option<&'a Row>,
}

impl Study {
    /// The cheapest setting whose error is at most `wanted` (rad or m): by its time where there is a clock, else by its
    /// evaluations. An error below the uncertainty of the reference counts as that uncertainty.
    ///
    /// [`Method::Automatic`] and [`Method::Usual`] are not asked: they try several settings themselves.
    pub fn cheapest(&self, wanted: f64) -> Option<&Row> {
        let meets = |row: &&Row| {
            let error = row.result.as_ref().ok().map(|accuracy| accuracy.position);
            let is_met = error.is_some_and(|error| error.max(self.reference.uncertainty.position) <= wanted);
            is_met && !matches!(row.method, Method::Usual | Method::Automatic { .. })
        };
        let rows = || self.rows.iter().filter(meets);
        if rows().all(|row| row.seconds.is_some()) {
            return rows().min_by(|a, b| a.seconds.unwrap_or(0.0).total_cmp(&b.seconds.unwrap_or(0.0)));
        }
        rows().min_by_key(|row| row.counts.evaluations)
    }

    /// The cheapest setting for each error from 1e-1 down to 1e-12, as far as one is met.
    pub fn choices(&self) -> Vec<Choice<'_>> {
        let all = (1..=12).map(|digits| 10_f64.powi(-digits));
        all.map(|wanted| Choice { wanted, row: self.cheapest(wanted) })
            .take_while(|choice| choice.row.is_some())
            .collect()
    }
}

/// Runs `simulation` by every method of `options` and says which to take; `on_row` gets what there is as soon as a row
/// more is there.
///
/// Duration, rate and guard are those of `settings`; joint forces are left out. Where the answer is not known beforehand
/// it is found by the finest runs there are, and the difference between two of them is its uncertainty. Trouble of a row
/// is its result, not that of the study. Where `observer` stops, the study ends with what it has.
///
/// # Errors
///
/// [`RunError`] where nothing could be found to compare with.
pub fn study(
    simulation: &Simulation,
    settings: &Settings,
    options: &StudyOptions<'_>,
    observer: &mut dyn Observer,
    on_row: &mut dyn FnMut(&Study),
) -> Result<Study, RunError> {
    let mut settings = Settings { forces: false, estimate: false, ..settings.clone() };
    settings.guard.evaluations = settings.guard.evaluations.min(options.evaluations);
    // The reference and the sensitivity count as a fifth, the savings as a twentieth.
    let mut outlook = Outlook::new(observer, 0.0, 0.2);
    let found = reference::find(simulation, &settings, options, &mut outlook)?;
    let sensitivity = sensitivity::of(simulation, &settings, &found, &mut outlook)?;
    let frames = agreement::Frames::of(simulation, &found, &sensitivity);
    let answer = options.solution.map(Answer::Solution).or(found.motion.as_ref().map(Answer::Motion));
    let compare = |motion: &Motion| match &answer {
        Some(answer) => compare::compare(simulation.figure(), motion, answer, sensitivity.comparable_until),
        None => (f64::INFINITY, f64::INFINITY),
    };

    let (wanted, reference) = (options.wanted, found.reference.clone());
    let mut study =
        Study { reference, rows: Vec::new(), wanted, sensitivity, savings: None, is_complete: false };
    let methods = ladder::fitted(&options.methods, settings.rate);
    let share = |index: usize| 0.2 + 0.75 * index as f64 / methods.len().max(1) as f64;
    for (index, method) in methods.iter().enumerate() {
        let mut outlook = Outlook::new(observer, share(index), share(index + 1));
        let row = rows::measure(simulation, &settings, *method, options.repeats, &mut outlook, compare);
        let Some(mut row) = row else { return Ok(study) };
        // What this program was built without is no row.
        if !row.is_built_in {
            continue;
        }
        row.agreement = frames.as_ref().and_then(|frames| frames.agreement(&settings, *method, &mut outlook));
        study.rows.push(row);
        on_row(&study);
    }
    let method = study.cheapest(options.wanted).map(|row| row.method);
    let mut outlook = Outlook::new(observer, 0.95, 1.0);
    study.savings = savings::measure(simulation, &settings, method, options.repeats, &mut outlook);
    study.is_complete = true;
    Ok(study)
}
