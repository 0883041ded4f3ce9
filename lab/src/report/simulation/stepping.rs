//! Beside MuJoCo: the same scenes stepped by both, error against time.
//!
//! MuJoCo is driven from C, so that nobody waits for Python; Python says where it is, and finds the end of each motion in the air by
//! a method that is neither's. Where they are not at hand nothing is measured and nothing is written.

mod bodies;
mod mujoco;
mod ours;
mod page;
mod picture;
mod points;

use super::PAGE;
use crate::table;
use crate::workspace::{read, write};
use bodies::Scene;
use mujoco::MuJoCo;
use points::{Series, distance};

/// Both are timed by turns, so that a slow spell of the machine strikes both; the least time counts.
const ROUNDS: usize = 3;

/// What a scene came to.
struct Measured {
    scene: Scene,
    /// Ours, then MuJoCo's.
    series: Vec<Series>,
    /// Where the answer is none of a closed form: how far our finest runs are from each other, and from the method apart.
    agreement: Option<[f64; 2]>,
}

/// Measures and writes all, where there is a MuJoCo.
pub(super) fn run() -> Result<(), String> {
    let Some(peer) = MuJoCo::find()? else { return Ok(()) };
    let measured =
        bodies::all()?.into_iter().map(|scene| measure(scene, &peer)).collect::<Result<Vec<_>, _>>()?;
    let mut text = read(PAGE)?;
    for (name, table) in page::tables(&measured) {
        text = table::replace(&text, name, &table.markdown()).map_err(|error| format!("{PAGE}: {error}"))?;
    }
    text = table::replace(&text, "beside MuJoCo, when", &page::circumstances(&peer))?;
    write(PAGE, &text)?;
    write("docs/trust/stepping.svg", &picture::draw(&measured))
}

fn measure(scene: Scene, peer: &MuJoCo) -> Result<Measured, String> {
    eprintln!("report: beside MuJoCo, {}", scene.name);
    let model = peer.model(&scene)?;
    let (end, agreement) = if let Some(end) = &scene.answer {
        (end.clone(), None)
    } else {
        let [finest, finer] = ours::finest(&scene)?;
        let apart = peer.reference(&scene, &model)?;
        let agreement = [distance(&finest, &finer), distance(&finest, &apart)].map(|[q, v]| q.max(v));
        (finest, Some(agreement))
    };
    let round = || {
        let mut series = ours::series(&scene, &end);
        series.extend(peer.series(&scene, &model, &end)?);
        Ok::<_, String>(series)
    };
    let mut series = round()?;
    for _ in 1..ROUNDS {
        for (known, again) in series.iter_mut().zip(round()?) {
            known
                .points
                .iter_mut()
                .zip(again.points)
                .for_each(|(known, again)| known.seconds = known.seconds.min(again.seconds));
        }
    }
    for Series { name, points, .. } in &series {
        for point in points {
            eprintln!(
                "  {name}, {}: {:.3e} s, off by {:.1e}, {:.1e}",
                point.setting, point.seconds, point.error[0], point.error[1]
            );
        }
    }
    Ok(Measured { scene, series, agreement })
}
