//! Measurements, run as `cargo lab CHORE`: what takes minutes, needs all crates, or writes the numbers of a page.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a chore talks to the person who runs it")]

mod bench;
mod contacts;
mod docs;
mod falls;
mod fit;
mod gaits;
mod live;
mod mjcf;
mod models;
mod peers;
mod report;
mod subject;
mod table;
mod timing;
mod workspace;

use std::process::ExitCode;

const HELP: &str = "\
cargo lab CHORE

  bench [--peers] [FIGURE…]         times the kernel, a minute; --peers: beside Pinocchio, MuJoCo and dynibo, which are installed and compiled in
                                    target/peers (python3 with venv, some minutes), and into docs/performance.md
  contacts [--poses N]              what slides, rolls, bounces, stands, is held and falls, by impulses, by springs, by MuJoCo and by Drake, where PYTHON
                                    (python3) has the packages mujoco and drake: into docs/contact.md and docs/trust/contact.svg; some twenty minutes,
                                    most of them for N limp people who are dropped (50)
  docs [--check]                    writes the tables of walks in docs/walking.md and docs/people.md, or says which are out of date
  falls                             drops limp people in fifty poses, and says what became of their energy: about ten minutes
  fit [--measure] [--recipe]        fits the smooth style's numbers to people's bands, prints them and what strides and walks come to;
      [--curves]                    or measures the numbers that ship; --recipe: begins with the recipe's; --curves: people's curves
                                    over a stride are targets too
  gaits [--walks N] [--from M]      walks a million random requests in the thesis's style, or says why not, and 3000 smooth ones over all grounds
                                    and in all manners, each held against the laws: about twenty minutes; --walks: so many smooth ones alone;
                                    --from: beginning with that number of them
  live                              times the frames of a walker that is steered into docs/live.md, and draws docs/strips/live.svg
  models FOLDER [--write]           reads the model files of a folder that other engines open (lab/models/opened.py lists them), prints
                                    why those are refused that are, and writes the counts into docs/bodies.md
  peers --model FILE.txt --states PREFIX [--ms MS] [--rounds N] [--dump FILE.f64] [--dump-fd FILE.f64]
                                    times the kernel as other engines are timed
  report [moments | profiles | simulation | people]
                                    measures digits and times, and writes them into docs/accuracy.md, its picture and docs/operations.md,
                                    moments beside OpenSim's into docs/bodies.md, curves as printed beside the library's into
                                    docs/profiles-accuracy.md and its picture, and simulations of which the answer is known into
                                    docs/trust.md and its pictures, walks beside people into docs/people.md; or one of these four alone
  report chosen                     counts what a tolerance of the run takes beside the cheapest setting of every scene, into docs/trust.md
                                    and docs/trust/chosen.svg
  report published                  solves problems whose answers others have published, into docs/benchmarks.md
  report stepping                   times simulations beside MuJoCo's into docs/trust.md and docs/trust/stepping.svg, where PYTHON (python3) has the
                                    packages mujoco, numpy and scipy, and CC (cc) compiles C
  subject                           writes fixtures/subject: an OpenSim model, its motion and its force plates, from a walk
  help                              this list
";

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    if cfg!(debug_assertions) {
        eprintln!("lab: a debug build is slow, and its times mean nothing; `cargo lab` builds for release");
    }
    let done = match args[..] {
        ["bench", ref options @ ..] => {
            bench::Options::parse(options).and_then(|options| bench::run(&options))
        }
        ["contacts", ref options @ ..] => contacts::Options::parse(options).and_then(contacts::run),
        ["docs", ref options @ ..] => docs::Options::parse(options).and_then(docs::run),
        ["falls"] => falls::run(),
        ["fit", ref options @ ..] => fit::Options::parse(options).and_then(|options| fit::run(&options)),
        ["gaits", ref options @ ..] => {
            gaits::Options::parse(options).and_then(|options| gaits::run(&options))
        }
        ["live"] => live::run(),
        ["models", ref options @ ..] => {
            models::Options::parse(options).and_then(|options| models::run(&options))
        }
        ["peers", ref options @ ..] => {
            peers::Options::parse(options).and_then(|options| peers::run(&options))
        }
        ["report"] => report::run(),
        ["report", "moments"] => report::moments(),
        ["report", "people"] => docs::people(),
        ["report", "profiles"] => report::profiles(),
        ["report", "simulation"] => report::simulation(),
        ["report", "simulation", "adaptive"] => report::adaptive(),
        ["report", "chosen"] => report::chosen(),
        ["report", "published"] => report::published(),
        ["report", "stepping"] => report::stepping(),
        ["subject"] => subject::run(),
        ["help" | "--help" | "-h"] => {
            print!("{HELP}");
            Ok(())
        }
        _ => {
            eprint!("cargo lab: no such chore: {}\n\n{HELP}", args.join(" "));
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
