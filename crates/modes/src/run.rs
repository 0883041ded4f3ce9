//! A simulation from its beginning to its end.

mod active_contacts;
mod automatic;
mod between;
mod carries;
mod closing;
mod compare;
mod contacts;
mod driven;
mod drives;
mod guard;
mod impacts;
mod ledger;
mod looks;
mod outcomes;
mod pass;
mod passes;
mod present;
mod pushes;
mod record;
mod running;
mod stages;
mod touching;
mod tracks;
mod usual;
mod watching;

use crate::failure::{FailureKind, Remedy, RunError, RunFailure, SetupError};
use crate::range::check_not_negative;
use crate::report::{Cost, Counts, ErrorEstimate, Observer, Remark, Run, RunReport};
use crate::settings::{Method, Settings};
use crate::simulation::Simulation;
use crate::time::Stepping;
use crate::{Drive, LimitLaw, Step};
use carries::LoadedBody;
pub(crate) use pass::Pass;
use pass::{Passed, pass};
use passes::Passes;
pub(crate) use present::Present;
pub use present::Touching;
pub(crate) use running::Progress;
use solaris_dynamics::Wrench;
use solaris_model::Motion;
use std::sync::Arc;
pub(crate) use usual::STEP;

/// Whether the implicit method is built in.
const IS_STIFF: bool = cfg!(feature = "stiff");

/// The part of the energy at play that may be missing from the balance without a remark.
const UNBALANCED: f64 = 1e-3;

/// The most frames of a run.
const MOST_FRAMES: f64 = 1e7;

/// A pass with what was found out about it.
struct Chosen {
    passed: Passed,
    error: Option<ErrorEstimate>,
    method: String,
    why: String,
    /// What other passes took.
    beside: Counts,
    remarks: Vec<Remark>,
}

impl Simulation {
    /// Refuses settings out of range, what waits for a ground that is not there, and loops that begin open: what can be told without
    /// beginning to run.
    ///
    /// # Errors
    ///
    /// [`SetupError`].
    pub fn check_setup(&self, settings: &Settings) -> Result<(), SetupError> {
        check_settings(settings)?;
        touching::check(self)?;
        let method = match settings.method {
            Method::Usual => self.usual_method(),
            method => method,
        };
        if matches!(method, Method::Impulses { .. }) || self.closed().next().is_none() {
            return Ok(());
        }
        let (mut q, mut v) = (self.q.clone(), self.v.clone());
        self.figure.follow(&mut q, &mut v, &mut vec![0.0; self.v.len()]);
        let mut body = crate::body::Body::new(&self.figure, self.gravity, &[], &self.limits)?;
        closing::check(self, &mut body, &q, &v)
    }

    /// Refuses what [`Self::run`] would refuse at the beginning: settings out of range, drives that cannot begin, a start
    /// that the guard does not let pass.
    ///
    /// # Errors
    ///
    /// [`RunError`].
    pub fn check(&self, settings: &Settings) -> Result<(), RunError> {
        check_settings(settings)?;
        check_work(settings)?;
        let beginning = Settings { duration: 0.0, estimate: false, ..settings.clone() };
        self.run(&beginning).map(|_| ())
    }

    /// Runs it.
    ///
    /// # Errors
    ///
    /// [`RunError`].
    pub fn run(&self, settings: &Settings) -> Result<Run, RunError> {
        self.run_observed(settings, &mut ())
    }

    /// Runs it while somebody looks on.
    ///
    /// # Errors
    ///
    /// [`RunError`].
    pub fn run_observed(&self, settings: &Settings, observer: &mut dyn Observer) -> Result<Run, RunError> {
        run(self, settings, observer)
    }
}

/// Runs a simulation.
fn run(simulation: &Simulation, settings: &Settings, observer: &mut dyn Observer) -> Result<Run, RunError> {
    check_settings(settings)?;
    check_work(settings)?;
    let simulation = &Arc::new(simulation.clone());
    let begun = observer.now();
    let chosen = match settings.method {
        Method::Usual => usual::choose(simulation, settings, observer)?,
        Method::Automatic { tolerance } => {
            automatic::choose(simulation, settings, tolerance, &mut Passes::new(observer, settings))?
        }
        Method::Fixed { rule, step } => {
            // The step that is taken: no longer than a frame, and so many to a frame.
            let step = (settings.rate * steps_in_frame(step, settings.rate)).recip();
            named(simulation, settings, Stepping::Fixed { rule, step }, observer)?
        }
        Method::Impulses { step } => by_impulses(simulation, settings, step, observer)?,
        Method::Adaptive { tolerance } => {
            named(simulation, settings, Stepping::Adaptive { tolerance }, observer)?
        }
        Method::Stiff { tolerance } => named(simulation, settings, Stepping::Stiff { tolerance }, observer)?,
    };
    let Chosen { passed, error, method, why, beside, mut remarks } = chosen;
    remarks.extend(outside(simulation));
    let Passed {
        mut record,
        ledger,
        mut counts,
        outcomes,
        impacts,
        landings,
        mut phases,
        ground,
        pushed,
        by_impulses,
        ..
    } = passed;
    let planted = std::mem::take(&mut record.planted);
    counts.add(&beside);
    let all_between = std::mem::take(&mut record.between);
    let mut motion = record.motion(&simulation.figure, simulation.gravity, settings.rate)?;
    let mut ground = contacts::add(simulation, &mut motion, &ground, &planted, by_impulses)?;
    if let Some(ground) = &mut ground {
        ground.landings = landings;
    }
    let told = between::add(simulation, &mut motion, &all_between);
    if settings.forces {
        let acting = |frame: usize| {
            let own = planted[planted.partition_point(|(of, ..)| *of < frame)..].iter();
            let own = own.take_while(|(of, ..)| *of == frame).map(|(_, link, wrench)| (*link, *wrench));
            own.chain(between::wrenches(&all_between, frame)).collect()
        };
        add_forces(simulation, &mut motion, &acting, by_impulses)?;
    } else {
        let omitted = "forces of the drives: nobody asked for them";
        for phase in &mut phases {
            phase.omitted.push(omitted.to_owned());
        }
    }
    let seconds = begun.zip(observer.now()).map(|(begun, ended)| ended - begun);
    let mut energy = ledger.report;
    let share = energy.imbalance / energy.scale;
    if energy.scale > 0.0 && share > UNBALANCED {
        remarks.push(Remark::Energy { share });
    }
    energy.pushes = pushed;
    energy.work -= pushed;
    let cost = Cost { counts, seconds };
    let report = RunReport {
        method,
        why,
        error,
        cost,
        energy,
        outcomes,
        impacts,
        phases,
        ground,
        collisions: told.collisions,
        loops: told.loops,
        remarks,
    };
    Ok(Run { motion, report })
}

fn check_settings(settings: &Settings) -> Result<(), SetupError> {
    check_not_negative(|| "the duration of the run".to_owned(), settings.duration)?;
    let Settings { rate, duration, method, .. } = settings;
    if !(*rate > 0.0 && *rate <= 1e5) {
        let what = "the rate of the run".to_owned();
        return Err(SetupError::Range { what, value: *rate, range: "above 0 and at most 100000 frames/s" });
    }
    if rate * duration > MOST_FRAMES {
        let what = "the number of frames, duration times rate,".to_owned();
        return Err(SetupError::Range { what, value: rate * duration, range: "at most 1e7" });
    }
    match *method {
        Method::Fixed { step, .. } | Method::Impulses { step } if !(step.is_finite() && step > 0.0) => {
            let what = "the step".to_owned();
            Err(SetupError::Range { what, value: step, range: "a finite time above zero (s)" })
        }
        Method::Automatic { tolerance } | Method::Adaptive { tolerance } | Method::Stiff { tolerance }
            if !(1e-14..=1.0).contains(&tolerance) =>
        {
            Err(SetupError::Range { what: "the tolerance".to_owned(), value: tolerance, range: "1e-14 to 1" })
        }
        Method::Stiff { .. } if !IS_STIFF => Err(SetupError::NotBuiltIn { method: "stiff" }),
        _ => Ok(()),
    }
}

/// Refuses steps so short that the run cannot come to its end.
fn check_work(settings: &Settings) -> Result<(), Box<RunFailure>> {
    let (step, each) = match settings.method {
        Method::Fixed { rule, step } => (step, rule.evaluations()),
        Method::Impulses { step } => (step, 1),
        _ => return Ok(()),
    };
    let evaluations = settings.duration / step * each as f64;
    if evaluations <= settings.guard.evaluations as f64 {
        return Ok(());
    }
    let most = settings.guard.evaluations;
    let longer = settings.duration * each as f64 / most as f64;
    let cause = FailureKind::Evaluations { evaluations: most };
    let remedies = vec![Remedy::StepAbove { step: longer, evaluations }, Remedy::MoreEvaluations];
    Err(Box::new(RunFailure { time: 0.0, dof: None, cause, remedies }))
}

/// What starts outside of a hard limit, which then does not hold it.
fn outside(simulation: &Simulation) -> Vec<Remark> {
    let figure = &simulation.figure;
    let is_hard = |dof: usize| matches!(simulation.limits[dof], LimitLaw::Hard { .. });
    let is_ever_free = |dof: usize| {
        let given = |step: &Step| {
            matches!(
                step.drive,
                Drive::Frozen | Drive::Kinematic(_) | Drive::Move { .. } | Drive::Recorded(_)
            )
        };
        !simulation.drives[dof].iter().all(given)
    };
    let excess = figure.limit_excess(&simulation.q).into_iter();
    excess
        .filter(|excess| is_hard(excess.dof) && is_ever_free(excess.dof) && excess.by > 1e-9)
        .map(|excess| Remark::OutsideLimits { dof: simulation.name(excess.dof).to_owned(), by: excess.by })
        .collect()
}

/// What a stepping is called.
fn describe(stepping: Stepping, rate: f64) -> String {
    match stepping {
        // The step that is taken divides a frame.
        Stepping::Fixed { rule, step } => {
            let step = (rate * steps_in_frame(step, rate)).recip();
            format!("{rule}, step {step:.3e} s")
        }
        Stepping::Impulses { step } => {
            let step = (rate * steps_in_frame(step, rate)).recip();
            format!("impulses, step {step:.3e} s")
        }
        Stepping::Adaptive { tolerance } => format!("adaptive explicit, tolerance {tolerance:e}"),
        Stepping::Stiff { tolerance } => format!("stiff implicit, tolerance {tolerance:e}"),
    }
}

/// By impulses, in steps of so many to a frame that none is longer than this (s).
fn by_impulses(
    simulation: &Arc<Simulation>,
    settings: &Settings,
    step: f64,
    observer: &mut dyn Observer,
) -> Result<Chosen, RunError> {
    let step = (settings.rate * steps_in_frame(step, settings.rate)).recip();
    named(simulation, settings, Stepping::Impulses { step }, observer)
}

/// By the method that was named, with an error estimate where one is wanted: the difference from a run with twice the step.
///
/// ```text
/// |x(h) − x(2h)| = (2ᵖ − 1)·e(h)
/// ```
///
/// for a step short enough. Whether it is, two runs do not tell, so nothing is divided by what order `p` promises.
fn named(
    simulation: &Arc<Simulation>,
    settings: &Settings,
    stepping: Stepping,
    observer: &mut dyn Observer,
) -> Result<Chosen, RunError> {
    let passes = &mut Passes::new(observer, settings);
    let passed = pass(simulation, settings, stepping, &mut passes.main(stepping))?;
    let (mut beside, mut remarks, mut error) = (Counts::default(), Vec::new(), None);
    if settings.estimate && passed.is_dynamic {
        let coarser = coarser(stepping, settings.rate)
            .map(|coarser| pass(simulation, settings, coarser, &mut passes.next(coarser)));
        // Where there is no coarser run, or it comes to grief, a finer one tells as much.
        let (other, factor) = match coarser {
            Some(Err(RunError::Cancelled)) => return Err(RunError::Cancelled),
            Some(Ok(other)) => (Some(other), 1.0),
            _ => {
                let finer = finer(stepping, settings.rate);
                let finer = pass(simulation, settings, finer, &mut passes.next(finer)).ok();
                // The finer run has at least half of the error.
                (finer, 2.0)
            }
        };
        match other {
            Some(other) => {
                beside = other.counts;
                error = Some(compare::estimate(&simulation.figure, &passed, &other, factor)?);
            }
            None => remarks.push(Remark::NoEstimate),
        }
    }
    if !passed.is_dynamic {
        error = settings.estimate.then(ErrorEstimate::default);
    }
    let method = if passed.is_dynamic { describe(stepping, settings.rate) } else { NOTHING.to_owned() };
    let why = if passed.is_dynamic { NAMED } else { "every motion is given" }.to_owned();
    Ok(Chosen { passed, error, method, why, beside, remarks })
}

/// Why it was taken where somebody said so.
const NAMED: &str = "it was named";

/// What the method is called where there is none.
const NOTHING: &str = "none: nothing is integrated";

/// Steps in a frame: no step is longer than a frame.
fn steps_in_frame(step: f64, rate: f64) -> f64 {
    (1.0 / (rate * step) - 1e-9).ceil().max(1.0)
}

/// The same method with at least twice the step, or ten times the tolerance; none where a step is a frame already.
fn coarser(stepping: Stepping, rate: f64) -> Option<Stepping> {
    match stepping {
        Stepping::Fixed { rule, step } => {
            let count = (0.5 * steps_in_frame(step, rate)).floor();
            (count > 0.0).then(|| Stepping::Fixed { rule, step: (rate * count).recip() })
        }
        Stepping::Impulses { step } => {
            let count = (0.5 * steps_in_frame(step, rate)).floor();
            (count > 0.0).then(|| Stepping::Impulses { step: (rate * count).recip() })
        }
        Stepping::Adaptive { tolerance } => Some(Stepping::Adaptive { tolerance: 10.0 * tolerance }),
        Stepping::Stiff { tolerance } => Some(Stepping::Stiff { tolerance: 10.0 * tolerance }),
    }
}

/// The same method with half the step, or a tenth of the tolerance.
fn finer(stepping: Stepping, rate: f64) -> Stepping {
    match stepping {
        Stepping::Fixed { rule, step } => {
            Stepping::Fixed { rule, step: (2.0 * rate * steps_in_frame(step, rate)).recip() }
        }
        Stepping::Impulses { step } => {
            Stepping::Impulses { step: (2.0 * rate * steps_in_frame(step, rate)).recip() }
        }
        Stepping::Adaptive { tolerance } => Stepping::Adaptive { tolerance: 0.1 * tolerance },
        Stepping::Stiff { tolerance } => Stepping::Stiff { tolerance: 0.1 * tolerance },
    }
}

fn scaled(difference: ErrorEstimate, factor: f64) -> ErrorEstimate {
    ErrorEstimate { position: factor * difference.position, velocity: factor * difference.velocity }
}

/// What acts on links in a frame: each with its wrench about the world's origin (N, N m).
pub type Acting = Vec<(usize, Wrench<f64>)>;

impl Simulation {
    /// What springs between points and pushes do to links in the frames of a motion of the figure: links and wrenches about the world's origin (N, N m), of which each
    /// frame has equally many. What the ground, other links and loops do, a run's motion has among its contacts; a blow in an instant is no force.
    ///
    /// # Errors
    ///
    /// A motion of another figure.
    pub fn acting(&self, motion: &Motion) -> Result<Vec<Acting>, RunError> {
        motion.check_figure(&self.figure).map_err(SetupError::from)?;
        let thrusts = pushes::thrusts(self)?;
        let mut body = LoadedBody::new(self, true)?.body;
        let frame = |frame: usize| {
            let time = motion.time()[frame];
            for (push, force) in pushes::after(&thrusts, time) {
                body.set_push(push, &force);
            }
            let acting = body.acting(motion.q(frame), motion.v(frame));
            acting.map(<[_]>::to_vec).map_err(|error| guard::of_dynamics(time, error).into())
        };
        (0..motion.len()).map(frame).collect()
    }
}

/// The forces of the drives in every frame; where a limit holds something, with what the limit adds.
///
/// `acting` is what acts on links in a frame besides (N, N m, about the world's origin): the ground on what stands on it, and links on
/// each other.
fn add_forces(
    simulation: &Simulation,
    motion: &mut Motion,
    acting: &dyn Fn(usize) -> Vec<(usize, Wrench<f64>)>,
    by_impulses: bool,
) -> Result<(), RunError> {
    let figure = &simulation.figure;
    let nv = figure.layout().nv();
    let thrusts = pushes::thrusts(simulation)?;
    let mut loaded = LoadedBody::new(simulation, by_impulses)?;
    let mut tau = vec![0.0; motion.len() * nv];
    for (frame, tau) in tau.chunks_exact_mut(nv.max(1)).enumerate() {
        loaded.go_to(simulation, motion.time()[frame])?;
        let body = &mut loaded.body;
        for (push, force) in pushes::after(&thrusts, motion.time()[frame]) {
            body.set_push(push, &force);
        }
        body.inverse(motion.q(frame), motion.v(frame), motion.a(frame), &acting(frame), tau)
            .map_err(|error| guard::of_dynamics(motion.time()[frame], error))?;
        figure.fold_forces(motion.q(frame), tau);
    }
    Ok(motion.set_tau(tau).map_err(SetupError::from)?)
}
