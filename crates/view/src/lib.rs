#![doc = include_str!("../README.md")]

mod bands;
mod body;
mod camera;
pub mod chart;
mod coordinates;
mod curves;
mod cycles;
mod data;
pub mod denavit_hartenberg;
mod draw;
mod efforts;
mod error;
mod film;
mod forces;
mod frames;
mod html;
mod live;
mod members;
mod multiples;
mod pack;
mod postures;
pub mod precision;
pub mod profile;
mod regions;
mod skin;
mod world;

pub use coordinates::coordinates;
pub use cycles::{CycleCurve, cycles};
pub use efforts::{Effort, efforts};
pub use error::ViewError;
pub use film::{FilmOptions, Seen, film};
pub use forces::{FootForces, forces};
pub use frames::FRAME_RATE;
pub use live::Live;
pub use postures::{Room, Stick, StickLine, StickPart, postures};
pub use regions::{Regions, regions};

use solaris_model::{Figure, Motion, Vector3};

/// What a page says beside the motion itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PageOptions {
    /// Title of the page, plain text; the figure's name where it is empty.
    pub title: String,
    /// Rows of the summary table, which is left out where there are none.
    pub table: Vec<TableRow>,
    /// Lines that are drawn on links without a shape of their own, such as soles.
    pub lines: Vec<LinkLine>,
    /// The parts of a figure that is several: those that are people have skins of their own, unless they are more than a dozen.
    pub people: Vec<PagePerson>,
    /// Curves beside those of the ground's forces, such as residuals.
    pub curves: Vec<PageCurve>,
    /// Which way is forward (world axes), where it is not z, or x where z is up.
    pub forward: Option<Vector3<f64>>,
    /// Half widths of bands around the coordinates `q` (rad, m): `nv` a sample of the motion, in the order of the figure's
    /// layout of `v`, 0 where nothing is known.
    pub angle_bands: Option<Vec<f64>>,
    /// Half widths of bands around `tau` (N m, N), in the same order.
    pub moment_bands: Option<Vec<f64>>,
    /// What the bands are, plain text: "two standard errors". Nothing is said of them where it is empty.
    pub bands: String,
}

/// One of the figures that a figure is made of.
#[derive(Clone, Debug, PartialEq)]
pub struct PagePerson {
    /// The first of its links in the whole.
    pub first: usize,
    /// The figure alone.
    pub figure: Figure,
}

/// A line that goes with a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkLine {
    /// The link's index in the figure.
    pub link: usize,
    /// Its ends (m), in the link's frame.
    pub ends: [Vector3<f64>; 2],
}

/// A quantity over the whole motion.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PageCurve {
    /// What it is: "Residual force".
    pub label: String,
    /// In what: "N".
    pub unit: String,
    /// One value a sample of the motion.
    pub values: Vec<f64>,
}

/// A row of the summary table; plain text, ready to be read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct TableRow {
    /// What it is: "Step length".
    pub label: String,
    /// How much: "0.71".
    pub value: String,
    /// In what: "m"; may be empty.
    pub unit: String,
    /// A remark: "0.70 asked"; may be empty.
    pub note: String,
}

impl TableRow {
    /// A row of these four texts.
    pub fn new(
        label: impl Into<String>,
        value: impl Into<String>,
        unit: impl Into<String>,
        note: impl Into<String>,
    ) -> Self {
        Self { label: label.into(), value: value.into(), unit: unit.into(), note: note.into() }
    }
}

/// A page that shows one picture (an SVG's text).
pub fn picture_page(title: &str, svg: &str) -> String {
    let title = html::escape(title);
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>{title}</title>\
         <meta name=\"viewport\" content=\"width=device-width\">\
         <style>:root{{color-scheme:light dark}}body{{margin:16px auto;max-width:840px}}body>svg{{width:100%;height:auto}}</style></head>\n<body>\n{svg}</body>\n</html>\n"
    )
}

/// What a page is shown by: the bundle of `web/src`.
#[derive(Clone, Copy, Debug)]
pub struct Viewer<'a> {
    /// Its script, without anything that ends an element.
    pub script: &'a str,
    /// Its style.
    pub style: &'a str,
}

#[cfg(feature = "assets")]
impl Viewer<'static> {
    /// The one that stands in this crate.
    pub const OWN: Self =
        Self { script: include_str!("../assets/viewer.js"), style: include_str!("../assets/viewer.css") };
}

/// The page that shows `motion` of `figure`: a whole HTML file as text.
///
/// The same figure, motion and options give the same text, byte for byte. A walk of 9 s takes about 1.3 MB, of which
/// 0.7 MB are the page itself and 0.25 MB a person's skin; a further minute adds about 2.5 MB.
///
/// # Errors
///
/// [`ViewError`]: a motion of another figure, one without samples, contacts that do not fit to the motion or to the
/// figure, a line of a link that is none, a curve or a band of another length, a negative half width, numbers that are not
/// finite.
#[cfg(feature = "assets")]
pub fn page(figure: &Figure, motion: &Motion, options: &PageOptions) -> Result<String, ViewError> {
    page_by(&Viewer::OWN, figure, motion, options)
}

/// The same page by a viewer that the caller has already, as a page has that writes pages.
///
/// # Errors
///
/// As those of [`page_data`].
pub fn page_by(
    viewer: &Viewer<'_>,
    figure: &Figure,
    motion: &Motion,
    options: &PageOptions,
) -> Result<String, ViewError> {
    let data = data::collect(figure, motion, options)?;
    Ok(html::render(&data, options, viewer))
}

/// The skin of a person as [`page_data`] has it under `body`, as JSON; none of any other figure. It is most of the work of a short motion:
/// whoever shows many motions of one person makes it once, and takes [`page_data_without_skin`].
pub fn page_skin(figure: &Figure) -> Option<String> {
    body::body(figure).map(|body| body.to_json())
}

/// The skins of several people as [`page_data`] has them under `bodies`, as JSON; of more than a dozen none.
pub fn page_skins(people: &[PagePerson]) -> String {
    serde_json::to_string(&body::bodies(people))
        .expect("plain data of finite numbers and text is always JSON")
}

/// [`page_data`] without the skin of a person, so that links are drawn by their shapes.
///
/// # Errors
///
/// As those of [`page_data`].
pub fn page_data_without_skin(
    figure: &Figure,
    motion: &Motion,
    options: &PageOptions,
) -> Result<String, ViewError> {
    Ok(data::collect_bare(figure, motion, options)?.to_json())
}

/// What a page knows of a motion, as the JSON that stands in it (see *What the page holds*).
///
/// # Errors
///
/// [`ViewError`]: what `page` refuses.
pub fn page_data(figure: &Figure, motion: &Motion, options: &PageOptions) -> Result<String, ViewError> {
    Ok(data::collect(figure, motion, options)?.to_json())
}
