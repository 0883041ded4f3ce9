//! Motors of MuJoCo models, as numbers at their joints.

use solaris_io::{NoFiles, mjcf};
use solaris_model::ActuatorLaw::{self, Force, Other, Position, Velocity};

/// Law and greatest force of each actuator of a joint `a`.
fn found(defaults: &str, actuators: &str) -> Vec<(ActuatorLaw, Option<f64>)> {
    let text = format!(
        r#"<mujoco><default>{defaults}</default><worldbody><body><joint name="a"/><geom size="0.1"/></body></worldbody><actuator>{actuators}</actuator></mujoco>"#
    );
    let all = mjcf::actuators(&text, &mut NoFiles).unwrap_or_else(|error| panic!("{error}"));
    all.into_iter().map(|one| (one.law, one.limit)).collect()
}

#[test]
fn gears_are_in_all_numbers() {
    let text = r#"<position joint="a" kp="10" kv="2" gear="3" forcerange="-5 5"/><velocity joint="a" kv="2" gear="-3"/>
        <motor joint="a" gear="50" ctrlrange="-2 2"/><motor joint="a" gear="50" ctrllimited="false" ctrlrange="-2 2"/>"#;
    let expected = vec![
        (Position { stiffness: 90.0, damping: 18.0 }, Some(15.0)),
        (Velocity { damping: 18.0 }, None),
        (Force, Some(100.0)),
        (Force, None),
    ];
    assert_eq!(found("", text), expected);
}

#[test]
fn general_ones_are_told_by_their_law_and_defaults_hold() {
    let defaults = r#"<general gainprm="20" biastype="affine" biasprm="0 -20 -3" forcerange="-7 7"/><default class="w"><position kp="4" kv="1"/></default>"#;
    let text = r#"<general joint="a"/><general joint="a" biasprm="0 0 -20"/><general joint="a" biastype="none" gainprm="6"/>
        <general joint="a" biasprm="1 -20 0"/><general joint="a" dyntype="filter"/><position class="w" joint="a"/>"#;
    let all = found(defaults, text);
    let laws: Vec<ActuatorLaw> = all.iter().map(|(law, _)| law.clone()).collect();
    let other = || Other("<general> of another law".to_owned());
    let position = Position { stiffness: 20.0, damping: 3.0 };
    let expected = [
        position,
        Velocity { damping: 20.0 },
        Force,
        other(),
        other(),
        Position { stiffness: 4.0, damping: 1.0 },
    ];
    assert_eq!(laws, expected);
    assert_eq!(all[0].1, Some(7.0));
}

#[test]
fn what_has_no_place_is_told_by_name() {
    let text = r#"<position joint="a" forcerange="-1 3"/><position joint="a" dampratio="1"/><muscle joint="a"/><position name="t" tendon="b"/>"#;
    let said: Vec<String> = found("", text)
        .into_iter()
        .map(|(law, _)| match law {
            Other(what) => what,
            law => panic!("{law:?}"),
        })
        .collect();
    assert_eq!(
        said,
        [
            "forcerange -1 to 3, which is not the same both ways",
            "<position> with a dampratio; give it a kv",
            "<muscle>",
            "<position> without a joint"
        ]
    );
}
