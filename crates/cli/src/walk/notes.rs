//! Notes on what is known to be wrong with a walk, said where it shows.

use solaris::gait::{FRICTION, InBetween, IsolatedPeak, Peak, StyledPlan, WalkMeasures};

/// From which on a knee that bends backward is worth a word (rad): half a degree; people's straighten by more.
const HYPEREXTENDED: f64 = 0.009;

/// What is known to be wrong with a walk of a body of some weight (N).
pub(super) fn notes(
    plan: &StyledPlan,
    measures: &WalkMeasures,
    lone: &[IsolatedPeak],
    weight: f64,
    repeats: bool,
) -> Vec<String> {
    let mut notes = Vec::new();
    if let StyledPlan::Thesis(plan) = plan {
        let what = match plan.in_between {
            InBetween::Rest => "the body stops at every posture",
            InBetween::Linear => "the body's velocity jumps at every posture",
        };
        let reach = measures.extremes.vertical.value;
        notes.push(format!("{what}: forces reach {reach:.0} %BW; --style smooth walks on"));
        notes.extend(artefacts(lone, weight));
        if let Some(slide) = plan.walk.toe_slide() {
            notes.push(format!(
                "both postures have the toe of the foot behind on the ground, {:.0} mm apart: it counts as lifted between",
                1e3 * slide.abs()
            ));
        }
    }
    if let StyledPlan::Run(plan) = plan
        && plan.stride().style().give > 0.0
    {
        let give = 1e3 * plan.stride().style().give;
        notes.push(format!(
            "its soles give: in the middle of a stance a foot is {give:.1} mm deep in the ground, as was asked, and the greatest slide and sink are that"
        ));
    }
    let heading = plan.heading();
    let Some(plan) = plan.smooth() else { return notes };
    let turned = heading.to_degrees();
    if turned.abs() > 1e-9 {
        notes.push(format!(
            "it turns by {:.1}° to the {} in all; the distance, braking and pushing are those along its first direction",
            turned.abs(),
            if turned > 0.0 { "left" } else { "right" }
        ));
    }
    if plan.is_backward() {
        notes.push(
            "it goes backward, as a walk forward in reversed time: people's joints do nearly so, and their bands are of walking forward"
                .to_owned(),
        );
    }
    let step_frequency = plan.style().step_frequency;
    if measures.extremes.least_knee.value < -HYPEREXTENDED {
        notes.push(format!(
            "a knee is hyperextended by {:.1}° at {:.2} s",
            -measures.extremes.least_knee.value.to_degrees(),
            measures.extremes.least_knee.time
        ));
    }
    for (whose, peak, limit) in [
        ("both feet", measures.extremes.friction, FRICTION.0),
        ("one foot", measures.extremes.foot_friction, FRICTION.1),
    ] {
        if peak.value > limit {
            notes.push(format!(
                "as written, the motion needs a friction of {:.2} under {whose} at {:.2} s, and soles hold {limit}: a leg \
                 passes straight there; shorten the step",
                peak.value, peak.time
            ));
        }
    }
    if measures.extremes.cop_outside.value > 1e-3 {
        notes.push(format!(
            "the ground would have to press {:.0} mm beside a foot at {:.2} s",
            1e3 * measures.extremes.cop_outside.value,
            measures.extremes.cop_outside.time
        ));
    }
    if let Some(beyond) = &measures.extremes.beyond_range {
        notes.push(format!(
            "{} goes {:.1}° beyond its range at {:.2} s",
            beyond.joint,
            beyond.by.to_degrees(),
            beyond.time
        ));
    }
    if step_frequency > 115.0 && !plan.is_backward() {
        notes.push(
            "above 115 steps/min hip range, hip moments, push and ankle moment exceed people's".to_owned(),
        );
    }
    if step_frequency < 82.0 && !plan.is_backward() {
        notes.push(
            "up to about 80 steps/min the vertical force dips a little before its second peak".to_owned(),
        );
    }
    if plan.is_extrapolated() {
        notes.push(
            "steps are shorter than any that the style was fitted to: its numbers are held, and the knee lands too bent"
                .to_owned(),
        );
    }
    if measures.steady.is_none() && !repeats && !plan.is_backward() {
        notes.push(
            "no steady stride in the middle (eight steps straight on at one pace have one), so there is nothing to hold against people's bands"
                .to_owned(),
        );
    }
    notes
}

/// Greatest forces that only one sample has. A smooth walk has none; where a body goes from posture to posture, its acceleration
/// jumps as one phase gives way to the next.
fn artefacts(lone: &[IsolatedPeak], weight: f64) -> Option<String> {
    // Rounded here, for what is nearly nothing is not less than it.
    let percent = |force: f64| (100.0 * force / weight).round() + 0.0;
    let told = lone.iter().map(|force| {
        let Peak { value, time } = force.peak;
        format!(
            "{:.0} %BW ({value:.0} N) {} at {time:.2} s, {:.0} %BW beside it",
            percent(value),
            force.direction,
            percent(force.neighbour)
        )
    });
    let told: Vec<String> = told.collect();
    let what = if told.len() > 1 { "single samples, artefacts" } else { "a single sample, an artefact" };
    (!told.is_empty())
        .then(|| format!("{what} of the change of posture, no forces to reckon with: {}", told.join("; ")))
}
