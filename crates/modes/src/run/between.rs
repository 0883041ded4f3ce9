//! What links do to each other in every frame, and the report on it.

use crate::between::{Between, Kind};
use crate::report::{LinkCollision, LoopReport};
use crate::simulation::Simulation;
use nalgebra::Vector3;
use solaris_dynamics::Wrench;
use solaris_model::{Contact, ContactTrack, Motion};
use std::collections::BTreeMap;

/// What there is to say of links that touched each other, in the order of the figure, and of all loops.
#[derive(Default)]
pub(super) struct Told {
    pub(super) collisions: Vec<LinkCollision>,
    pub(super) loops: Vec<LoopReport>,
}

/// What links do to each other in a frame; `all` are in the order of the frames.
fn of_frame(all: &[(usize, Between)], frame: usize) -> impl Iterator<Item = &Between> {
    let first = all.partition_point(|(of, _)| *of < frame);
    all[first..].iter().take_while(move |(of, _)| *of == frame).map(|(_, between)| between)
}

/// What acts on the links in a frame, about the world's origin.
pub(super) fn wrenches(
    all: &[(usize, Between)],
    frame: usize,
) -> impl Iterator<Item = (usize, Wrench<f64>)> + '_ {
    of_frame(all, frame).flat_map(|between| between.wrenches(between.links))
}

/// Adds to the motion's contacts what links do to each other; what there is to say of it.
pub(super) fn add(simulation: &Simulation, motion: &mut Motion, all: &[(usize, Between)]) -> Told {
    let name = |link: usize| simulation.figure.links()[link].name().to_owned();
    let end = |link: Option<usize>| link.map_or_else(|| "world".to_owned(), name);
    let of_loop = |closed: &crate::Loop| LoopReport {
        links: closed.between.map(|anchor| end(anchor.link)),
        ..LoopReport::default()
    };
    let mut loops: Vec<LoopReport> = simulation.loops.iter().map(of_loop).collect();
    let mut touched: BTreeMap<[Option<usize>; 2], LinkCollision> = BTreeMap::new();
    for frame in 0..motion.len() {
        let time = motion.time()[frame];
        let step = frame.checked_sub(1).map_or(0.0, |before| time - motion.time()[before]);
        let mut pairs: BTreeMap<[Option<usize>; 2], (Vector3<f64>, f64)> = BTreeMap::new();
        for Between { links, force, kind, .. } in of_frame(all, frame) {
            match *kind {
                Kind::Touch { gap } => {
                    let (sum, depth) = pairs.entry(*links).or_insert((Vector3::zeros(), 0.0));
                    *sum += force;
                    *depth = depth.max(-gap);
                }
                Kind::Loop { index, apart } => loops[index].take(time, apart, force.norm()),
            }
        }
        for (links, (force, depth)) in pairs {
            let new = || LinkCollision { links: links.map(end), ..LinkCollision::default() };
            touched.entry(links).or_insert_with(new).take((time, step), depth, force.norm());
        }
        for between in of_frame(all, frame) {
            let ends = between.links.into_iter().zip(between.points);
            for ((link, wrench), point) in between
                .wrenches(between.links)
                .zip(ends.filter_map(|(link, point)| link.map(|_| point)))
            {
                act(motion, &name(link), (frame, &point), &wrench);
            }
        }
    }
    Told { collisions: touched.into_values().collect(), loops }
}

/// Adds a wrench that acts at a point to what acts on a link in a frame. The centre of pressure is that of all forces, each with its
/// size for a weight.
fn act(motion: &mut Motion, link: &str, (frame, point): (usize, &Vector3<f64>), wrench: &Wrench<f64>) {
    let frames = motion.len();
    let index = motion.contacts.iter().position(|track| track.link == link).unwrap_or_else(|| {
        let samples = vec![Contact::default(); frames];
        motion.contacts.push(ContactTrack { link: link.to_owned(), samples });
        motion.contacts.len() - 1
    });
    let contact = &mut motion.contacts[index].samples[frame];
    let [new, before] = [wrench.force.norm(), contact.force.norm()];
    contact.cop += (point - contact.cop) * (new / (new + before).max(f64::MIN_POSITIVE));
    contact.force += wrench.force;
    contact.moment += wrench.moment;
}
