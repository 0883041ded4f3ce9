//! The files that `solaris ground` and `solaris inverse` write: a table of forces, and the motion that was changed.

use crate::convert::TableFormat;
use crate::error::CliError;
use crate::given::Given;
use crate::output::{Formats, Outputs};
use crate::run::positions;
use solaris::io::bvh::Unit;
use solaris::io::{bvh, csv, sto};
use std::io::Write;
use std::path::PathBuf;

/// What a file is to hold.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Content {
    /// Forces, of the ground or of the joints.
    Forces(TableFormat),
    /// The motion that `--consistent` made.
    Motion(MotionFormat),
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum MotionFormat {
    Csv,
    Sto,
    Bvh,
}

const FORCES: Formats<Content> = &[
    ("csv", Content::Forces(TableFormat::Csv)),
    ("sto", Content::Forces(TableFormat::Sto)),
    ("mot", Content::Forces(TableFormat::Sto)),
];

const MOTION: Formats<Content> = &[
    ("csv", Content::Motion(MotionFormat::Csv)),
    ("sto", Content::Motion(MotionFormat::Sto)),
    ("mot", Content::Motion(MotionFormat::Sto)),
    ("bvh", Content::Motion(MotionFormat::Bvh)),
];

/// What a file of `solaris ground` is to hold.
#[derive(Clone, Copy, Debug)]
pub(super) enum Written {
    Table(Content),
    /// Forces over time.
    Picture,
}

const FORCES_OR_PICTURE: Formats<Written> = &[
    ("csv", Written::Table(Content::Forces(TableFormat::Csv))),
    ("sto", Written::Table(Content::Forces(TableFormat::Sto))),
    ("mot", Written::Table(Content::Forces(TableFormat::Sto))),
    ("svg", Written::Picture),
];

const MOVED: Formats<Written> = &[
    ("csv", Written::Table(Content::Motion(MotionFormat::Csv))),
    ("sto", Written::Table(Content::Motion(MotionFormat::Sto))),
    ("mot", Written::Table(Content::Motion(MotionFormat::Sto))),
    ("bvh", Written::Table(Content::Motion(MotionFormat::Bvh))),
];

/// The files that the options of `solaris ground` name.
pub(super) fn outputs_or_picture(
    forces: &[PathBuf],
    motions: &[PathBuf],
) -> Result<Outputs<Written>, CliError> {
    named(forces, motions, FORCES_OR_PICTURE, MOVED)
}

/// The files that the options of `solaris inverse` name.
pub(crate) fn outputs(forces: &[PathBuf], motions: &[PathBuf]) -> Result<Outputs<Content>, CliError> {
    named(forces, motions, FORCES, MOTION)
}

fn named<T: Copy + 'static>(
    forces: &[PathBuf],
    motions: &[PathBuf],
    formats: Formats<T>,
    motion: Formats<T>,
) -> Result<Outputs<T>, CliError> {
    let motions = motions.iter().map(|path| ("--motion-out", path, motion));
    Outputs::new(forces.iter().map(|path| ("-o", path, formats)).chain(motions))
}

/// Writes the motion as it is now; its frames are equally far apart.
pub(crate) fn write_motion(
    format: MotionFormat,
    mut writer: &mut dyn Write,
    given: &Given,
) -> Result<(), CliError> {
    let (figure, motion) = (&given.body.figure, given.motion());
    match format {
        MotionFormat::Csv => csv::write(figure, motion, &mut writer),
        MotionFormat::Sto => sto::write(&positions(figure, motion), &mut writer),
        MotionFormat::Bvh => bvh::write(figure, motion, Unit::default(), &mut writer),
    }
    .map_err(CliError::other)
}
