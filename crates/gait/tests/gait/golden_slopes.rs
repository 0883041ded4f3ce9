//! Strides on slopes and stairs against the golden numbers of the recipe.

use crate::golden::{Differences, golden, golden_figure, number, read, recipe_table, vector};
use serde_json::Value;
use solaris_gait::{LegGeometry, Resolution, StridePlan, Style, WALK_RATIO};
use solaris_model::Figure;

fn slopes() -> Value {
    read(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/reference/slopes/golden.json"))
}

fn compare(figure: &Figure, golden: &Value, plan: &StridePlan, differences: &mut Differences) {
    let n = plan.node_count();
    let mut q = vec![0.0; figure.layout().nq()];
    for i in (0..100).filter(|i| (i * n).is_multiple_of(100)) {
        let (u, node) = (i as f64 / 100.0, i * n / 100 % n);
        assert!((number(&golden["u"][i]) - u).abs() < 1e-9);
        plan.configuration(u, &mut q);
        for axis in 0..3 {
            let place = |what: &'static str| move || format!("{what} {axis}, u = {u}");
            let pelvis = q[axis] - number(&golden["pelvis_pos"][i][axis]);
            differences.length.note(pelvis.abs(), place("pelvis"));
            let com = plan.com(node)[axis] - number(&golden["com"][i][axis]);
            differences.length.note(com.abs(), place("com"));
            let rate = plan.momentum_rate(node)[axis] - number(&golden["dH"][i][axis]);
            differences.force.note(rate.abs(), place("dH"));
        }
        differences.note_joints(figure, golden, i, &q);
        let (forces, support) = (plan.forces(node), plan.support(node));
        for (side, name) in ["left", "right"].into_iter().enumerate() {
            let of = |key: &str| &golden[format!("{key}_{name}")][i];
            differences
                .share
                .note((support[side].share - number(of("share"))).abs(), || format!("{name}, {u}"));
            differences
                .force
                .note((forces[side].force - vector(of("F"))).amax(), || format!("F {name}, {u}"));
            if support[side].share > 1e-6 {
                let cop = (forces[side].cop - vector(of("cop"))).amax();
                differences.length.note(cop, || format!("cop {name}, {u}"));
            }
        }
        let total = forces[0].force + forces[1].force;
        differences.force.note((total - vector(&golden["F_total"][i])).amax(), || format!("F, u = {u}"));
        let free: f64 = forces.iter().map(|f| (f.moment - f.cop.cross(&f.force)).y).sum();
        let wanted = number(&golden["free_moment_vertical"][i]);
        differences.force.note((free - wanted).abs(), || format!("free moment, u = {u}"));
    }
}

/// A figure of the recipe at this cadence, walking as long steps as people on level ground.
fn level(figure: &Figure, step_frequency: f64) -> (LegGeometry, Style) {
    let leg = LegGeometry::of(figure).expect("legs");
    let step_length = WALK_RATIO * 1.75 * step_frequency;
    let style = Style::from_table(&recipe_table(&golden()), &leg, 1.75, step_frequency, step_length);
    (leg, style)
}

#[test]
fn strides_on_slopes() {
    let (figure, slopes) = (golden_figure(&golden()), slopes());
    for (name, slope) in [("slope+10", 10.0_f64), ("slope-10", -10.0)] {
        let (leg, style) = level(&figure, 100.0);
        let style = style.on_slope(&leg, 1.75, slope.to_radians());
        let resolution = Resolution { nodes: 200, stride_passes: 10, ..Resolution::default() };
        let plan = StridePlan::new(&figure, &style, resolution).expect("a stride");
        let mut differences = Differences::default();
        compare(&figure, &slopes["strides"][name], &plan, &mut differences);
        println!("{name}:");
        differences.assert_below([1e-5, 1e-3, 0.01, 1e-6]);
    }
}

#[test]
fn strides_on_stairs() {
    let (figure, slopes) = (golden_figure(&golden()), slopes());
    let leg = LegGeometry::of(&figure).expect("legs");
    for (name, step_frequency, rise) in [("stairs_up", 88.0, 0.17), ("stairs_down", 100.0, -0.17)] {
        let style = Style::from_table(&recipe_table(&golden()), &leg, 1.75, step_frequency, 0.29);
        let style = style.on_stairs(&leg, 1.75, rise);
        let resolution = Resolution { nodes: 200, stride_passes: 10, ..Resolution::default() };
        let plan = StridePlan::new(&figure, &style, resolution).expect("a stride");
        let mut differences = Differences::default();
        compare(&figure, &slopes["strides"][name], &plan, &mut differences);
        println!("{name}:");
        differences.assert_below([1e-5, 1e-3, 0.01, 1e-6]);
    }
}
