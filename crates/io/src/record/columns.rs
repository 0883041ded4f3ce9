//! Where in a table each number of a state stands.

use crate::error::IoError;
use crate::table::{CONTACT, CoordinateDefault, TAU, TIME, Table};
use solaris_model::{AxisKind, Figure, JointKind, nearest};
use std::collections::{BTreeMap, HashMap};

/// The most missing columns for which a message looks for the nearest heading.
const MOST_HINTS: usize = 12;
/// The most headings that are looked at for it.
const MOST_COMPARED: usize = 10_000;

/// Places of the columns of a state.
pub(super) struct Columns {
    /// Of each coordinate; `None` for those of followers and defaults that are missing.
    pub(super) q: Vec<Option<usize>>,
    /// Of each degree of freedom, where its velocity is known.
    pub(super) v: Vec<Option<usize>>,
    /// Of each degree of freedom, where its acceleration is known.
    pub(super) a: Vec<Option<usize>>,
    /// The degrees of freedom that turn about one axis, each with its coordinate.
    pub(super) turning: BTreeMap<usize, usize>,
    /// Headings that mean nothing here.
    pub(super) ignored: Vec<String>,
    /// The coordinates without a column that the model knows, and where.
    pub(super) defaulted: Vec<(usize, CoordinateDefault)>,
}

/// What a heading means.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Meaning {
    Time,
    Position(usize),
    Velocity(usize),
    Acceleration(usize),
    /// Read by others.
    Force,
}

impl Columns {
    pub(super) fn find(
        figure: &Figure,
        table: &Table,
        defaults: &[CoordinateDefault],
    ) -> Result<Self, IoError> {
        let dotted =
            table.columns.iter().any(|name| [".q", ".v", ".a"].iter().any(|ending| name.ends_with(ending)));
        let meanings = meanings(figure, dotted);
        let mut places: HashMap<Meaning, usize> = HashMap::new();
        let mut strange = Vec::new();
        for (place, name) in table.columns.iter().enumerate() {
            let known = meanings.get(name).copied().or_else(|| state(figure, &meanings, name));
            let Some(meaning) = known else {
                strange.push(place);
                continue;
            };
            if let Some(first) = places.insert(meaning, place)
                && meaning != Meaning::Force
            {
                let (line, first) = (table.header_line, table.columns[first].clone());
                return Err(IoError::SameCoordinate { line, first, second: name.clone() });
            }
        }
        let find = |meaning| places.get(&meaning).copied();
        let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
        let mut found = Self {
            q: (0..nq).map(|i| find(Meaning::Position(i))).collect(),
            v: (0..nv).map(|i| find(Meaning::Velocity(i))).collect(),
            a: (0..nv).map(|i| find(Meaning::Acceleration(i))).collect(),
            turning: turning(figure),
            ignored: Vec::new(),
            defaulted: Vec::new(),
        };
        found.take_defaults(figure, table, &strange, defaults);
        found.check_whole(figure, table, &strange, dotted)?;
        if find(Meaning::Time).is_none() {
            found.check_needs_no_time(figure, table.header_line)?;
        }
        for place in strange {
            let name = &table.columns[place];
            match name.rsplit_once('.').filter(|_| dotted) {
                Some((_, "q" | "v" | "a" | TAU)) => {
                    return Err(IoError::UnknownDof {
                        line: table.header_line,
                        column: place + 1,
                        name: name.clone(),
                        figure: figure.name().to_owned(),
                        nearest: nearest(name, sorted(&meanings).into_iter()),
                    });
                }
                Some((_, ending)) if CONTACT.contains(&ending) => {}
                _ => found.ignored.push(name.clone()),
            }
        }
        Ok(found)
    }

    /// Whether velocities and accelerations of all degrees of freedom are in the table, but for those of followers.
    pub(super) fn know_all(&self, figure: &Figure) -> bool {
        let known = |places: &[Option<usize>]| {
            places.iter().enumerate().all(|(dof, place)| place.is_some() || figure.follows(dof))
        };
        known(&self.v) && known(&self.a)
    }

    /// Takes missing coordinates from where the model has them, if that is all that is meant.
    fn take_defaults(
        &mut self,
        figure: &Figure,
        table: &Table,
        strange: &[usize],
        defaults: &[CoordinateDefault],
    ) {
        let names = figure.layout().q_names();
        let follows = |q: &usize| figure.followers().iter().any(|follower| follower.coordinate == *q);
        let missing: Vec<usize> =
            (0..self.q.len()).filter(|&q| self.q[q].is_none() && !follows(&q)).collect();
        let default = |q: usize| defaults.iter().find(|default| default.name == names[q]);
        let free: Vec<usize> = missing
            .iter()
            .copied()
            .filter(|&q| !default(q).is_some_and(|default| default.is_locked))
            .collect();
        let is_misspelt = |q: usize| {
            let columns = strange.iter().take(MOST_COMPARED).map(|&place| table.columns[place].as_str());
            nearest(&names[q], columns).is_some()
        };
        // A table of another figure is refused as such, for what it does not have of what is not locked.
        let is_other =
            free.len() * 2 > names.len() || free.iter().any(|&q| default(q).is_none() || is_misspelt(q));
        let taken = missing.into_iter().filter_map(|q| Some((q, default(q)?.clone())));
        self.defaulted = taken.filter(|(_, default)| default.is_locked || !is_other).collect();
    }

    /// Refuses what is missing: positions, and parts of the velocities of ball and free joints.
    fn check_whole(
        &self,
        figure: &Figure,
        table: &Table,
        strange: &[usize],
        dotted: bool,
    ) -> Result<(), IoError> {
        let layout = figure.layout();
        let follows = |q: usize| figure.followers().iter().any(|follower| follower.coordinate == q);
        let named =
            |name: &String, ending: &str| if dotted { format!("{name}.{ending}") } else { name.clone() };
        let mut missing: Vec<String> = (0..layout.nq())
            .filter(|&q| self.q[q].is_none() && !follows(q) && !self.is_defaulted(q))
            .map(|q| named(&layout.q_names()[q], "q"))
            .collect();
        for (link, at) in figure.links().iter().zip(layout.joints()) {
            if link.joint().kind().quaternion().is_none() {
                continue;
            }
            for (places, ending) in [(&self.v, "v"), (&self.a, "a")] {
                let range = at.v..at.v + at.nv;
                if places[range.clone()].iter().any(Option::is_some) {
                    let absent = range.filter(|&dof| places[dof].is_none());
                    missing.extend(absent.map(|dof| named(&layout.v_names()[dof], ending)));
                }
            }
        }
        if missing.is_empty() {
            return Ok(());
        }
        // Names are compared for the first of them only, so that a table of another figure is refused at once.
        let candidates = || strange.iter().take(MOST_COMPARED).map(|&place| table.columns[place].as_str());
        let hint = |(i, name): (usize, String)| {
            let near = if i < MOST_HINTS { nearest(&name, candidates()) } else { None };
            (name, near)
        };
        let columns = missing.into_iter().enumerate().map(hint).collect();
        Err(IoError::MissingColumns { line: table.header_line, columns })
    }

    fn is_defaulted(&self, q: usize) -> bool {
        self.defaulted.iter().any(|(coordinate, _)| *coordinate == q)
    }

    /// Rows without times can be states of their own only where nothing is to be differentiated.
    fn check_needs_no_time(&self, figure: &Figure, line: u64) -> Result<(), IoError> {
        for (places, ending) in [(&self.v, "v"), (&self.a, "a")] {
            let absent = (0..places.len()).find(|&dof| places[dof].is_none() && !figure.follows(dof));
            if let Some(dof) = absent {
                let missing = format!("{}.{ending}", figure.layout().v_names()[dof]);
                return Err(IoError::NoTime { line, missing });
            }
        }
        Ok(())
    }
}

/// What a heading of `OpenSim`'s tables of states means: `/jointset/JOINT/COORDINATE/value`, or `/speed`.
fn state(figure: &Figure, meanings: &HashMap<String, Meaning>, name: &str) -> Option<Meaning> {
    let (path, kind) = name.strip_prefix('/')?.rsplit_once('/')?;
    let coordinate = path.rsplit('/').next()?;
    match (kind, meanings.get(coordinate)?) {
        ("value", position @ Meaning::Position(_)) => Some(*position),
        ("speed", Meaning::Position(_)) => figure.layout().dof_index(coordinate).map(Meaning::Velocity),
        _ => None,
    }
}

/// All headings that mean something for the figure.
fn meanings(figure: &Figure, dotted: bool) -> HashMap<String, Meaning> {
    let layout = figure.layout();
    let mut meanings = HashMap::new();
    // Joints' names first, so that a full name wins over a short one.
    for (link, at) in figure.links().iter().zip(layout.joints()) {
        if let ([_], JointKind::Axes(_)) = (link.joint().kind().axes(), link.joint().kind()) {
            put(&mut meanings, link.joint().name(), Some(at.q), Some(at.v), dotted);
        }
    }
    for (q, name) in layout.q_names().iter().enumerate() {
        put(&mut meanings, name, Some(q), None, dotted);
    }
    for (v, name) in layout.v_names().iter().enumerate() {
        put(&mut meanings, name, None, Some(v), dotted);
    }
    meanings.insert(TIME.to_owned(), Meaning::Time);
    meanings
}

fn put(
    meanings: &mut HashMap<String, Meaning>,
    name: &str,
    q: Option<usize>,
    v: Option<usize>,
    dotted: bool,
) {
    if !dotted {
        meanings.extend(q.map(|q| (name.to_owned(), Meaning::Position(q))));
        return;
    }
    meanings.extend(q.map(|q| (format!("{name}.q"), Meaning::Position(q))));
    if let Some(v) = v {
        meanings.insert(format!("{name}.v"), Meaning::Velocity(v));
        meanings.insert(format!("{name}.a"), Meaning::Acceleration(v));
        meanings.insert(format!("{name}.{TAU}"), Meaning::Force);
    }
}

/// In an order that does not change from run to run.
fn sorted(meanings: &HashMap<String, Meaning>) -> Vec<&str> {
    let mut names: Vec<&str> = meanings.keys().map(String::as_str).collect();
    names.sort_unstable();
    names
}

/// The degrees of freedom that turn about one axis, with their coordinates.
fn turning(figure: &Figure) -> BTreeMap<usize, usize> {
    let joints = figure.links().iter().zip(figure.layout().joints());
    joints
        .flat_map(|(link, at)| {
            let axes = link.joint().kind().axes().iter().enumerate();
            axes.filter(|(_, dof)| dof.axis.kind == AxisKind::Rotation).map(|(i, _)| (at.v + i, at.q + i))
        })
        .collect()
}
