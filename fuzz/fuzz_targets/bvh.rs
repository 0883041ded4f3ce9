//! Motion capture as BVH: read, as a table, written again, and put onto a person; and tables of masses.
#![no_main]

use solaris_fuzz::{figure, refused, said, target, text};
use solaris_io::bvh::{self, Clip, ReadOptions, Up};
use solaris_model::{Vector3, human};
use solaris_retarget::{BoneMap, Roles, Skeleton, Take, retarget};

target!(|bytes: &[u8]| {
    let Some(source) = text(bytes) else { return };
    let _ = bvh::masses(&source);
    let options = match source.len() % 3 {
        0 => ReadOptions { up: Some(Up::Z), mass: Some(70.0), skip: 1, ..ReadOptions::default() },
        _ => ReadOptions::default(),
    };
    match bvh::read(&source, &options) {
        Ok(clip) => {
            clip.findings.iter().for_each(|finding| said(&source, &finding.message));
            figure(&source, &clip.figure);
            let table = clip.table_of(&clip.figure).expect("the clip's own figure");
            solaris_fuzz::table(&source, &table);
            again(&clip, options.mass);
            onto_a_person(&clip);
        }
        Err(error) => refused(&error),
    }
});

/// Panics where the written clip of a body of any sensible size is not read; the file does not know a mass that was asked for.
fn again(clip: &Clip, mass: Option<f64>) {
    if clip.figure.extent(&Vector3::y()).height > 1e6 {
        return;
    }
    let mut written = Vec::new();
    if bvh::write(&clip.figure, &clip.motion, clip.unit, &mut written).is_ok() {
        let written = String::from_utf8(written).expect("text");
        let options = ReadOptions { unit: Some(clip.unit), mass, ..ReadOptions::default() };
        match bvh::read(&written, &options) {
            Ok(again) => assert_eq!(again.motion.len(), clip.motion.len(), "{written}"),
            Err(error) => panic!("what was written is not read: {error}\n{written}"),
        }
    }
}

/// Puts the clip of whoever has thighs, shanks and feet onto a person of another size: all numbers of it are some.
fn onto_a_person(clip: &Clip) {
    let from = Skeleton::of(&clip.figure);
    let roles = match Roles::find(&from, &BoneMap::default()) {
        Ok(roles) => roles,
        Err(error) => return refused(&error),
    };
    let take = match Take::of(&from, &roles, &clip.figure, &clip.motion, None) {
        Ok(take) => take,
        Err(error) => return refused(&error),
    };
    let child = Skeleton::of(&human(1.2, 23.0).expect("a person"));
    let roles = Roles::find(&child, &BoneMap::default()).expect("a person's bones");
    for take in [take.clone(), take.mirrored()] {
        match retarget(&take, &child, &roles) {
            Ok(moved) => {
                assert_eq!(moved.time.len(), clip.motion.len());
                let turns =
                    moved.turns.iter().flat_map(|(_, turns)| turns).flat_map(|turn| turn.coords.iter());
                assert!(turns.chain(moved.root.1.iter().flat_map(|at| at.iter())).all(|x| x.is_finite()));
            }
            Err(error) => refused(&error),
        }
    }
}
