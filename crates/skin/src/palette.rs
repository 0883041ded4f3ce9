//! The colours of a skin: a strip in which neighbours on a body are neighbours.
//!
//! A vertex has a place in the strip, and between vertices it goes evenly: where it passes from one colour's part into the next
//! one's, the border runs as a sharp line across triangles. So clothes need no seams in the mesh.

/// A colour, red, green, blue from 0 to 255 (sRGB).
pub type Colour = [u8; 3];

/// How many colours there are.
pub(crate) const COLOURS: usize = 9;

/// The colours of the strip: shoes, trousers, shirt, skin, hair, what is no person's, the white of an eye, iris, pupil. Colour `i` has the
/// part from `i / 9` to `(i + 1) / 9`.
pub const PALETTE: [Colour; COLOURS] = [
    [58, 56, 60],
    [74, 86, 108],
    [196, 200, 196],
    [206, 160, 132],
    [70, 54, 44],
    [168, 174, 184],
    [226, 222, 216],
    [88, 96, 92],
    [26, 24, 24],
];

const MACHINE: usize = 5;
pub(crate) const WHITE: usize = 6;
pub(crate) const IRIS: usize = 7;
pub(crate) const PUPIL: usize = 8;

/// The middle of machines' part.
pub(crate) const THING: f32 = within(MACHINE, 0.5);

/// The place of a share of a colour's part.
pub(crate) const fn within(colour: usize, share: f32) -> f32 {
    (colour as f32 + share) / COLOURS as f32
}

/// The colour at a place of the strip, from 0 to 1.
pub fn colour_at(place: f32) -> Colour {
    PALETTE[((place * COLOURS as f32) as usize).min(COLOURS - 1)]
}
