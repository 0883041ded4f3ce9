//! The mesh of a figure, bound to its nodes.

use super::pack::VERTICES;
use super::skeleton::Skeleton;
use super::{Actor, File};
use serde_json::json;
use solaris_skin::{Detail, Influence, skin};

/// Steps of a share.
const STEPS: f64 = 65_535.0;

/// Adds the skin of an actor, if it has one.
pub(super) fn add(file: &mut File, actor: &Actor, skeleton: &Skeleton, detail: Detail) {
    let own = if actor.skin.is_none() { Some(skin(actor.figure, detail)) } else { None };
    let Some(skin) = actor.skin.or(own.as_ref()) else { return };
    if skin.triangles.is_empty() {
        return;
    }
    let pack = &mut file.pack;
    let points: Vec<[f32; 3]> = skin.points.iter().map(|p| p.map(|x| x as f32).into()).collect();
    let normals: Vec<[f32; 3]> = skin.normals.iter().map(|n| n.map(|x| x as f32).into()).collect();
    let colours: Vec<[u16; 2]> =
        skin.colours.iter().map(|place| [(f64::from(*place) * STEPS).round() as u16, 32_768]).collect();
    let (joints, weights): (Vec<_>, Vec<_>) = skin.influences.iter().map(bound).unzip();
    let binds: Vec<[f32; 16]> = skin
        .bind
        .iter()
        .map(|place| {
            let matrix = place.inverse().to_homogeneous();
            std::array::from_fn(|i| matrix.as_slice()[i] as f32)
        })
        .collect();
    let attributes = json!({
        "POSITION": pack.floats(&points, VERTICES, true),
        "NORMAL": pack.floats(&normals, VERTICES, false),
        "TEXCOORD_0": pack.shares(&colours),
        "JOINTS_0": pack.joints(&joints),
        "WEIGHTS_0": pack.shares(&weights),
    });
    let indices = pack.triangles(&skin.triangles, skin.points.len());
    let binds = pack.floats(&binds, None, false);
    let material = file.palette();
    file.meshes.push(json!({
        "name": actor.name,
        "primitives": [{ "attributes": attributes, "indices": indices, "material": material }],
    }));
    file.skins.push(json!({
        "name": actor.name,
        "joints": skeleton.nodes,
        "inverseBindMatrices": binds,
        "skeleton": skeleton.nodes[0],
    }));
    let (mesh, skin) = (file.meshes.len() - 1, file.skins.len() - 1);
    // Beside the nodes that move it, not below: their places are in the skin already.
    let node = file.node(json!({ "name": format!("{} skin", actor.name), "mesh": mesh, "skin": skin }));
    file.scene.push(node);
}

/// The links of a vertex with their shares in steps, which are the whole together: the greatest takes what rounding leaves, and a share of no step
/// has the first link, as glTF asks of those that count nothing.
fn bound(influences: &[Influence; 4]) -> ([u16; 4], [u16; 4]) {
    let mut steps = influences.map(|i| (f64::from(i.share) * STEPS).round() as u16);
    let others: u32 = steps[1..].iter().map(|x| u32::from(*x)).sum();
    steps[0] = (STEPS as u32 - others) as u16;
    let links = std::array::from_fn(|i| if steps[i] > 0 { influences[i].link } else { 0 });
    (links, steps)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_the_whole_to_the_last_step() {
        for parts in [
            [1.0, 0.0, 0.0, 0.0],
            [0.4, 0.3, 0.2, 0.1],
            [0.25; 4],
            [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 0.0],
            [0.6, 0.399_995, 5e-6, 0.0],
        ] {
            let (links, steps) = bound(&parts.map(|share| Influence { link: 7, share }));
            assert_eq!(steps.iter().map(|x| u32::from(*x)).sum::<u32>(), 65_535, "{parts:?}");
            let none = steps.iter().zip(&links).filter(|(step, _)| **step == 0);
            assert!(none.into_iter().all(|(_, link)| *link == 0), "{links:?}, {steps:?}");
        }
    }
}
