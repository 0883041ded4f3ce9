//! Faults as a person sees them: the line, and what is wrong underlined.

use solaris_model::TextError;
use std::fmt::Write as _;

/// Every fault with its line of the text.
pub(crate) fn render(text: &str, error: &TextError) -> String {
    let mut shown = String::new();
    for fault in &error.faults {
        let place = &fault.place;
        let line = text.split('\n').nth(place.line - 1).unwrap_or_default().trim_end_matches('\r');
        let inside = &text[place.span.clone()];
        let width =
            inside.split('\n').next().unwrap_or_default().trim_end_matches('\r').chars().count().max(1);
        // Long lines are shown around the fault.
        let skip = if line.chars().count() > 110 { place.column.saturating_sub(40) } else { 0 };
        let clip: String =
            line.chars().skip(skip).take(110).map(|c| if c.is_control() { '·' } else { c }).collect();
        let _ = writeln!(shown, "{}:{}: {}", place.line, place.column, fault.message);
        let _ = writeln!(shown, "  | {clip}");
        let caret = place.column - 1 - skip;
        let _ = writeln!(shown, "  | {}{}", " ".repeat(caret), "^".repeat(width.min(110 - caret.min(109))));
    }
    if error.omitted > 0 {
        let _ = writeln!(shown, "and {} more", error.omitted);
    }
    shown
}
