//! Key postures as lines to be drawn.

use crate::thesis::determinants::{ArmAngles, Joints, KeyPhase, KeyPosture, KeySolution, Proportions, Root};

/// Lengths over the standing height: hips to shoulders, shoulders to the head's middle, the head's radius, upper arm, forearm with
/// the hand closed (after Drillis and Contini).
const TRUNK: [f64; 5] = [0.288, 0.115, 0.052, 0.186, 0.186];

/// The postures of the starting cycle's first and of all phases of the intermediate cycle, each with its lines: swing arm, swing
/// leg, trunk, head (middle and a point of its outline), stance leg, stance arm. Forward and up, on a ground at height 0.
pub fn stick_figures(p: &Proportions, solution: &KeySolution) -> Vec<(KeyPosture, Vec<Vec<[f64; 2]>>)> {
    let [starting, intermediate, _] = &solution.cycles;
    // A starting phase that only repeats one of the intermediate cycle is not drawn twice.
    let own =
        starting.iter().take(1).filter(|phase| !intermediate.iter().any(|other| other.end == phase.end));
    own.chain(intermediate).map(|phase| (phase.end, lines(p, phase))).collect()
}

fn lines(p: &Proportions, phase: &KeyPhase) -> Vec<Vec<[f64; 2]>> {
    let posture = phase.end;
    let root = usize::from(phase.root.swing);
    let up = if phase.root.point == Root::Ball { p.ball_height } else { 0.0 };
    let hip = posture.legs[root].hip_over(p, phase.root.point, [0.0, up]);
    let offset = posture.swing_hip(p);
    let stance_hip = if phase.root.swing { [hip[0] - offset[0], hip[1] - offset[1]] } else { hip };
    let [stance, swing] = posture.joints(p, stance_hip);
    let middle = [0.5 * (stance.hip[0] + swing.hip[0]), 0.5 * (stance.hip[1] + swing.hip[1])];
    let [trunk, neck, head, upper, fore] = TRUNK.map(|part| part * p.height);
    let leaned = |from: [f64; 2], length: f64| {
        [from[0] + length * posture.trunk.lean.sin(), from[1] + length * posture.trunk.lean.cos()]
    };
    let (shoulder, face) = (leaned(middle, trunk), leaned(middle, trunk + neck));
    let arm = |angles: ArmAngles| {
        let along = |from: [f64; 2], length: f64, flexed: f64| {
            [from[0] + length * flexed.sin(), from[1] - length * flexed.cos()]
        };
        let elbow = along(shoulder, upper, angles.shoulder);
        vec![shoulder, elbow, along(elbow, fore, angles.shoulder + angles.elbow)]
    };
    let leg =
        |joints: &Joints| vec![joints.hip, joints.knee, joints.ankle, joints.heel, joints.ball, joints.tip];
    vec![
        arm(posture.arms[1]),
        leg(&swing),
        vec![middle, shoulder],
        vec![face, [face[0] + head, face[1]]],
        leg(&stance),
        arm(posture.arms[0]),
    ]
}
