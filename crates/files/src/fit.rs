//! Motions that are markers, brought to positions of a figure.

use crate::error::FileError;
use crate::figure::Body;
use solaris_analysis::markers::{FrameFit, IkOptions, MarkerMotion, inverse_kinematics};
use solaris_io::markers::Recording;
use solaris_model::{Finding, FindingKind, Known, Marker, MarkerTrial, Motion, MotionInfo};
use std::path::Path;

/// A trial of markers, and the positions that fit it.
#[derive(Debug)]
pub struct MarkerFit {
    /// The trial, in the figure's world, from the first to the last frame that tells where the figure is.
    pub recording: Recording,
    /// Positions alone; nothing else is known yet.
    pub motion: Motion,
    /// How well they fit.
    pub found: MarkerMotion,
    /// The figure's markers.
    pub markers: Vec<Marker>,
    /// How they were asked to be fitted.
    pub options: IkOptions,
    /// What was done on the way.
    pub findings: Vec<Finding>,
}

impl Body {
    /// How markers are fitted to it while nobody says more: defaults and locks are the model's; ranges hold where it clamps them, and
    /// where the format knows no clamps.
    pub fn ik_options(&self) -> IkOptions {
        IkOptions {
            held: self.locked(),
            bounds: self.clamped(),
            rest: Some(self.rest()),
            ..IkOptions::default()
        }
    }

    /// Its markers, or its named frames where it has none.
    pub fn known_markers(&self) -> Vec<Marker> {
        if self.markers.markers.is_empty() { self.frames_as_markers() } else { self.markers.markers.clone() }
    }
}

/// Finds the positions of a figure that fit the markers of a recording, which was read from `path` and is in the figure's world.
///
/// # Errors
///
/// Markers that tell nothing of the figure, and what inverse kinematics refuse.
pub fn fit_markers(
    path: &Path,
    body: &Body,
    mut recording: Recording,
    options: IkOptions,
) -> Result<MarkerFit, FileError> {
    let (figure, markers) = (&body.figure, body.known_markers());
    let find = |trial: &MarkerTrial| {
        inverse_kinematics(figure, &markers, trial, &options).map_err(|error| FileError::input(path, &error))
    };
    let mut found = find(&recording.markers)?;
    let mut findings = Vec::new();
    if let Some((placed, finding)) = placed(&recording.markers, &found) {
        found = find(&placed)?;
        recording.markers = placed;
        findings.push(finding);
    }
    let time = recording.markers.time().to_vec();
    let info = MotionInfo::recorded(figure, body.gravity, &time);
    let nv = figure.layout().nv();
    let still = vec![0.0; time.len() * nv];
    let states = [found.q.clone(), still.clone(), still];
    let known = Known { v: vec![false; nv], a: vec![false; nv] };
    let motion = Motion::recorded(figure, info, time, states, known)
        .map_err(|error| FileError::input(path, &error))?;
    Ok(MarkerFit { recording, motion, found, markers, options, findings })
}

/// The trial from the first to the last frame that tells where the figure is, if that is not all of it.
fn placed(trial: &MarkerTrial, found: &MarkerMotion) -> Option<(MarkerTrial, Finding)> {
    let is_placed = |frame: &FrameFit| frame.is_placed;
    let (first, last) = (found.frames.iter().position(is_placed)?, found.frames.iter().rposition(is_placed)?);
    let after = found.frames.len() - 1 - last;
    let cut = [(first, "at the beginning"), (after, "at the end")];
    let cut = cut.iter().filter(|(frames, _)| *frames > 0);
    let words: Vec<String> = cut
        .map(|(frames, which)| format!("{frames} frame{} {which}", if *frames == 1 { "" } else { "s" }))
        .collect();
    let finding = Finding {
        kind: FindingKind::Note,
        subject: "frames".to_owned(),
        message: format!("{} left out: no markers tell where the figure is", words.join(" and ")),
        place: None,
    };
    let trial = trial.within(found.frames[first].time, found.frames[last].time);
    (!words.is_empty()).then_some((trial, finding))
}
