//! Setup files of OpenSim's tools for markers: what to weigh, what to measure.

mod scale;
mod tasks;

pub use scale::{BodyAxes, ManualScale, Measurement, PlacerSetup, ScaleSetup, ScalingStep, scale_setup};
pub use tasks::{CoordinateTask, IkSetup, MarkerTask, TaskValue, ik_setup};

use super::element::{child_words, words_at};
use crate::xml::{Node, Reader, element, tag};

/// The name of a file; nothing where there is none.
fn file(node: Node, name: &str) -> Option<String> {
    child_words(node, name).filter(|told| !told.eq_ignore_ascii_case("unassigned")).map(str::to_owned)
}

/// A time range (s), as far as it is one.
fn time_range(reader: &mut Reader, node: Node) -> Option<(f64, f64)> {
    let child = element(node, "time_range")?;
    let told = super::words(child);
    let of = |word: &str| match word.trim_start_matches(['+', '-']).to_ascii_lowercase().as_str() {
        "inf" | "infinity" => Some(if word.starts_with('-') { f64::NEG_INFINITY } else { f64::INFINITY }),
        _ => word.parse().ok().filter(|x: &f64| !x.is_nan()),
    };
    if told.is_empty() {
        return None;
    }
    let times: Option<Vec<f64>> = told.split_whitespace().map(of).collect();
    match times.as_deref() {
        Some(&[from, to]) if from <= to => Some((from, to)),
        _ => {
            let message = format!("<time_range> is '{told}'; it must be two times, the earlier one first");
            reader.fault(words_at(child), message);
            None
        }
    }
}

/// The element that holds a tool, called `name`: the root, or its child.
fn tool<'a>(root: Node<'a>, name: &str) -> Option<Node<'a>> {
    if root.tag_name().name() == name { Some(root) } else { element(root, name) }
}

/// What a document holds instead of what it should.
fn held(root: Node) -> String {
    let found = crate::xml::elements(root).next().unwrap_or(root);
    format!("<{}>", found.tag_name().name())
}

/// The place of a child, or of its parent where it is not there.
fn place(node: Node, child: &str) -> std::ops::Range<usize> {
    element(node, child).map_or_else(|| tag(node), words_at)
}
