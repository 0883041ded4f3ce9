//! Which points of a foot are planted while it stands.

use crate::body::roles::{FEET, TOES};
use solaris_model::{Figure, Interval, SolePart};

/// One stance of a foot: the times (s) between which its parts are on the ground.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stood {
    pub(crate) landed: f64,
    pub(crate) flat: f64,
    /// Whether it lands on its ball, its toes flat, instead of its heel.
    pub(crate) on_ball: bool,
    pub(crate) heel_off: f64,
    pub(crate) tip_roll: f64,
    pub(crate) toe_off: f64,
}

impl Stood {
    /// The same so much later (s).
    pub(crate) fn later(self, by: f64) -> Self {
        Self {
            landed: self.landed + by,
            flat: self.flat + by,
            on_ball: self.on_ball,
            heel_off: self.heel_off + by,
            tip_roll: self.tip_roll + by,
            toe_off: self.toe_off + by,
        }
    }

    /// When which point of the sole of the foot on a side is planted: the heel until it rises, the foot's ball while the foot is
    /// flat, the toes' ball until they roll, their tip until it lifts.
    pub(crate) fn planted(&self, figure: &Figure, side: usize) -> impl Iterator<Item = Interval> + use<> {
        let (foot, toes) = (FEET[side], TOES[side]);
        let toes_from = if self.on_ball { self.landed } else { self.flat };
        let spans = [
            (foot, SolePart::Heel, if self.on_ball { self.flat } else { self.landed }, self.heel_off),
            (foot, SolePart::Ball, self.flat, self.heel_off),
            (toes, SolePart::Ball, toes_from, self.tip_roll),
            (toes, SolePart::ToeTip, toes_from, self.toe_off),
        ];
        let planted = spans.map(|(name, part, start, end)| {
            let link = figure.link_index(name)?;
            let point = *figure.links()[link].sole_point(part)?;
            Some(Interval { link, point, start, end })
        });
        planted.into_iter().flatten()
    }
}
