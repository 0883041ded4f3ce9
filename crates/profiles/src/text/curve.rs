//! Curves of every kind.

use crate::error::ProfileError;
use crate::profile::{Kind, Measure, Parameter, Profile};
use solaris_text::{ExpectedKind, Fields, Node, Reader, nearest};

/// What a curve can be.
pub(super) fn curves() -> impl Iterator<Item = &'static str> {
    Profile::KINDS.iter().map(|kind| kind.variant).chain(["Blend", "Weighted", "Sine", "Repeat"])
}

/// Reads profiles out of a tree.
pub(super) struct ProfileReader<'r> {
    pub(super) reader: &'r mut Reader,
    /// Whether what is moved turns, so that degrees make sense.
    pub(super) turns: bool,
    /// How long (s) what comes again without end has to go on, where that is known.
    pub(super) lasts: Option<f64>,
}

impl ProfileReader<'_> {
    /// A curve.
    pub(super) fn profile(&mut self, node: &Node<'_>) -> Option<Profile> {
        let Some(head) = node.head() else {
            let message = format!(
                "a curve must stand here, such as MinimumJerk(from: 0, to: 1, duration: 2), not {}",
                node.describe()
            );
            self.reader.fault(node.place(), message);
            return None;
        };
        self.reader.expect(&head.span, ExpectedKind::Word, "curve", curves());
        match head.name {
            "Blend" => return self.blend(node),
            "Weighted" => return self.weighted(node),
            "Sine" => return self.sine(node),
            "Repeat" => return self.repeat(node),
            _ => {}
        }
        let Some(kind) = Profile::KINDS.iter().find(|kind| kind.variant == head.name) else {
            let near = nearest(head.name, curves());
            let hint = match &near {
                Some(near) => format!("did you mean '{near}'?"),
                None => format!("there are {}", curves().collect::<Vec<_>>().join(", ")),
            };
            let message = format!("there is no curve '{}'; {hint}", head.name);
            self.reader.fault_meaning(head.span, message, near);
            return None;
        };
        self.of_kind(kind, node)
    }

    fn of_kind(&mut self, kind: &'static Kind, node: &Node<'_>) -> Option<Profile> {
        let before = self.reader.count();
        let names: Vec<String> = kind.parameters().map(Parameter::field).collect();
        let known: Vec<&str> =
            names.iter().map(String::as_str).chain(kind.has_keys().then_some("keys")).collect();
        let fields = self.reader.fields(node, &[kind.variant], &known)?;
        let mut values = Vec::new();
        for (index, parameter) in kind.parameters().enumerate() {
            let name = &names[index];
            let given = if index < kind.required.len() {
                self.reader.required(&fields, name, "0.5")
            } else {
                fields.get(name)
            };
            let angle = self.turns && !matches!(parameter.measure, Measure::Time | Measure::Number);
            let value = given.and_then(|node| self.reader.coordinate(node, angle, parameter.name));
            values.extend(value.map(|value| (parameter.name, value)));
        }
        let keys = if kind.has_keys() { self.keys(&fields) } else { Vec::new() };
        if self.reader.count() > before {
            return None;
        }
        let value = |parameter: &Parameter| {
            values.iter().find(|(name, _)| *name == parameter.name).map(|(_, value)| *value)
        };
        let profile = kind.profile(value, keys);
        let checked = profile.and_then(|profile| profile.curve::<f64>().map(|_| profile));
        checked.map_err(|error| self.refuse(&error, &fields)).ok()
    }

    /// `[(0, deg(10)), (1, deg(40)), …]`: times and positions.
    fn keys(&mut self, fields: &Fields<'_, '_>) -> Vec<(f64, f64)> {
        let Some(node) = self.reader.required(fields, "keys", "[(0, 0), (1, 0.5)]") else {
            return Vec::new();
        };
        let items = self.reader.items(node, "keys", "[(time, position), …]").unwrap_or_default();
        let mut keys = Vec::new();
        for item in items {
            let Some([time, position]) = item.items() else {
                self.reader
                    .fault(item.place(), format!("a key is (time, position), not {}", item.describe()));
                continue;
            };
            let time = self.reader.number(time, "the time of a key");
            let position = self.reader.coordinate(position, self.turns, "the position of a key");
            keys.extend(time.zip(position));
        }
        keys
    }

    /// Why there is no such curve, said of the number that is at fault where it can be told.
    pub(super) fn refuse(&mut self, error: &ProfileError, fields: &Fields<'_, '_>) {
        let node = culprit(error).and_then(|name| fields.get(&name));
        let place = node.map_or(fields.at.clone(), |node| node.span.clone());
        self.reader.fault(place, error.to_string());
    }
}

/// The field that an error is about.
pub(super) fn culprit(error: &ProfileError) -> Option<String> {
    Some(match error {
        ProfileError::NotFinite { what, .. }
        | ProfileError::NotWhole { what, .. }
        | ProfileError::OutOfRange { what, .. }
        | ProfileError::Infeasible { what, .. } => match *what {
            "start of the window" => "start".to_owned(),
            "end of the window" => "end".to_owned(),
            what => what.replace(' ', "_"),
        },
        ProfileError::Duration { .. } => "duration".to_owned(),
        ProfileError::Knots { .. } | ProfileError::Count { .. } => "keys".to_owned(),
        _ => return None,
    })
}
