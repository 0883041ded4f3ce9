//! Nodes beside a body: arrows for what the ground does, a ball at the centre of mass.

use super::pack::VERTICES;
use super::{Animation, File, keys};
use crate::error::IoError;
use crate::upright::upright;
use serde_json::json;
use solaris_model::{Figure, Motion, UnitQuaternion, Vector3};

/// How long an arrow of nothing is: a node's scale must not be nothing, or it cannot be turned back (m).
const LEAST: f64 = 1e-4;
const SECTORS: usize = 12;

/// The arrows of a motion's contacts, 1 m for the body's weight, and its centre of mass.
pub(super) fn add(
    file: &mut File,
    animation: &mut Animation,
    name: &str,
    figure: &Figure,
    motion: &Motion,
) -> Result<(), IoError> {
    let [arrow, ball] = meshes(file);
    let world = upright(&motion.info.gravity);
    let start = motion.time()[0];
    let keys = keys::told_apart(keys::samples(motion), start);
    let times: Vec<f64> = keys.iter().map(|key| key.time - start).collect();
    let input = file.pack.times(&times);
    let finite = |what: &str, v: &Vector3<f64>, time: f64| match v.iter().find(|x| !(**x as f32).is_finite())
    {
        Some(value) => Err(IoError::NotFinite { column: what.to_owned(), time, value: *value }),
        None => Ok(v.map(|x| x as f32).into()),
    };
    let weight = figure.mass() * motion.info.gravity.norm();
    for track in motion.contacts.iter().filter(|_| weight > 0.0) {
        let column = format!("{}.f", track.link);
        let (mut places, mut turns, mut scales) = (Vec::new(), Vec::new(), Vec::new());
        let mut turn = UnitQuaternion::identity();
        for key in &keys {
            let (contact, time) = (&track.samples[key.sample], &key.time);
            let force = world * contact.force;
            places.push(finite(&column, &(world * contact.cop), *time)?);
            let _: [f32; 3] = finite(&column, &force, *time)?;
            // Where nothing acts, the arrow keeps its direction.
            let now = if force.norm() > 1e-9 {
                UnitQuaternion::rotation_between(&Vector3::y(), &force)
            } else {
                None
            };
            let now = now.unwrap_or(turn);
            turn = if now.coords.dot(&turn.coords) < 0.0 {
                UnitQuaternion::new_unchecked(-now.into_inner())
            } else {
                now
            };
            turns.push(turn.coords.map(|x| x as f32).into());
            scales.push([1.0, (force.norm() / weight).max(LEAST) as f32, 1.0]);
        }
        let node = file.node(json!({ "name": format!("{name} force on {}", track.link), "mesh": arrow }));
        file.scene.push(node);
        let outputs: [usize; 3] = [
            file.pack.floats(&places, None, false),
            file.pack.floats::<4>(&turns, None, false),
            file.pack.floats(&scales, None, false),
        ];
        for (path, output) in ["translation", "rotation", "scale"].into_iter().zip(outputs) {
            animation.channel(node, path, input, output);
        }
    }
    if figure.mass() > 0.0 {
        let mut places = Vec::new();
        for key in keys {
            let centre = world * centre(figure, motion.q(key.sample));
            places.push(finite("centre of mass", &centre, key.time)?);
        }
        let node = file.node(json!({ "name": format!("{name} centre of mass"), "mesh": ball }));
        file.scene.push(node);
        let output = file.pack.floats(&places, None, false);
        animation.channel(node, "translation", input, output);
    }
    Ok(())
}

/// The centre of mass (m).
fn centre(figure: &Figure, q: &[f64]) -> Vector3<f64> {
    let of = |(link, place): (&solaris_model::Link, &solaris_model::Placement)| {
        (place.rotation * link.com() + place.translation.vector) * link.mass()
    };
    figure.links().iter().zip(&figure.places(q)).map(of).sum::<Vector3<f64>>() / figure.mass()
}

/// The meshes of arrow and ball, once for all.
fn meshes(file: &mut File) -> [usize; 2] {
    if let Some(meshes) = file.extra {
        return meshes;
    }
    // Radius and height along the arrow, whose length is 1; and of a ball of 3 cm.
    let arrow = [[0.0, 0.0], [0.008, 0.0], [0.008, 0.85], [0.025, 0.85], [0.0, 1.0]];
    let ball: Vec<[f64; 2]> = (0..=8)
        .map(|i| {
            let (sin, cos) = (std::f64::consts::PI * f64::from(i) / 8.0).sin_cos();
            [if i % 8 == 0 { 0.0 } else { 0.03 * sin }, -0.03 * cos]
        })
        .collect();
    let meshes = [("force", &arrow[..], [0.85, 0.25, 0.15, 1.0]), ("centre of mass", &ball, [0.95, 0.75, 0.1, 1.0])].map(
        |(name, meridian, colour)| {
            let (points, normals, triangles) = turned(meridian);
            let attributes =
                json!({ "POSITION": file.pack.floats(&points, VERTICES, true), "NORMAL": file.pack.floats(&normals, VERTICES, false) });
            let indices = file.pack.triangles(&triangles, points.len());
            file.materials.push(json!({
                "name": name,
                "pbrMetallicRoughness": { "baseColorFactor": colour, "metallicFactor": 0.0, "roughnessFactor": 0.6 },
            }));
            let material = file.materials.len() - 1;
            file.meshes.push(json!({
                "name": name,
                "primitives": [{ "attributes": attributes, "indices": indices, "material": material }],
            }));
            file.meshes.len() - 1
        },
    );
    *file.extra.insert(meshes)
}

/// A meridian turned about y: each piece of it with its own flat normals along it.
#[allow(clippy::type_complexity, reason = "the three parts of a mesh")]
fn turned(meridian: &[[f64; 2]]) -> (Vec<[f32; 3]>, Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let (mut points, mut normals, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
    for pair in meridian.windows(2) {
        let ([r, h], [s, k]) = (pair[0], pair[1]);
        let length = (k - h).hypot(s - r);
        let (out, up) = ((k - h) / length, (r - s) / length);
        let first = points.len() as u32;
        for i in 0..SECTORS {
            let (sin, cos) = (std::f64::consts::TAU * i as f64 / SECTORS as f64).sin_cos();
            for (radius, height) in [(r, h), (s, k)] {
                points.push([radius * cos, height, radius * sin].map(|x| x as f32));
                normals.push([out * cos, up, out * sin].map(|x| x as f32));
            }
            let [a, b] = [i, (i + 1) % SECTORS].map(|i| first + 2 * i as u32);
            if r > 0.0 {
                triangles.push([a, b + 1, b]);
            }
            if s > 0.0 {
                triangles.push([a, a + 1, b + 1]);
            }
        }
    }
    (points, normals, triangles)
}
