//! Options as a request of the planners.

use super::options::{GaitKind, GaitOptions, PartOptions, RunEndOptions, RunWalkOptions, StairOptions};
use super::stages::{Next, Staged, stages};
use crate::error::{GaitError, RequestError};
use crate::request::{
    DEFAULT_RUN_SPEED, Extent, Foothold, Population, RunEnd, RunPart, RunRequest, RunWalk, Stairs,
    StyleSheet, Variability, WalkGround, WalkPart, WalkPath, WalkRequest,
};
use crate::running::least_run_steps;
use crate::smooth::{PARAMETERS, sheet_of, side_sheet_of};
use crate::styled::StyledRequest;
use crate::thesis::ThesisRequest;
use crate::thesis::determinants::{Determinants, Proportions};
use solaris_model::{Figure, Relief, nearest};

/// Steps where it is not said how far.
const STEPS: usize = 10;
/// Steps of which one in the middle is taken where a stride is to repeat itself: of a walk, through key postures, of a run.
const LOOPED: [usize; 3] = [42, 6, 2];

impl GaitOptions {
    /// The request of the planners, for this figure.
    ///
    /// # Errors
    ///
    /// What contradicts itself, is not known by that name, or belongs to another gait or style. Ranges are the planners' to check.
    pub fn request(&self, figure: &Figure) -> Result<Staged, GaitError> {
        self.check()?;
        let alone = |request| Staged { request, origins: Vec::new() };
        Ok(match (self.gait, self.determinants) {
            (GaitKind::Run, _) => alone(StyledRequest::Run(self.run()?)),
            (GaitKind::Walk, Some(count)) => alone(StyledRequest::Thesis(self.thesis(count, figure)?)),
            (GaitKind::Walk, None) => self.walk(figure)?,
        })
    }

    /// Refuses what belongs to another gait or style, and what says the same twice.
    fn check(&self) -> Result<(), RequestError> {
        let (is_run, is_thesis) = (self.gait == GaitKind::Run, self.determinants.is_some());
        let of_walks = [
            ("step_frequency", self.step_frequency.is_some() && is_run),
            ("step_length", self.step_length.is_some() && is_run),
            ("determinants", is_thesis && is_run),
            ("style", !self.style.is_empty() && is_run),
            ("turn", self.turn != 0.0),
            ("path", self.path.is_some()),
            ("backward", self.backward),
            ("then", !self.then.is_empty() && is_thesis && !is_run),
            ("slope", self.slope.is_some()),
            ("stairs", self.stairs.is_some()),
            ("ground", self.ground.is_some()),
            ("footholds", self.footholds.is_some()),
            ("population", self.population.is_some()),
            ("manner", self.manner.is_some()),
            ("left", self.left.is_some()),
            ("right", self.right.is_some()),
            ("variability", self.variability.is_some()),
            ("cane_load", self.cane_load.is_some()),
        ];
        if (is_run || is_thesis)
            && let Some((option, _)) = of_walks.into_iter().find(|(_, given)| *given)
        {
            let of = if is_run { "a run" } else { "a walk through key postures (determinants)" };
            return Err(RequestError::NotOf { option, of });
        }
        let of_runs = [
            ("forefoot", self.forefoot),
            ("give", self.give.is_some_and(|give| give > 0.0)),
            ("from", self.from != RunEndOptions::Running),
            ("to", self.to != RunEndOptions::Running),
        ];
        let bound = of_runs.into_iter().find(|(_, given)| *given);
        if let Some((option, _)) = bound.filter(|_| !is_run) {
            return Err(RequestError::NotOf { option, of: "a walk" });
        }
        let looped = self.repeats.is_some();
        let both = [
            ("steps", self.steps.is_some(), "distance", self.distance.is_some()),
            ("loop", looped, "steps", self.steps.is_some()),
            ("loop", looped, "distance", self.distance.is_some()),
            ("loop", looped, "turn", self.turn != 0.0),
            ("loop", looped, "path", self.path.is_some()),
            ("loop", looped, "then", !self.then.is_empty()),
            ("loop", looped, "variability", self.variability.is_some()),
            ("loop", looped, "left", self.left.is_some()),
            ("loop", looped, "right", self.right.is_some()),
            ("loop", looped, "slope", self.slope.is_some()),
            ("loop", looped, "stairs", self.stairs.is_some()),
            ("loop", looped, "ground", self.ground.is_some()),
            ("loop", looped, "footholds", self.footholds.is_some()),
            ("loop", looped, "from", self.from != RunEndOptions::Running),
            ("loop", looped, "to", self.to != RunEndOptions::Running),
            ("slope", self.slope.is_some(), "stairs", self.stairs.is_some()),
            ("slope", self.slope.is_some(), "ground", self.ground.is_some()),
            ("slope", self.slope.is_some(), "footholds", self.footholds.is_some()),
            ("stairs", self.stairs.is_some(), "ground", self.ground.is_some()),
            ("stairs", self.stairs.is_some(), "footholds", self.footholds.is_some()),
            ("ground", self.ground.is_some(), "footholds", self.footholds.is_some()),
            ("stairs", self.stairs.is_some(), "steps", self.steps.is_some()),
            ("stairs", self.stairs.is_some(), "distance", self.distance.is_some()),
            ("footholds", self.footholds.is_some(), "steps", self.steps.is_some()),
            ("footholds", self.footholds.is_some(), "distance", self.distance.is_some()),
        ];
        match both.into_iter().find(|(_, one, _, other)| *one && *other) {
            Some((one, _, other, _)) => Err(RequestError::Both { one, other }),
            None => Ok(()),
        }
    }

    fn extent(&self, usual: usize, looped: usize) -> Extent {
        match (self.repeats, self.distance) {
            (Some(_), _) => Extent::Steps(looped),
            (None, Some(distance)) => Extent::Distance(distance),
            (None, None) => Extent::Steps(self.steps.unwrap_or(usual)),
        }
    }

    fn run(&self) -> Result<RunRequest, RequestError> {
        let bound = |end: RunEndOptions| match end {
            RunEndOptions::Running => RunEnd::Running,
            RunEndOptions::Standing => RunEnd::Standing,
            RunEndOptions::Walking(RunWalkOptions { steps, speed }) => {
                RunEnd::Walking(RunWalk { steps: steps.unwrap_or(RunWalk::default().steps), speed })
            }
        };
        let (from, to) = (bound(self.from), bound(self.to));
        let speed = self.speed.unwrap_or(DEFAULT_RUN_SPEED);
        let then = self.then.iter().map(|part| match *part {
            PartOptions { steps: Some(steps), speed: Some(speed), .. }
                if *part
                    == (PartOptions { steps: Some(steps), speed: Some(speed), ..PartOptions::default() }) =>
            {
                Ok(RunPart { steps, speed })
            }
            _ => {
                Err(RequestError::NotOf { option: "then", of: "a run, unless it has steps and speed alone" })
            }
        });
        let then: Vec<RunPart> = then.collect::<Result<_, _>>()?;
        let least = least_run_steps(speed, from, if then.is_empty() { to } else { RunEnd::Running });
        let extent = self.extent(STEPS.max(least), LOOPED[2]);
        let left_first = self.left_first.unwrap_or(false);
        let usual = RunRequest::default();
        let (forefoot, give) = (self.forefoot, self.give.unwrap_or(usual.give));
        Ok(RunRequest { speed, extent, then, from, to, left_first, forefoot, give, ..usual })
    }

    fn thesis(&self, count: usize, figure: &Figure) -> Result<ThesisRequest, GaitError> {
        let determinants = Determinants::ALL.into_iter().find(|known| known.count() == count);
        let determinants = determinants.ok_or_else(|| RequestError::Unknown {
            what: "number of determinants",
            name: count.to_string(),
            known: "it is 3 or 5".to_owned(),
        })?;
        let parameters = if self.style.is_empty() {
            Vec::new()
        } else {
            let proportions = Proportions::of(figure)?;
            self.numbers(&determinants.parameters(&proportions).iter().map(|parameter| parameter.name))?
        };
        Ok(ThesisRequest {
            determinants,
            step_frequency: self.step_frequency,
            step_length: self.step_length,
            speed: self.speed,
            extent: self.extent(STEPS, LOOPED[1]),
            parameters,
            left_first: self.left_first.unwrap_or(false),
            ..ThesisRequest::default()
        })
    }

    fn walk(&self, figure: &Figure) -> Result<Staged, RequestError> {
        let open = self.step_frequency.or(self.step_length).or(self.speed).is_none();
        let ground = self.on()?;
        let usual = ground.usual_step_frequency();
        let path = self.path.as_deref().map(WalkPath::through).transpose()?;
        let inner = self.turn > 0.0 || path.as_ref().is_some_and(|path| path.begins() > 0.0);
        let blend = |given: &Option<String>, of: fn(&str) -> Result<StyleSheet, RequestError>| {
            given.as_deref().map_or(Ok(StyleSheet::default()), of)
        };
        let first = WalkRequest {
            step_frequency: self.step_frequency.or(usual.filter(|_| open)),
            step_length: self.step_length,
            speed: self.speed,
            extent: self.extent(STEPS, LOOPED[0]),
            turn: self.turn,
            backward: self.backward,
            ground,
            path,
            left_first: self.left_first.unwrap_or(inner),
            cane_load: self.cane_load,
            parameters: self.numbers(&PARAMETERS.iter().map(|parameter| parameter.name))?,
            population: self.population.as_deref().map_or(Ok(Population::default()), population)?,
            sheet: blend(&self.manner, sheet_of)?,
            sides: [blend(&self.left, side_sheet_of)?, blend(&self.right, side_sheet_of)?],
            variability: self.variability.map(|scale| Variability { scale, seed: self.seed }),
            ..WalkRequest::default()
        };
        let first = if self.left_first.is_none() { first.helped_foot_first(figure) } else { first };
        let next: Vec<Next> = self.then.iter().map(next).collect::<Result<_, _>>()?;
        stages(&first, &next)
    }

    fn on(&self) -> Result<WalkGround, RequestError> {
        if let Some(slope) = self.slope {
            return Ok(WalkGround::Slope(slope));
        }
        if let Some(StairOptions { count, rise, tread }) = self.stairs {
            let usual = Stairs::default();
            return Ok(WalkGround::Stairs(Stairs {
                count: count.unwrap_or(usual.count),
                rise: rise.unwrap_or(usual.rise),
                tread: tread.unwrap_or(usual.tread),
            }));
        }
        if let Some(points) = &self.ground {
            return Relief::new(points.clone()).map(WalkGround::Relief).map_err(RequestError::Relief);
        }
        let Some(rows) = &self.footholds else { return Ok(WalkGround::Level) };
        let foothold = |(at, row): (usize, &Vec<f64>)| {
            if !(2..=4).contains(&row.len()) {
                let why =
                    format!("it has {} numbers; it must have 2 to 4: z, height, pitch, heading", row.len());
                return Err(RequestError::Foothold { number: at + 1, why });
            }
            let number = |i: usize| row.get(i).copied().unwrap_or_default();
            Ok(Foothold { x: None, z: number(0), height: number(1), pitch: number(2), heading: number(3) })
        };
        rows.iter().enumerate().map(foothold).collect::<Result<_, _>>().map(WalkGround::Footholds)
    }

    /// The style's numbers, by the names that are `known`.
    fn numbers(
        &self,
        known: &(impl Iterator<Item = &'static str> + Clone),
    ) -> Result<Vec<(&'static str, f64)>, RequestError> {
        let one = |(name, value): (&String, &f64)| {
            let dashed = name.replace('_', "-");
            match known.clone().find(|known| *known == dashed) {
                Some(name) => Ok((name, *value)),
                None => Err(unknown("style parameter", name, known)),
            }
        };
        self.style.iter().map(one).collect()
    }
}

fn population(name: &str) -> Result<Population, RequestError> {
    let known = Population::ALL.into_iter().find(|known| known.name() == name);
    known.ok_or_else(|| unknown("population", name, &Population::ALL.into_iter().map(Population::name)))
}

/// What is not known by its name, with what is.
pub(super) fn unknown(
    what: &'static str,
    name: &str,
    known: &(impl Iterator<Item = &'static str> + Clone),
) -> RequestError {
    let near = nearest(&name.replace('_', "-"), known.clone());
    let near = near.map_or_else(String::new, |near| format!("did you mean {near}? "));
    let known = format!("{near}there are {}", known.clone().collect::<Vec<_>>().join(", "));
    RequestError::Unknown { what, name: name.to_owned(), known }
}

fn next(part: &PartOptions) -> Result<Next, RequestError> {
    let PartOptions { steps, distance, stand, step_frequency, step_length, speed, turn, backward } = *part;
    let count = steps.unwrap_or_default();
    let walked = WalkPart { steps: count, step_frequency, step_length, speed, turn, backward };
    match (steps, distance, stand) {
        (None, None, Some(time)) if walked == WalkPart::default() => Ok(Next::Stand(time)),
        (None, None, Some(_)) => Err(RequestError::Both { one: "stand", other: "a pace or a turn" }),
        (Some(_), None, None) => Ok(Next::Steps(walked)),
        (None, Some(distance), None) => Ok(Next::Distance(distance, walked)),
        (None, None, None) => Err(RequestError::NothingNext),
        (Some(_), Some(_), _) => Err(RequestError::Both { one: "steps", other: "distance" }),
        (Some(_), None, Some(_)) => Err(RequestError::Both { one: "steps", other: "stand" }),
        (None, Some(_), Some(_)) => Err(RequestError::Both { one: "distance", other: "stand" }),
    }
}
