//! How a walk starts and stops: knees, the first shift of load, the closing foot.

use solaris_analysis::ground_reactions;
use solaris_gait::{Extent, FEET, WalkPlan, WalkRequest, measure, walk};
use solaris_model::{EventKind, Figure, Motion, Vector3, human};

const DEGREE: f64 = std::f64::consts::PI / 180.0;
/// Samples of a second.
const RATE: f64 = 120.0;
/// Pitch from which on a heel is off the ground (rad).
const RISEN: f64 = 0.01;

struct Walked {
    name: String,
    height: f64,
    figure: Figure,
    plan: WalkPlan,
    motion: Motion,
    lifts: Vec<f64>,
    contacts: Vec<f64>,
}

impl Walked {
    fn of(height: f64, step_frequency: f64, steps: usize) -> Self {
        let figure = human(height, 23.8 * height * height).expect("a person");
        let request = WalkRequest {
            step_frequency: Some(step_frequency),
            extent: Extent::Steps(steps),
            ..WalkRequest::default()
        };
        let name = format!("{height} m at {step_frequency} steps/min");
        let plan = walk(&figure, &request).unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut motion = plan.motion(&figure, RATE).expect("sampled");
        ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
        let times = |touch: bool| {
            let of = move |kind: &EventKind| matches!(kind, EventKind::TouchDown { .. }) == touch;
            plan.events().into_iter().filter(|event| of(&event.kind)).map(|event| event.time).collect()
        };
        let (lifts, contacts) = (times(false), times(true));
        Self { name, height, figure, plan, motion, lifts, contacts }
    }

    /// Knees (°) and pitches of the feet (rad) at a sample, left and right.
    fn legs(&self, sample: usize) -> ([f64; 2], [f64; 2]) {
        let clock = self.plan.clock_at(self.motion.time()[sample]);
        let knees = self.plan.knees(clock).map(|knee| knee / DEGREE);
        (knees, self.plan.foot_pitches(clock).map(|(pitch, _)| pitch))
    }

    /// Centre of pressure of both feet (m).
    fn pressure(&self, sample: usize) -> Vector3<f64> {
        let feet = FEET.map(|foot| self.motion.contact(foot).expect("a foot").samples[sample]);
        let total = feet[0].force.y + feet[1].force.y;
        feet.iter().map(|foot| foot.cop * foot.force.y).sum::<Vector3<f64>>() / total
    }

    fn samples(&self, from: f64, to: f64) -> impl Iterator<Item = usize> {
        let time = self.motion.time().to_vec();
        (0..time.len()).filter(move |&i| (from..=to).contains(&time[i]))
    }
}

fn all(look: impl Fn(&Walked)) {
    for height in [1.5, 1.75, 1.95] {
        for step_frequency in [60.0, 70.0, 80.0, 95.0, 110.0, 120.0, 130.0] {
            look(&Walked::of(height, step_frequency, 10));
        }
    }
}

#[test]
fn knees_stay_nearly_straight_until_a_heel_rises() {
    all(|walked| {
        for side in [0, 1] {
            let samples = walked.samples(0.0, walked.contacts[0]);
            let standing = samples.take_while(|&i| walked.legs(i).1[side] < RISEN);
            let most = standing.map(|i| walked.legs(i).0[side]).fold(0.0, f64::max);
            assert!(most < 12.0, "{}: knee {side} bends by {most}° on a flat foot", walked.name);
        }
        let swing = walked.samples(walked.lifts[0], walked.contacts[0]).map(|i| walked.legs(i).0[1]);
        let most = swing.fold(0.0, f64::max);
        assert!((45.0..=72.0).contains(&most), "{}: the first knee swings to {most}°", walked.name);
        let (landed, _) = walked.legs(walked.samples(walked.contacts[0], 1e9).next().expect("a sample"));
        assert!(landed[1] < 25.0, "{}: the first knee lands on {}°", walked.name, landed[1]);
    });
}

/// The centre of pressure goes back and towards the foot that is about to swing, then over the other one; for as long at every pace.
#[test]
fn the_load_shifts_back_and_to_the_swing_foot_first() {
    all(|walked| {
        let rest = walked.pressure(0);
        let moved = |i: usize| walked.pressure(i) - rest;
        let until = |to: f64| walked.samples(0.0, to);
        let onset = until(walked.lifts[0]).find(|&i| moved(i).norm() > 3e-3).expect("it begins");
        let lasts = walked.lifts[0] - walked.motion.time()[onset];
        let pendulum = (walked.height / 1.741).sqrt();
        assert!((0.6 * pendulum..0.72 * pendulum).contains(&lasts), "{}: {lasts} s", walked.name);
        let least = |axis: usize| until(walked.lifts[0]).map(|i| moved(i)[axis]).fold(0.0, f64::min);
        // The right foot swings first: to its side, and back. Slow steps ask for less of it.
        let (back, side) = (-least(2) / walked.height, -least(0) / walked.height);
        assert!((0.014..0.045).contains(&back), "{}: back by {back} of the height", walked.name);
        assert!((0.014..0.022).contains(&side), "{}: aside by {side} of the height", walked.name);
        let lift = until(walked.lifts[0]).last().expect("a sample");
        assert!(moved(lift).x > 0.03, "{}: {}", walked.name, moved(lift).x);
    });
}

#[test]
fn knees_do_not_sink_while_the_feet_close() {
    all(|walked| {
        let (standing, _) = walked.legs(walked.motion.len() - 1);
        let last = walked.lifts.last().expect("a lift");
        let closed = walked.contacts.last().expect("a contact");
        // Ten steps: the left foot lands last, the right one closes.
        let sunk = walked.samples(*last, *closed).map(|i| walked.legs(i).0[0]).fold(0.0, f64::max);
        assert!(sunk - standing[0] < 15.0, "{}: the standing knee bends to {sunk}°", walked.name);
        for i in walked.samples(*closed, 1e9) {
            let (knees, _) = walked.legs(i);
            assert!(knees.iter().all(|knee| *knee < standing[0] + 10.0), "{}: {knees:?}", walked.name);
        }
        // It is set down: no more than the load that comes to it by and by.
        let weight = walked.plan.weight();
        let closing = walked.motion.contact(FEET[1]).expect("a foot");
        let landing = walked.samples(*closed, closed + 0.15).map(|i| closing.samples[i].force.y / weight);
        let most = landing.fold(0.0, f64::max);
        assert!(most < 0.25, "{}: it lands with {most} of the weight", walked.name);
    });
}

#[test]
fn walks_of_any_number_of_steps_obey_the_laws() {
    let few = [1, 2, 3, 4, 5, 6, 7, 13].into_iter();
    let walks = few.flat_map(|steps| [60.0, 85.0, 110.0].map(|step_frequency| (steps, step_frequency)));
    // The foot that lands last but three was put onto the ground by a straight leg.
    let slow = [66.0, 69.0, 70.0, 71.5, 73.0].map(|step_frequency| (10, step_frequency));
    for (steps, step_frequency) in walks.chain(slow) {
        let walked = Walked::of(1.7, step_frequency, steps);
        let found = measure(&walked.figure, &walked.motion).expect("measured").extremes;
        let name = format!("{} in {steps} steps", walked.name);
        assert!(found.cop_outside.value < 1e-3, "{name}: {:?}", found.cop_outside);
        assert!(found.friction.value < 0.36 && found.foot_friction.value < 0.4, "{name}");
        assert!(found.least_knee.value > 0.0, "{name}: {:?}", found.least_knee);
        assert!(found.slide.value < 1e-9 && found.sink.value < 1e-4, "{name}");
        assert!(found.beyond_range.is_none(), "{name}: {:?}", found.beyond_range);
        let knee = |i: usize, side: usize| walked.legs(i).0[side];
        let bends = (1..walked.motion.len() - 1)
            .flat_map(|i| [0, 1].map(|side| knee(i - 1, side) - 2.0 * knee(i, side) + knee(i + 1, side)));
        // Some 5000 °/s² in swing; of a knee that trembled, 40 000.
        let hardest = bends.map(f64::abs).fold(0.0, f64::max) * RATE * RATE;
        assert!(hardest < 10_000.0, "{name}: {hardest} °/s²");
    }
}
