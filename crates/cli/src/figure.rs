//! `solaris figure`: writes a figure as text.

use crate::args::{BODY_MASS_INDEX, FigureCommand, HEIGHT, HumanArgs, Number};
use crate::error::{CliError, Typed};
use crate::output::{Formats, Outputs};
use crate::print::print;
use crate::words::rounded;
use solaris::model::{Human, RootOrder, text};

/// A figure's text.
pub(crate) const TEXT: Formats<()> = &[("ron", ())];

pub(crate) fn run(command: &FigureCommand) -> Result<(), CliError> {
    match command {
        FigureCommand::Human(args) => human(args),
    }
}

fn human(args: &HumanArgs) -> Result<(), CliError> {
    let HumanArgs { size, age, loads, shorter, cane, heading_first, output } = args;
    let outputs = Outputs::new([("-o", output, TEXT)])?;
    let height = size.height.as_ref().map_or(HEIGHT, |height| height.value);
    let mass = size.mass.as_ref().map_or(BODY_MASS_INDEX * height * height, |mass| mass.value);
    let root = if *heading_first { RootOrder::Yzx } else { RootOrder::Zyx };
    let person = Human::new(height, mass).root(root);
    let person = match age {
        Some(age) => person.age(age.value),
        None => person,
    };
    let human = size
        .segments
        .iter()
        .fold(person, |human, (name, length)| human.segment_length(name.clone(), *length));
    let human = loads.iter().fold(human, |human, (side, load)| human.load(side.clone(), *load));
    let human = shorter.iter().fold(human, |human, (leg, by)| human.shorter_leg(leg.clone(), *by));
    let human = match cane {
        Some(hand) => human.cane(hand.name()),
        None => human,
    };
    let figure = human.build().map_err(|error| CliError::of_human(error, args))?;
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

impl Typed for HumanArgs {
    fn typed(&self, name: &str) -> Option<&str> {
        let number = match name {
            "height" => &self.size.height,
            "age" => &self.age,
            _ => &self.size.mass,
        };
        number.as_ref().map(|number| number.typed.as_str())
    }

    fn pace(&self) -> Vec<(&'static str, &Number)> {
        Vec::new()
    }
}
