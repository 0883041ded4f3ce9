//! The table of axes in docs/engines.md: a point of a link is where the engine's own arithmetic puts it.

use solaris::model::{UnitQuaternion, Vector3};

/// An engine's vector and quaternion (x, y, z, w) of ours.
type Rows = (fn(Vector3<f64>) -> Vector3<f64>, fn([f64; 4]) -> [f64; 4]);

#[test]
fn turned_points_are_turned_alike_in_every_engine() {
    let unity: Rows = (|p| Vector3::new(-p.x, p.y, p.z), |[x, y, z, w]| [x, -y, -z, w]);
    let unreal: Rows = (|p| 100.0 * Vector3::new(p.z, -p.x, p.y), |[x, y, z, w]| [-z, x, -y, w]);
    for (place, quaternion) in [unity, unreal] {
        for k in 0..50 {
            let at = |i: i32| f64::sin(f64::from(k * 7 + i) * 1.3);
            let turn = UnitQuaternion::from_scaled_axis(3.0 * Vector3::new(at(1), at(2), at(3)));
            let point = Vector3::new(at(4), at(5), at(6));
            // What a left-handed engine does with a quaternion is the same sums of products.
            let theirs = quaternion(turn.coords.into());
            let q = UnitQuaternion::new_normalize(solaris_quaternion(theirs));
            let (found, expected) = (q * place(point), place(turn * point));
            assert!((found - expected).norm() < 1e-12 * 100.0, "{found} {expected}");
        }
    }
}

fn solaris_quaternion([x, y, z, w]: [f64; 4]) -> nalgebra::Quaternion<f64> {
    nalgebra::Quaternion::new(w, x, y, z)
}
