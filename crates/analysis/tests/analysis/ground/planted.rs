//! Motions that say themselves where their feet are planted.

use crate::ground::support::{GRAVITY, ground, person, steps, swaying};
use solaris_analysis::ground::{Split, reactions_of_planted, soles};
use solaris_model::{Contact, ContactTrack, Interval, Vector3};

/// What the motion is given is what is found of stances that are told, whatever the soles do meanwhile, and by the split that is asked for.
#[test]
fn a_foot_stands_while_it_is_planted_and_shares_as_it_is_told() {
    let figure = person();
    let (states, feet) = (swaying(&figure, 101, 0.1), soles(&figure));
    let found = Split::ALL.map(|split| {
        let mut motion = states.motion(&figure, GRAVITY).expect("a motion");
        let planted = steps().list.into_iter().map(|stance| {
            let sole = &feet[stance.foot];
            Interval { link: sole.foot, point: sole.heel, start: stance.start, end: stance.end }
        });
        motion.planted = planted.collect();
        let (report, residual) = reactions_of_planted(&figure, &mut motion, split).expect("forces");
        assert_eq!(report.split, split);
        assert!(residual.force < 1e-10 && residual.moment < 1e-10, "{}: {residual:?}", split.name());
        assert_eq!(motion.contacts, ground(&figure, &states, split, steps()).contacts, "{}", split.name());
        motion.contacts
    });
    for [left, right] in
        found.each_ref().map(|found| <&[ContactTrack; 2]>::try_from(&found[..]).expect("two feet"))
    {
        for (row, t) in states.time.iter().enumerate() {
            let [left, right]: [&Contact; 2] = [&left.samples[row], &right.samples[row]];
            // Both from 0.2 s to 0.35 s and from 0.65 s to 0.8 s.
            if *t < 0.2 || *t > 0.8 {
                assert_eq!(right.force, Vector3::zeros());
            } else if *t > 0.35 && *t < 0.65 {
                assert_eq!(left.force, Vector3::zeros());
            }
        }
    }
    let [transition, pivot, effort] = &found;
    assert!(transition != pivot && pivot != effort && effort != transition);
}
