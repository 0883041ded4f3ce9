#![doc = include_str!("../README.md")]

mod contour;
mod fair;
mod field;
mod human;
mod links;
mod mesh;
mod palette;
mod weights;

pub use mesh::{Influence, Part, Skin};
pub use palette::{Colour, PALETTE, colour_at};

use solaris_model::Figure;

/// How finely a skin is made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Detail {
    /// For a crowd: a person has some 4300 vertices.
    Rough,
    /// For a page: a person has some 8300 vertices.
    Coarse,
    /// For a film: a person has some 14 000 vertices.
    #[default]
    Fine,
}

/// The surface of a figure.
///
/// A person, as [`solaris_model::human()`] makes them, has one closed skin over all links, and two eyes in it, as long and as thick as the links' own shapes
/// are. Any other figure has the shapes of its links, each as a part of its own; a link without a shape has none.
///
/// ```
/// use solaris_skin::{Detail, skin};
///
/// let ann = solaris_model::human(1.65, 58.0)?;
/// let skin = skin(&ann, Detail::Coarse);
/// // Of the density of living tissue.
/// assert!((58.0 / skin.volume() / 1050.0 - 1.0).abs() < 0.05, "{} m³", skin.volume());
/// # Ok::<(), solaris_model::HumanError>(())
/// ```
pub fn skin(figure: &Figure, detail: Detail) -> Skin {
    person(figure, detail).unwrap_or_else(|| links::skin(figure))
}

/// The bones that a person's body has beyond the links, [`Skin::parts`] of its skin; of anything else none.
pub fn parts(figure: &Figure) -> Vec<Part> {
    human::parts(figure)
}

/// The closed skin of a person; none of a figure that lacks links of [`solaris_model::human()`]; what it has besides is as its shapes are.
pub fn person(figure: &Figure, detail: Detail) -> Option<Skin> {
    human::skin(figure, detail)
}
