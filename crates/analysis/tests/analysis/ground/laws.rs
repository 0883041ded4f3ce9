//! What holds of any split of any motion.

use crate::ground::support::{GRAVITY, ground, person, steps, swaying, swaying_at};
use crate::states::inverse_loaded;
use approx::assert_relative_eq;
use solaris_analysis::ground::{Footing, Split, Stance, Stances, soles};
use solaris_analysis::{FootSupport, split_at_pivot};
use solaris_dynamics::Wrench;
use solaris_model::{Contact, Vector3};

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

/// As told of the contacts themselves, on level ground and on a slope.
#[test]
fn friction_is_what_is_along_the_ground_over_what_is_across() {
    let figure = person();
    let states = swaying(&figure, 101, 0.1);
    for tilt in [0.0_f64, 0.2] {
        let normal = Vector3::new(0.0, tilt.cos(), -tilt.sin());
        let footings = steps().list.iter().map(|_| Footing { point: Vector3::zeros(), normal }).collect();
        let ground = ground(&figure, &states, Split::Pivot, Stances { footings, ..steps() });
        for (track, report) in ground.contacts.iter().zip(&ground.report.feet) {
            let ratios = track.samples.iter().enumerate().map(|(row, contact)| {
                let is_loaded = contact.force.y > 0.05 * ground.report.weight;
                let pressed = contact.force.dot(&normal);
                (row, if is_loaded { contact.force.cross(&normal).norm() / pressed } else { 0.0 })
            });
            let (row, most) = ratios.max_by(|a, b| a.1.total_cmp(&b.1)).expect("frames");
            let told = report.friction.expect("it bears something");
            assert_relative_eq!(told.value, most, epsilon = 1e-9);
            assert_relative_eq!(told.time, states.time[row]);
        }
    }
}

/// One foot stands 0.2 m higher than the other: whoever stands still presses half-way up, below the centre of mass, wherever it is told
/// of the two levels where they are.
#[test]
fn feet_at_two_heights_press_half_way_up() {
    let figure = person();
    let states = swaying(&figure, 3, 0.0);
    let list = vec![Stance { foot: 0, start: -1.0, end: 1.0 }, Stance { foot: 1, start: -1.0, end: 1.0 }];
    let level = |x, y, z| Footing { point: Vector3::new(x, y, z), normal: Vector3::y() };
    for footings in
        [[level(0.0, 0.0, 0.0), level(0.0, 0.2, 0.0)], [level(5.0, 0.0, 3.0), level(-7.0, 0.2, 1.0)]]
    {
        let stances = Stances { list: list.clone(), footings: footings.to_vec(), ..steps() };
        for frame in ground(&figure, &states, Split::Pivot, stances).total {
            let cop = frame.cop.expect("pressed");
            assert_relative_eq!(cop, Vector3::new(0.0, 0.1, frame.com.z), epsilon = 1e-12);
        }
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

/// In a double support of walking, shares and centres of pressure can be read off the contacts.
#[test]
fn the_pivot_split_is_that_of_its_formula() {
    let figure = person();
    let states = swaying(&figure, 101, 0.0);
    let ground = ground(&figure, &states, Split::Pivot, steps());
    for row in [24, 27, 70] {
        let total = &ground.total[row];
        let contacts = [0, 1].map(|foot| ground.contacts[foot].samples[row]);
        let feet = contacts.map(|own| FootSupport::level(own.force.y / total.force.y, own.cop));
        let wrench = Wrench { force: total.force, moment: total.moment };
        let parts = split_at_pivot(&wrench, &total.com, &Vector3::y(), 1.4297, &feet).expect("pressed");
        for (contact, part) in contacts.iter().zip(&parts) {
            assert_relative_eq!(contact.force, part.force, epsilon = 1e-9);
            assert_relative_eq!(contact.moment, part.moment, epsilon = 1e-9);
        }
    }
}

/// Who stands still has the hips above the feet here, so that nothing pushes the feet apart; the pivot alone would by 24 N.
#[test]
fn forces_of_feet_that_stand_still_point_at_the_hips() {
    let figure = person();
    let states = swaying(&figure, 101, 0.0);
    let standing =
        Stances { list: [0, 1].map(|foot| Stance { foot, start: -1.0, end: 2.0 }).to_vec(), ..steps() };
    let ground = ground(&figure, &states, Split::Pivot, standing);
    for track in &ground.contacts {
        let Contact { force, .. } = track.samples[50];
        assert_relative_eq!(force.y, ground.report.weight / 2.0, epsilon = 1e-9);
        assert!(force.x.abs() < 1e-9, "{force}");
    }
}

/// Abducted legs: the hips lean inwards over the feet by as much as the legs do, and so do the forces.
#[test]
fn forces_of_feet_apart_lean_as_the_legs_do() {
    let figure = person();
    let mut states = swaying(&figure, 101, 0.0);
    let spread: f64 = 0.2;
    let dofs = ["left_hip.rz", "right_hip.rz", "left_ankle.rz", "right_ankle.rz"]
        .map(|name| figure.layout().v_names().iter().position(|dof| dof == name).expect("a dof of the legs"));
    let nv = figure.layout().nv();
    for row in 0..states.time.len() {
        for (dof, angle) in dofs.into_iter().zip([spread, -spread, -spread, spread]) {
            states.q[row * nv + dof] = angle;
        }
    }
    let standing =
        Stances { list: [0, 1].map(|foot| Stance { foot, start: -1.0, end: 2.0 }).to_vec(), ..steps() };
    let ground = ground(&figure, &states, Split::Pivot, standing);
    let leans = ground.contacts.iter().map(|track| track.samples[50].force).map(|force| force.x / force.y);
    let leans: Vec<f64> = leans.collect();
    // The soles are a little below the ankles, which the ankles' turn takes out of the line.
    assert!((leans[0].abs() - spread.tan()).abs() < 0.03, "{leans:?}");
    assert_relative_eq!(leans[0], -leans[1], epsilon = 1e-9);
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
