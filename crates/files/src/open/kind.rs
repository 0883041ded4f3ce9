//! What a file is, by its name and by what it holds.

use crate::files::Source;
use crate::read::extension;
use solaris_io::decode;
use solaris_model::text::first_word;
use std::path::Path;

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Figure,
    /// Body and motion in one.
    Clip,
    /// A motion, or forces.
    Table,
    Markers,
    /// Which forces push which bodies.
    Loads,
    Soles,
    Scene,
    Page,
    Profile,
    /// What others may name, or nobody knows.
    Other,
}

impl Kind {
    /// Of a file; one that cannot be read is whatever its name says.
    pub(super) fn of(source: Source<'_>, name: &str) -> Self {
        let path = Path::new(name);
        let text = || source.bytes(path).ok().and_then(|bytes| decode(bytes).ok()).map(|(text, _)| text);
        match extension(path).as_str() {
            "urdf" | "mjcf" | "osim" | "sdf" | "world" => Self::Figure,
            "bvh" | "glb" | "gltf" => Self::Clip,
            "csv" | "mot" | "sto" => Self::Table,
            "trc" | "c3d" => Self::Markers,
            "html" | "htm" => Self::Page,
            "xml" => match text().as_deref().map(crate::figure::root_element) {
                Some("mujoco" | "robot" | "sdf") => Self::Figure,
                Some("OpenSimDocument" | "ExternalLoads") => {
                    if text().is_some_and(|text| text.contains("<ExternalLoads")) {
                        Self::Loads
                    } else if text().is_some_and(|text| text.contains("<Model")) {
                        Self::Figure
                    } else {
                        Self::Other
                    }
                }
                _ => Self::Other,
            },
            "ron" | "txt" | "" => match text().as_deref().and_then(first_word) {
                Some("Figure" | "Human") => Self::Figure,
                Some("Scene") => Self::Scene,
                Some("Soles") => Self::Soles,
                Some(word) if is_curve(word) => Self::Profile,
                // A text that is named as those of this program are is meant to be one.
                _ if extension(path) == "ron" => Self::Scene,
                _ => Self::Other,
            },
            _ => Self::Other,
        }
    }
}

fn is_curve(word: &str) -> bool {
    solaris_profiles::Profile::KINDS.iter().any(|kind| kind.variant == word)
        || ["Blend", "Weighted", "Sine", "Repeat", "ProfileLayer"].contains(&word)
}
