//! The pairs of left and right links, by their names.

use crate::link::Link;
use std::collections::{HashMap, HashSet};

/// A left link and its right one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Mates {
    /// Index of the left link.
    pub(crate) left: usize,
    /// Index of the right one.
    pub(crate) right: usize,
    /// Their name without the side.
    pub(crate) stem: String,
}

/// A reading of a name as one of the left or right.
struct Reading {
    is_left: bool,
    /// The same name on the other side.
    other: String,
    stem: String,
    /// Whether the side is a whole word, so that a missing partner is worth a word.
    whole: bool,
}

/// The longest name that is read (bytes).
const LONGEST: usize = 200;

/// The sides, left and right, in the spellings that are told apart.
const SIDES: [(&str, &str); 5] =
    [("left", "right"), ("Left", "Right"), ("LEFT", "RIGHT"), ("l", "r"), ("L", "R")];

/// The pairs among the links.
///
/// A side is a word of the name: `left`, `right`, `l` or `r`, all small, all capital or beginning with a capital
/// (`left_shank`, `calcn_l`, `hand.L`, `LeftArm`, `front_left_wheel`); or `left` and `right` at the beginning or the end
/// of a word (`leftfinger`); or `l`, `r`, `L`, `R` at the beginning of the name (`LARM`, `rknee`). Words end at whatever
/// is no letter and no digit, and where a capital follows a small letter or begins a word in capitals. A name may say its
/// side several times. The first reading that has a link on the other side is taken; names of more than 200 bytes have
/// none.
pub(crate) fn mates(links: &[Link]) -> Vec<Mates> {
    let index: HashMap<&str, usize> =
        links.iter().enumerate().map(|(i, link)| (link.name.as_str(), i)).collect();
    let mut taken = HashSet::new();
    let mut pairs = Vec::new();
    for (i, link) in links.iter().enumerate() {
        let mate = readings(&link.name)
            .into_iter()
            .filter(|reading| reading.is_left)
            .find_map(|reading| Some((*index.get(reading.other.as_str())?, reading.stem)));
        let Some((right, stem)) = mate.filter(|(right, _)| taken.insert(*right)) else { continue };
        pairs.push(Mates { left: i, right, stem });
    }
    pairs
}

/// The links whose names have a side, where none has the name of the other side: each with that name. A side of one letter
/// counts where the figure has pairs.
pub(crate) fn singles(links: &[Link], pairs: &[Mates]) -> Vec<(usize, String)> {
    let paired: HashSet<usize> = pairs.iter().flat_map(|pair| [pair.left, pair.right]).collect();
    let alone = links.iter().enumerate().filter(|(i, _)| !paired.contains(i));
    let single = |(i, link): (usize, &Link)| {
        let reading = readings(&link.name).into_iter().find(|reading| reading.whole)?;
        let letter = reading.other.len().abs_diff(link.name.len()) == 0;
        (!letter || !pairs.is_empty()).then_some((i, reading.other))
    };
    alone.filter_map(single).collect()
}

fn readings(name: &str) -> Vec<Reading> {
    if name.len() > LONGEST {
        return Vec::new();
    }
    let words = words(name);
    let mut found: Vec<Reading> = throughout(name, &words).into_iter().collect();
    let mut read = |range: std::ops::Range<usize>, whole: bool| {
        for (left, right) in SIDES {
            let (is_left, other) = match &name[range.clone()] {
                side if side == left => (true, right),
                side if side == right => (false, left),
                _ => continue,
            };
            let (before, after) = (&name[..range.start], &name[range.end..]);
            // One separator goes with the side, where the side is a word.
            let separators = |c: char| whole && !c.is_alphanumeric();
            let stem = match before.strip_suffix(separators) {
                Some(before) => format!("{before}{after}"),
                None => format!("{before}{}", after.strip_prefix(separators).unwrap_or(after)),
            };
            found.push(Reading { is_left, other: format!("{before}{other}{after}"), stem, whole });
        }
    };
    for word in &words {
        read(word.clone(), true);
    }
    for word in &words {
        for length in [4, 5] {
            if word.len() > length && name.is_char_boundary(word.start + length) {
                read(word.start..word.start + length, false);
            }
            if word.len() > length && name.is_char_boundary(word.end - length) {
                read(word.end - length..word.end, false);
            }
        }
    }
    if name.len() > 1 && name.is_char_boundary(1) {
        read(0..1, false);
    }
    found
}

/// The reading of a name that says its side several times, and the same each time: `foot_left_ankle_left`.
fn throughout(name: &str, words: &[std::ops::Range<usize>]) -> Option<Reading> {
    let (mut other, mut stem) = (name.to_owned(), name.to_owned());
    let mut sides = Vec::new();
    // From the end, so that what comes before keeps its place.
    for word in words.iter().rev() {
        for (left, right) in SIDES {
            for (side, opposite) in [(left, right), (right, left)] {
                if name[word.clone()] == *side {
                    other.replace_range(word.clone(), opposite);
                    stem.replace_range(word.clone(), "");
                    sides.push(side == left);
                }
            }
        }
    }
    let is_one = sides.len() > 1 && sides.windows(2).all(|pair| pair[0] == pair[1]);
    is_one.then(|| Reading { is_left: sides[0], other, stem, whole: true })
}

/// The byte ranges of the words of a name.
pub(crate) fn words(name: &str) -> Vec<std::ops::Range<usize>> {
    let characters: Vec<(usize, char)> = name.char_indices().collect();
    let mut words = Vec::new();
    let mut start = None;
    for (k, &(at, c)) in characters.iter().enumerate() {
        let before = k.checked_sub(1).map(|k| characters[k].1);
        let after = characters.get(k + 1).map(|&(_, c)| c);
        let begins = c.is_uppercase()
            && (before.is_some_and(char::is_lowercase)
                || (before.is_some_and(char::is_uppercase) && after.is_some_and(char::is_lowercase)));
        if let Some(from) = start.filter(|_| begins || !c.is_alphanumeric()) {
            words.push(from..at);
            start = None;
        }
        if c.is_alphanumeric() {
            start = start.or(Some(at));
        }
    }
    words.extend(start.map(|from| from..name.len()));
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{FigureBuilder, Joint, LinkSpec};

    fn figure(names: &[&str]) -> crate::Figure {
        let add = |builder: FigureBuilder, name: &&str| {
            builder.link(LinkSpec::child(*name, "trunk", Joint::new(format!("{name} joint"))))
        };
        let trunk = FigureBuilder::new("f").link(LinkSpec::root("trunk", Joint::new("root")));
        names.iter().fold(trunk, add).build().expect("valid")
    }

    fn pairs(names: &[&str]) -> Vec<(String, String, String)> {
        let figure = figure(names);
        let name = |i: usize| figure.links[i].name.clone();
        mates(&figure.links).into_iter().map(|pair| (name(pair.left), name(pair.right), pair.stem)).collect()
    }

    #[test]
    fn names_of_both_sides_pair_up() {
        for (left, right, stem) in [
            ("left_shank", "right_shank", "shank"),
            ("calcn_l", "calcn_r", "calcn"),
            ("hand.L", "hand.R", "hand"),
            ("LeftArm", "RightArm", "Arm"),
            ("ArmLeft", "ArmRight", "Arm"),
            ("HAND_LEFT", "HAND_RIGHT", "HAND"),
            ("l_wrist", "r_wrist", "wrist"),
            ("LThigh", "RThigh", "Thigh"),
            ("LARM_LINK1", "RARM_LINK1", "ARM_LINK1"),
            ("lknee", "rknee", "knee"),
            ("panda_leftfinger", "panda_rightfinger", "panda_finger"),
            ("front left wheel", "front right wheel", "front wheel"),
            ("foot_left_ankle_left", "foot_right_ankle_right", "foot__ankle_"),
            ("fuß_links_l", "fuß_links_r", "fuß_links"),
        ] {
            let found = pairs(&[right, left]);
            assert_eq!(found, [(left.to_owned(), right.to_owned(), stem.to_owned())]);
        }
    }

    #[test]
    fn other_names_are_no_sides() {
        let long = ["l", "r"].map(|side| format!("{side}_").repeat(150));
        assert!(pairs(&long.each_ref().map(String::as_str)).is_empty());
        assert!(pairs(&["L5", "R5x", "pelvis", "leftover", "Lamp", "éa", "l", "left"]).is_empty());
    }

    #[test]
    fn who_stands_alone_is_named_with_the_one_that_is_missing() {
        let alone = |names: &[&str]| {
            let figure = figure(names);
            singles(&figure.links, &mates(&figure.links))
                .into_iter()
                .map(|(_, other)| other)
                .collect::<Vec<_>>()
        };
        assert_eq!(alone(&["left_hand"]), ["right_hand"]);
        assert_eq!(alone(&["foot_r", "toes"]), Vec::<String>::new());
        assert_eq!(alone(&["foot_r", "hand_l", "hand_r"]), ["foot_l"]);
        assert_eq!(alone(&["leftover", "hand_l", "hand_r"]), Vec::<String>::new());
    }
}
