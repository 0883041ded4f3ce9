//! The whole wrench of the ground in a motion.

use crate::differentiate::Completed;
use crate::ground::given::Given;
use crate::ground::{GroundError, GroundOption};
use nalgebra::Vector3;
use solaris_dynamics::{Wrench, center_of_mass, inverse_dynamics};
use solaris_model::Figure;

/// What the ground must do to the figure at one time, and where its centre of mass is; world axes.
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
/// outside. `gravity` (m/s², world axes) says which way is up, `level` (m, along up) where the ground is.
///
/// # Errors
///
/// No gravity, no mass, a motion that is not the figure's, and the first state that the kernel refuses (numbers that
/// are not finite among them).
///
/// # Examples
///
/// A body of 2 kg that is lifted at 1 m/s² presses with 2·(9.81 + 1) N:
///
/// ```
/// use solaris_analysis::{Completed, ground::balance};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let lift = LinkSpec::root("body", Joint::new("lift").ty()).mass(2.0);
/// let figure = FigureBuilder::new("lift").link(lift).build()?;
/// let states = Completed { time: vec![0.0], q: vec![0.3], v: vec![0.0], a: vec![1.0], ..Completed::default() };
/// let total = balance(&figure, Vector3::new(0.0, -9.81, 0.0), &states, 0.0)?;
/// assert!((total[0].force.y - 2.0 * 10.81).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn balance(
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &Completed,
    level: f64,
) -> Result<Vec<BalanceFrame>, GroundError> {
    if !level.is_finite() {
        return Err(bad_level(level));
    }
    let given = Given::new(figure, gravity, states)?;
    given.frames(|workspace, row| {
        let mut tau = vec![0.0; given.tree.nv()];
        inverse_dynamics(&given.tree, workspace, given.q(row), given.v(row), given.a(row), &[], &mut tau)?;
        let base = workspace.base_wrench();
        let total = Wrench { force: base.force, moment: base.moment };
        Ok(BalanceFrame {
            time: states.time[row],
            force: total.force,
            moment: total.moment,
            com: center_of_mass(&given.tree, workspace, given.q(row))?,
            cop: total.centre_of_pressure(&given.up, level),
        })
    })
}

pub(crate) const fn bad_level(level: f64) -> GroundError {
    GroundError::Option { option: GroundOption::Level, value: level, range: "finite" }
}
