//! How feet meet the ground and leave it: what plates see, and what one kilohertz sees of a landing. Nothing here plans.

use solaris_analysis::ground_reactions;
use solaris_dynamics::{Tree, Workspace, center_of_mass};
use solaris_gait::{
    FEET, Footfall, LegGeometry, Resolution, StridePlan, Style, StyleTable, WALK_RATIO, WalkNumbers,
    WalkPlan, WalkRequest, measure, walk,
};
use solaris_model::{Vector3, human};

const G: f64 = 9.80665;
const PEOPLE: [(f64, f64); 3] = [(1.6, 55.0), (1.75, 73.0), (1.9, 90.0)];

fn stride(height: f64, mass: f64, step_frequency: f64) -> StridePlan {
    let figure = human(height, mass).expect("a person");
    let leg = LegGeometry::of(&figure).expect("legs");
    let style = Style::of(&leg, height, step_frequency, WALK_RATIO * height * step_frequency);
    StridePlan::new(&figure, &style, Resolution::default()).expect("a stride")
}

#[test]
fn a_plate_sees_the_law_of_double_support() {
    let table = StyleTable { footfall: Footfall::PEOPLE, ..StyleTable::default() };
    for (height, mass) in PEOPLE {
        let figure = human(height, mass).expect("a person");
        let leg = LegGeometry::of(&figure).expect("legs");
        for step_frequency in [80.0, 95.0, 110.0, 120.0] {
            let step_length = WALK_RATIO * height * step_frequency;
            let style = Style::from_table(&table, &leg, height, step_frequency, step_length);
            let stride = StridePlan::new(&figure, &style, Resolution::default()).expect("a stride");
            let numbers = WalkNumbers::by_contact();
            let plan = WalkPlan::with_numbers(&stride, 10, numbers, Resolution::default()).expect("a walk");
            let mut motion = plan.motion(&figure, 400.0).expect("a motion");
            ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
            let steady = measure(&figure, &motion).expect("measures").steady.expect("a steady stride");
            let law = 29.4 - 0.15 * step_frequency;
            let (both, stance) = (steady.plate_double_support, steady.plate_stance);
            assert!((both - law).abs() < 0.3, "{height} m, {step_frequency}/min: {both} and not {law} %");
            assert!((stance - 50.0 - law).abs() < 0.3, "{height} m, {step_frequency}/min: stance {stance} %");
        }
    }
}

/// A force that grows to a fifth of the weight between two frames passes the threshold where it does, not a frame before.
#[test]
fn what_a_plate_sees_is_the_same_at_any_rate() {
    let figure = human(1.75, 73.0).expect("a person");
    let plan = walk(&figure, &WalkRequest::default()).expect("a walk");
    let seen = |rate: f64| {
        let mut motion = plan.motion(&figure, rate).expect("a motion");
        ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
        let steady = measure(&figure, &motion).expect("measures").steady.expect("a steady stride");
        [steady.plate_double_support, steady.plate_stance]
    };
    let [both, stance] = seen(2000.0);
    for rate in [50.0, 60.0, 100.0, 120.0, 250.0] {
        let [coarse, stood] = seen(rate);
        assert!((coarse - both).abs() < 0.1, "{rate} Hz: double support {coarse} % and not {both}");
        assert!((stood - stance).abs() < 0.1, "{rate} Hz: stance {stood} % and not {stance}");
    }
}

#[test]
fn the_recipe_counts_from_touch_down_to_lift_off() {
    let figure = human(1.75, 73.0).expect("a person");
    let leg = LegGeometry::of(&figure).expect("legs");
    let table = StyleTable { footfall: Footfall::RECIPE, ..StyleTable::default() };
    let style = Style::from_table(&table, &leg, 1.75, 110.0, 0.712);
    assert!((style.double_support - (0.294 - 0.00149 * 110.0)).abs() < 1e-12);
}

/// A foot's pitch passes its contact with one rate and one second derivative.
#[test]
fn a_foot_lands_smoothly() {
    for step_frequency in [80.0, 95.0, 110.0, 120.0, 130.0] {
        let plan = stride(1.75, 73.0, step_frequency);
        let pitch = |u: f64| plan.foot_pitches(u)[0].0;
        let h = 1e-4;
        let second = |u: f64| (pitch(u + h) - 2.0 * pitch(u) + pitch(u - h)) / (h * h);
        let rate = |u: f64| (pitch(u + h) - pitch(u - h)) / (2.0 * h);
        let (before, after) = (second(1.0 - 2.0 * h), second(2.0 * h));
        let most = (1..300).map(|i| second(1.0 - f64::from(i) * 1e-4).abs()).fold(0.0, f64::max);
        assert!((before - after).abs() < 0.1 * most, "{step_frequency}: {before} and {after} of {most}");
        let (before, after) = (rate(1.0 - h), rate(h));
        assert!((before - after).abs() < 0.05 * before.abs(), "{step_frequency}: {before} and {after}");
    }
}

/// What the body's own movement needs, by differences of its centre of mass a millisecond apart, is the law between its nodes too.
#[test]
fn forces_at_a_kilohertz_have_no_spikes() {
    for (height, mass) in PEOPLE {
        let figure = human(height, mass).expect("a person");
        let tree = Tree::<f64>::new(&figure, Vector3::zeros()).expect("a tree");
        let mut workspace = Workspace::new(&tree);
        for step_frequency in [80.0, 95.0, 110.0, 120.0] {
            let plan = stride(height, mass, step_frequency);
            let (n, time) = (plan.node_count(), plan.style().stride_time);
            let mut q = vec![0.0; figure.layout().nq()];
            let mut com = |t: f64| {
                plan.configuration(t / time, &mut q);
                center_of_mass(&tree, &mut workspace, &q).expect("a place")
            };
            let h = 1e-3;
            let law = |node: usize| {
                let [left, right] = plan.forces(node % n);
                left.force + right.force
            };
            let mut worst = (0.0, 0.0);
            for i in 0..(time / h) as usize {
                let t = i as f64 * h;
                let acceleration = (com(t + h) - 2.0 * com(t) + com(t - h)) / (h * h);
                let force = (acceleration + Vector3::y() * G) * mass;
                let x = t / time * n as f64;
                let (k, part) = (x as usize, x.fract());
                let off = (force - law(k) * (1.0 - part) - law(k + 1) * part).amax() * 100.0 / (mass * G);
                if off > worst.0 {
                    worst = (off, t / time);
                }
            }
            assert!(
                worst.0 < 5.0,
                "{height} m, {step_frequency}/min: {:.1} %BW at u = {:.4}",
                worst.0,
                worst.1
            );
        }
    }
}
