//! Timing beside other engines: our part in the programs that a driver runs back to back on the same model and states.
//!
//! Prints `RESULT<TAB>tool<TAB>operation<TAB>model<TAB>median ns<TAB>least ns` for each operation. The operations have the
//! names that robotics gives them: `rnea` is inverse dynamics, `aba` forward dynamics, `crba` the mass matrix, `minverse` its inverse,
//! `rnea_derivatives` and `aba_derivatives` the derivatives of the first two by state and input.

mod model;
mod states;

use crate::timing;
use model::Model;
use solaris_dynamics::{
    Derivatives, DynamicsError, Tree, Workspace, forward_dynamics, inverse_dynamics, inverse_mass_matrix,
    mass_matrix,
};
use states::States;
use std::fs;
use std::hint::black_box;
use std::path::{Path, PathBuf};

/// The states that are timed come from the first rows: the driver's other programs stop here too.
const MOST_TIMED: usize = 1024;

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
    /// Where the derivatives of inverse dynamics by `q` and `v` go, row by row.
    dump_derivatives: Option<PathBuf>,
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
                "--dump-derivatives" => options.dump_derivatives = Some(value()?.into()),
                other => {
                    return Err(format!(
                        "peers: unknown option '{other}'; there are --model FILE.txt, --states PREFIX, --ms MS, \
                         --rounds N, --dump FILE.f64, --dump-fd FILE.f64 and --dump-derivatives FILE.f64"
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
    let mut case = Case::new(&model, states).map_err(|error| error.to_string())?;
    if let Some(path) = &options.dump {
        dump(&mut case, path, Case::rnea, |case| case.tau.clone())?;
    }
    if let Some(path) = &options.dump_forward {
        dump(&mut case, path, Case::aba, |case| case.a.clone())?;
    }
    if let Some(path) = &options.dump_derivatives {
        dump(&mut case, path, Case::rnea_derivatives, |case| case.slopes.clone())?;
    }
    case.slopes.clear();
    let operations: [(&str, timing::Operation<Case, DynamicsError>); 6] = [
        ("rnea", Case::rnea),
        ("aba", Case::aba),
        ("crba", Case::crba),
        ("minverse", Case::minverse),
        ("rnea_derivatives", Case::rnea_derivatives),
        ("aba_derivatives", Case::aba_derivatives),
    ];
    let count = case.states.count.min(MOST_TIMED);
    let times = timing::run(&mut case, &operations, count, options.block, options.rounds)
        .map_err(|error| error.to_string())?;
    for ((operation, _), time) in operations.iter().zip(times) {
        println!("RESULT\tsolaris\t{operation}\t{}\t{:.2}\t{:.2}", model.name, time.median, time.least);
    }
    Ok(())
}

/// The result of one operation for every state, one state after another.
fn dump(
    case: &mut Case,
    path: &Path,
    operation: timing::Operation<Case, DynamicsError>,
    result: impl Fn(&Case) -> Vec<f64>,
) -> Result<(), String> {
    let mut rows = Vec::new();
    for state in 0..case.states.count {
        operation(case, state).map_err(|error| format!("state {state}: {error}"))?;
        rows.extend(result(case));
    }
    states::write(path, &rows)
}

/// A model with its states, and room for results.
struct Case {
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    states: States,
    tau: Vec<f64>,
    a: Vec<f64>,
    matrix: nalgebra::DMatrix<f64>,
    derivatives: Derivatives,
    /// The derivatives by `q` and `v`, row by row; empty where nobody asks for them.
    slopes: Vec<f64>,
}

impl Case {
    fn new(model: &Model, states: States) -> Result<Self, DynamicsError> {
        let tree = Tree::new(&model.figure, model.gravity)?;
        let (workspace, nv) = (Workspace::new(&tree), tree.nv());
        let (tau, a) = (vec![0.0; nv], vec![0.0; nv]);
        let derivatives = Derivatives::new(&model.figure, model.gravity)?;
        let matrix = nalgebra::DMatrix::zeros(nv, nv);
        Ok(Self { tree, workspace, states, tau, a, matrix, derivatives, slopes: vec![0.0] })
    }

    fn rnea(&mut self, state: usize) -> Result<(), DynamicsError> {
        let (q, v, a) = (self.states.q(state), self.states.v(state), self.states.a(state));
        inverse_dynamics(&self.tree, &mut self.workspace, black_box(q), v, a, &[], &mut self.tau)?;
        black_box(&mut self.tau);
        Ok(())
    }

    fn aba(&mut self, state: usize) -> Result<(), DynamicsError> {
        let (q, v, tau) = (self.states.q(state), self.states.v(state), self.states.tau(state));
        forward_dynamics(&self.tree, &mut self.workspace, black_box(q), v, tau, &[], &mut self.a)?;
        black_box(&mut self.a);
        Ok(())
    }

    fn crba(&mut self, state: usize) -> Result<(), DynamicsError> {
        mass_matrix(&self.tree, &mut self.workspace, black_box(self.states.q(state)), &mut self.matrix)?;
        black_box(&mut self.matrix);
        Ok(())
    }

    fn minverse(&mut self, state: usize) -> Result<(), DynamicsError> {
        let q = black_box(self.states.q(state));
        inverse_mass_matrix(&self.tree, &mut self.workspace, q, &mut self.matrix)?;
        black_box(&mut self.matrix);
        Ok(())
    }

    fn rnea_derivatives(&mut self, state: usize) -> Result<(), DynamicsError> {
        let (q, v, a) = (self.states.q(state), self.states.v(state), self.states.a(state));
        let partials = black_box(self.derivatives.inverse_dynamics(black_box(q), v, a, &[])?);
        if !self.slopes.is_empty() {
            self.slopes.clear();
            // The columns of the transpose are rows.
            self.slopes.extend(partials.by_q.transpose().iter().chain(partials.by_v.transpose().iter()));
        }
        Ok(())
    }

    fn aba_derivatives(&mut self, state: usize) -> Result<(), DynamicsError> {
        let (q, v, tau) = (self.states.q(state), self.states.v(state), self.states.tau(state));
        black_box(self.derivatives.forward_dynamics(black_box(q), v, tau, &[])?);
        Ok(())
    }
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
            dump_derivatives: None,
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
        peers: unknown option '--fast'; there are --model FILE.txt, --states PREFIX, --ms MS, --rounds N, --dump FILE.f64, --dump-fd FILE.f64 and --dump-derivatives FILE.f64
        ");
    }
}
