//! Joint forces by virtual work: what inertia, weight and the ground do when one degree of freedom moves alone.

use crate::body::{Moving, frames, frames_at, second_moments};
use crate::cases::{RATE, person, steps, walked};
use crate::criteria::seconds;
use crate::worst::Worst;
use solaris::gait::FEET;
use solaris::model::{Contact, Figure, Motion, SolePart, Vector3};

/// The vector of the skew part of `∂R Rᵀ`: by what a unit of a degree of freedom turns the frame.
fn turned(frame: &Moving) -> Vector3<f64> {
    let w = frame.turn[1] * frame.turn[0].transpose();
    Vector3::new(w[(2, 1)] - w[(1, 2)], w[(0, 2)] - w[(2, 0)], w[(1, 0)] - w[(0, 1)]) / 2.0
}

/// Forces of all degrees of freedom, for contacts that act on given links:
///
/// ```text
/// τⱼ = Σ m (c̈ − g)·∂c/∂qⱼ + tr(R̈ S (∂R/∂qⱼ)ᵀ) − Σ F·∂P/∂qⱼ + M·∂φ/∂qⱼ
/// ```
fn virtual_work(figure: &Figure, motion: &Motion, sample: usize, loads: &[(usize, Contact)]) -> Vec<f64> {
    let now = frames_at(figure, motion, sample);
    let nv = figure.layout().nv();
    let (q, still) = (motion.q(sample), vec![0.0; nv]);
    let one = |j: usize| {
        let mut unit = still.clone();
        unit[j] = 1.0;
        // With a unit velocity, derivatives in time are those in q_j.
        let moved = frames(figure, q, &unit, &still);
        let mut work = 0.0;
        for ((link, now), moved) in figure.links().iter().zip(&now).zip(&moved) {
            let acceleration = now.point(link.com())[2] - motion.info.gravity;
            work += link.mass() * acceleration.dot(&moved.point(link.com())[1]);
            work += (now.turn[2] * second_moments(link) * moved.turn[1].transpose()).trace();
        }
        for (link, contact) in loads {
            let local = now[*link].turn[0].transpose() * (contact.cop - now[*link].origin[0]);
            let free = contact.moment - contact.cop.cross(&contact.force);
            work -= contact.force.dot(&moved[*link].point(&local)[1]) + free.dot(&turned(&moved[*link]));
        }
        work
    };
    (0..nv).map(one).collect()
}

/// How far the centre of pressure is past the ball, along the toes on the ground (m).
fn past_ball(figure: &Figure, motion: &Motion, sample: usize, toes: usize, cop: &Vector3<f64>) -> f64 {
    let frames = frames_at(figure, motion, sample);
    let place = |part| {
        let point = figure.links()[toes].sole_point(part).expect("ball and tip of the toes");
        frames[toes].point(point)[0]
    };
    let (ball, tip) = (place(SolePart::Ball), place(SolePart::ToeTip));
    let ahead = (tip - ball).xz();
    (cop - ball).xz().dot(&ahead) / ahead.norm()
}

fn link(figure: &Figure, name: &str) -> usize {
    figure.link_index(name).expect("a link of the human")
}

pub(crate) const TAU: &str = "tau off virtual work";
const BEYOND: &str = "foot or toes, beyond their joint";

/// What was loaded, and by how much the other link of the foot would have changed the toes' joint (weights × height).
#[derive(Default)]
pub(crate) struct Loaded {
    toes: usize,
    foot: usize,
    change: f64,
}

/// Joint forces of every `every`-th sample against virtual work; the ground presses on the toes once the centre of
/// pressure is past the ball, and on the foot before.
pub(crate) fn torques(figure: &Figure, motion: &Motion, every: usize, loaded: &mut Loaded) -> Worst {
    let mut worst = Worst::default();
    let scale = figure.mass() * motion.info.gravity.norm() * figure.stature().expect("a human");
    for sample in (0..motion.len()).step_by(every) {
        let (mut loads, mut others) = (Vec::new(), Vec::new());
        let mut nearest = f64::INFINITY;
        for name in FEET {
            let contact = motion.contact(name).expect("a track").samples[sample];
            let (foot, toes) = (link(figure, name), link(figure, &name.replace("foot", "toes")));
            if contact.force.y > 0.0 {
                let past = past_ball(figure, motion, sample, toes, &contact.cop);
                nearest = nearest.min(past.abs());
                let (carrier, other) = if past > 0.0 { (toes, foot) } else { (foot, toes) };
                *(if past > 0.0 { &mut loaded.toes } else { &mut loaded.foot }) += 1;
                loads.push((carrier, contact));
                others.push((other, contact));
            }
        }
        // Right below the ball either link will do.
        if nearest < 2e-3 {
            continue;
        }
        let found = motion.tau(sample).expect("forces of the joints");
        let wanted = virtual_work(figure, motion, sample, &loads);
        let other = virtual_work(figure, motion, sample, &others);
        for (j, name) in figure.layout().v_names().iter().enumerate() {
            let here = || format!("{name} {}", seconds(motion.time()[sample]));
            worst.note(TAU, (found[j] - wanted[j]).abs() / scale, 1e-9, here);
            let changed = (other[j] - wanted[j]).abs() / scale;
            if name.contains("toes") {
                loaded.change = loaded.change.max(changed);
            } else {
                worst.note(BEYOND, changed, 1e-9, here);
            }
        }
    }
    worst
}

#[test]
fn joint_forces_do_the_virtual_work() {
    let (mut worst, mut loaded) = (Worst::default(), Loaded::default());
    for (height, frequency, n) in [(1.75, 95.0, 4), (1.5, 110.0, 3), (2.0, 118.0, 1)] {
        let figure = person(height);
        let (_, motion) = walked(&figure, &steps(frequency, n), RATE);
        let found = torques(&figure, &motion, 7, &mut loaded);
        worst.merge(&format!("{height} m, {frequency}/min, {n} steps"), &found);
    }
    worst.assert_all("virtual work");
    // Both links were loaded, and the wrong one would have been seen.
    assert!(loaded.toes > 20 && loaded.foot > 20 && loaded.change > 1e-3);
}
