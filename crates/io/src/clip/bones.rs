//! What readers of bones share: names that differ, lengths, and what there is to say.

use super::masses::Length;
use solaris_model::rig::Bone;
use solaris_model::{Finding, FindingKind, Place, Vector3};
use std::collections::{HashMap, HashSet};
use std::ops::Range;

/// What there is to say.
pub(crate) struct Said<'a> {
    /// The text that places are in; empty for a file that is none.
    pub(crate) text: &'a str,
    pub(crate) findings: Vec<Finding>,
}

impl Said<'_> {
    pub(crate) fn say(
        &mut self,
        kind: FindingKind,
        subject: impl Into<String>,
        message: String,
        span: Option<Range<usize>>,
    ) {
        let place = span.map(|span| Place::of(self.text, span));
        self.findings.push(Finding { kind, subject: subject.into(), message, place });
    }
}

/// The most joints that are said one by one to have other names.
const MOST_RENAMED: usize = 100;

/// Names of links and joints: those of the file, made different, without blanks. `what` they are there.
pub(crate) fn names(what: &str, raw: &[(&str, Option<Range<usize>>)], said: &mut Said) -> Vec<String> {
    let mut taken: HashSet<String> = HashSet::new();
    // How often a stem was tried, so that a thousand joints of one name are no million tries.
    let mut tried: HashMap<String, usize> = HashMap::new();
    let mut names = Vec::with_capacity(raw.len());
    let mut renamed = 0;
    for (raw, span) in raw {
        let words: Vec<&str> = raw.split_whitespace().collect();
        let stem = if words.is_empty() { what.to_owned() } else { words.join("_") };
        let mut name = stem.clone();
        let count = tried.entry(stem.clone()).or_insert(1);
        while !taken.insert(name.clone()) {
            *count += 1;
            name = format!("{stem}_{count}");
        }
        renamed += usize::from(name != *raw);
        if name != *raw && renamed <= MOST_RENAMED {
            let message = format!("it is called '{name}' here: names differ and have no blanks");
            said.say(FindingKind::Note, format!("{what} '{raw}'"), message, span.clone());
        }
        names.push(name);
    }
    if renamed > MOST_RENAMED {
        let more = renamed - MOST_RENAMED;
        let message = format!("{more} more are called otherwise here: names differ and have no blanks");
        said.say(FindingKind::Note, format!("{what}s"), message, None);
    }
    names
}

/// A joint's parent, where the joint is in it and where its bone ends (m), if the file says that.
pub(crate) type Told = (Option<usize>, Vector3<f64>, Option<Vector3<f64>>);

/// The bones of joints told by their parent, where they are in it and where they end (m): from each joint to the next of its body, to
/// the middle of several, or to its end.
pub(crate) fn lengths(joints: &[Told], segments: &[Option<Bone>]) -> Vec<Length> {
    let mut children = vec![Vec::new(); joints.len()];
    for (i, (parent, _, _)) in joints.iter().enumerate() {
        if let Some(parent) = *parent {
            children[parent].push(i);
        }
    }
    let along = |i: usize| {
        // Helpers turn with a bone and do not end it.
        let own: Vec<usize> =
            children[i].iter().copied().filter(|child| segments[*child].is_some()).collect();
        let ends = if own.is_empty() { &children[i] } else { &own };
        let middle = ends.iter().map(|child| joints[*child].1).sum::<Vector3<f64>>();
        if ends.is_empty() { joints[i].2.unwrap_or_default() } else { middle / ends.len() as f64 }
    };
    (0..joints.len()).map(|i| Length { parent: joints[i].0, along: along(i), bone: segments[i] }).collect()
}
