//! Files that are read: figures in any format, tables of numbers.

use crate::error::CliError;
use solaris::io::bvh::{self, BvhError, Clip, ReadOptions};
use solaris::io::{Import, Table, csv, mjcf, opensim, sto, urdf};
use solaris::model::{Figure, Finding, TextError, Vector3, text};
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
            "xml" => match root_element(text) {
                "mujoco" => Some(Self::Mjcf),
                "robot" => Some(Self::Urdf),
                "OpenSimDocument" => Some(Self::OpenSim),
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
}

impl Body {
    /// A figure that nobody had to read.
    pub(crate) fn own(figure: Figure) -> Self {
        Self {
            figure,
            language: Language::Ron,
            findings: Vec::new(),
            gravity: GRAVITY,
            gravity_is_given: false,
        }
    }
}

/// What is known of files that are not read yet, by their extensions.
const UNREAD: [(&str, &str); 8] = [
    ("c3d", "measured markers (C3D), which are not read yet"),
    ("trc", "measured markers (TRC), which are not read yet"),
    ("fbx", "a model of a 3-D program (FBX), which is not read yet"),
    ("glb", "a model of a 3-D program (glTF), which is not read yet"),
    ("gltf", "a model of a 3-D program (glTF), which is not read yet"),
    ("usd", "a model of a 3-D program (USD), which is not read yet"),
    ("sdf", "a model of a simulator (SDF), which is not read yet"),
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
        "xml" => text(path).ok().and_then(|text| Language::of(path, &text)),
        _ => None,
    }
}

/// Reads a figure.
pub(crate) fn body(path: &Path) -> Result<Body, CliError> {
    body_with(path, &ReadOptions::default())
}

/// Reads a figure, of a BVH file with these options.
pub(crate) fn body_with(path: &Path, options: &ReadOptions) -> Result<Body, CliError> {
    let known = "a figure is .ron, .urdf, .xml or .mjcf (MuJoCo), .osim, or .bvh";
    refuse_unread(path, known)?;
    let text = self::text(path)?;
    let language = Language::of(path, &text).ok_or_else(|| {
        let why = match extension(path).as_str() {
            "xml" => {
                "it is neither a MuJoCo model (<mujoco>) nor a URDF (<robot>) nor an OpenSim model".to_owned()
            }
            "csv" | "mot" | "sto" => format!("it is a motion, and a figure is needed: {known}"),
            _ => format!("its extension says nothing; {known}"),
        };
        CliError::input(path, &why)
    })?;
    let imported = match language {
        Language::Ron => text::read(&text).map(|figure| Import {
            figure,
            findings: Vec::new(),
            gravity: GRAVITY,
            gravity_is_given: false,
        }),
        Language::Urdf => urdf::read(&text),
        Language::Mjcf => mjcf::read(&text),
        Language::OpenSim => opensim::read(&text),
        Language::Bvh => {
            let Clip { figure, findings, .. } = clip_of(path, &text, options)?;
            Ok(Import { figure, findings, gravity: GRAVITY, gravity_is_given: false })
        }
    };
    let Import { figure, findings, gravity, gravity_is_given, .. } =
        imported.map_err(|faults| faulty(path, &text, faults))?;
    if language == Language::Ron {
        let gravity = figure.gravity().copied();
        let gravity_is_given = gravity.is_some();
        return Ok(Body {
            figure,
            language,
            findings,
            gravity: gravity.unwrap_or(GRAVITY),
            gravity_is_given,
        });
    }
    // Kept with the figure, so that its text says which way is up.
    let figure = figure.with_gravity(gravity).map_err(|error| CliError::input(path, &error))?;
    Ok(Body { figure, language, findings, gravity, gravity_is_given })
}

/// Reads a BVH file.
pub(crate) fn clip(path: &Path, options: &ReadOptions) -> Result<Clip, CliError> {
    clip_of(path, &text(path)?, options)
}

fn clip_of(path: &Path, text: &str, options: &ReadOptions) -> Result<Clip, CliError> {
    bvh::read(text, options).map_err(|error| match error {
        BvhError::Text(faults) => faulty(path, text, faults),
        other => CliError::input(path, &other),
    })
}

/// Reads a motion of a figure.
pub(crate) fn motion(path: &Path, figure: &Figure) -> Result<Table, CliError> {
    if extension(path) == "bvh" {
        let clip = clip(path, &ReadOptions::default())?;
        return clip.table_of(figure).map_err(|error| CliError::input(path, &error));
    }
    table(path)
}

/// Reads a table of numbers.
pub(crate) fn table(path: &Path) -> Result<Table, CliError> {
    let read = match extension(path).as_str() {
        "csv" => csv::read_table,
        "mot" | "sto" => sto::read,
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
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        refuse(&format!("it is no text: byte {at} is not UTF-8"))
    })
}

/// A path's extension in lower case, or nothing.
pub(crate) fn extension(path: &Path) -> String {
    path.extension().map(|extension| extension.to_string_lossy().to_lowercase()).unwrap_or_default()
}
