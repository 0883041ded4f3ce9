//! A recording from the text of a TRC file.

use super::header::{Header, lines};
use super::rows::{Rows, rows};
use crate::markers::{Extent, LengthUnit, Recording, counted, plausible, unique};
use solaris_model::{Finding, FindingKind, MarkerTrial, TextError, Vector3};

/// What is not left to the file.
#[derive(Clone, Copy, Debug, Default)]
pub struct ReadOptions {
    /// The unit of lengths, whatever the file says and however large its subject then is.
    pub unit: Option<LengthUnit>,
}

/// What there is to say.
struct Said(Vec<Finding>);

impl Said {
    fn say(&mut self, kind: FindingKind, subject: &str, message: String) {
        self.0.push(Finding { kind, subject: subject.to_owned(), message, place: None });
    }
}

/// Reads a TRC file.
///
/// # Errors
///
/// [`TextError`], with the place, where there is no line of names, a cell is no number, times do not grow, or neither times nor
/// a rate are there.
///
/// # Examples
///
/// ```
/// use solaris_io::trc::{ReadOptions, read};
/// let text = "DataRate\tUnits\n50\tmm\nFrame#\tTime\theel\t\t\n\t\tX1\tY1\tZ1\n1\t0\t900\t10\t5\n2\t0.02\t\t\t\n";
/// let recording = read(text, &ReadOptions::default())?;
/// assert_eq!(recording.markers.point(0, 0).map(|p| p.x), Some(0.9));
/// assert_eq!(recording.markers.point(1, 0), None);
/// # Ok::<(), solaris_model::TextError>(())
/// ```
pub fn read(text: &str, options: &ReadOptions) -> Result<Recording, TextError> {
    let lines = lines(text);
    let header = Header::read(text, &lines)?;
    let mut rows = rows(text, &lines, &header)?;
    let mut said = Said(Vec::new());
    differences(&header, &rows, &mut said);
    let names = names(&header, rows.markers, &mut said);
    let (unit, message) = unit(&header, options.unit, &rows);
    if let Some((kind, message)) = message {
        said.say(kind, "unit", message);
    }
    let metre = unit.metres();
    origins(&mut rows, &names, metre, &mut said);
    let time = times(text, &header, &rows, &mut said)?;
    let trial = MarkerTrial::new(names, time, rows.points)
        .map_err(|error| TextError::one(text, header.line.clone(), error.to_string()))?
        .mapped(|point| point * metre);
    // The times count, which are rounded where they agree with the rate.
    let told = header.number("DataRate").filter(|rate| *rate > 0.0);
    let own = trial.rate();
    let rate = told.filter(|told| own.is_none_or(|own| !differ(own, *told))).or(own);
    Ok(Recording {
        rate,
        markers: trial,
        unit,
        first_frame: rows.first.unwrap_or(1),
        residuals: Vec::new(),
        events: Vec::new(),
        analog: Vec::new(),
        plates: Vec::new(),
        findings: said.0,
    })
}

/// Says where the header and the table differ.
fn differences(header: &Header<'_>, rows: &Rows, said: &mut Said) {
    for (key, what, found) in
        [("NumMarkers", "markers", rows.markers), ("NumFrames", "frames", rows.time.len())]
    {
        if let Some(told) = header.number(key).filter(|told| (told - found as f64).abs() > 0.5) {
            said.say(
                FindingKind::Suspect,
                key,
                format!("the header says {told} {what}, there are {found}; those are read"),
            );
        }
    }
    if header.is_shifted {
        let message = "names do not stand above their columns; they are given to the columns in their order";
        said.say(FindingKind::Suspect, "markers", message.to_owned());
    }
    if header.coordinates > 0 && header.coordinates != 3 * rows.markers {
        let message = format!(
            "{} columns have names, and {} markers have {}",
            header.coordinates,
            rows.markers,
            3 * rows.markers
        );
        said.say(FindingKind::Note, "columns", message);
    }
    if rows.short > 0 {
        let message =
            format!("missing at the end of {}; their markers are hidden", counted(rows.short, "line"));
        said.say(FindingKind::Note, "cells", message);
    }
    if rows.halves > 0 {
        let message =
            format!("{} with one or two coordinates only, taken as hidden", counted(rows.halves, "place"));
        said.say(FindingKind::Suspect, "cells", message);
    }
    if rows.has_commas {
        said.say(FindingKind::Note, "numbers", "with decimal commas".to_owned());
    }
}

/// A name for each marker.
fn names(header: &Header<'_>, markers: usize, said: &mut Said) -> Vec<String> {
    let mut names = header.names.clone();
    names.resize(markers, String::new());
    let (names, changed) = unique(names);
    if let Some((was, is)) = changed.first() {
        let message = format!(
            "{} without a name of its own: '{was}' is called '{is}', for one",
            counted(changed.len(), "marker")
        );
        said.say(FindingKind::Suspect, "markers", message);
    }
    names
}

/// The unit of lengths, and what there is to say of it.
fn unit(
    header: &Header<'_>,
    asked: Option<LengthUnit>,
    rows: &Rows,
) -> (LengthUnit, Option<(FindingKind, String)>) {
    let text = header.value("Units").unwrap_or("");
    let told = LengthUnit::named(text);
    if let Some(unit) = asked {
        let other = told.filter(|told| *told != unit);
        let message = other.map(|told| format!("{unit}, as asked for, and not {told} as the file says"));
        return (unit, message.map(|message| (FindingKind::Note, message)));
    }
    // Zeros that stand for hidden points would make the cloud look larger than it is.
    let seen: Vec<_> = rows
        .points
        .iter()
        .map(|point| if is_origin(point) { Vector3::repeat(f64::NAN) } else { *point })
        .collect();
    let (unit, mut message) = plausible(told, Extent::of(&seen, rows.markers));
    if told.is_none() && !text.is_empty() {
        message = Some(format!("'{text}' is no unit of lengths: {}", message.unwrap_or_default()));
    }
    (unit, message.map(|message| (FindingKind::Suspect, message)))
}

/// Whether two rates are not the same to a hundredth.
fn differ(own: f64, told: f64) -> bool {
    (own / told - 1.0).abs() > 0.01
}

fn is_origin(point: &Vector3<f64>) -> bool {
    point.iter().all(|x| *x == 0.0)
}

/// Hides the three zeros of markers that are elsewhere far from the origin.
fn origins(rows: &mut Rows, names: &[String], metre: f64, said: &mut Said) {
    /// Nearer than this (m), a marker may well pass through the origin.
    const FAR: f64 = 0.1;
    let (mut hidden, mut which, mut left) = (0, Vec::new(), Vec::new());
    for marker in 0..rows.markers {
        let own = || rows.points.iter().skip(marker).step_by(rows.markers);
        let zeros = own().filter(|point| is_origin(point)).count();
        if zeros == 0 {
            continue;
        }
        let nearest =
            own().filter(|point| !point.x.is_nan() && !is_origin(point)).map(Vector3::norm).reduce(f64::min);
        if nearest.is_some_and(|nearest| nearest * metre > FAR) {
            hidden += zeros;
            which.push(names[marker].as_str());
            for point in
                rows.points.iter_mut().skip(marker).step_by(rows.markers).filter(|point| is_origin(point))
            {
                *point = Vector3::repeat(f64::NAN);
            }
        } else {
            left.push(names[marker].as_str());
        }
    }
    if let Some(first) = which.first() {
        let message = format!(
            "{} of {} at 0 0 0, such as of '{first}', which is elsewhere far from there; taken as hidden",
            counted(hidden, "place"),
            counted(which.len(), "marker")
        );
        said.say(FindingKind::Suspect, "zeros", message);
    }
    if let Some(first) = left.first() {
        let message =
            format!("at 0 0 0 at times: '{first}', of {}; left there", counted(left.len(), "marker"));
        said.say(FindingKind::Suspect, "zeros", message);
    }
}

/// Times nearer to each other than this (s) are the same.
const EVEN: f64 = 1e-9;

/// The times (s): the table's, unrounded where they are those of the rate, or where one is missing those of the rate.
fn times(text: &str, header: &Header<'_>, rows: &Rows, said: &mut Said) -> Result<Vec<f64>, TextError> {
    let rate = header.number("DataRate").filter(|rate| *rate > 0.0);
    let Some(time) = rows.time.iter().map(|(time, _)| *time).collect::<Option<Vec<f64>>>() else {
        let missing =
            rows.time.iter().find(|(time, _)| time.is_none()).map_or(0..0, |(_, span)| span.clone());
        let Some(rate) = rate else {
            let message = "this frame has no time, and the header no DataRate; write one of both";
            return Err(TextError::one(text, missing, message));
        };
        said.say(
            FindingKind::Suspect,
            "times",
            format!("some are missing; all are made of the rate of {rate} Hz, from 0"),
        );
        return Ok((0..rows.time.len()).map(|frame| frame as f64 / rate).collect());
    };
    if let Some(at) = time.windows(2).position(|pair| pair[1] <= pair[0]) {
        let message = format!(
            "the time {} s does not come after {} s of the frame before; sort the frames",
            time[at + 1],
            time[at]
        );
        return Err(TextError::one(text, rows.time[at + 1].1.clone(), message));
    }
    if let (Some(rate), [first, .., last]) = (rate, &time[..]) {
        if let Some((even, unit)) = unrounded(&time, rate) {
            let message = format!("rounded to {unit} s; the frames are taken at the header's {rate} Hz");
            said.say(FindingKind::Note, "times", message);
            return Ok(even);
        }
        let own = (time.len() - 1) as f64 / (last - first);
        if differ(own, rate) {
            let message = format!("the header says {rate} Hz, the times {own:.4} Hz; the times count");
            said.say(FindingKind::Suspect, "DataRate", message);
        }
    }
    Ok(time)
}

/// The times of frames at this rate (Hz) of which `time` are the rounded ones, and to what (s) they are rounded; `None` where they are
/// not rounded, or not those.
fn unrounded(time: &[f64], rate: f64) -> Option<(Vec<f64>, f64)> {
    let is_multiple = |t: &f64, unit: f64| ((t / unit).round() * unit - t).abs() < EVEN;
    let unit =
        [1e-2, 1e-3, 1e-4, 1e-5].into_iter().find(|&unit| time.iter().all(|t| is_multiple(t, unit)))?;
    let at = |first: f64| (0..time.len()).map(|frame| (first + frame as f64) / rate).collect::<Vec<f64>>();
    let off = |even: &[f64]| even.iter().zip(time).map(|(even, t)| (even - t).abs()).fold(0.0, f64::max);
    // Frames are counted from time zero, or from some other time that is rounded as well.
    let counted = (time[0] * rate).round();
    let starts = [(counted, 0.5), (time[0] * rate, 1.0)];
    let found = starts.into_iter().map(|(first, most)| (at(first), most));
    let (even, _) = found.into_iter().find(|(even, most)| off(even) <= most * unit + EVEN)?;
    (off(&even) > EVEN).then_some((even, unit))
}
