//! What `check` finds of a file, without its names, its numbers and its texts.

use super::veil::Veil;
use crate::error::CliError;
use crate::findings::heading;
use crate::input::{self, Body, extension};
use crate::run::{LoadedScene, load};
use crate::words::counted;
use crate::{check, recording};
use serde::Serialize;
use solaris::model::{Chains, Figure, Finding, TextError};
use std::collections::BTreeMap;
use std::io::Write;
use std::path::Path;

/// Extensions that may be told; another one may be somebody's own.
const EXTENSIONS: [&str; 16] = [
    "bvh", "c3d", "csv", "glb", "gltf", "mjcf", "mot", "osim", "ron", "sdf", "sto", "trc", "urdf", "usda",
    "world", "xml",
];

/// A file, as it may be told.
#[derive(Debug, Serialize)]
pub(super) struct Told {
    extension: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    kilobytes: Option<u64>,
    /// What it is; nothing where it cannot be used.
    #[serde(skip_serializing_if = "Option::is_none")]
    what: Option<&'static str>,
    counts: Vec<(&'static str, usize)>,
    /// By kind and message: how often, and in which lines at first.
    found: Vec<Found>,
}

#[derive(Debug, Serialize)]
struct Found {
    kind: &'static str,
    message: String,
    times: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<usize>,
}

impl Told {
    pub(super) fn of(path: &Path) -> Self {
        let extension = extension(path);
        let known = EXTENSIONS.contains(&extension.as_str());
        let mut told = Self {
            extension: if known { format!(".{extension}") } else { "none of ours".to_owned() },
            kilobytes: std::fs::metadata(path).ok().map(|found| found.len().div_ceil(1000)),
            what: None,
            counts: Vec::new(),
            found: Vec::new(),
        };
        let mut veil = Veil::default();
        veil.names([path.to_string_lossy().as_ref()]);
        // Of another extension nothing is read, by `look` neither.
        if let Some(bytes) = input::bytes(path).ok().filter(|_| known) {
            let is_table = ["csv", "mot", "sto", "trc", "c3d", "bvh"].contains(&extension.as_str());
            veil.text(&String::from_utf8_lossy(&bytes), is_table);
        }
        if let Err(error) = told.look(path, &mut veil) {
            told.refuse(&error, &veil);
        }
        told
    }

    fn look(&mut self, path: &Path, veil: &mut Veil) -> Result<(), CliError> {
        if recording::is_one(path) {
            let recording = recording::read(path, None)?;
            veil.names(recording.markers.names().iter().map(String::as_str));
            self.what = Some("a recording of markers");
            self.counts = vec![
                ("markers", recording.markers.names().len()),
                ("frames", recording.markers.len()),
                ("plates", recording.plates.len()),
            ];
            self.find(&recording.findings, veil);
        } else if check::is_scene(path) {
            let LoadedScene { scene, reads } = load(path)?;
            veil.names([scene.name()]);
            self.what = Some("a scene");
            self.figure(scene.figure(), veil);
            self.counts.push(("files beside it", reads.len().saturating_sub(1)));
            self.find(&scene.figure().lint(), veil);
            scene.check().map_err(|error| crate::run::refuse(path, &error, scene.notes()))?;
        } else {
            let Body { figure, language, mut findings, .. } = input::body_in(path, None)?;
            self.what = Some(language.name());
            self.figure(&figure, veil);
            if !language.is_of_bones() {
                findings.extend(figure.lint());
            }
            self.find(&findings, veil);
        }
        Ok(())
    }

    fn figure(&mut self, figure: &Figure, veil: &mut Veil) {
        let layout = figure.layout();
        veil.names([figure.name()]);
        veil.names(figure.links().iter().flat_map(|link| [link.name(), link.joint().name()]));
        veil.names(layout.v_names().iter().chain(layout.q_names()).map(String::as_str));
        self.counts = vec![
            ("links", figure.links().len()),
            ("degrees of freedom", layout.nv()),
            ("positions", layout.nq()),
            ("followers", figure.followers().len()),
            ("chains", Chains::count(figure)),
        ];
    }

    /// Findings, those that say the same together.
    fn find(&mut self, findings: &[Finding], veil: &Veil) {
        let lines = findings.iter().map(|finding| {
            let line = finding.place.as_ref().map(|place| place.line);
            (heading(finding.kind).0, veil.over(&format!("{}: {}", finding.subject, finding.message)), line)
        });
        self.gather(lines);
    }

    /// What an error says, fault by fault.
    fn refuse(&mut self, error: &CliError, veil: &Veil) {
        let faults = |faults: &TextError| {
            let place = |fault: &solaris::model::TextFault| (fault.message.clone(), Some(fault.place.line));
            faults.faults.iter().map(place).collect::<Vec<_>>()
        };
        let said = match error {
            CliError::Text { faults: of, .. } => faults(of),
            CliError::Files { error, .. } => {
                error.files.iter().flat_map(|file| faults(&file.error)).collect()
            }
            CliError::Input { why, .. } => vec![(why.clone(), None)],
            other => vec![(other.to_string(), None)],
        };
        self.gather(said.into_iter().map(|(message, line)| ("refused", veil.over(&message), line)));
    }

    fn gather(&mut self, lines: impl Iterator<Item = (&'static str, String, Option<usize>)>) {
        let mut groups: BTreeMap<(&'static str, String), (usize, Option<usize>)> = BTreeMap::new();
        for (kind, message, line) in lines {
            groups.entry((kind, message)).or_insert((0, line)).0 += 1;
        }
        let found = groups.into_iter();
        self.found.extend(found.map(|((kind, message), (times, line))| Found { kind, message, times, line }));
    }

    pub(super) fn write(&self, out: &mut dyn Write, number: usize) -> std::io::Result<()> {
        let size = self.kilobytes.map_or_else(String::new, |size| format!(", {size} kB"));
        let what = self.what.unwrap_or("it cannot be used");
        writeln!(out, "\nFile {number} ({}{size}): {what}\n", self.extension)?;
        for (name, count) in &self.counts {
            writeln!(out, "  {name:<24}{count}")?;
        }
        for Found { kind, message, times, line } in &self.found {
            let line = line.map_or_else(String::new, |line| format!(", first in line {line}"));
            let times = counted(*times, "time", "times");
            writeln!(out, "  {kind}, {times}{line}: {message}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A robot whose every name, text and number can be told from all others, with what is read, doubted, passed over and refused.
    fn robot(mass: &str, parent: &str) -> String {
        format!(
            r#"<robot name="zyzz"><!-- a zyzz of zyzz -->
              <link name="zyzz_base"><inertial><mass value="{mass}"/><inertia ixx="7.7e7" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
              <link name="zyzz arm"><zyzz_extension zyzz="7777"/></link>
              <joint name="mass" type="revolute"><parent link="{parent}"/><child link="zyzz arm"/><axis xyz="0 0 1"/>
                <limit lower="7.77" upper="7.7777" effort="7777" velocity="777"/></joint>
            </robot>"#
        )
    }

    fn told(text: &str) -> String {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("zyzz.urdf");
        std::fs::write(&path, text).expect("written");
        let mut out = Vec::new();
        Told::of(&path).write(&mut out, 1).expect("into memory");
        String::from_utf8(out).expect("text")
    }

    #[test]
    fn nothing_of_a_file_is_told_but_what_is_found() {
        let said = told(&robot("7777.7", "zyzz_base"));
        assert!(said.contains("suspect") && said.contains("unsupported"), "{said}");
        assert!(!said.contains("zyzz") && !said.contains("77"), "{said}");
        // A name that is one of our words, too.
        assert!(!said.contains("mass:"), "{said}");
    }

    #[test]
    fn nothing_of_a_file_is_told_by_its_refusal() {
        for (mass, parent) in [
            ("7777,zyzz", "zyzz_base"),
            ("7777", "zyzz_bass"),
            ("7777\"zyzz=\"", "zyzz_base"),
            ("<zyzz>", "x"),
        ] {
            let said = told(&robot(mass, parent));
            assert!(said.contains("refused"), "{said}");
            assert!(!said.contains("zyzz") && !said.contains("77"), "{said}");
        }
    }
}
