//! What may stand at a place of a scene's text: for editors.
//!
//! The readers of scenes say it themselves. A word that nobody knows is put where somebody is writing, the text around it is mended so
//! far that it can be parsed, and whichever reader comes to that word tells what it would have taken. So whatever can be read is known
//! here, and nothing else.

mod place;

use crate::loader::Loader;
use crate::read;
use place::{Place, Stand};
use solaris_model::text::layout::quoted;
use solaris_model::text::{Expected, ExpectedKind, parse};

/// What may stand at a place of a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Completions {
    /// The first byte of what is written there now.
    pub from: usize,
    /// The byte after it: what is chosen takes the place of `from..to`.
    pub to: usize,
    /// All that may stand there, whatever is written already; nothing where nobody knows.
    pub items: Vec<Completion>,
}

/// Something that may stand at a place of a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Completion {
    /// What it is called.
    pub label: String,
    /// What to write: a field with its colon, a name with its quotes, where they are not there yet.
    pub insert: String,
    /// What it is, for people: `field of Servo`, `joint`; may be empty.
    pub detail: String,
}

/// A word that no reader knows.
const NOBODY: &str = "zz";

/// What may stand at byte `offset` of a scene's text, which need not be one yet; `loader` fetches the figures that it names as files,
/// whose names may stand there too.
///
/// ```
/// use solaris_scene::{NoFiles, complete};
///
/// let text = "Scene(version: 1, figures: {\"ann\": Human()}, drives: {\"left_elbow\": Servo(to: 1, st";
/// let found = complete(text, text.len(), &mut NoFiles);
/// assert_eq!(&text[found.from..found.to], "st");
/// let stiffness = found.items.iter().find(|item| item.label == "stiffness").expect("a field");
/// assert_eq!((&*stiffness.insert, &*stiffness.detail), ("stiffness: ", "field of Servo"));
/// ```
pub fn complete(text: &str, offset: usize, loader: &mut dyn Loader) -> Completions {
    let Some(place) = Place::find(text, offset) else {
        let offset = place::boundary(text, offset);
        return Completions { from: offset, to: offset, items: Vec::new() };
    };
    let mut items: Vec<Completion> = Vec::new();
    for stand in place.stands() {
        for (tried, at) in place.tries(*stand, NOBODY) {
            if parse(&tried, "scene", "Scene(version: 1, …)").is_err() {
                continue;
            }
            let expected = read::expected(&tried, at, loader);
            let found: Vec<Completion> =
                expected.iter().flat_map(|expected| of_expected(expected, *stand, &place)).collect();
            let is_known = !found.is_empty();
            for item in found {
                if items.iter().all(|known| known.label != item.label) {
                    items.push(item);
                }
            }
            if is_known {
                break;
            }
        }
    }
    Completions { from: place.from, to: place.to, items }
}

/// What a reader expects, where that is what may stand here.
fn of_expected(expected: &Expected, stand: Stand, place: &Place<'_>) -> Vec<Completion> {
    let fits = match expected.kind {
        ExpectedKind::Field => stand == Stand::Field,
        ExpectedKind::Word => stand == Stand::Word,
        ExpectedKind::Name => matches!(stand, Stand::Name | Stand::Key),
    };
    if !fits {
        return Vec::new();
    }
    let colon = if matches!(stand, Stand::Field | Stand::Key) && !place.has_colon { ": " } else { "" };
    let item = |name: &String| {
        let word = match (expected.kind, place.in_quotes) {
            (ExpectedKind::Name, false) => quoted(name),
            (ExpectedKind::Name, true) => {
                let written = quoted(name);
                written[1..written.len() - 1].to_owned()
            }
            _ => name.clone(),
        };
        let detail = match expected.kind {
            ExpectedKind::Field => format!("field of {}", expected.of),
            _ => expected.of.clone(),
        };
        let colon = if place.in_quotes { "" } else { colon };
        Completion { label: name.clone(), insert: format!("{word}{colon}"), detail }
    };
    expected.names.iter().map(item).collect()
}
