//! A walker's curves over one stride, beside people's.

use super::curves::{Curve, PHASES, curves, nearest_pace};
use crate::body::LegGeometry;
use crate::body::roles::FEET;
use crate::measure::SteadyStride;
use crate::measure::window::Window;
use solaris_model::{Figure, Motion};

/// A curve of people's, and a walker's over a stride of the left leg.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beside {
    /// People's, at the pace that is nearest.
    pub people: Curve,
    /// The walker's, in the same unit.
    pub values: [f64; PHASES],
}

impl Beside {
    /// Root of the mean square of the difference from people's mean, over the stride.
    pub fn difference(&self) -> f64 {
        let squares = self.people.mean.iter().zip(&self.values).map(|(mean, value)| (value - mean).powi(2));
        (squares.sum::<f64>() / PHASES as f64).sqrt()
    }

    /// The part of the stride in which it lies within so many standard deviations of people's mean. Where people hardly differ, as in the force of a
    /// foot in the air, within a hundredth of what the mean comes to at most.
    pub fn within(&self, deviations: f64) -> f64 {
        let most = self.people.mean.iter().fold(0.0_f64, |most, mean| most.max(mean.abs()));
        let near = |i: &usize| {
            let margin = (deviations * self.people.deviation[*i]).max(most / 100.0);
            (self.values[*i] - self.people.mean[*i]).abs() <= margin
        };
        (0..PHASES).filter(near).count() as f64 / PHASES as f64
    }
}

/// A steady stride of the left leg, as [`crate::measure()`] finds it, beside people's curves at its pace; without those that the figure or its motion lacks. Backward it is
/// beside none: people's are of walking forward.
pub fn beside(figure: &Figure, motion: &Motion, stride: &SteadyStride) -> Vec<Beside> {
    let Ok(leg) = LegGeometry::of_sides(figure).map(|sides| LegGeometry::between(&sides)) else {
        return Vec::new();
    };
    if stride.backward {
        return Vec::new();
    }
    let gravity = motion.info.gravity.norm();
    let pace = nearest_pace(stride.speed / (gravity * (leg.length() + leg.ankle_height)).sqrt());
    let window = Window { time: motion.time(), span: stride.span };
    let over = |people: Curve| {
        let value = values(figure, motion, people.name)?;
        let (start, end) = stride.span;
        let at = |i: usize| window.at(start + (end - start) * i as f64 / (PHASES - 1) as f64, &value);
        Some(Beside { people, values: std::array::from_fn(at) })
    };
    curves(pace).into_iter().filter_map(over).collect()
}

/// A quantity of people's curves by sample; `None` where the figure has no such angle, or the motion no forces.
fn values<'a>(figure: &'a Figure, motion: &'a Motion, name: &str) -> Option<Box<dyn Fn(usize) -> f64 + 'a>> {
    let (mass, gravity) = (figure.mass(), motion.info.gravity.norm());
    if let Some(axis) = ["Vertical force", "Force forwards"].iter().position(|force| *force == name) {
        let track = motion.contact(FEET[0])?;
        return Some(Box::new(move |i| 100.0 * track.samples[i].force[1 + axis] / (mass * gravity)));
    }
    let (angle, kind) = name.split_once(": ").unwrap_or((name, ""));
    let called = angle.to_lowercase().replace(' ', ".");
    let angle =
        figure.anatomical_angle(&format!("left_{called}")).or_else(|| figure.anatomical_angle(&called))?;
    if kind.is_empty() {
        return Some(Box::new(|i| (angle.sign * motion.q(i)[angle.coordinate]).to_degrees()));
    }
    motion.tau(0)?;
    let tau = move |i: usize| motion.tau(i).map_or(f64::NAN, |tau| tau[angle.dof] / mass);
    match kind {
        "moment" => Some(Box::new(move |i| angle.sign * tau(i))),
        _ => Some(Box::new(move |i| tau(i) * motion.v(i)[angle.dof])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::people::PACES;

    #[test]
    fn who_lies_a_deviation_and_a_half_beside_is_within_two_and_not_within_one() {
        for people in curves(&PACES[2]) {
            let exactly = Beside { people, values: people.mean };
            assert!(exactly.difference() < 1e-15 && exactly.within(0.0) > 0.999);
            let values = std::array::from_fn(|i| people.mean[i] + 1.5 * people.deviation[i]);
            let other = Beside { people, values };
            assert!(other.within(2.0) > 0.999, "{}", people.name);
            // Where people hardly differ a margin is left.
            assert!(other.within(1.0) <= 0.5, "{}: {}", people.name, other.within(1.0));
            let square = people.deviation.iter().map(|deviation| deviation * deviation).sum::<f64>();
            assert!((other.difference() - 1.5 * (square / PHASES as f64).sqrt()).abs() < 1e-12);
        }
    }
}
