#![doc = include_str!("../README.md")]

mod error;
mod external;
mod figure;
mod files;
mod fit;
mod folder;
mod forces;
mod given;
mod moments;
mod motion;
mod open;
mod plates;
mod read;
mod recording;
mod scene;
mod soles;
mod words;

pub use error::FileError;
pub use external::{External, ExternalError};
pub use figure::{Body, Language, actuators, body, body_in, body_with, clip, is_clip, language, ties};
pub use files::{Disk, Files, Source};
pub use fit::{MarkerFit, fit_markers};
pub use forces::{Acting, JointForces, check_measured, joint_forces};
pub use given::Given;
pub use moments::{AskedGround, MomentOptions, Moments};
pub use motion::{is_motion, motion, table};
pub use open::{Alone, FileRole, Held, OpenOptions, Opened, OpenedMotion, open};
pub use plates::OwnPlates;
pub use read::{MOST_BYTES, bytes, decoded, extension, refuse_unread, text};
pub use recording::{Turned, in_world, is_recording, recording, turned};
pub use scene::{LoadedScene, SCENE, scene};
pub use soles::SolesFrom;
pub use words::short;
