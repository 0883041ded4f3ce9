//! The animations of a file, as curves in time.

use super::accessor::{Rows, rows};
use super::document::{At, Document};
use super::fault::GlbError;
use super::nodes::{Local, Nodes, turn};
use solaris_model::{UnitQuaternion, Vector3};

/// How a curve goes from key to key.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    Linear,
    Step,
    /// Each row is an in-tangent, a value, an out-tangent.
    Cubic,
}

/// The keys of one property of one node.
#[derive(Clone, Debug)]
pub(super) struct Curve {
    times: Vec<f64>,
    rows: Rows,
    way: Way,
}

/// What moves, node by node.
pub(super) struct Animation {
    pub(super) translations: Vec<Option<Curve>>,
    pub(super) rotations: Vec<Option<Curve>>,
    pub(super) scales: Vec<Option<Curve>>,
    /// Its own remarks, where it is one of ours.
    pub(super) rate: Option<f64>,
}

impl Animation {
    /// Animation `index` of a file.
    pub(super) fn of(document: &Document, nodes: &Nodes, index: usize) -> Result<Self, GlbError> {
        let at = document.one("animations", index)?;
        let count = nodes.nodes.len();
        let none = || vec![None; count];
        let mut animation = Self {
            translations: none(),
            rotations: none(),
            scales: none(),
            rate: at.get("extras").and_then(|extras| extras.get("rate")).and_then(|rate| rate.number().ok()),
        };
        let samplers = at.need("samplers")?.each()?;
        for channel in at.need("channels")?.each()? {
            let target = channel.need("target")?;
            // A target of an extension has no node of its own.
            let Some(node) = target.get("node") else { continue };
            let node = node.index("nodes", count)?;
            let path = target.need("path")?;
            let (into, width) = match path.text()? {
                "translation" => (&mut animation.translations, 3),
                "rotation" => (&mut animation.rotations, 4),
                "scale" => (&mut animation.scales, 3),
                // Weights of shapes move no bone, and extensions have paths of their own.
                _ => continue,
            };
            if nodes.nodes[node].is_matrix {
                return Err(target.need("node")?.wrong("a node that has no matrix"));
            }
            let sampler = &samplers[channel.need("sampler")?.index("samplers", samplers.len())?];
            into[node] = Some(Curve::of(document, sampler, width)?);
        }
        Ok(animation)
    }

    /// All times at which anything has a key (s).
    pub(super) fn curves(&self) -> impl Iterator<Item = &Curve> {
        self.translations.iter().chain(&self.rotations).chain(&self.scales).flatten()
    }

    /// Where a node is in its parent at a time (s), which is at `rest` where nothing moves it.
    pub(super) fn local(&self, node: usize, rest: &Local, time: f64) -> Local {
        let vector = |curve: &Option<Curve>| curve.as_ref().map(|curve| curve.vector(time));
        Local {
            translation: vector(&self.translations[node]).unwrap_or(rest.translation),
            rotation: self.rotations[node].as_ref().map_or(rest.rotation, |curve| curve.turn(time)),
            scale: vector(&self.scales[node]).unwrap_or(rest.scale),
        }
    }
}

/// What an animation is called: its own name, or `animation` and its number.
pub(super) fn name(at: &At, index: usize) -> String {
    let own = at.get("name").and_then(|name| name.text().ok()).filter(|name| !name.is_empty());
    own.map_or_else(|| format!("animation {index}"), str::to_owned)
}

impl Curve {
    fn of(document: &Document, sampler: &At, width: usize) -> Result<Self, GlbError> {
        let accessors = document.count("accessors");
        let way = match sampler.get("interpolation") {
            None => Way::Linear,
            Some(way) => match way.text()? {
                "LINEAR" => Way::Linear,
                "STEP" => Way::Step,
                "CUBICSPLINE" => Way::Cubic,
                _ => return Err(way.wrong("LINEAR, STEP or CUBICSPLINE")),
            },
        };
        let input = sampler.need("input")?;
        let times = rows(document, input.index("accessors", accessors)?)?;
        let output = sampler.need("output")?;
        let rows = rows(document, output.index("accessors", accessors)?)?;
        if times.width != 1 || times.values.is_empty() {
            return Err(input.wrong("an array of one or more times"));
        }
        if let Some(row) = (1..times.len()).find(|i| times.values[*i] <= times.values[i - 1]) {
            return Err(GlbError::Times { place: sampler.place.clone(), row, time: times.values[row] });
        }
        let each = if way == Way::Cubic { 3 } else { 1 };
        if rows.width != width || rows.len() != each * times.len() {
            return Err(output.wrong(&format!("an array of {} rows of {width}", each * times.len())));
        }
        let curve = Self { times: times.values, rows, way };
        let still = |i: &usize| width == 4 && turn(curve.key(*i)).is_none();
        match (0..curve.times.len()).find(still) {
            Some(_) => Err(output.wrong("an array of quaternions that have a length")),
            None => Ok(curve),
        }
    }

    pub(super) fn times(&self) -> &[f64] {
        &self.times
    }

    /// The value of a key.
    fn key<const N: usize>(&self, i: usize) -> [f64; N] {
        self.part(if self.way == Way::Cubic { 3 * i + 1 } else { i })
    }

    fn part<const N: usize>(&self, row: usize) -> [f64; N] {
        std::array::from_fn(|k| self.rows.row(row)[k])
    }

    /// The key before a time, and how far on to the next one; before the first and after the last there is no way on.
    fn place(&self, time: f64) -> (usize, f64) {
        let after = self.times.partition_point(|t| *t <= time);
        if after == 0 || after == self.times.len() {
            return (after.saturating_sub(1), 0.0);
        }
        let (from, to) = (self.times[after - 1], self.times[after]);
        (after - 1, (time - from) / (to - from))
    }

    fn vector(&self, time: f64) -> Vector3<f64> {
        let (i, s) = self.place(time);
        match self.way {
            _ if s <= 0.0 => self.key(i).into(),
            Way::Step => self.key(i).into(),
            Way::Linear => Vector3::from(self.key(i)).lerp(&self.key(i + 1).into(), s),
            Way::Cubic => self.cubic::<3>(i, s).into(),
        }
    }

    fn turn(&self, time: f64) -> UnitQuaternion<f64> {
        let (i, s) = self.place(time);
        let key = |i| turn(self.key(i)).unwrap_or_else(UnitQuaternion::identity);
        match self.way {
            _ if s <= 0.0 => key(i),
            Way::Step => key(i),
            Way::Linear => {
                let (from, to) = (key(i), key(i + 1));
                // The shorter way; turns that are opposite have none.
                from.try_slerp(&to, s, 1e-12).unwrap_or(from)
            }
            Way::Cubic => turn(self.cubic(i, s)).unwrap_or_else(|| key(i)),
        }
    }

    /// ```text
    /// p(s) = (2s³ − 3s² + 1)·v₀ + d·(s³ − 2s² + s)·b₀ + (−2s³ + 3s²)·v₁ + d·(s³ − s²)·a₁
    /// ```
    ///
    /// with `d` (s) the time between the keys, `v` values, `a` in-tangents and `b` out-tangents (1/s): glTF 2.0, appendix C.5.
    fn cubic<const N: usize>(&self, i: usize, s: f64) -> [f64; N] {
        let d = self.times[i + 1] - self.times[i];
        let (s2, s3) = (s * s, s * s * s);
        let (v0, b0) = (self.part::<N>(3 * i + 1), self.part::<N>(3 * i + 2));
        let (a1, v1) = (self.part::<N>(3 * i + 3), self.part::<N>(3 * i + 4));
        std::array::from_fn(|k| {
            (2.0 * s3 - 3.0 * s2 + 1.0) * v0[k]
                + d * (s3 - 2.0 * s2 + s) * b0[k]
                + (3.0 * s2 - 2.0 * s3) * v1[k]
                + d * (s3 - s2) * a1[k]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(way: Way, width: usize, values: &[f64]) -> Curve {
        Curve { times: vec![1.0, 3.0], rows: Rows { width, values: values.to_vec() }, way }
    }

    #[test]
    fn vectors_go_straight_in_steps_and_along_the_cubic_that_has_their_tangents() {
        let straight = curve(Way::Linear, 3, &[0.0, 0.0, 0.0, 2.0, 4.0, 6.0]);
        assert_eq!(straight.vector(2.0), Vector3::new(1.0, 2.0, 3.0));
        assert_eq!(straight.vector(-7.0), Vector3::zeros());
        assert_eq!(straight.vector(9.0), Vector3::new(2.0, 4.0, 6.0));
        let steps = curve(Way::Step, 3, &[0.0, 0.0, 0.0, 2.0, 4.0, 6.0]);
        assert_eq!(steps.vector(2.9), Vector3::zeros());
        // t³ − t from 1 to 3: values 0 and 24, slopes 2 and 26.
        let mut values = vec![0.0; 18];
        (values[3], values[6], values[9], values[12]) = (0.0, 2.0, 26.0, 24.0);
        let cubic = curve(Way::Cubic, 3, &values);
        for time in [1.0, 1.3, 2.0, 2.9, 3.0_f64] {
            assert!((cubic.vector(time).x - (time.powi(3) - time)).abs() < 1e-12);
        }
    }

    #[test]
    fn turns_go_the_shorter_way_evenly() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        // The second key with the other sign: the same turn by 90° about y.
        let turned = curve(Way::Linear, 4, &[0.0, 0.0, 0.0, 1.0, 0.0, -half, 0.0, -half]);
        let expected = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), std::f64::consts::FRAC_PI_8);
        assert!(turned.turn(1.5).angle_to(&expected) < 1e-12);
    }
}
