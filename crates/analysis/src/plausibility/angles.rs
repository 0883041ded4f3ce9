//! Radians taken for degrees, and the reverse.

use super::MotionFinding;
use solaris_model::{AxisKind, Figure, Motion};

/// The greatest angle (rad) that a coordinate of people and animals takes; beyond it the numbers are rather degrees. A person
/// who turns round once and a half on the spot is at 9.4.
pub const GREATEST_RADIANS: f64 = 10.0;

/// Where no angle of a movement is greater than this (°), the numbers are rather radians: 2.5 rad is 143°, about the most that a
/// knee or an elbow bends.
pub const GREATEST_DEGREES_OF_RADIANS: f64 = 2.5;

/// Angles that change by less than this (°) may be of somebody who stands still; 0.5 rad is 29°, which any step has.
pub const LEAST_RANGE: f64 = 0.5;

/// Angles of joints whose ranges make no sense in the unit that they were read in: `in_degrees` says what the table's header
/// said, and nothing where it has no say. Ball and free joints are quaternions and have no unit.
///
/// # Examples
///
/// ```
/// use solaris_analysis::plausibility::{MotionFinding, check_angles};
/// use solaris_model::{FigureBuilder, Joint, Known, LinkSpec, Motion, MotionInfo, Vector3};
///
/// let figure = FigureBuilder::new("leg").link(LinkSpec::root("leg", Joint::new("knee").rx()).mass(1.0)).build()?;
/// let (time, q) = (vec![0.0, 0.1], vec![5.0, 60.0]);
/// let info = MotionInfo::recorded(&figure, Vector3::zeros(), &time);
/// let motion = Motion::recorded(&figure, info, time, [q, vec![0.0; 2], vec![0.0; 2]], Known::none(1))?;
/// let found = check_angles(&figure, &motion, None);
/// assert!(matches!(found, Some(MotionFinding::DegreesAsRadians { greatest: 60.0, .. })));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "inDegrees")]
pub fn check_angles(figure: &Figure, motion: &Motion, in_degrees: Option<bool>) -> Option<MotionFinding> {
    let (layout, q) = (figure.layout(), motion.columns()[0]);
    let mut farthest: Option<(usize, f64)> = None;
    let mut range = 0.0_f64;
    for (link, at) in figure.links().iter().zip(layout.joints()) {
        for (i, dof) in link.joint().kind().axes().iter().enumerate() {
            if dof.axis.kind != AxisKind::Rotation || figure.follows(at.v + i) {
                continue;
            }
            let column = || q.iter().skip(at.q + i).step_by(layout.nq()).copied();
            let greatest = column().fold(0.0_f64, |greatest, x| greatest.max(x.abs()));
            let (least, most) =
                column().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
            range = range.max(most - least);
            if farthest.is_none_or(|(_, before)| greatest > before) {
                farthest = Some((at.v + i, greatest));
            }
        }
    }
    let (dof, greatest) = farthest?;
    if in_degrees == Some(true) {
        let (greatest, range) = (greatest.to_degrees(), range.to_degrees());
        let is_small = greatest <= GREATEST_DEGREES_OF_RADIANS && range > LEAST_RANGE;
        return is_small.then_some(MotionFinding::RadiansAsDegrees { greatest });
    }
    let dof = layout.v_names()[dof].clone();
    (greatest > GREATEST_RADIANS).then_some(MotionFinding::DegreesAsRadians { dof, greatest })
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris_model::{Curve, FigureBuilder, Joint, Known, LinkSpec, MotionInfo, Vector3};

    /// A wheel that its crank turns five times as far.
    #[test]
    fn what_follows_another_is_not_judged() {
        let gear = Joint::new("wheel").rx().following("crank.rx", Curve::Polynomial(vec![0.0, 5.0]));
        let figure = FigureBuilder::new("gear")
            .link(LinkSpec::root("crank", Joint::new("crank").rx()).mass(1.0))
            .link(LinkSpec::child("wheel", "crank", gear).mass(1.0))
            .build()
            .expect("valid");
        let found = |turned: f64| {
            let (time, q) = (vec![0.0, 0.1], vec![0.0, 0.0, turned, 5.0 * turned]);
            let info = MotionInfo::recorded(&figure, Vector3::zeros(), &time);
            let columns = [q, vec![0.0; 4], vec![0.0; 4]];
            let motion = Motion::recorded(&figure, info, time, columns, Known::none(2)).expect("a motion");
            check_angles(&figure, &motion, None)
        };
        assert_eq!(found(9.0), None);
        let crank = MotionFinding::DegreesAsRadians { dof: "crank.rx".to_owned(), greatest: 12.0 };
        assert_eq!(found(-12.0), Some(crank));
    }
}
