//! Running, against the golden numbers of its recipe and by laws that know no plan.

use crate::golden::{Differences, golden, golden_figure, number, running_golden, vector};
use serde_json::Value;
use solaris_gait::{RunResolution, RunStride, RunStyle};
use solaris_model::Figure;

fn compare(figure: &Figure, golden: &Value, stride: &RunStride, differences: &mut Differences) {
    let n = stride.node_count();
    let mut q = vec![0.0; figure.layout().nq()];
    let way = 2.0 * stride.style().step_length;
    for i in 0..=100 {
        let u = i as f64 / 100.0;
        stride.configuration(u, &mut q);
        for axis in 0..3 {
            let place = |what: &'static str| move || format!("{what} {axis}, u = {u}");
            let off = q[axis] - number(&golden["pelvis_pos"][i][axis]);
            differences.length.note(off.abs(), place("pelvis"));
            if (i * n).is_multiple_of(100) {
                let node = i * n / 100 % n;
                let wrapped = if i == 100 && axis == 2 { way } else { 0.0 };
                let off = stride.com(node)[axis] + wrapped - number(&golden["com"][i][axis]);
                differences.length.note(off.abs(), place("com"));
                let off = stride.angular_momentum(node)[axis] - number(&golden["angular_momentum"][i][axis]);
                differences.share.note(off.abs(), place("angular momentum"));
            }
        }
        differences.note_joints(figure, golden, i, &q);
        let (foot, toes) = stride.foot_pitches(u)[0];
        differences.note_pitches(golden, i, "left", (foot, toes));
        let forces = stride.forces(u);
        let mut free = 0.0;
        for (side, name) in ["left", "right"].into_iter().enumerate() {
            let (contact, wanted) = (forces[side], vector(&golden[format!("F_{name}")][i]));
            differences.force.note((contact.force - wanted).amax(), || format!("F {name}, u = {u}"));
            free += (contact.moment - contact.cop.cross(&contact.force)).y;
            if wanted.y > 1.0 {
                let cop = &golden[format!("cop_{name}")][i];
                for (found, wanted) in [(contact.cop.x, &cop[0]), (contact.cop.z, &cop[1])] {
                    differences
                        .length
                        .note((found - number(wanted)).abs(), || format!("cop {name}, u = {u}"));
                }
            }
        }
        differences.force.note((free - number(&golden["free_moment"][i])).abs(), || format!("T, u = {u}"));
    }
}

/// Limits of lengths (m), angles (degrees), forces (N and N m), momentum (N m s).
fn check(resolution: RunResolution, limits: [f64; 4]) {
    let golden = running_golden();
    let figure = golden_figure(&crate::golden::golden());
    for speed in [2.5, 3.5, 5.0] {
        let stride = RunStride::new(&figure, &RunStyle::of(1.75, speed), resolution).expect("a stride");
        let mut differences = Differences::default();
        compare(&figure, &golden["strides"][format!("{speed:.1}")], &stride, &mut differences);
        println!("{speed} m/s, {} nodes, {} passes:", resolution.nodes, resolution.passes);
        differences.assert_below(limits);
    }
}

#[test]
fn with_the_golden_discretisation() {
    check(RunResolution { nodes: 400, passes: 25 }, [2e-5, 2e-3, 0.1, 1e-3]);
}

#[test]
fn with_the_resolution_that_ships() {
    check(RunResolution::default(), [1e-3, 0.2, 20.0, 0.1]);
}
