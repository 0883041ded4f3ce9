//! Hands: five digits apart, as long and as broad as people's; what goes with their bones.

use nalgebra::{Point3, Vector3};
use solaris_model::{Figure, Human, human};
use solaris_skin::{Detail, Influence, Part, Skin, skin};
use std::collections::{BTreeMap, HashMap};

fn part<'a>(skin: &'a Skin, name: &str) -> &'a Part {
    skin.parts.iter().find(|part| part.name == name).unwrap_or_else(|| panic!("no part '{name}'"))
}

/// Where a part's joint is when the skin is as it was made.
fn at(skin: &Skin, part: &Part) -> Vector3<f64> {
    (skin.bind[part.link] * Point3::from(part.at)).coords
}

/// The part that a vertex goes with most, of those whose vertices go with some.
fn owners(skin: &Skin) -> HashMap<u32, &str> {
    let own = skin.fine.iter().filter_map(|(vertex, with)| {
        let part = usize::from(with[0].link).checked_sub(skin.bind.len())?;
        Some((*vertex, skin.parts[part].name.as_str()))
    });
    own.collect()
}

/// Who, and how finely.
fn hands() -> Vec<(String, Figure, Skin)> {
    let child = Human::new(1.10, 18.0).age(6.0).build().expect("a child");
    let people = [
        human(1.741, 73.0).expect("a person"),
        child,
        human(2.10, 120.0).expect("a person"),
        human(1.65, 110.0).expect("a person"),
    ];
    let of = |figure: Figure| {
        [Detail::Fine, Detail::Coarse, Detail::Rough].map(|detail| {
            let made = skin(&figure, detail);
            (format!("{} m, {detail:?}", figure.stature().unwrap_or_default()), figure.clone(), made)
        })
    };
    people.into_iter().flat_map(of).collect()
}

/// Whether the way from `a` to `b` goes through a triangle.
fn pierces(a: &Vector3<f64>, b: &Vector3<f64>, [p, q, r]: [Vector3<f64>; 3]) -> bool {
    let side = |a: Vector3<f64>, b: Vector3<f64>, c: Vector3<f64>, d: Vector3<f64>| {
        (b - a).cross(&(c - a)).dot(&(d - a)) > 0.0
    };
    let around = [side(*a, *b, p, q), side(*a, *b, q, r), side(*a, *b, r, p)];
    side(p, q, r, *a) != side(p, q, r, *b) && around[0] == around[1] && around[1] == around[2]
}

/// How many edges of digits go through triangles of other digits or of their own that are not beside them.
fn piercings(skin: &Skin) -> usize {
    let owners = owners(skin);
    let digit = |t: &[u32; 3]| owners.get(&t[0]).filter(|part| !part.ends_with("eye")).copied();
    let own: Vec<[u32; 3]> = skin.triangles.iter().filter(|t| digit(t).is_some()).copied().collect();
    let cell = |x: f64| (x / 0.008).floor() as i32;
    let mut boxes: HashMap<[i32; 3], Vec<usize>> = HashMap::new();
    let spans = |points: &[Vector3<f64>]| {
        let low = points.iter().fold(Vector3::repeat(f64::INFINITY), |l, p| l.inf(p));
        let high = points.iter().fold(Vector3::repeat(f64::NEG_INFINITY), |l, p| l.sup(p));
        let mut keys = Vec::new();
        for x in cell(low.x)..=cell(high.x) {
            for y in cell(low.y)..=cell(high.y) {
                keys.extend((cell(low.z)..=cell(high.z)).map(|z| [x, y, z]));
            }
        }
        keys
    };
    let corners = |t: &[u32; 3]| t.map(|i| skin.points[i as usize]);
    for (i, t) in own.iter().enumerate() {
        for key in spans(&corners(t)) {
            boxes.entry(key).or_default().push(i);
        }
    }
    let mut found = 0;
    for t in &own {
        for k in 0..3 {
            let (i, j) = (t[k], t[(k + 1) % 3]);
            if i > j {
                continue;
            }
            let [a, b] = [i, j].map(|i| skin.points[i as usize]);
            let mut near: Vec<usize> =
                spans(&[a, b]).iter().filter_map(|key| boxes.get(key)).flatten().copied().collect();
            near.sort_unstable();
            near.dedup();
            let apart = near.into_iter().filter(|o| !own[*o].contains(&i) && !own[*o].contains(&j));
            found += apart.filter(|o| pierces(&a, &b, corners(&own[*o]))).count();
        }
    }
    found
}

#[test]
fn no_digit_goes_through_another_one_as_they_hang() {
    // Hands are bent in whole: what is apart where they are made is so in every pose of the figure.
    for (who, _, skin) in hands() {
        assert_eq!(piercings(&skin), 0, "{who}");
    }
}

#[test]
fn digits_that_are_moved_into_each_other_are_found() {
    let mut made = skin(&human(1.741, 73.0).expect("a person"), Detail::Coarse);
    let owners: Vec<u32> = made
        .fine
        .iter()
        .filter(|(_, with)| {
            let part = usize::from(with[0].link).checked_sub(made.bind.len());
            part.is_some_and(|part| made.parts[part].name.starts_with("left_index"))
        })
        .map(|(vertex, _)| *vertex)
        .collect();
    for vertex in owners {
        made.points[vertex as usize].z -= 0.012;
    }
    assert!(piercings(&made) > 20);
}

#[test]
fn each_hand_has_a_thumb_and_four_fingers_of_three_bones() {
    let made = skin(&human(1.741, 73.0).expect("a person"), Detail::Fine);
    let mut vertices: BTreeMap<&str, usize> = BTreeMap::new();
    for part in owners(&made).into_values() {
        *vertices.entry(part).or_default() += 1;
    }
    for side in ["left", "right"] {
        for digit in ["thumb", "index", "middle", "ring", "little"] {
            for bone in 1..=3 {
                let name = format!("{side}_{digit}_{bone}");
                let parent = part(&made, &name).parent.map(|i| made.parts[i].name.clone());
                let before = (bone > 1).then(|| format!("{side}_{digit}_{}", bone - 1));
                assert_eq!(parent, before, "{name}");
                assert!(vertices[name.as_str()] > 25, "{name}: {} vertices", vertices[name.as_str()]);
            }
        }
    }
    assert_eq!(made.parts.len(), 32, "and two eyes");
}

/// The least and the greatest along `across` (m) of a digit's surface in the plane through `point`.
fn breadth(skin: &Skin, digit: &str, point: Vector3<f64>, normal: Vector3<f64>, across: Vector3<f64>) -> f64 {
    let owners = owners(skin);
    let own = |i: &u32| owners.get(i).is_some_and(|part| part.starts_with(digit));
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for t in skin.triangles.iter().filter(|t| t.iter().any(own)) {
        for k in 0..3 {
            let [a, b] = [t[k], t[(k + 1) % 3]].map(|i| skin.points[i as usize]);
            let [u, v] = [a, b].map(|p| normal.dot(&(p - point)));
            if (u < 0.0) != (v < 0.0) {
                let place = across.dot(&(a + (b - a) * (u / (u - v))));
                (low, high) = (low.min(place), high.max(place));
            }
        }
    }
    high - low
}

#[test]
fn fingers_are_as_long_and_broad_as_people_s() {
    // Of people of 1.741 m, women and men together, the hand is about the mean of both.
    let made = skin(&human(1.741, 73.0).expect("a person"), Detail::Fine);
    for side in ["left", "right"] {
        let joint = |digit: &str, bone: usize| at(&made, part(&made, &format!("{side}_{digit}_{bone}")));
        // S. Pheasant, Bodyspace (1996), hands of British adults, medians of men and women, and their means (mm): breadth of
        // the index at its joints 21 and 18, 19 and 16; of the thumb 23 and 19.
        for (digit, bone, expected) in [("index", 2, 0.0195), ("index", 3, 0.0175), ("thumb", 3, 0.021)] {
            let point = joint(digit, bone);
            let along = (point - joint(digit, bone - 1)).normalize();
            // The thumb's breadth is across the way from it to where it would touch the fingers.
            let back = if digit == "thumb" {
                let x = if side == "left" { 0.62 } else { -0.62 };
                made.bind[part(&made, &format!("{side}_thumb_3")).link] * Vector3::new(x, 0.10, 0.78)
            } else {
                made.bind[part(&made, &format!("{side}_index_3")).link] * Vector3::x()
            };
            let across = along.cross(&back).normalize();
            let found = breadth(&made, &format!("{side}_{digit}"), point, along, across);
            assert!((found / expected - 1.0).abs() < 0.08, "{side} {digit} {bone}: {found} m");
        }
        // Buryanov & Kotiuk (2010), mm: proximal and middle phalanges; the thumb's metacarpal and proximal phalanx.
        for (digit, lengths) in [
            ("thumb", [0.04622, 0.03157]),
            ("index", [0.03978, 0.02238]),
            ("middle", [0.04463, 0.02633]),
            ("ring", [0.04137, 0.02565]),
            ("little", [0.03274, 0.01811]),
        ] {
            for (bone, length) in (1..).zip(lengths) {
                let found = (joint(digit, bone + 1) - joint(digit, bone)).norm();
                assert!((found / length - 1.0).abs() < 0.06, "{side} {digit} {bone}: {found} m");
            }
        }
    }
}

#[test]
fn fingers_bend_to_the_palm_and_the_thumb_is_in_front() {
    for (who, _, made) in hands() {
        for (side, out) in [("left", 1.0), ("right", -1.0)] {
            let at = |digit: &str, bone: usize| part(&made, &format!("{side}_{digit}_{bone}")).at;
            for digit in ["index", "middle", "ring", "little"] {
                let [a, b, c] = [1, 2, 3].map(|bone| at(digit, bone));
                let bend = |from: Vector3<f64>, to: Vector3<f64>| {
                    let way = to - from;
                    (-out * way.x).atan2(-way.y)
                };
                // Palms look at the thighs: x is to the back of the left hand.
                let (first, second) = (bend(a, b), bend(b, c));
                assert!(first > 0.1 && second > first + 0.2 && second < 1.3, "{who}, {side} {digit}");
            }
            assert!(at("thumb", 3).z > at("index", 1).z && at("index", 1).z > at("little", 1).z, "{who}");
        }
    }
}

#[test]
fn shares_of_parts_are_one_together_and_no_finger_moves_another() {
    let made = skin(&human(1.741, 73.0).expect("a person"), Detail::Fine);
    let digit = |i: &Influence| {
        let part = usize::from(i.link).checked_sub(made.bind.len())?;
        made.parts[part].name.rsplit_once('_').map(|(digit, _)| digit.to_owned())
    };
    let is_beyond = |i: &Influence| {
        let part = usize::from(i.link).checked_sub(made.bind.len());
        part.is_some_and(|part| made.parts[part].name.ends_with(['2', '3']))
    };
    for (vertex, with) in &made.fine {
        let total: f32 = with.iter().map(|i| i.share).sum();
        assert!((total - 1.0).abs() < 1e-5, "{total}");
        // Beyond the first bones and the web between them a finger is its own.
        if is_beyond(&with[0]) {
            let own = digit(&with[0]);
            let others: f32 =
                with.iter().filter(|i| digit(i).is_some_and(|d| Some(d) != own)).map(|i| i.share).sum();
            assert!(others < 0.03, "{vertex}: {with:?}");
        }
        // Whoever has no bones for the parts moves it with the link that they are parts of.
        let own = made.influences[*vertex as usize];
        let of_link = |link: u16, all: &[Influence; 4]| -> f32 {
            let is = |i: &&Influence| match usize::from(i.link).checked_sub(made.bind.len()) {
                Some(part) => made.parts[part].link == usize::from(link),
                None => i.link == link,
            };
            all.iter().filter(is).map(|i| i.share).sum()
        };
        assert!((of_link(own[0].link, with) - own[0].share).abs() < 0.02);
    }
}

#[test]
fn eyes_look_ahead_out_of_their_lids() {
    for (who, figure, made) in hands() {
        let head = figure.link_index("head").expect("a head");
        for (side, out) in [("left", 1.0), ("right", -1.0)] {
            let (i, eye) = made
                .parts
                .iter()
                .enumerate()
                .find(|(_, part)| part.name == format!("{side}_eye"))
                .expect("an eye");
            assert!(eye.link == head && eye.at.x * out > 0.02, "{who}");
            let link = (made.bind.len() + i) as u16;
            let own: Vec<usize> =
                made.fine.iter().filter(|(_, w)| w[0].link == link).map(|(v, _)| *v as usize).collect();
            let centre = at(&made, eye);
            // The pupil is the last colour of the strip; its middle is straight ahead.
            let pupil = own.iter().copied().max_by(|a, b| made.colours[*a].total_cmp(&made.colours[*b]));
            let pupil = pupil.expect("a pupil");
            assert!(made.colours[pupil] > 8.0 / 9.0, "{who}");
            let way = (made.points[pupil] - centre).normalize();
            assert!((way - made.bind[head] * Vector3::z()).norm() < 1e-9, "{who}: {way}");
            // Nothing of the face is before pupil and iris, and the lids cover the eye's upper rim.
            let radius = (made.points[pupil] - centre).norm();
            let covers = |x: f64, y: f64| {
                let from = centre + Vector3::new(x, y, 2.0) * radius;
                let to = centre + Vector3::new(x, y, (1.0 - x * x - y * y).sqrt()) * radius * 1.0001;
                let face = made.triangles.iter().filter(|t| !own.contains(&(t[0] as usize)));
                face.filter(|t| pierces(&from, &to, t.map(|i| made.points[i as usize]))).count() > 0
            };
            for (x, y) in [(0.0, 0.0), (0.3, 0.0), (-0.3, 0.0), (0.0, 0.25), (0.0, -0.25)] {
                assert!(!covers(x, y), "{who}: {side}, {x}, {y}");
            }
            assert!(covers(0.0, 0.75) && covers(0.0, -0.75), "{who}: {side}");
        }
    }
}
