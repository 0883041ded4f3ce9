//! The paces of a walk, and which of them a clock belongs to.

use super::course::{Episode, Step};
use super::standing::Standing;
use super::tempo::{Tempo, smooth_step};
use crate::error::GaitError;
use crate::limbs::path::Passing;
use crate::limbs::stance::Landing;
use crate::smooth::laws;
use crate::smooth::stride::StridePlan;
use crate::smooth::style::Style;
use nalgebra::Vector3;
use solaris_profiles::Clip;
use solaris_profiles::spline::CubicSpline;

/// Least flexion of a knee in the push on ground that is not level (rad).
const LEAST_PUSH_KNEE: f64 = 2.0 * std::f64::consts::PI / 180.0;

/// A pace: its style, and what its steady stride says.
#[derive(Clone)]
pub(crate) struct Gait {
    pub(super) style: Style,
    /// Mean height of the centre of mass (m).
    pub(super) mean_height: f64,
    /// Thigh and knee at contact (rad).
    pub(super) contact_thigh: f64,
    pub(super) contact_knee: f64,
    pub(super) standing: Standing,
    /// Rate of the angular momentum and centre of mass against the pelvis, by node.
    momentum_rate: Vec<Vector3<f64>>,
    com_offset: Vec<Vector3<f64>>,
    /// Flexion of the left knee, by node.
    knee: Vec<f64>,
}

impl Gait {
    pub(super) fn of(stride: &StridePlan) -> Self {
        let count = stride.node_count();
        let nodes = 0..count;
        Self {
            style: stride.style,
            mean_height: stride.mean_height(),
            contact_thigh: stride.contact.thigh.position,
            contact_knee: stride.contact.knee.position,
            standing: Standing::new(&stride.body, &stride.style, 0.0),
            momentum_rate: nodes.map(|node| stride.momentum_rate(node)).collect(),
            com_offset: stride.com_offset.clone(),
            knee: (0..count).map(|node| stride.knees(node as f64 / count as f64)[0]).collect(),
        }
    }

    /// Between this pace and another one of as many nodes.
    pub(super) fn mixed(&self, other: &Self, part: f64) -> Self {
        let mix = |a: f64, b: f64| a + (b - a) * part;
        let all =
            |a: &[Vector3<f64>], b: &[Vector3<f64>]| a.iter().zip(b).map(|(a, b)| a.lerp(b, part)).collect();
        Self {
            style: self.style.mixed(&other.style, part),
            mean_height: mix(self.mean_height, other.mean_height),
            contact_thigh: mix(self.contact_thigh, other.contact_thigh),
            contact_knee: mix(self.contact_knee, other.contact_knee),
            standing: self.standing,
            momentum_rate: all(&self.momentum_rate, &other.momentum_rate),
            com_offset: all(&self.com_offset, &other.com_offset),
            knee: self.knee.iter().zip(&other.knee).map(|(a, b)| mix(*a, *b)).collect(),
        }
    }

    /// Flexion of a knee in a steady stride, at the node next to a clock of its foot.
    pub(super) fn stance_knee(&self, v: f64) -> f64 {
        let count = self.knee.len();
        self.knee[((v * count as f64).round() as isize).rem_euclid(count as isize) as usize]
    }

    /// Rate of the angular momentum and centre of mass against the pelvis in a steady stride, at the node next to a clock.
    pub(super) fn steady(&self, u: f64) -> (Vector3<f64>, Vector3<f64>) {
        let count = self.momentum_rate.len();
        let node = ((u * count as f64).round() as isize).rem_euclid(count as isize) as usize;
        (self.momentum_rate[node], self.com_offset[node])
    }
}

/// What a foot does on one print: its pace's style with the double support in which it lifts, and where it is pressed.
pub(super) struct StanceLaw {
    pub(super) style: Style,
    /// How it lands, if it does.
    pub(super) landing: Landing,
    /// Least flexion of the knee in the push.
    pub(super) least_knee: f64,
    pub(super) cop: Clip<CubicSpline>,
}

impl StanceLaw {
    /// In this style, landing as `landing`.
    fn of(style: &Style, landing: &Style, least_knee: f64) -> Result<Self, GaitError> {
        Ok(Self { landing: landing.landing(), least_knee, cop: laws::cop_of(landing, style)?, style: *style })
    }

    /// Lands as `landing`, then stands and pushes off as `push`.
    fn merged(landing: &Style, push: &Style, double_support: f64) -> Result<Self, GaitError> {
        let style = Style {
            heel_strike_angle: landing.heel_strike_angle,
            knee_contact: landing.knee_contact,
            knee_contact_rate: landing.knee_contact_rate,
            knee_contact_acc: landing.knee_contact_acc,
            foot_flat: landing.foot_flat,
            double_support,
            ..*push
        };
        Self::of(&style, landing, LEAST_PUSH_KNEE)
    }
}

/// How a foot lands at a contact.
#[derive(Clone, Copy)]
pub(super) struct LandingLaw {
    pub(super) style: Style,
    /// Knee and thigh of a steady stride there, and the knee that it is hardly straighter than (rad).
    pub(super) knee: f64,
    pub(super) thigh: f64,
    pub(super) straightest: f64,
}

/// How a foot swings to a contact.
#[derive(Clone)]
pub(super) struct SwingLaw {
    pub(super) style: Style,
    /// Edges that it passes, if any: then its path is the law.
    pub(super) passings: Vec<Passing>,
}

/// A contact on ground that is not level.
#[derive(Clone)]
pub(super) struct Contact {
    pub(super) gait: Gait,
    pub(super) landing: LandingLaw,
    /// The style in which the foot then stands and pushes off.
    pub(super) push: Style,
}

/// The paces of a walk.
pub(super) struct Gaits {
    paces: Vec<Gait>,
    /// The pace of each contact, from the standing feet to the closing one.
    of_contact: Vec<usize>,
    /// By the contact before which a foot lifts.
    stances: Vec<StanceLaw>,
    /// By contact.
    landings: Vec<LandingLaw>,
    swings: Vec<SwingLaw>,
    pub(super) tempo: Tempo,
    /// Stride time of the fastest pace (s).
    pub(super) stride_time: f64,
}

impl Gaits {
    /// Of some strides and the steps that are taken with them; the feet stand before the first step in the manner of the pace
    /// `standing`.
    pub(super) fn new(strides: &[StridePlan], standing: usize, steps: &[Step]) -> Result<Self, GaitError> {
        let paces: Vec<Gait> = strides.iter().map(Gait::of).collect();
        let mut of_contact = vec![standing];
        of_contact.extend(steps.iter().map(|step| step.pace));
        of_contact.push(of_contact[steps.len()]);
        let stride_time = paces.iter().map(|pace| pace.style.stride_time).fold(f64::INFINITY, f64::min);
        let stances = (0..=of_contact.len())
            .map(|next| {
                let style_of = |contact: usize| &paces[of_contact[contact.min(of_contact.len() - 1)]].style;
                let double_support = style_of(next).double_support;
                let style = Style { double_support, ..*style_of(next.saturating_sub(1)) };
                StanceLaw::of(&style, &style, f64::NEG_INFINITY)
            })
            .collect::<Result<_, GaitError>>()?;
        let tempo = tempo(&paces, stride_time, standing, steps);
        let landing = |pace: &usize| {
            let Gait { style, contact_thigh, .. } = &paces[*pace];
            let knee = style.knee_contact;
            LandingLaw { style: *style, knee, thigh: *contact_thigh, straightest: knee }
        };
        let landings = of_contact.iter().map(landing).collect();
        let swing = |pace: &usize| SwingLaw { style: paces[*pace].style, passings: Vec::new() };
        let swings = of_contact.iter().map(swing).collect();
        Ok(Self { paces, of_contact, stances, landings, swings, tempo, stride_time })
    }

    /// On ground that is not level, where every contact has a pace of its own; a swing for the contact that it ends in.
    pub(super) fn on_ground(
        contacts: &[Contact],
        swings: &[SwingLaw],
        steps: &[Step],
    ) -> Result<Self, GaitError> {
        let last = contacts.len() - 1;
        let stances = (0..=contacts.len())
            .map(|next| {
                let contact = &contacts[next.saturating_sub(1)];
                let double_support = contacts[next.min(last)].gait.style.double_support;
                StanceLaw::merged(&contact.landing.style, &contact.push, double_support)
            })
            .collect::<Result<_, GaitError>>()?;
        let stride_time = contacts[0].gait.style.stride_time;
        Ok(Self {
            paces: contacts.iter().map(|contact| contact.gait.clone()).collect(),
            of_contact: (0..contacts.len()).collect(),
            stances,
            landings: contacts.iter().map(|contact| contact.landing).collect(),
            swings: swings.to_vec(),
            tempo: Tempo::new(vec![1.0; steps.len() + 1], steps.iter().map(|step| step.slower)),
            stride_time,
        })
    }

    /// How a foot lands at contact `k`.
    pub(super) fn landing(&self, k: usize) -> &LandingLaw {
        &self.landings[k.min(self.landings.len() - 1)]
    }

    /// The edges that a foot passes on its way to a print.
    pub(super) fn passings(&self, to: &Episode) -> &[Passing] {
        &self.swings[to.index.min(self.swings.len() - 1)].passings
    }

    /// The tempo of other steps of the same paces.
    pub(super) fn tempo_of(&self, standing: usize, steps: &[Step]) -> Tempo {
        tempo(&self.paces, self.stride_time, standing, steps)
    }

    /// The pace of contact `k`.
    pub(super) fn of_contact(&self, k: usize) -> &Gait {
        &self.paces[self.of_contact[k.min(self.of_contact.len() - 1)]]
    }

    /// The law of a foot on a print.
    pub(super) fn stance(&self, episode: &Episode) -> &StanceLaw {
        &self.stances[episode.next]
    }

    /// The style in which a foot swings from one print to the next.
    pub(super) fn swing(&self, from: &Episode, to: &Episode) -> Style {
        let double_support = self.stance(from).style.double_support;
        Style { double_support, ..self.swings[to.index.min(self.swings.len() - 1)].style }
    }

    /// The pace at a clock, and in a step in which it changes how much of which other one: over step k from that of contact
    /// k − 1 to that of contact k.
    pub(super) fn at(&self, u: f64) -> (&Gait, Option<(&Gait, f64)>) {
        let x = 2.0 * u;
        let last = self.of_contact.len() - 1;
        let k = (x.max(0.0) as usize).min(last);
        let (from, to) = (self.of_contact[k], self.of_contact[(k + 1).min(last)]);
        let other = (from != to && x > 0.0).then(|| (&self.paces[to], smooth_step(x - k as f64)));
        (&self.paces[from], other)
    }

    /// A number of the pace at a clock.
    pub(super) fn number(&self, u: f64, of: impl Fn(&Gait) -> f64) -> f64 {
        let (pace, other) = self.at(u);
        let value = of(pace);
        other.map_or(value, |(next, part)| value + (of(next) - value) * part)
    }
}

fn tempo(paces: &[Gait], stride_time: f64, standing: usize, steps: &[Step]) -> Tempo {
    let contacts = std::iter::once(standing).chain(steps.iter().map(|step| step.pace));
    let ratios = contacts.map(|pace| paces[pace].style.stride_time / stride_time);
    Tempo::new(ratios.collect(), steps.iter().map(|step| step.slower))
}
