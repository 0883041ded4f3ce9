//! The summary of a given figure and motion, for people.

use super::report::{FilterReport, GivenReport};
use crate::markers::MarkersReport;
use crate::words::{counted, row, short, some};
use solaris::view::TableRow;
use std::io::{Result, Write};

impl GivenReport {
    /// The figure, its motion, and what was made of it.
    pub(crate) fn write(&self, out: &mut dyn Write) -> Result<()> {
        let Self { figure, format, dofs, mass_kg, .. } = self;
        let dofs = counted(*dofs, "degree of freedom", "degrees of freedom");
        writeln!(out, "{format} '{figure}': {dofs}, {} kg\n", short(*mass_kg))?;
        let rows = counted(self.rows, "row", "rows");
        let times = match (self.has_times, self.rows) {
            (false, _) => " without times".to_owned(),
            (true, 1) => format!(" at {} s", short(self.from_s)),
            (true, _) => format!(", {} to {} s", short(self.from_s), short(self.to_s)),
        };
        row(out, "motion", &format!("{rows}{times}; {}", self.units))?;
        let [x, y, z] = self.gravity_m_s2;
        row(out, "gravity", &format!("({x}, {y}, {z}) m/s², {}", self.gravity_from))?;
        let which = if self.filter.is_some() { "filtered " } else { "" };
        for (count, of) in [(self.from_positions, "positions"), (self.from_velocities, "velocities")] {
            let dofs = counted(count, "dof", "dofs");
            let how = match self.rows {
                _ if count == 0 => continue,
                1 => "zero, since a single row has none".to_owned(),
                2 => format!("of the straight line through the {which}{of}"),
                _ => format!("of the natural quintic spline through the {which}{of}"),
            };
            row(out, "derivatives", &format!("{dofs}: {how}"))?;
        }
        if self.from_positions + self.from_velocities == 0 {
            row(out, "derivatives", "as recorded")?;
        }
        self.write_filter(out)?;
        self.subject.iter().try_for_each(|subject| subject.write(out))?;
        self.markers.iter().try_for_each(|markers| markers.write(out))
    }

    /// What a page says of them.
    pub(crate) fn page_rows(&self) -> Vec<TableRow> {
        let rows = counted(self.rows, "row", "rows");
        let [x, y, z] = self.gravity_m_s2;
        let mut all = vec![
            TableRow::new(
                "Figure",
                short(self.mass_kg),
                "kg",
                format!(
                    "{} '{}', {}",
                    self.format,
                    self.figure,
                    counted(self.dofs, "degree of freedom", "degrees of freedom")
                ),
            ),
            TableRow::new("Motion", short(self.to_s - self.from_s), "s", format!("{rows}; {}", self.units)),
            TableRow::new("Gravity", "", "", format!("({x}, {y}, {z}) m/s², {}", self.gravity_from)),
        ];
        if let Some(FilterReport { cutoff_hz, order, .. }) = &self.filter {
            let what = format!("zero-phase Butterworth of order {order}, there and back");
            all.push(TableRow::new("Filter", short(*cutoff_hz), "Hz", what));
        }
        all.extend(self.markers.iter().flat_map(MarkersReport::page_rows));
        all
    }

    /// That the figure lies on its side or stands on its head, as its markers say.
    pub(crate) fn turned(&self) -> Option<&str> {
        self.markers.as_ref()?.turned()
    }

    fn write_filter(&self, out: &mut dyn Write) -> Result<()> {
        let Some(FilterReport { cutoff_hz, order, spoiled_s }) = &self.filter else { return Ok(()) };
        if self.from_positions + self.from_velocities == 0 {
            return row(out, "filter", "not used: what is recorded with its derivatives is taken as it is");
        }
        let what = format!("zero-phase Butterworth, {cutoff_hz} Hz, order {order} there and back");
        row(out, "filter", &what)?;
        let ends = short(*spoiled_s);
        row(out, "", &format!("the first and the last {ends} s are the filter's, not the motion's"))
    }

    /// What looks wrong with it, and what was not used.
    pub(crate) fn write_doubts(&self, out: &mut dyn Write) -> Result<()> {
        self.doubts().iter().try_for_each(|(what, value)| row(out, what, value))
    }

    /// The same by line: what it is about (nothing where that is as before), and what there is to say.
    pub(crate) fn doubts(&self) -> Vec<(&'static str, String)> {
        let mut doubts = Vec::new();
        for (i, missing) in self.missing.iter().enumerate() {
            doubts.push((if i == 0 { "missing" } else { "" }, missing.clone()));
        }
        doubts.extend(self.guessed.iter().map(|guess| ("suspect", guess.clone())));
        if let Some(found) = &self.suspect_angles {
            doubts.push(("suspect", found.message().to_owned()));
        } else if !self.many_turns.is_empty() {
            let what = format!("{}: more than two turns; are these degrees?", some(&self.many_turns));
            doubts.push(("suspect", what));
        }
        if !self.mass_doubts.is_empty() {
            let subjects: Vec<String> = self.mass_doubts.iter().map(|doubt| doubt.subject.clone()).collect();
            let what = format!("{}: masses that no matter has, taken as they are", some(&subjects));
            doubts.push(("suspect", format!("{what}; solaris check says more")));
        }
        for (i, excess) in self.outside_limits.iter().enumerate() {
            let (by, unit) = if excess.turns { (excess.by.to_degrees(), "°") } else { (excess.by, " m") };
            let what = if i == 0 { "outside limits" } else { "" };
            doubts.push((what, format!("{} by {}{unit} at {} s", excess.dof, short(by), short(excess.at_s))));
        }
        if !self.ignored_columns.is_empty() {
            doubts.push(("columns not used", some(&self.ignored_columns)));
        }
        for (i, note) in self.notes.iter().enumerate() {
            doubts.push((if i == 0 { "of the table" } else { "" }, note.clone()));
        }
        if self.not_read > 0 {
            let kinds = counted(self.not_read, "kind", "kinds");
            doubts.push(("not read", format!("{kinds} of things in the model; solaris check lists them")));
        }
        doubts
    }
}
