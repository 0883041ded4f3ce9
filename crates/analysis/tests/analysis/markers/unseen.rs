//! What is not seen for a while, and where the figure is not known.

use super::{changed, markers, seen, solve, swaying};
use solaris_analysis::markers::IkOptions;
use solaris_model::{Base, FigureBuilder, Joint, LinkSpec, Vector3, human};

/// An arm whose markers are hidden for a fifth of a second goes on from where it was to where it is seen again; everything else is
/// where it is.
#[test]
fn a_hidden_arm_is_led_on() {
    let figure = human(1.75, 73.0).expect("a person");
    let markers = markers(&figure, 4);
    let poses = swaying(&figure, 60, 0.4);
    let is_arm: Vec<bool> = markers
        .iter()
        .map(|marker| {
            let name = figure.links()[marker.link].name();
            ["left_upper_arm", "left_forearm", "left_hand"].contains(&name)
        })
        .collect();
    assert!(is_arm.iter().filter(|is| **is).count() >= 8, "an arm with markers");
    let trial = changed(&seen(&figure, &markers, &poses), |frame, marker, point| {
        if is_arm[marker] && (20..40).contains(&frame) { Vector3::repeat(f64::NAN) } else { point }
    });
    let found = solve(&figure, &markers, &trial, &IkOptions::default());
    let nq = figure.layout().nq();
    assert!(found.frames[30].blind > 0 && found.frames[30].is_placed && found.frames[45].blind == 0);
    let greatest =
        |q: &dyn Fn(usize) -> f64| (1..60).map(|frame| (q(frame) - q(frame - 1)).abs()).fold(0.0, f64::max);
    for k in 0..nq {
        let [ours, truth] = [found.q.clone(), poses.concat()].map(|q| move |frame: usize| q[frame * nq + k]);
        let off = (0..60).map(|frame| (ours(frame) - truth(frame)).abs()).fold(0.0, f64::max);
        assert!(off < 0.05, "coordinate {k} is off by {off} rad");
        let (step, own) = (greatest(&ours), greatest(&truth));
        assert!(step < 2.0 * own + 1e-9, "coordinate {k} jumps by {step} rad, not {own}");
    }
}

/// What turns evenly before it is hidden and after goes on doing so; what turns on one side only leaves or comes to rest, by the cubic with these ends.
#[test]
fn a_hidden_hinge_goes_on_as_it_came_and_as_it_leaves() {
    let hinge = Joint::new("hinge").rz().at(Vector3::x() * 0.3);
    let figure = FigureBuilder::new("f")
        .link(LinkSpec::root("a", Joint::new("shoulder").rz()).mass(1.0))
        .link(LinkSpec::child("b", "a", hinge).mass(1.0))
        .build()
        .expect("valid");
    let markers = markers(&figure, 4);
    let (rate, from, to) = (0.02, 10, 30);
    let evenly = |frame: usize| rate * frame as f64;
    let leaving = |frame: usize| rate * frame.min(to) as f64;
    let coming = |frame: usize| rate * frame.max(from) as f64;
    for angle in [&evenly as &dyn Fn(usize) -> f64, &leaving, &coming] {
        let poses: Vec<Vec<f64>> = (0..41).map(|frame| vec![0.1, angle(frame)]).collect();
        let hidden = |frame: usize, marker: usize| marker >= 4 && frame > from && frame < to;
        let trial = changed(&seen(&figure, &markers, &poses), |frame, marker, point| {
            if hidden(frame, marker) { Vector3::repeat(f64::NAN) } else { point }
        });
        let found = solve(&figure, &markers, &trial, &IkOptions::default());
        let lasts = (to - from) as f64;
        let slopes = [angle(from) - angle(from - 1), angle(to + 1) - angle(to)].map(|step| step * lasts);
        for frame in from..=to {
            let s = (frame - from) as f64 / lasts;
            let rise = (3.0 - 2.0 * s) * s * s * (angle(to) - angle(from));
            let expected = angle(from) + rise + s * (1.0 - s) * ((1.0 - s) * slopes[0] - s * slopes[1]);
            let off = (found.q[2 * frame + 1] - expected).abs();
            assert!(off < 1e-6, "frame {frame} is off by {off}");
        }
    }
}

/// Before the first and after the last frame that tells, nothing moves; without markers of the root nobody knows where it is.
#[test]
fn what_is_never_seen_again_stays() {
    let figure = FigureBuilder::new("f")
        .link(LinkSpec::root("a", Joint::new("ground")).mass(1.0))
        .link(LinkSpec::child("b", "a", Joint::ball("hip").at(Vector3::new(0.0, -0.2, 0.0))).mass(1.0))
        .build()
        .expect("valid")
        .on_base(Base::Free)
        .expect("a base");
    let markers = markers(&figure, 4);
    let pose = |frame: usize| {
        let angle = 0.02 * frame as f64;
        let mut q = vec![
            0.1 * frame as f64,
            1.0,
            0.0,
            angle.cos(),
            angle.sin(),
            0.0,
            0.0,
            angle.cos(),
            0.0,
            0.0,
            angle.sin(),
        ];
        figure.normalize(&mut q).expect("valid");
        q
    };
    let poses: Vec<Vec<f64>> = (0..50).map(pose).collect();
    let trial = changed(&seen(&figure, &markers, &poses), |frame, marker, point| {
        let is_hidden = !(8..45).contains(&frame) || (marker >= 4 && (20..30).contains(&frame));
        if is_hidden { Vector3::repeat(f64::NAN) } else { point }
    });
    let found = solve(&figure, &markers, &trial, &IkOptions::default());
    let placed: Vec<bool> = found.frames.iter().map(|frame| frame.is_placed).collect();
    assert_eq!(placed, (0..50).map(|frame| (8..45).contains(&frame)).collect::<Vec<_>>());
    let at = |frame: usize| &found.q[frame * 11..][..11];
    for (frame, expected) in poses.iter().enumerate() {
        // The ball's turn is even, so that the shortest way is the true one.
        let expected = if frame < 8 {
            at(8)
        } else if frame >= 45 {
            at(44)
        } else {
            expected
        };
        let off = figure.distance(at(frame), expected).expect("valid");
        assert!(off < 1e-6, "frame {frame} is off by {off}");
    }
}
