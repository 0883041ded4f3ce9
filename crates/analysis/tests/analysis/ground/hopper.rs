//! Motions whose true forces are known: a body on one foot that jumps, from a box too, and a sitter.

use crate::ground::support::GRAVITY;
use crate::states::{States, find_stances, ground_forces};
use approx::assert_relative_eq;
use solaris_analysis::ground::{
    Belt, ElsewhereKind, GroundForces, GroundOptions, Sole, StanceOptions, Stances, soles,
};
use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, SolePart, Vector3};

const G: f64 = 9.806_65;
const RATE: f64 = 200.0;

/// A foot of 1 kg that slides in three directions, and a body of 70 kg that slides up and down on it.
fn hopper() -> Figure {
    let foot = LinkSpec::root("foot", Joint::new("root").tx().ty().tz()).mass(1.0);
    let foot = foot
        .sole(SolePart::Heel, Vector3::new(-0.05, 0.0, 0.0))
        .sole(SolePart::Ball, Vector3::new(0.1, 0.0, 0.0))
        .sole(SolePart::ToeTip, Vector3::new(0.15, 0.0, 0.0));
    let joint = Joint::new("leg").at(Vector3::new(0.05, 0.0, 0.0)).ty();
    let body = LinkSpec::child("body", "foot", joint).mass(70.0).com(Vector3::zeros());
    FigureBuilder::new("hopper").link(foot).link(body).build().expect("valid")
}

/// One flight: from when, for how long (s), from and to which height (m), how fast forward (m/s).
struct Flight {
    start: f64,
    time: f64,
    from: f64,
    to: f64,
    forward: f64,
}

/// Stands, flies, stands: the foot is still on the ground and thrown in the air. The body is still on the foot in flight; on the ground it
/// moves so that the force is the weight, whatever it takes.
fn jumps(flights: &[Flight], length: f64) -> States {
    let mut out = States::default();
    for row in 0..=(length * RATE) as usize {
        let t = row as f64 / RATE;
        let (mut x, mut y) = (0.0, flights[0].from);
        let (mut v, mut a) = (Vector3::zeros(), Vector3::zeros());
        for flight in flights.iter().filter(|flight| t >= flight.start) {
            let s = t - flight.start;
            // Thrown so that it is at the other height in time.
            let up = (flight.to - flight.from) / flight.time + 0.5 * G * flight.time;
            if s < flight.time {
                (x, y) = (x + flight.forward * s, flight.from + up * s - 0.5 * G * s * s);
                (v, a) = (Vector3::new(flight.forward, up - G * s, 0.0), Vector3::new(0.0, -G, 0.0));
            } else {
                (x, y) = (x + flight.forward * flight.time, flight.to);
            }
        }
        out.time.push(t);
        out.q.extend([x, y, 0.0, 0.8]);
        out.v.extend([v.x, v.y, 0.0, 0.0]);
        out.a.extend([a.x, a.y, 0.0, 0.0]);
    }
    out
}

fn found(states: &States) -> GroundForces {
    let figure = hopper();
    ground_forces(&figure, GRAVITY, states, &soles(&figure), &GroundOptions::default()).expect("forces")
}

fn spans(stances: &Stances) -> Vec<[f64; 2]> {
    stances.list.iter().map(|stance| [stance.start, stance.end]).collect()
}

#[test]
fn jumps_are_found_to_a_frame_and_nobody_stands_in_the_air() {
    let flight = |start, forward| Flight { start, time: 0.4, from: 0.0, to: 0.0, forward };
    let states = jumps(&[flight(0.5025, 0.0), flight(1.4025, 3.0)], 2.5);
    let ground = found(&states);
    let expected = [[0.0, 0.5025], [0.9025, 1.4025], [1.8025, 2.5]];
    let spans = spans(&ground.stances);
    assert_eq!(spans.len(), 3, "{spans:?}");
    for (found, expected) in spans.iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() <= 1.0 / RATE, "{spans:?}");
    }
    for (sample, t) in ground.contacts[0].samples.iter().zip(&states.time) {
        let flies = [0.5025, 1.4025].iter().any(|start| (0.0..0.4).contains(&(t - start)));
        let force = if flies { 0.0 } else { 71.0 * G };
        assert_relative_eq!(sample.force, Vector3::new(0.0, force, 0.0), epsilon = 1e-9);
    }
    assert!(ground.report.unsupported.force < 1e-9 && ground.report.elsewhere.is_empty());
    // Half of the time that the foot is low it flies forward at 3 m/s; that is no belt.
    assert_eq!(ground.stances.belt, Vector3::zeros());
}

#[test]
fn who_stands_on_a_box_stands_and_it_is_said() {
    let ground = found(&jumps(&[Flight { start: 0.6, time: 0.5, from: 0.4, to: 0.0, forward: 0.8 }], 3.0));
    let spans = spans(&ground.stances);
    assert_eq!(spans.len(), 2, "{spans:?}");
    assert!((spans[0][1] - 0.6).abs() <= 1.0 / RATE && (spans[1][0] - 1.1).abs() <= 1.0 / RATE, "{spans:?}");
    let [raised] = ground.report.elsewhere[..] else { panic!("{:?}", ground.report.elsewhere) };
    assert_eq!((raised.kind, raised.foot, raised.start), (ElsewhereKind::Raised, Some(0), 0.0));
    assert_relative_eq!(raised.distance, 0.4, epsilon = 1e-12);
}

/// Two feet of nothing much before a pelvis of 60 kg, which is where the legs hang.
fn sitter() -> (Figure, Vec<Sole>) {
    let pelvis = LinkSpec::root("pelvis", Joint::new("root").tx().ty().tz()).mass(60.0);
    let leg = |name: &str, z: f64| {
        let hip = Joint::new(format!("{name}_hip")).at(Vector3::new(0.0, 0.0, z)).rz();
        let spec = LinkSpec::child(name, "pelvis", hip).mass(1.0).com(Vector3::new(0.4, -0.5, 0.0));
        let point = |x| Vector3::new(x, -0.5, 0.0);
        spec.sole(SolePart::Heel, point(0.4))
            .sole(SolePart::Ball, point(0.58))
            .sole(SolePart::ToeTip, point(0.64))
    };
    let figure = FigureBuilder::new("sitter").link(pelvis).link(leg("left", 0.1)).link(leg("right", -0.1));
    let figure = figure.build().expect("valid");
    let own = soles(&figure);
    (figure, own)
}

#[test]
fn a_seat_is_said_with_where_and_how_much() {
    let (figure, soles) = sitter();
    let nv = figure.layout().nv();
    let time: Vec<f64> = (0..50).map(|row| f64::from(row) / 50.0).collect();
    let zeros = vec![0.0; nv * time.len()];
    let mut q = zeros.clone();
    (0..time.len()).for_each(|row| q[row * nv + 1] = 0.5);
    let states = States { time, q, v: zeros.clone(), a: zeros, ..States::default() };
    let ground = ground_forces(&figure, GRAVITY, &states, &soles, &GroundOptions::default()).expect("forces");
    let [seat] = ground.report.elsewhere[..] else { panic!("{:?}", ground.report.elsewhere) };
    assert_eq!((seat.kind, seat.start, seat.end), (ElsewhereKind::Beside, 0.0, 0.98));
    // Of 62 kg two are at x = 0.4 m and the rest at 0; the heels are at 0.4 m, the hips at 0.
    let place = 2.0 * 0.4 / 62.0;
    assert_relative_eq!(seat.place, Vector3::new(place, 0.0, 0.0), epsilon = 1e-12);
    assert_relative_eq!(seat.distance, 0.4 - place, epsilon = 1e-12);
    assert_relative_eq!(seat.share.expect("the hips are out there"), 60.0 / 62.0, epsilon = 1e-12);
}

#[test]
fn feet_that_come_down_fast_stand_where_the_force_says_so() {
    // A long way down: 5 m/s when it lands. On the ground since, with no speed but in the air.
    let states = jumps(&[Flight { start: 0.0, time: 1.0, from: 1.3, to: 0.0, forward: 0.0 }], 2.0);
    let figure = hopper();
    for belt in [Belt::Auto, Belt::Still] {
        let options = StanceOptions { belt, ..StanceOptions::default() };
        let found = find_stances(&figure, GRAVITY, &states, &soles(&figure), &options).expect("stances");
        let spans = spans(&found);
        assert!(spans.len() == 1 && (spans[0][0] - 1.0).abs() <= 1.0 / RATE, "{spans:?}");
    }
}
