//! Bad models: every one a clear error with its place, in bounded time, and never a panic.

use crate::opensim::{axis, body, document, joint};
use solaris_io::opensim;
use std::fmt::Write;

fn pin(name: &str, parent: &str, child: &str) -> String {
    joint("PinJoint", name, [parent, child], &[&format!("{name}_angle")], "")
}

/// A pendulum of one rod.
fn good() -> String {
    document(&body("rod", 2.0), &pin("pivot", "/ground", "/bodyset/rod"), "")
}

/// A rod on a custom joint whose first axis has this inside.
fn custom(coordinates: &str, function: &str) -> String {
    let transform =
        format!("<SpatialTransform>{}</SpatialTransform>", axis("rotation1", coordinates, "0 0 1", function));
    let joint = joint("CustomJoint", "pivot", ["/ground", "/bodyset/rod"], &["bend", "twist"], &transform);
    document(&body("rod", 2.0), &joint, "")
}

#[expect(clippy::too_many_lines, reason = "a table")]
fn cases() -> Vec<(&'static str, String)> {
    let good = good();
    let two = body("rod", 2.0) + &body("bob", 1.0);
    let pivot = pin("pivot", "/ground", "/bodyset/rod");
    let frames = "<frames><PhysicalOffsetFrame name=\"a\"><socket_parent>../b</socket_parent></PhysicalOffsetFrame>\
        <PhysicalOffsetFrame name=\"b\"><socket_parent>../a</socket_parent></PhysicalOffsetFrame></frames>";
    let spline = |x: &str, y: &str| {
        custom("bend", &format!("<SimmSpline name=\"function\"><x>{x}</x><y>{y}</y></SimmSpline>"))
    };
    let coupler = |from: &str, to: &str| {
        format!(
            "<CoordinateCouplerConstraint name=\"{to}\"><independent_coordinate_names>{from}</independent_coordinate_names>\
             <dependent_coordinate_name>{to}</dependent_coordinate_name>\
             <LinearFunction name=\"coupled_coordinates_function\"/></CoordinateCouplerConstraint>"
        )
    };
    let constraints = |inner: String| format!("<ConstraintSet><objects>{inner}</objects></ConstraintSet>");
    vec![
        ("empty", String::new()),
        ("blank", " \r\n\t".to_owned()),
        ("binary", "\u{0}\u{1}\u{7f}PK\u{3}\u{4}".to_owned()),
        ("no model of OpenSim", "<robot name=\"r\"/>".to_owned()),
        (
            "loads instead of a model",
            "<OpenSimDocument Version=\"40000\"><ExternalLoads/></OpenSimDocument>".to_owned(),
        ),
        ("truncated", good[..good.len() / 2].to_owned()),
        ("too old", good.replace("40000", "10900")),
        ("version is a word", good.replace("40000", "four")),
        ("unknown body", good.replace("/bodyset/rod", "/bodyset/rd")),
        ("missing socket", good.replace("<socket_parent_frame>/ground</socket_parent_frame>", "")),
        ("empty socket", good.replace("/ground", "")),
        (
            "cycle",
            document(
                &two,
                &(pin("one", "/bodyset/bob", "/bodyset/rod") + &pin("two", "/bodyset/rod", "/bodyset/bob")),
                "",
            ),
        ),
        ("on itself", document(&body("rod", 2.0), &pin("one", "/bodyset/rod", "/bodyset/rod"), "")),
        (
            "two joints move a body",
            document(&body("rod", 2.0), &(pivot.clone() + &pin("again", "/ground", "/bodyset/rod")), ""),
        ),
        (
            "frames on each other",
            document(&body("rod", 2.0), &joint("PinJoint", "pivot", ["a", "/bodyset/rod"], &[], frames), ""),
        ),
        ("names twice", document(&(body("rod", 2.0) + &body("rod", 1.0)), &(pivot.clone() + &pivot), "")),
        ("no name", good.replace("<Body name=\"rod\">", "<Body>")),
        ("unknown joint", good.replace("PinJoint", "ConstantCurvatureJoint")),
        ("an ellipsoid without radii", good.replace("PinJoint", "EllipsoidJoint")),
        (
            "points on a line",
            good.replace("<socket_parent_frame>/ground", "<socket_parent_frame>/corner").replace(
                "<BodySet",
                "<components><Station name=\"p\"><socket_parent_frame>/ground</socket_parent_frame></Station>\
                 <StationDefinedFrame name=\"corner\"><socket_point_a>/p</socket_point_a><socket_point_b>/p</socket_point_b>\
                 <socket_point_c>/p</socket_point_c><socket_origin_point>/p</socket_origin_point></StationDefinedFrame>\
                 </components><BodySet",
            ),
        ),
        ("too many coordinates", good.replace("<coordinates>", "<coordinates><Coordinate name=\"more\"/>")),
        (
            "a body that cannot be",
            good.replace("0.02 0.015 0.021", "0.02 0.015 0.5").replace("<mass>2<", "<mass>-2<"),
        ),
        (
            "numbers that are none",
            good.replace("0.02 0.015", "NaN 0.015")
                .replace("0.01 -0.2", "1e999 -0.2")
                .replace("<mass>2<", "<mass>two<"),
        ),
        ("five numbers", good.replace(" 0.0005", "")),
        (
            "a flag that is none",
            good.replace(
                "<Coordinate name=\"pivot_angle\"/>",
                "<Coordinate name=\"pivot_angle\"><locked>perhaps</locked></Coordinate>",
            ),
        ),
        ("no transform", custom("bend", "").replace("SpatialTransform", "Transform")),
        ("unknown function", custom("bend", "<function><SmoothSegmentedFunction/></function>")),
        ("unknown coordinate", custom("bent", "")),
        ("two coordinates", custom("bend twist", "")),
        (
            "function of nothing",
            custom("", "<LinearFunction/>")
                .replace("<Coordinate name=\"bend\"/><Coordinate name=\"twist\"/>", ""),
        ),
        ("spline falls", spline("0 1 1", "0 0 1")),
        ("spline of unequal lists", spline("0 1 2", "0 0")),
        ("spline of one point", spline("0", "0")),
        ("spline beyond numbers", spline("-1e308 0 1 1e308", "-1e308 1e308 -1e308 1e308")),
        ("spline of degree 7", custom("bend", "<GCVSpline><half_order>4</half_order></GCVSpline>")),
        ("quintic spline of two points", custom("bend", "<GCVSpline><x>0 1</x><y>1 0</y></GCVSpline>")),
        ("no direction", custom("bend", "").replace("<axis>0 0 1</axis>", "<axis>0 0 0</axis>")),
        (
            "coupler to nowhere",
            document(&body("rod", 2.0), &pivot, &constraints(coupler("pivot_angel", "pivot_angle"))),
        ),
        (
            "couplers in a circle",
            document(
                &two,
                &(pivot.clone() + &pin("hinge", "/bodyset/rod", "/bodyset/bob")),
                &constraints(coupler("pivot_angle", "hinge_angle") + &coupler("hinge_angle", "pivot_angle")),
            ),
        ),
        ("too many bent functions in a row", {
            let count = 40;
            let name = |i: usize| if i == 0 { "/ground".to_owned() } else { format!("/bodyset/b{i}") };
            let bodies: String = (1..=count).map(|i| body(&format!("b{i}"), 1.0)).collect();
            let joints: String = (1..=count).map(|i| pin(&format!("j{i}"), &name(i - 1), &name(i))).collect();
            let spline = "<SimmSpline name=\"coupled_coordinates_function\"><x>0 1 2</x><y>0 1 4</y></SimmSpline>";
            let line = "<LinearFunction name=\"coupled_coordinates_function\"/>";
            let tie = |i: usize| coupler(&format!("j{i}_angle"), &format!("j{}_angle", i + 1)).replace(line, spline);
            document(&bodies, &joints, &constraints((1..count).map(tie).collect()))
        }),
        ("frames through points of each other", {
            let point = |name: &str, frame: &str| {
                format!("<Station name=\"{name}\"><socket_parent_frame>{frame}</socket_parent_frame></Station>")
            };
            let corner = |i: usize| {
                let frame = if i == 0 { "/ground".to_owned() } else { format!("/corner{}", i - 1) };
                let socket = |socket: &str| format!("<socket_{socket}>/p{i}</socket_{socket}>");
                let sockets = ["point_a", "point_b", "point_c", "origin_point"].map(socket).concat();
                point(&format!("p{i}"), &frame)
                    + &format!("<StationDefinedFrame name=\"corner{i}\">{sockets}</StationDefinedFrame>")
            };
            let corners: String = (0..60).map(corner).collect();
            good.replace("<socket_parent_frame>/ground", "<socket_parent_frame>/corner59")
                .replace("<BodySet", &format!("<components>{corners}</components><BodySet"))
        }),
        ("deep", "<a>".repeat(2000) + &"</a>".repeat(2000)),
        ("declares entities", "<!DOCTYPE x [<!ENTITY a \"b\">]><x/>".to_owned()),
    ]
}

#[test]
fn bad_models_are_answered_with_their_places() {
    let mut said = String::new();
    for (name, text) in cases() {
        let error = opensim::read(&text).err().map_or_else(|| "READ".to_owned(), |error| error.to_string());
        let _ = writeln!(said, "{name}:\n  {}", error.replace('\n', "\n  "));
    }
    assert!(!said.contains("READ"), "{said}");
    insta::assert_snapshot!(said);
}

/// What OpenSim opens, too: it moves nothing, or not one to one.
#[test]
fn coordinates_without_an_axis_of_their_own_are_no_fault() {
    let said = |text: &str| {
        let import = opensim::read(text).expect("a model");
        let found = import.findings.iter().find(|finding| finding.subject.starts_with("coordinate"));
        found.map_or_else(String::new, |finding| finding.message.clone())
    };
    assert!(said(&custom("bend", "")).starts_with("it moves nothing"));
    let half = "<LinearFunction name=\"function\"><coefficients>0.5 0</coefficients></LinearFunction>";
    let half = custom("bend", half).replace("<Coordinate name=\"twist\"/>", "");
    assert!(said(&half).contains("in radians"));
}

#[test]
fn windows_line_ends_blanks_and_odd_names_are_no_fault() {
    let text = good().replace('\n', "\r\n").replace("/ground", " /ground ").replace("rod", "l'os «ü» 1");
    let import = opensim::read(&text).expect("all the same");
    assert_eq!(import.figure.links()[0].name(), "l'os «ü» 1");
    // Older files of version 4 name frames by paths that are no longer right.
    let moved = good().replace("/bodyset/rod", "../rod");
    assert_eq!(opensim::read(&moved).expect("the name alone tells").figure.links().len(), 1);
}

/// Every prefix of a model, and every line left out, is read or refused.
#[test]
fn cut_texts_do_not_panic() {
    let text = custom("bend", "<SimmSpline name=\"function\"><x>0 1 2</x><y>0 1 4</y></SimmSpline>");
    for end in (0..text.trim_end().len()).filter(|end| text.is_char_boundary(*end)) {
        assert!(opensim::read(&text[..end]).is_err());
    }
    for (start, _) in text.match_indices('<') {
        let end = text[start..].find('>').map_or(text.len(), |end| start + end + 1);
        let _ = opensim::read(&format!("{}{}", &text[..start], &text[end..]));
    }
}

/// Chains of 12 000 bodies and of 12 000 frames take time in proportion.
#[test]
fn long_chains_are_read() {
    let count = 12_000;
    let name = |i: usize| if i == 0 { "/ground".to_owned() } else { format!("/bodyset/b{i}") };
    let bodies = (1..=count).map(|i| body(&format!("b{i}"), 1.0)).collect::<Vec<_>>().concat();
    let joints =
        (1..=count).map(|i| pin(&format!("j{i}"), &name(i - 1), &name(i))).collect::<Vec<_>>().concat();
    let import = opensim::read(&document(&bodies, &joints, "")).expect("a chain");
    assert_eq!(import.figure.links().len(), count);
    // As many unknown parents: the first hundred are told.
    let lost = joints.replace("<socket_parent_frame>/bodyset/b", "<socket_parent_frame>/bodyset/c");
    let error = opensim::read(&document(&bodies, &lost, "")).expect_err("unknown");
    assert_eq!((error.faults.len(), error.omitted), (100, count - 101));
    let frames = (0..count)
        .map(|i| {
            let below = if i == 0 { "/ground".to_owned() } else { format!("../f{}", i - 1) };
            format!("<PhysicalOffsetFrame name=\"f{i}\"><socket_parent>{below}</socket_parent><translation>0 0.001 0</translation></PhysicalOffsetFrame>")
        })
        .collect::<Vec<_>>().concat();
    let pivot = joint(
        "PinJoint",
        "pivot",
        [&format!("f{}", count - 1), "/bodyset/rod"],
        &[],
        &format!("<frames>{frames}</frames>"),
    );
    let import = opensim::read(&document(&body("rod", 1.0), &pivot, "")).expect("frames on frames");
    assert!((import.figure.links()[0].joint().placement().translation.y - 12.0).abs() < 1e-9);
}
