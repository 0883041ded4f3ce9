//! Event functions of a phase.

use super::Phase;
use super::small::Small;
use nalgebra::Vector3;

/// What is watched for: an event is where the function passes through zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Watched {
    /// `q[coordinate] − value`, of the full figure.
    Position { dof: usize, value: f64 },
    /// `outwards·(k·(q[dof] − limit) + c·v[dof])`, of the full figure: the push of a limit's spring and damper.
    Push { dof: usize, limit: f64, outwards: f64, stiffness: f64, damping: f64 },
    /// `v[dof] − value`, of the full figure.
    Velocity { dof: usize, value: f64 },
    /// The force that holds a prescribed degree of freedom, less that of its drive: where it passes through zero a limit lets go.
    Hold { dof: usize },
    /// How far a sphere that can touch the ground is above it (m), and `below` (m).
    Gap { touch: usize, below: f64 },
    /// How far the lowest point of a link is above the ground (m), less `off` (m).
    Near { link: usize, off: f64 },
    /// The force of a lever of a contact patch, by their indices, as a part of the weight, and `slack`.
    Lever { hold: usize, lever: usize, slack: f64 },
    /// What a servo of a degree of freedom asks for, by its place among those of its drive, less what its motor gives at most
    /// on this side.
    Saturation { dof: usize, servo: usize, most: f64 },
}

impl Phase {
    /// The values of what is watched for in a state.
    pub(super) fn watched_values(&mut self, t: f64, y: &[f64], values: &mut [f64]) {
        let seen = self.see(t, y);
        let small = self.small.as_ref().filter(|_| seen);
        for (value, watched) in values.iter_mut().zip(&self.watched) {
            let position = |dof: usize| {
                let entry = self.state.position_of(dof);
                entry.map_or_else(|| self.prescribed.at(dof, t)[0], |entry| y[entry])
            };
            let velocity = |dof: usize| {
                let entry = self.state.velocity_of(dof);
                entry.map_or_else(|| self.prescribed.at(dof, t)[1], |entry| y[entry])
            };
            *value = match *watched {
                Watched::Position { dof, value } => position(dof) - value,
                Watched::Velocity { dof, value } => velocity(dof) - value,
                Watched::Push { dof, limit, outwards, stiffness, damping } => {
                    outwards * (stiffness * (position(dof) - limit) + damping * velocity(dof))
                }
                Watched::Hold { dof } => {
                    let own = self.held.iter().find(|(held, _)| *held == dof);
                    let [position, velocity, _] = self.prescribed.at(dof, t);
                    let drive = own.map_or(0.0, |(_, force)| force.at(t, (position, velocity)));
                    small.and_then(|small| small.force(dof)).map_or(f64::NAN, |force| force - drive)
                }
                Watched::Gap { touch, below } => {
                    small.and_then(|small| small.lowest(touch)).map_or(f64::NAN, |(_, gap)| gap + below)
                }
                Watched::Near { link, off } => {
                    small.and_then(|small| self.nearest(small, link)).map_or(f64::NAN, |gap| gap - off)
                }
                Watched::Saturation { dof, servo, most } => {
                    self.demand(dof, servo, t, y).map_or(f64::NAN, |demand| demand - most)
                }
                Watched::Lever { hold, lever, slack } => {
                    small.map_or(f64::NAN, |small| self.lever(small, hold, lever) + slack)
                }
            };
        }
    }

    /// What a servo of a degree of freedom that dynamics move asks for.
    fn demand(&self, dof: usize, servo: usize, t: f64, y: &[f64]) -> Option<f64> {
        let (position, velocity) = self.state.position_of(dof).zip(self.state.velocity_of(dof))?;
        let force = self.prescribed.force(velocity - self.state.positions());
        Some(force.servos().nth(servo)?.demand(t, (y[position], y[velocity])))
    }

    /// Finds what the watched needs in a state; whether there is any of it. A state that the dynamics refuse has none: its rate
    /// says so.
    fn see(&mut self, t: f64, y: &[f64]) -> bool {
        let Some(small) = &mut self.small else { return false };
        let any = |is: fn(&Watched) -> bool| self.watched.iter().any(is);
        if any(|watched| matches!(watched, Watched::Hold { .. } | Watched::Lever { .. })) {
            small.solve(&self.prescribed, t, y).is_ok()
        } else if any(|watched| matches!(watched, Watched::Gap { .. } | Watched::Near { .. })) {
            small.place(&self.prescribed, t, y).is_ok()
        } else {
            false
        }
    }

    /// How far the lowest point of a link of the full figure is above the ground (m).
    fn nearest(&self, small: &Small, link: usize) -> Option<f64> {
        let points = self.source.surface.as_ref()?.contact_points.iter().enumerate();
        let gaps =
            points.filter(|(_, point)| point.link == link).filter_map(|(touch, _)| small.lowest(touch));
        gaps.map(|(_, gap)| gap).min_by(f64::total_cmp)
    }

    /// The force of a lever as a part of the weight.
    fn lever(&self, small: &Small, hold: usize, lever: usize) -> f64 {
        let Some(surface) = &self.source.surface else { return f64::NAN };
        let arm = self.planted[hold].levers[lever].arm;
        let at = |touch| small.lowest(touch).map_or_else(Vector3::zeros, |(point, _)| point);
        let wrench = small.patch_wrenches().nth(hold);
        wrench.map_or(f64::NAN, |wrench| arm.force(&wrench, at, &surface.plane.up) / self.weight)
    }
}
