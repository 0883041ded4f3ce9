//! The constants of a figure as a table for people.

use super::{Base, DenavitHartenberg};
use crate::error::DynamicsError;
use nalgebra::Vector3;
use solaris_model::{Chains, Figure};
use std::fmt;

/// The Denavit-Hartenberg frames of a figure and its chains, to be printed.
#[derive(Clone, Debug)]
pub struct Summary {
    /// The frames.
    pub frames: DenavitHartenberg,
    /// The chains to the end-effectors, and what they share.
    pub chains: Chains,
}

impl Summary {
    /// The summary of `figure`.
    ///
    /// # Errors
    ///
    /// As for [`DenavitHartenberg::of`].
    pub fn of(figure: &Figure) -> Result<Self, DynamicsError> {
        Ok(Self { frames: DenavitHartenberg::of(figure)?, chains: Chains::of(figure) })
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}\n{}", self.chains, self.frames)
    }
}

/// One row a rationalised link: its index in `v`, that of the one before it, whether a base `B` stands between them, the
/// degree of freedom, α and θ⁰ in degrees, a and s⁰ in metres, and the figure's links that move with its frame. Then the
/// bases.
impl fmt::Display for DenavitHartenberg {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = |k: usize| self.v_names[k].as_str();
        let width = self.v_names.iter().map(|name| name.chars().count()).max().unwrap_or(0).max(3);
        writeln!(f, "dof  after  base  {:<width$}    α (°)   θ⁰ (°)    a (m)   s⁰ (m)  carries", "name")?;
        for (k, link) in self.links.iter().enumerate() {
            let after = link.parent.map_or_else(|| "world".to_owned(), |parent| parent.to_string());
            let base = match link.base {
                Base::Identity => "",
                Base::Constant(_) => "B",
                Base::Moved { .. } => "B(q)",
            };
            let carried: Vec<&str> =
                link.carried.iter().map(|carried| self.link_names[carried.link].as_str()).collect();
            let line = format!(
                "{k:>3}  {after:>5}  {base:<4}  {:<width$} {:>8} {:>8} {:>8} {:>8}  {}",
                name(k),
                short(link.alpha.to_degrees(), 2),
                short(link.theta.to_degrees(), 2),
                length(link.a, 4),
                length(link.s, 4),
                carried.join(" "),
            );
            writeln!(f, "{}", line.trim_end())?;
        }
        for carried in &self.grounded {
            writeln!(f, "{} does not move", self.link_names[carried.link])?;
        }
        for (k, link) in self.links.iter().enumerate() {
            let of = |base: &nalgebra::IsometryMatrix3<f64>| {
                let axis = |i: usize| vector(&base.rotation.matrix().column(i).into_owned(), 4);
                format!("origin {} m, x {}, z {}", vector(&base.translation.vector, 4), axis(0), axis(2))
            };
            match &link.base {
                Base::Identity => {}
                Base::Constant(base) => writeln!(f, "B before {}: {}", name(k), of(base))?,
                Base::Moved { before, after, .. } => {
                    writeln!(f, "B(q) before {}: {}; the joint; {}", name(k), of(before), of(after))?;
                }
            }
        }
        Ok(())
    }
}

/// A length of a fixed number of digits; zero is `0`.
pub(super) fn length(x: f64, digits: usize) -> String {
    let text = format!("{x:.digits$}");
    if text.bytes().all(|byte| matches!(byte, b'-' | b'0' | b'.')) { "0".to_owned() } else { text }
}

/// The same without zeros at the end.
pub(super) fn short(x: f64, digits: usize) -> String {
    let text = length(x, digits);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

fn vector(v: &Vector3<f64>, digits: usize) -> String {
    format!("({})", [v.x, v.y, v.z].map(|x| short(x, digits)).join(" "))
}
