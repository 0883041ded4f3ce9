//! Targets of the fit: people's bands and what the bands do not see, as residuals that are zero inside.

use super::measured::Measured;
use super::stride::{Case, Found};
use solaris_gait::people::{Beside, PHASES};
use solaris_gait::{Band, RECIPE_BANDS, Style, StyleTable, TEXTBOOK_BANDS};

/// Heights of the fit's person (m), step frequencies with their weights, and the same for steps a tenth shorter and longer.
const HEIGHT: f64 = 1.75;
const NORMAL: [(f64, f64); 12] = [
    (75.0, 2.0),
    (80.0, 6.0),
    (85.0, 2.0),
    (90.0, 2.0),
    (95.0, 5.0),
    (102.0, 1.5),
    (110.0, 6.0),
    (115.0, 3.0),
    (118.0, 3.0),
    (120.0, 3.0),
    (125.0, 0.6),
    (130.0, 0.5),
];
/// The same for other heights.
const OTHERS: [(f64, f64, f64); 12] = [
    (1.55, 80.0, 3.0),
    (1.55, 90.0, 3.0),
    (1.55, 100.0, 3.0),
    (1.55, 110.0, 4.0),
    (1.55, 120.0, 3.0),
    (1.55, 130.0, 0.6),
    (1.90, 80.0, 3.0),
    (1.90, 90.0, 3.0),
    (1.90, 100.0, 3.0),
    (1.90, 110.0, 4.0),
    (1.90, 115.0, 3.0),
    (1.90, 120.0, 3.0),
];
/// Weight of the measured person.
const MEASURED: f64 = 18.0;
const STRETCHED: [(f64, f64); 4] = [(84.0, 0.4), (90.0, 0.5), (105.0, 0.5), (116.0, 0.4)];
/// The longest of the fast steps that are taken, with its stretch and weight.
const FASTEST: (f64, f64, f64) = (122.0, 1.08, 0.5);
/// Least flexion of the knee that the push is told to go through (°).
const LEAST_PUSH: f64 = 6.0;
/// Least place of the centre of pressure as the other foot lands (of the foot's length).
const LEAST_AHEAD: f64 = 0.79;
/// Weight of each of people's curves, beside a band.
const CURVES: f64 = 3.0;
/// A stride of the fit.
pub(crate) struct Stride {
    case: Case,
    weight: f64,
    measured: Option<Measured>,
    /// Whether people's curves are targets.
    curves: bool,
    /// What the recipe's numbers come to.
    recipe: Found,
}

/// All strides of the fit.
pub(crate) fn targets(recipe: &StyleTable, beside: super::Beside) -> Result<Vec<Stride>, String> {
    let normal = NORMAL.map(|(frequency, weight)| (frequency, 1.0, weight)).into_iter();
    let stretched = STRETCHED
        .iter()
        .flat_map(|(frequency, weight)| [0.9, 1.1].map(|stretch| (*frequency, stretch, *weight)));
    let own = normal.chain(stretched).chain([FASTEST]);
    let own = own.map(|(frequency, stretch, weight)| (HEIGHT, frequency, stretch, weight));
    let others = OTHERS.iter().map(|&(height, frequency, weight)| (height, frequency, 1.0, weight));
    let curves = beside == super::Beside::BandsAndCurves;
    let mut strides = Vec::new();
    for (height, frequency, stretch, weight) in own.chain(others) {
        let case = Case::new(height, frequency, stretch)?;
        let recipe = Found::of(&case, recipe)?;
        strides.push(Stride { case, weight, measured: None, curves, recipe });
    }
    if let Some(measured) = Measured::read()? {
        let case = measured.case.clone();
        let recipe = Found::of(&case, recipe)?;
        let (weight, measured) = (MEASURED, Some(measured));
        strides.push(Stride { case, weight, measured, curves, recipe });
    }
    Ok(strides)
}

/// By how much a value is above a limit, in units of `one`.
fn above(value: f64, limit: f64, one: f64) -> f64 {
    ((value - limit) / one).max(0.0)
}

/// What has a square that grows like a square up to a bound, and like the distance beyond it (Huber): what cannot be met does
/// not push out what can.
fn huber(distance: f64, bound: f64) -> f64 {
    if distance.abs() <= bound { distance } else { (bound * (2.0 * distance.abs() - bound)).sqrt() }
}

/// The bands of the fit: textbooks' but for double support, which is a law's, and those of the recipe besides.
fn textbook() -> impl Iterator<Item = &'static Band> {
    let inner = RECIPE_BANDS.iter().filter(|band| TEXTBOOK_BANDS.iter().all(|other| other.name != band.name));
    TEXTBOOK_BANDS.iter().filter(|band| band.name != "one double support").chain(inner)
}

impl Stride {
    pub(crate) fn case(&self) -> &Case {
        &self.case
    }

    /// What residual `i` is about.
    pub(crate) fn name(&self, i: usize) -> String {
        const OTHERS: [&str; 18] = [
            "pitch",
            "early",
            "free moment",
            "clearance",
            "detour",
            "flank",
            "knee",
            "friction",
            "foot's friction",
            "notch",
            "lowest",
            "inward mid",
            "inward most",
            "toes",
            "pressed behind",
            "F1",
            "valley",
            "F2",
        ];
        const BOUNDS: [&str; 14] = [
            "arm",
            "yaw",
            "bend",
            "lean",
            "lean back",
            "pitch bound",
            "narrow",
            "wide",
            "cop",
            "cop",
            "cop",
            "cop",
            "push",
            "ahead",
        ];
        let bands = textbook().count();
        if self.measured.is_some() {
            return format!("curve {i}");
        }
        textbook().nth(i).map_or_else(
            || {
                let i = i - bands;
                let others = OTHERS.get(i).or_else(|| BOUNDS.get(i.wrapping_sub(OTHERS.len())));
                others.map_or_else(|| format!("other {i}"), |name| (*name).to_owned())
            },
            |band| band.name.to_owned(),
        )
    }

    /// What is not as it should be.
    pub(crate) fn residuals(&self, table: &StyleTable) -> Result<Vec<f64>, String> {
        let all = self.distances(table)?;
        if let Some(i) = all.iter().position(|x| !x.is_finite()) {
            return Err(format!("residual {i} at {} steps/min is not a number", self.case.step_frequency));
        }
        Ok(all)
    }

    fn distances(&self, table: &StyleTable) -> Result<Vec<f64>, String> {
        let found = Found::of(&self.case, table)?;
        let limit = |limits: [f64; 3]| self.limit(limits);
        let root = self.weight.sqrt();
        if let Some(measured) = &self.measured {
            let angles = measured.differences(&found.curves);
            let angles = angles.iter().map(|difference| difference / 4.0);
            let loads =
                found.vertical.iter().zip(&measured.vertical).map(|(ours, theirs)| (ours - theirs) / 7.0);
            return Ok(angles.chain(loads).map(|residual| root * 0.5 * huber(residual, 2.0)).collect());
        }
        let mut all: Vec<f64> = textbook().map(|band| self.outside(band, &found)).collect();
        let others = [
            2.0 * found.pitch.abs(),
            above(found.early, 6e-3, 2e-3),
            above(found.free_moment, limit([9.5, 11.3, 16.0]), 1.6),
            above(limit([12.1e-3, 6.5e-3, 2.5e-3]) * self.case.height / HEIGHT, found.clearance, 1e-3),
            above(found.detour, limit([3.0, 0.5, 0.5]), 1.0),
            above(found.flank, limit([-4.0, -8.0, -12.0]), 1.5),
            above(3.5, found.knee, 0.7),
            above(found.friction.0, limit([0.13, 0.20, 0.27]), 0.01),
            above(found.friction.1, limit([0.19, 0.25, 0.36]), 0.01),
            above(found.notch, limit([0.9, 2.4, 4.6]), 0.4),
            above(-1e-4, found.lowest, 1e-4),
            above(4.2, found.inward.0, 0.5),
            above(found.inward.1, 6.6, 0.5),
            above(found.toes, limit([36.0, 37.0, 42.0]), 4.0),
            above(found.behind_ball, 0.0, 1e-3),
            (found.steady.first_peak - limit([101.5, 107.0, 119.0])) / 3.0,
            (found.steady.valley - limit([84.0, 77.0, 66.0])) / 3.0,
            (found.steady.second_peak - limit([102.0, 108.5, 117.0])) / 3.0,
        ];
        all.extend(others.map(|residual| huber(residual, 2.0)));
        all.extend(self.bounds(&self.case.style(table)));
        all.extend(found.curves.iter().zip(&self.recipe.curves).map(|(now, before)| (now - before) / 30.0));
        if self.curves {
            all.extend(found.beside.iter().flat_map(beside_people));
        }
        Ok(all.into_iter().map(|residual| root * residual).collect())
    }

    /// Linear between (80, a), (110, b) and (130, c) steps/min.
    fn limit(&self, [a, b, c]: [f64; 3]) -> f64 {
        let frequency = self.case.step_frequency;
        if frequency < 110.0 {
            a + (b - a) * ((frequency - 80.0) / 30.0).max(0.0)
        } else {
            b + (c - b) * (frequency - 110.0) / 20.0
        }
    }

    /// Distance outside a band that is a little narrower, in parts of its width.
    ///
    fn outside(&self, band: &Band, found: &Found) -> f64 {
        let (lower, upper) = band.range;
        let (width, value) = (upper - lower, band.value(&found.steady));
        let inner = 0.04 * width;
        let distance = above(value, upper - inner, 0.05 * width) + above(lower + inner, value, 0.05 * width);
        weight(band, self.case.step_frequency) * huber(distance, 2.0)
    }

    /// What the style's own numbers must keep: trunk and arms as people move them, toes up at contact, and a centre of pressure that goes forward.
    fn bounds(&self, style: &Style) -> Vec<f64> {
        let bend = style.thorax_bend_sin.hypot(style.thorax_bend_cos);
        let upper = [
            (style.arm_swing, self.limit([9.0, 17.0, 21.0])),
            (style.thorax_yaw, 3.0),
            (bend, 3.5),
            (style.thorax_lean, 3.0),
            (-style.thorax_lean, 3.0),
            (-style.heel_strike_angle, -self.limit([13.0, 15.5, 18.0])),
        ];
        let width = style.step_width * HEIGHT / self.case.height;
        let widths = [above(0.1, width, 4e-3), above(width, 0.13, 4e-3)];
        let cop = [0.56 * style.cop_forward, style.cop_middle, style.cop_40, style.cop_50, 0.94];
        let angles = upper.map(|(value, most)| above(value.to_degrees(), most, 0.5));
        let order = cop.windows(2).map(|pair| above(0.004, pair[1] - pair[0], 0.004));
        // Where the other foot lands it swings the pressure to and fro, which is not to come behind the ball.
        let ahead = above(LEAST_AHEAD, style.cop_50, 4e-3);
        // A knee that hardly bends as its heel rises passes straight where a manner bends it less.
        let push = above(LEAST_PUSH, style.knee_push.to_degrees(), 0.4);
        angles.into_iter().chain(widths).chain(order).chain([push, ahead]).collect()
    }
}

/// What people's curves of a stride ask for, in one and a half of their deviations: angles and forces, and the course of the ankle's moment. Hip and tilt are told
/// against another plane, so that only their shapes count.
fn beside_people(Beside { people, values }: &Beside) -> Vec<f64> {
    let part = (CURVES / PHASES as f64).sqrt();
    if people.name == "Ankle dorsiflexion: moment" {
        // A moment grows with the leg: where the foot is pressed shows in its way to its greatest.
        let most = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        let (ours, theirs) = (most(values), most(&people.mean));
        let each = values.iter().zip(&people.mean).zip(&people.deviation);
        return each
            .map(|((value, mean), deviation)| {
                part * huber((value / ours - mean / theirs) / (1.5 * (deviation / theirs).max(0.06)), 2.0)
            })
            .collect();
    }
    if !["°", "%BW"].contains(&people.unit) {
        return Vec::new();
    }
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let shape_only = ["Hip flexion", "Pelvis tilt"].contains(&people.name);
    let level = if shape_only { mean(&values[1..]) - mean(&people.mean[1..]) } else { 0.0 };
    let least = if people.unit == "°" { 2.0 } else { 2.5 };
    let each = values.iter().zip(&people.mean).zip(&people.deviation);
    each.map(|((value, mean), deviation)| {
        part * huber((value - level - mean) / (1.5 * deviation.max(least)), 2.0)
    })
    .collect()
}

/// People who walk slowly rise less than the band says, and press less.
fn weight(band: &Band, frequency: f64) -> f64 {
    match band.name {
        "CoM rise" if frequency < 79.0 => 0.3,
        "CoM rise" => 2.6,
        "first vertical peak" if frequency < 79.0 => 0.9,
        "first vertical peak"
        | "knee in stance"
        | "ankle plantarflexor moment"
        | "hip flexor moment"
        | "hip abductor moment" => 1.8,
        _ => 1.2,
    }
}
