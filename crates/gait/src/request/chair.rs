//! The request for standing up from a seat and sitting down.

use crate::error::RequestError;

/// Heights of a seat, as parts of the standing height.
const SEAT: (f64, f64) = (0.19, 0.36);
/// The usual one: 0.45 m at a height of 1.75 m.
const USUAL_SEAT: f64 = 0.45 / 1.75;
/// How long it takes (s), and usually, at a height of 1.75 m; others' goes with its root.
const DURATION: (f64, f64) = (1.4, 4.0);
const USUAL_DURATION: f64 = 1.9;
/// How far the shanks lean forward in sitting (rad), and usually.
const SHANK: (f64, f64) = (8.0 * DEGREE, 25.0 * DEGREE);
const USUAL_SHANK: f64 = 15.0 * DEGREE;
/// How often somebody may stand up and sit down again.
pub const CHAIR_TIMES: (usize, usize) = (1, 100);

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// What is asked of somebody and a seat.
///
/// ```
/// use solaris_gait::{ChairRequest, chair};
/// use solaris_model::Trajectory;
///
/// let ann = solaris_model::human(1.65, 58.0)?;
/// let plan = chair(&ann, &ChairRequest::default())?;
/// let mut q = vec![0.0; ann.layout().nq()];
/// let mut height = |time: f64| {
///     plan.configuration(time, &mut q);
///     q[1] // root.ty
/// };
/// assert!(height(plan.duration()) - height(0.0) > 0.3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "sit-to-stand")]
#[doc(alias = "stand-to-sit")]
pub struct ChairRequest {
    /// What is done.
    pub motion: ChairMotion,
    /// Height of the seat (m), 0.19 to 0.36 of the standing height; 0.257 of it where it is left out.
    pub seat: Option<f64>,
    /// How long it takes to stand up or to sit down (s), 1.4 to 4 at a height of 1.75 m; 1.9 where it is left out. Others' goes with the height's root. Besides, 0.4 s
    /// go by at rest before, between and after (at 1.75 m).
    pub duration: Option<f64>,
    /// How far the shanks lean forward in sitting (rad), 8 to 25°: the more, the farther back the feet are.
    pub shank: f64,
}

impl Default for ChairRequest {
    fn default() -> Self {
        Self { motion: ChairMotion::Rise, seat: None, duration: None, shank: USUAL_SHANK }
    }
}

/// What is done with a seat.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ChairMotion {
    /// Stands up.
    #[default]
    #[doc(alias = "sit-to-stand")]
    Rise,
    /// Sits down.
    #[doc(alias = "stand-to-sit")]
    Sit,
    /// Stands up and sits down again, so many times.
    #[doc(alias = "five times sit to stand")]
    RiseAndSit(usize),
}

impl ChairRequest {
    /// The seat's height (m) for somebody so tall (m).
    ///
    /// # Errors
    ///
    /// One that is out of range.
    pub(crate) fn seat_of(&self, stature: f64) -> Result<f64, RequestError> {
        let (lower, upper) = (SEAT.0 * stature, SEAT.1 * stature);
        in_range("seat height", self.seat.unwrap_or(USUAL_SEAT * stature), " m", [lower, upper])
    }

    /// How long a rise usually takes somebody so tall (m), in s.
    pub(crate) fn usual_duration(stature: f64) -> f64 {
        USUAL_DURATION * (stature / 1.75).sqrt()
    }

    /// Whether one way may take so long (s), for somebody so tall (m).
    pub(crate) fn takes(&self, duration: f64, stature: f64) -> bool {
        Self { duration: Some(duration), ..*self }.duration_of(stature).is_ok()
    }

    /// How long it takes (s), for somebody so tall (m).
    ///
    /// # Errors
    ///
    /// A time that is out of range.
    pub(crate) fn duration_of(&self, stature: f64) -> Result<f64, RequestError> {
        let time = (stature / 1.75).sqrt();
        let (lower, upper) = (DURATION.0 * time, DURATION.1 * time);
        in_range(
            "duration",
            self.duration.unwrap_or_else(|| Self::usual_duration(stature)),
            " s",
            [lower, upper],
        )
    }

    /// Refuses what is out of range whoever it is.
    pub(crate) fn check(&self) -> Result<(), RequestError> {
        let degrees = [SHANK.0, SHANK.1].map(f64::to_degrees);
        in_range("shank", self.shank.to_degrees(), "°", degrees)?;
        if let ChairMotion::RiseAndSit(times) = self.motion {
            let [fewest, most] = [CHAIR_TIMES.0, CHAIR_TIMES.1].map(|times| times as f64);
            in_range("times", times as f64, "", [fewest, most])?;
        }
        Ok(())
    }
}

fn in_range(
    parameter: &'static str,
    value: f64,
    unit: &'static str,
    [lower, upper]: [f64; 2],
) -> Result<f64, RequestError> {
    // The ends as they are told count as within.
    let [least, most] = [(lower * 1e3).floor() / 1e3, (upper * 1e3).ceil() / 1e3];
    if (least..=most).contains(&value) {
        return Ok(value);
    }
    Err(RequestError::Range { parameter, value, unit, lower: least, upper: most, why: String::new() })
}
