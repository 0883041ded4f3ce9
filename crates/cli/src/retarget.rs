//! `solaris retarget`: a motion onto a character of a 3D program.

use crate::args::RetargetArgs;
use crate::convert::{self, stem};
use crate::error::{CliError, UsageError};
use crate::findings::list;
use crate::input;
use crate::output::{Formats, Outputs};
use crate::print::print;
use solaris::files::bytes;
use solaris::io::clip::ReadOptions;
use solaris::io::glb::{Character, animations};
use solaris::model::{Figure, Finding, Motion};
use solaris::retarget::{BoneMap, Moved, Roles, Skeleton, Take, retarget};
use std::io::Write;
use std::path::Path;

const WRITTEN: Formats<()> = &[("glb", ())];

pub(crate) fn run(args: &RetargetArgs) -> Result<(), CliError> {
    let outputs = Outputs::new([("-o", &args.output, WRITTEN)])?;
    outputs.keep_off([args.motion.as_path(), args.onto.as_path()])?;
    let bytes = bytes(&args.onto)?;
    let character =
        Character::read(&bytes, &stem(&args.onto)).map_err(|error| CliError::input(&args.onto, &error))?;
    let onto = character.skeleton();
    let roles = Roles::find(onto, &map(args.map.as_deref())?)
        .map_err(|error| CliError::input(&args.onto, &format!("{error} (--map)")))?;
    let mut clips = Vec::new();
    for clip in asked(args)? {
        let Given { figure, motion, findings } = given(args, clip.as_deref())?;
        let from = Skeleton { name: stem(&args.motion), ..Skeleton::of(&figure) };
        let of_clip = Roles::find(&from, &map(args.clip_map.as_deref())?)
            .map_err(|error| CliError::input(&args.motion, &format!("{error} (--clip-map)")))?;
        let take = Take::of(&from, &of_clip, &figure, &motion, args.rest_frame)
            .map_err(|error| CliError::input(&args.motion, &format!("{error} (--rest-frame)")))?;
        // The rest pose may be one of those that are left out.
        let take = if args.rest_frame.is_some() { take.without(args.skeleton.skip_frames) } else { take };
        let take = if args.mirror { take.mirrored() } else { take };
        let moved = retarget(&take, onto, &roles).map_err(|error| CliError::input(&args.onto, &error))?;
        // As asked, until it is written: there may be one of that name. Of a file with several clips that of the one that was chosen.
        let name = args.name.clone().or(clip).unwrap_or_else(|| stem(&args.motion));
        clips.push(Done { name, moved, of_clip, findings });
    }
    outputs.write(|(), mut writer| {
        let added = clips.iter().map(|done| (done.name.as_str(), &done.moved));
        let names = character.with_clips(added, &mut writer).map_err(CliError::other)?;
        clips.iter_mut().zip(names).for_each(|(done, name)| done.name = name);
        Ok(())
    })?;
    print(|out| {
        for done in &clips {
            told(out, done, onto)?;
        }
        writeln!(out, "legs {:.3} times those of the clip", clips[0].moved.replanted.scale)?;
        for (whose, roles) in [("clip", &clips[0].of_clip), ("character", &roles)] {
            missing(out, whose, roles)?;
        }
        list(out, &clips[0].findings)?;
        outputs.written().try_for_each(|line| writeln!(out, "{line}"))
    })
}

/// A clip on the character.
struct Done {
    name: String,
    moved: Moved,
    of_clip: Roles,
    findings: Vec<Finding>,
}

/// What a clip's file holds.
struct Given {
    figure: Figure,
    motion: Motion,
    findings: Vec<Finding>,
}

/// The animations that are asked for, one at least; of a file that has no names for them none is named.
fn asked(args: &RetargetArgs) -> Result<Vec<Option<String>>, CliError> {
    if !args.all {
        return Ok(vec![args.skeleton.clip.clone()]);
    }
    if !matches!(&*input::extension(&args.motion), "glb" | "gltf") {
        return Err(UsageError::OneAnimation { clip: args.motion.clone() }.into());
    }
    let names = animations(&bytes(&args.motion)?).map_err(|error| CliError::input(&args.motion, &error))?;
    let names: Vec<Option<String>> = names.into_iter().map(Some).collect();
    Ok(if names.is_empty() { vec![None] } else { names })
}

/// The figure and the motion of the clip of that name, and what there is to say of them.
fn given(args: &RetargetArgs, name: Option<&str>) -> Result<Given, CliError> {
    if input::is_clip(&args.motion) {
        let mut options = ReadOptions { clip: name.map(str::to_owned), ..convert::options(&args.skeleton)? };
        if args.rest_frame.is_some() {
            options.skip = 0;
        }
        let clip = input::clip(&args.motion, &options)?;
        // What bones weigh moves nothing here.
        let findings = clip.findings.into_iter().filter(|finding| finding.subject != "masses").collect();
        return Ok(Given { figure: clip.figure, motion: clip.motion, findings });
    }
    if args.skeleton.is_asked() {
        return Err(UsageError::OnlyOfBones.into());
    }
    let Some(path) = &args.figure else {
        return Err(UsageError::WhoseTable { clip: args.motion.clone() }.into());
    };
    let body = input::body(path)?;
    let motion = convert::motion_of(&args.motion, &body)?;
    Ok(Given { figure: body.figure, motion, findings: Vec::new() })
}

fn map(path: Option<&Path>) -> Result<BoneMap, CliError> {
    let Some(path) = path else { return Ok(BoneMap::default()) };
    let text = input::text(path)?;
    BoneMap::read(&text).map_err(|faults| input::faulty(path, &text, faults))
}

fn told(out: &mut dyn Write, Done { name, moved, .. }: &Done, onto: &Skeleton) -> std::io::Result<()> {
    let done = &moved.replanted;
    let lasts = moved.time[moved.time.len() - 1] - moved.time[0];
    writeln!(
        out,
        "animation '{name}' of '{}': {} frames, {lasts:.2} s, {} bones",
        onto.name,
        moved.time.len(),
        moved.turns.len()
    )?;
    if done.belt > 0.0 {
        writeln!(out, "in place, over ground that goes by at {:.2} m/s", done.belt)?;
    }
    let slides = format!(
        "what stands slides by {:.1} mm at the most ({:.1} mm in the clip)",
        done.slide * 1000.0,
        done.slid * 1000.0
    );
    match (done.stances, done.is_alike) {
        (0, _) => writeln!(out, "no foot stands in the clip: none was planted")?,
        (stances, true) => {
            writeln!(out, "{stances} stances as they are, for legs and feet are alike; {slides}")?;
        }
        (stances, false) => {
            writeln!(
                out,
                "{stances} stances planted anew: {slides}; for it hips turn by up to {:.1}°, knees by up \
                 to {:.1}°, and the pelvis is up to {:.0} mm lower",
                done.hip.to_degrees(),
                done.knee.to_degrees(),
                done.lowered * 1000.0
            )?;
        }
    }
    Ok(())
}

/// What has no bone.
fn missing(out: &mut dyn Write, whose: &str, roles: &Roles) -> std::io::Result<()> {
    let missing = roles.missing();
    if missing.is_empty() {
        return Ok(());
    }
    writeln!(out, "the {whose} has no bone for {}: what it would turn stays as it is", missing.join(", "))
}
