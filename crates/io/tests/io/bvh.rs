//! What a reader of BVH sees is what the figure does.

use crate::bvh_reader::{Bvh, parse};
use crate::motions::{Full, full_human, info, swing, thrown, thrown_angles};
use solaris_io::{
    IoError,
    bvh::{self, Unit},
};
use solaris_model::{
    Axis, AxisKind, Figure, FigureBuilder, Isometry3, Joint, LinkSpec, Matrix3, Motion, MotionInfo,
    Rotation3, Vector3, human,
};

fn text(figure: &Figure, motion: &Motion, unit: Unit) -> String {
    let mut bytes = Vec::new();
    bvh::write(figure, motion, unit, &mut bytes).expect("a figure that fits");
    String::from_utf8(bytes).expect("text")
}

/// Forward kinematics from the figure's own data: world rotation and origin of every link.
fn poses(figure: &Figure, q: &[f64]) -> Vec<(Rotation3<f64>, Vector3<f64>)> {
    let mut poses: Vec<(Rotation3<f64>, Vector3<f64>)> = Vec::new();
    for (link, layout) in figure.links().iter().zip(figure.layout().joints()) {
        let parent = link.parent().map_or((Rotation3::identity(), Vector3::zeros()), |parent| poses[parent]);
        let placement = link.joint().placement();
        let mut origin = parent.1 + parent.0 * placement.translation.vector;
        let mut rotation = parent.0 * placement.rotation.to_rotation_matrix();
        if let Some(first) = link.joint().kind().quaternion() {
            let q = &q[layout.q..][..layout.nq];
            // Place and turn by the definition of a quaternion: v + 2w·u×v + 2·u×(u×v).
            if first == 3 {
                origin += rotation * Vector3::new(q[0], q[1], q[2]);
            }
            let (u, w) = (Vector3::new(q[first], q[first + 1], q[first + 2]), q[first + 3]);
            let turned = |v: Vector3<f64>| v + (u.cross(&v) * w + u.cross(&u.cross(&v))) * 2.0;
            let columns = [Vector3::x(), Vector3::y(), Vector3::z()].map(turned);
            rotation *= Rotation3::from_matrix_unchecked(Matrix3::from_columns(&columns));
        }
        for (dof, q) in link.joint().kind().axes().iter().zip(&q[layout.q..]) {
            match dof.axis.kind {
                AxisKind::Rotation => rotation *= Rotation3::new(dof.axis.direction * *q),
                AxisKind::Translation => origin += rotation * dof.axis.direction * *q,
            }
        }
        poses.push((rotation, origin));
    }
    poses
}

/// The greatest distance (m) between a link or a tip in the file and in the figure, over all frames.
fn greatest_distance(figure: &Figure, motion: &Motion, file: &Bvh, metres_per_unit: f64) -> f64 {
    assert_eq!(file.nodes.len(), figure.links().len());
    let mut greatest: f64 = 0.0;
    for frame in 0..motion.len() {
        let poses = poses(figure, motion.q(frame));
        for (node, (origin, end)) in file.nodes.iter().zip(file.positions(frame)) {
            let link = figure.link_index(&node.name).expect("a link of the figure");
            let (rotation, expected) = poses[link];
            greatest = greatest.max((Vector3::from(origin) * metres_per_unit - expected).norm());
            if let (Some(end), Some(tip)) = (end, figure.links()[link].tip()) {
                greatest =
                    greatest.max((Vector3::from(end) * metres_per_unit - expected - rotation * tip).norm());
            }
        }
    }
    greatest
}

#[test]
fn a_reader_finds_every_link_where_the_figure_has_it() {
    let (figure, motion) = full_human();
    let file = parse(&text(&figure, &motion, Unit::default()));
    let distance = greatest_distance(&figure, &motion, &file, 0.01);
    assert!(distance < 1e-7, "{distance} m");
    assert!((file.frame_time - 1.0 / 30.0).abs() < 1e-15);
    assert_eq!(file.nodes[1].channels, ["Zrotation", "Yrotation", "Xrotation"]);
    let root = ["Xposition", "Yposition", "Zposition", "Zrotation", "Yrotation", "Xrotation"];
    assert_eq!(file.nodes[0].channels, root);
}

#[test]
fn lengths_come_in_the_unit_that_was_asked_for() {
    let figure = human(1.75, 73.0).expect("an ordinary human");
    let motion = swing(&figure, 5.0, 0.0);
    for (unit, metres) in [(Unit::Centimetres, 0.01), (Unit::Metres, 1.0), (Unit::Inches, 0.0254)] {
        let file = parse(&text(&figure, &motion, unit));
        let distance = greatest_distance(&figure, &motion, &file, metres);
        assert!(distance < 1e-5, "{unit:?}: {distance} m");
    }
}

/// Orders of rotation other than Z-Y-X, fewer than three axes, an axis the other way round, a weld, a placed root that
/// slides along an oblique line, and children that were described in another order than the file needs.
fn odd_figure() -> Figure {
    let oblique = Axis::translation(Vector3::new(1.0, 2.0, -2.0));
    let against = Axis::rotation(-Vector3::z());
    let at = |x, y, z| Vector3::new(x, y, z);
    FigureBuilder::new("odd")
        .link(
            LinkSpec::root("base", Joint::new("base").at(at(0.1, 0.9, 0.3)).axis(oblique).ry().rz())
                .mass(1.0),
        )
        .link(LinkSpec::child("a", "base", Joint::new("a").at(at(0.0, 0.4, 0.0)).rx().ry().rz()).mass(1.0))
        .link(LinkSpec::child("b", "base", Joint::new("b").at(at(0.3, 0.0, 0.1)).rx()).mass(1.0))
        .link(
            LinkSpec::child("a1", "a", Joint::new("a1").at(at(0.0, 0.2, 0.2)).ry().axis(against).rx())
                .mass(1.0)
                .tip(at(0.2, -0.1, 0.3)),
        )
        .link(LinkSpec::child("b1", "b", Joint::new("b1").at(at(0.2, 0.1, 0.0))).mass(1.0))
        .link(
            LinkSpec::child("b2", "b1", Joint::new("b2").at(at(0.0, 0.0, 0.3)).rz().rx())
                .mass(1.0)
                .tip(at(0.1, 0.2, 0.3)),
        )
        .build()
        .expect("valid")
}

#[test]
fn unusual_orders_and_missing_axes_read_back() {
    let figure = odd_figure();
    let motion = swing(&figure, 20.0, 0.0);
    let file = parse(&text(&figure, &motion, Unit::default()));
    let distance = greatest_distance(&figure, &motion, &file, 0.01);
    assert!(distance < 1e-7, "{distance} m");
    let channels = |name: &str| {
        let node = file.nodes.iter().find(|node| node.name == name).expect("the link");
        node.channels.join(" ")
    };
    assert_eq!(channels("a"), "Xrotation Yrotation Zrotation");
    assert_eq!(channels("a1"), "Yrotation Zrotation Xrotation");
    assert_eq!(channels("b"), "Xrotation Zrotation Yrotation");
    assert_eq!(channels("b2"), "Zrotation Xrotation Yrotation");
}

#[test]
fn a_file_looks_like_this() {
    let figure = odd_figure();
    let motion = swing(&figure, 1.0, 0.0);
    insta::assert_snapshot!(text(&figure, &motion, Unit::Centimetres));
}

#[test]
fn angles_run_on_past_half_a_turn() {
    let figure = human(1.75, 73.0).expect("an ordinary human");
    // 12 rad in one second: nearly two turns of every joint.
    let motion = swing(&figure, 100.0, 12.0);
    let file = parse(&text(&figure, &motion, Unit::default()));
    for (link, dof) in [("left_thigh", "left_hip.rx"), ("pelvis", "root.ry"), ("head", "head.rz")] {
        let axis = dof.as_bytes()[dof.len() - 1].to_ascii_uppercase() as char;
        let angles = file.channel(link, &format!("{axis}rotation"));
        let dof = figure.layout().dof_index(dof).expect("a dof");
        for (frame, angle) in angles.iter().enumerate() {
            assert!(
                (angle - motion.q(frame)[dof].to_degrees()).abs() < 1e-6,
                "{link} in frame {frame}: {angle}°"
            );
        }
        assert!(angles.iter().any(|angle| *angle > 500.0), "{link} turns more than once");
        assert!(angles.windows(2).all(|pair| (pair[1] - pair[0]).abs() < 45.0), "{link} flips");
    }
}

#[test]
fn ball_and_free_joints_are_three_rotations_that_run_on() {
    let (figure, motion) = thrown(30.0);
    let file = parse(&text(&figure, &motion, Unit::default()));
    let distance = greatest_distance(&figure, &motion, &file, 0.01);
    assert!(distance < 1e-7, "{distance} m");
    let order = ["Zrotation", "Yrotation", "Xrotation"];
    assert_eq!(file.nodes[0].channels[3..], order);
    assert_eq!(file.nodes[1].channels, order);
    for (node, joint) in [("trunk", 0), ("arm", 1)] {
        for (part, channel) in order.into_iter().enumerate() {
            for (frame, angle) in file.channel(node, channel).into_iter().enumerate() {
                let expected = thrown_angles(motion.time()[frame])[joint][part].to_degrees();
                assert!((angle - expected).abs() < 1e-6, "{node} {channel} in frame {frame}: {angle}°");
            }
        }
    }
}

/// Joints that BVH does not know are written by where they take their links.
#[test]
fn any_joint_is_held() {
    let child = |joint: Joint| {
        let base = LinkSpec::root("base", Joint::new("base").tx()).mass(1.0);
        FigureBuilder::new("f")
            .link(base)
            .link(LinkSpec::child("arm", "base", joint).mass(1.0).tip(Vector3::new(0.1, -0.3, 0.2)))
    };
    let turned = Isometry3::new(Vector3::new(0.1, 0.2, 0.3), Vector3::new(0.4, 0.3, -0.8));
    let oblique = Axis::rotation(Vector3::new(1.0, 1.0, 0.0));
    let figures = [
        child(Joint::new("shoulder").placed(turned).rx().ry()),
        child(Joint::new("wrist").rx().rz().rx()),
        child(Joint::new("hinge").ry().axis(oblique)),
        child(Joint::new("drawer").at(Vector3::new(0.2, 0.0, 0.1)).tz()),
        child(Joint::free("balloon").placed(turned)),
        child(Joint::new("screw").placed(turned).rx().tx().tz()),
        FigureBuilder::new("f").link(LinkSpec::root("base", Joint::new("late").ry().tx()).mass(1.0)),
        FigureBuilder::new("f").link(LinkSpec::root("base", Joint::free("base").placed(turned)).mass(1.0)),
    ];
    for figure in figures.map(|figure| figure.build().expect("valid")) {
        let motion = swing(&figure, 20.0, 0.0);
        let file = parse(&text(&figure, &motion, Unit::default()));
        let distance = greatest_distance(&figure, &motion, &file, 0.01);
        assert!(distance < 3e-8, "{:?}: {distance} m", figure.links().last().map(|link| link.joint().name()));
    }
}

#[test]
fn a_name_is_one_word() {
    let figure = FigureBuilder::new("f").link(LinkSpec::root("left {arm}", Joint::new("j").ry()).mass(1.0));
    let figure = figure.build().expect("valid");
    let file = parse(&text(&figure, &swing(&figure, 5.0, 0.0), Unit::default()));
    assert_eq!(file.nodes[0].name, "left__arm_");
}

/// A robot whose world has z up and that looks along x looks along z, as figures do where y is up.
#[test]
fn a_world_with_another_up_is_turned() {
    let figure = odd_figure();
    let mut motion = swing(&figure, 5.0, 0.0);
    let places = |motion: &Motion| parse(&text(&figure, motion, Unit::Metres)).positions(3);
    let own = places(&motion);
    let turn = |gravity: Vector3<f64>, motion: &mut Motion| {
        motion.info.gravity = gravity;
        places(motion)
    };
    let z_up = turn(Vector3::new(0.0, 0.0, -9.81), &mut motion);
    for (([x, y, z], _), (turned, _)) in own.iter().zip(&z_up) {
        let off = (Vector3::new(*y, *z, *x) - Vector3::from(*turned)).norm();
        assert!(off < 1e-5, "{off}");
    }
    let upside_down = turn(Vector3::new(0.0, 9.81, 0.0), &mut motion);
    let heights = own.iter().zip(&upside_down).map(|(a, b)| (a.0[1] + b.0[1]).abs());
    assert!(heights.fold(0.0, f64::max) < 1e-5);
    let oblique = turn(Vector3::new(-9.0, -1.0, 2.0), &mut motion);
    let up = Vector3::new(9.0, 1.0, -2.0).normalize();
    for ((a, _), (b, _)) in own.iter().zip(&oblique) {
        assert!((Vector3::from(*a).dot(&up) - b[1]).abs() < 1e-5);
    }
    assert!(
        (places_of(&turn(Vector3::new(0.0, -9.0, 2.0), &mut motion)) - places_of(&own)).amax() < 1e-12,
        "a slope"
    );
}

/// The last of these places.
fn places_of(places: &[([f64; 3], Option<[f64; 3]>)]) -> Vector3<f64> {
    Vector3::from(places[places.len() - 1].0)
}

#[test]
fn gravity_that_is_none_and_a_motion_without_rate_are_refused() {
    let figure = odd_figure();
    let mut motion = swing(&figure, 5.0, 0.0);
    let attempt = |motion: &Motion| bvh::write(&figure, motion, Unit::default(), &mut Vec::new());
    motion.info.gravity = Vector3::new(0.0, f64::NAN, 0.0);
    assert!(matches!(attempt(&motion), Err(IoError::BvhUp { .. })));
    motion.info.gravity = Vector3::zeros();
    attempt(&motion).expect("without gravity y may be up");
    motion.info.rate = 0.0;
    assert!(matches!(attempt(&motion), Err(IoError::Motion(_))));
    motion.info = info(&full_human().0, 5.0);
    assert!(matches!(attempt(&motion), Err(IoError::Motion(_))), "another figure");
}

#[test]
fn an_angle_too_large_for_degrees_is_refused() {
    let figure = FigureBuilder::new("f")
        .link(LinkSpec::root("base", Joint::new("base").tx()).mass(1.0))
        .link(LinkSpec::child("arm", "base", Joint::new("arm").rx()).mass(1.0))
        .build()
        .expect("valid");
    let columns = [vec![0.0, 1e308], vec![0.0; 2], vec![0.0; 2]];
    let motion = Motion::new(&figure, info(&figure, 5.0), vec![0.0], columns).expect("finite numbers");
    let error = bvh::write(&figure, &motion, Unit::default(), &mut Vec::new()).expect_err("infinite degrees");
    insta::assert_snapshot!(error, @"'arm.channel' at 0 s is inf; a file holds finite numbers only");
}

#[test]
fn a_failing_writer_is_an_error() {
    let (figure, motion) = full_human();
    let size = text(&figure, &motion, Unit::default()).len();
    for left in [0, 1, 20, 3000, size - 1] {
        let error = bvh::write(&figure, &motion, Unit::default(), &mut Full { left }).expect_err("no room");
        assert!(matches!(error, IoError::Write(_)), "{error}");
    }
    bvh::write(&figure, &motion, Unit::default(), &mut Full { left: size }).expect("just enough room");
}

/// Bones are told apart by their names where they are read, and a name is one word.
#[test]
fn names_that_become_one_are_told_apart() {
    let names = ["hip", "a b", "a_b", "a\u{0}b", "a\tb"];
    let joint = |i: usize| if i == 0 { Joint::free("root") } else { Joint::new(format!("j{i}")).rx() };
    let mut builder = FigureBuilder::new("odd");
    for (i, name) in names.iter().enumerate() {
        let at = joint(i).at(Vector3::new(0.0, 0.1, 0.0));
        builder = builder.link(match i {
            0 => LinkSpec::root(*name, at).mass(1.0),
            _ => LinkSpec::child(*name, names[i - 1], at).mass(1.0),
        });
    }
    let figure = builder.build().expect("a figure");
    let mut q = vec![0.0; figure.layout().nq()];
    figure.neutral(&mut q).expect("the neutral posture");
    let first = q.len() - 4;
    q[first..].copy_from_slice(&[0.1, 0.2, 0.3, 0.4]);
    let still = vec![0.0; figure.layout().nv()];
    let info = MotionInfo::on_earth(&figure, 30.0);
    let motion = Motion::new(&figure, info, vec![0.0], [q, still.clone(), still]).expect("a motion");
    let mut text = Vec::new();
    bvh::write(&figure, &motion, Unit::Metres, &mut text).expect("written");
    let text = String::from_utf8(text).expect("text");
    for name in ["JOINT a_b\n", "JOINT a_b_2\n", "JOINT a_b_3\n", "JOINT a_b_4\n"] {
        assert!(text.contains(name), "{name}: {text}");
    }
    let options = bvh::ReadOptions { unit: Some(Unit::Metres), ..Default::default() };
    let clip = bvh::read(&text, &options).expect("read");
    let [ours, theirs] =
        [(&figure, &motion), (&clip.figure, &clip.motion)].map(|(of, motion)| of.places(motion.q(0)));
    let off = (ours[4].translation.vector - theirs[4].translation.vector).norm();
    assert!(off < 1e-6, "{off} m");
}
