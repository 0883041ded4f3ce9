//! The requests about the program itself: `solaris doctor`, `solaris completions`, `solaris man`.

use super::wrap;
use clap::Args;
use clap_complete::Shell;
use std::path::PathBuf;

const DOCTOR_EXAMPLES: &str = "Examples:
  solaris doctor
      the version, what it was built with, and the machine
  solaris doctor robot.urdf
      the same, and what is found of a file without its names and numbers: for a report of a fault";

/// What to look at.
#[derive(Debug, Args)]
#[command(
    about = "What a report of a fault should say: the program, the machine, and files without what stands in them",
    after_help = DOCTOR_EXAMPLES
)]
pub(crate) struct DoctorArgs {
    #[arg(value_name = "FILE", help = wrap(
        "Figures, scenes and recordings of markers, as `solaris check` takes them; of each is told what it is, how large, and what \
         is found, never a name, a number or a text of it"
    ))]
    pub(crate) files: Vec<PathBuf>,
    #[arg(long, help = "Print it as JSON instead of text")]
    pub(crate) json: bool,
}

const COMPLETIONS_EXAMPLES: &str = "Examples:
  solaris completions bash > ~/.local/share/bash-completion/completions/solaris
  solaris completions zsh > ~/.zfunc/_solaris
      a folder of $fpath
  solaris completions fish > ~/.config/fish/completions/solaris.fish
  solaris completions powershell >> $PROFILE";

/// Whose completions.
#[derive(Debug, Args)]
#[command(about = "What a shell needs to complete commands and options", after_help = COMPLETIONS_EXAMPLES)]
pub(crate) struct CompletionsArgs {
    #[arg(value_name = "SHELL", value_enum, help = "Which shell")]
    pub(crate) shell: Shell,
}

const MAN_EXAMPLES: &str = "Examples:
  solaris man walk | man -l -
      the manual of one command, read at once
  solaris man -o ~/.local/share/man/man1/
      the manuals of all commands, as files for `man solaris-walk`";

/// Whose manual.
#[derive(Debug, Args)]
#[command(about = "The manual as pages for man", after_help = MAN_EXAMPLES)]
pub(crate) struct ManArgs {
    #[arg(
        value_name = "COMMAND",
        conflicts_with = "output",
        help = "The command, such as: walk, profile blend [default: the program]"
    )]
    pub(crate) command: Vec<String>,
    #[arg(
        short = 'o',
        long = "output",
        value_name = "FOLDER",
        help = "Write the pages of all commands into a folder"
    )]
    pub(crate) output: Option<PathBuf>,
}
