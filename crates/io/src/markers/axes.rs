//! The axes of a laboratory: which way is up, and which way the subject goes.

use solaris_model::{Matrix3, Vector3};
use std::fmt;
use std::str::FromStr;

/// One of the three axes, or the way against it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Way {
    /// 0, 1, 2 for x, y, z.
    axis: usize,
    is_against: bool,
}

/// Which way of some axes is up, and which way is forward.
///
/// ```
/// use solaris_io::markers::Axes;
/// use solaris_model::Vector3;
/// // Many laboratories have z up; OpenSim's models have y up and look along x.
/// let laboratory: Axes = "z,x".parse()?;
/// let turn = laboratory.turn_to(&Axes::OPENSIM);
/// assert_eq!(turn * Vector3::new(1.0, 2.0, 3.0), Vector3::new(1.0, 3.0, -2.0));
/// # Ok::<(), solaris_io::markers::AxesError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Axes {
    up: Way,
    forward: Way,
}

/// Why words name no axes.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum AxesError {
    /// Not two of them.
    #[error("'{text}' names no two ways; write UP,FORWARD, such as z,x or y,-z")]
    Two {
        /// The words.
        text: String,
    },
    /// None of the six ways.
    #[error("'{text}' is no way; it must be x, y, z, -x, -y or -z")]
    Way {
        /// The word.
        text: String,
    },
    /// Up and forward along one line.
    #[error("up is {up} and forward {forward}, which lie in one line; name two of x, y and z")]
    Line {
        /// Up.
        up: Way,
        /// Forward.
        forward: Way,
    },
}

impl Way {
    /// x, y, z for 0, 1, 2.
    ///
    /// # Panics
    ///
    /// With another number.
    pub const fn along(axis: usize) -> Self {
        assert!(axis < 3, "an axis is 0, 1 or 2");
        Self { axis, is_against: false }
    }

    /// The other way.
    #[must_use]
    pub const fn back(self) -> Self {
        Self { axis: self.axis, is_against: !self.is_against }
    }

    /// The way nearest to `vector`.
    pub fn nearest(vector: &Vector3<f64>) -> Self {
        let axis = vector.iamax();
        Self { axis, is_against: vector[axis] < 0.0 }
    }

    /// 0, 1, 2 for x, y, z.
    pub fn axis(self) -> usize {
        self.axis
    }

    /// As a vector of length 1.
    pub fn vector(self) -> Vector3<f64> {
        let mut vector = Vector3::zeros();
        vector[self.axis] = if self.is_against { -1.0 } else { 1.0 };
        vector
    }
}

impl Axes {
    /// Those of OpenSim: y up, x forward, z right.
    pub const OPENSIM: Self = Self { up: Way::along(1), forward: Way::along(0) };

    /// Up and forward.
    ///
    /// # Errors
    ///
    /// [`AxesError::Line`] where both lie in one line.
    pub fn new(up: Way, forward: Way) -> Result<Self, AxesError> {
        if up.axis == forward.axis {
            return Err(AxesError::Line { up, forward });
        }
        Ok(Self { up, forward })
    }

    /// Which way is up.
    pub fn up(&self) -> Way {
        self.up
    }

    /// Which way is forward.
    pub fn forward(&self) -> Way {
        self.forward
    }

    /// The rotation of what is along these axes into `world`'s: up becomes up, and forward becomes forward.
    pub fn turn_to(&self, world: &Self) -> Matrix3<f64> {
        world.columns() * self.columns().transpose()
    }

    /// Forward, up and right.
    fn columns(&self) -> Matrix3<f64> {
        let (up, forward) = (self.up.vector(), self.forward.vector());
        Matrix3::from_columns(&[forward, up, forward.cross(&up)])
    }
}

impl FromStr for Way {
    type Err = AxesError;

    fn from_str(text: &str) -> Result<Self, AxesError> {
        let bare = text.trim();
        let (is_against, name) = match bare.strip_prefix('-') {
            Some(name) => (true, name),
            None => (false, bare.strip_prefix('+').unwrap_or(bare)),
        };
        let axis = match name {
            "x" | "X" => 0,
            "y" | "Y" => 1,
            "z" | "Z" => 2,
            _ => return Err(AxesError::Way { text: text.to_owned() }),
        };
        Ok(Self { axis, is_against })
    }
}

impl FromStr for Axes {
    type Err = AxesError;

    fn from_str(text: &str) -> Result<Self, AxesError> {
        let (up, forward) = text.split_once(',').ok_or_else(|| AxesError::Two { text: text.to_owned() })?;
        Self::new(up.parse()?, forward.parse()?)
    }
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", if self.is_against { "-" } else { "" }, ["x", "y", "z"][self.axis])
    }
}

impl fmt::Display for Axes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{}", self.up, self.forward)
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn words_name_axes_or_are_refused() {
        let axes: Axes = "z,-y".parse().unwrap();
        assert_eq!(axes.to_string(), "z,-y");
        let said = |text: &str| text.parse::<Axes>().unwrap_err().to_string();
        assert!(said("z").contains("UP,FORWARD"));
        assert!(said("z,w").contains("'w' is no way"));
        assert!(said("z,-z").contains("one line"));
    }

    #[test]
    fn every_turn_is_a_rotation_that_keeps_up_and_forward() {
        let ways = ["x", "y", "z", "-x", "-y", "-z"];
        let mut count = 0;
        for up in ways {
            for forward in ways {
                let Ok(axes) = format!("{up},{forward}").parse::<Axes>() else { continue };
                let turn = axes.turn_to(&Axes::OPENSIM);
                assert!((turn.determinant() - 1.0).abs() < 1e-12);
                assert_eq!(turn * axes.up().vector(), Vector3::y());
                assert_eq!(turn * axes.forward().vector(), Vector3::x());
                count += 1;
            }
        }
        assert_eq!(count, 24);
    }
}
