//! A set of clips for a character of a game: standing, starts, walks at some speeds, turns and stops that fit together.
//!
//! All loops begin at a left contact. Starts end, stops begin, and turns on the way begin and end there too, at the set's usual walk; turns on the spot
//! go from standing to standing. So a player goes from clip to clip where one ends and the next begins, and mixes loops of different speeds at
//! the same phase. Each clip begins at the origin and faces along z.

mod breath;
mod clip;

pub use clip::{ClipKind, Joint, Seam, SetClip};

use crate::body::{Body, missing};
use crate::error::{GaitError, PlanError, RequestError};
use crate::request::{Extent, WalkPart, WalkRequest};
use crate::smooth::{Excerpt, WalkPlan};
use crate::styled::{StyledPlan, StyledRequest};
use crate::walking::{annotate, on_the_spot};
use breath::Breath;
use clip::at_origin;
use solaris_model::{EventKind, Figure, Motion, MotionInfo, RootOrder, Trajectory};

/// Step frequencies of the loops over the usual one.
const PACES: [f64; 5] = [0.64, 0.77, 0.89, 1.0, 1.1];
/// The same of the loops that go backward.
const BACKWARD: [f64; 2] = [1.0, 0.77];
/// Steps of a walk whose middle one is steady, right or left at last.
const STEADY: [usize; 2] = [42, 43];
/// Contacts until a start with the left or the right foot ends, steps from the contact at which a stop begins, and steps of the walk before and
/// after a turn in its clip: at least so many, and two more at a time until joints jump by less than [`SEAM`] (rad).
const STARTS: [usize; 2] = [5, 6];
const STOPS: usize = 4;
const LEAD: usize = 3;
const SEAM: f64 = std::f64::consts::PI / 180.0;
/// How often two more are tried.
const LONGER: usize = 4;
/// Steps of a walk before and after a turn on the way.
const AROUND: usize = 20;
/// Steps of a quarter turn on the way, and of one on the spot, where hips reach so far, or else.
const TURNING: usize = 4;
const ABOUT: [usize; 2] = [3, 4];
/// How long one stands in a clip (s).
const STANDING: f64 = 4.0;
/// Speeds that may be asked for.
const MOST_SPEEDS: usize = 20;

/// What is asked of a set.
#[derive(Clone, Debug, PartialEq)]
pub struct SetRequest {
    /// In which manner it walks: its population, parameters and sheet. The rest of it says nothing here.
    pub walk: WalkRequest,
    /// Speeds of the loops (m/s), at most twenty, negative ones backward, one at least forward; `None` for five from slow to fast and two backward.
    pub speeds: Option<Vec<f64>>,
    /// Frames a second (1/s); strides are fitted to whole frames.
    pub rate: f64,
    /// Whether loops stay where they are.
    pub in_place: bool,
}

impl Default for SetRequest {
    /// At 30 frames a second, loops that go on.
    fn default() -> Self {
        Self { walk: WalkRequest::default(), speeds: None, rate: 30.0, in_place: false }
    }
}

/// The clips, and what was left out.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ClipSet {
    /// Frames a second.
    #[cfg_attr(feature = "serde", serde(rename = "rate_per_s"))]
    pub rate: f64,
    /// Standing, starts, loops from the fastest backward to the fastest forward, turns, stops.
    pub clips: Vec<SetClip>,
    /// The loop that starts end in and stops begin in.
    pub usual: String,
    /// What could not be made, and why.
    pub notes: Vec<String>,
}

/// Makes the clips of a figure. Turns need a root that turns by its heading first ([`RootOrder::Yzx`]); of another figure they are left out.
///
/// ```
/// use solaris_gait::set::{ClipKind, SetRequest, clip_set};
/// use solaris_model::{Human, RootOrder};
///
/// let ann = Human::new(1.65, 58.0).root(RootOrder::Yzx).build()?;
/// let set = clip_set(&ann, &SetRequest { speeds: Some(vec![1.0, 1.4]), ..SetRequest::default() })?;
/// let loops: Vec<&str> =
///     set.clips.iter().filter(|clip| clip.kind == ClipKind::Walk).map(|clip| clip.name.as_str()).collect();
/// assert_eq!(loops, ["walk_1", "walk_2"]);
/// // A start ends where its loop begins: within half a degree.
/// let start = set.clips.iter().find(|clip| clip.name == "start_left").unwrap();
/// assert!(start.seam.as_ref().unwrap().angle.to_degrees() < 0.5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// Speeds that are none, none that can be walked, a rate that is none, and all that a walk is refused for.
pub fn clip_set(figure: &Figure, request: &SetRequest) -> Result<ClipSet, GaitError> {
    missing::check(figure)?;
    if !(request.rate >= 1.0 && request.rate <= 1000.0) {
        return Err(range("rate", request.rate, " frames/s", (1.0, 1000.0)));
    }
    let base = WalkRequest {
        population: request.walk.population,
        sheet: request.walk.sheet.clone(),
        parameters: request.walk.parameters.clone(),
        resolution: request.walk.resolution,
        ..WalkRequest::default()
    };
    let mut maker = Maker { figure, rate: request.rate, name: String::new(), notes: Vec::new() };
    "walk".clone_into(&mut maker.name);
    let usual = maker.plan(&WalkRequest { extent: Extent::Steps(2), ..base.clone() })?.style().step_frequency;
    let requests = maker.paces(&base, request.speeds.as_deref(), usual)?;
    let backward = maker.backward(&base, request.speeds.as_deref(), usual)?;

    let mut loops = Vec::new();
    for (number, request) in requests.iter().enumerate() {
        loops.push(maker.steady(&format!("walk_{}", number + 1), request)?);
    }
    let near = |(_, walk): &(usize, &(SetClip, WalkRequest))| (walk.0.step_frequency - usual).abs();
    let at = loops.iter().enumerate().min_by(|a, b| near(a).total_cmp(&near(b))).map_or(0, |(at, _)| at);
    let (usual, fitted) = (loops[at].0.clone(), loops[at].1.clone());

    let mut clips = vec![maker.standing(&fitted)?];
    clips.extend(maker.starts_and_stops(&fitted, &usual)?);
    let turns = if Body::of(figure)?.root_order == RootOrder::Yzx {
        maker.turns(&fitted, &usual)
    } else {
        maker.notes.push(
            "turns are left out: this figure's root turns about z first; give it a root that turns by its heading first".to_owned(),
        );
        Vec::new()
    };
    let stops = clips.split_off(3);
    for mut clip in backward.into_iter().chain(loops.into_iter().map(|(clip, _)| clip)) {
        if request.in_place {
            clip.motion = on_the_spot(figure, &clip.motion)?;
        }
        clips.push(clip);
    }
    clips.extend(turns);
    clips.extend(stops);
    Ok(ClipSet { rate: request.rate, clips, usual: usual.name, notes: maker.notes })
}

fn range(parameter: &'static str, value: f64, unit: &'static str, (lower, upper): (f64, f64)) -> GaitError {
    RequestError::Range { parameter, value, unit, lower, upper, why: String::new() }.into()
}

struct Maker<'a> {
    figure: &'a Figure,
    rate: f64,
    /// The clip that is made.
    name: String,
    notes: Vec<String>,
}

impl Maker<'_> {
    /// A plan, in so much of its manner as holds.
    fn plan(&mut self, request: &WalkRequest) -> Result<WalkPlan, GaitError> {
        let (plan, part) =
            StyledPlan::as_far_as_it_holds(self.figure, &StyledRequest::Smooth(request.clone()))?;
        if let Some((part, why)) = part {
            let note = format!(
                "{}: {:.0} % of the manner are walked, for all of it would not hold: {why}",
                self.name,
                100.0 * part
            );
            if !self.notes.contains(&note) {
                self.notes.push(note);
            }
        }
        match plan {
            StyledPlan::Smooth(plan) => Ok(*plan),
            // A smooth request is one walk.
            _ => Err(RequestError::NoWalk.into()),
        }
    }

    /// Requests at the speeds that are asked for, or at five paces, each with a stride of whole frames.
    fn paces(
        &mut self,
        base: &WalkRequest,
        speeds: Option<&[f64]>,
        usual: f64,
    ) -> Result<Vec<WalkRequest>, GaitError> {
        let asked: Vec<WalkRequest> = match speeds {
            Some(speeds) => {
                if !(1..=MOST_SPEEDS).contains(&speeds.len()) {
                    return Err(range(
                        "number of speeds",
                        speeds.len() as f64,
                        "",
                        (1.0, MOST_SPEEDS as f64),
                    ));
                }
                let mut speeds: Vec<f64> =
                    speeds.iter().copied().filter(|speed| speed.is_nan() || *speed >= 0.0).collect();
                if speeds.is_empty() {
                    return Err(range("number of speeds forward", 0.0, "", (1.0, MOST_SPEEDS as f64)));
                }
                speeds.sort_by(f64::total_cmp);
                speeds.iter().map(|speed| WalkRequest { speed: Some(*speed), ..base.clone() }).collect()
            }
            None => {
                PACES.map(|pace| WalkRequest { step_frequency: Some(pace * usual), ..base.clone() }).to_vec()
            }
        };
        let one = |(at, request)| {
            self.name = format!("walk_{}", at + 1);
            self.in_step(request)
        };
        asked.into_iter().enumerate().map(one).collect()
    }

    fn in_step(&mut self, request: WalkRequest) -> Result<WalkRequest, GaitError> {
        // A few steps do not come to a fast pace.
        let plan = self.plan(&WalkRequest { extent: Extent::Steps(STEADY[0]), ..request.clone() })?;
        let frequency = plan.style().step_frequency;
        Ok(match StyledRequest::Smooth(request.clone()).in_step(plan.stature(), frequency, self.rate) {
            Some(StyledRequest::Smooth(fitted)) => fitted,
            _ => WalkRequest { step_frequency: Some(frequency), ..request },
        })
    }

    /// A loop, and its request.
    fn steady(&mut self, name: &str, request: &WalkRequest) -> Result<(SetClip, WalkRequest), GaitError> {
        name.clone_into(&mut self.name);
        let plan = self.plan(&WalkRequest { extent: Extent::Steps(STEADY[0]), ..request.clone() })?;
        let stride = plan.stride_loop().ok_or(PlanError::NoStride { least: STEADY[0] })?;
        let motion = stride.motion(self.figure, self.rate)?;
        let mut clip = SetClip::new(name, ClipKind::Walk, motion, [Joint::LeftContact; 2]);
        clip.repeats = true;
        clip.paced(&plan);
        // A window that begins and ends at the origin.
        clip.motion = at_origin(self.figure, clip.motion)?;
        clip.advance = [0.0, 2.0 * clip.step_length];
        Ok((clip, request.clone()))
    }

    /// Loops that go backward, from fast to slow, at the speeds that are asked for; where none are, two, of which those that would not hold
    /// are left out, with a note.
    fn backward(
        &mut self,
        base: &WalkRequest,
        speeds: Option<&[f64]>,
        usual: f64,
    ) -> Result<Vec<SetClip>, GaitError> {
        let base = WalkRequest { backward: true, ..base.clone() };
        let asked: Vec<WalkRequest> = match speeds {
            Some(speeds) => {
                let mut speeds: Vec<f64> = speeds.iter().copied().filter(|speed| *speed < 0.0).collect();
                speeds.sort_by(f64::total_cmp);
                speeds.iter().map(|speed| WalkRequest { speed: Some(-speed), ..base.clone() }).collect()
            }
            None => BACKWARD
                .map(|pace| WalkRequest { step_frequency: Some(pace * usual), ..base.clone() })
                .to_vec(),
        };
        let (mut made, count) = (Vec::new(), asked.len());
        for (at, asked) in asked.into_iter().enumerate() {
            let name = format!("walk_backward_{}", count - at);
            name.clone_into(&mut self.name);
            match self.in_step(asked).and_then(|fitted| self.steady(&name, &fitted)) {
                Ok((clip, _)) => made.push(clip),
                Err(why) if speeds.is_none() => self.notes.push(format!("{name} is left out: {why}")),
                Err(why) => return Err(why),
            }
        }
        Ok(made)
    }

    /// Standing, starts with either foot, stops with either foot at last, in this order.
    fn starts_and_stops(&mut self, request: &WalkRequest, next: &SetClip) -> Result<Vec<SetClip>, GaitError> {
        let mut clips = Vec::new();
        for (name, left_first) in [("start_left", true), ("start_right", false)] {
            name.clone_into(&mut self.name);
            let walk = WalkRequest { left_first, extent: Extent::Steps(STEADY[0]), ..request.clone() };
            let plan = self.plan(&walk)?;
            let until = contacts(&plan)[STARTS[usize::from(!left_first)] - 1];
            let frames = (until * self.rate).ceil();
            let excerpt = Excerpt::new(&plan, until - frames / self.rate, until);
            clips.push(self.clip(
                name,
                ClipKind::Start,
                &excerpt,
                [Joint::Standing, Joint::LeftContact],
                next,
            )?);
        }
        for (name, steps) in [("stop_left", STEADY[0]), ("stop_right", STEADY[1])] {
            name.clone_into(&mut self.name);
            let plan = self.plan(&WalkRequest { extent: Extent::Steps(steps), ..request.clone() })?;
            let contacts = contacts(&plan);
            // Steps with even numbers are the left foot's.
            let from = contacts[STEADY[0] - STOPS - 1];
            let frames = ((plan.duration() - from) * self.rate).ceil();
            let excerpt = Excerpt::new(&plan, from, from + frames / self.rate);
            clips.push(self.clip(
                name,
                ClipKind::Stop,
                &excerpt,
                [Joint::LeftContact, Joint::Standing],
                next,
            )?);
        }
        Ok(clips)
    }

    /// Turns by a quarter on the way and on the spot, either way, and about on the spot; those that cannot be walked are told in the notes.
    fn turns(&mut self, request: &WalkRequest, next: &SetClip) -> Vec<SetClip> {
        let quarter = std::f64::consts::FRAC_PI_2;
        let ways = [("left", 1.0), ("right", -1.0)];
        let mut clips = Vec::new();
        for (side, sign) in ways {
            let name = format!("walk_turn_{side}_90");
            let found = self.on_the_way(&name, request, sign * quarter, next);
            clips.extend(self.or_note(&name, found));
        }
        for (angle, quarters) in [(90, 1), (180, 2)] {
            for (side, sign) in ways {
                let name = format!("turn_{side}_{angle}");
                let turn = sign * f64::from(angle).to_radians();
                let said = self.notes.len();
                let mut found = self.about(&name, request, turn, quarters * ABOUT[0], next);
                if found.is_err() || self.notes.len() > said {
                    self.notes.truncate(said);
                    found = self.about(&name, request, turn, quarters * ABOUT[1], next);
                }
                clips.extend(self.or_note(&name, found));
            }
        }
        clips
    }

    fn or_note(&mut self, name: &str, found: Result<SetClip, GaitError>) -> Option<SetClip> {
        found.map_err(|error| self.notes.push(format!("{name} is left out: {error}"))).ok()
    }

    /// A turn on the way: from a left contact to the left contact at which it walks straight on again.
    fn on_the_way(
        &mut self,
        name: &str,
        request: &WalkRequest,
        turn: f64,
        next: &SetClip,
    ) -> Result<SetClip, GaitError> {
        name.clone_into(&mut self.name);
        let steps = TURNING;
        let part = |steps, turn| WalkPart { steps, turn, ..WalkPart::default() };
        let then = vec![part(steps, turn / steps as f64), part(AROUND, 0.0)];
        let walk = WalkRequest { extent: Extent::Steps(AROUND), then, ..request.clone() };
        let plan = self.plan(&walk)?;
        let contacts = contacts(&plan);
        fitting(|more| {
            let around = LEAD + more;
            let excerpt = Excerpt::new(&plan, contacts[AROUND - around], contacts[AROUND + steps + around]);
            let mut clip = self.clip(name, ClipKind::Turn, &excerpt, [Joint::LeftContact; 2], next)?;
            clip.turn = turn;
            clip.seam = Some(clip.seam_to(next).worse(next.seam_to(&clip)));
            Ok(clip)
        })
    }

    /// A turn on the spot.
    fn about(
        &mut self,
        name: &str,
        request: &WalkRequest,
        turn: f64,
        steps: usize,
        next: &SetClip,
    ) -> Result<SetClip, GaitError> {
        name.clone_into(&mut self.name);
        let walk = WalkRequest {
            step_frequency: None,
            speed: None,
            step_length: Some(0.0),
            extent: Extent::Steps(steps),
            turn: turn / steps as f64,
            left_first: turn > 0.0,
            ..request.clone()
        };
        let plan = self.plan(&walk)?;
        let frames = (plan.duration() * self.rate).ceil();
        let excerpt = Excerpt::new(&plan, 0.0, frames / self.rate);
        let mut clip = self.clip(name, ClipKind::Turn, &excerpt, [Joint::Standing; 2], next)?;
        (clip.step_frequency, clip.step_length) = (plan.style().step_frequency, 0.0);
        clip.turn = turn;
        Ok(clip)
    }

    /// Standing and breathing.
    fn standing(&mut self, request: &WalkRequest) -> Result<SetClip, GaitError> {
        "idle".clone_into(&mut self.name);
        let plan = self.plan(&WalkRequest { extent: Extent::Steps(2), ..request.clone() })?;
        let frames = (STANDING * self.rate).round();
        let breath = Breath::new(self.figure, &plan, frames / self.rate);
        let mut motion = Motion::sample(self.figure, &breath, MotionInfo::on_earth(self.figure, self.rate))?;
        motion.planted = plan.planted(self.figure);
        motion.planted.retain(|planted| planted.start <= 0.0);
        motion.planted.iter_mut().for_each(|planted| planted.end = breath.duration());
        let motion = at_origin(self.figure, motion)?;
        let mut clip = SetClip::new("idle", ClipKind::Idle, motion, [Joint::Standing; 2]);
        clip.repeats = true;
        Ok(clip)
    }

    fn clip(
        &self,
        name: &str,
        kind: ClipKind,
        excerpt: &Excerpt<'_>,
        joints: [Joint; 2],
        next: &SetClip,
    ) -> Result<SetClip, GaitError> {
        let info = MotionInfo::on_earth(self.figure, self.rate);
        let mut motion = Motion::sample(self.figure, excerpt, info)?;
        annotate(&mut motion, excerpt, self.figure);
        let mut clip = SetClip::new(name, kind, at_origin(self.figure, motion)?, joints);
        clip.step_frequency = next.step_frequency;
        clip.step_length = next.step_length;
        clip.seam = match joints {
            [Joint::LeftContact, Joint::Standing] => Some(next.seam_to(&clip)),
            [_, Joint::LeftContact] => Some(clip.seam_to(next)),
            _ => None,
        };
        Ok(clip)
    }
}

/// The first of ever longer clips that fits the walk, or the shortest where none of them does.
fn fitting(make: impl Fn(usize) -> Result<SetClip, GaitError>) -> Result<SetClip, GaitError> {
    let shortest = make(0)?;
    let fits = |clip: &SetClip| clip.seam.is_none_or(|seam| seam.angle < SEAM);
    if fits(&shortest) {
        return Ok(shortest);
    }
    for more in 1..=LONGER {
        let clip = make(2 * more)?;
        if fits(&clip) {
            return Ok(clip);
        }
    }
    Ok(shortest)
}

/// When feet are set down, one after the other (s).
fn contacts(plan: &WalkPlan) -> Vec<f64> {
    let is_contact = |kind: &EventKind| matches!(kind, EventKind::TouchDown { .. });
    plan.events().iter().filter(|event| is_contact(&event.kind)).map(|event| event.time).collect()
}
