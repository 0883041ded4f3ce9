//! Metrics of any motion: a walk of ours against its own measures, a foot that slides, a motion that sinks.

use solaris_analysis::ground::{Belt, PlacedFeet, Sole, Stance, StanceOptions, Stances, find_stances, soles};
use solaris_analysis::{PreparedMotion, ground_reactions};
use solaris_gait::metrics::{Metric, MetricsInput, NoValue, metrics, stances_of_contacts};
use solaris_gait::{Extent, FEET, SteadyStride, WalkMeasures, WalkRequest, measure, walk};
use solaris_model::{ContactTrack, Figure, Motion, MotionInfo, Vector3, human};

const RATE: f64 = 120.0;

fn gravity() -> Vector3<f64> {
    Vector3::new(0.0, -9.806_65, 0.0)
}

/// A motion as a table has it: no events, no planted points, no forces.
fn states(figure: &Figure, motion: &Motion) -> Motion {
    let columns = motion.columns().map(<[f64]>::to_vec);
    Motion::new(figure, motion.info.clone(), motion.time().to_vec(), columns).expect("a motion")
}

struct Walked {
    figure: Figure,
    soles: Vec<Sole>,
    states: Motion,
    contacts: Vec<ContactTrack>,
    measures: WalkMeasures,
}

impl Walked {
    fn of(step_frequency: f64, steps: usize) -> Self {
        let figure = human(1.75, 73.0).expect("a person");
        let request = WalkRequest {
            step_frequency: Some(step_frequency),
            extent: Extent::Steps(steps),
            ..WalkRequest::default()
        };
        let plan = walk(&figure, &request).expect("a walk");
        let mut motion = plan.motion(&figure, RATE).expect("frames");
        ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
        let measures = measure(&figure, &motion).expect("measures");
        let soles = soles(&figure);
        let track = |sole: &Sole| motion.contact(&sole.name).expect("a track").clone();
        let contacts = soles.iter().map(track).collect();
        Self { states: states(&figure, &motion), figure, soles, contacts, measures }
    }

    fn prepared(&self) -> PreparedMotion<'_> {
        PreparedMotion::new(&self.figure, &self.states).expect("ready")
    }

    fn feet<'a>(&self, prepared: &'a PreparedMotion<'a>) -> PlacedFeet<'a> {
        PlacedFeet::new(prepared, self.soles.clone()).expect("placed")
    }

    fn found(&self, belt: Belt) -> Stances {
        let options = StanceOptions { belt, ..StanceOptions::default() };
        let prepared = self.prepared();
        let found = find_stances(&self.feet(&prepared), &options);
        Stances { level: 0.0, ..found.expect("stances") }
    }

    /// By the contacts.
    fn stances(&self) -> Stances {
        let found = self.found(Belt::Still);
        stances_of_contacts(&self.figure, gravity(), self.states.time(), &self.contacts, &found)
    }

    fn metrics(&self, stances: &Stances) -> Vec<Metric> {
        let prepared = self.prepared();
        let given = MetricsInput {
            motion: &prepared,
            feet: Some(&self.feet(&prepared)),
            stances: Some(stances),
            contacts: Some(&self.contacts),
        };
        metrics(&given).expect("metrics")
    }
}

fn of(all: &[Metric], key: &str) -> f64 {
    let metric = all.iter().find(|metric| metric.key == key).expect(key);
    metric.value.unwrap_or_else(|why| panic!("{key}: {why}"))
}

fn why(all: &[Metric], key: &str) -> Option<NoValue> {
    all.iter().find(|metric| metric.key == key).expect(key).value.err()
}

/// Largest differences from the walk's own measures: edges of stances are known to a frame here, events exactly there.
fn assert_agrees(walked: &Walked, all: &[Metric]) {
    let own = &walked.measures;
    let steady: &SteadyStride = own.steady.as_ref().expect("eight steps have one");
    let frame = 100.0 / RATE / (steady.span.1 - steady.span.0);
    for (key, wanted, within) in [
        ("slide_greatest_mm", 1e3 * own.extremes.slide.value, 0.1),
        ("sink_mm", 1e3 * own.extremes.sink.value, 1e-9),
        ("clearance_mm", 1e3 * own.extremes.clearance.value, 1.0),
        ("touch_downs", own.steps as f64 + 1.0, 0.0),
        ("double_support_percent", steady.double_support, 2.0 * frame),
        ("stance_percent", steady.stance, 2.0 * frame),
        ("step_length_m", steady.step_length, 5e-3),
        ("step_frequency_per_min", steady.cadence, 1.0),
        ("speed_m_s", steady.speed, 5e-3),
        ("bob_cm", steady.com_vertical, 0.02),
        ("sway_cm", steady.com_lateral, 0.05),
        ("vertical_first_percent_bw", steady.first_peak, 0.01),
        ("vertical_valley_percent_bw", steady.valley, 0.01),
        ("vertical_second_percent_bw", steady.second_peak, 0.01),
        ("braking_percent_bw", steady.braking, 0.1),
        ("pushing_percent_bw", steady.pushing, 0.1),
    ] {
        let found = of(all, key);
        assert!((found - wanted).abs() <= within, "{key}: {found} is not {wanted}");
    }
}

#[test]
fn a_walk_of_ours_has_the_numbers_of_its_own_report() {
    for (step_frequency, steps) in [(80.0, 10), (110.0, 10), (115.0, 13)] {
        let walked = Walked::of(step_frequency, steps);
        assert_agrees(&walked, &walked.metrics(&walked.stances()));
    }
}

/// A person who stands and is moved as a whole.
fn moved(velocity: Vector3<f64>, lower: f64) -> Walked {
    let mut walked = Walked::of(110.0, 8);
    let nv = walked.figure.layout().nv();
    let first = walked.states.q(0).to_vec();
    let start = walked.states.time()[0];
    let (mut q, mut v) = (Vec::new(), Vec::new());
    for &time in walked.states.time() {
        let place = q.len();
        q.extend_from_slice(&first);
        for k in 0..3 {
            q[place + k] += velocity[k] * (time - start);
        }
        q[place + 1] -= lower;
        v.extend_from_slice(velocity.as_slice());
        v.resize(v.len() + nv - 3, 0.0);
    }
    let a = vec![0.0; v.len()];
    walked.states.set_states(&walked.figure, [q, v, a]).expect("states");
    walked
}

#[test]
fn feet_that_slide_are_told_how_far() {
    let walked = moved(Vector3::new(0.06, 0.0, 0.08), 0.0);
    let all = walked.metrics(&walked.found(Belt::Still));
    let duration = walked.states.time()[walked.states.len() - 1];
    assert!((of(&all, "slide_speed_mm_s") - 100.0).abs() < 1e-9);
    assert!((of(&all, "slide_greatest_mm") - 100.0 * duration).abs() < 1e-8);
    assert!((of(&all, "slide_mean_mm") - 100.0 * duration).abs() < 1e-8);
    assert_eq!(why(&all, "step_length_m"), Some(NoValue::NoStride));
    assert_eq!(why(&all, "clearance_mm"), Some(NoValue::NoSwing));
    assert!(of(&all, "bob_cm").abs() < 1e-12);
    // On a belt that goes with them they do not.
    let belt = Belt::Speed(Vector3::new(0.06, 0.0, 0.08));
    let all = walked.metrics(&walked.found(belt));
    assert!(of(&all, "slide_greatest_mm") < 1e-8);
    assert_eq!(why(&all, "spectral_arc_length"), Some(NoValue::AtRest));
}

#[test]
fn a_walk_that_slides_as_a_whole_slides_by_that() {
    // Against the ground that moves by 0.1 m/s the other way: exactly the walk's own slide more.
    let mut walked = Walked::of(110.0, 10);
    let nq = walked.figure.layout().nq();
    let stances = walked.stances();
    let own = of(&walked.metrics(&stances), "slide_speed_mm_s");
    let [mut q, v, a] = walked.states.columns().map(<[f64]>::to_vec);
    for (row, time) in walked.states.time().iter().enumerate() {
        q[row * nq] += 0.1 * time;
    }
    walked.states.set_states(&walked.figure, [q, v, a]).expect("states");
    let found = of(&walked.metrics(&stances), "slide_speed_mm_s");
    assert!((found - 100.0).abs() <= own, "{found} mm/s, {own} of its own");
}

#[test]
fn what_is_lowered_sinks() {
    let walked = moved(Vector3::zeros(), 0.0);
    let own = of(&walked.metrics(&walked.found(Belt::Still)), "sink_mm");
    let walked = moved(Vector3::zeros(), 5e-3);
    let found = of(&walked.metrics(&walked.found(Belt::Still)), "sink_mm");
    assert!((found - own - 5.0).abs() < 1e-9 && own.abs() < 0.01, "{found} mm, {own} mm before");
}

#[test]
fn what_cannot_be_told_says_why() {
    let walked = Walked::of(110.0, 8);
    let prepared = walked.prepared();
    let given = MetricsInput { motion: &prepared, feet: None, stances: None, contacts: None };
    let all = metrics(&given).expect("metrics");
    for key in ["slide_greatest_mm", "sink_mm", "clearance_mm", "touch_downs", "vertical_first_percent_bw"] {
        assert_eq!(why(&all, key), Some(NoValue::NoFeet), "{key}");
    }
    assert!(of(&all, "bob_cm") > 1.0 && of(&all, "spectral_arc_length") < -1.0);
    let stances = walked.stances();
    let other = Sole { name: "third".to_owned(), ..walked.soles[0].clone() };
    let three: Vec<Sole> = walked.soles.iter().chain([&other]).cloned().collect();
    let three = PlacedFeet::new(&prepared, three).expect("placed");
    let given = MetricsInput { feet: Some(&three), stances: Some(&stances), ..given };
    let all = metrics(&given).expect("metrics");
    assert_eq!(why(&all, "step_length_m"), Some(NoValue::NotTwoFeet { feet: 3 }));
    assert_eq!(why(&all, "braking_percent_bw"), Some(NoValue::NoForces));
    let mut weightless = walked.states.clone();
    weightless.info.gravity = Vector3::zeros();
    let weightless = PreparedMotion::new(&walked.figure, &weightless).expect("ready");
    let refused = metrics(&MetricsInput { motion: &weightless, ..given }).expect_err("no up");
    assert!(refused.to_string().contains("which way is up"));
    let cut =
        [ContactTrack { link: "left_foot".to_owned(), samples: Vec::new() }, walked.contacts[1].clone()];
    let said = metrics(&MetricsInput { feet: Some(&walked.feet(&prepared)), contacts: Some(&cut), ..given })
        .expect_err("cut")
        .to_string();
    assert!(said.contains("a foot's force"), "{said}");
}

#[test]
fn stances_that_are_not_known_or_not_within_the_motion_are_none() {
    let figure = human(1.75, 73.0).expect("a person");
    let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
    let columns = [vec![0.0; nq], vec![0.0; nv], vec![0.0; nv]];
    let motion =
        Motion::new(&figure, MotionInfo::on_earth(&figure, RATE), vec![0.0], columns).expect("a motion");
    let prepared = PreparedMotion::new(&figure, &motion).expect("ready");
    let feet = PlacedFeet::new(&prepared, soles(&figure)).expect("placed");
    let later = |start: f64| Stance { foot: 0, start, end: start + 0.5 };
    let list = vec![later(1.0), later(2.0)];
    let later = Stances { list, belt: Vector3::zeros(), level: 0.0, footings: Vec::new(), method: "" };
    for (stances, why) in [(None, NoValue::NoStance), (Some(&later), NoValue::NoStride)] {
        let given = MetricsInput { motion: &prepared, feet: Some(&feet), stances, contacts: None };
        let all = metrics(&given).expect("metrics");
        let stance = all.iter().find(|metric| metric.key == "stance_percent").expect("a metric");
        assert_eq!(stance.value, Err(why));
    }
}
