//! One drive, and until when.

use super::SceneReader;
use super::drives::Placed;
use super::names::Meant;
use solaris_model::text::{ExpectedKind, Fields, Node};
use solaris_modes::{Course, Drive, EndCondition, Law, Shape, Step, Target};
use solaris_profiles::Profile;

pub(super) const DRIVES: [&str; 17] = [
    "Free",
    "Frozen",
    "Wait",
    "When",
    "Kinematic",
    "Move",
    "Torque",
    "TargetAngle",
    "TimeOriented",
    "AccelerateDecelerate",
    "FreeStyle",
    "Intensive",
    "Servo",
    "Actuator",
    "Sum",
    "Sine",
    "Repeat",
];

/// What moves more than a joint, and where it stands.
const ELSEWHERE: [(&str, &str); 8] = [
    ("Reach", "reaches: [Reach(…)]"),
    ("Look", "reaches: [Look(…)]"),
    ("Hold", "reaches: [Hold(…)]"),
    ("Clip", "clip: Clip(…)"),
    ("Carry", "carries: [Carry(…)]"),
    ("Push", "pushes: [Push(…)]"),
    ("Walk", "walk: Walk(…)"),
    ("Together", "sequence: [Together({…})]"),
];

const UNTIL: [&str; 7] = ["Done", "At", "Lasting", "Passes", "PassesSpeed", "Touches", "Leaves"];

/// The fields that each drive has.
fn known(kind: &str) -> &'static [&'static str] {
    match kind {
        "Kinematic" | "Torque" => &["along", "until"],
        "Move" => &["to", "over", "by", "until"],
        "TargetAngle" => &["to", "velocity", "acceleration", "until"],
        "TimeOriented" => &["to", "velocity", "acceleration", "over", "until"],
        "AccelerateDecelerate" => &["to", "velocity", "acceleration", "by", "until"],
        "FreeStyle" => &["to", "velocity", "acceleration", "for", "until"],
        "Intensive" => &["to", "velocity", "acceleration", "over", "law", "limit", "until"],
        "Servo" => &["to", "along", "stiffness", "damping", "limit", "until"],
        "Actuator" => &["to", "along", "velocity", "until"],
        "Sum" => &["of", "until"],
        _ => &["until"],
    }
}

/// Whether a curve stands here.
fn is_curve(node: &Node<'_>) -> bool {
    let is_kind = |name: &str| Profile::KINDS.iter().any(|kind| kind.variant == name);
    node.head().is_some_and(|head| is_kind(head.name) || ["Sine", "Blend", "Weighted"].contains(&head.name))
}

impl SceneReader<'_> {
    /// A drive of degrees of freedom that turn, or of others.
    pub(super) fn step(&mut self, node: &Node<'_>, turns: bool) -> Option<Placed> {
        let place = node.place();
        if is_curve(node) {
            // A curve stands for following it.
            let drive = Drive::Kinematic(self.profile(node, turns)?);
            return Some((place, drive.into()));
        }
        if let Some(head) = node.head() {
            // A curve may stand here too, of which the one that is read knows nothing.
            let curves = Profile::KINDS.iter().map(|kind| kind.variant).chain(["Blend", "Weighted"]);
            self.reader.expect(&head.span, ExpectedKind::Word, "curve", curves);
            if let Some((_, field)) = ELSEWHERE.iter().find(|(name, _)| *name == head.name) {
                let message =
                    format!("{} is not a drive of a joint; it stands beside the drives, {field}", head.name);
                self.reader.fault(head.span.clone(), message);
                return None;
            }
        }
        let kind = self.reader.kind(node, &DRIVES)?;
        match (kind, node.tuple()) {
            ("Wait", items) => {
                let Some([time]) = items else {
                    self.reader.fault(place, "Wait(0.5) takes one number, a time in s");
                    return None;
                };
                let time = self.reader.number(time, "the time to wait")?;
                return Some((place, Step { drive: Drive::Frozen, until: EndCondition::Lasting(time) }));
            }
            ("When", items) => {
                let Some([condition]) = items else {
                    let message =
                        "When(Passes(\"elbow.rx\", deg(10))) takes what is waited for, an until of a drive";
                    self.reader.fault(place, message);
                    return None;
                };
                return Some((place, Step { drive: Drive::Frozen, until: self.until(condition)? }));
            }
            ("Sum", Some([list])) => {
                let drive = self.sum(list, turns)?;
                return Some((place, drive.into()));
            }
            ("Kinematic", Some([curve])) => {
                let drive = Drive::Kinematic(self.profile(curve, turns)?);
                return Some((place, drive.into()));
            }
            ("Torque", Some([curve])) => {
                let drive = Drive::Torque(self.profile(curve, false)?);
                return Some((place, drive.into()));
            }
            _ => {}
        }
        let fields = self.reader.fields(node, &DRIVES, known(kind))?;
        let until = fields.get("until").map(|node| self.until(node));
        let drive = if kind == "Actuator" {
            self.actuator(place.start, &fields, turns)
        } else {
            self.drive(kind, &fields, turns)
        };
        Some((place, Step { drive: drive?, until: until.unwrap_or(Some(EndCondition::Done))? }))
    }

    fn drive(&mut self, kind: &str, fields: &Fields<'_, '_>, turns: bool) -> Option<Drive> {
        match kind {
            "Free" => Some(Drive::Free),
            "Frozen" => Some(Drive::Frozen),
            "Kinematic" | "Torque" => {
                let node =
                    self.reader.required(fields, "along", "MinimumJerk(from: 0, to: 1, duration: 2)")?;
                let profile = self.profile(node, turns && kind == "Kinematic")?;
                Some(if kind == "Torque" { Drive::Torque(profile) } else { Drive::Kinematic(profile) })
            }
            "Move" => {
                let (target, over) = (self.target(fields, turns), self.time(fields, "over"));
                let along = match self.reader.choice(fields, "by", &["MinimumJerk", "Cubic"])? {
                    "Cubic" => Shape::Cubic,
                    _ => Shape::MinimumJerk,
                };
                Some(Drive::Move { to: target?.position, over: over?, along })
            }
            "Servo" => self.servo(fields, turns),
            "Sum" => {
                let list = self.reader.required(fields, "of", super::forces::SUM)?;
                self.sum(list, turns)
            }
            "FreeStyle" => {
                let has_target =
                    ["to", "velocity", "acceleration"].iter().any(|field| fields.get(field).is_some());
                let target = has_target.then(|| self.target(fields, turns));
                let duration = self.time(fields, "for")?;
                Some(Drive::FreeStyle {
                    target: target.map_or(Some(None), |target| target.map(Some))?,
                    duration,
                })
            }
            "Intensive" => {
                let (target, over) = (self.target(fields, turns), self.time(fields, "over"));
                let law = match self.reader.choice(fields, "law", &["Quintic", "Cubic", "Literal"])? {
                    "Literal" => Law::Literal,
                    "Cubic" => Law::Cubic,
                    _ => Law::Quintic,
                };
                let limit = fields.get("limit").map(|node| self.reader.number(node, "the greatest force"));
                let limit = limit.map_or(Some(None), |limit| limit.map(Some))?;
                Some(Drive::Intensive { target: target?, duration: over?, law, limit })
            }
            _ => self.simple(kind, fields, turns),
        }
    }

    fn simple(&mut self, kind: &str, fields: &Fields<'_, '_>, turns: bool) -> Option<Drive> {
        let target = self.target(fields, turns);
        let course = match kind {
            "TargetAngle" => Course::TargetAngle,
            "TimeOriented" => Course::TimeOriented { duration: self.time(fields, "over")? },
            _ => match self.reader.choice(fields, "by", &["BangBang", "HalfCosine", "FullSine"])? {
                "HalfCosine" => Course::HalfCosine,
                "FullSine" => Course::FullSine,
                _ => Course::BangBang,
            },
        };
        Some(Drive::Simple { target: target?, course })
    }

    /// The fields `to`, `velocity` and `acceleration`.
    fn target(&mut self, fields: &Fields<'_, '_>, turns: bool) -> Option<Target> {
        let position = self.reader.required(fields, "to", if turns { "deg(30)" } else { "0.1" });
        let position = position.and_then(|node| self.reader.coordinate(node, turns, "the target"));
        let mut rate = |field| {
            let node = fields.get(field);
            node.map_or(Some(0.0), |node| self.reader.coordinate(node, turns, format_args!("the {field}")))
        };
        let (velocity, acceleration) = (rate("velocity"), rate("acceleration"));
        Some(Target { position: position?, velocity: velocity?, acceleration: acceleration? })
    }

    /// A duration that must be there (s).
    pub(super) fn time(&mut self, fields: &Fields<'_, '_>, field: &str) -> Option<f64> {
        let node = self.reader.required(fields, field, "0.6")?;
        self.reader.number(node, "the duration")
    }

    pub(super) fn until(&mut self, node: &Node<'_>) -> Option<EndCondition> {
        let kind = self.reader.kind(node, &UNTIL)?;
        match (kind, node.tuple()) {
            ("Done", None) => Some(EndCondition::Done),
            ("At", Some([time])) => self.reader.number(time, "the time").map(EndCondition::Time),
            ("Lasting", Some([time])) => self.reader.number(time, "the time").map(EndCondition::Lasting),
            ("Passes" | "PassesSpeed", Some([name, value])) => {
                let before = self.reader.count();
                let dof = self.meant_one(name);
                let turns = self.names.turn(dof.map(Meant::of).as_ref());
                let value = self.reader.coordinate(value, turns, "the value to pass through")?;
                let has_positions =
                    |dof| self.figure().is_some_and(|figure| figure.layout().coordinate(dof).is_some());
                if kind == "Passes" && dof.is_some_and(|dof| !has_positions(dof)) {
                    let message = "a ball or free joint has no positions of its own to pass through; take \
                                   PassesSpeed, or a joint of three rotations";
                    self.reader.fault(name.span.clone(), message);
                }
                if self.reader.count() > before {
                    return None;
                }
                // Without a figure the name means nothing yet.
                let dof = dof.map_or_else(String::new, |dof| self.names.name(dof).to_owned());
                Some(if kind == "Passes" {
                    EndCondition::Position { dof, value }
                } else {
                    EndCondition::Velocity { dof, value }
                })
            }
            ("Touches" | "Leaves", Some([name])) => {
                let link = self.reader.name(name, "the link")?;
                // Without a figure the name means nothing yet.
                if self.simulation.is_some() {
                    self.link(name, link, None)?;
                    self.awaited.push((link.to_owned(), name.span.clone()));
                }
                Some(if kind == "Touches" {
                    EndCondition::TouchDown { link: link.to_owned() }
                } else {
                    EndCondition::LiftOff { link: link.to_owned() }
                })
            }
            _ => {
                let message = "a drive lasts until: At(2.0), Lasting(0.5), Passes(\"elbow.rx\", deg(10)), \
                               PassesSpeed(\"elbow.rx\", 1.0), Touches(\"left_foot\"), Leaves(\"left_foot\") or Done";
                self.reader.fault(node.place(), message);
                None
            }
        }
    }
}
