//! Soles of figures that have none, by the names of their bodies.

use super::{SOLE_BREADTH, Sole};
use nalgebra::Vector3;
use solaris_model::{Figure, Placement};

/// How far the tip is beyond the ball, over the distance from heel to ball.
const TOES: f64 = 0.36;

/// Soles guessed by the names that the bodies of `OpenSim`'s models have; empty where there are none of them.
///
/// For each side of which the figure has links or frames `calcn_r` and `toes_r` (`calcn_l` and `toes_l`), the toes fixed to
/// the foot or hinged on it:
///
/// ```text
/// heel: the origin of calcn     ball: the origin of toes     tip: ball + 0.36 (ball − heel), without its y in toes
/// ```
///
/// In these models the calcaneus' frame is at the back of the heel bone, the toes' is between the metatarsal heads, and y is up in both.
/// The true sole lies some centimetres lower, by as much in all three points. That shifts the ground, and the centre of pressure by the
/// same times the ratio of tangential to normal force; not the whole wrench, so not the joints above a foot that stands alone.
/// Its breadth is [`SOLE_BREADTH`](super::SOLE_BREADTH) times its length. A sole is called as its foot, `calcn_r` or `calcn_l`.
pub fn guessed_soles(figure: &Figure) -> Vec<Sole> {
    ["r", "l"].into_iter().filter_map(|side| guess(figure, side)).collect()
}

fn guess(figure: &Figure, side: &str) -> Option<Sole> {
    let name = format!("calcn_{side}");
    let (foot, at_foot) = figure.locate(&name)?;
    let (link, at_toes) = figure.locate(&format!("toes_{side}"))?;
    // The toes' frame in the foot's link, with the joint between them at zero.
    let in_foot = if link == foot {
        at_toes
    } else {
        let toes = &figure.links()[link];
        (toes.parent() == Some(foot)).then(|| toes.joint().placement() * at_toes)?
    };
    let (heel, ball) = (origin(&at_foot), origin(&in_foot));
    let along = in_foot.rotation.inverse() * (ball - heel) * TOES;
    let beyond = Vector3::new(along.x, 0.0, along.z);
    let (toes, from) = if link == foot { (None, in_foot) } else { (Some(link), at_toes) };
    let tip = origin(&from) + from.rotation * beyond;
    let length = (ball - heel).norm() + beyond.norm();
    let width = (length > 0.0).then_some(SOLE_BREADTH * length);
    Some(Sole { name, foot, toes, heel, ball, tip, width })
}

fn origin(placement: &Placement) -> Vector3<f64> {
    placement.translation.vector
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use solaris_model::{FigureBuilder, Isometry3, Joint, LinkSpec};
    use std::f64::consts::FRAC_PI_2;

    const BALL: Vector3<f64> = Vector3::new(0.18, -0.002, 0.01);

    #[test]
    fn hinged_toes_and_fixed_ones_are_the_same_foot() {
        let turned = Isometry3::new(BALL, Vector3::y() * FRAC_PI_2);
        let calcn = Isometry3::translation(-0.05, -0.04, 0.008);
        let mtp = Joint::new("mtp_r").placed(calcn * turned).rz();
        let hinged = FigureBuilder::new("hinged")
            .link(LinkSpec::root("talus_r", Joint::new("ankle").rz()).mass(1.0).frame("calcn_r", calcn))
            .link(LinkSpec::child("toes_r", "talus_r", mtp).mass(1.0))
            .build()
            .expect("valid");
        let talus = LinkSpec::root("talus_r", Joint::new("ankle").rz()).mass(1.0);
        let fixed = FigureBuilder::new("fixed")
            .link(talus.frame("calcn_r", calcn).frame("toes_r", calcn * turned))
            .build()
            .expect("valid");
        let [hinged, fixed] = [hinged, fixed].map(|figure| guessed_soles(&figure));
        let ([hinged], [fixed]) = (&hinged[..], &fixed[..]) else { panic!("one sole each") };
        assert_eq!((hinged.foot, hinged.toes, fixed.foot, fixed.toes), (0, Some(1), 0, None));
        assert_eq!((hinged.heel, hinged.ball), (fixed.heel, fixed.ball));
        let heel = Vector3::new(-0.05, -0.04, 0.008);
        assert_relative_eq!(fixed.heel, heel, epsilon = 1e-15);
        assert_relative_eq!(fixed.ball, heel + BALL, epsilon = 1e-15);
        assert_relative_eq!(fixed.tip, heel + BALL + Vector3::new(0.0648, 0.0, 0.0036), epsilon = 1e-15);
        // In the toes' own frame, which is turned by a quarter about y: forwards is z there.
        assert_relative_eq!(hinged.tip, Vector3::new(-0.0036, 0.0, 0.0648), epsilon = 1e-15);
        assert_eq!((fixed.name.as_str(), fixed.width), ("calcn_r", hinged.width));
        // The toes' joint is 0.1803 m before the heel, the tip 0.0649 m before that.
        assert_relative_eq!(fixed.width.expect("a breadth"), 55.0 / 152.0 * 0.245_17, epsilon = 1e-4);
    }

    #[test]
    fn others_have_none() {
        let link = |name: &str| LinkSpec::root(name, Joint::new("ankle").rz()).mass(1.0);
        for name in ["foot", "calcn_r", "toes_r"] {
            let figure = FigureBuilder::new("f").link(link(name)).build().expect("valid");
            assert_eq!(guessed_soles(&figure), []);
        }
    }
}
