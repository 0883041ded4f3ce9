//! Figures, in whatever language they are written.

use crate::error::FileError;
use crate::files::Source;
use crate::read::{extension, refuse_unread};
use solaris_io::bvh::{self, BvhError};
use solaris_io::clip::{Clip, ReadOptions};
use solaris_io::opensim::{self, MarkerSet};
use solaris_io::{CoordinateDefault, Encoding, Import, glb, mjcf, sdf, urdf};
use solaris_model::{Actuator, Figure, Finding, FindingKind, JointKind, Marker, Medium, Tie, Vector3, text};
use std::path::Path;

/// Gravity of figures that are Solaris' own: y is up (m/s²).
const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);

/// What a model file is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// A figure's own text.
    Ron,
    /// URDF, of robots.
    Urdf,
    /// A model of `MuJoCo`.
    Mjcf,
    /// A model of `OpenSim`.
    OpenSim,
    /// The skeleton of motion capture.
    Bvh,
    /// The skeleton of a body of a 3D program.
    Gltf,
    /// A model or a world of Gazebo.
    Sdf,
}

impl Language {
    /// Its name for people.
    pub fn name(self) -> &'static str {
        match self {
            Self::Ron => "Solaris figure",
            Self::Urdf => "URDF",
            Self::Mjcf => "MuJoCo model",
            Self::OpenSim => "OpenSim model",
            Self::Bvh => "BVH skeleton",
            Self::Gltf => "glTF skeleton",
            Self::Sdf => "SDF model",
        }
    }

    /// Whether it is of bones and their motion, and leaves what they weigh to guess.
    pub fn is_of_bones(self) -> bool {
        matches!(self, Self::Bvh | Self::Gltf)
    }

    /// Of a file, by its extension, and for `.xml` by its root element.
    fn of(path: &Path, text: &str) -> Option<Self> {
        match extension(path).as_str() {
            "ron" => Some(Self::Ron),
            "urdf" => Some(Self::Urdf),
            "mjcf" => Some(Self::Mjcf),
            "osim" => Some(Self::OpenSim),
            "bvh" => Some(Self::Bvh),
            "glb" | "gltf" => Some(Self::Gltf),
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
pub(crate) fn root_element(text: &str) -> &str {
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
#[derive(Clone, Debug)]
pub struct Body {
    /// The figure, with the gravity that its file says.
    pub figure: Figure,
    /// What it was written in.
    pub language: Language,
    /// What the reader had to say.
    pub findings: Vec<Finding>,
    /// Gravity (m/s²): the file's, or what is usual in its language.
    pub gravity: Vector3<f64>,
    /// Whether the file says it.
    pub gravity_is_given: bool,
    /// The fluid that it moves in, and what carries it; empty but for models of MuJoCo.
    pub medium: Medium,
    /// Where its coordinates are while nobody says anything else, as far as the file says so.
    pub defaults: Vec<CoordinateDefault>,
    /// Its markers, as far as the file has any.
    pub markers: MarkerSet,
}

impl Body {
    /// Gravity where nobody says one (m/s²): y is up.
    pub const GRAVITY: Vector3<f64> = GRAVITY;

    /// The figure with its markers as named frames.
    pub fn marked(&self) -> Figure {
        self.figure.with_markers(&self.markers.markers)
    }

    /// Which way figures of its format go forward, where a picture would not know.
    pub fn forward(&self) -> Option<Vector3<f64>> {
        (self.language == Language::OpenSim).then(Vector3::x)
    }

    /// The positions (`nq`) that the figure has while nobody says anything else: those of the file, or zero.
    pub fn rest(&self) -> Vec<f64> {
        let layout = self.figure.layout();
        let mut rest = vec![0.0; layout.nq()];
        self.figure.neutral(&mut rest).expect("as long as its configurations are");
        for (default, _, at) in self.free_defaults() {
            rest[at] = default.value;
        }
        let nv = layout.nv();
        self.figure.follow(&mut rest, &mut vec![0.0; nv], &mut vec![0.0; nv]);
        rest
    }

    /// The degrees of freedom (index in `v`) that the file locks, each with its value (rad or m).
    pub fn locked(&self) -> Vec<(usize, f64)> {
        let locked = self.free_defaults().filter(|(default, _, _)| default.is_locked);
        locked.map(|(default, dof, _)| (dof, default.value)).collect()
    }

    /// The degrees of freedom (index in `v`) that stay in their range (rad or m): where the file clamps them, or where its format
    /// knows no clamps.
    pub fn clamped(&self) -> Vec<(usize, f64, f64)> {
        let layout = self.figure.layout();
        let is_clamped = |dof: usize| {
            let default = self.defaults.iter().find(|default| layout.dof_index(&default.name) == Some(dof));
            default.map_or(self.defaults.is_empty(), |default| default.is_clamped)
        };
        let mut clamped = Vec::new();
        for (link, at) in self.figure.links().iter().zip(layout.joints()) {
            let JointKind::Axes(dofs) = link.joint().kind() else { continue };
            for (i, dof) in dofs.iter().enumerate() {
                let free = is_clamped(at.v + i) && !self.figure.follows(at.v + i);
                if let Some(limits) = dof.limits.filter(|_| free) {
                    clamped.push((at.v + i, limits.lower, limits.upper));
                }
            }
        }
        clamped
    }

    /// Its named frames as markers, for a figure that has no others.
    pub fn frames_as_markers(&self) -> Vec<Marker> {
        let of = self.figure.links().iter().enumerate();
        of.flat_map(|(link, it)| {
            it.frames().iter().map(move |frame| Marker {
                name: frame.name.clone(),
                link,
                position: frame.placement.translation.vector,
                is_fixed: false,
            })
        })
        .collect()
    }

    /// What the file says of coordinates that are free, each with its degree of freedom and its place in `q`.
    fn free_defaults(&self) -> impl Iterator<Item = (&CoordinateDefault, usize, usize)> {
        let layout = self.figure.layout();
        self.defaults.iter().filter_map(move |default| {
            let dof = layout.dof_index(&default.name).filter(|dof| !self.figure.follows(*dof))?;
            Some((default, dof, layout.coordinate(dof)?))
        })
    }

    /// A figure that nobody had to read.
    pub fn own(figure: Figure) -> Self {
        Self {
            figure,
            language: Language::Ron,
            findings: Vec::new(),
            gravity: GRAVITY,
            gravity_is_given: false,
            medium: Medium::default(),
            defaults: Vec::new(),
            markers: MarkerSet::default(),
        }
    }
}

impl Source<'_> {
    /// What a figure's file of another program is written in, by its extension alone; none where that does not tell.
    pub fn language(self, path: &Path) -> Option<Language> {
        match extension(path).as_str() {
            "urdf" => Some(Language::Urdf),
            "mjcf" => Some(Language::Mjcf),
            "osim" => Some(Language::OpenSim),
            "bvh" => Some(Language::Bvh),
            "glb" | "gltf" => Some(Language::Gltf),
            "sdf" | "world" => Some(Language::Sdf),
            "xml" => self.text(path).ok().and_then(|text| Language::of(path, &text)),
            _ => None,
        }
    }

    /// Reads a figure; files that it names are in its folder.
    ///
    /// # Errors
    ///
    /// Files that cannot be read, and every fault of what they hold, with its place.
    pub fn body(self, path: &Path) -> Result<Body, FileError> {
        self.body_in(path, None)
    }

    /// Reads a figure; files that it names are in this folder, which holds it, or else in its own.
    ///
    /// # Errors
    ///
    /// As [`Source::body`], and a folder that does not hold the figure.
    pub fn body_in(self, path: &Path, files: Option<&Path>) -> Result<Body, FileError> {
        self.body_with(path, files, &ReadOptions::default())
    }

    /// The motors of a figure's joints, as its file has them.
    ///
    /// # Errors
    ///
    /// As [`Source::body`], and languages without motors.
    pub fn actuators(self, path: &Path) -> Result<Vec<Actuator>, FileError> {
        let text = self.decoded(path)?;
        match Language::of(path, &text) {
            Some(Language::Urdf) => {
                urdf::actuators(&text).map_err(|faults| FileError::faulty(path, &text, faults))
            }
            Some(Language::Mjcf) => mjcf::actuators(&text, &mut *self.files.beside(path, None)?)
                .map_err(|error| FileError::Files { path: path.to_owned(), error }),
            _ => Err(FileError::input(
                path,
                &"actuators are read of MuJoCo models and of URDF; leave 'actuators' out",
            )),
        }
    }

    /// What a figure's file holds together that its tree has open.
    ///
    /// # Errors
    ///
    /// As [`Source::body`], and languages without loops.
    pub fn ties(self, path: &Path) -> Result<Vec<Tie>, FileError> {
        let text = self.decoded(path)?;
        match Language::of(path, &text) {
            Some(Language::Mjcf) => mjcf::ties(&text, &mut *self.files.beside(path, None)?)
                .map_err(|error| FileError::Files { path: path.to_owned(), error }),
            Some(Language::Sdf) => sdf::ties(&text, &mut *self.files.beside(path, None)?)
                .map_err(|faults| FileError::faulty(path, &text, faults)),
            _ => {
                Err(FileError::input(path, &"loops are read of MuJoCo models and of SDF; leave 'loops' out"))
            }
        }
    }

    /// Reads a figure, of a file of bones with these options.
    ///
    /// # Errors
    ///
    /// As [`Source::body_in`].
    pub fn body_with(
        self,
        path: &Path,
        files: Option<&Path>,
        options: &ReadOptions,
    ) -> Result<Body, FileError> {
        let known =
            "a figure is .ron, .urdf, .sdf or .world (Gazebo), .xml or .mjcf (MuJoCo), .osim, .bvh, or .glb";
        refuse_unread(path, known)?;
        if is_gltf(path) {
            let Clip { figure, findings, .. } = self.clip(path, options)?;
            return Ok(Body { language: Language::Gltf, findings, ..Body::own(figure) });
        }
        let (text, encoding) = match extension(path).as_str() {
            // What people's and other programs' editors write.
            "urdf" | "sdf" | "world" | "xml" | "mjcf" | "osim" | "bvh" => self.with_encoding(path)?,
            _ => (self.text(path)?, Encoding::Utf8),
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
            FileError::input(path, &why)
        })?;
        let faults = |faults| FileError::faulty(path, &text, faults);
        let mut medium = Medium::default();
        let imported = match language {
            Language::Ron => text::read(&text)
                .map(|figure| Import {
                    figure,
                    findings: Vec::new(),
                    gravity: GRAVITY,
                    gravity_is_given: false,
                })
                .map_err(faults),
            Language::Urdf => urdf::read(&text).map_err(faults),
            Language::Mjcf => mjcf::read_with(&text, &mut *self.files.beside(path, files)?)
                .map(|mjcf::Loaded { import, medium: found }| {
                    medium = found;
                    import
                })
                .map_err(|error| FileError::Files { path: path.to_owned(), error }),
            Language::OpenSim => opensim::read(&text).map_err(faults),
            Language::Sdf => sdf::read_with(&text, &mut *self.files.beside(path, files)?).map_err(faults),
            Language::Bvh | Language::Gltf => {
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
            });
        }
        // Kept with the figure, so that its text says which way is up.
        let figure = figure.with_gravity(gravity).map_err(|error| FileError::input(path, &error))?;
        let (mut defaults, mut markers) = (Vec::new(), MarkerSet::default());
        if language == Language::OpenSim {
            defaults = opensim::coordinate_defaults(&text);
            markers = opensim::markers(&text, &figure).map_err(faults)?;
        }
        Ok(Body { figure, language, findings, gravity, gravity_is_given, medium, defaults, markers })
    }

    /// Reads a file of bones and their motion: BVH, or glTF.
    ///
    /// # Errors
    ///
    /// As [`Source::body`].
    pub fn clip(self, path: &Path, options: &ReadOptions) -> Result<Clip, FileError> {
        if is_gltf(path) {
            return glb::read(&self.bytes(path)?, options).map_err(|error| FileError::input(path, &error));
        }
        let text = self.decoded(path)?;
        clip_of(path, &text, options)
    }
}

/// [`Source::language`] of the disk.
pub fn language(path: &Path) -> Option<Language> {
    Source::disk().language(path)
}

/// [`Source::body`] of the disk.
///
/// # Errors
///
/// As there.
pub fn body(path: &Path) -> Result<Body, FileError> {
    Source::disk().body(path)
}

/// [`Source::body_in`] of the disk.
///
/// # Errors
///
/// As there.
pub fn body_in(path: &Path, files: Option<&Path>) -> Result<Body, FileError> {
    Source::disk().body_in(path, files)
}

/// [`Source::body_with`] of the disk.
///
/// # Errors
///
/// As there.
pub fn body_with(path: &Path, files: Option<&Path>, options: &ReadOptions) -> Result<Body, FileError> {
    Source::disk().body_with(path, files, options)
}

/// [`Source::actuators`] of the disk.
///
/// # Errors
///
/// As there.
pub fn actuators(path: &Path) -> Result<Vec<Actuator>, FileError> {
    Source::disk().actuators(path)
}

/// [`Source::ties`] of the disk.
///
/// # Errors
///
/// As there.
pub fn ties(path: &Path) -> Result<Vec<Tie>, FileError> {
    Source::disk().ties(path)
}

/// [`Source::clip`] of the disk.
///
/// # Errors
///
/// As there.
pub fn clip(path: &Path, options: &ReadOptions) -> Result<Clip, FileError> {
    Source::disk().clip(path, options)
}

/// Whether a file is one of bones and their motion, by its extension.
pub fn is_clip(path: &Path) -> bool {
    extension(path) == "bvh" || is_gltf(path)
}

fn is_gltf(path: &Path) -> bool {
    matches!(extension(path).as_str(), "glb" | "gltf")
}

fn clip_of(path: &Path, text: &str, options: &ReadOptions) -> Result<Clip, FileError> {
    bvh::read(text, options).map_err(|error| match error {
        BvhError::Text(faults) => FileError::faulty(path, text, faults),
        other => FileError::input(path, &other),
    })
}
