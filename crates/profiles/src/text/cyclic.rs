//! Curves that come again.

use super::curve::ProfileReader;
use crate::cyclic::whole_times;
use crate::profile::Profile;
use solaris_text::{Fields, Node};

impl ProfileReader<'_> {
    /// `Sine(amplitude: 0.2, period: 1, cycles: 3, phase: deg(90), offset: 0.5)`
    pub(super) fn sine(&mut self, node: &Node<'_>) -> Option<Profile> {
        let known = ["amplitude", "period", "cycles", "phase", "offset"];
        let fields = self.reader.fields(node, &["Sine"], &known)?;
        let turns = self.turns;
        let amplitude = self.reader.required(&fields, "amplitude", if turns { "deg(20)" } else { "0.2" });
        let amplitude = amplitude.and_then(|node| self.reader.coordinate(node, turns, "the amplitude"));
        let period = self.reader.required(&fields, "period", "1.2");
        let period = period.and_then(|node| self.reader.number(node, "the period"));
        let cycles = self.times(&fields, "cycles", period).map(|(cycles, _)| cycles);
        let phase = match fields.get("phase") {
            Some(node) => self.reader.angle(node, "the phase"),
            None => Some(0.0),
        };
        let offset = match fields.get("offset") {
            Some(node) => self.reader.coordinate(node, turns, "the offset"),
            None => Some(0.0),
        };
        let profile = Profile::Sine {
            amplitude: amplitude?,
            period: period?,
            cycles: cycles?,
            phase: phase?,
            offset: offset?,
        };
        self.checked(profile, &fields)
    }

    /// `Repeat(of: CURVE, times: 3)`
    pub(super) fn repeat(&mut self, node: &Node<'_>) -> Option<Profile> {
        let fields = self.reader.fields(node, &["Repeat"], &["of", "times"])?;
        let of = self.reader.required(&fields, "of", "MinimumJerk(from: 0, to: 1, duration: 2)");
        let of = of.and_then(|node| self.profile(node));
        let period = of.as_ref().and_then(|of| Some(crate::Curve::span(&of.curve::<f64>().ok()?)));
        let place = fields.get("times").map_or(fields.at.clone(), |node| node.span.clone());
        // What need not be whole of a sine has to be here.
        let times = self
            .times(&fields, "times", period)
            .map(|(times, given)| if given { times } else { times.ceil() })?;
        let times = whole_times(times).map_err(|error| self.reader.fault(place, error.to_string())).ok()?;
        self.checked(Profile::Repeat { of: Box::new(of?), times }, &fields)
    }

    /// How often, and whether the text says so; or as often as it takes to last as long as what is around.
    fn times(&mut self, fields: &Fields<'_, '_>, field: &str, period: Option<f64>) -> Option<(f64, bool)> {
        if let Some(node) = fields.get(field) {
            return Some((self.reader.number(node, format_args!("the {field}"))?, true));
        }
        let Some(lasts) = self.lasts else {
            self.reader.required(fields, field, "3");
            return None;
        };
        let period = period.filter(|period| *period > 0.0);
        Some((period.map_or(1.0, |period| lasts / period), false))
    }
}
