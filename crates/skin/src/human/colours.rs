//! What a person wears: where in the palette each place of the body is.

use super::head::HAIRLINE;
use super::sizes::Sizes;
use super::{ARMS, LEGS};
use crate::palette::COLOURS;
use nalgebra::{Isometry3, Vector3};

/// Borders between colours, from the soles up.
pub(super) struct Clothes {
    /// Heights of the shoes' and the trousers' borders (m).
    shoe: f64,
    waist: f64,
    /// Where the sleeves end and which way the arm goes on (m).
    sleeves: [(Vector3<f64>, Vector3<f64>); 2],
    /// A point of the neck's axis, the collar's radius and what is below all of it (m).
    collar: (Vector3<f64>, f64, f64),
    /// Over this all is skin (m).
    throat: f64,
    head: Isometry3<f64>,
    /// Of the head, and of the body.
    size: Vector3<f64>,
    tall: f64,
    /// Half of the thinnest that cells about the eyes show (m).
    least: f64,
}

/// A colour's part of the strip that a border is spread over is as long as this on the body (m): some cells, so that between
/// vertices the place in the strip goes evenly where the border is.
const SPREAD: f64 = 0.11;
const SPREAD_HEAD: f64 = 0.030;
const SPREAD_BROW: f64 = 0.012;

impl Clothes {
    /// `cell`: how long cells are about the eyes (m).
    pub(super) fn of(sizes: &Sizes<'_>, cell: f64) -> Self {
        let sleeve = |arm: &str| {
            let place = sizes.place(arm);
            let along = place.rotation * -Vector3::y();
            (place.translation.vector + along * (0.62 * sizes.length(arm)), along)
        };
        let tall = sizes.tall;
        let neck = Vector3::new(0.0, 0.0, -0.026 * tall);
        Self {
            shoe: sizes.joint("left_foot").y + 0.012 * tall,
            waist: sizes.height(0.048),
            sleeves: ["left_upper_arm", "right_upper_arm"].map(sleeve),
            collar: (neck, 0.080 * sizes.thick("neck").0.max(tall), sizes.height(0.385)),
            throat: sizes.height(0.48),
            head: sizes.place("head"),
            size: sizes.head(),
            tall,
            least: 0.6 * cell,
        }
    }

    /// The place in the palette of a point of a group.
    pub(super) fn place(&self, p: &Vector3<f64>, group: usize) -> f32 {
        let step = |way: f64, spread: f64| (way / (spread * self.tall) + 0.5).clamp(0.0, 1.0);
        let place = if LEGS.contains(&group) {
            step(p.y - self.shoe, SPREAD) + step(p.y - self.waist, SPREAD)
        } else if let Some(i) = ARMS.iter().position(|arm| *arm == group) {
            let (end, along) = self.sleeves[i];
            2.0 + step(along.dot(&(p - end)), SPREAD)
        } else {
            let (neck, radius, least) = self.collar;
            let collar =
                (radius - (p.x - neck.x).hypot(p.z - neck.z)).min(p.y - least).max(p.y - self.throat);
            1.0 + step(p.y - self.waist, SPREAD)
                + step(collar, 0.06)
                + step(self.hair(p), SPREAD_HEAD).max(step(self.brow(p), SPREAD_BROW))
        };
        ((place + 0.5) / COLOURS as f64) as f32
    }

    /// How far a point is over the hairline (m); ears are not.
    fn hair(&self, p: &Vector3<f64>) -> f64 {
        let local = self.head.inverse_transform_point(&(*p).into()).coords.component_div(&self.size);
        let (point, down) = (Vector3::from(HAIRLINE.0), Vector3::from(HAIRLINE.1));
        let over = -down.dot(&(local - point)) + 0.002;
        let ear = Vector3::new(local.x.abs() - 0.078, (local.y - 0.052) * 0.62, local.z - 0.010);
        over.min(ear.norm() - 0.021)
    }

    /// How far a point is within a brow (m): an arch that gets thinner outwards.
    fn brow(&self, p: &Vector3<f64>) -> f64 {
        let local = self.head.inverse_transform_point(&(*p).into()).coords.component_div(&self.size);
        let x = local.x.abs();
        let arch = 0.0872 - 8.0 * (x - 0.037).powi(2);
        let thin = 0.075 * (x - 0.030).max(0.0) + 0.10 * (0.020 - x).max(0.0);
        let thick = (0.0027 - thin).max(self.least / self.size.y);
        (thick - (local.y - arch).abs()).min(x - 0.0125).min(0.0490 - x).min(local.z - 0.05)
    }
}
