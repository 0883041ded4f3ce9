//! What was left out, and what that saves.

use super::Role;
use super::reduction::{Reduction, Source};
use crate::element::LimitLaw;
use crate::report::PhaseReport;
use nalgebra::Vector3;
use solaris_dynamics::scalar::{Counted, Operations};
use solaris_dynamics::{DynamicsError, Tree, Workspace, Wrench, hybrid_dynamics, velocities};
use solaris_model::{Figure, Link};

/// What is left for these roles, and what it takes to evaluate it; `standing` is the full `q`.
///
/// The cost is that of the recursions. What springs and dampers themselves take is left out of the count: it is the same on
/// both sides, but for those that were dropped.
pub(super) fn report(
    source: &Source,
    roles: &[Role],
    standing: &[f64],
    reduction: Option<&Reduction>,
) -> PhaseReport {
    let names = |dofs: &mut dyn Iterator<Item = usize>| -> Vec<String> {
        dofs.map(|dof| source.figure.layout().v_names()[dof].clone()).collect()
    };
    let is_dynamic = |dof: &usize| roles[*dof] == Role::Dynamic;
    let full = cost(source, &source.figure, source.springs.len(), roles, standing);
    let mut report = PhaseReport {
        dynamic: names(&mut (0..roles.len()).filter(is_dynamic)),
        cost: (full, Operations::default()),
        omitted: vec!["contact: the scene has no ground".to_owned()],
        ..PhaseReport::default()
    };
    let Some(reduction) = reduction else {
        report.dropped = source.figure.links().iter().map(|link| link.name().to_owned()).collect();
        report.omitted.push("dynamics: they move nothing".to_owned());
        return report;
    };
    let small_roles: Vec<Role> = reduction.kept_v.iter().map(|dof| roles[*dof]).collect();
    let small_q: Vec<f64> = reduction.kept_q.iter().map(|index| standing[*index]).collect();
    report.prescribed = names(&mut reduction.kept_v.iter().copied().filter(|dof| !is_dynamic(dof)));
    report.fused = names(&mut reduction.fused.iter().copied());
    report.dropped =
        reduction.dropped.iter().map(|link| source.figure.links()[*link].name().to_owned()).collect();
    report.cost.1 = if reduction.dropped.is_empty() && reduction.fused.is_empty() {
        full
    } else {
        cost(source, &reduction.figure, reduction.springs.len(), &small_roles, &small_q)
    };
    report.omitted.extend(omitted(source, reduction));
    report
}

/// Operations of all kinds.
pub(super) fn total(cost: &Operations) -> u64 {
    let Operations { multiplications, additions, divisions, sines, .. } = *cost;
    multiplications + additions + divisions + sines
}

/// What else was left out.
fn omitted(source: &Source, Reduction { figure, springs, limits, .. }: &Reduction) -> Vec<String> {
    let mut omitted = Vec::new();
    if springs.is_empty() {
        omitted.push("velocities of links: no spring between points asks for them".to_owned());
    }
    if springs.len() < source.springs.len() {
        let (left, all) = (source.springs.len() - springs.len(), source.springs.len());
        omitted.push(format!(
            "springs between points: {left} of {all} do not act on anything that dynamics move"
        ));
    }
    let acts = |link: &Link| (0..link.joint().kind().nv()).any(|i| !link.joint().kind().passive(i).is_none());
    if !figure.links().iter().any(acts) {
        omitted.push("springs, dampers and friction in joints: there are none".to_owned());
    }
    if !limits.iter().any(|law| matches!(law, LimitLaw::Spring { .. })) {
        omitted.push("limits that push back: there are none".to_owned());
    }
    omitted
}

/// Operations of one evaluation of hybrid dynamics of `figure` with so many springs between points.
fn cost(source: &Source, figure: &Figure, springs: usize, roles: &[Role], q: &[f64]) -> Operations {
    // A figure or a state that the dynamics refuse will be refused where it counts; here it costs what it cost until then.
    Counted::measure(|| evaluate(source, figure, springs, roles, q).ok()).1
}

fn evaluate(
    source: &Source,
    figure: &Figure,
    springs: usize,
    roles: &[Role],
    q: &[f64],
) -> Result<(), DynamicsError> {
    let tree = Tree::<Counted>::new(figure, source.gravity)?;
    let mut workspace = Workspace::new(&tree);
    let q: Vec<Counted> = q.iter().map(|x| Counted::new(*x)).collect();
    let prescribed: Vec<bool> = roles.iter().map(|role| *role != Role::Dynamic).collect();
    let zeros = vec![Counted::default(); roles.len()];
    let (v, mut a, mut tau) = (zeros.clone(), zeros.clone(), zeros);
    let none = Wrench { force: Vector3::zeros(), moment: Vector3::zeros() };
    let external = vec![(0, none); 2 * springs];
    let mut evaluate = || {
        if springs > 0 {
            velocities(&tree, &mut workspace, &q, &v)?;
        }
        hybrid_dynamics(&tree, &mut workspace, &q, &v, &prescribed, &external, &mut a, &mut tau)
    };
    evaluate()
}
