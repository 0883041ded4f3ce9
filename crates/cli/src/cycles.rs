//! Means over the strides of a motion.

use crate::error::CliError;
use crate::ground::CyclesFormat;
use crate::words::{counted, row, short};
use serde::Serialize;
use solaris::analysis::cycles::{MeanCycle, PERCENTS, mean_cycle, strides};
use solaris::analysis::ground::{Sole, Stances};
use solaris::io::{Table, csv};
use solaris::view::{CycleCurve, cycles};
use std::io::{Result as Written, Write};

/// A quantity over the motion.
pub(crate) struct Column {
    /// What its columns are called: `hip_flexion_r.tau`.
    pub(crate) heading: String,
    /// What the picture calls it; left out of it where it is `None`.
    pub(crate) name: Option<String>,
    /// The picture's unit.
    pub(crate) unit: &'static str,
    /// How many of the picture's units are in one of the table's.
    pub(crate) factor: f64,
    /// One a time.
    pub(crate) values: Vec<f64>,
}

/// Means over strides.
#[derive(Serialize)]
pub(crate) struct Cycles {
    /// The sole whose touch-downs part them.
    foot: String,
    strides_s: Vec<[f64; 2]>,
    #[serde(skip)]
    means: Vec<(Column, MeanCycle)>,
}

/// Strides of which one is so many times longer than another are not all whole.
const UNEVEN: f64 = 1.5;

impl Cycles {
    /// Cuts columns at the touch-downs of the foot that is asked for.
    pub(crate) fn of(
        asked: &str,
        (soles, stances): (&[Sole], &Stances),
        time: &[f64],
        columns: Vec<Column>,
    ) -> Result<Self, CliError> {
        let refuse = |why: String| CliError::option("cycles", asked, why);
        let foot = find(asked, soles).ok_or_else(|| {
            let names: Vec<&str> = soles.iter().map(|sole| &*sole.name).collect();
            refuse(format!("it must be a sole: {}", names.join(", ")))
        })?;
        let strides_s = strides(stances, foot, time);
        if strides_s.is_empty() {
            let touches = stances.list.iter().filter(|stance| stance.foot == foot).count();
            let stands = counted(touches, "time", "times");
            return Err(refuse(format!(
                "it stands {stands} in this motion, and a stride goes from one touch-down to the next; take a longer motion"
            )));
        }
        let cut = |column: Column| {
            let mean = mean_cycle(time, &column.values, &strides_s);
            (column, mean)
        };
        let means = columns.into_iter().map(cut).collect();
        Ok(Self { foot: soles[foot].name.clone(), strides_s, means })
    }

    pub(crate) fn write_file(
        &self,
        format: CyclesFormat,
        title: &str,
        mut writer: &mut dyn Write,
    ) -> Result<(), CliError> {
        match format {
            CyclesFormat::Table => csv::write_table(&self.table(), &mut writer).map_err(CliError::other),
            CyclesFormat::Picture => {
                writer.write_all(self.picture(title).as_bytes()).map_err(CliError::other)
            }
        }
    }

    /// `percent`, then mean and standard deviation of each column.
    fn table(&self) -> Table {
        let headings = self
            .means
            .iter()
            .flat_map(|(column, _)| ["mean", "sd"].map(|what| format!("{}.{what}", column.heading)));
        let columns = std::iter::once("percent".to_owned()).chain(headings).collect();
        let values = (0..PERCENTS).flat_map(|percent| {
            let means = self.means.iter();
            let both = means.flat_map(move |(_, cycle)| [cycle.mean[percent], cycle.deviation[percent]]);
            std::iter::once(percent as f64).chain(both)
        });
        let (values, lines) = (values.collect(), (1..).take(PERCENTS).collect());
        Table { columns, values, lines, header_line: 1, ..Table::default() }
    }

    fn picture(&self, title: &str) -> String {
        let curves = self.means.iter().filter_map(|(column, MeanCycle { mean, deviation })| {
            let scaled = |values: &[f64]| values.iter().map(|value| column.factor * value).collect();
            Some(CycleCurve {
                name: column.name.clone()?,
                unit: column.unit.to_owned(),
                mean: scaled(mean),
                deviation: scaled(deviation),
            })
        });
        let strides = counted(self.strides_s.len(), "stride", "strides");
        cycles(&curves.collect::<Vec<_>>(), &format!("{title}: {strides} of {}", self.foot))
    }

    /// The summary's lines.
    pub(crate) fn write(&self, out: &mut dyn Write) -> Written<()> {
        row(out, "strides", &self.words())?;
        self.doubt().map_or(Ok(()), |doubt| row(out, "", &doubt))
    }

    fn lasting(&self) -> (f64, f64) {
        let lasting = self.strides_s.iter().map(|[from, to]| to - from);
        lasting.fold((f64::INFINITY, 0.0), |(least, most), time| (time.min(least), time.max(most)))
    }

    pub(crate) fn words(&self) -> String {
        let ((least, most), count) = (self.lasting(), self.strides_s.len());
        let strides = counted(count, "stride", "strides");
        let lasting = if count == 1 { short(least) } else { format!("{} to {}", short(least), short(most)) };
        format!("{strides} of {lasting} s, from touch-down to touch-down of {}", self.foot)
    }

    /// What looks wrong with them.
    pub(crate) fn doubt(&self) -> Option<String> {
        let (least, most) = self.lasting();
        (most > UNEVEN * least).then(|| {
            format!(
                "the longest is {:.1} times the shortest: a touch-down may not have been found; see --stance-height, --stance-speed",
                most / least
            )
        })
    }
}

/// The sole of this name, or the only one of this side.
fn find(asked: &str, soles: &[Sole]) -> Option<usize> {
    let by_name = soles.iter().position(|sole| sole.name == asked);
    let letter = match asked {
        "left" => "l",
        "right" => "r",
        _ => return by_name,
    };
    let is_of = |name: &str, word: &str| {
        name.strip_prefix(word).is_some_and(|rest| rest.starts_with('_'))
            || name.strip_suffix(word).is_some_and(|rest| rest.ends_with('_'))
    };
    let own = |sole: &&Sole| is_of(&sole.name, asked) || is_of(&sole.name, letter);
    by_name.or_else(|| match soles.iter().filter(own).count() {
        1 => soles.iter().position(|sole| own(&sole)),
        _ => None,
    })
}
