//! Accelerations whose momentum is that of the positions.

use crate::error::ReactionError;
use nalgebra::Vector3;
use solaris_dynamics::{Tree, Workspace, center_of_mass, inverse_dynamics};
use solaris_model::{AxisKind, DifferenceStep, Figure, Motion, Trajectory};

/// Corrects the root's linear accelerations in samples of a trajectory so that the centre of mass accelerates by the differences of its own positions.
///
/// Positions are differenced coordinate by coordinate, and the centre of mass is not linear in them: what its acceleration
/// misses is of the order of the difference formula's own error (in walks below 0.04 m/s²), but it adds up to a force that
/// moves nothing. After the correction the ground's impulse over a motion from rest to rest is its weight times its
/// duration, to rounding. Returns the greatest correction (m/s²).
///
/// # Errors
///
/// A root that does not begin with slides along three axes, and what the kernel refuses.
#[doc(alias = "residual reduction")]
pub fn balance_momentum(
    figure: &Figure,
    trajectory: &(impl Trajectory + ?Sized),
    motion: &mut Motion,
) -> Result<f64, ReactionError> {
    motion.check_figure(figure)?;
    let joint = figure.links()[0].joint();
    let slides = joint.kind().axes().iter().take_while(|dof| dof.axis.kind == AxisKind::Translation);
    let axes: Vec<Vector3<f64>> = slides.map(|dof| joint.placement().rotation * dof.axis.direction).collect();
    let no_slides = || ReactionError::NoSlides { joint: joint.name().to_owned() };
    let [x, y, z] = axes[..] else { return Err(no_slides()) };
    if [x.dot(&y), y.dot(&z), z.dot(&x)].iter().any(|cosine| cosine.abs() > 1e-9) {
        return Err(no_slides());
    }
    let first = figure.layout().joints()[0].v;
    let tree = Tree::<f64>::new(figure, motion.info.gravity)?;
    let mut workspace = Workspace::new(&tree);
    let step = DifferenceStep::new(trajectory.resolution(), motion.info.rate);
    let (mut q, mut tau) = (vec![0.0; tree.nq()], vec![0.0; tree.nv()]);
    let mut com = vec![Vector3::zeros(); step.rows(motion.len())];
    for (row, com) in com.iter_mut().enumerate().filter(|(row, _)| step.asks_for(*row)) {
        // What lies at a sample is known.
        let at = if let Some(sample) = step.sample(row).filter(|sample| *sample < motion.len()) {
            motion.q(sample)
        } else {
            trajectory.configuration(step.time(row), &mut q);
            &q
        };
        *com = center_of_mass(&tree, &mut workspace, at)?;
    }
    let (mut a, mut greatest) = (Vec::with_capacity(motion.len() * tree.nv()), 0.0_f64);
    for sample in 0..motion.len() {
        let wanted = Vector3::from([0, 1, 2].map(|axis| step.second(|k| com[step.row(sample, k)][axis])));
        inverse_dynamics(
            &tree,
            &mut workspace,
            motion.q(sample),
            motion.v(sample),
            motion.a(sample),
            &[],
            &mut tau,
        )?;
        let found = workspace.base_wrench().force / tree.mass() + motion.info.gravity;
        let missing = wanted - found;
        greatest = greatest.max(missing.norm());
        a.extend_from_slice(motion.a(sample));
        let row = a.len() - tree.nv() + first;
        for (k, axis) in [x, y, z].iter().enumerate() {
            a[row + k] += axis.dot(&missing);
        }
    }
    motion.set_a(a)?;
    Ok(greatest)
}
