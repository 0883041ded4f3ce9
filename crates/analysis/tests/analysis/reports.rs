//! Reports as JSON: the keys carry the units, the values are the fields'.

use serde_json::{Value, json};
use solaris_analysis::ground::{GroundOptions, PlacedFeet, Violation, ground_forces, soles};
use solaris_analysis::{InverseOptions, Loads, Peak, PreparedMotion, RootReport, inverse_motion, nearness};
use solaris_model::{Base, Figure, FigureBuilder, Joint, LinkSpec, Motion, MotionInfo, human};

/// The keys of an object, sorted.
fn keys(value: &Value) -> Vec<&str> {
    let mut keys: Vec<&str> = value.as_object().expect("an object").keys().map(String::as_str).collect();
    keys.sort_unstable();
    keys
}

/// Two frames of standing still, the root (if it is free) 0.9 m up.
fn still(figure: &Figure) -> Motion {
    let mut q = vec![0.0; figure.layout().nq()];
    if let Some(height) = q.get_mut(1) {
        *height = 0.9;
    }
    let rest = vec![0.0; 2 * figure.layout().nv()];
    let columns = [[q.clone(), q].concat(), rest.clone(), rest];
    Motion::new(figure, MotionInfo::on_earth(figure, 10.0), vec![0.0, 0.1], columns).expect("valid")
}

#[test]
fn joint_forces_are_written_by_name_and_unit() {
    let link = LinkSpec::root("base", Joint::new("ground")).mass(4.0);
    let lift = LinkSpec::child("load", "base", Joint::new("lift").ty()).mass(2.0);
    let held = FigureBuilder::new("lift").link(link).link(lift).build().expect("valid");
    for (figure, root) in [(&held, false), (&held.on_base(Base::Floating).expect("free"), true)] {
        let motion = still(figure);
        let prepared = PreparedMotion::new(figure, &motion).expect("ready");
        let report =
            inverse_motion(&prepared, &Loads::none(), InverseOptions::default()).expect("joint forces");
        let written = serde_json::to_value(&report).expect("written");
        assert_eq!(keys(&written), ["joints", "residual"]);
        let loads = written["joints"].as_array().expect("a list");
        let load = |dof: &str| loads.iter().find(|load| load["dof"] == dof).expect(dof);
        let weight = report.dofs.last().expect("the lift").rms;
        assert!((weight - 2.0 * 9.80665).abs() < 1e-9);
        let expected = json!({
            "dof": "lift.ty", "unit": "N", "rms": weight, "greatest": weight, "at_s": 0.0, "root": false,
        });
        assert_eq!(load("lift.ty"), &expected);
        if root {
            assert_eq!((&load("root.rx")["unit"], &load("root.rx")["root"]), (&json!("N m"), &json!(true)));
        }
        assert_eq!(
            keys(&written["residual"]),
            [
                "force_at_s",
                "force_greatest_n",
                "force_rms_n",
                "moment_at_s",
                "moment_greatest_nm",
                "moment_rms_nm"
            ]
        );
        assert_eq!(written["residual"]["force_rms_n"], json!(report.residual.force_rms));
        assert!((report.residual.force_rms - 6.0 * 9.80665).abs() < 1e-9);
    }
}

#[test]
fn the_ground_under_each_foot_is_written_with_its_sole() {
    let ann = human(1.65, 58.0).expect("a person");
    let motion = still(&ann);
    let prepared = PreparedMotion::new(&ann, &motion).expect("ready");
    let feet = PlacedFeet::new(&prepared, soles(&ann)).expect("placed");
    let found = ground_forces(&feet, &GroundOptions::default()).expect("forces");
    let written = serde_json::to_value(&found.report).expect("written");
    assert_eq!(keys(&written), ["elsewhere", "feet", "irregular_frames", "split", "unsupported", "weight_n"]);
    assert_eq!((&written["split"], &written["weight_n"]), (&json!("pivot"), &json!(found.report.weight)));
    assert_eq!(
        written["unsupported"],
        json!({"frames": 0, "force_rms_n": 0.0, "force_greatest_n": 0.0, "at_s": 0.0})
    );
    let (foot, told) = (&found.report.feet[0], &written["feet"][0]);
    assert_eq!(
        keys(told),
        [
            "cop_outside_m",
            "frames",
            "friction",
            "greatest_n",
            "greatest_of_weight",
            "least_n",
            "link",
            "name",
            "stances_s",
            "toes",
            "width_m"
        ]
    );
    assert_eq!((&told["link"], &told["toes"]), (&json!("left_foot"), &json!("left_toes")));
    assert_eq!(told["stances_s"], json!([[0.0, 0.1]]));
    assert!((foot.greatest_of_weight - 0.5).abs() < 1e-9);
    assert_eq!(told["greatest_of_weight"], json!(foot.greatest_of_weight));
    let least = foot.least.expect("it stands");
    assert_eq!(told["least_n"], json!({"worst": least.value, "at_s": least.time, "share": 0.0}));
}

#[test]
fn near_limbs_are_written_by_name() {
    let ann = human(1.65, 58.0).expect("a person");
    let motion = still(&ann);
    let found = nearness(&ann, &motion).expect("measured").expect("limbs");
    let limbs = found.limbs(&ann, motion.time());
    let written = serde_json::to_value(&limbs).expect("written");
    assert_eq!(keys(&written), ["at_s", "distance_m", "left_out", "links", "overlaps", "pairs", "spells"]);
    assert_eq!(written["distance_m"], json!(found.nearest.distance));
    let spell = json!({
        "links": found.nearest.links, "from_s": 0.0, "to_s": 0.1, "distance_m": found.nearest.distance, "at_s": 0.0,
    });
    assert_eq!(written["spells"], json!([spell]));
}

#[test]
fn lengths_of_violations_are_written_in_millimetres_and_roots_with_their_times() {
    let violation = Violation { frames: 3, outside: 0.25, pull: 2.0 };
    let written = serde_json::to_value(violation).expect("written");
    assert_eq!(written, json!({"frames": 3, "cop_outside_mm": 250.0, "pull_n": 2.0}));
    let roots = RootReport {
        roots: vec![("left_foot".to_owned(), 0.5)],
        reaction_force: 1.0,
        torque: 2.0,
        ..RootReport::default()
    };
    let written = serde_json::to_value(&roots).expect("written");
    let expected = json!({"links": [["left_foot", 0.5]], "force_differs_n": 1.0, "torque_differs_n_m": 2.0});
    assert_eq!(written, expected);
    let peak = Peak { value: 1.5, time: 0.25 };
    assert_eq!(serde_json::to_value(peak).expect("written"), json!({"value": 1.5, "at_s": 0.25}));
}
