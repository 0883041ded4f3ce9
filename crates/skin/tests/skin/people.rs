//! The skins of people: closed, outwards, as large as the mass and the density of tissue say.

use solaris_model::rig::Segment;
use solaris_model::{Figure, Human, Vector3};
use solaris_skin::{Detail, Skin, skin};
use std::collections::HashMap;
use std::sync::LazyLock;

/// Height, mass, age.
const PEOPLE: [(f64, f64, Option<f64>); 9] = [
    (1.741, 73.0, None),
    (1.60, 50.0, None),
    (1.65, 58.0, None),
    (1.95, 95.0, None),
    (1.70, 110.0, None),
    (1.80, 55.0, None),
    (1.15, 21.0, Some(6.0)),
    (1.40, 33.0, Some(10.0)),
    (1.60, 50.0, Some(14.0)),
];

fn figure((height, mass, age): (f64, f64, Option<f64>)) -> Figure {
    let human = Human::new(height, mass);
    age.map_or(human.clone(), |age| human.age(age)).build().expect("a person")
}

static ALL: LazyLock<Vec<(String, Figure, Skin)>> = LazyLock::new(|| {
    let of = |person| {
        [Detail::Fine, Detail::Coarse, Detail::Rough].map(|detail| {
            let figure = figure(person);
            let made = skin(&figure, detail);
            (format!("{person:?}, {detail:?}"), figure, made)
        })
    };
    PEOPLE.into_iter().flat_map(of).collect()
});

fn all() -> impl Iterator<Item = (&'static str, &'static Figure, &'static Skin)> {
    ALL.iter().map(|(who, figure, skin)| (who.as_str(), figure, skin))
}

#[test]
fn every_edge_has_two_triangles_that_run_along_it_both_ways() {
    for (who, _, skin) in all() {
        let mut edges: HashMap<(u32, u32), usize> = HashMap::new();
        for t in &skin.triangles {
            for k in 0..3 {
                *edges.entry((t[k], t[(k + 1) % 3])).or_default() += 1;
            }
        }
        let bad =
            edges.iter().filter(|((a, b), count)| **count != 1 || !edges.contains_key(&(*b, *a))).count();
        assert_eq!(bad, 0, "{who}");
    }
}

/// The first vertex of a part.
fn root(part: &mut [usize], mut i: usize) -> usize {
    while part[i] != i {
        part[i] = part[part[i]];
        i = part[i];
    }
    i
}

#[test]
fn all_is_one_piece_but_the_eyes() {
    for (who, _, skin) in all() {
        let mut part: Vec<usize> = (0..skin.points.len()).collect();
        for t in &skin.triangles {
            let [a, b, c] = t.map(|i| root(&mut part, i as usize));
            part[b] = a;
            let c = root(&mut part, c);
            let a = root(&mut part, a);
            part[c] = a;
        }
        let eyes = skin.parts.iter().filter(|part| part.name.ends_with("eye")).count();
        assert_eq!((0..part.len()).filter(|i| part[*i] == *i).count(), 1 + eyes, "{who}");
    }
}

#[test]
fn no_triangle_is_a_line_and_hardly_any_looks_inwards() {
    for (who, _, skin) in all() {
        let mut inwards = 0;
        for t in &skin.triangles {
            let [a, b, c] = t.map(|i| skin.points[i as usize]);
            let across = (b - a).cross(&(c - a));
            assert!(across.norm() / 2.0 > 1e-10, "{who}: {a:?} {b:?} {c:?}");
            let normal: Vector3<f64> = t.iter().map(|i| skin.normals[*i as usize]).sum();
            inwards += usize::from(across.dot(&normal) <= 0.0);
        }
        // In creases between fingers and behind ears, narrower than a cell.
        let few = if who.contains("Rough") { 150 } else { 300 };
        assert!(inwards * few < skin.triangles.len(), "{who}: {inwards} of {}", skin.triangles.len());
        assert!(skin.normals.iter().all(|n| (n.norm() - 1.0).abs() < 1e-9), "{who}");
    }
}

/// What the segments hold together, by their densities (m³).
fn expected(figure: &Figure) -> f64 {
    let of = |name: &str| match name.trim_start_matches("left_").trim_start_matches("right_") {
        "pelvis" => Segment::Pelvis,
        "abdomen" | "thorax" => Segment::Trunk,
        "neck" => Segment::Neck,
        "head" => Segment::Head,
        "clavicle" => Segment::Clavicle,
        "upper_arm" => Segment::UpperArm,
        "forearm" => Segment::Forearm,
        "hand" => Segment::Hand,
        "thigh" => Segment::Thigh,
        "shank" => Segment::Shank,
        "foot" => Segment::Foot,
        _ => Segment::Toes,
    };
    figure.links().iter().map(|link| link.mass() / of(link.name()).of_adult().density).sum()
}

#[test]
fn a_body_is_as_large_as_its_segments_mass_and_density_say() {
    for (who, figure, skin) in all() {
        let off = skin.volume() / expected(figure) - 1.0;
        let most = if who.contains("Rough") { 0.13 } else { 0.12 };
        assert!(off.abs() < most, "{who}: {:.1} %", off * 100.0);
    }
    let man = figure(PEOPLE[0]);
    let off = skin(&man, Detail::Fine).volume() / expected(&man) - 1.0;
    assert!(off.abs() < 0.03, "{:.1} %", off * 100.0);
}

#[test]
fn left_is_the_mirror_image_of_right() {
    // Cells are not, so vertices are not; what they enclose on either side is.
    let skin = skin(&figure(PEOPLE[0]), Detail::Fine);
    let mut sides = [0.0; 2];
    for t in &skin.triangles {
        let [a, b, c] = t.map(|i| skin.points[i as usize]);
        // A sixth of the triple product is the part of the volume seen from the pelvis.
        sides[usize::from((a + b + c).x < 0.0)] += a.dot(&b.cross(&c)) / 6.0;
    }
    assert!((sides[0] / sides[1] - 1.0).abs() < 0.01, "{sides:?}");
}

#[test]
fn soles_are_flat_where_the_figure_has_them() {
    for (who, figure, skin) in all() {
        let foot = figure.link_index("left_foot").expect("a foot");
        let heel = figure.links()[foot].sole()[0].position;
        let sole = (skin.bind[foot] * nalgebra::Point3::from(heel)).y;
        let lowest = skin.points.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
        assert!((lowest - sole).abs() < 0.003, "{who}: {lowest} and {sole} m");
        let flat = skin.points.iter().filter(|p| (p.y - sole).abs() < 0.003).count();
        assert!(flat > 60, "{who}: {flat} vertices");
    }
}

#[test]
fn it_is_made_the_same_to_the_bit_however_many_threads_there_are() {
    let man = figure(PEOPLE[0]);
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
    let three = rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("a pool");
    let [a, b] = [one, three].map(|pool| pool.install(|| skin(&man, Detail::Coarse)));
    assert_eq!(a, b);
}

#[test]
fn a_person_has_as_many_vertices_as_films_and_pages_take() {
    for (who, _, skin) in all() {
        let range = match who {
            who if who.contains("Fine") => 9000..16_000,
            who if who.contains("Coarse") => 4500..9000,
            _ => 2000..5000,
        };
        assert!(range.contains(&skin.points.len()), "{who}: {}", skin.points.len());
    }
}

#[test]
fn people_who_cannot_be_have_a_skin_all_the_same() {
    for (height, mass) in [(0.8, 5.2), (2.3, 423.0), (2.3, 43.0), (0.8, 51.0)] {
        let skin = skin(&figure((height, mass, None)), Detail::Coarse);
        assert!(skin.volume() > 0.0 && skin.points.iter().all(|p| p.iter().all(|x| x.is_finite())));
    }
}
