//! Scenes of several texts, figures beside one another, and crowds.

use nalgebra::Vector3;
use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec};
use solaris_scene::{Loader, NoFiles, Scene, read};
use std::collections::HashMap;
use std::fmt::Write;

/// Texts by their names.
struct Shelf(HashMap<&'static str, &'static str>);

impl Loader for Shelf {
    fn figure(&mut self, _path: &str) -> Result<Figure, String> {
        Err("no figures".to_owned())
    }

    fn text(&mut self, path: &str) -> Result<String, String> {
        self.0.get(path).map(|text| (*text).to_owned()).ok_or_else(|| "there is no such file".to_owned())
    }
}

const BLOCK: &str = "Scene(version: 1, figures: {\"block\": Figure(name: \"block\", links: [\n    Link(name: \"box\", joint: Joint(name: \"rail\", axes: [tx, tz]), mass: 1)])},\n    start: {\"tx\": 1}, drives: {\"*\": Frozen})";

fn included(texts: &[(&'static str, &'static str)], scene: &str) -> Result<Scene, String> {
    read(scene, &mut Shelf(texts.iter().copied().collect())).map_err(|error| error.to_string())
}

#[test]
fn what_is_included_comes_first_and_once() {
    let inner = "Scene(version: 1, include: [\"block.ron\"], drives: {\"rail.*\": Free}, pushes: [Push(link: \"box\", force: (1, 0, 0))])";
    let texts = [("block.ron", BLOCK), ("inner.ron", inner)];
    let scene = "Scene(version: 1, include: [\"inner.ron\", \"block.ron\"], duration: 1, start: {\"rail.tx\": 2, \"rail.tz\": 3}, drives: {\"*.tz\": Frozen})";
    let error = included(&texts, scene).expect_err("tx of the block is no name");
    assert_eq!(
        error,
        "line 1, column 29: 'block.ron', line 3, column 13: figure 'block' has no degree of freedom or joint 'tx'"
    );
    let block = BLOCK.replace("\"tx\"", "\"rail\"");
    let block: &'static str = Box::leak(block.into_boxed_str());
    let scene = included(&[("block.ron", block), ("inner.ron", inner)], scene).expect("a scene");
    assert_eq!(scene.simulation().state().0, &[2.0, 3.0]);
    // Of two patterns the later wins, and the scene's own stand last.
    let drives: Vec<&str> = (0..2).map(|dof| scene.simulation().driven_by(dof)[0].drive.name()).collect();
    assert_eq!(drives, ["free", "frozen"]);
    let last = scene.simulate(&mut ()).expect("runs").motion;
    assert!((last.q(last.len() - 1)[0] - 2.5).abs() < 1e-9);
}

#[test]
fn faults_of_includes_name_file_line_and_column() {
    let texts = [
        ("round.ron", "Scene(version: 1, include: [\"again.ron\"])"),
        ("again.ron", "Scene(version: 1,\n  include: [\"round.ron\"])"),
        ("self.ron", "Scene(version: 1, include: [\"self.ron\"])"),
        ("broken.ron", "Scene(version: 1,\n  drives: {"),
        ("figure.ron", "Figure(version: 1)"),
        ("long.ron", "Scene(version: 1, duration: 2)"),
        ("wrong.ron", "Scene(version: 1,\n    gravty: (0, 0, 0))"),
        (
            "block.ron",
            "Scene(version: 1, figures: {\"b\": Figure(name: \"b\", links: [Link(name: \"b\", joint: Joint(name: \"r\", axes: [tx]), mass: 1)])})",
        ),
    ];
    let mut said = String::new();
    for list in [
        "\"block.ron\"",
        "[3]",
        "[\"nothing.ron\"]",
        "[\"round.ron\"]",
        "[\"self.ron\"]",
        "[\"broken.ron\"]",
        "[\"block.ron\", \"figure.ron\"]",
        "[\"block.ron\", \"long.ron\"]",
        "[\"block.ron\", \"wrong.ron\"]",
        "[\"block.ron\", \"block.ron\"]",
    ] {
        let scene = format!("Scene(version: 1, duration: 1,\n  include: {list})");
        let found = included(&texts, &scene).map_or_else(|error| error, |_| "no fault".to_owned());
        let _ = write!(said, "include: {list}\n{found}\n\n");
    }
    let plain =
        read("Scene(version: 1, duration: 1, include: [\"a.ron\"])", &mut NoFiles).expect_err("no files");
    let _ = writeln!(said, "{plain}");
    insta::assert_snapshot!(said);
}

fn placed(places: &str) -> Result<Vec<Vector3<f64>>, String> {
    let slab = "Figure(name: \"slab\", links: [Link(name: \"box\", joint: Joint(name: \"rail\", axes: [tx]), mass: 1)])";
    let text = format!(
        "Scene(version: 1, duration: 1, figures: {{\"a\": {slab}, \"b\": {slab}, \"c\": {slab}}},\n places: {places}, start: {{\"*\": 0.5}})"
    );
    let scene = read(&text, &mut NoFiles).map_err(|error| error.to_string())?;
    let figure = scene.figure();
    let tree = Tree::<f64>::new(figure, Vector3::zeros()).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    forward_kinematics(&tree, &mut workspace, scene.simulation().state().0).expect("finite");
    let at = |name: &str| workspace.pose(figure.link_index(name).expect("a link")).translation;
    Ok(["a.box", "b.box", "c.box"].map(at).to_vec())
}

#[test]
fn figures_stand_beside_one_another() {
    // b stands a metre in front of a, who faces to the left, +x, and looks back at it; c half a metre to the left of b.
    let text = "{\"c\": (beside: \"b\", at: (0.5, 0, 0)), \"b\": (beside: \"a\", at: (0, 0, 1), facing: deg(180)), \"a\": (at: (2, 0, 0), facing: deg(90))}";
    let found = placed(text).expect("places");
    // Each is half a metre along its own left.
    let expected = [(2.0, 0.0, -0.5), (3.0, 0.0, 0.5), (3.0, 0.0, 1.0)];
    for (found, (x, y, z)) in found.iter().zip(expected) {
        assert!((found - Vector3::new(x, y, z)).norm() < 1e-12, "{found}");
    }
    let mut said = String::new();
    for places in [
        "{\"a\": (beside: \"a\")}",
        "{\"a\": (beside: \"b\"), \"b\": (beside: \"c\"), \"c\": (beside: \"a\", at: (1, 0, 0))}",
        "{\"a\": (beside: \"d\")}",
        "{\"a\": (beside: 3, besid: \"b\")}",
    ] {
        let _ = write!(said, "{places}\n{}\n\n", placed(places).expect_err("refused"));
    }
    insta::assert_snapshot!(said);
}

/// A loader of one robot whose file has z up and x forward.
struct Robot;

impl Loader for Robot {
    fn figure(&mut self, _: &str) -> Result<Figure, String> {
        let mast = LinkSpec::root("mast", Joint::new("mast")).mass(2.0).com(Vector3::new(0.1, 0.0, 0.5));
        let arm = Joint::new("arm").at(Vector3::new(0.0, 0.0, 1.0)).ry();
        let arm = LinkSpec::child("arm", "mast", arm).mass(1.0).com(Vector3::new(0.5, 0.0, 0.0));
        let builder = FigureBuilder::new("robot").gravity(Vector3::new(0.0, 0.0, -9.81)).link(mast).link(arm);
        builder.build().map_err(|error| error.to_string())
    }
}

/// A robot whose file has z up stands beside people, faces as they do, and its dynamics are those that it has alone.
#[test]
fn a_robot_with_z_up_stands_upright_beside_people() {
    let scene = |figures: &str, fields: &str| {
        let text = format!("Scene(version: 1, duration: 0.5, figures: {{{figures}}}, {fields})");
        read(&text, &mut Robot).map_err(|error| error.to_string())
    };
    let ann = "\"ann\": Human(height: 1.75, mass: 73)";
    let robot = "\"robot\": File(\"robot.urdf\")";
    let alone = scene(robot, "method: RungeKutta4(step: 1e-3)").expect("a scene");
    assert_eq!(*alone.simulation().gravity(), Vector3::new(0.0, 0.0, -9.81));
    let alone = alone.simulation().run(&alone.settings().clone()).expect("runs").motion;
    for (both, first) in [(format!("{robot}, {ann}"), true), (format!("{ann}, {robot}"), false)] {
        let fields = "method: RungeKutta4(step: 1e-3), drives: {\"ann.*\": Frozen}, gravity: (0, -9.81, 0), places: {\"robot\": (at: (1, 0, 0.5))}";
        let scene = scene(&both, fields).expect("a scene");
        let figure = scene.figure();
        let tree = Tree::<f64>::new(figure, Vector3::zeros()).expect("a tree");
        let mut workspace = Workspace::new(&tree);
        forward_kinematics(&tree, &mut workspace, scene.simulation().state().0).expect("finite");
        let pose = workspace.pose(figure.link_index("robot.mast").expect("a link"));
        // Its x is forward, its z up.
        let com = pose.transform(&Vector3::new(0.1, 0.0, 0.5));
        assert!((com - Vector3::new(1.0, 0.5, 0.6)).norm() < 1e-12, "{com}");
        assert!(scene.notes().iter().any(|note| note.starts_with("'robot' is stood upright")));
        let motion = scene.simulation().run(&scene.settings().clone()).expect("runs").motion;
        let arm = figure.layout().dof_index("robot.arm.ry").expect("a joint");
        for frame in 0..motion.len() {
            assert!((motion.q(frame)[arm] - alone.q(frame)[0]).abs() < 1e-12, "{first} {frame}");
        }
    }
    // People say which way is up where the scene does not.
    let mixed = scene(&format!("{robot}, {ann}"), "drives: {\"*\": Frozen}").expect("a scene");
    assert_eq!(*mixed.simulation().gravity(), Vector3::new(0.0, -9.80665, 0.0));
    // Turned as the scene says: on its side, and not where that is not upright for who walks.
    let lies = "drives: {\"*\": Frozen}, places: {\"robot\": (turned: About(axis: (1, 0, 0), angle: 0))}";
    let scene_of = scene(&format!("{robot}, {ann}"), lies).expect("a scene");
    assert!(scene_of.notes().is_empty(), "{:?}", scene_of.notes());
    let walks =
        "walk: {\"ann\": Walk(steps: 4)}, places: {\"ann\": (turned: About(axis: (1, 0, 0), angle: 1))}";
    let error = scene(&format!("{robot}, {ann}"), walks).expect_err("refused");
    assert!(error.contains("a walk begins upright; leave 'turned' out of the place of 'ann'"), "{error}");
}

/// One figure is turned too, and who stands beside it is not.
#[test]
fn a_figure_is_turned_where_it_stands() {
    let found = placed("{\"a\": (at: (0, 1, 0), turned: About(axis: (0, 0, 1), angle: deg(90))), \"b\": (beside: \"a\", at: (0, 0, 1))}")
        .expect("places");
    // Half a metre along what was its x.
    assert!((found[0] - Vector3::new(0.0, 1.5, 0.0)).norm() < 1e-12, "{}", found[0]);
    assert!((found[1] - Vector3::new(0.5, 1.0, 1.0)).norm() < 1e-12, "{}", found[1]);
}

#[test]
fn a_crowd_is_many_people_in_rows() {
    let scene = |crowd: &str, places: &str| {
        format!(
            "Scene(version: 1, duration: 0.1, figures: {{\"crowd\": {crowd}}}, places: {{{places}}}, drives: {{\"*\": Frozen}})"
        )
    };
    let read = |crowd: &str, places: &str| {
        read(&scene(crowd, places), &mut NoFiles).map_err(|error| error.to_string())
    };
    let five = read(
        "Crowd(count: 5, seed: 3, columns: 2, apart: 1.2)",
        "\"crowd\": (at: (1, 0, 0)), \"crowd5\": (at: (9, 0, 0))",
    )
    .expect("people");
    let figure = five.figure();
    assert_eq!(figure.layout().nv(), 5 * 66);
    let at = |i: usize| {
        let link = figure.link_index(&format!("crowd{i}.pelvis")).expect("a pelvis");
        figure.links()[link].joint().placement().translation.vector
    };
    let expected = [(0.4, 0.0), (1.6, 0.0), (0.4, -1.2), (1.6, -1.2), (9.0, 0.0)];
    for (i, (x, z)) in expected.into_iter().enumerate() {
        assert!((at(i + 1) - Vector3::new(x, 0.0, z)).norm() < 1e-12, "{}", at(i + 1));
    }
    // The same seed is the same people; another is not.
    let mass = |crowd: &str| read(crowd, "").expect("people").figure().mass();
    assert!((mass("Crowd(count: 3, seed: 3)") - mass("Crowd(count: 3, seed: 3, apart: 2)")).abs() < 1e-12);
    assert!((mass("Crowd(count: 3, seed: 3)") - mass("Crowd(count: 3, seed: 4)")).abs() > 0.1);
    assert!(mass("Crowd(count: 3, age: 8)") < 110.0);
    let mut said = String::new();
    for crowd in [
        "Crowd",
        "Crowd(count: 0)",
        "Crowd(count: 2.5, seed: -1)",
        "Crowd(count: 3, apart: 0, colums: 2)",
        "Crowd(count: 3, joints: Lim)",
        "Crowd(count: 2, age: 3)",
    ] {
        let found = read(crowd, "").map_or_else(|error| error, |_| "no fault".to_owned());
        let _ = write!(said, "{crowd}\n{found}\n\n");
    }
    let twice = "Scene(version: 1, duration: 1, figures: {\"a1\": Human(height: 1.7, mass: 60), \"a\": Crowd(count: 2)}, walk: Walk(steps: 3))";
    let _ = writeln!(said, "{}", solaris_scene::read(twice, &mut NoFiles).expect_err("refused"));
    insta::assert_snapshot!(said);
}

/// Texts that are there under every name, and say nothing.
struct Anything;

impl Loader for Anything {
    fn figure(&mut self, _path: &str) -> Result<Figure, String> {
        Err("no figures".to_owned())
    }

    fn text(&mut self, _path: &str) -> Result<String, String> {
        Ok("Scene(version: 1)".to_owned())
    }
}

#[test]
fn two_hundred_texts_are_included_and_no_more() {
    let scene = |count: usize| {
        let names: Vec<String> = (0..count).map(|i| format!("\"{i}.ron\"")).collect();
        BLOCK
            .replace(
                "version: 1, figures",
                &format!("version: 1, duration: 1, include: [{}], figures", names.join(", ")),
            )
            .replace("\"tx\"", "\"rail\"")
    };
    let said = |count| read(&scene(count), &mut Anything).map_err(|error| error.to_string());
    assert!(said(200).is_ok(), "{:?}", said(200).err());
    let error = said(201).expect_err("too many");
    assert!(error.contains("200"), "{error}");
}
