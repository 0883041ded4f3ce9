//! Point masses and outlines.

use nalgebra::{Vector2, Vector3};
use solaris_analysis::ground::BalanceFrame;

pub(crate) const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.81, 0.0);
pub(crate) const WEIGHT: f64 = 9.81;

/// A body of `mass` at `com` that accelerates, with the rate of its angular momentum about its centre of mass.
pub(crate) fn balance(
    mass: f64,
    com: Vector3<f64>,
    acceleration: Vector3<f64>,
    spin: Vector3<f64>,
) -> BalanceFrame {
    let force = (acceleration - GRAVITY) * mass;
    BalanceFrame { force, moment: com.cross(&force) + spin, com, ..BalanceFrame::default() }
}

/// A rectangle about a point of the ground, y up, turned about it by `turn` (rad).
pub(crate) fn rectangle(centre: Vector3<f64>, half: [f64; 2], turn: f64) -> Vec<Vector3<f64>> {
    let corners = [[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]];
    let (sin, cos) = turn.sin_cos();
    let corner = |[x, z]: [f64; 2]| {
        let (x, z) = (x * half[0], z * half[1]);
        centre + Vector3::new(cos * x + sin * z, 0.0, cos * z - sin * x)
    };
    corners.map(corner).to_vec()
}

/// The convex hull of points over the ground, y up, counter-clockwise from above: Andrew's monotone chain over (z, x), since
/// x follows z there.
pub(crate) fn hull(points: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    let mut points = points.to_vec();
    points.sort_by(|a, b| (a.z, a.x).partial_cmp(&(b.z, b.x)).expect("numbers"));
    let flat = |p: &Vector3<f64>| Vector2::new(p.z, p.x);
    let mut chains = [vec![], vec![]];
    for (chain, reversed) in chains.iter_mut().zip([false, true]) {
        for k in 0..points.len() {
            let point = points[if reversed { points.len() - 1 - k } else { k }];
            while let [.., a, b] = chain[..] {
                if (flat(&b) - flat(&a)).perp(&(flat(&point) - flat(&b))) > 1e-12 {
                    break;
                }
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
    }
    chains.concat()
}

/// How far a point is beyond the worst edge of an outline, y up; negative inside.
pub(crate) fn beyond(outline: &[Vector3<f64>], point: &Vector3<f64>) -> f64 {
    let edges = outline.iter().zip(outline.iter().cycle().skip(1));
    edges
        .map(|(from, to)| {
            let out = (to - from).cross(&Vector3::y()).normalize();
            out.dot(&(point - from))
        })
        .fold(f64::NEG_INFINITY, f64::max)
}

/// Shown with `--nocapture`.
#[allow(clippy::print_stderr, reason = "numbers for who asks for them")]
pub(crate) fn say(text: &str) {
    eprintln!("{text}");
}

/// A number between −1 and 1 that looks random.
pub(crate) fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}
