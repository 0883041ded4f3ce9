//! Findings about a figure that was read, by kind.

use solaris::model::{Finding, FindingKind};
use std::io::Write;

/// What kinds of findings are called: in JSON, and above a list of them.
pub(crate) fn heading(kind: FindingKind) -> (&'static str, &'static str) {
    match kind {
        FindingKind::Suspect => ("suspect", "Looks wrong"),
        FindingKind::Unsupported => ("unsupported", "Not read: a figure has no place for it"),
        FindingKind::Note => ("note", "To know"),
    }
}

/// Lists findings by kind.
pub(crate) fn list(out: &mut dyn Write, findings: &[Finding]) -> std::io::Result<()> {
    for kind in [FindingKind::Suspect, FindingKind::Unsupported, FindingKind::Note] {
        let these: Vec<&Finding> = findings.iter().filter(|finding| finding.kind == kind).collect();
        if !these.is_empty() {
            writeln!(out, "\n{}", heading(kind).1)?;
            these.iter().try_for_each(|finding| writeln!(out, "  {finding}"))?;
        }
    }
    Ok(())
}
