//! Laws of a smooth walk in time: when feet touch, that strides repeat themselves, and that a step is the mirror image of the
//! one before.

use solaris_gait::{Extent, WalkPlan, WalkRequest, walk};
use solaris_model::{EventKind, Figure, human};

fn figure() -> Figure {
    human(1.75, 73.0).expect("a person")
}

fn planned(figure: &Figure, step_frequency: f64, steps: usize) -> WalkPlan {
    let request = WalkRequest {
        step_frequency: Some(step_frequency),
        extent: Extent::Steps(steps),
        ..WalkRequest::default()
    };
    walk(figure, &request).expect("it can be walked")
}

#[test]
fn feet_touch_a_step_time_apart() {
    let figure = figure();
    // Faster walks begin and end more slowly: `changes.rs`.
    for step_frequency in [60.0, 73.7, 95.0, 108.3, 110.0] {
        let plan = planned(&figure, step_frequency, 30);
        let events = plan.events();
        let (mut touches, mut lifts) = (Vec::new(), Vec::new());
        for event in &events {
            match &event.kind {
                EventKind::TouchDown { link } => touches.push((event.time, link)),
                EventKind::LiftOff { link } => lifts.push((event.time, link)),
                other => panic!("{other:?}"),
            }
        }
        assert_eq!((touches.len(), lifts.len()), (31, 31));
        for (k, (time, foot)) in touches.iter().enumerate() {
            let wanted = touches[0].0 + k as f64 * 60.0 / step_frequency;
            assert!(
                (time - wanted).abs() < 1e-12,
                "{step_frequency}: contact {k} at {time} and not {wanted} s"
            );
            assert_eq!(*foot, ["right_foot", "left_foot"][k % 2]);
        }
        // Two feet stand from each contact on for a little longer than a plate sees of people's double support, 29.4 − 0.15·sf % of a
        // stride.
        let seen = (29.4 - 0.15 * step_frequency) / 100.0 * 120.0 / step_frequency;
        let both = plan.style().double_support * 120.0 / step_frequency;
        assert!((1.0..1.2).contains(&(both / seen)), "{step_frequency}: {both} of {seen} s");
        for (k, ((touch, landed), (lift, left))) in touches.iter().zip(&lifts[1..]).enumerate() {
            // The first and the last steps have a style of their own.
            let both = plan.style_of_step(k + 1).double_support * 120.0 / step_frequency;
            assert!((1.0..1.2).contains(&(both / seen)), "{step_frequency}: {both} of {seen} s");
            assert!((lift - touch - both).abs() < 1e-12, "{step_frequency}: {touch} to {lift} s");
            assert_ne!(landed, left);
        }
    }
}

/// The greatest difference of two configurations, the first `back` (m) farther along.
fn apart(a: &[f64], b: &[f64], back: f64) -> f64 {
    (0..a.len()).map(|i| (a[i] - b[i] - if i == 2 { back } else { 0.0 }).abs()).fold(0.0, f64::max)
}

#[test]
fn a_hundred_strides_close() {
    let figure = figure();
    for step_frequency in [60.0, 110.0, 115.0, 118.0] {
        let plan = planned(&figure, step_frequency, 240);
        let stride = 2.0 * plan.style().step_length;
        let (mut a, mut b) = (vec![0.0; figure.layout().nq()], vec![0.0; figure.layout().nq()]);
        for part in 0..20 {
            // The tenth stride is planned by itself, as those before it are; what follows repeats one.
            let u = 9.5 + f64::from(part) / 20.0;
            plan.configuration_at(u, &mut a);
            for k in 1..=100 {
                plan.configuration_at(u + f64::from(k), &mut b);
                let off = apart(&b, &a, f64::from(k) * stride);
                assert!(off < 1e-9, "{step_frequency}: {off:e} after {k} strides from {u}");
            }
        }
    }
}

/// A configuration seen in a mirror: left and right exchanged, and what turns about y and z the other way.
fn mirrored(figure: &Figure, q: &[f64]) -> Vec<f64> {
    let mut image = vec![0.0; q.len()];
    let place = |name: &str| {
        let joint = figure.layout().joints()[figure.link_index(name).expect("a segment")];
        joint.q + joint.nq - 3
    };
    for link in figure.links() {
        let name = link.name();
        let other = match (name.strip_prefix("left_"), name.strip_prefix("right_")) {
            (Some(part), _) => format!("right_{part}"),
            (_, Some(part)) => format!("left_{part}"),
            _ => name.to_owned(),
        };
        let (from, to) = (place(&other), place(name));
        for (axis, sign) in [-1.0, -1.0, 1.0].into_iter().enumerate() {
            image[to + axis] = sign * q[from + axis];
        }
    }
    (image[0], image[1], image[2]) = (-q[0], q[1], q[2]);
    image
}

#[test]
fn a_step_is_the_mirror_image_of_the_one_before() {
    let figure = figure();
    for step_frequency in [60.0, 110.0, 115.0, 118.0] {
        let plan = planned(&figure, step_frequency, 41);
        let (mut a, mut b) = (vec![0.0; figure.layout().nq()], vec![0.0; figure.layout().nq()]);
        for part in 0..40 {
            let u = 9.5 + f64::from(part) / 20.0;
            plan.configuration_at(u, &mut a);
            plan.configuration_at(u + 0.5, &mut b);
            let off = apart(&b, &mirrored(&figure, &a), plan.style().step_length);
            assert!(off < 1e-9, "{step_frequency}: {off:e} at {u}");
        }
    }
}
