//! A skeleton and its motion to text.

use super::Unit;
use super::skeleton::{ORDER, Skeleton, Source};
use crate::error::IoError;
use solaris_model::{Figure, Motion, MotionError, UnitQuaternion, Vector3};
use std::io::{self, Write};

/// Names of the axes in channels.
const AXES: [char; 3] = ['X', 'Y', 'Z'];

/// Writes `motion` as BVH to `out`, lengths in `unit`, angles in degrees, six decimals.
///
/// Which figures fit and how they are written stands in the [module's documentation](super). Everything about the figure
/// is checked before the first byte.
///
/// # Errors
///
/// A motion of another figure or without a rate, gravity that does not point down −y (zero is allowed), a joint or name
/// that BVH cannot hold, a position too large for a number, and the writer's own errors.
pub fn write(figure: &Figure, motion: &Motion, unit: Unit, out: &mut impl Write) -> Result<(), IoError> {
    motion.check_figure(figure)?;
    let rate = motion.info.rate;
    if !(rate > 0.0 && rate <= 1e5) {
        return Err(MotionError::Rate { rate }.into());
    }
    let gravity = motion.info.gravity;
    let is_down = gravity.iter().all(|g| g.is_finite()) && -gravity.y >= gravity.amax();
    if gravity != Vector3::zeros() && !is_down {
        return Err(IoError::BvhUp { gravity });
    }
    let skeleton = Skeleton::of(figure)?;
    hierarchy(&skeleton, unit, out)?;
    write!(out, "MOTION\nFrames: {}\nFrame Time: {}\n", motion.len(), 1.0 / rate)?;
    let order = skeleton.order();
    // The angles of a quaternion go on from those of the frame before: never wrapped, like the others.
    let mut angles = vec![[0.0; 3]; skeleton.nodes.len()];
    for sample in 0..motion.len() {
        let q = motion.q(sample);
        for (node, angles) in skeleton.nodes.iter().zip(&mut angles) {
            if let Source::Quaternion(first, _) = node.turns[0].source {
                *angles = ORDER.angles_near(&rotation(&q[first..]), angles);
            }
        }
        let values = frame(&skeleton, &order, q, &angles, unit);
        if let Some(i) = values.iter().position(|value| !value.is_finite()) {
            // Every node has three channels after the root's three positions.
            let link = &skeleton.nodes[order[(i / 3).saturating_sub(1)]].name;
            let column = format!("{link}.channel");
            return Err(IoError::NotFinite { column, time: motion.time()[sample], value: values[i] });
        }
        let values: Vec<String> = values.into_iter().map(number).collect();
        writeln!(out, "{}", values.join(" "))?;
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
        let (keyword, position) =
            if index == 0 { ("ROOT", "6 Xposition Yposition Zposition") } else { ("JOINT", "3") };
        writeln!(
            out,
            "{tabs}{keyword} {}\n{tabs}{{\n{tabs}\tOFFSET {}",
            node.name,
            lengths(node.offset, unit)
        )?;
        write!(out, "{tabs}\tCHANNELS {position}")?;
        for turn in &node.turns {
            write!(out, " {}rotation", AXES[turn.axis])?;
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

/// The channels of one sample: the root's position, then the rotations of every node in the order of the file. `angles` (rad)
/// are those of each node's quaternion.
fn frame(skeleton: &Skeleton, order: &[usize], q: &[f64], angles: &[[f64; 3]], unit: Unit) -> Vec<f64> {
    let position = skeleton.slides.iter().fold(skeleton.origin, |p, (i, direction)| p + direction * q[*i]);
    let position = position * unit.per_metre();
    let turns =
        order.iter().flat_map(|&node| skeleton.nodes[node].turns.iter().map(move |turn| (node, turn)));
    let degrees = turns.map(|(node, turn)| match turn.source {
        Source::Nothing => 0.0,
        Source::Coordinate(i, sign) => sign * q[i].to_degrees(),
        Source::Quaternion(_, part) => angles[node][part].to_degrees(),
    });
    position.iter().copied().chain(degrees).collect()
}

/// The rotation of a quaternion (x, y, z, w), which a motion keeps near unit length.
fn rotation(q: &[f64]) -> UnitQuaternion<f64> {
    UnitQuaternion::from_quaternion([q[0], q[1], q[2], q[3]].into())
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
