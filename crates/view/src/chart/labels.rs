//! Labels that keep off each other.

use super::Point;

/// A rectangle (px).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Its left side.
    pub left: f64,
    /// Its upper side.
    pub top: f64,
    /// Its right side.
    pub right: f64,
    /// Its lower side.
    pub bottom: f64,
}

impl Rect {
    /// The rectangle about a point that reaches so far to either side, and up and down.
    pub fn about((x, y): Point, half: Point) -> Self {
        Self { left: x - half.0, top: y - half.1, right: x + half.0, bottom: y + half.1 }
    }

    fn meets(&self, other: &Self) -> bool {
        self.left < other.right
            && other.left < self.right
            && self.top < other.bottom
            && other.top < self.bottom
    }

    fn holds(&self, other: &Self) -> bool {
        self.left <= other.left
            && self.top <= other.top
            && self.right >= other.right
            && self.bottom >= other.bottom
    }
}

/// What is taken of a picture.
#[derive(Clone, Debug)]
pub struct Labels {
    within: Rect,
    taken: Vec<Rect>,
}

impl Labels {
    /// Labels within a rectangle.
    pub fn within(within: Rect) -> Self {
        Self { within, taken: Vec::new() }
    }

    /// No label is to cover this.
    pub fn keep_off(&mut self, taken: Rect) {
        self.taken.push(taken);
    }

    /// The first of these places that is free; it is taken from now on. Nothing where none is.
    pub fn place(&mut self, places: impl IntoIterator<Item = Rect>) -> Option<Rect> {
        let is_free =
            |place: &Rect| self.within.holds(place) && !self.taken.iter().any(|taken| taken.meets(place));
        let place = places.into_iter().find(is_free)?;
        self.taken.push(place);
        Some(place)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_labels_meet_and_none_leaves() {
        let sheet = Rect { left: 0.0, top: 0.0, right: 100.0, bottom: 10.0 };
        let mut labels = Labels::within(sheet);
        labels.keep_off(Rect::about((5.0, 5.0), (5.0, 5.0)));
        let places = || (0..12).map(|i| Rect::about((10.0 * f64::from(i), 5.0), (9.0, 4.0)));
        let lefts: Vec<f64> = std::iter::from_fn(|| labels.place(places())).map(|place| place.left).collect();
        assert_eq!(lefts, [11.0, 31.0, 51.0, 71.0]);
    }
}
