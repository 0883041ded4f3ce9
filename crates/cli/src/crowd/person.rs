//! One person of a crowd: from a row to a motion.

use super::table::People;
use crate::animation::{self, BodyFormat, Bones, Person};
use crate::args::{CrowdArgs, CrowdFormat, Number, PLACES, WalkArgs, parse, walk_options};
use crate::error::CliError;
use crate::walk::{asked, figure, heading_first};
use clap::Command;
use solaris::analysis::ground_reactions;
use solaris::gait::crowd::{Somebody, seed_of};
use solaris::gait::{FEET, GaitError, StyledRequest, walk_in_part};
use solaris::io::csv::number_text;
use solaris::model::Vector3;

/// How far to the left or right a person may face (degrees).
const HEADING: f64 = 360.0;
/// The farthest place (m).
const FARTHEST: f64 = 1e4;

/// The people of a crowd and how they are walked.
pub(super) struct Crowd<'a> {
    people: &'a People,
    args: &'a CrowdArgs,
    bones: &'a Bones,
    options: Command,
}

/// Somebody who walks.
pub(super) struct Walked {
    name: String,
    pub(super) file: String,
    /// How much of manner and variability holds.
    pub(super) part: f64,
    /// Height, mass, step frequency, step length, x, z, heading, duration.
    numbers: [f64; 8],
}

impl Walked {
    pub(super) const HEADINGS: [&'static str; 12] = [
        "name",
        "file",
        "height_m",
        "mass_kg",
        "step_frequency_per_min",
        "step_length_m",
        "x_m",
        "z_m",
        "heading_deg",
        "duration_s",
        "part",
        "refusal",
    ];

    pub(super) fn fields(&self) -> Vec<String> {
        let numbers = self.numbers.iter().copied().chain([self.part]).map(number_text);
        [self.name.clone(), self.file.clone()].into_iter().chain(numbers).chain([String::new()]).collect()
    }

    pub(super) fn refused(name: String, why: String) -> Vec<String> {
        let mut fields = vec![String::new(); Self::HEADINGS.len()];
        fields[0] = name;
        fields[Self::HEADINGS.len() - 1] = why;
        fields
    }
}

impl<'a> Crowd<'a> {
    pub(super) fn new(people: &'a People, args: &'a CrowdArgs, bones: &'a Bones) -> Self {
        Self { people, args, bones, options: walk_options() }
    }

    pub(super) fn name(&self, number: usize) -> String {
        self.field(number, "name").map_or_else(|| self.people.files[number].clone(), str::to_owned)
    }

    fn field(&self, number: usize, column: &str) -> Option<&str> {
        let at = self.people.columns.iter().position(|name| name == column)?;
        self.people.rows[number].fields.get(at).map(String::as_str).filter(|field| !field.is_empty())
    }

    /// What becomes of a row: somebody's motion, or why there is none, with line and column.
    pub(super) fn walk(&self, number: usize) -> Result<(Walked, Person), String> {
        let row = &self.people.rows[number];
        let (found, expected) = (row.fields.len(), self.people.columns.len());
        let line =
            if self.people.written { format!("line {}", row.line) } else { format!("person {}", number + 1) };
        if found != expected {
            return Err(format!("{line}: it has {found} fields, the header has {expected}"));
        }
        self.walked(number).map_err(|(column, why)| {
            let why = why.split_whitespace().collect::<Vec<_>>().join(" ");
            let is_same = |name: &str, column: &str| {
                name == column || (name == "cadence" && column == "step-frequency")
            };
            let at =
                column.and_then(|column| self.people.columns.iter().position(|name| is_same(name, &column)));
            at.map_or_else(|| format!("{line}: {why}"), |at| format!("{line}, column {}: {why}", at + 1))
        })
    }

    /// A number of a column that is no option of a walk.
    fn place(&self, number: usize, column: &'static str, most: f64) -> Result<f64, (Option<String>, String)> {
        let Some(field) = self.field(number, column) else { return Ok(0.0) };
        let fault = |why: String| (Some(column.to_owned()), format!("{column} {field}: {why}"));
        let value = field.parse::<Number>().map_err(|why| fault(why.to_string()))?.value;
        if (-most..=most).contains(&value) {
            return Ok(value);
        }
        Err(fault(format!("it must be {} to {most}", -most)))
    }

    fn walked(&self, number: usize) -> Result<(Walked, Person), (Option<String>, String)> {
        let [x, z] = ["x", "z"].map(|column| self.place(number, column, FARTHEST));
        let (x, z, heading) = (x?, z?, self.place(number, "heading", HEADING)?);
        let seed = seed_of(self.args.seed, number as u64);
        let columns = self.people.columns.iter().filter(|column| !PLACES.contains(&column.as_str()));
        // A seed alone is whose differences; how much they are is drawn with the rest.
        let given: Vec<(&String, &str)> =
            columns.filter_map(|column| Some((column, self.field(number, column)?))).collect();
        let has = |names: &[&str]| given.iter().any(|(column, _)| names.contains(&column.as_str()));
        let mut words: Vec<String> =
            given.iter().map(|(column, field)| format!("--{column}={field}")).collect();
        if has(&["seed"]) && !has(&["variability"]) {
            words.push("--variability=1".to_owned());
        }
        let args: WalkArgs = parse(&self.options, words.clone()).map_err(of_clap)?;
        let own = args.everyone.seed.unwrap_or(seed);
        let age = args.who.person.age.as_ref().map(|age| age.value).filter(|age| age.is_finite());
        let mut somebody = Somebody::drawn(own, age);
        if let Some(who) = args.everyone.population {
            somebody.population = who.into();
        }
        // Who is drawn takes the options' way, so that all is checked alike.
        let mut drawn = Vec::new();
        if !has(&["figure"]) {
            let height = args.who.person.height.as_ref().map(|height| height.value);
            if height.is_none() {
                drawn.push(format!("--height={}", somebody.height));
            }
            if !has(&["mass"]) {
                let index = somebody.mass / somebody.height.powi(2);
                let height = height.unwrap_or(somebody.height);
                drawn.push(format!("--mass={}", index * height * height));
            }
        }
        words.extend(drawn);
        let args: WalkArgs = parse(&self.options, words).map_err(of_clap)?;
        let walked = || -> Result<_, CliError> {
            let asked = asked(&args)?;
            // People of a crowd face any way.
            let figure = match args.who.figure {
                Some(_) => figure(&args.who)?,
                None => heading_first(&args.who.person)?,
            };
            let asked = asked.of(&figure, &args);
            let StyledRequest::Smooth(request) = &asked.request else {
                return Err(CliError::option(
                    "style",
                    "thesis",
                    "a crowd walks smoothly; leave out the column",
                ));
            };
            let request = somebody.dress(request);
            let refuse = |error: GaitError| asked.refuse(error, &args);
            let (plan, part) = walk_in_part(&figure, &request).map_err(refuse)?;
            let place = Vector3::new(x, 0.0, z);
            let plan = plan.moved(place, heading.to_radians()).map_err(|error| {
                let place = format!("({x}, {z}) m, heading {heading}");
                CliError::option("heading", place, error.to_string())
            })?;
            let mut motion = plan.motion(&figure, self.args.rate).map_err(CliError::other)?;
            if self.format() == CrowdFormat::Csv || self.bones.arrows {
                ground_reactions(&figure, &mut motion, FEET, &plan).map_err(CliError::other)?;
            }
            let style = plan.style();
            let (height, frequency, length) = (plan.stature(), style.step_frequency, style.step_length);
            let duration = motion.time()[motion.len() - 1];
            let numbers = [height, figure.mass(), frequency, length, x, z, heading, duration];
            Ok((part, numbers, figure, motion))
        };
        let (part, numbers, figure, motion) = walked().map_err(|error| of_cli(&error))?;
        let file = format!("{}.{}", self.people.files[number], self.format().extension());
        let name = self.name(number);
        Ok((Walked { name: name.clone(), file, part, numbers }, Person { name, figure, motion }))
    }

    fn format(&self) -> CrowdFormat {
        self.args.format.unwrap_or_default()
    }

    /// Somebody's motion as a file's bytes.
    pub(super) fn bytes(&self, person: &Person) -> Result<Vec<u8>, CliError> {
        let Person { figure, motion, .. } = person;
        let mut bytes = Vec::new();
        match self.format() {
            CrowdFormat::Csv => {
                solaris::io::csv::write(figure, motion, &mut bytes).map_err(CliError::other)?;
            }
            CrowdFormat::Glb => {
                animation::body(BodyFormat::Glb, figure, motion, "walk", self.bones, &mut bytes)?;
            }
            CrowdFormat::Bvh => animation::bones(figure, motion, false, self.bones, &mut bytes)?,
        }
        Ok(bytes)
    }
}

/// What is wrong, and the column that it is about.
fn of_cli(error: &CliError) -> (Option<String>, String) {
    let column = match error {
        CliError::Option { option, .. } => Some(option.clone()),
        _ => None,
    };
    (column, error.to_string())
}

/// The same of what cannot be read, without the usage of a command that nobody typed.
fn of_clap(error: clap::Error) -> (Option<String>, String) {
    match CliError::of_clap(error) {
        Ok(own) => of_cli(&own),
        Err(clap) => {
            let text = clap.to_string();
            let line = text.lines().next().unwrap_or_default();
            let line = line.strip_prefix("error: ").unwrap_or(line).to_owned();
            let option = line.split("--").nth(1).map(|rest| {
                rest.chars().take_while(|c| c.is_alphanumeric() || *c == '-').collect::<String>()
            });
            (option, line)
        }
    }
}
