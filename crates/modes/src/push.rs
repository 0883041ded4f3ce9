//! Forces of the world on points of links, each over a window of time.

use crate::drive::path::Path;
use crate::failure::SetupError;
use crate::range::{check_finite, check_not_negative, check_positive};
use crate::simulation::Simulation;
use nalgebra::Vector3;
use solaris_profiles::{Profile, ProfileError};

/// Times shorter than this (s) cannot be told from none.
const SHORTEST: f64 = 1e-9;

/// A push of the world on a point of a link, from a time of the run on.
///
/// Its direction stays that of the world's axes however the link turns, and its point moves with the link. What it does to the figure
/// is not the work of the drives: see [`EnergyReport::pushes`](crate::EnergyReport::pushes).
#[doc(alias = "external force")]
#[doc(alias = "perturbation")]
#[derive(Clone, Debug, PartialEq)]
pub struct Push {
    /// Index of the link.
    pub link: usize,
    /// The point in the link's frame (m).
    pub point: Vector3<f64>,
    /// When it begins (s).
    pub from: f64,
    /// How hard, which way and for how long.
    pub law: PushLaw,
}

/// How a [`Push`] goes on over its time.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum PushLaw {
    /// The same all the time.
    Force {
        /// The force (N, world axes).
        force: Vector3<f64>,
        /// For how long (s); infinite for the rest of the run.
        over: f64,
    },
    /// A force times the positions of a curve, as long as that lasts.
    Along {
        /// The force (N, world axes) where the curve is 1.
        force: Vector3<f64>,
        /// The curve.
        profile: Profile,
    },
    /// An impulse in all.
    Impulse {
        /// The impulse (N s, world axes).
        impulse: Vector3<f64>,
        /// Over how long (s), evenly; 0 for a blow that changes velocities in an instant.
        over: f64,
    },
}

impl Push {
    /// A force (N, world axes) on a point of a link (m, in its frame), from the beginning of the run to its end; with
    /// [`Running::set_pushes`](crate::Running::set_pushes), from then on.
    pub fn steady(link: usize, point: Vector3<f64>, force: Vector3<f64>) -> Self {
        Self { link, point, from: 0.0, law: PushLaw::Force { force, over: f64::INFINITY } }
    }

    /// Whether it is one force from a time (s) on to the end of the run.
    pub(crate) fn is_steady(&self, time: f64) -> bool {
        matches!(self.law, PushLaw::Force { over, .. } if over.is_infinite()) && self.from <= time
    }

    /// Refuses numbers that are out of range; `link` is the name of what is pushed.
    pub(crate) fn check(&self, link: &str) -> Result<(), SetupError> {
        let of = |what: &str| format!("the {what} of the push on '{link}'");
        self.point.iter().try_for_each(|value| check_finite(|| of("point"), *value))?;
        check_not_negative(|| of("beginning"), self.from)?;
        match &self.law {
            PushLaw::Force { force, over } => {
                force.iter().try_for_each(|value| check_finite(|| of("force"), *value))?;
                if *over > 0.0 && *over < SHORTEST {
                    let range = "1e-9 s and more";
                    return Err(SetupError::Range { what: of("time"), value: *over, range });
                }
                if over.is_infinite() && *over > 0.0 { Ok(()) } else { check_positive(|| of("time"), *over) }
            }
            PushLaw::Along { force, profile } => {
                force.iter().try_for_each(|value| check_finite(|| of("force"), *value))?;
                let source = profile.curve::<f64>().err();
                source.map_or(Ok(()), |source| Err(SetupError::PushProfile { link: link.to_owned(), source }))
            }
            PushLaw::Impulse { impulse, over } => {
                impulse.iter().try_for_each(|value| check_finite(|| of("impulse"), *value))?;
                if *over > 0.0 && *over < SHORTEST {
                    let range = "0 for a blow, or 1e-9 s and more";
                    return Err(SetupError::Range { what: of("time"), value: *over, range });
                }
                check_not_negative(|| of("time"), *over)
            }
        }
    }

    /// The impulse (N s) of a blow; none of what takes time.
    pub(crate) fn blow(&self) -> Option<Vector3<f64>> {
        match self.law {
            PushLaw::Impulse { impulse, over } if over <= 0.0 => Some(impulse),
            _ => None,
        }
    }

    /// Its force in the time of the run; none of a blow.
    pub(crate) fn thrust(&self) -> Result<Thrust, ProfileError> {
        let even = |force: Vector3<f64>, over| Thrust {
            force,
            path: Path::Still(1.0),
            span: (self.from, self.from + over),
        };
        Ok(match &self.law {
            PushLaw::Force { force, over } => even(*force, *over),
            PushLaw::Impulse { impulse, over } if *over > 0.0 => even(impulse / *over, *over),
            PushLaw::Impulse { .. } => even(Vector3::zeros(), 0.0),
            PushLaw::Along { force, profile } => {
                let path = Path::profile(profile, self.from)?;
                let span = (self.from, path.end());
                Thrust { force: *force, path, span }
            }
        })
    }
}

impl Simulation {
    /// Adds a push of the world on a point of a link.
    ///
    /// # Errors
    ///
    /// [`SetupError::UnknownLink`], [`SetupError::Range`], [`SetupError::PushProfile`].
    pub fn add_push(&mut self, push: Push) -> Result<(), SetupError> {
        self.check_push(&push)?;
        self.pushes.push(push);
        Ok(())
    }

    /// Refuses a push on a link that there is not, and numbers out of range.
    pub(crate) fn check_push(&self, push: &Push) -> Result<(), SetupError> {
        let Some(link) = self.figure.links().get(push.link) else {
            let (figure, name) = (self.figure.name().to_owned(), format!("number {}", push.link));
            return Err(SetupError::UnknownLink { figure, name, nearest: None });
        };
        push.check(link.name())
    }

    /// The pushes of the world.
    pub fn pushes(&self) -> &[Push] {
        &self.pushes
    }
}

/// The force of a push in the time of the run.
#[derive(Clone)]
pub(crate) struct Thrust {
    /// Where the path is 1 (N).
    force: Vector3<f64>,
    path: Path,
    /// From when to when (s).
    span: (f64, f64),
}

impl Thrust {
    /// The force (N) at a time of the run; outside of the span too, as at its ends.
    pub(crate) fn at(&self, time: f64) -> Vector3<f64> {
        self.force * self.path.at(time).position
    }

    /// The force from a time on, where there is one; `near` is what two times may differ by that are the same.
    pub(crate) fn after(&self, time: f64, near: f64) -> Option<&Self> {
        (self.span.0 <= time + near && time + near < self.span.1).then_some(self)
    }

    /// The force over a stretch without breaks inside: see [`Path::during`].
    pub(crate) fn during(&self, from: f64, to: f64) -> Self {
        Self { path: self.path.during(from, to), ..self.clone() }
    }

    /// The times of the run at which it may jump.
    pub(crate) fn breaks(&self) -> impl Iterator<Item = f64> {
        [self.span.0, self.span.1].into_iter().chain(self.path.breaks())
    }
}
