//! The files that `solaris ground` and `solaris inverse` write.

use crate::animation::{self, BodyFormat, Bones};
use crate::convert::TableFormat;
use crate::error::CliError;
use crate::given::Given;
use crate::output::{Formats, Outputs};
use solaris::io::bvh::Unit;
use solaris::io::record::positions;
use solaris::io::{bvh, csv, sto};
use std::io::Write;
use std::path::PathBuf;

/// What a file is to hold.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Content {
    /// Forces, of the ground or of the joints.
    Forces(TableFormat),
    /// The figure in its motion, and curves.
    Page,
    /// Curves of forces.
    Picture,
    /// The motion that `--consistent` made.
    Motion(MotionFormat),
    /// Means over strides, as a table or as a picture.
    Cycles(CyclesFormat),
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum MotionFormat {
    Csv,
    Sto,
    Bvh,
    Body(BodyFormat),
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum CyclesFormat {
    Table,
    Picture,
}

const FORCES: Formats<Content> = &[
    ("csv", Content::Forces(TableFormat::Csv)),
    ("sto", Content::Forces(TableFormat::Sto)),
    ("mot", Content::Forces(TableFormat::Sto)),
    #[cfg(feature = "parquet")]
    ("parquet", Content::Forces(TableFormat::Parquet)),
    ("html", Content::Page),
    ("svg", Content::Picture),
];

const MOTION: Formats<Content> = &[
    ("csv", Content::Motion(MotionFormat::Csv)),
    ("sto", Content::Motion(MotionFormat::Sto)),
    ("mot", Content::Motion(MotionFormat::Sto)),
    ("bvh", Content::Motion(MotionFormat::Bvh)),
    ("glb", Content::Motion(MotionFormat::Body(BodyFormat::Glb))),
    ("usda", Content::Motion(MotionFormat::Body(BodyFormat::Usda))),
];

const CYCLES: Formats<Content> =
    &[("csv", Content::Cycles(CyclesFormat::Table)), ("svg", Content::Cycles(CyclesFormat::Picture))];

/// The files that the options of `solaris ground` and `solaris inverse` name: of forces, of the motion, of means over strides.
pub(crate) fn outputs(
    forces: &[PathBuf],
    motions: &[PathBuf],
    cycles: &[PathBuf],
) -> Result<Outputs<Content>, CliError> {
    let forces = forces.iter().map(|path| ("-o", path, FORCES));
    let motions = motions.iter().map(|path| ("--motion-out", path, MOTION));
    let cycles = cycles.iter().map(|path| ("--cycles-out", path, CYCLES));
    Outputs::new(forces.chain(motions).chain(cycles))
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
        MotionFormat::Body(how) => {
            return animation::body(how, figure, motion, "moved", &Bones::default(), writer);
        }
    }
    .map_err(CliError::other)
}
