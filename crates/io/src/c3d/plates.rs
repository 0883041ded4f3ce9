//! The force plates that the parameters describe.

use super::layout::Layout;
use super::parameters::Parameters;
use super::read::Said;
use crate::markers::{Channel, LengthUnit, Plate, PlateKind};
use solaris_model::{FindingKind, Vector3};
use std::ops::Range;

/// Makes plates of the channels.
pub(super) fn plates(
    layout: &Layout,
    all: &Parameters<'_>,
    analog: &[Channel],
    unit: LengthUnit,
    said: &mut Said,
) -> Vec<Plate> {
    let used = all.count("FORCE_PLATFORM", "USED").unwrap_or(0);
    let types = all.numbers("FORCE_PLATFORM", "TYPE");
    let group = Group {
        corners: all.numbers("FORCE_PLATFORM", "CORNERS"),
        origins: all.numbers("FORCE_PLATFORM", "ORIGIN"),
        channels: all.counts("FORCE_PLATFORM", "CHANNEL"),
        width: all
            .get("FORCE_PLATFORM", "CHANNEL")
            .and_then(|list| list.dimensions.first().copied())
            .unwrap_or(6),
        matrices: all.numbers("FORCE_PLATFORM", "CAL_MATRIX"),
        matrix: all
            .get("FORCE_PLATFORM", "CAL_MATRIX")
            .map_or(36, |list| list.dimensions.iter().take(2).product()),
        polynomials: all.numbers("FORCE_PLATFORM", "FPCOPPOLY"),
        baseline: baseline(layout, all),
        unit,
    };
    let mut found = Vec::new();
    // A plate has 12 numbers of corners, so that a wrong count ends where they do.
    for at in 0..used.min(group.corners.len() / 12) {
        let subject = format!("force plate {}", at + 1);
        let kind = match types.get(at).copied().unwrap_or(0.0) as i64 {
            1 => PlateKind::Pressure,
            2 => PlateKind::Wrench,
            3 => PlateKind::Corners,
            4 => PlateKind::Matrix,
            other => {
                let message = format!("it is of type {other} ({}), which is not read", named(other));
                said.say(FindingKind::Unsupported, &subject, message);
                continue;
            }
        };
        match group.plate(at, kind, analog, &subject, said) {
            Ok(plate) => found.push(plate),
            Err(why) => said.say(FindingKind::Unsupported, &subject, format!("{why}; it is left out")),
        }
    }
    if used > group.corners.len() / 12 {
        let message = format!(
            "{used} plates, and FORCE_PLATFORM:CORNERS has {} numbers, 12 a plate",
            group.corners.len()
        );
        said.say(FindingKind::Suspect, "FORCE_PLATFORM:USED", message);
    }
    found
}

/// What plates of types that are not read are.
fn named(kind: i64) -> &'static str {
    match kind {
        5 => "eight channels as type 3, with a 6 × 8 calibration matrix",
        6 => "twelve channels, three forces at each corner",
        7 | 8 => "which some makers' programs define for plates of their own",
        11 => "Kistler's treadmill of two belts",
        12 => "Kistler's treadmill with a calibration matrix",
        21 => "AMTI's stairs of three steps",
        _ => "which no guide names",
    }
}

/// The parameters of all plates.
struct Group {
    corners: Vec<f64>,
    origins: Vec<f64>,
    channels: Vec<f64>,
    /// Channels of a plate.
    width: usize,
    matrices: Vec<f64>,
    /// Numbers of a matrix.
    matrix: usize,
    polynomials: Vec<f64>,
    baseline: Option<Range<usize>>,
    unit: LengthUnit,
}

impl Group {
    fn plate(
        &self,
        at: usize,
        mut kind: PlateKind,
        analog: &[Channel],
        subject: &str,
        said: &mut Said,
    ) -> Result<Plate, String> {
        let metre = self.unit.metres();
        let vector = |list: &[f64], from: usize| {
            Vector3::from_fn(|i, _| list.get(from + i).copied().unwrap_or(0.0)) * metre
        };
        let corners = [0, 1, 2, 3].map(|corner| vector(&self.corners, 12 * at + 3 * corner));
        let count = if kind == PlateKind::Corners { 8 } else { 6 };
        let mut channels = Vec::with_capacity(count);
        let mut rate = 0.0;
        let mut units = Vec::with_capacity(count);
        for place in 0..count {
            let number = self.channels.get(at * self.width + place).copied().filter(|_| place < self.width);
            let number = number.ok_or_else(|| {
                format!("FORCE_PLATFORM:CHANNEL has no number for its channel {}", place + 1)
            })?;
            let channel = (number as usize).checked_sub(1).and_then(|index| analog.get(index));
            let channel = channel.ok_or_else(|| {
                format!("FORCE_PLATFORM:CHANNEL names channel {number}, and there are {}", analog.len())
            })?;
            rate = channel.rate;
            units.push(channel.unit.as_str());
            channels.push(channel.samples.clone());
        }
        let moment = moment_unit(units.get(3).copied().unwrap_or(""), metre);
        let mut matrix = None;
        match kind {
            PlateKind::Wrench => channels[3..].iter_mut().flatten().for_each(|value| *value *= moment),
            PlateKind::Pressure => {
                for place in 3..5 {
                    let length = LengthUnit::named(units[place]).map_or(metre, LengthUnit::metres);
                    channels[place].iter_mut().for_each(|value| *value *= length);
                }
                let moment = moment_unit(units[5], metre);
                channels[5].iter_mut().for_each(|value| *value *= moment);
            }
            PlateKind::Matrix => {
                matrix = self.calibration(at, metre);
                if matrix.is_none() {
                    kind = PlateKind::Wrench;
                    channels[3..].iter_mut().flatten().for_each(|value| *value *= moment);
                    let message = "it is of type 4 and has no FORCE_PLATFORM:CAL_MATRIX of 6 × 6 numbers; read as type 2";
                    said.say(FindingKind::Suspect, subject, message.to_owned());
                }
            }
            PlateKind::Corners => {}
        }
        let mut origin = vector(&self.origins, 3 * at);
        if origin.z > 0.0 {
            origin = -origin;
            let message = "its origin points to above the surface, the other way than the format's guide says; turned round";
            said.say(FindingKind::Note, subject, message.to_owned());
        }
        let none = channels.iter().flatten().filter(|value| !value.is_finite()).count();
        if none > 0 {
            let message = format!("{none} samples of its channels are no numbers; nothing acts where one is");
            said.say(FindingKind::Suspect, subject, message);
        }
        let plate = Plate {
            number: at + 1,
            kind,
            corners,
            origin,
            rate,
            channels,
            matrix,
            polynomials: self.polynomials(at, metre),
            baseline: self.baseline.clone(),
            is_opposite: false,
        };
        plate
            .axes()
            .map(|_| plate)
            .ok_or_else(|| "its corners (FORCE_PLATFORM:CORNERS) span no surface".to_owned())
    }

    /// The 6 × 6 matrix of a plate, which the file has column by column, with moments in N·m.
    fn calibration(&self, at: usize, metre: f64) -> Option<[[f64; 6]; 6]> {
        let own = self.matrices.get(at * self.matrix..).filter(|own| self.matrix >= 36 && own.len() >= 36)?;
        Some(std::array::from_fn(|row| {
            std::array::from_fn(|column| own[6 * column + row] * if row < 3 { 1.0 } else { metre })
        }))
    }

    /// The polynomials of a plate, if it has some that are not zero, for lengths in metres.
    fn polynomials(&self, at: usize, metre: f64) -> Option<[[f64; 6]; 2]> {
        let own = self.polynomials.get(12 * at..12 * at + 12)?;
        let powers = [6, 4, 2, 4, 2, 0];
        let of = |first: usize| std::array::from_fn(|i| own[first + i] / metre.powi(powers[i]));
        own.iter().any(|p| *p != 0.0).then(|| [of(0), of(6)])
    }
}

/// What a moment of 1 is (N·m), by its unit's text or else by the unit of lengths.
fn moment_unit(text: &str, metre: f64) -> f64 {
    let text: String =
        text.chars().filter(char::is_ascii_alphabetic).collect::<String>().to_ascii_lowercase();
    match text.strip_prefix('n').and_then(LengthUnit::named) {
        Some(unit) => unit.metres(),
        None => metre,
    }
}

/// The samples of `FORCE_PLATFORM:ZERO`, which names frames from 1.
fn baseline(layout: &Layout, all: &Parameters<'_>) -> Option<Range<usize>> {
    let [first, last] = all.counts("FORCE_PLATFORM", "ZERO").get(..2)?.try_into().ok()?;
    let (first, last): (f64, f64) = (first, last);
    let frames = 1.0..=layout.frames as f64;
    (frames.contains(&first) && frames.contains(&last) && last >= first)
        .then(|| (first as usize - 1) * layout.samples..last as usize * layout.samples)
}
