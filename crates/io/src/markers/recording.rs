//! What a file of markers holds.

use super::axes::Axes;
use super::plates::{LoadOptions, Plate};
use super::unit::LengthUnit;
use solaris_model::{Finding, FindingKind, MarkerTrial};

/// What a file of markers holds.
#[derive(Clone, Debug)]
pub struct Recording {
    /// The markers, in metres along the laboratory's axes.
    pub markers: MarkerTrial,
    /// The unit that the file's lengths were read in.
    pub unit: LengthUnit,
    /// Frames a second (Hz): what the file says, or else what its times say.
    pub rate: Option<f64>,
    /// The number that the file gives its first frame. The times of C3D files begin with zero whatever it is.
    pub first_frame: i64,
    /// How far apart the cameras saw each point (m): frame after frame, in each all markers; NaN where one was hidden. Empty
    /// where the file does not say, as of TRC.
    pub residuals: Vec<f64>,
    /// What happened when, in the order of the file.
    pub events: Vec<Event>,
    /// Signals beside the markers, such as those of muscles; those of force plates too.
    pub analog: Vec<Channel>,
    /// Force plates whose numbers are read.
    pub plates: Vec<Plate>,
    /// What was odd, guessed or left out.
    pub findings: Vec<Finding>,
}

impl Recording {
    /// The same recording along other axes: what is along `from` in the file is along `to`. Plates that push the subject
    /// down, as in files that hold what the subject does to the plate, are [turned round](Plate::is_opposite), with a finding.
    #[must_use]
    pub fn turned(mut self, from: &Axes, to: &Axes) -> Self {
        let turn = from.turn_to(to);
        self.markers = self.markers.mapped(|point| turn * point);
        let up = to.up().vector();
        for plate in &mut self.plates {
            plate.corners = plate.corners.map(|corner| turn * corner);
            let push = plate.mean_force(&LoadOptions::default()).0.dot(&up);
            if push < 0.0 {
                plate.is_opposite = !plate.is_opposite;
                let message = format!(
                    "it pushes down with {:.0} N: that is the subject on the plate, and is turned round",
                    -push
                );
                let subject = format!("force plate {}", plate.number);
                self.findings.push(Finding { kind: FindingKind::Note, subject, message, place: None });
            }
        }
        self
    }
}

/// Something that happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// What, such as `Foot Strike`.
    pub label: String,
    /// On which side, such as `Left`; empty where the file does not say.
    pub context: String,
    /// When (s), on the clock of the markers.
    pub time: f64,
}

/// A signal beside the markers.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Its name.
    pub label: String,
    /// Its unit, as the file writes it.
    pub unit: String,
    /// Samples a second (Hz). The first is at the time of the first frame.
    pub rate: f64,
    /// The samples, in that unit.
    pub samples: Vec<f64>,
}
