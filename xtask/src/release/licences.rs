//! What others wrote: under which licences, from where, and whether anything is known against it, by cargo-deny and `deny.toml`.

use super::Done;
use super::state::{State, listened, outside, starts};
use crate::workspace::root;

const LACKING: &str = "there is no cargo-deny (cargo install cargo-deny)";

/// Licences, sources, and crates that are there twice.
pub(super) fn allowed(_: &State) -> Result<Done, String> {
    if !starts(outside(root()).args(["deny", "--version"])) {
        return Ok(Done::Skipped(LACKING.to_owned()));
    }
    listened(outside(root()).args([
        "deny",
        "--offline",
        "--log-level",
        "error",
        "check",
        "licenses",
        "bans",
        "sources",
    ]))?;
    Ok(Done::Holds("licences, sources and bans are those of deny.toml".to_owned()))
}

/// Known weaknesses; their list is fetched.
pub(super) fn advisories(_: &State) -> Result<Done, String> {
    if !starts(outside(root()).args(["deny", "--version"])) {
        return Ok(Done::Skipped(LACKING.to_owned()));
    }
    if !starts(outside(root()).args(["deny", "--log-level", "error", "fetch", "db"])) {
        return Ok(Done::Skipped("the list of known weaknesses cannot be fetched".to_owned()));
    }
    listened(outside(root()).args(["deny", "--log-level", "error", "check", "advisories"]))?;
    Ok(Done::Holds("nothing is known against what others wrote".to_owned()))
}
