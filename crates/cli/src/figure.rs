//! `solaris figure`: writes a figure as text.

use crate::args::{BODY_MASS_INDEX, HEIGHT};
use crate::error::CliError;
use crate::input::Size;
use crate::output::{Formats, Outputs};
use crate::print::print;
use clap::ArgMatches;
use solaris::model::{Human, text};
use std::path::PathBuf;

/// A figure's text.
pub(crate) const TEXT: Formats<()> = &[("ron", ())];

pub(crate) fn run(matches: &ArgMatches) -> Result<(), CliError> {
    match matches.subcommand() {
        Some(("human", matches)) => human(matches),
        // clap asks for a subcommand.
        _ => Ok(()),
    }
}

fn human(matches: &ArgMatches) -> Result<(), CliError> {
    let path = matches.get_one::<PathBuf>("output");
    let outputs = Outputs::new(path.map(|path| ("-o", path, TEXT)))?;
    let Size { height, mass, segments } = Size::of(matches);
    let height = height.unwrap_or(HEIGHT);
    let mass = mass.unwrap_or(BODY_MASS_INDEX * height * height);
    let human = segments
        .into_iter()
        .fold(Human::new(height, mass), |human, (name, length)| human.segment_length(name, length));
    let figure = human.build().map_err(|error| CliError::of_human(error, matches))?;
    let text = text::write(&figure);
    outputs.write(|(), writer| writer.write_all(text.as_bytes()).map_err(CliError::other))?;
    let (links, dofs) = (figure.links().len(), figure.layout().nv());
    print(|out| {
        writeln!(out, "A human of {height} m and {mass} kg: {links} links, {dofs} degrees of freedom")?;
        outputs.paths().try_for_each(|path| writeln!(out, "wrote {}", path.display()))
    })
}
