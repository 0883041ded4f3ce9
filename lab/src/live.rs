//! What frames of a walker that is steered cost, and pictures of one.

use crate::table::replace;
use crate::workspace::{read, write};
use solaris_analysis::Goal;
use solaris_gait::{Command, LiveError, Walker};
use solaris_model::{Figure, Human, Motion, MotionInfo, RootOrder, Vector3};
use solaris_modes::time::Stepping;
use solaris_modes::{ContactLaw, GroundPlane, Simulation, contact_points};
use solaris_view::{FilmOptions, Seen, film};
use std::fmt::Write as _;
use std::time::Instant;

const PAGE: &str = "docs/live.md";
const STRIP: &str = "docs/strips/live.svg";
const REACH: &str = "docs/strips/live-reach.svg";
/// Frames a second, and the seconds that are driven.
const RATE: f64 = 60.0;
/// In the frame of a hand (m).
const PALM: Vector3<f64> = Vector3::new(0.0, -0.08, 0.0);
const DRIVEN: f64 = 600.0;
/// How often all frames are made.
const ROUNDS: usize = 4;
/// How long somebody limp falls and lies (s).
const FALLS: f64 = 4.0;
/// Walkers of a crowd, and for how long (s).
const CROWD: (usize, f64) = (100, 20.0);

/// Writes all of it.
pub(crate) fn run() -> Result<(), String> {
    let figure = Human::new(1.75, 73.0).root(RootOrder::Yzx).build().map_err(|error| error.to_string())?;
    let (table, physics) = (cost(&figure)?, limp()?);
    println!("{table}\n\n{physics}");
    let page = replace(&read(PAGE)?, "cost", &table)?;
    write(PAGE, &replace(&page, "physics", &physics)?)?;
    write(STRIP, &strip(&figure, (2.2, 6.6), |_, time| Ok(steered(time)))?)?;
    write(REACH, &strip(&figure, (1.5, 5.9), reaching)?)
}

/// Commands as somebody who plays gives them: another one every 1.3 s.
fn command(time: f64, who: f64) -> Command {
    let k = (time / 1.3).floor() + 7.0 * who;
    let angle = 2.4 * k;
    match k as usize % 6 {
        0 => Command::stop(),
        1 => Command::own_velocity(0.2, 0.3),
        2 => Command::to_point(3.0 * angle.sin(), 3.0 * angle.cos(), 1.2),
        _ => Command::velocity(1.3 * angle.sin(), 1.3 * angle.cos()),
    }
}

fn cost(figure: &Figure) -> Result<String, String> {
    let say = |error: &dyn std::fmt::Display| error.to_string();
    let began = Instant::now();
    let walker = Walker::new(figure).map_err(|error| say(&error))?;
    let built = began.elapsed().as_secs_f64();
    // Each frame is made by several, for others may be at work on the machine: its least time is its own.
    let mut walkers = vec![walker.clone(); ROUNDS];
    let mut times = vec![f64::INFINITY; (DRIVEN * RATE) as usize];
    for walker in &mut walkers {
        for (frame, least) in times.iter_mut().enumerate() {
            let command = command(frame as f64 / RATE, 0.0);
            let began = Instant::now();
            walker.step(1.0 / RATE, &command).map_err(|error| say(&error))?;
            *least = least.min(1e6 * began.elapsed().as_secs_f64());
        }
    }
    let mean = times.iter().sum::<f64>() / times.len() as f64;
    times.sort_by(f64::total_cmp);
    let [median, hundredth, worst] =
        [times.len() / 2, times.len() * 99 / 100, times.len() - 1].map(|i| times[i]);
    let [reach, forces] = beside(&walker)?;
    let (count, seconds) = CROWD;
    let mut walkers = vec![walker; count];
    let began = Instant::now();
    for frame in 0..(seconds * RATE) as usize {
        for (who, walker) in walkers.iter_mut().enumerate() {
            let command = command(frame as f64 / RATE, who as f64);
            walker.step(1.0 / RATE, &command).map_err(|error| say(&error))?;
        }
    }
    let share = 100.0 * began.elapsed().as_secs_f64() / seconds;
    Ok(format!(
        "| | |\n|---|---|\n| `Walker::new`, once for all clones | {:.0} ms |\n| a frame at {RATE} Hz, planning included: mean | {mean:.1} µs |\n\
         | half of all frames | {median:.1} µs |\n| 99 of 100 | {hundredth:.0} µs |\n| the worst of {:.0} min | {worst:.0} µs |\n\
         | {count} walkers at {RATE} Hz | {share:.1} % of one core |\n| more, a frame in which a hand reaches: mean | {reach:.1} µs |\n\
         | more, the forces of a frame: mean | {forces:.1} µs |",
        1e3 * built,
        DRIVEN / 60.0
    ))
}

/// What a reach and forces add to a frame: means (µs).
fn beside(walker: &Walker) -> Result<[f64; 2], String> {
    let say = |error: &dyn std::fmt::Display| error.to_string();
    let mut tau = vec![0.0; walker.configuration().len()];
    let mut mean = |reaches: bool, asks: bool| -> Result<f64, String> {
        let mut least = f64::INFINITY;
        for _ in 0..ROUNDS {
            let mut walker = walker.clone();
            let began = Instant::now();
            for frame in 0..(60.0 * RATE) as usize {
                if reaches {
                    let goal = Goal::Place(walker.com() + Vector3::new(-0.35, 0.0, 0.15));
                    walker.reach("right_hand", PALM, &[], goal).map_err(|error| say(&error))?;
                }
                let command = command(frame as f64 / RATE, 0.0);
                walker.step(1.0 / RATE, &command).map_err(|error| say(&error))?;
                if asks {
                    walker.forces(&mut tau).map_err(|error| say(&error))?;
                }
            }
            least = least.min(1e6 * began.elapsed().as_secs_f64() / (60.0 * RATE));
        }
        Ok(least)
    };
    let alone = mean(false, false)?;
    Ok([mean(true, false)? - alone, mean(false, true)? - alone])
}

/// What frames of somebody limp cost who falls, comes to lie and lies, by impulses: the least of some rounds of each, as above.
fn limp() -> Result<String, String> {
    let say = |error: &dyn std::fmt::Display| error.to_string();
    let figure = Human::new(1.75, 73.0).limp().build().map_err(|error| say(&error))?;
    let mut simulation = Simulation::new(&figure, Vector3::y() * -9.81);
    let (mut q, mut v) = (simulation.state().0.to_vec(), vec![0.0; figure.layout().nv()]);
    q[1] = 1.2;
    (v[3], v[4]) = (2.0, 4.0);
    simulation.set_start(&q, &v).map_err(|error| say(&error))?;
    let plane = GroundPlane::under(&figure, simulation.gravity(), 0.8).map_err(|error| say(&error))?;
    let plane = GroundPlane { law: ContactLaw::Rigid, ..plane };
    simulation.set_ground(plane, contact_points(&figure)).map_err(|error| say(&error))?;
    let mut rows =
        "| a frame at 60 Hz, steps of | half of all frames | 99 of 100 | the worst |\n|---|---|---|---|"
            .to_owned();
    for steps in [2.0, 4.0, 16.0] {
        let step = (RATE * steps).recip();
        let mut times = vec![f64::INFINITY; (FALLS * RATE) as usize];
        for _ in 0..ROUNDS {
            let mut running = simulation.start(Stepping::Impulses { step }).map_err(|error| say(&error))?;
            for least in &mut times {
                let began = Instant::now();
                running.step(1.0 / RATE).map_err(|error| say(&error))?;
                *least = least.min(1e3 * began.elapsed().as_secs_f64());
            }
        }
        times.sort_by(f64::total_cmp);
        let [median, hundredth, worst] =
            [times.len() / 2, times.len() * 99 / 100, times.len() - 1].map(|i| times[i]);
        // Writing into a string does not fail.
        let _ =
            write!(rows, "\n| {:.1} ms | {median:.2} ms | {hundredth:.2} ms | {worst:.2} ms |", 1e3 * step);
    }
    Ok(rows)
}

/// Somebody walks on, turns and stops.
fn steered(time: f64) -> Command {
    match time {
        t if t < 2.5 => Command::velocity(0.0, 1.2),
        t if t < 5.5 => Command::velocity(1.2, 0.0),
        _ => Command::stop(),
    }
}

/// Somebody walks past a lamp that she looks at, with a hand on a rail for a while.
fn reaching(walker: &mut Walker, time: f64) -> Result<Command, LiveError> {
    let eyes = Vector3::new(0.0, 0.1, 0.08);
    let lamp = Goal::Look { axis: Vector3::z_axis(), at: Vector3::new(1.2, 1.3, 4.5) };
    if (2.0..5.0).contains(&time) {
        walker.reach("head", eyes, &[], lamp)?;
        let rail = Vector3::new(-0.4, 1.3, walker.com().z + 0.35);
        walker.reach("right_hand", PALM, &[], Goal::Place(rail))?;
    } else {
        walker.withdraw("head")?;
        walker.withdraw("right_hand")?;
    }
    Ok(Command::velocity(0.0, 1.1))
}

/// A film strip, of a part of nine seconds, of who does what `told` says in every frame.
fn strip(
    figure: &Figure,
    between: (f64, f64),
    mut told: impl FnMut(&mut Walker, f64) -> Result<Command, LiveError>,
) -> Result<String, String> {
    let say = |error: &dyn std::fmt::Display| error.to_string();
    let mut walker = Walker::new(figure).map_err(|error| say(&error))?;
    let n = figure.layout().nq();
    let (mut time, mut columns) = (Vec::new(), [Vec::new(), Vec::new(), Vec::new()]);
    let (mut v, mut a) = (vec![0.0; n], vec![0.0; n]);
    for frame in 0..(9.0 * RATE) as usize {
        let t = frame as f64 / RATE;
        let command = told(&mut walker, t).map_err(|error| say(&error))?;
        let q = walker.step(1.0 / RATE, &command).map_err(|error| say(&error))?.to_vec();
        walker.derivatives(&mut v, &mut a).map_err(|error| say(&error))?;
        time.push(t);
        columns[0].extend(q);
        columns[1].extend(&v);
        columns[2].extend(&a);
    }
    let motion = Motion::new(figure, MotionInfo::on_earth(figure, RATE), time, columns);
    let motion = motion.map_err(|error| say(&error))?;
    let options = FilmOptions { between: Some(between), seen: Seen::Corner, ..FilmOptions::default() };
    film(figure, &motion, &options).map_err(|error| say(&error))
}
