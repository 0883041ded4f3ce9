//! A figure and its motion from a BVH file.

use super::body::{figure, lengths, slides, weights};
use super::error::BvhError;
use super::motion::motion;
use super::parse::{Text, parse};
use super::unit::Unit;
use super::{guess, masses};
use solaris_model::rig::bones;
use solaris_model::{Figure, Finding, FindingKind, Motion, Place};
use std::collections::{HashMap, HashSet};
use std::ops::Range;

/// Which of the file's axes points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Up {
    /// y, as most tools write.
    #[default]
    Y,
    /// z. The file's y, z, x become the figure's x, y, z.
    Z,
}

/// What a file does not say; what is left out is guessed, and a finding says what was.
#[derive(Clone, Debug, Default)]
pub struct ReadOptions {
    /// The unit of lengths.
    pub unit: Option<Unit>,
    /// The axis that points up.
    pub up: Option<Up>,
    /// The body's mass (kg).
    pub mass: Option<f64>,
    /// Masses of bones by their names (kg); those that it does not name have none. Empty where masses are a person's.
    pub masses: Vec<(String, f64)>,
    /// Frames that are left out at the beginning, such as a reference pose.
    pub skip: usize,
}

/// What a BVH file holds.
#[derive(Clone, Debug)]
pub struct Clip {
    /// A link a joint; x left, y up, z forward where the file has that.
    pub figure: Figure,
    /// Its positions; nothing else is known.
    pub motion: Motion,
    /// What was guessed, done and found.
    pub findings: Vec<Finding>,
    /// The unit that lengths were read in.
    pub unit: Unit,
}

/// Reads a BVH file: any hierarchy, any channels.
///
/// Each joint is a link with the joint's name, whose degrees of freedom are its channels in their order, positions first. A
/// position is where the joint is in its parent, in place of its `OFFSET`; positions of inner joints that never change are
/// no degrees of freedom. Angles go on from frame to frame: whole turns, and sets of three angles that were turned over,
/// are undone, which changes no rotation.
///
/// **Masses.** A rig with a person's names (see [`solaris_model::rig`]) gets a person's: each segment's published share of
/// the body, thigh, shank, upper arm and forearm with their centres of mass and radii of gyration, the others as solids. A
/// segment that the rig divides is divided by lengths, one that it lacks is part of the next one inwards. Other skeletons get
/// solids as thick as they are long, which a finding says, unless there is a table.
///
/// # Errors
///
/// The first thing that cannot be read, with its place: a block that does not close, an unknown channel, a row with another
/// number of numbers, a number that is not finite. Options that cannot be: a mass or unit of zero, a table that names what is
/// not there, more frames to leave out than there are.
///
/// # Examples
///
/// ```
/// let text = "HIERARCHY\nROOT rod\n{\n OFFSET 0 0 0\n CHANNELS 3 Zrotation Xrotation Yrotation\n \
///             End Site\n {\n OFFSET 0 -40 0\n }\n}\nMOTION\nFrames: 2\nFrame Time: 0.033333\n0 0 0\n90 0 0\n";
/// use solaris_io::bvh;
/// let clip = bvh::read(text, &Default::default())?;
/// assert_eq!(clip.figure.layout().q_names(), ["rod.rz", "rod.rx", "rod.ry"]);
/// assert_eq!((clip.motion.info.rate, clip.motion.q(1)[0]), (30.0, std::f64::consts::FRAC_PI_2));
/// # Ok::<(), bvh::BvhError>(())
/// ```
pub fn read(text: &str, options: &ReadOptions) -> Result<Clip, BvhError> {
    for (what, value) in [("mass", options.mass), ("unit", options.unit.map(|unit| 1.0 / unit.per_metre()))] {
        if let Some(value) = value.filter(|value| !(*value > 0.0 && value.is_finite())) {
            return Err(BvhError::Option { what, value });
        }
    }
    let mut file = parse(text)?;
    let mut said = Said { text, findings: Vec::new() };
    rows(&mut file, options.skip, &mut said)?;
    let names = names(&file, &mut said);
    let segments = bones(&names.iter().map(String::as_str).collect::<Vec<_>>());
    let segments = if masses::is_person(&segments) { segments } else { vec![None; segments.len()] };
    let up = options.up.unwrap_or_else(|| guess::up(&file, &segments, &mut said));
    if up == Up::Z {
        guess::turn(&mut file);
    }
    let slides = slides(&file);
    let unit = options.unit.unwrap_or_else(|| guess::unit(&file, &segments, &mut said));
    let lengths = lengths(&file, &segments, unit);
    let weights = weights(&lengths, &names, options, &mut said)?;
    let figure = figure(&file, &names, &slides, unit, weights)
        .map_err(|(places, error)| places.locate(text, &error))?;
    let motion = motion(&file, &figure, &slides, unit, &mut said)?;
    Ok(Clip { figure, motion, findings: said.findings, unit })
}

/// What there is to say.
pub(super) struct Said<'a> {
    pub(super) text: &'a str,
    findings: Vec<Finding>,
}

impl Said<'_> {
    pub(super) fn say(
        &mut self,
        kind: FindingKind,
        subject: impl Into<String>,
        message: String,
        span: Option<Range<usize>>,
    ) {
        let place = span.map(|span| Place::of(self.text, span));
        self.findings.push(Finding { kind, subject: subject.into(), message, place });
    }
}

/// Leaves out the frames at the beginning that are not wanted, and says what rows there are.
fn rows(file: &mut Text, skip: usize, said: &mut Said) -> Result<(), BvhError> {
    if let Some((frames, span)) =
        file.said.clone().filter(|(frames, _)| *frames != file.count && file.width > 0)
    {
        let message = format!("the file says {frames}, and has {}; these are read", file.count);
        said.say(FindingKind::Suspect, "Frames", message, Some(span));
    }
    if skip > 0 && skip >= file.count {
        return Err(BvhError::Skip { skip, frames: file.count });
    }
    file.values.drain(..skip * file.width);
    file.count -= skip;
    Ok(())
}

/// The most joints that are said one by one to have other names.
const MOST_RENAMED: usize = 100;

/// Names of links and joints: those of the file, made different, without blanks.
fn names(file: &Text, said: &mut Said) -> Vec<String> {
    let mut taken: HashSet<String> = HashSet::new();
    // How often a stem was tried, so that a thousand joints of one name are no million tries.
    let mut tried: HashMap<String, usize> = HashMap::new();
    let mut names = Vec::with_capacity(file.joints.len());
    let mut renamed = 0;
    for joint in &file.joints {
        let words: Vec<&str> = joint.name.split_whitespace().collect();
        let stem = if words.is_empty() { "joint".to_owned() } else { words.join("_") };
        let mut name = stem.clone();
        let count = tried.entry(stem.clone()).or_insert(1);
        while !taken.insert(name.clone()) {
            *count += 1;
            name = format!("{stem}_{count}");
        }
        renamed += usize::from(name != joint.name);
        if name != joint.name && renamed <= MOST_RENAMED {
            let message = format!("it is called '{name}' here: names differ and have no blanks");
            said.say(FindingKind::Note, format!("joint '{}'", joint.name), message, Some(joint.span.clone()));
        }
        names.push(name);
    }
    if renamed > MOST_RENAMED {
        let more = renamed - MOST_RENAMED;
        let message = format!("{more} more are called otherwise here: names differ and have no blanks");
        said.say(FindingKind::Note, "joints", message, None);
    }
    names
}
