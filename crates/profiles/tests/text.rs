//! Profiles as text: all that is written is read, here and by others, and what cannot be read says where and why.

use proptest::prelude::*;
use solaris_profiles::blend::{Fade, FadeKind, Leaving};
use solaris_profiles::{Kind, Outside, Parameter, Profile, ProfileLayer, text};

/// Values that make a curve of most kinds, with all their digits.
fn value(parameter: &Parameter, share: f64) -> f64 {
    let (low, high) = match parameter.name {
        "duration" => (1.5, 3.0),
        "rise" | "third time" => (0.3, 0.7),
        "fall" => (0.8, 1.2),
        "exponent" if *parameter == Parameter::WHOLE_EXPONENT => return 3.0 + (4.0 * share).floor(),
        "exponent" => (1.5, 5.0),
        "shape" | "from" => (-1.0, 0.0),
        "stiffness" | "largest velocity" | "largest acceleration" | "largest jerk" => (0.5, 4.0),
        "to" => (0.5, 2.0),
        "tension" | "continuity" | "bias" => (-0.5, 0.5),
        _ => (0.1, 1.0),
    };
    low + share * (high - low)
}

fn of_kind(kind: &Kind, shares: &[f64]) -> Profile {
    let position = |parameter: &Parameter| {
        kind.parameters().position(|known| known == parameter).expect("one of its own")
    };
    let keys = (0..4).map(|i| (f64::from(i) + 0.5 * shares[i as usize], 2.0 * shares[4 + i as usize] - 1.0));
    kind.profile(|parameter| Some(value(parameter, shares[position(parameter)])), keys.collect())
        .expect("all parameters have values")
}

/// A profile of any kind that has a curve.
fn single() -> impl Strategy<Value = Profile> {
    let kinds = 0..Profile::KINDS.len();
    let any = (kinds, proptest::collection::vec(0.0_f64..1.0, 8));
    let any = any.prop_map(|(kind, shares)| of_kind(&Profile::KINDS[kind], &shares));
    any.prop_filter("no curve", |profile| profile.curve::<f64>().is_ok())
}

fn fade() -> impl Strategy<Value = Fade> {
    let kind = prop_oneof![
        Just(FadeKind::Linear),
        Just(FadeKind::Smooth),
        (0.1..0.6).prop_map(|stiffness| FadeKind::Exponential { stiffness }),
        (0.1..3.0).prop_map(|stiffness| FadeKind::Sinh { stiffness }),
        (0.1..1.5).prop_map(|stiffness| FadeKind::Trigonometric { stiffness }),
    ];
    (kind, 0.0..0.5, 0.6..1.2).prop_map(|(kind, start, end)| Fade::new(kind, start, end).expect("a fade"))
}

fn layer(profile: impl Strategy<Value = Profile>) -> impl Strategy<Value = ProfileLayer> {
    use Outside::{Extrapolate, Hold, Mirror, Repeat};
    let outside = proptest::sample::select(vec![Hold, Extrapolate, Repeat, Mirror]);
    let fades = (proptest::option::of(fade()), proptest::option::of(fade()));
    (profile, -0.5..0.5, outside, 0.5..2.0, fades).prop_map(|(profile, start, outside, amount, fades)| {
        ProfileLayer { profile, start, outside, amount, fade_in: fades.0, fade_out: fades.1 }
    })
}

/// Any kind, blended or not.
fn any_profile() -> impl Strategy<Value = Profile> {
    let blended = single().prop_recursive(2, 6, 3, |inner| {
        let leaving = proptest::sample::select(vec![Leaving::Refuse, Leaving::Clamp, Leaving::Allow]);
        let between = (layer(inner.clone()), layer(inner.clone()), fade(), leaving);
        let between = between.prop_map(|(first, second, fade, leaving)| Profile::Blend {
            first: Box::new(first),
            second: Box::new(second),
            fade,
            leaving,
        });
        let weighted = proptest::collection::vec(layer(inner), 1..3);
        prop_oneof![between, weighted.prop_map(|layers| Profile::Weighted { layers })]
    });
    blended.prop_filter("no curve", |profile| profile.curve::<f64>().is_ok())
}

proptest! {
    #![proptest_config(ProptestConfig { max_global_rejects: 100_000, ..ProptestConfig::with_cases(500) })]

    #[test]
    fn what_is_written_is_read_bit_for_bit(profile in any_profile()) {
        for written in [text::write(&profile), text::line(&profile)] {
            let read = text::read(&written);
            prop_assert_eq!(read.as_ref(), Ok(&profile), "{}", written);
        }
    }

    #[cfg(feature = "serde")]
    #[test]
    fn what_is_written_here_is_read_by_others_and_the_other_way_round(profile in any_profile()) {
        for written in [text::write(&profile), text::line(&profile)] {
            prop_assert_eq!(ron::from_str::<Profile>(&written).expect("RON"), profile.clone(), "{}", written);
        }
        // As profiles were written before there was a reader of our own, and as RON writes without being asked for more.
        let implicit = ron::Options::default().with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME);
        let pretty = || ron::ser::PrettyConfig::new().struct_names(true).depth_limit(3);
        let bare = ron::ser::PrettyConfig::new();
        let written = [
            implicit.to_string_pretty(&profile, pretty()),
            implicit.to_string(&profile),
            ron::ser::to_string_pretty(&profile, pretty()),
            ron::ser::to_string_pretty(&profile, bare),
            ron::to_string(&profile),
        ];
        for written in written {
            let written = written.expect("it can be written");
            let read = text::read(&written);
            prop_assert_eq!(read.as_ref(), Ok(&profile), "{}", written);
        }
    }

    #[test]
    fn a_changed_text_is_read_or_refused(
        profile in any_profile(),
        changes in proptest::collection::vec((any::<usize>(), 0_usize..12, any::<usize>()), 1..5),
    ) {
        let pieces = ["(", ")", "[", "]", ":", ",", "deg(", "-", "1e999", "NaN", "None", "Blend(", "é", "\"", "0"];
        let mut bytes = text::line(&profile).into_bytes();
        for (at, length, piece) in changes {
            let at = at % (bytes.len() + 1);
            let end = (at + length).min(bytes.len());
            bytes.splice(at..end, pieces[piece % pieces.len()].bytes());
        }
        let changed = String::from_utf8_lossy(&bytes);
        match text::read(&changed) {
            Ok(profile) => prop_assert!(profile.curve::<f64>().is_ok()),
            Err(error) => {
                prop_assert!(!error.faults.is_empty());
                for fault in &error.faults {
                    prop_assert!(changed.get(fault.place.span.clone()).is_some(), "{}: {:?}", changed, fault);
                }
            }
        }
    }
}

#[test]
fn every_kind_is_written_and_read_with_what_is_zero_left_out() {
    for kind in Profile::KINDS {
        let profile = of_kind(kind, &[0.5; 8]);
        assert_eq!(text::read(&text::write(&profile)), Ok(profile), "{}", kind.name);
        let keys = if kind.has_keys() { "keys: [(0, 0), (1, 0.5), (2, 0)], " } else { "" };
        let fields: Vec<String> = kind
            .required
            .iter()
            .map(|parameter| format!("{}: {:?}", parameter.field(), value(parameter, 0.5)))
            .collect();
        let least = format!("{}({keys}{})", kind.variant, fields.join(", "));
        let read = text::read(&least).unwrap_or_else(|error| panic!("{least}: {error}"));
        for parameter in kind.optional {
            let zero = read.values().into_iter().any(|(known, x)| known == *parameter && x.abs() < 1e-300);
            assert!(zero, "{least}");
        }
    }
}

#[test]
fn a_parameter_stands_on_each_line() {
    let profile = Profile::Tension {
        from: 0.0,
        to: 1.25,
        duration: 0.75,
        stiffness: 3.0,
        start_velocity: 0.0,
        end_velocity: 1e-7,
    };
    let expected = "Tension(\n    from: 0.0,\n    to: 1.25,\n    duration: 0.75,\n    stiffness: 3.0,\n    start_velocity: 0.0,\n    \
                    end_velocity: 1e-7,\n)\n";
    assert_eq!(text::write(&profile), expected);
}

#[test]
fn layers_are_curves_or_say_when_they_begin() {
    let bare = text::read_layer("Line(from: 0, to: deg(90), duration: 2)").expect("a curve");
    let full = text::read_layer(
        "(profile: Line(from: 0, to: 1, duration: 2), start: 1, fade_in: (kind: Smooth, start: 0, end: 1))",
    );
    let full = full.expect("a layer");
    assert!(
        (bare.profile.values()[1].1 - std::f64::consts::FRAC_PI_2).abs() < 1e-15 && bare.start.abs() < 1e-300
    );
    assert!((full.start - 1.0).abs() < 1e-300 && full.fade_in.is_some() && full.outside == Outside::Hold);
}

#[test]
fn an_error_of_a_profile_has_the_place_of_its_parameter() {
    let written = "CubicHermite(from: 0, to: 5, duration: 2,\n    start_velocity: -1, end_velocity: 5)";
    let error = text::read(written).expect("a curve").refuse_reversal().expect_err("it turns round");
    assert_eq!(text::place(written, &error).map(|span| &written[span]), Some("-1"));
}

#[test]
fn faults_say_where_and_what_to_do() {
    let texts = [
        "",
        "Tention(from: 0, to: 1, duration: 1, stiffness: 1)",
        "Wobble(from: 0)",
        "3.5",
        "Line(from: 0, to: 1",
        "Line(0, 1, 2)",
        "Line(from: 0, to: \"one\", durtion: 1)",
        "Line(from: 0, to: 1e999, duration: -1)",
        "Line(from: 0, to: 1, duration: deg(3))",
        "Line(from: 0, to: 1, duration: -1)",
        "Line(from: 0, to: 1, duration: 1) // and\nLine(from: 0, to: 1, duration: 1)",
        "Power(from: 0, to: 1, duration: 1, exponent: 0.5)",
        "CatmullRom(keys: [(0, 0), (1, 1, 1), 2])",
        "CatmullRom(keys: [(0, 0), (2, 1), (1, 2)])",
        "CatmullRom()",
        "Blend(first: Line(from: 0, to: 1, duration: 1), second: (profile: Line(from: 0, to: 1, duration: 0)),\n    fade: (kind: Smoth, start: 0, end: 1))",
        "Blend(first: Line(from: 0, to: 1, duration: 1), second: (start: 1, outside: Loop),\n    fade: (kind: Sinh, start: 1, end: 0), leaving: Never)",
        "Weighted(layers: [(profile: Line(from: 0, to: 1, duration: 1),\n    fade_in: Some(Fade(kind: Smooth(stiffness: 1), start: 2, end: 1)))])",
        "Weighted(layers: [(profile: Line(from: 0, to: 1, duration: 1), fade_in: (kind: Linear, start: 2, end: 1))])",
        "Weighted(layers: Line)",
    ];
    let said: Vec<String> = texts
        .iter()
        .map(|written| format!("{written}\n{}\n", text::read(written).expect_err(written)))
        .collect();
    insta::assert_snapshot!(said.join("\n"));
}
