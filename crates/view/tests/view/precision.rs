//! The picture and the page of precision against work.

use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
use solaris_modes::study::{StudyOptions, study};
use solaris_modes::{Method, Rule, Settings, Simulation};
use solaris_view::precision::{Against, Diagram, Point, Report, Series, Table, page, report, svg};

fn point(label: &str, work: f64, error: Option<f64>) -> Point {
    Point { label: label.to_owned(), seconds: Some(work * 2e-6), evaluations: Some(work), error }
}

/// What a stiff scene looks like: explicit rules fail until they are stable.
fn stiff() -> Diagram {
    let fixed = |name: &str, per_step: f64, order: i32| {
        let points = [1e-2, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5].map(|step: f64| {
            let error = (step < 3.4e-4).then(|| (30.0 * step).powi(order) * 1e-2 + 2e-11);
            point(&format!("{step:.0e} s"), per_step * 10.0 / step, error)
        });
        Series { name: name.to_owned(), points: points.into() }
    };
    let adaptive = |name: &str, work: &dyn Fn(f64) -> f64| {
        let points = [1e-4, 1e-6, 1e-8, 1e-10].map(|tolerance| {
            point(&format!("{tolerance:.0e}"), work(tolerance), Some(0.1 * tolerance + 2e-11))
        });
        Series { name: name.to_owned(), points: points.into() }
    };
    Diagram {
        title: "governor.ron: precision against work".to_owned(),
        subtitle: "worst position of all frames over 10 s, against the stiff method at 1e-11".to_owned(),
        error: "positions (rad or m)".to_owned(),
        series: vec![
            fixed("explicit Euler", 1.0, 1),
            fixed("semi-implicit Euler", 1.0, 1),
            fixed("constant acceleration", 1.0, 1),
            fixed("Runge-Kutta 4", 4.0, 4),
            adaptive("adaptive", &|tolerance| 1e5 * (1.0 + 1e-3 * tolerance.powf(-0.25))),
            adaptive("stiff", &|tolerance| 600.0 * tolerance.powf(-0.18)),
        ],
        wanted: Some(1e-6),
        floor: Some(1e-10),
    }
}

fn sample() -> Report {
    let row = |cells: &[&str]| cells.iter().map(|cell| (*cell).to_owned()).collect::<Vec<_>>();
    Report {
        diagram: stiff(),
        findings: vec![
            "For errors up to 1e-6: stiff at a tolerance of 1e-6, 7 211 evaluations, 0.014 s.".to_owned(),
            "Explicit methods are held to steps below 3.4e-4 s by the stiffest eigenvalue, −8117 1/s."
                .to_owned(),
        ],
        tables: vec![Table {
            title: "All settings".to_owned(),
            note: "Times are the best of three.".to_owned(),
            header: row(&["setting", "evaluations", "seconds", "error"]),
            rows: vec![
                row(&["Runge-Kutta 4, 1e-2 s", "at t = 0.03 s: a step of 1.00e-2 s is too long <for it>"]),
                row(&["stiff, 1e-6", "7 211", "0.014", "1.1e-7"]),
            ],
            marked: vec![1],
        }],
    }
}

/// The lines of the series.
fn lines(picture: &str) -> Vec<&str> {
    picture.lines().filter(|line| line.starts_with("<path class=\"line")).collect()
}

/// The numbers of an element's attribute.
fn numbers(element: &str, attribute: &str) -> Vec<f64> {
    let value = element.split(&format!("{attribute}=\"")).nth(1).and_then(|rest| rest.split('"').next());
    let numbers = value.unwrap_or_default().split(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | '-')));
    numbers.filter_map(|number| number.parse().ok()).collect()
}

/// A tenth of the error is as far down as a tenth of the work is to the left, at the scale of the axes: 10 decades up, 4 across.
#[test]
fn both_axes_are_logarithmic() {
    let points = [(1e2, 1e-1), (1e4, 1e-6), (1e6, 1e-11)];
    let points = points.map(|(work, error)| point("x", work, Some(error))).into();
    let diagram = Diagram { series: vec![Series { name: "one".to_owned(), points }], ..Diagram::default() };
    let picture = svg(&diagram, Against::Evaluations);
    let line = numbers(lines(&picture)[0], " d");
    assert!((line[2] - 0.5 * (line[0] + line[4])).abs() < 0.02, "{line:?}");
    assert!((line[3] - 0.5 * (line[1] + line[5])).abs() < 0.02, "{line:?}");
    assert!(line[4] > line[0] + 400.0 && line[5] > line[1] + 250.0, "{line:?}");
}

/// No label covers another one, or a mark.
#[test]
fn settings_keep_off_each_other() {
    let picture = svg(&stiff(), Against::Evaluations);
    let labels: Vec<(f64, f64, f64)> = picture
        .lines()
        .filter(|line| line.contains("class=\"small over t"))
        .map(|line| {
            let text = line.split('>').nth(1).and_then(|text| text.split('<').next()).unwrap_or_default();
            (numbers(line, " x")[0], numbers(line, " y")[0], 5.0 * text.chars().count() as f64)
        })
        .collect();
    assert!(labels.len() > 15, "{}", labels.len());
    let marks: Vec<(f64, f64)> = picture
        .lines()
        .filter(|line| line.starts_with("<path class=\"mark"))
        .map(|line| numbers(line, "transform"))
        .map(|at| (at[0], at[1]))
        .collect();
    for (i, (x, y, width)) in labels.iter().enumerate() {
        for (u, v, _) in &labels[i + 1..] {
            assert!((y - v).abs() > 10.0 || *u > x + width || u + width < *x, "{x} {y} and {u} {v}");
        }
        assert!(!marks.iter().any(|(u, v)| (x..=&(x + width)).contains(&u) && (y - 9.0..=*y).contains(v)));
    }
}

#[test]
fn the_picture_is_of_plain_numbers_and_the_same_each_time() {
    for against in [Against::Seconds, Against::Evaluations] {
        let picture = svg(&stiff(), against);
        assert_eq!(picture, svg(&stiff(), against));
        assert!(
            !picture.contains("NaN") && !picture.contains("inf\"") && !picture.contains("infs"),
            "{picture}"
        );
        for series in &stiff().series {
            assert!(picture.contains(&format!(">{}</text>", series.name)), "{}", series.name);
        }
    }
}

/// Two settings of each fixed rule are too long for a governor: crosses, and no line through them.
#[test]
fn what_failed_is_crossed_and_not_joined() {
    let picture = svg(&stiff(), Against::Evaluations);
    assert_eq!(picture.matches("class=\"failed").count(), 8);
    assert_eq!(picture.matches("no result</title>").count(), 8);
    let lines = lines(&picture);
    assert_eq!(lines.len(), 6);
    assert!(lines.iter().all(|line| line.matches("d=\"M").count() == 1), "{lines:?}");
    let by_rule = lines[3].matches(['M', 'L']).count();
    assert_eq!(by_rule, 4, "{}", lines[3]);
}

#[test]
fn a_gap_in_a_series_is_a_gap_in_its_line() {
    let points = [Some(1e-2), None, Some(1e-4), Some(1e-5)];
    let points = points.into_iter().zip([1.0, 10.0, 100.0, 1000.0]);
    let points = points.map(|(error, work)| point("x", work, error)).collect();
    let diagram = Diagram { series: vec![Series { name: "one".to_owned(), points }], ..Diagram::default() };
    let picture = svg(&diagram, Against::Evaluations);
    let line = lines(&picture)[0];
    assert_eq!((line.matches('M').count(), line.matches('L').count()), (2, 1), "{line}");
}

#[test]
fn nothing_at_all_is_still_a_picture() {
    let picture = svg(&Diagram::default(), Against::Seconds);
    assert!(picture.ends_with("</svg>\n") && !picture.contains("NaN"));
    let odd = [Some(0.0), Some(f64::NAN), Some(f64::INFINITY), Some(1e300)];
    let points = odd.map(|error| point("odd", f64::INFINITY, error)).into();
    let diagram = Diagram { series: vec![Series { name: String::new(), points }], ..Diagram::default() };
    assert!(!svg(&diagram, Against::Evaluations).contains("NaN"));
}

#[test]
fn the_page_needs_nothing_else_and_escapes_what_it_shows() {
    let html = page(&sample());
    assert_eq!(html, page(&sample()));
    assert!(html.starts_with("<!doctype html>") && html.contains("default-src 'none'"));
    assert!(html.contains("&lt;for it&gt;") && !html.contains("<for it>") && !html.contains("{{"));
    assert!(html.contains("<td class=\"across\" colspan=\"3\">") && html.contains("<tr class=\"marked\">"));
    assert_eq!(html.matches("<svg ").count(), 2);
    assert!(!html.contains("<script"));
}

/// Without a clock there is one picture only.
#[test]
fn times_that_nobody_took_are_not_drawn() {
    let mut report = sample();
    report
        .diagram
        .series
        .iter_mut()
        .flat_map(|series| &mut series.points)
        .for_each(|point| point.seconds = None);
    assert_eq!(page(&report).matches("<svg ").count(), 1);
}

/// A study as it comes from the library: a pendulum by two rules, of which one explodes.
#[test]
fn a_study_is_told_with_its_recommendation_first() {
    let bob = Vector3::new(0.0, -1.0, 0.0);
    let link = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(1.0).com(bob);
    let figure = FigureBuilder::new("pendulum").link(link).build().expect("a figure");
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    simulation.set_start(&[1.0], &[0.0]).expect("a state");
    let fixed = |rule, step| Method::Fixed { rule, step };
    let methods = vec![
        fixed(Rule::ExplicitEuler, 1e-3),
        fixed(Rule::RungeKutta4, 1e-2),
        fixed(Rule::RungeKutta4, 1e-3),
        fixed(Rule::RungeKutta4, 1e-6),
    ];
    let options = StudyOptions { methods, evaluations: 100_000, ..StudyOptions::default() };
    let settings = Settings::new(1.0, 100.0);
    let study = study(&simulation, &settings, &options, &mut (), &mut |_| {}).expect("a study");
    let report = report(&study, "pendulum", 1.0, 100.0);
    let first = &report.findings[0];
    assert_eq!(first, "For errors up to 1e-6: Runge-Kutta 4, 1e-2 s (500 evaluations).");
    assert!(report.findings.iter().any(|it| it.starts_with("1 of 4 settings")), "{:?}", report.findings);
    let series: Vec<usize> = report.diagram.series.iter().map(|series| series.points.len()).collect();
    assert_eq!(series, [1, 3]);
    // What had too many evaluations is drawn where it would have been.
    let last = &report.diagram.series[1].points[2];
    assert_eq!((last.evaluations, last.error), (Some(4e6), None));
    let titles: Vec<&str> = report.tables.iter().map(|table| table.title.as_str()).collect();
    assert_eq!(titles, ["Which setting for which error", "Every setting", "What leaving out saves"]);
    assert!(page(&report).contains("evaluations of the dynamics are spent"));
}
