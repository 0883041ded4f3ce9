//! Models in several files: what is brought, what is refused, and in which file it is said.

use solaris_io::{Loader, NoFiles, mjcf};
use solaris_model::FindingKind;
use std::fmt::Write;
use std::time::{Duration, Instant};

/// The files beside `models/files/main.xml`.
pub(crate) struct Parts;

impl Loader for Parts {
    fn load(&mut self, path: &str) -> Result<Vec<u8>, String> {
        let bytes: &[u8] = match path {
            "parts/common.xml" => include_bytes!("models/files/parts/common.xml"),
            // Named beside the file that names it.
            "parts/bodies.xml" => include_bytes!("models/files/parts/bodies.xml"),
            "parts/arm.xml" => include_bytes!("models/files/parts/arm.xml"),
            "parts/wedge.obj" => include_bytes!("models/files/parts/wedge.obj"),
            "parts/bent.stl" => include_bytes!("models/files/parts/bent.stl"),
            _ => return Err("there is no such file".to_owned()),
        };
        Ok(bytes.to_vec())
    }
}

/// Names and texts.
type Texts = Vec<(&'static str, String)>;

/// Files by name, from memory.
struct Files(Texts);

impl Loader for Files {
    fn load(&mut self, path: &str) -> Result<Vec<u8>, String> {
        let found = self.0.iter().find(|(name, _)| *name == path);
        found.map(|(_, text)| text.clone().into_bytes()).ok_or_else(|| "there is no such file".to_owned())
    }
}

fn model(inside: &str) -> String {
    format!("<mujoco>{inside}<worldbody><body name='b'><joint/><geom size='.1'/></body></worldbody></mujoco>")
}

fn world(inside: &str) -> String {
    format!("<mujoco><worldbody>{inside}</worldbody></mujoco>")
}

/// Twice the model before, sixty times: 2⁶⁰ bodies.
fn laughs() -> Texts {
    let names: Vec<&'static str> =
        (0..60).map(|i| &*Box::leak(format!("m{i}.xml").into_boxed_str())).collect();
    let text = |i: usize| match names.get(i + 1) {
        Some(next) => format!(
            "<mujoco><asset><model name='a' file='{next}'/><model name='b' file='{next}'/></asset><worldbody>\
             <attach model='a' prefix='a'/><attach model='b' prefix='b'/></worldbody></mujoco>"
        ),
        None => model(""),
    };
    names.iter().enumerate().map(|(i, name)| (*name, text(i))).collect()
}

/// Bodies that each attach the one before twice.
fn doubled() -> String {
    let body = |i: usize| {
        let before = i.wrapping_sub(1);
        let twice = format!("<attach body='b{before}' prefix='l'/><attach body='b{before}' prefix='r'/>");
        format!("<body name='b{i}'><geom size='.1'/>{}</body>", if i == 0 { "" } else { &twice })
    };
    world(&(0..60).map(body).collect::<Vec<_>>().concat())
}

fn cases() -> Vec<(&'static str, String, Texts)> {
    let include = |file: &str| format!("<include file='{file}'/>");
    let part = |inside: &str| format!("<mujocoinclude>\n  {inside}\n</mujocoinclude>");
    let copies = |count: &str| {
        world(&format!("<replicate count='{count}'><body><geom size='.1'/></body></replicate>"))
    };
    let nested =
        "<replicate count='1000'>".repeat(40) + "<body><geom size='.1'/></body>" + &"</replicate>".repeat(40);
    let mesh = |file: &str| {
        format!(
            "<mujoco><asset><mesh name='m' file='{file}'/></asset><worldbody><body name='b'><joint name='j'/><geom size='.1'/>\
                 <geom type='mesh' mesh='m'/></body></worldbody></mujoco>"
        )
    };
    vec![
        (
            "a fault and a finding in another file",
            model(&include("a.xml")),
            vec![("a.xml", part("<compiler angle='grad'/><mystery/>"))],
        ),
        (
            "a finding in another file",
            model(&include("a.xml")),
            vec![("a.xml", part("<option timestep='1'/><mystery/>"))],
        ),
        ("a file that is not there", model(&include("a.xml")), vec![]),
        ("a file that is no XML", model(&include("a.xml")), vec![("a.xml", "<a><b></a>".to_owned())]),
        ("a file that is no text", model(&include("a.xml")), vec![("a.xml", String::new())]),
        (
            "a file without elements",
            model(&include("a.xml")),
            vec![("a.xml", "<mujocoinclude> </mujocoinclude>".to_owned())],
        ),
        ("an include with elements", model("<include file='a.xml'><option/></include>"), vec![]),
        ("an include of nothing", model("<include/>"), vec![]),
        (
            "a file that is there twice",
            model(&(include("a.xml") + &include("./b/../a.xml"))),
            vec![("a.xml", part("<visual/>"))],
        ),
        ("a file that includes itself", model(&include("a.xml")), vec![("a.xml", part(&include("a.xml")))]),
        (
            "files that include each other",
            model(&include("a.xml")),
            vec![("a.xml", part(&include("b.xml"))), ("b.xml", part(&include("a.xml")))],
        ),
        ("a way out", model(&include("../a.xml")), vec![]),
        ("another way out", model(&include("a/../../b.xml")), vec![]),
        ("an absolute path", model(&include("/etc/passwd")), vec![]),
        (
            "a model that names itself",
            world("<attach model='a' prefix='p'/>")
                .replace("<worldbody>", "<asset><model name='a' file='a.xml'/></asset><worldbody>"),
            vec![(
                "a.xml",
                world("<body/>")
                    .replace("<worldbody>", "<asset><model name='a' file='a.xml'/></asset><worldbody>"),
            )],
        ),
        (
            "models that name the next twice",
            model("<asset><model name='a' file='m0.xml'/></asset>"),
            laughs(),
        ),
        ("bodies that attach the one before twice", doubled(), vec![]),
        (
            "a part of itself",
            world("<body name='a'><geom size='.1'/><attach body='a' prefix='p'/></body>"),
            vec![],
        ),
        (
            "nothing to attach",
            world(
                "<body name='b'><geom size='.1'/><attach body='a' prefix='p'/><attach prefix='p'/><attach model='m' prefix='p'/><attach body='b'/></body>",
            ),
            vec![],
        ),
        ("a thousand copies", copies("1000"), vec![]),
        ("a thousand million copies", copies("1000000000"), vec![]),
        ("half a copy", copies("0.5"), vec![]),
        ("copies of copies of copies", world(&nested), vec![]),
        (
            "copies of a joint",
            world("<body name='b'><replicate count='2'><joint/></replicate><geom size='.1'/></body>"),
            vec![],
        ),
        ("soft bodies", world("<body name='b'><composite/><flexcomp/><geom size='.1'/></body>"), vec![]),
        ("a mesh that is not there", mesh("a.stl"), vec![]),
        ("a mesh outside", mesh("../a.stl"), vec![]),
        ("a mesh of another format", mesh("a.dae"), vec![("a.dae", String::new())]),
        ("a mesh that is cut off", mesh("a.stl"), vec![("a.stl", "\u{0}".repeat(100))]),
        (
            "a mesh without volume",
            mesh("a.obj"),
            vec![("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3".to_owned())],
        ),
    ]
}

#[test]
fn other_files_are_answered_with_their_places() {
    let mut out = String::new();
    for (name, text, files) in cases() {
        let start = Instant::now();
        let answer = match mjcf::read_with(&text, &mut Files(files)) {
            Err(error) => error.to_string(),
            Ok(loaded) => {
                let figure = &loaded.import.figure;
                let mut said = format!("{} links, nv {}", figure.links().len(), figure.layout().nv());
                for finding in loaded.import.findings.iter().take(4) {
                    write!(said, "\n{:?}: {finding}", finding.kind).expect("a string");
                }
                said
            }
        };
        let took = start.elapsed();
        assert!(took < Duration::from_secs(40), "{name} took {took:?}");
        writeln!(out, "== {name}").expect("a string");
        for line in answer.lines().take(6) {
            writeln!(out, "   {}", line.chars().take(400).collect::<String>()).expect("a string");
        }
    }
    insta::assert_snapshot!(out);
}

/// What is missing without the files is said once, with its share.
#[test]
fn missing_meshes_are_summed_up() {
    let text = include_str!("models/files/main.xml").replace("<include file=\"parts/common.xml\"/>", "");
    let text =
        text.replace("<model name=\"arm\" file=\"parts/arm.xml\"/>", "").replace("childclass=\"stiff\"", "");
    let text: Vec<&str> = text.lines().filter(|line| !line.contains("<attach")).collect();
    let loaded = mjcf::read_with(&text.join("\n"), &mut NoFiles).unwrap_or_else(|error| panic!("{error}"));
    let missing = loaded.import.findings.iter().filter(|finding| finding.kind == FindingKind::Missing);
    let said: Vec<String> =
        missing.map(|finding| format!("{}: {}", finding.subject, finding.message)).collect();
    let expected = "mass: of 2 of 10 bodies that move, some is not known, as meshes were not read (cart, holder); 1 of them \
                    have no other mass";
    assert_eq!(said, [expected]);
}

/// Corners beyond what 32 bits hold gave an area of NaN m².
#[test]
fn a_mesh_beyond_all_range_is_said_to_be_that() {
    let said = |far: &str, scale: &str| {
        let corners = format!("0 0 0 {far} 0 0 0 {far} 0 0 0 {far}");
        let text = format!(
            "<mujoco><asset><mesh name='m' scale='{scale} {scale} {scale}' vertex='{corners}' face='0 2 1 0 1 3 0 3 2 1 2 3'/></asset>\
             <worldbody><body name='b'><joint name='j'/><geom type='mesh' mesh='m' density='1e-12'/></body></worldbody></mujoco>"
        );
        let loaded = mjcf::read_with(&text, &mut NoFiles).unwrap_or_else(|error| panic!("{error}"));
        let findings = loaded.import.findings.iter().map(ToString::to_string);
        findings.filter(|said| said.contains("'m'")).collect::<Vec<_>>().join("\n")
    };
    for (far, scale) in [("1e9", "1"), ("1", "-1e9"), ("1e-30", "1e38")] {
        assert_eq!(said(far, scale), "", "{far} times {scale}");
    }
    for (far, scale) in
        [("1e39", "1"), ("1e39", "0"), ("1.0000001e9", "1"), ("1", "1.1e9"), ("1e30", "1e300")]
    {
        let said = said(far, scale);
        assert!(said.contains("a corner lies more than 1e9 m away"), "{far} times {scale}: {said}");
        assert!(!said.contains("NaN"), "{said}");
    }
}
