//! A comparison of walks with people: every fact that is known of their walking, and the walker's own value.

mod beside;
mod curves;
mod facts;

pub use beside::{Beside, beside};
pub use curves::{Curve, PACES, PHASES, Pace, curves, nearest_pace};
pub use facts::{FACTS, Fact, Person};

use crate::error::{GaitError, MeasureError};
use crate::measure::{SteadyStride, measure};
use crate::request::{Extent, WalkRequest};
use crate::styled::{StyledPlan, StyledRequest};
use crate::thesis::determinants::{Cell, Determinants, GaitTable};
use solaris_model::Figure;

/// Steps of a walk in whose middle neither its beginning nor its end is felt.
const STEPS: usize = 24;
/// Samples a second.
const RATE: f64 = 120.0;

/// A walker's steady stride at a step frequency, or why there is none.
#[derive(Clone, Debug)]
pub struct Compared {
    /// Steps a minute.
    pub step_frequency: f64,
    /// The stride, or the refusal.
    pub stride: Result<SteadyStride, GaitError>,
    /// The stride's curves beside people's at its pace; none of a refusal.
    pub curves: Vec<Beside>,
    person: Person,
}

impl Compared {
    /// The smooth walk of a figure at a step frequency.
    pub fn of(figure: &Figure, determinants: Determinants, step_frequency: f64) -> Self {
        let parameters = match determinants {
            Determinants::Three => vec![("rotation", 0.0)],
            Determinants::Five => Vec::new(),
        };
        let request = WalkRequest {
            step_frequency: Some(step_frequency),
            extent: Extent::Steps(STEPS),
            parameters,
            ..WalkRequest::default()
        };
        let walked = || {
            let plan = StyledPlan::of(figure, &StyledRequest::Smooth(request))?;
            let (motion, _) = plan.loaded(figure, RATE)?;
            let steady = measure(figure, &motion)?.steady;
            let steady = steady.ok_or(MeasureError::NothingToMeasure { what: "steady stride" })?;
            let curves = beside(figure, &motion, &steady);
            Ok((steady, curves))
        };
        let person = Person { height: figure.stature().unwrap_or(f64::NAN), step_frequency };
        let (stride, curves) =
            walked().map_or_else(|error| (Err(error), Vec::new()), |(stride, curves)| (Ok(stride), curves));
        Self { step_frequency, stride, curves, person }
    }

    /// What its column of a table is called.
    fn heading(&self) -> String {
        format!("{} /min", self.step_frequency)
    }

    /// A fact's value here, and whether it lies inside of people's band.
    pub fn holds(&self, fact: &Fact) -> Option<(f64, bool)> {
        let stride = self.stride.as_ref().ok()?;
        let value = fact.value(stride, &self.person);
        let (lower, upper) = fact.band(stride, &self.person);
        // A law that both follow is met as well as a sampled motion is measured.
        let slack = 1e-4 * lower.abs().max(upper.abs());
        Some((value, (lower - slack..=upper + slack).contains(&value)))
    }

    /// How many facts lie inside, and of how many.
    pub fn inside(&self) -> Option<(usize, usize)> {
        self.stride.as_ref().ok()?;
        let held = FACTS.iter().filter(|fact| self.holds(fact).is_some_and(|(_, inside)| inside)).count();
        Some((held, FACTS.len()))
    }
}

/// A figure's smooth walks at step frequencies (steps/min).
pub fn compare(figure: &Figure, determinants: Determinants, step_frequencies: &[f64]) -> Vec<Compared> {
    step_frequencies.iter().map(|frequency| Compared::of(figure, determinants, *frequency)).collect()
}

/// The table of all facts for walks of so many determinants.
pub fn table(determinants: Determinants, compared: &[Compared]) -> GaitTable {
    let mut columns =
        vec!["fact".to_owned(), "unit".to_owned(), "people".to_owned(), "measured trial".to_owned()];
    columns.extend(compared.iter().map(Compared::heading));
    let mut rows: Vec<Vec<Cell>> = FACTS.iter().map(|fact| row(fact, compared)).collect();
    let mut counts = vec![Cell::plain("inside"), Cell::plain(""), Cell::plain(""), Cell::plain("")];
    counts.extend(compared.iter().map(|compared| {
        Cell::plain(compared.inside().map_or_else(String::new, |(held, of)| format!("{held} of {of}")))
    }));
    rows.push(counts);
    let mut notes = vec![
        "✓ inside of people's band, ✗ outside. A dash: such a walk is refused.".to_owned(),
        "*: a textbook's range that nobody has looked up.".to_owned(),
        "Measured trial: one person on a treadmill, 97.8 steps/min, 1.135 m/s.".to_owned(),
    ];
    notes.extend(refusals(compared));
    let title = match determinants {
        Determinants::Three => "smooth walks of three determinants beside people",
        Determinants::Five => "smooth walks of five determinants beside people",
    };
    GaitTable { number: "", title, columns, rows, notes }
}

/// The table of the curves of the same walks.
pub fn curve_table(compared: &[Compared]) -> GaitTable {
    let mut columns = vec!["curve".to_owned(), "unit".to_owned()];
    columns.extend(compared.iter().map(Compared::heading));
    let known = compared.iter().find(|compared| !compared.curves.is_empty());
    let rows = known.into_iter().flat_map(|known| &known.curves).map(|Beside { people, .. }| {
        let decimals = usize::from(people.unit.starts_with(['N', 'W'])) + 1;
        let cells = compared.iter().map(|compared| {
            let beside = compared.curves.iter().find(|beside| beside.people.name == people.name);
            beside.map_or_else(
                || "–".to_owned(),
                |beside| format!("{:.decimals$} ({:.0} %)", beside.difference(), 100.0 * beside.within(2.0)),
            )
        });
        [people.name.to_owned(), people.unit.to_owned()].into_iter().chain(cells).map(Cell::plain).collect()
    });
    let mut notes = vec![
        "Root of the mean square of the difference from people's mean over a stride, and in brackets in how much of the stride it lies within two \
         standard deviations."
            .to_owned(),
        "People: up to 82 children and young people at the nearest of five paces, Schwartz, Rozumalski and Trost 2008 (J. Biomech. 41:1639)."
            .to_owned(),
    ];
    notes.extend(refusals(compared));
    GaitTable {
        number: "",
        title: "curves of smooth walks beside people",
        rows: rows.collect(),
        columns,
        notes,
    }
}

fn refusals(compared: &[Compared]) -> impl Iterator<Item = String> {
    compared.iter().filter_map(|compared| {
        let error = compared.stride.as_ref().err()?;
        Some(format!("{} steps/min is refused: {error}", compared.step_frequency))
    })
}

fn row(fact: &Fact, compared: &[Compared]) -> Vec<Cell> {
    let number = |value: f64| format!("{value:.0$}", fact.decimals);
    let star = if fact.looked_up { "" } else { "*" };
    let bands: Vec<(f64, f64)> =
        compared.iter().filter_map(|c| Some(fact.band(c.stride.as_ref().ok()?, &c.person))).collect();
    let same = bands.windows(2).all(|pair| pair[0] == pair[1]);
    let people = match bands.first() {
        Some((lower, upper)) if same => format!("{} to {}{star}", number(*lower), number(*upper)),
        _ => fact.law.to_owned(),
    };
    let trial = fact.trial.map_or_else(String::new, number);
    let cells = compared.iter().map(|c| match (c.holds(fact), &c.stride) {
        (Some((value, inside)), Ok(stride)) => {
            let (lower, upper) = fact.band(stride, &c.person);
            // As many decimals as show on which side it lies.
            let shows = |decimals: &usize| {
                let shown: f64 = format!("{value:.decimals$}").parse().unwrap_or(f64::NAN);
                inside || !(lower..=upper).contains(&shown)
            };
            let decimals = (fact.decimals..fact.decimals + 4).find(shows).unwrap_or(fact.decimals + 4);
            format!("{value:.decimals$} {}", if inside { "✓" } else { "✗" })
        }
        _ => "–".to_owned(),
    });
    [fact.name.to_owned(), fact.unit.to_owned(), people, trial]
        .into_iter()
        .chain(cells)
        .map(Cell::plain)
        .collect()
}
