//! glTF as it is read: our own files against the motions that they were written of, and every kind of array, curve and node against the crate
//! gltf, which is not ours, or numbers that can be checked by hand.

use solaris_gait::{WalkRequest, walk};
use solaris_io::clip::{Clip, ReadOptions};
use solaris_io::glb::{self, Actor, GlbError, Options, read};
use solaris_io::record;
use solaris_io::rig::{Rig, Rigged};
use solaris_model::{Figure, Motion, Placement, Vector3, human};

fn walked(figure: &Figure, rate: f64) -> Motion {
    let request = WalkRequest { step_frequency: Some(110.0), ..WalkRequest::default() };
    walk(figure, &request).expect("a walk").motion(figure, rate).expect("a motion")
}

fn written(figure: &Figure, motion: &Motion) -> Vec<u8> {
    let mut bytes = Vec::new();
    let clip = glb::Clip { name: "walk", motions: vec![(0, motion)] };
    let options = Options { skin: None, forces: false };
    glb::write(&[Actor { name: "Ann", figure, skin: None }], &[clip], options, &mut bytes).expect("written");
    bytes
}

fn found(bytes: &[u8]) -> Clip {
    read(bytes, &ReadOptions::default()).expect("a clip")
}

/// The greatest distance (m) of a link's origin or of a point 0.3 m from it, sample by sample.
fn worst(figure: &Figure, motion: &Motion, other: &Clip) -> f64 {
    assert_eq!(motion.len(), other.motion.len());
    let mut worst: f64 = 0.0;
    for sample in 0..motion.len() {
        let (places, others) = (figure.places(motion.q(sample)), other.figure.places(other.motion.q(sample)));
        for (link, place) in figure.links().iter().zip(&places) {
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
        let on = Rigged::new(&ann, rig).expect("a rig");
        let moved = on.motion(&ann, &motion).expect("its motion");
        let clip = found(&written(&on.figure, &moved));
        let off = worst(&on.figure, &moved, &clip);
        assert!(off < 1e-5, "{}: {off} m", rig.name());
        // The names are a person's, so the masses are.
        assert!((40.0..110.0).contains(&clip.figure.mass()), "{} kg", clip.figure.mass());
    }
}
