//! The page and the picture of a given motion, with what was found of it.

use crate::error::CliError;
use crate::given::{Given, GivenReport};
use crate::words::capital;
use solaris::analysis::InverseReport;
use solaris::analysis::ground::Sole;
use solaris::model::{ContactTrack, Ground, Motion, Vector3};
use solaris::view::{
    Effort, FootForces, LinkLine, PageCurve, PageOptions, TableRow, efforts, page as page_of,
};

/// The world's axes, and what they are called.
pub(crate) fn axes() -> [(&'static str, Vector3<f64>); 3] {
    [("along x", Vector3::x()), ("along y", Vector3::y()), ("along z", Vector3::z())]
}

/// Half the length of the strokes of a marker's cross (m).
const CROSS: f64 = 0.008;

/// What was found of a motion.
pub(crate) struct Shown<'a> {
    pub(crate) given: &'a Given,
    /// What acts on the feet, at the motion's times.
    pub(crate) contacts: &'a [ContactTrack],
    /// Whether plates measured that.
    pub(crate) is_measured: bool,
    /// The feet's soles, as far as they are known.
    pub(crate) soles: &'a [Sole],
    /// How high the ground is (m), where that is known.
    pub(crate) level: Option<f64>,
    /// The joints' forces.
    pub(crate) forces: Option<&'a InverseReport>,
    /// Half widths of the bands around positions and forces, where they are known.
    pub(crate) bands: Option<[Vec<f64>; 2]>,
}

impl Shown<'_> {
    /// The page, with these rows in its summary.
    pub(crate) fn page(&self, what: &str, table: Vec<TableRow>) -> Result<String, CliError> {
        let figure = &self.given.body.figure;
        let options = PageOptions {
            title: self.title(what),
            table,
            lines: lines(self.soles).into_iter().chain(self.markers()).collect(),
            curves: self.residuals(),
            forward: self.given.body.forward(),
            angle_bands: self.bands.as_ref().map(|[angles, _]| angles.clone()),
            moment_bands: self.bands.as_ref().map(|[_, moments]| moments.clone()),
            bands: self.bands.iter().map(|_| "two standard errors").collect(),
            people: Vec::new(),
        };
        page_of(figure, &self.motion()?, &options).map_err(CliError::other)
    }

    /// Joint moments, and the ground's forces below.
    pub(crate) fn picture(&self, what: &str) -> String {
        let (figure, time) = (&self.given.body.figure, self.given.motion().time());
        let nv = figure.layout().nv();
        let own = self.forces.iter().flat_map(|forces| {
            let shown = forces.dofs.iter().enumerate().filter(|(dof, _)| !figure.follows(*dof));
            // What is left over at the root comes last.
            let (residuals, joints): (Vec<_>, Vec<_>) = shown.partition(|(_, load)| load.is_residual);
            joints.into_iter().chain(residuals).map(move |(dof, load)| {
                let column = |of: &[f64]| of.iter().skip(dof).step_by(nv.max(1)).copied().collect();
                let name =
                    if load.is_residual { format!("{}, residual", load.dof) } else { load.dof.clone() };
                let spread =
                    self.bands.as_ref().filter(|_| !load.is_residual).map(|[_, moments]| column(moments));
                Effort { name, unit: load.unit.to_owned(), values: column(&forces.tau), spread }
            })
        });
        let own: Vec<Effort> = own.collect();
        let feet: Vec<FootForces<'_>> = self
            .contacts
            .iter()
            .map(|track| FootForces {
                name: &track.link,
                time,
                samples: &track.samples,
                is_measured: self.is_measured,
            })
            .collect();
        efforts(time, &own, &feet, &axes(), &self.title(what))
    }

    /// The markers, where the motion is markers: a small cross each.
    fn markers(&self) -> impl Iterator<Item = LinkLine> {
        let markers = self.given.markers.iter().flat_map(|_| &self.given.body.markers.markers);
        markers.flat_map(|marker| {
            [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| LinkLine {
                link: marker.link,
                ends: [marker.position - axis * CROSS, marker.position + axis * CROSS],
            })
        })
    }

    /// `walk: joint moments`.
    pub(crate) fn title(&self, what: &str) -> String {
        format!("{}: {what}", stem(self.given))
    }

    /// The motion with all that is known of it.
    fn motion(&self) -> Result<Motion, CliError> {
        let mut motion = self.given.motion().clone();
        motion.contacts = self.contacts.to_vec();
        motion.info.ground = self.level.map(|height| Ground { height, friction: None });
        if let Some(forces) = self.forces {
            motion.set_tau(forces.tau.clone()).map_err(CliError::other)?;
        }
        Ok(motion)
    }

    /// What is missing for the balance of a figure that nothing holds.
    fn residuals(&self) -> Vec<PageCurve> {
        let Some(forces) = self.forces.filter(|_| self.given.body.figure.root_is_free()) else {
            return Vec::new();
        };
        [("Residual force", "N"), ("Residual moment", "N m")]
            .iter()
            .enumerate()
            .map(|(part, (label, unit))| PageCurve {
                label: (*label).to_owned(),
                unit: (*unit).to_owned(),
                values: forces.residuals.iter().map(|pair| pair[part]).collect(),
            })
            .collect()
    }
}

/// A motion's name: its file without folder and extension.
pub(crate) fn stem(given: &Given) -> String {
    given.from.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned())
}

/// The soles' lines.
fn lines(soles: &[Sole]) -> Vec<LinkLine> {
    soles.iter().flat_map(Sole::lines).map(|(link, ends)| LinkLine { link, ends }).collect()
}

/// What a page says of what went in, and what looks wrong with it.
pub(crate) fn given_rows(report: &GivenReport) -> Vec<TableRow> {
    let mut rows = report.page_rows();
    rows.extend(report.doubts().into_iter().map(|(what, value)| TableRow::new(capital(what), "", "", value)));
    rows
}

/// What is to be looked at.
pub(crate) fn warning_rows(warnings: &[String]) -> impl Iterator<Item = TableRow> + '_ {
    warnings.iter().map(|warning| TableRow::new("Look at", "", "", warning))
}
