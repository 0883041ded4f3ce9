//! Figures that lie on their side or stand on their head from beginning to end.

use super::MotionFinding;
use crate::prepared::each;
use nalgebra::Vector3;
use solaris_dynamics::{DynamicsError, Tree, Workspace, forward_kinematics};
use solaris_model::{AxisKind, Figure};

/// How far (rad) a figure may be turned from how it rests and still be upright: who bends over or sits turns the trunk by that, not
/// the legs below.
pub const TURNED: f64 = std::f64::consts::FRAC_PI_3;

/// Share of the frames in which it must be turned by more: who falls, rolls or gets up is not so all the time.
pub const TURNED_SHARE: f64 = 0.9;

/// Whether a figure that can turn in the world is turned from upright in nearly all frames of a motion, as one that was found in
/// recordings of which another way is up than was thought.
///
/// Every link carries along what was up (against `gravity`) while the figure was at `rest` (length `nq`); the mean of these
/// directions, weighed by the links' masses, is the figure's own up at `q` (`nq` a frame). That a person lies or hangs looks the same.
/// Nothing is found without gravity.
///
/// # Errors
///
/// A `rest` or `q` that is no configuration, and a figure that the kernel refuses.
///
/// # Examples
///
/// ```
/// use solaris_analysis::plausibility::check_upright;
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let trunk = LinkSpec::root("trunk", Joint::new("room").tx().ty().rz()).mass(30.0);
/// let figure = FigureBuilder::new("gymnast").link(trunk).build()?;
/// let gravity = Vector3::new(0.0, -9.81, 0.0);
/// let (stands, lies) = ([0.0, 1.0, 0.1, 0.3, 1.0, 0.2], [0.0, 0.2, 1.6, 0.3, 0.2, 1.5]);
/// assert_eq!(check_upright(&figure, &[0.0; 3], &stands, gravity)?, None);
/// assert!(check_upright(&figure, &[0.0; 3], &lies, gravity)?.is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn check_upright(
    figure: &Figure,
    rest: &[f64],
    q: &[f64],
    gravity: Vector3<f64>,
) -> Result<Option<MotionFinding>, DynamicsError> {
    let nq = figure.layout().nq();
    let Some(up) = (-gravity).try_normalize(0.0).filter(|_| can_turn(figure) && nq > 0) else {
        return Ok(None);
    };
    let tree = Tree::<f64>::new(figure, Vector3::zeros())?;
    let mut workspace = Workspace::new(&tree);
    forward_kinematics(&tree, &mut workspace, rest)?;
    let own: Vec<(f64, Vector3<f64>)> = figure
        .links()
        .iter()
        .enumerate()
        .map(|(link, it)| (it.mass(), workspace.pose(link).rotation.transpose() * up))
        .collect();
    let ups = each(
        0..q.len() / nq,
        || Workspace::new(&tree),
        |workspace, row| {
            forward_kinematics(&tree, workspace, &q[row * nq..][..nq])?;
            let carried = |(link, (mass, own)): (usize, &(f64, Vector3<f64>))| {
                workspace.pose(link).rotation * own * *mass
            };
            Ok::<_, DynamicsError>(own.iter().enumerate().map(carried).sum::<Vector3<f64>>())
        },
    )?;
    // A figure without mass, or one that is folded so that nothing of it is up, says nothing.
    let ups: Vec<Vector3<f64>> = ups.iter().filter_map(|up| up.try_normalize(1e-9)).collect();
    let angles: Vec<f64> = ups.iter().map(|own| own.angle(&up)).collect();
    let turned = angles.iter().filter(|angle| **angle > TURNED).count();
    if turned == 0 || (turned as f64) < TURNED_SHARE * angles.len() as f64 {
        return Ok(None);
    }
    let along = ups.iter().sum::<Vector3<f64>>().try_normalize(1e-9).unwrap_or_default();
    Ok(Some(MotionFinding::Turned {
        angle: angles.iter().sum::<f64>() / angles.len() as f64,
        along: along.into(),
        frames: turned,
        of: angles.len(),
    }))
}

/// Whether the root turns in the world; what is fixed there lies only where its joints lay it.
fn can_turn(figure: &Figure) -> bool {
    let layout = figure.layout();
    let root = layout.joints()[0].v;
    (root..root + figure.links()[0].joint().kind().nv())
        .any(|dof| layout.axis_kind(dof) == AxisKind::Rotation)
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris_model::{FigureBuilder, Joint, LinkSpec, human};
    use std::f64::consts::{FRAC_PI_2, PI};

    const DOWN: Vector3<f64> = Vector3::new(0.0, -9.81, 0.0);

    /// A person in `frames` frames, of whom coordinates are as `pose` says.
    fn found(frames: usize, pose: impl Fn(usize, &mut dyn FnMut(&str, f64))) -> Option<MotionFinding> {
        let figure = human(1.75, 73.0).expect("a person");
        let layout = figure.layout();
        let mut rest = vec![0.0; layout.nq()];
        figure.neutral(&mut rest).expect("a configuration");
        let mut q = Vec::new();
        for frame in 0..frames {
            let mut row = rest.clone();
            pose(frame, &mut |name, value| {
                let dof = layout.dof_index(name).expect("a coordinate");
                row[layout.coordinate(dof).expect("a place")] = value;
            });
            q.extend(row);
        }
        check_upright(&figure, &rest, &q, DOWN).expect("poses")
    }

    #[test]
    fn who_is_turned_by_quarters_is_found() {
        for (name, angle) in [("root.rz", FRAC_PI_2), ("root.rx", -FRAC_PI_2), ("root.rz", PI)] {
            let finding = found(20, |frame, set| set(name, angle + 0.01 * (frame as f64)));
            let Some(MotionFinding::Turned { angle: found, frames: 20, of: 20, .. }) = finding else {
                panic!("{name} {angle}: {finding:?}");
            };
            assert!((found - angle.abs()).abs() < 0.2, "{name} {angle}: {found}");
        }
    }

    #[test]
    fn who_turns_round_or_lies_for_a_while_is_not() {
        assert_eq!(found(20, |frame, set| set("root.ry", 0.3 * frame as f64)), None);
        assert_eq!(found(20, |frame, set| set("root.rz", if frame < 17 { FRAC_PI_2 } else { 0.0 })), None);
        let bows = found(20, |_, set| {
            set("root.rz", -1.4);
            set("left_hip.rz", 1.4);
            set("right_hip.rz", 1.4);
        });
        assert_eq!(bows, None);
    }

    /// Turned by just as much as is still upright, to some last bits.
    #[test]
    fn who_is_found_is_turned_by_more_than_is_upright() {
        let trunk = LinkSpec::root("trunk", Joint::new("room").rz()).mass(30.0);
        let figure = FigureBuilder::new("gymnast").link(trunk).build().expect("valid");
        let angle = |turned: f64| match check_upright(&figure, &[0.0], &[turned], DOWN).expect("poses") {
            Some(MotionFinding::Turned { angle, .. }) => Some(angle),
            _ => None,
        };
        assert_eq!((angle(TURNED - 1e-9), angle(TURNED + 1e-9).is_some()), (None, true));
        for bits in -8..=8 {
            let turned = TURNED + f64::from(bits) * f64::EPSILON;
            assert!(angle(turned).is_none_or(|angle| angle > TURNED), "{bits}");
        }
    }
}
