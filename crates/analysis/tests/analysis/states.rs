//! Questions about states that are plain columns, asked the way a user asks them: a motion, prepared, then the question.

use solaris_analysis::ground::{
    self, Consistency, ConsistencyOptions, GroundForces, GroundOptions, PlacedFeet, Sole, StanceOptions,
    Stances,
};
use solaris_analysis::{
    Differentiated, Filter, InverseOptions, InverseReport, Loads, PreparedMotion, differentiate,
};
use solaris_model::{Figure, Known, MeasuredForce, Motion, MotionError, MotionInfo, Vector3};
use std::error::Error;

/// A refusal of any of the steps.
pub(crate) type Refused = Box<dyn Error>;

/// Columns of a motion of which everything is known.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct States {
    pub(crate) time: Vec<f64>,
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
    pub(crate) a: Vec<f64>,
    /// How far (s) a filter reaches into the ends, and of which degrees of freedom something was found.
    pub(crate) unsettled: f64,
    pub(crate) found: Vec<bool>,
}

/// Columns of a motion of which velocities and accelerations may be missing.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Record {
    pub(crate) time: Vec<f64>,
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
    pub(crate) a: Vec<f64>,
    pub(crate) known_v: Vec<bool>,
    pub(crate) known_a: Vec<bool>,
}

impl States {
    pub(crate) fn of(motion: &Motion) -> Self {
        let [q, v, a] = motion.columns().map(<[f64]>::to_vec);
        Self { time: motion.time().to_vec(), q, v, a, ..Self::default() }
    }

    pub(crate) fn motion(&self, figure: &Figure, gravity: Vector3<f64>) -> Result<Motion, MotionError> {
        let info = MotionInfo::recorded(figure, gravity, &self.time);
        let columns = [self.q.clone(), self.v.clone(), self.a.clone()];
        Motion::recorded(figure, info, self.time.clone(), columns, Known::all(figure.layout().nv()))
    }

    fn ask<R>(
        &self,
        figure: &Figure,
        gravity: Vector3<f64>,
        question: impl FnOnce(&PreparedMotion<'_>) -> Result<R, Refused>,
    ) -> Result<R, Refused> {
        let motion = self.motion(figure, gravity)?;
        question(&PreparedMotion::new(figure, &motion)?)
    }

    fn ask_feet<R>(
        &self,
        figure: &Figure,
        gravity: Vector3<f64>,
        soles: &[Sole],
        question: impl FnOnce(&PlacedFeet<'_>) -> Result<R, Refused>,
    ) -> Result<R, Refused> {
        self.ask(figure, gravity, |prepared| question(&PlacedFeet::new(prepared, soles)?))
    }
}

/// What is missing of a record, found.
pub(crate) fn complete(figure: &Figure, record: &Record, filter: Option<Filter>) -> Result<States, Refused> {
    let Record { time, q, v, a, known_v, known_a } = record.clone();
    let info = MotionInfo::recorded(figure, Vector3::zeros(), &time);
    let motion = Motion::recorded(figure, info, time, [q, v, a], Known { v: known_v, a: known_a })?;
    let Differentiated { motion, unsettled, found } = differentiate(figure, &motion, filter)?;
    assert!(motion.known().is_all());
    Ok(States { unsettled, found, ..States::of(&motion) })
}

/// With what was found of the ground.
pub(crate) fn inverse_loaded(
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &States,
    loads: &Loads,
) -> InverseReport {
    let ask = |prepared: &PreparedMotion<'_>| {
        Ok(solaris_analysis::inverse_motion(prepared, loads, InverseOptions::default())?)
    };
    states.ask(figure, gravity, ask).expect("torques")
}

pub(crate) fn inverse_motion(
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &States,
    loads: &[MeasuredForce],
    options: InverseOptions<'_>,
) -> Result<InverseReport, Refused> {
    states.ask(figure, gravity, |prepared| {
        let loads = Loads::at_times(figure, loads, prepared.motion().time())?;
        Ok(solaris_analysis::inverse_motion(prepared, &loads, options)?)
    })
}

pub(crate) fn ground_forces(
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &States,
    soles: &[Sole],
    options: &GroundOptions,
) -> Result<GroundForces, Refused> {
    states.ask_feet(figure, gravity, soles, |feet| Ok(ground::ground_forces(feet, options)?))
}

pub(crate) fn find_stances(
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &States,
    soles: &[Sole],
    options: &StanceOptions,
) -> Result<Stances, Refused> {
    states.ask_feet(figure, gravity, soles, |feet| Ok(ground::find_stances(feet, options)?))
}

pub(crate) fn consistent_shift(
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &States,
    soles: &[Sole],
    stances: &Stances,
    options: &ConsistencyOptions,
) -> Result<Consistency, Refused> {
    states.ask_feet(figure, gravity, soles, |feet| Ok(ground::consistent_shift(feet, stances, options)?))
}

pub(crate) fn make_consistent(
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &mut States,
    soles: &[Sole],
    stances: &Stances,
    options: &ConsistencyOptions,
) -> Result<Consistency, Refused> {
    let found = consistent_shift(figure, gravity, states, soles, stances, options)?;
    shift_root(figure, states, &found)?;
    Ok(found)
}

pub(crate) fn shift_root(figure: &Figure, states: &mut States, found: &Consistency) -> Result<(), Refused> {
    let mut motion = states.motion(figure, Vector3::zeros())?;
    ground::shift_root(figure, &mut motion, found)?;
    *states = States::of(&motion);
    Ok(())
}
