//! The frames of models and worlds, and where each stands.
//!
//! Names are of a scope: a model or the world. Each entity of a scope has a place relative to another one, by default to the
//! scope's own frame.

use crate::xml::Reader;
use solaris_model::Placement;
use std::collections::HashMap;
use std::ops::Range;

/// What a place, or what is attached, refers to.
#[derive(Clone, Debug)]
pub(super) enum Anchor {
    /// The scope's own frame: the model's, or the world's.
    Scope,
    /// An entity.
    Entity(usize),
    /// A name, and where it stands in the text.
    Named(String, Range<usize>),
}

/// Something with a frame.
pub(super) struct Entity {
    pub(super) name: String,
    pub(super) scope: usize,
    pub(super) place: Placement,
    pub(super) relative_to: Anchor,
    pub(super) kind: Kind,
}

/// What has the frame.
pub(super) enum Kind {
    /// The link of this number.
    Link(usize),
    /// A joint, whose frame is attached to its child.
    Joint { child: Anchor },
    /// A `<frame>`.
    Frame { attached_to: Anchor },
    /// A model, with its scope; the place is that of the frame in it that is named, where one is.
    Model { scope: usize, placed: Option<Anchor> },
}

/// The names of a model or the world.
#[derive(Default)]
pub(super) struct Scope {
    /// The model's own entity; none for the world.
    pub(super) model: Option<usize>,
    pub(super) is_static: bool,
    /// What the model's own frame is attached to.
    pub(super) canonical: Option<Anchor>,
    pub(super) names: HashMap<String, usize>,
    pub(super) entities: Vec<usize>,
}

/// All scopes and entities; scope 0 is the world.
pub(super) struct Frames {
    pub(super) scopes: Vec<Scope>,
    pub(super) entities: Vec<Entity>,
}

/// The way from a scope's frame to an entity of it or of a model in it; empty for the scope's own.
type Path = Vec<usize>;

impl Frames {
    /// The world alone.
    pub(super) fn new() -> Self {
        let world = Scope { is_static: true, ..Scope::default() };
        Self { scopes: vec![world], entities: Vec::new() }
    }

    /// Adds a scope.
    pub(super) fn open(&mut self, scope: Scope) -> usize {
        self.scopes.push(scope);
        self.scopes.len() - 1
    }

    /// Adds an entity; a name that is there already is a fault at `span`.
    pub(super) fn add(&mut self, reader: &mut Reader, span: &Range<usize>, entity: Entity) -> usize {
        let index = self.entities.len();
        let Entity { name, scope, .. } = &entity;
        let scope = &mut self.scopes[*scope];
        if name.trim().is_empty() {
            reader.fault(span.clone(), "it has no name; give it one");
        } else if scope.names.insert(name.clone(), index).is_some() {
            reader.fault(
                span.clone(),
                format!("'{name}' is there already; names of links, joints, frames and models must differ"),
            );
        }
        scope.entities.push(index);
        self.entities.push(entity);
        index
    }

    /// The entities of a scope, in order.
    pub(super) fn of(&self, scope: usize) -> &[usize] {
        &self.scopes[scope].entities
    }

    /// An entity's own name.
    pub(super) fn name(&self, entity: usize) -> &str {
        &self.entities[entity].name
    }

    /// An entity's name with those of the models that it is in, up to but without `top`.
    pub(super) fn full_name(&self, entity: usize, top: Option<usize>) -> String {
        let mut names = vec![self.name(entity)];
        let mut model = self.scopes[self.entities[entity].scope].model;
        while let Some(at) = model.filter(|at| Some(*at) != top) {
            names.push(self.name(at));
            model = self.scopes[self.entities[at].scope].model;
        }
        names.reverse();
        names.join("::")
    }

    /// Whether a scope or one that it is in is static.
    pub(super) fn is_static(&self, scope: usize) -> bool {
        let mut at = Some(scope).filter(|scope| *scope > 0);
        while let Some(scope) = at {
            if self.scopes[scope].is_static {
                return true;
            }
            at = self.scopes[scope].model.map(|model| self.entities[model].scope).filter(|scope| *scope > 0);
        }
        false
    }

    /// The way to what an anchor of `scope` refers to; a name that is none is a fault.
    pub(super) fn path(&self, reader: &mut Reader, scope: usize, anchor: &Anchor) -> Option<Path> {
        match anchor {
            Anchor::Scope => Some(Vec::new()),
            Anchor::Entity(entity) => Some(vec![*entity]),
            Anchor::Named(name, span) => {
                let path = self.find(scope, name);
                if path.is_none() {
                    let names = self.scopes[scope].names.keys().map(String::as_str);
                    let hint = reader.hint(name, names);
                    reader.fault(span.clone(), format!("there is no frame '{name}' here{hint}"));
                }
                path
            }
        }
    }

    pub(super) fn find(&self, scope: usize, name: &str) -> Option<Path> {
        let own = &self.scopes[scope].names;
        // Names with colons were names like others before models were nested.
        if let Some(entity) = own.get(name) {
            return Some(vec![*entity]);
        }
        if name == "__model__" || (name == "world" && scope == 0) {
            return Some(Vec::new());
        }
        let (mut path, mut scope) = (Vec::new(), Some(scope));
        for part in name.split("::") {
            if part == "__model__" && !path.is_empty() {
                break;
            }
            let entity = *self.scopes[scope?].names.get(part)?;
            path.push(entity);
            // Nothing else has names in it.
            scope = match self.entities[entity].kind {
                Kind::Model { scope, .. } => Some(scope),
                _ => None,
            };
        }
        Some(path)
    }

    /// The link that a model's own frame is attached to: the one that is named, or its first, or that of its first model.
    pub(super) fn canonical(&self, scope: usize) -> Option<Anchor> {
        let named = self.scopes[scope].canonical.clone();
        let of = |wanted: fn(&Kind) -> bool| {
            self.of(scope)
                .iter()
                .copied()
                .find(|entity| wanted(&self.entities[*entity].kind))
                .map(Anchor::Entity)
        };
        named
            .or_else(|| of(|kind| matches!(kind, Kind::Link(_))))
            .or_else(|| of(|kind| matches!(kind, Kind::Model { .. })))
    }
}
