//! Whose bones an animation file has.

use super::wrap;
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use solaris::io::rig::Rig;

/// The bones of an animation file.
#[derive(Clone, Copy, Debug, Default, Args)]
pub(crate) struct RigArgs {
    #[arg(
        long, value_name = "RIG", hide_possible_values = true,
        value_parser = PossibleValuesParser::new(Rig::ALL.map(Rig::name)).map(|name| named(&name)),
        help = wrap(&format!(
            "Bones of .bvh, .glb and .usda as an animator's rig has them, in names and rest pose: {} [default: our own]",
            Rig::ALL.map(Rig::name).join(", ")
        ))
    )]
    pub(crate) rig: Option<Rig>,
}

fn named(name: &str) -> Rig {
    Rig::ALL.into_iter().find(|rig| rig.name() == name).unwrap_or(Rig::ALL[0])
}
