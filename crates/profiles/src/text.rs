//! Profiles as text, for people: [RON](https://docs.rs/ron) with every fault at its place.
//!
//! ```
//! use solaris_profiles::{Profile, text};
//!
//! let profile = text::read("Tension(from: 0, to: 1.2, duration: 0.8, stiffness: 3, end_velocity: 0.5)")?;
//! assert_eq!(text::read(&text::write(&profile))?, profile);
//! assert_eq!(
//!     text::line(&Profile::Line { from: 0.0, to: 1.0, duration: 2.0 }),
//!     "Line(from: 0.0, to: 1.0, duration: 2.0)"
//! );
//!
//! let error = text::read("Line(from: 0, to: 1,\n     durtion: 2)").unwrap_err();
//! assert_eq!(
//!     error.to_string(),
//!     "line 1, column 1: this Line has no duration; add duration: 0.5\n\
//!      line 2, column 6: Line has no field 'durtion'; did you mean 'duration'?"
//! );
//! # Ok::<(), solaris_text::TextError>(())
//! ```
//!
//! # Grammar
//!
//! | | fields |
//! |---|---|
//! | CURVE | the variant of a [`Kind`](crate::Kind) with its parameters, a `_` where their names have a blank: `CubicHermite(from: 0, to: 5, duration: 2, end_velocity: 1)`; optional ones are zero where they are left out. Kinds through keys have `keys: [(time, position), …]` |
//! | | `Blend(first: LAYER, second: LAYER, fade: FADE, leaving: Refuse)`, the last also `Clamp` or `Allow`: [`Leaving`](crate::blend::Leaving) |
//! | | `Weighted(layers: [LAYER, …])` |
//! | | `Sine(amplitude: 0.2, period: 1, cycles: 3, phase: deg(90), offset: 0.5)`, phase and offset zero unless given: [`Sine`](crate::cyclic::Sine) |
//! | | `Repeat(of: CURVE, times: 3)`: [`Repeat`](crate::cyclic::Repeat) |
//! | LAYER | CURVE, or `(profile: CURVE, start: 0, outside: Hold, amount: 1, fade_in: FADE, fade_out: FADE)`; `outside` also `Extrapolate`, `Repeat` or `Mirror`: [`ProfileLayer`] |
//! | FADE | `(kind: Smooth, start: 0, end: 1)`; kinds are `Linear`, `Smooth`, `Exponential(stiffness: 1)`, `Sinh(…)` and `Trigonometric(…)`: [`FadeKind`](crate::blend::FadeKind) |
//!
//! Positions of what turns, and their rates, are numbers or degrees: `deg(30)`. What is optional may stand in `Some(…)` or be `None`.

mod blend;
mod curve;
mod cyclic;
mod write;

pub use solaris_text::{TextError, TextFault};
pub use write::{line, write};

use crate::error::ProfileError;
use crate::profile::{Profile, ProfileLayer};
use curve::{ProfileReader, culprit};
use solaris_text::{Content, Node, Reader, parse};
use std::ops::Range;

const NOUN: &str = "profile";
const BEGINS: &str = "MinimumJerk(from: 0, to: 1, duration: 2)";

/// The profile that a text describes.
///
/// # Errors
///
/// [`TextError`] with every fault, in the order of the text: what is no RON, what is unknown, missing or of the wrong kind, and what
/// [`Profile::curve`] refuses.
pub fn read(text: &str) -> Result<Profile, TextError> {
    whole(text, |reader, tree| read_node(reader, tree, true))
}

/// The profile or the layer of a blend that a text describes.
///
/// # Errors
///
/// As for [`read`].
pub fn read_layer(text: &str) -> Result<ProfileLayer, TextError> {
    whole(text, |reader, tree| ProfileReader { reader, turns: true, lasts: None }.layer(tree))
}

/// The profile of a node inside of another text, or nothing where it has faults, which `reader` then knows. Where it moves what
/// `turns`, positions and their rates may be in degrees.
pub fn read_node(reader: &mut Reader, node: &Node<'_>, turns: bool) -> Option<Profile> {
    ProfileReader { reader, turns, lasts: None }.profile(node)
}

/// The same in a text that says how long (s) it is about, `lasts`: a sine without `cycles` and a repetition without `times` go on for
/// so long at least.
pub fn read_node_within(
    reader: &mut Reader,
    node: &Node<'_>,
    turns: bool,
    lasts: Option<f64>,
) -> Option<Profile> {
    ProfileReader { reader, turns, lasts }.profile(node)
}

/// The bytes of the value that an error of the profile in `text` is about, where that is one of its own parameters and not one of
/// a layer.
pub fn place(text: &str, error: &ProfileError) -> Option<Range<usize>> {
    let (tree, name) = (parse(text, NOUN, BEGINS).ok()?, culprit(error)?);
    let Content::Fields(fields) = &tree.group()?.content else { return None };
    fields.iter().find(|(field, _)| field.name == name).map(|(_, node)| node.span.clone())
}

fn whole<T>(text: &str, one: impl Fn(&mut Reader, &Node<'_>) -> Option<T>) -> Result<T, TextError> {
    let tree = parse(text, NOUN, BEGINS)?;
    let mut reader = Reader::default();
    let found = one(&mut reader, &tree);
    reader.finish(text)?;
    // Where there is none there is a fault.
    found.ok_or_else(|| TextError::one(text, tree.span, "this profile cannot be used"))
}
