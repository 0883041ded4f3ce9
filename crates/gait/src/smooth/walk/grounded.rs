//! What a walk over ground that is not level does at each contact and in each swing.
//!
//! A foot lands as on the slope of the step in, and stands and pushes off as on that of the step out; the body between them is that of
//! the mean of both.

use super::gaits::{Contact, Gait, LandingLaw, SwingLaw};
use super::standing::Standing;
use super::terrain::{StepKind, Terrain};
use crate::body::Body;
use crate::error::GaitError;
use crate::limbs::path::Passing;
use crate::request::Resolution;
use crate::smooth::stair_numbers::{StairNumbers, nosing};
use crate::smooth::stride::StridePlan;
use crate::smooth::style::Style;
use solaris_model::Relief;

/// How much the body is that of stairs over the print before they lead down.
const DOWN_FROM: f64 = 0.75;

/// A walk's ground, and what is done on it.
pub(crate) struct Grounded {
    pub(super) relief: Relief,
    /// Pitch of the ground under the standing feet (rad).
    pub(super) standing: f64,
    /// By contact, from the standing feet to the closing one.
    pub(super) contacts: Vec<Contact>,
    /// By the contact that a swing ends in.
    pub(super) swings: Vec<SwingLaw>,
}

/// Strides that were planned already.
struct Strides<'a> {
    body: &'a Body,
    style: &'a dyn Fn(StepKind) -> Result<Style, GaitError>,
    resolution: Resolution,
    known: Vec<(StepKind, Gait)>,
}

impl Strides<'_> {
    fn of(&mut self, kind: StepKind) -> Result<Gait, GaitError> {
        if let Some((_, gait)) = self.known.iter().find(|(known, _)| *known == kind) {
            return Ok(gait.clone());
        }
        let stride = StridePlan::plan(self.body.clone(), &(self.style)(kind)?, self.resolution)?;
        let gait = Gait::of(&stride);
        self.known.push((kind, gait.clone()));
        Ok(gait)
    }

    /// Between two kinds of steps.
    fn between(&mut self, before: StepKind, after: StepKind) -> Result<Gait, GaitError> {
        match (before, after) {
            (StepKind::Slope(a, s), StepKind::Slope(b, t)) => {
                self.of(StepKind::Slope(0.5 * (a + b), 0.5 * (s + t)))
            }
            // At the top of stairs the body stands as on them: it rises to its height on the level after that.
            (StepKind::Stairs { rise, .. }, StepKind::Slope(..)) if rise > 0.0 => self.of(before),
            // Over the last level print before they lead down the knee bends as on stairs.
            (StepKind::Slope(..), StepKind::Stairs { rise, .. }) if rise < 0.0 => {
                Ok(self.of(before)?.mixed(&self.of(after)?, DOWN_FROM))
            }
            _ if before == after => self.of(before),
            _ => Ok(self.of(before)?.mixed(&self.of(after)?, 0.5)),
        }
    }
}

impl Grounded {
    /// On a terrain, in the style of each kind of step, of a pace whose level steps are `usual` long (m).
    pub(crate) fn new(
        body: &Body,
        terrain: &Terrain,
        usual: f64,
        style: &dyn Fn(StepKind) -> Result<Style, GaitError>,
        resolution: Resolution,
    ) -> Result<Self, GaitError> {
        let Terrain { relief, steps, kinds, standing } = terrain;
        let n = steps.len();
        let length = |kind: Option<&StepKind>| match kind {
            Some(StepKind::Slope(_, length)) => *length,
            _ => usual,
        };
        let ends = [
            StepKind::Slope(*standing, length(kinds.first())),
            StepKind::Slope(steps[n - 1].tilt, length(kinds.last())),
        ];
        // The kind of the step that ends in a contact, and of the one that begins there.
        let into = |k: usize| if k == 0 { ends[0] } else { kinds.get(k - 1).copied().unwrap_or(ends[1]) };
        let out = |k: usize| kinds.get(k).copied().unwrap_or(ends[1]);
        let mut strides = Strides { body, style, resolution, known: Vec::new() };
        let mut contacts = Vec::with_capacity(n + 2);
        for k in 0..n + 2 {
            let gait = strides.between(into(k), out(k))?;
            let landed = strides.of(into(k))?;
            let landing = LandingLaw {
                style: landed.style,
                knee: landed.contact_knee,
                thigh: landed.contact_thigh,
                straightest: landed.style.knee_contact,
            };
            contacts.push(Contact { gait, landing, push: style(out(k))? });
        }
        // The feet stand before the walk and after it as the first and last contact's style has it.
        let stood = [(0, *standing), (n + 1, steps[n - 1].tilt)]
            .map(|(k, tilt)| Standing::new(body, &contacts[k].gait.style, tilt));
        for (k, contact) in contacts.iter_mut().enumerate() {
            contact.gait.standing = stood[usize::from(2 * k > n)];
        }
        let places: Vec<[f64; 2]> = std::iter::once([0.0, 0.0])
            .chain(steps.iter().scan([0.0, 0.0], |[z, y], step| {
                (*z, *y) = (*z + step.length, *y + step.rise);
                Some([*z, *y])
            }))
            .collect();
        let swings = (0..n + 2)
            .map(|k| {
                let (to, from) = (k.min(n), k.saturating_sub(2).min(n));
                let is_stair = |kind: &StepKind| matches!(kind, StepKind::Stairs { .. });
                let stairs = [into(k.saturating_sub(1)), into(k)].into_iter().find(is_stair);
                let stair = stairs.filter(|_| k >= 1 && k <= n);
                let slope =
                    (places[to][1] - places[from][1]).atan2((places[to][0] - places[from][0]).max(0.05));
                let style = match stair {
                    Some(kind) => style(kind)?,
                    None => style(StepKind::Slope(
                        slope,
                        0.5 * (length(Some(&into(k))) + length(Some(&into(k.saturating_sub(1))))),
                    ))?,
                };
                let stepped = [into(k.saturating_sub(1)), into(k)].map(|kind| is_stair(&kind));
                let passings = style.stairs.map_or_else(Vec::new, |stairs| {
                    let at = [from, k.saturating_sub(1), k].map(|k| places[k.min(n)]);
                    passings(&stairs, stepped, at, style.step_length, body)
                });
                Ok(SwingLaw { style, passings })
            })
            .collect::<Result<_, GaitError>>()?;
        Ok(Self { relief: relief.clone(), standing: *standing, contacts, swings })
    }
}

/// How much of its pitch over an edge a foot has where the step that it makes then is level: with none the ankle would bend by 50° on the
/// way to the first stair down.
const LEVEL_PITCH: f64 = 0.5;

/// The nosings that a foot passes between its print, that of the other foot and its next one ([z, y], m), seen from its print: those of
/// the steps that are `stairs`.
fn passings(
    stairs: &StairNumbers,
    stepped: [bool; 2],
    [from, beside, to]: [[f64; 2]; 3],
    tread: f64,
    body: &Body,
) -> Vec<Passing> {
    let nosing = nosing(stairs.rise, tread, body.leg.foot_length());
    let edges = if stairs.rise > 0.0 { [beside, to] } else { [from, beside] };
    let passed = (0..2).map(|i| {
        let ([z, y], (at, above, pitch)) = (edges[i], stairs.passings[i]);
        let place = stepped[i].then_some([y - from[1] + above, z - from[0] + nosing]);
        let pitch = if stepped[i] { pitch } else { LEVEL_PITCH * pitch };
        Passing { at, end: stairs.end(), pitch, place }
    });
    passed.collect()
}
