//! Files that are read: figures in any format, tables of numbers.

mod folder;

use crate::error::CliError;
use crate::subject::SubjectReport;
use folder::Folder;
use solaris::io::bvh::{self, BvhError, Clip, ReadOptions};
use solaris::io::opensim::MarkerSet;
use solaris::io::{CoordinateDefault, Encoding, Import, Table, csv, decode, mjcf, opensim, sdf, sto, urdf};
use solaris::model::{Actuator, Figure, Finding, FindingKind, Medium, TextError, Tie, Vector3, text};
use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

/// The most bytes of a file that is read.
const MOST_BYTES: u64 = 1 << 30;
/// Gravity of figures that are Solaris' own: y is up (m/s²).
const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);

/// What a model file is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Language {
    Ron,
    Urdf,
    Mjcf,
    OpenSim,
    Bvh,
    Sdf,
}

impl Language {
    /// Its name for people.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Ron => "Solaris figure",
            Self::Urdf => "URDF",
            Self::Mjcf => "MuJoCo model",
            Self::OpenSim => "OpenSim model",
            Self::Bvh => "BVH skeleton",
            Self::Sdf => "SDF model",
        }
    }

    /// Of a file, by its extension, and for `.xml` by its root element.
    fn of(path: &Path, text: &str) -> Option<Self> {
        match extension(path).as_str() {
            "ron" => Some(Self::Ron),
            "urdf" => Some(Self::Urdf),
            "mjcf" => Some(Self::Mjcf),
            "osim" => Some(Self::OpenSim),
            "bvh" => Some(Self::Bvh),
            "sdf" | "world" => Some(Self::Sdf),
            "xml" => match root_element(text) {
                "mujoco" => Some(Self::Mjcf),
                "robot" => Some(Self::Urdf),
                "OpenSimDocument" => Some(Self::OpenSim),
                "sdf" => Some(Self::Sdf),
                _ => None,
            },
            _ => None,
        }
    }
}

/// Name of the first element of an XML text, after declarations and comments.
fn root_element(text: &str) -> &str {
    let mut rest = text.trim_start_matches('\u{feff}');
    loop {
        rest = rest.trim_start();
        let end = match rest {
            _ if rest.starts_with("<!--") => "-->",
            _ if rest.starts_with("<?") => "?>",
            _ if rest.starts_with("<!") => ">",
            _ => break,
        };
        match rest.split_once(end) {
            Some((_, after)) => rest = after,
            None => return "",
        }
    }
    let name = rest.strip_prefix('<').unwrap_or("");
    name.split(|c: char| c.is_whitespace() || matches!(c, '>' | '/')).next().unwrap_or("")
}

/// A figure as it was read.
#[derive(Clone)]
pub(crate) struct Body {
    pub(crate) figure: Figure,
    pub(crate) language: Language,
    /// What the reader had to say.
    pub(crate) findings: Vec<Finding>,
    pub(crate) gravity: Vector3<f64>,
    pub(crate) gravity_is_given: bool,
    /// The fluid that it moves in, and what carries it; empty but for models of MuJoCo.
    pub(crate) medium: Medium,
    /// Where its coordinates are while nobody says anything else, as far as the file says so.
    pub(crate) defaults: Vec<CoordinateDefault>,
    /// Its markers, as far as the file has any.
    pub(crate) markers: MarkerSet,
    /// How it was brought to a person's size, if it was.
    pub(crate) subject: Option<SubjectReport>,
}

impl Body {
    /// The figure with its markers as named frames.
    pub(crate) fn marked(&self) -> Figure {
        self.figure.with_markers(&self.markers.markers)
    }

    /// A figure that nobody had to read.
    pub(crate) fn own(figure: Figure) -> Self {
        Self {
            figure,
            language: Language::Ron,
            findings: Vec::new(),
            gravity: GRAVITY,
            gravity_is_given: false,
            medium: Medium::default(),
            defaults: Vec::new(),
            markers: MarkerSet::default(),
            subject: None,
        }
    }
}

/// What is known of files that are not read yet, by their extensions.
const UNREAD: [(&str, &str); 7] = [
    ("c3d", "measured markers (C3D)"),
    ("trc", "measured markers (TRC)"),
    ("fbx", "a model of a 3-D program (FBX), which is not read yet"),
    ("glb", "a model of a 3-D program (glTF), which is not read yet"),
    ("gltf", "a model of a 3-D program (glTF), which is not read yet"),
    ("usd", "a model of a 3-D program (USD), which is not read yet"),
    ("html", "a page, which a browser shows"),
];

/// Refuses a file of a format that is known and not read; `known` says what is.
pub(crate) fn refuse_unread(path: &Path, known: &str) -> Result<(), CliError> {
    let extension = extension(path);
    match UNREAD.iter().find(|(unread, _)| *unread == extension) {
        Some((_, what)) => Err(CliError::input(path, &format!("it is {what}; {known}"))),
        None => Ok(()),
    }
}

/// What a figure's file is written in, by its extension alone; none where that does not tell.
pub(crate) fn foreign(path: &Path) -> Option<Language> {
    match extension(path).as_str() {
        "urdf" => Some(Language::Urdf),
        "mjcf" => Some(Language::Mjcf),
        "osim" => Some(Language::OpenSim),
        "bvh" => Some(Language::Bvh),
        "sdf" | "world" => Some(Language::Sdf),
        "xml" => text(path).ok().and_then(|text| Language::of(path, &text)),
        _ => None,
    }
}

/// Reads a figure; files that it names are in its folder.
pub(crate) fn body(path: &Path) -> Result<Body, CliError> {
    body_in(path, None)
}

/// Reads a figure; files that it names are in this folder, which holds it, or else in its own.
pub(crate) fn body_in(path: &Path, files: Option<&Path>) -> Result<Body, CliError> {
    body_with(path, files, &ReadOptions::default())
}

/// The motors of a figure's joints, as its file has them.
pub(crate) fn actuators(path: &Path) -> Result<Vec<Actuator>, CliError> {
    let text = decode(bytes(path)?).map_err(|bytes| no_text(path, bytes))?.0;
    match Language::of(path, &text) {
        Some(Language::Urdf) => urdf::actuators(&text).map_err(|faults| faulty(path, &text, faults)),
        Some(Language::Mjcf) => mjcf::actuators(&text, &mut Folder::of(path, None)?)
            .map_err(|error| CliError::Files { path: path.to_owned(), error }),
        _ => Err(CliError::input(
            path,
            &"actuators are read of MuJoCo models and of URDF; leave 'actuators' out",
        )),
    }
}

/// What a figure's file holds together that its tree has open.
pub(crate) fn ties(path: &Path) -> Result<Vec<Tie>, CliError> {
    let text = decode(bytes(path)?).map_err(|bytes| no_text(path, bytes))?.0;
    match Language::of(path, &text) {
        Some(Language::Mjcf) => mjcf::ties(&text, &mut Folder::of(path, None)?)
            .map_err(|error| CliError::Files { path: path.to_owned(), error }),
        Some(Language::Sdf) => {
            sdf::ties(&text, &mut Folder::of(path, None)?).map_err(|faults| faulty(path, &text, faults))
        }
        _ => Err(CliError::input(path, &"loops are read of MuJoCo models and of SDF; leave 'loops' out")),
    }
}

/// Reads a figure, of a BVH file with these options.
pub(crate) fn body_with(path: &Path, files: Option<&Path>, options: &ReadOptions) -> Result<Body, CliError> {
    let known = "a figure is .ron, .urdf, .sdf or .world (Gazebo), .xml or .mjcf (MuJoCo), .osim, or .bvh";
    refuse_unread(path, known)?;
    let (text, encoding) = match extension(path).as_str() {
        // What people's and other programs' editors write.
        "urdf" | "sdf" | "world" | "xml" | "mjcf" | "osim" | "bvh" => {
            decode(bytes(path)?).map_err(|bytes| no_text(path, bytes))?
        }
        _ => (self::text(path)?, Encoding::Utf8),
    };
    let language = Language::of(path, &text).ok_or_else(|| {
        let why = match extension(path).as_str() {
            "xml" => {
                "it is neither a MuJoCo model (<mujoco>) nor a URDF (<robot>) nor an SDF (<sdf>) nor an OpenSim model"
                    .to_owned()
            }
            "csv" | "mot" | "sto" => format!("it is a motion, and a figure is needed: {known}"),
            _ => format!("its extension says nothing; {known}"),
        };
        CliError::input(path, &why)
    })?;
    let faults = |faults| faulty(path, &text, faults);
    let mut medium = Medium::default();
    let imported = match language {
        Language::Ron => text::read(&text)
            .map(|figure| Import { figure, findings: Vec::new(), gravity: GRAVITY, gravity_is_given: false })
            .map_err(faults),
        Language::Urdf => urdf::read(&text).map_err(faults),
        Language::Mjcf => mjcf::read_with(&text, &mut Folder::of(path, files)?)
            .map(|mjcf::Loaded { import, medium: found }| {
                medium = found;
                import
            })
            .map_err(|error| CliError::Files { path: path.to_owned(), error }),
        Language::OpenSim => opensim::read(&text).map_err(faults),
        Language::Sdf => sdf::read_with(&text, &mut Folder::of(path, files)?).map_err(faults),
        Language::Bvh => {
            let Clip { figure, findings, .. } = clip_of(path, &text, options)?;
            Ok(Import { figure, findings, gravity: GRAVITY, gravity_is_given: false })
        }
    };
    let Import { figure, mut findings, gravity, gravity_is_given, .. } = imported?;
    if encoding != Encoding::Utf8 {
        findings.push(Finding {
            kind: FindingKind::Note,
            subject: "letters".to_owned(),
            message: format!("the file is no UTF-8, and is read as {}", encoding.name()),
            place: None,
        });
    }
    if language == Language::Ron {
        let gravity = figure.gravity().copied();
        let gravity_is_given = gravity.is_some();
        return Ok(Body {
            figure,
            language,
            findings,
            gravity: gravity.unwrap_or(GRAVITY),
            gravity_is_given,
            medium,
            defaults: Vec::new(),
            markers: MarkerSet::default(),
            subject: None,
        });
    }
    // Kept with the figure, so that its text says which way is up.
    let figure = figure.with_gravity(gravity).map_err(|error| CliError::input(path, &error))?;
    let (mut defaults, mut markers) = (Vec::new(), MarkerSet::default());
    if language == Language::OpenSim {
        defaults = opensim::coordinate_defaults(&text);
        markers = opensim::markers(&text, &figure).map_err(faults)?;
    }
    Ok(Body {
        figure,
        language,
        findings,
        gravity,
        gravity_is_given,
        medium,
        defaults,
        markers,
        subject: None,
    })
}

/// Reads a BVH file.
pub(crate) fn clip(path: &Path, options: &ReadOptions) -> Result<Clip, CliError> {
    let (text, _) = decode(bytes(path)?).map_err(|bytes| no_text(path, bytes))?;
    clip_of(path, &text, options)
}

fn clip_of(path: &Path, text: &str, options: &ReadOptions) -> Result<Clip, CliError> {
    bvh::read(text, options).map_err(|error| match error {
        BvhError::Text(faults) => faulty(path, text, faults),
        other => CliError::input(path, &other),
    })
}

/// Reads a motion of a figure, and what looks wrong with it.
pub(crate) fn motion(path: &Path, figure: &Figure) -> Result<(Table, Vec<Finding>), CliError> {
    if extension(path) != "bvh" {
        return Ok((table(path)?, Vec::new()));
    }
    let mut clip = clip(path, &ReadOptions::default())?;
    let table = clip.table_of(figure).map_err(|error| CliError::input(path, &error))?;
    // The masses are the figure's.
    clip.findings.retain(|finding| finding.kind == FindingKind::Suspect && finding.subject != "masses");
    Ok((table, clip.findings))
}

/// Reads a table of numbers.
pub(crate) fn table(path: &Path) -> Result<Table, CliError> {
    let read = match extension(path).as_str() {
        "csv" => csv::read_table,
        "mot" => sto::read_mot,
        "sto" => sto::read,
        _ => {
            refuse_unread(path, "a motion is .csv, .mot, .sto or .bvh")?;
            return Err(CliError::input(path, &"its extension says nothing; a table is .csv, .mot or .sto"));
        }
    };
    read(&text(path)?).map_err(|error| CliError::input(path, &error))
}

/// Whether a file is one of motions, by its extension.
pub(crate) fn is_motion(path: &Path) -> bool {
    matches!(extension(path).as_str(), "csv" | "mot" | "sto" | "bvh" | "c3d" | "trc")
}

/// The error of a text with faults.
pub(crate) fn faulty(path: &Path, text: &str, faults: TextError) -> CliError {
    CliError::Text { path: path.to_owned(), text: text.to_owned(), faults }
}

/// A file's text.
pub(crate) fn text(path: &Path) -> Result<String, CliError> {
    String::from_utf8(bytes(path)?).map_err(|error| no_text(path, error.into_bytes()))
}

/// A file's text in any of the encodings that people's and other programs' editors write.
pub(crate) fn decoded(path: &Path) -> Result<String, CliError> {
    let (text, _) = decode(bytes(path)?).map_err(|bytes| no_text(path, bytes))?;
    Ok(text)
}

/// The error of bytes that are no text.
fn no_text(path: &Path, bytes: Vec<u8>) -> CliError {
    let at = String::from_utf8(bytes).err().map_or(0, |error| error.utf8_error().valid_up_to());
    CliError::input(path, &format!("it is no text: byte {at} is not UTF-8"))
}

/// A file's bytes.
pub(crate) fn bytes(path: &Path) -> Result<Vec<u8>, CliError> {
    let refuse = |why: &dyn ToString| CliError::input(path, why);
    if fs::metadata(path).is_ok_and(|found| found.is_dir()) {
        return Err(refuse(&"it is a folder; name a file"));
    }
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(|error| match error.kind() {
        std::io::ErrorKind::NotFound => refuse(&"there is no such file"),
        _ => refuse(&error),
    })?;
    file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(|error| refuse(&error))?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(refuse(&format!("it has more than {MOST_BYTES} bytes, the most that is read")));
    }
    Ok(bytes)
}

/// A path's extension in lower case, or nothing.
pub(crate) fn extension(path: &Path) -> String {
    path.extension().map(|extension| extension.to_string_lossy().to_lowercase()).unwrap_or_default()
}
