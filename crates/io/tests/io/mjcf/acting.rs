//! What acts in MuJoCo's models besides joints, bodies and gravity: applied, or said to be missing, each kind once.

use solaris_io::mjcf;
use solaris_model::FindingKind;

fn model(before: &str, joint: &str, after: &str) -> String {
    format!(
        "<mujoco>{before}<worldbody>\
         <body name='a'><joint name='j' {joint}/><geom name='g' size='.1'/></body>\
         <body name='b'><joint name='k'/><geom size='.1'/></body>\
         </worldbody>{after}</mujoco>"
    )
}

/// The subjects of what is missing, in the order of the text.
fn missing(text: &str) -> Vec<String> {
    let import = mjcf::read(text).unwrap_or_else(|error| panic!("{error}"));
    let missing = import.findings.into_iter().filter(|finding| finding.kind == FindingKind::Missing);
    missing.map(|finding| finding.subject).collect()
}

#[test]
fn what_is_switched_off_does_not_act() {
    let joint = "stiffness='2' springref='10' damping='3' frictionloss='4'";
    let acts = |option: &str| {
        let import = mjcf::read(&model(option, joint, "")).unwrap_or_else(|error| panic!("{error}"));
        let passive = *import.figure.links()[1].joint().kind().passive(0);
        [passive.stiffness, passive.damping, passive.friction].map(|number| number > 0.0)
    };
    let off = |what: &str| format!("<option><flag {what}='disable'/></option>");
    assert_eq!(acts(""), [true, true, true]);
    assert_eq!(acts(&off("spring")), [false, true, true]);
    assert_eq!(acts(&off("damper")), [true, false, true]);
    assert_eq!(acts(&off("passive")), [false, false, true]);
    assert_eq!(acts(&off("frictionloss")), [true, true, false]);
    assert_eq!(acts(&off("contact")), [true, true, true]);
}

#[test]
fn what_acts_and_has_no_place_is_said_once_a_kind() {
    let none: &[&str] = &[];
    let tendon = |attributes: &str| {
        format!("<tendon><fixed name='t' {attributes}><joint joint='j' coef='1'/></fixed></tendon>")
    };
    let defaults = "<default><tendon stiffness='3'/><default class='geared'><general armature='.1'/></default></default>";
    let cases: [(&str, &str, &str, &[&str]); 16] = [
        ("", "", "", none),
        ("", "springdamper='.1 1'", "", none),
        ("", "type='ball' springdamper='.1 1'", "", &["springdampers of joints"]),
        ("", "springdamper='0 1'", "", none),
        ("", "stiffness='1 2'", "", &["springs that are not linear"]),
        ("", "damping='1 0 3'", "", &["dampers that are not linear"]),
        ("", "stiffness='1 0'", "", none),
        ("", "", &tendon("range='0 1'"), none),
        ("", "", &tendon("damping='1'"), &["tendons"]),
        (defaults, "", &tendon(""), &["tendons"]),
        (defaults, "", &tendon("stiffness='0'"), none),
        ("", "", "<actuator><motor joint='j'/></actuator>", none),
        (
            "",
            "",
            "<actuator><motor joint='j' armature='.1'/><motor joint='k' damping='1'/></actuator>",
            &["actuators"],
        ),
        (defaults, "", "<actuator><position class='geared' joint='j'/></actuator>", &["actuators"]),
        (
            "",
            "",
            "<equality><weld body1='a'/><connect body1='a' anchor='0 0 0'/></equality>",
            &["equalities"],
        ),
        ("", "", "<equality><weld body1='a' active='false'/></equality>", none),
    ];
    for (before, joint, after, expected) in cases {
        let text = model(before, joint, after);
        assert_eq!(missing(&text), expected, "{text}");
    }
}

#[test]
fn limits_of_a_free_joint_mean_nothing() {
    let text = "<mujoco><default><joint limited='true'/></default><worldbody><body><joint type='free'/><geom size='.1'/>\
                </body></worldbody></mujoco>";
    assert_eq!(missing(text), [""; 0]);
}
