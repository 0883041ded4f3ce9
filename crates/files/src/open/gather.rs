//! Files one after the other: what others stand on comes first.

use super::kind::Kind;
use super::{Alone, FileRole, Held, OpenOptions, Opened, OpenedMotion, page};
use crate::error::FileError;
use crate::external::{External, ExternalError, link_plates};
use crate::figure::{Body, Language};
use crate::files::Source;
use crate::fit::fit_markers;
use crate::given::Given;
use crate::plates::table_plates;
use crate::recording::turned;
use solaris_io::clip::Clip;
use solaris_io::markers::{Recording, cloud};
use solaris_io::{Table, record};
use solaris_model::{Finding, FindingKind};
use solaris_profiles::text as profiles;
use std::path::{Path, PathBuf};

/// So many markers must be the figure's, so that they are taken to be of it.
const COMMON: usize = 3;

/// What a file was taken for, in words, and whether it is of use; nothing as long as nobody knows.
type Fate = Option<(String, bool)>;

/// Files, and what they have come to by now.
pub(super) struct Gathering<'f> {
    files: &'f Given,
    options: OpenOptions,
    /// Every file, what it is, and what became of it.
    kinds: Vec<(String, Kind, Fate)>,
    opened: Opened,
}

impl<'f> Gathering<'f> {
    pub(super) fn new(files: &'f Given, options: OpenOptions) -> Self {
        let source = Source::new(files);
        let kinds = files.names().map(|name| (name.to_owned(), Kind::of(source, name), None)).collect();
        Self { files, options, kinds, opened: Opened::default() }
    }

    pub(super) fn opened(mut self) -> Opened {
        self.scenes();
        self.figures();
        self.clips();
        self.tables();
        self.recordings();
        self.loads();
        self.soles();
        self.texts();
        self.finish()
    }

    fn source(&self) -> Source<'f> {
        Source::new(self.files)
    }

    /// The files of a kind that nobody has taken yet.
    fn of(&self, kind: Kind) -> Vec<String> {
        let free = self.kinds.iter().filter(|(_, own, role)| *own == kind && role.is_none());
        free.map(|(name, ..)| name.clone()).collect()
    }

    /// Says what became of a file.
    fn say(&mut self, name: &str, what: impl Into<String>, is_used: bool) {
        if let Some((.., role)) = self.kinds.iter_mut().find(|(own, ..)| own == name) {
            *role = Some((what.into(), is_used));
        }
    }

    /// Keeps what is wrong with a file.
    fn fault(&mut self, name: &str, what: &str, error: FileError) {
        self.say(name, format!("{what} that cannot be used"), false);
        self.opened.faults.push(error);
    }

    /// The scene: the one that no other includes.
    fn scenes(&mut self) {
        let mut read = Vec::new();
        for name in self.of(Kind::Scene) {
            let path = PathBuf::from(&name);
            match self.source().text(&path) {
                Ok(text) => {
                    self.files.forget();
                    let held = self.source().scene_of(&path, &text);
                    let others = self.others(&name);
                    read.push((name, Alone { path, text }, held, others));
                }
                Err(error) => self.fault(&name, "a scene", error),
            }
        }
        let parts: Vec<String> = read.iter().flat_map(|(.., others)| others.clone()).collect();
        for (name, Alone { path, text }, held, others) in read {
            if parts.contains(&name) {
                continue;
            }
            if self.opened.scene.is_some() {
                self.say(&name, "another scene: one is open", false);
                continue;
            }
            let held = match held {
                Ok(loaded) => {
                    self.say(&name, "a scene", true);
                    Some(loaded.scene)
                }
                Err(error) => {
                    self.fault(&name, "a scene", error);
                    None
                }
            };
            for other in &others {
                self.say(other, format!("named by {name}"), true);
            }
            self.opened.scene = Some(Held { path, text, held });
        }
    }

    /// The files that were read beside this one since the last look.
    fn others(&self, name: &str) -> Vec<String> {
        let read = self.files.names().filter(|other| *other != name && self.files.was_read(other));
        read.map(str::to_owned).collect()
    }

    /// The figure: the one whose file no other names.
    fn figures(&mut self) {
        let names = self.of(Kind::Figure);
        let mut read: Vec<(String, Result<Body, FileError>, Vec<String>)> = Vec::new();
        for name in &names {
            self.files.forget();
            let body = self.source().body_with(Path::new(name), None, &self.options.clip);
            read.push((name.clone(), body, self.others(name)));
        }
        let parts: Vec<String> = read.iter().flat_map(|(.., others)| others.clone()).collect();
        for (name, body, others) in read {
            if parts.contains(&name) {
                continue;
            }
            match body {
                Ok(_) if self.opened.body.is_some() => self.say(&name, "another figure: one is open", false),
                Ok(body) => {
                    self.say(
                        &name,
                        format!("the figure '{}' ({})", body.figure.name(), body.language.name()),
                        true,
                    );
                    self.opened.body = Some(body);
                }
                Err(error) => self.fault(&name, "a figure", error),
            }
            for other in &others {
                self.say(other, format!("named by {name}"), true);
            }
        }
    }

    /// The motion of a figure that was dropped with it, or body and motion in one.
    fn clips(&mut self) {
        for name in self.of(Kind::Clip) {
            let path = PathBuf::from(&name);
            if self.opened.motion.is_some() {
                self.say(&name, "another motion: one is open", false);
                continue;
            }
            if let Some(body) = self.opened.body.take() {
                self.motion_of(&body, &name);
                self.opened.body = Some(body);
                continue;
            }
            match self.source().clip(&path, &self.options.clip) {
                Ok(Clip { figure, motion, findings, .. }) => {
                    let language =
                        if name.to_lowercase().ends_with("bvh") { Language::Bvh } else { Language::Gltf };
                    self.say(&name, format!("a body and its motion ({})", language.name()), true);
                    self.opened.body = Some(Body { language, findings, ..Body::own(figure) });
                    let (table, findings, notes, ignored) = (None, Vec::new(), Vec::new(), Vec::new());
                    self.opened.motion = Some(OpenedMotion { path, motion, table, findings, notes, ignored });
                }
                Err(error) => self.fault(&name, "a clip", error),
            }
        }
    }

    /// Reads a file as the motion of a figure.
    fn motion_of(&mut self, body: &Body, name: &str) {
        let path = PathBuf::from(name);
        let read = self.source().motion(&path, &body.figure).and_then(|(table, findings)| {
            record::read_with_defaults(&body.figure, body.gravity, &table, &body.defaults)
                .map(|read| (table, findings, read))
                .map_err(|error| FileError::input(&path, &error))
        });
        match read {
            Ok((table, findings, read)) => {
                self.say(name, format!("a motion of '{}'", body.figure.name()), true);
                let record::ReadMotion { motion, ignored, notes } = read;
                let table = Some(table);
                self.opened.motion = Some(OpenedMotion { path, motion, table, findings, notes, ignored });
            }
            Err(error) => self.fault(name, "a motion", error),
        }
    }

    /// Takes the figure that is open already where none came with the files.
    fn body(&mut self) -> bool {
        if self.opened.body.is_none() {
            self.opened.body = self.options.figure.take();
        }
        self.opened.body.is_some()
    }

    /// Tables: the motion; forces are kept for those who say what they push.
    fn tables(&mut self) {
        let described = self.described();
        for name in self.of(Kind::Table) {
            if described.iter().any(|path| self.files.find(path) == Some(&name)) {
                continue;
            }
            let table = match self.source().table(Path::new(&name)) {
                Ok(table) => table,
                Err(error) => {
                    self.fault(&name, "a table", error);
                    continue;
                }
            };
            if !self.body() {
                let what = if record::force_prefixes(&table).is_empty() {
                    "a motion"
                } else {
                    "forces, or a motion"
                };
                self.say(
                    &name,
                    format!("{what} without a figure: open its figure, or drop it with it"),
                    false,
                );
                continue;
            }
            let Some(body) = self.opened.body.take() else { continue };
            if is_of_forces(&table, &body) {
                self.say_forces(&name, table, &body);
            } else if self.opened.motion.is_some() {
                self.say(&name, "another motion: one is open", false);
            } else {
                self.motion_of(&body, &name);
                if let (Some(motion), External::None) = (&self.opened.motion, &self.opened.external) {
                    self.opened.external = by_links(&motion.path, table, &body);
                }
            }
            self.opened.body = Some(body);
        }
    }

    /// Forces whose columns are called by links of the figure, as `solaris walk` writes them, or those of force plates.
    fn say_forces(&mut self, name: &str, table: Table, body: &Body) {
        let plates = table_plates(&table);
        let external = by_links(Path::new(name), table, body);
        if matches!(external, External::None) {
            match plates {
                Ok(_) if !self.opened.plates.is_empty() => {
                    self.say(name, "other force plates: some are open", false);
                }
                Ok(plates) => {
                    let what = match plates.len() {
                        1 => "a force plate; the foot on it is found by the soles".to_owned(),
                        count => format!("{count} force plates; the feet on them are found by the soles"),
                    };
                    self.say(name, what, true);
                    self.opened.plates = plates;
                }
                Err(error) => self.fault(name, "force plates", FileError::input(Path::new(name), &error)),
            }
            return;
        }
        self.say(name, "forces on links of the figure", true);
        self.opened.external = external;
    }

    /// The tables that descriptions of loads name.
    fn described(&self) -> Vec<PathBuf> {
        let loads = self.of(Kind::Loads);
        let named = loads.iter().filter_map(|name| {
            let text = self.source().text(Path::new(name)).ok()?;
            let data = solaris_io::opensim::external_loads(&text).ok()?.data_file?;
            Some(Path::new(name).parent().unwrap_or(Path::new("")).join(data.trim()))
        });
        named.collect()
    }

    fn loads(&mut self) {
        for name in self.of(Kind::Loads) {
            self.files.forget();
            let read = External::read(self.source(), &[], [None, Some(Path::new(&name))]);
            let others = self.others(&name);
            for other in &others {
                self.say(other, format!("named by {name}"), true);
            }
            let read = read.and_then(|external| match &self.opened.body {
                Some(body) => external.records(&body.figure).map(|_| external),
                None => Ok(external),
            });
            match read {
                Ok(external) => {
                    self.say(&name, "which measured forces push which bodies", true);
                    self.opened.external = external;
                }
                Err(ExternalError::File(error)) => self.fault(&name, "a description of forces", error),
                Err(error) => {
                    let error = FileError::input(Path::new(&name), &error);
                    self.fault(&name, "a description of forces", error);
                }
            }
        }
    }

    fn recordings(&mut self) {
        for name in self.of(Kind::Markers) {
            if self.opened.recording.is_some() || self.opened.motion.is_some() {
                self.say(&name, "another motion: one is open", false);
                continue;
            }
            let path = PathBuf::from(&name);
            let recording = match self.source().recording(&path, self.options.unit) {
                Ok(recording) => recording,
                Err(error) => {
                    self.fault(&name, "a recording of markers", error);
                    continue;
                }
            };
            let is_given = self.opened.body.is_some();
            self.body();
            let body = self.opened.body.take();
            // Of a figure that happens to be open, markers need not be.
            match body.filter(|body| is_given || in_common(body, &recording) >= COMMON) {
                Some(body) => {
                    self.fit(&body, &name);
                    self.opened.body = Some(body);
                }
                None => self.cloud(&path, recording),
            }
        }
    }

    /// Fits a figure to markers.
    fn fit(&mut self, body: &Body, name: &str) {
        let path = PathBuf::from(name);
        let (unit, axes) = (self.options.unit, self.options.axes);
        let fitted = self
            .source()
            .in_world(&path, body.gravity, unit, axes)
            .and_then(|read| fit_markers(&path, body, read.recording, body.ik_options()));
        match fitted {
            Ok(fit) => {
                self.say(name, format!("markers of '{}'", body.figure.name()), true);
                self.opened.recording = Some(fit.recording.clone());
                let findings = fit.recording.findings.iter().chain(&fit.findings).cloned().collect();
                let (motion, notes, ignored) = (fit.motion.clone(), Vec::new(), Vec::new());
                let table = None;
                self.opened.motion = Some(OpenedMotion { path, motion, table, findings, notes, ignored });
                self.opened.fit = Some(fit);
            }
            Err(error) => self.fault(name, "markers", error),
        }
    }

    /// Markers alone, as a figure of points.
    fn cloud(&mut self, path: &Path, recording: Recording) {
        let name = path.to_string_lossy().into_owned();
        let recording = turned(recording, self.options.axes).recording;
        let gravity = Body::GRAVITY;
        match cloud(&recording.markers, gravity) {
            Ok(found) => {
                self.say(&name, "markers without a figure, shown as points", true);
                let findings: Vec<Finding> =
                    recording.findings.iter().cloned().chain(found.findings).collect();
                self.opened.body = Some(Body::own(found.figure));
                let (motion, table, notes, ignored) = (found.motion, None, Vec::new(), Vec::new());
                let path = path.to_owned();
                self.opened.motion = Some(OpenedMotion { path, motion, table, findings, notes, ignored });
                self.opened.is_cloud = true;
                self.opened.recording = Some(recording);
            }
            Err(error) => self.fault(&name, "markers", FileError::input(path, &error)),
        }
    }

    fn soles(&mut self) {
        for name in self.of(Kind::Soles) {
            if !self.body() {
                self.say(&name, "soles without a figure: open their figure, or drop it with them", false);
                continue;
            }
            let Some(body) = &self.opened.body else { continue };
            match self.source().soles(Some(Path::new(&name)), &body.figure) {
                Ok(soles) => {
                    self.opened.soles = soles;
                    self.say(&name, "where feet meet the ground", true);
                }
                Err(error) => self.fault(&name, "soles", error),
            }
        }
        if let (None, Some(body), false) = (&self.opened.soles, &self.opened.body, self.opened.is_cloud) {
            self.opened.soles = self.source().soles(None, &body.figure).ok().flatten();
        }
    }

    /// Pages and profiles.
    fn texts(&mut self) {
        for name in self.of(Kind::Page) {
            let path = PathBuf::from(&name);
            let found = self.source().decoded(&path).and_then(|text| {
                let why = "it is a page, and none of this program: it holds no data";
                page::data(&text).map(str::to_owned).ok_or_else(|| FileError::input(&path, &why))
            });
            match found {
                Ok(text) => {
                    self.say(&name, "a page of this program", true);
                    self.opened.page = Some(Alone { path, text });
                }
                Err(error) => self.fault(&name, "a page", error),
            }
        }
        for name in self.of(Kind::Profile) {
            let path = PathBuf::from(&name);
            let Ok(text) = self.source().text(&path) else { continue };
            let held = match profiles::read(&text) {
                Ok(profile) => {
                    self.say(&name, "a profile of motion", true);
                    Some(profile)
                }
                Err(faults) => {
                    self.fault(&name, "a profile", FileError::faulty(&path, &text, faults));
                    None
                }
            };
            self.opened.profile = Some(Held { path, text, held });
        }
    }

    fn finish(mut self) -> Opened {
        let roles = self.kinds.into_iter().map(|(name, _, role)| {
            let unknown = || ("nothing here names it, and alone it says nothing".to_owned(), false);
            let (what, is_used) = role.unwrap_or_else(unknown);
            FileRole { name, what, is_used }
        });
        self.opened.files = roles.collect();
        self.opened
    }
}

/// Whether no column of a table is a coordinate of the figure, and some are forces.
fn is_of_forces(table: &Table, body: &Body) -> bool {
    let layout = body.figure.layout();
    let last = |heading: &str| heading.rsplit('/').nth(1).map(str::to_owned);
    let is_coordinate = |heading: &String| {
        let name = heading.strip_suffix(".q").unwrap_or(heading);
        layout.q_names().iter().any(|own| own == name)
            || layout.dof_index(name).is_some()
            || last(name).is_some_and(|name| layout.dof_index(&name).is_some())
    };
    !record::force_prefixes(table).is_empty() && !table.columns.iter().any(is_coordinate)
}

/// Forces of a table whose columns are called by links of the figure; none where there are none.
fn by_links(path: &Path, table: Table, body: &Body) -> External {
    let plates = link_plates(&table, &body.figure);
    if plates.is_empty() { External::None } else { External::Plates { path: path.to_owned(), table, plates } }
}

/// How many markers of a recording are the figure's.
fn in_common(body: &Body, recording: &Recording) -> usize {
    let known = body.known_markers();
    known.iter().filter(|marker| recording.markers.marker(&marker.name).is_some()).count()
}

impl Body {
    /// What there is to say of it that looks wrong, or acts and is missing.
    pub fn doubts(&self) -> impl Iterator<Item = &Finding> {
        self.findings
            .iter()
            .filter(|finding| matches!(finding.kind, FindingKind::Missing | FindingKind::Suspect))
    }
}
