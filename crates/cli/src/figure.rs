//! `solaris figure`: writes a figure as text.

use crate::args::{BODY_MASS_INDEX, FigureCommand, HEIGHT, HumanArgs, Number, SizeArgs};
use crate::error::{CliError, Typed};
use crate::output::{Formats, Outputs};
use crate::print::print;
use crate::words::rounded;
use solaris::model::{Human, text};

/// A figure's text.
pub(crate) const TEXT: Formats<()> = &[("ron", ())];

pub(crate) fn run(command: &FigureCommand) -> Result<(), CliError> {
    match command {
        FigureCommand::Human(args) => human(args),
    }
}

fn human(HumanArgs { size, output }: &HumanArgs) -> Result<(), CliError> {
    let outputs = Outputs::new([("-o", output, TEXT)])?;
    let height = size.height.as_ref().map_or(HEIGHT, |height| height.value);
    let mass = size.mass.as_ref().map_or(BODY_MASS_INDEX * height * height, |mass| mass.value);
    let human = size
        .segments
        .iter()
        .fold(Human::new(height, mass), |human, (name, length)| human.segment_length(name.clone(), *length));
    let figure = human.build().map_err(|error| CliError::of_human(error, size))?;
    let text = text::write(&figure);
    outputs.write(|(), writer| writer.write_all(text.as_bytes()).map_err(CliError::other))?;
    let (links, dofs) = (figure.links().len(), figure.layout().nv());
    print(|out| {
        writeln!(
            out,
            "A human of {} m and {} kg: {links} links, {dofs} degrees of freedom",
            rounded(height),
            rounded(mass)
        )?;
        outputs.written().try_for_each(|line| writeln!(out, "{line}"))
    })
}

impl Typed for SizeArgs {
    fn typed(&self, name: &str) -> Option<&str> {
        let number = if name == "height" { &self.height } else { &self.mass };
        number.as_ref().map(|number| number.typed.as_str())
    }

    fn pace(&self) -> Vec<(&'static str, &Number)> {
        Vec::new()
    }
}
