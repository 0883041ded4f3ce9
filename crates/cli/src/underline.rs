//! Faults of a text, each under the line that caused it.

use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use solaris::model::{TextError, TextFault, is_unseen, plain};
use std::fmt::Write;
use std::ops::Range;
use std::path::Path;

/// Columns of the output; longer lines are cut around the fault.
const WIDTH: usize = 120;
/// Bytes of the lines that are still shown.
const MOST_SHOWN: usize = 4000;

/// All faults, each with its line underlined, and how many there are.
pub(crate) fn faults(path: &Path, text: &str, error: &TextError) -> String {
    let renderer = Renderer::styled().decor_style(DecorStyle::Unicode).term_width(WIDTH);
    let path = path.display().to_string();
    let path = plain(&path);
    let mut shown = String::new();
    for fault in &error.faults {
        let _ = write!(shown, "\n{}\n", block(&renderer, &path, text, fault));
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

fn block(renderer: &Renderer, path: &str, text: &str, fault: &TextFault) -> String {
    let (place, message) = (&fault.place, &*plain(&fault.message));
    let lines = around(text, &place.span);
    let source = &text[lines.clone()];
    if source.len() > MOST_SHOWN || source.replace("\r\n", "\n").contains(is_unseen) {
        return format!("{path}:{}:{}: {message}", place.line, place.column);
    }
    let span = place.span.start - lines.start..place.span.end - lines.start;
    let snippet = Snippet::source(source)
        .path(path)
        .line_start(place.line)
        .annotation(AnnotationKind::Primary.span(span));
    renderer.render(&[Level::ERROR.no_name().primary_title(message).element(snippet)])
}

/// The whole lines that hold a span.
fn around(text: &str, span: &Range<usize>) -> Range<usize> {
    let first = text[..span.start].rfind('\n').map_or(0, |newline| newline + 1);
    let last = text[span.end..].find('\n').map_or(text.len(), |newline| span.end + newline);
    first..last
}
