//! A table of numbers as text: what is blessed keeps every digit that was written.

use super::case::fits;

/// A header and rows of as many fields.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Table {
    pub(crate) header: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

impl Table {
    /// Reads comma-separated text without quotes: names of degrees of freedom and links hold no commas.
    pub(crate) fn parse(text: &str) -> Result<Self, String> {
        let fields =
            |line: &str| line.split(',').map(|field| field.trim().to_owned()).collect::<Vec<String>>();
        let mut lines = text.lines();
        let header = fields(lines.next().filter(|line| !line.is_empty()).ok_or("the table is empty")?);
        if let Some(name) = header.iter().enumerate().find(|(i, name)| header[..*i].contains(name)) {
            return Err(format!("column '{}' stands twice", name.1));
        }
        let rows: Vec<Vec<String>> = lines.map(fields).collect();
        match rows.iter().position(|row| row.len() != header.len()) {
            Some(i) => {
                Err(format!("line {} has {} fields, the header has {}", i + 2, rows[i].len(), header.len()))
            }
            None => Ok(Self { header, rows }),
        }
    }

    /// Every `every`-th row from the first, and of the columns `time` and those that fit a pattern; all without patterns.
    pub(crate) fn reduced(&self, every: usize, patterns: &[String]) -> Result<Self, String> {
        if let Some(idle) =
            patterns.iter().find(|pattern| !self.header.iter().any(|name| fits(pattern, name)))
        {
            return Err(format!("no column fits \"{idle}\" of `columns`"));
        }
        let is_kept =
            |name: &str| patterns.is_empty() || name == "time" || patterns.iter().any(|p| fits(p, name));
        let kept: Vec<usize> = (0..self.header.len()).filter(|&i| is_kept(&self.header[i])).collect();
        let pick = |row: &Vec<String>| kept.iter().map(|&i| row[i].clone()).collect();
        Ok(Self { header: pick(&self.header), rows: self.rows.iter().step_by(every).map(pick).collect() })
    }

    pub(crate) fn to_text(&self) -> String {
        std::iter::once(&self.header).chain(&self.rows).map(|row| row.join(",") + "\n").collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_thinned_and_printed_with_its_digits() {
        let table =
            Table::parse("time,a.q,b.q,a.v\n0,1.50,2,3\n0.1,4,5,6\n0.2,7,8,9\n").expect("well-formed");
        let small = table.reduced(2, &["a.*".to_owned()]).expect("a column fits");
        assert_eq!(small.to_text(), "time,a.q,a.v\n0,1.50,3\n0.2,7,9\n");
        assert_eq!(table.reduced(1, &[]), Ok(table.clone()));
        assert!(table.reduced(1, &["c.*".to_owned()]).is_err());
    }

    #[test]
    fn ragged_and_double_columns_are_refused() {
        assert_eq!(Table::parse("a,b\n1,2\n3\n"), Err("line 3 has 1 fields, the header has 2".to_owned()));
        assert_eq!(Table::parse("a,a\n"), Err("column 'a' stands twice".to_owned()));
        assert!(Table::parse("").is_err());
    }
}
