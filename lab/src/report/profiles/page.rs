//! The tables of docs/profiles-accuracy.md.

use super::accuracy::{self, Accuracy};
use super::cases::{CLIPS, HARD, KINDS, Kind};
use super::family::Placed;
use super::reference::Reference;
use super::speed::Speed;
use crate::report::page::duration;
use crate::table::{Cell, Table};

/// All that is measured.
pub(super) struct Measured {
    /// Of the ordinary case of each of [`KINDS`].
    pub(super) ordinary: Vec<Accuracy>,
    pub(super) speeds: Vec<Speed>,
    /// Of [`HARD`].
    pub(super) hard: Vec<Accuracy>,
    /// Of [`CLIPS`].
    pub(super) clips: Vec<Accuracy>,
}

impl Measured {
    /// The errors of every case, with the speeds that `speed` finds.
    pub(super) fn new(speed: impl Fn(&Kind, &Reference) -> Result<Speed, String>) -> Result<Self, String> {
        let reference = Reference::read()?;
        Ok(Self {
            ordinary: KINDS
                .iter()
                .map(|kind| (kind.accuracy)(&reference, kind.ordinary))
                .collect::<Result<_, _>>()?,
            speeds: KINDS.iter().map(|kind| speed(kind, &reference)).collect::<Result<_, _>>()?,
            hard: HARD
                .iter()
                .map(|case| (case.kind().accuracy)(&reference, case.name))
                .collect::<Result<_, _>>()?,
            clips: CLIPS
                .iter()
                .map(|name| accuracy::measure::<Placed>(&reference, name))
                .collect::<Result<_, _>>()?,
        })
    }

    pub(super) fn tables(&self) -> [(&'static str, Table); 4] {
        [
            ("ordinary", self.ordinary()),
            ("hard", self.hard()),
            ("clips", self.clips()),
            ("constants", self.constants()),
        ]
    }

    /// Errors and times of ordinary curves.
    fn ordinary(&self) -> Table {
        let row = |(i, kind): (usize, &Kind)| {
            let Speed { evaluation: [printed, stable], .. } = self.speeds[i];
            let errors = self.ordinary[i];
            let mut row = vec![Cell::text(format!("{} {}", i + 1, kind.name))];
            row.extend([errors.printed, errors.stable].map(both));
            row.extend([printed[0], stable[0], printed[1], stable[1]].map(time));
            row
        };
        Table {
            header: vec![
                "",
                "printed, f64 / f32",
                "library, f64 / f32",
                "printed, f64",
                "library, f64",
                "printed, f32",
                "library, f32",
            ],
            rows: KINDS.iter().enumerate().map(row).collect(),
        }
    }

    /// Errors where the printed forms lose digits.
    fn hard(&self) -> Table {
        let row = |(name, Accuracy { printed, stable }): (&'static str, &Accuracy)| {
            let mut row = vec![Cell::text(name)];
            row.extend([printed[0], stable[0], printed[1], stable[1]].map(one));
            row
        };
        Table {
            header: vec!["", "printed, f64", "library, f64", "printed, f32", "library, f32"],
            rows: HARD.iter().map(|case| case.name).zip(&self.hard).map(row).collect(),
        }
    }

    /// Errors of single precision in absolute time.
    fn clips(&self) -> Table {
        let row = |(name, errors): (&&'static str, &Accuracy)| {
            vec![Cell::text(*name), one(errors.printed[1]), one(errors.stable[1])]
        };
        Table {
            header: vec!["f32", "(t − t₀)/T", "`Clip`"],
            rows: CLIPS.iter().zip(&self.clips).map(row).collect(),
        }
    }

    /// Times to work out the constants.
    fn constants(&self) -> Table {
        let row = |(i, kind): (usize, &Kind)| {
            let Speed { construction: [printed, stable], .. } = self.speeds[i];
            let mut row = vec![
                Cell::text(format!("{} {}", i + 1, kind.name)),
                Cell::text(format!("`{}`", kind.stable)),
            ];
            row.extend([printed[0], stable[0], printed[1], stable[1]].map(time));
            row
        };
        Table {
            header: vec!["", "library", "printed, f64", "library, f64", "printed, f32", "library, f32"],
            rows: KINDS.iter().enumerate().map(row).collect(),
        }
    }
}

/// An error; a dash where there is no such case.
fn one(error: Option<f64>) -> Cell {
    error.map_or_else(|| Cell::text("–"), |error| Cell::Numbers(vec![error]))
}

/// Errors that there are in both precisions.
fn both(errors: [Option<f64>; 2]) -> Cell {
    Cell::Numbers(errors.into_iter().flatten().collect())
}

fn time(ns: f64) -> Cell {
    Cell::Time(duration(ns))
}
