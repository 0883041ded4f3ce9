//! Tables read back bit for bit, and say where they are wrong.

use crate::motions::{Full, full_human, info, swing, thrown, track};
use solaris_io::{IoError, csv};
use solaris_model::{Contact, ContactTrack, Figure, FigureBuilder, Joint, LinkSpec, Motion};

fn text(figure: &Figure, motion: &Motion) -> String {
    let mut bytes = Vec::new();
    csv::write(figure, motion, &mut bytes).expect("a valid motion and a vector");
    String::from_utf8(bytes).expect("text")
}

/// A pendulum with two links; few enough columns to read.
fn pendulum() -> Figure {
    FigureBuilder::new("pendulum")
        .link(LinkSpec::root("base", Joint::new("slide").tx()).mass(1.0))
        .link(LinkSpec::child("bob", "base", Joint::new("wrist").rx().rx()).mass(1.0))
        .build()
        .expect("valid")
}

fn bits(motion: &Motion) -> Vec<u64> {
    let contact = |c: &Contact| [c.force, c.moment, c.cop].map(|v| [v.x, v.y, v.z]);
    let mut numbers = motion.time().to_vec();
    for i in 0..motion.len() {
        numbers.extend([motion.q(i), motion.v(i), motion.a(i), motion.tau(i).unwrap_or_default()].concat());
        numbers.extend(motion.contacts.iter().flat_map(|track| contact(&track.samples[i]).concat()));
    }
    numbers.into_iter().map(f64::to_bits).collect()
}

#[test]
fn a_table_reads_back_bit_for_bit() {
    let (figure, motion) = full_human();
    let back = csv::read(&figure, &text(&figure, &motion), motion.info.clone()).expect("what was written");
    assert_eq!(bits(&back), bits(&motion));
    assert_eq!(back.contacts, motion.contacts);
    assert_eq!(back.len(), 31);
}

#[test]
fn free_and_ball_joints_have_more_columns_of_positions_than_of_velocities() {
    let (figure, mut motion) = thrown(10.0);
    motion.set_tau((0..110).map(|i| f64::from(i).sin()).collect()).expect("nv a sample");
    motion.contacts = vec![track("hand", 11)];
    let table = text(&figure, &motion);
    let header: Vec<&str> = table.lines().next().unwrap_or_default().split(',').collect();
    assert_eq!(header.len(), 1 + 12 + 3 * 10 + 9);
    assert_eq!(
        header[1..8].join(" "),
        "root.px.q root.py.q root.pz.q root.qx.q root.qy.q root.qz.q root.qw.q"
    );
    assert_eq!(header[8..13].join(" "), "shoulder.qx.q shoulder.qy.q shoulder.qz.q shoulder.qw.q elbow.rx.q");
    for (ending, at) in [("v", 13), ("a", 23), ("tau", 33)] {
        let names =
            "root.vx root.vy root.vz root.wx root.wy root.wz shoulder.wx shoulder.wy shoulder.wz elbow.rx";
        let expected: Vec<String> = names.split(' ').map(|name| format!("{name}.{ending}")).collect();
        assert_eq!(header[at..at + 10], expected);
    }
    let back = csv::read(&figure, &table, motion.info.clone()).expect("what was written");
    assert_eq!(bits(&back), bits(&motion));
    let broken = table.replacen(&header[4..8].join(","), "root.qx.q,root.qy.q,root.qz.q,root.w.q", 1);
    let error = csv::read(&figure, &broken, motion.info.clone()).expect_err("no qw");
    assert!(error.to_string().contains("'root.qw.q' is missing"), "{error}");
}

#[test]
fn forces_and_contacts_may_be_absent() {
    let figure = pendulum();
    let motion = swing(&figure, 10.0, 0.0);
    let back = csv::read(&figure, &text(&figure, &motion), motion.info.clone()).expect("what was written");
    assert_eq!(bits(&back), bits(&motion));
    assert_eq!(back.tau(0), None);
    assert!(back.contacts.is_empty());
}

#[test]
fn columns_may_come_in_any_order_with_spaces_and_windows_line_ends() {
    let figure = pendulum();
    let motion = swing(&figure, 10.0, 0.0);
    let reversed = text(&figure, &motion)
        .lines()
        .map(|line| line.split(',').rev().collect::<Vec<_>>().join(" , ") + "\r\n")
        .collect::<String>();
    let back = csv::read(&figure, &reversed, motion.info.clone()).expect("the same columns");
    assert_eq!(bits(&back), bits(&motion));
}

#[test]
fn the_header_names_every_column_in_the_documented_order() {
    let figure = pendulum();
    let mut motion = swing(&figure, 10.0, 0.0);
    motion.set_tau(vec![0.5; 33]).expect("nv a sample");
    motion.contacts = vec![track("bob", 11)];
    let text = text(&figure, &motion);
    insta::assert_snapshot!(text.lines().next().unwrap_or_default().replace(',', "\n"), @"
    time
    slide.tx.q
    wrist.rx.q
    wrist.rx2.q
    slide.tx.v
    wrist.rx.v
    wrist.rx2.v
    slide.tx.a
    wrist.rx.a
    wrist.rx2.a
    slide.tx.tau
    wrist.rx.tau
    wrist.rx2.tau
    bob.fx
    bob.fy
    bob.fz
    bob.mx
    bob.my
    bob.mz
    bob.px
    bob.py
    bob.pz
    ");
}

#[test]
fn the_human_has_a_column_for_every_number() {
    let (figure, motion) = full_human();
    let text = text(&figure, &motion);
    let header: Vec<&str> = text.lines().next().unwrap_or_default().split(',').collect();
    assert_eq!(header.len(), 1 + 4 * 66 + 2 * 9);
    assert_eq!(header[1], "root.tx.q");
    assert_eq!(header[1 + 66], "root.tx.v");
    assert_eq!(header[1 + 4 * 66 + 9], "right_foot.fx");
}

#[test]
fn mistakes_are_answered_with_line_and_column() {
    let figure = pendulum();
    let motion = swing(&figure, 10.0, 0.0);
    let good = text(&figure, &motion);
    let header = good.lines().next().unwrap_or_default();
    let row = good.lines().nth(1).unwrap_or_default();
    let with_contact = format!("{header},bob.fx\n{row},0\n");
    let cases = [
        String::new(),
        good.replace("wrist.rx.v", "wrist.rx.w"),
        good.replace("time", "t"),
        good.replace("wrist.rx.v", "wrist.rx.q"),
        format!("{header},bob.rx.q\n{row},0\n"),
        format!("{header},slide.tx.tau\n{row},0\n"),
        with_contact,
        format!("{header}\n{row}\n{row},1\n"),
        format!("{header}\n{}\n", row.replacen("0,", "nan,", 1)),
        format!("{header}\n{row}\n{row}x\n"),
        format!("{header}\n{row}\n{row}\n"),
        format!("{header}\n{row}\n{}\n", row.replacen("0,", "0.2,", 1)),
    ];
    let answers = cases.map(|text| match csv::read(&figure, &text, motion.info.clone()) {
        Ok(_) => "ACCEPTED".to_owned(),
        Err(error) => error.to_string(),
    });
    insta::assert_snapshot!(answers.join("\n"));
}

#[test]
fn a_table_knows_its_rate() {
    let figure = pendulum();
    let table = text(&figure, &swing(&figure, 40.0, 0.0));
    let rate = csv::frame_rate(&table).expect("a table").expect("more than one row");
    assert!((rate - 40.0).abs() < 1e-9, "{rate}");
    let header = table.lines().next().unwrap_or_default();
    assert!(matches!(csv::frame_rate(header), Ok(None)));
    assert!(csv::read(&figure, &table, info(&figure, 41.0)).is_err(), "a wrong rate is noticed");
}

#[test]
fn what_does_not_belong_together_is_refused() {
    let figure = pendulum();
    let motion = swing(&figure, 10.0, 0.0);
    let (human, _) = full_human();
    let mut none = Vec::new();
    assert!(matches!(csv::write(&human, &motion, &mut none), Err(IoError::Motion(_))));
    let other = info(&human, 10.0);
    assert!(matches!(csv::read(&figure, &text(&figure, &motion), other), Err(IoError::Motion(_))));
    let no_rate = info(&figure, 0.0);
    assert!(matches!(csv::read(&figure, &text(&figure, &motion), no_rate), Err(IoError::Motion(_))));

    let with = |tracks: Vec<ContactTrack>| {
        let mut motion = motion.clone();
        motion.contacts = tracks;
        csv::write(&figure, &motion, &mut Vec::new()).expect_err("contacts that do not fit").to_string()
    };
    let answers = [
        with(vec![track("foot", 11)]),
        with(vec![track("bob", 11), track("bob", 11)]),
        with(vec![track("bob", 10)]),
    ];
    insta::assert_snapshot!(answers.join("\n"), @"
    contacts of link 'foot': figure 'pendulum' has no link of that name
    contacts of link 'bob': there are two tracks of that name; merge them
    contacts of link 'bob': 10 contacts for 11 samples; give one a sample
    ");
}

#[test]
fn no_number_that_is_none_leaves() {
    let figure = pendulum();
    let mut motion = swing(&figure, 10.0, 0.0);
    let mut broken = track("bob", 11);
    broken.samples[4].force.y = f64::NAN;
    motion.contacts = vec![broken];
    let error = csv::write(&figure, &motion, &mut Vec::new()).expect_err("a NaN");
    insta::assert_snapshot!(error, @"'bob.fy' at 0.4 s is NaN; a file holds finite numbers only");
}

#[test]
fn a_failing_writer_is_an_error() {
    let (figure, motion) = full_human();
    let size = text(&figure, &motion).len();
    for left in [0, 1, 5000, size - 1] {
        let error = csv::write(&figure, &motion, &mut Full { left }).expect_err("no room");
        assert!(error.to_string().contains("no space left"), "{error}");
    }
    csv::write(&figure, &motion, &mut Full { left: size }).expect("just enough room");
}
