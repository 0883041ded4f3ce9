//! Walks in the thesis's style: every posture met, what is planted stays, nothing sinks, and the laws that hold for any walk.

use crate::posed::Posed;
use approx::assert_relative_eq;
use nalgebra::Vector3;
use solaris_analysis::reactions_from_feet;
use solaris_gait::determinants::{Determinants, DoubleSupport};
use solaris_gait::{
    Extent, FEET, InBetween, StyledPlan, StyledRequest, ThesisRequest, ThesisWalk, thesis_walk,
};
use solaris_model::{EventKind, Figure, Trajectory, human};

fn walked(figure: &Figure, determinants: Determinants, step_frequency: f64, steps: usize) -> ThesisWalk {
    let request = ThesisRequest {
        determinants,
        step_frequency: Some(step_frequency),
        extent: Extent::Steps(steps),
        ..ThesisRequest::default()
    };
    thesis_walk(figure, &request).expect("it can be walked")
}

/// The lowest point of both soles over a walk (m), and when.
fn lowest(figure: &Figure, walk: &dyn Trajectory) -> (f64, f64) {
    let mut posed = Posed::new(figure, walk);
    let mut lowest = (f64::INFINITY, 0.0);
    let frames = (walk.duration() * 300.0) as usize;
    for t in (0..frames).map(|frame| frame as f64 / 300.0) {
        posed.pose(t);
        let y = posed.lowest(figure);
        lowest = if y < lowest.0 { (y, t) } else { lowest };
    }
    lowest
}

/// How far a planted point is from its place at most (m).
fn slide(figure: &Figure, plan: &ThesisWalk) -> f64 {
    let mut posed = Posed::new(figure, &plan.walk);
    let mut worst = 0.0_f64;
    for interval in plan.walk.planted(figure) {
        posed.pose(interval.start);
        let place = posed.at(interval.link, &interval.point);
        for k in 0..=40 {
            posed.pose(interval.start + (interval.end - interval.start) * f64::from(k) / 40.0);
            worst = worst.max((posed.at(interval.link, &interval.point) - place).norm());
        }
    }
    worst
}

#[test]
fn what_is_planted_stays_and_nothing_sinks() {
    for (height, mass) in [(1.75, 73.0), (1.2, 25.0), (2.0, 95.0)] {
        let figure = human(height, mass).expect("a person");
        for determinants in Determinants::ALL {
            for step_frequency in [70.0, 110.0, 125.0] {
                for in_between in [InBetween::Rest, InBetween::Linear] {
                    let request = ThesisRequest {
                        determinants,
                        step_frequency: Some(step_frequency),
                        extent: Extent::Steps(3),
                        in_between,
                        step_width: Some(0.07 * height),
                        sway: 0.012 * height,
                        ..ThesisRequest::default()
                    };
                    let plan = thesis_walk(&figure, &request).expect("it can be walked");
                    let case = format!("{height} {determinants:?} {step_frequency} {in_between:?}");
                    let (slide, lowest) = (slide(&figure, &plan), lowest(&figure, &plan.walk));
                    assert!(slide < 1e-8, "{case}: slides {slide:e} m");
                    assert!(lowest.0 > -1e-8, "{case}: sinks, {lowest:?}");
                }
            }
        }
    }
}

/// Pitch (rad, lower end behind) of the line from a link's joint to that of another one, or to a point.
fn pitch(from: Vector3<f64>, to: Vector3<f64>) -> f64 {
    let down = to - from;
    (-down.z).atan2(-down.y)
}

#[test]
fn every_posture_is_met() {
    let figure = human(1.75, 73.0).expect("a person");
    for determinants in Determinants::ALL {
        let plan = walked(&figure, determinants, 110.0, 3);
        let mut posed = Posed::new(&figure, &plan.walk);
        let [starting, intermediate, finishing] = &plan.postures.cycles;
        let all = starting.iter().chain(intermediate).chain(intermediate).chain(finishing);
        // The right foot swings first: it is the stance leg of every other cycle.
        let stance = [
            vec![0; starting.len()],
            vec![1; intermediate.len()],
            vec![0; intermediate.len()],
            vec![1; finishing.len()],
        ];
        let keys: Vec<(f64, &str)> = plan.walk.keys().collect();
        assert_eq!(keys.len(), stance.concat().len());
        for ((phase, stance), (time, name)) in all.zip(stance.concat()).zip(keys) {
            assert_eq!(phase.end.name, name);
            posed.pose(time);
            for (leg, angles) in phase.end.legs.iter().enumerate() {
                let side = ["left", "right"][if leg == 0 { stance } else { 1 - stance }];
                let place = |part: &str| {
                    let link = figure.link_index(&format!("{side}_{part}")).expect("a segment");
                    (link, posed.pose_of(link).translation)
                };
                let [thigh, shank, foot, toes] = ["thigh", "shank", "foot", "toes"].map(place);
                let toe = |link: usize| {
                    let forward = posed.pose_of(link).rotation * Vector3::z();
                    (-forward.y).atan2(forward.z)
                };
                // The pelvis' tilt and turn narrow the hips, and legs that lean to the side by 0.1° reach 1e-7 m less: straight
                // ones bend by 0.01° for that.
                for (wanted, is) in [
                    (angles.thigh, pitch(thigh.1, shank.1)),
                    (angles.shank, pitch(shank.1, foot.1)),
                    (angles.foot, toe(foot.0)),
                    (angles.toes, toe(toes.0)),
                ] {
                    assert!(
                        (is - wanted).abs() < 3e-4,
                        "{determinants:?} {name} {side}: {is} and not {wanted}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_hundred_strides_close() {
    let figure = human(1.75, 73.0).expect("a person");
    for determinants in Determinants::ALL {
        let plan = walked(&figure, determinants, 100.0, 210);
        let (step, time) = (plan.step_length, plan.walk.step_time());
        let (mut a, mut b) = (vec![0.0; figure.layout().nq()], vec![0.0; figure.layout().nq()]);
        let first = plan.walk.stride_loop().expect("a stride");
        assert_relative_eq!(first.speed(), step / time, max_relative = 1e-12);
        for k in 0..50 {
            let t = 2.0 + 2.0 * time * f64::from(k) / 50.0;
            plan.walk.configuration(t, &mut a);
            plan.walk.configuration(t + 200.0 * time, &mut b);
            b[2] -= 200.0 * step;
            let off = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-9, "{determinants:?} {t}: {off:e}");
        }
        assert_relative_eq!(*plan.walk.prints().last().expect("prints"), 210.0 * step, max_relative = 1e-14);
    }
}

#[test]
fn a_stride_mirrors_itself_a_step_later() {
    let figure = human(1.75, 73.0).expect("a person");
    for determinants in Determinants::ALL {
        let plan = walked(&figure, determinants, 100.0, 8);
        let other = ThesisRequest {
            determinants,
            step_frequency: Some(100.0),
            extent: Extent::Steps(8),
            left_first: true,
            ..ThesisRequest::default()
        };
        let other = thesis_walk(&figure, &other).expect("it can be walked");
        let (mut a, mut b) = (vec![0.0; figure.layout().nq()], vec![0.0; figure.layout().nq()]);
        let coordinate = |name: &str, axis: usize| {
            let link = figure.link_index(name).expect("a segment");
            figure.layout().joints()[link].q + axis
        };
        for k in 0..80 {
            let t = other.walk.duration() * f64::from(k) / 80.0;
            plan.walk.configuration(t, &mut a);
            other.walk.configuration(t, &mut b);
            for part in ["thigh", "shank", "foot", "upper_arm"] {
                for (axis, sign) in [(0, -1.0), (1, -1.0), (2, 1.0)] {
                    let left = a[coordinate(&format!("left_{part}"), axis)];
                    let right = b[coordinate(&format!("right_{part}"), axis)];
                    assert!(
                        (left - sign * right).abs() < 1e-12,
                        "{determinants:?} {part} {axis}: {left} {right}"
                    );
                }
            }
            assert!((a[0] + b[0]).abs() < 1e-12 && (a[2] - b[2]).abs() < 1e-12);
        }
    }
}

/// From rest to rest the ground's impulse is the weight's, whatever forces lie between.
#[test]
fn the_mean_vertical_force_is_the_weight_and_no_force_depends_on_the_root() {
    let figure = human(1.75, 73.0).expect("a person");
    for determinants in Determinants::ALL {
        let request = ThesisRequest { determinants, extent: Extent::Steps(3), ..ThesisRequest::default() };
        let plan = StyledPlan::of(&figure, &StyledRequest::Thesis(request)).expect("it can be walked");
        let (mut motion, _) = plan.loaded(&figure, 480.0).expect("forces");
        let frames = motion.len() - 1;
        let vertical = |frame: usize| -> f64 {
            FEET.iter().map(|foot| motion.contact(foot).expect("a foot").samples[frame].force.y).sum()
        };
        let mean = (0..frames).map(vertical).sum::<f64>() / frames as f64;
        let weight = figure.mass() * 9.80665;
        assert_relative_eq!(mean, weight, max_relative = 2e-3);
        let scale = (0..frames).map(|frame| vertical(frame).abs()).fold(0.0, f64::max);
        let rooted = reactions_from_feet(&figure, &mut motion, FEET).expect("from the feet");
        assert!(
            rooted.reaction_force < 1e-9 * scale,
            "{determinants:?}: {} of {scale} N",
            rooted.reaction_force
        );
        assert!(rooted.torque < 1e-9 * scale, "{determinants:?}: {} N m", rooted.torque);
    }
}

#[test]
fn steps_and_phases_last_as_long_as_is_asked() {
    let figure = human(1.75, 73.0).expect("a person");
    for law in [DoubleSupport::Thesis, DoubleSupport::Measured] {
        let request = ThesisRequest {
            step_frequency: Some(100.0),
            extent: Extent::Distance(5.0),
            double_support: Some(law),
            ..ThesisRequest::default()
        };
        let plan = thesis_walk(&figure, &request).expect("it can be walked");
        assert_relative_eq!(*plan.walk.prints().last().expect("prints"), 5.0, max_relative = 1e-14);
        let events = plan.walk.events();
        let of = |down: bool| -> Vec<f64> {
            let kind = |kind: &EventKind| matches!(kind, EventKind::TouchDown { .. }) == down;
            events.iter().filter(|event| kind(&event.kind)).map(|event| event.time).collect()
        };
        let (touches, lifts) = (of(true), of(false));
        assert_eq!(touches.len(), plan.steps + 1);
        for k in 0..plan.steps - 1 {
            assert!((touches[k + 1] - touches[k] - 0.6).abs() < 1e-12);
            // From the touch to the next lift: the double support.
            let double = lifts.iter().find(|lift| **lift > touches[k]).expect("a lift") - touches[k];
            assert_relative_eq!(double, 0.6 * law.part_of_step(100.0), max_relative = 1e-9);
        }
    }
}

/// The printed postures of three determinants slide the toe that they have on the ground, as the table's choice does by 179 mm.
#[test]
fn three_determinants_say_how_far_a_toe_would_slide() {
    let figure = human(1.75, 73.0).expect("a person");
    let slide =
        |determinants, step_frequency| walked(&figure, determinants, step_frequency, 3).walk.toe_slide();
    assert_eq!(slide(Determinants::Five, 105.0), None);
    let at_105 = slide(Determinants::Three, 105.0).expect("a slide");
    assert!((0.1..0.4).contains(&at_105), "{at_105}");
    let at_70 = slide(Determinants::Three, 70.0).expect("a slide");
    assert!(at_70 < at_105, "{at_70} {at_105}");
}

/// Where the slide changes its sign it is less than a tenth of a millimetre: still too much for a point that is planted.
#[test]
fn a_toe_that_would_slide_by_a_hair_is_lifted() {
    for (height, mass) in [(1.75, 73.0), (1.2, 25.0), (2.0, 95.0)] {
        let figure = human(height, mass).expect("a person");
        let plan = |step_frequency| walked(&figure, Determinants::Three, step_frequency, 3);
        let would_slide = |step_frequency| plan(step_frequency).walk.toe_slide();
        let (mut backward, mut forward) = (50.0, 70.0);
        for _ in 0..12 {
            let middle = 0.5 * (backward + forward);
            if would_slide(middle).expect("a slide") > 0.0 { forward = middle } else { backward = middle }
        }
        let hair = would_slide(forward).expect("a slide");
        assert!((1e-6..1e-4).contains(&hair), "{hair}");
        let slide = slide(&figure, &plan(forward));
        assert!(slide < 1e-8, "{height}: slides {slide:e} m");
    }
}
