//! The ground, and where links can touch it.

mod patch;
mod points;

pub(crate) use patch::{CALM, ContactPatch};
pub use points::contact_points;

use crate::failure::SetupError;
use crate::range::{check_not_negative, check_positive};
use nalgebra::{Unit, Vector3};
use solaris_model::Figure;

/// What bodies touch: a plane.
#[doc(alias = "floor")]
#[doc(alias = "terrain")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundPlane {
    /// Out of the ground, in the world's axes. Against gravity for a floor; any other direction is a slope.
    pub up: Unit<Vector3<f64>>,
    /// Of the plane along [`up`](Self::up), from the world's origin (m).
    pub height: f64,
    /// `μ`, the coefficient of friction.
    pub friction: f64,
    /// How it pushes.
    pub law: ContactLaw,
}

/// How the ground pushes what touches it.
#[doc(alias = "contact model")]
#[doc(alias = "hunt-crossley")]
#[doc(alias = "penalty")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ContactLaw {
    /// Springs and dampers with smooth friction.
    ///
    /// ```text
    /// Fₙ = k·d·(1 + b·ḋ)   for d > 0, never below 0        F_t = −μ·Fₙ·v_t/√(v_t² + v_s²)
    /// ```
    ///
    /// `d` is how deep the lowest point of a sphere is, `v_t` the velocity along the ground of the link's material there. The
    /// force begins at zero, so that no velocity jumps. The energy `½·k·d²` is in the spring; the damper takes
    /// `(Fₙ − k·d)·ḋ` and friction `|F_t·v_t|`.
    ///
    /// What ought to stick creeps: under a pull of the part `s` of `μ·Fₙ` it slides with `v_s·s/√(1 − s²)`.
    ///
    /// # Source
    ///
    /// K. H. Hunt, F. R. E. Crossley, "Coefficient of restitution interpreted as damping in vibroimpact", Journal of Applied
    /// Mechanics 42 (1975), with a linear spring.
    Compliant {
        /// `k` (N/m).
        stiffness: f64,
        /// `b` (s/m): at the speed `1/b` the damper doubles the force.
        damping: f64,
        /// `v_s` (m/s): at this speed friction has 71 % of its magnitude.
        slip: f64,
    },
    /// What comes to the ground stays where it came down, until the ground would have to pull.
    ///
    /// The velocity of what comes down is lost in an instant, as in a plastic impact, and from then on it is held: its
    /// acceleration is known, its force sought. Of a part that touches with several points at once the force as a whole is
    /// found; where its centre of pressure would leave the points' convex hull the part begins to tip over that edge. Spheres
    /// roll. Where the figure leaves open which part bears how much (two feet of a stiff table), the forces with the least sum
    /// of squares are taken.
    ///
    /// Nothing sinks in, and nothing slides while it can be held: where friction would not hold what is asked of it, the report
    /// says how much it would take. A part that would be pulled where it is held and sink where it is let go (Painlevé's paradox:
    /// its friction would have given way before) slides without friction until it leaves the ground or comes to rest.
    Rigid,
}

impl ContactLaw {
    /// How deep (m) the whole weight sinks in where it rests on one point, by the stiffness that is taken where none is given.
    pub const DEPTH: f64 = 2e-3;
    /// `b` (s/m) where none is given: what falls on a point does not come back higher than a tenth of 1 m.
    pub const DAMPING: f64 = 1.0;
    /// `v_s` (m/s) where none is given.
    pub const SLIP: f64 = 1e-2;

    /// The stiffness (N/m) that is taken where none is given, `k = m·g/d` with a depth of [2 mm](Self::DEPTH); none without gravity or
    /// mass.
    pub fn stiffness_for(figure: &Figure, gravity: &Vector3<f64>) -> Option<f64> {
        let stiffness = figure.mass() * gravity.norm() / Self::DEPTH;
        (stiffness > 0.0 && stiffness.is_finite()).then_some(stiffness)
    }
}

impl GroundPlane {
    /// A floor at the height 0 with these coefficient of friction and the springs and dampers that fit the figure.
    ///
    /// # Errors
    ///
    /// [`SetupError::NoGround`] without gravity.
    pub fn under(figure: &Figure, gravity: &Vector3<f64>, friction: f64) -> Result<Self, SetupError> {
        let up = Unit::try_new(-gravity, 0.0).ok_or(SetupError::NoGround)?;
        let stiffness = ContactLaw::stiffness_for(figure, gravity).ok_or(SetupError::NoGround)?;
        let law = ContactLaw::Compliant { stiffness, damping: ContactLaw::DAMPING, slip: ContactLaw::SLIP };
        Ok(Self { up, height: 0.0, friction, law })
    }

    /// Whether it is square to gravity, or there is none.
    pub(crate) fn is_level(&self, gravity: &Vector3<f64>) -> bool {
        // To rounding: what people write as a direction.
        gravity.cross(&self.up).norm() <= 1e-9 * gravity.norm() && gravity.dot(&self.up) <= 0.0
    }

    fn check(&self) -> Result<(), SetupError> {
        if let Some(value) = self.up.iter().chain([&self.height]).find(|x| !x.is_finite()) {
            let what = "the place of the ground".to_owned();
            return Err(SetupError::Range { what, value: *value, range: "finite numbers" });
        }
        check_not_negative(|| "the friction of the ground".to_owned(), self.friction)?;
        let ContactLaw::Compliant { stiffness, damping, slip } = self.law else { return Ok(()) };
        check_not_negative(|| "the damping of the ground".to_owned(), damping)?;
        check_positive(|| "the stiffness of the ground".to_owned(), stiffness)?;
        check_positive(|| "the slip of the ground".to_owned(), slip)
    }
}

/// A sphere of a link that can touch the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPoint {
    /// Index of the link.
    pub link: usize,
    /// Its centre in the link's frame (m).
    pub center: Vector3<f64>,
    /// Its radius (m); 0 for a point.
    pub radius: f64,
}

/// The ground and what can touch it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Surface {
    pub(crate) plane: GroundPlane,
    pub(crate) contact_points: Vec<ContactPoint>,
}

/// How many spheres can touch a ground.
pub(crate) fn count(surface: Option<&Surface>) -> usize {
    surface.map_or(0, |surface| surface.contact_points.len())
}

impl Surface {
    /// Whether what comes to the ground stays there.
    pub(crate) fn plants(&self) -> bool {
        self.plane.law == ContactLaw::Rigid
    }

    /// Refuses numbers that are none, and links that `figure` does not have.
    pub(crate) fn new(
        figure: &Figure,
        plane: GroundPlane,
        contact_points: Vec<ContactPoint>,
    ) -> Result<Self, SetupError> {
        plane.check()?;
        for ContactPoint { link, center, radius } in &contact_points {
            let Some(link) = figure.links().get(*link) else {
                let (figure, name) = (figure.name().to_owned(), format!("number {link}"));
                return Err(SetupError::UnknownLink { figure, name, nearest: None });
            };
            if let Some(value) = center.iter().find(|x| !x.is_finite()) {
                let what = format!("a point of '{}' that can touch the ground", link.name());
                return Err(SetupError::Range { what, value: *value, range: "finite numbers" });
            }
            check_not_negative(|| format!("the radius of a sphere of '{}'", link.name()), *radius)?;
        }
        Ok(Self { plane, contact_points })
    }
}
