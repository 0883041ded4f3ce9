//! Whose bones an animation file has, and what else.

use super::wrap;
use clap::Args;
use solaris::io::rig::Rig;
use std::path::{Path, PathBuf};

/// The bones of an animation file.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct RigArgs {
    #[arg(
        long, value_name = "RIG", value_parser = asked,
        help = wrap(&format!(
            "Bones of .bvh, .glb and .usda as an animator's rig has them, in names and rest pose: {}, or as a .ron file tells \
             them, Rig(rest: T, bones: {{\"pelvis\": \"Hips\", …}}) [default: our own]",
            names()
        ))
    )]
    pub(crate) rig: Option<AskedRig>,
    #[arg(long, help = wrap(
        "In .glb, an arrow for each force of a contact, 1 m for the body's weight, and a ball at the centre of mass, as nodes of their own"
    ))]
    pub(crate) arrows: bool,
}

/// A rig by its name, or the file that tells it.
#[derive(Clone, Debug)]
pub(crate) enum AskedRig {
    Known(Rig),
    Map(PathBuf),
}

fn names() -> String {
    Rig::ALL.map(Rig::name).join(", ")
}

fn asked(text: &str) -> Result<AskedRig, String> {
    if let Some(rig) = Rig::ALL.into_iter().find(|rig| rig.name() == text) {
        return Ok(AskedRig::Known(rig));
    }
    let path = Path::new(text);
    if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("ron")) {
        return Ok(AskedRig::Map(path.to_owned()));
    }
    Err(format!("it must be {} or a .ron file with bones of your own", names()))
}
