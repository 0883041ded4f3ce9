//! Why a glTF file cannot be read.

use crate::bvh::BvhError;
use solaris_model::{FigureError, MotionError};

/// Why a glTF file cannot be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GlbError {
    /// Neither `glTF` nor a `{` stands first.
    #[error("it is no glTF: its first bytes are neither 'glTF' nor the '{{' of a .gltf file")]
    NotGltf,
    /// Another version than 2.
    #[error("it is glTF {version}; 2.0 is read: export it anew, or convert it (gltf-pipeline)")]
    Version {
        /// What it says.
        version: String,
    },
    /// A length of the container that goes past the file.
    #[error("the {what} at byte {at} says {said} bytes, and {left} are left: the file is cut off")]
    Length {
        /// Header or chunk.
        what: &'static str,
        /// Where it stands.
        at: usize,
        /// How long it says it is.
        said: usize,
        /// How many bytes there are.
        left: usize,
    },
    /// A container without its JSON.
    #[error("its first chunk is no JSON; every .glb begins with it")]
    NoJson,
    /// JSON that is none.
    #[error("its JSON is none: {message} (line {line}, column {column} of it)")]
    Json {
        /// What is wrong.
        message: String,
        /// Line of the JSON, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
    },
    /// A value of the JSON that cannot be.
    #[error("{place} is {value}; it must be {want}")]
    Value {
        /// Where, such as `accessors[3].count`.
        place: String,
        /// What stands there, cut where it is long.
        value: String,
        /// What must stand there.
        want: String,
    },
    /// Something that must be there and is not.
    #[error("{place} has no '{key}'")]
    Missing {
        /// Where.
        place: String,
        /// What is missing.
        key: String,
    },
    /// Bytes in another file.
    #[error("{place} is in another file, '{uri}'; save it as one .glb")]
    External {
        /// Which buffer.
        place: String,
        /// The other file.
        uri: String,
    },
    /// Bytes that an extension packs in its own way.
    #[error("{place} is packed by {extension}, which is not read; save it without")]
    Packed {
        /// Which view.
        place: String,
        /// The extension.
        extension: &'static str,
    },
    /// An array that goes past its bytes.
    #[error("{place} needs {needs} bytes, and {has} are there")]
    Bytes {
        /// Which accessor or view.
        place: String,
        /// How many it needs.
        needs: usize,
        /// How many there are.
        has: usize,
    },
    /// More numbers than are read.
    #[error("{place}: all arrays up to this one have more than {most} numbers; leave out what is not needed")]
    Many {
        /// Which accessor.
        place: String,
        /// The most that are read.
        most: usize,
    },
    /// Nodes that are no tree.
    #[error("{place} {why}; nodes must be trees")]
    Tree {
        /// The node.
        place: String,
        /// What is wrong.
        why: &'static str,
    },
    /// A number that is none.
    #[error("{place}, row {row} is {value}; it must be a finite number")]
    NotFinite {
        /// Which accessor or animation.
        place: String,
        /// The row, from 0.
        row: usize,
        /// What stands there.
        value: f64,
    },
    /// Keys that do not come one after the other.
    #[error("{place}: key {row} is at {time} s, not after the one before; times of keys must rise")]
    Times {
        /// Which sampler.
        place: String,
        /// The key, from 0.
        row: usize,
        /// Its time (s).
        time: f64,
    },
    /// No such animation.
    #[error("it has no animation '{name}'; {}", .names.as_deref().map_or_else(|| "it has none at all".to_owned(), |names| format!("its animations are {names}")))]
    NoClip {
        /// What was asked for.
        name: String,
        /// Those that there are.
        names: Option<String>,
    },
    /// Nothing that could be a figure.
    #[error("it has no skin, and no animation turns or moves a node: there are no bones to be read")]
    NoBones,
    /// Too many frames.
    #[error(
        "the animation lasts {duration} s, which makes {frames} frames of {bones} bones at {rate} frames/s, more than are read"
    )]
    Long {
        /// How long it is (s).
        duration: f64,
        /// Frames a second.
        rate: f64,
        /// So many frames.
        frames: f64,
        /// Of so many bones.
        bones: usize,
    },
    /// What was asked cannot be.
    #[error(transparent)]
    Options(#[from] BvhError),
    /// The bones are no figure.
    #[error(transparent)]
    Figure(#[from] FigureError),
    /// The numbers are no motion.
    #[error(transparent)]
    Motion(#[from] MotionError),
}
