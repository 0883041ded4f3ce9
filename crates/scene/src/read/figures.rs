//! The figures of a scene: people, files, or written out.

use super::SceneReader;
use super::places::Member;
use crate::member::Member as OfSeveral;
use nalgebra::{Matrix3, Rotation3, Unit, UnitQuaternion, Vector3};
use solaris_model::text::{Fields, Node, read_node};
use solaris_model::{Base, Figure, Placement};

const EXAMPLE: &str = "{\"ann\": Human(height: 1.75, mass: 73.0)}";

/// How far (m) a figure may stand from the world's origin along an axis: half of how long a figure may be.
const FARTHEST: f64 = 5e8;

impl SceneReader<'_> {
    /// The figure, or all figures as one, and what the scene calls it; under this gravity, where the scene says one.
    pub(super) fn figures(
        &mut self,
        fields: &Fields<'_, '_>,
        gravity: Option<Vector3<f64>>,
    ) -> Option<(String, Figure)> {
        let node = self.reader.required(fields, "figures", EXAMPLE)?;
        let entries = self.reader.entries(node, "figures", EXAMPLE)?;
        if entries.is_empty() {
            self.reader.fault(node.place(), format!("there is no figure; write {EXAMPLE}"));
        }
        let (mut found, mut whole) = (Vec::new(), true);
        for (key, value) in entries {
            whole &= self.entry(key, value, &mut found);
        }
        let (members, found): (Vec<Member>, Vec<Figure>) = found.into_iter().unzip();
        let gravity = gravity.unwrap_or_else(|| usual_gravity(&found));
        let up = Unit::try_new(-gravity, 0.0).unwrap_or_else(Vector3::y_axis);
        let stands: Vec<UnitQuaternion<f64>> = found
            .iter()
            .map(|figure| figure.gravity().filter(|_| found.len() > 1).map(|own| stood_up(own, &up)))
            .map(Option::unwrap_or_default)
            .collect();
        let places = self.places(fields, &members, &up, &stands);
        self.gravity = gravity;
        if !whole || found.is_empty() {
            return None;
        }
        let is_beyond = |x: &f64| x.is_nan() || x.abs() > FARTHEST;
        let is_far = |place: &Placement| place.translation.vector.iter().any(is_beyond);
        if let Some((member, place)) = members.iter().zip(&places).find(|(_, place)| is_far(place)) {
            let message = format!(
                "'{}' stands {:e} m from the world's origin; it may be {:e} m at most",
                member.name,
                place.translation.vector.amax(),
                FARTHEST
            );
            self.reader.fault(fields.get("places").map_or(node.place(), Node::place), message);
            return None;
        }
        if let ([member], [figure], [place]) = (&members[..], &found[..], &places[..]) {
            if *place != Placement::identity() && fields.get("walk").is_some() {
                let message = "a walk begins at the world's origin; leave its figure out of 'places'";
                self.reader.fault(fields.get("places").map_or(node.place(), Node::place), message);
            }
            let figure = if *place == Placement::identity() { figure.clone() } else { figure.placed(place) };
            return Some((member.name.clone(), figure));
        }
        let all: Vec<(&str, &Figure, Placement)> = members
            .iter()
            .zip(&found)
            .zip(places)
            .map(|((member, figure), place)| (member.name.as_str(), figure, place))
            .collect();
        self.members = OfSeveral::all(
            all.iter().map(|(name, figure, place)| ((*name).to_owned(), (*figure).clone(), *place)),
        );
        let figure = Figure::together(&all)
            .map_err(|error| self.reader.fault(node.place(), error.to_string()))
            .ok()?;
        Some((figure.name().to_owned(), figure))
    }

    /// One entry of the figures: a figure, or a crowd of them, whose people are called by numbers. Whether all of it is there.
    fn entry(&mut self, key: &Node<'_>, value: &Node<'_>, found: &mut Vec<(Member, Figure)>) -> bool {
        let name = self.reader.name(key, "the name of a figure");
        let mut own: Vec<(Member, Figure)> = Vec::new();
        if value.head().is_some_and(|head| head.name == "Crowd") {
            let people = self.crowd(value);
            let (Some(name), Some(people)) = (name, people) else { return false };
            for (i, (figure, within)) in people.into_iter().enumerate() {
                let member =
                    Member { name: format!("{name}{}", i + 1), crowd: Some((name.to_owned(), within)) };
                own.push((member, figure));
            }
        } else {
            let figure = self.one_figure(value);
            if let Some(name) =
                name.filter(|_| figure.is_some() && value.head().is_some_and(|head| head.name == "File"))
            {
                self.ask_for_actuators(name, value);
                self.ask_for_ties(name, value);
            }
            let (Some(name), Some(figure)) = (name, figure) else { return false };
            own.push((Member { name: name.to_owned(), crowd: None }, figure));
        }
        let is_taken = |name: &str| found.iter().any(|(other, _)| other.name == name);
        if let Some((twice, _)) = own.iter().find(|(member, _)| is_taken(&member.name)) {
            let message = format!("two figures are called '{}'; give each its own name", twice.name);
            self.reader.fault(key.span.clone(), message);
            return false;
        }
        found.extend(own);
        true
    }

    fn one_figure(&mut self, node: &Node<'_>) -> Option<Figure> {
        if self.reader.kind(node, &["Human", "File", "Figure", "Crowd"])? != "File" {
            return read_node(&mut self.reader, node);
        }
        let (path, base) = match node.tuple() {
            Some([path]) => (path, Base::Fixed),
            Some(_) => {
                let message = "File(\"…\") takes the path of one file, or File(path: \"…\", base: Free)";
                self.reader.fault(node.span.clone(), message);
                return None;
            }
            None => {
                let fields = self.reader.fields(node, &["File"], &["path", "base", "actuators", "loops"])?;
                let path = self.reader.required(&fields, "path", "\"robot.urdf\"");
                let base = match self.reader.choice(&fields, "base", &["Fixed", "Floating", "Free"])? {
                    "Floating" => Base::Floating,
                    "Free" => Base::Free,
                    _ => Base::Fixed,
                };
                (path?, base)
            }
        };
        let name = self.reader.name(path, "the path of a figure")?;
        let loaded = self.loader.figure(name).map_err(|why| format!("'{name}': {why}"));
        let based = loaded.and_then(|figure| figure.on_base(base).map_err(|why| format!("'{name}': {why}")));
        based.map_err(|why| self.reader.fault(path.span.clone(), why)).ok()
    }
}

/// Gravity where the scene does not say it: that of the figures' files, but where somebody stands among them whose file says none, as people's do.
fn usual_gravity(figures: &[Figure]) -> Vector3<f64> {
    let own: Option<Vec<Vector3<f64>>> = figures.iter().map(|figure| figure.gravity().copied()).collect();
    own.and_then(|own| own.first().copied()).unwrap_or(super::GRAVITY)
}

/// How a figure with a gravity of its own is turned to stand where `up` is up: not at all where the same axis is, more or less, up for both; else so that axes
/// go round, x to z, y to x and z to y where its z is up and y is the scene's, for who has z up has x forward, and who has y up has z forward.
fn stood_up(gravity: &Vector3<f64>, up: &Unit<Vector3<f64>>) -> UnitQuaternion<f64> {
    let axis = |v: &Vector3<f64>| {
        let i = v.iamax();
        Vector3::ith(i, v[i].signum())
    };
    let (own, up) = (-axis(gravity), axis(up));
    if gravity.norm_squared() == 0.0 || own == up {
        return UnitQuaternion::identity();
    }
    let round = Rotation3::from_matrix_unchecked(Matrix3::new(0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0));
    let round = UnitQuaternion::from_rotation_matrix(&round);
    [round, round.inverse()]
        .into_iter()
        .find(|turn| (turn * own - up).norm() < 1e-9)
        .or_else(|| UnitQuaternion::rotation_between(&own, &up))
        .unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI))
}
