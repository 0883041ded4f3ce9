//! Lints: what is suspicious about a figure though it is valid.

mod inertia;
mod mass;
mod mirror;
mod neutral;
pub(crate) mod sides;

use crate::figure::Figure;
use crate::joint::AxisKind;
use crate::limits::MANY_TURNS;
pub use mass::MassDoubt;
use nalgebra::Vector3;
use neutral::Neutral;
use solaris_text::{Finding, FindingKind};

/// The mass of a figure and its extent at its zero pose: every coordinate zero but those that follow others.
#[doc(alias = "bounding box")]
#[doc(alias = "height")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Total mass (kg).
    pub mass: f64,
    /// The standing height that the figure was made for (m), if it was said.
    pub stature: Option<f64>,
    /// From the lowest to the highest point along the direction that was called up (m).
    pub height: f64,
}

impl Figure {
    /// The figure's mass and how far its shapes, joints, tips and soles reach along `up`, at its zero pose, in world axes.
    ///
    /// `up` may have any length but zero; against gravity is up. Links without a shape reach as far as their points.
    ///
    /// ```
    /// use solaris_model::{Vector3, human};
    /// let extent = human(1.75, 73.0)?.extent(&Vector3::y());
    /// assert_eq!((extent.mass, extent.stature), (73.0, Some(1.75)));
    /// # Ok::<(), solaris_model::HumanError>(())
    /// ```
    pub fn extent(&self, up: &Vector3<f64>) -> Extent {
        let up = up.try_normalize(0.0).unwrap_or_else(Vector3::y);
        let neutral = Neutral::of(self);
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut reach = |at: f64, by: f64| (low, high) = (low.min(at - by), high.max(at + by));
        for (i, link) in self.links.iter().enumerate() {
            // The frame of a link that carries nothing says nothing about how far the figure reaches.
            let mut points: Vec<Vector3<f64>> = link.sole.iter().map(|point| point.position).collect();
            points.extend(link.tip);
            points.extend((link.mass > 0.0 || link.parent.is_some()).then(Vector3::zeros));
            for point in &points {
                reach(neutral.point(i, point).dot(&up), 0.0);
            }
            if let Some(shape) = &link.shape {
                let place = neutral.places[i] * shape.placement;
                let along = place.rotation.inverse() * up;
                reach(place.translation.vector.dot(&up), shape.kind.reach(&along));
            }
        }
        Extent { mass: self.mass(), stature: self.stature, height: (high - low).max(0.0) }
    }

    /// The findings about what is suspicious in the figure, though it is valid; empty where nothing is.
    ///
    /// | looks wrong | rule |
    /// |---|---|
    /// | mass | an inertia that no mass distribution has, inertia without mass, a joint that moves nothing: [`Figure::mass_doubts`] |
    /// | density | mass over the volume of a link's shape outside 300–3000 kg/m³ |
    /// | limits | a range of one value; one that excludes the zero pose; an angle of more than two turns |
    /// | centre of mass | outside of the box round the link's shape, which then is not all of the link and not asked for more |
    /// | inertia of a link with a shape | more spread along an axis of its box than any mass inside can be; for another shape, more spread than its largest half; less than a hundredth of the uniform solid's |
    /// | inertia of a link without one | a radius of gyration of more than three times the way from the centre of mass to the farthest joint, tip, sole point or frame |
    /// | products of inertia | as large as they can be: no extension at all along an oblique axis |
    /// | left and right | mass, inertia, centre of mass or joint origin that are not mirror images to 1e-6 |
    ///
    /// These are [`FindingKind::Suspect`]; a link of one side that has no partner is a [`FindingKind::Note`].
    ///
    /// Shapes may be drawings: a link that is drawn slimmer than it is has a high density. Left and right are told by
    /// their names (`left_`, `l_`, `_l`, `.L`, `Left`, `L` and the like) and compared at the zero pose, along the root's
    /// axes, since the frames of left and right links may be turned against each other. The plane of symmetry is square
    /// to that of the root's axes for which most pairs' joints are mirror images; where none serves most of them, each
    /// pair may be symmetric to any axis of the link that carries both.
    ///
    /// The subject of each is a link's name, or for limits that of a degree of freedom; limits come first, then
    /// masses, links in order, then pairs.
    #[doc(alias = "validate")]
    #[doc(alias = "check")]
    pub fn lint(&self) -> Vec<Finding> {
        let neutral = Neutral::of(self);
        let mut findings = Vec::new();
        limits(self, &neutral, &mut findings);
        findings.extend(self.mass_doubts().iter().map(MassDoubt::finding));
        inertia::check(self, &mut findings);
        mirror::check(self, &neutral, &mut findings);
        findings
    }
}

fn limits(figure: &Figure, neutral: &Neutral, findings: &mut Vec<Finding>) {
    for (link, at) in figure.links.iter().zip(figure.layout.joints()) {
        for (k, dof) in link.joint.kind.axes().iter().enumerate() {
            let Some(range) = dof.limits else { continue };
            let (name, zero) = (&figure.layout.v_names()[at.v + k], neutral.q[at.q + k]);
            let far = [range.lower, range.upper]
                .into_iter()
                .any(|limit| limit.is_finite() && limit.abs() > MANY_TURNS);
            if far && dof.axis.kind == AxisKind::Rotation {
                findings.push(suspect(
                    name,
                    format!(
                        "its limits {} to {} rad are several turns; if these are degrees, turn them into radians (in a figure's \
                         text, write deg(…))",
                        short(range.lower),
                        short(range.upper)
                    ),
                ));
            }
            if range.lower >= range.upper {
                findings.push(suspect(
                    name,
                    format!(
                        "its limits are both {}, so that it cannot move; weld it, or give it a range",
                        short(range.lower)
                    ),
                ));
            } else if !(range.lower..=range.upper).contains(&zero) {
                let pose = if dof.follows.is_some() {
                    "where it follows to at the zero pose"
                } else {
                    "the zero pose"
                };
                findings.push(suspect(
                    name,
                    format!(
                        "its limits {} to {} exclude {}, {pose}",
                        short(range.lower),
                        short(range.upper),
                        short(zero)
                    ),
                ));
            }
        }
    }
}

fn suspect(subject: &str, message: String) -> Finding {
    Finding { kind: FindingKind::Suspect, subject: subject.to_owned(), message, place: None }
}

fn note(subject: &str, message: String) -> Finding {
    Finding { kind: FindingKind::Note, ..suspect(subject, message) }
}

/// A number with four digits that count.
fn short(x: f64) -> String {
    digits(x, 4)
}

/// A number with at most `count` digits that count.
fn digits(x: f64, count: i32) -> String {
    let exponent = if x.abs() > 0.0 { x.abs().log10().floor() as i32 } else { 0 };
    if !(-4..6).contains(&exponent) {
        let text = format!("{x:.*e}", count as usize - 1);
        let Some((number, exponent)) = text.split_once('e') else { return text };
        return format!("{}e{exponent}", trimmed(number));
    }
    trimmed(&format!("{x:.*}", (count - 1 - exponent).max(0) as usize)).to_owned()
}

/// Without the zeros at the end of a fraction.
fn trimmed(number: &str) -> &str {
    if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { number }
}

#[cfg(test)]
mod tests {
    use super::short;

    #[test]
    fn numbers_have_four_digits_that_count() {
        let all = [0.0, 1.0, 0.25, 1234.56, 123_456.0, -0.000_123_456, 1e-9, 2.5e7, f64::INFINITY].map(short);
        assert_eq!(all.join(" "), "0 1 0.25 1235 123456 -0.0001235 1e-9 2.5e7 inf");
    }
}
