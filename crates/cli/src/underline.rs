//! Faults of a text, each under the line that caused it.

use miette::{GraphicalReportHandler, GraphicalTheme, LabeledSpan, MietteDiagnostic, NamedSource, Report};
use solaris::model::{TextError, TextFault};
use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

/// Columns of the output.
const WIDTH: usize = 110;
/// Bytes of a line that is still shown.
const LONGEST_LINE: usize = 400;

/// All faults, each with its line underlined, and how many there are.
pub(crate) fn faults(path: &Path, text: &str, error: &TextError) -> String {
    let source = Arc::new(NamedSource::new(path.display().to_string(), text.to_owned()));
    let handler = GraphicalReportHandler::new_themed(GraphicalTheme::unicode())
        .with_width(WIDTH)
        .with_context_lines(1)
        .with_links(false);
    let mut shown = String::new();
    for fault in &error.faults {
        let mut block = String::new();
        let written = can_be_shown(text, fault)
            && handler.render_report(&mut block, report(&source, fault).as_ref()).is_ok();
        if !written {
            block = format!("  × {}: {}\n", fault.place, fault.message);
        }
        let _ = write!(shown, "\n{}", block.trim_start_matches('\n'));
    }
    let count = error.faults.len() + error.omitted;
    if count > 1 {
        let _ = write!(shown, "\n{count} faults");
        if error.omitted > 0 {
            let _ = write!(shown, ", of which the first {} are shown", error.faults.len());
        }
        shown.push('\n');
    }
    shown
}

fn report(source: &Arc<NamedSource<String>>, fault: &TextFault) -> Report {
    let label = LabeledSpan::underline(fault.place.span.clone());
    Report::new(MietteDiagnostic::new(fault.message.clone()).with_label(label))
        .with_source_code(source.clone())
}

/// Whether the fault's lines and those around them are few and short, and text.
fn can_be_shown(text: &str, fault: &TextFault) -> bool {
    let span = &fault.place.span;
    let first = text[..span.start].rmatch_indices('\n').nth(1).map_or(0, |(newline, _)| newline + 1);
    let last =
        text[span.end..].match_indices('\n').nth(1).map_or(text.len(), |(newline, _)| span.end + newline);
    let lines = &text[first..last];
    lines.len() <= 3 * LONGEST_LINE
        && lines.lines().all(|line| line.len() <= LONGEST_LINE)
        && !lines.chars().any(|c| c.is_control() && !matches!(c, '\n' | '\r' | '\t'))
}
