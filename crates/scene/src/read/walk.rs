//! A planned walk, or several with standing in between, that the figure follows where nothing else drives it.

use super::drives::Given;
use super::names::matches;
use super::segments::Written;
use super::{GRAVITY, SceneReader};
use crate::member::Member;
use crate::scene::Walked;
use nalgebra::Vector3;
use solaris_gait::{GaitError, RequestError, WalkGround, WalkSegment, WalkSequence};
use solaris_model::text::{ExpectedKind, Fields, Node};
use solaris_model::{Figure, JointKind, Known, Motion, MotionError, MotionInfo, Placement, Trajectory};
use solaris_modes::{Drive, RecordedMotion};
use std::sync::Arc;

/// Samples a second of the walk that is followed; between them it follows curves of degree five.
const RATE: f64 = 480.0;

/// What is walked, and how it begins.
pub(super) struct Planned {
    walks: Vec<One>,
    /// What all of them do.
    recorded: Arc<RecordedMotion>,
    /// How long the longest takes (s).
    duration: f64,
}

/// Whose a walk is.
enum Who {
    /// The only figure's.
    Only,
    /// One's of several, by its place among them.
    Member(usize),
    /// Nobody's who can walk, which has been said.
    Nobody,
}

/// What one figure walks.
struct One {
    plan: Arc<WalkSequence>,
    motion: Motion,
    /// Which, of several figures.
    of: Option<Member>,
    /// Degrees of freedom of the whole that follow it.
    followed: Vec<usize>,
}

impl Planned {
    /// How long it takes (s).
    pub(super) fn duration(&self) -> f64 {
        self.duration
    }

    /// Positions and velocities at the beginning.
    pub(super) fn first(&self) -> (&[f64], &[f64]) {
        let motion = self.recorded.motion();
        (motion.q(0), motion.v(0))
    }

    /// What the scene keeps of it; `reaching` are degrees of freedom that do something else over it.
    pub(super) fn into_walked(self, reaching: &[usize]) -> Vec<Walked> {
        let walked = |One { plan, motion, of, followed }: One| {
            let followed = followed.iter().filter(|dof| !reaching.contains(dof)).count();
            let (mut planted, mut events) = (motion.planted, motion.events);
            if let Some(member) = &of {
                planted = planted.iter().map(|planted| member.interval(planted)).collect();
                events = events.iter().map(|event| member.event(event)).collect();
            }
            Walked { of, plan, planted, events, followed, relief: motion.relief }
        };
        self.walks.into_iter().map(walked).collect()
    }
}

/// The error itself, not in which walk it is.
fn reason(error: &GaitError) -> &GaitError {
    match error {
        GaitError::InSegment { why, .. } => reason(why),
        _ => error,
    }
}

/// Whether it is a number of the ground that cannot be.
fn is_of_ground(error: &GaitError) -> bool {
    let GaitError::Request(RequestError::Range { parameter, .. }) = reason(error) else { return false };
    ["slope", "stairs", "rise", "tread"].contains(parameter)
}

/// Whether it is a person made for falls.
fn is_limp(figure: &Figure) -> bool {
    let kind = |link: usize| figure.links()[link].joint().kind();
    let arm = figure.link_index("left_upper_arm");
    matches!(kind(0), JointKind::Free { .. })
        && arm.is_some_and(|arm| matches!(kind(arm), JointKind::Ball { .. }))
}

impl SceneReader<'_> {
    /// Plans what is walked, and lets every degree of freedom of who walks follow it that has no drive of its own.
    pub(super) fn walk(
        &mut self,
        fields: &Fields<'_, '_>,
        figure: Option<(&str, &Figure)>,
        given: &Given,
        terrain: Option<&WalkGround>,
    ) -> Option<Planned> {
        let node = fields.get("walk")?;
        let walkers = self.walkers(
            node,
            figure.map(|(name, _)| name),
            terrain.is_none_or(|terrain| *terrain == WalkGround::Level),
        );
        let before = self.reader.count();
        let segments: Vec<_> = walkers.iter().map(|(node, _)| self.segments(node)).collect();
        let (_, figure) = figure?;
        let gravity = *self.simulation.as_ref()?.gravity();
        if (gravity - GRAVITY).norm() > 1e-6 {
            let message = format!(
                "a walk needs the gravity (0, −9.80665, 0) m/s²; here it is ({}, {}, {})",
                gravity.x, gravity.y, gravity.z
            );
            self.reader.fault(fields.get("gravity").map_or(node.place(), |node| node.span.clone()), message);
        }
        // To plan it takes a while, and who asks what may stand somewhere does not care.
        if self.reader.count() > before || self.reader.is_asked() {
            return None;
        }
        let mut walks = Vec::new();
        for ((node, of), segments) in walkers.into_iter().zip(segments) {
            let of = match of {
                Who::Only => None,
                Who::Member(at) => Some(self.members[at].clone()),
                Who::Nobody => return None,
            };
            let alone = of.as_ref().map_or(figure, |member| &member.figure);
            let (plan, motion) = self.planned(fields, node, alone, segments?, terrain?)?;
            let own = of.as_ref().map_or(0..figure.layout().nv(), |member| member.rows().1);
            let followed = own.filter(|dof| !given.contains_key(dof)).collect();
            walks.push(One { plan: Arc::new(plan), motion, of, followed });
        }
        let whole = self.whole_motion(figure, &walks);
        let whole = whole.map_err(|error| self.reader.fault(node.place(), error.to_string())).ok()?;
        let recorded = Arc::new(self.setup(&node.place(), RecordedMotion::new(whole))?);
        let simulation = self.simulation.as_mut()?;
        for dof in walks.iter().flat_map(|walk| &walk.followed) {
            let result = simulation.drive(self.names.name(*dof), [Drive::Recorded(Arc::clone(&recorded))]);
            if let Err(error) = result {
                self.reader.fault(node.place(), error.to_string());
                return None;
            }
        }
        let duration = walks.iter().map(|walk| walk.plan.duration()).fold(0.0, f64::max);
        Some(Planned { walks, recorded, duration })
    }

    /// Who walks, and what: the only figure, or those that are named, `{"ann": Walk(…), "crowd*": [Walk(…), Stand(time: 2)]}`. Of a name that
    /// cannot walk nothing.
    fn walkers<'n, 'a>(
        &mut self,
        node: &'n Node<'a>,
        only: Option<&str>,
        is_level: bool,
    ) -> Vec<(&'n Node<'a>, Who)> {
        let members = self.members.clone();
        let Some(entries) = node.entries() else {
            if members.is_empty() {
                return vec![(node, Who::Only)];
            }
            let first = members.first().map_or("ann", |member| member.name.as_str());
            let message =
                format!("there are several figures; say who walks: {{\"{first}\": Walk(steps: 6)}}");
            self.reader.fault(node.place(), message);
            return vec![(node, Who::Nobody)];
        };
        let names: Vec<&str> = match only.filter(|_| members.is_empty()) {
            Some(only) => vec![only],
            None => members.iter().map(|member| member.name.as_str()).collect(),
        };
        let (mut walkers, mut taken) = (Vec::new(), Vec::new());
        for (key, value) in entries {
            let Some(name) = self.reader.name(key, "the name of a figure") else { continue };
            self.reader.expect(&key.span, ExpectedKind::Name, "figure", names.iter().copied());
            let found: Vec<usize> = (0..names.len()).filter(|at| matches(name, names[*at])).collect();
            // Without figures no name means anything yet.
            if found.is_empty() && !names.is_empty() {
                self.no_figure(key, name, &names);
            }
            for at in found {
                if taken.contains(&at) {
                    let twice = names[at];
                    self.reader.fault(key.span.clone(), format!("'{twice}' has two walks; keep one of them"));
                    continue;
                }
                taken.push(at);
                let of = match members.get(at) {
                    Some(member) if self.on_level(key, member, is_level) => Who::Member(at),
                    Some(_) => Who::Nobody,
                    None => Who::Only,
                };
                walkers.push((value, of));
            }
        }
        if entries.is_empty() {
            self.reader
                .fault(node.place(), "nobody walks; write {\"ann\": Walk(steps: 6)}, or leave 'walk' out");
        }
        walkers
    }

    /// Whether a walk may begin where a figure stands: on the ground, with nothing taken up that its plan does not know of.
    fn on_level(&mut self, key: &Node<'_>, member: &Member, is_level: bool) -> bool {
        let name = &member.name;
        if !is_level && member.place != Placement::identity() {
            let message = format!(
                "over a slope, stairs or a relief a walk goes along z from the world's origin on; leave '{name}' out of 'places'"
            );
            self.reader.fault(key.span.clone(), message);
            return false;
        }
        if (member.place.rotation * Vector3::y() - Vector3::y()).norm() > 1e-9 {
            let message = format!("a walk begins upright; leave 'turned' out of the place of '{name}'");
            self.reader.fault(key.span.clone(), message);
            return false;
        }
        if member.place.translation.y.abs() > 1e-9 {
            let height = member.place.translation.y;
            let message =
                format!("a walk begins on the ground, at height 0; 'places' has '{name}' at {height} m");
            self.reader.fault(key.span.clone(), message);
            return false;
        }
        let links = member.link..member.link + member.figure.links().len();
        let mass: f64 = self
            .figure()
            .map_or(0.0, |figure| figure.links()[links].iter().map(solaris_model::Link::mass).sum());
        if self.figure().is_some() && (mass - member.figure.mass()).abs() > 1e-9 * mass {
            let message = format!(
                "of several figures a walk knows what a person carries from the figure alone: \"{name}\": Human(…, load: {{\"right\": 5.0}}), without 'carries'"
            );
            self.reader.fault(key.span.clone(), message);
            return false;
        }
        true
    }

    /// One figure's walk over the scene's ground.
    fn planned(
        &mut self,
        fields: &Fields<'_, '_>,
        node: &Node<'_>,
        figure: &Figure,
        segments: Vec<Written<'_, '_>>,
        terrain: &WalkGround,
    ) -> Option<(WalkSequence, Motion)> {
        let (written, mut segments): (Vec<_>, Vec<_>) = segments.into_iter().unzip();
        self.lay_under(fields, terrain, &mut segments)?;
        if is_limp(figure) {
            let message = "a limp person does not walk; leave 'joints: Limp' out, or let another one walk";
            self.reader.fault(node.place(), message);
            return None;
        }
        let segments: Vec<WalkSegment> =
            segments.into_iter().map(|segment| segment.helped_foot_first(figure)).collect();
        let plan = WalkSequence::new(figure, &segments);
        let plan = plan.map_err(|error| match fields.get("ground").filter(|_| is_of_ground(&error)) {
            Some(ground) => self.reader.fault(ground.place(), reason(&error).to_string()),
            None => self.refuse_walk(&error, &node.place(), &written),
        });
        let plan = plan.ok()?;
        let motion = plan.motion(figure, RATE);
        let motion = motion.map_err(|error| self.reader.fault(node.place(), error.to_string())).ok()?;
        Some((plan, motion))
    }

    /// What all who walk do, beside those who do not, who stand as they begin: who is there first waits for the others.
    fn whole_motion(&self, figure: &Figure, walks: &[One]) -> Result<Motion, MotionError> {
        if let [One { motion, of: None, .. }] = walks {
            return Ok(motion.clone());
        }
        let longest = walks.iter().map(|walk| walk.motion.time()).max_by_key(|time| time.len());
        let time = longest.unwrap_or(&[0.0]).to_vec();
        let begins = self.simulation.as_ref().map_or(&[][..], |simulation| simulation.state().0);
        let (nv, last) = (figure.layout().nv(), time.len() - 1);
        let mut columns = [begins.repeat(time.len()), vec![0.0; nv * time.len()], vec![0.0; nv * time.len()]];
        for One { motion, of, .. } in walks {
            let Some((of_q, of_v)) = of.as_ref().map(Member::rows) else { continue };
            for frame in 0..=last {
                let own = frame.min(motion.len() - 1);
                let at = |start: usize, width: usize| frame * width + start;
                let (q, v) = (at(of_q.start, begins.len()), at(of_v.start, nv));
                columns[0][q..q + of_q.len()].copy_from_slice(motion.q(own));
                if frame == own {
                    columns[1][v..v + of_v.len()].copy_from_slice(motion.v(own));
                    columns[2][v..v + of_v.len()].copy_from_slice(motion.a(own));
                }
            }
        }
        let info = MotionInfo { rate: RATE, ..MotionInfo::on_earth(figure, RATE) };
        Motion::recorded(figure, info, time, columns, Known::all(nv))
    }

    /// Lets a walk go over the scene's ground, where that is not level at the pace that people take there unless the walk says one.
    fn lay_under(
        &mut self,
        fields: &Fields<'_, '_>,
        ground: &WalkGround,
        segments: &mut [WalkSegment],
    ) -> Option<()> {
        if *ground == WalkGround::Level {
            return Some(());
        }
        let [WalkSegment::Walk(request)] = segments else {
            let message = "walks one after the other are on level ground; over a slope, stairs or a relief goes one Walk(…) alone";
            self.reader.fault(
                fields.get("ground").map_or(fields.at.clone(), solaris_model::text::Node::place),
                message,
            );
            return None;
        };
        if [request.step_frequency, request.step_length, request.speed] == [None; 3] {
            request.step_frequency = ground.usual_step_frequency();
        }
        request.ground = ground.clone();
        Some(())
    }
}
