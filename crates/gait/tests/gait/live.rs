//! Walkers that are steered while they walk: starts and stops, paces, turns, walking aside and back, arrival, snapshots, what is refused.

use crate::driven::{Driver, person};
use solaris_gait::{Bent, Command, Extent, LiveError, WalkRequest, Walker, walk};
use solaris_model::{Figure, Human, RootOrder, Trajectory, human};
use std::f64::consts::{FRAC_PI_2, PI};

const RATE: f64 = 240.0;

/// Commands round a circle (m, m/s), a tenth of a second each.
pub(crate) fn circle(radius: f64, speed: f64) -> Vec<(Command, f64)> {
    let count = (20.0 * PI * radius / speed) as usize;
    let at = |k: usize| 0.1 * k as f64 * speed / radius;
    (0..count).map(|k| (Command::velocity(speed * at(k).sin(), speed * at(k).cos()), 0.1)).collect()
}

/// What every driven walk keeps.
fn keeps(name: &str, figure: &Figure, driver: &Driver<'_>) {
    let (found, height) = (&driver.found, figure.stature().expect("a person"));
    println!("{name}: {found:.5?}");
    assert!(found.slide.0 < 1e-4 && found.sink < 1e-6, "{name}: {found:?}");
    assert!(found.feet.0 > 0.03 * height, "{name}: {found:?}");
    assert!(found.knees[0] > 0.01 && found.knees[1] < 1.6, "{name}: {found:?}");
    assert!(found.rate.0 < 35.0 && found.change.0 < 4000.0 && found.root_change < 40.0, "{name}: {found:?}");
}

#[test]
fn it_starts_goes_at_any_pace_and_stops() {
    let figure = person(1.75);
    for speed in [0.3, 0.6, 0.9, 1.2, 1.5] {
        let mut driver = Driver::new(&figure, RATE);
        driver.go(&Command::velocity(0.0, speed), 9.0);
        let from = driver.walker.place()[1];
        // A whole number of steps of any pace, nearly.
        driver.go(&Command::velocity(0.0, speed), 12.0);
        let went = (driver.walker.place()[1] - from) / 12.0;
        assert!((went - speed).abs() < 0.05 * speed, "{went} m/s for {speed}");
        driver.go(&Command::stop(), 7.0);
        assert!(driver.walker.is_standing(), "{speed} m/s");
        assert!(driver.walker.place()[0].abs() < 0.03 && driver.walker.heading().abs() < 1e-9);
        keeps(&format!("{speed} m/s"), &figure, &driver);
        let before = driver.walker.configuration().to_vec();
        driver.go(&Command::stop(), 0.5);
        let moved = before.iter().zip(driver.walker.configuration()).map(|(a, b)| (a - b).abs());
        assert!(moved.fold(0.0, f64::max) < 2e-3, "it stands");
    }
}

#[test]
fn it_turns_about_walks_circles_and_turns_on_the_spot() {
    let figure = person(1.75);
    let mut driver = Driver::new(&figure, RATE);
    driver.go(&Command::velocity(0.0, 1.2), 4.0).go(&Command::velocity(0.0, -1.2), 7.0);
    assert!((driver.walker.heading().abs() - PI).abs() < 0.05, "{}", driver.walker.heading());
    keeps("a U-turn", &figure, &driver);

    let mut driver = Driver::new(&figure, RATE);
    for k in 0..60 {
        let angle = f64::from(k) * 0.21;
        driver.go(&Command::velocity(0.8 * angle.sin(), 0.8 * angle.cos()), 0.6);
    }
    // Headings go on past whole turns.
    assert!(driver.walker.heading() > 9.0, "{}", driver.walker.heading());
    keeps("two circles", &figure, &driver);

    let mut driver = Driver::new(&figure, RATE);
    driver.go(&Command::stop().facing(PI), 11.0);
    let [x, z] = driver.walker.place();
    assert!((driver.walker.heading().abs() - PI).abs() < 0.01 && x.hypot(z) < 0.05, "{x}, {z}");
    assert!(driver.walker.is_standing());
    keeps("on the spot", &figure, &driver);
}

#[test]
fn it_faces_a_point_while_it_walks_aside_and_goes_backward() {
    let figure = person(1.75);
    let mut driver = Driver::new(&figure, RATE);
    driver.go(&Command::velocity(0.2, 0.0).facing_point(0.0, 5.0), 12.0);
    let ([x, z], heading) = (driver.walker.place(), driver.walker.heading());
    assert!(x > 1.7 && z.abs() < 0.3, "{x}, {z}");
    assert!((heading - (-x).atan2(5.0 - z)).abs() < 0.1, "{heading} at {x}, {z}");
    keeps("aside", &figure, &driver);

    let mut driver = Driver::new(&figure, RATE);
    driver.go(&Command::own_velocity(0.0, -0.4), 10.0).go(&Command::stop(), 4.0);
    let [x, z] = driver.walker.place();
    assert!(z < -2.8 && x.abs() < 0.05 && driver.walker.heading().abs() < 1e-6, "{x}, {z}");
    keeps("backward", &figure, &driver);
}

#[test]
fn it_comes_to_points_and_stops_there() {
    let figure = person(1.75);
    for point in [[0.0, 0.4], [1.0, 3.0], [-2.0, -1.0], [0.3, 8.0]] {
        let mut driver = Driver::new(&figure, RATE);
        driver.go(&Command::to_point(point[0], point[1], 1.2), 18.0);
        let [x, z] = driver.walker.place();
        assert!(driver.walker.is_standing(), "{point:?}");
        assert!((x - point[0]).hypot(z - point[1]) < 0.05, "{x}, {z} for {point:?}");
        keeps(&format!("to {point:?}"), &figure, &driver);
    }
}

#[test]
fn it_settles_at_any_point_and_does_not_dance_around_it() {
    let points = [[1.0, 4.0], [0.0, 3.0], [-2.0, 1.0], [0.3, 0.2], [0.0, -2.0], [5.0, 5.0], [0.1, 0.0]];
    for (height, mass) in [(1.65, 58.0), (1.75, 73.0), (1.2, 25.0)] {
        let ann = Human::new(height, mass).root(RootOrder::Yzx).build().expect("a person");
        let walker = Walker::new(&ann).expect("a walker");
        for [x, z] in points {
            let mut walker = walker.clone();
            let mut frames = 0;
            while frames < 1200 && (frames < 60 || !walker.is_standing()) {
                walker.step(1.0 / 60.0, &Command::to_point(x, z, 1.3)).expect("a frame");
                frames += 1;
            }
            let [x0, z0] = walker.place();
            let off = (x0 - x).hypot(z0 - z);
            assert!(
                walker.is_standing() && off < 0.03,
                "({x}, {z}) of {height} m: {off} m after {frames} frames"
            );
            // Turned where it went, in a bow to what is behind, and not once round.
            assert!(walker.heading().abs() < 5.0, "({x}, {z}) of {height} m: {}", walker.heading());
        }
    }
}

#[test]
fn a_command_takes_effect_at_the_next_footfall() {
    let figure = person(1.75);
    let mut walker = Walker::new(&figure).expect("a walker");
    for _ in 0..720 {
        walker.step(1.0 / 120.0, &Command::velocity(0.0, 1.2)).expect("a frame");
    }
    let mut waited = 0.0;
    while walker.velocity()[1] > 1.19 {
        walker.step(1.0 / 120.0, &Command::velocity(0.0, 0.6)).expect("a frame");
        waited += 1.0 / 120.0;
    }
    assert!(waited < 0.6, "{waited} s");
}

/// A steady walk is the planned one: hips and knees within some degrees at the same part of the step.
#[test]
fn a_steady_walk_is_the_planned_stride() {
    let figure = person(1.75);
    let dof = |name: &str| figure.layout().q_names().iter().position(|q| q == name).expect("a dof");
    let names =
        ["left_hip.rx", "left_knee.rx", "left_ankle.rx", "right_hip.rx", "right_knee.rx", "left_shoulder.rx"];
    for step_frequency in [85.0, 100.0, 110.0] {
        let extent = Extent::Steps(60);
        let request = WalkRequest { step_frequency: Some(step_frequency), extent, ..WalkRequest::default() };
        let plan = walk(&figure, &request).expect("a walk");
        let stride = plan.stride_loop().expect("a stride");
        let mut driver = Driver::new(&figure, RATE);
        driver.go(&Command::velocity(0.0, stride.speed()), 9.0);
        let from = (driver.time(), driver.walker.configuration()[2]);
        let mut rows: Vec<Vec<f64>> = Vec::new();
        for _ in 0..(2.0 * stride.duration() * RATE) as usize {
            driver.go(&Command::velocity(0.0, stride.speed()), 1.0 / RATE);
            rows.push(driver.walker.configuration().to_vec());
        }
        let speed = (driver.walker.configuration()[2] - from.1) / (driver.time() - from.0);
        assert!((speed / stride.speed() - 1.0).abs() < 0.01, "{speed} for {}", stride.speed());
        // The shift of time at which both agree best.
        let mut q = vec![0.0; figure.layout().nq()];
        let mut apart = |shift: f64| {
            let mut sums = [0.0; 6];
            for (k, row) in rows.iter().enumerate() {
                stride.configuration((k as f64 / RATE + shift) % stride.duration(), &mut q);
                for (sum, name) in sums.iter_mut().zip(names) {
                    *sum += (row[dof(name)] - q[dof(name)]).powi(2) / rows.len() as f64;
                }
            }
            sums.map(|sum: f64| sum.sqrt().to_degrees())
        };
        let shifts = (0..200).map(|k| f64::from(k) / 200.0 * stride.duration());
        let best = shifts.map(&mut apart).min_by(|a, b| a[1].total_cmp(&b[1])).expect("shifts");
        println!(
            "{step_frequency}/min: hip, knee, ankle, right hip and knee, shoulder off by {best:.2?}° rms; {speed:.3} m/s"
        );
        assert!(best.iter().all(|off| *off < 1.6), "{best:?}");
    }
}

/// The plan's centre of pressure is what the motion asks of the ground. Prints the table of docs/live.md.
#[test]
fn the_ground_is_pressed_where_the_plan_says() {
    let figure = person(1.75);
    let walk = |speed: f64| Command::velocity(0.0, speed);
    let stop = Command::stop();
    for (name, script, from, most) in [
        ("steady, 0.5 m/s", vec![(walk(0.5), 10.0)], 5.0, 0.03),
        ("steady, 0.9 m/s", vec![(walk(0.9), 10.0)], 5.0, 0.03),
        ("steady, 1.3 m/s", vec![(walk(1.3), 10.0)], 5.0, 0.03),
        ("from standing to 1.2 m/s", vec![(walk(1.2), 3.0)], 0.0, 0.042),
        ("from 1.2 m/s to a stop", vec![(walk(1.2), 6.0), (stop, 5.0)], 6.0, 0.04),
        ("a circle of 2 m, 0.9 m/s", circle(2.0, 0.9), 0.0, 0.04),
        ("on the spot", vec![(stop.facing(PI), 8.0)], 2.0, 0.08),
        ("aside, 0.2 m/s", vec![(Command::own_velocity(0.2, 0.0), 8.0)], 2.0, 0.08),
        ("backward, 0.4 m/s", vec![(Command::own_velocity(0.0, -0.4), 8.0)], 2.0, 0.08),
    ] {
        let mut driver = Driver::new(&figure, RATE).keeping();
        for (command, time) in script {
            driver.go(&command, time);
        }
        let all: Vec<_> = driver.pressures().into_iter().filter(|(time, ..)| *time > from).collect();
        let part = |values: &mut Vec<f64>, part: f64| {
            values.sort_by(f64::total_cmp);
            values[(part * (values.len() - 1) as f64) as usize]
        };
        let mut off: Vec<f64> = all.iter().map(|(.., off)| 1e3 * off).collect();
        let mut vertical: Vec<f64> = all.iter().map(|(_, force, _)| 100.0 * force.y).collect();
        let mut friction: Vec<f64> =
            all.iter().map(|(_, force, _)| force.x.hypot(force.z) / force.y).collect();
        let (median, nearly_all) = (part(&mut off, 0.5), part(&mut off, 0.95));
        println!(
            "| {name} | {median:.0} | {nearly_all:.0} | {:.0} to {:.0} | {:.2} |",
            part(&mut vertical, 0.02),
            part(&mut vertical, 0.98),
            part(&mut friction, 0.98)
        );
        assert!(median < 1e3 * most && nearly_all < 2.5e3 * most, "{name}: {median}, {nearly_all} mm");
    }
}

#[test]
fn a_clone_goes_on_to_the_same_bits() {
    let figure = person(1.75);
    let mut walker = Walker::new(&figure).expect("a walker");
    let drive = |walker: &mut Walker, from: usize, to: usize| {
        for k in from..to {
            let angle = 0.01 * k as f64;
            let command = Command::velocity(angle.sin(), angle.cos());
            walker.step(1.0 / 60.0, &command).expect("a frame");
        }
    };
    drive(&mut walker, 0, 331);
    let mut snapshot = walker.clone();
    drive(&mut walker, 331, 900);
    drive(&mut snapshot, 331, 900);
    assert!(
        walker.configuration().iter().zip(snapshot.configuration()).all(|(a, b)| a.to_bits() == b.to_bits())
    );
}

#[test]
fn what_is_no_command_is_refused_and_loses_nothing() {
    let figure = person(1.75);
    let mut walker = Walker::new(&figure).expect("a walker");
    let forward = Command::velocity(0.0, 1.0);
    for _ in 0..100 {
        walker.step(1.0 / 60.0, &forward).expect("a frame");
    }
    let before = walker.configuration().to_vec();
    for dt in [0.0, -1.0 / 60.0, 10.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(walker.step(dt, &forward), Err(LiveError::Frame { .. })), "{dt}");
    }
    for command in [
        Command::velocity(f64::NAN, 0.0),
        Command::own_velocity(0.0, f64::INFINITY),
        Command::to_point(0.0, f64::NAN, 1.0),
        Command::to_point(0.0, 1.0, f64::NAN),
        Command::stop().facing(f64::NAN),
        Command::stop().facing_point(1e30, 0.0),
    ] {
        let error = walker.step(1.0 / 60.0, &command).expect_err("a refusal");
        assert!(matches!(error, LiveError::NotFinite { .. }), "{command:?}: {error}");
    }
    assert_eq!(walker.configuration(), before);
    let usual = human(1.75, 73.0).expect("a person");
    let error = Walker::new(&usual).err().expect("a refusal").to_string();
    assert!(error.contains("Yzx"), "{error}");
}

#[test]
fn what_cannot_be_walked_is_bent_and_said() {
    let figure = person(1.75);
    let bent = |command: Command| {
        let mut driver = Driver::new(&figure, 120.0);
        let mut all = Vec::new();
        for _ in 0..1000 {
            driver.go(&command, 1.0 / 120.0);
            all.extend(driver.walker.bent());
        }
        keeps(&format!("{command:?}"), &figure, &driver);
        all
    };
    assert!(bent(Command::velocity(0.0, 5.0)).contains(&Bent::Fast));
    assert!(bent(Command::own_velocity(1.0, 0.0)).contains(&Bent::Aside));
    assert!(bent(Command::own_velocity(0.0, -2.0)).contains(&Bent::Aside));
    assert!(bent(Command::velocity(1.0, 0.0).facing(-FRAC_PI_2)).contains(&Bent::Sharp));
    assert!(bent(Command::velocity(0.0, 1.2)).contains(&Bent::Sudden));
}

#[test]
fn other_bodies_walk_too() {
    let child = Human::new(1.25, 26.0).age(7.0).root(solaris_model::RootOrder::Yzx).build().expect("a child");
    for figure in [person(1.5), person(1.95), child] {
        let mut driver = Driver::new(&figure, RATE);
        driver
            .go(&Command::velocity(0.0, 0.9), 4.0)
            .go(&Command::velocity(0.9, 0.0), 4.0)
            .go(&Command::own_velocity(0.15, 0.0), 4.0)
            .go(&Command::stop(), 4.0);
        assert!(driver.walker.is_standing());
        keeps(figure.name(), &figure, &driver);
    }
}

#[test]
fn an_arm_can_be_freed_and_taken_back() {
    let figure = person(1.75);
    let mut driver = Driver::new(&figure, RATE);
    let dof = figure.layout().q_names().iter().position(|q| q == "left_shoulder.rx").expect("a dof");
    driver.go(&Command::velocity(0.0, 1.0), 4.0);
    driver.walker.set_freed("left_shoulder.rx", -1.5).expect("a number");
    driver.walker.free("left_shoulder.rx").expect("a dof");
    driver.go(&Command::velocity(0.0, 1.0), 1.0);
    assert!((driver.walker.configuration()[dof] + 1.5).abs() < 1e-12);
    driver.walker.hold("left_shoulder.rx").expect("a dof");
    driver.go(&Command::velocity(0.0, 1.0), 2.0);
    assert!(driver.walker.configuration()[dof].abs() < 0.7);
    for dof in ["left_knee.rx", "root.tx", "nothing"] {
        assert!(matches!(driver.walker.free(dof), Err(LiveError::NotFree { .. })), "{dof}");
    }
    assert!(driver.walker.set_freed("left_shoulder.rx", f64::NAN).is_err());
    keeps("an arm", &figure, &driver);
}

/// Velocities and accelerations on demand are those of the positions.
#[test]
fn derivatives_are_those_of_the_motion() {
    let figure = person(1.75);
    let mut walker = Walker::new(&figure).expect("a walker");
    let n = figure.layout().nq();
    let (mut v, mut a) = (vec![0.0; n], vec![0.0; n]);
    let (mut before, mut off) = (walker.configuration().to_vec(), Vec::new());
    let dt = 1e-3;
    for _ in 0..4000 {
        let q = walker.step(dt, &Command::velocity(0.0, 1.1)).expect("a frame").to_vec();
        walker.derivatives(&mut v, &mut a).expect("slices");
        // Half a frame ago, by the acceleration.
        let apart = (0..n).map(|i| ((q[i] - before[i]) / dt - v[i] + 0.5 * dt * a[i]).abs());
        off.push(apart.fold(0.0, f64::max));
        before = q;
    }
    off.sort_by(f64::total_cmp);
    // Where pieces meet an acceleration jumps within the differences.
    let [median, nearly_all] = [off.len() / 2, off.len() * 99 / 100].map(|k| off[k]);
    println!("off by {median} rad/s, 99 % by less than {nearly_all}");
    assert!(median < 1e-3 && nearly_all < 0.2, "{median}, {nearly_all}");
    assert!(walker.derivatives(&mut v[1..], &mut a).is_err());
}
