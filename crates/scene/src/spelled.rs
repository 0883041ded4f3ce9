//! Remedies of a simulation spelled in the words of a scene.

use solaris_modes::{Remedy, RunError, SetupError};

/// What stands in a scene for a remedy, where something does.
fn remedy(remedy: &Remedy) -> Option<&'static str> {
    Some(match remedy {
        Remedy::ToleranceForStep => "tolerance: 1e-6",
        Remedy::StiffMethod => "method: Stiff(tolerance: 1e-6)",
        Remedy::NamedMethod { .. } => "method: RungeKutta4(step: …)",
        Remedy::MoreEvaluations => "guard: Guard(evaluations: …)",
        Remedy::StartAtCurve => "start: {…}, velocities: {…}",
        Remedy::MoveInstead => "Move(…)",
        Remedy::SoftLimits => "limits: Spring(stiffness: 500)",
        Remedy::Impulses => "method: Impulses(step: 1e-3)",
        Remedy::CompliantGround => "contact: Compliant()",
        _ => return None,
    })
}

/// What a setup is refused for, in the words of a scene.
pub(crate) fn setup(error: &SetupError) -> String {
    match error {
        SetupError::NoGround => format!("{error} (contact: Compliant(stiffness: 1e5), up: (0, 1, 0))"),
        SetupError::NoWayDown { .. } => format!("{error} (start: {{…}}, without stand)"),
        SetupError::NotBuiltIn { .. } => format!(
            "{error} (method: RungeKutta4(step: 1e-3)), or build with the feature stiff (cargo build --release --features stiff)"
        ),
        _ => error.to_string(),
    }
}

/// Why a run has no motion, in the words of a scene.
pub(crate) fn run(error: &RunError) -> String {
    match error {
        RunError::Setup(error) => setup(error),
        RunError::Failed(failure) => failure.told(remedy),
        _ => error.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris_modes::{FailureKind, RunFailure};

    #[test]
    fn trouble_says_what_to_write() {
        let remedies = vec![Remedy::StepBelow { step: 1e-4 }, Remedy::StiffMethod];
        let cause = FailureKind::Energy { share: 0.5 };
        let error = RunError::from(RunFailure { time: 1.0, dof: None, cause, remedies });
        let said = ": take a step below 1.0e-4 s, or take a stiff method (method: Stiff(tolerance: 1e-6))";
        assert!(run(&error).ends_with(said), "{}", run(&error));
        assert!(!error.to_string().contains("method:"), "{error}");
    }

    #[test]
    fn setups_say_what_to_write() {
        let error = SetupError::NotBuiltIn { method: "stiff" };
        let said = "take Runge-Kutta 4 with a step (method: RungeKutta4(step: 1e-3)), or build with the feature stiff";
        assert!(setup(&error).contains(said), "{}", setup(&error));
    }
}
