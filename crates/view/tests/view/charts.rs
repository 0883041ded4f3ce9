//! The pictures of coordinates, forces, postures and maps; and that no text of any picture covers another one or leaves it.

use solaris_model::{Contact, FigureBuilder, Joint, LinkSpec, Motion, MotionInfo, Trajectory, Vector3};
use solaris_view::chart::{WIDTH, width};
use solaris_view::{
    Effort, FootForces, Regions, Room, Stick, StickLine, StickPart, coordinates, efforts, forces, postures,
    regions,
};
use std::path::{Path, PathBuf};

/// The value of an attribute.
pub(crate) fn attribute<'a>(element: &'a str, name: &str) -> &'a str {
    element.split(&format!(" {name}=\"")).nth(1).and_then(|rest| rest.split('"').next()).unwrap_or_default()
}

/// The numbers of a text.
pub(crate) fn numbers(text: &str) -> Vec<f64> {
    text.split(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | '-')))
        .filter_map(|n| n.parse().ok())
        .collect()
}

/// The points of the elements of a class.
fn points(svg: &str, class: &str) -> Vec<Vec<f64>> {
    let of_class = |line: &&str| line.starts_with(&format!("<path class=\"{class}\""));
    svg.lines().filter(of_class).map(|line| numbers(attribute(line, "d"))).collect()
}

/// A text of a picture and the box around it.
struct Word {
    said: String,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

fn texts(svg: &str) -> Vec<Word> {
    let read = |line: &str| {
        let class = attribute(line, "class");
        let is = |name: &str| class.split(' ').any(|class| class == name);
        let size = if is("title") {
            17.0
        } else if is("small") {
            11.5
        } else {
            13.0
        };
        let (x, y): (f64, f64) =
            (attribute(line, "x").parse().expect("x"), attribute(line, "y").parse().expect("y"));
        let text = line.split('>').nth(1).and_then(|text| text.split('<').next()).unwrap_or_default();
        let text = text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&").replace("&#39;", "'");
        // Widths are estimated rather large.
        let wide = 0.88 * width(&text, size);
        let left = x - if is("end") {
            wide
        } else if is("middle") {
            0.5 * wide
        } else {
            0.0
        };
        Word { left, right: left + wide, top: y - 0.7 * size, bottom: y + 0.1 * size, said: text }
    };
    svg.lines().filter(|line| line.starts_with("<text")).map(read).collect()
}

/// What is wrong with the texts of a picture.
pub(crate) fn faults(svg: &str) -> Vec<String> {
    let height: f64 = attribute(svg.lines().next().expect("a line"), "height").parse().expect("a height");
    let texts = texts(svg);
    let mut faults = Vec::new();
    for (i, a) in texts.iter().enumerate() {
        if a.left < 0.0 || a.right > WIDTH || a.top < 0.0 || a.bottom > height {
            faults.push(format!("'{}' at {} {} leaves the picture", a.said, a.left, a.bottom));
        }
        for b in &texts[i + 1..] {
            if a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom {
                faults.push(format!("'{}' at {} {} covers '{}'", a.said, a.left, a.bottom, b.said));
            }
        }
    }
    if svg.contains("NaN") || svg.contains("inf\"") {
        faults.push("a number that is none".to_owned());
    }
    faults
}

fn svgs(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let (folders, files): (Vec<PathBuf>, Vec<PathBuf>) = entries.partition(|path| path.is_dir());
    let mut svgs: Vec<PathBuf> =
        files.into_iter().filter(|path| path.extension().is_some_and(|e| e == "svg")).collect();
    svgs.extend(folders.iter().flat_map(|folder| self::svgs(folder)));
    svgs
}

/// Every picture of the documentation that the charts drew.
#[test]
fn texts_of_the_pictures_keep_apart_and_inside() {
    let mut looked_at = 0;
    for path in svgs(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs")) {
        let svg = std::fs::read_to_string(&path).expect("a picture");
        if svg.contains("class=\"solaris-chart\"") {
            looked_at += 1;
            let faults = faults(&svg);
            assert!(faults.is_empty(), "{}:\n{}", path.display(), faults.join("\n"));
        }
    }
    assert!(looked_at > 30, "{looked_at} pictures");
}

/// A slide that goes so far (m) in two seconds while a hinge turns from −90° to 90° for a metre.
struct Ramp(f64);

impl Trajectory for Ramp {
    fn duration(&self) -> f64 {
        2.0
    }
    fn configuration(&self, t: f64, q: &mut [f64]) {
        q[0] = 0.5 * self.0 * t;
        q[1] = self.0 * (t - 1.0) * std::f64::consts::FRAC_PI_2;
    }
}

#[test]
fn angles_are_in_degrees_and_ways_in_metres() {
    let joint = Joint::new("rail").tx().rz();
    let link = LinkSpec::root("car", joint).mass(1.0).com(Vector3::new(0.0, -0.1, 0.0));
    let figure = FigureBuilder::new("car").link(link).build().expect("a figure");
    let gravity = Vector3::new(0.0, -9.81, 0.0);
    let info = MotionInfo { fingerprint: figure.fingerprint(), gravity, ground: None, rate: 50.0 };
    let motion = Motion::sample(&figure, &Ramp(1.0), info.clone()).expect("a motion");
    let svg = coordinates(&figure, &motion, "A <car>");
    assert_eq!(svg, coordinates(&figure, &motion, "A <car>"));
    assert!(faults(&svg).is_empty(), "{:?}", faults(&svg));
    for text in ["A &lt;car&gt;", "angle (°)", "way (m)", "rail.tx", "rail.rz", "−50", "50", "0.5", "1.0"]
    {
        assert!(svg.contains(&format!(">{text}</text>")), "{text}: {svg}");
    }
    // Straight lines of two points, one in each panel, from its left to its right and up.
    let lines = points(&svg, "line s0");
    let lines: Vec<&Vec<f64>> = lines.iter().filter(|line| line[2] - line[0] > 400.0).collect();
    assert_eq!(lines.len(), 2, "{svg}");
    for line in lines {
        assert!(line.len() == 4 && line[3] < line[1] - 150.0, "{line:?}");
    }
    let still = Motion::sample(&figure, &Ramp(0.0), info).expect("a motion");
    assert!(coordinates(&figure, &still, "").contains("No joint with an axis moves."));
}

#[test]
fn a_plate_is_dashed_in_the_colour_of_its_foot() {
    let time = [0.0, 0.1, 0.2];
    let contact = |up: f64| Contact { force: Vector3::new(0.0, up, 0.0), ..Contact::default() };
    let (found, measured) = ([0.0, 700.0, 0.0].map(contact), [0.0, 690.0, 0.0].map(contact));
    let foot = |name, samples, is_measured| FootForces { name, time: &time, samples, is_measured };
    let feet = [foot("left", &found, false), foot("right", &found, false), foot("right", &measured, true)];
    let svg = forces(&feet, &[("along x", Vector3::x()), ("along y", Vector3::y())], "forces");
    assert!(faults(&svg).is_empty(), "{:?}", faults(&svg));
    for text in ["left", "right", "right, plate", "along x (N)", "along y (N)", "600"] {
        assert_eq!(svg.matches(&format!(">{text}</text>")).count(), 1, "{text}");
    }
    // In the legend and in both panels.
    assert_eq!(points(&svg, "line s0").len(), 3);
    assert_eq!(points(&svg, "line s1").len(), 3);
    let plate = points(&svg, "thin s1");
    assert_eq!(plate.len(), 3);
    assert!(plate[2].len() == 6 && plate[2][3] < plate[2][1] - 100.0, "{plate:?}");
}

#[test]
fn a_moment_lies_in_the_area_of_its_errors() {
    let time = [0.0, 0.1, 0.2];
    let effort = |name: &str, spread| Effort {
        name: name.to_owned(),
        unit: "N m".to_owned(),
        values: vec![0.0, 60.0, 10.0],
        spread,
    };
    let said = "across: time (s); areas: two standard errors";
    let moments = [effort("left_knee", Some(vec![5.0, 20.0, 5.0])), effort("right_knee", None)];
    let svg = efforts(&time, &moments, &[], &[], "moments");
    assert!(faults(&svg).is_empty(), "{:?}", faults(&svg));
    assert!(svg.contains(&format!(">{said}</text>")), "{svg}");
    assert!(points(&svg, "area f1").is_empty(), "none around the right knee");
    let (area, line) = (&points(&svg, "area f0")[0], points(&svg, "line s0"));
    // There along the upper edge, back along the lower one; the line is midway.
    let line = line.last().expect("a curve");
    let lower: Vec<f64> = area.chunks(2).rev().take(3).map(|point| point[1]).collect();
    for i in 0..3 {
        let (above, on, below) = (area[2 * i + 1], line[2 * i + 1], lower[i]);
        assert!(above < on && (0.5 * (above + below) - on).abs() < 0.02, "{above} {on} {below}");
    }
    let plain = efforts(&time, &[effort("left_knee", None)], &[], &[], "moments");
    assert!(plain.contains(">across: time (s)</text>"), "{plain}");
}

#[test]
fn a_map_colours_what_fails_and_marks_the_point() {
    // Two places by two: the upper right one fails.
    let fails = [None, None, None, Some(1)];
    let map = Regions {
        axes: ["across (°)".to_owned(), "up (°)".to_owned()],
        spans: [(0.0, 10.0), (0.0, 20.0)],
        places: [2, 2],
        conditions: vec!["(i) a < b".to_owned(), "(ii) c < d".to_owned()],
        fails: &fails,
        edges: vec![([[5.0, 20.0], [10.0, 10.0]], 1)],
        mark: Some([0.0, 0.0]),
    };
    let svg = regions(&map, "map");
    assert!(faults(&svg).is_empty(), "{:?}", faults(&svg));
    for text in ["across (°)", "up (°)", "all hold", "fails: (i) a &lt; b", "fails: (ii) c &lt; d"] {
        assert!(svg.contains(&format!(">{text}</text>")), "{text}");
    }
    assert!(points(&svg, "area f0").is_empty());
    let area = &points(&svg, "area f1")[0];
    let edge = &points(&svg, "line s1")[0];
    let mark = svg.lines().find(|line| line.starts_with("<circle class=\"ink\"")).expect("a mark");
    let mark: Vec<f64> = ["cx", "cy"].map(|name| attribute(mark, name).parse().expect(name)).into();
    // The mark is at the lower left corner, the edge runs from the middle of the top to the middle of the right side.
    assert!(edge[0] > mark[0] + 200.0 && edge[1] < mark[1] - 350.0, "{edge:?} {mark:?}");
    assert!((edge[3] - 0.5 * (mark[1] + edge[1])).abs() < 0.05, "{edge:?} {mark:?}");
    assert!((area[0] - edge[0]).abs() < 0.05 && area[1] < edge[1], "{area:?} {edge:?}");
}

#[test]
fn postures_stand_on_one_ground_in_one_scale() {
    let stick = |name: &str, height: f64| Stick {
        name: name.to_owned(),
        lines: vec![StickLine { part: StickPart::Stance, points: vec![[0.0, height], [0.1, 0.0]] }],
        angles: vec![("stance thigh".to_owned(), "-6.3°".to_owned())],
    };
    let room = |text: &str, share: f64| Room {
        text: text.to_owned(),
        sides: "1.00° < 2.00°".to_owned(),
        room: format!("{share}°"),
        share,
    };
    let rooms = [
        room("(i) χ < α", 0.5),
        room("(ii) a long one that is said in many words: the foot stays above", -0.25),
    ];
    let svg = postures(&[stick("tall", 1.6), stick("small", 0.8)], &rooms, "postures");
    assert!(faults(&svg).is_empty(), "{:?}", faults(&svg));
    let legs = points(&svg, "limb s0");
    assert!((legs[0][3] - legs[1][3]).abs() < 0.05, "one ground: {legs:?}");
    assert!(
        ((legs[0][3] - legs[0][1]) / (legs[1][3] - legs[1][1]) - 2.0).abs() < 0.01,
        "one scale: {legs:?}"
    );
    assert_eq!(svg.matches(">stance thigh</text>").count(), 1);
    assert_eq!(svg.matches(">−6.3°</text>").count(), 2);
    let bar = |class: &str| -> f64 {
        let bar =
            svg.lines().find(|line| line.starts_with(&format!("<rect class=\"{class}\""))).expect(class);
        attribute(bar, "width").parse().expect("a width")
    };
    let ratio = bar("f2") / bar("f1");
    assert!((1.9..2.1).contains(&ratio), "what holds is green, what fails vermilion: {ratio}");
}
