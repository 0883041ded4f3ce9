//! Motions at the edge of what has ground forces, and beyond.

use crate::ground::support::{GRAVITY, ground, person, steps, swaying};
use crate::states::{States, find_stances, ground_forces};
use approx::assert_relative_eq;
use solaris_analysis::ground::{
    Belt, GroundError, GroundOption, GroundOptions, Split, Stance, StanceOptions, Stances, soles,
};
use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, SolePart, Vector3};

fn refused(states: &States, options: &GroundOptions, gravity: Vector3<f64>) -> GroundError {
    let figure = person();
    let refused = ground_forces(&figure, gravity, states, &soles(&figure), options).expect_err("a refusal");
    *refused.downcast().expect("of the ground")
}

/// What is no motion at all is refused before the ground is asked.
fn no_motion(states: &States, gravity: Vector3<f64>) -> String {
    let figure = person();
    let options = GroundOptions::default();
    ground_forces(&figure, gravity, states, &soles(&figure), &options).expect_err("a refusal").to_string()
}

#[test]
fn what_cannot_be_is_refused_by_name() {
    let figure = person();
    let (states, options) = (swaying(&figure, 5, 0.1), GroundOptions::default());
    assert!(matches!(refused(&states, &options, Vector3::zeros()), GroundError::NoGravity { .. }));
    assert!(no_motion(&states, Vector3::repeat(f64::NAN)).contains("gravity"));
    let mut bad = states.clone();
    bad.a[40] = f64::NAN;
    assert!(no_motion(&bad, GRAVITY).contains("it must be a finite number"));
    let mut bad = states.clone();
    bad.time[3] = bad.time[2];
    assert!(matches!(refused(&bad, &options, GRAVITY), GroundError::Time { frame: 3, .. }));
    let mut bad = states.clone();
    bad.q.pop();
    assert!(no_motion(&bad, GRAVITY).starts_with("q has 329 numbers; 5 samples of 66 make 330"));
    assert_eq!(refused(&States::default(), &options, GRAVITY), GroundError::Empty);
    let (still, belt) = (StanceOptions::default(), Belt::Speed(Vector3::repeat(f64::NAN)));
    for (stance, number) in [
        (StanceOptions { height: Some(f64::NAN), ..still }, GroundOption::Height),
        (StanceOptions { speed: Some(0.0), ..still }, GroundOption::Speed),
        (StanceOptions { shortest: -0.1, ..still }, GroundOption::Shortest),
        (StanceOptions { belt, ..still }, GroundOption::Belt),
    ] {
        let options = GroundOptions { stance, ..GroundOptions::default() };
        let error = refused(&states, &options, GRAVITY);
        assert!(matches!(error, GroundError::Option { option, .. } if option == number), "{error}");
    }
    for stance in [
        Stance { foot: 2, start: 0.0, end: 1.0 },
        Stance { foot: 0, start: 1.0, end: 0.0 },
        Stance { foot: 0, start: f64::NAN, end: 0.0 },
    ] {
        let stances = Some(Stances { list: vec![stance], ..steps() });
        let options = GroundOptions { stances, ..GroundOptions::default() };
        assert!(matches!(refused(&states, &options, GRAVITY), GroundError::Stance { stance: 0, .. }));
    }
    for speed in [f64::NAN, f64::INFINITY] {
        let stances = Some(Stances { belt: Vector3::new(0.0, 0.0, speed), ..steps() });
        let options = GroundOptions { stances, ..GroundOptions::default() };
        let error = refused(&states, &options, GRAVITY);
        assert!(matches!(error, GroundError::Option { option: GroundOption::Belt, .. }), "{error}");
    }
}

#[test]
fn a_figure_without_soles_is_told_what_it_lacks() {
    let body = LinkSpec::root("body", Joint::new("lift").ty()).mass(2.0);
    let figure = FigureBuilder::new("lift").link(body).build().expect("valid");
    let states = States { time: vec![0.0], q: vec![0.0], v: vec![0.0], a: vec![0.0], ..States::default() };
    let error = ground_forces(&figure, GRAVITY, &states, &soles(&figure), &GroundOptions::default());
    let text = error.expect_err("a refusal").to_string();
    assert_eq!(
        text,
        "figure 'lift' has no soles; give its feet sole points (heel, ball, toe tip), or name the soles"
    );
}

/// Falling freely, nothing needs a ground, and moving soles do not stand.
#[test]
fn in_flight_no_foot_stands_and_nothing_is_left_over() {
    let figure = person();
    let mut states = swaying(&figure, 60, 0.0);
    let nv = figure.layout().nv();
    for (row, t) in states.time.iter().enumerate() {
        states.q[row * nv + 1] = 2.0 - 4.0 * t + GRAVITY.y * t * t / 2.0;
        states.v[row * nv + 1] = -4.0 + GRAVITY.y * t;
        states.a[row * nv + 1] = GRAVITY.y;
    }
    let forces = ground_forces(&figure, GRAVITY, &states, &soles(&figure), &GroundOptions::default());
    let forces = forces.expect("no forces");
    assert_eq!(forces.stances.list, []);
    let left = forces.report.unsupported;
    assert_eq!(left.frames, 60);
    assert!(left.force < 1e-10 * forces.report.weight, "{left:?}");
    assert!(
        forces
            .contacts
            .iter()
            .flat_map(|track| &track.samples)
            .all(|contact| contact.force == Vector3::zeros())
    );
}

#[test]
fn one_frame_is_a_motion() {
    let figure = person();
    let states = swaying(&figure, 1, 0.0);
    for split in Split::ALL {
        let options = GroundOptions { split, ..GroundOptions::default() };
        let forces = ground_forces(&figure, GRAVITY, &states, &soles(&figure), &options).expect("forces");
        for track in &forces.contacts {
            assert_relative_eq!(track.samples[0].force.y, forces.report.weight / 2.0, epsilon = 1e-6);
        }
        assert_eq!(forces.report.irregular, 1);
    }
}

/// A ground that would have to pull is told, and the sum is still the whole.
#[test]
fn a_ground_that_pulls_is_reported() {
    let figure = person();
    let mut states = swaying(&figure, 101, 0.05);
    let nv = figure.layout().nv();
    for row in 20..=35 {
        states.a[row * nv + 1] = -15.0;
    }
    for split in Split::ALL {
        let forces = ground(&figure, &states, split, steps());
        let least = forces.report.feet[0].least.expect("it stands");
        assert!(least.value < 0.0 && least.share > 0.0, "{}: {least:?}", split.name());
        let (total, sum) =
            (forces.total[27].force, forces.contacts.iter().map(|track| track.samples[27].force).sum());
        assert!(total.y < 0.0);
        assert_relative_eq!(total, sum, epsilon = 1e-9);
    }
}

#[test]
fn a_belt_is_found_and_its_feet_stand_on_it() {
    let figure = person();
    let mut states = swaying(&figure, 101, 0.0);
    let nv = figure.layout().nv();
    for (row, t) in states.time.iter().enumerate() {
        states.q[row * nv + 2] = -1.2 * t;
        states.v[row * nv + 2] = -1.2;
    }
    let find = |belt| {
        let options = StanceOptions { belt, ..StanceOptions::default() };
        find_stances(&figure, GRAVITY, &states, &soles(&figure), &options).expect("stances")
    };
    let found = find(Belt::Auto);
    assert_relative_eq!(found.belt, Vector3::new(0.0, 0.0, -1.2), epsilon = 1e-12);
    assert_eq!(found.list.len(), 2);
    assert_eq!(find(Belt::Still).list, []);
    assert_eq!(find(Belt::Speed(found.belt)).list, found.list);
}

/// A body that walks over a foot that moves evenly. What moves with the ground is less than a quarter of the speed of
/// travel over it on a foot that rolls, and all of it on a walkway.
#[test]
fn a_belt_is_told_by_how_fast_the_body_travels_over_it() {
    let foot = LinkSpec::root("foot", Joint::new("root").tx().ty().tz()).mass(10.0);
    let foot = foot
        .sole(SolePart::Heel, Vector3::new(0.0, 0.0, -0.1))
        .sole(SolePart::Ball, Vector3::new(0.0, 0.0, 0.1))
        .sole(SolePart::ToeTip, Vector3::new(0.0, 0.0, 0.15));
    let body = LinkSpec::child("body", "foot", Joint::new("way").tz()).mass(60.0);
    let figure = FigureBuilder::new("walker").link(foot).link(body.com(Vector3::y())).build().expect("valid");
    // The centre of mass travels at 1 m/s: at 0.7 m/s over a foot that is faster than a quarter of that, and at 1.22 m/s over one that is slower.
    for (speed, belt) in [(0.3, 0.3), (-0.22, 0.0)] {
        let way = (1.0 - speed) * 70.0 / 60.0;
        let mut states = States { a: vec![0.0; 4 * 101], ..States::default() };
        for t in (0..=100).map(|row| f64::from(row) / 100.0) {
            states.time.push(t);
            states.q.extend([0.0, 0.0, speed * t, way * t]);
            states.v.extend([0.0, 0.0, speed, way]);
        }
        let options = StanceOptions::default();
        let found = find_stances(&figure, GRAVITY, &states, &soles(&figure), &options).expect("stances");
        assert_relative_eq!(found.belt, Vector3::new(0.0, 0.0, belt), epsilon = 1e-12);
    }
}

/// A table on three paws, the first of them in front.
fn table() -> Figure {
    let mut builder = FigureBuilder::new("table").link(
        LinkSpec::root("top", Joint::new("root").tx().ty().tz()).mass(9.0).com(Vector3::new(0.1, 0.0, 0.0)),
    );
    for (name, x, z) in [("a", 0.5, 0.0), ("b", -0.3, 0.4), ("c", -0.3, -0.4)] {
        let joint = Joint::new(format!("hinge_{name}")).at(Vector3::new(x, 0.0, z)).rx();
        let spec = LinkSpec::child(name, "top", joint).mass(1.0).com(Vector3::new(0.0, -0.4, 0.0));
        builder = builder.link(spec.sole(SolePart::Ball, Vector3::new(0.0, -0.8, 0.0)));
    }
    builder.build().expect("valid")
}

/// Two paws stand throughout, and the third for four seconds: it has the weight `3x² − 2x³` of their 1 each, rising for two seconds and
/// falling for two, of the sum of all.
#[test]
fn three_shares_rise_and_fall_and_add_up_to_one() {
    let figure = table();
    let time = vec![0.5, 1.0, 2.0, 3.0, 3.5];
    let [q, v, a] = [(); 3].map(|()| vec![0.0; figure.layout().nv() * time.len()]);
    let states = States { time, q, v, a, ..States::default() };
    let stance = |foot, start, end| Stance { foot, start, end };
    let list = vec![stance(0, -10.0, 10.0), stance(1, -10.0, 10.0), stance(2, 0.0, 4.0)];
    let ground = ground(&figure, &states, Split::Pivot, Stances { list, ..steps() });
    for (row, third) in [0.15625, 0.5, 1.0, 0.5, 0.15625].into_iter().enumerate() {
        for (track, own) in ground.contacts.iter().zip([1.0, 1.0, third]) {
            let expected = ground.report.weight * own / (2.0 + third);
            assert_relative_eq!(track.samples[row].force.y, expected, epsilon = 1e-9);
        }
    }
}

#[test]
fn three_feet_share_by_two_splits_and_not_by_the_third() {
    let figure = table();
    let paws = soles(&figure);
    assert_eq!(paws.len(), 3);
    let nv = figure.layout().nv();
    let states = States {
        time: vec![0.0, 0.1],
        q: vec![0.0; 2 * nv],
        v: vec![0.0; 2 * nv],
        a: vec![0.0; 2 * nv],
        ..States::default()
    };
    for split in [Split::Pivot, Split::Effort] {
        let options = GroundOptions { split, ..GroundOptions::default() };
        let forces = ground_forces(&figure, GRAVITY, &states, &paws, &options).expect("forces");
        for frame in 0..2 {
            let sum: Vector3<f64> = forces.contacts.iter().map(|track| track.samples[frame].force).sum();
            assert_relative_eq!(sum, forces.total[frame].force, epsilon = 1e-11);
            let moment: Vector3<f64> = forces.contacts.iter().map(|track| track.samples[frame].moment).sum();
            assert_relative_eq!(moment, forces.total[frame].moment, epsilon = 1e-11);
        }
    }
    let options = GroundOptions { split: Split::Transition, ..GroundOptions::default() };
    let error = ground_forces(&figure, GRAVITY, &states, &paws, &options).expect_err("a refusal");
    assert!(matches!(error.downcast_ref(), Some(GroundError::TooManyFeet { feet: 3, .. })));
}
