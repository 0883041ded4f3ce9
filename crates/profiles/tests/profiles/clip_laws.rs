//! What a clip does outside of its span.

use solaris_profiles::{Clip, Curve, Outside, Quintic, Sample};

fn close(found: Sample, wanted: Sample) -> bool {
    found.to_array().iter().zip(wanted.to_array()).all(|(x, y)| (x - y).abs() <= 1e-6 * (1.0 + y.abs()))
}

#[test]
fn a_mirrored_clip_turns_at_each_end_of_its_span_and_jumps_nowhere() {
    for duration in [0.1, 0.3, 0.7, 1.0] {
        let curve = Quintic::minimum_jerk(duration, 0.0, 1.0).expect("a curve");
        let clip = Clip::new(curve).outside(Outside::Mirror);
        for k in -20_i32..=20 {
            let turn = f64::from(k) * duration;
            let wanted = f64::from(k.rem_euclid(2));
            for time in [turn.next_down(), turn, turn.next_up()] {
                let found = clip.at(time).position;
                assert!((found - wanted).abs() < 1e-12, "{duration}, {k}: {found}, not {wanted}");
            }
            let (before, after) = (clip.at(turn - 0.03), clip.at(turn + 0.03));
            assert!(close(before, after.reversed()), "{duration}, {k}: {before:?} {after:?}");
        }
    }
}

#[test]
fn a_repeated_clip_is_the_same_in_every_period() {
    let curve = Quintic::minimum_jerk(0.3, 0.0, 1.0).expect("a curve");
    let clip = Clip::new(curve).starting(5.0).expect("a start").outside(Outside::Repeat);
    for k in -20_i32..=20 {
        for s in [0.01, 0.15, 0.29] {
            assert!(close(clip.at(5.0 + f64::from(k) * 0.3 + s), curve.at(s)), "{k} {s}");
        }
    }
}

#[test]
fn a_held_clip_rests_and_an_extrapolated_one_goes_on() {
    let curve =
        solaris_profiles::displacement::Tension::new(1.0_f64, (0.0, 2.0), (1.0, -3.0), 2.0).expect("a curve");
    let (held, on) = (Clip::new(curve), Clip::new(curve).outside(Outside::Extrapolate));
    assert_eq!((held.at(-1.0), held.at(4.0)), (Sample::rest(0.0), Sample::rest(1.0)));
    assert!((on.at(-0.5).position + 1.0).abs() < 1e-15 && (on.at(3.0).position + 5.0).abs() < 1e-14);
    assert!(on.at(f64::NAN).to_array().iter().all(|x| x.is_nan()));
    assert!(curve.extrapolated(f64::NAN).to_array().iter().all(|x: &f64| x.is_nan()));
}
