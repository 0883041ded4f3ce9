//! What a person wears: where in the palette each place of the body is.

use super::head::HAIRLINE;
use super::sizes::Sizes;
use super::{ARMS, LEGS};
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
    scale: f64,
    tall: f64,
}

/// A colour's part of the strip that a border is spread over is as long as this on the body (m): some cells, so that between
/// vertices the place in the strip goes evenly where the border is.
const SPREAD: f64 = 0.11;
const SPREAD_HEAD: f64 = 0.030;

impl Clothes {
    pub(super) fn of(sizes: &Sizes<'_>) -> Self {
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
            scale: sizes.long("head"),
            tall,
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
            1.0 + step(p.y - self.waist, SPREAD) + step(collar, 0.06) + step(self.hair(p), SPREAD_HEAD)
        };
        ((place + 0.5) / 6.0) as f32
    }

    /// How far a point is over the hairline (m); ears are not.
    fn hair(&self, p: &Vector3<f64>) -> f64 {
        let local = self.head.inverse_transform_point(&(*p).into()).coords / self.scale;
        let (point, down) = (Vector3::from(HAIRLINE.0), Vector3::from(HAIRLINE.1));
        let over = -down.dot(&(local - point)) + 0.002;
        let ear = Vector3::new(local.x.abs() - 0.078, (local.y - 0.052) * 0.62, local.z - 0.010);
        over.min(ear.norm() - 0.021)
    }
}
