//! What is known of a segment of an adult's body, for bodies that are divided otherwise.

use super::segments::{REFERENCE_HEIGHT, SEGMENTS};

/// Part of an adult's body, in shares of the body and of its own length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Portion {
    /// Share of the body's mass.
    pub mass: f64,
    /// Density of its tissue (kg/m³).
    pub density: f64,
    /// Length over the body's height.
    pub length: f64,
    /// Of a limb's segment: how far its centre of mass is from its joint, and its radii of gyration across and along
    /// itself, each over its length.
    pub limb: Option<[f64; 3]>,
}

/// What the segments of these names are together.
pub(crate) fn portion(names: &[&str]) -> Portion {
    let found: Vec<_> = SEGMENTS.iter().filter(|segment| names.contains(&segment.name)).collect();
    let mass: f64 = found.iter().map(|segment| segment.mass).sum();
    let limb = match found[..] {
        // Limbs hang down in the table.
        [segment] if ["upper_arm", "forearm", "thigh", "shank"].contains(&segment.name) => {
            let [x, y, z] = segment.gyration;
            Some([-segment.com[1] / segment.length, f64::midpoint(x, z), y])
        }
        _ => None,
    };
    Portion {
        mass,
        density: found.iter().map(|segment| segment.mass * segment.density).sum::<f64>() / mass,
        length: found.iter().map(|segment| segment.length).sum::<f64>() / REFERENCE_HEIGHT,
        limb,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thigh_is_that_of_the_published_table() {
        let thigh = portion(&["thigh"]);
        assert!((thigh.mass - 0.1416).abs() < 1e-12 && (thigh.length - 0.422 / 1.741).abs() < 1e-12);
        let [com, across, along] = thigh.limb.expect("a limb");
        assert!(
            (com - 0.4095).abs() < 1e-3 && (across - 0.329).abs() < 1e-12 && (along - 0.149).abs() < 1e-12
        );
    }

    #[test]
    fn all_portions_are_the_whole_body() {
        let one = ["pelvis", "abdomen", "thorax", "neck", "head"];
        let two = ["clavicle", "upper_arm", "forearm", "hand", "thigh", "shank", "foot", "toes"];
        let total = portion(&one).mass + 2.0 * portion(&two).mass;
        assert!((total - 1.0).abs() < 1e-3, "{total}");
    }
}
