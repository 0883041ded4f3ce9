//! What is wrong with forces that were found.

use crate::complete::Completed;
use crate::ground::{BalanceFrame, GroundError, Sole, Stances};
use nalgebra::Vector3;
use solaris_model::{Contact, Figure};

/// The worst of a quantity over time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Worst {
    /// The worst value.
    pub value: f64,
    /// When (s).
    pub time: f64,
    /// Share of the foot's standing frames that are at fault.
    pub share: f64,
}

/// What is to be said of one foot's forces.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FootReport {
    /// The sole's name.
    pub name: String,
    /// Frames in which it stands.
    pub frames: usize,
    /// Greatest tangential over normal force where the normal force exceeds 5 % of the weight; `share` of frames above
    /// 0.6. `None` where it never does.
    pub friction: Option<Worst>,
    /// How far (m) the centre of pressure is outside of the sole's outline at worst; `share` of frames outside. Where the
    /// normal force exceeds 5 % of the weight; `None` where it never does or the sole has no breadth.
    pub outside: Option<Worst>,
    /// Least normal force (N); `share` of frames in which it is less than zero: the ground pulls.
    pub normal: Option<Worst>,
    /// Greatest normal force (N).
    pub greatest: f64,
}

/// Frames in which no foot stands: nothing but gravity should act there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Unsupported {
    /// How many.
    pub frames: usize,
    /// Root of the mean square of the force (N) that is left unexplained.
    pub force_rms: f64,
    /// Greatest force (N).
    pub force: f64,
    /// When (s).
    pub time: f64,
}

/// Judges the contacts of each foot and the frames without any.
///
/// # Errors
///
/// Stub.
pub fn judge(
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &Completed,
    soles: &[Sole],
    stances: &Stances,
    total: &[BalanceFrame],
    contacts: &[Vec<Contact>],
) -> Result<(Vec<FootReport>, Unsupported), GroundError> {
    let _ = (figure, gravity, states, soles, stances, total, contacts);
    Err(GroundError::Empty)
}
