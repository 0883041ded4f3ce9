//! The ground's forces of a motion, from the soles to what is wrong with them.

use crate::differentiate::Completed;
use crate::ground::carry::{Carried, carried};
use crate::ground::given::Given;
use crate::ground::{
    BalanceFrame, FootReport, GroundError, Sole, Split, StanceOptions, Stances, Unsupported, balance,
    find_stances, judge, share,
};
use nalgebra::Vector3;
use solaris_model::{ContactTrack, Figure, ForceRecord};

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
    carried: Vec<Carried>,
}

/// What is to be said of forces that were found.
#[derive(Clone, Debug, PartialEq)]
pub struct GroundReport {
    /// The figure's weight (N).
    pub weight: f64,
    /// How feet share the wrench.
    pub split: Split,
    /// Frames in which several feet stand, not between two single supports; see [`crate::ground::Shared::irregular`].
    pub irregular: usize,
    /// By sole.
    pub feet: Vec<FootReport>,
    /// Frames in which no foot stands.
    pub unsupported: Unsupported,
}

impl GroundForces {
    /// What acts on the figure, as [`crate::inverse_motion`] takes it: a record for each foot.
    pub fn records(&self) -> Vec<ForceRecord> {
        let records = self.contacts.iter().zip(&self.carried).map(|(track, carried)| ForceRecord {
            links: carried.links.clone(),
            ball_and_tip: carried.ball_and_tip,
            time: self.total.iter().map(|frame| frame.time).collect(),
            samples: track.samples.clone(),
        });
        records.collect()
    }
}

/// Finds the ground's forces in a motion of `figure` under `gravity` (m/s², world axes): when which foot stands, the
/// whole wrench, how it is shared, and what is wrong with it. The ground is level.
///
/// A foot's force acts on its link, and on its toes once the centre of pressure has passed the ball
/// ([`GroundForces::records`]). In the frame of the toes' link the ball is where it is with all joints at zero. Of the figure's
/// own soles ([`crate::ground::soles`]) the toes' link has a ball of its own, or the foot carries all.
///
/// # Errors
///
/// No gravity, no mass, no soles or soles that are none, options out of their range, a motion that is not the figure's,
/// a split that cannot share between so many feet, and the first state that the kernel refuses.
///
/// # Examples
///
/// A person who stands still has half the weight on either foot:
///
/// ```
/// use solaris_analysis::{Completed, ground::{GroundOptions, ground_forces, soles}};
/// use solaris_model::{Vector3, human};
///
/// let ann = human(1.65, 58.0)?;
/// let mut q = vec![0.0; ann.layout().nq()];
/// q[1] = 0.9; // pelvis height: the ground is where the soles are
/// let (rest, time) = (vec![0.0; ann.layout().nv()], vec![0.0]);
/// let states = Completed { time, q, v: rest.clone(), a: rest, ..Completed::default() };
/// let gravity = Vector3::new(0.0, -9.80665, 0.0);
/// let ground = ground_forces(&ann, gravity, &states, &soles(&ann), &GroundOptions::default())?;
/// let [left, right] = [0, 1].map(|foot| ground.contacts[foot].samples[0].force.y);
/// assert!((left - 29.0 * 9.80665).abs() < 1e-9 && (left - right).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn ground_forces(
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &Completed,
    soles: &[Sole],
    options: &GroundOptions,
) -> Result<GroundForces, GroundError> {
    let stances = match &options.stances {
        Some(stances) => stances.clone(),
        None => find_stances(figure, gravity, states, soles, &options.stance)?,
    };
    let total = balance(figure, gravity, states, stances.level)?;
    let shared = share(options.split, figure, gravity, states, soles, &stances, &total)?;
    let (feet, unsupported) = judge(figure, gravity, states, soles, &stances, &total, &shared.contacts)?;
    let report = GroundReport {
        weight: figure.mass() * gravity.norm(),
        split: options.split,
        irregular: shared.irregular,
        feet,
        unsupported,
    };
    let contacts = soles.iter().zip(shared.contacts);
    let contacts =
        contacts.map(|(sole, samples)| ContactTrack { link: sole.name.clone(), samples }).collect();
    let carried = carried(&Given::new(figure, gravity, states)?, soles)?;
    Ok(GroundForces { contacts, total, stances, report, carried })
}
