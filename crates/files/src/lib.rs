#![doc = include_str!("../README.md")]

mod error;
mod figure;
mod files;
mod folder;
mod given;
mod motion;
mod read;
mod recording;
mod scene;

pub use error::FileError;
pub use figure::{Body, Language, actuators, body, body_in, body_with, clip, is_clip, language, ties};
pub use files::{Disk, Files, Source};
pub use given::Given;
pub use motion::{is_motion, motion, table};
pub use read::{MOST_BYTES, bytes, decoded, extension, refuse_unread, text};
pub use recording::{Turned, in_world, is_recording, recording, turned};
pub use scene::{LoadedScene, SCENE, scene};
