//! Within which values of one number the planner accepts what is asked.

use super::field::Field;
use super::judge::Judge;
use super::options::GaitOptions;
use crate::error::GaitError;
use solaris_model::Figure;

/// To which part of the declared range ends are found.
const FINENESS: f64 = 500.0;
/// The same of what is known without a plan, and values that are looked at for any.
const FINER: f64 = 1e6;
const LOOKS: usize = 128;
/// Values that are tried on the way to an end.
const ON_THE_WAY: usize = 3;
/// Values that are tried for one that is accepted, where the present one is not.
const TRIES: usize = 16;

impl GaitOptions {
    /// Within which values of one of its numbers the planner accepts the request with everything else as it stands (in the unit of the option):
    /// where the present value, or the usual one of a number that is left out, is accepted, the interval about it; else the nearest one; none where
    /// nothing is accepted.
    ///
    /// `field` is `step_frequency`, `step_length`, `speed`, `turn`, `slope`, `variability`, `cane_load`, `stairs.rise`, `stairs.tread`, or a number of the style
    /// by its name (`arm_swing`, `arm-swing` or `style.arm_swing`).
    ///
    /// It is the planner's own judgement, no table: both ends were planned whole and hold, and what is a 500th of the number's declared
    /// range beyond an end was planned and does not, or is out of that range. In between three values on either side of the present one were
    /// planned, and all others are taken to hold. It takes 7 plans where all holds, and up to some thirty; on slopes up to seven more, of a
    /// few steps, for each that does not. As in [`Self::make`], a manner or a variability that holds in part is accepted, but where `field`
    /// is the variability.
    ///
    /// ```
    /// use solaris_gait::GaitOptions;
    ///
    /// let ann = solaris_model::human(1.65, 58.0)?;
    /// let options = GaitOptions { step_frequency: Some(100.0), ..GaitOptions::default() };
    /// let [shortest, longest] = options.range_of(&ann, "step_length")?.expect("some steps hold");
    /// assert!(shortest < 0.61 && longest > 0.61);
    /// assert!(GaitOptions { step_length: Some(longest), ..options }.make(&ann).is_ok());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// A name that is none of a number; what contradicts itself, is not known, or belongs to another gait or style, whatever the number is;
    /// figures that cannot walk.
    pub fn range_of(&self, figure: &Figure, field: &str) -> Result<Option<[f64; 2]>, GaitError> {
        let mut judge = Judge::new(figure)?;
        let field = Field::named(field, &judge, self)?;
        judge.whole = field == Field::Variability;
        let declared = field.declared(&judge, self);
        let present = field.given(self).or_else(|| field.usual(&judge, self));
        let present = present.filter(|value| value.is_finite()).unwrap_or(0.5 * (declared[0] + declared[1]));
        let width = declared[1] - declared[0];
        let in_range = |value: f64| judge.is_in_range(&field.set(self, value));
        let Some(known) = interval(in_range, declared, present, (LOOKS, 1), width / FINER)? else {
            return Ok(None);
        };
        let within = |value: f64, short: bool| judge.accepts(&field.set(self, value), short);
        let fineness = width / FINENESS;
        let judged = |short: bool| {
            interval(|value| within(value, short), known, present, (TRIES, ON_THE_WAY), fineness)
        };
        // Some steps decide of many, unless the whole walk says otherwise.
        let found = judged(true)?;
        match found {
            Some([lower, upper])
                if judge.shortens(self) && !(within(lower, false)? && within(upper, false)?) =>
            {
                judged(false)
            }
            found => Ok(found),
        }
    }
}

/// The interval in `[lower, upper]` about a value, or nearest to it, in which values are accepted, to so `fine`: `tries` look for one that is, and so many
/// on the way to each end.
fn interval(
    accepts: impl Fn(f64) -> Result<bool, GaitError>,
    [lower, upper]: [f64; 2],
    about: f64,
    (tries, on_the_way): (usize, usize),
    fine: f64,
) -> Result<Option<[f64; 2]>, GaitError> {
    let about = about.clamp(lower, upper);
    let mut inside = accepts(about)?.then_some((about, [lower, upper]));
    let spacing = (upper - lower) / tries as f64;
    // Values farther and farther away, on both sides; what was refused last bounds what is found.
    let mut refused = [about; 2];
    for k in 1..=tries {
        if inside.is_some() {
            break;
        }
        for (side, value) in [about - spacing * k as f64, about + spacing * k as f64].into_iter().enumerate()
        {
            let value = value.clamp(lower, upper);
            if inside.is_some() || value.to_bits() == refused[side].to_bits() {
                continue;
            }
            if accepts(value)? {
                let bounds = if side == 0 { [lower, refused[0]] } else { [refused[1], upper] };
                inside = Some((value, bounds));
            } else {
                refused[side] = value;
            }
        }
    }
    let Some((inside, bounds)) = inside else { return Ok(None) };
    let mut ends = [inside; 2];
    for (end, bound) in ends.iter_mut().zip(bounds) {
        let mut outside = None;
        for k in 1..=on_the_way {
            let value = inside + (bound - inside) * k as f64 / on_the_way as f64;
            if value.to_bits() == end.to_bits() || accepts(value)? {
                *end = value;
            } else {
                outside = Some(value);
                break;
            }
        }
        let Some(mut outside) = outside else { continue };
        while (outside - *end).abs() > fine {
            let middle = 0.5 * (outside + *end);
            if accepts(middle)? {
                *end = middle;
            } else {
                outside = middle;
            }
        }
    }
    Ok(Some(ends))
}
