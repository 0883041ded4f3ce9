//! Motions as binary glTF.

use crate::error::CliError;
use solaris::io::glb::{Actor, Clip, Detail, Options, write};
use solaris::model::{Figure, Motion};
use std::io::Write;

/// One figure and its motion, by the figure's name and that of the motion.
pub(crate) fn one(
    figure: &Figure,
    motion: &Motion,
    clip: &str,
    mut writer: &mut dyn Write,
) -> Result<(), CliError> {
    let actor = Actor { name: figure.name(), figure };
    let clip = Clip { name: clip, motions: vec![(0, motion)] };
    write(&[actor], &[clip], Options::default(), &mut writer).map_err(CliError::other)
}

/// Somebody of a crowd.
pub(crate) struct Person {
    pub(crate) name: String,
    pub(crate) figure: Figure,
    pub(crate) motion: Motion,
}

/// All of them in one file, and one clip that moves them.
pub(crate) fn crowd(people: &[Person], mut writer: &mut dyn Write) -> Result<(), CliError> {
    let actors: Vec<Actor> =
        people.iter().map(|person| Actor { name: &person.name, figure: &person.figure }).collect();
    let motions = people.iter().map(|person| &person.motion).enumerate().collect();
    let options = Options { skin: Some(Detail::Rough), ..Options::default() };
    write(&actors, &[Clip { name: "crowd", motions }], options, &mut writer).map_err(CliError::other)
}
