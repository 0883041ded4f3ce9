//! The picture that a command draws, in the files that are asked for.

use crate::error::CliError;
use crate::output::{Formats, Outputs};
use solaris::view::picture_page;
use std::io::Write;
use std::path::PathBuf;

/// What a file holds: the picture, or a page with it.
#[derive(Clone, Copy, Debug)]
enum Format {
    Svg,
    Html,
}

const FORMATS: Formats<Format> = &[("svg", Format::Svg), ("html", Format::Html)];

/// The files of one picture.
pub(super) struct Picture(Outputs<Format>);

impl Picture {
    /// Those at these paths, checked before the work begins.
    pub(super) fn asked(paths: &[PathBuf]) -> Result<Self, CliError> {
        Ok(Self(Outputs::new(paths.iter().map(|path| ("-o", path, FORMATS)))?))
    }

    /// Writes them all, or none; nothing is drawn that nobody asks for.
    pub(super) fn write(&self, title: &str, svg: impl Fn() -> String) -> Result<(), CliError> {
        self.0.write(|format, writer| {
            let text = match format {
                Format::Svg => svg(),
                Format::Html => picture_page(title, &svg()),
            };
            writer.write_all(text.as_bytes()).map_err(CliError::other)
        })
    }

    /// Says what was written, or how to have it written.
    pub(super) fn tell(&self, out: &mut dyn Write, add: &str) -> std::io::Result<()> {
        if self.0.paths().next().is_none() {
            return writeln!(out, "\nnothing is written; add {add}");
        }
        writeln!(out)?;
        self.0.written().try_for_each(|line| writeln!(out, "{line}"))
    }
}
