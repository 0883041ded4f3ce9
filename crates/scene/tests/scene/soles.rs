//! Soles as text: what they come to, and what is wrong with them, in its place.

use solaris_analysis::ground::soles;
use solaris_model::{Figure, FigureBuilder, Isometry3, Joint, LinkSpec, Placement, SolePart, Vector3, human};
use solaris_scene::read_soles;
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;

/// A foot that carries a frame turned by a quarter about z, and another for its toes.
fn foot() -> Figure {
    let calcn = Placement::new(Vector3::new(0.1, 0.2, 0.3), Vector3::z() * FRAC_PI_2);
    let toes = Isometry3::translation(1.0, 0.0, 0.0);
    let talus = LinkSpec::root("talus_r", Joint::new("ankle").rz()).mass(1.0);
    FigureBuilder::new("foot")
        .link(talus.frame("calcn_r", calcn).frame("toes_r", toes))
        .build()
        .expect("valid")
}

#[test]
fn what_the_figure_has_can_be_written_down() {
    let ann = human(1.65, 58.0).expect("a person");
    let own = soles(&ann);
    let mut text = "Soles(version: 1, soles: [\n".to_owned();
    for sole in &own {
        let point = |p: &Vector3<f64>| format!("({}, {}, {})", p.x, p.y, p.z);
        let link = |index: usize| ann.links()[index].name();
        let (toes, width) = (sole.toes.expect("toes"), sole.width.expect("a width"));
        writeln!(
            text,
            "Sole(name: \"{}\", foot: \"{}\", toes: \"{}\", heel: {}, ball: {}, tip: {}, width: {width}),",
            sole.name,
            link(sole.foot),
            link(toes),
            point(&sole.heel),
            point(&sole.ball),
            point(&sole.tip)
        )
        .expect("memory");
    }
    assert_eq!(read_soles(&(text + "])"), &ann).expect("soles"), own);
    assert!(ann.links()[own[0].foot].sole_point(SolePart::Heel).is_some());
}

#[test]
fn points_of_a_frame_are_carried_to_its_link() {
    let text = r#"Soles(version: 1, soles: [Sole(name: "r", foot: "calcn_r", toes: "toes_r",
        heel: (0, 0, 0), ball: (1, 2, 3), tip: (0.5, 0, 0))])"#;
    let found = &read_soles(text, &foot()).expect("a sole")[0];
    assert_eq!((found.foot, found.toes, found.width), (0, None, None));
    assert!((found.heel - Vector3::new(0.1, 0.2, 0.3)).norm() < 1e-15);
    // A quarter about z: x becomes y, y becomes −x.
    assert!((found.ball - Vector3::new(0.1 - 2.0, 0.2 + 1.0, 3.3)).norm() < 1e-14, "{}", found.ball);
    assert!((found.tip - Vector3::new(1.5, 0.0, 0.0)).norm() < 1e-15, "{}", found.tip);
    // Without toes the tip is in the foot's frame, too.
    let text = text.replace("toes: \"toes_r\",", "");
    let found = &read_soles(&text, &foot()).expect("a sole")[0];
    assert!((found.tip - Vector3::new(0.1, 0.7, 0.3)).norm() < 1e-15, "{}", found.tip);
}

#[test]
fn faults_of_soles() {
    let mut text = String::new();
    for case in [
        "",
        "Sols(version: 1)",
        "Soles(soles: [])",
        "Soles(version: 2, soles: nothing)",
        "Soles(version: 1)",
        "Soles(version: 1, soles: 3, sole: 4)",
        "Soles(version: 1, soles: [Sole()])",
        "Soles(version: 1, soles: [Sole(name: \"a b\", foot: \"calc_r\", toes: \"head\",\n  heel: (0, 0), ball: 1, tip: (0, x, 0), width: 0)])",
        "Soles(version: 1, soles: [\n  Sole(name: \"a\", foot: \"calcn_r\", heel: (0, 0, 0), ball: (1, 0, 0), tip: (inf, 0, 0), widht: 1),\n  \
         Sole(name: \"a\", foot: \"talus\", heel: (0, 0, 0), ball: (1, 0, 0), tip: (2, 0, 0), width: inf)])",
    ] {
        let said = read_soles(case, &foot()).expect_err(case);
        let _ = write!(text, "{case}\n{said}\n\n");
    }
    insta::assert_snapshot!(text);
}
