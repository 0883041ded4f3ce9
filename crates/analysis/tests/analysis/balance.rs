//! The root's accelerations that momentum asks for.

use crate::ground::support::{GRAVITY, person, swaying_at};
use approx::assert_relative_eq;
use solaris_analysis::{ReactionError, balance_momentum};
use solaris_model::{Axis, Figure, FigureBuilder, Joint, LinkSpec, Trajectory, Vector3};

/// Every coordinate of a person swings at its own pace, as in [`swaying_at`].
struct Swaying<'a>(&'a Figure);

const AMPLITUDE: f64 = 0.1;
const RATE: f64 = 120.0;
const FRAMES: usize = 61;

impl Trajectory for Swaying<'_> {
    fn duration(&self) -> f64 {
        (FRAMES - 1) as f64 / RATE
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        for (dof, q) in q.iter_mut().enumerate().take(self.0.layout().nq()) {
            let size = if dof < 3 { 0.1 * AMPLITUDE } else { AMPLITUDE };
            let angle = (3.0 + 0.37 * dof as f64) * t + dof as f64;
            *q = size * angle.sin() + if dof == 1 { 0.9 } else { 0.0 };
        }
    }
}

/// Whatever the root's accelerations were: they become those of the curve, and nothing else does.
#[test]
fn the_centre_of_mass_is_accelerated_as_its_path_has_it() {
    let figure = person();
    let exact = swaying_at(&figure, FRAMES, RATE, AMPLITUDE);
    let nv = figure.layout().nv();
    let wrong = [0.4, -1.1, 0.2];
    let mut states = exact.clone();
    for (row, a) in states.a.chunks_mut(nv).enumerate() {
        for (axis, wrong) in wrong.iter().enumerate() {
            a[axis] += if row.is_multiple_of(2) { *wrong } else { 0.0 };
        }
    }
    let mut motion = states.motion(&figure, GRAVITY).expect("a motion");
    let corrected = balance_momentum(&figure, &Swaying(&figure), &mut motion).expect("balanced");
    let most = wrong.iter().map(|part| part * part).sum::<f64>().sqrt();
    assert_relative_eq!(corrected, most, epsilon = 1e-4);
    for row in 0..FRAMES {
        for dof in 0..nv {
            let (found, expected) = (motion.a(row)[dof], exact.a[row * nv + dof]);
            assert!((found - expected).abs() < 1e-4, "row {row}, dof {dof}: {found} for {expected}");
        }
    }
}

#[test]
fn a_root_without_three_slides_at_right_angles_is_refused_by_its_joint() {
    let root = || Joint::new("root");
    let slide = |joint: Joint, x, y, z| joint.axis(Axis::translation(Vector3::new(x, y, z)));
    for (joint, is_refused) in [
        (root().tx().ty().tz().rx(), false),
        (root().tz().tx().ty(), false),
        (root(), true),
        (root().tx().ty().rz(), true),
        (root().rx().ty().tz(), true),
        (slide(root().tx(), 0.01, 1.0, 0.0).tz(), true),
        (slide(root(), 0.01, 0.0, 1.0).tx().ty(), true),
        (slide(root().tx().ty(), 0.0, 0.01, 1.0), true),
    ] {
        let link = LinkSpec::root("body", joint).mass(2.0);
        let figure = FigureBuilder::new("one").link(link).build().expect("a figure");
        let mut motion = swaying_at(&figure, 3, RATE, 0.0).motion(&figure, GRAVITY).expect("a motion");
        let found = balance_momentum(&figure, &Swaying(&figure), &mut motion);
        assert_eq!(
            is_refused,
            matches!(&found, Err(ReactionError::NoSlides { joint }) if joint == "root"),
            "{found:?}"
        );
        assert!(is_refused || found.is_ok(), "{found:?}");
    }
}
