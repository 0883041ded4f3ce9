//! A crane with every way that SDF has to say where something stands, against what Drake finds for it (`models/drake.json`);
//! and joints by numbers that can be checked by hand.

use crate::data::numbers;
use serde_json::Value;
use solaris_dynamics::{DMatrix, Tree, Workspace, inverse_dynamics, mass_matrix};
use solaris_io::{Import, sdf};
use solaris_model::{FindingKind, JointKind, Limits, TieLaw, Vector3};

fn crane() -> Import {
    sdf::read(include_str!("models/crane.sdf")).unwrap_or_else(|error| panic!("{error}"))
}

/// Total mass (without the static plate of 1 kg), mass matrix and forces to 1e-13 of the largest.
#[test]
fn the_crane_has_the_mass_matrix_and_needs_the_forces_of_drake() {
    let import = crane();
    let figure = &import.figure;
    let reference: Value = serde_json::from_str(include_str!("models/drake.json")).expect("JSON");
    assert!((figure.mass() - (reference["mass"].as_f64().expect("a number") - 1.0)).abs() < 1e-13);
    assert_eq!(import.gravity, Vector3::new(0.3, 0.0, -9.81));
    let dofs: Vec<usize> = reference["dofs"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|name| figure.layout().dof_index(name.as_str().expect("a name")).expect("a dof"))
        .collect();
    let n = dofs.len();
    assert_eq!(figure.layout().nv(), n);
    let tree = Tree::<f64>::new(figure, import.gravity).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    for sample in reference["samples"].as_array().expect("a list") {
        let [q, v, a] = ["q", "v", "a"].map(|name| {
            let mut ours = vec![0.0; n];
            dofs.iter().zip(numbers(&sample[name])).for_each(|(&at, value)| ours[at] = value);
            ours
        });
        let (mut tau, mut matrix) = (vec![0.0; n], DMatrix::zeros(n, n));
        inverse_dynamics(&tree, &mut workspace, &q, &v, &a, &[], &mut tau).expect("forces");
        mass_matrix(&tree, &mut workspace, &q, &mut matrix).expect("a matrix");
        let close = |found: &[f64], expected: &[f64]| {
            let scale = expected.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
            found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-13 * scale)
        };
        let tau: Vec<f64> = dofs.iter().map(|&dof| tau[dof]).collect();
        assert!(close(&tau, &numbers(&sample["tau"])), "{tau:?}");
        let matrix: Vec<f64> =
            dofs.iter().flat_map(|&i| dofs.iter().map(move |&j| (i, j))).map(|at| matrix[at]).collect();
        assert!(close(&matrix, &numbers(&sample["M"])), "{matrix:?}");
    }
}

#[test]
fn what_the_file_says_is_in_the_figure_or_in_the_findings() {
    let import = crane();
    let figure = &import.figure;
    let links: Vec<&str> = figure.links().iter().map(solaris_model::Link::name).collect();
    assert_eq!(links, ["tower", "jib", "trolley", "hook::block", "hook::claw"]);
    assert_eq!(figure.name(), "crane");
    let tower = &figure.links()[0];
    let dof = &tower.joint().kind().axes()[0];
    assert_eq!(dof.limits, Some(Limits { lower: -2.5, upper: f64::INFINITY }));
    assert_eq!((dof.passive.stiffness, dof.passive.rest, dof.passive.damping), (3.0, 0.2, 0.5));
    assert!(tower.frames().iter().any(|frame| frame.name == "foot"));
    assert!(tower.shape().is_some());
    // A continuous joint has none, and what is beyond all bounds is none.
    let limits = |name: &str| figure.link(name).expect("a link").joint().kind().axes()[0].limits;
    assert_eq!(limits("hook::claw"), None);
    assert_eq!(limits("trolley"), Some(Limits { lower: f64::NEG_INFINITY, upper: 0.8 }));
    assert_eq!(figure.locate("hook::lamp").map(|(link, _)| links[link]), Some("hook::block"));
    let said: Vec<String> =
        import.findings.iter().map(|finding| format!("{:?}: {finding}", finding.kind)).collect();
    insta::assert_snapshot!(said.join("\n"));
}

fn model(content: &str) -> String {
    format!("<sdf version='1.9'>\n<model name='m'>\n{content}\n</model>\n</sdf>")
}

fn link(name: &str, rest: &str) -> String {
    format!(
        "<link name='{name}'>{rest}<inertial><mass>2</mass><inertia><ixx>0.1</ixx><iyy>0.2</iyy><izz>0.25</izz></inertia></inertial>\
         </link>\n"
    )
}

fn joint(name: &str, kind: &str, parent: &str, child: &str, rest: &str) -> String {
    format!(
        "<joint name='{name}' type='{kind}'><parent>{parent}</parent><child>{child}</child>{rest}</joint>\n"
    )
}

fn read(content: &str) -> Import {
    sdf::read(&model(content)).unwrap_or_else(|error| panic!("{error}"))
}

fn suspects(import: &Import) -> Vec<String> {
    let wrong = |kind| matches!(kind, FindingKind::Missing | FindingKind::Suspect);
    let suspects = import.findings.iter().filter(|finding| wrong(finding.kind));
    suspects.map(ToString::to_string).collect()
}

#[test]
fn what_no_joint_holds_is_free() {
    let import = read(&link("a", "<pose>1 2 3 0 0 0</pose>"));
    let root = import.figure.links()[0].joint();
    assert!(matches!(root.kind(), JointKind::Free { .. }) && root.name() == "root");
    assert!(import.findings[0].message.contains("(1, 2, 3) m"), "{:?}", import.findings);
    assert!(suspects(&import).is_empty());
    // Two of them.
    let both = read(&(link("a", "") + &link("b", "")));
    assert_eq!(both.figure.layout().nv(), 12);
    assert_eq!(both.figure.layout().v_names()[6], "b_root.vx");
}

/// `v = ω·pitch/2π`: the mass matrix with the slide folded in is `Izz + m·(pitch/2π)²`.
#[test]
fn the_slide_of_a_screw_follows_its_turn() {
    for (pitch, lead) in [
        ("<screw_thread_pitch>0.5</screw_thread_pitch>", 0.5 / std::f64::consts::TAU),
        ("<thread_pitch>-4</thread_pitch>", 0.25),
    ] {
        let screw = joint("j", "screw", "world", "a", &format!("<axis><xyz>0 0 2</xyz></axis>{pitch}"));
        let figure = read(&(link("a", "") + &screw)).figure;
        assert_eq!(figure.layout().v_names(), ["j", "j.slide"]);
        let tree = Tree::<f64>::new(&figure, Vector3::new(0.0, 0.0, -9.81)).expect("a tree");
        let (mut workspace, mut tau) = (Workspace::new(&tree), [0.0; 2]);
        let (mut q, mut v, mut a) = ([0.3, 0.0], [0.0; 2], [1.0, 0.0]);
        figure.follow(&mut q, &mut v, &mut a);
        inverse_dynamics(&tree, &mut workspace, &q, &v, &a, &[], &mut tau).expect("forces");
        figure.fold_forces(&q, &mut tau);
        assert!((tau[0] - (0.25 + 2.0 * lead * lead + 2.0 * 9.81 * lead)).abs() < 1e-14, "{tau:?}");
    }
}

/// The second joint is left open, and said to be.
#[test]
fn a_loop_is_opened_by_name() {
    let axis = "<axis><xyz>0 1 0</xyz></axis>";
    let links: String = ["a", "b", "c"].map(|name| link(name, "")).concat();
    let joints = joint("wa", "revolute", "world", "a", axis)
        + &joint("ab", "revolute", "a", "b", axis)
        + &joint("ac", "revolute", "a", "c", axis)
        + &joint("bc", "revolute", "b", "c", axis);
    let import = read(&(links + &joints));
    assert_eq!(import.figure.layout().v_names(), ["wa", "ab", "ac"]);
    assert_eq!(
        suspects(&import),
        [
            "line 9, column 14: bc: it closes a loop at 'c', which joint 'ac' holds already; it is left open, and its forces are \
          missing: those of other joints differ from the closed mechanism's"
        ]
    );
}

/// By its hinge two points of the axis, in the frames of both links, which stand where the file says; a slider is none of two points.
#[test]
fn loops_are_told_as_what_holds_them_together() {
    let axis = "<axis><xyz>0 1 0</xyz></axis>";
    let links =
        link("a", "<pose>0 0 1 0 0 0</pose>") + &link("b", "<pose>1 0 1 0 0 1.5707963267948966</pose>");
    let joints = joint("wa", "revolute", "world", "a", axis) + &joint("wb", "revolute", "world", "b", axis);
    let found = |closing: &str| {
        let text = format!("<sdf version='1.10'><model name='m'>{links}{joints}{closing}</model></sdf>");
        solaris_io::sdf::ties(&text, &mut solaris_io::NoFiles).expect("valid")
    };
    let hinge = found(&joint(
        "ab",
        "revolute",
        "a",
        "b",
        "<pose>0.2 0.3 0 0 0 0</pose><axis><xyz>1 0 0</xyz></axis>",
    ));
    let points: Vec<_> = hinge.iter().map(|tie| tie.between.clone().map(|end| end.point)).collect();
    let names: Vec<_> = hinge[0].between.iter().map(|end| end.link.as_deref()).collect();
    assert_eq!(names, [Some("a"), Some("b")]);
    assert_eq!(hinge.len(), 2);
    // In b's own frame, which is turned by a quarter against a's: its x is a's y.
    let expected = [
        [Vector3::new(0.7, 0.2, 0.0), Vector3::new(0.2, 0.3, 0.0)],
        [Vector3::new(0.7, 1.2, 0.0), Vector3::new(1.2, 0.3, 0.0)],
    ];
    for (found, expected) in points.iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).norm() < 1e-12, "{found} {expected}");
    }
    assert_eq!(found(&joint("ab", "ball", "a", "b", ""))[0].law, TieLaw::Points);
    assert!(matches!(found(&joint("ab", "prismatic", "a", "b", axis))[0].law, TieLaw::Other(_)));
    assert_eq!(found("").len(), 0);
}

/// Mass of the static link does not count, and joints to it are joints to the world.
#[test]
fn static_models_are_the_world() {
    let text = format!(
        "<sdf version='1.10'><world name='w'><model name='bench'><static>true</static><pose>0 0 1 0 0 0</pose>{}</model>\
         <model name='arm'>{}</model>{}</world></sdf>",
        link("top", ""),
        link("a", ""),
        joint("hinge", "revolute", "bench::top", "arm::a", "<axis><xyz>0 1 0</xyz></axis>")
    );
    let import = sdf::read(&text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((import.figure.mass(), import.figure.layout().v_names()), (2.0, &["hinge".to_owned()][..]));
    assert_eq!(import.gravity, Vector3::new(0.0, 0.0, -9.8));
    // Nothing else than static: it stands.
    let alone = sdf::read(&model(&format!("<static>1</static>{}", link("a", "")))).expect("a figure");
    assert_eq!((alone.figure.layout().nv(), alone.figure.mass()), (0, 2.0));
}

/// Before version 1.5 axes are along the model's; 1.5 and 1.6 say so, later ones name a frame.
#[test]
fn older_versions_have_their_axes_elsewhere() {
    let axis = |rest: &str| format!("<axis><xyz>1 0 0</xyz>{rest}</axis>");
    let turned = link("a", "<pose>0 0 0 0 0 1.5707963267948966</pose>");
    let direction = |version: &str, axis: &str| {
        let text = model(&(turned.clone() + &joint("j", "revolute", "world", "a", axis)));
        let figure =
            sdf::read(&text.replace("1.9", version)).unwrap_or_else(|error| panic!("{error}")).figure;
        let joint = figure.links()[0].joint();
        joint.placement().rotation * joint.kind().axes()[0].axis.direction
    };
    let own = Vector3::y();
    let of_model = "<use_parent_model_frame>true</use_parent_model_frame>";
    for (version, axis, expected) in [
        ("1.4", axis(""), Vector3::x()),
        ("1.5", axis(""), own),
        ("1.6", axis(of_model), Vector3::x()),
        ("1.7", axis(""), own),
        ("1.7", axis("").replace("<xyz>", "<xyz expressed_in='__model__'>"), Vector3::x()),
    ] {
        assert!((direction(version, &axis) - expected).norm() < 1e-15, "{version} {axis}");
    }
}
