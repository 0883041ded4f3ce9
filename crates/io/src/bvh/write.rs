//! A skeleton and its motion to text.

use super::Unit;
use super::skeleton::{Channels, Node, ORDER, Skeleton};
use crate::error::IoError;
use crate::upright::upright;
use solaris_model::{Figure, Motion, MotionError, MotionInfo, Vector3};
use std::io::{self, Write};

/// Names of the axes in channels.
const AXES: [char; 3] = ['X', 'Y', 'Z'];

/// Writes `motion` as BVH to `out`, lengths in `unit`, angles in degrees, six decimals.
///
/// How figures are written stands in the [module's documentation](super). A world whose gravity does not point down −y is
/// turned until it does.
///
/// # Errors
///
/// A motion of another figure or without a rate, gravity that is no direction (zero is one that leaves y up), a position too
/// large for a number, and the writer's own errors.
pub fn write(figure: &Figure, motion: &Motion, unit: Unit, out: &mut impl Write) -> Result<(), IoError> {
    motion.check_figure(figure)?;
    let rate = motion.info.rate;
    if !(rate > 0.0 && rate <= MotionInfo::HIGHEST_RATE) {
        return Err(MotionError::Rate { rate }.into());
    }
    let gravity = motion.info.gravity;
    if !gravity.iter().all(|g| g.is_finite()) {
        return Err(IoError::BvhUp { gravity });
    }
    let skeleton = Skeleton::of(figure, upright(&gravity));
    hierarchy(&skeleton, unit, out)?;
    write!(out, "MOTION\nFrames: {}\nFrame Time: {}\n", motion.len(), 1.0 / rate)?;
    let order = skeleton.order();
    // Angles that are found from a rotation go on from those of the frame before: never wrapped, like the others.
    let mut angles = vec![[0.0; 3]; skeleton.nodes.len()];
    for sample in 0..motion.len() {
        let q = motion.q(sample);
        let mut line = Vec::new();
        for &node in &order {
            for value in channels(&skeleton.nodes[node], q, &mut angles[node], unit) {
                if !value.is_finite() {
                    let column = format!("{}.channel", skeleton.nodes[node].name);
                    return Err(IoError::NotFinite { column, time: motion.time()[sample], value });
                }
                line.push(number(value));
            }
        }
        writeln!(out, "{}", line.join(" "))?;
    }
    Ok(out.flush()?)
}

/// What is left to write of the hierarchy.
enum Step {
    /// A node by its index, at this depth.
    Open(usize, usize),
    /// The closing brace of a node at this depth.
    Close(usize),
}

fn hierarchy(skeleton: &Skeleton, unit: Unit, out: &mut impl Write) -> io::Result<()> {
    writeln!(out, "HIERARCHY")?;
    let mut steps = vec![Step::Open(0, 0)];
    while let Some(step) = steps.pop() {
        let (index, depth) = match step {
            Step::Close(depth) => {
                writeln!(out, "{}}}", "\t".repeat(depth))?;
                continue;
            }
            Step::Open(index, depth) => (index, depth),
        };
        let (node, tabs) = (&skeleton.nodes[index], "\t".repeat(depth));
        let keyword = if index == 0 { "ROOT" } else { "JOINT" };
        let position = if node.is_placed { "6 Xposition Yposition Zposition" } else { "3" };
        // Some readers add the offset of what is free to its position, some take the position in its place: zero means the same to both.
        let offset = if node.is_free { Vector3::zeros() } else { node.offset };
        writeln!(out, "{tabs}{keyword} {}\n{tabs}{{\n{tabs}\tOFFSET {}", node.name, lengths(offset, unit))?;
        write!(out, "{tabs}\tCHANNELS {position}")?;
        let axes = match &node.channels {
            Channels::Own { turns, .. } => [turns[0].axis, turns[1].axis, turns[2].axis],
            Channels::Place { .. } => ORDER.axes(),
        };
        for axis in axes {
            write!(out, " {}rotation", AXES[axis])?;
        }
        writeln!(out)?;
        if node.children.is_empty() {
            let end = lengths(node.end, unit);
            writeln!(out, "{tabs}\tEnd Site\n{tabs}\t{{\n{tabs}\t\tOFFSET {end}\n{tabs}\t}}")?;
        }
        steps.push(Step::Close(depth));
        steps.extend(node.children.iter().rev().map(|&child| Step::Open(child, depth + 1)));
    }
    Ok(())
}

/// The channels of one node in one sample: its position where it has one, then its rotations. `angles` (rad) are those of
/// its last rotation, where they are found from one.
fn channels(node: &Node, q: &[f64], angles: &mut [f64; 3], unit: Unit) -> Vec<f64> {
    let (position, degrees) = match &node.channels {
        Channels::Own { slides, turns } => {
            let position = slides.iter().fold(node.offset, |p, (i, direction)| p + direction * q[*i]);
            let degrees = |i: usize| turns[i].source.map_or(0.0, |(i, sign)| sign * q[i].to_degrees());
            (position, [degrees(0), degrees(1), degrees(2)])
        }
        Channels::Place { placement, joint, first } => {
            let place = placement * joint.moved(&q[*first..]);
            *angles = ORDER.angles_near(&place.rotation, angles);
            (place.translation.vector, angles.map(f64::to_degrees))
        }
    };
    let position = node.is_placed.then_some(position * unit.per_metre());
    position.iter().flat_map(Vector3::iter).copied().chain(degrees).collect()
}

fn lengths(vector: Vector3<f64>, unit: Unit) -> String {
    let scaled = vector * unit.per_metre();
    [scaled.x, scaled.y, scaled.z].map(number).join(" ")
}

/// Six decimals: a hundredth of a micrometre, a millionth of a degree. A rounded zero has no sign.
fn number(value: f64) -> String {
    let text = format!("{value:.6}");
    if text == "-0.000000" { "0.000000".to_owned() } else { text }
}
