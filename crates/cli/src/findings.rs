//! Findings about a figure that was read, by kind.

use crate::words::counted;
use solaris::model::{Finding, FindingKind, Medium};
use std::io::Write;

/// What kinds of findings are called: in JSON, and above a list of them.
pub(crate) fn heading(kind: FindingKind) -> (&'static str, &'static str) {
    match kind {
        FindingKind::Missing => ("missing", "Missing: it acts, and forces differ without it"),
        FindingKind::Suspect => ("suspect", "Looks wrong"),
        FindingKind::Unsupported => ("unsupported", "Not read: a figure has no place for it"),
        FindingKind::Note => ("note", "To know"),
    }
}

/// What there is to say of a medium that a figure's text, and a simulation, know nothing of.
pub(crate) fn of_medium(medium: &Medium, kind: FindingKind) -> Option<Finding> {
    let message = format!(
        "it resists {} and carries {} against gravity: solaris inverse counts that, with this model; the text of a figure has \
         no place for it, and a simulation leaves it out",
        counted(medium.immersed.len(), "body", "bodies"),
        counted(medium.carried.len(), "body", "bodies"),
    );
    (!medium.is_empty()).then(|| Finding { kind, subject: "the medium".to_owned(), message, place: None })
}

/// Lists findings by kind.
pub(crate) fn list(out: &mut dyn Write, findings: &[Finding]) -> std::io::Result<()> {
    for kind in [FindingKind::Missing, FindingKind::Suspect, FindingKind::Unsupported, FindingKind::Note] {
        let these: Vec<&Finding> = findings.iter().filter(|finding| finding.kind == kind).collect();
        if !these.is_empty() {
            writeln!(out, "\n{}", heading(kind).1)?;
            these.iter().try_for_each(|finding| writeln!(out, "  {finding}"))?;
        }
    }
    Ok(())
}
