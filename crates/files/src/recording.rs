//! Recordings of markers: C3D and TRC files.

use crate::error::FileError;
use crate::files::Source;
use crate::read::extension;
use solaris_io::markers::{Axes, LengthUnit, Recording, Way, find_axes};
use solaris_io::{c3d, trc};
use solaris_model::{Finding, FindingKind, Vector3};
use std::path::Path;

/// A recording along the axes of a world, and which of its own those were.
#[derive(Debug)]
pub struct Turned {
    /// It, along the world's axes.
    pub recording: Recording,
    /// Which ways of the file were up and forward.
    pub axes: Axes,
    /// Which ways of the world are.
    world: Axes,
}

impl Turned {
    /// The axes of the file, where up in it is what now points nearest to `along`; as they are where that is no direction.
    pub fn with_up(&self, along: &Vector3<f64>) -> Axes {
        let up = Way::nearest(&(self.axes.turn_to(&self.world).transpose() * along));
        // Where up was what is forward, the old up is as good as any.
        let sides = [self.axes.forward(), self.axes.up()];
        let found = sides.into_iter().find_map(|forward| Axes::new(up, forward).ok());
        found.filter(|_| along.norm_squared() > 0.0).unwrap_or(self.axes)
    }
}

/// Whether a file is one of markers, by its extension.
pub fn is_recording(path: &Path) -> bool {
    matches!(extension(path).as_str(), "c3d" | "trc")
}

impl Source<'_> {
    /// Reads a recording, in the unit that is asked for or its own.
    ///
    /// # Errors
    ///
    /// Files that cannot be read, and what is no recording.
    pub fn recording(self, path: &Path, unit: Option<LengthUnit>) -> Result<Recording, FileError> {
        if extension(path) == "c3d" {
            let bytes = self.bytes(path)?;
            return c3d::read(&bytes, &c3d::ReadOptions { unit })
                .map_err(|error| FileError::input(path, &error));
        }
        let text = self.decoded(path)?;
        trc::read(&text, &trc::ReadOptions { unit }).map_err(|faults| FileError::faulty(path, &text, faults))
    }

    /// Reads a recording along the axes of a world with this gravity: turned where its axes are named, or where plates or names tell
    /// that another way is up in it. Without gravity it stays as it is.
    ///
    /// # Errors
    ///
    /// As [`Source::recording`].
    pub fn in_world(
        self,
        path: &Path,
        gravity: Vector3<f64>,
        unit: Option<LengthUnit>,
        named: Option<Axes>,
    ) -> Result<Turned, FileError> {
        let mut recording = self.recording(path, unit)?;
        let as_it_is = |recording, world| Ok(Turned { recording, axes: world, world });
        if gravity.norm_squared() == 0.0 {
            return as_it_is(recording, Axes::OPENSIM);
        }
        let up = Way::nearest(&-gravity);
        // Any level way will do for forward, as nothing in a world looks anywhere; that of OpenSim where it is one.
        let forward = if up.axis() == 0 { Way::along(1) } else { Way::along(0) };
        let Ok(world) = Axes::new(up, forward) else { return as_it_is(recording, Axes::OPENSIM) };
        if let Some(axes) = named {
            return Ok(Turned { recording: recording.turned(&axes, &world), axes, world });
        }
        let (axes, findings) = find_axes(&recording);
        // The first one is about up; forward is nobody's concern, as markers may be seen from any side.
        let Some(by) = findings.into_iter().next().filter(|_| axes.up() != up) else {
            // Plates that hold what the subject does to them are turned round all the same.
            return as_it_is(recording.turned(&world, &world), world);
        };
        if by.kind == FindingKind::Suspect {
            let message = format!(
                "neither names nor plates tell which way is up; {up} is taken to be, as of the figure"
            );
            recording.findings.push(Finding { message, ..by });
            return as_it_is(recording, world);
        }
        recording.findings.push(by);
        Ok(Turned { recording: recording.turned(&axes, &world), axes, world })
    }
}

/// [`Source::recording`] of the disk.
///
/// # Errors
///
/// As there.
pub fn recording(path: &Path, unit: Option<LengthUnit>) -> Result<Recording, FileError> {
    Source::disk().recording(path, unit)
}

/// [`Source::in_world`] of the disk.
///
/// # Errors
///
/// As there.
pub fn in_world(
    path: &Path,
    gravity: Vector3<f64>,
    unit: Option<LengthUnit>,
    named: Option<Axes>,
) -> Result<Turned, FileError> {
    Source::disk().in_world(path, gravity, unit, named)
}

/// Turns a recording into the axes of `OpenSim` (x forward, y up) from those that are named, or else from those that are found.
pub fn turned(mut recording: Recording, named: Option<Axes>) -> Turned {
    let axes = named.unwrap_or_else(|| {
        let (axes, findings) = find_axes(&recording);
        recording.findings.extend(findings);
        axes
    });
    Turned { recording: recording.turned(&axes, &Axes::OPENSIM), axes, world: Axes::OPENSIM }
}
