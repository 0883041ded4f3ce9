//! What acts at the present instant of a run: forces of the joints, and of the ground.

use super::carries::LoadedBody;
use super::guard;
use super::pushes;
use super::running::Progress;
use crate::failure::{RunError, SetupError};
use nalgebra::Vector3;
use solaris_dynamics::Wrench;
use solaris_model::Contact;
use std::sync::Arc;

/// What the ground does to a link at an instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touching {
    /// Index of the link.
    pub link: usize,
    /// Force (N), moment about the world's origin (N m) and centre of pressure (m), in world axes.
    pub contact: Contact,
}

/// The whole figure, and room for what is found.
#[derive(Clone)]
pub(crate) struct Present {
    loaded: LoadedBody,
    tau: Vec<f64>,
    acting: Vec<(usize, Wrench<f64>)>,
    touching: Vec<Touching>,
}

impl Present {
    /// Of what is run by now.
    pub(crate) fn of(progress: &Progress) -> Result<Self, SetupError> {
        let simulation = &progress.pass.simulation;
        Ok(Self {
            loaded: LoadedBody::new(simulation, progress.pass.by_impulses())?,
            tau: vec![0.0; progress.pass.v.len()],
            acting: Vec::new(),
            touching: Vec::new(),
        })
    }

    /// The forces of the joints (N m or N, `nv`), with those of limits that hold something.
    pub(crate) fn forces(&mut self, progress: &mut Progress) -> Result<&[f64], RunError> {
        progress.accelerations()?;
        self.acting.clear();
        self.acting.extend(progress.pressed().chain(progress.between()));
        let pass = &progress.pass;
        self.loaded.go_to(&pass.simulation, pass.t)?;
        let body = &mut self.loaded.body;
        for (push, force) in pushes::after(&pass.thrusts, pass.t) {
            body.set_push(push, &force);
        }
        body.inverse(&pass.q, &pass.v, &pass.a, &self.acting, &mut self.tau)
            .map_err(|error| guard::of_dynamics(pass.t, error))?;
        pass.simulation.figure.fold_forces(&pass.q, &mut self.tau);
        Ok(&self.tau)
    }

    /// What the ground does to every link that it presses, in the order of the links.
    pub(crate) fn contacts(&mut self, progress: &mut Progress) -> Result<&[Touching], RunError> {
        self.touching.clear();
        // Shared, so that what is run may be asked meanwhile.
        let simulation = Arc::clone(&progress.pass.simulation);
        let Some(surface) = &simulation.surface else { return Ok(&self.touching) };
        if surface.plants() || progress.pass.by_impulses() {
            progress.accelerations()?;
            for (link, wrench) in progress.pressed() {
                add(&mut self.touching, link, &wrench);
            }
        } else {
            let pass = &progress.pass;
            let found = self.loaded.body.touching(&pass.q, &pass.v);
            let found = found.map_err(|error| guard::of_dynamics(pass.t, error))?;
            for (touch, pressed) in surface.contact_points.iter().zip(found) {
                if pressed.force != Vector3::zeros() {
                    add(
                        &mut self.touching,
                        touch.link,
                        &Wrench::at(&pressed.point, pressed.force, Vector3::zeros()),
                    );
                }
            }
        }
        for Touching { contact, .. } in &mut self.touching {
            let whole = Wrench { force: contact.force, moment: contact.moment };
            let plane = &surface.plane;
            contact.cop = whole.center_of_pressure(&plane.up, plane.height).unwrap_or_default();
        }
        self.touching.sort_unstable_by_key(|touching| touching.link);
        Ok(&self.touching)
    }
}

/// Adds a wrench to what acts on its link.
fn add(touching: &mut Vec<Touching>, link: usize, wrench: &Wrench<f64>) {
    let at = touching.iter().position(|other| other.link == link).unwrap_or_else(|| {
        touching.push(Touching { link, contact: Contact::default() });
        touching.len() - 1
    });
    touching[at].contact.force += wrench.force;
    touching[at].contact.moment += wrench.moment;
}
