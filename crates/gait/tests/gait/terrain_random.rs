//! Walks over ground by chance, within limits: mixtures of slopes, kerbs and flats.

use crate::terrain::{judge_loaded, request};
use solaris_gait::{Extent, WalkGround, WalkRequest, walk};
use solaris_model::{Relief, human};

/// How many, and how many of them must be walked over.
const PROFILES: u32 = 100;
const LEAST: usize = 98;

/// Chance that repeats itself (the constants are Knuth's).
struct Chance(u64);

impl Chance {
    /// Of a number and where it counts from; the first draws of neighbours are alike.
    fn of(number: u32, from: u64) -> Self {
        let mut chance = Self(u64::from(number) + from);
        for _ in 0..4 {
            chance.between(0.0, 1.0);
        }
        chance
    }

    /// Between two numbers.
    fn between(&mut self, from: f64, to: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

/// From 1.2 m on slopes of up to 9°, kerbs of 2 to 8 cm and flats, one after the other.
fn profile(number: u32) -> Relief {
    let mut chance = Chance::of(number, 1);
    let (mut z, mut height) = (1.2 + chance.between(0.0, 0.6), 0.0);
    let mut points = vec![[z, height]];
    while z < 8.0 {
        match chance.between(0.0, 3.0) as u32 {
            0 => {
                let length = chance.between(1.0, 2.5);
                height += length * chance.between(-9.0, 9.0).to_radians().tan();
                z += length;
            }
            1 => {
                let up = if chance.between(-1.0, 1.0) < 0.0 { -1.0 } else { 1.0 };
                height += up * chance.between(0.02, 0.08);
                points.push([z, height]);
                z += chance.between(0.7, 1.5);
            }
            _ => z += chance.between(0.5, 1.5),
        }
        points.push([z, height]);
    }
    Relief::new(points).expect("a relief")
}

#[test]
fn ground_by_chance_is_walked_over_or_refused_by_what_is_wrong() {
    let ann = human(1.75, 73.0).expect("a person");
    let mut walked = 0;
    for number in 0..PROFILES {
        let ask = request(WalkGround::Relief(profile(number)), 95.0);
        match walk(&ann, &ask) {
            Ok(_) => {
                walked += 1;
                judge_loaded(&format!("profile {number}"), &ann, &ask, 160.0);
            }
            Err(error) => {
                println!("profile {number}: {error}");
                assert!(error.to_string().contains("step"), "{error}");
            }
        }
    }
    println!("{walked} of {PROFILES}");
    assert!(walked >= LEAST, "{walked} of {PROFILES} were walked over");
}

/// A kerb, a pavement that is left again, two kerbs in a row, or a flight of two to five uneven stairs: edges of 5 to 20 cm, up or down.
fn edges(number: u32) -> Relief {
    let mut chance = Chance::of(number, 901);
    let up = if chance.between(-1.0, 1.0) < 0.0 { -1.0 } else { 1.0 };
    let (mut z, mut height) = (chance.between(1.0, 4.0), up * chance.between(0.06, 0.19));
    let first = height;
    let mut points = vec![[z, 0.0], [z, height]];
    let mut next = |z: f64, to: f64| {
        points.extend([[z, height], [z, to]]);
        height = to;
    };
    match number % 4 {
        1 => next(z + chance.between(0.9, 4.0), 0.0),
        2 => next(z + chance.between(1.2, 3.0), first + up * chance.between(0.06, 0.18)),
        3 => {
            let tread = chance.between(0.27, 0.33);
            for stair in 2..3 + chance.between(0.0, 4.0) as u32 {
                z += tread + chance.between(-0.006, 0.006);
                next(z, f64::from(stair) * first + up * chance.between(-0.004, 0.004));
            }
        }
        _ => {}
    }
    Relief::new(points).expect("a relief")
}

#[test]
fn kerbs_pavements_and_flights_are_climbed_by_anybody_at_any_pace() {
    let mut walked = 0;
    for number in 0..PROFILES {
        let mut chance = Chance::of(number, 77);
        let height = chance.between(1.5, 1.95);
        let person = human(height, 23.8 * height * height).expect("a person");
        let ask = WalkRequest {
            extent: Extent::Steps(16),
            ..request(WalkGround::Relief(edges(number)), chance.between(70.0, 112.0).round())
        };
        match walk(&person, &ask) {
            Ok(_) => {
                walked += 1;
                judge_loaded(&format!("edges {number}"), &person, &ask, 165.0);
            }
            Err(error) => println!("edges {number}, {height:.2} m, {:?}: {error}", ask.ground),
        }
    }
    println!("{walked} of {PROFILES}");
    assert!(walked >= 95, "{walked} of {PROFILES} were climbed");
}

/// Pavements and roads fall to their gutters: a kerb of 6 to 16 cm, up or down, between ground of up to 3° either way.
#[test]
fn kerbs_between_ground_that_falls_are_climbed() {
    let (all, mut walked) = (40_u32, 0);
    for number in 0..all {
        let mut chance = Chance::of(number, 1301);
        let mut slope = || chance.between(-3.0, 3.0).to_radians().tan();
        let (before, after) = (slope(), slope());
        let at = chance.between(1.6, 4.0);
        let up = if chance.between(-1.0, 1.0) < 0.0 { -1.0 } else { 1.0 };
        let below = (at - 1.0) * before;
        let above = below + up * chance.between(0.06, 0.16);
        let points = vec![[1.0, 0.0], [at, below], [at, above], [at + 4.0, above + 4.0 * after]];
        let height = chance.between(1.5, 1.95);
        let person = human(height, 23.8 * height * height).expect("a person");
        let ask = WalkRequest {
            extent: Extent::Steps(12),
            ..request(
                WalkGround::Relief(Relief::new(points).expect("a relief")),
                chance.between(75.0, 110.0).round(),
            )
        };
        match walk(&person, &ask) {
            Ok(_) => {
                walked += 1;
                judge_loaded(&format!("kerb {number}"), &person, &ask, 165.0);
            }
            Err(error) => println!("kerb {number}, {height:.2} m, {:?}: {error}", ask.ground),
        }
    }
    println!("{walked} of {all}");
    assert!(walked >= 34, "{walked} of {all} were climbed");
}
