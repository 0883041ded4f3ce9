//! A drawing of the frames of a figure.

mod canvas;

use super::summary::{length, short};
use super::{Base, DenavitHartenberg, Rationalized};
use crate::error::DynamicsError;
use canvas::{Canvas, Row, Stroke};
use nalgebra::{IsometryMatrix3, Point3, Vector3};
use solaris_model::Figure;

/// From where a figure is drawn, and how much of it.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// The direction that points up in the picture (world axes, any length but zero).
    pub up: Vector3<f64>,
    /// Where the viewer stands: an angle about `up` (rad), from the first of the axes x, y, z that is not along `up`.
    pub azimuth: f64,
    /// Indices of the figure's links whose joints are drawn; all where there are none.
    pub links: Vec<usize>,
    /// Width of the drawing (pixels), without the table beside it.
    pub width: f64,
}

impl View {
    /// The isometric view of the whole figure with `up` up.
    pub fn isometric(up: Vector3<f64>) -> Self {
        Self { up, azimuth: std::f64::consts::FRAC_PI_4, links: Vec::new(), width: 460.0 }
    }
}

/// Draws the Denavit-Hartenberg frames of `figure` at `q` (length `nq`) as an SVG document.
///
/// Rationalised links are numbered from 1. Blue arrows are their axes, z of the frame before; red ones x of their frames.
/// Green lines are the common normals (a), dashed blue ones the offsets along z (s), dashed violet ones the bases `B`. The
/// figure's links are grey. The constants stand beside the drawing.
///
/// # Errors
///
/// As for [`DenavitHartenberg::of`] and [`DenavitHartenberg::frames`].
pub fn picture(figure: &Figure, q: &[f64], view: &View) -> Result<String, DynamicsError> {
    let frames = DenavitHartenberg::of(figure)?;
    let (stands, poses) = (frames.frames(q)?, frames.poses(q)?);
    let is_drawn = |link: usize| view.links.is_empty() || view.links.contains(&link);
    let drawn: Vec<usize> = (0..frames.links.len()).filter(|k| is_drawn(frames.links[*k].joint)).collect();
    let mut canvas = Canvas::new(view);
    bones(figure, &poses, &is_drawn, &mut canvas);
    // Arrows as long as a tenth of what is drawn.
    let arrow = canvas.extent().max(1e-3) * 0.11;
    for (i, k) in drawn.iter().enumerate() {
        let before = frames.links[*k].parent.map_or_else(IsometryMatrix3::identity, |parent| stands[parent]);
        frame(i + 1, &frames.links[*k], q, &before, &stands[*k], arrow, &mut canvas);
    }
    let rows: Vec<Row> = drawn.iter().enumerate().map(|(i, k)| row(i + 1, &frames, *k)).collect();
    Ok(canvas.finish(&format!("Denavit-Hartenberg frames of {}", figure.name()), &rows))
}

/// One rationalised link: its base, its axis, the way from axis to axis, its x.
fn frame(
    number: usize,
    link: &Rationalized,
    q: &[f64],
    before: &IsometryMatrix3<f64>,
    stand: &IsometryMatrix3<f64>,
    arrow: f64,
    canvas: &mut Canvas,
) {
    let at_axis = before * link.base.at(q);
    let point = |frame: &IsometryMatrix3<f64>| Point3::from(frame.translation.vector);
    let column = |frame: &IsometryMatrix3<f64>, i: usize| frame.rotation.matrix().column(i).into_owned();
    if link.base != Base::Identity && link.parent.is_some() {
        canvas.line(point(before), point(&at_axis), Stroke::Base);
    }
    let q = link.coordinate.map_or(0.0, |index| q[index]);
    let s = if link.slides { link.s + q } else { link.s };
    let foot = point(&at_axis) + column(&at_axis, 2) * s;
    canvas.line(point(&at_axis), foot, Stroke::Offset);
    canvas.line(foot, point(stand), Stroke::Normal);
    canvas.arrow(point(&at_axis), column(&at_axis, 2) * arrow, Stroke::Z, &format!("{number}"));
    canvas.arrow(point(stand), column(stand, 0) * (0.75 * arrow), Stroke::X, &format!("x{number}"));
}

/// The figure's links: from each joint's centre to those after it, and to the tip.
fn bones(
    figure: &Figure,
    poses: &[IsometryMatrix3<f64>],
    is_drawn: &impl Fn(usize) -> bool,
    canvas: &mut Canvas,
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
        canvas.line(start(i), own, Stroke::Bone);
        for child in figure.links().iter().enumerate().filter(|(_, other)| other.parent() == Some(i)) {
            if is_drawn(child.0) {
                canvas.line(own, start(child.0), Stroke::Bone);
                far = far.or_else(|| Some(start(child.0)));
            }
        }
        if let Some(tip) = link.tip().map(|tip| poses[i] * Point3::from(*tip)) {
            canvas.line(own, tip, Stroke::Bone);
            far = far.or(Some(tip));
        }
        let far = far.unwrap_or_else(|| {
            let com = poses[i] * Point3::from(*link.com());
            canvas.line(own, com, Stroke::Bone);
            com
        });
        canvas.name(own, far, link.name());
    }
}

/// Number, name and constants.
fn row(index: usize, frames: &DenavitHartenberg, k: usize) -> Row {
    let link = &frames.links[k];
    let base = match link.base {
        Base::Identity => "",
        Base::Constant(_) => "B",
        Base::Moved { .. } => "B(q)",
    };
    let minus = |text: String| text.replace('-', "\u{2212}");
    [
        index.to_string(),
        frames.v_names[k].clone(),
        base.to_owned(),
        minus(short(link.alpha.to_degrees(), 1)),
        minus(short(link.theta.to_degrees(), 1)),
        minus(length(link.a, 3)),
        minus(length(link.s, 3)),
    ]
}
