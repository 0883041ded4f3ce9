//! The ground of a still: a section of it from the side, a grid of it from elsewhere.

use super::{Lens, Still};
use crate::chart::{LETTERS, Picture, Point, SMALL, width};
use crate::world::World;
use glam::{DQuat, DVec3};
use solaris_model::{Motion, Relief};

/// Distance of the grid's lines (m), and how far it goes about the figure, in the figure's own size.
const CELL: f64 = 0.5;
const AROUND: f64 = 2.0;
/// Between the numbers of metres (px).
const APART: f64 = 4.0;

/// Heights of the ground along the page's z (m).
pub(super) struct Ground<'a> {
    relief: Option<&'a Relief>,
    level: f64,
}

impl<'a> Ground<'a> {
    /// The ground of a motion, if it has one.
    pub(super) fn of(motion: &'a Motion, world: &World) -> Option<Self> {
        let relief = motion.relief.as_ref().filter(|_| world.is_identity());
        let level = motion.info.ground.map(|ground| ground.height);
        (relief.is_some() || level.is_some()).then_some(Self { relief, level: level.unwrap_or_default() })
    }

    fn height(&self, z: f64) -> f64 {
        self.relief.map_or(self.level, |relief| relief.height(z))
    }

    /// The lowest that it is within `reach` of a place (m).
    pub(super) fn lowest(&self, z: f64, reach: f64) -> f64 {
        self.relief.map_or(self.level, |relief| relief.lowest_near(z, reach))
    }

    /// Its corners from one place to another, with both ends: places along z and heights (m).
    fn profile(&self, from: f64, to: f64) -> Vec<[f64; 2]> {
        let corners = self.relief.map(Relief::points).unwrap_or_default();
        let inside = corners.iter().copied().filter(|point| point[0] > from && point[0] < to);
        [[from, self.height(from)]].into_iter().chain(inside).chain([[to, self.height(to)]]).collect()
    }

    /// From the side: cut open down to `bottom` (px), with a mark and a number at each metre.
    pub(super) fn section(&self, picture: &mut Picture, lens: &Lens, reach: f64, bottom: f64) {
        let (from, to) = (lens.from.0 - reach, lens.from.0 + reach);
        let at = |z: f64, y: f64| lens.point(DVec3::new(z, y, 0.0));
        let line: Vec<Point> = self.profile(from, to).iter().map(|[z, y]| at(*z, *y)).collect();
        let [(first, _), .., (last, _)] = line[..] else { return };
        let area: Vec<Point> = line.iter().copied().chain([(last, bottom), (first, bottom)]).collect();
        picture.line("floor", &area);
        picture.line("zero", &line);
        let label = |metre: i64| format!("{metre} m").replace('-', "−");
        let (nearest, farthest) = (from.ceil() as i64, to.floor() as i64);
        let widest = width(&label(nearest), LETTERS).max(width(&label(farthest), LETTERS));
        // As many numbers as there is room for.
        let steps = (0..9).flat_map(|power| [1, 2, 5].map(|first| first * 10_i64.pow(power)));
        let every = steps.into_iter().find(|step| *step as f64 * lens.scale > widest + APART).unwrap_or(1);
        for metre in nearest..=farthest {
            let (x, y) = at(metre as f64, self.height(metre as f64));
            picture.line("zero", &[(x, y), (x, y + 4.0)]);
            let text = label(metre);
            let half = 0.5 * width(&text, LETTERS);
            // Below the lowest step that it reaches.
            let line = at(0.0, self.lowest(metre as f64, half / lens.scale)).1 + 5.0 + SMALL;
            if metre % every == 0 && x - half > first && x + half < last && line < bottom {
                picture.text("small middle", (x, line), &text);
            }
        }
    }

    /// From elsewhere: lines each half metre, about the figure.
    pub(super) fn grid(&self, picture: &mut Picture, lens: &Lens, eye: DQuat, still: &Still) {
        let middle = eye.inverse() * still.bounds.low.midpoint(still.bounds.high);
        let reach = AROUND * still.bounds.edges().max_element();
        let cells = |at: f64| (((at - reach) / CELL).floor() as i64)..=(((at + reach) / CELL).ceil() as i64);
        let at = |x: f64, y: f64, z: f64| lens.point(eye * DVec3::new(x, y, z));
        let ends = (middle.z - reach, middle.z + reach);
        let profile = self.profile(ends.0, ends.1);
        for x in cells(middle.x) {
            let line: Vec<Point> = profile.iter().map(|[z, y]| at(CELL * x as f64, *y, *z)).collect();
            picture.line("grid", &line);
        }
        let sides = [middle.x - reach, middle.x + reach];
        let even = cells(middle.z).map(|z| [CELL * z as f64, self.height(CELL * z as f64)]);
        // Edges of steps, too.
        let corners = profile.iter().copied().filter(|point| point[0] > ends.0 && point[0] < ends.1);
        for [z, y] in even.chain(corners) {
            picture.line("grid", &sides.map(|x| at(x, y, z)));
        }
    }
}
