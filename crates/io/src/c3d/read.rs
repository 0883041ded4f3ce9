//! A recording from the bytes of a C3D file.

use super::analog::analog;
use super::error::C3dError;
use super::events::events;
use super::header::{field, header};
use super::layout::layout;
use super::parameters::{Parameters, parameters};
use super::plates::plates;
use super::points::points;
use crate::markers::{Extent, LengthUnit, Recording, plausible};
use solaris_model::{Finding, FindingKind, MarkerTrial};

/// What is not left to the file.
#[derive(Clone, Copy, Debug, Default)]
pub struct ReadOptions {
    /// The unit of lengths, whatever the file says and however large its subject then is.
    pub unit: Option<LengthUnit>,
}

/// What there is to say.
#[derive(Default)]
pub(super) struct Said {
    findings: Vec<Finding>,
}

impl Said {
    pub(super) fn say(&mut self, kind: FindingKind, subject: &str, message: String) {
        self.findings.push(Finding { kind, subject: subject.to_owned(), message, place: None });
    }
}

/// Reads a C3D file.
///
/// # Errors
///
/// [`C3dError`] of what is no C3D file, or of one whose header, parameters or length leave open where the points are.
///
/// # Examples
///
/// ```
/// use solaris_io::c3d::{ReadOptions, read};
/// let error = read(b"PK\x03\x04", &ReadOptions::default()).unwrap_err();
/// assert!(error.to_string().starts_with("it is no C3D file"));
/// ```
pub fn read(bytes: &[u8], options: &ReadOptions) -> Result<Recording, C3dError> {
    let mut said = Said::default();
    let (header, bytes) = header(bytes)?;
    let all = parameters(bytes, &header);
    if let Some(broken) = &all.broken {
        if !all.has_group("POINT") || all.get("POINT", "SCALE").is_none() {
            let advice = "the parameters cannot be read; export the trial again";
            return Err(field("a parameter", &broken.why, broken.offset, advice));
        }
        let message =
            format!("those from byte {} on make no sense ({}), and are left out", broken.offset, broken.why);
        said.say(FindingKind::Suspect, "parameters", message);
    }
    let layout = layout(&bytes, &header, &all, &mut said)?;
    let found = points(&bytes, &layout, &all, &mut said);
    let unit = unit(&all, options.unit, &found.places, found.names.len(), &mut said);
    let metre = unit.metres();
    let time = (0..layout.frames).map(|frame| frame as f64 / layout.rate).collect();
    let markers = MarkerTrial::new(found.names, time, found.places)?.mapped(|point| point * metre);
    let analog = analog(&bytes, &layout, &all, &mut said);
    let plates = plates(&layout, &all, &analog, unit, &mut said);
    Ok(Recording {
        markers,
        unit,
        rate: Some(layout.rate),
        first_frame: layout.first,
        residuals: found.residuals.iter().map(|residual| residual * metre).collect(),
        events: events(&bytes, &layout, &all),
        analog,
        plates,
        findings: said.findings,
    })
}

/// The unit of lengths: the asked one, or the file's where it can be.
fn unit(
    all: &Parameters<'_>,
    asked: Option<LengthUnit>,
    points: &[solaris_model::Vector3<f64>],
    markers: usize,
    said: &mut Said,
) -> LengthUnit {
    let texts = all.texts("POINT", "UNITS");
    let text = texts.first().map_or("", String::as_str);
    let told = LengthUnit::named(text);
    if let Some(unit) = asked {
        if let Some(told) = told.filter(|told| *told != unit) {
            said.say(
                FindingKind::Note,
                "unit",
                format!("{unit}, as asked for, and not {told} as the file says"),
            );
        }
        return unit;
    }
    if told.is_none() && !text.is_empty() {
        said.say(FindingKind::Suspect, "POINT:UNITS", format!("'{text}' is no unit of lengths"));
    }
    let (unit, message) = plausible(told, Extent::of(points, markers));
    if let Some(message) = message {
        said.say(FindingKind::Suspect, "unit", message);
    }
    unit
}
