//! A figure and its motion from a BVH file.

use super::body::{figure, lengths, slides};
use super::error::BvhError;
use super::guess;
use super::motion::motion;
use super::parse::{Text, parse};
use crate::clip::bones::{Said, names};
use crate::clip::{Clip, ReadOptions, Up, masses};
use solaris_model::FindingKind;
use solaris_model::rig::bones;
use std::ops::Range;

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
    masses::check(options)?;
    let mut file = parse(text)?;
    let mut said = Said { text, findings: Vec::new() };
    rows(&mut file, options.skip, &mut said)?;
    let joints: Vec<(&str, Option<Range<usize>>)> =
        file.joints.iter().map(|joint| (joint.name, Some(joint.span.clone()))).collect();
    let names = names("joint", &joints, &mut said);
    let segments = bones(&names.iter().map(String::as_str).collect::<Vec<_>>());
    let segments = if masses::is_person(&segments) { segments } else { vec![None; segments.len()] };
    let up = options.up.unwrap_or_else(|| guess::up(&file, &segments, &mut said));
    if up == Up::Z {
        guess::turn(&mut file);
    }
    let slides = slides(&file);
    let unit = options.unit.unwrap_or_else(|| guess::unit(&file, &segments, &mut said));
    let lengths = lengths(&file, &segments, unit);
    let weights = masses::weights(&lengths, &names, options, &mut said)?;
    let figure = figure(&file, &names, &slides, unit, weights)
        .map_err(|(places, error)| places.locate(text, &error))?;
    let motion = motion(&file, &figure, &slides, unit, &mut said)?;
    Ok(Clip { figure, motion, findings: said.findings, unit })
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
