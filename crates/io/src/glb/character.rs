//! A character of somebody else's file: its skeleton at rest, and the file with one more animation.

use super::accessor::{Rows, rows};
use super::append::{Added, append};
use super::bones::joints;
use super::document::{At, Document};
use super::fault::GlbError;
use super::nodes::{Nodes, World, decomposed};
use crate::error::IoError;
use crate::rig::Rig;
use solaris_model::rig::{self, Segment, bones};
use solaris_model::{Matrix3, Placement, UnitQuaternion, Vector3};
use solaris_retarget::{Bone, Moved, ROLES, Skeleton};
use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;

/// A node whose turn is so far (rad) from that of the pose in which the skin was bound is posed.
const POSED: f64 = 0.01;

/// A character, as its file has it.
pub struct Character<'a> {
    bytes: &'a [u8],
    /// The node of each bone of the skeleton.
    nodes: Vec<usize>,
    skeleton: Skeleton,
    /// Places of the nodes above the bones at rest; the world where there is none.
    above: Vec<World>,
    /// Bones that the file has in another pose than its skin was bound in, with their turns in that one.
    posed: Vec<(usize, UnitQuaternion<f64>)>,
    /// Bones whose nodes say their place by a matrix, which no animation may move.
    matrices: BTreeSet<usize>,
}

impl<'a> Character<'a> {
    /// Reads a character: all nodes are bones of its skeleton, and those that joints of skins are or hang on may have roles, such as those that the
    /// extensions `VRMC_vrm` and `VRM` give them. At rest it is as its nodes are where left and right are alike, and else as its skin was bound. The skin's points come along as its surface.
    ///
    /// # Errors
    ///
    /// As [`super::read()`], and a file without a skin.
    pub fn read(bytes: &'a [u8], name: &str) -> Result<Self, GlbError> {
        let document = Document::read(bytes)?;
        let nodes = Nodes::of(&document)?;
        let joints = joints(&document, &nodes)?;
        if !joints.contains(&true) {
            return Err(GlbError::NoBones);
        }
        let skins = document
            .list("skins")?
            .iter()
            .map(|skin| Skin::of(&document, skin))
            .collect::<Result<Vec<_>, _>>()?;
        let mut turns = bound(&document, &nodes, &skins)?;
        // Nodes that stand alike on both sides are at rest themselves; those of a pose out of a motion are not.
        if is_mirrored(&nodes, &nodes.rest()) {
            turns = vec![None; nodes.nodes.len()];
        }
        let worlds = nodes.worlds(|i| {
            let mut local = nodes.nodes[i].local;
            local.rotation = turns[i].unwrap_or(local.rotation);
            local
        });
        let mut place = vec![0; nodes.nodes.len()];
        nodes.order.iter().enumerate().for_each(|(bone, node)| place[*node] = bone);
        // What has a joint below is of the skeleton.
        let mut is_bone = joints;
        for node in nodes.order.iter().rev() {
            if let (true, Some(parent)) = (is_bone[*node], nodes.nodes[*node].parent) {
                is_bone[parent] = true;
            }
        }
        let tags = tags(&document)?;
        let (mut bones, mut above) = (Vec::new(), Vec::new());
        for node in &nodes.order {
            let (world, of) = (&worlds[*node], &nodes.nodes[*node]);
            bones.push(Bone {
                name: of.name.clone(),
                parent: of.parent.map(|parent| place[parent]),
                rest: Placement::from_parts(world.origin.into(), world.rotation),
                is_bone: is_bone[*node],
                role: tags.iter().find(|(tagged, _)| tagged == node).map(|(_, role)| *role),
            });
            above.push(of.parent.map_or_else(World::identity, |parent| worlds[parent]));
        }
        if let Some(bone) =
            bones.iter().find(|bone| bone.rest.translation.vector.iter().any(|x| !x.is_finite()))
        {
            let place = format!("node '{}'", bone.name);
            return Err(GlbError::NotFinite { place, row: 0, value: f64::INFINITY });
        }
        let surface =
            surface(&document, &skins, &worlds)?.into_iter().map(|(node, point)| (place[node], point));
        let skeleton = Skeleton { name: name.to_owned(), bones, surface: surface.collect() };
        let posed =
            nodes.order.iter().enumerate().filter_map(|(bone, node)| Some((bone, turns[*node]?))).collect();
        let matrices =
            (0..nodes.order.len()).filter(|bone| nodes.nodes[nodes.order[*bone]].is_matrix).collect();
        Ok(Self { bytes, nodes: nodes.order, skeleton, above, posed, matrices })
    }

    /// Its skeleton at rest, in the file's own world: as the nodes are where left and right are alike, and else as its skin was bound.
    pub fn skeleton(&self) -> &Skeleton {
        &self.skeleton
    }

    /// Writes the file with one more animation, called `clip` or where there is one of that name `clip 2` and so on: bytes are added at its end, and to its JSON
    /// accessors, views and the animation; all else stays as it is, byte by byte. Gives the name that it has.
    ///
    /// # Errors
    ///
    /// A node that is to be moved and says its place by a matrix; a file of more than 4 GB; and the writer's own errors.
    pub fn with_clip(&self, clip: &str, moved: &Moved, out: &mut impl Write) -> Result<String, IoError> {
        Ok(self.with_clips([(clip, moved)], out)?.pop().unwrap_or_default())
    }

    /// The same with several, in their order.
    ///
    /// # Errors
    ///
    /// As of [`Self::with_clip`].
    pub fn with_clips<'c>(
        &self,
        clips: impl IntoIterator<Item = (&'c str, &'c Moved)>,
        out: &mut impl Write,
    ) -> Result<Vec<String>, IoError> {
        let added = clips.into_iter().map(|(name, moved)| self.added(name, moved));
        append(self.bytes, added.collect::<Result<_, _>>()?, out)
    }

    /// A motion as an animation of the file's nodes.
    fn added(&self, clip: &str, moved: &Moved) -> Result<Added, IoError> {
        let start = moved.time.first().copied().unwrap_or(0.0);
        let times: Vec<f64> = moved.time.iter().map(|time| time - start).collect();
        let mut turns: Vec<(usize, Vec<[f32; 4]>)> = Vec::new();
        let float = |turn: &UnitQuaternion<f64>| turn.coords.map(|x| x as f32).into();
        for (bone, of) in &moved.turns {
            if self.matrices.contains(bone) {
                let name = self.skeleton.bones[*bone].name.clone();
                return Err(IoError::MatrixNode { node: name });
            }
            turns.push((self.nodes[*bone], of.iter().map(float).collect()));
        }
        // What the file has in another pose and nothing turns is brought into the pose that was taken for its rest.
        for (bone, turn) in &self.posed {
            if !self.matrices.contains(bone) && moved.turns.iter().all(|(other, _)| other != bone) {
                turns.push((self.nodes[*bone], vec![float(turn)]));
            }
        }
        let (root, way) = &moved.root;
        let above = &self.above[*root];
        let inverse = above.matrix.try_inverse().unwrap_or_else(Matrix3::identity);
        let way: Vec<[f32; 3]> =
            way.iter().map(|place| (inverse * (place - above.origin)).map(|x| x as f32).into()).collect();
        for (time, place) in moved.time.iter().zip(&way) {
            if let Some(value) = place.iter().find(|x| !x.is_finite()) {
                let column = format!("{}.place", self.skeleton.bones[*root].name);
                return Err(IoError::NotFinite { column, time: *time, value: f64::from(*value) });
            }
        }
        Ok(Added { name: clip.to_owned(), times, turns, root: self.nodes[*root], way })
    }
}

/// A skin: its joints, and for each the matrix that brings its points into the joint's frame.
struct Skin {
    joints: Vec<usize>,
    inverse: Vec<World>,
}

impl Skin {
    fn of(document: &Document, skin: &At) -> Result<Self, GlbError> {
        let count = document.count("nodes");
        let joints = skin
            .need("joints")?
            .each()?
            .iter()
            .map(|joint| joint.index("nodes", count))
            .collect::<Result<Vec<_>, _>>()?;
        let Some(matrices) = skin.get("inverseBindMatrices") else {
            return Ok(Self { inverse: vec![World::identity(); joints.len()], joints });
        };
        let rows = rows(document, matrices.index("accessors", document.count("accessors"))?)?;
        if rows.width != 16 || rows.len() < joints.len() {
            return Err(matrices.wrong(&format!("an array of {} matrices", joints.len())));
        }
        let inverse = (0..joints.len()).map(|i| affine(&rows, i)).collect();
        Ok(Self { joints, inverse })
    }

    /// The turn of a joint in the space in which the skin was bound.
    fn turn(&self, i: usize) -> UnitQuaternion<f64> {
        self.inverse[i].rotation.inverse()
    }
}

fn affine(rows: &Rows, i: usize) -> World {
    let row = rows.row(i);
    let numbers: [f64; 16] = std::array::from_fn(|k| row[k]);
    let column = |k: usize| Vector3::new(row[4 * k], row[4 * k + 1], row[4 * k + 2]);
    World {
        matrix: Matrix3::from_columns(&[column(0), column(1), column(2)]),
        origin: column(3),
        rotation: decomposed(&numbers).rotation,
    }
}

/// For each node that stands otherwise than its skin was bound, its turn in its parent in that pose.
///
/// How joints are turned against each other in it, the inverse matrices say; how all of it stands in the world they leave open: as the nodes
/// stand, in the world's own axes, or as what is above the joints or the mesh, whichever is nearest to the nodes as they are.
fn bound(
    document: &Document,
    nodes: &Nodes,
    skins: &[Skin],
) -> Result<Vec<Option<UnitQuaternion<f64>>>, GlbError> {
    let worlds = nodes.rest();
    let mut bind: Vec<Option<UnitQuaternion<f64>>> = vec![None; nodes.nodes.len()];
    let mut meshes = vec![Vec::new(); skins.len()];
    for (i, node) in document.list("nodes")?.iter().enumerate() {
        if let Some(skin) = node.get("skin") {
            let of: &mut Vec<usize> = &mut meshes[skin.index("skins", skins.len())?];
            // Of a skin that many meshes have, the first few.
            if of.len() < 4 {
                of.push(i);
            }
        }
    }
    for (skin, meshes) in skins.iter().zip(meshes) {
        let mut frames = vec![UnitQuaternion::identity()];
        frames.extend(meshes.into_iter().map(|mesh| worlds[mesh].rotation));
        if let Some(first) = skin.joints.first() {
            let top = nodes.nodes[*first].parent;
            frames.push(top.map_or_else(UnitQuaternion::identity, |top| worlds[top].rotation));
            frames.push(worlds[*first].rotation * skin.turn(0).inverse());
        }
        let off = |frame: &UnitQuaternion<f64>| -> f64 {
            let of = skin.joints.iter().enumerate();
            of.map(|(i, joint)| (frame * skin.turn(i)).angle_to(&worlds[*joint].rotation)).sum()
        };
        let Some(frame) = frames.iter().min_by(|a, b| off(a).total_cmp(&off(b))) else { continue };
        for (i, joint) in skin.joints.iter().enumerate() {
            bind[*joint].get_or_insert(frame * skin.turn(i));
        }
    }
    let mut found = vec![UnitQuaternion::identity(); nodes.nodes.len()];
    let mut turns = vec![None; nodes.nodes.len()];
    for i in &nodes.order {
        let above = nodes.nodes[*i].parent.map_or_else(UnitQuaternion::identity, |parent| found[parent]);
        let own = nodes.nodes[*i].local.rotation;
        found[*i] = above * own;
        if let Some(bind) = bind[*i].filter(|bind| bind.angle_to(&found[*i]) > POSED) {
            found[*i] = bind;
            turns[*i] = Some(above.inverse() * bind);
        }
    }
    Ok(turns)
}

/// Whether left and right of a person's bones are mirror images, wherever the plane between them is: then each left bone is as far from another's right one
/// as the right one is from that one's left.
fn is_mirrored(nodes: &Nodes, worlds: &[World]) -> bool {
    const ALIKE: f64 = 0.01;
    let names: Vec<&str> = nodes.nodes.iter().map(|node| node.name.as_str()).collect();
    let mut pairs: BTreeMap<Segment, [Option<Vector3<f64>>; 2]> = BTreeMap::new();
    for (bone, world) in bones(&names).into_iter().zip(worlds) {
        if let Some(rig::Bone { segment, side: Some(side) }) = bone {
            pairs.entry(segment).or_default()[side as usize].get_or_insert(world.origin);
        }
    }
    let pairs: Vec<[Vector3<f64>; 2]> =
        pairs.into_values().filter_map(|[left, right]| Some([left?, right?])).collect();
    let size = pairs
        .iter()
        .map(|[left, right]| (left - pairs[0][1]).norm().max((right - pairs[0][0]).norm()))
        .fold(0.0, f64::max);
    let alike = |[l, r]: &[Vector3<f64>; 2], [m, s]: &[Vector3<f64>; 2]| {
        ((l - s).norm() - (r - m).norm()).abs() < ALIKE * size
    };
    pairs.len() >= 6 && pairs.iter().all(|pair| pairs.iter().all(|other| alike(pair, other)))
}

/// The points of all skinned meshes at rest, each with the joint that it goes with most.
fn surface(
    document: &Document,
    skins: &[Skin],
    worlds: &[World],
) -> Result<Vec<(usize, Vector3<f64>)>, GlbError> {
    let mut surface = Vec::new();
    let mut seen = BTreeSet::new();
    for node in document.list("nodes")? {
        let (Some(mesh), Some(skin)) = (node.get("mesh"), node.get("skin")) else { continue };
        let of = (mesh.index("meshes", document.count("meshes"))?, skin.index("skins", skins.len())?);
        if !seen.insert(of) {
            continue;
        }
        for primitive in document.one("meshes", of.0)?.need("primitives")?.each()? {
            let packed = primitive
                .get("extensions")
                .is_some_and(|all| all.get("KHR_draco_mesh_compression").is_some());
            let attributes = primitive.need("attributes")?;
            let all = ["POSITION", "JOINTS_0", "WEIGHTS_0"].map(|key| attributes.get(key));
            let ([Some(points), Some(joints), Some(weights)], false) = (all, packed) else { continue };
            let read = |at: At, width: usize| {
                let rows = rows(document, at.index("accessors", document.count("accessors"))?)?;
                if rows.width == width {
                    Ok(rows)
                } else {
                    Err(at.wrong(&format!("an array of rows of {width}")))
                }
            };
            let (points, joints, weights) = (read(points, 3)?, read(joints, 4)?, read(weights, 4)?);
            if joints.len() != points.len() || weights.len() != points.len() {
                return Err(attributes.wrong("arrays of one length"));
            }
            for i in 0..points.len() {
                add(&skins[of.1], worlds, [points.row(i), joints.row(i), weights.row(i)], &mut surface);
            }
        }
    }
    Ok(surface)
}

/// Adds a point where its joints have it.
fn add(
    skin: &Skin,
    worlds: &[World],
    [point, joints, weights]: [&[f64]; 3],
    surface: &mut Vec<(usize, Vector3<f64>)>,
) {
    let point = Vector3::new(point[0], point[1], point[2]);
    let (mut place, mut sum, mut most) = (Vector3::zeros(), 0.0, (0.0, None));
    for (joint, weight) in joints.iter().zip(weights) {
        let joint = *joint as usize;
        let Some((node, inverse)) = skin.joints.get(joint).zip(skin.inverse.get(joint)) else { continue };
        let world = &worlds[*node];
        place += (world.matrix * (inverse.matrix * point + inverse.origin) + world.origin) * *weight;
        sum += weight;
        if *weight > most.0 {
            most = (*weight, Some(*node));
        }
    }
    if let (Some(node), true) = (most.1, sum > 0.0) {
        let place = place / sum;
        if place.iter().all(|x| x.is_finite()) {
            surface.push((node, place));
        }
    }
}

/// The roles that VRM's extensions say, of nodes.
fn tags(document: &Document) -> Result<Vec<(usize, &'static str)>, GlbError> {
    let mut tags = Vec::new();
    let count = document.count("nodes");
    let role = |bone: &str| ROLES.into_iter().find(|role| Rig::Vrm.bone(role) == Some(bone));
    let Some(extensions) = document.root().get("extensions") else { return Ok(tags) };
    for extension in ["VRMC_vrm", "VRM"] {
        let bones = extensions
            .get(extension)
            .and_then(|vrm| vrm.get("humanoid"))
            .and_then(|all| all.get("humanBones"));
        let Some(bones) = bones else { continue };
        // VRM 1.0 has an object, VRM 0 a list.
        for (name, bone) in bones.members() {
            if let (Some(role), Some(node)) = (role(name), bone.get("node")) {
                tags.push((node.index("nodes", count)?, role));
            }
        }
        for bone in if extension == "VRM" { bones.each()? } else { Vec::new() } {
            if let (Some(role), Some(node)) = (role(bone.need("bone")?.text()?), bone.get("node")) {
                tags.push((node.index("nodes", count)?, role));
            }
        }
    }
    // Only what ends the trunk has a role of its own.
    tags.retain(|(_, role)| !matches!(*role, "abdomen" | "thorax" | "neck"));
    Ok(tags)
}
