//! What was measured, as text and as the tables of docs/performance.md.

use super::case::BATCH_NAMES;
use super::figures::Subject;
use super::programs::{FLAGS, Peers};
use crate::report::page::{self, duration};
use crate::table::{Cell, Table};
use std::fmt::Write;

/// Times of one figure's operations, turn by turn.
pub(super) struct Measured {
    name: String,
    what: String,
    dofs: usize,
    /// By engine and operation, each with the times of a state (ns) in every turn.
    times: Vec<(&'static str, String, Vec<f64>)>,
    /// How far peers' forces and accelerations are from ours, of the greatest.
    pub(super) apart: Vec<(&'static str, [f64; 2])>,
}

/// One of our operations beside the quickest peer's.
struct Row {
    operation: String,
    time: f64,
    /// Who is the quickest, its time, and how many times as long it takes: in the middle, at least, at most.
    peer: Option<(&'static str, f64, [f64; 3])>,
}

/// The operations by what they are called on the page.
const CALLED: [(&str, &str); 10] = [
    ("rnea", "inverse dynamics"),
    ("aba", "forward dynamics"),
    ("crba", "mass matrix"),
    ("minverse", "inverse mass matrix"),
    ("rnea_derivatives", "derivatives of inverse dynamics"),
    ("aba_derivatives", "derivatives of forward dynamics"),
    ("jacobian", "Jacobian of a frame"),
    ("jacobian_rate", "its rate"),
    ("centroidal_map", "centroidal momentum matrix"),
    ("regressor", "torque regressor"),
];

impl Measured {
    pub(super) fn new(subject: &Subject) -> Self {
        let Subject { name, what, figure, .. } = subject;
        let dofs = figure.layout().nv();
        Self { name: name.clone(), what: what.clone(), dofs, times: Vec::new(), apart: Vec::new() }
    }

    /// The times of an engine's turn. Where an operation is done in two ways, the quicker one counts.
    pub(super) fn take(&mut self, engine: &'static str, turn: impl IntoIterator<Item = (String, f64)>) {
        let mut best: Vec<(String, f64)> = Vec::new();
        for (operation, time) in turn {
            match best.iter_mut().find(|(known, _)| *known == operation) {
                Some((_, known)) => *known = known.min(time),
                None => best.push((operation, time)),
            }
        }
        for (operation, time) in best {
            let known = self.times.iter_mut().find(|(by, known, _)| *by == engine && *known == operation);
            match known {
                Some((.., times)) => times.push(time),
                None => self.times.push((engine, operation, vec![time])),
            }
        }
    }

    fn ours(&self, operation: &str) -> Option<&[f64]> {
        let found = self.times.iter().find(|(by, known, _)| *by == "ours" && known == operation);
        found.map(|(.., times)| &times[..])
    }

    fn row(&self, operation: &str) -> Option<Row> {
        let ours = self.ours(operation)?;
        // Peers do a batch one state after the other, in one precision.
        let of_peers = operation.split(' ').next().unwrap_or(operation).trim_end_matches("_f32");
        let others = self.times.iter().filter(|(by, known, _)| *by != "ours" && known == of_peers);
        let quickest = others.min_by(|a, b| middle(&a.2).total_cmp(&middle(&b.2)));
        let peer = quickest.map(|(by, _, times)| {
            let ratios: Vec<f64> = times.iter().zip(ours).map(|(theirs, ours)| theirs / ours).collect();
            let least = ratios.iter().copied().fold(f64::INFINITY, f64::min);
            let most = ratios.iter().copied().fold(0.0, f64::max);
            (*by, middle(times), [middle(&ratios), least, most])
        });
        Some(Row { operation: operation.to_owned(), time: middle(ours), peer })
    }

    /// Everything, for a terminal.
    pub(super) fn text(&self) -> String {
        let mut out = format!("{} ({}, {} dofs), time of a state", self.name, self.what, self.dofs);
        let ours = self.times.iter().filter(|(by, ..)| *by == "ours");
        for row in ours.filter_map(|(_, operation, _)| self.row(operation)) {
            // Writing into a string does not fail.
            let _ = write!(out, "\n  {:<32} {:>10}", called(&row.operation), duration(row.time));
            if let Some((by, time, [ratio, least, most])) = row.peer {
                let _ = write!(
                    out,
                    "   {ratio:5.2} × ({least:.2} to {most:.2}) as fast as {by}: {}",
                    duration(time)
                );
            }
        }
        for (by, [forces, accelerations]) in &self.apart {
            let _ = write!(
                out,
                "\n  {by} is {forces:.0e} (forces) and {accelerations:.0e} (accelerations) of the greatest away"
            );
        }
        out
    }
}

/// The tables of the page, by the names of their marks.
pub(super) fn tables(all: &[Measured]) -> Vec<(&'static str, Table)> {
    let person = &all[0];
    let others: Vec<&Measured> = all[1..].iter().collect();
    vec![
        ("beside peers", beside(person)),
        ("other figures", ratios(&others)),
        ("batches", batches(all)),
        ("growth", growth(all)),
        ("agreement", agreement(all)),
    ]
}

/// Each operation of a figure beside the quickest peer's.
fn beside(measured: &Measured) -> Table {
    let row = |(operation, called): &(&str, &str)| {
        let row = measured.row(operation)?;
        let (by, time, [ratio, least, most]) = row.peer?;
        Some(vec![
            Cell::text(*called),
            Cell::Time(format!("{by} {}", duration(time))),
            Cell::Time(duration(row.time)),
            Cell::Time(format!("**{ratio:.2}**")),
            Cell::Time(format!("{least:.2} to {most:.2}")),
        ])
    };
    Table {
        header: vec!["one state", "quickest peer, for this processor", "ours", "times as fast", "in 7 turns"],
        rows: CALLED.iter().filter_map(row).collect(),
    }
}

/// How many times as fast as the quickest peer, figure by figure.
fn ratios(figures: &[&Measured]) -> Table {
    let operations: Vec<&(&str, &str)> =
        CALLED.iter().filter(|(name, _)| figures.iter().any(|figure| peer(figure, name).is_some())).collect();
    let cell = |figure: &Measured, name: &str| {
        let ratio = peer(figure, name).map(|(_, _, [ratio, ..])| format!("{ratio:.2}"));
        Cell::Time(ratio.unwrap_or_else(|| "–".to_owned()))
    };
    let row = |(name, called): &(&str, &str)| {
        let cells = figures.iter().map(|figure| cell(figure, name));
        std::iter::once(Cell::text(*called)).chain(cells).collect()
    };
    let names = figures.iter().map(|figure| &*figure.name.clone().leak());
    Table {
        header: std::iter::once("times as fast").chain(names).collect(),
        rows: operations.into_iter().map(row).collect(),
    }
}

fn peer(figure: &Measured, operation: &str) -> Option<(&'static str, f64, [f64; 3])> {
    figure.row(operation)?.peer
}

/// Batches of every figure by instructions: the time of a state, and how many times as fast as the quickest peer.
fn batches(all: &[Measured]) -> Table {
    let mut rows = Vec::new();
    let figures =
        all.iter().filter(|figure| peer(figure, BATCH_NAMES[0]).is_some() || figure.ours("rnea").is_some());
    for figure in figures {
        for name in BATCH_NAMES {
            let single = name.ends_with("_f32");
            let alone = if name.starts_with("rnea") { "rnea" } else { "aba" };
            let what = CALLED.iter().find(|(known, _)| *known == alone).map_or("", |(_, called)| called);
            let mut cells = vec![
                Cell::text(&figure.name),
                Cell::text(format!("{what}{}", if single { ", f32" } else { "" })),
            ];
            for instructions in ["Baseline", "Avx2", "Avx512"] {
                let row = figure.row(&format!("{name} {instructions}"));
                let cell = row.map_or("–".to_owned(), |row| {
                    let ratio =
                        row.peer.map_or(String::new(), |(_, _, [ratio, ..])| format!(", **{ratio:.1}**"));
                    format!("{}{ratio}", duration(row.time))
                });
                cells.push(Cell::Time(cell));
            }
            rows.push(cells);
        }
    }
    let header = vec!["figure", "batch", "plain x86-64 (SSE2)", "AVX2 and FMA", "AVX-512"];
    Table { header, rows }
}

/// The exponents of the recursions' times along the chains.
fn growth(all: &[Measured]) -> Table {
    let chains: Vec<&Measured> = all.iter().filter(|figure| figure.name.starts_with("chain")).collect();
    let steps: Vec<[&Measured; 2]> = chains.windows(2).map(|two| [two[0], two[1]]).collect();
    let row = |name: &&str| {
        let called = CALLED.iter().find(|(known, _)| known == name).map_or("", |(_, called)| called);
        let cell = |[short, long]: &[&Measured; 2]| {
            let exponent = short.ours(name).zip(long.ours(name)).map(|(short_times, long_times)| {
                (middle(long_times) / middle(short_times)).ln() / (long.dofs as f64 / short.dofs as f64).ln()
            });
            Cell::Time(exponent.map_or_else(|| "–".to_owned(), |exponent| format!("{exponent:.2}")))
        };
        std::iter::once(Cell::text(called)).chain(steps.iter().map(cell)).collect()
    };
    let headers =
        steps.iter().map(|[short, long]| &*format!("{} to {} hinges", short.dofs, long.dofs).leak());
    Table {
        header: std::iter::once("exponent of the time").chain(headers).collect(),
        rows: ["rnea", "aba", "crba", "minverse", "rnea_derivatives"].iter().map(row).collect(),
    }
}

/// How far peers are from ours.
fn agreement(all: &[Measured]) -> Table {
    let row = |figure: &Measured, (by, [forces, accelerations]): &(&'static str, [f64; 2])| {
        vec![
            Cell::text(&figure.name),
            Cell::text(*by),
            Cell::Numbers(vec![*forces]),
            Cell::Numbers(vec![*accelerations]),
        ]
    };
    Table {
        header: vec!["figure", "peer", "forces, of the greatest", "accelerations, of the greatest"],
        rows: all
            .iter()
            .flat_map(|figure| figure.apart.iter().map(move |apart| row(figure, apart)))
            .collect(),
    }
}

/// When, on what, and with which peers.
pub(super) fn circumstances(peers: &Peers) -> String {
    let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let cpu = cpu.lines().find_map(|line| line.strip_prefix("model name")?.split(": ").nth(1));
    format!(
        "{} The processor: {}; instructions of batches are chosen at run time. Peers: {}; `{}`, dynibo with `-Ctarget-cpu=native` and \
         link-time optimisation.",
        page::circumstances(),
        cpu.unwrap_or("unknown").trim(),
        peers.versions,
        FLAGS.join(" "),
    )
}

fn called(operation: &str) -> String {
    let (name, rest) = operation.split_once(' ').unwrap_or((operation, ""));
    let (name, single) = name.strip_suffix("_f32").map_or((name, ""), |name| (name, " f32"));
    let (name, batch) = name.strip_suffix("_batch").map_or((name, ""), |name| (name, ", batch"));
    let called = CALLED.iter().find(|(known, _)| *known == name).map_or(name, |(_, called)| called);
    format!("{called}{batch}{single} {rest}").trim_end().to_owned()
}

fn middle(times: &[f64]) -> f64 {
    let mut sorted = times.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}
