//! `solaris walk`: a person walks.

mod everyone;
mod notes;
pub(crate) mod numbers;
mod planned;
mod report;
mod request;
mod summary;
mod told;

use crate::args::{BODY_MASS_INDEX, HEIGHT, PersonArgs, WalkArgs, WhoArgs};
use crate::error::CliError;
use crate::input;
use crate::limbs;
use crate::planned_files::{PlannedFiles, Shown};
use crate::print::print;
use crate::progress::Progress;
pub(crate) use everyone::dressed;
use planned::Planned;
use report::Report;
pub(crate) use request::asked;
use solaris::gait::{isolated_peaks, measure, missing_for_walking};
use solaris::model::{Figure, Human, RootOrder};

/// Plans the walk, finds its forces, writes it, and says what it came to.
pub(crate) fn run(args: &WalkArgs) -> Result<(), CliError> {
    let files = PlannedFiles::new(&args.files, args.who.figure.as_deref())?;
    let asked = asked(args)?;
    let mut figure = figure(&args.who)?;
    let asked = asked.of(&figure, args);

    let progress = Progress::new(4);
    let (planned, motion) = Planned::of(&mut figure, &asked, args, &progress)?;
    progress.stage("measuring");
    let measures = measure(&figure, &motion).map_err(CliError::other)?;
    let lone = isolated_peaks(&motion).map_err(CliError::other)?;
    let limbs = limbs::nearest(&figure, &motion, &[])?;
    let carried = args.who.person.loads.iter().map(|(_, load)| load).sum();
    let report = Report::new((&figure, carried), planned, &motion, measures, &lone, limbs);
    progress.stage("writing");
    let shown = Shown {
        name: "walk",
        title: summary::title(&report),
        rows: summary::page_rows(&report),
        repeats: report.walk.repeats,
        report: &|writer| report.write(writer),
    };
    files.write(&figure, &motion, &shown)?;
    drop(progress);

    if args.files.json {
        print(|out| report.write(out))
    } else {
        print(|out| out.write_all(summary::table(&report, files.written()).as_bytes()))
    }
}

/// Who walks: the figure of a file that has all that a walk needs, or a human.
pub(crate) fn figure(who: &WhoArgs) -> Result<Figure, CliError> {
    if let Some(path) = &who.figure {
        let figure = input::body(path)?.figure;
        let missing = missing_for_walking(&figure);
        return if missing.is_empty() {
            Ok(figure)
        } else {
            let list = missing.iter().map(|lack| format!("\n  - {lack}")).collect::<Vec<_>>().concat();
            Err(CliError::input(path, &format!("figure '{}' cannot walk:{list}", figure.name())))
        };
    }
    person(&who.person)
}

/// A human of the height and mass that are asked for, or of the usual ones.
pub(crate) fn person(person: &PersonArgs) -> Result<Figure, CliError> {
    person_with(person, RootOrder::Zyx)
}

/// The same whose root turns by its heading first.
pub(crate) fn heading_first(person: &PersonArgs) -> Result<Figure, CliError> {
    person_with(person, RootOrder::Yzx)
}

fn person_with(person: &PersonArgs, root: RootOrder) -> Result<Figure, CliError> {
    let height = person.height.as_ref().map_or(HEIGHT, |height| height.value);
    let mass = person.mass.as_ref().map_or(BODY_MASS_INDEX * height * height, |mass| mass.value);
    let human = Human::new(height, mass).root(root);
    let human = match &person.age {
        Some(age) => human.age(age.value),
        None => human,
    };
    let human = person.loads.iter().fold(human, |human, (side, load)| human.load(side.clone(), *load));
    let human = person.shorter.iter().fold(human, |human, (leg, by)| human.shorter_leg(leg.clone(), *by));
    let human = match person.cane {
        Some(hand) => human.cane(hand.name()),
        None => human,
    };
    human.build().map_err(|error| CliError::of_human(error, person))
}
