//! Models in files of their own: where they are put, and what must not be opened.

use solaris_io::{Import, Loader, sdf};
use solaris_model::TextError;
use std::collections::HashMap;

/// Files by their paths.
#[derive(Default)]
struct Shelf {
    files: HashMap<String, String>,
    opened: Vec<String>,
}

impl Loader for Shelf {
    fn load(&mut self, path: &str) -> Result<Vec<u8>, String> {
        self.opened.push(path.to_owned());
        self.files
            .get(path)
            .map(|text| text.clone().into_bytes())
            .ok_or_else(|| "there is no such file".to_owned())
    }
}

fn shelf<const N: usize>(files: [(&str, &str); N]) -> Shelf {
    let files = files.map(|(path, text)| (path.to_owned(), format!("<sdf version='1.9'>\n{text}</sdf>")));
    Shelf { files: files.into(), opened: Vec::new() }
}

const WHEEL: &str = "<model name='wheel'><frame name='hub'><pose>0 0 0.3 0 0 0</pose></frame><link name='rim'><pose>0 0 0.3 0 0 0</pose>\
                     <inertial><mass>1.5</mass></inertial></link></model>";

fn read(content: &str, shelf: &mut Shelf) -> Result<Import, TextError> {
    sdf::read_with(&format!("<sdf version='1.9'>\n{content}\n</sdf>"), shelf)
}

fn joint(name: &str, child: &str) -> String {
    format!(
        "<joint name='{name}' type='revolute'><parent>cart</parent><child>{child}</child><axis><xyz>0 1 0</xyz></axis></joint>"
    )
}

fn cart(wheels: &str) -> String {
    format!("<model name='cart'><link name='cart'/>{wheels}</model>")
}

#[test]
fn an_included_model_stands_where_it_is_put() {
    let mut files = shelf([("wheel/model.sdf", WHEEL)]);
    let include = |name: &str, rest: &str| {
        format!("<include><uri>model://wheel</uri><name>{name}</name>{rest}</include>")
            + &joint(&format!("j{name}"), &format!("{name}::rim"))
    };
    let wheels = include("left", "<pose>0 0.5 0 0 0 0</pose>")
        + &include("right", "<placement_frame>hub</placement_frame><pose>0 -0.5 0.3 0 0 0</pose>");
    let import = read(&cart(&wheels), &mut files).unwrap_or_else(|error| panic!("{error}"));
    let links: Vec<&str> = import.figure.links().iter().map(solaris_model::Link::name).collect();
    assert_eq!(links, ["cart", "left::rim", "right::rim"]);
    let places: Vec<[f64; 3]> = import
        .figure
        .links()
        .iter()
        .skip(1)
        .map(|link| link.joint().placement().translation.vector.into())
        .collect();
    assert_eq!(places, [[0.0, 0.5, 0.3], [0.0, -0.5, 0.3]]);
    assert!((import.figure.mass() - 4.0).abs() < 1e-15);
    // What is wrong in the file is told once, by its name and line.
    let told: Vec<&str> = import
        .findings
        .iter()
        .map(|f| f.message.as_str())
        .filter(|message| message.contains("wheel/model.sdf"))
        .collect();
    assert_eq!(told, [""; 0]);
}

#[test]
fn a_merged_model_becomes_part_of_the_one_that_includes_it() {
    let mut files = shelf([("wheel/model.sdf", WHEEL)]);
    let wheels = "<include merge='true'><uri>model://wheel</uri><pose>0 0.5 0 0 0 0</pose></include>"
        .to_owned()
        + &joint("j", "rim");
    let import = read(&cart(&wheels), &mut files).unwrap_or_else(|error| panic!("{error}"));
    let rim = import.figure.link("rim").expect("its own name");
    assert_eq!(rim.joint().placement().translation.vector.as_slice(), [0.0, 0.5, 0.3]);
    assert_eq!(import.figure.locate("hub").map(|(link, _)| link), Some(0));
}

#[test]
fn the_file_of_a_folder_is_the_one_that_its_description_names() {
    let mut files = shelf([("wheel/new.sdf", WHEEL), ("wheel/old.sdf", "")]);
    let config = "<model><sdf version='1.4'>old.sdf</sdf><sdf version='1.9'>new.sdf</sdf></model>";
    files.files.insert("wheel/model.config".to_owned(), config.to_owned());
    let import = read("<include><uri>model://wheel</uri></include>", &mut files)
        .unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(import.figure.links()[0].name(), "rim");
}

#[test]
fn what_cannot_be_included_is_refused_by_name() {
    let include = |uri: &str| format!("<include><uri>{uri}</uri></include>");
    let mut said = Vec::new();
    let broken = "<model name='m'><link name='a'><inertial><mass>heavy</mass></inertial></link></model>";
    let myself = format!("<model name='m'>{}<link name='a'/></model>", include("model://loop"));
    for (what, content) in [
        ("not there", cart(&include("model://wheel"))),
        ("not there, of a world", format!("<world name='w'>{}{}</world>", include("model://sun"), cart(""))),
        ("climbs out", cart(&include("model://../../etc/passwd"))),
        ("climbs out of a world", format!("<world name='w'>{}</world>", include("../wheel.sdf"))),
        ("absolute", cart(&include("/etc/passwd.sdf"))),
        ("on the network", cart(&include("https://fuel.gazebosim.org/1.0/models/wheel"))),
        ("includes itself", cart(&include("model://loop"))),
        ("has faults", cart(&include("model://broken"))),
        ("is no XML", cart(&include("model://text"))),
        ("has no uri", cart("<include/>")),
    ] {
        let mut files =
            shelf([("loop/model.sdf", &*myself), ("broken/model.sdf", broken), ("text/model.sdf", "<")]);
        let answer = match read(&content, &mut files) {
            Err(error) => error.to_string(),
            Ok(import) => {
                import.findings.iter().map(|f| format!("{:?} {f}", f.kind)).collect::<Vec<_>>().join("\n")
            }
        };
        assert!(files.opened.iter().all(|path| !path.contains("..")), "{:?}", files.opened);
        said.push(format!("{what}:\n  {}", answer.replace('\n', "\n  ")));
    }
    insta::assert_snapshot!(said.join("\n"));
}

/// Ten files, each of which includes the next one twice: a thousand models, and no more.
#[test]
fn doubling_files_are_refused() {
    let mut files = Shelf::default();
    for i in 0..30 {
        let next = format!("<include><uri>m{}.sdf</uri><name>N</name></include>", i + 1);
        let both = next.replace('N', "a") + &next.replace('N', "b");
        let text = format!("<sdf version='1.9'><model name='m'><link name='l'/>{both}</model></sdf>");
        files.files.insert(format!("m{i}.sdf"), text);
    }
    let error = read("<include><uri>m0.sdf</uri></include>", &mut files).expect_err("too many");
    assert!(error.to_string().contains("more than 1000 files"), "{error}");
    assert!(files.opened.len() <= 1000);
}
