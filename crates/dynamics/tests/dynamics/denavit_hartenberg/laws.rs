//! What holds for the frames of any figure.

use crate::support::Kernel;
use crate::support::random::{Random, tree};
use nalgebra::{IsometryMatrix3, Matrix4, Quaternion, Translation3, UnitQuaternion, Vector3};
use proptest::prelude::*;
use solaris_dynamics::denavit_hartenberg::{Base, DenavitHartenberg, rows};
use solaris_model::{Axis, AxisKind, Figure, FigureBuilder, Joint, JointKind, LinkSpec, Placement, human};

/// Poses of the links as products of what the figure says, one motion after the other.
fn expected(figure: &Figure, q: &[f64]) -> Vec<Matrix4<f64>> {
    let mut poses: Vec<Matrix4<f64>> = Vec::new();
    for (link, joint) in figure.links().iter().zip(figure.layout().joints()) {
        let q = &q[joint.q..joint.q + joint.nq];
        let mut pose = link.parent().map_or_else(Matrix4::identity, |parent| poses[parent]);
        pose *= link.joint().placement().to_homogeneous();
        let turn = |at: usize| {
            UnitQuaternion::from_quaternion(Quaternion::new(q[at + 3], q[at], q[at + 1], q[at + 2]))
                .to_homogeneous()
        };
        match link.joint().kind() {
            JointKind::Axes(dofs) => {
                for (dof, q) in dofs.iter().zip(q) {
                    let motion = dof.axis.direction * *q;
                    pose *= match dof.axis.kind {
                        AxisKind::Rotation => UnitQuaternion::from_scaled_axis(motion).to_homogeneous(),
                        AxisKind::Translation => Matrix4::new_translation(&motion),
                    };
                }
            }
            JointKind::Ball { .. } => pose *= turn(0),
            JointKind::Free { .. } => {
                pose *= Matrix4::new_translation(&Vector3::new(q[0], q[1], q[2])) * turn(3);
            }
            other => panic!("a new kind of joint: {other:?}"),
        }
        poses.push(pose);
    }
    poses
}

/// A state with unit quaternions where the joints have them.
fn state(figure: &Figure, random: &mut Random) -> Vec<f64> {
    let mut q = random.slice(figure.layout().nq(), 2.0);
    for (link, joint) in figure.links().iter().zip(figure.layout().joints()) {
        if let Some(at) = link.joint().kind().quaternion() {
            let quaternion = &mut q[joint.q + at..][..4];
            let norm = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
            for x in quaternion {
                *x /= norm;
            }
        }
    }
    q
}

/// The figure with every `n`-th joint made a ball or free joint.
fn with_balls(figure: &Figure, n: usize) -> Figure {
    let mut builder = FigureBuilder::new("with balls");
    for (i, link) in figure.links().iter().enumerate() {
        let joint = match i % n {
            1 => Joint::ball(link.joint().name()).placed(*link.joint().placement()),
            2 => Joint::free(link.joint().name()).placed(*link.joint().placement()),
            _ => link.joint().clone(),
        };
        let spec = match link.parent() {
            None => LinkSpec::root(link.name(), joint),
            Some(parent) => LinkSpec::child(link.name(), figure.links()[parent].name(), joint),
        };
        builder = builder.link(spec.mass(1.0));
    }
    builder.build().expect("a valid figure")
}

fn assert_near(found: &[IsometryMatrix3<f64>], expected: &[Matrix4<f64>], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (i, (found, expected)) in found.iter().zip(expected).enumerate() {
        let error = (found.to_homogeneous() - expected).amax();
        assert!(error <= tolerance, "link {i} is off by {error:e}: {found} for {expected}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn the_frames_carry_the_links_where_the_kernel_places_them(seed: u64) {
        let mut random = Random::new(seed);
        let links = 1 + random.below(12);
        let figure = tree(&mut random, links, 1.0);
        let q = state(&figure, &mut random);
        let mut kernel = Kernel::<f64>::new(&figure, Vector3::zeros());
        kernel.place(&q);
        let poses: Vec<_> = (0..links)
            .map(|i| {
                let pose = kernel.workspace.pose(i);
                let mut matrix = pose.rotation.to_homogeneous();
                matrix.fixed_view_mut::<3, 1>(0, 3).copy_from(&pose.translation);
                matrix
            })
            .collect();
        let found = DenavitHartenberg::of(&figure).expect("known joints").poses(&q).expect("a valid state");
        assert_near(&found, &poses, 1e-12);
    }

    #[test]
    fn ball_and_free_joints_are_carried_along(seed: u64) {
        let mut random = Random::new(seed);
        let links = 1 + random.below(12);
        let figure = with_balls(&tree(&mut random, links, 1.0), 3 + random.below(2));
        let q = state(&figure, &mut random);
        let frames = DenavitHartenberg::of(&figure).expect("known joints");
        assert_near(&frames.poses(&q).expect("a valid state"), &expected(&figure, &q), 1e-12);
    }

    /// One rationalised link a degree of freedom, every link of the figure carried once, by its own joint's last one.
    #[test]
    fn every_link_is_carried_once(seed: u64) {
        let mut random = Random::new(seed);
        let links = 1 + random.below(12);
        let figure = tree(&mut random, links, 1.0);
        let frames = DenavitHartenberg::of(&figure).expect("known joints");
        prop_assert_eq!(frames.links.len(), figure.layout().nv());
        let mut carried: Vec<usize> = frames.grounded.iter().map(|carried| carried.link).collect();
        for (k, link) in frames.links.iter().enumerate() {
            prop_assert!(link.parent.is_none_or(|parent| parent < k));
            let joint = figure.layout().joints()[link.joint];
            prop_assert!((joint.v..joint.v + joint.nv).contains(&k));
            if joint.v + joint.nv == k + 1 {
                prop_assert_eq!(link.carried[0].link, link.joint);
            } else {
                prop_assert!(link.carried.is_empty());
            }
            carried.extend(link.carried.iter().map(|carried| carried.link));
        }
        carried.sort_unstable();
        prop_assert_eq!(carried, (0..links).collect::<Vec<_>>());
    }

    /// A link's frames need a base only at the root, at branches and where two axes are nearly parallel.
    #[test]
    fn a_chain_without_branches_needs_one_base(seed: u64) {
        let mut random = Random::new(seed);
        let mut builder = FigureBuilder::new("chain");
        for i in 0..8 {
            let mut joint = Joint::new(format!("j{i}")).at(random.vector(0.5));
            for axis in [0, 1, 2].map(|_| random.below(3)) {
                joint = match axis {
                    0 => joint.rx(),
                    1 => joint.ry(),
                    _ => joint.rz(),
                };
            }
            let link = match i {
                0 => LinkSpec::root("l0", joint),
                _ => LinkSpec::child(format!("l{i}"), format!("l{}", i - 1), joint),
            };
            builder = builder.link(link.mass(1.0));
        }
        let frames = DenavitHartenberg::of(&builder.build().expect("valid")).expect("known joints");
        prop_assert!(matches!(frames.links[0].base, Base::Constant(_)));
        prop_assert!(frames.links[1..].iter().all(|link| link.base == Base::Identity));
    }
}

#[test]
fn a_thousand_links_in_a_row_stay_in_place() {
    let mut random = Random::new(7);
    let mut builder = FigureBuilder::new("chain");
    for i in 0..1000 {
        let joint = Joint::new(format!("j{i}")).at(Vector3::new(0.1, 0.3, 0.0));
        let joint = if i % 3 == 0 { joint.rz() } else { joint.rx() };
        let link = match i {
            0 => LinkSpec::root("l0", joint),
            _ => LinkSpec::child(format!("l{i}"), format!("l{}", i - 1), joint),
        };
        builder = builder.link(link.mass(1.0));
    }
    let figure = builder.build().expect("valid");
    let q = state(&figure, &mut random);
    let frames = DenavitHartenberg::of(&figure).expect("known joints");
    // Frames stay at the joints' centres though parallel axes would let them run away along z.
    assert!(frames.links.iter().all(|link| link.s.abs() < 0.5), "{:?}", frames.links[998]);
    assert_near(&frames.poses(&q).expect("a valid state"), &expected(&figure, &q), 1e-11);
}

#[test]
fn a_figure_100_km_away_has_the_constants_of_one_at_home() {
    let figure = |root: Vector3<f64>| {
        FigureBuilder::new("arm")
            .link(LinkSpec::root("a", Joint::new("a").at(root).rz().axis(skew())).mass(1.0))
            .link(LinkSpec::child("b", "a", Joint::new("b").at(Vector3::new(0.1, 0.2, 0.3)).ry()).mass(1.0))
            .build()
            .expect("valid")
    };
    let constants = |root| {
        let links = DenavitHartenberg::of(&figure(root)).expect("known joints").links;
        let constants = links.into_iter().map(|link| (link.alpha, link.theta, link.a, link.s, link.carried));
        constants.collect::<Vec<_>>()
    };
    let at_home = constants(Vector3::zeros());
    assert_eq!(constants(Vector3::new(1e5, -1e5, 1e5)), at_home);
    // Along the first axis too, where the world's z would serve.
    assert_eq!(constants(Vector3::new(0.0, 0.0, 1e5)), at_home);
}

fn skew() -> Axis {
    Axis::rotation(Vector3::new(1.0, 2.0, -3.0))
}

/// Whether a second axis, tilted by `angle` about y, needs a base where its joint is at `at` from the first one's.
fn needs_base(angle: f64, at: Vector3<f64>) -> bool {
    let axis = Axis::rotation(Vector3::new(angle.sin(), 0.0, angle.cos()));
    let figure = FigureBuilder::new("arm")
        .link(LinkSpec::root("a", Joint::new("a").rz()).mass(1.0))
        .link(LinkSpec::child("b", "a", Joint::new("b").at(at).axis(axis)).mass(1.0))
        .link(LinkSpec::child("c", "b", Joint::new("c").at(Vector3::x()).rx()).mass(1.0))
        .build()
        .expect("valid");
    let frames = DenavitHartenberg::of(&figure).expect("known joints");
    let q = [0.3, -0.8, 0.5];
    assert_near(&frames.poses(&q).expect("a valid state"), &expected(&figure, &q), 1e-13);
    frames.links[1].base != Base::Identity
}

#[test]
fn nearly_parallel_axes_get_a_base_instead_of_a_frame_far_away() {
    let angles = [1e-15, 1e-12, 1e-6, 1e-2, 0.04, 0.06, 1.0];
    // The axes' common normal goes through the joints, and stays there.
    assert_eq!(angles.map(|angle| needs_base(angle, Vector3::y())), [false; 7]);
    // It runs away along the axes.
    let expected = [false, true, true, true, true, false, false];
    assert_eq!(angles.map(|angle| needs_base(angle, Vector3::x())), expected);
}

#[test]
fn links_welded_to_the_world_are_grounded_and_others_ride() {
    let weld = |name: &str, at: f64| Joint::new(name).at(Vector3::new(at, 0.0, 0.0));
    let figure = FigureBuilder::new("stand")
        .link(LinkSpec::root("floor", weld("floor", 1.0)).mass(1.0))
        .link(LinkSpec::child("post", "floor", weld("post", 2.0)).mass(1.0))
        .link(LinkSpec::child("arm", "post", weld("arm", 3.0).ry()).mass(1.0))
        .link(LinkSpec::child("tool", "arm", weld("tool", 4.0)).mass(1.0))
        .link(LinkSpec::child("tip", "tool", weld("tip", 5.0)).mass(1.0))
        .build()
        .expect("valid");
    let frames = DenavitHartenberg::of(&figure).expect("known joints");
    let x = |carried: &solaris_dynamics::denavit_hartenberg::Carried| {
        (carried.link, carried.placement.translation.x)
    };
    assert_eq!(frames.grounded.iter().map(x).collect::<Vec<_>>(), [(0, 1.0), (1, 3.0)]);
    assert_eq!(frames.links[0].carried.iter().map(|carried| carried.link).collect::<Vec<_>>(), [2, 3, 4]);
    let poses = frames.poses(&[std::f64::consts::PI]).expect("a valid state");
    assert_near(&poses[4..], &expected(&figure, &[std::f64::consts::PI])[4..], 1e-14);
    assert!((poses[4].translation.x - (6.0 - 9.0)).abs() < 1e-14);
}

/// α and θ of the human are those of the rule on its axes, chain by chain: no limb is special.
#[test]
fn the_angles_of_the_human_are_those_of_the_rule() {
    let figure = human(1.75, 73.0).expect("within range");
    let frames = DenavitHartenberg::of(&figure).expect("known joints");
    let chain = &frames.chains()[0];
    assert_eq!(chain.links.len(), 6 + 4 * 3);
    let axes: Vec<_> = chain
        .links
        .iter()
        .map(|k| {
            let link = &frames.links[*k];
            let first = figure.layout().joints()[link.joint].v;
            figure.links()[link.joint].joint().kind().axes()[k - first].axis.direction
        })
        .collect();
    let rule = rows(&axes);
    for (k, row) in chain.links.iter().zip(&rule[1..]) {
        let link = &frames.links[*k];
        assert!(
            (link.alpha - row.alpha).abs() + (link.theta - row.theta).abs() < 1e-15,
            "{k}: {link:?} {row:?}"
        );
    }
}

#[test]
fn the_frames_refuse_what_is_no_state() {
    let figure = human(1.75, 73.0).expect("within range");
    let frames = DenavitHartenberg::of(&figure).expect("known joints");
    let mut q = vec![0.0; 66];
    q[4] = f64::NAN;
    let free = FigureBuilder::new("rock").link(LinkSpec::root("rock", Joint::free("rock")).mass(1.0)).build();
    let free = DenavitHartenberg::of(&free.expect("valid")).expect("known joints");
    let answers = [frames.frames(&q[..60]), frames.frames(&q), free.frames(&[0.0; 7])]
        .map(|answer| answer.expect_err("no state").to_string());
    insta::assert_snapshot!(answers.join("\n"), @"
    q has 60 entries, but the figure needs 66
    q of dof 'root.ry' is NaN; it must be a finite number
    the quaternion that starts at 'rock.qx' has the squared length 0.0; it must be 1: normalise the configuration first (Figure::normalize)
    ");
}

/// A placement that turns, for the eye: the link's frame keeps its place in the D-H frame whatever q.
#[test]
fn a_slide_goes_along_z_of_the_frame_before() {
    let turned = Placement::from_parts(
        Translation3::new(0.1, 0.2, 0.3),
        UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -0.5, 0.6)),
    );
    let figure = FigureBuilder::new("rail")
        .link(LinkSpec::root("a", Joint::new("a").placed(turned).tx().ty().rz()).mass(1.0))
        .build()
        .expect("valid");
    let frames = DenavitHartenberg::of(&figure).expect("known joints");
    let at = |q: &[f64]| frames.frames(q).expect("a valid state");
    let (rest, moved) = (at(&[0.0; 3]), at(&[0.0, 0.7, 0.0]));
    let slid = moved[2].translation.vector - rest[2].translation.vector;
    assert!((slid - rest[0].rotation.matrix().column(2) * 0.7).norm() < 1e-15);
}
