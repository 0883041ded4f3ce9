//! Every fault of a figure is found, and says what to do.

use solaris_model::{
    Axis, Curve, Fault, Figure, FigureBuilder, FigureError, Inertia, Joint, LinkSpec, Matrix3, NamedFrame,
    Passive, Placement, Shape, ShapeKind, SolePart, Vector3,
};
use std::collections::HashSet;
use std::mem::discriminant;

const NAN: f64 = f64::NAN;

fn root(name: &str) -> LinkSpec {
    LinkSpec::root(name, Joint::new(format!("{name}_joint")).rx()).mass(1.0)
}

fn child(name: &str, parent: &str) -> LinkSpec {
    LinkSpec::child(name, parent, Joint::new(format!("{name}_joint")).rx()).mass(1.0)
}

fn with(links: impl IntoIterator<Item = LinkSpec>) -> FigureBuilder {
    links.into_iter().fold(FigureBuilder::new("f"), FigureBuilder::link)
}

fn hinge(joint: Joint) -> FigureBuilder {
    with([LinkSpec::root("a", joint).mass(1.0)])
}

fn tensor(rows: [[f64; 3]; 3]) -> Inertia {
    Inertia::Tensor(Matrix3::from_fn(|i, j| rows[i][j]))
}

fn capsule(radius: f64, length: f64) -> Shape {
    Shape { kind: ShapeKind::Capsule { radius, length }, placement: Placement::identity() }
}

fn line() -> Curve {
    Curve::linear(1.0, 0.0)
}

/// A figure for every fault, with the part of the tree or of a link that is wrong.
fn broken() -> Vec<(&'static str, FigureBuilder)> {
    let seven = (0..7).fold(Joint::new("many"), |joint, _| joint.tx());
    let diagonal = |x, y, z| tensor([[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]);
    let heel = Vector3::new(0.0, NAN, 0.0);
    let mut no_rotation = Placement::identity();
    no_rotation.rotation.as_mut_unchecked().coords.fill(0.0);
    let skewed = tensor([[1.0, 0.1, 0.0], [0.2, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    vec![
        ("no links", with([])),
        ("no root", with([child("a", "b"), child("b", "a")])),
        ("two roots", with([root("a"), root("b")])),
        ("cycle", with([root("a"), child("b", "d"), child("c", "b"), child("d", "c"), child("e", "d")])),
        ("own parent", with([root("a"), child("b", "b")])),
        ("link twice", with([root("a"), child("b", "a"), child("b", "a")])),
        ("empty name", with([root("a"), child(" ", "a")])),
        ("unknown parent", with([root("trunk"), child("arm", "trnk")])),
        ("unknown parent, nothing near", with([root("trunk"), child("arm", "zebra")])),
        ("stature", with([root("a")]).stature(0.0)),
        ("gravity", with([root("a")]).gravity(Vector3::new(0.0, NAN, 0.0))),
        ("mass", with([root("a").mass(NAN)])),
        ("centre of mass", with([root("a").com(Vector3::new(0.0, f64::INFINITY, 0.0))])),
        ("inertia", with([root("a").inertia(diagonal(NAN, 1.0, 1.0))])),
        ("inertia beyond the range", with([root("a").inertia(diagonal(-1e308, 1.0, 1.0))])),
        (
            "solid beyond the range",
            with([root("a").mass(1e200).inertia(Inertia::Uniform(capsule(1e60, 1e60)))]),
        ),
        ("radius without measure", with([root("a").shape(capsule(1e200, 0.3))])),
        ("length of a solid", with([root("a").mass(1.0).inertia(Inertia::Uniform(capsule(0.1, 1.1e9)))])),
        ("far away", hinge(Joint::new("j").at(Vector3::new(0.0, -1.1e9, 0.0)).rx())),
        ("mass without measure", with([root("a").mass(1.1e20)])),
        ("stature without measure", with([root("a")]).stature(1.1e9)),
        ("origin", hinge(Joint::new("j").at(Vector3::new(NAN, 0.0, 0.0)).rx())),
        ("tip", with([root("a").tip(Vector3::new(0.0, -f64::INFINITY, 0.0))])),
        ("sole", with([root("a").sole(SolePart::Heel, heel)])),
        ("frame", with([root("a").frame("marker", Placement::translation(NAN, 0.0, 0.0))])),
        ("negative mass", with([root("a").mass(-2.5)])),
        ("skewed inertia", with([root("a").inertia(skewed)])),
        ("flat shape", with([root("a").inertia(Inertia::Uniform(capsule(0.0, 0.3)))])),
        ("drawn shape", with([root("a").shape(capsule(0.1, -0.3))])),
        ("no axis", hinge(Joint::new("j").rx().axis(Axis::rotation(Vector3::zeros())))),
        ("turned by nothing", hinge(Joint::new("j").placed(no_rotation).rx())),
        ("limits", hinge(Joint::new("j").rx().rx().limited(0.5, -0.5))),
        ("limits without order", hinge(Joint::new("j").rx().limited(NAN, 0.5))),
        ("seven dofs", hinge(seven)),
        ("axis of a ball", hinge(Joint::ball("j").rx())),
        ("limits of nothing", hinge(Joint::new("j").limited(0.0, 1.0).rx())),
        ("armature", hinge(Joint::new("j").rx().armature(-0.1))),
        ("armature of a ball", hinge(Joint::ball("j").armature(NAN))),
        ("damping", hinge(Joint::new("j").rx().passive(Passive { damping: -0.1, ..Passive::default() }))),
        (
            "spring of a free joint",
            hinge(Joint::free("j").passive(Passive { stiffness: 1.0, ..Passive::default() })),
        ),
        ("no leader", hinge(Joint::new("j").rx().tx().following("j.ry", line()))),
        ("follows itself", hinge(Joint::new("j").rx().following("j.rx", line()))),
        ("no curve", hinge(Joint::new("j").rx().tx().following("j.rx", Curve::Polynomial(vec![NAN])))),
        ("dof twice", hinge(Joint::new("j").rx().named("flexion").ry().named("flexion"))),
        ("angle of a ball", hinge(Joint::ball("j")).angle("swing", "j.wx", false)),
        ("angle", with([root("knee")]).angle("knee.flexion", "knee_joint.ry", false)),
    ]
}

fn error(builder: FigureBuilder) -> FigureError {
    builder.build().expect_err("a broken figure")
}

#[test]
fn every_fault_says_what_and_what_to_do() {
    let answers: Vec<String> =
        broken().into_iter().map(|(what, builder)| format!("[{what}] {}", error(builder))).collect();
    insta::assert_snapshot!(answers.join("\n"));
}

#[test]
fn no_kind_of_fault_is_left_out_above() {
    let provoked: HashSet<_> = broken()
        .into_iter()
        .flat_map(|(_, builder)| error(builder).faults)
        .map(|fault| discriminant(&fault))
        .collect();
    let known = include_str!("../../src/fault.rs").matches("#[error(").count();
    assert_eq!(provoked.len(), known, "a new fault needs a broken figure here");
}

#[test]
fn all_faults_are_found_at_once() {
    let builder = with([
        root("trunk").mass(-1.0),
        child("arm", "trnk").com(Vector3::new(NAN, 0.0, 0.0)),
        LinkSpec::child("hand", "arm", Joint::new("trunk_joint").rx().limited(1.0, 0.0)).mass(0.1),
        LinkSpec::child("finger", "hand", Joint::new("finger").axis(Axis::translation(Vector3::zeros())))
            .mass(0.1),
        root("second"),
    ])
    .angle("elbow.flexion", "elbow.rx", false)
    .angle("elbow.flexion", "arm_joint.rx", true);
    insta::assert_snapshot!(error(builder));
}

#[test]
fn nothing_is_called_a_fault_that_is_none() {
    let flat = Inertia::diagonal(1.0, 2.0, 3.0);
    let figure = with([
        // Children before parents, a thin plate, a massless link that a weld holds and one that carries mass.
        child("c", "b"),
        child("b", "a").mass(0.0).inertia(Inertia::Point),
        root("a").inertia(flat),
        LinkSpec::child("marker", "a", Joint::new("weld")),
    ])
    .angle("flexion", "c_joint.rx", true)
    .build()
    .expect("all of this is allowed");
    let names: Vec<&str> = figure.links().iter().map(solaris_model::Link::name).collect();
    assert_eq!(names, ["a", "b", "c", "marker"]);
    let angle = figure.anatomical_angle("flexion").expect("it was named");
    assert_eq!((angle.dof, angle.sign), (2, -1.0));
}

#[test]
fn one_fault_in_the_tree_does_not_hide_the_numbers() {
    let faults = error(with([root("a"), child("b", "x").mass(NAN)])).faults;
    assert!(matches!(&faults[..], [Fault::NotFinite { .. }, Fault::UnknownParent { .. }]), "{faults:?}");
}

#[test]
fn frames_keep_their_place() {
    let placement = Placement::translation(0.1, 0.2, 0.3);
    let figure = with([root("a").frame("marker", placement)]).build().expect("valid");
    let frame = NamedFrame { name: "marker".to_owned(), placement };
    assert_eq!(figure.links()[0].frames(), [frame]);
}

#[test]
fn names_follow_from_the_axes_whatever_their_length() {
    let figure = hinge(Joint::new("j").axis(Axis::rotation(Vector3::new(2.0, 0.0, 0.0))).rz())
        .angle("a.flexion", "j.rx", true)
        .build()
        .expect("a figure");
    assert_eq!(figure.layout().v_names()[0], "j.rx");
    assert_eq!(figure.anatomical_angles().len(), 1);
}

#[test]
fn a_one_dof_joint_answers_to_its_name_unless_a_dof_has_it() {
    let figure = with([
        root("a"),
        LinkSpec::child("b", "a", Joint::new("j.ry").rz()).mass(1.0),
        LinkSpec::child("c", "a", Joint::new("j").rx().ry()).mass(1.0),
        LinkSpec::child("d", "a", Joint::new("knee").rx()).mass(1.0),
    ])
    .angle("knee.flexion", "knee", false)
    .build()
    .expect("a figure");
    let layout = figure.layout();
    let named = |name: &str| layout.dof_index(name).map(|dof| layout.v_names()[dof].as_str());
    assert_eq!(named("j.ry"), Some("j.ry"));
    assert_eq!(named("knee"), Some("knee.rx"));
    assert_eq!(figure.anatomical_angles()[0].name, "knee.flexion");
}

#[test]
fn what_follows_from_the_largest_lengths_and_masses_is_finite() {
    let most = Figure::LONGEST;
    let shapes = [
        ShapeKind::Box { size: Vector3::repeat(most) },
        ShapeKind::Cylinder { radius: most, length: most },
        ShapeKind::Ellipsoid { radii: Vector3::repeat(most) },
        ShapeKind::Capsule { radius: most, length: most },
        ShapeKind::Sphere { radius: most },
    ];
    for kind in shapes {
        let far = Vector3::repeat(most);
        let shape = Shape { kind, placement: Placement::translation(far.x, far.y, far.z) };
        let link = |name: &str, joint| {
            LinkSpec::child(name, "a", joint).mass(Figure::HEAVIEST).inertia(Inertia::Uniform(shape)).tip(far)
        };
        let root = LinkSpec::root("a", Joint::new("r").at(far).rx())
            .mass(Figure::HEAVIEST)
            .inertia(Inertia::Uniform(shape));
        let figure = FigureBuilder::new("f").link(root).link(link("b", Joint::new("j").at(far).rx()));
        let figure = figure.stature(most).build().expect("at the limits");
        assert!(
            kind.volume().is_finite()
                && figure.mass().is_finite()
                && figure.extent(&Vector3::y()).height.is_finite()
        );
        for link in figure.links() {
            assert!(link.inertia().iter().all(|entry| entry.is_finite()), "{kind:?}");
        }
    }
}
