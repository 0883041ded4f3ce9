//! What `<equality>` holds together: points as MuJoCo 4.0.0 has them in `eq_data` of the same text.

use approx::assert_abs_diff_eq;
use solaris_io::{NoFiles, mjcf};
use solaris_model::{TieEnd, TieLaw, Vector3};

/// Turned bodies whose joints stand beside their origins, one that is a part of another, one that flies; a joint that is not at zero.
const TEXT: &str = r#"<mujoco><compiler angle="radian"/><worldbody>
<body name="a" pos="0.1 0.2 1" euler="0.3 -0.2 0.5"><joint name="ja" pos="0.05 0 0.1" axis="0 1 1" ref="0.4"/><geom size="0.1"/>
 <body name="tool" pos="0.3 0 0.1" euler="0 0.7 0"><geom size="0.1"/><site name="tip" pos="0.1 0.2 0.3"/></body>
 <body name="b" pos="0 0.4 -0.2" euler="0.1 0.2 0.3"><joint name="jb" type="ball" pos="0 0.1 0"/><geom size="0.1"/></body></body>
<body name="c" pos="-0.3 0.6 0.2" euler="1 0 -0.4"><freejoint/><geom size="0.1"/><site name="eye" pos="0 0 0.1"/></body>
</worldbody><equality>
<connect name="one" body1="tool" body2="c" anchor="0.1 0.2 0.3"/>
<connect name="two" body1="b" anchor="0 0 0.5"/>
<weld name="three" body1="a" body2="b" anchor="0.3 -0.1 0"/>
<weld name="four" body1="c" body2="tool" relpose="1 2 3 0.8 0 0.6 0" anchor="0 0.1 0"/>
<connect name="five" site1="tip" site2="eye"/>
<weld name="off" body1="a" active="false"/>
<joint joint1="ja" polycoef="0 1 0 0 0"/>
</equality></mujoco>"#;

fn assert_end(end: &TieEnd, link: Option<&str>, point: [f64; 3]) {
    assert_eq!(end.link.as_deref(), link);
    assert_abs_diff_eq!(end.point, Vector3::from(point), epsilon = 1e-10);
}

#[test]
fn points_are_those_of_mujoco() {
    let found = mjcf::ties(TEXT, &mut NoFiles).expect("valid");
    let names: Vec<&str> = found.iter().map(|tie| tie.name.as_str()).collect();
    assert_eq!(names, ["one", "two", "three", "four", "five", "joint6"]);
    let laws = found.iter().map(|tie| &tie.law).collect::<Vec<_>>();
    let other = TieLaw::Other("<joint>".to_owned());
    assert_eq!(
        laws,
        [&TieLaw::Points, &TieLaw::Points, &TieLaw::Axes, &TieLaw::Axes, &TieLaw::Points, &other]
    );
    // Of links: their frames are at the joints, the bodies' are not.
    let (sin, cos) = 0.7_f64.sin_cos();
    let within = |x: f64, y: f64, z: f64| [0.25 + cos * x + sin * z, y, cos * z - sin * x];
    assert_end(&found[0].between[0], Some("a"), within(0.1, 0.2, 0.3));
    assert_end(&found[0].between[1], Some("c"), [0.287_800_885_83, 1.228_308_919_808, 0.739_861_782_441]);
    assert_end(&found[1].between[0], Some("b"), [0.0, -0.1, 0.5]);
    assert_end(&found[1].between[1], None, [-0.036_658_457_667, 0.461_306_642_861, 1.358_987_299_081]);
    let held = [0.309_850_956_838 - 0.05, 0.399_427_299_136, -0.263_182_723_591 - 0.1];
    assert_end(&found[2].between[0], Some("a"), held);
    assert_end(&found[2].between[1], Some("b"), [0.3, -0.2, 0.0]);
    assert_end(&found[3].between[0], Some("c"), [1.0, 2.0, 3.0]);
    assert_end(&found[3].between[1], Some("a"), within(0.0, 0.1, 0.0));
    assert_end(&found[4].between[0], Some("a"), within(0.1, 0.2, 0.3));
    assert_end(&found[4].between[1], Some("c"), [0.0, 0.0, 0.1]);
}

#[test]
fn what_is_not_there_is_refused_by_name() {
    let refused = |from: &str, to: &str| {
        let error = mjcf::ties(&TEXT.replacen(from, to, 1), &mut NoFiles).expect_err("refused");
        error.files[0].error.faults.iter().map(|fault| fault.message.clone()).collect::<Vec<_>>()
    };
    assert_eq!(refused("body1=\"tool\"", "body1=\"tol\""), ["there is no body 'tol'; did you mean 'tool'?"]);
    assert_eq!(refused(" body1=\"b\"", ""), ["<connect> has no 'body1'"]);
    assert_eq!(refused("site2=\"eye\"", ""), ["<connect> has no 'site2'"]);
    assert_eq!(refused("0 0 0.5", "0 0"), ["'anchor' holds 2 numbers; it must hold 3 numbers"]);
}
