//! A scene: everything that a motion script says, ready to be run.

use crate::error::SceneError;
use solaris_analysis::{ReactionReport, ground_reactions};
use solaris_gait::{FEET, WalkSequence};
use solaris_model::{Event, Figure, Ground, Interval, Motion, Relief};
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
    pub(crate) walk: Option<Walked>,
}

/// A walk that the figure follows where nothing else drives it.
#[derive(Clone)]
pub(crate) struct Walked {
    pub(crate) plan: Arc<WalkSequence>,
    /// When which point is planted, in the order of time.
    pub(crate) planted: Vec<Interval>,
    /// Touch-downs and lift-offs.
    pub(crate) events: Vec<Event>,
    /// How many degrees of freedom follow it.
    pub(crate) followed: usize,
    /// The friction of its ground, where the scene says it.
    pub(crate) friction: Option<f64>,
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

    /// What is walked, if anything: one walk, or several with standing in between.
    pub fn walk(&self) -> Option<&WalkSequence> {
        self.walk.as_ref().map(|walk| &*walk.plan)
    }

    /// How many degrees of freedom follow the walk.
    pub fn walked(&self) -> usize {
        self.walk.as_ref().map_or(0, |walk| walk.followed)
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
        let Some(walk) = &self.walk else { return Ok(Simulated { motion, report, reactions: None }) };
        let end = motion.time().last().copied().unwrap_or_default();
        let planted = walk.planted.iter().filter(|planted| planted.start < end).cloned();
        motion.planted = planted.map(|planted| Interval { end: planted.end.min(end), ..planted }).collect();
        motion.events.extend(walk.events.iter().filter(|event| event.time <= end).cloned());
        motion.events.sort_by(|a, b| a.time.total_cmp(&b.time));
        motion.info.ground = Some(Ground { height: 0.0, friction: walk.friction });
        motion.relief.clone_from(&walk.relief);
        let reactions = ground_reactions(self.figure(), &mut motion, FEET, &*walk.plan)?;
        Ok(Simulated { motion, report, reactions: Some(reactions) })
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
