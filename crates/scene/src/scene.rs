//! A scene: everything that a motion script says, ready to be run.

use crate::error::SceneError;
use crate::member::{Member, OneOfSeveral};
use solaris_analysis::{ReactionError, ReactionReport, ground_reactions_under};
use solaris_dynamics::Wrench;
use solaris_gait::{FEET, WalkSequence};
use solaris_model::{Event, Figure, Ground, Interval, Motion, MotionError, Relief};
use solaris_modes::{Observer, Remark, Run, RunReport, Settings, Simulation};
use std::fmt;
use std::sync::Arc;

/// A figure, what drives it and for how long.
#[derive(Clone)]
pub struct Scene {
    pub(crate) name: String,
    pub(crate) simulation: Simulation,
    pub(crate) settings: Settings,
    /// What there is to say of it before it is run.
    pub(crate) notes: Vec<String>,
    /// Who walks: of one figure itself, of several each that does.
    pub(crate) walks: Vec<Walked>,
    /// Of several figures, each.
    pub(crate) members: Vec<Member>,
    /// The friction of the ground that they walk on, where the scene says it.
    pub(crate) friction: Option<f64>,
}

/// A walk that a figure follows where nothing else drives it.
#[derive(Clone)]
pub(crate) struct Walked {
    /// Which, of several figures.
    pub(crate) of: Option<Member>,
    pub(crate) plan: Arc<WalkSequence>,
    /// When which point is planted, in the order of time.
    pub(crate) planted: Vec<Interval>,
    /// Touch-downs and lift-offs.
    pub(crate) events: Vec<Event>,
    /// How many degrees of freedom follow it.
    pub(crate) followed: usize,
    /// The heights of its ground, where it is not level.
    pub(crate) relief: Option<Relief>,
}

/// What came of a scene.
#[derive(Clone, Debug)]
pub struct Simulated {
    /// The motion, with the joint forces, and with contacts where the scene has a walk.
    pub motion: Motion,
    /// How it was found, and how far it can be trusted.
    pub report: RunReport,
    /// What the ground does under the feet of a walk.
    pub reactions: Option<ReactionReport>,
}

impl Walked {
    /// What the ground does under the feet of who walks, into the motion of all.
    fn reactions(
        &self,
        figure: &Figure,
        motion: &mut Motion,
        acting: &[Vec<(usize, Wrench<f64>)>],
    ) -> Result<ReactionReport, ReactionError> {
        let Some(member) = &self.of else {
            return ground_reactions_under(figure, motion, FEET, &*self.plan, acting);
        };
        let mut part = member.part(motion)?;
        let own: Vec<_> = acting.iter().map(|frame| member.acting(frame)).collect();
        let own = ground_reactions_under(&member.figure, &mut part, FEET, &*self.plan, &own)?;
        member.put_back(&part, motion)?;
        Ok(own)
    }
}

impl Scene {
    /// What the scene calls its figure.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The figure.
    pub fn figure(&self) -> &Figure {
        self.simulation.figure()
    }

    /// The figure with its drives, springs and limits, at the beginning.
    pub fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// How it is to be run.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// How it is to be run, to be changed.
    pub fn settings_mut(&mut self) -> &mut Settings {
        &mut self.settings
    }

    /// What there is to say of it before it is run: what does not reach what it should.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// What is walked, if anything: one walk, or several with standing in between; of several who walk, what the first does.
    pub fn walk(&self) -> Option<&WalkSequence> {
        self.walks.first().map(|walk| &*walk.plan)
    }

    /// Whether it has several figures.
    pub fn is_of_several(&self) -> bool {
        !self.members.is_empty()
    }

    /// Of a scene with several figures, each alone, with its first link in the whole; of one with a single figure nothing.
    pub fn parts(&self) -> impl Iterator<Item = (usize, &Figure)> {
        self.members.iter().map(|member| (member.link, &member.figure))
    }

    /// Of a scene with several figures, each with its part of a motion of all, such as [`Simulated::motion`]; of one with a single figure
    /// nothing.
    ///
    /// # Errors
    ///
    /// A motion of another figure.
    pub fn several(&self, motion: &Motion) -> Result<Vec<OneOfSeveral>, MotionError> {
        motion.check_figure(self.figure())?;
        self.members.iter().map(|member| member.in_the_world(motion)).collect()
    }

    /// How many degrees of freedom follow a walk.
    pub fn walked(&self) -> usize {
        self.walks.iter().map(|walk| walk.followed).sum()
    }

    /// Refuses what [`Self::simulate`] would refuse at the beginning.
    ///
    /// # Errors
    ///
    /// [`SceneError`].
    pub fn check(&self) -> Result<(), SceneError> {
        Ok(self.simulation.check(&self.settings)?)
    }

    /// Runs the scene reporting to `observer`. In a scene with a walk, what the ground does under the feet is found from the
    /// whole motion, with what dynamics have made of the parts that do not follow the walk.
    ///
    /// # Errors
    ///
    /// [`SceneError`].
    pub fn simulate(&self, observer: &mut dyn Observer) -> Result<Simulated, SceneError> {
        let Run { mut motion, mut report } = self.simulation.run_observed(&self.settings, observer)?;
        report.remarks.extend(self.notes.iter().cloned().map(Remark::Said));
        if self.walks.is_empty() {
            return Ok(Simulated { motion, report, reactions: None });
        }
        let end = motion.time().last().copied().unwrap_or_default();
        let begun = |walk: &Walked| {
            walk.planted.iter().filter(|planted| planted.start < end).cloned().collect::<Vec<_>>()
        };
        let planted = self.walks.iter().flat_map(begun);
        motion.planted = planted.map(|planted| Interval { end: planted.end.min(end), ..planted }).collect();
        motion.planted.sort_by(|a, b| a.start.total_cmp(&b.start));
        let events = self.walks.iter().flat_map(|walk| &walk.events);
        motion.events.extend(events.filter(|event| event.time <= end).cloned());
        motion.events.sort_by(|a, b| a.time.total_cmp(&b.time));
        motion.info.ground = Some(Ground { height: 0.0, friction: self.friction });
        motion.relief.clone_from(&self.walks[0].relief);
        let acting = self.simulation.acting(&motion)?;
        let mut reactions: Option<ReactionReport> = None;
        for walk in &self.walks {
            let own = match walk.reactions(self.figure(), &mut motion, &acting) {
                // What somebody walks into may lift a leg in a frame, and the rest of the motion is as it is.
                Err(error @ ReactionError::Pulls { .. }) if self.is_acted_on(&report) => {
                    let who = walk.of.as_ref().map_or("who walks", |member| &member.name);
                    let note = format!("what the ground does under the feet of {who} is not told: {error}");
                    report.remarks.push(Remark::Said(note));
                    continue;
                }
                found => found?,
            };
            reactions = Some(match reactions {
                Some(before) => before.worst(&own),
                None => own,
            });
        }
        Ok(Simulated { motion, report, reactions })
    }
}

impl Scene {
    /// Whether something else than the ground acts on who walks.
    fn is_acted_on(&self, report: &RunReport) -> bool {
        let simulation = &self.simulation;
        !(report.collisions.is_empty()
            && simulation.springs().is_empty()
            && simulation.pushes().is_empty()
            && simulation.loops().is_empty())
    }
}

impl fmt::Debug for Scene {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = f.debug_struct("Scene");
        shown
            .field("name", &self.name)
            .field("simulation", &self.simulation)
            .field("settings", &self.settings);
        shown.finish_non_exhaustive()
    }
}
