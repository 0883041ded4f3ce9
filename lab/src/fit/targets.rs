//! Targets of the fit: people's bands and what the bands do not see, as residuals that are zero inside.

use super::stride::{Case, Found};
use super::walk;
use solaris_gait::{Band, RECIPE_BANDS, Style, StyleTable};

/// Heights of the fit's person (m), step frequencies with their weights, and the same for steps a tenth shorter and longer.
const HEIGHT: f64 = 1.75;
const NORMAL: [(f64, f64); 12] = [
    (70.0, 0.3),
    (75.0, 0.5),
    (80.0, 6.0),
    (85.0, 1.5),
    (90.0, 2.0),
    (95.0, 5.0),
    (102.0, 1.0),
    (110.0, 8.0),
    (115.0, 2.0),
    (118.0, 1.5),
    (122.0, 0.8),
    (127.0, 0.4),
];
const STRETCHED: [(f64, f64); 4] = [(76.0, 0.4), (90.0, 0.5), (105.0, 0.5), (116.0, 0.4)];
/// The longest of the fast steps that are taken, with its stretch and weight.
const FASTEST: (f64, f64, f64) = (122.0, 1.08, 0.5);
/// Walks of so many steps at a step frequency, with what their friction, that of one foot, and their least knee (°) should keep.
const WALKS: [(f64, usize, [f64; 3]); 3] =
    [(80.0, 4, [0.18, 0.21, 2.0]), (117.0, 4, [0.36, 0.41, 2.5]), (124.0, 4, [0.43, 0.48, 2.0])];

/// A stride or a walk of the fit.
pub(crate) enum Target {
    Stride(Box<Stride>),
    Walk(Box<Case>, usize, [f64; 3]),
}

/// A stride of the fit.
pub(crate) struct Stride {
    case: Case,
    weight: f64,
    /// What the recipe's numbers come to.
    recipe: Found,
}

/// All strides and walks of the fit.
pub(crate) fn targets(recipe: &StyleTable) -> Result<Vec<Target>, String> {
    let normal = NORMAL.map(|(frequency, weight)| (frequency, 1.0, weight)).into_iter();
    let stretched = STRETCHED
        .iter()
        .flat_map(|(frequency, weight)| [0.9, 1.1].map(|stretch| (*frequency, stretch, *weight)));
    let cases: Vec<(f64, f64, f64)> = normal.chain(stretched).chain([FASTEST]).collect();
    let strides = cases.iter().map(|&(frequency, stretch, weight)| {
        let case = Case::new(HEIGHT, frequency, stretch)?;
        let recipe = Found::of(&case, recipe)?;
        Ok(Target::Stride(Box::new(Stride { case, weight, recipe })))
    });
    let walks = WALKS.iter().map(|&(frequency, steps, limits)| {
        Ok(Target::Walk(Box::new(Case::new(HEIGHT, frequency, 1.0)?), steps, limits))
    });
    // Walks take longest: they begin first.
    walks.chain(strides).collect()
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

impl Target {
    pub(crate) fn case(&self) -> &Case {
        match self {
            Self::Stride(stride) => &stride.case,
            Self::Walk(case, ..) => case,
        }
    }

    /// What is not as it should be.
    pub(crate) fn residuals(&self, table: &StyleTable) -> Result<Vec<f64>, String> {
        let all = match self {
            Self::Stride(stride) => stride.residuals(table)?,
            Self::Walk(case, steps, [both, one, knee]) => {
                let found = walk::needs(case, table, *steps)?;
                let all =
                    [above(found[0], *both, 0.02), above(found[1], *one, 0.02), above(*knee, found[2], 1.0)];
                all.map(|residual| huber(residual, 1.0)).to_vec()
            }
        };
        if let Some(i) = all.iter().position(|x| !x.is_finite()) {
            return Err(format!("residual {i} at {} steps/min is not a number", self.case().step_frequency));
        }
        Ok(all)
    }
}

impl Stride {
    fn residuals(&self, table: &StyleTable) -> Result<Vec<f64>, String> {
        let found = Found::of(&self.case, table)?;
        let limit = |limits: [f64; 3]| self.limit(limits);
        let mut all: Vec<f64> = RECIPE_BANDS.iter().map(|band| self.outside(band, &found)).collect();
        let others = [
            found.pitch.abs() / 0.5,
            above(found.early, 6e-3, 2e-3),
            above(found.free_moment, limit([9.5, 11.3, 16.0]), 0.8),
            above(12.6e-3, found.clearance, 1e-3),
            above(found.detour, limit([3.0, 0.5, 0.5]), 1.0),
            above(found.flank, limit([-4.0, -8.0, -12.0]), 1.5),
            above(3.5, found.knee, 0.7),
            above(found.friction.0, limit([0.13, 0.20, 0.27]), 0.01),
            above(found.friction.1, limit([0.19, 0.25, 0.36]), 0.01),
            above(found.notch, 0.8, 0.3),
            above(-1e-4, found.lowest, 1e-4),
        ];
        all.extend(others.map(|residual| huber(residual, 2.0)));
        all.extend(self.bounds(&self.case.style(table)));
        all.extend(found.curves.iter().zip(&self.recipe.curves).map(|(now, before)| (now - before) / 12.0));
        let root = self.weight.sqrt();
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
    /// A band that the recipe's stride lies in is to be kept; any other may stay out.
    fn outside(&self, band: &Band, found: &Found) -> f64 {
        let (lower, upper) = band.range;
        let (width, value) = (upper - lower, band.value(&found.steady));
        let inner = 0.04 * width;
        let distance = above(value, upper - inner, 0.05 * width) + above(lower + inner, value, 0.05 * width);
        if (lower..=upper).contains(&band.value(&self.recipe.steady)) {
            1.5 * huber(distance, 3.0)
        } else {
            weight(band, self.case.step_frequency) * huber(distance, 1.0)
        }
    }

    /// What the style's own numbers must keep: trunk and arms as people move them, toes up at contact, and a centre of pressure that goes forward.
    fn bounds(&self, style: &Style) -> Vec<f64> {
        let bend = style.thorax_bend_sin.hypot(style.thorax_bend_cos);
        let upper = [
            (style.arm_swing, self.limit([11.0, 24.0, 29.0])),
            (style.thorax_yaw, 7.0),
            (bend, 6.2),
            (style.thorax_lean, 3.0),
            (-style.thorax_lean, 3.0),
            (-style.heel_strike_angle, -self.limit([13.0, 15.5, 18.0])),
        ];
        let width = style.step_width * HEIGHT / self.case.height;
        let widths = [above(0.1, width, 4e-3), above(width, 0.13, 4e-3)];
        let cop = [0.56 * style.cop_forward, style.cop_heel_off, style.cop_40, style.cop_50, 0.94];
        let angles = upper.map(|(value, most)| above(value.to_degrees(), most, 0.5));
        let order = cop.windows(2).map(|pair| above(0.004, pair[1] - pair[0], 0.004));
        // Where the heel has risen, the foot is pressed on its ball.
        let ball = above(0.735, style.cop_heel_off, 4e-3);
        angles.into_iter().chain(widths).chain(order).chain([ball]).collect()
    }
}

/// People who walk slowly rise less than the band says, and press less.
fn weight(band: &Band, frequency: f64) -> f64 {
    match band.name {
        "CoM rise" if frequency < 90.0 => 0.3,
        "CoM rise" => 3.0,
        "first vertical peak" if frequency < 82.0 => 0.6,
        _ => 0.8,
    }
}
