//! The root is a choice: forces computed from the foot that stands are those computed from the pelvis.

use crate::cases::{person, steps, walked};
use solaris::analysis::{ReactionError, reactions_from_feet};
use solaris::gait::{FEET, Stairs, WalkGround, WalkRequest};
use solaris::model::EventKind;

/// What rounding leaves, of the greatest force of its kind.
const ROUNDING: f64 = 1e-9;

#[test]
fn forces_do_not_depend_on_the_root_through_every_change_of_support() {
    for (height, frequency, count, rate) in
        [(1.75, 110.0, 4, 120.0), (1.3, 105.0, 3, 97.0), (1.9, 90.0, 5, 60.0)]
    {
        let figure = person(height);
        let (_, mut motion) = walked(&figure, &steps(frequency, count), rate);
        let before = motion.clone();
        let report = reactions_from_feet(&figure, &mut motion, FEET).expect("a walk on two feet");
        let (force, moment, torque) = report.scale;
        assert!(force > 9.0 * figure.mass() && torque > 0.1 * force);
        // The report compares, and so does this, with what is in the motion.
        let greatest = |of: &dyn Fn(usize) -> f64| (0..motion.len()).map(of).fold(0.0, f64::max);
        let tau = greatest(&|row| {
            let [was, is] = [&before, &motion].map(|motion| motion.tau(row).expect("forces"));
            was.iter().zip(is).fold(0.0, |worst, (was, is)| f64::max(worst, (was - is).abs()))
        });
        assert!(tau <= ROUNDING * torque && (tau - report.torque).abs() <= 0.0, "{tau:e}");
        for foot in FEET {
            let [was, is] = [&before, &motion].map(|motion| &motion.contact(foot).expect("a foot").samples);
            let off = greatest(&|row| (was[row].force - is[row].force).norm());
            let turn = greatest(&|row| (was[row].moment - is[row].moment).norm());
            // Where it bears next to nothing, a centre of pressure is a quotient of two roundings.
            let cop = greatest(&|row| {
                let light = was[row].force.norm() < 0.01 * force;
                if light { 0.0 } else { (was[row].cop - is[row].cop).norm() }
            });
            assert!(
                off <= ROUNDING * force && turn <= ROUNDING * moment && cop < 1e-9,
                "{foot}: {off:e} {turn:e} {cop:e}"
            );
        }
        // Each step has the foot and then its toes as the root; from standing, through every step, to standing.
        let links: Vec<&str> = report.roots.iter().map(|(link, _)| link.as_str()).collect();
        assert!(links.len() >= 2 * count, "{links:?}");
        for pair in links.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let is_roll = to == from.replace("_foot", "_toes") && from != to;
            let is_step = from[..4] != to[..4] && to.ends_with("_foot");
            assert!(is_roll || is_step || from == to.replace("_foot", "_toes"), "{links:?}");
        }
        let changes: Vec<(String, f64)> = motion
            .events
            .iter()
            .filter_map(|event| match &event.kind {
                EventKind::RootChange { link } => Some((link.clone(), event.time)),
                _ => None,
            })
            .collect();
        assert_eq!(changes, report.roots[1..]);
    }
}

/// Centres of pressure lay at y = 0 on stairs before, up to a storey below the foot.
#[test]
fn on_stairs_and_slopes_pressure_stays_under_the_foot() {
    let figure = person(1.75);
    let stairs = WalkGround::Stairs(Stairs { count: 3, ..Stairs::default() });
    for (ground, frequency) in [(stairs, 88.0), (WalkGround::Slope(-0.1), 100.0)] {
        let request = WalkRequest { ground, ..steps(frequency, 9) };
        let (_, mut motion) = walked(&figure, &request, 60.0);
        let before = motion.contacts.clone();
        reactions_from_feet(&figure, &mut motion, FEET).expect("a walk on two feet");
        for (was, is) in before.iter().zip(&motion.contacts) {
            for (row, (was, is)) in was.samples.iter().zip(&is.samples).enumerate() {
                let (off, scale) = ((was.force - is.force).norm(), 10.0 * figure.mass());
                assert!(off < ROUNDING * scale, "{row}: {off:e}");
                let apart = (was.cop - is.cop).norm();
                assert!(was.force.norm() < 0.01 * scale || apart < 1e-9, "{row}: {apart} m");
            }
        }
        let heights = motion.contacts.iter().flat_map(|track| track.samples.iter().map(|at| at.cop.y.abs()));
        assert!(heights.fold(0.0, f64::max) > 0.2, "it goes up or down");
    }
}

#[test]
fn a_motion_without_reactions_has_nothing_to_compute_from() {
    let figure = person(1.75);
    let (plan, _) = walked(&figure, &steps(110.0, 2), 60.0);
    let mut motion = plan.motion(&figure, 60.0).expect("a motion");
    let refused = reactions_from_feet(&figure, &mut motion, FEET).expect_err("no contacts");
    assert_eq!(refused, ReactionError::NoContacts { link: FEET[0].to_owned() });
}
