//! Texts that are no models, or strange ones.

use crate::table::answers;
use solaris_io::mjcf;

fn model(before: &str, bodies: &str) -> String {
    format!("<mujoco model='m'>\n{before}\n<worldbody>\n{bodies}\n</worldbody>\n</mujoco>")
}

fn body(inside: &str) -> String {
    model("", &format!("<body name='b'>\n{inside}\n<geom size='.1'/>\n</body>"))
}

fn geom(attributes: &str) -> String {
    model("", &format!("<body name='b'><joint name='j'/><geom {attributes}/></body>"))
}

fn chain(count: usize) -> String {
    model("", &format!("{}{}", "<body><joint/><geom size='.1'/>".repeat(count), "</body>".repeat(count)))
}

/// With `many` links where a text is long.
fn cases(many: usize) -> Vec<(&'static str, String)> {
    let whole = body("<joint name='j' axis='0 1 0'/>");
    vec![
        ("the pendulum itself", whole.clone()),
        ("empty", String::new()),
        ("binary", "\u{0}\u{1}\u{2}".to_owned()),
        ("cut off", whole[..whole.len() / 2].to_owned()),
        ("another root", "<robot name='r'/>".to_owned()),
        ("no bodies", model("", "")),
        ("Windows line ends", whole.replace('\n', "\r\n")),
        ("names with spaces, quotes and letters", whole.replace("'b'", "'b &apos;o&apos; ü'").replace("'j'", "'関節 1'")),
        ("numbers that are none", body("<joint name='j' axis='0 1e999 NaN' range='0 abc' armature='inf'/>")),
        ("too few numbers", body("<joint name='j' axis='0 1' pos='1 2 3 4' damping=''/>")),
        ("an axis of no length", body("<joint name='j' axis='0 0 0'/>")),
        ("limited without a range", body("<joint name='j' limited='true'/>")),
        ("limited perhaps", body("<joint name='j' limited='maybe'/>")),
        ("a range the wrong way round", body("<joint name='j' limited='true' range='10 -10'/>")),
        ("negative damping", body("<joint name='j' damping='-1' armature='-2'/>")),
        ("an unknown type", body("<joint name='j' type='hnige'/>")),
        ("an unknown class", model("<default><default class='leg'/></default>", "<body childclass='lge'><joint class='arm'/><geom size='.1'/></body>")),
        ("a class that is there twice", model("<default><default class='a'/><default class='a'/><default/></default>", "<body><geom size='.1'/></body>")),
        ("a fault in a default, used twice", model("<default><joint axis='0 0'/></default>", "<body><joint/><joint/><geom size='.1'/></body>")),
        ("two joints of one name", body("<joint name='j'/><joint name='j'/>")),
        ("two bodies of one name", model("", "<body name='a'><geom size='.1'/></body><body name='a'><geom size='.1'/></body>")),
        ("a free joint beside others", body("<freejoint/><joint/>")),
        ("a free joint inside", model("", "<body name='a'><geom size='.1'/><body name='b'><freejoint/><geom size='.1'/></body></body>")),
        ("a joint of the world", model("", "<joint/><body><geom size='.1'/></body>")),
        ("orientations that are none", model("", "<body quat='0 0 0 0'><geom size='.1'/></body><body axisangle='0 0 0 1'><geom size='.1'/></body><body xyaxes='1 0 0 2 0 0'><geom size='.1'/></body><body zaxis='0 0 0'><geom size='.1'/></body>")),
        ("two orientations", model("", "<body quat='1 0 0 0' euler='1 2 3'><geom size='.1'/></body>")),
        ("sizes that are none", geom("size='-1'")),
        ("sizes that are missing", geom("type='box' size='.1 .2'")),
        ("an unknown geom", geom("type='cube' size='1'")),
        ("points that are one", geom("type='capsule' size='.1' fromto='1 1 1 1 1 1'")),
        ("a negative density", geom("size='.1' density='-1'")),
        ("a mesh", geom("type='mesh' mesh='m'")),
        ("no mass", model("", "<body name='b'><joint name='j'/></body>")),
        ("an inertia of no body", body("<joint/><inertial pos='0 0 0' mass='1' diaginertia='1 2 8'/>")),
        ("inertials that are none", body("<joint/><inertial mass='x' fullinertia='1 2' quat='1 0 0 0'/>")),
        ("a huge inertia", body("<joint/><inertial pos='0 0 0' mass='1' diaginertia='1.7e308 1.7e308 1.7e308'/>")),
        ("included files", "<mujoco><include file='a.xml'/><worldbody><replicate count='2'><body/></replicate></worldbody></mujoco>".to_owned()),
        ("global coordinates", model("<compiler coordinate='global' eulerseq='xyq' angle='grad'/>", "<body><geom size='.1'/></body>")),
        ("what is not read", model(
            "<option timestep='0.01' wind='1 0 0'><flag gravity='disable' contact='disable'/></option><actuator><motor joint='j'/><motor joint='j'/></actuator><equality><weld/></equality><visual/><asset/><custom/><mystery/>",
            "<light/><camera/><geom type='plane' size='1 1 1'/><body name='b' gravcomp='1' mocap='true'><joint name='j' stiffness='1 2' springdamper='1 1' margin='0.1'/><geom size='.1' rgba='1 0 0 1' shellinertia='true'/><site/></body>",
        )),
        ("a free joint's extras", model("", "<body pos='1 2 3'><joint type='free' stiffness='1' armature='2' damping='3'/><geom size='.1'/></body>")),
        ("bodies nested deeply", chain(many)),
        ("many bodies in a row", model("", &"<body><joint/><geom size='.1'/></body>".repeat(many))),
        ("classes nested 1e4 deep", model(
            &format!("<default>{}{}</default>", (0..10_000).map(|i| format!("<default class='c{i}'><joint a{i}='1' armature='{i}'/>")).collect::<Vec<_>>().concat(), "</default>".repeat(10_000)),
            "<body><joint class='c9999'/><geom size='.1'/></body>",
        )),
        ("frames nested deeply", model("", &format!("{}<body><geom size='.1'/></body>{}", "<frame>".repeat(many), "</frame>".repeat(many)))),
    ]
}

#[test]
fn strange_texts_are_answered_with_their_places() {
    insta::assert_snapshot!(answers(mjcf::read, &cases(10_000)));
}

#[test]
#[ignore = "ten times as long, some ten seconds: cargo xtask nightly"]
fn long_texts_are_answered_with_their_places() {
    insta::assert_snapshot!(answers(mjcf::read, &cases(100_000)));
}

/// Whatever is cut away, there is an answer.
#[test]
fn every_beginning_of_a_text_is_answered() {
    let whole = model(
        "<default><joint axis='0 1 0'/></default><!-- ü -->",
        "<body quat='1 0 0 0'><joint/><geom size='.1'/></body>",
    );
    for (end, _) in whole.char_indices() {
        assert!(mjcf::read(&whole[..end]).is_err());
    }
}
