//! The writer of profiles.

use crate::blend::{Fade, FadeKind};
use crate::profile::{Profile, ProfileLayer};
use solaris_text::layout::{Doc, field, group, number};

/// The text of a profile, a parameter a line.
///
/// [`read`](super::read) makes the same profile of it, bit for bit, and so does any other reader of RON by the feature `serde`.
pub fn write(profile: &Profile) -> String {
    let mut text = String::new();
    self::profile(profile).print_broken(0, &mut text);
    text.push('\n');
    text
}

/// The same on one line.
pub fn line(profile: &Profile) -> String {
    self::profile(profile).flat()
}

fn profile(profile: &Profile) -> Doc {
    let mut fields = Vec::new();
    match profile {
        Profile::Blend { first, second, fade: over, leaving } => {
            fields.push(field("first", layer(first)));
            fields.push(field("second", layer(second)));
            fields.push(field("fade", fade(over)));
            fields.push(field("leaving", Doc::Atom(format!("{leaving:?}"))));
        }
        Profile::Weighted { layers } => fields.push(field("layers", list(layers.iter().map(layer)))),
        Profile::Sine { amplitude, period, cycles, phase, offset } => {
            let all = [
                ("amplitude", amplitude),
                ("period", period),
                ("cycles", cycles),
                ("phase", phase),
                ("offset", offset),
            ];
            fields.extend(all.map(|(name, value)| field(name, plain(*value))));
        }
        Profile::Repeat { of, times } => {
            fields.push(field("of", self::profile(of)));
            fields.push(field("times", Doc::Atom(times.to_string())));
        }
        Profile::CatmullRom { keys }
        | Profile::Centripetal { keys }
        | Profile::MonotoneCubic { keys }
        | Profile::KochanekBartels { keys, .. }
        | Profile::NaturalSpline { keys }
        | Profile::ClampedSpline { keys, .. } => {
            let key = |&(time, position): &(f64, f64)| group("(", vec![plain(time), plain(position)], ")");
            fields.push(field("keys", list(keys.iter().map(key))));
        }
        _ => {}
    }
    let values = profile.values().into_iter();
    fields.extend(values.map(|(parameter, value)| field(&parameter.field(), plain(value))));
    group(&format!("{}(", profile.variant()), fields, ")")
}

fn layer(layer: &ProfileLayer) -> Doc {
    let ProfileLayer { profile: motion, start, outside, amount, fade_in, fade_out } = layer;
    let optional = |over: &Option<Fade>| match over {
        Some(over) => group("Some(", vec![fade(over)], ")"),
        None => Doc::Atom("None".to_owned()),
    };
    let fields = vec![
        field("profile", profile(motion)),
        field("start", plain(*start)),
        field("outside", Doc::Atom(format!("{outside:?}"))),
        field("amount", plain(*amount)),
        field("fade_in", optional(fade_in)),
        field("fade_out", optional(fade_out)),
    ];
    group("ProfileLayer(", fields, ")")
}

fn fade(fade: &Fade) -> Doc {
    let name = match fade.kind() {
        FadeKind::Linear => "Linear",
        FadeKind::Exponential { .. } => "Exponential",
        FadeKind::Sinh { .. } => "Sinh",
        FadeKind::Trigonometric { .. } => "Trigonometric",
        FadeKind::Smooth => "Smooth",
    };
    let kind = match fade.kind().stiffness() {
        Some(stiffness) => group(&format!("{name}("), vec![field("stiffness", plain(stiffness))], ")"),
        None => Doc::Atom(name.to_owned()),
    };
    let fields =
        vec![field("kind", kind), field("start", plain(fade.start())), field("end", plain(fade.end()))];
    group("Fade(", fields, ")")
}

fn list(items: impl Iterator<Item = Doc>) -> Doc {
    group("[", items.collect(), "]")
}

fn plain(value: f64) -> Doc {
    Doc::Atom(number(value))
}
