//! Nodes for links, and how they move.

use super::keys::{Key, positions};
use super::{Actor, Animation, File};
use crate::error::IoError;
use crate::upright::upright;
use serde_json::json;
use solaris_model::{Figure, Link, Motion, Placement, UnitQuaternion};

/// The nodes of one figure.
pub(super) struct Skeleton {
    /// The node of each link.
    pub(super) nodes: Vec<usize>,
    /// The turn of its world until y is up.
    world: UnitQuaternion<f64>,
}

impl Skeleton {
    /// Nodes in the neutral posture, the rest pose of the file; the root where the `first` motion begins, or at the origin with
    /// what is lowest on the ground, if it shall be `standing`.
    pub(super) fn new(file: &mut File, actor: &Actor, first: Option<&Motion>, standing: bool) -> Self {
        let figure = actor.figure;
        let gravity = first.map(|motion| motion.info.gravity).or_else(|| figure.gravity().copied());
        let world = gravity.map_or_else(UnitQuaternion::identity, |gravity| upright(&gravity));
        let mut q = vec![0.0; figure.layout().nq()];
        // The length is the figure's own.
        let _ = figure.neutral(&mut q);
        let mut nodes = Vec::with_capacity(figure.links().len());
        for (i, (link, at)) in figure.links().iter().zip(figure.layout().joints()).enumerate() {
            let mut place = local(link, &q[at.q..], &world);
            if standing && link.parent().is_none() {
                place.translation.y -= lowest(figure, &q, &world);
            } else if let Some(motion) = first.filter(|_| link.parent().is_none()) {
                place.translation = local(link, &motion.q(0)[at.q..], &world).translation;
            }
            let translation = place.translation.vector.map(|x| x as f32);
            let rotation = place.rotation.coords.map(|x| x as f32);
            let mut node = json!({
                "name": link.name(),
                "translation": translation.as_slice(),
                "rotation": rotation.as_slice(),
            });
            let children: Vec<usize> =
                children(figure, i).map(|child| file.nodes.len() - i + child).collect();
            if !children.is_empty() {
                node["children"] = json!(children);
            }
            nodes.push(file.node(node));
        }
        let root = file.node(json!({ "name": actor.name, "children": [nodes[0]] }));
        file.scene.push(root);
        Self { nodes, world }
    }

    /// Moves the nodes.
    pub(super) fn animate(
        &self,
        file: &mut File,
        animation: &mut Animation,
        figure: &Figure,
        motion: &Motion,
        keys: &[Key],
    ) -> Result<(), IoError> {
        let start = motion.time()[0];
        let times: Vec<f64> = keys.iter().map(|key| key.time - start).collect();
        let rows: Vec<Vec<f64>> = keys.iter().map(|key| positions(figure, motion, key)).collect();
        let (mut all, mut one) = (None, None);
        for ((link, at), node) in figure.links().iter().zip(figure.layout().joints()).zip(&self.nodes) {
            let kind = link.joint().kind();
            if kind.nq() == 0 {
                continue;
            }
            let mut places: Vec<Placement> =
                rows.iter().map(|q| local(link, &q[at.q..], &self.world)).collect();
            for (place, time) in places.iter().zip(&times) {
                let numbers = place.translation.vector.iter().chain(place.rotation.coords.iter());
                if let Some(value) = numbers.copied().find(|x| !(*x as f32).is_finite()) {
                    let column = format!("{}.place", link.name());
                    return Err(IoError::NotFinite { column, time: time + start, value });
                }
            }
            // Of a turn's two quaternions the one near to that before.
            for i in 1..places.len() {
                if places[i].rotation.coords.dot(&places[i - 1].rotation.coords) < 0.0 {
                    places[i].rotation = UnitQuaternion::new_unchecked(-places[i].rotation.into_inner());
                }
            }
            let turns: Vec<[f32; 4]> =
                places.iter().map(|place| place.rotation.coords.map(|x| x as f32).into()).collect();
            let slides: Vec<[f32; 3]> =
                places.iter().map(|place| place.translation.vector.map(|x| x as f32).into()).collect();
            let moves = kind.slides().next().is_some();
            for (path, still) in [("rotation", still(&turns)), ("translation", still(&slides))] {
                if path == "translation" && !moves {
                    continue;
                }
                // What stands still has one key.
                let input = if still { &mut one } else { &mut all };
                let input =
                    *input.get_or_insert_with(|| file.pack.times(if still { &times[..1] } else { &times }));
                let count = if still { 1 } else { keys.len() };
                let output = match path {
                    "rotation" => file.pack.floats(&turns[..count], None, false),
                    _ => file.pack.floats(&slides[..count], None, false),
                };
                animation.channel(*node, path, input, output);
            }
        }
        Ok(())
    }
}

/// Where a link is in its parent, with its joint's coordinates `q`; the root in the world that is turned by `world`.
pub(crate) fn local(link: &Link, q: &[f64], world: &UnitQuaternion<f64>) -> Placement {
    let place = link.joint().placement() * link.joint().moved(q);
    if link.parent().is_none() { world * place } else { place }
}

/// The height (m) of the lowest joint or point of a sole.
fn lowest(figure: &Figure, q: &[f64], world: &UnitQuaternion<f64>) -> f64 {
    let places = figure.places(q);
    let points = figure.links().iter().zip(&places).flat_map(|(link, place)| {
        let origin = place.translation.vector;
        let soles = link.sole().iter().map(move |point| origin + place.rotation * point.position);
        soles.chain([origin])
    });
    points.map(|point| (world * point).y).fold(f64::INFINITY, f64::min)
}

fn children(figure: &Figure, of: usize) -> impl Iterator<Item = usize> + '_ {
    figure.links().iter().enumerate().filter(move |(_, link)| link.parent() == Some(of)).map(|(i, _)| i)
}

fn still<const N: usize>(rows: &[[f32; N]]) -> bool {
    rows.iter().all(|row| row.iter().zip(&rows[0]).all(|(a, b)| a.to_bits() == b.to_bits()))
}
