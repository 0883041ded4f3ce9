//! Motions as files.

use crate::errors::{of_path, plain};
use crate::motion::Motion;
use pyo3::PyResult;
use solaris::files::extension;
use solaris::io::glb::{self, Actor, Clip};
use solaris::io::{bvh, csv, parquet, record, sto, usd};
use solaris::scene::OneOfSeveral;
use solaris::skin::{Skin, parts, skin};
use solaris::view::{FilmOptions, PageOptions, PagePerson, film};
use std::fs;
use std::path::Path;

/// The page of a motion.
pub(crate) fn page(of: &Motion) -> PyResult<String> {
    let people = of.several.iter().map(|one| PagePerson { first: one.first, figure: one.alone.clone() });
    let options = PageOptions { title: of.title.clone(), people: people.collect(), ..PageOptions::default() };
    solaris::view::page(of.figure.figure(), &of.motion, &options)
        .map_err(|error| plain("MotionError")(&error))
}

/// Writes a motion in the format of the path's extension.
pub(crate) fn save(of: &Motion, path: &Path, arrows: bool) -> PyResult<()> {
    let figure = of.figure.figure();
    let refuse = |error: &dyn std::fmt::Display| of_path(path, &format!("{}: {error}", path.display()));
    let format = extension(path);
    // Pages and clips go by their time; who plays frame after frame shall not see one twice.
    let by_frames = of.repeats && matches!(format.as_str(), "csv" | "bvh" | "mot" | "sto" | "parquet");
    let shorter = by_frames.then(|| of.motion.without_last());
    let motion = shorter.as_ref().unwrap_or(&of.motion);
    let mut bytes = Vec::new();
    match format.as_str() {
        "html" => bytes = page(of)?.into_bytes(),
        "csv" => csv::write(figure, motion, &mut bytes).map_err(|error| refuse(&error))?,
        "bvh" => {
            bvh::write(figure, motion, bvh::Unit::default(), &mut bytes).map_err(|error| refuse(&error))?;
        }
        "glb" => {
            let options = glb::Options { forces: arrows, ..glb::Options::default() };
            let skins: Vec<Skin> = of.several.iter().map(|one| skin(&one.alone, detail(of))).collect();
            let several = of.several.iter().zip(&skins);
            let mut actors: Vec<Actor> = several
                .map(|(one, skin)| Actor { name: &one.name, figure: &one.figure, skin: Some(skin) })
                .collect();
            let mut motions: Vec<_> = of.several.iter().map(|one| &one.motion).enumerate().collect();
            if actors.is_empty() {
                actors.push(Actor { name: figure.name(), figure, skin: None });
                motions.push((0, motion));
            }
            let clips = [Clip { name: "motion", motions }];
            glb::write(&actors, &clips, options, &mut bytes).map_err(|error| refuse(&error))?;
        }
        "usda" => {
            let skin = skin(figure, glb::Detail::default());
            usd::write(figure, &skin, "motion", motion, &mut bytes).map_err(|error| refuse(&error))?;
        }
        "mot" | "sto" => {
            let table = record::positions_in_degrees(figure, motion);
            sto::write(&table, &mut bytes).map_err(|error| refuse(&error))?;
        }
        "parquet" => {
            let columns: Vec<(String, parquet::Column)> = record::headings(figure, motion)
                .into_iter()
                .zip(crate::arrow::columns(motion))
                .map(|(name, numbers)| {
                    (name, parquet::Column::Numbers(numbers.into_iter().map(Some).collect()))
                })
                .collect();
            parquet::write(&columns, &mut bytes).map_err(|error| refuse(&error))?;
        }
        "svg" => {
            let options = FilmOptions { title: of.title.clone(), ..FilmOptions::default() };
            bytes = film(figure, motion, &options).map_err(|error| refuse(&error))?.into_bytes();
        }
        _ => {
            let known = ".html, .glb, .usda, .bvh, .csv, .parquet, .mot, .sto or .svg";
            return Err(refuse(&format!("its extension says nothing; it must be {known}")));
        }
    }
    place(path, &bytes).map_err(|error| refuse(&error))
}

/// Of many people skins are rough.
fn detail(of: &Motion) -> glb::Detail {
    let is_person = |one: &&OneOfSeveral| !parts(&one.alone).is_empty();
    if of.several.iter().filter(is_person).count() > 4 { glb::Detail::Rough } else { glb::Detail::default() }
}

/// Writes beside the place and renames, so that nobody finds half a file.
fn place(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let part = path.with_file_name(format!(".{name}-{}.part", std::process::id()));
    let written = fs::write(&part, bytes).and_then(|()| fs::rename(&part, path));
    if written.is_err() {
        let _ = fs::remove_file(&part);
    }
    written
}
