//! The order of continuity of a fade.

use core::fmt;

/// The continuity of a blend where its fade begins and ends.
///
/// Outside of the window the blend is one of the two motions; within it the derivative of order n is
///
/// ```text
/// R⁽ⁿ⁾ = α·f₁⁽ⁿ⁾ + (1 − α)·f₂⁽ⁿ⁾ + Σⱼ (n over j)·α⁽ʲ⁾·(f₁ − f₂)⁽ⁿ⁻ʲ⁾        j = 1 … n
/// ```
///
/// so that it goes over without a jump where, of each product in the sum, one factor is zero. With m derivatives of α zero at
/// that end, and the motions agreeing there in p of position, velocity, acceleration, …, all derivatives up to order m + p do.
///
/// # Source
///
/// Vasilonikolidakis (1991), §5.6 and §6.7.1, blends position, velocity and acceleration alike with α, as if α were constant
/// (E26 of the misprints in `docs/sources.md`); what is kept follows from the derivatives above.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keeps {
    /// m: how many derivatives of α, from the first on, are zero at both ends of the window.
    pub at_rest: usize,
}

impl Keeps {
    /// The order up to which derivatives stay continuous where the motions agree in `agreeing` quantities: in none (0), in
    /// position (1), in position and velocity (2), …
    ///
    /// # Examples
    ///
    /// ```
    /// use solaris_profiles::blend::{Fade, FadeKind};
    ///
    /// let keeps = Fade::new(FadeKind::Linear, 0.0, 1.0)?.keeps();
    /// // Motions between the same two positions keep their velocity at the ends of a linear fade.
    /// assert_eq!(keeps.order(1), 1);
    /// # Ok::<(), solaris_profiles::ProfileError>(())
    /// ```
    pub fn order(&self, agreeing: usize) -> usize {
        self.at_rest + agreeing
    }
}

/// "position stays continuous; with equal positions also velocity; …", up to the jerk.
impl fmt::Display for Keeps {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const NAMES: [&str; 4] = ["position", "velocity", "acceleration", "jerk"];
        let general = &NAMES[..=self.order(0).min(3)];
        for (i, name) in general.iter().enumerate() {
            let separator = match general.len() - i {
                _ if i == 0 => "",
                1 => " and ",
                _ => ", ",
            };
            write!(f, "{separator}{name}")?;
        }
        write!(f, "{} continuous", if general.len() == 1 { " stays" } else { " stay" })?;
        let agreements = ["positions", "velocities", "accelerations"];
        for (agreeing, name) in agreements.iter().enumerate() {
            let Some(kept) = NAMES.get(self.order(agreeing + 1)) else { break };
            let joint = if agreeing == 0 { "; with equal" } else { ", with equal" };
            write!(f, "{joint} {name} {} {kept}", if agreeing == 0 { "also" } else { "as well" })?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::string::ToString;

    #[test]
    fn what_is_kept_can_be_read() {
        assert_eq!(
            Keeps { at_rest: 0 }.to_string(),
            "position stays continuous; with equal positions also velocity, with equal velocities as well \
             acceleration, with equal accelerations as well jerk"
        );
        assert_eq!(
            Keeps { at_rest: 2 }.to_string(),
            "position, velocity and acceleration stay continuous; with equal positions also jerk"
        );
    }
}
