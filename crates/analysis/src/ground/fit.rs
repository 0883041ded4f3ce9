//! Checks that a motion and soles are ones that the ground can be asked about.

use crate::ground::{GroundError, Sole};
use crate::prepared::PreparedMotion;

impl PreparedMotion<'_> {
    /// Refuses what nothing can stand in: no gravity, no mass, no frames, times that do not rise.
    pub(super) fn check_ground(&self) -> Result<(), GroundError> {
        let gravity = self.motion.info.gravity;
        if self.up.norm_squared() == 0.0 || !gravity.norm().is_finite() {
            return Err(GroundError::NoGravity { gravity: gravity.into() });
        }
        if self.weight <= 0.0 {
            return Err(GroundError::NoMass { figure: self.figure.name().to_owned() });
        }
        if self.motion.is_empty() {
            return Err(GroundError::Empty);
        }
        let time = self.time();
        match (1..time.len()).find(|&frame| time[frame] <= time[frame - 1]) {
            None => Ok(()),
            Some(frame) => Err(GroundError::Time { frame, time: time[frame] }),
        }
    }

    /// Refuses soles that are none of the figure's.
    pub(super) fn check_soles(&self, soles: &[Sole]) -> Result<(), GroundError> {
        if soles.is_empty() {
            return Err(GroundError::NoSoles { figure: self.figure.name().to_owned() });
        }
        for (i, sole) in soles.iter().enumerate() {
            sole.check(self.figure)?;
            if soles[..i].iter().any(|other| other.name == sole.name) {
                let (sole, value) = (sole.name.clone(), "that of another sole".to_owned());
                let (what, remedy) = ("the name", "give each sole its own");
                return Err(GroundError::Sole { sole, what, value, remedy });
            }
        }
        Ok(())
    }
}
