//! Standing: which patches stay, by the forces that this takes.

use super::{REST, ROUNDING, SHORTEST_FLIGHT, Scene, Tried};
use crate::contact::{CALM, Surface};
use crate::failure::RunError;
use crate::run::guard;
use crate::run::pass::Pass;

/// Rounds at one instant after which there is no end to be expected, for each touch.
const MOST_ROUNDS: usize = 50;

impl Pass {
    /// Of the contact points that are on the ground, those that stay there, beginning with `held` and never again with what was
    /// `tried`: levers that would pull give way, the worst first, and what then would go into the ground is held again.
    pub(super) fn stand(
        &mut self,
        surface: &Surface,
        scene: &mut Scene,
        mut held: Vec<usize>,
        mut tried: Tried,
    ) -> Result<Vec<usize>, RunError> {
        let weight = self.simulation.weight();
        let mut last = None;
        // What slid and has come to rest may stay.
        let slides = |part: usize| {
            held.iter().any(|&i| scene.parts[i] == Some(part) && scene.contact_points[i].slip.norm() > REST)
        };
        self.active.sliding.retain(|part| slides(*part));
        for _ in 0..MOST_ROUNDS * (1 + surface.contact_points.len()) {
            tried.check(&mut held, last, self, (surface, scene))?;
            let holds = self.patches(surface, scene, &held);
            self.body.plant(&holds);
            let (prescribed, mut a, mut tau) = self.given();
            let failed = |error| RunError::from(guard::of_dynamics(self.t, error));
            self.body.hybrid(&self.q, &self.v, &prescribed, &mut a, &mut tau).map_err(failed)?;
            self.passed.counts.evaluations += 1;
            if let Some((pull, released)) = self.worst_pull(surface, scene, &holds, weight) {
                tried.pull = tried.pull.max(pull);
                held.retain(|touch| !released.contains(touch));
                continue;
            }
            let rises: Vec<f64> = self.body.rises(&self.q, &self.v, &a).map_err(failed)?.collect();
            let scale = rises.iter().fold(self.simulation.gravity.norm(), |most, x| most.max(x.abs()));
            self.check_denied(&holds, surface, scale)?;
            let open = |i: &usize| scene.closed[*i] && !held.contains(i) && !scene.is_shut(&holds, *i);
            let mut next: Option<(f64, usize)> = None;
            for touch in (0..rises.len()).filter(open) {
                let (away, rise) = (-scene.contact_points[touch].rate, rises[touch]);
                // What stands does so with a velocity that dies out.
                if rise >= -ROUNDING * scale - REST / CALM {
                    continue;
                }
                let flight = 2.0 * away.max(0.0) / -rise;
                // What comes back at once has not left: what velocity it has dies out.
                let stays = away <= REST
                    || (flight < SHORTEST_FLIGHT && scene.contact_points[touch].slip.norm() <= REST);
                if !stays {
                    // The next step has to see it off the ground.
                    self.cap = self.cap.min(self.t + 0.5 * flight);
                } else if next.is_none_or(|(least, _)| rise < least) {
                    next = Some((rise, touch));
                }
            }
            let Some((rise, touch)) = next else { return Ok(held) };
            tried.sink = tried.sink.max(-rise);
            held.push(touch);
            last = Some(touch);
            let slides = scene.parts[touch].is_some_and(|part| self.active.sliding.contains(&part));
            if !slides && scene.contact_points[touch].slip.norm() > REST {
                // It has a velocity that it must not keep, unless to stop it the ground would have to pull.
                held = self.land(surface, scene, held)?;
                *scene = self.scene(surface, &[])?;
                if !held.contains(&touch) {
                    self.let_slide(&tried, Some(touch), (surface, scene))?;
                    held.push(touch);
                }
                (tried, last) = (Tried::default(), None);
            }
        }
        self.no_contacts(&tried, last, (surface, scene))
    }
}
