//! Standard errors, against what errors of known size really do, over and over again.

use nalgebra::{DMatrix, DVector};
use solaris_analysis::markers::{IkOptions, inverse_kinematics, position_errors};
use solaris_analysis::{
    Answer, CUTOFF_FACTOR, Filter, InverseOptions, Loads, PreparedMotion, SpreadError, differentiate,
    filter_spread, inverse_motion, position_spread, residual_spread,
};
use solaris_dynamics::{Frame, Tree, Workspace, forward_kinematics, mass_matrix};
use solaris_model::{
    Figure, FigureBuilder, Joint, Known, LinkSpec, Marker, MarkerTrial, Motion, MotionInfo, Vector3, human,
};
use std::f64::consts::{PI, TAU};

const FRAMES: usize = 80;
const RATE: f64 = 50.0;
const CUTOFF: Filter = Filter { cutoff: 5.0, order: 2 };

/// Numbers between −1 and 1 that look random.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / 4_503_599_627_370_496.0 - 1.0
    }

    fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.next())
    }
}

/// A person's legs and trunk swing; every link has three markers.
fn person() -> (Figure, Vec<Marker>, Vec<f64>) {
    let figure = human(1.75, 73.0).expect("a person");
    let corners = [[0.1, 0.02, 0.0], [-0.05, 0.08, 0.03], [0.02, -0.06, 0.09]];
    let on = |link: usize| {
        corners.iter().enumerate().map(move |(i, corner)| Marker {
            name: format!("m{link}_{i}"),
            link,
            position: Vector3::from(*corner),
            is_fixed: false,
        })
    };
    let markers = (0..figure.links().len()).flat_map(on).collect();
    let nq = figure.layout().nq();
    let at = |frame: usize, k: usize| 0.3 * (5.0 * frame as f64 / RATE + 1.7 * k as f64).sin();
    let q = (0..FRAMES).flat_map(|frame| (0..nq).map(move |k| at(frame, k))).collect();
    (figure, markers, q)
}

/// Where markers are seen whose errors, in their links' frames, are these.
fn seen(
    figure: &Figure,
    markers: &[Marker],
    q: &[f64],
    error: impl Fn(usize, usize) -> Vector3<f64>,
) -> MarkerTrial {
    let tree = Tree::<f64>::new(figure, Vector3::zeros()).expect("finite");
    let mut workspace = Workspace::new(&tree);
    let mut points = Vec::new();
    for (frame, q) in q.chunks_exact(figure.layout().nq()).enumerate() {
        forward_kinematics(&tree, &mut workspace, q).expect("valid");
        let place = |(i, marker): (usize, &Marker)| {
            Frame::at(marker.link, marker.position + error(frame, i)).pose(&workspace).translation
        };
        points.extend(markers.iter().enumerate().map(place));
    }
    let names = markers.iter().map(|marker| marker.name.clone()).collect();
    let time = (0..FRAMES).map(|frame| frame as f64 / RATE).collect();
    MarkerTrial::new(names, time, points).expect("valid")
}

fn recorded(figure: &Figure, q: Vec<f64>) -> Motion {
    let time: Vec<f64> = (0..FRAMES).map(|frame| frame as f64 / RATE).collect();
    let info = MotionInfo::recorded(figure, Vector3::new(0.0, -9.81, 0.0), &time);
    let nv = figure.layout().nv();
    let still = vec![0.0; FRAMES * nv];
    Motion::recorded(figure, info, time, [q, still.clone(), still], Known::none(nv)).expect("valid")
}

fn ask(figure: &Figure, recorded: &Motion, filter: Filter) -> Answer {
    let motion = differentiate(figure, recorded, Some(filter)).expect("smooth").motion;
    let prepared = PreparedMotion::new(figure, &motion).expect("known");
    let forces = inverse_motion(&prepared, &Loads::none(), InverseOptions::default()).expect("finite").tau;
    Answer { motion, forces }
}

/// Root of the mean square over all frames, of each degree of freedom.
fn by_dof(values: &[f64], nv: usize) -> Vec<f64> {
    let of = |dof: usize| values.iter().skip(dof).step_by(nv).map(|x| x * x).sum::<f64>();
    (0..nv).map(|dof| (of(dof) / (values.len() / nv) as f64).sqrt()).collect()
}

/// What is predicted from two trials over what happened in many, of each degree of freedom's force.
fn ratios(error: impl Fn(&mut Random, usize) -> Vec<Vector3<f64>>) -> Vec<f64> {
    const TRIALS: u32 = 16;
    const PREDICTED: u32 = 2;
    let (figure, markers, q) = person();
    let nv = figure.layout().nv();
    let options = IkOptions::default();
    let truth = ask(&figure, &recorded(&figure, q.clone()), CUTOFF);
    let (mut actual, mut predicted) = (vec![0.0; nv], vec![0.0; nv]);
    for trial in 0..TRIALS {
        let errors = error(&mut Random(u64::from(trial) + 100), markers.len());
        let seen = seen(&figure, &markers, &q, |frame, marker| errors[frame * markers.len() + marker]);
        let found = inverse_kinematics(&figure, &markers, &seen, &options).expect("markers");
        let record = recorded(&figure, found.q.clone());
        let answer = ask(&figure, &record, CUTOFF);
        let off: Vec<f64> = answer.forces.iter().zip(&truth.forces).map(|(a, b)| a - b).collect();
        for (sum, off) in actual.iter_mut().zip(by_dof(&off, nv)) {
            *sum += off * off / f64::from(TRIALS);
        }
        if trial < PREDICTED {
            let samples = position_errors(&figure, &markers, &seen, &options, &found, 48).expect("markers");
            let ask = |moved: &Motion| Ok::<_, SpreadError>(ask(&figure, moved, CUTOFF));
            let spread = position_spread(&figure, &record, &answer, &samples, ask).expect("smooth");
            for (sum, spread) in predicted.iter_mut().zip(by_dof(&spread.forces, nv)) {
                *sum += spread * spread / f64::from(PREDICTED);
            }
        }
    }
    predicted.iter().zip(&actual).map(|(predicted, actual)| (predicted / actual).sqrt()).collect()
}

fn assert_near(mut ratios: Vec<f64>, median: f64, all: f64) {
    ratios.sort_by(f64::total_cmp);
    let middle = ratios[ratios.len() / 2];
    eprintln!(
        "predicted over actual error: {:.2} to {:.2}, median {middle:.2}",
        ratios[0],
        ratios[ratios.len() - 1]
    );
    assert!((1.0 / median..median).contains(&middle), "median {middle}");
    assert!(ratios.iter().all(|ratio| (1.0 / all..all).contains(ratio)), "{ratios:.2?}");
}

/// Errors of every frame by themselves: most of what they do comes of the accelerations.
#[test]
fn noise_spreads_as_it_does() {
    assert_near(
        ratios(|random, markers| (0..FRAMES * markers).map(|_| random.vector() * 0.008).collect()),
        1.1,
        1.3,
    );
}

/// Markers that sit elsewhere than the figure has them, on skin that slides with the motion: nothing of it is filtered out, and
/// 16 people are few.
#[test]
fn misplaced_markers_spread_as_they_do() {
    let errors = |random: &mut Random, markers: usize| {
        let of = |_| (random.vector() * 0.012, random.vector() * 0.008);
        let of: Vec<(Vector3<f64>, Vector3<f64>)> = (0..markers).map(of).collect();
        let at = |frame: usize, i: usize| of[i].0 + of[i].1 * (5.0 * frame as f64 / RATE + i as f64).sin();
        (0..FRAMES * markers).map(|k| at(k / markers, k % markers)).collect()
    };
    assert_near(ratios(errors), 1.2, 1.8);
}

/// Markers that fit have no errors, and a joint that none tells of is not made more uncertain than it can be.
#[test]
fn what_no_marker_tells_of_stays_bounded() {
    let (figure, markers, q) = person();
    let nv = figure.layout().nv();
    let hand = figure.link_index("left_hand").expect("a hand");
    let markers: Vec<Marker> = markers.into_iter().filter(|marker| marker.link != hand).collect();
    let options = IkOptions::default();
    let exact = seen(&figure, &markers, &q, |_, _| Vector3::zeros());
    let found = inverse_kinematics(&figure, &markers, &exact, &options).expect("markers");
    let errors = position_errors(&figure, &markers, &exact, &options, &found, 2).expect("markers");
    assert!(errors.iter().flatten().all(|error| error.abs() < 1e-6));

    // One is hidden for a while, another one all the time.
    let mut random = Random(5);
    let noise: Vec<Vector3<f64>> = (0..FRAMES * markers.len()).map(|_| random.vector() * 0.01).collect();
    let trial = seen(&figure, &markers, &q, |frame, marker| match (frame, marker) {
        (20..40, 3) | (_, 8) => Vector3::repeat(f64::NAN),
        _ => noise[frame * markers.len() + marker],
    });
    let found = inverse_kinematics(&figure, &markers, &trial, &options).expect("markers");
    let errors = position_errors(&figure, &markers, &trial, &options, &found, 16).expect("markers");
    assert_eq!((errors.len(), errors[0].len()), (16, FRAMES * nv));
    assert!(errors.iter().flatten().all(|error| error.abs() < 0.5), "an error beyond half a radian");
    let wrist = figure.layout().joints()[hand];
    assert!(errors[0].iter().skip(wrist.v).step_by(nv).all(|error| error.abs() < 1e-9));
    assert_eq!(errors, position_errors(&figure, &markers, &trial, &options, &found, 16).expect("markers"));
}

/// With the root accelerated by what the residual asks for, none is left, and every force is changed by its part of the spread.
#[test]
fn the_residual_is_explained_by_the_root() {
    let (figure, _, q) = person();
    let answer = ask(&figure, &recorded(&figure, q), CUTOFF);
    let (motion, nv) = (&answer.motion, figure.layout().nv());
    let prepared = PreparedMotion::new(&figure, motion).expect("known");
    let spread = residual_spread(&prepared, &answer.forces).expect("finite").forces;
    let mut a = motion.columns()[2].to_vec();
    for row in 0..FRAMES {
        let mut mass = DMatrix::zeros(nv, nv);
        mass_matrix(prepared.tree(), &mut Workspace::new(prepared.tree()), motion.q(row), &mut mass)
            .expect("finite");
        let left = DVector::from_column_slice(&answer.forces[row * nv..][..6]);
        let change = mass.view((0, 0), (6, 6)).into_owned().lu().solve(&left).expect("masses");
        (0..6).for_each(|i| a[row * nv + i] -= change[i]);
    }
    let [q, v, _] = motion.columns().map(<[f64]>::to_vec);
    let moved =
        Motion::recorded(&figure, motion.info.clone(), motion.time().to_vec(), [q, v, a], Known::all(nv));
    let moved = moved.expect("valid");
    let prepared = PreparedMotion::new(&figure, &moved).expect("known");
    let other = inverse_motion(&prepared, &Loads::none(), InverseOptions::default()).expect("finite").tau;
    for (k, (was, is)) in answer.forces.iter().zip(&other).enumerate() {
        assert!(k % nv >= 6 || is.abs() < 1e-8, "{is:e} is left");
        assert!(((was - is).abs() - spread[k]).abs() < 1e-8);
    }
}

/// The filter's gain is 1/(1 + (tan(πf/r)/tan(πf₀/r))²ⁿ): of a swing at 2 Hz without gravity the moment follows it.
#[test]
fn a_cut_off_changes_a_swing_by_the_filter_s_gain() {
    let rod = LinkSpec::root("rod", Joint::new("pivot").rz()).mass(2.0).com(Vector3::new(0.5, 0.0, 0.0));
    let figure = FigureBuilder::new("rod").link(rod).build().expect("valid");
    let (frames, rate, swing) = (400, 100.0, 2.0);
    let time: Vec<f64> = (0..frames).map(|frame| f64::from(frame) / rate).collect();
    let q = time.iter().map(|t| 0.2 * (TAU * swing * t).sin()).collect();
    let info = MotionInfo::recorded(&figure, Vector3::zeros(), &time);
    let still = vec![0.0; time.len()];
    let motion =
        Motion::recorded(&figure, info, time, [q, still.clone(), still], Known::none(1)).expect("valid");
    let filter = Filter { cutoff: 4.0, order: 2 };
    let answer = ask(&figure, &motion, filter);
    let spread =
        filter_spread(&figure, filter, &answer, |filter| Ok::<_, SpreadError>(ask(&figure, &motion, filter)))
            .expect("smooth");
    let gain = |cutoff: f64| {
        let ratio = (PI * swing / rate).tan() / (PI * cutoff / rate).tan();
        1.0 / (1.0 + ratio.powi(4))
    };
    let [less, as_asked, more] = [4.0 / CUTOFF_FACTOR, 4.0, 4.0 * CUTOFF_FACTOR].map(gain);
    let expected = f64::midpoint((less - as_asked).powi(2), (more - as_asked).powi(2)).sqrt() / as_asked;
    for row in 150..250 {
        let (part, force) = (spread.forces[row], answer.forces[row].abs());
        assert!((part - expected * force).abs() < 1e-3 * 2.0, "{part} of {force}");
    }
}

/// A cut-off that is near half the rate has no greater one; the smaller one tells what there is.
#[test]
fn a_cut_off_near_half_the_rate_is_held_against_a_smaller_one() {
    let (figure, _, q) = person();
    let record = recorded(&figure, q);
    let filter = Filter { cutoff: 0.45 * RATE, order: 2 };
    let answer = ask(&figure, &record, filter);
    let spread = filter_spread(&figure, filter, &answer, |filter| {
        assert!(filter.cutoff < RATE / 2.0, "{} Hz is no cut-off", filter.cutoff);
        Ok::<_, SpreadError>(ask(&figure, &record, filter))
    });
    let less = ask(&figure, &record, Filter { cutoff: filter.cutoff / CUTOFF_FACTOR, ..filter }).forces;
    let found = spread.expect("smooth").forces;
    for ((found, less), asked) in found.iter().zip(less).zip(answer.forces) {
        assert!((found - (less - asked).abs()).abs() < 1e-9);
    }
}

#[test]
fn errors_of_another_length_are_refused() {
    let (figure, _, q) = person();
    let record = recorded(&figure, q);
    let answer = ask(&figure, &record, CUTOFF);
    let refused = position_spread(&figure, &record, &answer, &[vec![0.0; 7]], |moved| {
        Ok::<_, SpreadError>(ask(&figure, moved, CUTOFF))
    });
    let expected = FRAMES * figure.layout().nv();
    assert_eq!(refused.expect_err("7 numbers"), SpreadError::Length { sample: 0, found: 7, expected });
}
