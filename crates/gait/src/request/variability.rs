//! How much steps differ from each other, and left from right.

use crate::error::RequestError;

/// The greatest scale: twice what people do.
pub const MOST_VARIABILITY: f64 = 2.0;

/// Differences from step to step and between left and right, made from a seed: the same seed is the same walk.
///
/// At a scale of 1 the standard deviations are
///
/// | what | step to step | left to right |
/// |---|---|---|
/// | step length | 2.5 % | 1.5 % |
/// | step time | 2 % | 1 % |
/// | step width | 17 mm at 1.75 m | – |
/// | turn of a foot | 1.5° | – |
/// | arm swing | 6 % | 8 % |
/// | turn and bend of the thorax | 6 % | – |
/// | turn and tilt of the pelvis | 4 % | – |
/// | pitch of the foot at contact | 1° | – |
/// | knee in swing | 1.2° | – |
/// | clearance | 15 % | – |
///
/// Those of length, time and width are what is told of healthy young people (from memory, not looked up: length and time 1.5 to 3 %, width
/// 15 to 25 mm, as Owings and Grabiner 2004 and Brach 2005 have them), the rest is an artist's choice. Steps are independent of each other:
/// the long memory of people's stride times is not there. What varies is what a walk is planned from, so that its forces and its motion
/// agree as they do without.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variability {
    /// Over people's.
    pub scale: f64,
    /// Whose differences.
    pub seed: u64,
}

impl Variability {
    pub(crate) fn check(self) -> Result<(), RequestError> {
        super::pace::range("variability", self.scale, "", (0.0, MOST_VARIABILITY), || {
            " times people's".to_owned()
        })
    }
}

/// Numbers by chance that depend on nothing but a seed and what they are for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Chance(pub(crate) u64);

impl Chance {
    /// A normally distributed number with a standard deviation of 1, within ±2.5: the `which`-th one for `step`.
    pub(crate) fn normal(self, step: u64, which: u64) -> f64 {
        let at = mixed(mixed(self.0 ^ 0x5851_f42d_4c95_7f2d).wrapping_add(step)).wrapping_add(which << 1);
        // Box and Muller's, of two even numbers above 0.
        let even = |x: u64| ((mixed(x) >> 11) as f64 + 0.5) / (1_u64 << 53) as f64;
        let (radius, angle) = (even(at), even(at.wrapping_add(1)));
        let normal = (-2.0 * radius.ln()).sqrt() * (std::f64::consts::TAU * angle).cos();
        normal.clamp(-2.5, 2.5)
    }
}

/// The finaliser of `SplitMix64`.
pub(crate) fn mixed(x: u64) -> u64 {
    let x = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chance_is_normal_and_independent() {
        let count = 20_000_u64;
        let draws: Vec<f64> = (0..count).map(|i| Chance(i / 1000).normal(i % 1000 / 10, i % 10)).collect();
        let mean = draws.iter().sum::<f64>() / count as f64;
        let variance = draws.iter().map(|x| x * x).sum::<f64>() / count as f64;
        let next = draws.windows(2).map(|pair| pair[0] * pair[1]).sum::<f64>() / count as f64;
        assert!(
            mean.abs() < 0.02 && (variance - 1.0).abs() < 0.05 && next.abs() < 0.02,
            "{mean} {variance} {next}"
        );
        assert!(Chance(7).normal(3, 2).to_bits() == Chance(7).normal(3, 2).to_bits());
    }
}
