//! The centre of mass and the points of the soles over the samples.

use super::MetricsInput;
use crate::error::{GaitError, MeasureError};
use crate::measure::window::samples_between;
use nalgebra::Vector3;
use solaris_analysis::ground::PlacedFeet;
use solaris_dynamics::{Workspace, center_of_mass, centroidal_momentum, centroidal_momentum_rate};

/// A number or a place for each sample, in world axes.
pub(super) struct Tracks<'a> {
    pub(super) time: &'a [f64],
    /// The direction against gravity.
    pub(super) up: Vector3<f64>,
    /// Body weight (N).
    pub(super) weight: f64,
    /// Height of the ground along up (m), and its velocity (m/s).
    pub(super) level: f64,
    pub(super) belt: Vector3<f64>,
    /// Place, velocity and acceleration of the centre of mass (m, m/s, m/s²).
    pub(super) com: Vec<Vector3<f64>>,
    pub(super) velocity: Vec<Vector3<f64>>,
    pub(super) acceleration: Vec<Vector3<f64>>,
    feet: Option<&'a PlacedFeet<'a>>,
}

impl<'a> Tracks<'a> {
    pub(super) fn of(given: &MetricsInput<'a>) -> Result<Self, GaitError> {
        let MetricsInput { motion: prepared, feet, .. } = *given;
        let (motion, tree) = (prepared.motion(), prepared.tree());
        let gravity = motion.info.gravity;
        let up = prepared.up().ok_or(MeasureError::NoGravity { gravity: gravity.into() })?;
        let rows = motion.len();
        let fits = |what, found, expected| {
            if found == expected { Ok(()) } else { Err(MeasureError::OtherMotion { what, found, expected }) }
        };
        fits("the times", rows, rows.max(1))?;
        fits("the feet's motion", feet.map_or(rows, |feet| feet.frames().len()), rows)?;
        if let Some(contacts) = given.contacts {
            fits("the forces", contacts.len(), given.soles().len())?;
            contacts.iter().try_for_each(|track| fits("a foot's force", track.samples.len(), rows))?;
        }
        let mut tracks = Self {
            time: motion.time(),
            up,
            weight: tree.mass() * gravity.norm(),
            level: given.stances.map_or(0.0, |stances| stances.level),
            belt: given.stances.map_or_else(Vector3::zeros, |stances| stances.belt),
            com: Vec::with_capacity(rows),
            velocity: Vec::with_capacity(rows),
            acceleration: Vec::with_capacity(rows),
            feet,
        };
        let (mut workspace, mass) = (Workspace::new(tree), tree.mass());
        for row in 0..rows {
            let (q, v, a) = (motion.q(row), motion.v(row), motion.a(row));
            tracks.com.push(center_of_mass(tree, &mut workspace, q)?);
            tracks.velocity.push(centroidal_momentum(tree, &mut workspace, q, v)?.linear / mass);
            tracks.acceleration.push(centroidal_momentum_rate(tree, &mut workspace, q, v, a)?.force / mass);
        }
        Ok(tracks)
    }

    /// Heel, ball and tip of a foot (m); `None` where there is no such foot.
    pub(super) fn points(&self, foot: usize, sample: usize) -> Option<&'a [Vector3<f64>; 3]> {
        Some(&self.feet?.frame(sample).get(foot)?.points)
    }

    /// Height of a point above the ground (m).
    pub(super) fn height(&self, point: &Vector3<f64>) -> f64 {
        point.dot(&self.up) - self.level
    }

    /// The level part of a vector.
    pub(super) fn level(&self, vector: &Vector3<f64>) -> Vector3<f64> {
        vector - self.up * vector.dot(&self.up)
    }

    /// From when to when the motion lasts (s).
    pub(super) fn span(&self) -> (f64, f64) {
        (self.time.first().copied().unwrap_or_default(), self.time.last().copied().unwrap_or_default())
    }

    /// The samples from one time to another, ends included.
    pub(super) fn samples(&self, span: (f64, f64)) -> std::ops::Range<usize> {
        samples_between(self.time, span)
    }
}
