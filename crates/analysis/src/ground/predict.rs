//! The ground's forces of a motion, from the soles to what is wrong with them.

use crate::carrier::Carrier;
use crate::ground::carry::carriers;
use crate::ground::{
    BalanceFrame, Elsewhere, FootReport, GroundError, PlacedFeet, Split, StanceOptions, Stances, Unsupported,
    find_elsewhere, find_stances, judge, share,
};
use crate::loads::Loads;
use solaris_model::ContactTrack;

/// How the ground's forces are to be found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GroundOptions {
    /// How feet share the wrench.
    pub split: Split,
    /// What counts as standing.
    pub stance: StanceOptions,
    /// Stances that are known; they are not looked for then.
    pub stances: Option<Stances>,
}

/// The ground's forces of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct GroundForces {
    /// By sole, under its name: one contact a frame, zero where the foot does not stand.
    pub contacts: Vec<ContactTrack>,
    /// The whole wrench, frame by frame.
    pub total: Vec<BalanceFrame>,
    /// When which foot stands.
    pub stances: Stances,
    /// What is to be said of them.
    pub report: GroundReport,
    /// By sole, what carries the force.
    carriers: Vec<Carrier>,
}

/// What is to be said of forces that were found.
///
/// With the feature `serde` its keys are `split`, `weight_n`, `feet`, `irregular_frames`, `unsupported` and `elsewhere`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct GroundReport {
    /// How feet share the wrench.
    pub split: Split,
    /// The figure's weight (N).
    #[cfg_attr(feature = "serde", serde(rename = "weight_n"))]
    pub weight: f64,
    /// By sole.
    pub feet: Vec<FootReport>,
    /// Frames in which several feet stand, not between two single supports; see [`crate::ground::Shared::irregular`].
    #[cfg_attr(feature = "serde", serde(rename = "irregular_frames"))]
    pub irregular: usize,
    /// Frames in which no foot stands.
    pub unsupported: Unsupported,
    /// When something else than feet on the ground carries.
    pub elsewhere: Vec<Elsewhere>,
}

impl GroundForces {
    /// What acts on the figure, as [`crate::inverse_motion`] takes it.
    pub fn loads(&self) -> Loads {
        Loads::of(
            self.carriers
                .iter()
                .zip(&self.contacts)
                .map(|(carrier, track)| (*carrier, track.samples.clone())),
        )
    }
}

/// Finds the ground's forces in a motion: when which foot stands, the
/// whole wrench, how it is shared, and what is wrong with it. Stairs and slopes are told by how the soles stand on them ([`Stances::footings`]).
///
/// A foot's force acts on its link, and on its toes once the centre of pressure has passed the ball
/// ([`GroundForces::loads`]). In the frame of the toes' link the ball is where it is with all joints at zero. Of the figure's
/// own soles ([`crate::ground::soles`]) the toes' link has a ball of its own, or the foot carries all.
///
/// # Errors
///
/// Options out of their range, a split that cannot share between so many feet, and the first state that the kernel refuses.
///
/// # Examples
///
/// A person who stands still has half the weight on either foot:
///
/// ```
/// use solaris_analysis::{PreparedMotion, ground::{GroundOptions, PlacedFeet, ground_forces, soles}};
/// use solaris_model::{Motion, MotionInfo, human};
///
/// let ann = human(1.65, 58.0)?;
/// let mut q = vec![0.0; ann.layout().nq()];
/// q[1] = 0.9; // pelvis height: the ground is where the soles are
/// let rest = vec![0.0; ann.layout().nv()];
/// let motion = Motion::new(&ann, MotionInfo::on_earth(&ann, 100.0), vec![0.0], [q, rest.clone(), rest])?;
/// let prepared = PreparedMotion::new(&ann, &motion)?;
/// let ground = ground_forces(&PlacedFeet::new(&prepared, soles(&ann))?, &GroundOptions::default())?;
/// let [left, right] = [0, 1].map(|foot| ground.contacts[foot].samples[0].force.y);
/// assert!((left - 29.0 * 9.80665).abs() < 1e-9 && (left - right).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "grf")]
#[doc(alias = "ground reaction forces")]
pub fn ground_forces(feet: &PlacedFeet<'_>, options: &GroundOptions) -> Result<GroundForces, GroundError> {
    let stances = match &options.stances {
        Some(stances) => stances.clone(),
        None => find_stances(feet, &options.stance)?,
    };
    let total = feet.whole_on(&stances)?;
    let shared = share(options.split, feet, &stances, &total)?;
    let (of_feet, unsupported) = judge(feet, &stances, &total, &shared.contacts)?;
    let report = GroundReport {
        weight: feet.prepared().weight,
        split: options.split,
        irregular: shared.irregular,
        feet: of_feet,
        unsupported,
        elsewhere: find_elsewhere(feet, &stances, &total)?,
    };
    let contacts = feet.soles().iter().zip(shared.contacts);
    let contacts =
        contacts.map(|(sole, samples)| ContactTrack { link: sole.name.clone(), samples }).collect();
    let carriers = carriers(feet)?;
    Ok(GroundForces { contacts, total, stances, report, carriers })
}
