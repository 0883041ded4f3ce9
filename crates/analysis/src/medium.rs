//! Forces of the medium that a figure moves in.

mod fluid;

use crate::carrier::Carrier;
use crate::loads::Loads;
use crate::prepared::{PreparedMotion, StateError};
use fluid::Fluid;
use nalgebra::Vector3;
use solaris_dynamics::{DynamicsError, velocities};
use solaris_model::{Contact, Medium};
use std::collections::HashMap;

/// Why a medium has no forces in a motion.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MediumError {
    /// It acts on a link that the figure does not have.
    #[error("the medium acts on link '{link}', which figure '{figure}' does not have")]
    UnknownLink {
        /// The figure.
        figure: String,
        /// The link.
        link: String,
    },
    /// A state that cannot be computed with.
    #[error("at {time} s: {source}")]
    State {
        /// When (s).
        time: f64,
        /// Why.
        source: DynamicsError,
    },
}

/// What a medium does to the links of a figure in its motion: drag and lift of a fluid, and what carries links against
/// gravity; one wrench a link and sample.
///
/// # Source
///
/// MuJoCo 4.0's documentation, Computation, "Fluid forces" (both models) and `body/gravcomp`.
///
/// # Errors
///
/// Links that the figure does not have, and states that the kernel refuses.
#[doc(alias = "drag")]
#[doc(alias = "gravcomp")]
#[doc(alias = "qfrc_fluid")]
pub fn medium_forces(prepared: &PreparedMotion<'_>, medium: &Medium) -> Result<Loads, MediumError> {
    let figure = prepared.figure;
    let names: HashMap<&str, usize> =
        figure.links().iter().enumerate().map(|(i, link)| (link.name(), i)).collect();
    let find = |link: &String| {
        let unknown = || MediumError::UnknownLink { figure: figure.name().to_owned(), link: link.clone() };
        names.get(link.as_str()).copied().ok_or_else(unknown)
    };
    let immersed: Vec<usize> =
        medium.immersed.iter().map(|part| find(&part.link)).collect::<Result<_, _>>()?;
    let carried: Vec<usize> = medium.carried.iter().map(|part| find(&part.link)).collect::<Result<_, _>>()?;
    let fluids: Vec<Fluid> = medium.immersed.iter().map(|part| Fluid::of(medium, part)).collect();
    let mut links: Vec<usize> = immersed.iter().chain(&carried).copied().collect();
    links.sort_unstable();
    links.dedup();
    let gravity = prepared.motion.info.gravity;
    let frames = prepared.frames(|workspace, row| {
        velocities(&prepared.tree, workspace, prepared.q(row), prepared.v(row))?;
        let mut wrenches = vec![Contact::default(); links.len()];
        let mut push = |link: usize, point: Vector3<f64>, force: Vector3<f64>, moment: Vector3<f64>| {
            if let Ok(at) = links.binary_search(&link) {
                wrenches[at].force += force;
                wrenches[at].moment += moment + point.cross(&force);
            }
        };
        for ((part, fluid), &link) in medium.immersed.iter().zip(&fluids).zip(&immersed) {
            let (pose, twist) = (workspace.pose(link), workspace.velocity(link));
            let axes = pose.rotation * part.at.rotation.to_rotation_matrix().matrix();
            let arm = pose.rotation * part.at.translation.vector;
            let velocity = twist.linear + twist.angular.cross(&arm) - medium.wind;
            let (force, moment) = fluid.act(&axes.tr_mul(&velocity), &axes.tr_mul(&twist.angular));
            push(link, pose.translation + arm, axes * force, axes * moment);
        }
        for (part, &link) in medium.carried.iter().zip(&carried) {
            let pose = workspace.pose(link);
            push(link, pose.translation + pose.rotation * part.at, -gravity * part.mass, Vector3::zeros());
        }
        Ok(wrenches)
    });
    let frames = frames.map_err(|StateError { time, source }| MediumError::State { time, source })?;
    let track = |(i, &link): (usize, &usize)| {
        (Carrier::of_one(link), frames.iter().map(|wrenches| wrenches[i]).collect())
    };
    Ok(Loads::of(links.iter().enumerate().map(track)))
}
