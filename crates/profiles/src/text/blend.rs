//! Curves that go over into each other.

use super::curve::ProfileReader;
use crate::blend::{Fade, FadeKind, Leaving};
use crate::clip::Outside;
use crate::error::ProfileError;
use crate::profile::{Profile, ProfileLayer};
use solaris_text::{Fields, Node};

const FADES: [&str; 5] = ["Linear", "Exponential", "Sinh", "Trigonometric", "Smooth"];
const OUTSIDE: [&str; 4] = ["Hold", "Extrapolate", "Repeat", "Mirror"];
const LEAVING: [&str; 3] = ["Refuse", "Clamp", "Allow"];

impl ProfileReader<'_> {
    /// `Blend(first: …, second: …, fade: Fade(…))`
    pub(super) fn blend(&mut self, node: &Node<'_>) -> Option<Profile> {
        let fields = self.reader.fields(node, &["Blend"], &["first", "second", "fade", "leaving"])?;
        let example = "(profile: Line(from: 0, to: 1, duration: 2))";
        let first = self.reader.required(&fields, "first", example);
        let first = first.and_then(|node| self.layer(node));
        let second = self.reader.required(&fields, "second", example);
        let second = second.and_then(|node| self.layer(node));
        let fade = self.reader.required(&fields, "fade", "Fade(kind: Smooth, start: 0, end: 1)");
        let fade = fade.and_then(|node| self.fade(node));
        let leaving = match self.reader.choice(&fields, "leaving", &LEAVING)? {
            "Refuse" => Leaving::Refuse,
            "Clamp" => Leaving::Clamp,
            _ => Leaving::Allow,
        };
        let profile =
            Profile::Blend { first: Box::new(first?), second: Box::new(second?), fade: fade?, leaving };
        self.checked(profile, &fields)
    }

    /// `Weighted(layers: […])`
    pub(super) fn weighted(&mut self, node: &Node<'_>) -> Option<Profile> {
        let fields = self.reader.fields(node, &["Weighted"], &["layers"])?;
        let example = "[(profile: Line(from: 0, to: 1, duration: 2)), …]";
        let layers = self.reader.required(&fields, "layers", example)?;
        let items = self.reader.items(layers, "layers", example)?;
        let layers: Vec<Option<ProfileLayer>> = items.iter().map(|item| self.layer(item)).collect();
        let layers: Option<Vec<ProfileLayer>> = layers.into_iter().collect();
        self.checked(Profile::Weighted { layers: layers? }, &fields)
    }

    pub(super) fn checked(&mut self, profile: Profile, fields: &Fields<'_, '_>) -> Option<Profile> {
        let curve: Result<_, ProfileError> = profile.curve::<f64>();
        curve.map_err(|error| self.refuse(&error, fields)).ok()?;
        Some(profile)
    }

    /// A curve, or `(profile: CURVE, start: 0, outside: Hold, amount: 1, fade_in: Fade(…), fade_out: Fade(…))`
    pub(super) fn layer(&mut self, node: &Node<'_>) -> Option<ProfileLayer> {
        if node.head().is_some_and(|head| head.name != "ProfileLayer") {
            return self.profile(node).map(ProfileLayer::from);
        }
        let known = ["profile", "start", "outside", "amount", "fade_in", "fade_out"];
        let fields = self.reader.fields(node, &["ProfileLayer"], &known)?;
        let before = self.reader.count();
        let profile = self.reader.required(&fields, "profile", "Line(from: 0, to: 1, duration: 2)");
        let profile = profile.and_then(|node| self.profile(node));
        let start = self.reader.number_or(&fields, "start", 0.0);
        let amount = self.reader.number_or(&fields, "amount", 1.0);
        let outside = match self.reader.choice(&fields, "outside", &OUTSIDE) {
            Some("Extrapolate") => Outside::Extrapolate,
            Some("Repeat") => Outside::Repeat,
            Some("Mirror") => Outside::Mirror,
            _ => Outside::Hold,
        };
        let fade_in = fields.get("fade_in").and_then(|node| self.fade(node));
        let fade_out = fields.get("fade_out").and_then(|node| self.fade(node));
        let layer =
            ProfileLayer { profile: profile?, start: start?, outside, amount: amount?, fade_in, fade_out };
        (self.reader.count() == before).then_some(layer)
    }

    /// `Fade(kind: Sinh(stiffness: 1), start: 0, end: 1)`
    fn fade(&mut self, node: &Node<'_>) -> Option<Fade> {
        let fields = self.reader.fields(node, &["Fade"], &["kind", "start", "end"])?;
        let kind = self.reader.required(&fields, "kind", "Smooth").and_then(|node| self.fade_kind(node));
        let start = self.reader.required_number(&fields, "start", "1.0");
        let end = self.reader.required_number(&fields, "end", "1.0");
        let fade = Fade::new(kind?, start?, end?);
        fade.map_err(|error| self.refuse(&error, &fields)).ok()
    }

    fn fade_kind(&mut self, node: &Node<'_>) -> Option<FadeKind> {
        let kind = self.reader.kind(node, &FADES)?;
        if matches!(kind, "Linear" | "Smooth") {
            let fields = self.reader.fields(node, &FADES, &[])?;
            let plain = if kind == "Linear" { FadeKind::Linear } else { FadeKind::Smooth };
            return (!self.reader.only_known(&fields, &[])).then_some(plain);
        }
        let fields = self.reader.fields(node, &FADES, &["stiffness"])?;
        let stiffness = self.reader.required_number(&fields, "stiffness", "1.0")?;
        Some(match kind {
            "Exponential" => FadeKind::Exponential { stiffness },
            "Sinh" => FadeKind::Sinh { stiffness },
            _ => FadeKind::Trigonometric { stiffness },
        })
    }
}
