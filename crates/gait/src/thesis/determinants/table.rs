//! A table of the thesis, computed anew, with what is printed beside it.

use std::fmt::Write as _;

/// How a computed cell stands to the printed one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Agreement {
    /// They agree.
    Agrees,
    /// They do not, and the table's notes say why.
    Differs,
    /// Nothing is printed to compare with.
    Unprinted,
}

/// A cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// What was computed, or the corrected entry.
    pub computed: String,
    /// What is printed; empty where nothing is.
    pub printed: String,
    /// How the two stand.
    pub agreement: Agreement,
}

impl Cell {
    /// A cell that nothing is printed for.
    pub fn plain(computed: impl Into<String>) -> Self {
        Self { computed: computed.into(), printed: String::new(), agreement: Agreement::Unprinted }
    }

    /// A cell beside its printed one.
    pub fn beside(computed: impl Into<String>, printed: impl Into<String>, agrees: bool) -> Self {
        let agreement = if agrees { Agreement::Agrees } else { Agreement::Differs };
        Self { computed: computed.into(), printed: printed.into(), agreement }
    }

    /// As one text: `47 ✓`, `4.5 (printed 4) ✗`, `62°`.
    pub fn text(&self) -> String {
        match self.agreement {
            Agreement::Agrees if self.computed == self.printed => format!("{} ✓", self.computed),
            Agreement::Agrees => format!("{} (printed {}) ✓", self.computed, self.printed),
            Agreement::Differs => format!("{} (printed {}) ✗", self.computed, self.printed),
            Agreement::Unprinted => self.computed.clone(),
        }
    }
}

/// A table.
#[derive(Clone, Debug, PartialEq)]
pub struct GaitTable {
    /// Its number in the thesis: `7.7`; empty where it is none of the thesis's.
    pub number: &'static str,
    /// What it shows.
    pub title: &'static str,
    /// Headings.
    pub columns: Vec<String>,
    /// Rows of as many cells.
    pub rows: Vec<Vec<Cell>>,
    /// What has to be said about it.
    pub notes: Vec<String>,
}

impl GaitTable {
    /// Of texts: `corrected|printed`, or one text where both are the same; `corrected|` where nothing is printed. The first
    /// `head` columns name the row.
    pub(super) fn corrected(
        (number, title): (&'static str, &'static str),
        columns: &[&str],
        head: usize,
        rows: &[&[&str]],
        notes: &[&str],
    ) -> Self {
        let cell = |(i, text): (usize, &&str)| match text.split_once('|') {
            _ if i < head => Cell::plain(*text),
            Some((corrected, "")) => Cell::plain(corrected),
            Some((corrected, printed)) => Cell::beside(corrected, printed, false),
            None => Cell::beside(*text, *text, true),
        };
        let owned = |texts: &[&str]| texts.iter().map(|&text| text.to_owned()).collect();
        Self {
            number,
            title,
            columns: owned(columns),
            rows: rows.iter().map(|row| row.iter().enumerate().map(cell).collect()).collect(),
            notes: owned(notes),
        }
    }

    /// How many cells agree with the printed ones, and how many are printed.
    pub fn agreement(&self) -> (usize, usize) {
        let cells = || self.rows.iter().flatten();
        let agree = cells().filter(|cell| cell.agreement == Agreement::Agrees).count();
        (agree, cells().filter(|cell| cell.agreement != Agreement::Unprinted).count())
    }

    fn heading(&self, mark: &str) -> String {
        let Self { number, title, .. } = self;
        if number.is_empty() {
            format!("{mark}{title}{mark}")
        } else {
            format!("{mark}Table {number}{mark}: {title}")
        }
    }

    /// As text, columns aligned.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n\n", self.heading(""));
        let texts: Vec<Vec<String>> =
            self.rows.iter().map(|row| row.iter().map(Cell::text).collect()).collect();
        let width = |column: usize| {
            let cells = texts.iter().map(|row| &row[column]).chain([&self.columns[column]]);
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..self.columns.len()).map(width).collect();
        for row in [&self.columns].into_iter().chain(&texts) {
            let padded = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}"));
            let _ = writeln!(text, "  {}", padded.collect::<Vec<_>>().join("  ").trim_end());
        }
        self.end(&mut text);
        text
    }

    /// As Markdown.
    pub fn markdown(&self) -> String {
        let mut text = format!("{}\n\n", self.heading("**"));
        let line = |cells: &[String]| format!("| {} |\n", cells.join(" | "));
        text += &line(&self.columns);
        let _ = writeln!(text, "|{}", "---|".repeat(self.columns.len()));
        for row in &self.rows {
            text += &line(&row.iter().map(Cell::text).collect::<Vec<_>>());
        }
        self.end(&mut text);
        text
    }

    fn end(&self, text: &mut String) {
        let (agree, printed) = self.agreement();
        if printed > 0 {
            let _ = write!(text, "\n{agree} of {printed} printed cells agree.\n");
        }
        for note in &self.notes {
            let _ = write!(text, "\n{note}\n");
        }
    }

    /// As comma-separated values: every column, and behind it what is printed and whether they agree, where anything in that
    /// column is printed.
    pub fn csv(&self) -> String {
        let printed =
            |column: usize| self.rows.iter().any(|row| row[column].agreement != Agreement::Unprinted);
        let quoted = |text: &str| {
            if text.contains([',', '"', '\n']) {
                format!("\"{}\"", text.replace('"', "\"\""))
            } else {
                text.to_owned()
            }
        };
        let mut heads = Vec::new();
        for (i, head) in self.columns.iter().enumerate() {
            heads.push(quoted(head));
            if printed(i) {
                heads.extend([quoted(&format!("{head} (printed)")), quoted(&format!("{head} (agrees)"))]);
            }
        }
        let mut text = heads.join(",") + "\n";
        for row in &self.rows {
            let mut cells = Vec::new();
            for (i, cell) in row.iter().enumerate() {
                cells.push(quoted(&cell.computed));
                if printed(i) {
                    let agrees = match cell.agreement {
                        Agreement::Agrees => "yes",
                        Agreement::Differs => "no",
                        Agreement::Unprinted => "",
                    };
                    cells.extend([quoted(&cell.printed), agrees.to_owned()]);
                }
            }
            text += &(cells.join(",") + "\n");
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_says_what_agrees() {
        let table = GaitTable {
            number: "7.0",
            title: "a test",
            columns: vec!["sf".to_owned(), "χ".to_owned()],
            rows: vec![
                vec![Cell::plain("20"), Cell::beside("47", "47", true)],
                vec![Cell::plain("40"), Cell::beside("4.5", "4", false)],
            ],
            notes: vec!["A note.".to_owned()],
        };
        assert_eq!(table.agreement(), (1, 2));
        let text = "Table 7.0: a test\n\n  sf  χ\n  20  47 ✓\n  40  4.5 (printed 4) ✗\n\n1 of 2 printed cells agree.\n\nA note.\n";
        assert_eq!(table.text(), text);
        assert_eq!(table.csv(), "sf,χ,χ (printed),χ (agrees)\n20,47,47,yes\n40,4.5,4,no\n");
        assert!(table.markdown().contains("| sf | χ |\n|---|---|\n| 20 | 47 ✓ |\n"));
    }
}
