//! The text of the page.

use crate::data::Data;
use crate::{PageOptions, TableRow, Viewer};
use solaris_model::plain;
use std::fmt::Write as _;

const TEMPLATE: &str = include_str!("../assets/page.html");

/// The whole page.
pub(crate) fn render(data: &Data, options: &PageOptions, viewer: &Viewer<'_>) -> String {
    let json = data.to_json();
    let title = if options.title.trim().is_empty() { &data.figure } else { &options.title };
    fill(
        TEMPLATE,
        &[
            ("title", &escape(title)),
            ("style", viewer.style),
            ("legend", if data.sided { "" } else { " hidden" }),
            ("table", &table(&options.table)),
            ("data", &guard(&json)),
            ("viewer", viewer.script),
        ],
    )
}

/// Puts values in the places of `{{names}}`, in one pass: what a value holds is never taken for a place.
pub(crate) fn fill(template: &str, values: &[(&str, &str)]) -> String {
    let mut page =
        String::with_capacity(template.len() + values.iter().map(|(_, value)| value.len()).sum::<usize>());
    for (i, piece) in template.split("{{").enumerate() {
        let place = piece.split_once("}}").filter(|_| i > 0);
        let value =
            place.and_then(|(name, rest)| Some((values.iter().find(|(key, _)| *key == name)?.1, rest)));
        match value {
            Some((value, rest)) => page.extend([value, rest]),
            None => page.extend([if i > 0 { "{{" } else { "" }, piece]),
        }
    }
    page
}

/// Text for elements and quoted attributes. What is not seen is written out: most of it may not stand in a picture at all.
pub(crate) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in plain(text).chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            _ => escaped.push(character),
        }
    }
    escaped
}

/// JSON that cannot end the element it stands in: `<` occurs in strings only, and there `\u003c` is the same.
pub(crate) fn guard(json: &str) -> String {
    json.replace('<', "\\u003c")
}

/// The summary; empty without rows.
pub(crate) fn table(rows: &[TableRow]) -> String {
    if rows.is_empty() {
        return String::new();
    }
    let mut html = String::from("  <details open>\n    <summary>Summary</summary>\n    <table>\n");
    for row in rows {
        let [label, value, unit, note] =
            [&row.label, &row.value, &row.unit, &row.note].map(|text| escape(text));
        // A sentence without a number has the whole width.
        let cells = if value.is_empty() && unit.is_empty() {
            format!("<td class=\"note\" colspan=\"3\">{note}</td>")
        } else {
            format!(
                "<td class=\"value\">{value}</td><td class=\"unit\">{unit}</td><td class=\"note\">{note}</td>"
            )
        };
        // Writing to a string cannot fail.
        let _ = writeln!(html, "      <tr><th scope=\"row\">{label}</th>{cells}</tr>");
    }
    html.push_str("    </table>\n  </details>");
    html
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_seen_is_written_out() {
        assert_eq!(escape("a\u{1b}[31m\u{9b}\u{202e}<b>"), "a\\u{1b}[31m\\u{9b}\\u{202e}&lt;b&gt;");
    }

    #[test]
    fn values_are_not_searched_for_places() {
        assert_eq!(fill("a {{x}} b {{y}} {{z}}", &[("x", "{{y}}"), ("y", "2")]), "a {{y}} b 2 {{z}}");
    }

    #[test]
    fn all_places_of_the_template_are_known() {
        let names: Vec<&str> =
            TEMPLATE.split("{{").skip(1).filter_map(|piece| Some(piece.split_once("}}")?.0)).collect();
        assert_eq!(names, ["title", "style", "title", "legend", "table", "data", "viewer"]);
    }

    #[test]
    #[cfg(feature = "assets")]
    fn the_embedded_files_cannot_end_their_elements() {
        let Viewer { script, style } = Viewer::OWN;
        let lower = script.to_lowercase();
        assert!(!lower.contains("</script") && !lower.contains("<!--"), "rebuild assets/viewer.js");
        assert!(!style.to_lowercase().contains("</style"));
    }

    #[test]
    fn a_table_without_rows_leaves_nothing() {
        assert_eq!(table(&[]), "");
        assert!(table(&[TableRow::new("a", "1", "m", "x<y")]).contains("<td class=\"note\">x&lt;y</td>"));
        assert!(
            table(&[TableRow::new("a", "", "", "said")])
                .contains("<td class=\"note\" colspan=\"3\">said</td>")
        );
    }
}
