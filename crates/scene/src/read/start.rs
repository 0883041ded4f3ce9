//! The state at the beginning.

use super::SceneReader;
use super::drives::Given;
use super::names::{Closeness, Meant, in_order};
use super::walk::Planned;
use solaris_model::text::{Fields, Node, ReadSpatial as _};
use solaris_model::{JointKind, JointLayout};
use std::ops::Range;

const EXAMPLE: &str = "{\"elbow.rx\": deg(30), \"hip\": About(axis: (0, 1, 0), angle: deg(30))}";
/// What a quaternion's length may miss by because it was written with few digits.
const FEW_DIGITS: f64 = 1e-3;

/// Numbers to put into `q`, from an index on.
type Numbers = Vec<(usize, f64)>;

impl SceneReader<'_> {
    /// Sets the state: the walk's where there is one, then that of curves at their beginning, then what is said.
    pub(super) fn start(&mut self, fields: &Fields<'_, '_>, given: &Given, walk: Option<&Planned>) {
        let before = self.reader.count();
        let (mut q, mut v) = self.simulation.as_ref().map_or_else(Default::default, |simulation| {
            let (q, v) = simulation.state();
            (q.to_vec(), v.to_vec())
        });
        if let Some(walk) = walk {
            let (first_q, first_v) = walk.first();
            q.copy_from_slice(first_q);
            v.copy_from_slice(first_v);
        }
        for (dof, (position, velocity)) in
            given.iter().filter_map(|(dof, steps)| Some((*dof, Self::begins(steps)?)))
        {
            let coordinate = self.figure().and_then(|figure| figure.layout().coordinate(dof));
            if let Some(coordinate) = coordinate {
                (q[coordinate], v[dof]) = (position, velocity);
            }
        }
        let place = fields.get("start").map_or(fields.at.clone(), Node::place);
        let entries = self.map(fields, "start", EXAMPLE);
        let mut positions = Vec::new();
        for (key, value) in entries {
            if let Some(found) = self.position(key, value) {
                positions.push(found);
            }
        }
        self.twice(entries, &positions);
        for (_, numbers) in in_order(positions) {
            for (index, value) in numbers {
                q[index] = value;
            }
        }
        self.check_quaternions(entries, &mut q);
        self.velocities(fields, &mut v);
        if self.reader.count() > before {
            return;
        }
        if let Some(simulation) = &mut self.simulation {
            let result = simulation.set_start(&q, &v);
            self.setup(&place, result);
        }
    }

    /// Where one entry puts which numbers.
    fn position(&mut self, key: &Node<'_>, value: &Node<'_>) -> Option<(Meant, Numbers)> {
        if let Some(index) = self.part_of_quaternion(key) {
            let value = self.reader.number(value, "a part of a quaternion")?;
            // Apart from the degrees of freedom, whose numbers are fewer.
            let meant = Meant { dofs: vec![usize::MAX - index], closeness: Closeness::Dof, joint: None };
            return Some((meant, vec![(index, value)]));
        }
        let Some(meant) = self.meant(key) else {
            // Faults of the value are found without a figure too.
            if self.figure().is_none()
                && value.head().is_none_or(|head| head.name == "deg")
                && value.items().is_none()
            {
                self.reader.angle(value, "a position");
            }
            return None;
        };
        let figure = self.figure()?;
        if let Some(joint) = meant.joint {
            let (at, kind) = (figure.layout().joints()[joint], figure.links()[joint].joint().kind().clone());
            match kind {
                JointKind::Ball { .. } => {
                    let numbers = self.quaternion(value, at.q)?;
                    return Some((meant, numbers));
                }
                JointKind::Free { .. } => {
                    let numbers = self.place(value, at)?;
                    return Some((meant, numbers));
                }
                _ => {}
            }
        }
        let layout = figure.layout();
        let coordinates: Option<Vec<usize>> = meant.dofs.iter().map(|dof| layout.coordinate(*dof)).collect();
        let Some(coordinates) = coordinates else {
            let message = "a ball or free joint starts with a rotation: \"hip\": About(axis: (0, 1, 0), angle: deg(30)), or \
                           \"root\": (at: (0, 1, 0), turned: About(…))";
            self.reader.fault(key.span.clone(), message);
            return None;
        };
        let turns = self.names.turn(Some(&meant));
        let value = self.reader.coordinate(value, turns, "the position")?;
        Some((meant, coordinates.into_iter().map(|coordinate| (coordinate, value)).collect()))
    }

    /// Index in `q` of an entry of a ball or free joint.
    fn part_of_quaternion(&self, key: &Node<'_>) -> Option<usize> {
        let solaris_model::text::Value::Text(name) = &key.value else { return None };
        let layout = self.figure()?.layout();
        let index = layout.q_names().iter().position(|known| known == name)?;
        layout.dof_index(name).is_none().then_some(index)
    }

    /// A rotation as four numbers from `q` on.
    fn quaternion(&mut self, value: &Node<'_>, q: usize) -> Option<Numbers> {
        let rotation = self.reader.rotation(value)?;
        Some(rotation.coords.iter().enumerate().map(|(i, part)| (q + i, *part)).collect())
    }

    /// `(at: (x, y, z), turned: ROTATION)`
    fn place(&mut self, value: &Node<'_>, at: JointLayout) -> Option<Numbers> {
        let before = self.reader.count();
        let fields = self.reader.fields(value, &["Place"], &["at", "turned"])?;
        let place = self.reader.placement(&fields);
        let point = place.translation.vector.iter().enumerate().map(|(i, x)| (at.q + i, *x));
        let turned = place.rotation.coords.iter().enumerate().map(|(i, part)| (at.q + 3 + i, *part));
        (self.reader.count() == before).then(|| point.chain(turned).collect())
    }

    /// Finds entries that say the same thing twice.
    pub(super) fn twice<T>(&mut self, entries: &[(Node<'_>, Node<'_>)], found: &[(Meant, T)]) {
        if entries.len() != found.len() {
            return;
        }
        let mut spans: Vec<(&Meant, Range<usize>)> = Vec::new();
        for ((key, _), (meant, _)) in entries.iter().zip(found) {
            if meant.closeness == Closeness::Pattern {
                continue;
            }
            if spans.iter().any(|(other, _)| other.dofs == meant.dofs && other.closeness == meant.closeness) {
                self.reader.fault(key.span.clone(), "this is said twice; keep one of them");
            }
            spans.push((meant, key.span.clone()));
        }
    }

    /// Refuses quaternions that are no rotations, at the first entry that may have made them so, and gives the others the
    /// length 1.
    fn check_quaternions(&mut self, entries: &[(Node<'_>, Node<'_>)], q: &mut [f64]) {
        let Some(figure) = self.figure() else { return };
        let mut bad = Vec::new();
        for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
            let Some(first) = link.joint().kind().quaternion().map(|first| at.q + first) else { continue };
            let parts = &mut q[first..first + 4];
            let length = parts.iter().map(|x| x * x).sum::<f64>().sqrt();
            if (length - 1.0).abs() > FEW_DIGITS {
                bad.push((link.joint().name().to_owned(), length));
            }
        }
        for (joint, length) in bad {
            let begins = format!("{joint}.q");
            let is_part = |key: &Node<'_>| matches!(&key.value, solaris_model::text::Value::Text(name) if name.starts_with(&begins));
            let place =
                entries.iter().find(|(key, _)| is_part(key)).map_or(0..0, |(key, _)| key.span.clone());
            let message = format!(
                "the quaternion of '{joint}' has the length {length}, and must have 1; all four parts count"
            );
            self.reader.fault(place, message);
        }
    }
}
