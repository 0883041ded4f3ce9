//! Curves that go over into each other.

use super::SceneReader;
use solaris_model::text::{Fields, Node};
use solaris_profiles::blend::{Fade, FadeKind, Leaving};
use solaris_profiles::{Outside, Profile, ProfileError, ProfileLayer};

const FADES: [&str; 5] = ["Linear", "Exponential", "Sinh", "Trigonometric", "Smooth"];
const OUTSIDE: [&str; 4] = ["Hold", "Extrapolate", "Repeat", "Mirror"];
const LEAVING: [&str; 3] = ["Refuse", "Clamp", "Allow"];

impl SceneReader<'_> {
    /// `Blend(first: …, second: …, fade: Fade(…))`
    pub(super) fn blend(&mut self, node: &Node<'_>, turns: bool) -> Option<Profile> {
        let fields = self.reader.fields(node, &["Blend"], &["first", "second", "fade", "leaving"])?;
        let example = "(profile: Line(from: 0, to: 1, duration: 2))";
        let first = self.reader.required(&fields, "first", example);
        let first = first.and_then(|node| self.layer(node, turns));
        let second = self.reader.required(&fields, "second", example);
        let second = second.and_then(|node| self.layer(node, turns));
        let fade = self.reader.required(&fields, "fade", "Fade(kind: Smooth, start: 0, end: 1)");
        let fade = fade.and_then(|node| self.fade(node));
        let leaving = match fields.get("leaving").map(|node| self.reader.kind(node, &LEAVING)) {
            None | Some(Some("Refuse")) => Leaving::Refuse,
            Some(Some("Clamp")) => Leaving::Clamp,
            Some(Some(_)) => Leaving::Allow,
            Some(None) => return None,
        };
        let profile =
            Profile::Blend { first: Box::new(first?), second: Box::new(second?), fade: fade?, leaving };
        self.checked(profile, &fields)
    }

    /// `Weighted(layers: […])`
    pub(super) fn weighted(&mut self, node: &Node<'_>, turns: bool) -> Option<Profile> {
        let fields = self.reader.fields(node, &["Weighted"], &["layers"])?;
        let layers =
            self.reader.required(&fields, "layers", "[(profile: Line(from: 0, to: 1, duration: 2)), …]")?;
        let Some(items) = layers.items() else {
            let message = format!("layers must be a list, not {}", layers.describe());
            self.reader.fault(layers.place(), message);
            return None;
        };
        let layers: Vec<Option<ProfileLayer>> = items.iter().map(|item| self.layer(item, turns)).collect();
        let layers: Option<Vec<ProfileLayer>> = layers.into_iter().collect();
        self.checked(Profile::Weighted { layers: layers? }, &fields)
    }

    fn checked(&mut self, profile: Profile, fields: &Fields<'_, '_>) -> Option<Profile> {
        let curve: Result<_, ProfileError> = profile.curve::<f64>();
        curve.map_err(|error| self.refuse(&error, fields)).ok()?;
        Some(profile)
    }

    /// A curve, or `(profile: CURVE, start: 0, outside: Hold, amount: 1, fade_in: Fade(…), fade_out: Fade(…))`
    fn layer(&mut self, node: &Node<'_>, turns: bool) -> Option<ProfileLayer> {
        if node.head().is_some_and(|head| head.name != "ProfileLayer") {
            return self.profile(node, turns).map(ProfileLayer::from);
        }
        let known = ["profile", "start", "outside", "amount", "fade_in", "fade_out"];
        let fields = self.reader.fields(node, &["ProfileLayer"], &known)?;
        let before = self.reader.count();
        let profile = self.reader.required(&fields, "profile", "Line(from: 0, to: 1, duration: 2)");
        let profile = profile.and_then(|node| self.profile(node, turns));
        let mut layer = ProfileLayer::from(profile?);
        if let Some(start) = fields.get("start").and_then(|node| self.reader.number(node, "the start")) {
            layer.start = start;
        }
        if let Some(amount) = fields.get("amount").and_then(|node| self.reader.number(node, "the amount")) {
            layer.amount = amount;
        }
        layer.outside = match fields.get("outside").and_then(|node| self.reader.kind(node, &OUTSIDE)) {
            Some("Extrapolate") => Outside::Extrapolate,
            Some("Repeat") => Outside::Repeat,
            Some("Mirror") => Outside::Mirror,
            _ => Outside::Hold,
        };
        layer.fade_in = fields.get("fade_in").and_then(|node| self.fade(node));
        layer.fade_out = fields.get("fade_out").and_then(|node| self.fade(node));
        (self.reader.count() == before).then_some(layer)
    }

    /// `Fade(kind: Sinh(stiffness: 1), start: 0, end: 1)`
    fn fade(&mut self, node: &Node<'_>) -> Option<Fade> {
        let fields = self.reader.fields(node, &["Fade"], &["kind", "start", "end"])?;
        let kind = self.reader.required(&fields, "kind", "Smooth").and_then(|node| self.fade_kind(node));
        let mut time = |field| {
            self.reader.required(&fields, field, "1.0").and_then(|node| self.reader.number(node, field))
        };
        let (start, end) = (time("start"), time("end"));
        let fade = Fade::new(kind?, start?, end?);
        fade.map_err(|error| self.refuse(&error, &fields)).ok()
    }

    fn fade_kind(&mut self, node: &Node<'_>) -> Option<FadeKind> {
        let kind = self.reader.kind(node, &FADES)?;
        if matches!(kind, "Linear" | "Smooth") {
            return Some(if kind == "Linear" { FadeKind::Linear } else { FadeKind::Smooth });
        }
        let fields = self.reader.fields(node, &FADES, &["stiffness"])?;
        let stiffness = self.reader.required(&fields, "stiffness", "1.0")?;
        let stiffness = self.reader.number(stiffness, "the stiffness")?;
        Some(match kind {
            "Exponential" => FadeKind::Exponential { stiffness },
            "Sinh" => FadeKind::Sinh { stiffness },
            _ => FadeKind::Trigonometric { stiffness },
        })
    }
}
