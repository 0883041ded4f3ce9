//! `solaris convert` of recordings: markers as TRC or CSV, and what force plates measured.

use crate::args::ConvertArgs;
use crate::error::{CliError, UsageError};
use crate::findings::list;
use crate::output::{Formats, Outputs};
use crate::print::print;
use crate::recording::{self, Turned};
use crate::words::{counted, short};
use solaris::io::markers::{LengthUnit, LoadOptions, Recording, ground_forces, write_csv};
use solaris::io::{Table, sto, trc};
use std::path::Path;

/// What of a recording is written.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Trc,
    Csv,
    /// What its force plates measured.
    Forces,
}

const PARTS: Formats<Part> =
    &[("trc", Part::Trc), ("csv", Part::Csv), ("mot", Part::Forces), ("sto", Part::Forces)];

pub(super) fn run(args: &ConvertArgs) -> Result<(), CliError> {
    let ConvertArgs { from, to, size, skeleton, axes, figure, .. } = args;
    if size.is_asked() || figure.is_some() {
        return Err(UsageError::MarkersHaveNoFigure.into());
    }
    if skeleton.up.is_some()
        || skeleton.masses.is_some()
        || skeleton.skip_frames > 0
        || skeleton.clip.is_some()
    {
        return Err(UsageError::OnlyOfBones.into());
    }
    let outputs = Outputs::new([("OUT", to, PARTS)])?;
    outputs.keep_off([from.as_path()])?;
    let Turned { recording, axes, .. } =
        recording::turned(recording::read(from, recording::unit(skeleton.unit)?)?, *axes);
    let is_forces = ["mot", "sto"].contains(&crate::input::extension(to).as_str());
    let forces = if is_forces { Some(forces(from, &recording)?) } else { None };
    let title = to.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    outputs.write(|part, mut writer| match (part, &forces) {
        (Part::Forces, Some(table)) => sto::write(table, &mut writer).map_err(CliError::other),
        (Part::Csv, _) => write_csv(&recording.markers, &mut writer).map_err(CliError::other),
        _ => trc::write(&recording.markers, &title, LengthUnit::Millimetres, &mut writer)
            .map_err(CliError::other),
    })?;
    print(|out| {
        if let Some(table) = &forces {
            let plates = counted(recording.plates.len(), "force plate", "force plates");
            let rows = counted(table.len(), "row", "rows");
            let rate = short(recording.plates[0].rate);
            writeln!(out, "{plates} in {rows} at {rate} Hz, in N, m and N·m")?;
        } else {
            let names = counted(recording.markers.names().len(), "marker", "markers");
            let frames = counted(recording.markers.len(), "frame", "frames");
            let rate = recording.rate.map(|rate| format!(" at {} Hz", short(rate))).unwrap_or_default();
            let unit = if crate::input::extension(to) == "csv" { "m" } else { "mm" };
            writeln!(out, "{names} in {frames}{rate}, in {unit}")?;
        }
        writeln!(
            out,
            "x is forward, y up and z right; in {} {} was forward and {} up",
            from.display(),
            axes.forward(),
            axes.up()
        )?;
        list(out, &recording.findings)?;
        outputs.written().try_for_each(|line| writeln!(out, "{line}"))
    })
}

/// What the force plates measured.
fn forces(from: &Path, recording: &Recording) -> Result<Table, CliError> {
    if recording.plates.is_empty() {
        let said: Vec<String> = recording.findings.iter().map(ToString::to_string).collect();
        let plates =
            said.into_iter().find(|said| said.starts_with("force plate")).map(|said| format!(" ({said})"));
        let why = format!(
            "it has no force plate that is read{}; .trc and .csv hold its markers",
            plates.unwrap_or_default()
        );
        return Err(CliError::input(from, &why));
    }
    ground_forces(&recording.plates, &LoadOptions::default())
        .ok_or_else(|| CliError::input(from, &"its force plates have different rates, and a table has one"))
}
