//! The numbers by which tables of style numbers are compared.

use super::measured::{Measured, apart};
use super::stride::{self, Case};
use super::walk;
use rayon::prelude::*;
use solaris_gait::{StyleTable, TEXTBOOK_BANDS, check_bands};

const HEIGHTS: [f64; 4] = [1.5, 1.6, 1.75, 1.9];
const STRETCHES: [f64; 3] = [0.9, 1.0, 1.1];
const STEPS: [usize; 5] = [1, 2, 3, 4, 10];
/// Step frequencies at which curves are printed.
const BESIDE: [f64; 3] = [95.0, 110.0, 120.0];
const FAST: [f64; 3] = [120.0, 125.0, 130.0];

/// Prints steady strides of all bodies and speeds, then whole walks that ship.
pub(crate) fn print(table: &StyleTable) -> Result<(), String> {
    measured(table)?;
    curves(table)?;
    strides(table)?;
    walks()
}

/// Prints how far a stride is from that of a measured person who walks as fast with as long steps.
fn measured(table: &StyleTable) -> Result<(), String> {
    let Some(measured) = Measured::read()? else { return Ok(()) };
    let found = stride::Found::of(&measured.case, table)?;
    let angles = measured.differences(&found.curves);
    let [hip, knee, ankle] = [0, 1, 2].map(|k| apart(&angles[20 * k..20 * k + 20]));
    let offset = (0..20).map(|k| found.curves[k] - measured.curves[k]).sum::<f64>() / 20.0;
    let loads = found.vertical.iter().zip(&measured.vertical).map(|(ours, theirs)| ours - theirs);
    let load = apart(&loads.collect::<Vec<_>>());
    println!(
        "measured person: hip {hip:.1} (and {offset:.1} in its mean), knee {knee:.1}, ankle {ankle:.1} °, \
         vertical force {load:.1} %BW rms\n"
    );
    for (ours, theirs) in found.curves.chunks(20).zip(measured.curves.chunks(20)) {
        let row = |values: &[f64]| values.iter().map(|x| format!("{x:5.0}")).collect::<Vec<_>>().concat();
        println!("{}\n{}", row(ours), row(theirs));
    }
    Ok(())
}

/// Prints curves of a stride, people's at its pace, and people's deviations, every 4 % of it.
fn curves(table: &StyleTable) -> Result<(), String> {
    for frequency in BESIDE {
        println!("at {frequency} steps/min: ours, people's mean and deviation over a stride");
        for curve in stride::Found::of(&Case::new(1.75, frequency, 1.0)?, table)?.beside {
            let people = &curve.people;
            let digits = usize::from(people.unit != "°") + usize::from(people.unit.contains("/kg"));
            println!(
                "{} ({}): apart {:.2}, within two deviations {:.0} %",
                people.name,
                people.unit,
                curve.difference(),
                100.0 * curve.within(2.0)
            );
            for values in [&curve.values, &people.mean, &people.deviation] {
                let row = values.iter().map(|x| format!("{x:6.digits$}")).collect::<Vec<_>>().concat();
                println!("{row}");
            }
        }
        println!();
    }
    Ok(())
}

fn strides(table: &StyleTable) -> Result<(), String> {
    println!("steady strides: bands of 22, facts of 24, free moment N m, clearance and lowest point mm,");
    println!(
        "maxima of the vertical force in a stance and its detour %BW, least knee °, friction of both and of one foot, notch %BW"
    );
    println!(
        "height  S/S0 steps/min bands facts  twist clear lowest humps detour  knee  friction    notch  early inward mid, most  toes outside"
    );
    let mut cases = Vec::new();
    for height in HEIGHTS {
        for stretch in STRETCHES {
            for step in 0..13 {
                cases.push((height, stretch, 70.0 + 5.0 * f64::from(step)));
            }
        }
    }
    let lines: Vec<Result<String, String>> = cases
        .par_iter()
        .map(|&(height, stretch, frequency)| {
            let case = Case::new(height, frequency, stretch)?;
            let line = match stride::Found::of(&case, table) {
                Ok(found) => stride_line(&found),
                Err(error) => error,
            };
            Ok(format!("{height:6.2} {stretch:5.2} {frequency:9.0} {line}"))
        })
        .collect();
    for line in lines {
        println!("{}", line?);
    }
    Ok(())
}

fn stride_line(found: &stride::Found) -> String {
    let outside: Vec<String> = check_bands(TEXTBOOK_BANDS, &found.steady)
        .iter()
        .filter(|check| !check.inside)
        .map(|check| format!("{} {:.2}", check.name, check.value))
        .collect();
    format!(
        "{:5} {:5} {:6.1} {:5.1} {:6.1} {:5} {:6.1} {:5.1} {:.3}/{:.3} {:6.2} {:6.3} {:5.1} {:5.1} {:5.1}  {}",
        found.bands,
        found.facts,
        found.free_moment,
        1e3 * found.clearance,
        1e3 * found.lowest,
        found.humps,
        found.detour,
        found.knee,
        found.friction.0,
        found.friction.1,
        found.notch,
        found.early,
        found.inward.0,
        found.inward.1,
        found.toes,
        outside.join(", "),
    )
}

fn walks() -> Result<(), String> {
    println!(
        "\nwalks that ship: friction of both and of one foot and when (u after the closing contact), free moment N m and when, greatest knee"
    );
    println!(
        "after the first contact and in any stance °, least knee °, sink mm, vertical and fore-and-aft force % of the weight"
    );
    println!(
        "steps/min  n  friction       at  twist     at  first stance  least  sink   vertical     along  bands facts  knee at contact"
    );
    let frequencies = [80.0, 95.0, 110.0, 118.0].into_iter().chain(FAST);
    let cases: Vec<(f64, usize)> =
        frequencies.flat_map(|frequency| STEPS.map(|steps| (frequency, steps))).collect();
    let lines: Vec<Result<String, String>> = cases
        .par_iter()
        .map(|&(frequency, steps)| {
            let case = Case::new(1.75, frequency, 1.0)?;
            let line = walk::Found::of(&case, steps).map_or_else(|error| error, |found| walk_line(&found));
            Ok(format!("{frequency:9.0} {steps:2}  {line}"))
        })
        .collect();
    for line in lines {
        println!("{}", line?);
    }
    Ok(())
}

fn walk_line(found: &walk::Found) -> String {
    let steady = found
        .steady
        .map_or_else(String::new, |(bands, facts, knee)| format!("{bands:6} {facts:5} {knee:6.1}"));
    format!(
        "{:.3}/{:.3} {:6.2} {:6.1} {:6.2} {:6.1} {:6.1} {:6.2} {:5.2}  {:3.0} {:3.0}   {:4.0} {:3.0} {steady}",
        found.friction.0,
        found.friction.1,
        found.friction_at,
        found.free_moment,
        found.free_moment_at,
        found.first_knee,
        found.stance_knee,
        found.least_knee,
        found.sink,
        found.vertical.0,
        found.vertical.1,
        found.along.0,
        found.along.1,
    )
}
