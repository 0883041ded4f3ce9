//! Walks in the thesis's style with random parameters: what is feasible obeys all laws, what is not answers.

use crate::posed::Posed;
use nalgebra::Vector3;
use solaris_gait::determinants::{Determinants, Proportions};
use solaris_gait::{Extent, GaitError, InBetween, PostureError, RequestError, ThesisRequest, thesis_walk};
use solaris_model::{Figure, Trajectory as _, human};

/// Random numbers that are the same everywhere.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn within(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * self.unit()
    }

    fn often(&mut self, share: f64) -> bool {
        self.unit() < share
    }
}

/// A request far and wide: most parameters are chosen, some are anything.
fn request(random: &mut Random, figure: &Figure) -> ThesisRequest {
    let determinants = if random.often(0.5) { Determinants::Three } else { Determinants::Five };
    let p = Proportions::of(figure).expect("a person");
    let parameters = determinants.parameters(&p);
    let mut given = Vec::new();
    for parameter in &parameters[1..] {
        if random.often(0.25) {
            let (lower, upper) = parameter.range;
            // Most of a range is far from any walk.
            let share = random.unit().powi(2);
            given.push((parameter.name, lower + share * (upper - lower)));
        }
    }
    let step_frequency = random.often(0.9).then(|| random.within(30.0, 178.0));
    let step_length = random.often(0.4).then(|| p.height * random.within(0.1, 0.7));
    ThesisRequest {
        determinants,
        step_frequency,
        step_length,
        extent: Extent::Steps(1 + (random.unit() * 3.0) as usize),
        parameters: given,
        in_between: if random.often(0.5) { InBetween::Linear } else { InBetween::Rest },
        step_width: random.often(0.5).then(|| p.height * random.within(0.02, 0.12)),
        sway: if random.often(0.5) { p.height * random.within(0.0, 0.02) } else { 0.0 },
        left_first: random.often(0.5),
        ..ThesisRequest::default()
    }
}

/// Walked and refused of so many requests.
fn tried(count: usize, seed: u64) -> (usize, usize) {
    let mut random = Random(seed);
    let figures: Vec<Figure> = [(1.2, 25.0), (1.75, 73.0), (2.0, 95.0)]
        .iter()
        .map(|(h, m)| human(*h, *m).expect("a person"))
        .collect();
    let (mut walked, mut refused) = (0, 0);
    for _ in 0..count {
        let figure = &figures[(random.unit() * 3.0) as usize];
        let request = request(&mut random, figure);
        match thesis_walk(figure, &request) {
            Ok(plan) => {
                walked += 1;
                obeys(figure, &plan.walk, &mut random, &request);
                let steps = plan.steps as f64 * plan.step_length;
                assert!((plan.walk.prints().last().expect("prints") - steps).abs() < 1e-12, "{request:?}");
            }
            Err(GaitError::Posture(PostureError::Infeasible { why, .. })) => {
                refused += 1;
                assert!(!why.fails.is_empty() && why.fails.iter().all(|fails| !fails.holds()), "{request:?}");
            }
            Err(GaitError::Request(RequestError::Range { .. })) => refused += 1,
            Err(error) => panic!("{request:?}: {error}"),
        }
    }
    (walked, refused)
}

/// No number that is none, nothing planted moves, nothing sinks.
fn obeys(figure: &Figure, walk: &solaris_gait::KeyframedWalk, random: &mut Random, request: &ThesisRequest) {
    let mut posed = Posed::new(figure, walk);
    let planted = walk.planted(figure);
    for _ in 0..8 {
        let interval = &planted[(random.unit() * planted.len() as f64) as usize];
        let mut place: Option<Vector3<f64>> = None;
        for _ in 0..2 {
            posed.pose(random.within(interval.start, interval.end));
            let at = posed.at(interval.link, &interval.point);
            let off = (at - *place.get_or_insert(at)).norm();
            assert!(off < 1e-7, "slides by {off:e} m: {request:?}");
        }
        let t = random.within(0.0, walk.duration());
        posed.pose(t);
        let y = posed.lowest(figure);
        assert!(y > -1e-7, "sinks by {y:e} m at {t} s: {request:?}");
    }
}

#[test]
fn what_can_be_walked_obeys_and_what_cannot_answers() {
    let (walked, refused) = tried(1_500, 1);
    assert!(walked > 150 && refused > 150, "{walked} walked, {refused} refused");
}

/// `cargo lab gaits`.
#[test]
#[ignore = "long: cargo xtask nightly"]
fn a_million_requests_are_walked_or_answered() {
    let (walked, refused) = tried(1_000_000, 2);
    println!("{walked} walked, {refused} refused");
    assert!(walked > 100_000 && refused > 100_000, "{walked} walked, {refused} refused");
}
