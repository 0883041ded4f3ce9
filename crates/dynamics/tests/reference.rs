//! Every operation against the numbers of another engine; see `fixtures/reference`.

mod support;

use nalgebra::{Matrix3, Rotation3, Translation3, UnitQuaternion, Vector3};
use serde::Deserialize;
use solaris_dynamics::{Real, Wrench};
use solaris_model::{Axis, Figure, FigureBuilder, Inertia, Joint, LinkSpec, Placement};
use support::{Kernel, relative_error};

#[derive(Deserialize)]
struct File {
    models: Vec<Model>,
}

#[derive(Deserialize)]
struct Model {
    name: String,
    gravity: [f64; 3],
    joints: Vec<FileJoint>,
    states: Vec<State>,
}

#[derive(Deserialize)]
struct FileJoint {
    name: String,
    parent: i64,
    #[serde(rename = "type")]
    kind: String,
    axis: [f64; 3],
    #[serde(rename = "R")]
    rotation: [f64; 9],
    p: [f64; 3],
    mass: f64,
    com: [f64; 3],
    inertia: [f64; 6],
}

#[derive(Deserialize)]
struct State {
    q: Vec<f64>,
    qd: Vec<f64>,
    qdd: Vec<f64>,
    tau_id: Vec<f64>,
    bias: Vec<f64>,
    grav: Vec<f64>,
    kinetic: f64,
    potential: f64,
    com: [f64; 3],
    #[serde(rename = "M")]
    mass_matrix: Option<Vec<f64>>,
    fext: Option<Vec<[f64; 6]>>,
    tau_id_ext: Option<Vec<f64>>,
}

fn models() -> Vec<Model> {
    let file: File =
        serde_json::from_str(include_str!("../../../fixtures/reference/dynamics.json")).expect("the schema");
    assert_eq!(file.models.len(), 48);
    file.models
}

/// One link a joint, on a welded base: link `i + 1` is body `i` of the file.
fn figure(model: &Model) -> Figure {
    let base = LinkSpec::root("base", Joint::new("base weld"));
    let links = model.joints.iter().map(|joint| {
        let axis = Vector3::from(joint.axis);
        let axis = if joint.kind == "P" { Axis::translation(axis) } else { Axis::rotation(axis) };
        let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_row_slice(&joint.rotation));
        let rotation = UnitQuaternion::from_rotation_matrix(&rotation);
        let placement = Placement::from_parts(Translation3::from(joint.p), rotation);
        let parent = usize::try_from(joint.parent).map_or("base", |parent| &model.joints[parent].name);
        let [xx, xy, xz, yy, yz, zz] = joint.inertia;
        LinkSpec::child(&joint.name, parent, Joint::new(&joint.name).placed(placement).axis(axis))
            .mass(joint.mass)
            .com(Vector3::from(joint.com))
            .inertia(Inertia::Tensor(Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)))
    });
    links
        .fold(FigureBuilder::new(&model.name).link(base), FigureBuilder::link)
        .build()
        .expect("a valid figure")
}

/// The wrenches of the file, which stand in the links' own frames, in world axes about the world's origin.
fn external<T: Real>(kernel: &mut Kernel<T>, q: &[T], wrenches: &[[f64; 6]]) -> Vec<(usize, Wrench<T>)> {
    kernel.place(q);
    let pose = |body: usize| *kernel.workspace.pose(body + 1);
    wrenches
        .iter()
        .enumerate()
        .map(|(body, w)| {
            let turn = |x, y, z| pose(body).rotation * Vector3::new(x, y, z).map(T::from_f64);
            let (moment, force) = (turn(w[0], w[1], w[2]), turn(w[3], w[4], w[5]));
            (body + 1, Wrench::at(&pose(body).translation, force, moment))
        })
        .collect()
}

/// Compares every quantity of every state, each relative to its own largest entry, and tells the worst of each.
fn compare<T: Real + Into<f64>>(tolerance: f64) {
    let mut worst: Vec<(&str, f64, String)> = Vec::new();
    for model in models() {
        let figure = figure(&model);
        let mut kernel = Kernel::<T>::new(&figure, Vector3::from(model.gravity));
        for (number, state) in model.states.iter().enumerate() {
            for (what, error) in errors(&mut kernel, &figure, &model, state) {
                let case = format!("{} state {number}", model.name);
                match worst.iter_mut().find(|(name, ..)| *name == what) {
                    Some(entry) if entry.1 < error => (entry.1, entry.2) = (error, case),
                    Some(_) => {}
                    None => worst.push((what, error, case)),
                }
            }
        }
    }
    assert_eq!(worst.len(), 8, "every quantity is compared");
    assert!(worst.iter().all(|(_, error, _)| *error <= tolerance), "worst errors: {worst:#?}");
}

fn errors<T: Real + Into<f64>>(
    kernel: &mut Kernel<T>,
    figure: &Figure,
    model: &Model,
    state: &State,
) -> Vec<(&'static str, f64)> {
    let narrow = |values: &[f64]| -> Vec<T> { values.iter().map(|&value| T::from_f64(value)).collect() };
    let error = |found: Vec<T>, expected: &[f64]| {
        relative_error(&found.into_iter().map(Into::into).collect::<Vec<f64>>(), expected)
    };
    let (q, v, a) = (narrow(&state.q), narrow(&state.qd), narrow(&state.qdd));
    let at_rest = vec![T::zero(); v.len()];
    let mut errors = vec![
        ("tau", error(kernel.inverse(&q, &v, &a, &[]).expect("valid"), &state.tau_id)),
        ("bias", error(kernel.bias(&q, &v).expect("valid"), &state.bias)),
        ("gravity", error(kernel.bias(&q, &at_rest).expect("valid"), &state.grav)),
        ("kinetic", error(vec![kernel.kinetic(&q, &v)], &[state.kinetic])),
    ];
    if let (Some(fext), Some(expected)) = (&state.fext, &state.tau_id_ext) {
        let external = external(kernel, &q, fext);
        errors.push((
            "tau with wrenches",
            error(kernel.inverse(&q, &v, &a, &external).expect("valid"), expected),
        ));
    }
    if let Some(expected) = &state.mass_matrix {
        errors.push(("M", error(kernel.mass_matrix(&q).expect("valid").as_slice().to_vec(), expected)));
    }
    let (potential, com) = (kernel.potential(&q).into(), kernel.center_of_mass(&q).map(Into::into));
    // Heights and places are relative to an arbitrary origin: their scale is the sum of the terms.
    let (mut energy_scale, mut com_scale) = (0.0, 0.0);
    for (i, link) in figure.links().iter().enumerate() {
        let center = kernel.workspace.pose(i).transform(&link.com().map(T::from_f64)).map(Into::<f64>::into);
        energy_scale += (link.mass() * Vector3::from(model.gravity).dot(&center)).abs();
        com_scale += link.mass() * center.norm() / figure.mass();
    }
    errors.push(("potential", (potential - state.potential).abs() / energy_scale));
    errors.push(("centre of mass", (com - Vector3::from(state.com)).amax() / com_scale));
    errors
}

#[test]
fn double_precision_agrees_to_thirteen_digits() {
    compare::<f64>(1e-13);
}

#[test]
fn single_precision_agrees_to_five_digits() {
    compare::<f32>(1e-5);
}
