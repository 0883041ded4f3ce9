//! The guard of a pass: condition, stiffness, energy, and the failures it names.

use crate::contact::ContactLaw;
use crate::failure::{FailureKind, Remedy, RunError, RunFailure, SetupError};
use crate::phase::Phase;
use crate::settings::Guard;
use crate::simulation::Simulation;
use crate::time::{RateError, Stepping, System, TimeError};
use nalgebra::{DMatrix, DVector, Schur};
use solaris_dynamics::DynamicsError;
use solaris_model::{AxisKind, EulerOrder};

/// The largest state whose eigenvalues are found: they take the cube of it.
const MOST_STATES: usize = 160;

/// Sweeps for each eigenvalue, of which two or three are usual.
const MOST_SWEEPS: usize = 30;

/// Multiplications for a bound of the eigenvalues.
const MOST_TURNS: usize = 24;

/// The least entry of a vector of positive ones, beside 1.
const LEAST_PART: f64 = 1e-12;

/// How near gimbal lock (rad) a joint may be what went wrong.
const NEAR_LOCK: f64 = 0.35;

/// The least part of a step that advice after failure may come down to.
const BELIEVED: f64 = 1e-2;

/// Looks at a frame of a run by `stepping`: `share` is the part of the energy that has come from nowhere.
pub(crate) fn look(
    simulation: &Simulation,
    guard: &Guard,
    phase: &Phase,
    stepping: Stepping,
    (time, q): (f64, &[f64]),
    share: f64,
) -> Result<(), Box<RunFailure>> {
    let figure = &simulation.figure;
    let distances = figure.gimbal_distances(q).map_err(|error| {
        let (cause, remedies) = (FailureKind::State(error.to_string()), vec![Remedy::ShorterStep]);
        Box::new(RunFailure { time, dof: None, cause, remedies })
    })?;
    for at in distances.filter(|at| at.distance < guard.gimbal) {
        let joint = figure.layout().joints()[at.joint];
        if !(joint.v..joint.v + joint.nv).any(|dof| phase.moves(dof)) {
            continue;
        }
        let name = figure.links()[at.joint].joint().name().to_owned();
        let remedies = vec![Remedy::OtherAxes { order: other_order(simulation, at.joint, q) }];
        let (dof, cause) =
            (Some(name.clone()), FailureKind::GimbalLock { joint: name, distance: at.distance });
        return Err(Box::new(RunFailure { time, dof, cause, remedies }));
    }
    // A share that is NaN is failure too.
    if share.partial_cmp(&guard.energy).is_none_or(std::cmp::Ordering::is_gt) {
        let remedies = match stepping {
            Stepping::Fixed { step, .. } | Stepping::Impulses { step } => {
                vec![Remedy::StepOf { step: 0.1 * step }, Remedy::ToleranceForStep]
            }
            Stepping::Adaptive { tolerance } | Stepping::Stiff { tolerance } => {
                vec![Remedy::SmallerTolerance { tolerance: 0.1 * tolerance }]
            }
        };
        return Err(Box::new(RunFailure { time, dof: None, cause: FailureKind::Energy { share }, remedies }));
    }
    Ok(())
}

/// Advice for the joint that came nearest to gimbal lock in some `states` (positions, one after the other), where dynamics move one that
/// came as near as steps jump over.
fn near_lock(simulation: &Simulation, phase: &Phase, states: &[f64]) -> Option<Remedy> {
    let figure = &simulation.figure;
    let moved = |joint: usize| {
        let at = figure.layout().joints()[joint];
        (at.v..at.v + at.nv).any(|dof| phase.moves(dof))
    };
    let states = states.chunks(figure.layout().nq().max(1));
    let all = states.filter_map(|q| figure.gimbal_distances(q).ok()).flatten();
    let near = all.filter(|at| at.distance < NEAR_LOCK && moved(at.joint));
    let nearest = near.min_by(|a, b| a.distance.total_cmp(&b.distance))?;
    let joint = figure.links()[nearest.joint].joint().name().to_owned();
    Some(Remedy::AwayFromLock { joint, distance: nearest.distance })
}

/// Looks at the equations of a phase before the first step.
pub(crate) fn look_before(
    simulation: &Simulation,
    guard: &Guard,
    phase: &mut Phase,
    stepping: Stepping,
    time: f64,
    y: &[f64],
) -> Result<(), RunError> {
    let (mut q, mut v) = (simulation.q.clone(), simulation.v.clone());
    phase.unpack(time, y, &mut q, &mut v);
    look(simulation, guard, phase, stepping, (time, &q), 0.0)?;
    let beyond = phase.condition_beyond(time, y, guard.condition);
    if let Some((condition, dof)) = beyond.map_err(|error| of_dynamics(time, error))? {
        let dof = simulation.name(dof).to_owned();
        let cause = FailureKind::IllConditioned { condition, dof: dof.clone() };
        let remedies = vec![Remedy::MoreInertia];
        return Err(Box::new(RunFailure { time, dof: Some(dof), cause, remedies }).into());
    }
    too_long(simulation, phase, stepping, time, y).map_or(Ok(()), |failure| Err(failure.into()))
}

/// Whether a fixed step is beyond stability: `h·|λ|` more than the rule allows.
fn too_long(
    simulation: &Simulation,
    phase: &mut Phase,
    stepping: Stepping,
    time: f64,
    y: &[f64],
) -> Option<Box<RunFailure>> {
    let Stepping::Fixed { rule, step } = stepping else { return None };
    let motion = motion(phase, time, y)?;
    // Eigenvalues take the cube of the state, a bound of them its square.
    let most = rule.stability() / step;
    if magnitude_bound(&motion, most) <= most {
        return None;
    }
    let (eigenvalue, dof) = stiffest(phase, &motion)?;
    let longest = rule.stability() / eigenvalue.abs();
    if step <= longest {
        return None;
    }
    let dof = dof.map_or_else(|| "the figure".to_owned(), |dof| simulation.name(dof).to_owned());
    let remedies = vec![Remedy::StepBelow { step: longest }, Remedy::StiffMethod];
    let cause =
        FailureKind::StepTooLong { method: rule.to_string(), step, longest, eigenvalue, dof: dof.clone() };
    Some(Box::new(RunFailure { time, dof: Some(dof), cause, remedies }))
}

/// The eigenvalue (1/s) of greatest magnitude of how rates change with positions and velocities, its magnitude with the sign of its
/// real part, and the degree of freedom that moves most in its direction; `None` without motion.
fn stiffest(phase: &Phase, motion: &DMatrix<f64>) -> Option<(f64, Option<usize>)> {
    let n = motion.nrows();
    // Without a bound the search for them may not end. The coarser one is told from the finer by no more than its own 1e-9.
    let schur = |least| Schur::try_new(motion.clone(), least, MOST_SWEEPS * n);
    let eigenvalues = schur(f64::EPSILON).or_else(|| schur(1e-9))?.complex_eigenvalues();
    let stiffest = eigenvalues.iter().copied().max_by(|a, b| a.norm().total_cmp(&b.norm()))?;
    let magnitude = stiffest.norm();
    if magnitude == 0.0 {
        return None;
    }
    // A few multiplications turn any direction into that of the greatest eigenvalues.
    let mut direction = DVector::from_fn(n, |i, _| 1.0 + (i % 7) as f64 * 0.1);
    for _ in 0..40 {
        direction = motion * direction / magnitude;
        let length = direction.norm();
        if !(length.is_finite() && length > 0.0) {
            break;
        }
        direction /= length;
    }
    let entry =
        direction.iter().enumerate().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).map(|(i, _)| i)?;
    Some((magnitude.copysign(stiffest.re), phase.dof_of(entry)))
}

/// How the rates of positions and velocities change with them; `None` for a state too large, or one without motion.
fn motion(phase: &mut Phase, time: f64, y: &[f64]) -> Option<DMatrix<f64>> {
    let n = Some(phase.accounts()).filter(|n| (1..=MOST_STATES).contains(n))?;
    let mut jacobian = DMatrix::zeros(y.len(), y.len());
    phase.jacobian(time, y, &mut jacobian).ok()?;
    let motion = jacobian.view((0, 0), (n, n)).into_owned();
    motion.iter().all(|x| x.is_finite()).then_some(motion)
}

/// What no eigenvalue of a square matrix exceeds in magnitude, for the square of its size in work:
///
/// ```text
/// |λ| ≤ max_i (|A|·x)_i / x_i    for any x > 0
/// ```
///
/// with an `x` near the one for which the quotients are equal, or the first for which the bound is `enough`.
///
/// # Source
///
/// L. Collatz: Einschließungssatz für die charakteristischen Zahlen von Matrizen. Mathematische Zeitschrift 48 (1942), 221–226.
fn magnitude_bound(matrix: &DMatrix<f64>, enough: f64) -> f64 {
    let matrix = matrix.abs();
    let mut x = DVector::repeat(matrix.nrows(), 1.0);
    let mut least = f64::INFINITY;
    for _ in 0..MOST_TURNS {
        let y = &matrix * &x;
        let bound = y.component_div(&x).max();
        least = least.min(bound);
        if least <= enough {
            break;
        }
        // Without a part of itself it would go to and fro between positions and velocities.
        x = y + x * (0.5 * least);
        x /= x.max();
        x.iter_mut().for_each(|entry| *entry = entry.max(LEAST_PART));
    }
    least
}

/// Says more of failure that a step too long, or gimbal lock, may have caused. `before` are the positions of the last frames, where there are
/// some.
pub(crate) fn explain(
    simulation: &Simulation,
    phase: &mut Phase,
    stepping: Stepping,
    (y, before): (&[f64], &[f64]),
    mut failure: RunFailure,
) -> RunError {
    let suspect = matches!(
        failure.cause,
        FailureKind::Energy { .. }
            | FailureKind::Stuck { .. }
            | FailureKind::Dynamics(_)
            | FailureKind::NotFinite { .. }
    );
    let state = y.iter().all(|x| x.is_finite());
    // A state that has run away has eigenvalues that say nothing.
    let is_believed = |found: &RunFailure| match found.cause {
        FailureKind::StepTooLong { step, longest, .. } => longest > BELIEVED * step,
        _ => true,
    };
    let found = (suspect && state).then(|| too_long(simulation, phase, stepping, failure.time, y)).flatten();
    let found = found.filter(|found| is_believed(found));
    // What is held and let go again and again on rigid ground takes a step each time.
    let is_rigid = simulation.grounded().is_some_and(|(plane, _)| plane.law == ContactLaw::Rigid);
    if is_rigid && matches!(failure.cause, FailureKind::Evaluations { .. }) {
        failure.remedies.insert(0, Remedy::Impulses);
    }
    if suspect {
        let (mut q, mut v) = (simulation.q.clone(), simulation.v.clone());
        let mut states = before.to_vec();
        if state {
            phase.unpack(failure.time, y, &mut q, &mut v);
            states.extend(q);
        }
        failure.remedies.splice(..0, near_lock(simulation, phase, &states));
    }
    found.unwrap_or_else(|| Box::new(failure)).into()
}

/// Trouble of a stepper.
pub(crate) fn of_time(error: TimeError) -> Result<RunFailure, RunError> {
    Ok(match error {
        TimeError::Rate { time, source } => of_rate_at(time, source),
        TimeError::Stuck { time, method, why } => {
            let remedies = vec![Remedy::LookAtJumps, Remedy::LargerTolerance];
            RunFailure { time, dof: None, cause: FailureKind::Stuck { method, why }, remedies }
        }
        TimeError::Evaluations { time, evaluations } => {
            let remedies = vec![
                Remedy::ShorterRun,
                Remedy::LargerTolerance,
                Remedy::StiffMethod,
                Remedy::MoreEvaluations,
            ];
            RunFailure { time, dof: None, cause: FailureKind::Evaluations { evaluations }, remedies }
        }
        error @ (TimeError::NoPositions { .. } | TimeError::NoImpulses | TimeError::Range { .. }) => {
            let (why, method) = (error.to_string(), "the stepper".to_owned());
            let cause = FailureKind::Stuck { method, why };
            RunFailure { time: 0.0, dof: None, cause, remedies: vec![Remedy::OtherMethod] }
        }
        TimeError::NotBuiltIn { method } => return Err(SetupError::NotBuiltIn { method }.into()),
    })
}

/// Trouble of a rate.
pub(crate) fn of_rate(time: f64, error: RateError) -> RunError {
    of_rate_at(time, error).into()
}

fn of_rate_at(time: f64, error: RateError) -> RunFailure {
    let cause = match error {
        RateError::Dynamics(source) => FailureKind::Dynamics(source),
        RateError::NotFinite { value, .. } | RateError::EventNotFinite { value, .. } => {
            FailureKind::NotFinite { value }
        }
        RateError::Stopped => {
            FailureKind::Stuck { method: "the run".to_owned(), why: "it was stopped".to_owned() }
        }
    };
    RunFailure { time, dof: None, cause, remedies: vec![Remedy::ShorterStep, Remedy::LookAtRequest] }
}

/// Trouble of the kernel.
pub(crate) fn of_dynamics(time: f64, error: DynamicsError) -> RunFailure {
    of_rate_at(time, RateError::Dynamics(error))
}

/// The order of rotations that is farthest from lock where a joint is in lock, and how far (rad).
fn other_order(simulation: &Simulation, link: usize, q: &[f64]) -> Option<(EulerOrder, f64)> {
    let figure = &simulation.figure;
    let (joint, at) = (figure.links()[link].joint(), figure.layout().joints()[link]);
    let turns =
        joint.kind().axes().iter().zip(&q[at.q..]).filter(|(dof, _)| dof.axis.kind == AxisKind::Rotation);
    let turned = turns.fold(nalgebra::Rotation3::identity(), |turned, (dof, angle)| {
        turned * nalgebra::Rotation3::new(dof.axis.direction * *angle)
    });
    let orders = EulerOrder::ALL.into_iter().map(|order| (order, middle(order, &turned)));
    orders.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// How far (rad) the order's middle rotation is from lock where it makes up the rotation `R = R_i·R_j·R_k`: `R·e_k` has the
/// component `± sin b` along `e_i`.
fn middle(order: EulerOrder, turned: &nalgebra::Rotation3<f64>) -> f64 {
    let [first, _, last] = order.axes();
    let sine: f64 = turned.matrix()[(first, last)];
    std::f64::consts::FRAC_PI_2 - sine.abs().min(1.0).asin()
}

#[cfg(test)]
mod tests {
    use super::magnitude_bound;
    use nalgebra::DMatrix;

    /// A swing of 3 rad/s, two masses on springs, and a matrix without a pattern.
    #[test]
    fn no_eigenvalue_is_beyond_its_bound() {
        let swing = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -9.0, 0.0]);
        assert!((magnitude_bound(&swing, 0.0) - 3.0).abs() < 1e-3, "{}", magnitude_bound(&swing, 0.0));
        assert!((magnitude_bound(&swing, 10.0) - 9.0).abs() < 1e-12);
        #[rustfmt::skip]
        let masses = DMatrix::from_row_slice(4, 4, &[
            0.0, 0.0, 1.0, 0.0,
            0.0, 0.0, 0.0, 1.0,
            -2e6, 1e6, -10.0, 0.0,
            5.0, -5.0, 0.0, 0.0,
        ]);
        let any =
            DMatrix::from_fn(7, 7, |i, j| ((3 * i + 5 * j) as f64).sin() * 10_f64.powi(i as i32 - j as i32));
        for matrix in [swing, masses, any, DMatrix::zeros(3, 3)] {
            let greatest = matrix.complex_eigenvalues().iter().fold(0.0_f64, |most, x| most.max(x.norm()));
            let bound = magnitude_bound(&matrix, 0.0);
            assert!(greatest <= bound * (1.0 + 1e-12), "{greatest} {bound}");
            assert!(bound <= 20.0 * greatest, "{greatest} {bound}");
        }
    }
}
