//! The colours of a skin: a strip in which neighbours on a body are neighbours.
//!
//! A vertex has a place in the strip, and between vertices it goes evenly: where it passes from one colour's part into the next
//! one's, the border runs as a sharp line across triangles. So clothes need no seams in the mesh.

/// A colour, red, green, blue from 0 to 255 (sRGB).
pub type Colour = [u8; 3];

/// The colours of the strip: shoes, trousers, shirt, skin, hair, and what is no person's. Colour `i` has the part from `i / 6` to `(i + 1) / 6`.
pub const PALETTE: [Colour; 6] =
    [[58, 56, 60], [74, 86, 108], [196, 200, 196], [206, 160, 132], [70, 54, 44], [168, 174, 184]];

/// The middle of the last colour's part.
pub(crate) const THING: f32 = 5.5 / 6.0;

/// The colour at a place of the strip, from 0 to 1.
pub fn colour_at(place: f32) -> Colour {
    PALETTE[((place * 6.0) as usize).min(5)]
}
