//! Which files belong to which motion, where there may be many.

use super::rows::RowsFormat;
use super::trial::Trial;
use crate::args::InverseArgs;
use crate::error::CliError;
use crate::given::in_order;
use crate::ground::outputs;
use crate::input::extension;
use crate::output::{Formats, Outputs, is_folder, make_folder};
use std::path::{Path, PathBuf};

/// What stands for a motion's name in a path.
const NAME: &str = "{}";

/// The summary of many motions, a row each.
const TABLE: Formats<RowsFormat> = &[
    ("csv", RowsFormat::Csv),
    #[cfg(feature = "parquet")]
    ("parquet", RowsFormat::Parquet),
];

/// The motions of a command.
pub(super) enum Plan {
    One(Trial),
    Many(Many),
}

/// Many motions.
pub(super) struct Many {
    pub(super) trials: Vec<Trial>,
    /// Tables with a row for each.
    pub(super) tables: Outputs<RowsFormat>,
}

impl Plan {
    /// Sorts the files, and refuses those that cannot be.
    pub(super) fn of(args: &InverseArgs) -> Result<Self, CliError> {
        for motion in args.motions() {
            in_order("inverse", &args.figure, motion)?;
        }
        let is_many = args.motions().len() > 1 || args.outputs.iter().any(|path| is_folder(path));
        let (mut each, mut tables): (Vec<&PathBuf>, Vec<&PathBuf>) = (Vec::new(), Vec::new());
        for path in &args.outputs {
            let is_for_each = !is_many || is_folder(path) || is_named(path);
            if is_for_each { &mut each } else { &mut tables }.push(path);
        }
        if is_many {
            check_many(args, &tables)?;
        }
        for folder in args.outputs.iter().filter(|path| is_folder(path)) {
            make_folder("-o", folder)?;
        }
        let trials = args.motions().into_iter().map(|motion| trial(args, motion, &each));
        let mut trials = trials.collect::<Result<Vec<Trial>, CliError>>()?;
        if !is_many && let Some(trial) = trials.pop() {
            return Ok(Self::One(trial));
        }
        let tables = Outputs::new(tables.into_iter().map(|path| ("-o", path, TABLE)))?;
        tables.keep_off(trials.iter().flat_map(|trial| trial.inputs(args)))?;
        tables.keep_off(trials.iter().flat_map(|trial| trial.outputs.paths()))?;
        Ok(Self::Many(Many { trials, tables }))
    }
}

/// Refuses files that belong to one motion and are to serve many, and motions of the same name.
fn check_many(args: &InverseArgs, tables: &[&PathBuf]) -> Result<(), CliError> {
    let count = args.motions().len();
    let refuse = |option: &'static str, path: &Path, example: &str| {
        let why = format!(
            "there are {count} motions and this is one file; let {NAME} stand for each one's name, such as {example}"
        );
        Err(CliError::Output { option, path: path.to_owned(), why })
    };
    let is_table = |path: &Path| TABLE.iter().any(|(known, _)| *known == extension(path));
    if let Some(table) = tables.iter().find(|table| !is_table(table)) {
        let of = if extension(table).is_empty() { "sto".to_owned() } else { extension(table) };
        return refuse("-o", table, &format!("out/{NAME}.{of}; one table with a row for each is .csv"));
    }
    if count > 1 {
        let external = &args.external;
        let one = |path: &Option<PathBuf>| path.clone().filter(|path| !is_named(path));
        if let Some(path) = one(&external.forces) {
            return refuse("--external", &path, &format!("grf/{NAME}.mot"));
        }
        if let Some(path) = one(&external.loads) {
            return refuse("--external-loads", &path, &format!("loads/{NAME}.xml"));
        }
        for (option, paths, example) in [
            ("--motion-out", &args.predicted.consistent.motions, "moved/{}.csv"),
            ("--cycles-out", &args.cycles.outputs, "out/{}_stride.csv"),
        ] {
            if let Some(path) = paths.iter().find(|path| !is_named(path)) {
                return refuse(option, path, example);
            }
        }
    }
    for (i, motion) in args.motions().into_iter().enumerate() {
        if let Some(other) = args.motions()[..i].iter().find(|other| stem(other) == stem(motion)) {
            let why = format!(
                "{} has the same name, and files are called by it; rename one, or take them one after the other",
                other.display()
            );
            return Err(CliError::input(motion, &why));
        }
    }
    Ok(())
}

/// The files of one motion.
fn trial(args: &InverseArgs, motion: &Path, each: &[&PathBuf]) -> Result<Trial, CliError> {
    let own = |path: &PathBuf| named(path, motion);
    let forces: Vec<PathBuf> = each
        .iter()
        .map(|path| match (is_folder(path), extension(motion).as_str()) {
            (false, _) => own(path),
            (true, "csv" | "bvh") => path.join(format!("{}.csv", stem(motion))),
            (true, _) => path.join(format!("{}.sto", stem(motion))),
        })
        .collect();
    let all = |paths: &[PathBuf]| paths.iter().map(own).collect::<Vec<PathBuf>>();
    let trial = Trial {
        motion: motion.to_owned(),
        forces: args.external.forces.as_ref().map(own),
        loads: args.external.loads.as_ref().map(own),
        outputs: outputs(&forces, &all(&args.predicted.consistent.motions), &all(&args.cycles.outputs))?,
    };
    trial.outputs.keep_off(trial.inputs(args))?;
    Ok(trial)
}

impl Trial {
    /// All that is read for it.
    fn inputs<'a>(&'a self, args: &'a InverseArgs) -> impl Iterator<Item = &'a Path> {
        let others = [&self.forces, &self.loads, &args.predicted.how.soles];
        let others = others.into_iter().flatten().map(PathBuf::as_path);
        [args.figure.as_path(), self.motion.as_path()].into_iter().chain(others)
    }
}

/// Whether a motion's name stands in it.
fn is_named(path: &Path) -> bool {
    path.to_string_lossy().contains(NAME)
}

/// The path with the motion's name in it.
fn named(path: &Path, motion: &Path) -> PathBuf {
    if is_named(path) { path.to_string_lossy().replace(NAME, &stem(motion)).into() } else { path.to_owned() }
}

fn stem(motion: &Path) -> String {
    motion.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned())
}
