//! Precision against work: which method, at which step or tolerance, comes how near for how much work. A picture, and a
//! page with the numbers.

mod chart;
mod page;
mod study;

pub use chart::svg;
pub use page::page;
pub use study::{diagram, findings, report};

/// What is drawn, and what stands beside it; plain text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagram {
    /// The first line.
    pub title: String,
    /// The line below it: of what, against what.
    pub subtitle: String,
    /// What the error is of: `positions (rad or m)`.
    pub error: String,
    /// One for each method; more than [`MOST_SERIES`] begin with the first colour again.
    pub series: Vec<Series>,
    /// The error that is wanted: a line.
    pub wanted: Option<f64>,
    /// How well the answer itself is known: what lies below says only that it is no worse.
    pub floor: Option<f64>,
}

/// The most series that have a colour and a shape of their own.
pub const MOST_SERIES: usize = crate::chart::SERIES;

/// A method at its settings.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Series {
    /// The method.
    pub name: String,
    /// Its settings, the coarsest first; they are joined in this order.
    pub points: Vec<Point>,
}

/// A setting of a method, and what came of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The setting: `1e-3 s`.
    pub label: String,
    /// How long it took (s), where that is known.
    pub seconds: Option<f64>,
    /// How many evaluations it took, where that is known.
    pub evaluations: Option<f64>,
    /// How far off it was; `None` for one without a result.
    pub error: Option<f64>,
}

/// What the work is measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Against {
    /// Seconds.
    Seconds,
    /// Evaluations of the dynamics.
    Evaluations,
}

impl Against {
    /// The work of a point; nothing where it is not known or no number above zero.
    fn of(self, point: &Point) -> Option<f64> {
        let work = match self {
            Self::Seconds => point.seconds,
            Self::Evaluations => point.evaluations,
        };
        work.filter(|work| work.is_finite() && *work > 0.0)
    }

    fn name(self) -> &'static str {
        match self {
            Self::Seconds => "time (s)",
            Self::Evaluations => "evaluations of the dynamics",
        }
    }
}

/// What stands on the page beside the pictures; plain text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// The pictures.
    pub diagram: Diagram,
    /// What is to be read first: the recommendation, and what speaks against it.
    pub findings: Vec<String>,
    /// Tables, in their order, after the pictures.
    pub tables: Vec<Table>,
}

/// A table with a heading.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// What it shows.
    pub title: String,
    /// What there is to say of it; may be empty.
    pub note: String,
    /// Names of the columns. The first is text, the others are set to the right.
    pub header: Vec<String>,
    /// The rows, as long as the header. A row with fewer cells says what it has in the last one across the rest.
    pub rows: Vec<Vec<String>>,
    /// The rows that are set off, by index.
    pub marked: Vec<usize>,
}
