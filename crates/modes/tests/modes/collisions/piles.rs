//! Heaps of whatever there is.

use super::{G, colliding, cube, over_a_slab, settings};
use solaris_collision::Colliders;
use solaris_dynamics::{Tree, Workspace, forward_kinematics, kinetic_energy, potential_energy};
use solaris_model::{Figure, Isometry3, Motion, Rotation3, ShapeKind, UnitQuaternion, Vector3};
use solaris_modes::Collisions;

/// The depth (m) of the deepest overlap in any frame.
pub(super) fn deepest(figure: &Figure, motion: &Motion, collisions: &Collisions) -> f64 {
    let tree = Tree::<f64>::new(figure, Vector3::zeros()).expect("valid");
    let mut workspace = Workspace::new(&tree);
    let mut colliders = Colliders::of(figure, &collisions.pairs).expect("valid");
    let mut deepest = 0.0_f64;
    for frame in 0..motion.len() {
        forward_kinematics(&tree, &mut workspace, motion.q(frame)).expect("valid");
        let pose = |link: usize| {
            let pose = workspace.pose(link);
            let turn = Rotation3::from_matrix_unchecked(pose.rotation);
            Isometry3::from_parts(pose.translation.into(), UnitQuaternion::from_rotation_matrix(&turn))
        };
        colliders.touches(pose, |_| 0.0, |touch| deepest = deepest.max(-touch.gap));
    }
    deepest
}

/// The energy of motion and in gravity (J).
fn mechanical(figure: &Figure, q: &[f64], v: &[f64]) -> f64 {
    let tree = Tree::<f64>::new(figure, Vector3::y() * -G).expect("valid");
    let mut workspace = Workspace::new(&tree);
    let kinetic = kinetic_energy(&tree, &mut workspace, q, v).expect("finite");
    kinetic + potential_energy(&tree, &mut workspace, q).expect("finite")
}

/// Bodies of every kind that fall on each other: every run ends, nothing passes through, and no energy comes from nowhere.
#[test]
fn heaps_of_every_kind_fall_and_do_not_pass_through() {
    let mut random = 17_u64;
    let mut next = || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (random >> 11) as f64 / (1_u64 << 53) as f64
    };
    for scene in 0..3 {
        let mut bodies = Vec::new();
        for i in 0..6 {
            let [a, b, c] = [0; 3].map(|_| 0.05 + 0.1 * next());
            let kind = match (2 * scene + i) % 5 {
                0 => cube(2.0 * a, 2.0 * b, 2.0 * c),
                1 => ShapeKind::Cylinder { radius: a, length: 2.0 * b },
                2 => ShapeKind::Ellipsoid { radii: Vector3::new(a, b, c) },
                3 => ShapeKind::Capsule { radius: a, length: b },
                _ => ShapeKind::Sphere { radius: a },
            };
            bodies.push((kind, 0.2 + 2.0 * next()));
        }
        let figure = over_a_slab(&bodies);
        let places: Vec<Vector3<f64>> =
            (0..6).map(|i| Vector3::new(0.1 * next(), 0.3 + 0.35 * f64::from(i), 0.1 * next())).collect();
        let mut simulation = colliding(&figure, Vector3::y() * -G, 0.6, &places);
        // Turning a little as they fall.
        let q = simulation.state().0.to_vec();
        let v: Vec<f64> = (0..36).map(|k| if k % 6 < 3 { 0.0 } else { 2.0 * next() - 1.0 }).collect();
        simulation.set_start(&q, &v).expect("valid");
        let run = simulation.run(&settings(2.0, 100.0, 1e-3)).expect("never refused");
        let collisions = simulation.collisions().expect("some");
        let deepest = deepest(&figure, &run.motion, collisions);
        assert!(deepest < 2e-3, "scene {scene}: {deepest}");
        let energy = &run.report.energy;
        assert!(energy.imbalance < 0.02 * energy.scale, "scene {scene}: {energy:?}");
        // Frame by frame, it only falls.
        let mut least = f64::INFINITY;
        for frame in 0..run.motion.len() {
            let now = mechanical(&figure, run.motion.q(frame), run.motion.v(frame));
            assert!(
                now < least + 1e-3 * energy.scale,
                "scene {scene}, frame {frame}: {now} J after {least} J"
            );
            least = least.min(now);
        }
        let start = mechanical(&figure, run.motion.q(0), run.motion.v(0));
        assert!(least < start - 0.5 * energy.scale, "scene {scene}: {least} J of {start} J");
    }
}
