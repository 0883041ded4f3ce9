//! The Denavit-Hartenberg frames of a figure, as a picture.

mod space;

use crate::ViewError;
use crate::chart::{Key, LETTERS, MARGIN, Picture, WIDTH, cut, number};
use nalgebra::{IsometryMatrix3, Point3, Vector3};
use solaris_dynamics::denavit_hartenberg::{Base, DenavitHartenberg, Rationalized};
use solaris_model::Figure;
use space::{Space, Stroke};

/// From where a figure is drawn, and how much of it.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// The direction that points up in the picture (world axes, any length but zero).
    pub up: Vector3<f64>,
    /// Where the viewer stands: an angle about `up` (rad), from the first of the axes x, y, z that is not along `up`.
    pub azimuth: f64,
    /// Indices of the figure's links whose joints are drawn; all where there are none.
    pub links: Vec<usize>,
}

impl View {
    /// The isometric view of the whole figure with `up` up.
    pub fn isometric(up: Vector3<f64>) -> Self {
        Self { up, azimuth: std::f64::consts::FRAC_PI_4, links: Vec::new() }
    }
}

/// Draws the Denavit-Hartenberg frames of `figure` at `q` (length `nq`) as an SVG.
///
/// Rationalised links are numbered from 1. Blue arrows are their axes, z of the frame before; red ones x of their frames.
/// Green lines are the common normals (a), dashed blue ones the offsets along z (s), dotted purple ones the bases `B`. The
/// figure's links are grey. The constants stand below the drawing.
///
/// # Errors
///
/// [`ViewError::Dynamics`]: as for [`DenavitHartenberg::of`] and [`DenavitHartenberg::frames`].
pub fn picture(figure: &Figure, q: &[f64], view: &View) -> Result<String, ViewError> {
    let frames = DenavitHartenberg::of(figure)?;
    let (stands, poses) = (frames.frames(q)?, frames.poses(q)?);
    let is_drawn = |link: usize| view.links.is_empty() || view.links.contains(&link);
    let drawn: Vec<usize> = (0..frames.links.len()).filter(|k| is_drawn(frames.links[*k].joint)).collect();
    let mut space = Space::new(view);
    bones(figure, &poses, &is_drawn, &mut space);
    // Arrows as long as a tenth of what is drawn.
    let arrow = space.extent().max(1e-3) * 0.11;
    for (i, k) in drawn.iter().enumerate() {
        let before = frames.links[*k].parent.map_or_else(IsometryMatrix3::identity, |parent| stands[parent]);
        frame(i + 1, &frames.links[*k], q, &before, &stands[*k], arrow, &mut space);
    }
    let mut picture = Picture::new(&format!("Denavit-Hartenberg frames of {}", figure.name()));
    picture.legend(&Stroke::ALL.map(|(stroke, says)| Key::stroke(stroke.class(), says)));
    space.draw(&mut picture);
    table(&mut picture, figure, &frames, &drawn);
    Ok(picture.finish())
}

/// One rationalised link: its base, its axis, the way from axis to axis, its x.
fn frame(
    number: usize,
    link: &Rationalized,
    q: &[f64],
    before: &IsometryMatrix3<f64>,
    stand: &IsometryMatrix3<f64>,
    arrow: f64,
    space: &mut Space,
) {
    let at_axis = before * link.base.at(q);
    let point = |frame: &IsometryMatrix3<f64>| Point3::from(frame.translation.vector);
    let column = |frame: &IsometryMatrix3<f64>, i: usize| frame.rotation.matrix().column(i).into_owned();
    if link.base != Base::Identity && link.parent.is_some() {
        space.line(point(before), point(&at_axis), Stroke::Base);
    }
    let q = link.coordinate.map_or(0.0, |index| q[index]);
    let s = if link.slides { link.s + q } else { link.s };
    let foot = point(&at_axis) + column(&at_axis, 2) * s;
    space.line(point(&at_axis), foot, Stroke::Offset);
    space.line(foot, point(stand), Stroke::Normal);
    space.arrow(point(&at_axis), column(&at_axis, 2) * arrow, Stroke::Z, &format!("{number}"));
    space.arrow(point(stand), column(stand, 0) * (0.75 * arrow), Stroke::X, &format!("x{number}"));
}

/// The figure's links: from each joint's centre to those after it, and to the tip.
fn bones(
    figure: &Figure,
    poses: &[IsometryMatrix3<f64>],
    is_drawn: &impl Fn(usize) -> bool,
    space: &mut Space,
) {
    let start = |i: usize| {
        let link = &figure.links()[i];
        let before = link.parent().map_or_else(IsometryMatrix3::identity, |parent| poses[parent]);
        before * Point3::from(link.joint().placement().translation.vector)
    };
    for (i, link) in figure.links().iter().enumerate().filter(|(i, _)| is_drawn(*i)) {
        let own = Point3::from(poses[i].translation.vector);
        let mut far = None;
        // What a slide has moved.
        space.line(start(i), own, Stroke::Bone);
        for child in figure.links().iter().enumerate().filter(|(_, other)| other.parent() == Some(i)) {
            if is_drawn(child.0) {
                space.line(own, start(child.0), Stroke::Bone);
                far = far.or_else(|| Some(start(child.0)));
            }
        }
        if let Some(tip) = link.tip().map(|tip| poses[i] * Point3::from(*tip)) {
            space.line(own, tip, Stroke::Bone);
            far = far.or(Some(tip));
        }
        let far = far.unwrap_or_else(|| {
            let com = poses[i] * Point3::from(*link.com());
            space.line(own, com, Stroke::Bone);
            com
        });
        space.name(own, far, link.name());
    }
}

/// Where the columns of the table end, or begin for the second one (px).
const COLUMNS: [f64; 7] = [MARGIN + 18.0, MARGIN + 30.0, 280.0, 346.0, 406.0, 476.0, WIDTH - MARGIN];
/// Height of a row (px).
const ROW: f64 = 18.0;

/// Number, degree of freedom, base and constants of the rationalised links.
fn table(picture: &mut Picture, figure: &Figure, frames: &DenavitHartenberg, drawn: &[usize]) {
    let mut row = |class: &str, cells: [&str; 7]| {
        let y = picture.take(ROW) + LETTERS;
        for (column, (cell, x)) in cells.into_iter().zip(COLUMNS).enumerate() {
            let end = if column == 1 { "" } else { " end" };
            let most = if column == 1 { COLUMNS[2] - COLUMNS[1] - 40.0 } else { WIDTH };
            picture.text(format!("{class}{end}").trim(), (x, y), &cut(cell, LETTERS, most));
        }
    };
    row("bold", ["n", "degree of freedom", "base", "α (°)", "θ⁰ (°)", "a (m)", "s⁰ (m)"]);
    let angle = |angle: f64| rounded(angle.to_degrees(), 1);
    for (i, k) in drawn.iter().enumerate() {
        let link = &frames.links[*k];
        let base = match link.base {
            Base::Identity => "",
            Base::Constant(_) => "B",
            Base::Moved { .. } => "B(q)",
        };
        row(
            "",
            [
                &(i + 1).to_string(),
                &figure.layout().v_names()[*k],
                base,
                &angle(link.alpha),
                &angle(link.theta),
                &rounded(link.a, 3),
                &rounded(link.s, 3),
            ],
        );
    }
}

/// A number with so many decimals, zeros at the end left out.
fn rounded(x: f64, decimals: i32) -> String {
    let scale = 10f64.powi(decimals);
    number((x * scale).round() / scale, 8).replace('-', "\u{2212}")
}
