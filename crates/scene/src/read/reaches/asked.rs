//! What is asked of links: to reach, to look, to be held as they are; as it is written.

use super::beforehand::carriers;
use crate::read::SceneReader;
use crate::read::apart::APART;
use crate::read::names::matches;
use nalgebra::{Unit, UnitQuaternion, Vector3};
use solaris_model::text::{Fields, Node, ReadSpatial as _, Value};
use std::ops::Range;

pub(super) const EXAMPLE: &str = "[Reach(tip: \"right_hand\", by: [\"right_shoulder\", \"right_elbow\"], to: (-0.2, 1.2, 0.4), over: 0.8)]";
const KINDS: [&str; 3] = ["Reach", "Look", "Hold"];
const FOLLOW: &str = "Follow(link: \"left_hand\", at: (0, -0.1, 0))";

/// The longest that a link may take to where it is to be (s).
const LONGEST: f64 = 600.0;

/// One thing that is asked of a link.
pub(super) struct Asked {
    pub(super) place: Range<usize>,
    pub(super) name: String,
    pub(super) link: usize,
    /// The point that reaches, or looks, in the link's frame (m).
    pub(super) point: Vector3<f64>,
    pub(super) by: Vec<usize>,
    /// When it begins, and in what time it is there (s).
    pub(super) from: f64,
    pub(super) over: f64,
    /// When it is given up, and in what time the joints go back to what they would otherwise do (s).
    pub(super) until: f64,
    pub(super) back: f64,
    /// How much of it the joints take over, 0 to 1.
    pub(super) weight: f64,
    /// How far apart its joints keep links (m).
    pub(super) clearance: f64,
    pub(super) what: What,
}

/// What is asked.
#[derive(Clone)]
pub(super) enum What {
    /// To be at a spot.
    Reach(Spot),
    /// To be at places at times since it began (s, m).
    Along(Vec<(f64, Vector3<f64>)>),
    /// To turn an axis of the link towards a spot.
    Look(Unit<Vector3<f64>>, Spot),
    /// To be turned against the world in a way, or as it is when that begins.
    Hold(Option<UnitQuaternion<f64>>),
}

/// Where something is.
#[derive(Clone, Copy)]
pub(super) enum Spot {
    /// At a place (m, world).
    Place(Vector3<f64>),
    /// At a point (m) of a link.
    Of(usize, Vector3<f64>),
}

impl What {
    /// The link that is followed.
    pub(super) fn followed(&self) -> Option<usize> {
        match self {
            Self::Reach(Spot::Of(link, _)) | Self::Look(_, Spot::Of(link, _)) => Some(*link),
            _ => None,
        }
    }

    /// Whether a point is to be somewhere, which has a way to it.
    pub(super) fn is_of_a_place(&self) -> bool {
        matches!(self, Self::Reach(_) | Self::Along(_))
    }

    /// What is done, and the unit of what may be missing, with how many of it are one m or rad.
    pub(super) fn verb(&self) -> (&'static str, &'static str, f64) {
        match self {
            Self::Reach(_) | Self::Along(_) => ("reach all of its way", "mm", 1e3),
            Self::Look(..) => ("look where it should all of the time", "°", 1f64.to_degrees()),
            Self::Hold(_) => ("be held as it should all of the time", "°", 1f64.to_degrees()),
        }
    }
}

/// Whether the tip is a pattern.
fn is_pattern(fields: &Fields<'_, '_>) -> bool {
    fields.get("tip").is_some_and(|node| matches!(&node.value, Value::Text(name) if name.contains('*')))
}

fn known(kind: &str) -> &'static [&'static str] {
    match kind {
        "Look" => &["tip", "at", "axis", "by", "to", "over", "from", "until", "back", "weight", "clearance"],
        "Hold" => &["tip", "by", "turned", "over", "from", "until", "back", "weight", "clearance"],
        _ => &["tip", "at", "by", "to", "along", "over", "from", "until", "back", "weight", "clearance"],
    }
}

impl SceneReader<'_> {
    /// `Reach(tip: "right_hand", …)`, `Look(tip: "head", …)` or `Hold(tip: "right_hand", …)`; of each link that a pattern means.
    pub(super) fn asked(&mut self, node: &Node<'_>) -> Option<Vec<Asked>> {
        let before = self.reader.count();
        let kind = self.reader.kind(node, &KINDS)?;
        let fields = self.reader.fields(node, &KINDS, known(kind))?;
        let tip = self.reader.required(&fields, "tip", "\"right_hand\"");
        let tips = tip.and_then(|node| self.named_links(node));
        let at = fields.get("at").map_or(Some(Vector3::zeros()), |node| {
            self.reader
                .vector(node, if kind == "Look" { "the point that looks" } else { "the point that reaches" })
        });
        let by = self.asked_by(&fields);
        let from = self.time_of(fields.get("from"), "from", 0.0);
        let what = self.what(kind, &fields);
        let over = match &what {
            Some(What::Along(keys)) => keys.last().map(|(time, _)| *time),
            Some(_) => self.over(kind, &fields, from),
            // What is at fault there has been said.
            None => None,
        };
        let (until, back) = self.given_up(&fields, from, over);
        let weight = fields.get("weight").map_or(Some(1.0), |node| self.weight(node));
        let clearance = self.apart(&fields, APART);
        if self.reader.count() > before {
            return None;
        }
        let clearance = clearance?;
        let (place, point, from, over, what) = (node.place(), at?, from?, over?, what?);
        let (until, back, weight) = (until?, back?, weight?);
        let tips = tips?;
        let figure = self.figure()?;
        let of = |(name, link): (String, usize)| {
            let mut by = by.clone();
            if is_pattern(&fields) {
                // Each by its own joints.
                let carriers = carriers(figure, link);
                by.retain(|dof| carriers.contains(dof));
            }
            let (place, what) = (place.clone(), what.clone());
            Asked { place, name, link, point, by, from, over, until, back, weight, clearance, what }
        };
        Some(tips.into_iter().map(of).collect())
    }

    /// A link by its name, or several by a pattern.
    fn named_links(&mut self, node: &Node<'_>) -> Option<Vec<(String, usize)>> {
        let Value::Text(name) = &node.value else { return self.named_link(node).map(|one| vec![one]) };
        if !name.contains('*') {
            return self.named_link(node).map(|one| vec![one]);
        }
        let figure = self.figure()?;
        let links = figure.links().iter().enumerate().filter(|(_, link)| matches(name, link.name()));
        let found: Vec<(String, usize)> = links.map(|(i, link)| (link.name().to_owned(), i)).collect();
        if found.is_empty() {
            let message = format!("no link of figure '{}' is called like '{name}'", figure.name());
            self.reader.fault(node.span.clone(), message);
            return None;
        }
        Some(found)
    }

    /// A link by its name.
    fn named_link(&mut self, node: &Node<'_>) -> Option<(String, usize)> {
        let name = self.reader.name(node, "the name of a link")?;
        Some((name.to_owned(), self.link(node, name, None)?))
    }

    /// `by: ["right_shoulder", "right_elbow.rx"]`
    fn asked_by(&mut self, fields: &Fields<'_, '_>) -> Vec<usize> {
        let example = "[\"right_shoulder\", \"right_elbow\"]";
        let node = self.reader.required(fields, "by", example);
        let items = node.and_then(|node| self.reader.items(node, "by", example)).unwrap_or_default();
        let mut dofs = Vec::new();
        for item in items {
            let Some(meant) = self.meant(item).map(|meant| self.leaders(meant)) else { continue };
            if let Some((_, why)) = meant.dofs.iter().find_map(|dof| Some((dof, self.moves_otherwise(*dof)?)))
            {
                self.reader.fault(item.span.clone(), why);
            }
            dofs.extend(meant.dofs);
        }
        dofs.sort_unstable();
        dofs.dedup();
        dofs
    }

    fn what(&mut self, kind: &str, fields: &Fields<'_, '_>) -> Option<What> {
        match kind {
            "Look" => {
                let axis = match fields.get("axis") {
                    Some(node) => self.reader.direction(node).map(Unit::new_normalize),
                    None => Some(Vector3::z_axis()),
                };
                let to = self.reader.required(fields, "to", "(0, 1.5, 3)");
                let to = to.and_then(|node| self.spot(node, "the place to look at"));
                Some(What::Look(axis?, to?))
            }
            "Hold" => match fields.get("turned") {
                Some(node) => self.reader.rotation(node).map(|turned| What::Hold(Some(turned))),
                None => Some(What::Hold(None)),
            },
            _ => self.reached(fields),
        }
    }

    /// `to: (x, y, z)`, or `to: Follow(…)`, or `along: [(0.4, (x, y, z)), (0.8, (x, y, z)), …]`
    fn reached(&mut self, fields: &Fields<'_, '_>) -> Option<What> {
        match (fields.get("to"), fields.get("along")) {
            (Some(to), None) => self.spot(to, "the place to reach").map(What::Reach),
            (None, Some(along)) => self.places_along(along).map(What::Along),
            (to, _) => {
                let what = if to.is_some() { "both; keep one of them" } else { "neither" };
                let message = format!(
                    "a reach goes to a place, to: (x, y, z), over: 0.8, or along: [(0.4, (x, y, z)), …]; this has {what}"
                );
                self.reader.fault(to.map_or(fields.at.clone(), Node::place), message);
                None
            }
        }
    }

    /// `(x, y, z)`, or a point that moves: `Follow("left_hand")`, `Follow(link: "left_hand", at: (x, y, z))`
    fn spot(&mut self, node: &Node<'_>, what: &str) -> Option<Spot> {
        if node.head().is_none() {
            return self.reader.vector(node, what).map(Spot::Place);
        }
        self.reader.kind(node, &["Follow"])?;
        let (link, at) = match node.tuple() {
            Some([link]) => (link, None),
            Some([link, at]) => (link, Some(at)),
            Some(_) => {
                self.reader.fault(node.place(), format!("a point that is followed is {FOLLOW}"));
                return None;
            }
            None => {
                let fields = self.reader.fields(node, &["Follow"], &["link", "at"])?;
                (self.reader.required(&fields, "link", "\"left_hand\"")?, fields.get("at"))
            }
        };
        let link = self.named_link(link);
        let at =
            at.map_or(Some(Vector3::zeros()), |node| self.reader.vector(node, "the point that is followed"));
        Some(Spot::Of(link?.1, at?))
    }

    /// `[(0.4, (x, y, z)), (0.8, (x, y, z)), …]`
    fn places_along(&mut self, along: &Node<'_>) -> Option<Vec<(f64, Vector3<f64>)>> {
        let example = "[(0.4, (0, 1, 0.3)), (0.8, (0.2, 1, 0.3))]";
        let mut keys: Vec<(f64, Vector3<f64>)> = Vec::new();
        for item in self.reader.items(along, "along", example)? {
            let Some([time, place]) = item.items() else {
                let message = format!("a place on the way is (time, (x, y, z)), not {}", item.describe());
                self.reader.fault(item.place(), message);
                continue;
            };
            let read = self.reader.number(time, "the time of a place");
            let place = self.reader.vector(place, "a place on the way");
            let (Some(at), Some(place)) = (read, place) else { continue };
            let last = keys.last().map_or(0.0, |(time, _)| *time);
            if !(at.is_finite() && at > last) {
                let message = format!("times of places rise from 0 on; {at} comes after {last}");
                self.reader.fault(time.span.clone(), message);
            }
            keys.push((at, place));
        }
        match keys.last() {
            None => {
                self.reader.fault(along.place(), format!("there is no place on the way; write {example}"));
            }
            Some((time, _)) if *time > LONGEST => self.too_long(along, *time),
            Some(_) => {}
        }
        Some(keys)
    }

    fn too_long(&mut self, node: &Node<'_>, time: f64) {
        let message = format!("a reach takes {LONGEST} s at most; this takes {time} s");
        self.reader.fault(node.place(), message);
    }

    /// In what time it is there (s). What looks or is held from the beginning of the run on may begin there.
    fn over(&mut self, kind: &str, fields: &Fields<'_, '_>, from: Option<f64>) -> Option<f64> {
        let Some(node) = fields.get("over") else {
            if kind == "Reach" {
                self.reader.required(fields, "over", "0.8");
                return None;
            }
            if from.is_some_and(|from| from > 0.0) {
                let message = format!(
                    "this {kind} has no over; add over: 0.5, the time in which it goes over into it. Only what begins with the run begins there"
                );
                self.reader.fault(fields.at.clone(), message);
            }
            return Some(0.0);
        };
        let over = self.reader.positive(node, "the time to be there", "s")?;
        if over > LONGEST {
            self.too_long(node, over);
        }
        Some(over)
    }

    /// The fields `until` and `back`.
    fn given_up(
        &mut self,
        fields: &Fields<'_, '_>,
        from: Option<f64>,
        over: Option<f64>,
    ) -> (Option<f64>, Option<f64>) {
        let until = self.time_of(fields.get("until"), "until", f64::INFINITY);
        let back = fields.get("back");
        let taken = back.map(|node| self.reader.positive(node, "the time to go back", "s"));
        let (Some(end), Some(from), Some(over)) = (until, from, over) else {
            return (until, taken.unwrap_or(over));
        };
        match fields.get("until") {
            None => {
                if let Some(node) = back {
                    let message = "it goes back after 'until'; add until: 2.0, or leave 'back' out";
                    self.reader.fault(node.span.clone(), message);
                }
            }
            Some(node) if end < from + over => {
                let message =
                    format!("until is {end}; it must be after it is there, at {} s or later", from + over);
                self.reader.fault(node.span.clone(), message);
            }
            Some(node) if back.is_none() && over <= 0.0 => {
                let message = "in what time does it go back? Add back: 0.5";
                self.reader.fault(node.span.clone(), message);
            }
            Some(_) => {}
        }
        (until, taken.unwrap_or(Some(over)))
    }

    fn weight(&mut self, node: &Node<'_>) -> Option<f64> {
        let weight = self.reader.number(node, "the weight")?;
        if (0.0..=1.0).contains(&weight) {
            return Some(weight);
        }
        let message = format!("the weight is {weight}; it must be from 0, nothing of it, to 1, all of it");
        self.reader.fault(node.span.clone(), message);
        None
    }

    /// A time of the run (s).
    fn time_of(&mut self, node: Option<&Node<'_>>, what: &str, without: f64) -> Option<f64> {
        let Some(node) = node else { return Some(without) };
        let time = self.reader.number(node, what)?;
        if time.is_finite() && time >= 0.0 {
            return Some(time);
        }
        let message = format!("{what} is {time}; it must be a finite time, zero or more (s)");
        self.reader.fault(node.span.clone(), message);
        None
    }
}
