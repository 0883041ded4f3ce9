//! Proportions of children beside an adult's: [`crate::Human::age`].

use super::segments::{
    ABDOMEN, FOOT, HEAD, HIP, LUMBAR, NECK, REFERENCE_HEIGHT, SHANK, STACK, THIGH, THORAX,
};

/// From when proportions are known, and from when they are an adult's (years).
pub(super) const AGES: (f64, f64) = (6.0, 18.0);

/// Lengths as fractions of the height at 6, 8, 10, 12, 14, 16 and 18 years: medians over the children of Snyder et al. (1977) within a year of the age, at 18 over
/// those of 17 and older.
///
/// Head from chin to vertex; acromion to radiale; radiale to stylion; hand; trochanter to tibiale; tibiale to sphyrion; foot.
#[rustfmt::skip]
const LENGTHS: [(&str, [f64; 7]); 7] = [
    ("head",      [0.1601, 0.1488, 0.1413, 0.1348, 0.1296, 0.1257, 0.1250]),
    ("upper_arm", [0.1787, 0.1824, 0.1839, 0.1872, 0.1879, 0.1879, 0.1872]),
    ("forearm",   [0.1456, 0.1455, 0.1466, 0.1478, 0.1499, 0.1492, 0.1499]),
    ("hand",      [0.1104, 0.1087, 0.1088, 0.1092, 0.1088, 0.1071, 0.1070]),
    ("thigh",     [0.2361, 0.2412, 0.2489, 0.2514, 0.2533, 0.2484, 0.2466]),
    ("shank",     [0.2098, 0.2177, 0.2223, 0.2268, 0.2245, 0.2213, 0.2214]),
    ("foot",      [0.1562, 0.1558, 0.1564, 0.1560, 0.1538, 0.1488, 0.1484]),
];

/// Shares of the mass (%) at 6, 12 and 18 years, of one side where there are two: Jensen (1989, 1986, 1989).
#[rustfmt::skip]
const MASSES: [(&str, [f64; 3]); 8] = [
    ("head",      [18.2, 10.1,  7.0]),
    ("trunk",     [43.0, 41.7, 44.6]),
    ("upper_arm", [ 2.4,  3.2,  3.6]),
    ("forearm",   [ 1.3,  1.7,  1.9]),
    ("hand",      [ 0.8,  0.9,  0.9]),
    ("thigh",     [ 8.5, 11.0, 11.4]),
    ("shank",     [ 4.6,  5.3,  4.8]),
    ("foot",      [ 1.9,  2.1,  1.7]),
];

/// What lengths and masses of segments are multiplied by; one for an adult.
pub(super) struct Proportions {
    age: f64,
    /// Of abdomen, thorax and neck: what head and legs leave of the height.
    trunk: f64,
}

impl Proportions {
    /// Proportions at this age (years, from [`AGES`] on).
    pub(super) fn at(age: f64) -> Self {
        let mut found = Self { age, trunk: 1.0 };
        if age < AGES.1 {
            let of = |name: &str| found.length(name);
            let legs = HIP + of("thigh") * THIGH + of("shank") * SHANK + of("foot") * FOOT;
            let left = (REFERENCE_HEIGHT - legs) / STACK - LUMBAR - of("head") * HEAD;
            found.trunk = left / (ABDOMEN + THORAX + NECK);
        }
        found
    }

    /// Of a segment's length, by its name without the side.
    pub(super) fn length(&self, segment: &str) -> f64 {
        match segment {
            "abdomen" | "thorax" | "neck" => self.trunk,
            "toes" => self.relative(&LENGTHS, "foot"),
            _ => self.relative(&LENGTHS, segment),
        }
    }

    /// Of a segment's share of the mass, by its name without the side.
    pub(super) fn mass(&self, segment: &str) -> f64 {
        let group = match segment {
            "pelvis" | "abdomen" | "thorax" | "clavicle" => "trunk",
            "neck" => "head",
            "toes" => "foot",
            _ => segment,
        };
        self.relative(&MASSES, group)
    }

    /// The table's number at the age over that of an adult, between the rows along straight lines; one for what it has not.
    fn relative<const N: usize>(&self, table: &[(&str, [f64; N])], name: &str) -> f64 {
        let row = table.iter().find(|(known, _)| *known == name);
        let Some((_, values)) = row.filter(|_| self.age < AGES.1) else { return 1.0 };
        #[allow(clippy::cast_precision_loss, reason = "a few rows")]
        let place = (self.age - AGES.0) / (AGES.1 - AGES.0) * (N - 1) as f64;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to below N - 1")]
        let before = place.floor() as usize;
        let between = place - place.floor();
        (values[before] * (1.0 - between) + values[before + 1] * between) / values[N - 1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_two_rows_it_is_between() {
        let nine = Proportions::at(9.0);
        assert!((nine.length("head") - f64::midpoint(0.1488, 0.1413) / 0.1250).abs() < 1e-15);
        assert!((nine.mass("neck") - f64::midpoint(18.2, 10.1) / 7.0).abs() < 1e-15);
        let six = Proportions::at(6.0);
        assert!((six.length("toes") - 0.1562 / 0.1484).abs() < 1e-15);
        assert!((0.9..1.1).contains(&six.trunk), "{}", six.trunk);
    }
}
