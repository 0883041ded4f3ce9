//! Dynamic similarity: at the same Froude number people of other sizes walk alike, lengths in proportion to height, angles and
//! forces over weight the same.
//!
//! Times go with the square root of height, masses are free. This is so of laws, solve and postures, not of what is chosen for
//! them: a style's numbers and the double support depend on the step frequency in steps a minute, and the trunk of five
//! determinants on the speed in m/s. What was chosen for one walk is therefore given to the other.

use crate::posed::Posed;
use solaris_gait::determinants::{Determinants, DoubleSupport, Proportions};
use solaris_gait::{
    Extent, InBetween, KeyScript, KeyframedOptions, KeyframedWalk, Resolution, ScriptCycle, StridePlan,
    Style, WalkPlan, WalkRequest, walk,
};
use solaris_model::{Figure, Trajectory, human};

/// Heights (m) with masses (kg) that are in no proportion to each other.
const OTHERS: [(f64, f64); 3] = [(1.2, 40.0), (1.5, 38.0), (2.0, 140.0)];
const HEIGHT: f64 = 1.75;
const GRAVITY: f64 = 9.80665;

fn figure() -> Figure {
    human(HEIGHT, 73.0).expect("a person")
}

/// A style for a body `scale` times as high: lengths with it, times with its root, all that has no dimension as it is.
fn scaled(style: &Style, scale: f64) -> Style {
    Style {
        step_frequency: style.step_frequency / scale.sqrt(),
        stride_time: style.stride_time * scale.sqrt(),
        step_length: style.step_length * scale,
        step_width: style.step_width * scale,
        clearance: style.clearance * scale,
        ..*style
    }
}

/// The greatest difference of two walks at the same parts of their time: of joint centres, in heights of the first one, and of
/// angles (rad).
fn apart(figures: [&Figure; 2], walks: [&dyn Trajectory; 2], scale: f64) -> (f64, f64) {
    let nq = figures[0].layout().nq();
    let (mut a, mut b) = (vec![0.0; nq], vec![0.0; nq]);
    let mut poses = [0, 1].map(|i| Posed::new(figures[i], walks[i]));
    let (mut lengths, mut angles) = (0.0_f64, 0.0_f64);
    for k in 0..=400 {
        let times = [0, 1].map(|i| walks[i].duration() * f64::from(k) / 400.0);
        walks[0].configuration(times[0], &mut a);
        walks[1].configuration(times[1], &mut b);
        angles = (3..nq).map(|i| (a[i] - b[i]).abs()).fold(angles, f64::max);
        for (posed, time) in poses.iter_mut().zip(times) {
            posed.pose(time);
        }
        for link in 0..figures[0].links().len() {
            let [here, there] = [0, 1].map(|i| poses[i].pose_of(link).translation);
            lengths = lengths.max((here - there / scale).amax());
        }
    }
    (lengths / HEIGHT, angles)
}

#[test]
fn smooth_walks_of_one_froude_number_are_similar() {
    let figure = figure();
    // More passes than usual: the first guess of the centre of mass is 5 cm above anybody's pelvis, and a pass lowers heights
    // by no more than 1 cm; both are forgotten as the passes go on.
    // A stride's 50 nodes resolve the knots of the height, a twentieth of a stride apart.
    let resolution = Resolution { nodes: 50, stride_passes: 40, walk_passes: 50 };
    for step_frequency in [80.0, 110.0] {
        let asked = WalkRequest {
            step_frequency: Some(step_frequency),
            extent: Extent::Steps(1),
            ..WalkRequest::default()
        };
        let style = *walk(&figure, &asked).expect("a style").style();
        let planned = |figure: &Figure, style: &Style| {
            let stride = StridePlan::new(figure, style, resolution).expect("a stride");
            (WalkPlan::new(&stride, 3, resolution).expect("a walk"), stride)
        };
        let (mine, stride) = planned(&figure, &style);
        for (height, mass) in OTHERS {
            let other = human(height, mass).expect("a person");
            let scale = height / HEIGHT;
            let (theirs, other_stride) = planned(&other, &scaled(&style, scale));
            let froude = |plan: &WalkPlan| {
                let speed = plan.style().step_length / plan.style().stride_time;
                speed * speed / (GRAVITY * plan.stature())
            };
            assert!((froude(&mine) / froude(&theirs) - 1.0).abs() < 1e-12);

            let case = format!("{step_frequency} steps/min, {height} m, {mass} kg");
            let (lengths, angles) = apart([&figure, &other], [&mine, &theirs], scale);
            assert!(lengths < 1e-10 && angles < 1e-9, "{case}: {lengths:e} of the height, {angles:e} rad");
            for (a, b) in mine.prints().iter().zip(theirs.prints()) {
                assert!((a - b / scale).abs() < 1e-12, "{case}: print {a} and not {b}");
            }
            let raised = stride.mean_height() - other_stride.mean_height() / scale;
            assert!(raised.abs() < 1e-11, "{case}: the stride's mean height is off by {raised:e} m");
            // Forces over mass, moments over mass and height.
            for node in 0..mine.nodes().0 {
                let com = (mine.com(node) - theirs.com(node) / scale).amax();
                assert!(com < 1e-10, "{case}: the centre of mass is off by {com:e} m at node {node}");
                for (a, b) in mine.forces(node).iter().zip(theirs.forces(node)) {
                    let force = (a.force / figure.mass() - b.force / mass).amax() / GRAVITY;
                    let moment = (a.moment / figure.mass() - b.moment / (mass * scale)).amax() / GRAVITY;
                    assert!(force < 1e-10 && moment < 1e-10, "{case}: {force:e} {moment:e} at node {node}");
                    assert!((a.cop - b.cop / scale).amax() < 1e-10, "{case}: at node {node}");
                }
            }
        }
    }
}

/// A walk through key postures whose parameters, speed of the trunk, and times of phases are those of a person of
/// [`HEIGHT`].
fn keyframed(
    figure: &Figure,
    determinants: Determinants,
    in_between: InBetween,
    step_frequency: f64,
) -> KeyframedWalk {
    let own = Proportions::of(figure).expect("proportions");
    let scale = own.height / HEIGHT;
    let p = own.scaled(1.0 / scale);
    let step_length = 0.004 * HEIGHT * step_frequency;
    let values = determinants.automatic(&p, step_frequency, step_length).expect("parameters");
    let speed = step_length * step_frequency / 60.0;
    let parts = determinants.solve(&p, &values, speed).expect("postures").parts(
        &p,
        Some(DoubleSupport::Thesis),
        step_frequency,
    );
    // Of the parameters only lengths are other ones.
    let theirs: Vec<f64> = determinants
        .parameters(&own)
        .iter()
        .zip(&values)
        .map(|(parameter, value)| if parameter.unit == " m" { value * scale } else { *value })
        .collect();
    let [a, b, c] = determinants.solve(&own, &theirs, speed).expect("postures").cycles;
    let [d, e, f] = parts;
    let script = KeyScript {
        cycles: [(a, d), (b, e), (c, f)].map(|(phases, parts)| ScriptCycle { phases, parts }),
        steps: 3,
        step_length: step_length * scale,
        step_time: 60.0 / step_frequency * scale.sqrt(),
    };
    let options = KeyframedOptions {
        in_between,
        step_width: Some(0.1 * scale),
        sway: 0.02 * scale,
        clearance: 0.015 * scale,
        left_first: false,
    };
    KeyframedWalk::new(figure, &script, options).expect("a walk")
}

#[test]
fn walks_through_key_postures_of_one_froude_number_are_similar() {
    let figure = figure();
    for determinants in Determinants::ALL {
        for in_between in [InBetween::Rest, InBetween::Linear] {
            for step_frequency in [80.0, 110.0] {
                let mine = keyframed(&figure, determinants, in_between, step_frequency);
                for (height, mass) in OTHERS {
                    let other = human(height, mass).expect("a person");
                    let scale = height / HEIGHT;
                    let theirs = keyframed(&other, determinants, in_between, step_frequency);
                    let case = format!("{determinants:?}, {in_between:?}, {step_frequency}, {height} m");
                    let (lengths, angles) = apart([&figure, &other], [&mine, &theirs], scale);
                    // The angle of a straight knee is an arc cosine of 1: what rounding takes from that, 2e-16, is 2e-8 rad.
                    assert!(
                        lengths < 2e-8 && angles < 2e-7,
                        "{case}: {lengths:e} of the height, {angles:e} rad"
                    );
                    for (a, b) in mine.prints().iter().zip(theirs.prints()) {
                        assert!((a - b / scale).abs() < 1e-12, "{case}: print {a} and not {b}");
                    }
                }
            }
        }
    }
}
