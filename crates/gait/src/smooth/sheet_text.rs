//! Style sheets as text, and those that ship.

use super::sheet_numbers::{SHEET_NUMBERS, SheetNumber, SheetUnit};
use crate::error::RequestError;
use crate::request::{Change, StyleSheet};
use solaris_text::{Content, Node, Reader, TextError, nearest, parse};

/// A manner that ships, as its text.
#[derive(Debug)]
pub struct ShippedManner {
    /// Its name.
    pub name: &'static str,
    /// The sheet, with its source.
    pub text: &'static str,
}

macro_rules! shipped {
    ($folder:literal: $($name:literal),*) => {
        &[$(ShippedManner { name: $name, text: include_str!(concat!("../../manners/", $folder, $name, ".ron")) }),*]
    };
}

/// All manners that ship.
pub const MANNERS: &[ShippedManner] =
    shipped!["": "tired", "sad", "happy", "proud", "heavy", "older", "child", "cautious"];

/// All manners of one side that ship, see [`crate::WalkRequest::sides`].
pub const SIDE_MANNERS: &[ShippedManner] = shipped!["sides/": "limp", "stiff_knee", "drop_foot", "load"];

/// What a number of a sheet may be blended by at most: twice as much as it says.
const MOST: f64 = 2.0;

/// The manner of this name.
///
/// # Errors
///
/// A name that none has, with the nearest.
pub fn manner(name: &str) -> Result<StyleSheet, RequestError> {
    among(MANNERS, name)
}

fn among(all: &[ShippedManner], name: &str) -> Result<StyleSheet, RequestError> {
    let names = || all.iter().map(|manner| manner.name);
    let found = all.iter().find(|manner| manner.name == name);
    found.and_then(|manner| read_sheet(manner.text).ok()).ok_or_else(|| RequestError::UnknownManner {
        name: name.to_owned(),
        known: match nearest(name, names()) {
            Some(near) => format!("did you mean '{near}'?"),
            None => format!("there are {}", names().collect::<Vec<_>>().join(", ")),
        },
    })
}

/// Manners that ship, blended: `sad`, `sad:0.6`, `sad:0.6,heavy:0.3`, summed.
///
/// # Errors
///
/// A name that none has, and a part that is no number from 0 to 2.
pub fn sheet_of(blend: &str) -> Result<StyleSheet, RequestError> {
    blended(MANNERS, blend)
}

/// The same of one side: `limp`, `limp:0.5,load`.
///
/// # Errors
///
/// As for [`sheet_of`].
pub fn side_sheet_of(blend: &str) -> Result<StyleSheet, RequestError> {
    blended(SIDE_MANNERS, blend)
}

fn blended(all: &[ShippedManner], blend: &str) -> Result<StyleSheet, RequestError> {
    blend.split(',').try_fold(StyleSheet::default(), |sum, one| {
        let (name, part) = one.split_once(':').unwrap_or((one, "1"));
        let value = part.trim().parse::<f64>().ok().filter(|part| (0.0..=MOST).contains(part));
        let value = value.ok_or_else(|| RequestError::MannerPart {
            manner: name.trim().to_owned(),
            part: part.trim().to_owned(),
            most: MOST,
        })?;
        Ok(sum.plus(&among(all, name.trim())?.scaled(value)))
    })
}

/// The sheet that a text describes:
///
/// ```text
/// Manner(
///     name: "weary",
///     source: "an artist's choice",
///     arm_swing: Times(0.7),
///     thorax_lean: Plus(deg(6)),
///     elbow: [Times(0.8), Plus(deg(3))],
/// )
/// ```
///
/// Name and source may be left out; the other fields are those of [`SHEET_NUMBERS`]. `Times` is a factor; `Plus` is in rad or in degrees
/// (`deg`), in metres, or a plain number.
///
/// # Errors
///
/// [`TextError`] with every fault, in the order of the text.
///
/// ```
/// let error = solaris_gait::read_sheet("Manner(\n    arm_swin: Times(0.5),\n    elbow: 3,\n)").unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "line 2, column 5: Manner has no field 'arm_swin'; did you mean 'arm_swing'?\n\
///      line 3, column 12: a change must be Times(…) or Plus(…), or both in a list, as [Times(0.8), Plus(deg(3))], not a number"
/// );
/// ```
pub fn read_sheet(text: &str) -> Result<StyleSheet, TextError> {
    let tree = parse(text, "manner", "Manner(arm_swing: Times(0.7))")?;
    let mut reader = Reader::default();
    let known: Vec<&str> =
        ["name", "source"].into_iter().chain(SHEET_NUMBERS.iter().map(|number| number.name)).collect();
    let mut sheet = StyleSheet::default();
    if let Some(fields) = reader.fields(&tree, &["Manner"], &known) {
        for what in ["name", "source"] {
            if let Some(node) = fields.get(what) {
                reader.text(node, format_args!("the {what} of a manner"));
            }
        }
        for number in SHEET_NUMBERS {
            if let Some(node) = fields.get(number.name) {
                sheet = sheet.with(number.name, read_changes(&mut reader, node, number));
            }
        }
    }
    reader.finish(text)?;
    Ok(sheet)
}

/// One change, or some in a list; none where there is a fault.
fn read_changes(reader: &mut Reader, node: &Node<'_>, number: &SheetNumber) -> Change {
    let one = std::slice::from_ref(node);
    let all = if node.head().is_none() { node.items().unwrap_or(one) } else { one };
    // Factors first, whatever stands first.
    all.iter().fold(Change::NONE, |sum, node| {
        let change = read_change(reader, node, number);
        Change { factor: sum.factor * change.factor, add: sum.add + change.add }
    })
}

fn read_change(reader: &mut Reader, node: &Node<'_>, number: &SheetNumber) -> Change {
    let name = number.name;
    let operand = node.group().and_then(|group| match (&group.name, &group.content) {
        (Some(named), Content::Tuple(items)) if items.len() == 1 => Some((named, &items[0])),
        _ => None,
    });
    let Some((named, operand)) = operand else {
        let message = format!(
            "a change must be Times(…) or Plus(…), or both in a list, as [Times(0.8), Plus(deg(3))], not {}",
            node.describe()
        );
        reader.fault(node.place(), message);
        return Change::NONE;
    };
    match named.name {
        "Times" => {
            let factor = reader.number(operand, format_args!("the factor of {name}"));
            let range = if number.unit == SheetUnit::Factor { number.range } else { (0.0, 5.0) };
            Change { factor: within(reader, operand, factor, range, name, "").unwrap_or(1.0), add: 0.0 }
        }
        "Plus" if number.unit == SheetUnit::Factor => {
            reader.fault(named.span.clone(), format!("{name} takes Times(…) alone: {}", number.help));
            Change::NONE
        }
        "Plus" => {
            let what = format!("what is added to {name}");
            let add = if number.unit == SheetUnit::Degrees {
                reader.angle(operand, what).map(f64::to_degrees)
            } else {
                reader.number(operand, what)
            };
            let most = number.range.1 - number.range.0;
            let add = within(reader, operand, add, (-most, most), name, number.unit.symbol());
            Change { factor: 1.0, add: add.unwrap_or(0.0) }
        }
        other => {
            let hint = nearest(other, ["Times", "Plus"].into_iter()).map_or_else(
                || "write Times(…) or Plus(…)".to_owned(),
                |near| format!("did you mean '{near}'?"),
            );
            reader.fault(named.span.clone(), format!("'{other}' is not known here; {hint}"));
            Change::NONE
        }
    }
}

/// A number in its range.
fn within(
    reader: &mut Reader,
    node: &Node<'_>,
    value: Option<f64>,
    (lower, upper): (f64, f64),
    name: &str,
    unit: &str,
) -> Option<f64> {
    let value = value?;
    if (lower..=upper).contains(&value) {
        return Some(value);
    }
    let message = format!("{name} {value}{unit}: a change of it must be {lower} to {upper}{unit}");
    reader.fault(node.span.clone(), message);
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_ships_can_be_read_and_says_where_it_comes_from() {
        for ShippedManner { name, text } in MANNERS.iter().chain(SIDE_MANNERS) {
            let sheet = read_sheet(text).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert!(
                !sheet.is_empty() && text.contains("source:") && text.contains(&format!("\"{name}\"")),
                "{name}"
            );
        }
    }

    #[test]
    fn blends_are_sums_of_parts() {
        let [sad, heavy] = ["sad", "heavy"].map(|name| manner(name).expect("it ships"));
        let blend = sheet_of("sad:0.6, heavy:0.5").expect("a blend");
        for number in SHEET_NUMBERS {
            let [a, b, c] = [&sad, &heavy, &blend].map(|sheet| sheet.get(number.name));
            assert!((c.factor - 1.0 - 0.6 * (a.factor - 1.0) - 0.5 * (b.factor - 1.0)).abs() < 1e-12);
            assert!((c.add - 0.6 * a.add - 0.5 * b.add).abs() < 1e-12);
        }
        for wrong in ["sda", "sad:x", "sad:3", "sad:-1", "sad:nan", ""] {
            assert!(sheet_of(wrong).is_err(), "{wrong}");
        }
    }
}
