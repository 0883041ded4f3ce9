//! Motions as animation files: BVH, binary glTF and USD.

use crate::args::{AskedRig, RigArgs};
use crate::error::{CliError, UsageError};
use crate::input::{self, extension};
use rayon::prelude::*;
use solaris::io::bvh::{self, Unit};
use solaris::io::glb::{Actor, Clip, Detail, Options, write};
use solaris::io::rig::{Rig, RigMap, Rigged};
use solaris::io::usd;
use solaris::model::{Figure, Motion};
use solaris::scene::OneOfSeveral;
use solaris::skin::{parts, skin};
use std::io::Write;
use std::path::Path;

/// Of more people than these the skins are rough.
const FEW: usize = 4;

/// What an animation file is to have.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bones {
    /// Whose bones; our own where there is none.
    pub(crate) rig: Option<RigMap>,
    /// Whether forces are arrows and the centre of mass a ball, where a file can have them.
    pub(crate) arrows: bool,
}

/// One figure and its motion as bones, those of a `rig` where one is asked for. What `repeats` itself is written without its last frame, which is its first one.
pub(crate) fn bones(
    figure: &Figure,
    motion: &Motion,
    repeats: bool,
    bones: &Bones,
    mut writer: &mut dyn Write,
) -> Result<(), CliError> {
    let mut write = |figure: &Figure, motion: &Motion| {
        // Cut on the rig: the track of its root is that of the whole.
        let shorter = repeats.then(|| motion.without_last());
        let motion = shorter.as_ref().unwrap_or(motion);
        bvh::write(figure, motion, Unit::default(), &mut writer).map_err(CliError::other)
    };
    let Some(rig) = &bones.rig else { return write(figure, motion) };
    let on = Rigged::new(figure, rig).map_err(CliError::other)?;
    let motion = on.motion(figure, motion).map_err(CliError::other)?;
    write(&on.figure, &motion)
}

/// Somebody on the bones of a rig, with the axes that these have at home.
fn rigged(figure: &Figure, rig: &RigMap) -> Result<Rigged, CliError> {
    Rigged::new(figure, rig.clone().with_own_axes()).map_err(CliError::other)
}

/// What a body with its motion is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BodyFormat {
    /// Binary glTF.
    Glb,
    /// USD as text.
    Usda,
}

/// One figure and its motion as a body, by the figure's name and that of the motion.
pub(crate) fn body(
    how: BodyFormat,
    figure: &Figure,
    motion: &Motion,
    clip: &str,
    bones: &Bones,
    mut writer: &mut dyn Write,
) -> Result<(), CliError> {
    if how == BodyFormat::Glb {
        return clips(figure, &[(clip, motion)], bones, writer);
    }
    let detail = Detail::default();
    let Some(rig) = &bones.rig else {
        return usd::write(figure, &skin(figure, detail), clip, motion, &mut writer).map_err(CliError::other);
    };
    let on = rigged(figure, rig)?;
    let motion = on.motion(figure, motion).map_err(CliError::other)?;
    usd::write(&on.figure, &on.skin(figure, detail), clip, &motion, &mut writer).map_err(CliError::other)
}

/// One figure as a body, and its motions by their names.
pub(crate) fn clips(
    figure: &Figure,
    motions: &[(&str, &Motion)],
    bones: &Bones,
    mut writer: &mut dyn Write,
) -> Result<(), CliError> {
    let vrm = bones.rig.as_ref().and_then(RigMap::rig) == Some(Rig::Vrm);
    let options = Options { vrm, forces: bones.arrows, ..Options::default() };
    let mut write = |actor: Actor<'_>, motions: &[(&str, &Motion)]| {
        let clips: Vec<Clip<'_>> =
            motions.iter().map(|(name, motion)| Clip { name, motions: vec![(0, *motion)] }).collect();
        write(&[actor], &clips, options, &mut writer).map_err(CliError::other)
    };
    let Some(rig) = &bones.rig else {
        return write(Actor { name: figure.name(), figure, skin: None }, motions);
    };
    let on = rigged(figure, rig)?;
    let skin = on.skin(figure, options.skin.unwrap_or_default());
    let moved = motions.iter().map(|(_, motion)| on.motion(figure, motion));
    let moved = moved.collect::<Result<Vec<_>, _>>().map_err(CliError::other)?;
    let motions: Vec<(&str, &Motion)> = motions.iter().map(|(name, _)| *name).zip(&moved).collect();
    write(Actor { name: figure.name(), figure: &on.figure, skin: Some(&skin) }, &motions)
}

/// Somebody of a crowd.
pub(crate) struct Person {
    pub(crate) name: String,
    pub(crate) figure: Figure,
    pub(crate) motion: Motion,
}

/// The figures of a scene in one file, people with their skin, and one clip that moves them; on the bones of a rig those that are people.
pub(crate) fn scene(all: &[OneOfSeveral], bones: &Bones, mut writer: &mut dyn Write) -> Result<(), CliError> {
    let options = Options { forces: bones.arrows, ..Options::default() };
    let is_person = |one: &OneOfSeveral| !parts(&one.alone).is_empty();
    let many = all.iter().filter(|one| is_person(one)).count() > FEW;
    let detail = if many { Detail::Rough } else { Detail::default() };
    let dressed = all.par_iter().map(|one| {
        let OneOfSeveral { alone, figure, motion, .. } = one;
        let Some(rig) = bones.rig.as_ref().filter(|_| is_person(one)) else {
            return Ok((figure.clone(), motion.clone(), skin(alone, detail)));
        };
        let on = rigged(alone, rig)?;
        let place = figure.links()[0].joint().placement() * alone.links()[0].joint().placement().inverse();
        let mut own = motion.clone();
        own.info.fingerprint = alone.fingerprint();
        let mut moved = on.motion(alone, &own).map_err(CliError::other)?;
        let placed = on.figure.placed(&place);
        moved.info.fingerprint = placed.fingerprint();
        Ok((placed, moved, on.skin(alone, detail)))
    });
    let dressed: Vec<_> = dressed.collect::<Result<_, CliError>>()?;
    let actors = all.iter().zip(&dressed);
    let actors = actors.map(|(one, (figure, _, skin))| Actor { name: &one.name, figure, skin: Some(skin) });
    let actors: Vec<Actor> = actors.collect();
    let motions = dressed.iter().map(|(_, motion, _)| motion).enumerate().collect();
    write(&actors, &[Clip { name: "run", motions }], options, &mut writer).map_err(CliError::other)
}

/// All of them in one file, and one clip that moves them.
pub(crate) fn crowd(people: &[Person], bones: &Bones, mut writer: &mut dyn Write) -> Result<(), CliError> {
    let options = Options { skin: Some(Detail::Rough), forces: bones.arrows, ..Options::default() };
    let mut write = |actors: &[Actor<'_>], motions: Vec<(usize, &Motion)>| {
        write(actors, &[Clip { name: "crowd", motions }], options, &mut writer).map_err(CliError::other)
    };
    let Some(rig) = &bones.rig else {
        let actors: Vec<Actor> =
            people.iter().map(|Person { name, figure, .. }| Actor { name, figure, skin: None }).collect();
        return write(&actors, people.iter().map(|person| &person.motion).enumerate().collect());
    };
    let rigged = people.par_iter().map(|Person { figure, motion, .. }| {
        let on = rigged(figure, rig)?;
        let motion = on.motion(figure, motion).map_err(CliError::other)?;
        let skin = on.skin(figure, Detail::Rough);
        Ok((on.figure, motion, skin))
    });
    let rigged: Vec<_> = rigged.collect::<Result<_, CliError>>()?;
    let actors = people.iter().zip(&rigged);
    let actors =
        actors.map(|(Person { name, .. }, (figure, _, skin))| Actor { name, figure, skin: Some(skin) });
    let actors: Vec<Actor> = actors.collect();
    write(&actors, rigged.iter().map(|(_, motion, _)| motion).enumerate().collect())
}

/// The bones that are asked for.
pub(crate) fn asked(args: &RigArgs) -> Result<Bones, CliError> {
    let rig = match &args.rig {
        None => None,
        Some(AskedRig::Known(rig)) => Some((*rig).into()),
        Some(AskedRig::Map(path)) => {
            let text = input::text(path)?;
            Some(RigMap::read(&text).map_err(|faults| input::faulty(path, &text, faults))?)
        }
    };
    Ok(Bones { rig, arrows: args.arrows })
}

/// Refuses bones and arrows that no file has.
pub(crate) fn check<'a>(args: &RigArgs, paths: impl IntoIterator<Item = &'a Path>) -> Result<(), UsageError> {
    let extensions: Vec<String> = paths.into_iter().map(extension).collect();
    check_bones(args, &extensions.iter().map(String::as_str).collect::<Vec<_>>())
}

/// The same by the files' extensions.
pub(crate) fn check_bones(args: &RigArgs, extensions: &[&str]) -> Result<(), UsageError> {
    let any = |known: &[&str]| extensions.iter().any(|extension| known.contains(extension));
    if args.rig.is_some() && !any(&["bvh", "glb", "usda"]) {
        return Err(UsageError::NoBones);
    }
    if args.arrows && !any(&["glb"]) {
        return Err(UsageError::NoArrows);
    }
    Ok(())
}
