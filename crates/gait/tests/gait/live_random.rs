//! Walkers under commands at random: planted feet, continuity and limbs at every frame, whatever comes.

use crate::driven::{Driver, Found, person};
use crate::random::Random;
use solaris_gait::{Command, Walker};

/// Any command, and how long it holds (s).
pub(crate) fn command(random: &mut Random) -> (Command, f64) {
    let command = match random.pick(8) {
        0 => Command::stop(),
        1..=3 => {
            let (angle, speed) = (random.within(-3.2, 3.2), random.within(0.0, 2.0));
            Command::velocity(speed * angle.sin(), speed * angle.cos())
        }
        4 | 5 => Command::own_velocity(random.within(-0.4, 0.4), random.within(-0.8, 1.6)),
        6 => Command::to_point(random.within(-4.0, 4.0), random.within(-4.0, 4.0), random.within(0.2, 1.8)),
        _ => Command::velocity(random.within(-1.0, 1.0), random.within(-1.0, 1.0))
            .facing(random.within(-4.0, 4.0)),
    };
    let faces = random.often(0.15);
    let command = if faces {
        command.facing_point(random.within(-3.0, 3.0), random.within(-3.0, 3.0))
    } else {
        command
    };
    (command, random.within(0.1, 4.0))
}

/// Drives for some time, and holds every frame against what walks keep.
fn driven(height: f64, seed: u64, rate: f64, time: f64) {
    let figure = person(height);
    let mut driver = Driver::new(&figure, rate);
    let mut random = Random(seed);
    while driver.time() < time {
        let (command, holds) = command(&mut random);
        driver.go(&command, holds);
    }
    holds(&driver.found, height, &format!("{height} m, seed {seed}"));
}

/// What every walk keeps, whatever it was told.
pub(crate) fn holds(found: &Found, height: f64, name: &str) {
    println!("{name}: {found:.5?}");
    assert!(found.slide.0 < 1e-4 && found.sink < 1e-6, "{name}: {found:?}");
    assert!(found.feet.0 > 0.025 * height, "{name}: {found:?}");
    assert!(found.knees[0] > 0.01 && found.knees[1] < 1.6, "{name}: {found:?}");
    assert!(found.rate.0 < 35.0 && found.change.0 < 4000.0 && found.root_change < 40.0, "{name}: {found:?}");
}

#[test]
fn two_minutes_of_any_commands_hold() {
    for (height, seed, rate) in [(1.75, 7, 240.0), (1.5, 8, 120.0), (1.95, 9, 60.0), (1.2, 10, 144.0)] {
        driven(height, seed, rate, 30.0);
    }
}

/// No coordinate jumps, nor does a rate by more than a fraction: third differences of a tenth of a millisecond see what frames of a game do not.
#[test]
fn no_coordinate_jumps_where_pieces_meet() {
    let figure = person(1.75);
    let names = figure.layout().q_names();
    let mut walker = Walker::new(&figure).expect("a walker");
    let (mut random, dt) = (Random(77), 1e-4);
    let mut last = [(); 3].map(|()| walker.configuration().to_vec());
    let mut worst = (0.0_f64, 0.0, "");
    let mut frame = 0;
    while frame < 400_000 {
        let (command, holds) = command(&mut random);
        for _ in 0..(holds / dt) as usize {
            let q = walker.step(dt, &command).expect("a frame");
            frame += 1;
            for (i, name) in names.iter().enumerate() {
                let third = q[i] - 3.0 * last[2][i] + 3.0 * last[1][i] - last[0][i];
                if third.abs() > worst.0 {
                    worst = (third.abs(), f64::from(frame) * dt, name);
                }
            }
            last.rotate_left(1);
            last[2].copy_from_slice(q);
        }
    }
    println!("{worst:?}");
    assert!(worst.0 < 2e-5, "{worst:?}");
}

#[test]
#[ignore = "an hour of walking"]
fn an_hour_of_any_commands_holds() {
    for k in 0..60 {
        driven([1.75, 1.5, 1.95, 1.65, 1.85][k % 5], 100 + k as u64, [240.0, 60.0, 120.0][k % 3], 60.0);
    }
}
