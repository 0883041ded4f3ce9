//! Outcomes of drives, and impacts, in words.

use super::energy::digits;
use crate::words::some;
use serde::Serialize;
use solaris::model::{AxisKind, Figure, JointKind};
use solaris::modes::{Impact, Outcome, OutcomeKind};

/// How a drive ended.
#[derive(Debug, Serialize)]
pub(super) struct Told {
    pub(super) dof: String,
    pub(super) drive: &'static str,
    pub(super) start_s: f64,
    pub(super) end_s: f64,
    pub(super) result: &'static str,
    /// rad or m, where the degree of freedom has a position.
    pub(super) position: f64,
    /// rad/s or m/s.
    pub(super) velocity: f64,
    /// By how much the target was missed (rad or m).
    pub(super) missed_by: Option<f64>,
    /// What the analysis of simple mode gave (rad/s² or m/s²).
    pub(super) acceleration: Option<f64>,
    #[serde(skip)]
    turns: bool,
    /// Velocities of ball joints are the rates of no coordinate.
    #[serde(skip)]
    has_position: bool,
}

/// A jump of the velocities.
#[derive(Debug, Serialize)]
pub(super) struct Hit {
    pub(super) time_s: f64,
    pub(super) dof: String,
    pub(super) what: &'static str,
    pub(super) velocity_before: f64,
    pub(super) velocity_after: f64,
    pub(super) impulse: f64,
    pub(super) loss_j: f64,
    #[serde(skip)]
    turns: bool,
}

impl Told {
    pub(super) fn of(figure: &Figure, outcome: &Outcome) -> Self {
        let missed_by = if let OutcomeKind::Missed(off) = outcome.result { Some(off) } else { None };
        Self {
            dof: figure.layout().v_names()[outcome.dof].clone(),
            drive: outcome.drive,
            start_s: outcome.start,
            end_s: outcome.end,
            result: name(outcome.result),
            position: outcome.position,
            velocity: outcome.velocity,
            missed_by,
            acceleration: outcome.acceleration,
            turns: turns(figure, outcome.dof),
            has_position: figure.layout().coordinate(outcome.dof).is_some(),
        }
    }

    /// What became of it, in words.
    fn words(&self) -> String {
        let (position, velocity) = (amount(self.position, self.turns), rate(self.velocity, self.turns));
        match self.result {
            "reached" => format!("reached {position}"),
            "reached with velocity" => format!("reached {position} with {velocity}"),
            "no motion" => format!("stayed at {position}: the force of the target gives no acceleration"),
            "wrong sign" => {
                let acceleration =
                    self.acceleration.map_or_else(String::new, |a| format!(" ({}²)", rate(a, self.turns)));
                format!(
                    "stayed at {position}: the force of the target accelerates it away from there{acceleration}"
                )
            }
            "unreachable" => format!("stayed at {position}: it would turn round before the target"),
            "needs rest" => format!(
                "stayed at {position}: this drive goes from rest to rest, and it came with a velocity"
            ),
            "limited by torque" => format!("came to {position}: the force was at its limit"),
            "missed" => {
                let off = amount(self.missed_by.unwrap_or_default().abs(), self.turns);
                format!("came to {position}, {off} beside the target")
            }
            "limit hit" => format!("came to {position}, the limit of the joint"),
            "interrupted" => format!("at {position} when the next drive took over"),
            "unfinished" => format!("not done at the end of the run, at {position}"),
            "not begun" => "the run ended before it began".to_owned(),
            _ if !self.has_position => "ended".to_owned(),
            _ => format!("ended at {position}"),
        }
    }

    /// What several have in common, in words.
    fn words_of_many(&self) -> &'static str {
        match self.result {
            "unfinished" => "not done at the end of the run",
            "interrupted" => "the next drive took over",
            "not begun" => "the run ended before they began",
            result => result,
        }
    }
}

impl Hit {
    pub(super) fn of(figure: &Figure, impact: &Impact) -> Self {
        Self {
            time_s: impact.time,
            dof: figure.layout().v_names()[impact.dof].clone(),
            what: impact.what,
            velocity_before: impact.velocity.0,
            velocity_after: impact.velocity.1,
            impulse: impact.impulse,
            loss_j: impact.loss,
            turns: turns(figure, impact.dof),
        }
    }

    /// What happened, in words.
    fn words(&self) -> String {
        let [before, after] = [self.velocity_before, self.velocity_after].map(|v| rate(v, self.turns));
        let unit = if self.turns { "N m s" } else { "N s" };
        format!("{} ({}) {before} to {after}, {} {unit}", self.dof, self.what, digits(self.impulse))
    }
}

/// A line for each impact; those at the same time share their loss, and the last of them tells it.
pub(super) fn hits(impacts: &[Hit]) -> Vec<String> {
    let at_once = |a: &Hit, b: &Hit| (a.time_s - b.time_s).abs() < 1e-9;
    let mut lines = Vec::new();
    for group in impacts.chunk_by(at_once) {
        let loss: f64 = group.iter().map(|hit| hit.loss_j).sum();
        for (i, hit) in group.iter().enumerate() {
            let together = if group.len() > 1 { "together " } else { "" };
            let loss = format!("; {together}{} J lost", digits(loss));
            let loss = if i + 1 == group.len() { loss } else { String::new() };
            lines.push(format!("{:>7.3} s  {}{loss}", hit.time_s, hit.words()));
        }
    }
    lines
}

/// A line for each drive; those of the same kind over the same time with the same end share one.
pub(super) fn lines(drives: &[Told]) -> Vec<String> {
    let mut groups: Vec<Vec<&Told>> = Vec::new();
    for told in drives {
        let same = |other: &Told| {
            let times = [(told.start_s, other.start_s), (told.end_s, other.end_s)];
            let together = times.iter().all(|(a, b)| (a - b).abs() < 1e-9);
            together && told.drive == other.drive && told.result == other.result
        };
        match groups.iter_mut().find(|group| same(group[0])) {
            Some(group) => group.push(told),
            None => groups.push(vec![told]),
        }
    }
    let mut lines = Vec::new();
    for group in groups {
        let when = |told: &Told| format!("{:>7.3} to {:>7.3} s", told.start_s, told.end_s);
        if group.len() > FEW {
            let names: Vec<String> = group.iter().map(|told| told.dof.clone()).collect();
            let what = group[0].words_of_many();
            lines.push(format!("{}  {}: {what}; {}", when(group[0]), group[0].drive, some(&names)));
        } else {
            lines.extend(
                group
                    .iter()
                    .map(|told| format!("{}  {}, {}: {}", when(told), told.dof, told.drive, told.words())),
            );
        }
    }
    lines
}

/// As many drives of one kind each have a line of their own.
const FEW: usize = 3;

/// A position for people: degrees or m.
fn amount(value: f64, turns: bool) -> String {
    if turns { format!("{}°", digits(value.to_degrees())) } else { format!("{} m", digits(value)) }
}

fn rate(value: f64, turns: bool) -> String {
    if turns { format!("{}°/s", digits(value.to_degrees())) } else { format!("{} m/s", digits(value)) }
}

/// Whether a degree of freedom turns.
fn turns(figure: &Figure, dof: usize) -> bool {
    let layout = figure.layout();
    let found =
        figure.links().iter().zip(layout.joints()).find(|(_, at)| (at.v..at.v + at.nv).contains(&dof));
    found.is_none_or(|(link, at)| match link.joint().kind() {
        JointKind::Axes(dofs) => dofs[dof - at.v].axis.kind == AxisKind::Rotation,
        JointKind::Free { .. } => dof - at.v >= 3,
        _ => true,
    })
}

/// What came of a drive, as JSON has it.
fn name(result: OutcomeKind) -> &'static str {
    match result {
        OutcomeKind::Reached => "reached",
        OutcomeKind::ReachedWithVelocity => "reached with velocity",
        OutcomeKind::NoMotion => "no motion",
        OutcomeKind::WrongSign => "wrong sign",
        OutcomeKind::Unreachable => "unreachable",
        OutcomeKind::NeedsRest => "needs rest",
        OutcomeKind::LimitedByTorque => "limited by torque",
        OutcomeKind::Missed(_) => "missed",
        OutcomeKind::LimitHit => "limit hit",
        OutcomeKind::Interrupted => "interrupted",
        OutcomeKind::Unfinished => "unfinished",
        OutcomeKind::NotBegun => "not begun",
        _ => "ended",
    }
}
