//! A table to a text.

use super::header::is_key;
use crate::error::IoError;
use crate::table::{TIME, Table, bare, is_around};
use std::io::{self, Write};

/// Writes a table as OpenSim reads it.
///
/// Numbers have the fewest digits that read back to the same bits; times and numbers stand as they are, in the units
/// that `table.in_degrees` claims. [`super::read()`] gives the same table back, but for the places of its lines, and blanks
/// and byte order marks in its title.
///
/// # Errors
///
/// A table without a column of times, a number that is not finite, a heading that is empty or holds a blank, headings that
/// stand twice, and the writer's own errors.
pub fn write(table: &Table, out: &mut impl Write) -> Result<(), IoError> {
    table.check_headings()?;
    if table.column(TIME).is_none() {
        return Err(IoError::StoTime);
    }
    let is_word =
        |name: &String| !name.is_empty() && bare(name) == name && !name.contains(char::is_whitespace);
    if let Some(name) = table.columns.iter().find(|name| !is_word(name)) {
        return Err(IoError::StoHeading { name: name.clone() });
    }
    header(table, out)?;
    writeln!(out, "{}", table.columns.join("\t"))?;
    let mut text = Vec::new();
    for index in 0..table.len() {
        text.clear();
        for (i, (&value, name)) in table.row(index).iter().zip(&table.columns).enumerate() {
            if !value.is_finite() {
                let time = table.column("time").map_or(index as f64, |time| table.row(index)[time]);
                return Err(IoError::NotFinite { column: name.clone(), time, value });
            }
            if i > 0 {
                text.push(b'\t');
            }
            number(value, &mut text)?;
        }
        text.push(b'\n');
        out.write_all(&text)?;
    }
    Ok(())
}

fn header(table: &Table, out: &mut impl Write) -> io::Result<()> {
    let title = table.title.split(is_around).filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ");
    let first = title.split([' ', '=']).next().unwrap_or_default();
    match first {
        "" if title.is_empty() => {}
        // Such a title would be taken for what it begins with.
        word if is_key(word) => writeln!(out, "name={title}")?,
        _ => writeln!(out, "{title}")?,
    }
    writeln!(out, "version=1\nnRows={}\nnColumns={}", table.len(), table.columns.len())?;
    if let Some(in_degrees) = table.in_degrees {
        writeln!(out, "inDegrees={}", if in_degrees { "yes" } else { "no" })?;
    }
    writeln!(out, "endheader")
}

/// The fewest digits that read back to the same bits; an exponent only where zeros would fill the field.
fn number(value: f64, text: &mut Vec<u8>) -> io::Result<()> {
    let size = value.abs();
    if size == 0.0 || (1e-5..1e16).contains(&size) {
        write!(text, "{value}")
    } else {
        write!(text, "{value:e}")
    }
}
