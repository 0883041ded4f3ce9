//! `solaris check`: what a figure or a scene is, and what looks wrong with it.

mod markers;
mod scene;

pub(crate) use scene::is_one as is_scene;

use crate::args::CheckArgs;
use crate::error::CliError;
use crate::findings::{heading, list, of_medium};
use crate::input::{self, Body};
use crate::print::{print, write_json};
use crate::words::rounded;
use serde::Serialize;
use solaris::dynamics::denavit_hartenberg::Summary;
use solaris::model::{Chains, Figure, Finding, FindingKind, Vector3};
use std::io::Write;

/// The most links of a figure whose chains are listed: they may repeat each other as often as there are links.
const MOST_LINKS: usize = 5000;

pub(crate) fn run(args: &CheckArgs) -> Result<(), CliError> {
    if crate::recording::is_one(&args.file) {
        return markers::run(args);
    }
    if scene::is_one(&args.file) {
        return scene::run(args);
    }
    let Body { figure, language, mut findings, gravity, gravity_is_given, medium, .. } =
        input::body_in(&args.file, args.files.as_deref())?;
    // A skeleton is measured, so its sides differ, and its masses are ours.
    if !language.is_of_bones() {
        findings.extend(figure.lint());
    }
    findings.extend(of_medium(&medium, FindingKind::Note));
    let wrong = |finding: &&Finding| matches!(finding.kind, FindingKind::Missing | FindingKind::Suspect);
    let suspects = findings.iter().filter(wrong).count();
    // With the rationalised links or without, the chains come first.
    let chains = if figure.links().len() > MOST_LINKS {
        format!("The table of chains is left out: there are more than {MOST_LINKS} links.\n")
    } else if args.dh {
        let summary = Summary::of(&figure).map_err(CliError::other)?;
        format!("{summary}")
    } else {
        Chains::of(&figure).to_string()
    };
    let facts = Facts::of(&figure, language.name(), gravity.into(), gravity_is_given, &findings);
    print(|out| {
        if args.json {
            return write_json(out, &facts);
        }
        facts.write(out)?;
        writeln!(out, "\n{}", chains.trim_end())?;
        list(out, &findings)
    })?;
    if args.strict && suspects > 0 {
        return Err(CliError::Strict { path: args.file.clone(), count: suspects });
    }
    Ok(())
}

/// What a figure is, in numbers.
#[derive(Serialize)]
struct Facts<'a> {
    name: &'a str,
    format: &'static str,
    links: usize,
    dofs: usize,
    positions: usize,
    followers: Vec<&'a str>,
    mass_kg: f64,
    stature_m: Option<f64>,
    extent_m: f64,
    gravity_m_s2: [f64; 3],
    gravity_is_given: bool,
    chains: usize,
    findings: Vec<Said<'a>>,
}

#[derive(Serialize)]
struct Said<'a> {
    kind: &'static str,
    subject: &'a str,
    message: &'a str,
    line: Option<usize>,
    column: Option<usize>,
}

impl<'a> Facts<'a> {
    fn of(
        figure: &'a Figure,
        format: &'static str,
        gravity: [f64; 3],
        gravity_is_given: bool,
        findings: &'a [Finding],
    ) -> Self {
        let layout = figure.layout();
        let said = |finding: &'a Finding| Said {
            kind: heading(finding.kind).0,
            subject: &finding.subject,
            message: &finding.message,
            line: finding.place.as_ref().map(|place| place.line),
            column: finding.place.as_ref().map(|place| place.column),
        };
        Self {
            name: figure.name(),
            format,
            links: figure.links().len(),
            dofs: layout.nv(),
            positions: layout.nq(),
            followers: figure.followers().iter().map(|f| layout.v_names()[f.dof].as_str()).collect(),
            mass_kg: figure.mass(),
            stature_m: figure.stature(),
            extent_m: figure.extent(&-Vector3::from(gravity)).height,
            gravity_m_s2: gravity,
            gravity_is_given,
            chains: Chains::count(figure),
            findings: findings.iter().map(said).collect(),
        }
    }

    fn write(&self, out: &mut dyn Write) -> std::io::Result<()> {
        writeln!(out, "{} '{}'\n", self.format, self.name)?;
        let mut row = |what: &str, value: String| writeln!(out, "  {what:<24}{value}");
        row("links", self.links.to_string())?;
        let extra = if self.positions == self.dofs {
            String::new()
        } else {
            format!(" ({} positions)", self.positions)
        };
        row("degrees of freedom", format!("{}{extra}", self.dofs))?;
        if !self.followers.is_empty() {
            row(
                "of which follow others",
                format!("{} ({})", self.followers.len(), self.followers.join(", ")),
            )?;
        }
        row("mass", format!("{} kg", rounded(self.mass_kg)))?;
        if let Some(stature) = self.stature_m {
            row("standing height", format!("{} m", rounded(stature)))?;
        }
        row(
            "reaches",
            format!(
                "{:.3} m, from its lowest to its highest point with all coordinates at zero",
                self.extent_m
            ),
        )?;
        let [x, y, z] = self.gravity_m_s2;
        let whose = if self.gravity_is_given { "the file's" } else { "standard, down in this format" };
        row("gravity", format!("({x}, {y}, {z}) m/s², {whose}"))?;
        row("chains", self.chains.to_string())
    }
}
