//! Recordings of markers: C3D and TRC files.

use crate::args::MarkerArgs;
use crate::error::{CliError, UsageError};
use crate::input::{self, extension};
use solaris::io::bvh::Unit;
use solaris::io::markers::{Axes, LengthUnit, Recording, Way, find_axes};
use solaris::io::{c3d, trc};
use solaris::model::{Finding, FindingKind, Vector3};
use std::path::Path;

/// A recording along the axes of a world, and which of its own those were.
pub(crate) struct Turned {
    pub(crate) recording: Recording,
    /// Which ways of the file were up and forward.
    pub(crate) axes: Axes,
    /// Which ways of the world are.
    world: Axes,
}

impl Turned {
    /// The axes of the file, where up in it is what now points nearest to `along`; as they are where that is no direction.
    pub(crate) fn with_up(&self, along: &Vector3<f64>) -> Axes {
        let up = Way::nearest(&(self.axes.turn_to(&self.world).transpose() * along));
        // Where up was what is forward, the old up is as good as any.
        let sides = [self.axes.forward(), self.axes.up()];
        let found = sides.into_iter().find_map(|forward| Axes::new(up, forward).ok());
        found.filter(|_| along.norm_squared() > 0.0).unwrap_or(self.axes)
    }
}

/// Whether a file is one of markers, by its extension.
pub(crate) fn is_one(path: &Path) -> bool {
    matches!(extension(path).as_str(), "c3d" | "trc")
}

/// Reads a recording, in the unit that is asked for or its own.
pub(crate) fn read(path: &Path, unit: Option<LengthUnit>) -> Result<Recording, CliError> {
    if extension(path) == "c3d" {
        let bytes = input::bytes(path)?;
        return c3d::read(&bytes, &c3d::ReadOptions { unit }).map_err(|error| CliError::input(path, &error));
    }
    let text = input::decoded(path)?;
    trc::read(&text, &trc::ReadOptions { unit }).map_err(|faults| input::faulty(path, &text, faults))
}

/// Turns a recording into the axes of `OpenSim` (x forward, y up) from those that are named, or else from those that are found.
pub(crate) fn turned(mut recording: Recording, named: Option<Axes>) -> Turned {
    let axes = named.unwrap_or_else(|| {
        let (axes, findings) = find_axes(&recording);
        recording.findings.extend(findings);
        axes
    });
    Turned { recording: recording.turned(&axes, &Axes::OPENSIM), axes, world: Axes::OPENSIM }
}

/// Reads a recording along the axes of a world with this gravity: turned where its axes are named, or where plates or names tell
/// that another way is up in it. Without gravity it stays as it is.
pub(crate) fn in_world(path: &Path, gravity: Vector3<f64>, args: &MarkerArgs) -> Result<Turned, CliError> {
    let mut recording = read(path, args.unit)?;
    let as_it_is = |recording, world| Ok(Turned { recording, axes: world, world });
    if gravity.norm_squared() == 0.0 {
        return as_it_is(recording, Axes::OPENSIM);
    }
    let up = Way::nearest(&-gravity);
    // Any level way will do for forward, as nothing in a world looks anywhere; that of OpenSim where it is one.
    let forward = if up.axis() == 0 { Way::along(1) } else { Way::along(0) };
    let Ok(world) = Axes::new(up, forward) else { return as_it_is(recording, Axes::OPENSIM) };
    if let Some(axes) = args.axes {
        return Ok(Turned { recording: recording.turned(&axes, &world), axes, world });
    }
    let (axes, findings) = find_axes(&recording);
    // The first one is about up; forward is nobody's concern, as markers may be seen from any side.
    let Some(by) = findings.into_iter().next().filter(|_| axes.up() != up) else {
        // Plates that hold what the subject does to them are turned round all the same.
        return as_it_is(recording.turned(&world, &world), world);
    };
    if by.kind == FindingKind::Suspect {
        let message =
            format!("neither names nor plates tell which way is up; {up} is taken to be, as of the figure");
        recording.findings.push(Finding { message, ..by });
        return as_it_is(recording, world);
    }
    recording.findings.push(by);
    Ok(Turned { recording: recording.turned(&axes, &world), axes, world })
}

/// The unit of lengths that `--unit` names.
pub(crate) fn unit(asked: Option<Unit>) -> Result<Option<LengthUnit>, UsageError> {
    Ok(match asked {
        None => None,
        Some(Unit::Millimetres) => Some(LengthUnit::Millimetres),
        Some(Unit::Centimetres) => Some(LengthUnit::Centimetres),
        Some(Unit::Metres) => Some(LengthUnit::Metres),
        Some(Unit::Inches) => Some(LengthUnit::Inches),
        Some(Unit::Cmu | Unit::Of(_)) => return Err(UsageError::UnitOfMarkers),
    })
}

/// Those of findings that look wrong.
pub(crate) fn doubts(findings: &[Finding]) -> usize {
    findings
        .iter()
        .filter(|finding| matches!(finding.kind, FindingKind::Missing | FindingKind::Suspect))
        .count()
}
