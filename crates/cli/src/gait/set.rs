//! `solaris gait set`: clips for a character of a game.

use crate::animation::{self, Bones};
use crate::args::{Loop, SetArgs};
use crate::error::CliError;
use crate::output::{Formats, Outputs, is_folder, make_folder};
use crate::print::{print, write_json};
use crate::progress::Progress;
use crate::walk::{dressed, figure, heading_first};
use crate::words::short;
use serde::Serialize;
use solaris::gait::set::{ClipSet, SetRequest, clip_set};
use solaris::gait::{GaitError, RequestError, WalkRequest};
use solaris::model::Figure;
use std::io::Write;
use std::path::PathBuf;

/// What a file holds.
#[derive(Clone, Copy, Debug)]
enum Format {
    Glb,
    Json,
    Bvh,
}

const FILES: Formats<Format> = &[("glb", Format::Glb), ("json", Format::Json)];
const CLIPS: Formats<Format> = &[("bvh", Format::Bvh)];
/// What a folder says of its clips.
const INDEX: &str = "set.json";

/// A set as JSON.
#[derive(Serialize)]
struct Written<'a> {
    version: &'static str,
    figure: &'a str,
    /// Where a clip's axes go.
    axes: &'static str,
    #[serde(flatten)]
    set: &'a ClipSet,
}

pub(super) fn run(args: &SetArgs) -> Result<(), CliError> {
    if let Some((option, typed)) = args.everyone.uneven() {
        let why = "loops have no steps that differ, and fit starts and stops of both feet; leave it out";
        return Err(CliError::option(option, typed, why));
    }
    let (folders, files): (Vec<&PathBuf>, Vec<&PathBuf>) =
        args.outputs.iter().partition(|path| is_folder(path));
    let outputs = Outputs::new(files.into_iter().map(|path| ("-o", path, FILES)))?;
    outputs.keep_off(args.who.figure.as_deref())?;
    if folders.is_empty() {
        animation::check(&args.bones, outputs.paths())?;
    }
    let how = &animation::asked(&args.bones)?;
    let figure = match args.who.figure {
        Some(_) => figure(&args.who)?,
        None => heading_first(&args.who.person)?,
    };
    let speeds: Vec<f64> = args.speeds.iter().map(|speed| speed.value).collect();
    let request = SetRequest {
        walk: dressed(WalkRequest::default(), &args.everyone)?,
        speeds: Some(speeds).filter(|speeds| !speeds.is_empty()),
        rate: args.rate,
        in_place: args.repeats == Some(Loop::InPlace),
    };
    let progress = Progress::new(2);
    progress.stage("planning");
    let set = clip_set(&figure, &request).map_err(|error| refused(error, args))?;
    progress.stage("writing");
    let mut written: Vec<String> = Vec::new();
    for folder in folders {
        make_folder("-o", folder)?;
        let index = folder.join(INDEX);
        let paths: Vec<PathBuf> =
            set.clips.iter().map(|clip| folder.join(format!("{}.bvh", clip.name))).collect();
        let all = paths.iter().map(|path| ("-o", path, CLIPS)).chain([("-o", &index, FILES)]);
        let mut clips = set.clips.iter();
        Outputs::new(all)?.write(|format, writer| match clips.next() {
            Some(clip) => animation::bones(&figure, &clip.motion, clip.repeats, how, writer),
            None => write(format, &figure, &set, how, writer),
        })?;
        written.push(format!("wrote {} clips and {INDEX} into {}", paths.len(), folder.display()));
    }
    outputs.write(|format, writer| write(format, &figure, &set, how, writer))?;
    written.extend(outputs.written());
    drop(progress);
    print(|out| if args.json { write_json(out, &told(&figure, &set)) } else { table(out, &set, &written) })
}

/// Why there is no set, said of the option that asks for it.
fn refused(error: GaitError, args: &SetArgs) -> CliError {
    let of_speeds =
        matches!(error, GaitError::Request(RequestError::Range { .. } | RequestError::StepLength { .. }));
    if of_speeds && !args.speeds.is_empty() {
        let typed: Vec<&str> = args.speeds.iter().map(|speed| speed.typed.as_str()).collect();
        return CliError::option("speeds", typed.join(","), error.to_string());
    }
    CliError::other(error)
}

fn told<'a>(figure: &'a Figure, set: &'a ClipSet) -> Written<'a> {
    let axes = "y up, z forward, x left; m, s";
    Written { version: env!("CARGO_PKG_VERSION"), figure: figure.name(), axes, set }
}

fn write(
    format: Format,
    figure: &Figure,
    set: &ClipSet,
    how: &Bones,
    writer: &mut dyn Write,
) -> Result<(), CliError> {
    match format {
        Format::Json | Format::Bvh => {
            serde_json::to_writer_pretty(&mut *writer, &told(figure, set)).map_err(CliError::other)?;
            writer.write_all(b"\n").map_err(CliError::other)
        }
        Format::Glb => {
            let motions: Vec<_> = set.clips.iter().map(|clip| (clip.name.as_str(), &clip.motion)).collect();
            animation::clips(figure, &motions, how, writer)
        }
    }
}

/// What a person reads.
fn table(out: &mut dyn Write, set: &ClipSet, written: &[String]) -> std::io::Result<()> {
    let rows = set.clips.iter().map(|clip| {
        let speed = clip.speed();
        [
            clip.name.clone(),
            format!("{}", clip.motion.len() - usize::from(clip.repeats)),
            format!("{:.2} s", clip.duration()),
            if speed == 0.0 { String::new() } else { format!("{speed:.2} m/s") },
            if clip.turn == 0.0 { String::new() } else { format!("{:.0}°", clip.turn.to_degrees()) },
            clip.seam.map_or_else(String::new, |seam| format!("{:.2}°", seam.angle.to_degrees())),
        ]
    });
    let head = ["clip", "frames", "lasts", "walks at", "turns by", "seam"].map(str::to_owned);
    writeln!(
        out,
        "{} clips at {} frames/s; all in the walk fit {}",
        set.clips.len(),
        short(set.rate),
        set.usual
    )?;
    writeln!(out)?;
    for [name, frames, lasts, speed, turn, seam] in [head].into_iter().chain(rows) {
        let row = format!("  {name:<20}{frames:>6}  {lasts:>8}  {speed:>9}  {turn:>8}  {seam:>6}");
        writeln!(out, "{}", row.trim_end())?;
    }
    for note in &set.notes {
        writeln!(out, "\nnote: {note}")?;
    }
    if !written.is_empty() {
        writeln!(out)?;
    }
    written.iter().try_for_each(|line| writeln!(out, "{line}"))
}
