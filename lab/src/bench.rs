//! Speed: how long the kernel's operations take, by themselves and beside other engines on the same figures and states.
//!
//! All programs take turns, so that a slow spell of the machine strikes all of them; ratios are formed within a turn, and their middle
//! counts.

mod case;
mod figures;
mod page;
mod programs;
mod text;

pub(crate) use case::Case;

use crate::table;
use crate::workspace::{read, write};
use figures::{GRAVITY, Subject};
use page::Measured;
use programs::Peers;

const PAGE: &str = "docs/performance.md";
/// How often every program has its turn; the rounds within a turn, and the length of a block of calls (ms).
const TURNS: usize = 7;
const ROUNDS: usize = 5;
const BLOCK: f64 = 4.0;

/// What `cargo lab bench` was asked.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Options {
    /// Beside other engines, and into the page.
    peers: bool,
    /// These figures alone.
    figures: Vec<String>,
}

impl Options {
    pub(crate) fn parse(args: &[&str]) -> Result<Self, String> {
        let mut options = Self::default();
        for arg in args {
            match *arg {
                "--peers" => options.peers = true,
                unknown if unknown.starts_with('-') => {
                    return Err(format!(
                        "bench: unknown option '{unknown}'; there is --peers, and names of figures"
                    ));
                }
                name => options.figures.push(name.to_owned()),
            }
        }
        Ok(options)
    }
}

/// Measures, prints, and writes the page where peers stand beside all figures.
pub(crate) fn run(options: &Options) -> Result<(), String> {
    let peers = options.peers.then(Peers::prepare).transpose()?;
    let mut subjects = figures::own()?;
    if let Some(peers) = &peers {
        subjects.splice(1..1, figures::robots(&peers.packages)?);
    }
    let names: Vec<_> = subjects.iter().map(|subject| subject.name.clone()).collect();
    if let Some(unknown) = options.figures.iter().find(|name| !names.contains(name)) {
        return Err(format!("bench: there is no figure '{unknown}'; there are {}", names.join(", ")));
    }
    let is_asked = |name: &String| options.figures.is_empty() || options.figures.contains(name);
    let mut all = Vec::new();
    for subject in subjects.into_iter().filter(|subject| is_asked(&subject.name)) {
        eprintln!("bench: {}, {}", subject.name, subject.what);
        let measured = measure(&subject, peers.as_ref())?;
        println!("{}\n", measured.text());
        all.push(measured);
    }
    let Some(peers) = peers.filter(|_| options.figures.is_empty()) else { return Ok(()) };
    let mut text = read(PAGE)?;
    for (name, table) in page::tables(&all) {
        text = table::replace(&text, name, &table.markdown()).map_err(|error| format!("{PAGE}: {error}"))?;
    }
    text = table::replace(&text, "circumstances", &page::circumstances(&peers))?;
    write(PAGE, &text)
}

fn measure(subject: &Subject, peers: Option<&Peers>) -> Result<Measured, String> {
    if let Some(peers) = peers {
        peers.write(subject)?;
    }
    let mut case =
        Case::new(&subject.figure, GRAVITY, subject.states.clone()).map_err(|error| error.to_string())?;
    let mut measured = Measured::new(subject);
    for _ in 0..TURNS {
        let turn = case.time(BLOCK, ROUNDS)?.into_iter().map(|(name, time)| (name, time.median));
        measured.take("ours", turn);
        for (peers, program) in
            peers.iter().flat_map(|peers| peers.programs.iter().map(move |one| (peers, one)))
        {
            measured.take(program.name, peers.time(program, subject, BLOCK, ROUNDS)?);
        }
    }
    if let Some(peers) = peers {
        let ours = results(&mut case)?;
        for program in &peers.programs {
            if let Some(apart) = peers.disagreement(program, subject, &ours)? {
                measured.apart.push((program.name, apart));
            }
        }
    }
    Ok(measured)
}

/// Forces and accelerations of all states.
fn results(case: &mut Case) -> Result<[Vec<f64>; 2], String> {
    let mut results = [const { Vec::new() }; 2];
    for state in 0..case.states.count {
        case.rnea(state)?;
        case.aba(state)?;
        results[0].extend_from_slice(&case.tau);
        results[1].extend_from_slice(&case.a);
    }
    Ok(results)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::peers::model;
    use crate::peers::states::States;

    #[test]
    fn options_are_read() {
        let options = Options::parse(&["--peers", "human66"]).expect("well-formed");
        assert_eq!(options, Options { peers: true, figures: vec!["human66".to_owned()] });
        let mistake = Options::parse(&["--fast"]).expect_err("a mistake");
        assert_eq!(mistake, "bench: unknown option '--fast'; there is --peers, and names of figures");
        let unknown = Options { peers: false, figures: vec!["dog".to_owned()] };
        assert!(
            run(&unknown).expect_err("a mistake").contains("no figure 'dog'; there are human66, chain10")
        );
    }

    /// What peers read is the figure: its text, read again, takes the same forces.
    #[test]
    fn a_figure_is_what_its_text_says() {
        for Subject { name, figure, .. } in figures::own().expect("figures") {
            if figure.layout().nv() > 100 {
                continue;
            }
            for composite in [false, true] {
                let read = model::parse(&text::flat(&name, &figure, composite)).expect("a model");
                let forces = |figure| {
                    let mut case = Case::new(figure, GRAVITY, States::random(figure, 3)).expect("a case");
                    results(&mut case).expect("states")
                };
                let [expected, found] = [&figure, &read.figure].map(forces);
                for (expected, found) in expected.iter().zip(&found) {
                    let scale = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
                    assert!(expected.iter().zip(found).all(|(x, y)| (x - y).abs() < 1e-9 * scale), "{name}");
                }
                let urdf = solaris_io::urdf::read(&text::urdf(&name, &figure)).expect("a robot");
                assert!((urdf.figure.mass() - figure.mass()).abs() < 1e-9);
                assert_eq!(urdf.figure.layout().nv(), figure.layout().nv());
            }
        }
    }
}
