//! Contacts of every frame, and the report on them.

use super::guard;
use crate::body::{Body, Pressed};
use crate::contact::{GroundPlane, Surface};
use crate::failure::RunError;
use crate::phase::GROUND;
use crate::report::{ContactReport, LinkContact};
use crate::simulation::Simulation;
use nalgebra::Vector3;
use solaris_dynamics::Wrench;
use solaris_model::{Contact, ContactTrack, Event, EventKind, Ground, Motion};

/// Planted touches this near to the ground (m) are on it.
const NEAR: f64 = 1e-6;

/// A link that can touch the ground.
struct Foot {
    link: usize,
    track: ContactTrack,
    told: LinkContact,
    /// How deep its deepest touch was a frame ago (m), negative above the ground.
    before: f64,
    /// How fast it slid a frame ago (m/s).
    sliding: f64,
}

/// One link in one frame.
struct State {
    wrench: Wrench<f64>,
    /// Of the deepest touch (m).
    depth: f64,
    /// The greatest of a touch that is pressed (m/s).
    slip: f64,
    /// The mean of the contact points, each with the weight of its pressure (m/s).
    sliding: f64,
}

/// Adds to the motion the contacts of every link that ever touches, with the events of touching; what there is to say of the
/// ground, if there is one. `sums` are the ground's accounts, as in the state of a phase; `planted` is what it does to what stands
/// on it: frame, link and wrench, in the order of the frames, where the events are known already, or those are not, `by_impulses`.
pub(super) fn add(
    simulation: &Simulation,
    motion: &mut Motion,
    sums: &[f64; GROUND],
    planted: &[(usize, usize, Wrench<f64>)],
    by_impulses: bool,
) -> Result<Option<ContactReport>, RunError> {
    let Simulation { figure, gravity, springs, limits, surface, .. } = simulation;
    let Some(ground @ Surface { plane, contact_points }) = surface else { return Ok(None) };
    let surface_plants = ground.plants() && !by_impulses;
    let is_found = surface_plants || by_impulses;
    let mut body = Body::<f64>::new(figure, *gravity, springs, limits)?.on(surface.as_ref());
    let mut feet: Vec<Foot> = Vec::new();
    for (link, spec) in figure.links().iter().enumerate() {
        if contact_points.iter().any(|touch| touch.link == link) {
            feet.push(Foot::new(link, spec.name(), motion.len()));
        }
    }
    let mut events = Vec::new();
    for frame in 0..motion.len() {
        let time = motion.time()[frame];
        let step = frame.checked_sub(1).map_or(0.0, |before| time - motion.time()[before]);
        let found = body.touching(motion.q(frame), motion.v(frame));
        let found = found.map_err(|error| guard::of_dynamics(time, error))?;
        let mut pressed: Vec<(usize, Pressed<f64>)> =
            contact_points.iter().map(|touch| touch.link).zip(found).collect();
        pressed.sort_by_key(|(link, _)| *link);
        let stands = &planted[planted.partition_point(|(of, ..)| *of < frame)..];
        let stands = &stands[..stands.partition_point(|(of, ..)| *of == frame)];
        for foot in &mut feet {
            let own = &pressed[pressed.partition_point(|(link, _)| *link < foot.link)..];
            let own = own.iter().take_while(|(link, _)| *link == foot.link).map(|(_, pressed)| pressed);
            let mut state = State::of(own.clone(), &plane.up);
            if is_found {
                // What stands does not slip, but for what slides without friction.
                state.slip =
                    own.fold(
                        0.0,
                        |most, touch| if touch.depth > -NEAR { touch.slip.norm().max(most) } else { most },
                    );
                state.stand(stands.iter().find(|(_, link, _)| *link == foot.link).map(|(.., wrench)| wrench));
            }
            foot.take(&state, time, step, &mut events);
            foot.weigh(&state, plane, time, step);
            if let Some(contact) = foot.track.samples.last_mut() {
                let total = Wrench { force: contact.force, moment: contact.moment };
                contact.cop = total.center_of_pressure(&plane.up, plane.height).unwrap_or_default();
            }
        }
    }
    feet.retain(|foot| foot.told.touching > 0.0);
    if !surface_plants {
        motion.events.extend(events);
    }
    motion.events.sort_by(|a, b| a.time.total_cmp(&b.time));
    let level = plane.is_level(gravity);
    motion.info.ground = level.then_some(Ground { height: plane.height, friction: Some(plane.friction) });
    let (tracks, links) = feet.into_iter().map(|foot| (foot.track, foot.told)).unzip();
    motion.contacts = tracks;
    let [x, y, z, damping, friction] = *sums;
    Ok(Some(ContactReport {
        impulse: [x, y, z],
        damping,
        friction,
        links,
        planted: surface_plants,
        landings: Vec::new(),
    }))
}

impl State {
    fn of<'a>(contact_points: impl Iterator<Item = &'a Pressed<f64>>, up: &Vector3<f64>) -> Self {
        let none = Self { wrench: Wrench::zero(), depth: f64::NEG_INFINITY, slip: 0.0, sliding: 0.0 };
        let (mut state, mut pressure) = (none, 0.0);
        for Pressed { depth, point, slip, force, .. } in contact_points {
            state.depth = state.depth.max(*depth);
            state.wrench.force += force;
            state.wrench.moment += point.cross(force);
            let (speed, normal) = (slip.norm(), force.dot(up));
            if normal > 0.0 {
                state.slip = state.slip.max(speed);
                state.sliding += normal * speed;
                pressure += normal;
            }
        }
        if pressure > 0.0 {
            state.sliding /= pressure;
        }
        state
    }

    /// The same of something that stands on the ground with this wrench, or does not.
    fn stand(&mut self, wrench: Option<&Wrench<f64>>) {
        self.wrench = Wrench::zero();
        if let Some(wrench) = wrench {
            self.wrench = Wrench { force: wrench.force, moment: wrench.moment };
            // What stands is on the ground, whatever rounding says.
            self.depth = self.depth.max(f64::MIN_POSITIVE);
            self.sliding = self.slip;
        } else {
            (self.depth, self.slip) = (self.depth.min(0.0), 0.0);
        }
    }
}

impl Foot {
    fn new(link: usize, name: &str, frames: usize) -> Self {
        let track = ContactTrack { link: name.to_owned(), samples: Vec::with_capacity(frames) };
        let told = LinkContact { link: name.to_owned(), ..LinkContact::default() };
        Self { link, track, told, before: f64::NAN, sliding: 0.0 }
    }

    /// How much friction the next frame takes, `step` (s) after the one before.
    fn weigh(&mut self, state: &State, plane: &GroundPlane, time: f64, step: f64) {
        let force = state.wrench.force;
        let normal = force.dot(&plane.up);
        if normal <= 0.0 {
            return;
        }
        let (friction, told) = ((force - plane.up.into_inner() * normal).norm() / normal, &mut self.told);
        if friction > told.friction {
            (told.friction, told.friction_time) = (friction, time);
        }
        // Springs take the whole of it where they slide.
        if friction > plane.friction * (1.0 + 1e-9) {
            told.slipping += step;
        }
    }

    /// The next frame, `step` (s) after the one before; between the two depths are taken as linear.
    fn take(&mut self, state: &State, time: f64, step: f64, events: &mut Vec<Event>) {
        let State { wrench: Wrench { force, moment }, depth, slip, sliding } = *state;
        self.track.samples.push(Contact { force, moment, ..Contact::default() });
        let told = &mut self.told;
        if depth > told.depth {
            (told.depth, told.depth_time) = (depth, time);
        }
        if slip > told.slip {
            (told.slip, told.slip_time) = (slip, time);
        }
        let before = std::mem::replace(&mut self.before, depth);
        let slid_before = std::mem::replace(&mut self.sliding, sliding);
        // The first frame has none before it.
        if before.is_nan() {
            return;
        }
        let (was, is) = (before > 0.0, depth > 0.0);
        let part = before / (before - depth);
        let share = match (was, is) {
            (true, true) => 1.0,
            (true, false) => part,
            (false, true) => 1.0 - part,
            (false, false) => 0.0,
        };
        told.touching += share * step;
        told.slid += share * step * 0.5 * (slid_before + sliding);
        if was != is {
            let link = told.link.clone();
            let kind = if is { EventKind::TouchDown { link } } else { EventKind::LiftOff { link } };
            events.push(Event { time: time - step + part * step, kind });
        }
    }
}
