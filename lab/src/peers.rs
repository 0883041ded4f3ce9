//! Timing beside other engines: our part in the programs that a driver runs back to back on the same model and states.
//!
//! Prints `RESULT<TAB>tool<TAB>operation<TAB>model<TAB>median ns<TAB>least ns` for each operation. The operations have the
//! names that robotics gives them: `rnea` is inverse dynamics, `aba` forward dynamics, `crba` the mass matrix, `minverse` its inverse,
//! `rnea_derivatives` and `aba_derivatives` the derivatives of the first two by state and input. `cargo lab bench --peers` is a driver.

pub(crate) mod model;
pub(crate) mod states;

use crate::bench::Case;
use crate::timing;
use states::States;
use std::fs;
use std::path::{Path, PathBuf};

/// What `cargo lab peers` was asked.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Options {
    model: PathBuf,
    /// What the names of the files of states begin with.
    states: PathBuf,
    /// Length of one timed block (ms).
    block: f64,
    rounds: usize,
    dump: Option<PathBuf>,
    dump_forward: Option<PathBuf>,
}

impl Options {
    pub(crate) fn parse(args: &[&str]) -> Result<Self, String> {
        let mut options = Self { block: 4.0, rounds: 15, ..Self::default() };
        let mut args = args.iter();
        while let Some(arg) = args.next() {
            let mut value = || args.next().copied().ok_or_else(|| format!("peers: {arg} needs a value"));
            match *arg {
                "--model" => options.model = value()?.into(),
                "--states" => options.states = value()?.into(),
                "--ms" => options.block = positive(arg, value()?)?,
                "--rounds" => options.rounds = positive(arg, value()?)?,
                "--dump" => options.dump = Some(value()?.into()),
                "--dump-fd" => options.dump_forward = Some(value()?.into()),
                other => {
                    return Err(format!(
                        "peers: unknown option '{other}'; there are --model FILE.txt, --states PREFIX, --ms MS, \
                         --rounds N, --dump FILE.f64 and --dump-fd FILE.f64"
                    ));
                }
            }
        }
        for (name, path) in [("--model FILE.txt", &options.model), ("--states PREFIX", &options.states)] {
            if path.as_os_str().is_empty() {
                return Err(format!("peers: {name} is missing"));
            }
        }
        Ok(options)
    }
}

/// A number above zero.
fn positive<T: std::str::FromStr + PartialOrd + Default>(option: &str, text: &str) -> Result<T, String> {
    let number = text.parse().ok().filter(|number| *number > T::default());
    number.ok_or_else(|| format!("peers: {option} is '{text}'; it must be a number above zero"))
}

/// Writes what was asked for and prints the times.
pub(crate) fn run(options: &Options) -> Result<(), String> {
    let path = &options.model;
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let model = model::parse(&text).map_err(|error| format!("{}: {error}", path.display()))?;
    let states = States::read(&options.states, model.figure.layout())?;
    let mut case = Case::new(&model.figure, model.gravity, states).map_err(|error| error.to_string())?;
    if let Some(path) = &options.dump {
        dump(&mut case, path, Case::rnea, |case| &case.tau)?;
    }
    if let Some(path) = &options.dump_forward {
        dump(&mut case, path, Case::aba, |case| &case.a)?;
    }
    for (operation, time) in case.time(options.block, options.rounds)? {
        println!("RESULT\tsolaris\t{operation}\t{}\t{:.2}\t{:.2}", model.name, time.median, time.least);
    }
    Ok(())
}

/// The result of one operation for every state, one state after another.
fn dump(
    case: &mut Case,
    path: &Path,
    operation: timing::Operation<Case, String>,
    result: impl Fn(&Case) -> &[f64],
) -> Result<(), String> {
    let mut rows = Vec::new();
    for state in 0..case.states.count {
        operation(case, state).map_err(|error| format!("state {state}: {error}"))?;
        rows.extend_from_slice(result(case));
    }
    states::write(path, &rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_read() {
        let args =
            ["--model", "m.txt", "--states", "s/m", "--ms", "2.5", "--rounds", "3", "--dump", "tau.f64"];
        let options = Options::parse(&args).expect("well-formed");
        let expected = Options {
            model: "m.txt".into(),
            states: "s/m".into(),
            block: 2.5,
            rounds: 3,
            dump: Some("tau.f64".into()),
            dump_forward: None,
        };
        assert_eq!(options, expected);
    }

    #[test]
    fn mistakes_in_options_are_answered() {
        let parse = |args: &[&str]| Options::parse(args).expect_err("a mistake");
        let answers = [
            parse(&["--states", "s"]),
            parse(&["--model", "m.txt"]),
            parse(&["--model"]),
            parse(&["--ms", "-1"]),
            parse(&["--rounds", "0"]),
            parse(&["--fast"]),
        ];
        insta::assert_snapshot!(answers.join("\n"), @r"
        peers: --model FILE.txt is missing
        peers: --states PREFIX is missing
        peers: --model needs a value
        peers: --ms is '-1'; it must be a number above zero
        peers: --rounds is '0'; it must be a number above zero
        peers: unknown option '--fast'; there are --model FILE.txt, --states PREFIX, --ms MS, --rounds N, --dump FILE.f64 and --dump-fd FILE.f64
        ");
    }
}
