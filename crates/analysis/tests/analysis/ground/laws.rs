//! What holds of any split of any motion.

use crate::ground::support::{GRAVITY, ground, person, steps, swaying, swaying_at};
use crate::states::inverse_loaded;
use approx::assert_relative_eq;
use solaris_analysis::ground::{Split, Stances, soles};
use solaris_analysis::{FootSupport, split_at_pivot};
use solaris_dynamics::Wrench;
use solaris_model::Vector3;

#[test]
fn contacts_add_up_to_the_whole_and_leave_nothing_at_the_root() {
    let figure = person();
    let states = swaying(&figure, 101, 0.1);
    for split in Split::ALL {
        let ground = ground(&figure, &states, split, steps());
        let weight = ground.report.weight;
        for (row, total) in ground.total.iter().enumerate() {
            let sum = |part: fn(&solaris_model::Contact) -> Vector3<f64>| {
                ground.contacts.iter().map(|track| part(&track.samples[row])).sum::<Vector3<f64>>()
            };
            assert_relative_eq!(sum(|c| c.force), total.force, epsilon = 1e-12 * weight);
            assert_relative_eq!(sum(|c| c.moment), total.moment, epsilon = 1e-12 * weight);
        }
        let report = inverse_loaded(&figure, GRAVITY, &states, &ground.loads());
        let left = report.residual;
        assert!(left.force < 1e-10 && left.moment < 1e-10, "{}: {left:?}", split.name());
    }
}

#[test]
fn a_foot_that_does_not_stand_has_nothing_and_one_alone_has_all() {
    let figure = person();
    let states = swaying(&figure, 101, 0.1);
    for split in Split::ALL {
        let ground = ground(&figure, &states, split, steps());
        for (row, total) in ground.total.iter().enumerate() {
            let [left, right] = [0, 1].map(|foot| ground.contacts[foot].samples[row]);
            if total.time < 0.2 || total.time > 0.8 {
                assert_eq!((left.force, left.moment), (total.force, total.moment));
                assert_eq!((right.force, right.moment), (Vector3::zeros(), Vector3::zeros()));
            } else if total.time > 0.35 && total.time < 0.65 {
                assert_eq!(right.force, total.force);
            }
        }
        assert_eq!(ground.report.irregular, 0);
    }
}

/// Five thousand frames a second: nothing jumps by a hundredth of the weight where feet come and leave.
#[test]
fn forces_are_continuous() {
    let figure = person();
    let states = swaying_at(&figure, 5001, 5000.0, 0.02);
    for split in Split::ALL {
        let ground = ground(&figure, &states, split, steps());
        for track in &ground.contacts {
            let jumps = track.samples.windows(2).map(|pair| (pair[1].force - pair[0].force).norm());
            let worst = jumps.fold(0.0, f64::max) / ground.report.weight;
            assert!(worst < 0.01, "{}: {worst}", split.name());
        }
    }
}

/// Standing still, shares and centres of pressure can be read off the contacts.
#[test]
fn the_pivot_split_is_that_of_its_formula() {
    let figure = person();
    let states = swaying(&figure, 101, 0.0);
    let standing = Stances {
        list: [0, 1].map(|foot| solaris_analysis::ground::Stance { foot, start: -1.0, end: 2.0 }).to_vec(),
        ..steps()
    };
    let ground = ground(&figure, &states, Split::Pivot, standing);
    let total = &ground.total[50];
    let feet = [0, 1].map(|foot| FootSupport { share: 0.5, cop: ground.contacts[foot].samples[50].cop });
    let wrench = Wrench { force: total.force, moment: total.moment };
    let parts = split_at_pivot(&wrench, &total.com, &Vector3::y(), 1.4297, &feet).expect("pressed");
    for (foot, part) in parts.iter().enumerate() {
        assert_relative_eq!(ground.contacts[foot].samples[50].force, part.force, epsilon = 1e-9);
        assert_relative_eq!(ground.contacts[foot].samples[50].moment, part.moment, epsilon = 1e-9);
    }
}

#[test]
fn soles_of_a_person_are_its_own() {
    let figure = person();
    let soles = soles(&figure);
    let names: Vec<&str> = soles.iter().map(|sole| sole.name.as_str()).collect();
    assert_eq!(names, ["left_foot", "right_foot"]);
    for sole in &soles {
        assert_eq!(sole.toes.map(|toes| figure.links()[toes].parent()), Some(Some(sole.foot)));
        assert!(sole.width.is_some_and(|width| (0.08..0.11).contains(&width)), "{:?}", sole.width);
    }
}
