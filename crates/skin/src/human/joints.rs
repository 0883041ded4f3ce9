//! How the skin of a person bends.

use super::sizes::Sizes;
use super::{ARMS, LEGS, SIDES, TRUNK};
use crate::weights::Bend;
use nalgebra::Vector3;

pub(super) fn bends(sizes: &Sizes<'_>) -> Vec<Bend> {
    let body = || vec![TRUNK, LEGS[0], LEGS[1]];
    let bend = |link: &str, towards: [f64; 3], half: f64, groups: Vec<usize>| Bend {
        link: sizes.index(link),
        parent: sizes.parent(link),
        at: sizes.joint(link),
        towards: Vector3::from(towards).normalize(),
        half,
        groups,
        beyond: Vec::new(),
        beside: None,
    };
    let tall = sizes.tall;
    let mut bends = vec![
        bend("abdomen", [0.0, 1.0, 0.0], 0.075 * tall, body()),
        bend("thorax", [0.0, 1.0, 0.0], 0.085 * tall, body()),
        bend("neck", [0.0, 1.0, -0.15], 0.035 * tall, vec![TRUNK]),
        // The jaw goes with the head, the nape with the neck.
        bend("head", [0.0, 0.75, 0.66], 0.024 * tall, vec![TRUNK]),
    ];
    // However low a hand hangs, it is the chest's.
    for trunk in &mut bends[..2] {
        trunk.beyond = ARMS.to_vec();
    }
    for (i, side) in SIDES.into_iter().enumerate() {
        let own = |link: &str| side.name(link);
        let thick = |link: &str| sizes.thick(&own(link)).0;
        let (arm, leg) = (vec![ARMS[i]], vec![LEGS[i]]);
        let near = |group: usize| vec![TRUNK, group];
        let x = side.out;
        let along = |link: &str| sizes.place(&own(link)).rotation * -Vector3::y();
        let mut clavicle = bend(&own("clavicle"), [x, 0.35, 0.0], 0.055 * tall, near(ARMS[i]));
        clavicle.at += Vector3::new(x * 0.060, 0.0, 0.0) * tall;
        // The chest below does not follow the shoulder.
        let under = Vector3::new(0.0, sizes.height(0.365), 0.0);
        clavicle.beside = Some((under, Vector3::y(), 0.055 * tall));
        bends.push(clavicle);
        let mut shoulder = bend(&own("upper_arm"), [x, -0.22, 0.0], 0.052 * tall, near(ARMS[i]));
        shoulder.at += Vector3::new(x * 0.004, 0.0, 0.0) * tall;
        bends.push(shoulder);
        bends.push(bend(&own("forearm"), along("forearm").into(), 0.046 * thick("forearm"), arm.clone()));
        bends.push(bend(&own("hand"), along("hand").into(), 0.028 * tall, arm));
        // The groin rises outwards; between the legs it is the side that counts.
        let mut hip = bend(&own("thigh"), [x * 0.42, -0.90, 0.08], 0.075 * tall, near(LEGS[i]));
        hip.beside = Some((Vector3::zeros(), Vector3::x() * x, 0.03 * tall));
        bends.push(hip);
        bends.push(bend(&own("shank"), along("shank").into(), 0.058 * thick("shank"), leg.clone()));
        bends.push(bend(&own("foot"), [0.0, -0.8, 0.55], 0.032 * tall, leg.clone()));
        bends.push(bend(&own("toes"), [0.0, 0.15, 1.0], 0.022 * tall, leg));
    }
    bends
}
