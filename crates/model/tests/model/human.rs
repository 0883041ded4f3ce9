//! The human figure: counts, mass, symmetry, ranges.

use solaris_model::{Figure, Human, HumanError, Link, SolePart, Vector3, human};

fn ordinary() -> Figure {
    human(1.75, 73.0).expect("an ordinary human")
}

/// Heights (m) and masses (kg) over the whole range of both.
fn bodies() -> Vec<(f64, f64)> {
    let heights = (0..=30).map(|i| 0.8 + 1.5 * f64::from(i) / 30.0);
    heights.flat_map(|h| (0..=40).map(move |i| (h, (8.0 + 72.0 * f64::from(i) / 40.0) * h * h))).collect()
}

#[test]
fn there_are_21_links_and_66_dofs() {
    let figure = ordinary();
    assert_eq!(figure.links().len(), 21);
    assert_eq!((figure.layout().nq(), figure.layout().nv()), (66, 66));
    let joints: Vec<&str> = figure.links().iter().map(|link| link.joint().name()).collect();
    insta::assert_snapshot!(joints.join(" "), @"root lumbar thorax neck head left_clavicle left_shoulder left_elbow left_wrist left_hip left_knee left_ankle left_toes right_clavicle right_shoulder right_elbow right_wrist right_hip right_knee right_ankle right_toes");
    for link in figure.links().iter().skip(1) {
        let name = link.joint().name();
        let joint = figure.layout().joints()[figure.joint_index(name).expect("its own joint")];
        let names = &figure.layout().v_names()[joint.v..joint.v + joint.nv];
        assert_eq!(names, ["rz", "ry", "rx"].map(|axis| format!("{name}.{axis}")));
    }
}

#[test]
fn the_mass_is_the_one_asked_for() {
    for (height, mass) in bodies().into_iter().filter(|(h, m)| (8.0..=80.0).contains(&(m / (h * h)))) {
        let figure = human(height, mass).expect("in range");
        let total: f64 = figure.links().iter().map(Link::mass).sum();
        assert!((total / mass - 1.0).abs() < 1e-14, "{height} m, {mass} kg: {total} kg");
        assert!((figure.mass() / mass - 1.0).abs() < 1e-14);
        assert!(figure.links().iter().all(|link| link.mass() > 0.0));
    }
}

#[test]
fn lengths_follow_the_height_and_masses_the_mass() {
    let (small, large) = (ordinary(), human(0.875, 36.5).expect("in range"));
    for (a, b) in small.links().iter().zip(large.links()) {
        let close = |x: Vector3<f64>, y: Vector3<f64>| (x - y).norm() < 1e-15;
        assert!(close(a.com() / 2.0, *b.com()), "{}", a.name());
        assert!(close(
            a.joint().placement().translation.vector / 2.0,
            b.joint().placement().translation.vector
        ));
        assert!((a.mass() / 2.0 - b.mass()).abs() < 1e-14);
        // m k² L²: half the mass, a quarter of the length's square.
        assert!((a.inertia() / 8.0 - b.inertia()).amax() < 1e-15);
    }
}

#[test]
fn left_and_right_are_mirror_images() {
    let figure = ordinary();
    let mirror = |v: &Vector3<f64>| Vector3::new(-v.x, v.y, v.z);
    let mut pairs = 0;
    for left in figure.links().iter().filter(|link| link.name().starts_with("left_")) {
        let right = figure.link(&left.name().replace("left_", "right_")).expect("a right one");
        assert_eq!(right.com(), &mirror(left.com()), "{}", left.name());
        assert_eq!((right.mass(), right.inertia()), (left.mass(), left.inertia()));
        let origin = |link: &Link| link.joint().placement().translation.vector;
        assert_eq!(origin(right), mirror(&origin(left)));
        assert_eq!(right.tip().copied(), left.tip().map(mirror));
        let soles =
            |link: &Link| link.sole().iter().map(|point| (point.part, point.position)).collect::<Vec<_>>();
        let mirrored: Vec<_> = soles(left).iter().map(|(part, p)| (*part, mirror(p))).collect();
        assert_eq!(soles(right), mirrored);
        // Turns about the axes in the plane of symmetry change their sign, those about x keep it.
        for (l, r) in left.joint().kind().axes().iter().zip(right.joint().kind().axes()) {
            assert_eq!(l.axis, r.axis);
            let (l_limits, r_limits) = (l.limits.expect("a range"), r.limits.expect("a range"));
            let same = l.axis.direction == Vector3::x();
            let expected =
                if same { (l_limits.lower, l_limits.upper) } else { (-l_limits.upper, -l_limits.lower) };
            assert_eq!((r_limits.lower, r_limits.upper), expected, "{}", left.joint().name());
        }
        pairs += 1;
    }
    assert_eq!(pairs, 8);
    for middle in figure.links().iter().filter(|link| !link.name().contains('_')) {
        assert_eq!(
            (middle.com().x, middle.joint().placement().translation.x),
            (0.0, 0.0),
            "{}",
            middle.name()
        );
    }
}

#[test]
fn anatomical_angles_come_in_pairs_with_the_mirrors_sign() {
    let figure = ordinary();
    for left in figure.anatomical_angles().iter().filter(|angle| angle.name.starts_with("left_")) {
        let right = figure.anatomical_angle(&left.name.replace("left_", "right_")).expect("a right one");
        let dof = &figure.layout().v_names()[left.dof];
        assert_eq!(figure.layout().v_names()[right.dof], dof.replace("left_", "right_"));
        let expected = if dof.rsplit('.').next() == Some("rx") { left.sign } else { -left.sign };
        assert_eq!(right.sign.to_bits(), expected.to_bits(), "{}", left.name);
    }
}

#[test]
fn the_feet_stand_on_one_plane() {
    for (height, mass) in [(0.8, 10.0), (1.75, 73.0), (2.3, 200.0)] {
        let figure = human(height, mass).expect("in range");
        let part = |link: &str, part| *figure.link(link).expect("a link").sole_point(part).expect("a point");
        let toes = figure.link("left_toes").expect("a link").joint().placement().translation.vector;
        let heel = part("left_foot", SolePart::Heel);
        for point in [
            part("left_foot", SolePart::Ball),
            toes + part("left_toes", SolePart::Ball),
            toes + part("left_toes", SolePart::ToeTip),
        ] {
            assert!((point.y - heel.y).abs() < 1e-15, "{height} m: {point:?}");
        }
    }
}

/// Height of a link's origin above the pelvis' in the neutral posture.
fn above_pelvis(figure: &Figure, link: &Link) -> f64 {
    let parent = link.parent().map(|parent| &figure.links()[parent]);
    parent.map_or(0.0, |parent| above_pelvis(figure, parent) + link.joint().placement().translation.y)
}

/// From the sole to the head's tip, and to the top of what is drawn.
fn standing_heights(figure: &Figure) -> [f64; 2] {
    let (head, foot) = (figure.link("head").expect("a head"), figure.link("left_foot").expect("a foot"));
    let sole = above_pelvis(figure, foot) + foot.sole_point(SolePart::Heel).expect("a heel").y;
    let from = above_pelvis(figure, head) - sole;
    let shape = head.shape().expect("a shape");
    let top = shape.placement.translation.y + shape.kind.reach(&Vector3::y());
    [from + head.tip().expect("a tip").y, from + top]
}

#[test]
fn the_vertex_stands_at_the_height_that_was_asked_for() {
    for height in (0..=9).map(|i| 1.2 + 0.1 * f64::from(i)) {
        for index in [17.0, 23.8, 45.0] {
            let human = Human::new(height, index * height * height);
            let ages = [6.0, 7.3, 12.0, 17.9, 18.0, 40.0].map(|age| human.clone().age(age));
            for human in [human.clone(), human.limp()].iter().chain(&ages) {
                let figure = human.build().expect("in range");
                for found in standing_heights(&figure) {
                    assert!((found - height).abs() < 1e-12, "{height} m stands {found} m: {human:?}");
                }
            }
        }
    }
}

/// Joints against heights of landmarks of 4082 men (ANSUR II, means of fractions of the height).
#[test]
fn joints_stand_where_peoples_do() {
    let figure = human(1.0, 22.0).expect("in range");
    let pelvis = standing_heights(&figure)[0] - {
        let head = figure.link("head").expect("a head");
        above_pelvis(&figure, head) + head.tip().expect("a tip").y
    };
    for (link, landmark, published, within) in [
        ("abdomen", "omphalion", 0.6014, 0.015),
        ("left_clavicle", "suprasternale", 0.8191, 0.012),
        ("left_upper_arm", "acromion", 0.8203, 0.003),
        ("neck", "cervicale", 0.8639, 0.021),
        ("left_shank", "middle of the patella", 0.2780, 0.017),
        ("left_foot", "lateral malleolus", 0.0415, 0.004),
    ] {
        let found = pelvis + above_pelvis(&figure, figure.link(link).expect("a link"));
        assert!((found - published).abs() < within, "{link} at {found}, {landmark} at {published}");
    }
}

/// What is drawn of trunk, neck and limbs weighs what the segment weighs.
#[test]
fn volumes_are_those_of_the_mass() {
    let density = |name: &str| match name.rsplit_once('_').map_or(name, |(_, name)| name) {
        "pelvis" | "abdomen" | "thorax" | "clavicle" => 1030.0,
        "neck" => 1110.0,
        "arm" => 1070.0,
        "forearm" => 1130.0,
        "thigh" => 1050.0,
        "shank" => 1090.0,
        _ => f64::NAN,
    };
    for (height, mass) in bodies().into_iter().filter(|(h, m)| (8.0..=80.0).contains(&(m / (h * h)))) {
        let figure = human(height, mass).expect("in range");
        for link in figure.links().iter().filter(|link| !density(link.name()).is_nan()) {
            let drawn = link.shape().expect("a shape").kind.volume() * density(link.name());
            assert!((drawn / link.mass() - 1.0).abs() < 1e-12, "{} of {height} m, {mass} kg", link.name());
        }
    }
}

#[test]
fn the_heavier_is_thicker_and_has_the_same_head() {
    let [slim, ordinary, heavy] = [55.0, 73.0, 140.0].map(|mass| human(1.75, mass).expect("in range"));
    let half = |figure: &Figure, link: &str| {
        let kind = figure.link(link).expect("a link").shape().expect("a shape").kind;
        [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| kind.reach(&axis))
    };
    for link in ["pelvis", "abdomen", "thorax", "neck", "left_thigh", "right_shank", "left_forearm"] {
        let [slim, ordinary, heavy] = [&slim, &ordinary, &heavy].map(|figure| half(figure, link));
        assert!(slim[0] < 0.96 * ordinary[0] && heavy[0] > 1.15 * ordinary[0], "{link}");
        assert!(slim[2] < 0.92 * ordinary[2] && heavy[2] > 1.25 * ordinary[2], "{link}");
    }
    for link in ["head", "left_hand", "right_foot", "left_toes"] {
        assert_eq!(half(&slim, link).map(f64::to_bits), half(&heavy, link).map(f64::to_bits), "{link}");
    }
}

#[test]
fn a_child_has_a_larger_head_and_shorter_legs() {
    let body = |age| Human::new(1.15, 21.0).age(age).build().expect("in range");
    let (six, adult) = (body(6.0), human(1.15, 21.0).expect("in range"));
    assert_eq!(body(18.0), adult, "to the bit");
    assert_eq!(body(50.0), adult);
    let share = |figure: &Figure, link: &str| figure.link(link).expect("a link").mass() / figure.mass();
    // Jensen's 18.2 % over 7.0 %, and what all of de Leva's shares come to by such factors.
    assert!((share(&six, "head") / share(&adult, "head") - 18.2 / 7.0).abs() < 0.1);
    assert!(share(&six, "left_thigh") < 0.8 * share(&adult, "left_thigh"));
    assert!((six.mass() - 21.0).abs() < 1e-12);
    let length = |figure: &Figure, link: &str| figure.link(link).expect("a link").tip().expect("a tip").y;
    assert!((length(&six, "head") / length(&adult, "head") - 0.1601 / 0.1250).abs() < 1e-12);
    let hips = |figure: &Figure| {
        let foot = figure.link("left_foot").expect("a foot");
        let thigh = figure.link("left_thigh").expect("a thigh");
        let sole = above_pelvis(figure, foot) + foot.sole_point(SolePart::Heel).expect("a heel").y;
        above_pelvis(figure, thigh) - sole
    };
    // The trochanter of Snyder's children of six stands at 0.4865 of the height, that of the grown at 0.5080.
    assert!((hips(&six) / hips(&adult) - 0.4865 / 0.5080).abs() < 0.01);
}

#[test]
fn a_joint_may_have_its_own_limits() {
    let human = Human::new(1.75, 73.0).limits("right_shoulder.rz", -3.0, -0.1);
    let figure = human.clone().build().expect("in range");
    let axes =
        |figure: &Figure, link: &str| figure.link(link).expect("a link").joint().kind().axes().to_vec();
    let limits = axes(&figure, "right_upper_arm")[0].limits.expect("limits");
    assert_eq!([limits.lower, limits.upper].map(f64::to_bits), [-3.0_f64, -0.1].map(f64::to_bits));
    assert_eq!(axes(&figure, "left_upper_arm"), axes(&ordinary(), "left_upper_arm"));
    let why = |human: Human| human.build().expect_err("refused").to_string();
    assert!(why(human.clone().limits("right_sholder.rz", 0.0, 1.0)).contains("right_shoulder.rz"));
    // A limp shoulder is a ball joint: it has no limits.
    assert!(why(human.limp()).contains("no angle of that name"));
    assert!(why(Human::new(1.75, 73.0).limits("left_elbow.rx", 1.0, 0.0)).contains("left_elbow"));
}

#[test]
fn a_segment_may_have_its_own_length() {
    let long =
        Human::new(1.75, 73.0).segment_length("thigh", 0.46).segment_length("left_shank", 0.40).build();
    let figure = long.expect("in range");
    let drop = |link: &str| figure.link(link).expect("a link").joint().placement().translation.y;
    assert!((drop("left_shank") + 0.46).abs() < 1e-12, "the knee hangs 0.46 m below the hip");
    assert!((drop("right_shank") + 0.46).abs() < 1e-12);
    assert!((drop("left_foot") + 0.40).abs() < 1e-12);
    assert!((drop("right_foot") + 0.434 * 1.75 / 1.741).abs() < 1e-12);
    assert!((figure.mass() - 73.0).abs() < 1e-12);
}

/// Whatever a fall does to it, no joint comes near lock as long as it stays near its range.
#[test]
fn a_limp_human_has_no_lock_within_its_range() {
    let limp = Human::new(1.75, 73.0).limp().build().expect("in range");
    assert_eq!((limp.links().len(), limp.layout().nq(), limp.layout().nv()), (21, 69, 66));
    for link in limp.links() {
        let [_, middle, _] = link.joint().kind().axes() else {
            assert!(link.joint().kind().quaternion().is_some(), "{}", link.joint().name());
            continue;
        };
        let range = middle.limits.expect("a range");
        let farthest = range.upper.max(-range.lower).to_degrees();
        assert!(farthest < 45.001, "{} turns by {farthest}° about its middle axis", link.joint().name());
    }
}

/// Masses, places and ranges are those of anybody.
#[test]
fn a_limp_human_is_the_same_body() {
    let (figure, limp) = (ordinary(), Human::new(1.75, 73.0).limp().build().expect("in range"));
    for (one, other) in figure.links().iter().zip(limp.links()) {
        assert_eq!((one.mass(), one.com(), one.inertia()), (other.mass(), other.com(), other.inertia()));
        let (one, other) = (one.joint(), other.joint());
        assert_eq!((one.name(), one.placement()), (other.name(), other.placement()));
        for dof in other.kind().axes() {
            let same = one.kind().axes().iter().find(|one| one.axis == dof.axis).expect("the same axis");
            assert_eq!(same.limits, dof.limits, "{}", one.name());
            assert!(dof.passive.damping > 0.0 && same.passive.is_none(), "{}", one.name());
        }
    }
    let left = limp.anatomical_angle("left_elbow.flexion").expect("an angle");
    assert_eq!(limp.layout().v_names()[left.dof], "left_elbow.rx");
    assert!(limp.anatomical_angle("left_shoulder.flexion").is_none());
    assert_eq!(figure.anatomical_angles().len() - limp.anatomical_angles().len(), 9);
}

/// Torques go with `m·g·h`, times with `√(h/g)`.
#[test]
fn damping_goes_with_the_size() {
    let damping = |height: f64, mass: f64| {
        let limp = Human::new(height, mass).limp().build().expect("in range");
        let knee = limp.joint_index("left_knee").expect("a knee");
        limp.links()[knee].joint().kind().passive(0).damping
    };
    assert!((damping(1.741, 73.0) - 0.5).abs() < 1e-15);
    let expected = damping(1.75, 73.0) * 0.5 * 0.5_f64.powf(1.5);
    assert!((damping(0.875, 36.5) - expected).abs() < 1e-15);
}

#[test]
fn what_is_no_human_is_refused_with_the_range() {
    let bmi = |index: f64| human(1.75, index * 1.75 * 1.75);
    let segment = |name: &str, length| Human::new(1.75, 73.0).segment_length(name, length).build();
    let answers = [
        human(0.79, 10.0),
        human(2.31, 100.0),
        human(f64::NAN, 73.0),
        human(1.75, f64::NAN),
        human(1.75, f64::INFINITY),
        bmi(7.9),
        bmi(81.0),
        segment("thihg", 0.4),
        segment("tail", 0.4),
        segment("left_head", 0.2),
        segment("thigh", 0.86),
        segment("left_thigh", 0.2),
        segment("thigh", f64::NAN),
        Human::new(1.2, 25.0).age(5.9).build(),
        Human::new(1.2, 25.0).age(f64::NAN).build(),
        Human::new(1.2, 25.0).limits("left_elbow.xr", 0.0, 1.0).build(),
    ]
    .map(|answer: Result<Figure, HumanError>| answer.expect_err("not a human").to_string());
    insta::assert_snapshot!(answers.join("\n"));
}

#[test]
fn the_ends_of_the_ranges_are_allowed() {
    for height in [0.8, 2.3] {
        for index in [8.0, 80.0] {
            assert!(human(height, index * height * height).is_ok(), "{height} m, index {index}");
        }
    }
}

#[test]
fn a_shorter_leg_is_so_by_the_same_part_of_thigh_and_shank() {
    let lengths = |human: Human| {
        let figure = human.build().expect("a person");
        ["left_shank", "left_foot", "right_shank", "right_foot"]
            .map(|link| -figure.link(link).expect("a link").joint().placement().translation.y)
    };
    let plain = || Human::new(1.741, 73.0);
    let [thigh, shank, ..] = lengths(plain());
    let found = lengths(plain().shorter_leg("left", 0.02));
    let part = 1.0 - 0.02 / (thigh + shank);
    for (found, expected) in found.iter().zip([part * thigh, part * shank, thigh, shank]) {
        assert!((found - expected).abs() < 1e-14, "{found} {expected}");
    }
    let mass = |human: Human| human.build().expect("a person").mass().to_bits();
    assert_eq!(mass(plain().shorter_leg("left", 0.02)), mass(plain()));
    // On top of lengths of one's own, of which the last one counts.
    let own = |human: Human| human.segment_length("thigh", 0.40);
    let [thigh, shank, ..] = lengths(own(plain()));
    let [.., right_thigh, right_shank] = lengths(own(plain()).shorter_leg("right", 0.03));
    assert!((thigh + shank - right_thigh - right_shank - 0.03).abs() < 1e-14);
    let bits = |human: Human| lengths(human).map(f64::to_bits);
    assert_eq!(bits(plain().shorter_leg("right", 0.0)), bits(plain()));
    for (leg, by) in [("lefft", 0.01), ("left", -0.01), ("left", 0.09), ("right", f64::NAN)] {
        let error = plain().shorter_leg(leg, by).build().expect_err("refused").to_string();
        let expected = format!("{leg} leg shorter by {by} m: a leg of this person can be shorter by 0 to ");
        assert!(error.starts_with(&expected), "{error}");
    }
}

#[test]
fn a_cane_is_as_long_as_the_fist_is_high() {
    for (height, hand) in [(1.741, "left"), (1.2, "right")] {
        let with = Human::new(height, 23.0 * height * height).cane(hand).build().expect("a person");
        let without = human(height, 23.0 * height * height).expect("a person");
        // Standing straight, upper arms hanging and elbows bent by 30°, it stands on the ground that the soles stand on.
        let names = with.layout().v_names();
        let mut q = vec![0.0; with.layout().nq()];
        q[names.iter().position(|name| *name == format!("{hand}_elbow.rx")).expect("an elbow")] =
            -30_f64.to_radians();
        let places = with.places(&q);
        let link = |name: &str| with.link_index(name).expect("a link");
        let fist = places[link("cane")].translation.y;
        let heel = with.links()[link("left_foot")].sole_point(SolePart::Heel).expect("a heel");
        let ground = places[link("left_foot")].translation.y + heel.y;
        let length = -with.link("cane").expect("a cane").tip().expect("a tip").y;
        // But for the joints' offsets along z, of a millimetre or two, which the bent elbow turns.
        assert!((fist - ground - length).abs() < 6e-4 * height, "{fist} {ground} {length}");
        assert!((with.mass() - without.mass() - 0.4 * length).abs() < 1e-12);
        // A thin rod turns about its end as m L²/3.
        let rod = with.link("cane").expect("a cane");
        let about_end = rod.inertia()[(0, 0)] + rod.mass() * rod.com().norm_squared();
        assert!((about_end / (rod.mass() * length * length / 3.0) - 1.0).abs() < 1e-3, "{about_end}");
    }
    let error = Human::new(1.75, 73.0).cane("third").build().expect_err("refused").to_string();
    assert!(error.contains("'third' hand") && error.contains("left or in the right"), "{error}");
}

#[test]
fn a_load_in_a_hand_is_a_point_mass_in_the_fist() {
    let (empty, porter) = (
        human(1.741, 73.0).expect("a person"),
        Human::new(1.741, 73.0).load("right", 5.0).build().expect("a porter"),
    );
    let hand = |figure: &Figure, name: &str| figure.link(name).expect("a hand").clone();
    assert_eq!(hand(&empty, "left_hand"), hand(&porter, "left_hand"));
    let (own, both) = (hand(&empty, "right_hand"), hand(&porter, "right_hand"));
    assert!((both.mass() - own.mass() - 5.0).abs() < 1e-12);
    // Moments about the wrist are those of the hand and of the point.
    let at = nalgebra::Vector3::new(0.0, -0.090, 0.0);
    assert!((both.com() * both.mass() - own.com() * own.mass() - at * 5.0).norm() < 1e-12);
    let about_wrist = |mass: f64, com: nalgebra::Vector3<f64>, inertia: nalgebra::Matrix3<f64>| {
        inertia + (nalgebra::Matrix3::identity() * com.norm_squared() - com * com.transpose()) * mass
    };
    let of = |link: &solaris_model::Link| about_wrist(link.mass(), *link.com(), *link.inertia());
    let point = about_wrist(5.0, at, nalgebra::Matrix3::zeros());
    assert!((of(&both) - of(&own) - point).norm() < 1e-12);
    for (hand, load) in [("rigth", 1.0), ("left", -1.0), ("left", 22.0), ("right", f64::NAN)] {
        let error = Human::new(1.741, 73.0).load(hand, load).build().expect_err("refused").to_string();
        assert!(error.contains("can carry 0 to 21.9 kg in a hand, left or right"), "{error}");
    }
    // What is put into a hand twice is carried together.
    let both = Human::new(1.741, 73.0).load("left", 15.0).load("left", 15.0).build().expect_err("refused");
    assert!(both.to_string().starts_with("load of 30 kg in the left hand"), "{both}");
}
