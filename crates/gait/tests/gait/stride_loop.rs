//! One stride that repeats itself, in both styles: its last frame is the first one a stride later.

use solaris_gait::{Extent, FEET, StyledPlan, StyledRequest, ThesisRequest, WalkRequest, on_the_spot};
use solaris_model::{EventKind, Figure, Motion, human};

fn figure() -> Figure {
    human(1.75, 73.0).expect("a person")
}

/// A stride in a style, out of so many steps.
fn stride(figure: &Figure, thesis: bool, steps: usize) -> Option<Motion> {
    let extent = Extent::Steps(steps);
    let request = if thesis {
        StyledRequest::Thesis(ThesisRequest { extent, ..ThesisRequest::default() })
    } else {
        StyledRequest::Smooth(WalkRequest { extent, ..WalkRequest::default() })
    };
    let plan = StyledPlan::of(figure, &request).expect("it can be walked");
    plan.loaded_stride(figure, 120.0).ok().map(|(motion, _)| motion)
}

#[test]
fn the_last_frame_is_the_first_a_stride_later() {
    let figure = figure();
    // A knee that is nearly straight answers to rounding with its root.
    for (thesis, steps, step_length, limits) in
        [(false, 42, 0.0037 * 1.75 * 110.0, [1e-12, 1e-9, 1e-7]), (true, 6, 0.77, [1e-7, 1e-6, 0.1])]
    {
        let motion = stride(&figure, thesis, steps).expect("a stride");
        let last = motion.len() - 1;
        assert_eq!(last, 131);
        assert!((motion.time()[last] - 120.0 / 110.0).abs() < 1e-12);
        let off = |a: &[f64], b: &[f64]| {
            (0..a.len()).filter(|i| *i != 2).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max)
        };
        let advance = motion.q(last)[2] - motion.q(0)[2];
        assert!((advance - 2.0 * step_length).abs() < 1e-12, "{advance}");
        assert!(off(motion.q(0), motion.q(last)) < limits[0]);
        assert!(off(motion.v(0), motion.v(last)) < limits[1]);
        assert!(off(motion.a(0), motion.a(last)) < limits[2]);
        // Each foot touches once, and lifts once.
        for foot in FEET {
            let touches = motion.events.iter().filter(|event| match &event.kind {
                EventKind::TouchDown { link } => link == foot,
                _ => false,
            });
            assert_eq!(touches.count(), 1, "{foot}");
        }
    }
}

#[test]
fn on_the_spot_it_has_the_same_forces_and_goes_nowhere() {
    let figure = figure();
    let motion = stride(&figure, false, 42).expect("a stride");
    let still = on_the_spot(&figure, &motion).expect("the same figure");
    let last = still.len() - 1;
    assert!((still.q(last)[2] - still.q(0)[2]).abs() < 1e-12);
    assert!(still.planted.is_empty() && still.events.len() == motion.events.len());
    for foot in FEET {
        let [a, b] = [&motion, &still].map(|motion| &motion.contact(foot).expect("a foot").samples);
        assert!(a.iter().zip(b.iter()).all(|(a, b)| a.force == b.force));
    }
}

#[test]
fn a_walk_that_is_too_short_has_none() {
    let figure = figure();
    assert!(stride(&figure, false, 40).is_none());
    assert!(stride(&figure, true, 5).is_none());
}
