//! Footholds given one by one: feet stand on them, and the walk is as sound as any.

use crate::posed::Posed;
use crate::terrain::{judge, judge_loaded, request};
use solaris_gait::{Foothold, WalkGround, WalkRequest, walk};
use solaris_model::{Event, EventKind, human};

/// Places ahead (m), heights (m) and pitches (°).
fn stones(rows: &[[f64; 3]]) -> Vec<Foothold> {
    let stone = |&[z, height, pitch]: &[f64; 3]| Foothold {
        z,
        height,
        pitch: pitch.to_radians(),
        ..Foothold::default()
    };
    rows.iter().map(stone).collect()
}

/// Uneven lengths, heights and pitches.
fn uneven() -> Vec<Foothold> {
    stones(&[
        [0.45, 0.02, 0.0],
        [1.05, 0.06, 3.0],
        [1.55, 0.06, -2.0],
        [2.20, 0.12, 4.0],
        [2.75, 0.08, 0.0],
        [3.40, 0.05, -5.0],
        [3.95, 0.05, 0.0],
        [4.40, 0.00, 0.0],
        [4.80, 0.00, 0.0],
    ])
}

fn on(footholds: Vec<Foothold>) -> WalkRequest {
    request(WalkGround::Footholds(footholds), 95.0)
}

/// Where the heels stand, in the order of their contacts: left of the middle, up, ahead (m).
fn heels(ask: &WalkRequest) -> Vec<[f64; 3]> {
    let ann = human(1.75, 73.0).expect("a person");
    let plan = walk(&ann, ask).expect("a walk");
    let motion = plan.motion(&ann, 100.0).expect("a motion");
    let mut posed = Posed::new(&ann, &plan);
    let mut found: Vec<(f64, [f64; 3])> = Vec::new();
    for planted in
        motion.planted.iter().filter(|planted| planted.point.z < 0.0 && planted.end > planted.start)
    {
        posed.pose(0.5 * (planted.start + planted.end));
        let at = posed.at(planted.link, &planted.point);
        found.push((planted.start, [at.x, at.y, at.z]));
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    found.into_iter().map(|(_, at)| at).collect()
}

#[test]
fn stepping_stones_of_any_length_height_and_pitch() {
    let ann = human(1.75, 73.0).expect("a person");
    judge("uneven stones", &ann, &on(uneven()));
}

/// Prints as far apart to the last one as people's steps at the pace are: nobody stops at once after such a step.
#[test]
fn prints_that_are_all_as_far_apart() {
    for (height, mass) in [(1.60, 56.0), (1.75, 73.0), (1.88, 84.0)] {
        let person = human(height, mass).expect("a person");
        for step_frequency in [80.0, 95.0, 108.0, 120.0] {
            let level = walk(&person, &request(WalkGround::Level, step_frequency)).expect("a walk");
            let step = 0.95 * level.style().step_length;
            let rows: Vec<[f64; 3]> = (1..=9).map(|k| [step * f64::from(k), 0.0, 0.0]).collect();
            let ask = request(WalkGround::Footholds(stones(&rows)), step_frequency);
            judge_loaded(&format!("{height} m, {step_frequency} steps/min"), &person, &ask, 160.0);
            let plan = walk(&person, &ask).expect("a walk");
            let contacts: Vec<f64> = plan.events().iter().filter_map(touch_down).collect();
            let lasts: Vec<f64> = contacts.windows(2).map(|pair| pair[1] - pair[0]).collect();
            // Steps in the middle last as told; of quick ones the last one takes time.
            let usual = 60.0 / step_frequency;
            assert!((lasts[3] / usual - 1.0).abs() < 1e-9, "{lasts:?}");
            let last = lasts[7] / usual;
            assert!(last < 2.0 && last > if step_frequency > 100.0 { 1.1 } else { 1.0 - 1e-9 }, "{lasts:?}");
        }
    }
}

fn touch_down(event: &Event) -> Option<f64> {
    matches!(event.kind, EventKind::TouchDown { .. }).then_some(event.time)
}

/// Narrow and wide, with one foot turned out on a level stone.
fn winding() -> Vec<Foothold> {
    let stone =
        |x, z, heading: f64| Foothold { x: Some(x), z, heading: heading.to_radians(), ..Foothold::default() };
    vec![
        stone(-0.06, 0.45, 0.0),
        stone(0.08, 1.00, 6.0),
        stone(-0.02, 1.55, 12.0),
        stone(0.17, 2.05, 12.0),
        stone(0.10, 2.60, 4.0),
        stone(0.22, 3.10, 0.0),
        stone(0.12, 3.55, 0.0),
        stone(0.23, 3.90, 0.0),
    ]
}

#[test]
fn stones_beside_the_way_and_turned() {
    let ann = human(1.75, 73.0).expect("a person");
    judge("winding stones", &ann, &on(winding()));
}

#[test]
fn heels_stand_where_they_are_told() {
    for footholds in [uneven(), winding()] {
        let heels = heels(&on(footholds.clone()));
        assert_eq!(heels.len(), footholds.len() + 3, "both standing feet, each step, and the closing one");
        for (heel, foothold) in heels[2..].iter().zip(&footholds) {
            let told = [foothold.x.unwrap_or(heel[0]), foothold.height, foothold.z];
            for (axis, told) in told.into_iter().enumerate() {
                assert!((heel[axis] - told).abs() < 1e-6, "{axis}: {heel:?}, told {foothold:?}");
            }
        }
        let (last, closed) = (heels[heels.len() - 2], heels[heels.len() - 1]);
        assert!((last[2] - closed[2]).abs() < 1e-6 && (last[1] - closed[1]).abs() < 1e-6);
    }
}

/// The left foot on the mirror image of the stones: the same walk mirrored.
#[test]
fn the_left_foot_may_go_first() {
    let mirrored =
        |foothold: &Foothold| Foothold { x: foothold.x.map(|x| -x), heading: -foothold.heading, ..*foothold };
    let right = heels(&on(winding()));
    let ask = WalkRequest { left_first: true, ..on(winding().iter().map(mirrored).collect()) };
    for (right, left) in right[2..].iter().zip(&heels(&ask)[2..]) {
        assert!((right[0] + left[0]).abs() < 1e-9 && (right[2] - left[2]).abs() < 1e-9, "{right:?} {left:?}");
    }
}

#[test]
fn what_no_foot_can_stand_on_is_refused_by_its_number() {
    let ann = human(1.75, 73.0).expect("a person");
    let why =
        |footholds: Vec<Foothold>| walk(&ann, &on(footholds)).map(|_| ()).expect_err("no walk").to_string();
    let third = |change: &dyn Fn(&mut Foothold)| {
        let mut footholds = uneven();
        change(&mut footholds[2]);
        why(footholds)
    };
    for (said, why) in [
        ("foothold 3: it is 1.400 m ahead", third(&|stone| stone.z += 0.9)),
        ("foothold 3: its pitch is 20.0°", third(&|stone| stone.pitch = 20f64.to_radians())),
        ("foothold 3: it is turned by 5° and pitched", third(&|stone| stone.heading = 5f64.to_radians())),
        ("foothold 3: its heel is", third(&|stone| stone.x = Some(0.6))),
        ("foothold 3: it lies 2", third(&|stone| stone.height = 0.30)),
        ("foothold 3: x none, z NaN", third(&|stone| stone.z = f64::NAN)),
        ("footholds", why(Vec::new())),
    ] {
        assert!(why.contains(said), "{said}: {why}");
    }
    let near = stones(&[[0.45, 0.0, 0.0], [0.68, 0.05, 0.0], [1.2, 0.05, 0.0]]);
    assert!(why(near).contains("before the one before it ends"));
}
