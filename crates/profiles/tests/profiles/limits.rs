//! Limits of docs/limits.md: taken at the limit, refused by name just beyond.

use solaris_profiles::blend::{Fade, FadeKind, Leaving};
use solaris_profiles::{Butterworth, Outside, Profile, ProfileLayer};

fn line(duration: f64) -> Profile {
    Profile::Line { from: 0.0, to: 1.0, duration }
}

/// Panics unless there is a curve of the first profile, and none of the second for something with `word` in it.
fn ends(at: &Profile, beyond: &Profile, word: &str) {
    let said = |profile: &Profile| profile.curve::<f64>().err().map(|error| error.to_string());
    assert_eq!(said(at), None, "at the limit");
    let beyond = said(beyond).expect("refused");
    assert!(beyond.contains(word), "beyond it: {beyond}");
}

#[test]
fn curves_come_again_a_million_times_at_most() {
    let sine = |cycles| Profile::Sine { amplitude: 1.0, period: 1.0, cycles, phase: 0.0, offset: 0.0 };
    ends(&sine(1e6), &sine(1e6_f64.next_up()), "cycles is 1000000.0000000001");
    let repeat = |times| Profile::Repeat { of: Box::new(line(1.0)), times };
    ends(&repeat(1_000_000), &repeat(1_000_001), "times is 1000001");
    let both = |times| Profile::Repeat { of: Box::new(sine(1000.0)), times };
    ends(&both(1000), &both(1001), "times is 1001000");
}

#[test]
fn exponents_and_orders_end_where_the_limits_say() {
    let curve = |exponent| Profile::ExponentialVelocities {
        from: 0.0,
        to: 1.0,
        duration: 1.0,
        exponent,
        shape: 0.5,
        start_velocity: 0.0,
        end_velocity: 0.0,
    };
    ends(&curve(100.0), &curve(101.0), "exponent is 101");
    assert!(Butterworth::low_pass(10, 6.0, 100.0).is_ok());
    let error = Butterworth::low_pass(11, 6.0, 100.0).expect_err("refused").to_string();
    assert!(error.contains("filter order 11: it must be 1 to 10"), "{error}");
}

#[test]
fn repeats_in_a_blend_and_before_it_are_counted() {
    let fade = Fade::new(FadeKind::Linear, 0.0, 1.0).expect("a fade");
    let blend = |start, duration| Profile::Blend {
        first: Box::new(ProfileLayer { start, outside: Outside::Repeat, ..line(1.0).into() }),
        second: Box::new(line(duration).into()),
        fade,
        leaving: Leaving::Allow,
    };
    ends(&blend(0.0, 1e5), &blend(0.0, 1e5 + 1.0), "number of repeats in the blend is 100001");
    ends(&blend(-1e9, 2.0), &blend(-1e9 - 1.0, 2.0), "number of repeats before the blend is 1000000001");
}
