//! Feet that are placed once answer as feet that are placed for one question.

use super::support::{GRAVITY, person, swaying};
use crate::states::{consistent_shift, find_stances, ground_forces};
use solaris_analysis::PreparedMotion;
use solaris_analysis::ground::{
    self, ConsistencyOptions, GroundOptions, PlacedFeet, Split, StanceOptions, soles,
};

#[test]
fn many_questions_have_the_answers_of_one() {
    let figure = person();
    let (states, soles) = (swaying(&figure, 60, 0.02), soles(&figure));
    let motion = states.motion(&figure, GRAVITY).expect("a motion");
    let prepared = PreparedMotion::new(&figure, &motion).expect("ready");
    let feet = PlacedFeet::new(&prepared, &*soles).expect("placed");

    let still = StanceOptions { speed: Some(0.1), ..StanceOptions::default() };
    let stances = [StanceOptions::default(), still].map(|options| {
        let together = ground::find_stances(&feet, &options).expect("stances");
        assert_eq!(together, find_stances(&figure, GRAVITY, &states, &soles, &options).expect("stances"));
        together
    });
    assert!(!stances[0].list.is_empty() && stances[0].list != stances[1].list, "{stances:?}");
    for split in Split::ALL {
        for stances in [None, Some(stances[1].clone())] {
            let options = GroundOptions { split, stances, ..GroundOptions::default() };
            let together = ground::ground_forces(&feet, &options).expect("forces");
            let alone = ground_forces(&figure, GRAVITY, &states, &soles, &options).expect("forces");
            assert_eq!(together, alone, "{}", split.name());
        }
    }
    let options = ConsistencyOptions::default();
    let together = ground::consistent_shift(&feet, &stances[0], &options).expect("a shift");
    let alone = consistent_shift(&figure, GRAVITY, &states, &soles, &stances[0], &options).expect("a shift");
    assert_eq!(together, alone);
}
