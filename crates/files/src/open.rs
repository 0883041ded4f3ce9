//! Whatever somebody drops, one file or several together, as what it is.

mod gather;
mod kind;
mod page;

use crate::error::FileError;
use crate::external::External;
use crate::figure::Body;
use crate::fit::MarkerFit;
use crate::given::Given;
use crate::soles::SolesFrom;
use gather::Gathering;
use solaris_analysis::ground::{PlateRecord, Sole};
use solaris_io::clip::ReadOptions;
use solaris_io::markers::{Axes, LengthUnit, Recording};
use solaris_io::{Table, TableNote};
use solaris_model::{Finding, Motion};
use solaris_profiles::Profile;
use solaris_scene::Scene;
use std::path::PathBuf;

/// What is known before files are opened.
#[derive(Debug, Default)]
pub struct OpenOptions {
    /// A figure that is open already: motions, soles and loads without a figure beside them are of it.
    pub figure: Option<Body>,
    /// How clips are read.
    pub clip: ReadOptions,
    /// Which ways of files of markers are up and forward; otherwise that is found.
    pub axes: Option<Axes>,
    /// The unit of their lengths, whatever they say.
    pub unit: Option<LengthUnit>,
}

/// What files came to.
#[derive(Debug, Default)]
pub struct Opened {
    /// The figure, with its gravity, its markers and what its reader had to say. It may be the one that was open already.
    pub body: Option<Body>,
    /// Its motion.
    pub motion: Option<OpenedMotion>,
    /// A recording of markers, along the axes of the figure's world (without a figure, of OpenSim's: x forward, y up), with its force
    /// plates.
    pub recording: Option<Recording>,
    /// Where markers were fitted: how well, by which, and what was done on the way.
    pub fit: Option<MarkerFit>,
    /// Where the feet meet the ground, and who says so.
    pub soles: Option<(Vec<Sole>, SolesFrom)>,
    /// Forces that were measured.
    pub external: External,
    /// Force plates of a table of which nobody says what they push: the feet on them are found by the soles.
    pub plates: Vec<PlateRecord>,
    /// A scene.
    pub scene: Option<Held<Scene>>,
    /// What a page of this program shows, as JSON.
    pub page: Option<Alone>,
    /// A profile of motion.
    pub profile: Option<Held<Profile>>,
    /// What each file was taken for, in the order in which they were given.
    pub files: Vec<FileRole>,
    /// Files that could not be read, each with what is wrong with it; the others are open all the same.
    pub faults: Vec<FileError>,
    /// Whether the figure is one of points that stand for markers, which nobody gave.
    pub is_cloud: bool,
}

/// A motion, and the file that it was read from.
#[derive(Clone, Debug)]
pub struct OpenedMotion {
    /// The file.
    pub path: PathBuf,
    /// What was recorded: of velocities and accelerations, what the file says.
    pub motion: Motion,
    /// Its table, where it is one.
    pub table: Option<Table>,
    /// What looks wrong with it.
    pub findings: Vec<Finding>,
    /// How it was read all the same.
    pub notes: Vec<TableNote>,
    /// Headings of columns that mean nothing for the figure.
    pub ignored: Vec<String>,
}

/// A text and the file that it stands in.
#[derive(Clone, Debug)]
pub struct Alone {
    /// The file.
    pub path: PathBuf,
    /// The text.
    pub text: String,
}

/// A text, the file that it stands in, and what it says.
#[derive(Clone, Debug)]
pub struct Held<T> {
    /// The file.
    pub path: PathBuf,
    /// The text.
    pub text: String,
    /// What it says, where it is without fault.
    pub held: Option<T>,
}

/// What a file was taken for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileRole {
    /// Its name, as it was given.
    pub name: String,
    /// What it is, in words.
    pub what: String,
    /// Whether anybody made use of it.
    pub is_used: bool,
}

/// Opens files together.
///
/// A figure (URDF, MJCF, SDF, OpenSim, or a text of this program) is one alone; a table, a clip, a TRC or C3D file is its motion, and
/// markers are fitted to it. What a file names is sought among the others. Of what there may be one only, the first is taken.
///
/// ```
/// use solaris_files::{Given, OpenOptions, open};
///
/// let figure = "Figure(version: 1, name: \"arm\", links: [Link(name: \"arm\", joint: Joint(name: \"elbow\", axes: [rx]), mass: 1)])";
/// let files = Given::new([("arm.ron", figure), ("wave.csv", "time,elbow.rx.q\n0,0\n0.1,0.2\n")]);
/// let opened = open(&files, OpenOptions::default());
/// assert!(opened.faults.is_empty(), "{:?}", opened.faults);
/// assert_eq!(opened.motion.expect("a motion").motion.q(1), [0.2]);
/// assert_eq!(opened.files[1].what, "a motion of 'arm'");
/// ```
pub fn open(files: &Given, options: OpenOptions) -> Opened {
    Gathering::new(files, options).opened()
}

impl Opened {
    /// The names of files that nobody made use of, each with why.
    pub fn unused(&self) -> impl Iterator<Item = &FileRole> {
        self.files.iter().filter(|file| !file.is_used)
    }
}
