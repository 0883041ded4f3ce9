//! Where Unreal's root goes: on the ground, without the sway of steps.

use super::walked;
use nalgebra::Point3;
use solaris_gait::set::{self, SetClip, SetRequest, clip_set};
use solaris_gait::{Extent, StyledPlan, StyledRequest, WalkGround, WalkRequest, on_the_spot, walk};
use solaris_io::rig::{Rig, Rigged};
use solaris_model::{Figure, Human, Motion, MotionInfo, RootOrder, Vector3};
use std::f64::consts::PI;

#[test]
fn somebody_stands_on_unreal_s_root_at_rest() {
    let (figure, _) = walked();
    let on = Rigged::new(&figure, Rig::Unreal).expect("on the rig");
    let mut q = vec![0.0; on.figure.layout().nq()];
    on.figure.neutral(&mut q).expect("the neutral posture");
    let places = on.figure.places(&q);
    let all = on.figure.links().iter().zip(&places);
    let soles =
        all.flat_map(|(link, place)| link.sole().iter().map(move |p| place * Point3::from(p.position)));
    let lowest = soles.map(|point| point.y).fold(f64::INFINITY, f64::min);
    assert!(lowest.abs() < 1e-12 && places[0] == nalgebra::Isometry3::identity(), "{lowest} m");

    // Wherever somebody stands in a scene.
    let elsewhere = nalgebra::Isometry3::translation(3.0, 1.0, -2.0);
    let placed = Rigged::new(&figure.placed(&elsewhere), Rig::Unreal).expect("on the rig");
    for (ours, theirs) in placed.figure.places(&q).iter().zip(&places) {
        assert!((ours.translation.vector - theirs.translation.vector).norm() < 1e-12);
    }
}

/// The track of Unreal's root and the way of the pelvis, a row a sample: to the left, up, ahead (m), heading (rad).
fn tracks(figure: &Figure, motion: &Motion) -> [Vec<[f64; 4]>; 2] {
    let on = Rigged::new(figure, Rig::Unreal).expect("on the rig");
    let moved = on.motion(figure, motion).expect("a motion");
    [0, on.bones[0]].map(|bone| {
        let row = |sample| {
            let place: nalgebra::Isometry3<f64> = on.figure.places(moved.q(sample))[bone];
            let (at, ahead) = (place.translation.vector, place.rotation * Vector3::z());
            [at.x, at.y, at.z, ahead.x.atan2(ahead.z)]
        };
        (0..moved.len()).map(row).collect()
    })
}

/// The greatest second difference of a column, a second.
fn unevenness(rows: &[[f64; 4]], column: usize, rate: f64) -> f64 {
    let second = |w: &[[f64; 4]]| (w[2][column] - 2.0 * w[1][column] + w[0][column]).abs() * rate * rate;
    rows.windows(3).map(second).fold(0.0, f64::max)
}

#[test]
fn unreal_s_root_goes_along_the_ground_without_the_sway_of_steps() {
    let figure = Human::new(1.75, 73.0).build().expect("a person");
    let request =
        WalkRequest { extent: Extent::Steps(12), step_frequency: Some(110.0), ..WalkRequest::default() };
    let motion = walk(&figure, &request).expect("a walk").motion(&figure, 60.0).expect("a motion");
    let [root, pelvis] = tracks(&figure, &motion);
    let n = root.len();
    for end in [0, n - 1] {
        let off = [0, 2].map(|k| (root[end][k] - pelvis[end][k]).abs());
        assert!(off[0].max(off[1]) < 1e-9, "{off:?}");
    }
    assert!(root.iter().all(|row| row[1].abs() < 1e-6), "on flat ground");
    let middle = n / 3..2 * n / 3;
    let spread = |rows: &[[f64; 4]], k: usize| {
        let of = rows[middle.clone()].iter().map(|row| row[k]);
        of.clone().fold(f64::MIN, f64::max) - of.fold(f64::MAX, f64::min)
    };
    // The pelvis sways by four centimetres and turns by some degrees.
    for k in [0, 3] {
        assert!(
            spread(&root, k) < 0.05 * spread(&pelvis, k),
            "{k}: {} of {}",
            spread(&root, k),
            spread(&pelvis, k)
        );
    }
    let (even, uneven) =
        (unevenness(&root[middle.clone()], 2, 60.0), unevenness(&pelvis[middle.clone()], 2, 60.0));
    assert!(even < 0.1 * uneven, "{even} m/s² of {uneven}");
    // Who stops leans back a little at last.
    assert!(root.windows(2).all(|pair| pair[1][2] > pair[0][2] - 5e-4), "never back");
}

#[test]
fn the_root_of_a_loop_goes_on_evenly_and_stays_where_the_loop_is_on_the_spot() {
    let figure = Human::new(1.75, 73.0).build().expect("a person");
    let request = WalkRequest { extent: Extent::Steps(42), ..WalkRequest::default() };
    let plan = StyledPlan::of(&figure, &StyledRequest::Smooth(request)).expect("a walk");
    for (still, way) in [(true, 0.0), (false, 1.4)] {
        let (moving, _) = plan.loaded_stride(&figure, 60.0).expect("a stride");
        let motion = if still { on_the_spot(&figure, &moving).expect("the same figure") } else { moving };
        let [root, pelvis] = tracks(&figure, &motion);
        let n = root.len();
        let gone = root[n - 1][2] - root[0][2];
        assert!((gone - way).abs() < 0.1, "{gone} m");
        assert!((gone - (pelvis[n - 1][2] - pelvis[0][2])).abs() < 1e-9);
        for k in 0..4 {
            assert!(unevenness(&root, k, 60.0) < 1e-6, "{k}: {}", unevenness(&root, k, 60.0));
        }
    }
}

/// Clips that a game puts one behind the other.
#[test]
fn roots_of_clips_that_follow_each_other_do_not_leap() {
    let figure = Human::new(1.75, 73.0).root(RootOrder::Yzx).build().expect("a person");
    let clips = clip_set(&figure, &SetRequest::default()).expect("clips");
    let on = Rigged::new(&figure, Rig::Unreal).expect("on the rig");
    // The pelvis as the root sees it.
    let seen = |clip: &SetClip, sample: fn(usize) -> usize| {
        let moved = on.motion(&figure, &clip.motion).expect("a motion");
        let places = on.figure.places(moved.q(sample(moved.len())));
        places[0].inverse() * places[on.bones[0]]
    };
    let first = |_| 0;
    let last = |n| n - 1;
    let usual = clips.clips.iter().find(|clip| clip.name == clips.usual).expect("a loop");
    let expected = seen(usual, first);
    let mut seams = 0;
    for clip in clips.clips.iter().filter(|clip| clip.seam.is_some()) {
        for (at, joint) in [first, last].into_iter().zip(clip.joints) {
            if joint == set::Joint::LeftContact {
                let found = seen(clip, at);
                let (turned, off) = (
                    found.rotation.angle_to(&expected.rotation),
                    (found.translation.vector - expected.translation.vector).norm(),
                );
                assert!(turned < 0.02 && off < 0.015, "{}: {turned} rad, {off} m", clip.name);
                seams += 1;
            }
        }
    }
    // Two starts, two stops, two turns with two ends each.
    assert_eq!(seams, 8);
}

#[test]
fn who_falls_has_a_root_at_height_zero() {
    let figure = Human::new(1.75, 73.0).build().expect("a person");
    let layout = figure.layout();
    let time: Vec<f64> = (0..31).map(|i| f64::from(i) / 30.0).collect();
    let falls = time.iter().flat_map(|time| {
        let mut row = vec![0.0; layout.nq()];
        row[1] = -4.9 * time * time;
        row
    });
    let still = vec![0.0; layout.nv() * time.len()];
    let columns = [falls.collect(), still.clone(), still];
    let motion = Motion::new(&figure, MotionInfo::on_earth(&figure, 30.0), time, columns).expect("a motion");
    let [root, pelvis] = tracks(&figure, &motion);
    assert!(root.iter().all(|row| row[1] == 0.0) && pelvis[30][1] < pelvis[0][1] - 4.0);
}

#[test]
fn the_root_turns_with_the_way_and_climbs_with_the_ground() {
    let figure = Human::new(1.75, 73.0).root(RootOrder::Yzx).build().expect("a person");
    let turning = WalkRequest { extent: Extent::Steps(10), turn: 0.35, ..WalkRequest::default() };
    let motion = walk(&figure, &turning).expect("a walk").motion(&figure, 60.0).expect("a motion");
    let [root, pelvis] = tracks(&figure, &motion);
    let apart = |a: f64, b: f64| ((a - b + PI).rem_euclid(2.0 * PI) - PI).abs();
    let most = root.iter().zip(&pelvis).map(|(a, b)| apart(a[3], b[3])).fold(0.0, f64::max);
    assert!(most < 0.4, "{most} rad from the pelvis");
    let uphill =
        WalkRequest { extent: Extent::Steps(8), ground: WalkGround::Slope(0.1), ..WalkRequest::default() };
    let motion = walk(&figure, &uphill).expect("a walk").motion(&figure, 60.0).expect("a motion");
    let [root, _] = tracks(&figure, &motion);
    let last = root.last().expect("a row");
    assert!(last[1] > 0.3, "{last:?}");
    // And of a motion of a table, which says of nothing that it stands.
    let mut told = motion.clone();
    told.planted.clear();
    let [of_a_table, _] = tracks(&figure, &told);
    for row in root.iter().chain(&of_a_table) {
        assert!((row[1] - 0.1_f64.tan() * row[2]).abs() < 0.03, "{row:?}");
    }
}
