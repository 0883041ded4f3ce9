//! Many walks: one walk as a row of numbers, planned, sampled, loaded, measured and dropped.
//!
//! A row depends on nothing but what is asked: not on other rows, not on threads. [`COLUMNS`] says what a row holds.

mod columns;

pub use columns::{COLUMNS, Column};

use crate::error::{GaitError, MeasureError};
use crate::measure::{Peak, WalkMeasures, free_moment, measure};
use crate::styled::{StyledPlan, StyledRequest};
use solaris_model::Figure;

/// The most samples of one walk of a sweep: some 0.6 GB, about 1500 steps at 120 samples a second.
pub const MOST_SAMPLES: f64 = 1.5e5;

/// A walk of which all is known that a row tells.
#[derive(Clone, Debug)]
pub struct Walked {
    /// Steps a minute and step length (m) of the steady part, as planned.
    pub pace: (f64, f64),
    /// What it came to.
    pub measures: WalkMeasures,
    /// Greatest free moment of one foot, about the vertical through its centre of pressure (N m), either way round.
    pub free_moment: Peak,
}

impl Walked {
    /// Plans a walk of `figure`, samples it `rate` times a second, finds its forces and measures it.
    ///
    /// # Errors
    ///
    /// What cannot be walked ([`StyledPlan::of`]), a rate that is none, more than [`MOST_SAMPLES`].
    pub fn of(figure: &Figure, request: &StyledRequest, rate: f64) -> Result<Self, GaitError> {
        let plan = StyledPlan::of(figure, request)?;
        let samples = plan.duration() * rate;
        if samples > MOST_SAMPLES {
            return Err(MeasureError::TooManySamples {
                duration: plan.duration(),
                rate,
                samples,
                most: MOST_SAMPLES,
            }
            .into());
        }
        let (motion, _) = plan.loaded(figure, rate)?;
        let measures = measure(figure, &motion)?;
        Ok(Self {
            pace: (plan.step_frequency(), plan.step_length()),
            measures,
            free_moment: free_moment(&motion),
        })
    }
}

/// The numbers of one walk, in the order of [`COLUMNS`]; `None` where a walk has no such number (one that is too short
/// for a steady stride).
///
/// # Errors
///
/// As for [`Walked::of`]: why there is no such walk.
///
/// # Examples
///
/// ```
/// use solaris_gait::{Extent, StyledRequest, WalkRequest, sweep};
///
/// let ann = solaris_model::human(1.65, 58.0)?;
/// let request = WalkRequest { extent: Extent::Steps(3), ..WalkRequest::default() };
/// let row = sweep::metrics_of(&ann, &StyledRequest::Smooth(request.clone()), 60.0)?;
/// assert_eq!((row.len(), sweep::COLUMNS[0].heading, row[0]), (sweep::COLUMNS.len(), "walked_steps", Some(3.0)));
/// let too_fast = WalkRequest { speed: Some(2.9), ..request };
/// assert!(sweep::metrics_of(&ann, &StyledRequest::Smooth(too_fast), 60.0).is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn metrics_of(
    figure: &Figure,
    request: &StyledRequest,
    rate: f64,
) -> Result<Vec<Option<f64>>, GaitError> {
    let walked = Walked::of(figure, request, rate)?;
    Ok(COLUMNS.iter().map(|column| column.value(&walked)).collect())
}
