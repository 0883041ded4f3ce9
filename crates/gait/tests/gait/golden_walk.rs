//! Whole walks against the golden numbers of the recipe.

use crate::golden::{Differences, golden, golden_figure, number, recipe_table, vector};
use serde_json::Value;
use solaris_gait::{LegGeometry, Resolution, StridePlan, Style, WALK_RATIO, WalkNumbers, WalkPlan};
use solaris_model::{Figure, Vector3};

fn compare(figure: &Figure, golden: &Value, plan: &WalkPlan, differences: &mut Differences) {
    let (count, (first, _)) = plan.nodes();
    let mut q = vec![0.0; figure.layout().nq()];
    let clocks = golden["u"].as_array().expect("clocks");
    let mut compared = 0;
    let mut most_moved = 0.0_f64;
    for (i, clock) in clocks.iter().enumerate() {
        let u = number(clock);
        // The golden samples that fall on a node.
        let Some(node) = (first..count).find(|&node| (plan.clock(node) - u).abs() < 1e-9) else { continue };
        compared += 1;
        plan.configuration_at(u, &mut q);
        for axis in 0..3 {
            let place = |what: &'static str| move || format!("{what} {axis}, u = {u}");
            differences
                .length
                .note((q[axis] - number(&golden["pelvis_pos"][i][axis])).abs(), place("pelvis"));
            differences
                .length
                .note((plan.com(node)[axis] - number(&golden["com"][i][axis])).abs(), place("com"));
            let rate = plan.momentum_rate(node)[axis] - number(&golden["dH"][i][axis]);
            differences.force.note(rate.abs(), place("dH"));
        }
        differences.note_angles(figure, golden, i, &q, plan.foot_pitches(u));
        let (forces, support) = (plan.forces(node), plan.support(u));
        for (side, name) in ["left", "right"].into_iter().enumerate() {
            let of = |key: &str| &golden[format!("{key}_{name}")][i];
            differences
                .share
                .note((support[side].share - number(of("share"))).abs(), || format!("{name}, u = {u}"));
            let share = support[side].share;
            if share <= 1e-9 {
                continue;
            }
            // While the load shifts between standing feet the file's two centres of pressure do not add up to the one it
            // has solved for, and its two forces not to its total. Ours do: both feet are pressed elsewhere by `moved`, and
            // each force follows from that by the split's own formula.
            let cop = of("cop");
            let moved = forces[side].cop - Vector3::new(number(&cop[0]), 0.0, number(&cop[1]));
            let finish = u - (plan.steps() as f64 - 1.0) / 2.0;
            let d = plan.style().double_support;
            let shifting = u < d || finish > 0.5 + 0.5 * d;
            differences
                .length
                .note(if shifting { 0.0 } else { moved.amax() }, || format!("cop {name}, u = {u}"));
            most_moved = most_moved.max(moved.amax());
            let stiffness = (forces[0].force.y + forces[1].force.y) / (plan.style().pivot * plan.com(node).y);
            let theirs = forces[side].force + moved * (share * stiffness);
            differences.force.note((theirs - vector(of("F"))).amax(), || format!("F {name}, u = {u}"));
        }
        let total = forces[0].force + forces[1].force;
        differences.force.note((total - vector(&golden["F_total"][i])).amax(), || format!("F, u = {u}"));
        // The twist of the whole about the solved centre of pressure, which no split changes.
        let centre = support[0].cop * support[0].share + support[1].cop * support[1].share;
        let ours: f64 = forces.iter().map(|f| (f.moment - centre.cross(&f.force)).y).sum();
        let theirs: f64 = ["left", "right"]
            .iter()
            .map(|name| {
                let (cop, force) =
                    (&golden[format!("cop_{name}")][i], vector(&golden[format!("F_{name}")][i]));
                (Vector3::new(number(&cop[0]), 0.0, number(&cop[1])) - centre).cross(&force).y
            })
            .sum();
        let theirs = theirs + number(&golden["free_moment"][i]);
        differences.force.note((ours - theirs).abs(), || format!("twist, u = {u}"));
    }
    assert!(compared >= clocks.len() / 2, "only {compared} samples were compared");
    println!(
        "{compared} samples, centres of pressure moved by at most {:.1} mm while the load shifts",
        most_moved * 1e3
    );
    assert!(most_moved < 0.01, "{most_moved}");
}

fn check(resolution: Resolution, limits: [f64; 4]) {
    let golden = golden();
    let figure = golden_figure(&golden);
    let leg = LegGeometry::of(&figure).expect("legs");
    let style = Style::from_table(&recipe_table(&golden), &leg, 1.75, 110.0, WALK_RATIO * 1.75 * 110.0);
    // The golden walks start from the golden stride of 200 nodes and 10 passes.
    let stride = StridePlan::new(&figure, &style, resolution).expect("a stride");
    for steps in [1, 2, 4] {
        let plan = WalkPlan::with_numbers(&stride, steps, WalkNumbers::recipe(), resolution).expect("a walk");
        let golden = &golden["walks"][format!("110_n{steps}")];
        let mut differences = Differences::default();
        compare(&figure, golden, &plan, &mut differences);
        let (sagittal, lateral) = plan.amplitudes();
        for i in 0..2 {
            let along = number(&golden["amplitudes"]["sagittal_start_end"][i]);
            differences.length.note((sagittal[i] - along).abs(), || format!("amplitude {i}"));
            let across = number(&golden["amplitudes"]["lateral_start_end"][i]);
            differences.share.note((lateral[i] - across).abs(), || format!("lateral amplitude {i}"));
        }
        for (k, correction) in plan.height_corrections().iter().enumerate() {
            let wanted = number(&golden["height_corrections"][k]);
            differences.length.note((correction - wanted).abs(), || format!("height correction {k}"));
        }
        println!("{steps} steps, {} nodes, {} passes:", resolution.nodes, resolution.walk_passes);
        differences.assert_below(limits);
    }
}

#[test]
fn with_the_golden_discretisation() {
    check(Resolution { nodes: 200, stride_passes: 10, walk_passes: 14 }, [1e-5, 1e-3, 0.1, 1e-6]);
}

#[test]
fn with_the_resolution_that_ships() {
    check(Resolution::default(), [2e-4, 0.6, 25.0, 1e-5]);
}
