//! The numbers of another engine; see `fixtures/reference`.

use super::Kernel;
use nalgebra::{Matrix3, Rotation3, Translation3, UnitQuaternion, Vector3};
use serde::Deserialize;
use solaris_dynamics::{Scalar, Wrench};
use solaris_model::{Axis, Figure, FigureBuilder, Inertia, Joint, LinkSpec, Placement};

#[derive(Deserialize)]
struct File {
    models: Vec<Model>,
}

#[derive(Deserialize)]
pub(crate) struct Model {
    pub(crate) name: String,
    pub(crate) gravity: [f64; 3],
    pub(crate) joints: Vec<FileJoint>,
    pub(crate) states: Vec<State>,
}

#[derive(Deserialize)]
pub(crate) struct FileJoint {
    pub(crate) name: String,
    pub(crate) parent: i64,
    #[serde(rename = "type")]
    pub(crate) kind: String,
    pub(crate) axis: [f64; 3],
    #[serde(rename = "R")]
    pub(crate) rotation: [f64; 9],
    pub(crate) p: [f64; 3],
    pub(crate) mass: f64,
    pub(crate) com: [f64; 3],
    pub(crate) inertia: [f64; 6],
}

#[derive(Deserialize)]
pub(crate) struct State {
    pub(crate) q: Vec<f64>,
    pub(crate) qd: Vec<f64>,
    pub(crate) qdd: Vec<f64>,
    pub(crate) tau_id: Vec<f64>,
    pub(crate) bias: Vec<f64>,
    pub(crate) grav: Vec<f64>,
    pub(crate) kinetic: f64,
    pub(crate) potential: f64,
    pub(crate) com: [f64; 3],
    #[serde(rename = "M")]
    pub(crate) mass_matrix: Option<Vec<f64>>,
    pub(crate) fext: Option<Vec<[f64; 6]>>,
    pub(crate) tau_id_ext: Option<Vec<f64>>,
    pub(crate) tau_in: Vec<f64>,
    pub(crate) qdd_fd: Vec<f64>,
    pub(crate) qdd_fd_ext: Option<Vec<f64>>,
    pub(crate) hybrid: Hybrid,
    #[serde(rename = "condM")]
    pub(crate) condition: f64,
}

#[derive(Deserialize)]
pub(crate) struct Hybrid {
    pub(crate) prescribed: Vec<bool>,
    pub(crate) qdd_p: Vec<f64>,
    pub(crate) tau_d: Vec<f64>,
    pub(crate) qdd: Vec<f64>,
    pub(crate) tau: Vec<f64>,
}

/// The 48 models of the file.
pub(crate) fn models() -> Vec<Model> {
    let file: File = serde_json::from_str(include_str!("../../../../fixtures/reference/dynamics.json"))
        .expect("the schema");
    assert_eq!(file.models.len(), 48);
    file.models
}

/// One link a joint, on a welded base: link `i + 1` is body `i` of the file.
pub(crate) fn figure(model: &Model) -> Figure {
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
pub(crate) fn external<T: Scalar>(
    kernel: &mut Kernel<T>,
    q: &[T],
    wrenches: &[[f64; 6]],
) -> Vec<(usize, Wrench<T>)> {
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
