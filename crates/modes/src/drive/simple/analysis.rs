//! The dynamic analysis of a target: the force that goes with it, and what this force does now.

use crate::body::Body;
use crate::drive::Target;
use solaris_dynamics::DynamicsError;
use solaris_model::StateLayout;

/// What an analysis gives, one entry for each target.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Analysis {
    /// The drive's force that goes with the target's state (N m or N).
    pub(crate) force: Vec<f64>,
    /// The acceleration that this force gives in the state that there is (rad/s² or m/s²).
    pub(crate) acceleration: Vec<f64>,
}

/// The analysis of simple mode, for all the targets that are aimed at from one instant on.
///
/// ```text
/// τ* = Hybrid(q, v with the targets' θ₁, θ̇₁; targets' θ̈₁, prescribed a, other τ)     α = Hybrid(q, v; τ*, prescribed a, other τ)
/// ```
///
/// `targets` are degrees of freedom, as indices in `v`, with their targets. Of the others those that are `prescribed` have
/// the acceleration `a`, and the rest the drive's force `tau`, which is zero for an unactuated root; what `prescribed`,
/// `a` and `tau` hold for the targets themselves is not read.
///
/// # Source
///
/// Vasilonikolidakis (1991), §6.2: the inverse dynamics of the target state. Those take the root to be held, and give other
/// forces than these for a figure whose root is free.
#[allow(clippy::too_many_arguments, reason = "a state, what is known of it, and the targets")]
pub(crate) fn analyse(
    body: &mut Body<f64>,
    layout: &StateLayout,
    q: &[f64],
    v: &[f64],
    prescribed: &[bool],
    a: &[f64],
    tau: &[f64],
    targets: &[(usize, Target)],
) -> Result<Analysis, DynamicsError> {
    let (mut q_aim, mut v_aim) = (q.to_vec(), v.to_vec());
    let (mut given, mut a, mut tau) = (prescribed.to_vec(), a.to_vec(), tau.to_vec());
    for (dof, target) in targets {
        // Ball and free joints, whose velocities are the rates of no coordinate, have no such drives.
        if let Some(coordinate) = layout.coordinate(*dof) {
            q_aim[coordinate] = target.position;
        }
        (v_aim[*dof], a[*dof], given[*dof]) = (target.velocity, target.acceleration, true);
    }
    let mut a_aim = a.clone();
    body.hybrid(&q_aim, &v_aim, &given, &mut a_aim, &mut tau)?;
    for (dof, _) in targets {
        given[*dof] = false;
    }
    let force = targets.iter().map(|(dof, _)| tau[*dof]).collect();
    body.hybrid(q, v, &given, &mut a, &mut tau)?;
    Ok(Analysis { force, acceleration: targets.iter().map(|(dof, _)| a[*dof]).collect() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::LimitLaw;
    use approx::assert_abs_diff_eq;
    use nalgebra::Vector3;
    use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec};
    use std::f64::consts::PI;

    fn pendulum() -> Figure {
        let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0));
        FigureBuilder::new("pendulum").link(bob).build().expect("valid")
    }

    /// One target for a pendulum of 2 kg and 0.5 m at rest at an angle.
    fn analysed(gravity: f64, angle: f64, to: f64) -> Analysis {
        let figure = pendulum();
        let mut body =
            Body::new(&figure, Vector3::new(0.0, -gravity, 0.0), &[], &[LimitLaw::Ignore]).expect("valid");
        let targets = [(0, Target::at(to))];
        analyse(&mut body, figure.layout(), &[angle], &[0.0], &[true], &[7.0], &[7.0], &targets)
            .expect("finite")
    }

    #[test]
    fn the_force_is_the_one_that_holds_the_target() {
        // m·g·l·sin θ₁ holds; hanging it gives g/l·sin θ₁, upside down it drives away from the target.
        let (sine, g) = (0.5_f64.sqrt(), 9.81);
        let hanging = analysed(g, 0.0, PI / 4.0);
        assert_abs_diff_eq!(hanging.force[0], 2.0 * g * 0.5 * sine, epsilon = 1e-13);
        assert_abs_diff_eq!(hanging.acceleration[0], g / 0.5 * sine, epsilon = 1e-13);
        let inverted = analysed(-g, 0.0, PI / 4.0);
        assert_abs_diff_eq!(inverted.acceleration[0], -13.873_435, epsilon = 1e-6);
    }

    #[test]
    fn targets_at_one_instant_are_analysed_together_and_the_rest_gives_way() {
        // Two bars on a cart that nothing drives.
        let cart = LinkSpec::root("cart", Joint::new("rail").tx()).mass(3.0);
        let bar = |name: &str, parent: &str| {
            let joint = Joint::new(format!("{name}_hinge")).rz().at(Vector3::new(0.0, -0.4, 0.0));
            LinkSpec::child(name, parent, joint).mass(1.0).com(Vector3::new(0.0, -0.2, 0.0))
        };
        let figure = FigureBuilder::new("crane").link(cart).link(bar("a", "cart")).link(bar("b", "a"));
        let figure = figure.build().expect("valid");
        let mut body =
            Body::new(&figure, Vector3::new(0.0, -9.81, 0.0), &[], &[LimitLaw::Ignore; 3]).expect("valid");
        let (q, v) = ([0.3, 0.2, -0.4], [0.1, 0.5, -0.2]);
        let aim = |position| Target { position, velocity: 0.3, acceleration: 1.5 };
        let targets = [(1, aim(0.7)), (2, aim(0.1))];
        let found = analyse(&mut body, figure.layout(), &q, &v, &[false; 3], &[0.0; 3], &[0.0; 3], &targets)
            .expect("finite");
        // At the target state these forces, and none on the cart, give the targets' accelerations.
        let (mut a, mut tau) = ([0.0; 3], [0.0, found.force[0], found.force[1]]);
        let at_target = ([0.3, 0.7, 0.1], [0.1, 0.3, 0.3]);
        body.hybrid(&at_target.0, &at_target.1, &[false; 3], &mut a, &mut tau).expect("finite");
        assert_abs_diff_eq!(a[1], 1.5, epsilon = 1e-12);
        assert_abs_diff_eq!(a[2], 1.5, epsilon = 1e-12);
        assert!(a[0].abs() > 0.1, "the cart gives way: {}", a[0]);
        // And from where it is they give what was found.
        body.hybrid(&q, &v, &[false; 3], &mut a, &mut tau).expect("finite");
        assert_abs_diff_eq!(a[1], found.acceleration[0], epsilon = 1e-13);
        assert_abs_diff_eq!(a[2], found.acceleration[1], epsilon = 1e-13);
    }
}
