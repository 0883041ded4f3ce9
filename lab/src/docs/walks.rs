//! Tables of whole walks, on docs/walking.md.

use solaris_analysis::{ReactionReport, ground_reactions};
use solaris_gait::{Extent, FEET, WalkMeasures, WalkPart, WalkRequest, measure, walk};
use solaris_model::human;
use std::fmt::Write;

/// Height (m), mass (kg), and frames a second.
const BODY: (f64, f64) = (1.75, 73.0);
const RATE: f64 = 120.0;

/// Step frequencies (1/min) and numbers of steps.
const WALKS: [(f64, usize); 10] = [
    (60.0, 10),
    (80.0, 10),
    (95.0, 10),
    (110.0, 1),
    (110.0, 4),
    (110.0, 10),
    (115.0, 10),
    (118.0, 10),
    (125.0, 10),
    (130.0, 10),
];

/// A walk with its forces.
struct Walked {
    frames: usize,
    /// Of the person (N).
    weight: f64,
    reactions: ReactionReport,
    measures: WalkMeasures,
}

/// How far the forces that a motion implies are from those that its plan prescribes.
pub(super) fn forces() -> Result<String, String> {
    let mut text = "| steps/min, steps | frames | force | CoP |\n|---|---|---|---|".to_owned();
    for (frequency, steps) in WALKS {
        let Walked { frames, reactions, .. } = walked(&request(frequency, steps, &[]))?;
        let force = reactions.from_prescribed.map_or(f64::NAN, |off| off.value);
        let cop = 1e3 * reactions.cop_from_nominal.value;
        // Writing into a string does not fail.
        let _ = write!(text, "\n| {frequency}, {steps} | {frames} | {} N | {} mm |", two(force), two(cop));
    }
    Ok(text)
}

/// Walks that change on the way.
pub(super) fn changes() -> Result<String, String> {
    let half = WalkPart { step_frequency: Some(95.0), step_length: Some(0.31), ..part(1) };
    let walks = [
        ("80 → 110 steps/min", request(80.0, 5, &[paced(6, 110.0)])),
        ("115 → 80", request(115.0, 5, &[paced(6, 80.0)])),
        ("60 → 115", request(60.0, 4, &[paced(6, 115.0)])),
        ("a half step at 95", request(95.0, 4, &[half, paced(4, 95.0)])),
        ("four steps of 15° at 110", request(110.0, 4, &[turning(4, 15.0), part(3)])),
        ("two steps of 30° at 95", request(95.0, 4, &[turning(2, -30.0), part(3)])),
        ("130 steps/min, ten steps", request(130.0, 10, &[])),
    ];
    let mut text = "| walk of 1.75 m | off the prescribed forces | friction, one foot's | least knee |\n|---|---|---|---|"
        .to_owned();
    for (i, (name, request)) in walks.iter().enumerate() {
        let Walked { weight, reactions, measures, .. } =
            walked(request).map_err(|error| format!("{name}: {error}"))?;
        let off = reactions.from_prescribed.map_or(f64::NAN, |off| 100.0 * off.value / weight);
        let _ = write!(
            text,
            "\n| {name} | {off:.1}{} | {:.2}, {:.2} | {:.1}° |",
            if i == 0 { " %BW" } else { "" },
            measures.extremes.friction.value,
            measures.extremes.foot_friction.value,
            measures.extremes.least_knee.value.to_degrees()
        );
    }
    Ok(text)
}

fn walked(request: &WalkRequest) -> Result<Walked, String> {
    let say = |error: &dyn std::fmt::Display| error.to_string();
    let figure = human(BODY.0, BODY.1).map_err(|error| say(&error))?;
    let plan = walk(&figure, request).map_err(|error| say(&error))?;
    let mut motion = plan.motion(&figure, RATE).map_err(|error| say(&error))?;
    let reactions = ground_reactions(&figure, &mut motion, FEET, &plan).map_err(|error| say(&error))?;
    let measures = measure(&figure, &motion).map_err(|error| say(&error))?;
    Ok(Walked { frames: motion.len(), weight: plan.weight(), reactions, measures })
}

fn request(step_frequency: f64, steps: usize, then: &[WalkPart]) -> WalkRequest {
    WalkRequest {
        step_frequency: Some(step_frequency),
        extent: Extent::Steps(steps),
        then: then.to_vec(),
        ..WalkRequest::default()
    }
}

fn part(steps: usize) -> WalkPart {
    WalkPart { steps, ..WalkPart::default() }
}

fn paced(steps: usize, step_frequency: f64) -> WalkPart {
    WalkPart { step_frequency: Some(step_frequency), ..part(steps) }
}

fn turning(steps: usize, degrees: f64) -> WalkPart {
    WalkPart { turn: degrees.to_radians(), ..part(steps) }
}

/// Two digits.
fn two(x: f64) -> String {
    if x < 9.95 { format!("{x:.1}") } else { format!("{x:.0}") }
}
