//! Recordings of markers: C3D and TRC files.

pub(crate) use solaris::files::{Turned, in_world, is_recording as is_one, recording as read, turned};

use crate::error::UsageError;
use solaris::io::bvh::Unit;
use solaris::io::markers::LengthUnit;
use solaris::model::{Finding, FindingKind};

/// The unit of lengths that `--unit` names.
pub(crate) fn unit(asked: Option<Unit>) -> Result<Option<LengthUnit>, UsageError> {
    Ok(match asked {
        None => None,
        Some(Unit::Millimetres) => Some(LengthUnit::Millimetres),
        Some(Unit::Centimetres) => Some(LengthUnit::Centimetres),
        Some(Unit::Metres) => Some(LengthUnit::Metres),
        Some(Unit::Inches) => Some(LengthUnit::Inches),
        Some(Unit::Cmu | Unit::Of(_)) => return Err(UsageError::UnitOfMarkers),
    })
}

/// Those of findings that look wrong.
pub(crate) fn doubts(findings: &[Finding]) -> usize {
    findings
        .iter()
        .filter(|finding| matches!(finding.kind, FindingKind::Missing | FindingKind::Suspect))
        .count()
}
