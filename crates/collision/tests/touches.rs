//! What is found, against the support functions of the shapes themselves.
//!
//! Of two convex bodies the distance is the greatest separation along any direction, and of bodies that overlap the least depth:
//!
//! ```text
//! gap = max over |d| = 1 of  d·(c_A − c_B) − h_A(−d) − h_B(d)
//! ```

use approx::assert_relative_eq;
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use solaris_collision::{Colliders, Touch};
use solaris_model::{Placement, Shape, ShapeKind};

/// A generator of numbers that look random: Steele, Lea, Flood, "Fast splittable pseudorandom number generators" (2014).
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        low + (high - low) * ((z ^ (z >> 31)) as f64 / u64::MAX as f64)
    }

    fn direction(&mut self) -> Vector3<f64> {
        loop {
            let v = Vector3::from_fn(|_, _| self.between(-1.0, 1.0));
            if (0.1..1.0).contains(&v.norm()) {
                return v.normalize();
            }
        }
    }

    fn turn(&mut self) -> UnitQuaternion<f64> {
        UnitQuaternion::from_scaled_axis(self.direction() * self.between(0.0, 3.0))
    }

    fn kind(&mut self, which: usize) -> ShapeKind {
        let [a, b, c] = [0; 3].map(|_| self.between(0.05, 0.4));
        match which {
            0 => ShapeKind::Box { size: Vector3::new(a, b, c) },
            1 => ShapeKind::Cylinder { radius: a, length: b },
            2 => ShapeKind::Ellipsoid { radii: Vector3::new(a, b, c) },
            3 => ShapeKind::Capsule { radius: a, length: b },
            _ => ShapeKind::Sphere { radius: a },
        }
    }
}

fn found(kinds: [ShapeKind; 2], poses: [Isometry3<f64>; 2], reach: f64) -> Vec<Touch> {
    let shapes = [0, 1].map(|i| (i, Shape { kind: kinds[i], placement: Placement::identity() }));
    let mut colliders = Colliders::new(&shapes, vec![[0, 1]]);
    let mut touches = Vec::new();
    colliders.touches(|link| poses[link], |_| reach, |touch| touches.push(*touch));
    touches
}

/// The separation of the first from the second along `d`.
fn separation(kinds: &[ShapeKind; 2], poses: &[Isometry3<f64>; 2], d: &Vector3<f64>) -> f64 {
    let reach = |i: usize, d: Vector3<f64>| kinds[i].reach(&poses[i].rotation.inverse_transform_vector(&d));
    d.dot(&(poses[0].translation.vector - poses[1].translation.vector)) - reach(0, -d) - reach(1, *d)
}

/// How many random pairs.
const CASES: usize = 2500;

/// How far outside of a shape what stands for it may lie (m), at most.
fn outside(kind: &ShapeKind) -> f64 {
    match kind {
        ShapeKind::Ellipsoid { radii } => {
            let skin = radii.min() / 16.0;
            let k = (radii.max() - skin) / (radii.min() - skin);
            skin * (1.0 - 2.0 * k.sqrt() / (1.0 + k))
        }
        _ => 0.0,
    }
}

/// How far inside.
fn inside(kind: &ShapeKind) -> f64 {
    match *kind {
        // A corner that is rounded by r is off by (√2 − 1)·r.
        ShapeKind::Cylinder { radius, length } => 0.415 * radius.min(0.5 * length) / 16.0,
        _ => 0.0,
    }
}

/// Random pairs of every kind, a little apart and a little in each other: the gap is the separation along the normal, and no other
/// direction parts them more; to 1e-8 m, but for one pair in 500 of which one is round, where it may be 2e-5 m.
#[test]
fn gaps_are_the_greatest_separation() {
    let random = &mut Random(1);
    let mut rough = 0;
    for case in 0..CASES {
        let kinds = [random.kind(case % 5), random.kind(case / 5 % 5)];
        // Along a random direction, until they are as far apart as they should be along it.
        let (d, turns) = (random.direction(), [random.turn(), random.turn()]);
        let mut poses = turns.map(|turn| Isometry3::from_parts(Translation3::identity(), turn));
        let wanted = random.between(-0.004, 0.05);
        poses[0].translation.vector = d * (wanted - separation(&kinds, &poses, &d));
        let origin = random.direction() * 2.0;
        poses.iter_mut().for_each(|pose| pose.translation.vector += origin);

        let touches = found(kinds, poses, 1.0);
        let gap = touches.iter().map(|touch| touch.gap).fold(f64::INFINITY, f64::min);
        assert!(gap.is_finite(), "case {case}: {kinds:?} {poses:?}");
        let normal = touches.iter().find(|touch| touch.gap <= gap).expect("the nearest").normal;
        assert_relative_eq!(normal.norm(), 1.0, epsilon = 1e-12);
        let along = separation(&kinds, &poses, &normal);
        let outside = outside(&kinds[0]) + outside(&kinds[1]);
        let inside = inside(&kinds[0]) + inside(&kinds[1]);
        let off = (along - outside - gap).max(gap - along - inside);
        assert!(off < 2e-5, "case {case}: gap {gap}, along its normal {along}: {kinds:?}");
        if off > 1e-8 {
            rough += 1;
            continue;
        }
        // No direction is much better; nearby ones cannot be better than the bodies' roundness allows.
        for step in [1.0, 0.3, 0.1, 0.03, 0.01, 1e-3] {
            for _ in 0..40 {
                let other = separation(&kinds, &poses, &(normal + random.direction() * step).normalize());
                assert!(other < gap + outside + inside + 1e-7, "case {case}: {other} along another, gap {gap}: {kinds:?}");
            }
        }
        // Where they touch the nearest point is half way between both bodies, but for a part of the gap that cylinders' polygons cost,
        // and the other way round it is the same.
        for touch in touches.iter().filter(|touch| touch.gap <= gap && gap < 5e-3) {
            let back = found([kinds[1], kinds[0]], [poses[1], poses[0]], 1.0);
            let least = back.iter().map(|touch| touch.gap).fold(f64::INFINITY, f64::min);
            assert!((least - gap).abs() < 1e-7, "case {case}: {gap} and {least}: {kinds:?}");
            for (kind, pose) in kinds.iter().zip(&poses) {
                let point = pose.inverse_transform_point(&touch.point.into()).coords;
                let reach = kind.reach(&point.normalize()) + 0.6 * touch.gap.abs() + outside + 1e-9;
                assert!(point.norm() < reach, "case {case}: {} beyond {reach}, {touch:?}, {kinds:?}", point.norm());
            }
        }
    }
    assert!(500 * rough <= CASES, "{rough} of {CASES} are rough");
}

#[test]
fn faces_touch_in_their_corners_and_what_lies_in_two_points() {
    let slab = ShapeKind::Box { size: Vector3::new(1.0, 0.1, 1.0) };
    let on = |kind, height| {
        let poses = [Isometry3::translation(0.1, 0.05 + height, 0.2), Isometry3::identity()];
        let touches = found([kind, slab], poses, 0.01);
        for touch in &touches {
            assert!(touch.gap.abs() < 1e-12 && (touch.normal - Vector3::y()).norm() < 1e-12, "{touch:?}");
            assert!((touch.point.y - 0.05).abs() < 1e-12, "{touch:?}");
        }
        touches
    };
    let extent = |touches: &[Touch], axis: usize| {
        let along = || touches.iter().map(|touch| touch.point[axis]);
        along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
    };
    let block = on(ShapeKind::Box { size: Vector3::new(0.2, 0.3, 0.4) }, 0.15);
    assert_relative_eq!(extent(&block, 0), 0.2, epsilon = 1e-12);
    assert_relative_eq!(extent(&block, 2), 0.4, epsilon = 1e-12);
    let can = on(ShapeKind::Cylinder { radius: 0.1, length: 0.2 }, 0.1);
    assert!(extent(&can, 0) > 0.12 && extent(&can, 2) > 0.12, "{can:?}");
    assert_eq!(on(ShapeKind::Sphere { radius: 0.1 }, 0.1).len(), 1);

    let lying = Isometry3::from_parts(
        Translation3::new(0.0, 0.15, 0.0),
        UnitQuaternion::from_scaled_axis(Vector3::z() * std::f64::consts::FRAC_PI_2),
    );
    let capsule = ShapeKind::Capsule { radius: 0.1, length: 0.4 };
    let touches = found([capsule, slab], [lying, Isometry3::identity()], 0.01);
    assert_relative_eq!(extent(&touches, 0), 0.4, epsilon = 1e-9);
    // Two that cross, and two beside each other.
    let other = Isometry3::translation(0.0, 0.35, 0.0) * UnitQuaternion::from_scaled_axis(Vector3::x() * 1.2);
    assert!(extent(&found([capsule, capsule], [lying, other], 0.01), 0) < 1e-12);
    let beside = Isometry3::translation(0.1, 0.2, 0.0) * lying;
    assert_relative_eq!(extent(&found([capsule, capsule], [lying, beside], 0.01), 0), 0.3, epsilon = 1e-9);
}

/// Far from the origin, tiny and huge, middles in one place, and numbers that are none.
#[test]
fn hard_cases_are_answered() {
    let sphere = |radius| ShapeKind::Sphere { radius };
    let at = Isometry3::translation;
    let [far] = found([sphere(0.1), sphere(0.1)], [at(1e6, 0.0, 0.0), at(1e6 + 0.25, 0.0, 0.0)], 0.1)[..] else {
        panic!("one touch");
    };
    assert!((far.gap - 0.05).abs() < 1e-9);
    let [tiny] = found([sphere(1e-6), sphere(2e-6)], [at(0.0, 4e-6, 0.0), Isometry3::identity()], 1e-3)[..] else {
        panic!("one touch");
    };
    assert!((tiny.gap - 1e-6).abs() < 1e-15);
    let [uneven] = found([sphere(1e-3), sphere(1e5)], [at(0.0, 1e5 + 2e-3, 0.0), Isometry3::identity()], 1e-2)[..] else {
        panic!("one touch");
    };
    assert!((uneven.gap - 1e-3).abs() < 1e-9);
    for which in 0..5 {
        let kind = Random(3).kind(which);
        // No way out is shorter than another, or none is found; either is an answer.
        for touch in found([kind, kind], [Isometry3::identity(); 2], 0.1) {
            assert!(touch.gap < 0.0 && touch.normal.norm() > 0.99, "{touch:?}");
        }
        assert!(found([kind, kind], [Isometry3::identity(), at(f64::NAN, 0.0, 0.0)], 0.1).is_empty());
        assert!(found([kind, kind], [Isometry3::identity(), at(3.0, 0.0, 0.0)], 0.1).is_empty());
    }
}

/// What was found before does not change what is found.
#[test]
fn nothing_is_kept_from_call_to_call() {
    let random = &mut Random(8);
    let kinds = [0, 1, 2, 3, 4].map(|which| random.kind(which));
    let shapes: Vec<(usize, Shape)> =
        (0..5).map(|i| (i, Shape { kind: kinds[i], placement: Placement::identity() })).collect();
    let pairs: Vec<[usize; 2]> = (0..5).flat_map(|a| (a + 1..5).map(move |b| [a, b])).collect();
    let mut used = Colliders::new(&shapes, pairs);
    let fresh = used.clone();
    for _ in 0..100 {
        let poses = [0; 5].map(|_| Isometry3::from_parts((random.direction() * 0.2).into(), random.turn()));
        let all = |colliders: &mut Colliders| {
            let mut touches = Vec::new();
            colliders.touches(|link| poses[link], |_| 0.05, |touch| touches.push(*touch));
            touches
        };
        assert_eq!(all(&mut used), all(&mut fresh.clone()));
    }
}
