//! Characters made by code, such as 3D programs write them: any names, any axes of bones, centimetres under a scaled node, other poses and lengths.

use nalgebra::{Isometry3, Matrix4, UnitQuaternion, Vector3};
use serde_json::{Value, json};

/// How a character differs from an upright person of metres in a T pose.
#[derive(Clone)]
pub(crate) struct Made {
    /// Names of the 21 bones, by those of a human's links.
    pub(crate) names: fn(&str) -> String,
    /// How far arms are raised from hanging (rad).
    pub(crate) arms: f64,
    /// How far legs are apart (rad), soles flat.
    pub(crate) legs: f64,
    /// Lengths of thigh, shank, upper arm, forearm (m).
    pub(crate) lengths: [f64; 4],
    pub(crate) ankle: f64,
    /// Spine bones between pelvis and neck.
    pub(crate) spine: usize,
    /// Whether the nodes are in centimetres, along z, below one that is scaled and turned.
    pub(crate) centimetres: bool,
    /// Whether local axes are anything; else the world's.
    pub(crate) rolled: bool,
    /// Which way it looks (rad about the vertical).
    pub(crate) facing: f64,
    /// Whether limbs have twist bones: the arm's in the chain, at a quarter and at half, the leg's beside, at half and at three quarters; and whether
    /// there are bones that are called so and are none.
    pub(crate) twists: bool,
}

impl Default for Made {
    fn default() -> Self {
        Self {
            names: str::to_owned,
            arms: std::f64::consts::FRAC_PI_2,
            legs: 0.0,
            lengths: [0.42, 0.43, 0.28, 0.25],
            ankle: 0.09,
            spine: 3,
            centimetres: false,
            rolled: false,
            facing: 0.0,
            twists: false,
        }
    }
}

/// A bone of a character: its role or extra name, its parent, its joint (m).
pub(crate) struct Joint {
    pub(crate) name: String,
    pub(crate) parent: Option<usize>,
    pub(crate) at: Vector3<f64>,
}

impl Made {
    pub(crate) fn joints(&self) -> Vec<Joint> {
        let mut joints: Vec<Joint> = Vec::new();
        let [thigh, shank, upper, fore] = self.lengths;
        let high = self.ankle + (thigh + shank) * self.legs.cos();
        let mut add = |name: String, parent: Option<usize>, at: Vector3<f64>| {
            joints.push(Joint { name, parent, at });
            joints.len() - 1
        };
        let name = self.names;
        let pelvis = add(name("pelvis"), None, Vector3::new(0.0, high + 0.08, 0.0));
        let mut chest = pelvis;
        for i in 1..=self.spine {
            let named = if i == self.spine { name("thorax") } else { format!("{}{i}", name("abdomen")) };
            let at = Vector3::new(0.0, high + 0.08 + 0.4 * i as f64 / (self.spine + 1) as f64, 0.0);
            chest = add(named, Some(chest), at);
        }
        let neck = add(name("neck"), Some(chest), Vector3::new(0.0, high + 0.55, 0.0));
        add(name("head"), Some(neck), Vector3::new(0.0, high + 0.65, 0.02));
        for (side, sign) in [("left", 1.0), ("right", -1.0)] {
            let of = |part: &str| name(&format!("{side}_{part}"));
            let out = |x: f64, y: f64, z: f64| Vector3::new(sign * x, y, z);
            let shoulder = high + 0.48;
            let clavicle = add(of("clavicle"), Some(chest), out(0.03, shoulder, 0.0));
            let along = out(self.arms.sin(), -self.arms.cos(), 0.0);
            let arm = out(0.17, shoulder, 0.0);
            let upper_arm = add(of("upper_arm"), Some(clavicle), arm);
            let mut upper_arm = upper_arm;
            if self.twists {
                let at = arm + along * (upper / 4.0) + out(0.0, 0.001, 0.002);
                upper_arm = add(format!("{}_twist", of("upper_arm")), Some(upper_arm), at);
                // A pauldron's, behind the shoulder.
                add(format!("{}_shield_roll", of("upper_arm")), Some(upper_arm), arm - along * (upper / 4.0));
            }
            let mut elbow = add(of("forearm"), Some(upper_arm), arm + along * upper);
            if self.twists {
                elbow =
                    add(format!("{}_twist", of("forearm")), Some(elbow), arm + along * (upper + fore / 2.0));
            }
            add(of("hand"), Some(elbow), arm + along * (upper + fore));
            let hip = out(0.1, high, 0.0);
            let down = out(self.legs.sin(), -self.legs.cos(), 0.0);
            let leg = add(of("thigh"), Some(pelvis), hip);
            if self.twists {
                add(format!("{}_twist", of("thigh")), Some(leg), hip + down * (thigh / 2.0));
            }
            let knee = add(of("shank"), Some(leg), hip + down * thigh);
            if self.twists {
                add(format!("{}_twist", of("shank")), Some(knee), hip + down * (thigh + 0.75 * shank));
            }
            let ankle = hip + down * (thigh + shank);
            let foot = add(of("foot"), Some(knee), ankle);
            add(of("toes"), Some(foot), Vector3::new(ankle.x, 0.02, 0.14));
        }
        joints
    }

    /// Points of the soles, each with its bone.
    pub(crate) fn soles(&self) -> Vec<(usize, Vector3<f64>)> {
        let joints = self.joints();
        let mut soles = Vec::new();
        for side in ["left", "right"] {
            let of = |part: &str| {
                joints
                    .iter()
                    .position(|joint| joint.name == (self.names)(&format!("{side}_{part}")))
                    .expect("a bone")
            };
            let (foot, toes) = (of("foot"), of("toes"));
            for (bone, z) in [(foot, -0.06), (foot, 0.14), (toes, 0.21)] {
                soles.push((bone, Vector3::new(joints[foot].at.x, 0.0, z)));
            }
        }
        soles
    }

    /// The file, with an animation of its own, a material and a node beside, which must stay.
    pub(crate) fn bytes(&self) -> Vec<u8> {
        let joints = self.joints();
        let facing = UnitQuaternion::from_scaled_axis(Vector3::y() * self.facing);
        let turn = |i: usize| {
            let seed = i as f64;
            let roll = UnitQuaternion::from_euler_angles(seed, 0.7 * seed, 1.3 * seed);
            facing * if self.rolled { roll } else { UnitQuaternion::identity() }
        };
        let places: Vec<Isometry3<f64>> = joints
            .iter()
            .enumerate()
            .map(|(i, joint)| Isometry3::from_parts((facing * joint.at).into(), turn(i)))
            .collect();
        let (unit, above) = if self.centimetres {
            (100.0, UnitQuaternion::from_scaled_axis(Vector3::x() * -std::f64::consts::FRAC_PI_2))
        } else {
            (1.0, UnitQuaternion::identity())
        };
        let floats = |v: &[f64]| v.iter().map(|x| json!(*x as f32)).collect::<Vec<Value>>();
        let mut nodes = vec![json!({
            "name": "Armature", "children": [1], "rotation": floats(above.coords.as_slice()), "scale": floats(&[1.0 / unit; 3])
        })];
        for (i, joint) in joints.iter().enumerate() {
            let up = joint
                .parent
                .map_or_else(|| Isometry3::from_parts(Vector3::zeros().into(), above), |p| places[p]);
            let local = up.inverse() * places[i];
            let children: Vec<usize> =
                (0..joints.len()).filter(|k| joints[*k].parent == Some(i)).map(|k| k + 1).collect();
            let mut node = json!({
                "name": joint.name,
                "translation": floats((local.translation.vector * unit).as_slice()),
                "rotation": floats(local.rotation.coords.as_slice()),
            });
            if !children.is_empty() {
                node["children"] = json!(children);
            }
            nodes.push(node);
        }
        nodes.push(json!({ "name": "Body", "mesh": 0, "skin": 0 }));
        nodes.push(json!({ "name": "Lamp", "translation": [0, 3, 0], "extras": { "watts": 40 } }));
        let mut bytes: Vec<u8> = Vec::new();
        let (mut views, mut accessors) = (Vec::new(), Vec::new());
        let mut array = |data: &[u8], component: u32, count: usize, kind: &str, more: Value| {
            views.push(json!({ "buffer": 0, "byteOffset": bytes.len(), "byteLength": data.len() }));
            bytes.extend_from_slice(data);
            bytes.resize(bytes.len().next_multiple_of(4), 0);
            let mut accessor = json!({ "bufferView": views.len() - 1, "componentType": component, "count": count, "type": kind });
            more.as_object().into_iter().flatten().for_each(|(key, value)| accessor[key] = value.clone());
            accessors.push(accessor);
        };
        let le = |v: &[f64]| v.iter().flat_map(|x| (*x as f32).to_le_bytes()).collect::<Vec<u8>>();
        let soles = self.soles();
        let points: Vec<f64> =
            soles.iter().flat_map(|(_, p)| (facing * p).iter().copied().collect::<Vec<_>>()).collect();
        let limit = |pick: fn(f64, f64) -> f64, from: f64| -> Vec<Value> {
            floats(
                &(0..3)
                    .map(|k| points.iter().skip(k).step_by(3).copied().fold(from, pick))
                    .collect::<Vec<_>>(),
            )
        };
        let limits =
            json!({ "min": limit(f64::min, f64::INFINITY), "max": limit(f64::max, f64::NEG_INFINITY) });
        array(&le(&points), 5126, soles.len(), "VEC3", limits);
        let owners: Vec<u8> = soles.iter().flat_map(|(bone, _)| [*bone as u8, 0, 0, 0]).collect();
        array(&owners, 5121, soles.len(), "VEC4", json!({}));
        array(&le(&[1.0, 0.0, 0.0, 0.0].repeat(soles.len())), 5126, soles.len(), "VEC4", json!({}));
        let binds: Vec<f64> = places
            .iter()
            .flat_map(|place| {
                let world = place.to_homogeneous() * Matrix4::new_scaling(1.0 / unit);
                world.try_inverse().expect("a place").as_slice().to_vec()
            })
            .collect();
        array(&le(&binds), 5126, joints.len(), "MAT4", json!({}));
        array(&le(&[0.0, 1.0]), 5126, 2, "SCALAR", json!({ "min": [0], "max": [1] }));
        array(&le(&[0.0, 3.0, 0.0, 0.0, 4.0, 0.0]), 5126, 2, "VEC3", json!({}));
        let root = json!({
            "asset": { "version": "2.0", "generator": "somebody else's" },
            "scene": 0,
            "scenes": [{ "nodes": [0, nodes.len() - 2, nodes.len() - 1] }],
            "materials": [{ "name": "cloth", "pbrMetallicRoughness": { "roughnessFactor": 0.123_456_789_012_345_68 } }],
            "meshes": [{ "primitives": [{ "mode": 0, "attributes": { "POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2 }, "material": 0 }] }],
            "skins": [{ "joints": (1..=joints.len()).collect::<Vec<_>>(), "inverseBindMatrices": 3 }],
            "animations": [{
                "name": "sways",
                "channels": [{ "sampler": 0, "target": { "node": nodes.len() - 1, "path": "translation" } }],
                "samplers": [{ "input": 4, "output": 5 }],
            }],
            "nodes": nodes,
            "bufferViews": views,
            "accessors": accessors,
            "buffers": [{ "byteLength": bytes.len() }],
        });
        contained(&root.to_string(), &bytes)
    }
}

/// A binary file of a JSON text and bytes.
pub(crate) fn contained(json: &str, bytes: &[u8]) -> Vec<u8> {
    let mut text = json.as_bytes().to_vec();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut file = b"glTF".to_vec();
    let total = 12 + 8 + text.len() + 8 + bytes.len();
    for word in [2, total as u32, text.len() as u32, 0x4E4F_534A] {
        file.extend(word.to_le_bytes());
    }
    file.extend(text);
    for word in [bytes.len() as u32, 0x004E_4942] {
        file.extend(word.to_le_bytes());
    }
    file.extend(bytes);
    file
}
