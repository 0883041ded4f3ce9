//! Command lines that cannot be understood: exit code 2.

use std::path::PathBuf;

/// Options that contradict each other, or that say too little.
#[derive(Debug, thiserror::Error)]
pub(crate) enum UsageError {
    #[error("CLIP {path} is a table, or nothing that is known; say whose motion it is: --figure FILE", path = .clip.display())]
    WhoseTable { clip: PathBuf },
    #[error("--all: {path} holds one motion; leave it out", path = .clip.display())]
    OneAnimation { clip: PathBuf },
    #[error(
        "--step-frequency {step_frequency}, --step-length {step_length} and --speed {speed}: any two decide the third; drop one"
    )]
    Overdetermined { step_frequency: String, step_length: String, speed: String },
    #[error(
        "--duration {typed}: a walk is as long as its steps; at {step_frequency} steps/min it takes about {typed} s with --steps {steps}"
    )]
    Duration { typed: String, step_frequency: f64, steps: usize },
    #[error(
        "--then {typed}: of a run it says how many steps and at which speed, as in steps=10,speed=4, and nothing else"
    )]
    NotOfRuns { typed: String },
    #[error(
        "--then {typed}: a distance is met from standing to standing; say --then stand=1 before it, or count steps"
    )]
    DistanceOnTheWay { typed: String },
    #[error("--then {typed}: nobody turns round on the way; say --then stand=1 before it")]
    BackwardOnTheWay { typed: String },
    #[error(
        "--distance {distance}: it is met by a whole walk, from standing to standing, and more follows; count the steps before \
         --then {then} (--steps N), or stop in between: --distance {distance} --then stand=1 --then {then}"
    )]
    DistanceThenMore { distance: String, then: String },
    #[error(
        "{motion} is a motion and {figure} is a figure: swap them, give the figure first: solaris {command} {figure} {motion}",
        motion = .motion.display(), figure = .figure.display()
    )]
    Swapped { command: &'static str, figure: PathBuf, motion: PathBuf },
    #[error("'{word}' is no command of {of}; {of} --help lists them")]
    NoSuchCommand { word: String, of: String },
    #[error("--height, --mass and --segment change a figure; a motion has no size")]
    MotionHasNoSize,
    #[error(
        "--unit, --up, --masses, --skip-frames and --clip say what a file of bones (.bvh, .glb) does not; IN is none"
    )]
    OnlyOfBones,
    #[error("--axes says which way is up and which forward in a file of markers (.c3d, .trc); IN is none")]
    OnlyOfMarkers,
    #[error("--unit of markers is mm, cm, m or inch")]
    UnitOfMarkers,
    #[error(
        "a recording of markers has no figure: --figure, --height, --mass, --segment and --dh are of figures and motions"
    )]
    MarkersHaveNoFigure,
    #[error("OUT {}: a .{what} is written of a figure; say whose motion it is: --figure FILE", .to.display())]
    OfFigure { what: String, to: PathBuf },
    #[error("nothing says whom to scale it to; give --static FILE, --scale-setup FILE.xml or --mass KG")]
    NothingToScale,
    #[error("--fit: there is no trial of markers; give .trc or .c3d files, or --static FILE")]
    NothingToFit,
    #[error("--x and --y name the same parameter; a map needs two")]
    SameAxes,
    #[error("-o writes one curve, and its free parameter has no value; give it one")]
    FreeHasNoValue,
    #[error("the following required arguments were not provided:\n  {}", .options.join("\n  "))]
    Missing { options: Vec<String> },
    #[error("--{option} says what a film strip shows, and none is written; add -o strip.svg")]
    NoStrip { option: &'static str },
    #[error("--rig says whose bones a file has, and none with bones is written; add -o x.glb or -o x.bvh")]
    NoBones,
    #[error("--arrows are nodes of a .glb, and none is written; add -o x.glb")]
    NoArrows,
    #[error("--format says what the files of a folder are; -o {} is one file", .path.display())]
    FormatOfOne { path: PathBuf },
    #[error("--curve is given {found} times; a blend has two curves")]
    Curves { found: usize },
}
