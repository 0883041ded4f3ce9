//! Postures side by side as stick figures, with their angles, and how much room the inequalities leave.

use crate::chart::{LETTERS, MARGIN, Picture, Point, WIDTH, cut, width};

/// A stick figure.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stick {
    /// What the posture is called.
    pub name: String,
    /// Its lines.
    pub lines: Vec<StickLine>,
    /// Its angles, by symbol: `("α", "17.1°")`.
    pub angles: Vec<(String, String)>,
}

/// A line of a stick figure.
#[derive(Clone, Debug, PartialEq)]
pub struct StickLine {
    /// Which part of the body it is.
    pub part: StickPart,
    /// Forward and up (m).
    pub points: Vec<[f64; 2]>,
}

/// Part of a stick figure: what its line looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StickPart {
    /// The leg that stands.
    Stance,
    /// The leg that swings.
    Swing,
    /// Trunk and neck.
    Trunk,
    /// The arm of the side that stands.
    StanceArm,
    /// The arm of the side that swings.
    SwingArm,
    /// The head: its middle, and a point of its outline.
    Head,
}

/// An inequality and its room.
#[derive(Clone, Debug, PartialEq)]
pub struct Room {
    /// What it says: `(i) χ < α`.
    pub text: String,
    /// The lesser and the greater side: `15.89° < 17.08°`.
    pub sides: String,
    /// Room: `1.18°`.
    pub room: String,
    /// The room against the greatest that is drawn, 0 to 1; less than nothing fails.
    pub share: f64,
}

/// The greatest height of the stick figures (px).
const TALLEST: f64 = 300.0;
/// Least free space beside a stick figure, and least width for one (px).
const BESIDE: (f64, f64) = (8.0, 60.0);
/// Height of a line of text (px).
const LINE: f64 = 17.0;

/// Stick figures side by side on one ground and in one scale, their angles below, then the inequalities with bars, as an SVG.
///
/// The same postures give the same text, byte for byte.
pub fn postures(sticks: &[Stick], rooms: &[Room], title: &str) -> String {
    let mut picture = Picture::new(title);
    if !sticks.is_empty() {
        let columns = Columns::of(sticks);
        figures(&mut picture, sticks, &columns);
        angles(&mut picture, sticks, &columns);
    }
    if !rooms.is_empty() {
        picture.heading("Room that the inequalities leave");
        for room in rooms {
            bar(&mut picture, room);
        }
    }
    picture.finish()
}

/// Where the stick figures stand.
struct Columns {
    /// Middle of each, and its middle in m.
    middles: Vec<(f64, f64)>,
    /// Width of each (px).
    widths: Vec<f64>,
    /// Pixels a metre.
    scale: f64,
    /// Height of the tallest (px).
    height: f64,
}

impl Columns {
    fn of(sticks: &[Stick]) -> Self {
        let left = left_of_values(sticks);
        let spans: Vec<(f64, f64)> = sticks.iter().map(span).collect();
        let points = || sticks.iter().flat_map(|stick| stick.lines.iter().flat_map(|line| &line.points));
        let top = points().map(|point| point[1]).fold(1e-3, f64::max) * 1.06;
        let free = WIDTH - MARGIN - left;
        let wide = |scale: f64| -> Vec<f64> {
            spans.iter().map(|(a, b)| ((b - a) * scale + 2.0 * BESIDE.0).max(BESIDE.1)).collect()
        };
        // As large as there is room for.
        let scales = (0..200).map(|i| TALLEST / top * 0.98_f64.powi(i));
        let fits = |scale: &f64| wide(*scale).iter().sum::<f64>() <= free;
        let scale = scales.clone().find(fits).or(scales.clone().next_back()).unwrap_or(1.0);
        let mut widths = wide(scale);
        let more = (free - widths.iter().sum::<f64>()).max(0.0) / widths.len() as f64;
        for width in &mut widths {
            *width += more;
        }
        let mut from = left;
        let middles = spans.iter().zip(&widths).map(|((a, b), width)| {
            from += width;
            (from - 0.5 * width, 0.5 * (a + b))
        });
        Self { middles: middles.collect(), widths, scale, height: top * scale }
    }
}

/// Where the angles' names end and their values begin (px).
fn left_of_values(sticks: &[Stick]) -> f64 {
    let names = sticks.iter().flat_map(|stick| &stick.angles).map(|(name, _)| width(name, LETTERS));
    MARGIN + names.fold(0.0, f64::max)
}

/// How far a stick figure reaches backward and forward.
fn span(stick: &Stick) -> (f64, f64) {
    let along = stick.lines.iter().flat_map(|line| line.points.iter().map(|point| point[0]));
    let (least, most) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    if least <= most { (least, most) } else { (0.0, 0.0) }
}

/// The stick figures, their names above, on their ground.
fn figures(picture: &mut Picture, sticks: &[Stick], columns: &Columns) {
    let names = picture.take(LINE + 8.0) + LETTERS;
    let floor = picture.take(columns.height + 6.0) + columns.height;
    picture.line("zero", &[(MARGIN, floor), (WIDTH - MARGIN, floor)]);
    for ((stick, (middle, centre)), wide) in sticks.iter().zip(&columns.middles).zip(&columns.widths) {
        picture.text("bold middle", (*middle, names), &cut(&stick.name, 1.1 * LETTERS, wide - 2.0));
        let at = |point: &[f64; 2]| {
            (middle + (point[0] - centre) * columns.scale, floor - point[1] * columns.scale)
        };
        stick.lines.iter().for_each(|line| draw(picture, line, &at));
    }
}

fn draw(picture: &mut Picture, line: &StickLine, at: &dyn Fn(&[f64; 2]) -> Point) {
    let (class, is_leg) = match line.part {
        StickPart::Stance => ("limb s0", true),
        StickPart::Swing => ("limb s1", true),
        StickPart::Trunk => ("limb body", false),
        StickPart::StanceArm => ("arm s0", false),
        StickPart::SwingArm => ("arm s1", false),
        StickPart::Head => ("arm body", false),
    };
    let points: Vec<Point> = line.points.iter().map(at).collect();
    if let (StickPart::Head, [middle, edge]) = (line.part, &points[..]) {
        picture.circle(class, *middle, (middle.0 - edge.0).hypot(middle.1 - edge.1));
        return;
    }
    picture.line(class, &points);
    let joint = class.replace("limb", "hollow");
    for point in points.iter().take(points.len().saturating_sub(1)).filter(|_| is_leg) {
        picture.circle(&joint, *point, 3.6);
    }
}

/// The angles of each posture below it, rows of the same name once.
fn angles(picture: &mut Picture, sticks: &[Stick], columns: &Columns) {
    let mut names: Vec<&str> = Vec::new();
    for (name, _) in sticks.iter().flat_map(|stick| &stick.angles) {
        if !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    for name in names {
        let y = picture.take(LINE) + LETTERS;
        picture.text("italic", (MARGIN, y), name);
        for (stick, (middle, _)) in sticks.iter().zip(&columns.middles) {
            if let Some((_, value)) = stick.angles.iter().find(|angle| angle.0 == name) {
                // Decimal points one below the other.
                picture.text("end", (middle + 20.0, y), &value.replace('-', "−"));
            }
        }
    }
}

/// The longest bar (px).
const BAR: f64 = 300.0;

/// An inequality: what it says; below, a bar for its room, and its sides.
fn bar(picture: &mut Picture, room: &Room) {
    let top = picture.take(2.0 * LINE + 2.0);
    picture.text("", (MARGIN, top + LETTERS), &cut(&room.text, LETTERS, WIDTH - 2.0 * MARGIN));
    let (bar, line) = (top + LINE + 1.0, top + LINE + 10.0);
    let (area, text) = if room.share > 0.0 { ("f2", "t2") } else { ("f1", "t1") };
    let length = BAR * room.share.abs().clamp(0.004, 1.0);
    picture.rect(area, (MARGIN, bar), (length, 9.0));
    picture.text(text, (MARGIN + length + 6.0, line), &room.room);
    picture.text("soft end", (WIDTH - MARGIN, line), &room.sides);
}
