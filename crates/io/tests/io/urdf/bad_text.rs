//! Texts that are no robots, or strange ones.

use crate::table::answers;
use solaris_io::urdf;
use std::fmt::Write;

const INERTIAL: &str =
    "<inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>";

fn robot(inside: &str) -> String {
    format!("<robot name='r'>\n{inside}\n</robot>")
}

fn link(name: &str) -> String {
    format!("<link name='{name}'>{INERTIAL}</link>\n")
}

fn joint(name: &str, parent: &str, child: &str, inside: &str) -> String {
    format!(
        "<joint name='{name}' type='revolute'><parent link='{parent}'/><child link='{child}'/>\
         <limit lower='-1' upper='1' effort='5' velocity='2'/>{inside}</joint>\n"
    )
}

/// A pendulum, with something put into its joint and its link.
fn pendulum(in_joint: &str, in_link: &str) -> String {
    let bob = if in_link.is_empty() { link("bob") } else { format!("<link name='bob'>{in_link}</link>\n") };
    robot(&format!("<link name='base'/>\n{bob}{}", joint("pivot", "base", "bob", in_joint)))
}

fn inertial(mass: &str, numbers: &str) -> String {
    let names = ["ixx", "ixy", "ixz", "iyy", "iyz", "izz"];
    let numbers: Vec<String> =
        names.iter().zip(numbers.split(' ')).map(|(name, number)| format!("{name}='{number}'")).collect();
    format!("<inertial>\n<mass value='{mass}'/>\n<inertia {}/>\n</inertial>", numbers.join(" "))
}

fn many(count: usize, parent: impl Fn(usize) -> usize) -> String {
    let mut inside = link("l0");
    for i in 1..=count {
        writeln!(
            inside,
            "<link name='l{i}'>{INERTIAL}</link><joint name='j{i}' type='continuous'><parent link='l{}'/><child link='l{i}'/></joint>",
            parent(i)
        )
        .expect("a string");
    }
    robot(&inside)
}

fn deep(count: usize) -> String {
    robot(&format!("{}{}", "<gazebo>".repeat(count), "</gazebo>".repeat(count)))
}

/// With `n` links where a text is long.
fn cases(n: usize) -> Vec<(&'static str, String)> {
    let whole = pendulum("", "");
    vec![
        ("the pendulum itself", whole.clone()),
        ("empty", String::new()),
        ("white space", " \n\t ".to_owned()),
        ("plain words", "hello".to_owned()),
        ("binary", "\u{0}\u{1}PK\u{3}\u{4}".to_owned()),
        ("cut off", whole[..whole.len() / 2].to_owned()),
        ("cut off between elements", whole.replace("</robot>", "")),
        ("another root", "<mujoco><worldbody/></mujoco>".to_owned()),
        ("crossing elements", "<robot name='r'>\n<link name='a'></robot></link>".to_owned()),
        ("an undeclared prefix", robot("<sensor:camera/>")),
        ("a document type", format!("<!DOCTYPE robot [<!ENTITY a 'b'>]>{whole}")),
        ("xacro", "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n<xacro:include filename='a'/></robot>".to_owned()),
        ("xacro's expressions", whole.replace("'1'", "'${mass}'")),
        ("Windows line ends", whole.replace('\n', "\r\n")),
        ("a byte order mark", format!("\u{feff}{whole}")),
        ("no links", robot("")),
        ("names with spaces, quotes and letters", whole.replace("pivot", "der Gelenk &quot;1&quot; ü 関節").replace("'bob'", "'b &apos;o&apos; b'")),
        ("an unknown link", robot(&format!("{}{}{}", link("base"), link("bob"), joint("pivot", "bsae", "bob", "")))),
        ("two roots", robot(&format!("{}{}", link("one"), link("two")))),
        ("a cycle", robot(&format!("{}{}{}{}", link("a"), link("b"), joint("ab", "a", "b", ""), joint("ba", "b", "a", "")))),
        ("its own parent", robot(&format!("{}{}", link("a"), joint("aa", "a", "a", "")))),
        ("a loop", robot(&format!("{}{}{}{}{}{}", link("a"), link("b"), link("c"), joint("ab", "a", "b", ""), joint("ac", "a", "c", ""), joint("bc", "b", "c", "")))),
        ("two links of one name", robot(&format!("{}{}{}", link("a"), link("a"), link("b")))),
        ("two joints of one name", robot(&format!("{}{}{}{}{}", link("a"), link("b"), link("c"), joint("j", "a", "b", ""), joint("j", "a", "c", "")))),
        ("missing attributes", robot("<link/>\n<joint type='hinge'>\n<child/>\n</joint>")),
        ("everything at once", pendulum("<origin xyz='1 2' rpy='a b c'/><axis xyz='0 0 0'/>", &inertial("1e999", "NaN 0 0 1 0 inf"))),
        ("an axis of no length", pendulum("<axis xyz='0 0 0'/>", "")),
        ("limits the wrong way round", whole.replace("lower='-1'", "lower='3'")),
        ("a negative mass", pendulum("", &inertial("-2", "1 0 0 1 0 1"))),
        ("an inertia of no body", pendulum("", &inertial("2", "1 0 0 1 0 5"))),
        ("an inertia without mass", pendulum("", &inertial("0", "1 0 0 1 0 1"))),
        ("no mass at all", pendulum("", "<visual/>")),
        ("an inertia of zero", pendulum("", &inertial("2", "0 0 0 0 0 0"))),
        ("numbers that overflow", pendulum("", &inertial("2", "1.7e308 0 0 1.7e308 0 1.7e308"))),
        ("a bad body that is fused", robot(&format!("{}<link name='tool'>{}</link>\n<joint name='weld' type='fixed'><parent link='base'/><child link='tool'/></joint>", link("base"), inertial("1", "1 0 0 1 0 5")))),
        ("negative damping", pendulum("<dynamics damping='-1' friction='0.5'/>", "")),
        ("mimicry", robot(&format!("{}{}{}{}{}", link("a"), link("b"), link("c"), joint("one", "a", "b", ""), joint("two", "a", "c", "<mimic joint='one' multiplier='-2' offset='0.1'/>")))),
        ("mimicry of mimicry", robot(&format!("{}{}{}{}{}", link("a"), link("b"), link("c"), joint("one", "a", "b", "<mimic joint='two'/>"), joint("two", "b", "c", "<mimic joint='one' multiplier='2'/>")))),
        ("blanks before the declaration", format!(" \n<?xml version='1.0'?>{whole}")),
        ("rules in comments, and an empty document type", format!("<!DOCTYPE robot>\n<!-- --- a rule --- -->\n{whole}")),
        ("no <inertia>", pendulum("", "<inertial><mass value='2'/></inertial>")),
        ("no <mass>", pendulum("", "<inertial><mass/><inertia ixx='1' iyy='1' izz='1' ixy='0'/></inertial>")),
        ("a broken tree and broken numbers", robot(&format!("<link name='a'>{}</link>{}{}", inertial("-3", "1 0 0 1 0 1"), link("b"), joint("ab", "a", "c", "<dynamics damping='-1'/>")))),
        ("mimicry of nothing", pendulum("<mimic joint='pvot'/>", "")),
        ("nested deeply", deep(100_000)),
        ("nested, but not too deeply", deep(900)),
        ("a long chain of links", many(n, |i| i - 1)),
        ("a star of many links", many(n, |_| 0)),
        ("many unknown links", many(n, |i| i + 1_000_000)),
        ("1e5 attributes", robot(&format!("<link {}/>", repeated(100_000, |i| format!("a{i}='1' "))))),
        ("many namespaces", robot(&repeated(2000, |i| format!("<a xmlns:n{i}='n{i}'>")))),
    ]
}

/// One text after another.
fn repeated(count: usize, text: impl Fn(usize) -> String) -> String {
    (0..count).map(text).collect::<Vec<_>>().concat()
}

#[test]
fn strange_texts_are_answered_with_their_places() {
    insta::assert_snapshot!(answers(urdf::read, &cases(10_000)));
}

#[test]
#[ignore = "ten times as long, some ten seconds: cargo xtask nightly"]
fn long_texts_are_answered_with_their_places() {
    insta::assert_snapshot!(answers(urdf::read, &cases(100_000)));
}

/// Whatever is cut away, there is an answer.
#[test]
fn every_beginning_of_a_text_is_answered() {
    let whole = pendulum("<origin xyz='1 2 3' rpy='0 0 1'/><dynamics damping='1'/><!-- ü -->", "");
    for (end, _) in whole.char_indices() {
        assert!(urdf::read(&whole[..end]).is_err());
    }
}
