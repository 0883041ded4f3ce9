//! `solaris completions` and `solaris man`: made of the same description of the command line that reads it.

use crate::args::{Cli, CompletionsArgs, ManArgs};
use crate::error::{CliError, UsageError};
use crate::output::make_folder;
use crate::print::print;
use clap::{Command, CommandFactory};
use clap_mangen::Man;
use std::fs;

/// Prints what a shell reads.
pub(crate) fn completions(args: &CompletionsArgs) -> Result<(), CliError> {
    // Into memory first: the generator does not say when its output is closed.
    let mut text = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "solaris", &mut text);
    print(|out| out.write_all(&text))
}

/// Prints the page of one command, or writes those of all.
pub(crate) fn man(args: &ManArgs) -> Result<(), CliError> {
    let mut program = Cli::command();
    program.build();
    if let Some(folder) = &args.output {
        make_folder("-o", folder)?;
        let mut count = 0;
        each(&program, &mut |command| {
            let path = folder.join(format!("{}.1", name(command)));
            let refuse = |error: &std::io::Error| CliError::Output {
                option: "-o",
                path: path.clone(),
                why: error.to_string(),
            };
            let text = page(command).map_err(|error| refuse(&error))?;
            fs::write(&path, text).map_err(|error| refuse(&error))?;
            count += 1;
            Ok(())
        })?;
        return print(|out| writeln!(out, "wrote {count} pages into {}", folder.display()));
    }
    let mut command = &program;
    for word in &args.command {
        command = command.find_subcommand(word).ok_or_else(|| UsageError::NoSuchCommand {
            word: word.clone(),
            of: name(command).replace('-', " "),
        })?;
    }
    let text = page(command).map_err(CliError::Stdout)?;
    print(|out| out.write_all(&text))
}

/// Asks `visit` about a command and all below it that have pages of their own.
fn each(command: &Command, visit: &mut impl FnMut(&Command) -> Result<(), CliError>) -> Result<(), CliError> {
    visit(command)?;
    let inner = command.get_subcommands();
    inner
        .filter(|inner| inner.get_name() != "help" && !inner.is_hide_set())
        .try_for_each(|inner| each(inner, visit))
}

/// The page's name: `solaris-profile-blend`.
fn name(command: &Command) -> String {
    command.get_display_name().unwrap_or(command.get_name()).to_owned()
}

/// What examples begin with in a help text.
const EXAMPLES: [&str; 2] = ["Example:\n", "Examples:\n"];

/// A page. Examples stand under a heading of their own, their lines as they are: broken ones cannot be typed.
fn page(command: &Command) -> std::io::Result<Vec<u8>> {
    let after = command.get_after_help().map(ToString::to_string).unwrap_or_default();
    let examples = EXAMPLES.iter().find_map(|heading| after.strip_prefix(heading));
    let mut command = command.clone();
    if examples.is_some() {
        command = command.after_help("");
    }
    let version = concat!("solaris ", env!("CARGO_PKG_VERSION"));
    let mut text = Vec::new();
    Man::new(command.clone()).title(name(&command)).manual("Solaris").source(version).render(&mut text)?;
    for line in examples
        .iter()
        .flat_map(|examples| [".SH EXAMPLES", ".nf"].into_iter().chain(examples.lines()).chain([".fi"]))
    {
        let line = if line.starts_with(' ') { as_it_is(line) } else { line.to_owned() };
        text.extend_from_slice(line.as_bytes());
        text.push(b'\n');
    }
    Ok(text)
}

/// A line of text in which nothing commands the one who sets it.
fn as_it_is(line: &str) -> String {
    let plain = line.replace('\\', "\\e").replace('-', "\\-").replace('\'', "\\(aq");
    format!("\\&{plain}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_command_has_a_page_with_its_examples_as_they_are_typed() {
        let mut program = Cli::command();
        program.build();
        let mut names = Vec::new();
        each(&program, &mut |command| {
            let text =
                String::from_utf8(page(command).map_err(CliError::Stdout)?).map_err(CliError::other)?;
            assert!(text.contains(".SH SYNOPSIS") && !text.contains(".SH EXTRA\nExample"), "{text}");
            names.push(name(command));
            Ok(())
        })
        .expect("pages");
        assert!(names.contains(&"solaris-profile-blend".to_owned()), "{names:?}");
        assert!(!names.iter().any(|name| name.contains("help")), "{names:?}");
        let walk = page(program.find_subcommand("walk").expect("a command")).expect("a page");
        let walk = String::from_utf8(walk).expect("text");
        assert!(walk.contains("\n\\&  solaris walk \\-o walk.html\n"), "{walk}");
    }
}
