//! Joint forces of a motion whose ground reactions are prescribed.

use crate::error::ReactionError;
use crate::inverse::{InverseOptions, Residual, inverse_motion};
use crate::loads::Loads;
use crate::prepared::PreparedMotion;
use crate::reaction::Foot;
use solaris_model::{Contact, Figure, Motion};

/// Puts prescribed wrenches on two feet at every frame of a motion, finds the joints' forces, and writes both to it. What is missing
/// for the balance of momentum stays at the root and is answered: it says how far motion and forces agree, in flight too.
///
/// [`crate::ground_reactions`] asks the motion for the forces instead, and cannot answer in flight.
///
/// # Errors
///
/// A motion of another figure, links that are no feet, and a state that cannot be computed with.
#[doc(alias = "grf")]
#[doc(alias = "ground reaction forces")]
pub fn prescribed_reactions(
    figure: &Figure,
    motion: &mut Motion,
    feet: [&str; 2],
    law: impl Fn(f64) -> [Contact; 2],
) -> Result<Residual, ReactionError> {
    if feet[0] == feet[1] {
        return Err(ReactionError::OneFootTwice { link: feet[0].to_owned() });
    }
    let feet = [Foot::find(figure, feet[0])?, Foot::find(figure, feet[1])?];
    let contacts: Vec<[Contact; 2]> = motion.time().iter().map(|&time| law(time)).collect();
    let of = |side: usize| contacts.iter().map(|contacts| contacts[side]).collect::<Vec<Contact>>();
    let loads = Loads::of(feet.into_iter().enumerate().map(|(side, foot)| (foot.carrier, of(side))));
    let report = inverse_motion(&PreparedMotion::new(figure, motion)?, &loads, InverseOptions::default())?;
    motion.set_tau(report.tau)?;
    let tracks = loads.contacts(figure);
    motion.contacts.retain(|track| tracks.iter().all(|new| new.link != track.link));
    motion.contacts.extend(tracks);
    Ok(report.residual)
}
