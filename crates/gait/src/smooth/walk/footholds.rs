//! Footholds given one by one: steps from each to the next one, and the ground that they are part of.

use super::course::Step;
use super::terrain::{AROUND, StepKind, Terrain};
use crate::body::LegGeometry;
use crate::body::foot::turned;
use crate::error::{GaitError, RequestError};
use crate::request::pace::range;
use crate::request::{Foothold, STEPS, TURN};
use crate::smooth::slope::{SLOPES, step_length_on_slope};
use nalgebra::Vector3;
use solaris_model::Relief;

/// How far a stone reaches beyond heel and toes (m).
const MARGIN: f64 = 0.03;
/// Stones between whose edges the ground rises no steeper than this (rad) are joined by it; between others it is as low as the lower one.
const JOINED: f64 = 16.0 * std::f64::consts::PI / 180.0;
/// The steepest step (rad): steeper ones are stairs.
const STEEPEST: f64 = 16.0 * std::f64::consts::PI / 180.0;
/// Footholds that lie side by side are one plane to within this (m).
const SAME_PLANE: f64 = 1e-3;
/// Least and greatest distance of the feet to the side (m), and the longest step over the pace's.
const WIDTHS: (f64, f64) = (0.02, 0.30);
const LONGEST: f64 = 1.15;
/// The shortest step over the pace's, and the styles' shortest.
const SHORTEST: f64 = 0.3;
const SHORTEST_STYLE: f64 = 0.5;

/// A foothold in the walk's frame.
struct Print {
    /// Point of the way beside the heel.
    place: Vector3<f64>,
    heel: Vector3<f64>,
    heading: f64,
    pitch: f64,
}

impl Print {
    /// End of the sole along z, at its height.
    fn tip(&self, length: f64) -> [f64; 2] {
        [self.heel.z + length * self.pitch.cos(), self.heel.y + length * self.pitch.sin()]
    }

    /// Height of its plane at a place along z.
    fn plane(&self, z: f64) -> f64 {
        self.heel.y + (z - self.heel.z) * self.pitch.tan()
    }
}

impl Terrain {
    /// From foothold to foothold, for level steps of a pace whose steps are `usual` long and whose feet are `width` apart (m). The right foot goes first;
    /// `mirrored`: everything is the other way. `smoothly`: in the style of the mean slope around each step, in place of its own.
    pub(super) fn on_footholds(
        footholds: &[Foothold],
        leg: &LegGeometry,
        (usual, width): (f64, f64),
        [mirrored, smoothly]: [bool; 2],
    ) -> Result<Self, GaitError> {
        range("footholds", footholds.len() as f64, "", (STEPS.0 as f64, STEPS.1 as f64), String::new)?;
        let length = leg.foot_length();
        let origin = Vector3::zeros();
        let standing = Print { place: origin, heel: origin, heading: 0.0, pitch: 0.0 };
        let mut prints = vec![standing];
        for (i, foothold) in footholds.iter().enumerate() {
            // Odd contacts are the right foot's, which stands on the right.
            let side = if i % 2 == 0 { -1.0 } else { 1.0 };
            let print = print(foothold, side * 0.5 * width, mirrored);
            check(&prints, &print, foothold, (usual, width, length), side)
                .map_err(|why| RequestError::Foothold { number: i + 1, why })?;
            prints.push(print);
        }
        let slopes: Vec<f64> = prints
            .windows(2)
            .map(|pair| {
                let way = pair[1].place - pair[0].place;
                way.y.atan2(way.x.hypot(way.z))
            })
            .collect();
        let around = |k: usize| {
            let (before, after) = (slopes[k.saturating_sub(1)], slopes[(k + 1).min(slopes.len() - 1)]);
            0.25 * (before + 2.0 * slopes[k] + after)
        };
        let (mut steps, mut kinds) = (Vec::new(), Vec::new());
        for (k, pair) in prints.windows(2).enumerate() {
            let [before, next] = pair else { continue };
            let way = next.place - before.place;
            let (ahead, rise) = (way.x.hypot(way.z), way.y);
            let slope = if smoothly { around(k) } else { slopes[k] };
            // In the style of level steps that are as long for the pace as this one is for the slope.
            let part = ahead / (usual * step_length_on_slope(slope));
            kinds.push(StepKind::Slope(slope, usual * part.clamp(SHORTEST_STYLE, 1.0)));
            steps.push(Step {
                bearing: way.x.atan2(way.z) - before.heading,
                rise,
                tilt: next.pitch,
                ..Step::along_an_arc(0, ahead, next.heading - before.heading)
            });
        }
        let relief = Relief::new(ground(&prints, length)).map_err(RequestError::Relief)?;
        Ok(Self { relief, steps, kinds, standing: 0.0 })
    }
}

fn print(foothold: &Foothold, beside: f64, mirrored: bool) -> Print {
    let sign = if mirrored { -1.0 } else { 1.0 };
    let heading = sign * foothold.heading;
    let across = turned(heading, &Vector3::x()) * beside;
    let x = foothold.x.map_or(beside, |x| sign * x);
    let heel = Vector3::new(x, foothold.height, foothold.z);
    Print { place: heel - across, heel, heading, pitch: foothold.pitch }
}

/// Whether a foot can be set on the next foothold at all; why not.
fn check(
    prints: &[Print],
    next: &Print,
    foothold: &Foothold,
    (usual, width, length): (f64, f64, f64),
    side: f64,
) -> Result<(), String> {
    let Foothold { x, z, height, pitch, heading } = *foothold;
    if ![x.unwrap_or(0.0), z, height, pitch, heading].iter().all(|number| number.is_finite()) {
        return Err(format!(
            "x {}, z {z}, height {height}, pitch {pitch}, heading {heading}; all must be finite numbers",
            x.map_or_else(|| "none".to_owned(), |x| x.to_string())
        ));
    }
    let before = &prints[prints.len() - 1];
    let (lower, upper) = SLOPES;
    if !(lower - 1e-9..=upper + 1e-9).contains(&pitch) {
        return Err(format!("its pitch is {:.1}°; soles stand on −15 to 15°", pitch.to_degrees()));
    }
    if heading != 0.0 && pitch != 0.0 {
        return Err(format!(
            "it is turned by {:.0}° and pitched by {:.0}°: a slope across the way is not planned yet; leave one of them out",
            heading.to_degrees(),
            pitch.to_degrees()
        ));
    }
    let turn = next.heading - before.heading;
    if turn.abs() > TURN + 1e-9 {
        return Err(format!(
            "it is turned by {:.0}° against the one before; a step turns by {:.0}° at most",
            turn.to_degrees(),
            TURN.to_degrees()
        ));
    }
    let way = next.place - before.place;
    let ahead = turned(-before.heading, &way).z;
    let (shortest, longest) = (SHORTEST * usual, LONGEST * usual);
    if !(shortest..=longest).contains(&ahead) {
        return Err(format!(
            "it is {ahead:.3} m ahead of the one before; at this pace {shortest:.2} to {longest:.2} m are stepped"
        ));
    }
    // Between the two heels, to the side that the foot is on.
    let first = Vector3::x() * (-side * 0.5 * width);
    let heel = if prints.len() == 1 { first } else { before.heel };
    let apart = side * turned(-0.5 * (before.heading + next.heading), &(next.heel - heel)).x;
    if !(WIDTHS.0..=WIDTHS.1).contains(&apart) {
        return Err(format!(
            "its heel is {:.0} mm beside that of the other foot, on its own side; {:.0} to {:.0} mm are stepped",
            apart * 1e3,
            WIDTHS.0 * 1e3,
            WIDTHS.1 * 1e3
        ));
    }
    let climb = way.y.atan2(ahead);
    if climb.abs() > STEEPEST {
        return Err(format!(
            "it lies {:.0}° above the one before, seen from there; steps go up or down by 16° at most, steeper ones on stairs",
            climb.to_degrees()
        ));
    }
    let [tip, _] = before.tip(length);
    let apart = |z: f64| (next.plane(z) - before.plane(z)).abs();
    if next.heel.z < tip && apart(next.heel.z).max(apart(tip)) > SAME_PLANE {
        return Err(format!(
            "it begins at {:.3} m, before the one before it ends at {tip:.3} m, and lies in another plane; make the step as long as a foot, \
             {length:.2} m",
            next.heel.z
        ));
    }
    Ok(())
}

/// The ground under the footholds and between them: each goes on a little beyond heel and toes; where the next one is not near to the same line it falls to the
/// lower one of both.
fn ground(prints: &[Print], length: f64) -> Vec<[f64; 2]> {
    let mut points = vec![[-AROUND, 0.0], [0.0, 0.0]];
    for (k, print) in prints.iter().enumerate() {
        let [tip, top] = print.tip(length);
        let Some(next) = prints.get(k + 1) else {
            points.extend([[tip, top], [tip + MARGIN, print.plane(tip + MARGIN)]]);
            break;
        };
        if next.heel.z < tip {
            // The same plane.
            continue;
        }
        let margin = MARGIN.min(0.4 * (next.heel.z - tip));
        let ends = [tip + margin, next.heel.z - margin];
        let [from, to] = [print.plane(ends[0]), next.plane(ends[1])];
        points.extend([[tip, top], [ends[0], from]]);
        if (to - from).atan2(ends[1] - ends[0]).abs() > JOINED {
            let low = from.min(to);
            points.extend([[ends[0], low], [ends[1], low]]);
        }
        points.extend([[ends[1], to], [next.heel.z, next.heel.y]]);
    }
    let last = points[points.len() - 1];
    points.push([last[0] + AROUND, last[1]]);
    points
}
