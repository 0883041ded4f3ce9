//! Film strips: figure, ground and contacts in one scale, and what is refused. What outlines of solids look like is tested beside them.

use crate::charts::{attribute, faults, numbers};
use solaris_model::{
    Contact, ContactTrack, Figure, FigureBuilder, Joint, LinkSpec, Motion, MotionInfo, Placement, Relief,
    Shape, ShapeKind, Trajectory, Vector3,
};
use solaris_view::{FilmOptions, Seen, ViewError, film};

/// A ball of 1 m across rolls 11 m along z in 11 s, and up a kerb of 0.4 m at 5.5 m.
struct Ball;

const KERB: f64 = 0.4;

fn ground(z: f64) -> f64 {
    if z < 5.5 { 0.0 } else { KERB }
}

impl Trajectory for Ball {
    fn duration(&self) -> f64 {
        11.0
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        q[0] = 0.5 + ground(t);
        q[1] = t;
    }
}

fn ball() -> (Figure, Motion) {
    let shape = Shape { kind: ShapeKind::Sphere { radius: 0.5 }, placement: Placement::identity() };
    let link = LinkSpec::root("left_ball", Joint::new("way").ty().tz()).mass(2.0).shape(shape);
    let figure = FigureBuilder::new("ball").link(link).build().expect("a figure");
    let mut motion = Motion::sample(&figure, &Ball, MotionInfo::on_earth(&figure, 10.0)).expect("a motion");
    motion.relief = Some(Relief::new(vec![[5.5, 0.0], [5.5, KERB]]).expect("a relief"));
    // It is in the air for the last second.
    let contact = |&t: &f64| {
        let force = Vector3::y() * if t < 10.5 { 20.0 } else { 0.0 };
        Contact { force, cop: Vector3::new(0.0, ground(t), t), ..Contact::default() }
    };
    let samples = motion.time().iter().map(contact).collect();
    motion.contacts.push(ContactTrack { link: "left_ball".to_owned(), samples });
    (figure, motion)
}

/// The elements whose lines begin so, by the numbers of an attribute.
fn elements(svg: &str, begin: &str, attributes: &[&str]) -> Vec<Vec<f64>> {
    let lines = svg.lines().filter(|line| line.starts_with(begin));
    lines.map(|line| attributes.iter().flat_map(|name| numbers(attribute(line, name))).collect()).collect()
}

#[test]
fn a_ball_lies_on_the_ground_before_and_after_a_kerb() {
    let (figure, motion) = ball();
    let svg = film(&figure, &motion, &FilmOptions { title: "A ball".to_owned(), ..FilmOptions::default() })
        .expect("a strip");
    assert_eq!(
        svg,
        film(&figure, &motion, &FilmOptions { title: "A ball".to_owned(), ..FilmOptions::default() })
            .expect("again")
    );
    assert!(faults(&svg).is_empty(), "{:?}", faults(&svg));
    let balls = elements(&svg, "<path class=\"left\"", &["d"]);
    let dots = elements(&svg, "<circle class=\"f0 mark\"", &["cx", "cy"]);
    // Ground lines are the long ones: marks at metres are upright.
    let lines: Vec<Vec<f64>> = elements(&svg, "<path class=\"zero\"", &["d"]);
    let lines: Vec<&Vec<f64>> = lines.iter().filter(|line| line[line.len() - 2] - line[0] > 20.0).collect();
    assert_eq!((balls.len(), lines.len(), dots.len()), (12, 12, 11), "in the air there is no dot");
    for (i, (ball, line)) in balls.iter().zip(&lines).enumerate() {
        // M x y A r r 0 0 1 x y …
        let (radius, middle) = (ball[2], ball[1]);
        let under = if i < 6 { line[1] } else { line[line.len() - 1] };
        assert!((under - middle - radius).abs() < 0.2, "still {i}: {ball:?} {line:?}");
        if let Some(dot) = dots.get(i) {
            assert!((dot[1] - under).abs() < 0.1 && (dot[0] - ball[0] - radius).abs() < 0.1, "still {i}");
        }
    }
    // The kerb lies within two stills, the last of the upper row and the first of the lower one.
    let radius = balls[5][2];
    let rise = |line: &[f64]| (line[1] - line[line.len() - 1]) / (2.0 * radius);
    for (i, line) in lines.iter().enumerate() {
        let expected = if i == 5 || i == 6 { KERB } else { 0.0 };
        assert!((rise(line) - expected).abs() < 0.01, "still {i} rises by {} m", rise(line));
    }
    for text in ["0.00 s", "11.00 s", "3 m", "10 m"] {
        assert!(svg.contains(&format!(">{text}</text>")), "{text}");
    }
}

#[test]
fn it_is_seen_from_elsewhere_with_a_grid() {
    let (figure, motion) = ball();
    for seen in [Seen::Corner, Seen::Above] {
        let svg = film(&figure, &motion, &FilmOptions { seen, ..FilmOptions::default() }).expect("a strip");
        assert!(faults(&svg).is_empty(), "{seen:?}: {:?}", faults(&svg));
        assert_eq!(svg.matches("class=\"left\"").count(), 12, "{seen:?}");
        assert!(svg.matches("class=\"grid\"").count() > 12 * 8, "{seen:?}");
    }
    // The kerb's two edges are drawn across in the stills that reach it.
    let edges = |motion: &Motion| {
        let corner = FilmOptions { seen: Seen::Corner, ..FilmOptions::default() };
        film(&figure, motion, &corner).expect("a strip").matches("class=\"grid\"").count()
    };
    let mut level = motion.clone();
    level.relief = None;
    assert!(edges(&motion) > edges(&level), "{} {}", edges(&motion), edges(&level));
    let above = FilmOptions { seen: Seen::Above, ..FilmOptions::default() };
    let svg = film(&figure, &motion, &above).expect("a strip");
    // From above the pressure is under the middle of the ball.
    let (ball, dot) = (
        &elements(&svg, "<path class=\"left\"", &["d"])[0],
        &elements(&svg, "<circle class=\"f0 mark\"", &["cx", "cy"])[0],
    );
    assert!((dot[0] - ball[0] - ball[2]).abs() < 0.1 && (dot[1] - ball[1]).abs() < 0.1, "{dot:?} {ball:?}");
}

/// Where there is no ground, forces are of links on each other.
#[test]
fn no_ground_bears_nothing() {
    let (figure, mut motion) = ball();
    (motion.relief, motion.info.ground) = (None, None);
    let svg = film(&figure, &motion, &FilmOptions::default()).expect("a strip");
    assert_eq!(elements(&svg, "<circle class=\"f0 mark\"", &["cx"]).len(), 0);
    assert!(!svg.contains("A dot"));
}

#[test]
fn times_beyond_the_motion_are_refused() {
    let (figure, motion) = ball();
    for between in [(2.0, 1.0), (-1.0, 3.0), (3.0, 12.0), (0.0, f64::INFINITY)] {
        let options = FilmOptions { between: Some(between), ..FilmOptions::default() };
        let error = film(&figure, &motion, &options).expect_err("refused");
        assert!(matches!(error, ViewError::Span { .. }), "{error}");
        assert!(error.to_string().contains("from 0 to 11 s"), "{error}");
    }
}
