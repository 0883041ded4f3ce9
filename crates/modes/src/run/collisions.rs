//! What links do to each other in every frame, and the report on it.

use crate::collision::Collision;
use crate::report::LinkCollision;
use nalgebra::Vector3;
use solaris_dynamics::Wrench;
use solaris_model::{Contact, ContactTrack, Figure, Motion};
use std::collections::BTreeMap;

/// What acts on the links of a frame, about the world's origin; `collisions` are in the order of the frames.
pub(super) fn wrenches(
    collisions: &[(usize, Collision)],
    frame: usize,
) -> impl Iterator<Item = (usize, Wrench<f64>)> + '_ {
    of_frame(collisions, frame).flat_map(|collision| {
        let on = |link, force| (link, Wrench::at(&collision.point, force, Vector3::zeros()));
        [on(collision.links[0], collision.force), on(collision.links[1], -collision.force)]
    })
}

fn of_frame(collisions: &[(usize, Collision)], frame: usize) -> impl Iterator<Item = &Collision> {
    let first = collisions.partition_point(|(of, _)| *of < frame);
    collisions[first..].iter().take_while(move |(of, _)| *of == frame).map(|(_, collision)| collision)
}

/// Adds to the motion's contacts what links do to each other; what there is to say of each pair that touches, in the order of the
/// figure.
pub(super) fn add(
    figure: &Figure,
    motion: &mut Motion,
    collisions: &[(usize, Collision)],
) -> Vec<LinkCollision> {
    let name = |link: usize| figure.links()[link].name().to_owned();
    let mut told: BTreeMap<[usize; 2], LinkCollision> = BTreeMap::new();
    for frame in 0..motion.len() {
        let time = motion.time()[frame];
        let step = frame.checked_sub(1).map_or(0.0, |before| time - motion.time()[before]);
        let mut pairs: BTreeMap<[usize; 2], (Vector3<f64>, f64)> = BTreeMap::new();
        for Collision { links, force, gap, .. } in of_frame(collisions, frame) {
            let (sum, depth) = pairs.entry(*links).or_insert((Vector3::zeros(), 0.0));
            *sum += force;
            *depth = depth.max(-gap);
        }
        for (links, (force, depth)) in pairs {
            let told = told
                .entry(links)
                .or_insert_with(|| LinkCollision { links: links.map(name), ..LinkCollision::default() });
            told.touching += step;
            if depth > told.depth {
                (told.depth, told.depth_time) = (depth, time);
            }
            if force.norm() > told.force {
                (told.force, told.force_time) = (force.norm(), time);
            }
        }
        for collision in of_frame(collisions, frame) {
            for (link, force) in collision.links.into_iter().zip([collision.force, -collision.force]) {
                act(motion, &name(link), frame, &collision.point, force);
            }
        }
    }
    told.into_values().collect()
}

/// Adds a force at a point to what acts on a link in a frame. The ground's centre of pressure stays; where there is none it is the mean
/// of the points, each with the weight of its force.
fn act(motion: &mut Motion, link: &str, frame: usize, point: &Vector3<f64>, force: Vector3<f64>) {
    let frames = motion.len();
    let index = motion.contacts.iter().position(|track| track.link == link).unwrap_or_else(|| {
        let samples = vec![Contact::default(); frames];
        motion.contacts.push(ContactTrack { link: link.to_owned(), samples });
        motion.contacts.len() - 1
    });
    let contact = &mut motion.contacts[index].samples[frame];
    let before = contact.force.norm();
    let share = force.norm() / (force.norm() + before).max(f64::MIN_POSITIVE);
    contact.cop += (point - contact.cop) * share;
    contact.force += force;
    contact.moment += point.cross(&force);
}
