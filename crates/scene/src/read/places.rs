//! Where the figures of a scene stand: in the world, or beside one another.

use super::SceneReader;
use nalgebra::{Unit, UnitQuaternion, Vector3};
use solaris_model::text::{ExpectedKind, Fields, Node, ReadSpatial as _};
use solaris_model::{Placement, nearest};
use std::collections::HashMap;
use std::ops::Range;

const EXAMPLE: &str = "{\"bob\": (beside: \"ann\", at: (0, 0, 1.5), facing: deg(180))}";

/// The most names of figures that a message tells.
const MOST_TOLD: usize = 8;

/// A figure of a scene, or some people of a crowd: its own place in that, or none.
pub(super) struct Member {
    pub(super) name: String,
    /// The crowd, and the place in it.
    pub(super) crowd: Option<(String, Placement)>,
}

/// What a scene says of a place.
struct Said<'n> {
    span: Range<usize>,
    own: Placement,
    beside: Option<&'n str>,
    /// How the figure is turned there, which those beside it are not.
    turned: Option<UnitQuaternion<f64>>,
}

impl SceneReader<'_> {
    /// The places of the members, `{"bob": (at: (0, 0, 1.5), facing: deg(180))}`: an angle about the direction against gravity, to the left;
    /// both as `beside` has them, where that is said, and the figure itself `turned` there, any way, or as its own `stands` beside the others.
    pub(super) fn places(
        &mut self,
        fields: &Fields<'_, '_>,
        members: &[Member],
        up: &Unit<Vector3<f64>>,
        stands: &[UnitQuaternion<f64>],
    ) -> Vec<Placement> {
        let mut said: HashMap<&str, Said<'_>> = HashMap::new();
        let crowds =
            members.iter().filter_map(|member| member.crowd.as_ref().map(|(crowd, _)| crowd.as_str()));
        let names: Vec<&str> = crowds.chain(members.iter().map(|member| member.name.as_str())).collect();
        if let Some(node) = fields.get("places") {
            for (key, value) in self.reader.entries(node, "places", EXAMPLE).unwrap_or_default() {
                let name = self.known_figure(key, &names);
                let place = self.one_place(value, &names, up);
                let (Some(name), Some(place)) = (name, place) else { continue };
                if said.insert(name, Said { span: key.span.clone(), ..place }).is_some() {
                    self.reader.fault(key.span.clone(), format!("'{name}' has two places; keep one of them"));
                }
            }
        }
        let places = Places { members, said };
        let mut round: Vec<(Range<usize>, String)> = places.rounds();
        round.sort_by_key(|(span, _)| span.start);
        if round.is_empty() {
            let mut found = Vec::with_capacity(members.len());
            for (Member { name, .. }, stands) in members.iter().zip(stands) {
                let turned = places.said.get(name.as_str()).and_then(|said| said.turned);
                if turned.is_none() && *stands != UnitQuaternion::identity() {
                    self.stood.push(format!(
                        "'{name}' is stood upright, for in its file another way is up than in the scene; places: {{\"{name}\": (turned: …)}} turns it \
                         otherwise"
                    ));
                }
                found.push(places.of(name) * turned.unwrap_or(*stands));
            }
            return found;
        }
        for (span, message) in round {
            self.reader.fault(span, message);
        }
        vec![Placement::identity(); members.len()]
    }

    fn one_place<'n>(
        &mut self,
        value: &'n Node<'_>,
        names: &[&str],
        up: &Unit<Vector3<f64>>,
    ) -> Option<Said<'n>> {
        let place = self.reader.fields(value, &["Place"], &["at", "facing", "beside", "turned"])?;
        let at = place.get("at").map_or(Some(Vector3::zeros()), |node| self.reader.vector(node, "at"));
        let facing = place.get("facing").map_or(Some(0.0), |node| self.reader.angle(node, "facing"));
        let beside = place.get("beside").map(|node| self.known_figure(node, names));
        let turned = place.get("turned").map(|node| self.reader.rotation(node));
        let own = Placement::from_parts(at?.into(), UnitQuaternion::from_axis_angle(up, facing?));
        Some(Said {
            span: value.span.clone(),
            own,
            beside: beside.map_or(Some(None), |beside| beside.map(Some))?,
            turned: turned.map_or(Some(None), |turned| turned.map(Some))?,
        })
    }

    fn known_figure<'n>(&mut self, node: &'n Node<'_>, names: &[&str]) -> Option<&'n str> {
        let name = self.reader.name(node, "the name of a figure")?;
        self.reader.expect(&node.span, ExpectedKind::Name, "figure", names.iter().copied());
        if names.contains(&name) {
            return Some(name);
        }
        self.no_figure(node, name, names);
        None
    }

    /// Says that there is no figure of this name, and which there are where none is near.
    pub(super) fn no_figure(&mut self, node: &Node<'_>, name: &str, names: &[&str]) {
        let others = if nearest(name, names.iter().copied()).is_none() {
            let more = if names.len() > MOST_TOLD { ", …" } else { "" };
            format!("; there are {}{more}", names[..names.len().min(MOST_TOLD)].join(", "))
        } else {
            String::new()
        };
        let message = format!("there is no figure '{name}'{others}");
        self.reader.unknown_name(node.span.clone(), &message, name, names.iter().copied());
    }
}

/// What is said of all places.
struct Places<'m, 'n> {
    members: &'m [Member],
    said: HashMap<&'n str, Said<'n>>,
}

impl Places<'_, '_> {
    /// The place of a figure or crowd in the world; none goes round.
    fn of(&self, name: &str) -> Placement {
        if let Some(Said { own, beside, .. }) = self.said.get(name) {
            return beside.map_or(*own, |other| self.of(other) * own);
        }
        self.crowd_of(name).map_or_else(Placement::identity, |(crowd, within)| self.of(crowd) * within)
    }

    fn crowd_of(&self, name: &str) -> Option<&(String, Placement)> {
        self.members.iter().find(|member| member.name == name)?.crowd.as_ref()
    }

    /// What a place depends on.
    fn next(&self, name: &str) -> Option<&str> {
        match self.said.get(name) {
            Some(said) => said.beside,
            None => self.crowd_of(name).map(|(crowd, _)| crowd.as_str()),
        }
    }

    /// Places that depend on themselves.
    fn rounds(&self) -> Vec<(Range<usize>, String)> {
        let mut found = Vec::new();
        for (name, said) in &self.said {
            let (mut at, mut path) = (self.next(name), vec![format!("'{name}'")]);
            while let Some(other) = at.filter(|_| path.len() <= self.said.len() + self.members.len()) {
                path.push(format!("'{other}'"));
                if other == *name {
                    let message = format!(
                        "{}: that goes round; give one of them a place of its own",
                        path.join(" stands beside ")
                    );
                    found.push((said.span.clone(), message));
                    break;
                }
                at = self.next(other);
            }
        }
        found
    }
}
