//! Slide, sink and clearance of the feet.

use super::tracks::Tracks;
use super::{Metric, MetricsInput, NoValue};
use crate::measure::Peak;
use crate::measure::window::mid_swing;
use nalgebra::Vector3;
use solaris_analysis::ground::Stance;

const SLIDE: (&str, &str, &str) = ("slide_greatest_mm", "foot slide, greatest", "mm");
const MEAN: (&str, &str, &str) = ("slide_mean_mm", "foot slide, mean of the stances", "mm");
const SPEED: (&str, &str, &str) = ("slide_speed_mm_s", "foot slide, mean speed", "mm/s");
const SINK: (&str, &str, &str) = ("sink_mm", "sink below the ground", "mm");
const CLEARANCE: (&str, &str, &str) = ("clearance_mm", "swing clearance", "mm");

pub(super) fn metrics(given: &MetricsInput<'_>, tracks: &Tracks<'_>) -> Vec<Metric> {
    let slides = slides(given, tracks);
    let of = |value: &dyn Fn(&[Slide]) -> f64| match &slides {
        Ok(slides) => Ok(value(slides)),
        Err(why) => Err(*why),
    };
    let greatest = |slides: &[Slide]| {
        slides.iter().map(|slide| slide.farthest).fold(Peak { value: 0.0, time: 0.0 }, Peak::max)
    };
    let mean = |slides: &[Slide]| slides.iter().map(|s| s.farthest.value).sum::<f64>() / slides.len() as f64;
    let speed = |slides: &[Slide]| {
        let sum = |of: fn(&Slide) -> f64| slides.iter().map(of).sum::<f64>();
        sum(|slide| slide.path) / sum(|slide| slide.time)
    };
    let at = slides.as_ref().ok().map(|slides| greatest(slides).time);
    let (sink, clearance) = (sink(given, tracks), clearance(given, tracks));
    vec![
        Metric::new(SLIDE, of(&|slides| 1e3 * greatest(slides).value), at),
        Metric::new(MEAN, of(&|slides| 1e3 * mean(slides)), None),
        Metric::new(SPEED, of(&|slides| 1e3 * speed(slides)), None),
        peak(SINK, sink),
        peak(CLEARANCE, clearance),
    ]
}

/// A peak (m) in mm.
fn peak(what: (&'static str, &'static str, &'static str), peak: Result<Peak, NoValue>) -> Metric {
    Metric::new(what, peak.map(|peak| 1e3 * peak.value), peak.ok().map(|peak| peak.time))
}

/// How a foot slid in one stance.
struct Slide {
    /// Farthest from where it came down (m).
    farthest: Peak,
    /// Length of its way (m), and how long it took (s).
    path: f64,
    time: f64,
}

/// How the feet slid. From one sample to the next a foot's lowest point is the one that touches the ground, and its way
/// over the ground is the slide; so a foot that rolls from heel to tip does not slide:
///
/// ```text
/// s(t) = Σ P·(p_k(tᵢ₊₁) − p_k(tᵢ) − v_belt (tᵢ₊₁ − tᵢ))      k lowest over tᵢ, tᵢ₊₁      P takes the vertical away
/// ```
///
/// A foot that is planted as in [`solaris_model::Motion::planted`] has the slide of its planted points.
fn slides(given: &MetricsInput<'_>, tracks: &Tracks<'_>) -> Result<Vec<Slide>, NoValue> {
    let stances = stances(given)?;
    let slides: Vec<Slide> = stances.iter().filter_map(|stance| slide(tracks, stance)).collect();
    if slides.is_empty() { Err(NoValue::NoStance) } else { Ok(slides) }
}

/// The stances, at least one.
fn stances<'a>(given: &MetricsInput<'a>) -> Result<&'a [Stance], NoValue> {
    if given.soles().is_empty() {
        return Err(NoValue::NoFeet);
    }
    let list = given.stances.map_or(&[][..], |stances| &stances.list);
    if list.is_empty() { Err(NoValue::NoStance) } else { Ok(list) }
}

/// `None` for a stance between two samples.
fn slide(tracks: &Tracks<'_>, stance: &Stance) -> Option<Slide> {
    let samples = tracks.samples((stance.start, stance.end));
    let mut from_start = Vector3::zeros();
    let mut slide = Slide { farthest: Peak { value: 0.0, time: stance.start }, path: 0.0, time: 0.0 };
    for i in samples.start..samples.end.saturating_sub(1) {
        let [here, next] = [tracks.points(stance.foot, i)?, tracks.points(stance.foot, i + 1)?];
        let height = |k: usize| (here[k] + next[k]).dot(&tracks.up);
        let lowest = (0..3).min_by(|a, b| height(*a).total_cmp(&height(*b)))?;
        let step = tracks.time[i + 1] - tracks.time[i];
        let moved = tracks.level(&(next[lowest] - here[lowest] - tracks.belt * step));
        from_start += moved;
        slide.path += moved.norm();
        slide.time += step;
        slide.farthest = slide.farthest.max(Peak { value: from_start.norm(), time: tracks.time[i + 1] });
    }
    (slide.time > 0.0).then_some(slide)
}

/// Greatest depth of a point of the soles below the ground (m); negative for feet that never come down to it.
fn sink(given: &MetricsInput<'_>, tracks: &Tracks<'_>) -> Result<Peak, NoValue> {
    if given.soles().is_empty() {
        return Err(NoValue::NoFeet);
    }
    let mut sink = Peak::NONE;
    for foot in 0..given.soles().len() {
        for (sample, &time) in tracks.time.iter().enumerate() {
            let Some(points) = tracks.points(foot, sample) else { continue };
            let value = points.iter().map(|point| -tracks.height(point)).fold(f64::NEG_INFINITY, f64::max);
            sink = sink.max(Peak { value, time });
        }
    }
    Ok(sink)
}

/// Least height of a foot's tip in the middle of its swings (m).
fn clearance(given: &MetricsInput<'_>, tracks: &Tracks<'_>) -> Result<Peak, NoValue> {
    let stances = stances(given)?;
    let mut least: Option<Peak> = None;
    for pair in stances.windows(2).filter(|pair| pair[0].foot == pair[1].foot) {
        for i in mid_swing(tracks.time, (pair[0].end, pair[1].start)) {
            let Some(points) = tracks.points(pair[0].foot, i) else { continue };
            let here = Peak { value: tracks.height(&points[2]), time: tracks.time[i] };
            least = Some(least.map_or(here, |least| least.min(here)));
        }
    }
    least.ok_or(NoValue::NoSwing)
}
