//! glTF as it is read: our own files against the motions that they were written of, arrays of all kinds against numbers that can be checked by
//! hand, and files that nobody should write against what is said of them.

use crate::retarget::made::{Made, contained};
use solaris_gait::{WalkRequest, walk};
use solaris_io::clip::{Clip, ReadOptions};
use solaris_io::glb::{self, Actor, GlbError, Options, read};
use solaris_io::record;
use solaris_io::rig::{Rig, RigMap, Rigged};
use solaris_model::{Figure, Link, Motion, Placement, Vector3, human};

fn walked(figure: &Figure, rate: f64) -> Motion {
    let request = WalkRequest { step_frequency: Some(110.0), ..WalkRequest::default() };
    walk(figure, &request).expect("a walk").motion(figure, rate).expect("a motion")
}

fn written(figure: &Figure, motion: &Motion) -> Vec<u8> {
    let mut bytes = Vec::new();
    let clip = glb::Clip { name: "walk", motions: vec![(0, motion)] };
    let options = Options { skin: None, forces: false, vrm: false };
    glb::write(&[Actor { name: "Ann", figure, skin: None }], &[clip], options, &mut bytes).expect("written");
    bytes
}

fn found(bytes: &[u8]) -> Clip {
    read(bytes, &ReadOptions::default()).expect("a clip")
}

/// The greatest distance (m) of the origin of a link that moves or of a point 0.3 m from it, sample by sample.
fn worst(figure: &Figure, motion: &Motion, other: &Clip) -> f64 {
    assert_eq!(motion.len(), other.motion.len());
    let mut worst: f64 = 0.0;
    for sample in 0..motion.len() {
        let (places, others) = (figure.places(motion.q(sample)), other.figure.places(other.motion.q(sample)));
        // Of a file without a skin, bones are what an animation moves.
        let moves = |link: &Link| link.joint().kind().nq() > 0;
        for (link, place) in figure.links().iter().zip(&places).filter(|(link, _)| moves(link)) {
            let at = other.figure.link_index(link.name()).expect("a bone of that name");
            for point in [Vector3::zeros(), Vector3::new(0.3, 0.0, 0.0), Vector3::new(0.0, 0.0, 0.3)] {
                let of = |place: &Placement| place.rotation * point + place.translation.vector;
                worst = worst.max((of(place) - of(&others[at])).norm());
            }
        }
    }
    worst
}

#[test]
fn a_walk_comes_back() {
    let ann = human(1.65, 58.0).expect("a person");
    for rate in [24.0, 30.0, 120.0] {
        let motion = walked(&ann, rate);
        let clip = found(&written(&ann, &motion));
        assert!((clip.motion.info.rate - rate).abs() < 1e-12);
        let off = worst(&ann, &motion, &clip);
        assert!(off < 1e-5, "{off} m at {rate}/s");
        // Back on the figure that it was written of.
        let table = clip.table_of(&ann).expect("her motion");
        let again = record::read(&ann, motion.info.gravity, &table).expect("her motion").motion;
        let q = (0..motion.len()).flat_map(|i| motion.q(i).iter().zip(again.q(i)));
        let off = q.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-5, "{off} at {rate}/s");
    }
}

#[test]
fn a_walk_on_the_bones_of_a_rig_comes_back() {
    let ann = human(1.75, 73.0).expect("a person");
    let motion = walked(&ann, 30.0);
    for rig in Rig::ALL {
        let on = Rigged::new(&ann, RigMap::from(rig).with_own_axes()).expect("a rig");
        let moved = on.motion(&ann, &motion).expect("its motion");
        let clip = found(&written(&on.figure, &moved));
        let off = worst(&on.figure, &moved, &clip);
        assert!(off < 1e-5, "{}: {off} m", rig.name());
        // The names are a person's, so the masses are.
        assert!((40.0..110.0).contains(&clip.figure.mass()), "{} kg", clip.figure.mass());
    }
}

/// A file of two nodes of which the second is moved by an array of two rows, told by these pieces of JSON, of these bytes.
fn moved(accessor: &str, views: &str, bytes: &[u8], path: &str, way: &str) -> Result<Clip, GlbError> {
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],
        "nodes":[{{"name":"a","children":[1]}},{{"name":"b","translation":[0,1,0]}}],
        "animations":[{{"channels":[{{"sampler":0,"target":{{"node":1,"path":"{path}"}}}},
            {{"sampler":0,"target":{{"node":0,"path":"{path}"}}}}],
            "samplers":[{{"input":0,"output":1,"interpolation":"{way}"}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":2,"type":"SCALAR"}},{accessor}],
        "bufferViews":[{{"buffer":0,"byteLength":8}},{views}],
        "buffers":[{{"byteLength":{}}}]}}"#,
        bytes.len()
    );
    read(&contained(&json, bytes), &ReadOptions::default())
}

fn with_times(rest: &[u8]) -> Vec<u8> {
    let mut bytes: Vec<u8> = [0.0_f32, 1.0].iter().flat_map(|x| x.to_le_bytes()).collect();
    bytes.extend(rest);
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    bytes
}

#[test]
fn arrays_are_read_whatever_their_components_strides_and_sparse_parts() {
    let last = |clip: &Clip| clip.figure.places(clip.motion.q(clip.motion.len() - 1));
    // Quarter turns about y as shares of bytes and words.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let shorts: Vec<u8> = [0.0, 0.0, 0.0, 1.0, 0.0, half, 0.0, half]
        .iter()
        .flat_map(|x| ((x * 32_767.0).round() as i16).to_le_bytes())
        .collect();
    let bytes: Vec<u8> = [0_i8, 0, 0, 127, 0, 90, 0, 90].map(|x| x as u8).to_vec();
    for (data, kind, digits) in [(shorts, 5122, 1e-4), (bytes, 5120, 1e-2)] {
        let accessor =
            format!(r#"{{"bufferView":1,"componentType":{kind},"normalized":true,"count":2,"type":"VEC4"}}"#);
        let view = format!(r#"{{"buffer":0,"byteOffset":8,"byteLength":{}}}"#, data.len());
        let clip = moved(&accessor, &view, &with_times(&data), "rotation", "LINEAR").expect("a clip");
        // b turns in a, which turns as much: half a turn in all.
        let angle = last(&clip)[1].rotation.angle();
        assert!((angle - std::f64::consts::PI).abs() < digits, "{kind}: {angle}");
    }
    // Rows 20 bytes apart, after 4 that are nobody's.
    let mut data = vec![0_u8; 4];
    for row in [[0.0_f32, 1.0, 0.0], [3.0, 1.0, 0.0]] {
        data.extend(row.iter().flat_map(|x| x.to_le_bytes()));
        data.extend([0xFF; 8]);
    }
    let accessor = r#"{"bufferView":1,"byteOffset":4,"componentType":5126,"count":2,"type":"VEC3"}"#;
    let view = format!(r#"{{"buffer":0,"byteOffset":8,"byteLength":{},"byteStride":20}}"#, data.len());
    let clip = moved(accessor, &view, &with_times(&data), "translation", "LINEAR").expect("a clip");
    let places = last(&clip);
    assert!((places[1].translation.vector - Vector3::new(6.0, 2.0, 0.0)).norm() < 1e-12);
    // Nothing but zeros, of which the second row is another.
    let data: Vec<u8> =
        [1_u8, 0, 0, 0].into_iter().chain([5.0_f32, 6.0, 7.0].iter().flat_map(|x| x.to_le_bytes())).collect();
    let accessor = r#"{"componentType":5126,"count":2,"type":"VEC3","sparse":{"count":1,
        "indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":2}}}"#;
    let views = r#"{"buffer":0,"byteOffset":8,"byteLength":1},{"buffer":0,"byteOffset":12,"byteLength":12}"#;
    let clip = moved(accessor, views, &with_times(&data), "translation", "STEP").expect("a clip");
    assert!((last(&clip)[1].translation.vector - Vector3::new(10.0, 12.0, 14.0)).norm() < 1e-12);
}

#[test]
fn what_stands_above_a_skeleton_is_counted_in() {
    for (centimetres, rolled) in [(false, false), (true, false), (true, true)] {
        let made = Made { centimetres, rolled, ..Made::default() };
        let clip = read(&made.bytes(), &ReadOptions::default()).expect("a figure");
        let mut q = vec![0.0; clip.figure.layout().nq()];
        clip.figure.neutral(&mut q).expect("as long");
        q.copy_from_slice(clip.motion.q(0));
        let places = clip.figure.places(&q);
        for joint in made.joints() {
            let at = places[clip.figure.link_index(&joint.name).expect("a link")].translation.vector;
            assert!((at - joint.at).norm() < 1e-6, "{}: {at} and {}", joint.name, joint.at);
        }
    }
}

#[test]
fn bytes_may_stand_in_the_json() {
    let json = r#"{"asset":{"version":"2.0"},"nodes":[{"name":"a"}],"animations":[{"name":"up","channels":[{"sampler":0,
        "target":{"node":0,"path":"translation"}}],"samplers":[{"input":0,"output":1}]}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":1,"type":"SCALAR"},{"bufferView":0,"componentType":5126,"count":1,"type":"VEC3"}],
        "bufferViews":[{"buffer":0,"byteLength":12}],"buffers":[{"byteLength":12,"uri":"data:application/octet-stream;base64,AAAAAAAAgD8AAABA"}]}"#;
    let clip = read(json.as_bytes(), &ReadOptions::default()).expect("a clip");
    assert_eq!(clip.motion.q(0)[..3], [0.0, 1.0, 2.0]);
    let other = json.replace("data:application/octet-stream;base64,AAAAAAAAgD8AAABA", "walk.bin");
    let error = read(other.as_bytes(), &ReadOptions::default()).expect_err("elsewhere").to_string();
    assert_eq!(error, "buffers[0] is in another file, 'walk.bin'; save it as one .glb");
}

#[test]
fn what_nobody_should_write_is_told_by_its_place() {
    let told =
        |json: &str| read(&contained(json, &[]), &ReadOptions::default()).expect_err("at fault").to_string();
    let begin = r#"{"asset":{"version":"2.0"},"#;
    for (json, expected) in [
        (
            r#""nodes":[{"children":[0]}]}"#,
            "nodes[0] is below itself, or below one that is; nodes must be trees",
        ),
        (
            r#""nodes":[{"children":[2]},{"children":[2]},{}]}"#,
            "nodes[2] is the child of two nodes; nodes must be trees",
        ),
        (r#""nodes":[{"children":[7]}]}"#, "nodes[0].children[0] is 7; it must be one of 1 nodes"),
        (r#""nodes":[{"rotation":[0,0,0]}]}"#, "nodes[0].rotation is an array of 3; it must be 4 numbers"),
        (r#""nodes":[{"scale":[1,1,"x"]}]}"#, "nodes[0].scale[2] is \"x\"; it must be a finite number"),
        (
            r#""nodes":[{}]}"#,
            "it has no skin, and no animation turns or moves a node: there are no bones to be read",
        ),
    ] {
        assert_eq!(told(&format!("{begin}{json}")), expected);
    }
    assert_eq!(
        told(r#"{"asset":{"version":"1.0"}}"#),
        "it is glTF 1.0; 2.0 is read: export it anew, or convert it (gltf-pipeline)"
    );
    let view = r#"{"buffer":0,"byteOffset":8,"byteLength":24}"#;
    let of = |accessor: &str, view: &str, data: &[u8]| {
        moved(accessor, view, &with_times(data), "translation", "LINEAR").expect_err("at fault").to_string()
    };
    let accessor =
        |count: &str| format!(r#"{{"bufferView":1,"componentType":5126,"count":{count},"type":"VEC3"}}"#);
    assert_eq!(of(&accessor("3"), view, &[0; 24]), "accessors[1] needs 36 bytes, and 24 are there");
    assert!(of(&accessor("9000000000000000"), view, &[0; 24]).contains("more than 40000000 numbers"));
    let huge = r#"{"buffer":0,"byteOffset":18446744073709551615,"byteLength":24}"#;
    assert!(of(&accessor("2"), huge, &[0; 24]).contains("bytes, and 32 are there"));
    let nan: Vec<u8> = [0.0_f32, 0.0, f32::NAN, 0.0, 0.0, 0.0].iter().flat_map(|x| x.to_le_bytes()).collect();
    assert_eq!(of(&accessor("2"), view, &nan), "accessors[1], row 0 is NaN; it must be a finite number");
    let whole = written_short();
    for end in 0..whole.len() {
        assert!(read(&whole[..end], &ReadOptions::default()).is_err(), "{end} bytes are no file");
    }
}

fn written_short() -> Vec<u8> {
    Made { spine: 1, ..Made::default() }.bytes()
}
