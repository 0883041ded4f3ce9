//! Motions by a tolerance of the run, those of trees of links among them.

use super::{Outcome, Problem, linkages};
use crate::report::page::duration;
use crate::table::{Cell, Table};
use solaris_modes::Method;

const TOLERANCES: [f64; 3] = [1e-4, 1e-6, 1e-8];

pub(super) fn table() -> Result<Table, String> {
    let row = |problem: &Problem| {
        let mut row = vec![Cell::text(problem.name)];
        for tolerance in TOLERANCES {
            let solved = problem.solve(Method::Automatic { tolerance });
            let Outcome { off, time, .. } = solved.map_err(|error| format!("{}: {error}", problem.name))?;
            row.push(Cell::Numbers(vec![off.max(1e-13)]));
            row.push(Cell::Time(duration(time * 1e6)));
        }
        Ok(row)
    };
    let mut problems = vec![pendulum()?];
    problems.extend(linkages::all()?);
    problems.extend([governor()?, baby_boot()?]);
    Ok(Table {
        header: vec!["off (rad or m)", "tolerance 1e-4", "time", "1e-6", "time", "1e-8", "time"],
        rows: problems.iter().map(row).collect::<Result<_, String>>()?,
    })
}

/// A01: the point of a pendulum after 10 s, in closed form.
fn pendulum() -> Result<Problem, String> {
    const END: [f64; 2] = [-0.275_087_462_576_116_9, -0.961_419_205_099_125_3];
    Problem::of_scene("A01, pendulum, 10 s", "pendulum", |motion| {
        let (sin, cos) = motion.q(motion.len() - 1)[0].sin_cos();
        (sin - END[0]).hypot(-cos - END[1])
    })
}

/// A05: how high the slide of the stiff governor is, by an implicit method of Runge and Kutta to 1e-12.
fn governor() -> Result<Problem, String> {
    const HEIGHT: [(usize, f64); 7] = [
        (50, 0.743_249_425),
        (100, 0.501_420_922),
        (200, 0.505_909_294),
        (300, 0.513_246_078),
        (500, 0.535_563_104),
        (800, 0.583_178_337),
        (1000, 0.619_622_917),
    ];
    Problem::of_scene("A05, stiff governor, 10 s", "governor", |motion| {
        HEIGHT.iter().map(|(frame, height)| (motion.q(*frame)[1] - height).abs()).fold(0.0, f64::max)
    })
}

/// Kane's baby boot after 10 s, as Drake has it from `MotionGenesis`; its four runs differ by 2.5e-7 rad.
fn baby_boot() -> Result<Problem, String> {
    const END: [f64; 2] = [-61.312_983_340_691, -929.477_896_772_44];
    Problem::of_scene("baby boot, 10 s", "babyboot", |motion| {
        let end = motion.q(motion.len() - 1);
        END.iter().zip(end).map(|(known, is)| (known.to_radians() - is).abs()).fold(0.0, f64::max)
    })
}
