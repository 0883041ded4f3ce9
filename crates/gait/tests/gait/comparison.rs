//! A smooth walk beside the key postures of the same step.

use solaris_gait::determinants::Determinants;
use solaris_gait::{Extent, WalkRequest, walk};
use solaris_model::human;

#[test]
fn postures_are_compared_at_the_instants_that_they_are_of() {
    let figure = human(1.75, 73.0).expect("a person");
    let request = WalkRequest { extent: Extent::Steps(10), ..WalkRequest::default() };
    let plan = walk(&figure, &request).expect("it can be walked");
    let five = plan.compare_postures(Determinants::Five).expect("five determinants");
    let [strike, lift_off, passing, stretch] = &five[..] else { panic!("{five:?}") };
    assert_eq!(
        [strike.name, lift_off.name, passing.name, stretch.name],
        ["heel strike", "lift-off", "passing", "stretch"]
    );
    // In the order of time, within a step.
    let step = 60.0 / 110.0;
    assert!(five.windows(2).all(|pair| pair[0].time < pair[1].time) && stretch.time - strike.time < step);
    // Hip over ankle; shank upright before it lands.
    let leg = solaris_gait::LegGeometry::of(&figure).expect("legs");
    let over = leg.thigh * passing.walk[0].thigh.sin() + leg.shank * passing.walk[0].shank.sin();
    assert!(over.abs() < 1e-6, "{over}");
    assert!(stretch.walk[1].shank.abs() < 1e-6, "{stretch:?}");
    // The foot that strikes is toe up by the style's angle, and flat as it carries.
    assert!((strike.walk[0].foot + plan.style().heel_strike_angle).abs() < 2e-3);
    assert!(lift_off.walk[0].foot.abs() < 1e-6 && passing.walk[0].foot.abs() < 1e-6);
    let three = plan.compare_postures(Determinants::Three).expect("three determinants");
    assert_eq!(three.len(), 2);
    assert!(
        three[1].time > three[0].time && five.iter().all(|b| b.deviations().iter().all(|d| d.abs() < 1.0))
    );
}
