//! How well markers fit, as numbers and in words.

use super::Fitted;
use crate::plausible::Finding;
use crate::words::{capital, counted, row, short, some};
use serde::Serialize;
use solaris::model::Figure;
use solaris::view::TableRow;
use std::io::{Result, Write};

/// How many of the worst markers are shown.
const WORST: usize = 5;
/// A degree of freedom that is less sure than this (rad) is named.
const UNSURE: f64 = 0.35;

/// How well the markers of a trial fit a figure.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct MarkersReport {
    frames: usize,
    from_s: f64,
    to_s: f64,
    rate_hz: Option<f64>,
    unit: String,
    used: usize,
    rms_mm: f64,
    mean_cost_m2: f64,
    steps_a_frame: f64,
    /// Frames in which the solver came to no minimum.
    unsolved: usize,
    /// Frames without any marker, which keep the pose before.
    empty: usize,
    markers: Vec<Fit>,
    swaps: Vec<Exchange>,
    /// Degrees of freedom that no marker tells of, in some frames.
    blind: Vec<Blind>,
    /// Those of which the markers tell little, with their standard errors.
    unsure: Vec<Unsure>,
    /// Markers of the figure that the trial does not have.
    unseen: Vec<String>,
    /// Markers of the trial that the figure does not have.
    unknown: Vec<String>,
    /// That the figure lies on its side or stands on its head; absent where it is upright.
    #[serde(skip_serializing_if = "Option::is_none")]
    turned: Option<Finding>,
    notes: Vec<String>,
}

#[derive(Clone, Debug, Serialize)]
struct Fit {
    name: String,
    weight: f64,
    rms_mm: Option<f64>,
    greatest_mm: Option<f64>,
    greatest_s: Option<f64>,
    hidden_frames: usize,
}

#[derive(Clone, Debug, Serialize)]
struct Exchange {
    names: [String; 2],
    from_s: f64,
    to_s: f64,
    frames: usize,
}

#[derive(Clone, Debug, Serialize)]
struct Blind {
    dof: String,
    frames: usize,
}

#[derive(Clone, Debug, Serialize)]
struct Unsure {
    dof: String,
    standard_error_rad: f64,
}

impl MarkersReport {
    pub(crate) fn of(fitted: &Fitted, figure: &Figure) -> Self {
        let Fitted { recording, found, findings, turned, .. } = fitted;
        let time = recording.markers.time();
        let frames = time.len();
        let count = |of: &dyn Fn(&solaris::analysis::markers::FrameFit) -> bool| {
            found.frames.iter().filter(|frame| of(frame)).count()
        };
        let name = |dof: usize| figure.layout().v_names()[dof].clone();
        let millimetres = |x: f64| x * 1e3;
        let fits = found.markers.iter().map(|fit| Fit {
            name: fit.name.clone(),
            weight: fit.weight,
            rms_mm: Some(fit.rms).filter(|rms| !rms.is_nan()).map(millimetres),
            greatest_mm: fit.worst.map(|(distance, _)| millimetres(distance)),
            greatest_s: fit.worst.map(|(_, frame)| time[frame]),
            hidden_frames: frames - fit.seen,
        });
        let swaps = found.swaps.iter().map(|swap| Exchange {
            names: swap.names.clone(),
            from_s: time[swap.first],
            to_s: time[swap.last],
            frames: swap.last - swap.first + 1,
        });
        let blind = found.dofs.iter().filter(|sight| sight.blind > 0);
        let turns = |dof: usize| figure.layout().axis_kind(dof) == solaris::model::AxisKind::Rotation;
        let unsure = found.dofs.iter().filter(|sight| turns(sight.dof) && sight.spread.is_finite());
        let notes = recording.findings.iter().chain(findings).map(ToString::to_string);
        Self {
            frames,
            from_s: time.first().copied().unwrap_or_default(),
            to_s: time.last().copied().unwrap_or_default(),
            rate_hz: recording.markers.rate(),
            unit: recording.unit.to_string(),
            used: found.markers.len(),
            rms_mm: found.rms() * 1e3,
            mean_cost_m2: found.mean_cost(),
            steps_a_frame: found.frames.iter().map(|frame| frame.steps as f64).sum::<f64>() / frames as f64,
            unsolved: count(&|frame| !frame.converged),
            empty: count(&|frame| frame.seen == 0),
            markers: fits.collect(),
            swaps: swaps.collect(),
            blind: blind.map(|sight| Blind { dof: name(sight.dof), frames: sight.blind }).collect(),
            unsure: unsure
                .filter(|sight| sight.spread > UNSURE)
                .map(|sight| Unsure { dof: name(sight.dof), standard_error_rad: sight.spread })
                .collect(),
            unseen: found.matched.unseen.clone(),
            unknown: found.matched.unknown.clone(),
            turned: turned.clone(),
            notes: notes.collect(),
        }
    }

    /// What there is to say, by line: what it is about (nothing where that is as before), and the words.
    pub(crate) fn rows(&self) -> Vec<(&'static str, String)> {
        let rate = self.rate_hz.map_or_else(String::new, |rate| format!(", {} Hz", short(rate)));
        let mut rows = vec![(
            "markers",
            format!(
                "{} in {}{rate}, {} to {} s; lengths in {}",
                counted(self.used, "marker", "markers"),
                counted(self.frames, "frame", "frames"),
                short(self.from_s),
                short(self.to_s),
                self.unit
            ),
        )];
        rows.push(("fit", format!("{} mm rms over all markers and frames", short(self.rms_mm))));
        let mut worst: Vec<&Fit> = self.markers.iter().filter(|fit| fit.rms_mm.is_some()).collect();
        worst.sort_by(|a, b| b.rms_mm.unwrap_or(0.0).total_cmp(&a.rms_mm.unwrap_or(0.0)));
        for (i, fit) in worst.iter().take(WORST).enumerate() {
            let at = fit.greatest_s.map_or_else(String::new, |at| format!(" at {} s", short(at)));
            let (rms, greatest) = (fit.rms_mm.unwrap_or(0.0), fit.greatest_mm.unwrap_or(0.0));
            let words = format!("{}: {} mm rms, greatest {} mm{at}", fit.name, short(rms), short(greatest));
            rows.push((if i == 0 { "worst" } else { "" }, words));
        }
        let hidden: Vec<String> = self
            .markers
            .iter()
            .filter(|fit| fit.hidden_frames > 0)
            .map(|fit| format!("{} ({} frames)", fit.name, fit.hidden_frames))
            .collect();
        let mut say = |what: &'static str, words: String| rows.push((what, words));
        if !hidden.is_empty() {
            say("hidden", some(&hidden));
        }
        if self.empty > 0 {
            say("no marker at all", format!("in {} frames, which keep the pose before them", self.empty));
        }
        for (i, swap) in self.swaps.iter().enumerate() {
            let [a, b] = &swap.names;
            let (from, to) = (short(swap.from_s), short(swap.to_s));
            let words = format!(
                "{a} and {b} have each other's label from {from} to {to} s ({}); changed back",
                counted(swap.frames, "frame", "frames")
            );
            say(if i == 0 { "exchanged" } else { "" }, words);
        }
        if self.unsolved > 0 {
            say("unsolved", format!("{} frames came to no minimum", self.unsolved));
        }
        let never = self.blind.iter().filter(|blind| blind.frames == self.frames);
        let never: Vec<String> = never.map(|blind| blind.dof.clone()).collect();
        if !never.is_empty() {
            say("not seen", format!("no marker tells of {}: at rest", some(&never)));
        }
        let at_times = self.blind.iter().filter(|blind| blind.frames < self.frames);
        let at_times: Vec<String> =
            at_times.map(|blind| format!("{} ({} frames)", blind.dof, blind.frames)).collect();
        if !at_times.is_empty() {
            let words = format!(
                "at times no marker tells of {}: led from where it was seen to where it is seen again",
                some(&at_times)
            );
            say(if never.is_empty() { "not seen" } else { "" }, words);
        }
        let unsure: Vec<String> = self
            .unsure
            .iter()
            .map(|dof| format!("{} ±{}°", dof.dof, short(dof.standard_error_rad.to_degrees())))
            .collect();
        if !unsure.is_empty() {
            say("unsure", some(&unsure));
        }
        for (what, names) in [("not in the trial", &self.unseen), ("not on the figure", &self.unknown)] {
            if !names.is_empty() {
                say(what, some(names));
            }
        }
        if let Some(turned) = self.turned() {
            say("look at", turned.to_owned());
        }
        for note in &self.notes {
            say("of the markers", note.clone());
        }
        rows
    }

    /// That the figure lies on its side or stands on its head.
    pub(crate) fn turned(&self) -> Option<&str> {
        self.turned.as_ref().map(Finding::message)
    }

    pub(crate) fn write(&self, out: &mut dyn Write) -> Result<()> {
        self.rows().iter().try_for_each(|(what, words)| row(out, what, words))
    }

    /// What a page says of it.
    pub(crate) fn page_rows(&self) -> Vec<TableRow> {
        let rows = self.rows();
        rows.into_iter().map(|(what, words)| TableRow::new(capital(what), "", "", words)).collect()
    }
}
