//! Whether plates belong to the motion that they are given to.

use crate::error::CliError;
use crate::given::Given;
use crate::words::{row, short};
use serde::Serialize;
use solaris::analysis::ground::{PlacedFeet, Sole, Stances};
use solaris::analysis::plausibility::{
    MotionFinding, PlateReport, ResidualCheck, check_plates, check_residual,
};
use solaris::analysis::{InverseReport, PreparedMotion};
use solaris::files::check_measured;
use solaris::model::MeasuredForce;
use solaris::view::TableRow;
use std::io::{Result, Write};

/// What is to be said of measured forces.
#[derive(Serialize)]
pub(crate) struct Plausibility {
    /// What the plates bear over what figure and motion need; absent where no frame has all standing feet on plates.
    plates_bear: Option<f64>,
    /// Frames in which they have.
    complete_frames: usize,
    ground_level_m: f64,
    plates: Vec<Plate>,
    findings: Vec<Finding>,
    /// The residual beside published thresholds; absent where something holds the root.
    #[serde(skip_serializing_if = "Option::is_none")]
    residual: Option<Residual>,
}

/// One force and the foot that it is given to.
#[derive(Serialize)]
struct Plate {
    foot: String,
    loaded_frames: usize,
    mean_distance_m: Option<f64>,
    greatest_distance_m: Option<f64>,
    at_s: Option<f64>,
}

/// Something that does not fit.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Finding {
    kind: &'static str,
    subject: Option<String>,
    value: f64,
    threshold: f64,
    unit: &'static str,
    message: String,
}

/// The residual and what is published as acceptable.
#[derive(Serialize)]
struct Residual {
    force_n: f64,
    force_threshold_n: f64,
    moment_nm: f64,
    moment_threshold_nm: f64,
    greatest_external_n: f64,
    com_height_m: f64,
    likely: &'static str,
}

impl From<&MotionFinding> for Finding {
    fn from(found: &MotionFinding) -> Self {
        let (value, threshold) = found.value_and_threshold();
        Self {
            kind: found.kind(),
            subject: found.subject().map(str::to_owned),
            value,
            threshold,
            unit: found.unit(),
            message: found.to_string(),
        }
    }
}

impl Finding {
    /// With what to do about it on the command line.
    pub(crate) fn with_advice(self, advice: &str) -> Self {
        Self { message: format!("{}; {advice}", self.message), ..self }
    }

    /// In words.
    pub(crate) fn message(&self) -> &str {
        &self.message
    }
}

impl Plausibility {
    /// Of forces on links of the figure; without soles by the links that they act on. None without forces or gravity.
    pub(crate) fn of(
        given: &Given,
        prepared: &PreparedMotion<'_>,
        soles: Option<Vec<Sole>>,
        measured: &[MeasuredForce],
    ) -> std::result::Result<Option<Self>, CliError> {
        let has_times = given.table.column("time").is_some();
        let report = check_measured(&given.body.figure, prepared, soles, measured, has_times);
        let report = report.map_err(|error| CliError::input(&given.from, &error))?;
        Ok(report.as_ref().map(Self::new))
    }

    /// Of forces on feet that are placed.
    pub(crate) fn on(
        given: &Given,
        feet: &PlacedFeet<'_>,
        stances: &Stances,
        measured: &[MeasuredForce],
    ) -> std::result::Result<Self, CliError> {
        let report = check_plates(feet.prepared(), Some((feet, stances)), measured);
        Ok(Self::new(&report.map_err(|error| CliError::input(&given.from, &error))?))
    }

    fn new(report: &PlateReport) -> Self {
        let plate = |plate: &solaris::analysis::plausibility::PlateFit| Plate {
            foot: plate.foot.clone(),
            loaded_frames: plate.loaded,
            mean_distance_m: plate.mean_distance,
            greatest_distance_m: plate.greatest_distance.map(|(distance, _)| distance),
            at_s: plate.greatest_distance.map(|(_, time)| time),
        };
        Self {
            plates_bear: report.borne,
            complete_frames: report.complete,
            ground_level_m: report.level,
            plates: report.plates.iter().map(plate).collect(),
            findings: report.findings.iter().map(Finding::from).collect(),
            residual: None,
        }
    }

    /// With the residual of joint forces that were found with these forces, where nothing holds the root.
    pub(crate) fn with_residual(
        mut self,
        given: &Given,
        prepared: &PreparedMotion<'_>,
        found: &InverseReport,
        measured: &[MeasuredForce],
    ) -> std::result::Result<Self, CliError> {
        if !given.body.figure.root_is_free() {
            return Ok(self);
        }
        let unsettled = given.found.unsettled;
        let checked = check_residual(prepared, found, measured, self.ground_level_m, unsettled)
            .map_err(|error| CliError::input(&given.from, &error))?;
        self.residual = checked.as_ref().map(Residual::from);
        Ok(self)
    }

    /// What does not fit, in words.
    pub(crate) fn messages(&self) -> impl Iterator<Item = &str> {
        self.findings.iter().map(Finding::message)
    }

    /// What does not fit, for a page.
    pub(crate) fn page_rows(&self) -> impl Iterator<Item = TableRow> {
        self.messages().map(|message| TableRow::new("Look at", "", "", message))
    }

    /// How the plates fit, in a line, and what does not fit.
    pub(crate) fn write(&self, out: &mut dyn Write) -> Result<()> {
        self.write_fit(out)?;
        if !self.findings.is_empty() {
            writeln!(out, "\n  Look at")?;
        }
        self.messages().try_for_each(|message| writeln!(out, "  - {message}"))
    }

    /// How the plates fit, in a line.
    pub(crate) fn write_fit(&self, out: &mut dyn Write) -> Result<()> {
        let borne = self
            .plates_bear
            .map(|share| format!("bear {:.1} % of what figure and motion need", 100.0 * share));
        let far = self.plates.iter().filter_map(|plate| plate.mean_distance_m).reduce(f64::max);
        let far = far.map(|far| match (far * 1e3).round() {
            0.0 => "press under their feet".to_owned(),
            far => format!("press at most {far} mm beside their feet on average"),
        });
        let said: Vec<String> = borne.into_iter().chain(far).collect();
        if said.is_empty() {
            return row(out, "plates", "no frame has all standing feet on plates: not judged");
        }
        row(out, "plates", &said.join("; "))
    }

    /// The residual beside the published thresholds.
    pub(crate) fn write_residual(&self, out: &mut dyn Write) -> Result<()> {
        let Some(r) = &self.residual else { return Ok(()) };
        let beside = |value: f64, threshold: f64| format!("{} of {}", short(value), short(threshold));
        writeln!(
            out,
            "\n  Beside published thresholds (Hicks and others 2015), but for the ends that are the filter's:\n  force {} N (5 % of \
             the greatest external force), moment {} N m\n  (1 % of that times the height of the centre of mass, {} m):\n  {}",
            beside(r.force_n, r.force_threshold_n),
            beside(r.moment_nm, r.moment_threshold_nm),
            short(r.com_height_m),
            r.likely
        )
    }
}

impl From<&ResidualCheck> for Residual {
    fn from(checked: &ResidualCheck) -> Self {
        Self {
            force_n: checked.force,
            force_threshold_n: checked.force_threshold,
            moment_nm: checked.moment,
            moment_threshold_nm: checked.moment_threshold,
            greatest_external_n: checked.greatest_external,
            com_height_m: checked.com_height,
            likely: checked.cause(),
        }
    }
}
