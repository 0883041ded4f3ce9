//! One leg over a chain of steps: its stances, and the swings between them.

use super::footstep::{Footstep, Role};
use super::seam::Seam;
use super::step_forces::StepForces;
use crate::body::Body;
use crate::body::leg::{LegGeometry, LegPose};
use crate::limbs::jet::LegJet;
use crate::limbs::push::Push;
use crate::limbs::stance::{Footing, Landing, Stance};
use crate::limbs::swing::Swing;
use crate::running::style::RunStyle;
use crate::walking::Stood;
use nalgebra::Vector3;
use solaris_profiles::{Boundary, ProfileError};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// A knee that lands so much more bent than the style's does not go on bending, and how much straighter it may land.
const LANDING_RANGE: f64 = 25.0 * DEGREE;
const LANDING_STRAIGHTER: f64 = 4.0 * DEGREE;
/// Knee and ankle at which a foot in full run lands and leaves, and the parts that the waypoints near them have of what those of a swing from
/// standing, or to it, are more bent.
const KNEE_LANDS: f64 = 10.0 * DEGREE;
const ANKLE_LEAVES: f64 = -7.0 * DEGREE;
const BENT: (f64, f64) = (0.8, 1.0);
const FLEXED: (f64, f64) = (0.5, 0.2);
/// Over how much pitch a foot comes to be flat or begins to rise where the knee's law would press it through the ground.
const SOFT: f64 = 0.4 * DEGREE;
/// Flexion of a standing knee.
const KNEE_STANDING: f64 = 6.0 * DEGREE;
/// The foot's pitch at toe-off from which on the body is lowered.
const STEEP: f64 = 68.0 * DEGREE;

/// One stance of the leg, its clock and its print.
#[derive(Clone, Debug)]
struct Foothold {
    /// Which step of the chain it belongs to.
    step: usize,
    stance: Stance,
    lands: bool,
    /// When it touches and lifts (s), and the stride time that its clock goes by.
    time: f64,
    toe_off: Option<f64>,
    stride_time: f64,
    /// When it is flat, when its heel rises and when it rolls over the tip, by that clock.
    parts: [f64; 3],
    /// Of a left foot.
    print: Vector3<f64>,
    jets: Jets,
    /// As what it stands on in a walk.
    then: Option<Continued>,
}

/// A stance that a walk goes on with, from when on, with its own clock and print.
#[derive(Clone, Debug)]
struct Continued {
    from: f64,
    landed: f64,
    stride_time: f64,
    stance: Stance,
    print: Vector3<f64>,
}

impl Foothold {
    /// What it stands as at a time, the clock there, and the hip in the print's frame.
    fn at(&self, time: f64, hip: &Vector3<f64>) -> (&Stance, f64, Vector3<f64>) {
        match &self.then {
            Some(then) if time > then.from => {
                (&then.stance, (time - then.landed) / then.stride_time, hip - then.print)
            }
            _ => (&self.stance, (time - self.time) / self.stride_time, hip - self.print),
        }
    }
}

/// Of the leg as the foot lands and as it lifts.
#[derive(Clone, Copy, Debug, Default)]
struct Jets {
    landing: LegJet,
    lifting: LegJet,
}

/// A swing on its own clock, which is `toe_off` when the foot lifts and 1 when it lands.
#[derive(Clone, Debug)]
struct Swung {
    swing: Swing,
    from: f64,
    until: f64,
    toe_off: f64,
    stride_time: f64,
}

/// A leg over the chain: swings before, between and after its stances.
#[derive(Clone, Debug)]
pub(super) struct Leg {
    stances: Vec<Foothold>,
    swings: Vec<Swung>,
}

impl Leg {
    /// The leg on a side, for its hip as that of a left leg. Also by how much (m) the hip is too high at each of its contacts.
    pub(super) fn plan(
        body: &Body,
        side: usize,
        steps: &[Footstep],
        forces: &[StepForces],
        seams: [Option<&Seam>; 2],
        hip: &dyn Fn(f64) -> Vector3<f64>,
        (start, step, nodes): (f64, f64, usize),
    ) -> Result<(Self, Vec<(usize, f64)>), ProfileError> {
        let leg = &body.leg;
        let (mut stances, mut needs) = (Vec::new(), Vec::new());
        for (k, footstep) in steps.iter().enumerate() {
            for (_, role, time, toe_off) in footstep.feet().into_iter().filter(|foot| foot.0 == side) {
                let style = &footstep.style;
                let other = matches!(role, Role::LeavesFirst | Role::Closes);
                let aside = if other { forces[k].other_aside } else { forces[k].aside };
                let print = Vector3::new(aside, 0.0, forces[k].along);
                let stride_time = style.stride_time;
                let local = |u: f64| hip(time + u * stride_time) - print;
                let shape = Shape::of(role, style, toe_off.map(|toe_off| (toe_off - time) / stride_time));
                let mut stance = Stance::new(leg, &shape.footing, shape.landing, shape.push);
                let mut jets = Jets::default();
                let above = |hip: Vector3<f64>, ankle: Vector3<f64>, knee: f64| {
                    let d = hip - ankle;
                    d.y - (leg.reach_squared(knee) - d.x * d.x - d.z * d.z).max(0.2).sqrt()
                };
                let lands = shape.landing == Landing::Heel;
                if lands {
                    let pitch = -shape.heel_strike_angle;
                    let knee = shape.contact_knee;
                    let at = local(0.0);
                    let straightest = knee.position - LANDING_STRAIGHTER;
                    if role != Role::Closes {
                        needs.push((k, above(at, stance.ankle_on_heel(pitch), knee.position)));
                    }
                    let knee = stance.landing_knee(knee, straightest, pitch, LANDING_RANGE, &at);
                    stance.set_contact(knee, local)?;
                    jets.landing = stance.contact_jet(Some(knee), local);
                }
                if let Some(toe_off) = toe_off {
                    if role == Role::Runs {
                        let end = local((toe_off - time) / stride_time);
                        let lifted = above(end, stance.ankle_at_toe_off(STEEP), style.knee_toe_off);
                        if let Some((_, need)) = needs.last_mut() {
                            *need = need.max(lifted);
                        }
                    }
                    stance.set_push(local)?;
                    jets.lifting = stance.toe_off_jet(local);
                }
                match role {
                    Role::LeavesLast => {
                        needs.push((k, above(local(0.0), stance.flat_ankle(), KNEE_STANDING)));
                    }
                    Role::Stops => {
                        let end = hip(start + step * (nodes - 1) as f64) - print;
                        needs.push((steps.len(), above(end, stance.flat_ankle(), KNEE_STANDING)));
                    }
                    _ => {}
                }
                let then = seams[1].filter(|_| role == Role::Arrives).map(|seam| Continued {
                    from: time + shape.footing.flat * stride_time,
                    landed: seam.landed,
                    stride_time: seam.stride_time,
                    print: print + stance.flat_ankle() - seam.stance.flat_ankle(),
                    stance: seam.stance.clone(),
                });
                let parts = [shape.footing.flat, shape.push.heel_off, shape.push.tip_roll_at];
                stances.push(Foothold {
                    step: k,
                    stance,
                    lands,
                    time,
                    toe_off,
                    stride_time,
                    parts,
                    print,
                    jets,
                    then,
                });
            }
        }
        // The foot that swings at the seam with a walk comes from there, or goes there.
        let seams = seams.map(|seam| seam.filter(|seam| seam.side != side));
        let swings = swings(leg, &stances, steps, seams, hip, (start, step, nodes))?;
        Ok((Self { stances, swings }, needs))
    }

    /// When its foot stands, of which step, for times that count from `from` on.
    pub(super) fn stood(&self, from: f64) -> impl Iterator<Item = (usize, Stood)> {
        self.stances.iter().map(move |hold| {
            let at = |u: f64| hold.time + u * hold.stride_time - from;
            let [flat, heel_off, tip_roll] = hold.parts;
            let stays = hold.toe_off.is_none();
            let until = |time: f64| if stays { f64::INFINITY } else { time };
            let stood = Stood {
                landed: if hold.lands { at(0.0) } else { f64::NEG_INFINITY },
                flat: if hold.lands { at(flat) } else { f64::NEG_INFINITY },
                on_ball: false,
                heel_off: until(at(heel_off)),
                tip_roll: until(at(tip_roll)),
                toe_off: until(hold.toe_off.unwrap_or_default() - from),
            };
            (hold.step, stood)
        })
    }

    /// Moves its prints back along z (m).
    pub(super) fn back(&mut self, by: f64) {
        for hold in &mut self.stances {
            hold.print.z -= by;
            hold.then.iter_mut().for_each(|then| then.print.z -= by);
        }
    }

    /// By how much it is too short (m) for its foot on the ground.
    pub(super) fn short(&self, time: f64, hip: &Vector3<f64>) -> f64 {
        self.standing(time).map_or(0.0, |hold| {
            let (stance, clock, hip) = hold.at(time, hip);
            stance.short(clock, &hip)
        })
    }

    /// Where its foot stands at a time.
    fn standing(&self, time: f64) -> Option<&Foothold> {
        let next = self.stances.partition_point(|hold| hold.time <= time);
        let next = if self.stances.first().is_some_and(|hold| !hold.lands) { next.max(1) } else { next };
        let hold = &self.stances[next.checked_sub(1)?];
        hold.toe_off.is_none_or(|toe_off| time <= toe_off).then_some(hold)
    }

    /// The pose at a time (s), for the hip as that of a left leg.
    pub(super) fn pose(&self, leg: &LegGeometry, time: f64, hip: &Vector3<f64>) -> LegPose {
        if let Some(hold) = self.standing(time) {
            let (stance, clock, hip) = hold.at(time, hip);
            return stance.pose(clock, &hip);
        }
        let at = self.swings.partition_point(|swung| swung.until < time).min(self.swings.len() - 1);
        let Swung { swing, from, toe_off, stride_time, .. } = &self.swings[at];
        swing.pose(leg, toe_off + (time - from) / stride_time)
    }
}

/// The swings between the stances, before the first one and after the last one.
fn swings(
    leg: &LegGeometry,
    stances: &[Foothold],
    steps: &[Footstep],
    [comes, goes]: [Option<&Seam>; 2],
    hip: &dyn Fn(f64) -> Vector3<f64>,
    (start, step, nodes): (f64, f64, usize),
) -> Result<Vec<Swung>, ProfileError> {
    let mut swings = Vec::new();
    for i in 0..=stances.len() {
        // Before the first stance it swings as if there had been one like it, after the last one as if there came another.
        let (from, to) = (i.saturating_sub(1), i.min(stances.len() - 1));
        let (before, after) = (&stances[from], &stances[to]);
        let (comes, goes) = (comes.filter(|_| i == 0), goes.filter(|_| i == stances.len()));
        let begin = match comes {
            Some(seam) => Some(seam.at),
            None if i == 0 => after.toe_off.map(|t| t - after.stride_time),
            None => before.toe_off,
        };
        let end = match goes {
            Some(seam) => seam.at,
            None if i == stances.len() => before.time + before.stride_time,
            None => after.time,
        };
        let Some(begin) = begin.filter(|_| i > 0 || after.lands) else { continue };
        let (first, last) = (&steps[before.step].style, &steps[after.step].style);
        let duty = first.duty;
        let stride_time = (end - begin) / (1.0 - duty);
        let mut style = RunStyle { duty, ..first.mixed(last, 0.5) };
        let clock = |time: f64| duty + (time - begin) / stride_time;
        let times = (0..nodes).map(|i| start + step * i as f64).filter(|&time| time > begin && time < end);
        let begin_jet = match comes {
            Some(seam) => rescaled(&seam.swinging(), stride_time),
            None => rescaled(&before.jets.lifting, stride_time / before.stride_time),
        };
        let end_jet = match goes {
            Some(seam) => rescaled(&seam.swinging(), stride_time),
            None => rescaled(&after.jets.landing, stride_time / after.stride_time),
        };
        if comes.is_none() && goes.is_none() && (!before.lands || after.toe_off.is_none()) {
            // From standing and to it the foot leaves less steeply, and lands under a body that is lower.
            let bent = end_jet.knee.position - KNEE_LANDS;
            style.knee_76 += BENT.0 * bent;
            style.knee_93 += BENT.1 * bent;
            let ankle = begin_jet.knee.position - begin_jet.thigh.position - begin_jet.pitch.position;
            style.ankle_20 += FLEXED.0 * (ankle - ANKLE_LEAVES);
            style.ankle_45 += FLEXED.1 * (ankle - ANKLE_LEAVES);
        }
        let mut swing = match (comes, goes) {
            (Some(_), _) => style.swing_on(&begin_jet, &end_jet)?,
            (None, Some(_)) => style.swing_into(&begin_jet, &end_jet)?,
            (None, None) => style.swing(&begin_jet, &end_jet)?,
        };
        let heights: Vec<(f64, f64)> = times.map(|time| (clock(time), hip(time).y)).collect();
        swing.clear_ground(leg, &style.ground_clearance(), &heights);
        swings.push(Swung { swing, from: begin, until: end, toe_off: duty, stride_time });
    }
    Ok(swings)
}

/// How a foot lands and leaves.
struct Shape {
    footing: Footing,
    landing: Landing,
    heel_strike_angle: f64,
    contact_knee: Boundary,
    push: Push,
}

impl Shape {
    /// `toe_off` is by the foot's clock.
    fn of(role: Role, style: &RunStyle, toe_off: Option<f64>) -> Self {
        let footing = Footing { width: 0.0, ..style.footing() };
        let push = Push { softness: SOFT, ..style.push() };
        let running = Self {
            footing,
            landing: Landing::Heel,
            heel_strike_angle: style.heel_strike_angle,
            contact_knee: style.contact_knee(),
            push,
        };
        let end = toe_off.unwrap_or(0.0);
        let before = |time: f64| end - time / style.stride_time;
        let leaving =
            |knee: Boundary, heel_off: f64, waypoint: Option<(f64, f64)>, tip_roll: f64, toe_roll: f64| {
                Push {
                    heel_off: before(heel_off),
                    waypoint: waypoint.map(|(at, knee)| (before(at), knee)),
                    tip_roll_at: before(tip_roll),
                    toe_roll,
                    knee_toe_off: knee,
                    ..push
                }
            };
        let standing = Footing { flat: 0.0, toe_off: end, ..footing };
        match role {
            Role::Runs | Role::Stops | Role::Arrives => running,
            Role::LeavesFirst => Self {
                footing: standing,
                landing: Landing::Flat,
                push: leaving(
                    Boundary::new(32.0 * DEGREE, 120.0 * DEGREE, 0.0),
                    0.26,
                    None,
                    0.07,
                    4.0 * DEGREE,
                ),
                ..running
            },
            Role::Launches => Self {
                footing: standing,
                landing: Landing::Flat,
                push: leaving(
                    Boundary::new(26.0 * DEGREE, 150.0 * DEGREE, push.knee_toe_off.acceleration),
                    0.28,
                    Some((0.09, 14.0 * DEGREE)),
                    0.10,
                    push.toe_roll,
                ),
                ..running
            },
            Role::LeavesLast => Self {
                footing: standing,
                landing: Landing::Flat,
                push: leaving(push.knee_toe_off, 0.26, Some((0.11, style.knee_push)), 0.12, push.toe_roll),
                ..running
            },
            Role::Closes => Self {
                heel_strike_angle: 6.0 * DEGREE,
                contact_knee: Boundary::new(14.0 * DEGREE, 200.0 * DEGREE, 2000.0 * DEGREE),
                ..running
            },
        }
    }
}

fn in_units(b: Boundary, factor: f64) -> Boundary {
    Boundary::new(b.position, b.velocity * factor, b.acceleration * factor * factor)
}

/// A jet by a clock whose unit is `factor` times as long.
fn rescaled(jet: &LegJet, factor: f64) -> LegJet {
    let slower = |b: Boundary| in_units(b, factor);
    LegJet {
        side: slower(jet.side),
        thigh: slower(jet.thigh),
        knee: slower(jet.knee),
        pitch: slower(jet.pitch),
        toes: slower(jet.toes),
    }
}
