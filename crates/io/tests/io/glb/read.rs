//! A file as another reader has it, and a skinning that shares nothing with ours.

use gltf::animation::util::ReadOutputs;
use nalgebra::{Matrix4, Quaternion, Translation3, UnitQuaternion, Vector3, Vector4};

pub(crate) struct Read {
    pub(crate) gltf: gltf::Gltf,
    blob: Vec<u8>,
    channels: Vec<Channel>,
    /// Of the first mesh.
    pub(crate) points: Vec<Vector3<f64>>,
    pub(crate) joints: Vec<[usize; 4]>,
    pub(crate) weights: Vec<[f64; 4]>,
}

/// What moves a node: its translation (0), rotation (1) or scale (2).
struct Channel {
    animation: String,
    node: usize,
    part: usize,
    times: Vec<f64>,
    values: Vec<Vec<f64>>,
}

impl Read {
    pub(crate) fn of(bytes: &[u8]) -> Self {
        let gltf = gltf::Gltf::from_slice(bytes).expect("a valid file");
        let blob = gltf.blob.clone().unwrap_or_default();
        let mut read = Self { gltf, blob, channels: vec![], points: vec![], joints: vec![], weights: vec![] };
        read.channels = read.channels();
        if let Some(mesh) = read.gltf.meshes().next() {
            let primitive = mesh.primitives().next().expect("a primitive");
            let reader = primitive.reader(|_| Some(&read.blob));
            let points = reader.read_positions().expect("positions").map(|p| Vector3::from(p.map(f64::from)));
            let points: Vec<_> = points.collect();
            let joints = reader.read_joints(0).map(|j| j.into_u16().map(|j| j.map(usize::from)).collect());
            let weights = reader.read_weights(0).map(|w| w.into_f32().map(|w| w.map(f64::from)).collect());
            (read.points, read.joints, read.weights) =
                (points, joints.unwrap_or_default(), weights.unwrap_or_default());
        }
        read
    }

    fn channels(&self) -> Vec<Channel> {
        let of = |animation: gltf::Animation, channel: gltf::animation::Channel| {
            let reader = channel.reader(|_| Some(&self.blob));
            let wide = |rows: &mut dyn Iterator<Item = [f32; 3]>| {
                rows.map(|row| row.map(f64::from).to_vec()).collect()
            };
            let (part, values) = match reader.read_outputs().expect("values") {
                ReadOutputs::Translations(mut rows) => (0, wide(&mut rows)),
                ReadOutputs::Rotations(rows) => {
                    (1, rows.into_f32().map(|q| q.map(f64::from).to_vec()).collect())
                }
                ReadOutputs::Scales(mut rows) => (2, wide(&mut rows)),
                ReadOutputs::MorphTargetWeights(_) => panic!("none was written"),
            };
            Channel {
                animation: animation.name().unwrap_or_default().to_owned(),
                node: channel.target().node().index(),
                part,
                times: reader.read_inputs().expect("times").map(f64::from).collect(),
                values,
            }
        };
        let animations = self.gltf.animations();
        animations
            .flat_map(|animation| {
                animation.channels().map(|channel| of(animation.clone(), channel)).collect::<Vec<_>>()
            })
            .collect()
    }

    fn of_animation<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a Channel> {
        self.channels.iter().filter(move |channel| channel.animation == name)
    }

    /// The times of the channels that have the most keys.
    pub(crate) fn times(&self, animation: &str) -> Vec<f64> {
        self.of_animation(animation)
            .map(|channel| channel.times.clone())
            .max_by_key(Vec::len)
            .expect("a channel")
    }

    /// Whether the times of all channels grow.
    pub(crate) fn times_grow(&self, animation: &str) -> bool {
        self.of_animation(animation).all(|channel| channel.times.windows(2).all(|pair| pair[0] < pair[1]))
    }

    pub(crate) fn rotations(&self, animation: &str) -> Vec<Vec<Vector4<f64>>> {
        let turns = self.of_animation(animation).filter(|channel| channel.part == 1);
        turns.map(|channel| channel.values.iter().map(|q| Vector4::from_column_slice(q)).collect()).collect()
    }

    /// The matrices of all nodes at a time (s): channels that stand still beyond their ends, between keys even turns and slides.
    pub(crate) fn every(&self, animation: &str, time: f64) -> Vec<Matrix4<f64>> {
        let mut parts: Vec<[Vec<f64>; 3]> = self
            .gltf
            .nodes()
            .map(|node| {
                let (t, r, s) = node.transform().decomposed();
                [t.map(f64::from).to_vec(), r.map(f64::from).to_vec(), s.map(f64::from).to_vec()]
            })
            .collect();
        for channel in self.of_animation(animation) {
            let times = &channel.times;
            let after = times.partition_point(|t| *t <= time).min(times.len() - 1);
            let before = times.partition_point(|t| *t <= time).saturating_sub(1);
            let share =
                if after > before { (time - times[before]) / (times[after] - times[before]) } else { 0.0 };
            let (a, b) = (&channel.values[before], &channel.values[after]);
            parts[channel.node][channel.part] = if channel.part == 1 {
                let turn =
                    |q: &[f64]| UnitQuaternion::from_quaternion(Quaternion::new(q[3], q[0], q[1], q[2]));
                turn(a).slerp(&turn(b), share).coords.iter().copied().collect()
            } else {
                a.iter().zip(b).map(|(a, b)| a * (1.0 - share) + b * share).collect()
            };
        }
        let local = |part: &[Vec<f64>; 3]| {
            let [t, r, s] = part;
            let turn = UnitQuaternion::from_quaternion(Quaternion::new(r[3], r[0], r[1], r[2]));
            Translation3::new(t[0], t[1], t[2]).to_homogeneous()
                * turn.to_homogeneous()
                * Matrix4::new_nonuniform_scaling(&Vector3::new(s[0], s[1], s[2]))
        };
        let mut world = vec![None; parts.len()];
        let mut open: Vec<(gltf::Node, Matrix4<f64>)> = Vec::new();
        for scene in self.gltf.scenes() {
            open.extend(scene.nodes().map(|node| (node, Matrix4::identity())));
        }
        while let Some((node, above)) = open.pop() {
            let own = above * local(&parts[node.index()]);
            world[node.index()] = Some(own);
            open.extend(node.children().map(|child| (child, own)));
        }
        world.into_iter().map(|matrix| matrix.expect("in the scene")).collect()
    }

    /// The same of the joints of the first skin, or of the first nodes where there is none.
    pub(crate) fn world(&self, animation: &str, time: f64) -> Vec<Matrix4<f64>> {
        let all = self.every(animation, time);
        match self.gltf.skins().next() {
            Some(skin) => skin.joints().map(|node| all[node.index()]).collect(),
            None => all,
        }
    }

    pub(crate) fn binds(&self) -> Vec<Matrix4<f64>> {
        let skin = self.gltf.skins().next().expect("a skin");
        let reader = skin.reader(|_| Some(&self.blob));
        let matrix = |columns: [[f32; 4]; 4]| Matrix4::from_fn(|row, column| f64::from(columns[column][row]));
        reader.read_inverse_bind_matrices().expect("matrices").map(matrix).collect()
    }

    pub(crate) fn skinned(
        &self,
        vertex: usize,
        world: &[Matrix4<f64>],
        binds: &[Matrix4<f64>],
    ) -> Vector3<f64> {
        let point = self.points[vertex].push(1.0);
        let of = |(joint, weight): (&usize, &f64)| (world[*joint] * binds[*joint] * point).xyz() * *weight;
        self.joints[vertex].iter().zip(&self.weights[vertex]).map(of).sum()
    }
}
