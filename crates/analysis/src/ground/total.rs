//! The whole wrench of the ground in a motion.

use crate::ground::{GroundError, GroundOption};
use crate::prepared::PreparedMotion;
use nalgebra::Vector3;
use solaris_dynamics::{Wrench, center_of_mass, inverse_dynamics};

/// What the ground must do to the figure at one time, and where its centre of mass is; world axes.
#[doc(alias = "zmp")]
#[doc(alias = "cop")]
#[doc(alias = "com")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BalanceFrame {
    /// When (s).
    pub time: f64,
    /// Force (N).
    pub force: Vector3<f64>,
    /// Moment about the world's origin (N m).
    pub moment: Vector3<f64>,
    /// Centre of mass (m).
    pub com: Vector3<f64>,
    /// Centre of pressure (m): the point of the ground about which the moment is normal to it; `None` where nothing
    /// presses on the ground.
    pub cop: Option<Vector3<f64>>,
}

impl BalanceFrame {
    pub(crate) const fn wrench(&self) -> Wrench<f64> {
        Wrench { force: self.force, moment: self.moment }
    }
}

/// The whole wrench of the ground, frame by frame: what inverse dynamics finds at the root where nothing else acts from
/// outside. The motion's gravity says which way is up, `level` (m, along up) where the ground is.
///
/// # Errors
///
/// No gravity, no mass, and the first state that the kernel refuses.
///
/// # Examples
///
/// A body of 2 kg that is lifted at 1 m/s² presses with 2·(9.81 + 1) N:
///
/// ```
/// use solaris_analysis::{PreparedMotion, ground::balance};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Motion, MotionInfo, Vector3};
///
/// let lift = LinkSpec::root("body", Joint::new("lift").ty()).mass(2.0);
/// let figure = FigureBuilder::new("lift").link(lift).build()?;
/// let info = MotionInfo::recorded(&figure, Vector3::new(0.0, -9.81, 0.0), &[0.0]);
/// let motion = Motion::new(&figure, info, vec![0.0], [vec![0.3], vec![0.0], vec![1.0]])?;
/// let total = balance(&PreparedMotion::new(&figure, &motion)?, 0.0)?;
/// assert!((total[0].force.y - 2.0 * 10.81).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn balance(prepared: &PreparedMotion<'_>, level: f64) -> Result<Vec<BalanceFrame>, GroundError> {
    if !level.is_finite() {
        return Err(bad_level(level));
    }
    prepared.check_ground()?;
    let tree = &prepared.tree;
    let frames = prepared.frames(|workspace, row| {
        let q = prepared.q(row);
        let mut tau = vec![0.0; tree.nv()];
        inverse_dynamics(tree, workspace, q, prepared.v(row), prepared.a(row), &[], &mut tau)?;
        let total = workspace.base_wrench();
        Ok(BalanceFrame {
            time: prepared.time()[row],
            force: total.force,
            moment: total.moment,
            com: center_of_mass(tree, workspace, q)?,
            cop: total.center_of_pressure(&prepared.up, level),
        })
    })?;
    Ok(frames)
}

pub(crate) const fn bad_level(level: f64) -> GroundError {
    GroundError::Option { option: GroundOption::Level, value: level, range: "finite" }
}
