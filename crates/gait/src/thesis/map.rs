//! A map of two parameters: where postures exist, and which inequality forbids them elsewhere.

use crate::error::MapError;
use crate::thesis::determinants::{Condition, KeyParameter};

/// An inequality of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MapCondition {
    /// Its short name.
    pub name: &'static str,
    /// The inequality.
    pub text: &'static str,
}

/// A piece of the boundary between what can and what cannot be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Its two ends (x, y), in the parameters' units, to 1e-12 of their ranges.
    pub ends: [[f64; 2]; 2],
    /// Index of the inequality that fails beyond it.
    pub condition: usize,
}

/// Where postures exist, over two parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct FeasibleMap {
    /// Parameter across and up.
    pub axes: [KeyParameter; 2],
    /// What is looked at of them: least and greatest, in their units.
    pub spans: [(f64, f64); 2],
    /// Number of places across and up.
    pub places: [usize; 2],
    /// The inequalities that forbid anything here.
    pub conditions: Vec<MapCondition>,
    /// By place, row by row from below: the index of the first inequality that fails, or none where all hold.
    pub fails: Vec<Option<usize>>,
    /// The boundary, in pieces within one square of four places each.
    pub edges: Vec<Edge>,
}

/// Places across or up.
const PLACES: (usize, usize) = (2, 2000);

impl FeasibleMap {
    /// The map of two parameters (indices in `parameters`), the others at `values`, all in their units. `conditions` is asked
    /// with all values; what fails first there counts.
    ///
    /// # Errors
    ///
    /// Axes that are no index of a parameter, another number of values than there are parameters, numbers of places outside 2 to
    /// 2000, spans that are none.
    pub fn new(
        parameters: &[KeyParameter],
        values: &[f64],
        [across, up]: [usize; 2],
        spans: [(f64, f64); 2],
        places: [usize; 2],
        conditions: impl Fn(&[f64]) -> Vec<Condition>,
    ) -> Result<Self, MapError> {
        let (found, expected) = (values.len(), parameters.len());
        if found != expected {
            return Err(MapError::Values { found, expected });
        }
        if let Some((axis, index)) =
            [("across", across), ("up", up)].into_iter().find(|(_, i)| *i >= expected)
        {
            return Err(MapError::Axis { axis, index, parameters: expected });
        }
        for (axis, (lower, upper)) in [across, up].into_iter().zip(spans) {
            if !(lower.is_finite() && upper.is_finite() && lower < upper) {
                return Err(MapError::Span { parameter: parameters[axis].name, lower, upper });
            }
        }
        if let Some(&places) = places.iter().find(|places| !(PLACES.0..=PLACES.1).contains(places)) {
            return Err(MapError::Places { places, least: PLACES.0, most: PLACES.1 });
        }
        let axes = [parameters[across], parameters[up]];
        let mut map =
            Self { axes, spans, places, conditions: Vec::new(), fails: Vec::new(), edges: Vec::new() };
        let mut trial = values.to_vec();
        let mut first_failing = |at: [f64; 2]| {
            trial[across] = at[0];
            trial[up] = at[1];
            let failing = conditions(&trial).into_iter().find(|condition| !condition.holds())?;
            Some(MapCondition { name: failing.name, text: failing.text })
        };
        for row in 0..places[1] {
            for column in 0..places[0] {
                let failing = first_failing(map.at(column, row));
                let failing = failing.map(|condition| map.index(condition));
                map.fails.push(failing);
            }
        }
        map.trace(&mut first_failing);
        Ok(map)
    }

    /// The parameters at a place.
    pub fn at(&self, column: usize, row: usize) -> [f64; 2] {
        let along = |(lower, upper): (f64, f64), k: usize, of: usize| {
            lower + (upper - lower) * k as f64 / (of - 1) as f64
        };
        [along(self.spans[0], column, self.places[0]), along(self.spans[1], row, self.places[1])]
    }

    /// Part of the places at which all holds.
    pub fn feasible(&self) -> f64 {
        self.fails.iter().filter(|fails| fails.is_none()).count() as f64 / self.fails.len() as f64
    }

    /// Whether a point lies where all holds, by the boundary alone: the places decide on which side its square's corner is, the
    /// edges between them how often the way there crosses. None outside of the map.
    pub fn contains(&self, point: [f64; 2]) -> Option<bool> {
        let cell = |axis: usize| {
            let (lower, upper) = self.spans[axis];
            let last = self.places[axis] - 1;
            let k = (point[axis] - lower) / (upper - lower) * last as f64;
            (0.0..=last as f64).contains(&k).then(|| (k as usize).min(last - 1))
        };
        let (column, row) = (cell(0)?, cell(1)?);
        let corner = self.at(column, row);
        let inside = self.fails[row * self.places[0] + column].is_none();
        let far = self.at(column + 1, row + 1);
        let within = |p: &[f64; 2]| {
            (0..2).all(|axis| {
                let slack = 1e-9 * (far[axis] - corner[axis]);
                (corner[axis] - slack..=far[axis] + slack).contains(&p[axis])
            })
        };
        let own = self.edges.iter().filter(|edge| edge.ends.iter().all(within));
        let crossings = own.filter(|edge| crosses(corner, point, edge.ends)).count();
        Some(inside == (crossings % 2 == 0))
    }

    fn index(&mut self, condition: MapCondition) -> usize {
        // A name may be that of several inequalities.
        let known = self.conditions.iter().position(|known| *known == condition);
        known.unwrap_or_else(|| {
            self.conditions.push(condition);
            self.conditions.len() - 1
        })
    }

    /// Finds the boundary in every square of four places.
    fn trace(&mut self, first_failing: &mut impl FnMut([f64; 2]) -> Option<MapCondition>) {
        let [columns, rows] = self.places;
        // Crossings along the lines of places, each found once: across, then up.
        let mut crossings = [vec![None; columns * rows], vec![None; columns * rows]];
        for row in 0..rows {
            for column in 0..columns {
                let here = row * columns + column;
                for (axis, next) in [
                    (0, (column + 1 < columns).then_some(here + 1)),
                    (1, (row + 1 < rows).then_some(here + columns)),
                ] {
                    let Some(next) = next else { continue };
                    if self.fails[here].is_none() != self.fails[next].is_none() {
                        let to = if axis == 0 { self.at(column + 1, row) } else { self.at(column, row + 1) };
                        let ends = (self.at(column, row), to);
                        crossings[axis][here] =
                            Some(self.crossing(ends, self.fails[here].is_none(), first_failing));
                    }
                }
            }
        }
        for row in 0..rows - 1 {
            for column in 0..columns - 1 {
                let here = row * columns + column;
                // Below, right, above, left.
                let around = [
                    crossings[0][here],
                    crossings[1][here + 1],
                    crossings[0][here + columns],
                    crossings[1][here],
                ];
                let met: Vec<([f64; 2], usize)> = around.into_iter().flatten().collect();
                match met[..] {
                    [a, b] => self.edges.push(Edge { ends: [a.0, b.0], condition: a.1 }),
                    // A saddle: which pairs belong together the middle says.
                    [below, right, above, left] => {
                        let [low, high] = [self.at(column, row), self.at(column + 1, row + 1)];
                        let middle = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
                        let joined = first_failing(middle).is_none() == self.fails[here].is_none();
                        let pairs = if joined {
                            [(below, right), (above, left)]
                        } else {
                            [(below, left), (above, right)]
                        };
                        self.edges.extend(pairs.map(|(a, b)| Edge { ends: [a.0, b.0], condition: a.1 }));
                    }
                    _ => {}
                }
            }
        }
    }

    /// Where feasibility changes between two points, by bisection, and what fails beyond.
    fn crossing(
        &mut self,
        (mut a, mut b): ([f64; 2], [f64; 2]),
        holds_at_a: bool,
        first_failing: &mut impl FnMut([f64; 2]) -> Option<MapCondition>,
    ) -> ([f64; 2], usize) {
        let mut failing = None;
        for _ in 0..44 {
            let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
            let fails = first_failing(middle);
            if fails.is_none() == holds_at_a {
                a = middle;
            } else {
                b = middle;
            }
            failing = fails.or(failing);
        }
        let beyond = if holds_at_a { b } else { a };
        let condition = first_failing(beyond).or(failing);
        let index = condition.map_or(0, |condition| self.index(condition));
        ([0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])], index)
    }
}

/// Whether the way from `a` to `b` crosses a piece.
fn crosses(a: [f64; 2], b: [f64; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let side = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]) > 0.0
    };
    side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    const PARAMETERS: [KeyParameter; 2] = [
        KeyParameter { name: "x", symbol: "x", help: "", unit: " m", range: (-2.0, 2.0) },
        KeyParameter { name: "y", symbol: "y", help: "", unit: " m", range: (-2.0, 2.0) },
    ];

    /// A disc without a half-plane.
    fn conditions(values: &[f64]) -> Vec<Condition> {
        let [x, y] = [values[0], values[1]];
        let condition = |name, sides| Condition { name, text: name, sides, symbol: "" };
        vec![condition("disc", [x * x + y * y, 1.0]), condition("half", [y, 0.3 + 0.1 * x])]
    }

    fn map(places: usize) -> FeasibleMap {
        let spans = [(-1.3, 1.4), (-1.2, 1.1)];
        FeasibleMap::new(&PARAMETERS, &[0.0, 0.0], [0, 1], spans, [places; 2], conditions).expect("a map")
    }

    #[test]
    fn the_boundary_lies_on_the_inequalities() {
        let map = map(80);
        assert!(map.edges.len() > 100);
        for edge in &map.edges {
            for [x, y] in edge.ends {
                let off = [(x.hypot(y) - 1.0).abs(), (y - 0.3 - 0.1 * x).abs()];
                assert!(off[0].min(off[1]) < 1e-10, "{x} {y}");
                assert!(off[edge.condition] < 0.1, "{edge:?}");
            }
        }
    }

    #[test]
    fn points_lie_where_the_inequalities_say() {
        let map = map(200);
        let mut state = 1_u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for _ in 0..5_000 {
            let point = [-1.3 + 2.7 * random(), -1.2 + 2.3 * random()];
            // A chord of a square is off the circle by its square over eight radii: 3e-5.
            let near = (point[0].hypot(point[1]) - 1.0).abs() < 5e-5;
            let holds = conditions(&point).iter().all(Condition::holds);
            assert!(near || map.contains(point) == Some(holds), "{point:?}");
        }
        assert_eq!(map.contains([5.0, 0.0]), None);
    }

    #[test]
    fn inequalities_of_one_name_are_told_apart() {
        let same = |values: &[f64]| {
            let condition = |text, sides| Condition { name: "domain", text, sides, symbol: "" };
            vec![condition("x < 1", [values[0], 1.0]), condition("y < 1", [values[1], 1.0])]
        };
        let spans = [(0.0, 2.0), (0.0, 2.0)];
        let map = FeasibleMap::new(&PARAMETERS, &[0.0; 2], [0, 1], spans, [10; 2], same).expect("a map");
        let mut texts: Vec<&str> = map.conditions.iter().map(|condition| condition.text).collect();
        texts.sort_unstable();
        assert_eq!(texts, ["x < 1", "y < 1"]);
        let text = |column: usize, row: usize| map.fails[row * 10 + column].map(|i| map.conditions[i].text);
        assert_eq!((text(0, 0), text(9, 0), text(0, 9)), (None, Some("x < 1"), Some("y < 1")));
    }

    #[test]
    fn axes_and_values_that_are_none_are_refused() {
        let refused = |values: &[f64], axes| {
            let map = FeasibleMap::new(&PARAMETERS, values, axes, [(0.0, 1.0); 2], [9; 2], conditions);
            map.expect_err("there is no such axis").to_string()
        };
        assert_eq!(refused(&[0.0; 2], [2, 0]), "axis across of a map is parameter 2; it must be 0 to 1");
        assert_eq!(refused(&[0.0; 2], [0, 3]), "axis up of a map is parameter 3; it must be 0 to 1");
        assert_eq!(refused(&[0.0], [0, 1]), "1 values for the 2 parameters of a map");
    }

    #[test]
    fn bad_spans_and_places_are_refused() {
        let new = |spans, places| FeasibleMap::new(&PARAMETERS, &[0.0; 2], [0, 1], spans, places, conditions);
        assert!(new([(0.0, f64::NAN), (0.0, 1.0)], [9, 9]).is_err());
        assert!(new([(1.0, 1.0), (0.0, 1.0)], [9, 9]).is_err());
        assert!(new([(0.0, 1.0), (0.0, 1.0)], [1, 9]).is_err());
        assert!(new([(0.0, 1.0), (0.0, 1.0)], [9, 2001]).is_err());
    }
}
