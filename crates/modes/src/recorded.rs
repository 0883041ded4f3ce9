//! A recorded motion as a drive: curves through its samples.

use solaris_model::Motion;

/// A motion that degrees of freedom can follow: between two samples, the polynomial of degree five that meets position,
/// velocity and acceleration of both.
///
/// Before its first sample and after its last it stands still there.
#[derive(Clone, Debug)]
pub struct Recorded {
    motion: Motion,
}

impl PartialEq for Recorded {
    /// The same motion object, not one with equal numbers.
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Recorded {
    /// The curves of `motion`.
    pub fn new(motion: Motion) -> Self {
        Self { motion }
    }

    /// The motion.
    pub fn motion(&self) -> &Motion {
        &self.motion
    }
}

impl Recorded {
    /// Position, velocity and acceleration of a degree of freedom (index in `v`, and of its coordinate in `q`) at a time (s).
    pub(crate) fn at(&self, dof: usize, coordinate: usize, time: f64) -> solaris_profiles::Sample {
        let _ = (dof, coordinate, time);
        unimplemented!()
    }
}
