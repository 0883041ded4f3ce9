//! A body with its animation as USD text (`.usda`), as Omniverse, Houdini, Maya and Blender open it: `SkelRoot`, `Skeleton`, `SkelAnimation`, `Mesh`.
//!
//! Lengths are in metres, y is up and z forward (x left); a world with another "up" is turned as for glTF. Bones are links at their joints, of the links'
//! names where USD allows them. Time codes are the motion's samples, with one more at each touch-down and lift-off between two of them, as in
//! [`crate::glb`]. Of a figure without a skin there are bones alone.
//!
//! # Source
//!
//! Pixar, `UsdSkel` schemas (USD 24). Matrices there act on rows: each is the transpose of ours.

use crate::error::IoError;
use crate::glb::{keys, local};
use crate::upright::upright;
use solaris_model::{Figure, Motion, Placement, UnitQuaternion};
use solaris_skin::{Skin, colour_at};
use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::io::Write;

/// Writes a figure with its skin and one motion, called `clip`, to `out`.
///
/// # Errors
///
/// A motion of another figure or without samples, a number that is not finite, and the writer's own errors.
///
/// ```
/// use solaris_model::{Motion, MotionInfo, human};
/// use solaris_skin::{Detail, skin};
///
/// let ann = human(1.65, 58.0)?;
/// let (q, v) = (vec![0.0; ann.layout().nq()], vec![0.0; ann.layout().nv()]);
/// let stands = Motion::new(&ann, MotionInfo::on_earth(&ann, 30.0), vec![0.0], [q, v.clone(), v])?;
/// let mut bytes = Vec::new();
/// solaris_io::usd::write(&ann, &skin(&ann, Detail::Rough), "stands", &stands, &mut bytes)?;
/// assert!(bytes.starts_with(b"#usda 1.0"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(
    figure: &Figure,
    skin: &Skin,
    clip: &str,
    motion: &Motion,
    out: &mut impl Write,
) -> Result<(), IoError> {
    if motion.is_empty() {
        let problem = crate::error::ClipProblem::Empty;
        return Err(IoError::Clip { clip: clip.to_owned(), problem });
    }
    motion.check_figure(figure)?;
    let gravity = motion.info.gravity;
    if !gravity.iter().all(|g| g.is_finite()) {
        return Err(IoError::BvhUp { gravity });
    }
    let stage = Stage { figure, world: upright(&gravity), joints: joints(figure) };
    let mut taken = BTreeSet::new();
    let root = unique(figure.name(), &mut taken);
    let mut inside = BTreeSet::from(["bones".to_owned(), "skin".to_owned()]);
    let clip = unique(clip, &mut inside);
    let keys = keys::times(motion);
    let start = motion.time()[0];
    let rate = motion.info.rate;
    // Whole frames have whole time codes.
    let codes: Vec<f64> = keys.iter().map(|key| tidy((key.time - start) * rate)).collect();
    let last = codes.last().copied().unwrap_or_default();
    writeln!(out, "#usda 1.0\n(\n    defaultPrim = \"{root}\"\n    metersPerUnit = 1\n    upAxis = \"Y\"")?;
    writeln!(out, "    timeCodesPerSecond = {rate}\n    framesPerSecond = {rate}\n    startTimeCode = 0")?;
    writeln!(out, "    endTimeCode = {last}\n)\n")?;
    writeln!(out, "def SkelRoot \"{root}\" (\n    prepend apiSchemas = [\"SkelBindingAPI\"]\n)\n{{")?;
    stage.skeleton(skin, &root, &clip, out)?;
    stage.animation(&clip, motion, &keys, &codes, out)?;
    if !skin.triangles.is_empty() {
        mesh(skin, &root, out)?;
    }
    writeln!(out, "}}")?;
    Ok(())
}

/// A number of frames without the noise of time.
fn tidy(code: f64) -> f64 {
    let near = (code * 1e6).round() / 1e6;
    if (near - code).abs() < 1e-6 { near } else { code }
}

/// What of a name USD allows: letters, digits and underscores, no digit first.
fn unique(name: &str, taken: &mut BTreeSet<String>) -> String {
    let mut made: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    if made.is_empty() || made.starts_with(|c: char| c.is_ascii_digit()) {
        made.insert(0, '_');
    }
    let mut found = made.clone();
    let mut number = 2;
    while !taken.insert(found.clone()) {
        found = format!("{made}_{number}");
        number += 1;
    }
    found
}

/// The links as paths from the root: `pelvis/left_thigh/left_shank`.
fn joints(figure: &Figure) -> Vec<String> {
    let mut taken = BTreeSet::new();
    let mut paths: Vec<String> = Vec::with_capacity(figure.links().len());
    for link in figure.links() {
        let name = unique(link.name(), &mut taken);
        paths.push(link.parent().map_or_else(|| name.clone(), |parent| format!("{}/{name}", paths[parent])));
    }
    paths
}

struct Stage<'a> {
    figure: &'a Figure,
    world: UnitQuaternion<f64>,
    joints: Vec<String>,
}

impl Stage<'_> {
    /// The paths of these links.
    fn tokens(&self, links: &[usize]) -> String {
        let quoted: Vec<String> = links.iter().map(|i| format!("\"{}\"", self.joints[*i])).collect();
        quoted.join(", ")
    }

    fn skeleton(&self, skin: &Skin, root: &str, clip: &str, out: &mut impl Write) -> Result<(), IoError> {
        let mut q = vec![0.0; self.figure.layout().nq()];
        // The length is the figure's own.
        let _ = self.figure.neutral(&mut q);
        let links = self.figure.links().iter().zip(self.figure.layout().joints());
        let rest: Vec<Placement> = links.map(|(link, at)| local(link, &q[at.q..], &self.world)).collect();
        let bind: Vec<Placement> = if skin.bind.len() == rest.len() {
            skin.bind.clone()
        } else {
            self.figure.places(&q).iter().map(|place| self.world * place).collect()
        };
        writeln!(
            out,
            "    def Skeleton \"bones\" (\n        prepend apiSchemas = [\"SkelBindingAPI\"]\n    )\n    {{"
        )?;
        let all: Vec<usize> = (0..self.joints.len()).collect();
        writeln!(out, "        uniform token[] joints = [{}]", self.tokens(&all))?;
        writeln!(out, "        uniform matrix4d[] bindTransforms = [{}]", matrices(&bind))?;
        writeln!(out, "        uniform matrix4d[] restTransforms = [{}]", matrices(&rest))?;
        writeln!(out, "        rel skel:animationSource = </{root}/{clip}>\n    }}\n")?;
        Ok(())
    }

    fn animation(
        &self,
        clip: &str,
        motion: &Motion,
        keys: &[keys::Key],
        codes: &[f64],
        out: &mut impl Write,
    ) -> Result<(), IoError> {
        // Bones that never turn keep their rest.
        let moving = |i: &usize| self.figure.links()[*i].joint().kind().nv() > 0;
        let moving: Vec<usize> = (0..self.joints.len()).filter(moving).collect();
        let mut before: Vec<UnitQuaternion<f64>> = Vec::new();
        let (mut turns, mut slides) = (String::new(), String::new());
        for (key, code) in keys.iter().zip(codes) {
            let q = keys::positions(self.figure, motion, key);
            let links = self.figure.links().iter().zip(self.figure.layout().joints());
            let mut places: Vec<Placement> =
                links.map(|(link, at)| local(link, &q[at.q..], &self.world)).collect();
            for (i, place) in places.iter_mut().enumerate() {
                let numbers = place.translation.vector.iter().chain(place.rotation.coords.iter());
                if let Some(value) = numbers.copied().find(|x| !(*x as f32).is_finite()) {
                    let column = format!("{}.place", self.figure.links()[i].name());
                    return Err(IoError::NotFinite { column, time: key.time, value });
                }
                // Of a turn's two quaternions the one near to that before.
                if before.get(i).is_some_and(|before| before.coords.dot(&place.rotation.coords) < 0.0) {
                    place.rotation = UnitQuaternion::new_unchecked(-place.rotation.into_inner());
                }
            }
            before = places.iter().map(|place| place.rotation).collect();
            let moved: Vec<&Placement> = moving.iter().map(|i| &places[*i]).collect();
            let turned = moved.iter().map(|place| {
                let [x, y, z, w] = place.rotation.coords.map(|x| x as f32).into();
                format!("({w}, {x}, {y}, {z})")
            });
            let slid = moved.iter().map(|place| triple(place.translation.vector.map(|x| x as f32).into()));
            let line = |all: Vec<String>| format!("            {code}: [{}],\n", all.join(", "));
            turns += &line(turned.collect());
            slides += &line(slid.collect());
        }
        let ones = vec!["(1, 1, 1)"; moving.len()].join(", ");
        writeln!(out, "    def SkelAnimation \"{clip}\"\n    {{")?;
        writeln!(out, "        uniform token[] joints = [{}]", self.tokens(&moving))?;
        writeln!(out, "        quatf[] rotations.timeSamples = {{\n{turns}        }}")?;
        writeln!(out, "        half3[] scales = [{ones}]")?;
        writeln!(out, "        float3[] translations.timeSamples = {{\n{slides}        }}\n    }}\n")?;
        Ok(())
    }
}

fn triple([x, y, z]: [f32; 3]) -> String {
    format!("({x}, {y}, {z})")
}

/// Transposed: rows of what is printed are columns of ours.
fn matrices(places: &[Placement]) -> String {
    let one = |place: &Placement| {
        let matrix = place.to_homogeneous();
        let row = |i: usize| {
            let c = matrix.column(i);
            format!("({}, {}, {}, {})", c[0], c[1], c[2], c[3])
        };
        format!("({}, {}, {}, {})", row(0), row(1), row(2), row(3))
    };
    places.iter().map(one).collect::<Vec<_>>().join(", ")
}

fn mesh(skin: &Skin, root: &str, out: &mut impl Write) -> Result<(), IoError> {
    let listed = |items: &mut dyn Iterator<Item = String>| items.collect::<Vec<_>>().join(", ");
    let triples = |all: &[solaris_model::Vector3<f64>]| {
        listed(&mut all.iter().map(|v| triple(v.map(|x| x as f32).into())))
    };
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for point in &skin.points {
        for i in 0..3 {
            (low[i], high[i]) = (low[i].min(point[i]), high[i].max(point[i]));
        }
    }
    // A triangle has the colour of its middle.
    let colour = |triangle: &[u32; 3]| {
        let place = triangle.iter().map(|i| skin.colours[*i as usize]).sum::<f32>() / 3.0;
        triple(colour_at(place).map(linear))
    };
    let influences = || skin.influences.iter().flatten();
    let [joints, weights] = [
        listed(&mut influences().map(|i| i.link.to_string())),
        listed(&mut influences().map(|i| i.share.to_string())),
    ];
    writeln!(
        out,
        "    def Mesh \"skin\" (\n        prepend apiSchemas = [\"SkelBindingAPI\"]\n    )\n    {{"
    )?;
    let mut text = String::new();
    let corners = [low, high].map(|corner| triple(corner.map(|x| x as f32)));
    // Writing to a text cannot fail.
    let _ = writeln!(text, "        float3[] extent = [{}]", corners.join(", "));
    let _ = writeln!(
        text,
        "        int[] faceVertexCounts = [{}]",
        listed(&mut skin.triangles.iter().map(|_| "3".to_owned()))
    );
    let _ = writeln!(
        text,
        "        int[] faceVertexIndices = [{}]",
        listed(&mut skin.triangles.iter().flatten().map(ToString::to_string))
    );
    let _ = writeln!(
        text,
        "        normal3f[] normals = [{}] (\n            interpolation = \"vertex\"\n        )",
        triples(&skin.normals)
    );
    let _ = writeln!(text, "        point3f[] points = [{}]", triples(&skin.points));
    let _ = writeln!(
        text,
        "        color3f[] primvars:displayColor = [{}] (\n            interpolation = \"uniform\"\n        )",
        listed(&mut skin.triangles.iter().map(colour))
    );
    let four = "(\n            elementSize = 4\n            interpolation = \"vertex\"\n        )";
    let _ = writeln!(
        text,
        "        matrix4d primvars:skel:geomBindTransform = {}",
        matrices(&[Placement::identity()])
    );
    let _ = writeln!(text, "        int[] primvars:skel:jointIndices = [{joints}] {four}");
    let _ = writeln!(text, "        float[] primvars:skel:jointWeights = [{weights}] {four}");
    let _ = writeln!(text, "        rel skel:skeleton = </{root}/bones>");
    let _ = writeln!(text, "        uniform token subdivisionScheme = \"none\"\n    }}");
    out.write_all(text.as_bytes())?;
    Ok(())
}

/// A part of a colour as light (IEC 61966-2-1).
fn linear(part: u8) -> f32 {
    let x = f32::from(part) / 255.0;
    if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) }
}
