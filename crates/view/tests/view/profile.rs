//! The picture and the page of a motion curve.

use solaris_profiles::acceleration::Ellipse;
use solaris_profiles::spline::CubicSpline;
use solaris_profiles::{Boundary, Quintic};
use solaris_view::TableRow;
use solaris_view::profile::{Labels, answers, page, svg};

fn labels(title: &str, unit: &str) -> Labels {
    Labels { title: title.to_owned(), unit: unit.to_owned(), ..Labels::default() }
}

fn quintic() -> Quintic {
    Quintic::new(2.0, Boundary::new(0.0, -3.0, 0.0), Boundary::rest(1.2)).expect("a curve")
}

/// The points of all lines of a picture, by panel.
fn lines(svg: &str) -> Vec<&str> {
    svg.split("class=\"line s").skip(1).filter_map(|rest| rest.split('"').nth(2)).collect()
}

#[test]
fn a_picture_has_four_lines_that_stay_in_it() {
    let svg = svg(&quintic(), &labels("quintic", "rad"));
    let lines = lines(&svg);
    assert_eq!(lines.len(), 4);
    for line in lines {
        let numbers: Vec<f64> =
            line.split(['M', 'L', ' ']).filter(|n| !n.is_empty()).map(|n| n.parse().expect(n)).collect();
        assert!((10..600).contains(&numbers.len()), "{} numbers", numbers.len());
        assert!(numbers.iter().all(|n| (0.0..=700.0).contains(n)), "{line}");
    }
    assert!(svg.len() < 12_000, "{} bytes", svg.len());
}

#[test]
fn the_line_is_the_curve() {
    // A parabola of the velocity, as a chain of chords: half way between two points, the curve is within a tenth of a pixel.
    let curve = CubicSpline::clamped(&[(0.0, 0.0), (2.0, 1.0)], 0.0, 0.0).expect("a curve");
    let svg = svg(&curve, &labels("", ""));
    let points: Vec<(f64, f64)> = lines(&svg)[1]
        .split(['M', 'L'])
        .filter_map(|point| point.split_once(' '))
        .map(|(x, y)| (x.parse().expect(x), y.parse().expect(y)))
        .collect();
    let ((left, zero), (right, _)) = (points[0], *points.last().expect("points"));
    let top = points.iter().map(|point| point.1).fold(f64::INFINITY, f64::min);
    let height = |x: f64| {
        let u = (x - left) / (right - left);
        zero + (top - zero) * 4.0 * u * (1.0 - u)
    };
    for pair in points.windows(2) {
        let (x, y) = (0.5 * (pair[0].0 + pair[1].0), 0.5 * (pair[0].1 + pair[1].1));
        assert!((height(x) - y).abs() < 0.1, "at {x}: {y}, not {}", height(x));
    }
}

#[test]
fn jumps_break_the_line() {
    let keys = [(0.0, 5.0), (1.0, 7.0), (2.0, -9.0)];
    let curve = CubicSpline::catmull_rom(&[keys[0], keys[1], keys[2], (3.0, 0.0)]).expect("a curve");
    let svg = svg(&curve, &Labels { keys: keys.to_vec(), ..labels("", "") });
    let pieces: Vec<usize> = lines(&svg).iter().map(|line| line.matches('M').count()).collect();
    // Velocity is continuous, acceleration and jerk jump at both inner keys.
    assert_eq!(pieces, [1, 1, 3, 3]);
    assert_eq!(svg.matches("class=\"jump s").count(), 2);
    assert_eq!(svg.matches("<rect class=\"ink\"").count(), 3);
}

#[test]
fn standstills_are_marked_in_two_panels() {
    let svg = svg(&quintic(), &labels("", ""));
    assert_eq!(svg.matches("<circle class=\"ink\"").count(), 2);
    assert!(svg.contains("● turns round at "), "{svg}");
    let resting = CubicSpline::natural(&[(0.0, 1.5), (2.0, 1.5)]).expect("a curve");
    let svg = crate::profile::svg(&resting, &labels("", ""));
    assert_eq!(svg.matches("class=\"rest\"").count(), 2);
    assert!(svg.contains("zero throughout"));
}

#[test]
fn what_has_no_bound_is_said_and_not_drawn_there() {
    let curve = Ellipse::half(2.0, (0.0, 0.0), 3.0).expect("a curve");
    let svg = svg(&curve, &labels("", ""));
    assert!(svg.contains("unbounded at 0 s"), "{svg}");
    assert!(!svg.contains("inf") && !svg.contains("NaN"), "{svg}");
    let rows = answers(&curve, &labels("", "m"));
    let jerk = rows.iter().find(|row| row.label == "greatest jerk").expect("its row");
    assert_eq!((jerk.value.as_str(), jerk.unit.as_str()), ("unbounded", "m/s³"));
    let page = page(&curve, &labels("", ""));
    assert!(page.contains("null"), "the crosshair knows of it");
}

#[test]
fn numbers_of_any_size_can_be_drawn() {
    for (size, duration) in [(1e-9, 1e-6), (1e9, 1e6), (1e-300, 1.0), (1e300, 1.0)] {
        let curve = CubicSpline::clamped(&[(0.0, -size), (duration, size)], 0.0, 0.0).expect("a curve");
        let svg = svg(&curve, &labels("", "m"));
        assert!(!svg.contains("inf") && !svg.contains("NaN"), "{size}: {svg}");
        assert!(svg.len() < 12_000, "{size}: {} bytes", svg.len());
    }
    let many: Vec<(f64, f64)> = (0..5000).map(|i| (f64::from(i), (f64::from(i) * 0.7).sin())).collect();
    let curve = CubicSpline::catmull_rom(&many).expect("a curve");
    let svg = svg(&curve, &Labels { keys: many, ..labels("", "") });
    assert!(svg.len() < 80_000, "{} bytes", svg.len());
    assert!(svg.contains("■ 5000 keys"));
}

#[test]
fn texts_are_escaped_and_cut() {
    let bad = "<script>alert(1)</script> & \"quotes\"";
    let labels = Labels {
        parameters: bad.repeat(20),
        rows: vec![TableRow::new(bad, bad, "", "")],
        ..labels(bad, bad)
    };
    let (svg, page) = (svg(&quintic(), &labels), page(&quintic(), &labels));
    for text in [&svg, &page] {
        assert!(!text.contains("<script>alert"), "{text}");
        assert!(text.contains('…'), "{text}");
    }
    assert!(!svg.contains("& "), "{svg}");
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let labels = labels("quintic", "rad");
    assert_eq!(svg(&quintic(), &labels), svg(&quintic(), &labels));
    let page_text = page(&quintic(), &labels);
    assert_eq!(page_text, page(&quintic(), &labels));
    assert!(
        page_text.contains(&lines(&svg(&quintic(), &labels))[0].to_owned()),
        "the picture is in the page"
    );
    // The page's style knows its picture.
    assert!(page_text.contains("class=\"solaris-chart solaris-profile\""));
    assert!(page_text.len() < 70_000, "{} bytes", page_text.len());
    // No places of the template are left.
    assert!(!page_text.contains("{{"));
}
