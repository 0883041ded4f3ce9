//! Soles of links that plates push, where nobody says where they are.

use crate::ground::Sole;
use solaris_model::{Figure, MeasuredForce, Vector3};

/// A sole for each link that one of the forces acts on: from its origin through its centre of mass and as far beyond, which of a
/// foot's link is about its length. Good enough to tell one foot from the other, not to judge by centimetres.
pub fn soles_of_plates(figure: &Figure, measured: &[MeasuredForce]) -> Vec<Sole> {
    let mut soles: Vec<Sole> = Vec::new();
    for link in measured.iter().filter_map(|record| record.links.first()) {
        let Some(foot) = figure.link_index(link) else { continue };
        if soles.iter().any(|sole| sole.foot == foot) {
            continue;
        }
        let com = *figure.links()[foot].com();
        let (heel, tip) = (Vector3::zeros(), com * 2.0);
        soles.push(Sole { name: link.clone(), foot, toes: None, heel, ball: com, tip, width: None });
    }
    soles
}
