//! Tables as Parquet, which pyarrow, pandas, polars, R and many others read: one row group, uncompressed.
//!
//! Headings are those of CSV. A column of numbers is of doubles, all there where it comes from a [`Table`]; one of texts is UTF-8.

use crate::{IoError, Table};
use ::parquet::basic::{ConvertedType, Repetition, Type as Physical};
use ::parquet::data_type::{ByteArray, ByteArrayType, DoubleType};
use ::parquet::errors::ParquetError;
use ::parquet::file::properties::WriterProperties;
use ::parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use ::parquet::schema::types::{Type, TypePtr};
use std::io::Write;
use std::sync::Arc;

/// A column, one value a row.
#[derive(Clone, Debug, PartialEq)]
pub enum Column {
    /// Numbers; `None` where there is none.
    Numbers(Vec<Option<f64>>),
    /// Texts.
    Texts(Vec<String>),
}

/// Writes a table.
///
/// # Errors
///
/// A writer that fails.
pub fn write_table(table: &Table, out: &mut impl Write) -> Result<(), IoError> {
    let columns = table.columns.iter().enumerate().map(|(index, heading)| {
        (heading.clone(), Column::Numbers(table.values_of(index).map(Some).collect()))
    });
    write(&columns.collect::<Vec<_>>(), out)
}

/// Writes columns of one length below their headings.
///
/// # Errors
///
/// A writer that fails.
pub fn write(columns: &[(String, Column)], out: &mut impl Write) -> Result<(), IoError> {
    let bytes = bytes(columns).map_err(|error| IoError::Write(std::io::Error::other(error)))?;
    Ok(out.write_all(&bytes)?)
}

/// The whole file. The library asks for a writer of its own; a table is small.
fn bytes(columns: &[(String, Column)]) -> Result<Vec<u8>, ParquetError> {
    let fields = columns.iter().map(field).collect::<Result<Vec<TypePtr>, _>>()?;
    let schema = Arc::new(Type::group_type_builder("table").with_fields(fields).build()?);
    // Measured numbers seldom repeat.
    let properties = Arc::new(WriterProperties::builder().set_dictionary_enabled(false).build());
    let mut bytes = Vec::new();
    let mut file = SerializedFileWriter::new(&mut bytes, schema, properties)?;
    let mut rows = file.next_row_group()?;
    for (_, column) in columns {
        if let Some(writer) = rows.next_column()? {
            fill(writer, column)?;
        }
    }
    rows.close()?;
    file.close()?;
    Ok(bytes)
}

fn field((heading, column): &(String, Column)) -> Result<TypePtr, ParquetError> {
    let (kind, converted, repetition) = match column {
        Column::Numbers(values) if values.iter().all(Option::is_some) => {
            (Physical::DOUBLE, ConvertedType::NONE, Repetition::REQUIRED)
        }
        Column::Numbers(_) => (Physical::DOUBLE, ConvertedType::NONE, Repetition::OPTIONAL),
        Column::Texts(_) => (Physical::BYTE_ARRAY, ConvertedType::UTF8, Repetition::REQUIRED),
    };
    let builder = Type::primitive_type_builder(heading, kind).with_converted_type(converted);
    Ok(Arc::new(builder.with_repetition(repetition).build()?))
}

fn fill(mut writer: SerializedColumnWriter<'_>, column: &Column) -> Result<(), ParquetError> {
    match column {
        Column::Numbers(values) => {
            let there: Vec<f64> = values.iter().copied().flatten().collect();
            let levels: Vec<i16> = values.iter().map(|value| i16::from(value.is_some())).collect();
            // Levels are of columns that may lack values.
            let levels = (there.len() < values.len()).then_some(&levels[..]);
            writer.typed::<DoubleType>().write_batch(&there, levels, None)?;
        }
        Column::Texts(texts) => {
            let texts: Vec<ByteArray> = texts.iter().map(|text| ByteArray::from(text.as_str())).collect();
            writer.typed::<ByteArrayType>().write_batch(&texts, None, None)?;
        }
    }
    writer.close()
}

#[cfg(test)]
mod tests {
    use super::*;
    use ::parquet::file::reader::{FileReader, SerializedFileReader};
    use ::parquet::record::Field;

    #[test]
    fn what_is_written_reads_back_with_the_same_bits() {
        let columns = [
            ("time".to_owned(), Column::Numbers(vec![Some(0.1), Some(-0.0), Some(1e-300)])),
            ("knee, left.tau".to_owned(), Column::Numbers(vec![None, Some(2.5), None])),
            ("why".to_owned(), Column::Texts(vec![String::new(), "täglich".to_owned(), "x".to_owned()])),
        ];
        let path = std::env::temp_dir().join(format!("solaris-{}.parquet", std::process::id()));
        write(&columns, &mut std::fs::File::create(&path).expect("a file")).expect("written");
        let reader = SerializedFileReader::new(std::fs::File::open(&path).expect("a file")).expect("Parquet");
        std::fs::remove_file(path).expect("removed");
        let rows: Vec<Vec<(String, Field)>> =
            reader.get_row_iter(None).expect("rows").map(|row| row.expect("a row").into_columns()).collect();
        let of = |column: usize| rows.iter().map(|row| row[column].1.clone()).collect::<Vec<Field>>();
        assert_eq!(
            rows[0].iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(),
            ["time", "knee, left.tau", "why"]
        );
        assert_eq!(of(0), [Field::Double(0.1), Field::Double(-0.0), Field::Double(1e-300)]);
        assert_eq!(of(1), [Field::Null, Field::Double(2.5), Field::Null]);
        assert_eq!(of(2), ["", "täglich", "x"].map(|text| Field::Str(text.to_owned())));
    }
}
