//! External loads of OpenSim.

use solaris_io::{opensim, sto};
use solaris_model::Vector3;

fn force(name: &str, inner: &str) -> String {
    format!("<ExternalForce name=\"{name}\">{inner}</ExternalForce>")
}

fn loads(forces: &str) -> String {
    format!(
        "<OpenSimDocument Version=\"40000\"><ExternalLoads name=\"walk\"><objects>{forces}</objects>\
         <datafile>plates.mot</datafile></ExternalLoads></OpenSimDocument>"
    )
}

const RIGHT: &str = "<applied_to_body>/bodyset/calcn_r</applied_to_body>\
    <force_expressed_in_body>ground</force_expressed_in_body><point_expressed_in_body>/ground</point_expressed_in_body>\
    <force_identifier>ground_force_v</force_identifier><point_identifier>ground_force_p</point_identifier>\
    <torque_identifier>ground_torque_</torque_identifier>";

const TABLE: &str = "plates\nversion=1\nnRows=2\nnColumns=19\ninDegrees=yes\nendheader\n\
    time ground_force_vx ground_force_vy ground_force_vz ground_force_px ground_force_py ground_force_pz \
    1_ground_force_vx 1_ground_force_vy 1_ground_force_vz 1_ground_force_px 1_ground_force_py 1_ground_force_pz \
    ground_torque_x ground_torque_y ground_torque_z 1_ground_torque_x 1_ground_torque_y 1_ground_torque_z\n\
    0 1 2 3 0.5 0 -0.25 4 5 6 1 0 1 7 8 9 10 11 12\n\
    0.1 0 700 0 0.1 0 0 0 0 0 0 0 0 0 3 0 0 0 0\n";

#[test]
fn moments_are_about_the_origin_of_the_world() {
    let left = RIGHT.replace("ground_", "1_ground_").replace("calcn_r", "calcn_l");
    let text = loads(
        &(force("right", RIGHT)
            + &force("left", &left)
            + &force("off", "<appliesForce>false</appliesForce>")),
    );
    let loads = opensim::external_loads(&text).expect("loads");
    assert_eq!(loads.data_file.as_deref(), Some("plates.mot"));
    let table = sto::read(TABLE).expect("a table");
    let records = loads.records(&table).expect("its columns are there");
    assert_eq!(records.len(), 2);
    assert_eq!(records[0].links, ["calcn_r"]);
    assert_eq!(records[0].time, [0.0, 0.1]);
    let first = records[0].samples[0];
    assert_eq!(first.force, Vector3::new(1.0, 2.0, 3.0));
    // p × f = (0·3 + 0.25·2, −0.25·1 − 0.5·3, 0.5·2 − 0·1)
    assert_eq!(first.moment, Vector3::new(7.0 + 0.5, 8.0 - 1.75, 9.0 + 1.0));
    assert_eq!(first.cop, Vector3::new(0.5, 0.0, -0.25));
    assert_eq!(records[0].samples[1].moment, Vector3::new(0.0, 3.0, 70.0));
    // (1, 0, 1) × (4, 5, 6) = (−5, −2, 5)
    assert_eq!(records[1].samples[0].moment, Vector3::new(5.0, 9.0, 17.0));
}

#[test]
fn a_torque_alone_acts() {
    let text = loads(&force(
        "motor",
        "<applied_to_body>hand</applied_to_body><torque_identifier>ground_torque_</torque_identifier>",
    ));
    let records = opensim::external_loads(&text).expect("loads").records(&sto::read(TABLE).expect("a table"));
    let sample = records.expect("three columns")[0].samples[0];
    assert_eq!((sample.force, sample.moment), (Vector3::zeros(), Vector3::new(7.0, 8.0, 9.0)));
}

#[test]
fn faults_of_loads_are_told_by_name() {
    let cases = [
        "<a/>".to_owned(),
        loads(""),
        loads(&force("f", "")),
        loads(&force("f", "<applied_to_body>foot</applied_to_body><force_identifier>v</force_identifier>")),
        loads(
            &(force("right", &RIGHT.replace(">ground<", ">tibia_r<"))
                + &force("p", &RIGHT.replace("/ground", "/bodyset/toes_r"))),
        ),
        loads(&force("f", &RIGHT.replace("calcn_r", "").replace("/bodyset/", ""))),
        loads("<ExternalForce"),
    ];
    let said: Vec<String> =
        cases.iter().map(|text| opensim::external_loads(text).expect_err("wrong").to_string()).collect();
    let table = sto::read(TABLE).expect("a table");
    let unknown =
        [RIGHT.replace("ground_force_v", "ground_forse_v"), RIGHT.replace("ground_force_v", "ground_force_")];
    let wrong = unknown.map(|inner| {
        let loads = opensim::external_loads(&loads(&force("right", &inner))).expect("loads");
        loads.records(&table).expect_err("no three columns").to_string()
    });
    insta::assert_snapshot!(format!("{}\n---\n{}", said.join("\n---\n"), wrong.join("\n---\n")));
}
