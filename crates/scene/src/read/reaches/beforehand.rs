//! What is known of the motion before the run: that of curves, of walks and clips, and of what stands still.

use crate::read::SceneReader;
use crate::read::parts::Sequenced;
use solaris_model::Figure;
use solaris_modes::{
    Drive, EndCondition, Method, RecordedMotion, Rule, RunError, Settings, Simulation, Step,
};
use solaris_profiles::Sample;

/// Samples a second of what moves.
const RATE: f64 = 480.0;

/// The motion of degrees of freedom that is known before the run; that of the others is that they stand.
pub(super) struct Beforehand {
    start: Vec<f64>,
    /// The whole motion, where anything moves.
    moving: Option<RecordedMotion>,
}

/// Whether a drive is a motion that does not depend on the run's state.
fn is_motion(step: &Step) -> bool {
    matches!(step.drive, Drive::Frozen | Drive::Kinematic(_) | Drive::Move { .. } | Drive::Recorded(_))
        && matches!(
            step.until,
            EndCondition::Done | EndCondition::Time(_) | EndCondition::Lasting(_) | EndCondition::Part(_)
        )
}

/// Whether it stands still.
pub(in crate::read) fn stands(steps: &[Step]) -> bool {
    steps.iter().all(|step| step.drive == Drive::Frozen)
}

/// The degree of freedom that another follows, or itself.
pub(super) fn leader(figure: &Figure, dof: usize) -> usize {
    figure.followers().iter().find(|follower| follower.dof == dof).map_or(dof, |follower| follower.leader)
}

/// Whether it is known before the run what a degree of freedom does.
pub(super) fn is_known(simulation: &Simulation, dof: usize, sequenced: &Sequenced) -> bool {
    let dof = leader(simulation.figure(), dof);
    let own = |dof: &usize| simulation.driven_by(*dof).iter().all(is_motion);
    let waits = simulation.driven_by(dof).iter().any(|step| matches!(step.until, EndCondition::Part(_)));
    own(&dof) && (!waits || (!sequenced.waits_for_state && sequenced.dofs.iter().all(own)))
}

/// Degrees of freedom that carry a link.
pub(super) fn carriers(figure: &Figure, link: usize) -> Vec<usize> {
    let (mut at, mut found) = (Some(link), Vec::new());
    while let Some(link) = at {
        let joint = figure.layout().joints()[link];
        found.extend(joint.v..joint.v + joint.nv);
        at = figure.links()[link].parent();
    }
    found
}

impl Beforehand {
    /// That of the degrees of freedom `known`, for a time (s); all others stand.
    pub(super) fn of(simulation: &Simulation, known: &[usize], duration: f64) -> Result<Self, RunError> {
        let start = simulation.state().0.to_vec();
        let stands_or_follows = |dof: &usize| stands(simulation.driven_by(leader(simulation.figure(), *dof)));
        if known.iter().all(stands_or_follows) {
            return Ok(Self { start, moving: None });
        }
        let mut alone = simulation.clone();
        let figure = simulation.figure();
        for (dof, name) in figure.layout().v_names().iter().enumerate() {
            if !known.contains(&dof) && !figure.follows(dof) && !stands(simulation.driven_by(dof)) {
                alone.drive(name, [Drive::Frozen])?;
            }
        }
        let settings = Settings {
            method: Method::Fixed { rule: Rule::RungeKutta4, step: RATE.recip() },
            forces: false,
            estimate: false,
            ..Settings::new(duration + RATE.recip(), RATE)
        };
        let run = alone.run(&settings)?;
        Ok(Self { start, moving: Some(RecordedMotion::new(run.motion)?) })
    }

    /// Whether all of it stands still.
    pub(super) fn is_still(&self) -> bool {
        self.moving.is_none()
    }

    /// Position, velocity and acceleration of a degree of freedom with a coordinate at a time (s).
    pub(super) fn at(&self, dof: usize, coordinate: usize, time: f64) -> Sample {
        match &self.moving {
            Some(moving) => moving.at(dof, coordinate, time),
            None => Sample::rest(self.start[coordinate]),
        }
    }

    /// All positions at a time (s).
    pub(super) fn positions(&self, figure: &Figure, time: f64) -> Vec<f64> {
        let mut q = self.start.clone();
        let layout = figure.layout();
        if self.moving.is_some() {
            for dof in 0..layout.nv() {
                if let Some(coordinate) = layout.coordinate(dof) {
                    q[coordinate] = self.at(dof, coordinate, time).position;
                }
            }
        }
        if !figure.followers().is_empty() {
            let mut rates = [vec![0.0; layout.nv()], vec![0.0; layout.nv()]];
            let [v, a] = &mut rates;
            figure.follow(&mut q, v, a);
        }
        q
    }
}

impl SceneReader<'_> {
    /// Why a degree of freedom cannot be moved by what is asked of links, if it cannot: it takes part in a sequence, or a drive that is
    /// named for it has no motion that is known before the run.
    pub(super) fn moves_otherwise(&self, dof: usize) -> Option<String> {
        let name = self.names.name(dof);
        if self.sequenced.dofs.contains(&dof) {
            return Some(format!("'{name}' reaches, and takes part in the sequence; keep one of them"));
        }
        let known =
            self.simulation.as_ref().is_none_or(|simulation| is_known(simulation, dof, &self.sequenced));
        (self.named.contains_key(&dof) && !known).then(|| {
            format!(
                "'{name}' reaches, and has drives of its own whose motion is not known before the run; leave them out, or let it stand \
                 (Frozen) or follow a curve"
            )
        })
    }
}
