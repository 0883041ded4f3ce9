//! Parts of a sequence over several degrees of freedom: each begins when the one before is over.

use crate::drive::{Drive, EndCondition, Step};
use crate::failure::SetupError;
use crate::simulation::Simulation;

/// A part of a [sequence](Simulation::sequence).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Part {
    /// Drives of several degrees of freedom, or joints, by name, which begin together; it is over when all of them are done. Those that
    /// never are go on into the parts after it, until a part has another drive for them.
    Together(Vec<(String, Vec<Step>)>),
    /// Nothing new begins until this: [`EndCondition::Lasting`], since the part before was over, or any other but
    /// [`EndCondition::Done`] and [`EndCondition::Part`].
    Until(EndCondition),
}

/// A part, ready to be looked at in a run.
#[derive(Clone, Debug)]
pub(crate) struct Stage {
    /// By degree of freedom the index of its last drive in this part.
    pub(crate) parties: Vec<(usize, usize)>,
    pub(crate) until: EndCondition,
}

impl Simulation {
    /// What drives several degrees of freedom together, one part after the other; in place of what drove these before.
    ///
    /// A degree of freedom that is in a later part only stands still until then. What a part does not name goes on with what it
    /// does: what is done stands still.
    ///
    /// ```
    /// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
    /// use solaris_modes::{Drive, EndCondition, Part, Settings, Shape, Simulation};
    ///
    /// let block = |name: &str| LinkSpec::child(name, "rail", Joint::new(format!("{name}_slide")).tx()).mass(1.0);
    /// let rail = LinkSpec::root("rail", Joint::new("bed"));
    /// let figure = FigureBuilder::new("f").link(rail).link(block("a")).link(block("b")).build()?;
    /// let mut simulation = Simulation::new(&figure, Vector3::zeros());
    /// let part = |name: &str, to, over| {
    ///     (name.to_owned(), vec![Drive::Move { to, over, along: Shape::MinimumJerk }.into()])
    /// };
    /// simulation.sequence(vec![
    ///     Part::Together(vec![part("a_slide", 1.0, 0.5), part("b_slide", 0.2, 0.8)]),
    ///     Part::Until(EndCondition::Lasting(0.2)),
    ///     Part::Together(vec![part("a_slide", 0.0, 0.5)]),
    /// ])?;
    /// let run = simulation.run(&Settings::new(2.0, 10.0))?;
    /// // The second move of the first block begins at 0.8 + 0.2 s.
    /// assert!((run.motion.q(10)[0] - 1.0).abs() < 1e-12 && run.motion.q(15)[0].abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`drive`](Self::drive); [`SetupError::Sequence`] for a part that never is over before the last.
    pub fn sequence(&mut self, parts: Vec<Part>) -> Result<(), SetupError> {
        let mut drives: Vec<Vec<Step>> = vec![Vec::new(); self.drives.len()];
        // By degree of freedom: the last of its drives by now, if the next part that has one is to take over from it.
        let mut stages: Vec<Stage> = Vec::new();
        let count = parts.len();
        for (index, part) in parts.into_iter().enumerate() {
            let before = index.checked_sub(1);
            let named = match part {
                Part::Together(named) => named,
                Part::Until(until) => {
                    if matches!(until, EndCondition::Done | EndCondition::Part(_)) {
                        return Err(SetupError::Sequence { part: index + 1 });
                    }
                    self.check_until(&until, || "the time that a part of the sequence waits".to_owned())?;
                    stages.push(Stage { parties: Vec::new(), until });
                    continue;
                }
            };
            let mut stage = Stage { parties: Vec::new(), until: EndCondition::Done };
            let mut ends = named.is_empty();
            for (name, steps) in named {
                for dof in self.dofs(&name)?.into_iter().filter(|dof| !self.figure.follows(*dof)) {
                    self.check_steps(dof, &steps)?;
                    let own = &mut drives[dof];
                    // What a part says twice of one comes one after the other.
                    let is_first = stage.parties.iter().all(|(other, _)| *other != dof);
                    if let Some(before) = before.filter(|_| is_first) {
                        match own.last_mut() {
                            // It goes on until the part before this one is over.
                            Some(last) if last.until == EndCondition::Done => {
                                last.until = EndCondition::Part(before);
                            }
                            _ => own.push(Step { drive: Drive::Frozen, until: EndCondition::Part(before) }),
                        }
                    }
                    own.extend(steps.iter().cloned());
                    ends |=
                        own.last().is_some_and(|last| last.until != EndCondition::Done || last.drive.ends());
                    stage.parties.retain(|(other, _)| *other != dof);
                    stage.parties.push((dof, own.len() - 1));
                }
            }
            if !ends && index + 1 < count {
                return Err(SetupError::Sequence { part: index + 1 });
            }
            stages.push(stage);
        }
        for (dof, steps) in drives.into_iter().enumerate().filter(|(_, steps)| !steps.is_empty()) {
            self.drives[dof] = steps;
            self.again[dof] = None;
        }
        self.stages = stages;
        Ok(())
    }
}

impl Drive {
    /// Whether it is done by itself some time.
    pub(crate) fn ends(&self) -> bool {
        match self {
            Self::Free | Self::Frozen => false,
            Self::Servo(servo) => matches!(servo.aim, crate::Aim::Along(_)),
            Self::Sum(parts) => parts.iter().any(Self::ends),
            _ => true,
        }
    }
}
