//! The motion of a file: its rows as coordinates, angles that go on.

use super::angles::go_on;
use super::body::{GRAVITY, freedoms, origin};
use super::parse::{Channel, Text};
use super::unit::Unit;
use crate::clip::bones::Said;
use solaris_model::{Figure, FindingKind, Known, Motion, MotionError, MotionInfo, Vector3};

/// How far (relative) a printed time step may be from that of a whole number of frames a second.
const WHOLE: f64 = 3e-4;
/// A first frame this far (rad) from the second, and so many times as far as any frame after it from the next, is a pose of
/// its own.
const POSE: (f64, f64) = (0.35, 3.0);
/// A step of an angle from frame to frame (rad) that is a jump where it is none of the rotation.
const JUMP: f64 = 1.0;

/// The motion of `figure`, of which positions are known.
pub(super) fn motion(
    file: &Text,
    figure: &Figure,
    slides: &[bool],
    unit: Unit,
    said: &mut Said,
) -> Result<Motion, MotionError> {
    let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
    let interval = interval(file.interval);
    let (mut q, mut jumps) = (Vec::with_capacity(file.count * nq), 0);
    let freedoms: Vec<Vec<(usize, Channel)>> =
        file.joints.iter().zip(slides).map(|(node, slides)| freedoms(node, *slides)).collect();
    let origins: Vec<Vector3<f64>> = (0..file.joints.len()).map(|i| origin(file, i, slides[i])).collect();
    for row in 0..file.count {
        let values = file.row(row);
        for (freedoms, origin) in freedoms.iter().zip(&origins) {
            let first = q.len();
            q.extend(freedoms.iter().map(|(at, channel)| match *channel {
                Channel::Position(axis) => (values[*at] - origin[axis]) / unit.per_metre(),
                Channel::Rotation(_) => values[*at].to_radians(),
            }));
            let slides =
                freedoms.iter().filter(|(_, channel)| matches!(channel, Channel::Position(_))).count();
            if row > 0 && slides < freedoms.len() {
                let (before, now) = q.split_at_mut(first + slides);
                let before = &before[first + slides - nq..][..now.len()];
                go_on(now, before, now.len() == 3);
                let step = now.iter().zip(before).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                let last = file.row(row - 1);
                let mut printed =
                    freedoms[slides..].iter().map(|(at, _)| (values[*at] - last[*at]).to_radians().abs());
                jumps += usize::from(printed.any(|printed| printed > step + JUMP));
            }
        }
    }
    if jumps > 0 {
        let message = format!(
            "{jumps} times a joint's angles jumped by whole turns, or were turned over; they go on here"
        );
        said.say(FindingKind::Note, "angles", message, None);
    }
    reference_pose(&q, figure, file, &freedoms, said);
    let time: Vec<f64> = (0..file.count).map(|row| row as f64 * interval).collect();
    let mut info = MotionInfo::recorded(figure, GRAVITY, &time);
    info.rate = 1.0 / interval;
    let zeros = || vec![0.0; file.count * nv];
    Motion::recorded(figure, info, time, [q, zeros(), zeros()], Known::none(nv))
}

/// The time from row to row (s): that of a whole number of frames a second where the printed one is near to it.
fn interval(printed: Option<f64>) -> f64 {
    let printed = printed.unwrap_or(1.0 / 30.0);
    let rate = (1.0 / printed).round();
    if rate >= 1.0 && (printed * rate - 1.0).abs() < WHOLE { 1.0 / rate } else { printed }
}

/// Says where the first frame is a pose of its own: tools put one in front, and a motion that begins with it is none.
fn reference_pose(
    q: &[f64],
    figure: &Figure,
    file: &Text,
    freedoms: &[Vec<(usize, Channel)>],
    said: &mut Said,
) {
    let nq = figure.layout().nq();
    if file.count < 4 {
        return;
    }
    let turns: Vec<(usize, usize)> = freedoms
        .iter()
        .enumerate()
        .flat_map(|(joint, freedoms)| freedoms.iter().map(move |(_, channel)| (joint, *channel)))
        .enumerate()
        .filter(|(_, (_, channel))| matches!(channel, Channel::Rotation(_)))
        .map(|(at, (joint, _))| (at, joint))
        .collect();
    let step = |row: usize| {
        let steps =
            turns.iter().map(|(at, joint)| ((q[(row + 1) * nq + at] - q[row * nq + at]).abs(), *joint));
        steps.max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((0.0, 0))
    };
    let (jump, joint) = step(0);
    let after = (1..file.count - 1).map(|row| step(row).0).fold(0.0, f64::max);
    if jump > POSE.0 && jump > POSE.1 * after {
        let message = format!(
            "'{}' jumps by {:.0}° to the second frame, and no joint by more than {:.0}° after that: the first one is a reference pose that \
             a tool put in front; leave it out",
            figure.links()[joint].name(),
            jump.to_degrees(),
            after.to_degrees()
        );
        said.say(FindingKind::Suspect, "first frame", message, None);
    }
}
