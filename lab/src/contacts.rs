//! Contact beside MuJoCo and Drake: the same scenes by every model of contact, error against time. Writes docs/contact.md and its picture.
//!
//! Both are driven from Python, whose loop is not part of a time: they step many times in one call. Where one is not at hand its rows
//! stay as they were, which is said, and ours are measured all the same.

mod dropped;
mod ours;
mod page;
mod peers;
mod picture;
mod scenes;

use crate::report::page as report;
use crate::table::replace;
use crate::workspace::{read, write};
use peers::Peer;
use scenes::{Scene, Told};

const PAGE: &str = "docs/contact.md";
const PICTURE: &str = "docs/trust/contact.svg";

/// Lengths of steps (s), the longest first.
const STEPS: [f64; 7] = [1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4];
/// A step is left out where the one before took longer than this (s).
const MOST: f64 = 8.0;
/// Frames of a run, after the first.
const FRAMES: usize = 50;

/// A model of contact: whose it is, what it is called, and by which setting of its engine.
pub(super) struct Model {
    pub(super) name: &'static str,
    engine: Engine,
}

#[derive(Clone, Copy, PartialEq)]
enum Engine {
    Ours { by_springs: bool },
    MuJoCo(&'static str),
    Drake(&'static str),
}

const MODELS: [Model; 6] = [
    Model { name: "ours, impulses", engine: Engine::Ours { by_springs: false } },
    Model { name: "ours, springs", engine: Engine::Ours { by_springs: true } },
    Model { name: "MuJoCo, as shipped", engine: Engine::MuJoCo("shipped") },
    Model { name: "MuJoCo, hard", engine: Engine::MuJoCo("hard") },
    Model { name: "Drake, as shipped", engine: Engine::Drake("lagged") },
    Model { name: "Drake, SAP", engine: Engine::Drake("sap") },
];

impl Model {
    fn is_ours(&self) -> bool {
        matches!(self.engine, Engine::Ours { .. })
    }
}

/// A model in a scene, step by step.
struct Series {
    scene: &'static str,
    model: usize,
    points: Vec<Point>,
}

/// What a step came to, or why nothing.
struct Point {
    step: f64,
    /// Time of the run (s), error, and energy that came from nowhere (J).
    found: Result<[f64; 3], String>,
    /// How many steps the run has.
    count: f64,
}

/// The engines that are at hand.
struct Peers {
    mujoco: Option<Peer>,
    drake: Option<Peer>,
}

impl Peers {
    fn find() -> Result<Self, String> {
        Ok(Self { mujoco: Peer::find("mujoco")?, drake: Peer::find("drake")? })
    }

    /// Nothing where the engine is not at hand.
    fn of(&mut self, engine: Engine) -> Option<(&mut Peer, &'static str)> {
        match engine {
            Engine::Ours { .. } => None,
            Engine::MuJoCo(setting) => self.mujoco.as_mut().map(|peer| (peer, setting)),
            Engine::Drake(setting) => self.drake.as_mut().map(|peer| (peer, setting)),
        }
    }

    fn versions(&self) -> Vec<String> {
        [&self.mujoco, &self.drake].into_iter().flatten().map(|peer| peer.version.clone()).collect()
    }
}

/// How many people are dropped.
#[derive(Clone, Copy)]
pub(crate) struct Options {
    poses: u64,
}

impl Options {
    pub(crate) fn parse(options: &[&str]) -> Result<Self, String> {
        match options {
            [] => Ok(Self { poses: 50 }),
            ["--poses", count] => {
                let poses =
                    count.parse().map_err(|_| format!("contacts: --poses takes a number, not '{count}'"))?;
                Ok(Self { poses })
            }
            _ => Err(format!("contacts: no such options: {} (--poses N)", options.join(" "))),
        }
    }
}

/// Measures and writes all; the table of people only where some are dropped.
pub(crate) fn run(options: Options) -> Result<(), String> {
    let mut peers = Peers::find()?;
    let mut series = Vec::new();
    for scene in scenes::all()? {
        for (model, of) in MODELS.iter().enumerate() {
            eprintln!("contacts: {}, {}", scene.name, of.name);
            series.extend(measured(&scene, model, &mut peers));
        }
    }
    let dropped = dropped::measured(options.poses, &mut peers)?;
    let mut text = read(PAGE)?;
    let versions = peers.versions();
    text = replace(&text, "contacts, when", &report::circumstances())?;
    if !versions.is_empty() {
        let when = format!("{} {}, from Python.", report::circumstances(), versions.join(", "));
        text = replace(&text, "contacts, others, when", &when)?;
    }
    text = replace(&text, "contacts", &page::kept(&text, "contacts", &page::table(&series))?)?;
    if options.poses > 0 {
        text = replace(&text, "dropped", &page::kept(&text, "dropped", &dropped::table(&dropped))?)?;
    }
    write(PAGE, &text)?;
    if versions.len() < 2 {
        eprintln!("contacts: the picture stays as it is, for not all engines are at hand");
        return Ok(());
    }
    write(PICTURE, &picture::draw(&series))
}

/// A model in a scene; nothing where its engine is not at hand.
fn measured(scene: &Scene, model: usize, peers: &mut Peers) -> Option<Series> {
    let engine = MODELS[model].engine;
    let knows = match engine {
        Engine::Ours { by_springs: true } => scene.springs.is_some(),
        // The spring that it bounces on is as hard as it is told to be.
        Engine::MuJoCo("hard") => scene.elastic <= 0.0,
        _ => true,
    };
    if !knows {
        return None;
    }
    let mut points: Vec<Point> = Vec::new();
    for step in STEPS {
        if points.last().and_then(|point| point.found.as_ref().ok()).is_some_and(|found| found[0] > MOST) {
            break;
        }
        let told = if let Engine::Ours { by_springs } = engine {
            ours::told(scene, by_springs, step, FRAMES)
        } else {
            let (peer, setting) = peers.of(engine)?;
            peer.told(scene, setting, step, FRAMES)
        };
        let found = told.map(|told: Told| [told.seconds, (scene.error)(&told), told.gained()]);
        match &found {
            Ok([seconds, error, gained]) => {
                eprintln!("  {step:.0e} s: off by {error:.1e}, {gained:.1e} J, {seconds:.2e} s");
            }
            Err(why) => eprintln!("  {step:.0e} s: {why}"),
        }
        points.push(Point { step, found, count: scene.duration / step });
    }
    Some(Series { scene: scene.name, model, points })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::block;

    /// Rows of ours alone: other engines are not at hand where tests run.
    #[test]
    #[ignore = "all of ours, a minute: cargo xtask nightly"]
    fn the_page_says_what_ours_come_to() {
        let mut none = Peers { mujoco: None, drake: None };
        let mut series = Vec::new();
        for scene in scenes::all().expect("valid") {
            for model in 0..MODELS.len() {
                series.extend(measured(&scene, model, &mut none));
            }
        }
        let page = read(PAGE).expect("the page");
        let ours = |line: &&str| !MODELS.iter().any(|model| !model.is_ours() && line.contains(model.name));
        let block = block(&page, "contacts").expect("a table");
        let rows: Vec<&str> = block.lines().filter(ours).collect();
        let differences = page::table(&series).differences(&rows.join("\n"));
        assert!(differences.is_empty(), "{PAGE}: `cargo lab contacts` is due:\n{}", differences.join("\n"));
    }
}
