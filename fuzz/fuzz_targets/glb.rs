//! Characters and their animations as glTF: read as a clip, as a table, and as a character that gets one more animation.
#![no_main]

use solaris_fuzz::{figure, refused, said, target};
use solaris_io::clip::ReadOptions;
use solaris_io::glb::{Character, read};
use solaris_model::human;
use solaris_retarget::{BoneMap, Roles, Skeleton, Take, retarget};

target!(|bytes: &[u8]| {
    match read(bytes, &ReadOptions::default()) {
        Ok(clip) => {
            clip.findings.iter().for_each(|finding| said("", &finding.message));
            assert!(
                (0..clip.motion.len()).all(|i| clip.motion.q(i).iter().all(|x| x.is_finite())),
                "a place that is none"
            );
            figure("nan", &clip.figure);
            let table = clip.table_of(&clip.figure).expect("the clip's own figure");
            solaris_fuzz::table("nan", &table);
        }
        Err(error) => refused(&error),
    }
    match Character::read(bytes, "somebody") {
        Ok(character) => moved(&character),
        Err(error) => refused(&error),
    }
});

/// Puts a person who stands onto the character, and reads the file again.
fn moved(character: &Character) {
    let ann = human(1.7, 60.0).expect("a person");
    let (q, v) = (vec![0.0; ann.layout().nq()], vec![0.0; ann.layout().nv()]);
    let info = solaris_model::MotionInfo::on_earth(&ann, 30.0);
    let stands = solaris_model::Motion::new(&ann, info, vec![0.0], [q, v.clone(), v]).expect("a motion");
    let from = Skeleton::of(&ann);
    let take = Roles::find(&from, &BoneMap::default()).expect("her own bones");
    let take = Take::of(&from, &take, &ann, &stands, None).expect("she stands");
    let roles = match Roles::find(character.skeleton(), &BoneMap::default()) {
        Ok(roles) => roles,
        Err(error) => return refused(&error),
    };
    match retarget(&take, character.skeleton(), &roles) {
        Ok(moved) => {
            let mut out = Vec::new();
            match character.with_clip("stands", &moved, &mut out) {
                Ok(_) => {
                    let options = ReadOptions { clip: Some("stands".to_owned()), ..ReadOptions::default() };
                    if let Err(error) = read(&out, &options) {
                        refused(&error);
                    }
                    assert!(Character::read(&out, "again").is_ok(), "what was written is not read");
                }
                Err(error) => refused(&error),
            }
        }
        Err(error) => refused(&error),
    }
}
