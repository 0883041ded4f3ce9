//! Newton and Euler on the whole body: the feet's wrenches are what the motion needs, and nothing else acts.

use crate::body::{Whole, frames_at};
use crate::cases::{RATE, person, steps, walked};
use crate::criteria::seconds;
use crate::worst::Worst;
use solaris::gait::FEET;
use solaris::model::{Figure, Motion, Vector3};

pub(crate) const FORCE: &str = "force off m(a − g), weights";
pub(crate) const MOMENT: &str = "moment off momentum, weights × m";
const ROOT_FORCE: &str = "root force, weights";
const ROOT_MOMENT: &str = "root moment, weights × height";
const COP: &str = "centre of pressure off ground, m";
const TILTED: &str = "moment about it not vertical, N m";
const UNLOADED: &str = "unloaded foot, N, N m, m";
const TRACKS: &str = "tracks but the feet's";

/// Sums of forces and of moments about the world's origin against the rates of momentum of the samples.
pub(crate) fn newton(figure: &Figure, motion: &Motion) -> Worst {
    let mut worst = Worst::default();
    let gravity = motion.info.gravity;
    let (mass, height) = (figure.mass(), figure.stature().expect("a human"));
    let weight = mass * gravity.norm();
    for (i, &time) in motion.time().iter().enumerate() {
        let whole = Whole::of(figure, &frames_at(figure, motion, i));
        let contacts = motion.contacts.iter().map(|track| &track.samples[i]);
        let force: Vector3<f64> = contacts.clone().map(|contact| contact.force).sum();
        let moment: Vector3<f64> = contacts.map(|contact| contact.moment).sum();
        let [com, _, acceleration] = whole.com;
        let force_off = force - (acceleration - gravity) * mass;
        let moment_off = moment - (whole.spin_rate - com.cross(&gravity) * mass);
        // Moments grow with the distance from the origin, and their rounding with them.
        let arm = height + com.norm();
        worst.note(FORCE, force_off.amax() / weight, 1e-9, || seconds(time));
        worst.note(MOMENT, moment_off.amax() / (weight * arm), 1e-9, || seconds(time));
        let root = figure.layout().joints()[0].v;
        let tau = &motion.tau(i).expect("forces of the joints")[root..root + 6];
        for (k, tau) in tau.iter().enumerate() {
            if k < 3 {
                worst.note(ROOT_FORCE, tau.abs() / weight, 1e-9, || seconds(time));
            } else {
                worst.note(ROOT_MOMENT, tau.abs() / (weight * height), 1e-9, || seconds(time));
            }
        }
    }
    worst
}

/// One wrench a foot, as a force at a point of the ground and a free moment about the vertical.
fn wrenches(motion: &Motion) -> Worst {
    let mut worst = Worst::default();
    let others = motion.contacts.iter().filter(|track| !FEET.contains(&track.link.as_str())).count();
    worst.note(TRACKS, others as f64 + (motion.contacts.len() as f64 - 2.0).abs(), 0.0, String::new);
    for track in &motion.contacts {
        for (contact, &time) in track.samples.iter().zip(motion.time()) {
            if contact.force.y > 0.0 {
                let free = contact.moment - contact.cop.cross(&contact.force);
                worst.note(COP, contact.cop.y.abs(), 1e-12, || seconds(time));
                worst.note(TILTED, free.x.hypot(free.z), 1e-9, || seconds(time));
            } else {
                let all = contact.force.amax().max(contact.moment.amax()).max(contact.cop.amax());
                worst.note(UNLOADED, all, 0.0, || seconds(time));
            }
        }
    }
    worst
}

#[test]
fn forces_and_moments_are_the_rates_of_momentum() {
    let mut worst = Worst::default();
    for (height, frequency, n) in [(1.75, 95.0, 10), (1.5, 110.0, 3), (2.0, 118.0, 1), (1.2, 64.0, 2)] {
        let figure = person(height);
        let (_, motion) = walked(&figure, &steps(frequency, n), RATE);
        let case = format!("{height} m, {frequency}/min, {n} steps");
        worst.merge(&case, &newton(&figure, &motion));
        worst.merge(&case, &wrenches(&motion));
    }
    worst.assert_all("Newton and Euler");
}
