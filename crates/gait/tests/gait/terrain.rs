//! Walks over slopes, ramps, kerbs and stairs, judged by their own inverse dynamics and by where their soles are: nothing here knows
//! the plan but its requests.

use nalgebra::Vector3;
use solaris_analysis::{ReactionReport, ground_reactions};
use solaris_gait::{
    Extent, FEET, Population, Stairs, WalkExtremes, WalkGround, WalkPlan, WalkRequest, measure,
    step_length_on_slope, walk,
};
use solaris_model::{Figure, Human, Motion, Relief, human};

pub(crate) fn request(ground: WalkGround, step_frequency: f64) -> WalkRequest {
    WalkRequest {
        step_frequency: Some(step_frequency),
        extent: Extent::Steps(10),
        ground,
        ..WalkRequest::default()
    }
}

fn walked(figure: &Figure, request: &WalkRequest, rate: f64) -> (Motion, ReactionReport, WalkExtremes) {
    let plan = walk(figure, request).unwrap_or_else(|error| panic!("{:?}: {error}", request.ground));
    let mut motion = plan.motion(figure, rate).expect("a motion");
    let report = ground_reactions(figure, &mut motion, FEET, &plan).expect("forces");
    let measures = measure(figure, &motion).expect("measures").extremes;
    (motion, report, measures)
}

/// What every walk keeps, whatever it goes over.
pub(crate) fn judge(name: &str, figure: &Figure, request: &WalkRequest) {
    judge_loaded(name, figure, request, 150.0);
}

/// The same, judged as often as what lasts for a millisecond asks for.
fn judge_finely(name: &str, figure: &Figure, request: &WalkRequest) {
    judge_sampled(name, figure, request, (160.0, 960.0));
}

/// The same with another greatest vertical force (%BW).
pub(crate) fn judge_loaded(name: &str, figure: &Figure, request: &WalkRequest, vertical: f64) {
    judge_sampled(name, figure, request, (vertical, 120.0));
}

fn judge_sampled(name: &str, figure: &Figure, request: &WalkRequest, (vertical, rate): (f64, f64)) {
    let (motion, report, measures) = walked(figure, request, rate);
    let most = |what: &str, value: f64, limit: f64| {
        assert!(value <= limit, "{name}: {what} is {value}, not within {limit}");
    };
    most("slide, m", measures.slide.value, 1e-4);
    most("sink, m", measures.sink.value, 1e-3);
    most("pressure outside of the sole, m", measures.cop_outside.value, 5e-3);
    most("hyperextension, rad", -measures.least_knee.value, 1f64.to_radians());
    most("vertical force, %BW", measures.vertical.value, vertical);
    // A bent ankle under load bends by up to 20° more than its range, as in a lunge.
    let beyond = (0..motion.len()).flat_map(|sample| figure.limit_excess(motion.q(sample)));
    most("a joint beyond its range, °", beyond.map(|at| at.by.abs().to_degrees()).fold(0.0, f64::max), 20.0);
    // Newton: what the motion needs is what was prescribed.
    let weight = figure.mass() * 9.80665;
    most("force beside the law", report.from_prescribed.expect("a law").value / weight, 0.05);
    most("residual at the root, N", report.root_force, 1e-6);
    // Friction and free moment by each sole's own normal.
    for track in &motion.contacts {
        for (sample, contact) in track.samples.iter().enumerate() {
            if contact.force.y < 0.05 * weight {
                continue;
            }
            let free = contact.moment - contact.cop.cross(&contact.force);
            let normal = normal_under(&motion, contact.cop.z, &free);
            let pressed = contact.force.dot(&normal);
            let friction = (contact.force - normal * pressed).norm() / pressed;
            most(&format!("friction at {:.2} s", motion.time()[sample]), friction, 0.6);
        }
    }
}

/// The ground's normal at a place along z; under a sole that bridges a bend that of its free moment.
fn normal_under(motion: &Motion, z: f64, free: &Vector3<f64>) -> Vector3<f64> {
    let relief = motion.relief.as_ref().expect("a relief");
    let slope = (relief.height(z + 1e-4) - relief.height(z - 1e-4)) / 2e-4;
    if slope.abs() < 0.3 {
        return Vector3::new(0.0, 1.0, -slope).normalize();
    }
    free.try_normalize(1e-9).map_or_else(Vector3::y, |normal| normal * normal.y.signum())
}

fn relief(points: &[[f64; 2]]) -> WalkGround {
    WalkGround::Relief(Relief::new(points.to_vec()).expect("a relief"))
}

#[test]
fn slopes_from_standing_to_standing() {
    let ann = human(1.75, 73.0).expect("a person");
    for slope in [-15.0, -12.0, -10.0, -5.0, -2.0, 2.0, 5.0, 8.0, 10.0, 12.0, 13.0_f64] {
        judge(&format!("{slope}°"), &ann, &request(WalkGround::Slope(slope.to_radians()), 100.0));
    }
    for (slope, step_frequency) in [(-12.0_f64, 115.0), (-15.0, 80.0), (10.0, 115.0), (10.0, 80.0)] {
        let slow_or_fast = request(WalkGround::Slope(slope.to_radians()), step_frequency);
        judge(&format!("{slope}° at {step_frequency}"), &ann, &slow_or_fast);
    }
    // Slow ones need longer steps and time for the last shift of the pressure; at 15° they need more than that.
    for (slope, step_frequency) in
        [(4.0_f64, 60.0), (8.0, 60.0), (10.0, 65.0), (12.0, 70.0), (13.0, 60.0), (14.0, 75.0), (15.0, 90.0)]
    {
        let slow = request(WalkGround::Slope(slope.to_radians()), step_frequency);
        judge(&format!("{slope}° at {step_frequency}"), &ann, &slow);
    }
    // However few steps: a walk that begins as it ends.
    for (slope, steps) in [(10.0, 1), (10.0, 2), (-10.0, 1), (-10.0, 3_usize)] {
        let ground = WalkGround::Slope(f64::to_radians(slope));
        let short = WalkRequest { extent: Extent::Steps(steps), ..request(ground, 100.0) };
        judge(&format!("{steps} steps on {slope}°"), &ann, &short);
    }
}

/// Feet that came to be flat, or rose, at once pressed 6 to 18 mm beside themselves for some milliseconds.
#[test]
fn feet_come_down_and_rise_softly() {
    let slope = |degrees: f64| WalkGround::Slope(degrees.to_radians());
    let stairs = |count, rise, tread| WalkGround::Stairs(Stairs { count, rise, tread });
    for (height, ground, step_frequency) in [
        (1.94, relief(&[[1.8895, 0.0], [1.8895, 0.0979]]), 110.0),
        (1.80, slope(0.56), 115.0),
        (1.95, slope(0.97), 116.0),
        (1.55, slope(-14.9), 110.0),
        (1.92, slope(-12.9), 108.0),
        (1.79, stairs(8, 0.192, 0.313), 72.0),
        (1.92, stairs(4, -0.191, 0.301), 109.0),
    ] {
        let person = human(height, 23.8 * height * height).expect("a person");
        judge_finely(&format!("{ground:?}, {height} m"), &person, &request(ground, step_frequency));
    }
}

/// A foot that leaves the ground late has little of its swing left: the knee had gone to 97° on level ground, to 121° up 10°.
#[test]
fn the_swinging_knee_of_slow_steps_bends_as_others_do() {
    let ann = human(1.75, 73.0).expect("a person");
    let child = Human::new(1.1, 20.0).age(6.0).build().expect("a child");
    let slope = |degrees: f64| WalkGround::Slope(degrees.to_radians());
    for (figure, ground, step_frequency) in [
        (&ann, WalkGround::Level, 60.0),
        (&ann, WalkGround::Level, 70.0),
        (&ann, slope(0.0), 60.0),
        (&ann, slope(1.0), 60.0),
        (&ann, slope(-3.0), 65.0),
        (&ann, slope(6.0), 60.0),
        (&ann, slope(10.0), 60.0),
        (&ann, slope(10.0), 75.0),
        (&child, WalkGround::Level, 77.0),
        (&child, WalkGround::Level, 93.0),
        (&child, WalkGround::Level, 100.0),
    ] {
        let population = if figure == &child { Population::Child } else { Population::Adult };
        let asked = WalkRequest { population, ..request(ground.clone(), step_frequency) };
        let plan = walk(figure, &asked).expect("a walk");
        let motion = plan.motion(figure, 120.0).expect("a motion");
        let greatest = ["left", "right"].map(|side| {
            let angle = figure.anatomical_angle(&format!("{side}_knee.flexion")).expect("a knee");
            let bent = |frame: usize| angle.sign * motion.q(frame)[angle.coordinate];
            (0..motion.len()).map(bent).fold(0.0, f64::max).to_degrees()
        });
        let greatest = greatest[0].max(greatest[1]);
        assert!((60.0..80.0).contains(&greatest), "{ground:?} at {step_frequency} steps/min: {greatest:.1}°");
    }
}

/// The pace and the distance that are asked for are those on the slope, and a speed is kept where other steps are tried.
#[test]
fn what_is_asked_for_on_a_slope_is_walked() {
    let ann = human(1.75, 73.0).expect("a person");
    // Contacts of steps in the middle of the walk, along the level, and the time between them.
    let middle = |plan: &WalkPlan| {
        let (prints, half) = (plan.prints(), plan.steps() / 2);
        let length = prints[half + 1] - prints[half];
        (length, length / (0.5 * plan.style_of_step(half).stride_time))
    };
    for slope in [-12.0_f64, -6.0, 0.01, 7.0, 12.0] {
        let ground = WalkGround::Slope(slope.to_radians());
        let walked =
            |request: WalkRequest| walk(&ann, &request).unwrap_or_else(|error| panic!("{slope}°: {error}"));
        let twelve =
            WalkRequest { extent: Extent::Steps(12), ground: ground.clone(), ..WalkRequest::default() };
        let (length, speed) = (0.61 * step_length_on_slope(slope.to_radians()), 1.05);
        let plan = walked(WalkRequest { step_length: Some(length), ..twelve.clone() });
        assert!((middle(&plan).0 - length).abs() < 1e-9, "{slope}°: {} m", middle(&plan).0);
        let plan = walked(WalkRequest { speed: Some(speed), ..twelve.clone() });
        assert!((middle(&plan).1 - speed).abs() < 1e-9, "{slope}°: {} m/s", middle(&plan).1);
        for distance in [3.0, 8.0] {
            let plan = walked(WalkRequest { extent: Extent::Distance(distance), ..twelve.clone() });
            assert!((plan.destination().0.z - distance).abs() < 1e-9, "{slope}°: {:?}", plan.destination());
        }
    }
    // At this speed people's steps do not hold at 14°, and longer ones, made less often, do.
    let steep = WalkRequest {
        speed: Some(0.53),
        ground: WalkGround::Slope(14f64.to_radians()),
        extent: Extent::Steps(12),
        ..WalkRequest::default()
    };
    let plan = walk(&ann, &steep).expect("a walk");
    assert!((middle(&plan).1 - 0.53).abs() < 1e-9 && plan.style().step_frequency < 66.5);
    // So do those of a distance.
    for (slope, step_frequency, distance) in [(13f64, 60.0, 4.0), (15.0, 80.0, 4.33), (15.0, 75.0, 6.0)] {
        let far = WalkRequest {
            step_frequency: Some(step_frequency),
            ground: WalkGround::Slope(slope.to_radians()),
            extent: Extent::Distance(distance),
            ..WalkRequest::default()
        };
        let plan = walk(&ann, &far).unwrap_or_else(|error| panic!("{slope}°: {error}"));
        assert!((plan.destination().0.z - distance).abs() < 1e-9);
    }
    // As short as no person walks at this pace, named by what is asked for.
    let short = WalkRequest { step_length: Some(0.4), step_frequency: Some(100.0), ..steep };
    let short = WalkRequest { speed: None, ..short };
    assert!(walk(&ann, &short).err().expect("too short").to_string().contains("step length"));
}

#[test]
fn from_the_level_up_or_down_a_ramp_and_on() {
    let ann = human(1.75, 73.0).expect("a person");
    for slope in [-14.0, -12.0, -8.0, -4.0, 4.0, 7.0, 10.0, 12.0, 14.0_f64] {
        let ramp = relief(&[[1.8, 0.0], [4.8, 3.0 * slope.to_radians().tan()]]);
        judge(&format!("ramp of {slope}°"), &ann, &request(ramp, 100.0));
    }
}

#[test]
fn kerbs() {
    let ann = human(1.75, 73.0).expect("a person");
    for height in [-0.10, -0.05, 0.05, 0.10] {
        judge(&format!("kerb of {height} m"), &ann, &request(relief(&[[2.0, 0.0], [2.0, height]]), 100.0));
    }
    for (height, step_frequency) in [
        (-0.19, 100.0),
        (-0.15, 75.0),
        (-0.10, 70.0),
        (0.10, 70.0),
        (0.10, 90.0),
        (0.15, 110.0),
        (0.19, 100.0),
    ] {
        let asked = request(relief(&[[2.0, 0.0], [2.0, height]]), step_frequency);
        judge_loaded(&format!("kerb of {height} m at {step_frequency}"), &ann, &asked, 165.0);
    }
}

#[test]
fn who_asks_for_a_distance_or_a_step_length_gets_that_or_nothing() {
    let ann = human(1.75, 73.0).expect("a person");
    let kerb = request(relief(&[[2.0, 0.0], [2.0, 0.15]]), 90.0);
    assert!(walk(&ann, &kerb).is_ok());
    let distance = WalkRequest { extent: Extent::Distance(8.0), ..kerb.clone() };
    let plan = walk(&ann, &distance).expect("a walk");
    assert!((plan.destination().0.z - 8.0).abs() < 1e-6);
    for asked in [
        WalkRequest { step_length: Some(0.6), ..kerb.clone() },
        WalkRequest { speed: Some(0.9), step_frequency: None, ..kerb.clone() },
    ] {
        assert!(walk(&ann, &asked).is_err(), "{asked:?}");
    }
}

#[test]
fn stairs_up_and_down() {
    let ann = human(1.75, 73.0).expect("a person");
    for (rise, tread, step_frequency) in [
        (0.17, 0.29, 88.0),
        (0.15, 0.30, 100.0),
        (0.19, 0.30, 88.0),
        (-0.17, 0.29, 100.0),
        (-0.15, 0.26, 110.0),
    ] {
        let stairs = WalkGround::Stairs(Stairs { count: 8, rise, tread });
        judge(&format!("stairs {rise} over {tread}"), &ann, &request(stairs, step_frequency));
    }
}

/// All stairs, slowly, at the usual pace and fast. On steep ones people press with up to 1.6 times their weight (A. Stacoff et al., *Gait & Posture*
/// 21 (2005) 24–38).
#[test]
fn stairs_of_any_rise_and_tread_at_any_pace() {
    let ann = human(1.75, 73.0).expect("a person");
    for rise in [0.10, 0.12, 0.15, 0.17, 0.20] {
        for tread in [0.25, 0.29, 0.35] {
            for (rise, step_frequency) in
                [(rise, 70.0), (rise, 88.0), (rise, 110.0), (-rise, 70.0), (-rise, 100.0), (-rise, 110.0)]
            {
                let stairs = WalkGround::Stairs(Stairs { count: 6, rise, tread });
                let name = format!("stairs {rise} over {tread} at {step_frequency}");
                judge_loaded(&name, &ann, &request(stairs, step_frequency), 160.0);
            }
        }
    }
}

/// Toes roll there before the pressure has come to its place before that.
#[test]
fn quick_steps_up_a_steep_slope_are_planned_or_refused_with_advice() {
    let ann = human(1.75, 73.0).expect("a person");
    for step_frequency in [120.0, 125.0, 130.0] {
        let slope = WalkGround::Slope(14.9_f64.to_radians());
        if let Err(error) = walk(&ann, &request(slope, step_frequency)) {
            let message = error.to_string();
            let advised = ["the nearest slope that holds is ", "take a gentler slope, or walk slower"];
            assert!(advised.iter().any(|advice| message.contains(advice)), "{step_frequency}: {message}");
        }
    }
}

/// The last steps take more time, or nobody would come to a stop after them.
#[test]
fn quick_stairs_up() {
    for (height, rise) in [(1.65, 0.13), (1.75, 0.15), (1.85, 0.17)] {
        let figure = human(height, 22.0 * height * height).expect("a person");
        let stairs = WalkGround::Stairs(Stairs { count: 5, rise, tread: 0.29 });
        judge_loaded(&format!("{height} m, {rise} m"), &figure, &request(stairs, 125.0), 160.0);
    }
}

/// Feet as long as a tread, and short legs.
#[test]
fn stairs_for_the_tall_and_the_short() {
    for (height, mass) in [(1.55, 50.0), (1.95, 90.0)] {
        let figure = human(height, mass).expect("a person");
        for (rise, step_frequency) in [(0.16, 88.0), (-0.16, 95.0)] {
            let stairs = WalkGround::Stairs(Stairs { count: 6, rise, tread: 0.26 });
            judge_loaded(
                &format!("{height} m, rise {rise}"),
                &figure,
                &request(stairs, step_frequency),
                160.0,
            );
        }
    }
}

/// The same stairs are higher for short legs: knees bend more, and ankles stay within what they can.
#[test]
fn short_people_go_up_and_down_the_stairs_of_everyone() {
    // Steep and deep ones do not hold in the usual style.
    for height in [1.5, 1.6, 1.9] {
        let figure = human(height, 23.5 * height * height).expect("a person");
        for (rise, step_frequency) in [(0.20, 88.0), (-0.20, 100.0)] {
            for tread in [0.25, 0.30, 0.35] {
                let stairs = WalkGround::Stairs(Stairs { count: 5, rise, tread });
                let name = format!("{height} m, rise {rise} over {tread} at {step_frequency}");
                judge_loaded(&name, &figure, &request(stairs, step_frequency), 160.0);
            }
        }
    }
    for height in [1.46, 1.50, 1.56, 1.63] {
        let figure = human(height, 22.0 * height * height).expect("a person");
        for (rise, tread) in [(0.15, 0.30), (0.17, 0.29)] {
            for (rise, step_frequency) in [(rise, 80.0), (rise, 100.0), (-rise, 90.0), (-rise, 100.0)] {
                let stairs = WalkGround::Stairs(Stairs { count: 6, rise, tread });
                let name = format!("{height} m, rise {rise} over {tread} at {step_frequency}");
                judge_loaded(&name, &figure, &request(stairs, step_frequency), 160.0);
            }
        }
    }
}

/// A slope of next to nothing is the same walk as level ground that is told by its points.
#[test]
fn hardly_a_slope_is_level() {
    let ann = human(1.75, 73.0).expect("a person");
    let level = walk(&ann, &request(relief(&[[0.0, 0.0]]), 100.0)).expect("a walk");
    let sloped = walk(&ann, &request(WalkGround::Slope(1e-7), 100.0)).expect("a walk");
    let mut q = [vec![0.0; ann.layout().nq()], vec![0.0; ann.layout().nq()]];
    for clock in [-0.3, 0.7, 3.2, 5.4] {
        level.configuration_at(clock, &mut q[0]);
        sloped.configuration_at(clock, &mut q[1]);
        for (a, b) in q[0].iter().zip(&q[1]) {
            assert!((a - b).abs() < 1e-4, "{clock}: {a} {b}");
        }
    }
}

#[test]
fn what_cannot_be_walked_on_is_refused_by_what_it_is() {
    let ann = human(1.75, 73.0).expect("a person");
    let why = |ground: WalkGround| {
        walk(&ann, &request(ground, 100.0)).map(|_| ()).expect_err("no walk").to_string()
    };
    assert!(why(WalkGround::Slope(0.5)).contains("slope"));
    assert!(why(WalkGround::Slope(f64::NAN)).contains("slope"));
    assert!(why(WalkGround::Stairs(Stairs { rise: 0.4, ..Stairs::default() })).contains("rise"));
    assert!(why(WalkGround::Stairs(Stairs { count: 0, ..Stairs::default() })).contains("stairs"));
    // What nearly holds is refused with what does.
    let steep = why(WalkGround::Slope(15f64.to_radians()));
    assert!(steep.contains("the nearest slope that holds is 14.0°"), "{steep}");
    // A ditch that no foot finds a place in, and a wall.
    assert!(why(relief(&[[2.0, 0.0], [2.0, 1.0]])).contains("step"));
}

/// Steps are as many and as long as lead there, whatever slopes they go over and wherever no foot stands across an edge.
#[test]
fn a_distance_over_a_ramp_is_met() {
    let ann = human(1.75, 73.0).expect("a person");
    for (slope, distance) in [(10.0_f64, 8.0), (-10.0, 8.0), (6.0, 20.0), (-8.0, 5.0), (-8.0, 3.0)] {
        let ramp = relief(&[[1.8, 0.0], [5.8, 4.0 * slope.to_radians().tan()]]);
        let asked = WalkRequest { extent: Extent::Distance(distance), ..request(ramp, 90.0) };
        let plan = walk(&ann, &asked).unwrap_or_else(|error| panic!("{slope}°: {error}"));
        let off = plan.destination().0.z - distance;
        assert!(off.abs() < 1e-6, "{slope}°: {off} m beside {distance} m");
    }
    // Before a kerb and after it, where steps fewer, more, shorter and longer are what leads there, or edges as stairs.
    for (height, distance) in
        [(0.06, 3.65), (0.06, 4.25), (0.06, 6.0), (-0.12, 4.1), (-0.12, 2.6), (-0.14, 6.4), (0.12, 4.9)]
    {
        let kerb = relief(&[[3.0, 0.0], [3.0, height]]);
        let asked = WalkRequest { extent: Extent::Distance(distance), ..request(kerb, 100.0) };
        let plan = walk(&ann, &asked).unwrap_or_else(|error| panic!("kerb of {height} m: {error}"));
        let off = plan.destination().0.z - distance;
        assert!(off.abs() < 1e-6, "kerb of {height} m: {off} m beside {distance} m");
    }
}
