//! Records of states and forces from tables.

use crate::motions::{Full, full_human};
use solaris_io::record::ForceHeadings;
use solaris_io::{CoordinateDefault, IoError, Table, csv, record, sto};
use solaris_model::{Contact, ContactTrack, Curve, Figure, FigureBuilder, Joint, LinkSpec, Vector3};
use std::f64::consts::FRAC_PI_2;

fn table(text: &str) -> Table {
    csv::read_table(text).expect("a table")
}

/// A leg whose knee slides as it bends, on a pelvis that slides and tilts.
fn leg() -> Figure {
    let root = Joint::new("ground_pelvis").tx().named("pelvis_tx").rz().named("pelvis_tilt");
    let knee = Joint::new("knee_r").tx().named("slide").following("knee_angle_r", Curve::linear(0.5, 0.1));
    let knee = knee.rz().named("knee_angle_r");
    FigureBuilder::new("leg")
        .link(LinkSpec::root("pelvis", root).mass(1.0))
        .link(LinkSpec::child("shank", "pelvis", knee).mass(1.0))
        .link(LinkSpec::child("foot", "shank", Joint::new("ankle_r").rz().named("ankle_angle_r")).mass(1.0))
        .build()
        .expect("valid")
}

/// A thrown body with an arm on a ball joint.
fn thrown() -> Figure {
    FigureBuilder::new("thrown")
        .link(LinkSpec::root("body", Joint::free("root")).mass(1.0))
        .link(LinkSpec::child("arm", "body", Joint::ball("shoulder")).mass(1.0))
        .link(LinkSpec::child("hand", "arm", Joint::new("wrist").rx()).mass(1.0))
        .build()
        .expect("valid")
}

#[test]
fn opensim_degrees_are_for_what_turns() {
    let mut given = table(
        "time,ankle_angle_r,knee_angle_r,pelvis_tx,pelvis_tilt,emg\n0,90,-90,1.5,45,3\n0.1,0,180,2,0,3\n",
    );
    given.in_degrees = Some(true);
    let found = record::read(&leg(), Vector3::zeros(), &given).expect("all there");
    let pi = FRAC_PI_2 * 2.0;
    let expected = [1.5, pi / 4.0, 0.1 - 0.25 * pi, -FRAC_PI_2, FRAC_PI_2, 2.0, 0.0, 0.1 + 0.5 * pi, pi, 0.0];
    assert_eq!(found.motion.columns()[0], expected);
    assert_eq!(found.motion.known().v, [false; 5]);
    assert_eq!(found.ignored, ["emg"]);
    given.in_degrees = Some(false);
    assert_eq!(
        record::read(&leg(), Vector3::zeros(), &given).expect("all there").motion.q(0)[3].to_bits(),
        (-90.0_f64).to_bits()
    );
}

#[test]
fn velocities_and_accelerations_are_optional_for_each_coordinate() {
    let text = "knee_angle_r.q,time,pelvis_tx.q,pelvis_tilt.q,pelvis_tilt.v,ankle_r.q,ankle_r.v,ankle_r.a,foot.fx,slide.q,note\n\
                0.2,0,1,2,3,4,5,6,7,8,9\n";
    let found = record::read(&leg(), Vector3::zeros(), &table(text)).expect("all there");
    let motion = found.motion;
    assert_eq!((motion.q(0), motion.v(0)), (&[1.0, 2.0, 0.2, 0.2, 4.0][..], &[0.0, 3.0, 0.0, 0.0, 5.0][..]));
    assert_eq!(motion.known().v, [false, true, false, false, true]);
    assert_eq!((&*motion.known().a, motion.a(0)[4]), (&[false, false, false, false, true][..], 6.0));
    assert_eq!(found.ignored[0], "note");
    assert!(
        found.ignored[1].starts_with("slide (it follows knee_angle_r, and is off by"),
        "{:?}",
        found.ignored
    );
}

#[test]
fn unrelated_states_need_no_time() {
    let text = "wrist.q,wrist.v,wrist.a\n1,2,3\n-4,5,6\n";
    let figure = FigureBuilder::new("f")
        .link(LinkSpec::root("hand", Joint::new("wrist").rx()).mass(1.0))
        .build()
        .expect("valid");
    let record = record::read(&figure, Vector3::zeros(), &table(text)).expect("states").motion;
    assert_eq!(record.time(), [0.0, 1.0]);
    assert_eq!(record.columns(), [&[1.0, -4.0][..], &[2.0, 5.0], &[3.0, 6.0]]);
    let error = record::read(&figure, Vector3::zeros(), &table("wrist.q,wrist.v\n1,2\n"))
        .expect_err("no accelerations");
    assert!(error.to_string().contains("missing: 'wrist.rx.a'"), "{error}");
}

#[test]
fn unrelated_states_may_have_any_times() {
    let states = "time,elbow.q,elbow.v,elbow.a\n3,0.1,0.2,0.3\n1,0.4,0.5,0.6\n1,0.7,0.8,0.9\n";
    let arm = LinkSpec::root("arm", Joint::new("elbow").rx()).mass(1.0);
    let figure = FigureBuilder::new("arm").link(arm).build().expect("valid");
    let recorded = record::read(&figure, Vector3::zeros(), &table(states)).expect("states");
    assert_eq!(recorded.motion.time(), [3.0, 1.0, 1.0]);
    // Where something has to be differentiated, times rise.
    let error = record::read(&figure, Vector3::zeros(), &table("time,elbow.q\n3,0.1\n1,0.4\n"))
        .expect_err("back in time");
    assert!(error.to_string().starts_with("line 3"), "{error}");
}

#[test]
fn headings_of_opensims_states_are_understood() {
    let knee =
        Joint::new("knee").tx().following("bend", Curve::Polynomial(vec![0.0, 0.0, 1.0])).rz().named("bend");
    let figure =
        FigureBuilder::new("leg").link(LinkSpec::root("leg", knee).mass(1.0)).build().expect("valid");
    let states = table(
        "time,/jointset/knee/bend/value,/jointset/knee/bend/speed,/forceset/soleus/activation\n0,0.5,2,0.1\n0.1,0.6,2,0.2\n",
    );
    let recorded = record::read(&figure, Vector3::zeros(), &states).expect("states");
    assert_eq!(recorded.motion.columns()[..2], [&[0.25, 0.5, 0.36, 0.6][..], &[2.0, 2.0, 2.4, 2.0]]);
    assert_eq!(recorded.motion.known().v, [true, true]);
    assert_eq!(recorded.ignored, ["/forceset/soleus/activation"]);
    // A follower's own column is not used; where it says something else, that is said.
    let off = table("time,bend,knee.tx\n0,0.5,0.25\n0.1,0.6,0.86\n");
    assert_eq!(
        record::read(&figure, Vector3::zeros(), &off).expect("states").ignored,
        ["knee.tx (it follows bend, and is off by up to 5.0e-1)"]
    );
}

/// OpenSim 4 leaves the coordinates of kneecaps in radians in a table in degrees; before, they were in degrees.
#[test]
fn a_kneecap_may_be_in_radians_in_a_table_in_degrees() {
    let knee =
        Joint::new("knee").rz().named("bend").rx().named("beta").following("bend", Curve::linear(1.0, 0.0));
    let figure =
        FigureBuilder::new("leg").link(LinkSpec::root("leg", knee).mass(1.0)).build().expect("valid");
    let ignored = |beta: &str| {
        let text = format!(
            "t\nnRows=2\nnColumns=3\ninDegrees=yes\nendheader\ntime bend beta\n0 0 0\n0.1 30 {beta}\n"
        );
        let table = solaris_io::sto::read(&text).expect("a table");
        record::read(&figure, Vector3::zeros(), &table).expect("states").ignored
    };
    assert!(ignored("0.5235988").is_empty() && ignored("30").is_empty());
    assert_eq!(ignored("1"), ["beta (it follows bend, and is off by up to 4.8e-1)"]);
}

#[test]
fn the_table_of_a_motion_is_its_record() {
    let (figure, motion) = full_human();
    let mut text = Vec::new();
    csv::write(&figure, &motion, &mut text).expect("a vector");
    let table = table(&String::from_utf8(text).expect("text"));
    let found = record::read(&figure, Vector3::zeros(), &table).expect("all there");
    assert!(found.ignored.is_empty());
    assert!(found.motion.known().is_all());
    assert_eq!(found.motion.time(), motion.time());
    for row in 0..motion.len() {
        assert_eq!(found.motion.q(row), motion.q(row));
        assert_eq!(found.motion.a(row), motion.a(row));
    }
    for track in &motion.contacts {
        let forces =
            record::forces(&table, std::slice::from_ref(&track.link), &track.link).expect("its columns");
        assert_eq!(forces.samples, track.samples);
        assert_eq!(forces.time, motion.time());
    }
    // The other writer's errors are the caller's: nothing here holds a file.
    let mut full = Full { left: 10 };
    assert!(matches!(csv::write_table(&table, &mut full), Err(IoError::Write(_))));
}

const GRF: &str = "time,ground_force_vx,ground_force_vy,ground_force_vz,ground_force_px,ground_force_py,ground_force_pz,\
    1_ground_force_vx,1_ground_force_vy,1_ground_force_vz,1_ground_force_px,1_ground_force_py,1_ground_force_pz,\
    ground_torque_x,ground_torque_y,ground_torque_z,1_ground_torque_x,1_ground_torque_y,1_ground_torque_z";

#[test]
fn torques_of_opensim_are_about_the_center_of_pressure() {
    let text = format!(
        "{GRF}\n0,1,2,3,4,5,6,0,0,0,0,0,0,10,20,30,0,0,0\n0.1,0,700,0,0.5,0,-0.1,7,8,9,0,1,0,0,1,0,0,0,0\n"
    );
    let right = record::forces(&table(&text), &["calcn_r".to_owned()], "").expect("empty prefix");
    // (4, 5, 6) × (1, 2, 3) = (3, −6, 3)
    assert_eq!(right.samples[0].moment, Vector3::new(13.0, 14.0, 33.0));
    assert_eq!(right.samples[0].cop, Vector3::new(4.0, 5.0, 6.0));
    // (0.5, 0, −0.1) × (0, 700, 0) = (70, 0, 350)
    assert_eq!(right.samples[1].moment, Vector3::new(70.0, 1.0, 350.0));
    let left = record::forces(&table(&text), &["calcn_l".to_owned()], "1_").expect("prefix");
    assert_eq!(left.samples[1].force, Vector3::new(7.0, 8.0, 9.0));
    assert_eq!(left.samples[1].moment, Vector3::new(9.0, 0.0, -7.0));
    assert_eq!(record::force_prefixes(&table(&text)), ["", "1_"]);
}

/// Each of the ways in which files head their forces: as it is asked for, and the headings of force, point and torque.
#[test]
fn forces_have_many_names() {
    let cases = [
        ("", "ground_force_v", "ground_force_p", "ground_torque_"),
        ("1_", "1_ground_force_v", "1_ground_force_p", "1_ground_torque_"),
        ("1", "1_ground_force_v", "1_ground_force_p", "1_ground_torque_"),
        ("R", "R_ground_force_v", "R_ground_force_p", "R_ground_torque_"),
        ("l_", "l_ground_force_v", "l_ground_force_p", "l_ground_moment_"),
        ("r", "ground_force_r_v", "ground_force_r_p", "ground_torque_r_"),
        ("1", "ground_force_1_v", "ground_force_1_p", "ground_force_1_m"),
        ("2", "ground_force_2_v", "ground_force_2_p", "ground_moment_2_m"),
        ("calcn_l", "ground_force_calcn_l_v", "ground_force_calcn_l_p", "ground_torque_calcn_l_"),
        ("1", "ground_force1_v", "ground_force1_p", "ground_torque1_"),
        ("right_foot", "right_foot_force_v", "right_foot_force_p", "right_foot_torque_"),
        ("head", "head_v", "head_p", "head_torque_"),
    ];
    for (asked, force, point, torque) in cases {
        let names = [force, point, torque]
            .into_iter()
            .flat_map(|name| ["x", "y", "z"].map(|axis| format!("{name}{axis}")));
        let columns: Vec<String> = std::iter::once("time".to_owned()).chain(names).collect();
        let numbers = "\t0\t1\t2\t3\t4\t5\t6\t7\t8\t9";
        let text = format!("t\nendheader\n{}\n{}\n", columns.join("\t"), numbers.trim_start());
        let table = sto::read(&text).expect("a table");
        let found = record::forces(&table, &["foot".to_owned()], asked)
            .unwrap_or_else(|error| panic!("{force}: {error}"));
        let contact = &found.samples[0];
        assert_eq!(contact.force, Vector3::new(1.0, 2.0, 3.0), "{force}");
        assert_eq!(contact.cop, Vector3::new(4.0, 5.0, 6.0), "{force}");
        // (4, 5, 6) × (1, 2, 3) = (3, −6, 3)
        assert_eq!(contact.moment, Vector3::new(10.0, 2.0, 12.0), "{torque}");
        let prefixes = record::force_prefixes(&table);
        assert_eq!(prefixes.len(), 1, "{force}: {prefixes:?}");
        assert_eq!(prefixes[0].trim_end_matches('_'), asked.trim_end_matches('_'), "{force}");
    }
}

#[test]
fn forces_that_are_not_there_are_answered_with_those_that_are() {
    let answer = |headings: &str, asked: &str| {
        let row = headings.split(' ').map(|_| "0").collect::<Vec<_>>().join(" ");
        let table = sto::read(&format!("t\nendheader\n{headings}\n{row}\n")).expect("a table");
        record::forces(&table, &["foot".to_owned()], asked).expect_err("not there").to_string()
    };
    let two = "time ground_force_r_vx ground_force_r_vy ground_force_r_vz ground_force_l_vx";
    assert!(answer(two, "right").ends_with("its prefixes are 'r', 'l'"), "{}", answer(two, "right"));
    let plain = answer("time Fx1 Fy1 Fz1", "");
    assert!(plain.ends_with("the table holds no forces, but 'Fx1', 'Fy1', 'Fz1' …"), "{plain}");
    let points = answer(two, "r");
    assert!(points.contains("'ground_force_r_px'") && points.contains("missing"), "{points}");
    let twice =
        "ground_force_vx ground_force_vy ground_force_vz ground_force_px ground_force_py ground_force_pz";
    let twice = answer(&format!("time {twice} {twice}"), "");
    assert!(twice.contains("'ground_force_vx' is also the heading of column 2"), "{twice}");
}

#[test]
fn rows_that_repeat_a_time_are_left_out_and_noted() {
    let text = "time,knee_angle_r.q,pelvis_tx.q,pelvis_tilt.q,ankle_angle_r.q\n0,1,2,3,4\n0.1,1,2,3,4\n0.1,9,9,9,9\n";
    let table = csv::read_table(text).expect("a table");
    let read = record::read(&leg(), Vector3::zeros(), &table).expect("a motion");
    assert_eq!((read.motion.len(), read.notes.len()), (2, 1));
    assert_eq!(read.notes[0].to_string(), "one row repeats the time before (line 4 is the first), left out");
}

#[test]
fn missing_coordinates_are_where_the_model_has_them() {
    let default = |name: &str, value, is_locked| CoordinateDefault {
        name: name.to_owned(),
        value,
        is_locked,
        is_clamped: false,
    };
    let all = ["pelvis_tx", "pelvis_tilt", "knee_angle_r", "ankle_angle_r"];
    let read = |columns: &[&str], defaults: &[CoordinateDefault]| {
        let numbers = columns.iter().map(|_| "\t90").collect::<String>();
        let text =
            format!("t\ninDegrees=yes\nendheader\ntime\t{}\n0{numbers}\n1{numbers}\n", columns.join("\t"));
        record::read_with_defaults(&leg(), Vector3::zeros(), &sto::read(&text).expect("a table"), defaults)
    };
    let defaults = [default("ankle_angle_r", 0.25, true), default("pelvis_tx", -0.5, false)];
    let found = read(&all[1..3], &defaults).expect("the rest is known");
    let q =
        |name: &str| found.motion.q(1)[leg().layout().q_names().iter().position(|q| q == name).expect("one")];
    assert_eq!((q("ankle_angle_r"), q("pelvis_tx")), (0.25, -0.5), "never in degrees");
    assert_eq!(
        found.notes[0].to_string().matches("'ankle_angle_r' (0.25, locked)").count(),
        1,
        "{}",
        found.notes[0]
    );
    // Misspelt, not missing.
    let misspelt = read(&["pelvis_xt", "pelvis_tilt", "knee_angle_r", "ankle_angle_r"], &defaults);
    let misspelt = misspelt.expect_err("misspelt").to_string();
    assert!(misspelt.contains("'pelvis_tx'"), "{misspelt}");
    // Of another figure, and without a default: all missing ones are named.
    let few =
        read(&["pelvis_tilt"], &[default("pelvis_tx", 0.0, false), default("knee_angle_r", 0.0, false)]);
    let few = few.expect_err("of another figure").to_string();
    assert!(
        few.contains("pelvis_tx") && few.contains("knee_angle_r") && few.contains("ankle_angle_r"),
        "{few}"
    );
}

#[test]
fn mistakes_in_states_are_answered() {
    let unit = "0,0,0,0,0,0,1";
    let thrown_head = "time,root.px.q,root.py.q,root.pz.q,root.qx.q,root.qy.q,root.qz.q,root.qw.q,\
                       shoulder.qx.q,shoulder.qy.q,shoulder.qz.q,shoulder.qw.q,wrist.q";
    let good = "time,knee_angle_r.q,pelvis_tx.q,pelvis_tilt.q,ankle_angle_r.q";
    let cases: [(Figure, String); 15] = [
        (leg(), "time,knee_r.q,pelvis_tx.q,pelvis_tilt.q,ankle_angle_r.q\n0,1,2,3,4\n".to_owned()),
        (leg(), "time,knee_angle_r.v\n0,1\n".to_owned()),
        (leg(), "time,knee_angle_l,pelvis_tx,pelvis_tilt\n0,1,2,3\n".to_owned()),
        (leg(), "pelvis_tx,pelvis_tilt,knee_angle_r,ankle_angle_r\n0,1,2,3\n".to_owned()),
        (leg(), format!("{good},hip.q\n0,1,2,3,4,5\n")),
        (leg(), format!("{good},ankle_angel_r.v\n0,1,2,3,4,5\n")),
        (leg(), format!("{good},hip.tau\n0,1,2,3,4,5\n")),
        (leg(), format!("{good},ankle_r.q\n0,1,2,3,4,5\n")),
        (leg(), format!("{good}\n0.5,1,2,3,4\n0.25,1,2,3,4\n")),
        (leg(), format!("{good}\n")),
        (thrown(), format!("{thrown_head}\n0,{unit},0,0,0,0.99,0\n")),
        (thrown(), format!("{thrown_head},shoulder.wx.v\n0,{unit},0,0,0,1,0,7\n")),
        (thrown(), format!("{}\n0,{unit},0,0,1,0\n", thrown_head.replace(",shoulder.qz.q", ""))),
        (thrown(), "time,root.px,root.py,root.pz\n0,1,2,3\n".to_owned()),
        (full_human().0, "time,left_knee.rx.q\n0,1\n".to_owned()),
    ];
    let answers = cases.map(|(figure, text)| match record::read(&figure, Vector3::zeros(), &table(&text)) {
        Ok(found) => format!("ACCEPTED, without {:?}", found.ignored),
        Err(error) => error.to_string(),
    });
    insta::assert_snapshot!(answers.join("\n"));
}

#[test]
fn mistakes_in_forces_are_answered() {
    let zeros = format!("{}0", "0,".repeat(18));
    let toes = ["foot".to_owned(), "toes".to_owned()];
    let cases = [
        (format!("{GRF}\n{zeros}\n"), &toes[..1], "2_"),
        (format!("{}\n{zeros}\n", GRF.replacen("force_vz", "force_v3", 1)), &toes[..1], ""),
        (format!("{}\n{zeros}\n", GRF.replacen("torque_y", "torque_Y", 1)), &toes[..1], ""),
        (format!("{}\n{zeros}\n", GRF.replacen("time", "t", 1)), &toes[..1], "1_"),
        (format!("{GRF}\n"), &toes[..1], ""),
        (format!("{GRF}\n{zeros}\n{zeros}\n"), &toes[..1], ""),
        (
            "time,foot.fx,foot.fy,foot.fz,foot.mx,foot.my,foot.mz\n0,1,2,3,4,5,6\n".to_owned(),
            &toes[..],
            "foot",
        ),
        (
            "time,foot.fx,foot.fy,foot.fz,foot.mx,foot.my,foot.mz\n0,1,2,3,4,5,6\n".to_owned(),
            &toes[..1],
            "foot",
        ),
        ("time,knee.q\n0,1\n".to_owned(), &toes[..1], "foot"),
    ];
    let answers = cases.map(|(text, links, prefix)| match record::forces(&table(&text), links, prefix) {
        Ok(_) => "ACCEPTED".to_owned(),
        Err(error) => error.to_string(),
    });
    insta::assert_snapshot!(answers.join("\n"));
}

#[test]
fn forces_that_are_written_are_read_again() {
    let vector = |i: usize, scale: f64| {
        Vector3::new(1.1 * i as f64 - 3.0, 0.7 / (i as f64 + 1.0), 2.3 - i as f64) * scale
    };
    let contact =
        |i: usize| Contact { force: vector(i, 300.0), moment: vector(i + 2, 90.0), cop: vector(i + 5, 0.1) };
    // The last is of a foot in the air.
    let samples: Vec<Contact> = (0..7).map(contact).chain([Contact::default()]).collect();
    let tracks =
        ["calcn_r", "calcn_l"].map(|link| ContactTrack { link: link.to_owned(), samples: samples.clone() });
    let time: Vec<f64> = (0..8).map(|i| 0.1 * f64::from(i)).collect();
    for (headings, prefix) in [(ForceHeadings::Solaris, "calcn_l"), (ForceHeadings::OpenSim, "calcn_l_")] {
        let written = record::force_table(headings, &time, &tracks).expect("finite");
        let mut text = Vec::new();
        let read = match headings {
            ForceHeadings::Solaris => {
                csv::write_table(&written, &mut text).expect("written");
                csv::read_table(std::str::from_utf8(&text).expect("text"))
            }
            ForceHeadings::OpenSim => {
                sto::write(&written, &mut text).expect("written");
                sto::read(std::str::from_utf8(&text).expect("text"))
            }
        };
        let read = read.expect("a table");
        assert_eq!((read.columns.len(), &read.values), (19, &written.values));
        let found = record::forces(&read, &["foot".to_owned()], prefix).expect("forces");
        assert_eq!(found.time, time);
        for (found, given) in found.samples.iter().zip(&samples) {
            assert_eq!((found.force, found.cop), (given.force, given.cop));
            let off = (found.moment - given.moment).norm();
            // Ours are the same bits; OpenSim's moments are about another point.
            let rounding = 4.0 * f64::EPSILON * (given.moment.norm() + given.cop.norm() * given.force.norm());
            assert!(off <= if headings == ForceHeadings::Solaris { 0.0 } else { rounding }, "{off:e}");
        }
    }
}

#[test]
fn forces_that_do_not_fit_are_not_written() {
    let track = |name: &str, count: usize| ContactTrack {
        link: name.to_owned(),
        samples: vec![Contact::default(); count],
    };
    let refused = |time: &[f64], tracks: &[ContactTrack]| {
        record::force_table(ForceHeadings::OpenSim, time, tracks).expect_err("refused").to_string()
    };
    assert!(refused(&[0.0], &[track("a", 1), track("a", 1)]).starts_with("contacts of link 'a'"));
    assert!(refused(&[0.0], &[track("a", 2)]).contains("2 contacts for 1 samples"));
    let mut bad = track("a", 2);
    bad.samples[1].force.y = f64::NAN;
    assert!(refused(&[0.0, 0.5], &[bad]).starts_with("'a_ground_force_vy' at 0.5 s is NaN"));
}
