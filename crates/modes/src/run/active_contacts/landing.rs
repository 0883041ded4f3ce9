//! Landings: plastic impacts of what comes down.

use super::{REST, ROUNDING, Scene, Tried};
use crate::body::Pressed;
use crate::contact::Surface;
use crate::failure::RunError;
use crate::phase::Role;
use crate::report::Landing;
use crate::run::guard;
use crate::run::pass::Pass;

impl Pass {
    /// The impact of these contact points, which are on the ground, as a plastic one: those that the ground would have to pull are let
    /// go, and what would go into it is stopped as well. What stands afterwards.
    ///
    /// ```text
    /// M·(v⁺ − v⁻) = Jᵀ·P        J·v⁺ = 0 and P of every lever ≥ 0 for what stands, n·v⁺ ≥ 0 for all that is on the ground
    /// ```
    pub(super) fn land(
        &mut self,
        surface: &Surface,
        scene: &Scene,
        mut held: Vec<usize>,
    ) -> Result<Vec<usize>, RunError> {
        let time = self.t;
        let failed = |error| RunError::from(guard::of_dynamics(time, error));
        let stops = |touch: &Pressed<f64>| touch.rate > REST || touch.slip.norm() > REST;
        let moved: Vec<bool> = scene.contact_points.iter().map(stops).collect();
        let down: Vec<bool> = scene.contact_points.iter().map(|touch| touch.rate > REST).collect();
        let speed =
            scene.contact_points.iter().map(|touch| touch.slip.norm() + touch.rate.abs()).fold(0.0, f64::max);
        let nv = self.v.len();
        let (mut jump, mut impulse) = (vec![0.0; nv], vec![0.0; nv]);
        let (mut tried, mut last) = (Tried::default(), None);
        let comes =
            |part: usize| (0..down.len()).any(|i| down[i] && scene.closed[i] && scene.parts[i] == Some(part));
        self.active.sliding.retain(|part| !comes(*part));
        let holds = loop {
            tried.check(&mut held, last, self, (surface, scene))?;
            let holds = self.patches(surface, scene, &held);
            self.body.plant(&holds);
            jump.fill(0.0);
            impulse.fill(0.0);
            // What rests at a limit is stopped with the rest.
            let prescribed: Vec<bool> = self.roles().iter().map(|role| *role != Role::Dynamic).collect();
            self.body.impact((&self.q, &self.v), &prescribed, &mut jump, &mut impulse).map_err(failed)?;
            self.passed.counts.evaluations += 1;
            let pulled = (0..nv).find(|&dof| {
                let held = self.driven[dof].held;
                let most = impulse.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                held.is_some_and(|(side, _)| impulse[dof] * side.outward() > ROUNDING * most)
            });
            if let Some(dof) = pulled {
                self.driven[dof].held = None;
                tried = Tried::default();
                continue;
            }
            if let Some((pull, released)) = self.worst_pull(surface, scene, &holds, 0.0) {
                tried.pull = tried.pull.max(pull);
                held.retain(|touch| !released.contains(touch));
                continue;
            }
            self.check_denied(&holds, surface, speed)?;
            let after: Vec<f64> = self.v.iter().zip(&jump).map(|(v, jump)| v + jump).collect();
            let rates: Vec<f64> =
                self.body.touching(&self.q, &after).map_err(failed)?.map(|touch| touch.rate).collect();
            let sinks = (0..rates.len())
                .filter(|&i| scene.closed[i] && !held.contains(&i) && !scene.is_shut(&holds, i))
                .filter(|&i| rates[i] > REST.max(ROUNDING * speed))
                .max_by(|i, j| rates[*i].total_cmp(&rates[*j]));
            let Some(sinks) = sinks else { break holds };
            tried.sink = tried.sink.max(rates[sinks]);
            held.push(sinks);
            last = Some(sinks);
        };
        let total = self.body.patch_wrenches().fold([0.0; 3], |mut sum, wrench| {
            sum.iter_mut().zip(wrench.force.iter()).for_each(|(sum, force)| *sum += force);
            sum
        });
        let before = self.body.energy(&self.q, &self.v).map_err(failed)?.kinetic;
        self.v.iter_mut().zip(&jump).for_each(|(v, jump)| *v += jump);
        let loss = before - self.body.energy(&self.q, &self.v).map_err(failed)?.kinetic;
        self.passed.ledger.lose(loss);
        self.passed.jumps = true;
        for (sum, part) in self.passed.ground.iter_mut().zip(total) {
            *sum += part;
        }
        let mut links: Vec<String> = Vec::new();
        for touch in holds.iter().flat_map(|hold| &hold.contact_points).filter(|touch| moved[**touch]) {
            let name = self.simulation.figure.links()[surface.contact_points[*touch].link].name();
            if !links.iter().any(|other| other == name) {
                links.push(name.to_owned());
            }
        }
        self.passed.landings.push(Landing { time: self.t, links, impulse: total, loss });
        Ok(held)
    }
}
