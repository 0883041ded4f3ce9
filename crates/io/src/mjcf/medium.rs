//! The fluid around the bodies, and what carries them: put to the links of the figure.

use super::sections::World;
use crate::tree::Body;
use solaris_model::{Carried, Figure, Immersed, ImmersedShape, Medium, Placement, UnitQuaternion, Vector3};
use std::collections::HashMap;

/// What is smaller than this counts as this much, as in MuJoCo (kg m²).
const LEAST: f64 = 1e-15;

/// What was met of it while bodies were read, by their places in the list.
#[derive(Default)]
pub(super) struct Surroundings {
    /// Bodies that are in the fluid as boxes, with the axes of their inertia where they are known.
    pub(super) boxes: Vec<(usize, Option<UnitQuaternion<f64>>)>,
    /// Ellipsoids in the fluid.
    pub(super) ellipsoids: Vec<(usize, Placement, ImmersedShape)>,
    /// Which part of a body's weight is carried.
    pub(super) carried: Vec<(usize, f64)>,
}

/// The same with the masses of the bodies, by their names.
pub(super) struct Acting {
    immersed: Vec<(String, Placement, ImmersedShape)>,
    carried: Vec<(String, Vector3<f64>, f64)>,
}

impl Surroundings {
    /// When masses are final.
    pub(super) fn acting(self, bodies: &[Body]) -> Acting {
        // Of a body that a joint moves, the frame of its link is the joint's.
        let beyond = |i: usize| bodies[i].beyond;
        let massive = |(i, axes): (usize, Option<UnitQuaternion<f64>>)| {
            let body = &bodies[i];
            (body.mass > 0.0).then(|| {
                let (at, shape) = inertia_box(body, axes);
                (body.name.clone(), beyond(i) * at, shape)
            })
        };
        let boxes = self.boxes.into_iter().filter_map(massive);
        let named = |(i, at, shape): (usize, Placement, ImmersedShape)| {
            (bodies[i].name.clone(), beyond(i) * at, shape)
        };
        let immersed = boxes.chain(self.ellipsoids.into_iter().map(named)).collect();
        let carried = |(i, part): (usize, f64)| {
            let com = beyond(i).rotation * bodies[i].com + beyond(i).translation.vector;
            (bodies[i].name.clone(), com, bodies[i].mass * part)
        };
        Acting { immersed, carried: self.carried.into_iter().map(carried).collect() }
    }
}

/// The box of a body's mass and inertia: `r² = 3·(Iⱼ + Iₖ − Iᵢ)/(2·m)` of its half sides.
fn inertia_box(body: &Body, axes: Option<UnitQuaternion<f64>>) -> (Placement, ImmersedShape) {
    let axes = axes.unwrap_or_else(|| {
        let mut vectors = body.inertia.symmetric_eigen().eigenvectors;
        if vectors.determinant() < 0.0 {
            vectors.column_mut(0).neg_mut();
        }
        UnitQuaternion::from_rotation_matrix(&solaris_model::Rotation3::from_matrix_unchecked(vectors))
    });
    let turn = *axes.to_rotation_matrix().matrix();
    let moments = (turn.transpose() * body.inertia * turn).diagonal();
    let half = moments.map(|own| ((moments.sum() - 2.0 * own).max(LEAST) * 1.5 / body.mass).sqrt());
    (Placement::from_parts(body.com.into(), axes), ImmersedShape::Box(half))
}

impl Acting {
    /// What acts on the links of the figure that the bodies have become.
    pub(super) fn medium(self, figure: &Figure, world: &World) -> Medium {
        let mut places: HashMap<&str, (usize, Placement)> = HashMap::new();
        for (i, link) in figure.links().iter().enumerate() {
            places.insert(link.name(), (i, Placement::identity()));
        }
        // Bodies that nothing moves against their parents are frames of its link; those of links are sites.
        for (i, link) in figure.links().iter().enumerate() {
            for frame in link.frames() {
                places.entry(&frame.name).or_insert((i, frame.placement));
            }
        }
        let find = |body: &str| {
            let (i, within) = places.get(body)?;
            Some((figure.links()[*i].name().to_owned(), *within))
        };
        let immersed = self.immersed.into_iter().filter_map(|(body, at, shape)| {
            let (link, within) = find(&body)?;
            Some(Immersed { link, at: within * at, shape })
        });
        let carried = self.carried.into_iter().filter_map(|(body, com, mass)| {
            let (link, within) = find(&body)?;
            Some(Carried { link, at: within.rotation * com + within.translation.vector, mass })
        });
        Medium {
            density: world.density,
            viscosity: world.viscosity,
            wind: world.wind,
            immersed: immersed.collect(),
            carried: carried.collect(),
        }
    }
}
