//! Bones: entities whose transforms follow the links of a walker's figure.

use crate::axes::{TURNED, transform};
use crate::walker::Walker;
use bevy_ecs::component::Component;
use bevy_ecs::entity::Entity;
use bevy_ecs::hierarchy::{ChildOf, Children};
use bevy_ecs::name::Name;
use bevy_ecs::query::{Added, Changed, Or, With, Without};
use bevy_ecs::system::{Commands, Query};
use bevy_transform::components::Transform;

/// Has bones grown for a [`Walker`] when it is spawned: an entity a link, each the child of its parent's, the root's the child of the
/// walker's. They have the links' names.
///
/// Without it, bones are those descendants of the walker's entity that have the names of links, such as the nodes of a scene that was loaded from glTF.
#[derive(Component, Clone, Copy, Debug, Default)]
pub struct Skeleton;

/// An entity that follows a link: its `Transform` is written in every frame.
///
/// It has the link's own axes, as glTF has them (a foot's z points to its toes); half a turn about y stands in the root's. The entity must be the child of the
/// bone of the link's parent, or of entities between that stay where they are born; the root's must be the walker's.
#[derive(Component, Clone, Copy, Debug, PartialEq, Eq)]
#[require(Transform)]
pub struct Bone {
    /// The entity of its walker.
    pub walker: Entity,
    /// The index of its link in the figure.
    pub link: usize,
}

/// Spawns the bones of new skeletons.
pub(crate) fn grow(
    mut commands: Commands,
    new: Query<(Entity, &Walker), (With<Skeleton>, Or<(Added<Walker>, Added<Skeleton>)>)>,
) {
    for (walker, it) in &new {
        let mut bones: Vec<Entity> = Vec::new();
        for (link, of) in it.figure().links().iter().enumerate() {
            let parent = of.parent().map_or(walker, |parent| bones[parent]);
            let name = Name::new(of.name().to_owned());
            bones.push(commands.spawn((name, Bone { walker, link }, ChildOf(parent))).id());
        }
    }
}

/// Makes bones of what came below a walker and has the name of a link.
pub(crate) fn adopt(
    mut commands: Commands,
    walkers: Query<&Walker>,
    new_walkers: Query<Entity, Added<Walker>>,
    came: Query<Entity, (With<Name>, Without<Bone>, Or<(Added<Name>, Changed<ChildOf>)>)>,
    names: Query<&Name, Without<Bone>>,
    parents: Query<&ChildOf>,
    children: Query<&Children>,
) {
    let mut adopt = |entity: Entity, walker: Entity| {
        let (Ok(name), Ok(it)) = (names.get(entity), walkers.get(walker)) else { return };
        if let Some(link) = it.figure().links().iter().position(|link| link.name() == name.as_str()) {
            commands.entity(entity).insert(Bone { walker, link });
        }
    };
    for entity in &came {
        if let Some(walker) = parents.iter_ancestors(entity).find(|above| walkers.contains(*above)) {
            adopt(entity, walker);
        }
    }
    for walker in &new_walkers {
        children.iter_descendants(walker).for_each(|below| adopt(below, walker));
    }
}

/// Writes where every bone is.
pub(crate) fn pose(walkers: Query<&Walker>, mut bones: Query<(&Bone, &mut Transform)>) {
    for (bone, mut place) in &mut bones {
        let Ok(walker) = walkers.get(bone.walker) else { continue };
        let figure = walker.figure();
        let (Some(link), Some(at)) = (figure.links().get(bone.link), figure.layout().joints().get(bone.link))
        else {
            continue;
        };
        let q = &walker.inner().configuration()[at.q..];
        let local = transform(&(link.joint().placement() * link.joint().moved(q)));
        *place = if link.parent().is_none() { Transform::from_rotation(TURNED) * local } else { local };
    }
}
