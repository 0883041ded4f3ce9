//! Texts that are hostile or wrong: an answer with a place, in bounded time, and never a panic.

use crate::table::answers;
use solaris_io::sdf;

fn model(content: &str) -> String {
    format!("<sdf version='1.9'>\n<model name='m'>\n{content}\n</model>\n</sdf>")
}

fn hinge(parent: &str, child: &str, rest: &str) -> String {
    format!(
        "<joint name='{parent}_{child}' type='revolute'><parent>{parent}</parent><child>{child}</child>\
         <axis><xyz>0 1 0</xyz>{rest}</axis></joint>\n"
    )
}

const A: &str = "<link name='a'/>\n";

fn cases(n: usize) -> Vec<(&'static str, String)> {
    let deep = |n: usize, open: &str, close: &str| model(&(open.repeat(n) + A + &close.repeat(n)));
    let repeated = |n: usize, each: &dyn Fn(usize) -> String| (0..n).map(each).collect::<Vec<_>>().concat();
    let many = |n: usize, each: &dyn Fn(usize) -> String| model(&repeated(n, each));
    let frames = repeated(n, &|i| format!("<frame name='f{i}'><pose relative_to='f{}'/></frame>", i + 1));
    let attached = repeated(n, &|i| format!("<frame name='f{i}' attached_to='f{}'/>", (i + 1) % n));
    vec![
        ("empty", String::new()),
        ("not SDF", "<robot name='r'/>".to_owned()),
        ("an old version", "<sdf version='1.3'><model name='m'/></sdf>".to_owned()),
        ("no version", "<sdf><model name='m'/></sdf>".to_owned()),
        ("nothing", "<sdf version='1.9'/>".to_owned()),
        ("two models", "<sdf version='1.9'><model name='a'/><model name='b'/></sdf>".to_owned()),
        ("entities", "<!DOCTYPE sdf [<!ENTITY a 'b'>]><sdf version='1.9'/>".to_owned()),
        ("no links", model("")),
        ("names twice", model(&format!("{A}{A}<frame name='a'/>"))),
        ("no names", model("<link/><link name=' '/><frame/>")),
        (
            "numbers that are none",
            model(
                "<link name='a'><pose>1 2 3</pose><inertial><mass>x</mass><inertia><ixx>inf</ixx></inertia></inertial></link>",
            ),
        ),
        (
            "a quaternion that is none",
            model("<link name='a'><pose rotation_format='quat_xyzw'>0 0 0 0 0 0 0</pose></link>"),
        ),
        ("a negative mass", model("<link name='a'><inertial><mass>-1</mass></inertial></link>")),
        ("an unknown joint", model(&format!("{A}{}", hinge("world", "a", "").replace("revolute", "hinge")))),
        (
            "a joint without axis",
            model(&format!(
                "{A}<joint name='j' type='prismatic'><parent>world</parent><child>a</child></joint>"
            )),
        ),
        ("a joint without ends", model(&format!("{A}<joint name='j' type='fixed'/>"))),
        (
            "unknown frames",
            model(&format!("<link name='a'><pose relative_to='b'/></link>{}", hinge("A", "a", ""))),
        ),
        ("the world as a child", model(&format!("{A}{}", hinge("a", "world", "")))),
        ("the same link on both ends", model(&format!("{A}{}", hinge("a", "a", "")))),
        ("an axis of no length", model(&format!("{A}{}", hinge("world", "a", "").replace("0 1 0", "0 0 0")))),
        (
            "limits the wrong way round",
            model(&format!("{A}{}", hinge("world", "a", "<limit><lower>1</lower><upper>-1</upper></limit>"))),
        ),
        (
            "a gearbox",
            model(&format!(
                "{A}<link name='b'/>{}<joint name='g' type='gearbox'><parent>a</parent><child>b</child></joint>",
                hinge("world", "a", "") + &hinge("a", "b", "")
            )),
        ),
        (
            "links in a circle",
            model(&format!("{A}<link name='b'/>{}{}", hinge("a", "b", ""), hinge("b", "a", ""))),
        ),
        (
            "places in a circle",
            model(
                "<link name='a'><pose relative_to='b'/></link><link name='b'><pose relative_to='a'/></link>",
            ),
        ),
        ("frames in a circle", model(&format!("{A}{attached}"))),
        (
            "a placement frame that is not there",
            model("").replace("<model name='m'>", "<model name='m' placement_frame='x'>"),
        ),
        (
            "inertia of a mesh",
            model(
                "<link name='a'><inertial auto='true'/><collision name='c'><geometry><mesh/></geometry></collision></link>",
            ),
        ),
        ("inertia of nothing", model("<link name='a'><inertial auto='true'/></link>")),
        ("no gravity for a link", model("<link name='a'><gravity>false</gravity></link>")),
        ("models in each other", deep(60, "<model name='n'>", "</model>")),
        ("nested deeply", deep(100_000, "<model name='n'>", "</model>")),
        ("a long chain of frames", model(&(A.to_owned() + &frames))),
        ("many links", many(n, &|i| format!("<link name='l{i}'/>"))),
        (
            "a long chain of links",
            many(n, &|i| {
                let above = if i == 0 { "world".to_owned() } else { format!("l{}", i - 1) };
                format!("<link name='l{i}'/>{}", hinge(&above, &format!("l{i}"), ""))
            }),
        ),
        (
            "a long chain, each link held by its child",
            many(n, &|i| {
                format!("<link name='l{i}'/>{}", hinge(&format!("l{}", i + 1), &format!("l{i}"), ""))
            })
            .replace(&format!("<parent>l{n}<"), "<parent>world<"),
        ),
    ]
}

/// More links than memory holds are refused by their number.
#[test]
fn more_links_than_fit_are_refused() {
    let links: Vec<String> = (0..1 << 18).map(|i| format!("<link name='{i}'/>")).collect();
    let error = sdf::read(&model(&links.concat())).expect_err("too many");
    assert!(error.to_string().contains("more than 131072 links"), "{error}");
}

#[test]
fn strange_texts_are_answered_with_their_places() {
    insta::assert_snapshot!(answers(sdf::read, &cases(10_000)));
}

#[test]
#[ignore = "ten times as long, some ten seconds: cargo xtask nightly"]
fn long_texts_are_answered_with_their_places() {
    insta::assert_snapshot!(answers(sdf::read, &cases(100_000)));
}

/// Whatever is cut away, there is an answer.
#[test]
fn every_beginning_of_a_text_is_answered() {
    let whole = include_str!("models/crane.sdf").trim_end();
    for (end, _) in whole.char_indices().step_by(7) {
        assert!(sdf::read(&whole[..end]).is_err());
    }
}
