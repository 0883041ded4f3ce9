//! The stride against the golden numbers of the recipe.

use crate::golden::{Differences, golden, golden_figure, number, recipe_table, vector};
use serde_json::Value;
use solaris_gait::{LegGeometry, Resolution, StridePlan, Style, WALK_RATIO};
use solaris_model::Figure;

fn compare(figure: &Figure, golden: &Value, plan: &StridePlan, differences: &mut Differences) {
    let n = plan.node_count();
    let mut q = vec![0.0; figure.layout().nq()];
    let step = plan.style().step_length;
    // The golden samples that fall on a node.
    for i in (0..=40).filter(|i| (i * n).is_multiple_of(40)) {
        let (u, node) = (i as f64 / 40.0, i * n / 40 % n);
        plan.configuration(u, &mut q);
        let wrapped = if i == 40 { 2.0 * step } else { 0.0 };
        for axis in 0..3 {
            let shift = if axis == 2 { wrapped } else { 0.0 };
            let place = |what: &'static str| move || format!("{what} {axis}, u = {u}");
            differences
                .length
                .note((q[axis] - number(&golden["pelvis_pos"][i][axis])).abs(), place("pelvis"));
            let com = plan.com(node)[axis] + shift;
            differences.length.note((com - number(&golden["com"][i][axis])).abs(), place("com"));
            let rate = plan.momentum_rate(node)[axis] - number(&golden["dH"][i][axis]);
            differences.force.note(rate.abs(), place("dH"));
        }
        differences.note_angles(figure, golden, i, &q, plan.foot_pitches(u));
        let (forces, support) = (plan.forces(node), plan.support(node));
        for (side, name) in ["left", "right"].into_iter().enumerate() {
            let of = |key: &str| &golden[format!("{key}_{name}")][i];
            differences
                .share
                .note((support[side].share - number(of("share"))).abs(), || format!("{name}, u = {u}"));
            differences
                .force
                .note((forces[side].force - vector(of("F"))).amax(), || format!("F {name}, u = {u}"));
            if support[side].share > 1e-9 {
                let (x, z) = (forces[side].cop.x, forces[side].cop.z + wrapped);
                differences
                    .length
                    .note((x - number(&of("cop")[0])).abs(), || format!("cop x {name}, u = {u}"));
                differences
                    .length
                    .note((z - number(&of("cop")[1])).abs(), || format!("cop z {name}, u = {u}"));
            }
        }
        let total = forces[0].force + forces[1].force;
        differences.force.note((total - vector(&golden["F_total"][i])).amax(), || format!("F, u = {u}"));
        let free: f64 = forces.iter().map(|f| (f.moment - f.cop.cross(&f.force)).y).sum();
        differences
            .force
            .note((free - number(&golden["free_moment"][i])).abs(), || format!("free moment, u = {u}"));
    }
}

fn check(resolution: Resolution, limits: [f64; 4]) {
    let golden = golden();
    let figure = golden_figure(&golden);
    let leg = LegGeometry::of(&figure).expect("legs");
    let table = recipe_table(&golden);
    for step_frequency in [80.0, 95.0, 110.0, 125.0] {
        let step_length = WALK_RATIO * 1.75 * step_frequency;
        let style = Style::from_table(&table, &leg, 1.75, step_frequency, step_length);
        let plan = StridePlan::new(&figure, &style, resolution).expect("a stride");
        let mut differences = Differences::default();
        compare(&figure, &golden["strides"][format!("{step_frequency}")], &plan, &mut differences);
        println!(
            "{step_frequency} steps/min, {} nodes, {} passes:",
            resolution.nodes, resolution.stride_passes
        );
        differences.assert_below(limits);
    }
}

#[test]
fn with_the_golden_discretisation() {
    check(Resolution { nodes: 200, stride_passes: 10, ..Resolution::default() }, [1e-5, 1e-3, 0.1, 1e-6]);
}

#[test]
fn with_the_resolution_that_ships() {
    check(Resolution::default(), [1e-4, 0.1, 15.0, 1e-6]);
}

/// The style's numbers are those of the table, with the recipe's names.
#[test]
fn the_style_is_the_golden_one() {
    let golden = golden();
    let leg = LegGeometry::of(&golden_figure(&golden)).expect("legs");
    let table = recipe_table(&golden);
    let names = [
        ("theta", "heel_strike_angle"),
        ("a1", "height1"),
        ("kc2", "knee_contact_acc"),
        ("kto", "knee_toe_off"),
        ("toe", "toe_roll"),
        ("se", "share_exponent"),
        ("utk", "tip_roll"),
        ("vpp", "pivot"),
        ("w", "step_width"),
        ("d", "double_support"),
        ("T", "stride_time"),
        ("S", "step_length"),
        ("clear", "clearance"),
    ];
    for step_frequency in ["80", "95", "110", "125"] {
        let sf: f64 = step_frequency.parse().expect("a number");
        let style = Style::from_table(&table, &leg, 1.75, sf, WALK_RATIO * 1.75 * sf);
        let debug = format!("{style:?}");
        for (theirs, ours) in names {
            let wanted = number(&golden["strides"][step_frequency]["parameters"][theirs]);
            let wanted = if theirs == "clear" { wanted * 1.75 / 1.741 } else { wanted };
            let found = debug.split_once(&format!("{ours}: ")).expect(ours).1;
            let found: f64 = found.split([',', ' ']).next().expect("a number").parse().expect("a number");
            assert!(
                (found - wanted).abs() < 1e-6 * wanted.abs().max(1.0),
                "{ours} at {step_frequency}: {found} is not {wanted}"
            );
        }
    }
}
