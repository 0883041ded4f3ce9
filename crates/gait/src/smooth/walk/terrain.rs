//! Where feet are set down on ground that is not level.

use super::course::Step;
use crate::body::LegGeometry;
use crate::error::{GaitError, PlanError, RequestError};
use crate::request::pace::range;
use crate::request::{Stairs, WalkGround};
use crate::smooth::slope::step_length_on_slope;
use crate::smooth::stair_numbers::nosing;
use crate::smooth::stairs::STAIRS;
use crate::smooth::variant::StyleVariant;
use solaris_model::Relief;

/// How a step is gone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum StepKind {
    /// Along a line of this slope (rad), in the style of level steps of this length (m).
    Slope(f64, f64),
    /// From a tread to the next one, which is so much higher and so far ahead (m).
    Stairs { rise: f64, tread: f64 },
}

/// Which way to go over ground, of those that are tried.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Way {
    /// In the second way: edges of a relief as stairs, footholds in the style of the slope around them.
    pub(crate) otherwise: bool,
    pub(crate) easing: Easing,
    /// In which style, of those on slopes and stairs.
    pub(crate) style: &'static StyleVariant,
}

impl Way {
    pub(crate) const USUAL: Self =
        Self { otherwise: false, easing: Easing::NONE, style: &StyleVariant::USUAL };
}

/// By which parts the second step and the last three, the last one first, last longer than the others: who stops at once after a step as long as
/// the others presses hard, and takes time for it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Easing {
    second: f64,
    last: [f64; 3],
}

impl Easing {
    pub(crate) const NONE: Self = Self { second: 0.0, last: [0.0; 3] };
    /// From the least on.
    pub(crate) const ALL: [Self; 4] = [
        Self { second: 0.0, last: [0.15, 0.0, 0.0] },
        Self { second: 0.0, last: [0.30, 0.15, 0.0] },
        Self { second: 0.15, last: [0.60, 0.30, 0.0] },
        Self { second: 0.15, last: [0.90, 0.45, 0.20] },
    ];

    pub(crate) fn eases_beginnings(&self) -> bool {
        self.second > 0.0
    }

    /// Of fewer steps than have a middle only the last one is eased.
    fn ease(&self, steps: &mut [Step]) {
        let last = if steps.len() > LEAD { &self.last[..] } else { &self.last[..1] };
        steps.iter_mut().rev().zip(last).for_each(|(step, slower)| step.slower = *slower);
        if steps.len() > 2 * LEAD {
            steps[1].slower = self.second;
        }
    }
}

/// Steps over ground that is not level.
#[derive(Clone, Debug)]
pub(crate) struct Terrain {
    pub(crate) relief: Relief,
    pub(crate) steps: Vec<Step>,
    /// How each step is gone.
    pub(crate) kinds: Vec<StepKind>,
    /// Pitch of the ground under the standing feet (rad).
    pub(crate) standing: f64,
}

/// Level steps before and after stairs.
pub(crate) const LEAD: usize = 3;
/// How much shorter these steps are than elsewhere: the body is as slow before the stairs as on them, and gains speed after them.
pub(super) const BEFORE_UP: [f64; LEAD] = [0.85, 0.75, 0.65];
pub(super) const BEFORE_DOWN: [f64; LEAD] = [0.85, 0.68, 0.50];
pub(super) const AFTER_STAIRS: [f64; LEAD] = [0.60, 0.85, 0.85];
/// How much shorter the first steps are up a slope and down one, over the slope (1/rad), and the last ones, from the last one on: soles
/// hold less there, and uphill people gain their speed in a few steps.
const SHORTER_FIRST: [[f64; 4]; 2] = [[1.8, 1.5, 1.0, 0.5], [1.5, 0.0, 0.0, 0.0]];
const SHORTER_LAST: [[f64; 4]; 2] = [[0.5, 0.8, 0.6, 0.3], [0.8, 0.8, 0.0, 0.0]];
/// How far a slope's ground is known before the walk and after it (m).
pub(super) const AROUND: f64 = 3.0;
/// The most by which the ground may stand above the line from heel to tip, and below it (m).
const BUMP: f64 = 5e-4;
const HOLLOW: f64 = 0.02;
/// Edges so near to an end of the sole are under it (m).
pub(super) const EDGE: f64 = 1e-3;
/// So far before and behind a sole the ground may stand no more than so much above its line (m): feet swing low there.
const CLEAR: (f64, f64) = (0.08, 0.03);
/// So far behind a heel the ground may lie no more than so much below its line (m): it comes in low over the edge.
const FROM_EDGE: (f64, f64) = (0.06, 0.03);
/// How far behind a heel edges stand: so far (m) and so many times their height, lower ones than this do not matter (m), nor those farther off (m).
const FROM_RISER: (f64, f64, f64, f64) = (0.05, 1.2, 0.008, 0.30);
/// The steepest ground that a foot is set on (rad), and the steepest step (rad).
const STEEPEST_PRINT: f64 = 16.0 * std::f64::consts::PI / 180.0;
const STEEPEST_STEP: f64 = 16.0 * std::f64::consts::PI / 180.0;
/// How many steps before an edge are adapted to it, by which factors, and one alone; in which strides a place is looked for (m).
const ADAPTED: usize = 3;
const STRETCHED: (f64, f64) = (0.75, 1.06);
const STRETCHED_ALONE: (f64, f64) = (0.5, 1.06);
const LOOKS_BY: f64 = 0.005;

impl Terrain {
    /// Over `ground`, for level steps `levels` of a pace whose steps are `usual` long and whose feet are `width` apart (m); `None` on level ground.
    /// `mirrored`: the left foot goes first, and all is planned the other way.
    pub(crate) fn of(
        ground: &WalkGround,
        leg: &LegGeometry,
        (usual, width): (f64, f64),
        levels: &[Step],
        mirrored: bool,
        way: Way,
    ) -> Result<Option<Self>, GaitError> {
        let found = Self::in_way(ground, leg, (usual, width), levels, [mirrored, way.otherwise])?;
        Ok(found.map(|mut terrain| {
            way.easing.ease(&mut terrain.steps);
            terrain
        }))
    }

    fn in_way(
        ground: &WalkGround,
        leg: &LegGeometry,
        (usual, width): (f64, f64),
        levels: &[Step],
        [mirrored, otherwise]: [bool; 2],
    ) -> Result<Option<Self>, GaitError> {
        match ground {
            WalkGround::Level => Ok(None),
            WalkGround::Slope(slope) => Self::on_slope(*slope, usual, levels).map(Some),
            WalkGround::Stairs(stairs) => Self::on_stairs(stairs, leg, usual, levels).map(Some),
            WalkGround::Relief(relief) if otherwise => {
                let found = Self::over_edges(relief, leg, usual, levels);
                found.map(Some).ok_or_else(|| PlanError::NoFoothold { step: 0, place: 0.0 }.into())
            }
            WalkGround::Relief(relief) => Self::on_relief(relief, leg, usual, levels).map(Some),
            WalkGround::Footholds(footholds) => {
                Self::on_footholds(footholds, leg, (usual, width), [mirrored, otherwise]).map(Some)
            }
        }
    }

    /// How long the `i`-th of `n` steps on a slope is, over what it is on level ground and the slope's own factor.
    pub(crate) fn part_on_slope(slope: f64, i: usize, n: usize) -> f64 {
        let down = usize::from(slope < 0.0);
        let shorter = |by: &[[f64; 4]; 2], i: usize| by[down].get(i).map_or(0.0, |by| by * slope.abs());
        1.0 - shorter(&SHORTER_FIRST, i).max(shorter(&SHORTER_LAST, n - 1 - i))
    }

    fn on_slope(slope: f64, usual: f64, levels: &[Step]) -> Result<Self, GaitError> {
        let steps: Vec<Step> = levels
            .iter()
            .enumerate()
            .map(|(i, step)| {
                let part = Self::part_on_slope(slope, i, levels.len());
                let length = step.length * step_length_on_slope(slope) * part;
                Step { length, rise: length * slope.tan(), tilt: slope, ..*step }
            })
            .collect();
        let end = steps.iter().map(|step| step.length).sum::<f64>() + AROUND;
        let points = vec![[-AROUND, -AROUND * slope.tan()], [end, end * slope.tan()]];
        let relief = Relief::new(points).map_err(RequestError::Relief)?;
        let kinds = vec![StepKind::Slope(slope, usual); steps.len()];
        Ok(Self { relief, steps, kinds, standing: slope })
    }

    fn on_stairs(stairs: &Stairs, leg: &LegGeometry, usual: f64, levels: &[Step]) -> Result<Self, GaitError> {
        let Stairs { count, rise, tread } = *stairs;
        let (rises, treads) = STAIRS;
        range("rise", rise.abs(), " m", rises, || " up or down".to_owned())?;
        range("tread", tread, " m", treads, String::new)?;
        let (mut steps, mut kinds, mut points, mut z) = (Vec::new(), Vec::new(), vec![[-AROUND, 0.0]], 0.0);
        for (i, level) in levels.iter().enumerate() {
            let on_stairs = (LEAD..LEAD + count).contains(&i);
            let length = match i {
                _ if on_stairs => tread,
                i if i < LEAD => level.length * if rise > 0.0 { BEFORE_UP[i] } else { BEFORE_DOWN[i] },
                i => level.length * AFTER_STAIRS[i - LEAD - count],
            };
            if on_stairs {
                let above = (i - LEAD) as f64 * rise;
                let print = if rise > 0.0 { z + length } else { z };
                let nosing = print + nosing(rise, tread, leg.foot_length());
                points.extend([[nosing, above], [nosing, above + rise]]);
            }
            z += length;
            steps.push(Step { length, rise: if on_stairs { rise } else { 0.0 }, tilt: 0.0, ..*level });
            kinds.push(if on_stairs {
                StepKind::Stairs { rise, tread }
            } else {
                StepKind::Slope(0.0, length.min(usual))
            });
        }
        points.push([z + AROUND, count as f64 * rise]);
        let relief = Relief::new(points).map_err(RequestError::Relief)?;
        Ok(Self { relief, steps, kinds, standing: 0.0 })
    }

    /// How long the steps over ground are, in the first way or the other one, over what these level ones of a pace whose steps are `usual` long (m) are; `None` where
    /// a foot finds no place.
    pub(crate) fn parts_on_ground(
        (ground, otherwise): (&WalkGround, bool),
        leg: &LegGeometry,
        usual: f64,
        levels: &[Step],
    ) -> Option<Vec<f64>> {
        // How far apart feet are makes no difference along the way.
        let found = Self::in_way(ground, leg, (usual, 0.0), levels, [false, otherwise]).ok()??;
        Some(found.steps.iter().zip(levels).map(|(step, level)| step.length / level.length).collect())
    }

    fn on_relief(relief: &Relief, leg: &LegGeometry, usual: f64, levels: &[Step]) -> Result<Self, GaitError> {
        let length = leg.foot_length();
        let standing = Foothold::at(relief, 0.0, length);
        let from = relief.height(0.0);
        if !standing.holds() {
            return Err(PlanError::NoFoothold { step: 0, place: 0.0 }.into());
        }
        // Places of the heels, and what is found there.
        let mut places = vec![(0.0, standing)];
        for (i, level) in levels.iter().enumerate() {
            let (z, before) = places[i];
            // As long as people's on the slope that it goes over.
            let mut reach = level.length;
            for _ in 0..4 {
                let slope = (Foothold::at(relief, z + reach, length).height - before.height).atan2(reach);
                reach = level.length * step_length_on_slope(slope);
            }
            places.push((z + reach, Foothold::at(relief, z + reach, length)));
            if !fits(&places) && !fit_last(relief, length, &mut places) {
                return Err(PlanError::NoFoothold { step: i + 1, place: z + reach }.into());
            }
        }
        let (mut steps, mut kinds) = (Vec::new(), Vec::new());
        for (pair, level) in places.windows(2).zip(levels) {
            let [(z, before), (next, foothold)] = [pair[0], pair[1]];
            let (ahead, rise) = (next - z, foothold.height - before.height);
            let slope = rise.atan2(ahead);
            let shorter = ahead / (level.length * step_length_on_slope(slope));
            kinds.push(StepKind::Slope(slope, if shorter < 0.97 { usual * shorter } else { usual }));
            steps.push(Step { length: ahead, rise, tilt: foothold.tilt, ..*level });
        }
        let points = relief.points().iter().map(|[z, y]| [*z, y - from]).collect();
        let relief = Relief::new(points).map_err(RequestError::Relief)?;
        Ok(Self { relief, steps, kinds, standing: standing.tilt })
    }
}

/// Whether the last foot finds a place, and not too far above or below the one before.
fn fits(places: &[(f64, Foothold)]) -> bool {
    let [.., (z, before), (next, foothold)] = places else { return true };
    foothold.holds() && (foothold.height - before.height).atan2(next - z).abs() <= STEEPEST_STEP
}

/// Stretches or shortens the last steps alike, as many as help and by as little as does, until the last foot finds a place.
fn fit_last(relief: &Relief, length: f64, places: &mut Vec<(f64, Foothold)>) -> bool {
    let last = places.len() - 1;
    for count in (1..=ADAPTED.min(last)).rev() {
        let first = last - count;
        let (z, end) = (places[first].0, places[last].0);
        let (shortest, longest) = if count > 1 { STRETCHED } else { STRETCHED_ALONE };
        let most = ((end - z) * (1.0 - shortest) / LOOKS_BY) as i32;
        for shift in (1..=most).flat_map(|i| [-i, i]) {
            let factor = 1.0 + f64::from(shift) * LOOKS_BY / (end - z);
            if factor > longest {
                continue;
            }
            let mut tried = places.clone();
            for place in &mut tried[first + 1..] {
                place.0 = z + (place.0 - z) * factor;
                place.1 = Foothold::at(relief, place.0, length);
            }
            if (first + 1..=last).all(|i| fits(&tried[..=i])) {
                *places = tried;
                return true;
            }
        }
    }
    false
}

/// The points of a relief between two places along z, without those at them.
fn points_between(relief: &Relief, from: f64, to: f64) -> &[[f64; 2]] {
    let points = relief.points();
    let [first, end] =
        [points.partition_point(|point| point[0] <= from), points.partition_point(|point| point[0] < to)];
    points.get(first..end).unwrap_or_default()
}

/// A place for a foot.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foothold {
    /// Height at the heel (m), on the line that the sole lies on.
    pub(super) height: f64,
    /// Pitch of that line (rad).
    pub(super) tilt: f64,
    /// The most by which the ground stands above it and lies below it (m).
    above: f64,
    below: f64,
    /// Whether something stands close before it or behind it, or it begins at an edge.
    blocked: bool,
}

impl Foothold {
    /// With the heel at `z`, for a sole of this length (m).
    pub(super) fn at(relief: &Relief, z: f64, length: f64) -> Self {
        let heel = relief.height(z);
        let mut tilt = 0.0;
        // The sole is as long on a slope, too.
        for _ in 0..3 {
            let reach = length * f64::cos(tilt);
            tilt = (relief.height(z + reach) - heel).atan2(reach);
        }
        let reach = length * tilt.cos();
        let line = |at: f64| heel + (at.clamp(z, z + reach) - z) * tilt.tan();
        let inside = points_between(relief, z - EDGE, z + length + EDGE);
        let (above, below) = inside.iter().fold((0.0_f64, 0.0_f64), |(above, below), [at, height]| {
            let gap = height - line(*at);
            (above.max(gap), below.max(-gap))
        });
        let ends = [(z - 0.5 * CLEAR.0, z), (z + reach + 0.5 * CLEAR.0, z + reach)];
        let stands = |&(at, end): &(f64, f64)| relief.highest_near(at, 0.5 * CLEAR.0) > line(end) + CLEAR.1;
        let (from_edge, drop) = FROM_EDGE;
        let falls = relief.lowest_near(z - 0.5 * from_edge, 0.5 * from_edge) < heel - drop;
        let (near, times, least, far) = FROM_RISER;
        let passed = |&[at, height]: &[f64; 2]| {
            let above = height - heel - (at - z) * tilt.tan();
            above > least && z - at < near + times * above
        };
        let behind = points_between(relief, z - far, z - EDGE);
        let blocked = falls || ends.iter().any(stands) || behind.iter().any(passed);
        Self { height: heel, tilt, above, below, blocked }
    }

    pub(super) fn holds(&self) -> bool {
        !self.is_rough() && self.tilt.abs() <= STEEPEST_PRINT
    }

    fn is_rough(&self) -> bool {
        self.above > BUMP || self.below > HOLLOW || self.blocked
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_are_eased_where_there_are_any() {
        let slower = |count: usize| {
            let mut steps = vec![Step::along_an_arc(0, 0.7, 0.0); count];
            Easing::ALL[3].ease(&mut steps);
            steps.iter().map(|step| step.slower).collect::<Vec<f64>>()
        };
        assert_eq!(slower(1), [0.9]);
        assert_eq!(slower(3), [0.0, 0.0, 0.9]);
        assert_eq!(slower(5), [0.0, 0.0, 0.2, 0.45, 0.9]);
        assert_eq!(slower(8), [0.0, 0.15, 0.0, 0.0, 0.0, 0.2, 0.45, 0.9]);
    }

    #[test]
    fn a_foot_does_not_stand_across_a_kerb() {
        let kerb = Relief::new(vec![[1.0, 0.0], [1.0, 0.1]]).expect("a relief");
        assert!(Foothold::at(&kerb, 0.9, 0.26).is_rough());
        assert!(!Foothold::at(&kerb, 1.07, 0.26).is_rough() && !Foothold::at(&kerb, 0.6, 0.26).is_rough());
        assert!(Foothold::at(&kerb, 0.7, 0.26).is_rough());
        // Nor with its heel at the edge, above or below.
        assert!(Foothold::at(&kerb, 1.02, 0.26).is_rough());
        let down = Relief::new(vec![[1.0, 0.1], [1.0, 0.0]]).expect("a relief");
        assert!(Foothold::at(&down, 1.15, 0.26).is_rough() && !Foothold::at(&down, 1.19, 0.26).is_rough());
        let low = Relief::new(vec![[1.0, 0.02], [1.0, 0.0]]).expect("a relief");
        assert!(Foothold::at(&low, 1.06, 0.26).is_rough() && !Foothold::at(&low, 1.09, 0.26).is_rough());
        let ramp = Relief::new(vec![[0.0, 0.0], [2.0, 0.2]]).expect("a relief");
        let foothold = Foothold::at(&ramp, 0.5, 0.26);
        assert!((foothold.tilt - 0.1_f64.atan()).abs() < 1e-12 && (foothold.height - 0.05).abs() < 1e-12);
    }
}
