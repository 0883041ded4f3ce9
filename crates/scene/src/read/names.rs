//! Names of degrees of freedom, joints, and many at once.

use super::SceneReader;
use solaris_model::text::layout::quoted;
use solaris_model::text::{ExpectedKind, Node};
use solaris_model::{AxisKind, Figure, JointKind, nearest};
use std::collections::HashMap;

/// How closely a name says what it means. What says it more closely wins, and among equals the later.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Closeness {
    /// A pattern with `*`.
    Pattern,
    /// A joint of several degrees of freedom.
    Joint,
    /// One degree of freedom.
    Dof,
}

/// What a name means: indices in `v`.
#[derive(Clone, Debug)]
pub(super) struct Meant {
    pub(super) dofs: Vec<usize>,
    pub(super) closeness: Closeness,
    /// The joint, where that is what is named.
    pub(super) joint: Option<usize>,
}

impl Meant {
    /// One degree of freedom.
    pub(super) fn of(dof: usize) -> Self {
        Self { dofs: vec![dof], closeness: Closeness::Dof, joint: None }
    }
}

/// All names of a figure.
#[derive(Debug, Default)]
pub(super) struct Names {
    dofs: Vec<String>,
    /// Degrees of freedom by name, short names of joints with one among them.
    by_name: HashMap<String, usize>,
    /// Name and degrees of freedom of each joint, by link.
    joints: Vec<(String, Vec<usize>)>,
    /// Whether a degree of freedom turns.
    turns: Vec<bool>,
}

impl Names {
    pub(super) fn of(figure: &Figure) -> Self {
        let layout = figure.layout();
        let links = || figure.links().iter().zip(layout.joints());
        let turns = links().flat_map(|(link, _)| match link.joint().kind() {
            JointKind::Axes(dofs) => dofs.iter().map(|dof| dof.axis.kind == AxisKind::Rotation).collect(),
            JointKind::Ball { .. } => vec![true; 3],
            _ => vec![false, false, false, true, true, true],
        });
        let joints =
            links().map(|(link, at)| (link.joint().name().to_owned(), (at.v..at.v + at.nv).collect()));
        let short = links().map(|(link, _)| link.joint().name());
        let names = layout.v_names().iter().map(String::as_str).chain(short);
        Self {
            dofs: layout.v_names().to_vec(),
            by_name: names.filter_map(|name| Some((name.to_owned(), layout.dof_index(name)?))).collect(),
            joints: joints.collect(),
            turns: turns.collect(),
        }
    }

    /// Name of a degree of freedom.
    pub(super) fn name(&self, dof: usize) -> &str {
        &self.dofs[dof]
    }

    /// Whether all of these turn, so that degrees make sense for them.
    pub(super) fn turn(&self, meant: Option<&Meant>) -> bool {
        meant.is_none_or(|meant| meant.dofs.iter().all(|dof| self.turns[*dof]))
    }

    /// The one degree of freedom of this name, or of a joint of one.
    pub(super) fn one(&self, name: &str) -> Option<usize> {
        self.by_name.get(name).copied()
    }

    fn find(&self, name: &str) -> Option<Meant> {
        if let Some(dof) = self.by_name.get(name) {
            return Some(Meant::of(*dof));
        }
        if let Some(joint) = self.joints.iter().position(|(joint, dofs)| joint == name && !dofs.is_empty()) {
            let dofs = self.joints[joint].1.clone();
            return Some(Meant { dofs, closeness: Closeness::Joint, joint: Some(joint) });
        }
        if !name.contains('*') {
            return None;
        }
        let mut dofs: Vec<usize> =
            (0..self.dofs.len()).filter(|dof| matches(name, &self.dofs[*dof])).collect();
        // Of a joint whose name is like it all are meant.
        dofs.extend(self.joints.iter().filter(|(joint, _)| matches(name, joint)).flat_map(|(_, dofs)| dofs));
        dofs.sort_unstable();
        dofs.dedup();
        (!dofs.is_empty()).then_some(Meant { dofs, closeness: Closeness::Pattern, joint: None })
    }

    fn nearest(&self, name: &str) -> Option<String> {
        let joints = self.joints.iter().filter(|(_, dofs)| !dofs.is_empty()).map(|(name, _)| name.as_str());
        if let Some((joint, rest)) = name.split_once('.')
            && name.contains('*')
        {
            return Some(format!("{}.{rest}", nearest(joint, joints)?));
        }
        nearest(name, self.dofs.iter().map(String::as_str).chain(joints))
    }
}

/// Whether `name` is `pattern`, in which each `*` stands for any text.
pub(super) fn matches(pattern: &str, name: &str) -> bool {
    let mut pieces = pattern.split('*');
    let (first, mut rest) = (pieces.next().unwrap_or_default(), name);
    let Some(after) = rest.strip_prefix(first) else { return false };
    rest = after;
    let mut pieces: Vec<&str> = pieces.collect();
    let Some(last) = pieces.pop() else { return rest.is_empty() };
    for piece in pieces {
        let Some(at) = rest.find(piece) else { return false };
        rest = &rest[at + piece.len()..];
    }
    rest.ends_with(last)
}

impl SceneReader<'_> {
    /// What the name of a key means; nothing without a fault where there is no figure to ask.
    pub(super) fn meant(&mut self, key: &Node<'_>) -> Option<Meant> {
        let name = self.reader.name(key, "the name of a degree of freedom")?;
        let figure = self.figure()?.name().to_owned();
        let found = self.names.find(name);
        let joints = self.names.joints.iter().filter(|(_, dofs)| dofs.len() > 1).map(|(name, _)| name);
        self.reader.expect(&key.span, ExpectedKind::Name, "degree of freedom", &self.names.dofs);
        self.reader.expect(&key.span, ExpectedKind::Name, "joint", joints);
        if found.is_none() {
            let near = self.names.nearest(name);
            let hint = near.as_ref().map_or_else(String::new, |near| format!("; did you mean '{near}'?"));
            let message = if name.contains('*') {
                format!("no degree of freedom of figure '{figure}' is called like '{name}'{hint}")
            } else {
                format!("figure '{figure}' has no degree of freedom or joint '{name}'{hint}")
            };
            self.reader.fault_meaning(key.span.clone(), message, near.as_deref().map(quoted));
        }
        found
    }

    /// The link called `name`, as it stands at `node`; `besides` is what else may stand there.
    pub(super) fn link(&mut self, node: &Node<'_>, name: &str, besides: Option<&str>) -> Option<usize> {
        // The reader is told while the figure is looked at.
        let figure = self.simulation.as_ref()?.figure();
        let links = || figure.links().iter().map(solaris_model::Link::name).chain(besides);
        self.reader.expect(&node.span, ExpectedKind::Name, "link", links());
        if let Some(link) = figure.link_index(name) {
            return Some(link);
        }
        let message = format!("figure '{}' has no link '{name}'", figure.name());
        // Of several figures links have names such as `ann.head`: who leaves the figure out means the nearest of any.
        let own = |link: &'_ str| link.split_once('.').map(|(_, own)| own.to_owned());
        let owns: Vec<String> = links().filter_map(own).collect();
        let near = nearest(name, owns.iter().map(String::as_str));
        let meant = near.and_then(|near| links().find(|link| own(link).as_ref() == Some(&near)));
        let sought = meant.unwrap_or(name).to_owned();
        self.reader.unknown_name(node.span.clone(), &message, &sought, links());
        None
    }

    /// The one degree of freedom that a name means.
    pub(super) fn meant_one(&mut self, key: &Node<'_>) -> Option<usize> {
        let meant = self.meant(key)?;
        if let [dof] = meant.dofs[..] {
            return Some(dof);
        }
        let names: Vec<&str> = meant.dofs.iter().map(|dof| self.names.name(*dof)).collect();
        let message = format!("one degree of freedom must be named here; these are {}", names.join(", "));
        self.reader.fault(key.span.clone(), message);
        None
    }
}

/// What each entry of a map says of its degrees of freedom, in the order in which they are to be applied: what says it
/// more closely last, so that it stays.
pub(super) fn in_order<T>(mut entries: Vec<(Meant, T)>) -> Vec<(Meant, T)> {
    entries.sort_by_key(|(meant, _)| meant.closeness);
    entries
}

#[cfg(test)]
mod tests {
    use super::matches;

    #[test]
    fn stars_stand_for_any_text() {
        for (pattern, name, expected) in [
            ("neck.*", "neck.rx", true),
            ("neck.*", "necklace.rx", false),
            ("*", "anything", true),
            ("left_*.rx", "left_hip.rx", true),
            ("left_*.rx", "left_hip.rx2", false),
            ("*_hip.*", "left_hip.rx", true),
            ("a*a", "a", false),
            ("a*a", "aa", true),
            ("*b*b*", "abcb", true),
            ("*b*b*", "abc", false),
        ] {
            assert_eq!(matches(pattern, name), expected, "{pattern} {name}");
        }
    }
}
