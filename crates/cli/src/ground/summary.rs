//! The summary of the ground's forces, for people.

use super::report::{Foot, GroundReport};
use crate::words::{counted, row, short, some};
use solaris::analysis::ground::{Split, Worst};
use solaris::view::TableRow;
use std::io::{Result, Write};

impl GroundReport {
    /// Soles, ground, stances; each foot; what to look at.
    pub(crate) fn write(&self, out: &mut dyn Write) -> Result<()> {
        let names: Vec<String> = self.feet.iter().map(|foot| foot.found.name.clone()).collect();
        row(out, "soles", &format!("{}, {}", some(&names), self.soles_from))?;
        row(out, "ground", &format!("{}, {}", self.height(), self.belt()))?;
        row(out, "stances", &format!("by {}", self.stances_from))?;
        let (split, assumption) = (self.split.name(), assumption(self.split));
        row(out, "split", &format!("{split}: {assumption}; an assumption, no law"))?;
        if let Some(moved) = &self.consistent {
            moved.write(out)?;
        }
        self.feet.iter().try_for_each(|foot| foot.write(out))?;
        let air = &self.unsupported;
        writeln!(out)?;
        if let Some(beside) = &self.beside_plates {
            row(out, "beside all plates", &beside.words())?;
        }
        if let Some(plausible) = &self.plausibility {
            plausible.write_fit(out)?;
        }
        if air.frames == 0 {
            row(out, "no foot stands", "in no frame")?;
        } else {
            let [rms, force, at] = [air.force_rms, air.force, air.time].map(short);
            let left = format!("a force of {rms} N is left there (rms), {force} N at {at} s");
            row(out, "no foot stands", &format!("in {} frames; {left}", air.frames))?;
        }
        if !self.warnings.is_empty() {
            writeln!(out, "\n  Look at")?;
        }
        self.warnings.iter().try_for_each(|warning| writeln!(out, "  - {warning}"))
    }

    fn height(&self) -> String {
        let millimetres = |height: f64| short((height * 1e3).round() / 1e3 + 0.0);
        match self.feet_stand_m {
            None => format!("{} m up", millimetres(self.level_m)),
            Some(heights) => {
                let [low, high] = heights.map(millimetres);
                format!("not level: feet stand {low} to {high} m up, as their soles lie")
            }
        }
    }

    fn belt(&self) -> String {
        let speed = self.belt_m_s.iter().fold(0.0_f64, |speed, v| speed.hypot(*v));
        let from = self.belt_from;
        if speed == 0.0 {
            return format!("still, {from}");
        }
        let [x, y, z] = self.belt_m_s.map(short);
        format!("a belt of {} m/s, ({x}, {y}, {z}), {from}", short(speed))
    }
}

impl GroundReport {
    /// What a page says of the feet.
    pub(crate) fn page_rows(&self) -> Vec<TableRow> {
        let foot = |Foot { found, .. }: &Foot| {
            let stances = counted(found.stances.len(), "stance", "stances");
            let weight = percent(found.greatest_of_weight);
            TableRow::new(
                format!("Under {}", found.name),
                short(found.greatest),
                "N",
                format!("greatest; {weight} of the weight, {stances}"),
            )
        };
        let split = format!("{}: {}; an assumption, no law", self.split.name(), assumption(self.split));
        let split = TableRow::new("Shares of two feet", "", "", split);
        self.feet.iter().map(foot).chain([split]).collect()
    }
}

impl Foot {
    fn write(&self, out: &mut dyn Write) -> Result<()> {
        let foot = &self.found;
        writeln!(out, "\n  under {}", foot.name)?;
        let stances: Vec<String> =
            foot.stances.iter().map(|[start, end]| format!("{} to {}", short(*start), short(*end))).collect();
        if stances.is_empty() {
            return line(out, "stands", "never");
        }
        line(out, "stands", &format!("{} s", some(&stances)))?;
        let (greatest, of_weight) = (short(foot.greatest), percent(foot.greatest_of_weight));
        line(out, "greatest force", &format!("{greatest} N, {of_weight} of the weight"))?;
        if let Some(Worst { value, time, share }) = foot.least {
            let pulls = if share > 0.0 {
                format!("; it pulls in {} of its frames", percent(share))
            } else {
                String::new()
            };
            line(out, "least force", &format!("{} N at {} s{pulls}", short(value), short(time)))?;
        }
        if let Some(Worst { value, time, share }) = foot.friction {
            let above = percent(share);
            let what = format!("{} at {} s; above 0.6 in {above} of its frames", short(value), short(time));
            line(out, "greatest friction", &what)?;
        }
        match foot.outside {
            Some(Worst { value, time, share }) if value > 0.0 => {
                let (by, at, share) = (short(value * 1000.0), short(time), percent(share));
                line(
                    out,
                    "pressure",
                    &format!("{by} mm outside of the sole at {at} s; in {share} of its frames"),
                )
            }
            Some(_) => line(out, "pressure", "inside of the sole"),
            None if foot.width.is_none() => line(out, "pressure", "not judged: the sole has no width"),
            None => line(out, "pressure", "not judged: the foot never bears 5 % of the weight"),
        }?;
        self.beside_plate.map_or(Ok(()), |beside| line(out, "beside its plate", &beside.words()))
    }
}

/// What a split takes for granted.
fn assumption(split: Split) -> &'static str {
    match split {
        Split::Transition => "smooth curves fitted to people who walk",
        Split::Pivot => "forces point at one point above the centre of mass",
        Split::Effort => "least moments in the joints",
        _ => "",
    }
}

fn line(out: &mut dyn Write, what: &str, value: &str) -> Result<()> {
    writeln!(out, "    {what:<20}{value}")
}

/// A share of all.
fn percent(share: f64) -> String {
    let percent = share * 100.0;
    if percent > 0.0 && percent < 1.0 { "less than 1 %".to_owned() } else { format!("{percent:.0} %") }
}
