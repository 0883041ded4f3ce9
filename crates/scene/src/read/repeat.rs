//! Drives one after the other, some of them several times.

use super::SceneReader;
use super::drives::Placed;
use solaris_model::text::{Content, Node};
use std::ops::Range;

const EXAMPLE: &str = "[Move(to: 1, over: 0.5), Move(to: 0, over: 0.5)]";

/// The most drives that one degree of freedom can have.
const MOST: usize = 100_000;

/// The most drives that repeats and patterns can make of those that are written, in a scene.
const MOST_MADE: usize = 300_000;

/// Drives one after the other.
#[derive(Clone, Default)]
pub(super) struct Sequence {
    pub(super) steps: Vec<Placed>,
    /// With which of them it goes on after the last one, if it has no end.
    pub(super) again: Option<usize>,
}

impl SceneReader<'_> {
    /// `DRIVE`, or `[DRIVE, …]`.
    pub(super) fn sequence(&mut self, node: &Node<'_>, turns: bool) -> Sequence {
        let mut found = Sequence::default();
        let Some(Content::List(items)) = node.group().map(|group| &group.content) else {
            self.one(node, turns, &mut found);
            return found;
        };
        if items.is_empty() {
            self.reader.fault(
                node.span.clone(),
                "there is no drive in the list; write [Free] or leave the entry out",
            );
        }
        for item in items {
            if found.again.is_some() {
                let message =
                    "nothing comes after what is repeated without end; say how many times, or put it last";
                self.reader.fault(item.place(), message);
                break;
            }
            self.one(item, turns, &mut found);
        }
        found
    }

    /// One drive, or several times some.
    fn one(&mut self, node: &Node<'_>, turns: bool, found: &mut Sequence) {
        if node.head().is_none_or(|head| head.name != "Repeat") {
            found.steps.extend(self.step(node, turns));
            return;
        }
        let before = self.reader.count();
        let (inner, times) = if let Some([list]) = node.tuple() {
            (self.sequence(list, turns), None)
        } else {
            let Some(fields) = self.reader.fields(node, &["Repeat"], &["of", "times"]) else { return };
            let list = self.reader.required(&fields, "of", EXAMPLE);
            let inner = list.map(|list| self.sequence(list, turns)).unwrap_or_default();
            let times = fields.get("times").map(|node| (node.span.clone(), self.times(node)));
            if let (Some((span, _)), Some(_)) = (&times, inner.again) {
                let message = "what is repeated in here has no end; say how many times there";
                self.reader.fault(span.clone(), message);
            }
            (inner, times)
        };
        if self.reader.count() > before || inner.steps.is_empty() {
            return;
        }
        let first = found.steps.len();
        let Some((span, times)) = times else {
            found.again = Some(first + inner.again.unwrap_or(0));
            found.steps.extend(inner.steps);
            return;
        };
        let times = times.unwrap_or(1);
        let made = times.saturating_mul(inner.steps.len());
        if made.saturating_add(found.steps.len()) > MOST {
            let message =
                format!("that comes to more than {MOST} drives; leave 'times' out to repeat without end");
            self.reader.fault(span, message);
            return;
        }
        if !self.make(span, made) {
            return;
        }
        for _ in 0..times {
            found.steps.extend(inner.steps.iter().cloned());
        }
    }

    /// Whether so many more drives may be made of what stands at a place; a fault where they may not.
    pub(super) fn make(&mut self, span: Range<usize>, count: usize) -> bool {
        self.made = self.made.saturating_add(count);
        let is_within = self.made <= MOST_MADE;
        if !is_within {
            let message = format!(
                "all that is repeated comes to more than {MOST_MADE} drives in this scene; leave 'times' out to repeat without end"
            );
            self.reader.fault(span, message);
        }
        is_within
    }

    fn times(&mut self, node: &Node<'_>) -> Option<usize> {
        let times = self.reader.number(node, "the times")?;
        if times >= 1.0 && times <= MOST as f64 && times.fract() == 0.0 {
            return Some(times as usize);
        }
        let message =
            format!("'times' is {times}; it must be a whole number from 1 to {MOST}, or be left out");
        self.reader.fault(node.span.clone(), message);
        None
    }
}
