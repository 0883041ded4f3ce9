//! `solaris profile list`: the kinds of curves.

use crate::args::{ListArgs, amplitude, example, option};
use crate::error::CliError;
use crate::print::{print, write_json};
use serde::Serialize;
use solaris::profiles::{Kind, Profile};
use std::io::Write;

/// Width of the columns before the summaries.
const COLUMNS: (usize, usize) = (28, 15);

#[derive(Serialize)]
struct Said {
    name: &'static str,
    variant: &'static str,
    family: String,
    summary: &'static str,
    keys: bool,
    parameters: Vec<Parameter>,
    /// The parameter that `--to` may stand for.
    reaches_by: Option<&'static str>,
    example: String,
}

#[derive(Serialize)]
struct Parameter {
    name: &'static str,
    symbol: &'static str,
    option: String,
    unit: String,
    range: String,
    required: bool,
    summary: &'static str,
}

impl Said {
    fn of(kind: &'static Kind) -> Self {
        let parameters = kind.parameters().map(|parameter| Parameter {
            name: parameter.name,
            symbol: parameter.symbol,
            option: format!("--{}", option(parameter)),
            unit: parameter.measure.to_string(),
            range: parameter.range.to_string(),
            required: kind.required.contains(&parameter),
            summary: parameter.summary,
        });
        Self {
            name: kind.name,
            variant: kind.variant,
            family: kind.family.to_string(),
            summary: kind.summary,
            keys: kind.has_keys(),
            parameters: parameters.collect(),
            reaches_by: amplitude(kind).map(|parameter| parameter.name),
            example: format!("solaris profile {}", example(kind)),
        }
    }
}

pub(super) fn run(args: &ListArgs) -> Result<(), CliError> {
    print(|out| {
        if args.json {
            let kinds: Vec<Said> = Profile::KINDS.iter().map(Said::of).collect();
            return write_json(out, &kinds);
        }
        text(out)
    })
}

fn text(out: &mut dyn Write) -> std::io::Result<()> {
    let (names, families) = COLUMNS;
    for kind in Profile::KINDS {
        writeln!(out, "{:<names$}{:<families$}{}", kind.name, kind.family.to_string(), kind.summary)?;
    }
    writeln!(
        out,
        "\nsolaris profile KIND --help has the parameters of a kind, with units and ranges\n\
         solaris profile blend --help mixes two; solaris profile read --help takes any from a text"
    )
}

#[cfg(test)]
mod tests {
    use super::super::request::Request;
    use super::*;
    use crate::args::{Cli, Command, KindCommand, ProfileCommand};
    use clap::Parser;

    #[test]
    fn the_example_of_each_kind_works() {
        assert!(Profile::KINDS.len() >= 24);
        for kind in Profile::KINDS {
            let line = format!("solaris profile {}", example(kind).replace('\'', "").replace(", ", ","));
            let cli = Cli::try_parse_from(line.split(' ')).expect(&line);
            let Command::Profile(command) = cli.command else { panic!("{line}") };
            let ProfileCommand::Kind(KindCommand(args)) = *command else { panic!("{line}") };
            Request::of_kind(&args).and_then(|request| request.curve()).expect(&line);
        }
    }

    #[test]
    fn amplitudes_are_what_follows_from_an_end() {
        for kind in Profile::KINDS {
            let profile = kind.profile(|_| Some(1.0), vec![(0.0, 0.0), (1.0, 1.0)]).expect(kind.name);
            let before = profile.values();
            let changed = profile.reach(3.0).ok().map(|after| {
                let after = after.values();
                let mut differ = before.iter().zip(&after).filter(|(a, b)| (a.1 - b.1).abs() > 1e-9);
                differ.next().map(|(parameter, _)| parameter.0.name)
            });
            assert_eq!(changed, amplitude(kind).map(|parameter| Some(parameter.name)), "{}", kind.name);
        }
    }
}
