//! Active contacts with [rigid](crate::ContactLaw::Rigid) ground: touching down, standing, leaving.

mod denied;
mod landing;
mod standing;
pub(crate) mod state;

use super::driven::Meaning;
use super::guard;
use super::pass::Pass;
use crate::body::Pressed;
use crate::contact::{ContactPatch, Surface};
use crate::failure::{FailureKind, Remedy, RunError, RunFailure};
use crate::phase::Role;
use solaris_model::{Event, EventKind};
use std::collections::HashSet;
use std::sync::Arc;

/// Touches this near to the ground (m) are on it.
const NEAR: f64 = 1e-9;

/// How far into the ground (m) what was on it but not held goes before it is seen.
const BELOW: f64 = 1e-9;

/// Velocities (m/s) below which a touch stands.
const REST: f64 = 1e-6;

/// A flight shorter than this (s) is none.
const SHORTEST_FLIGHT: f64 = 1e-5;

/// Accelerations and velocities smaller than this part of the greatest are none.
const ROUNDING: f64 = 1e-9;

/// Forces smaller than this part of the weight, or of the greatest, are none: what integration leaves to what stands.
const PULL: f64 = 1e-6;

/// The part of the weight below zero at which a lever gives way on the way, so that none that is taken as holding has done so already.
pub(super) const SLACK: f64 = 2.0 * PULL;

/// Touches in an instant.
struct Scene {
    /// By touch, the first link of the rigid part that it belongs to; none where dynamics do not move it.
    parts: Vec<Option<usize>>,
    /// By touch, what there is without a force.
    contact_points: Vec<Pressed<f64>>,
    /// By touch, whether it is on the ground and on something that dynamics move.
    closed: Vec<bool>,
}

/// What was tried, so that nothing is tried again.
#[derive(Default)]
struct Tried {
    /// Sets of contact points.
    sets: HashSet<Vec<usize>>,
    /// The greatest force that would pull (N, or N s in an impact).
    pull: f64,
    /// The greatest rate at which something would sink (m/s², or m/s in an impact).
    sink: f64,
}

impl Pass {
    /// Finds what stands on the ground from now on; what comes down loses its velocity, and what the ground would have to pull
    /// is let go.
    pub(crate) fn find_contacts(&mut self, events: &[Meaning]) -> Result<(), RunError> {
        let simulation = Arc::clone(&self.simulation);
        let Some(surface) =
            simulation.surface.as_ref().filter(|surface| surface.plants() && !self.by_impulses())
        else {
            return Ok(());
        };
        let before = std::mem::take(&mut self.active.holds);
        let (mut held, mut tried): (Vec<usize>, Tried) = Default::default();
        for (hold, patch) in before.iter().enumerate() {
            let given_way = events.iter().find_map(|event| match event {
                Meaning::Pull(of, lever) if *of == hold => Some(*lever),
                _ => None,
            });
            let left = given_way.map_or(&patch.contact_points, |lever| &patch.levers[lever].left);
            held.extend(left);
            if given_way.is_some() {
                // What stood until now is no way to stand any more, however near it is to one.
                tried.sets.insert(all_of(&before));
            }
        }
        let mut scene = self.scene(surface, events)?;
        held.retain(|touch| scene.closed[*touch]);
        // What has come down so slowly that nothing has to be stopped.
        let brought = events.iter().filter_map(|event| match event {
            Meaning::Touch(touch) if scene.closed[*touch] => Some(*touch),
            _ => None,
        });
        held.extend(brought.filter(|touch| scene.contact_points[*touch].rate.abs() <= REST));
        let let_go: Vec<usize> = all_of(&before).into_iter().filter(|touch| !held.contains(touch)).collect();
        if self.comes_down(&scene, &[&held[..], &let_go].concat()) {
            let stands = |touch: &usize| scene.closed[*touch] && scene.contact_points[*touch].rate >= -REST;
            let all = held.iter().copied().chain((0..surface.contact_points.len()).filter(stands));
            held = self.land(surface, &scene, all.collect())?;
            self.settle(&[])?;
            scene = self.scene(surface, events)?;
        } else if !self.active.begun {
            held = (0..surface.contact_points.len())
                .filter(|touch| scene.closed[*touch] && scene.contact_points[*touch].rate >= -REST)
                .collect();
        }
        self.active.begun = true;
        let held = self.stand(surface, &mut scene, held, tried)?;
        self.take_contacts(surface, &scene, &held, &before);
        Ok(())
    }

    /// The touches now, but for those that an event has brought to the ground or below: these are on it.
    fn scene(&mut self, surface: &Surface, events: &[Meaning]) -> Result<Scene, RunError> {
        let links = self.parts();
        let parts: Vec<Option<usize>> =
            surface.contact_points.iter().map(|touch| links[touch.link]).collect();
        let contact_points = self.body.touching(&self.q, &self.v);
        let contact_points: Vec<Pressed<f64>> =
            contact_points.map_err(|error| guard::of_dynamics(self.t, error))?.collect();
        let closed = contact_points.iter().enumerate().map(|(i, touch)| {
            let there = touch.depth >= -NEAR || events.contains(&Meaning::Touch(i));
            there && parts[i].is_some()
        });
        Ok(Scene { closed: closed.collect(), contact_points, parts })
    }

    /// The rigid parts of what dynamics move: links whose joints stand still are one with the link that carries them.
    pub(super) fn parts(&self) -> Vec<Option<usize>> {
        let (figure, roles) = (&self.simulation.figure, self.roles());
        let mut parts: Vec<(usize, bool)> = Vec::with_capacity(figure.links().len());
        for (i, (link, at)) in figure.links().iter().zip(figure.layout().joints()).enumerate() {
            let own = &roles[at.v..at.v + at.nv];
            let carrier = link.parent().map(|parent| parts[parent]);
            let moves = carrier.is_some_and(|(_, moves)| moves) || own.contains(&Role::Dynamic);
            let is_part = own.iter().all(|role| *role == Role::Still);
            parts.push((carrier.filter(|_| is_part).map_or(i, |(part, _)| part), moves));
        }
        parts.into_iter().map(|(part, moves)| moves.then_some(part)).collect()
    }

    /// Whether something is on the ground with a velocity that it cannot keep, but for what has `stood` until now.
    fn comes_down(&self, scene: &Scene, stood: &[usize]) -> bool {
        let mut contact_points = scene.contact_points.iter().enumerate().filter(|(i, _)| scene.closed[*i]);
        contact_points.any(|(i, touch)| {
            let slides = touch.slip.norm() > REST && touch.rate >= -REST;
            !stood.contains(&i) && (touch.rate > REST || (slides && !self.active.begun))
        })
    }

    /// Lets the part of a touch slide; if it does so already, or there is none, there is no way to stand, after what was `tried`.
    fn let_slide(
        &mut self,
        tried: &Tried,
        touch: Option<usize>,
        (surface, scene): (&Surface, &Scene),
    ) -> Result<(), RunError> {
        let part = touch.and_then(|touch| scene.parts[touch]);
        if let Some(part) = part.filter(|part| !self.active.sliding.contains(part)) {
            self.active.sliding.push(part);
            return Ok(());
        }
        self.no_contacts(tried, touch, (surface, scene))
    }

    /// There is no way to stand, after what was `tried`, with a `last` touch that can neither be held nor be let go.
    fn no_contacts<T>(
        &self,
        tried: &Tried,
        last: Option<usize>,
        (surface, scene): (&Surface, &Scene),
    ) -> Result<T, RunError> {
        let mut contact_points = tried.contested();
        contact_points.extend(last);
        if contact_points.is_empty() {
            contact_points.extend((0..scene.closed.len()).filter(|touch| scene.closed[*touch]));
        }
        let mut links: Vec<usize> =
            contact_points.iter().map(|touch| surface.contact_points[*touch].link).collect();
        links.sort_unstable();
        links.dedup();
        let figure = &self.simulation.figure;
        let links: Vec<&str> = links.into_iter().map(|link| figure.links()[link].name()).collect();
        let cause =
            FailureKind::UnresolvedContact { links: links.join(", "), pull: tried.pull, sink: tried.sink };
        let remedies = vec![Remedy::CompliantGround];
        Err(RunFailure { time: self.t, dof: None, cause, remedies }.into())
    }

    /// Contact patches of these points, one for each rigid part.
    fn patches(&self, surface: &Surface, scene: &Scene, held: &[usize]) -> Vec<ContactPatch> {
        let mut parts: Vec<usize> = held.iter().filter_map(|touch| scene.parts[*touch]).collect();
        parts.sort_unstable();
        parts.dedup();
        let at = |touch: usize| scene.contact_points[touch].point;
        let of = |own: usize| {
            let contact_points =
                held.iter().copied().filter(|touch| scene.parts[*touch] == Some(own)).collect();
            let patch = ContactPatch::new(contact_points, at, &surface.plane.up)?;
            Some(ContactPatch { slides: self.active.sliding.contains(&own), ..patch })
        };
        parts.into_iter().filter_map(of).collect()
    }

    /// The lever that is farthest beyond giving way, with what the ground does as the body found it last: its force (N, or N s in
    /// an impact) and the contact points that are let go. None where all hold. Forces below `least` are none.
    fn worst_pull(
        &self,
        surface: &Surface,
        scene: &Scene,
        holds: &[ContactPatch],
        least: f64,
    ) -> Option<(f64, Vec<usize>)> {
        let at = |touch: usize| scene.contact_points[touch].point;
        let wrenches: Vec<_> = self.body.patch_wrenches().collect();
        let greatest = wrenches.iter().map(|wrench| wrench.force.norm()).fold(least, f64::max);
        let mut worst = (-PULL * greatest, None);
        for (hold, wrench) in holds.iter().zip(&wrenches) {
            for lever in &hold.levers {
                let force = lever.arm.force(wrench, at, &surface.plane.up);
                if force < worst.0 {
                    worst = (force, Some((hold, lever)));
                }
            }
        }
        worst.1.map(|(hold, lever)| {
            let released = hold.contact_points.iter().copied().filter(|touch| !lever.left.contains(touch));
            (-worst.0, released.collect())
        })
    }

    /// Takes these as what stands on the ground, and tells what has changed.
    fn take_contacts(&mut self, surface: &Surface, scene: &Scene, held: &[usize], before: &[ContactPatch]) {
        let holds = self.patches(surface, scene, held);
        self.body.plant(&holds);
        let stands = |holds: &[ContactPatch], link: usize| {
            holds.iter().any(|hold| {
                hold.contact_points.iter().any(|touch| surface.contact_points[*touch].link == link)
            })
        };
        for (link, spec) in self.simulation.figure.links().iter().enumerate() {
            let (was, is) = (stands(before, link), stands(&holds, link));
            // What stands from the beginning does not come down.
            if was != is && self.t > 0.0 {
                let link = spec.name().to_owned();
                let kind = if is { EventKind::TouchDown { link } } else { EventKind::LiftOff { link } };
                self.passed.record.events.push(Event { time: self.t, kind });
            }
        }
        self.passed.jumps |= before != holds;
        let is_open = |touch: &usize| {
            scene.parts[*touch].is_some() && !held.contains(touch) && !scene.is_shut(&holds, *touch)
        };
        let below = |touch: usize| {
            let depth = scene.contact_points[touch].depth;
            (touch, if depth < -NEAR { 0.0 } else { BELOW + depth.max(0.0) })
        };
        self.active.open = (0..surface.contact_points.len()).filter(is_open).map(below).collect();
        self.active.links =
            holds.iter().map(|hold| surface.contact_points[hold.contact_points[0]].link).collect();
        self.active.holds = holds;
    }
}

/// All points of these contact patches, in ascending order.
fn all_of(holds: &[ContactPatch]) -> Vec<usize> {
    let mut all: Vec<usize> = holds.iter().flat_map(|hold| &hold.contact_points).copied().collect();
    all.sort_unstable();
    all
}

impl Scene {
    /// Whether a touch belongs to a part none of whose points can come nearer to the ground.
    fn is_shut(&self, holds: &[ContactPatch], touch: usize) -> bool {
        holds.iter().any(|hold| hold.is_area() && self.parts[hold.contact_points[0]] == self.parts[touch])
    }
}

impl Tried {
    /// Notes a set. Where it has been there, the part of the touch that was to be held `last` is let slide, and if it does
    /// so already there is no way out.
    fn check(
        &mut self,
        held: &mut Vec<usize>,
        last: Option<usize>,
        pass: &mut Pass,
        (surface, scene): (&Surface, &Scene),
    ) -> Result<(), RunError> {
        held.sort_unstable();
        held.dedup();
        if self.sets.insert(held.clone()) {
            return Ok(());
        }
        pass.let_slide(self, last, (surface, scene))?;
        *self = Self::default();
        Ok(())
    }

    /// The contact points that were held in some sets and not in others.
    fn contested(&self) -> Vec<usize> {
        let mut all: Vec<usize> = self.sets.iter().flatten().copied().collect();
        all.sort_unstable();
        all.dedup();
        all.retain(|touch| !self.sets.iter().all(|set| set.contains(touch)));
        all
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where all was let go in the end, a fall said "no part of  can stay on the ground".
    #[test]
    fn what_is_held_and_let_go_in_turn_is_named_though_nothing_is_held_last() {
        let mut tried = Tried::default();
        tried.sets.extend([vec![2, 4, 7], vec![2, 7], vec![2]]);
        assert_eq!(tried.contested(), [4, 7]);
        tried.sets.insert(Vec::new());
        assert_eq!(tried.contested(), [2, 4, 7]);
    }
}
