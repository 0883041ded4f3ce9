//! The page: findings, two pictures, tables.

use super::{Against, Report, Table, svg};
use crate::html::{escape, fill};
use std::fmt::Write as _;

const TEMPLATE: &str = include_str!("../../assets/precision.html");
const STYLE: &str = include_str!("../../assets/precision.css");

/// A page with what was found, error against time and against evaluations, and the tables: a whole HTML file as text,
/// which needs nothing else and no scripts. The same report gives the same text, byte for byte.
pub fn page(report: &Report) -> String {
    let diagram = &report.diagram;
    let points = || diagram.series.iter().flat_map(|series| &series.points);
    let mut pictures = String::new();
    for against in [Against::Seconds, Against::Evaluations] {
        if points().any(|point| against.of(point).is_some()) {
            // Writing to a string cannot fail.
            let _ = writeln!(pictures, "<figure>\n{}</figure>", svg(diagram, against));
        }
    }
    let mut findings = String::new();
    for finding in &report.findings {
        let _ = writeln!(findings, "<p>{}</p>", escape(finding));
    }
    fill(
        TEMPLATE,
        &[
            ("title", &escape(&diagram.title)),
            ("subtitle", &escape(&diagram.subtitle)),
            ("style", STYLE),
            ("findings", &findings),
            ("pictures", &pictures),
            ("tables", &report.tables.iter().map(table).collect::<String>()),
        ],
    )
}

fn table(table: &Table) -> String {
    let mut html = format!("<section>\n<h2>{}</h2>\n", escape(&table.title));
    if !table.note.is_empty() {
        let _ = writeln!(html, "<p class=\"note\">{}</p>", escape(&table.note));
    }
    html.push_str("<div class=\"scroll\"><table>\n<thead><tr>");
    for name in &table.header {
        let _ = write!(html, "<th scope=\"col\">{}</th>", escape(name));
    }
    html.push_str("</tr></thead>\n<tbody>\n");
    for (index, row) in table.rows.iter().enumerate() {
        html.push_str(if table.marked.contains(&index) { "<tr class=\"marked\">" } else { "<tr>" });
        for (column, cell) in row.iter().enumerate() {
            let cell = escape(cell);
            let across = table.header.len() - row.len().min(table.header.len()) + 1;
            let _ = match column {
                0 => write!(html, "<th scope=\"row\">{cell}</th>"),
                _ if column + 1 == row.len() && across > 1 => {
                    write!(html, "<td class=\"across\" colspan=\"{across}\">{cell}</td>")
                }
                _ => write!(html, "<td>{cell}</td>"),
            };
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody>\n</table></div>\n</section>\n");
    html
}
