//! The report on what was left out, and what that saves.

use super::Role;
use super::reduction::{Reduction, Source};
use crate::contact::count;
use crate::element::LimitLaw;
use crate::report::PhaseReport;
use nalgebra::Vector3;
use solaris_dynamics::scalar::{Counted, Operations};
use solaris_dynamics::{DynamicsError, Tree, Workspace, Wrench, hybrid_dynamics, velocities};
use solaris_model::{Figure, Link};

/// What is left for these roles, and what it takes to evaluate it; `standing` is the full `q`.
///
/// The cost is that of the recursions, with all spheres on the ground that can touch it. What springs and dampers themselves take is left out of the count: it is the same on
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
    let all_touches = count(source.surface.as_ref());
    let full = cost(source, &source.figure, (source.springs.len(), all_touches), roles, standing);
    let mut report = PhaseReport {
        dynamic: names(&mut (0..roles.len()).filter(is_dynamic)),
        operations_of_all: full,
        omitted: Vec::new(),
        ..PhaseReport::default()
    };
    let left = reduction.map_or(0, |reduction| count(reduction.surface.as_ref()));
    report.omitted.extend(contact(source.surface.is_some(), left, all_touches));
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
    report.operations = if reduction.dropped.is_empty() && reduction.fused.is_empty() {
        full
    } else {
        cost(source, &reduction.figure, (reduction.springs.len(), left), &small_roles, &small_q)
    };
    report.omitted.extend(omitted(source, reduction));
    report
}

/// What was left out of the ground, if anything: `left` of `all` spheres can touch it.
fn contact(is_there: bool, left: usize, all: usize) -> Option<String> {
    if !is_there {
        return Some("contact: there is no ground".to_owned());
    }
    let without = all - left;
    (without > 0).then(|| {
        format!(
            "contact: {without} of {all} spheres that can touch the ground are on nothing that dynamics move"
        )
    })
}

/// What else was left out.
fn omitted(
    source: &Source,
    Reduction { figure, springs, limits, surface, pushes, .. }: &Reduction,
) -> Vec<String> {
    let mut omitted = Vec::new();
    if springs.is_empty() && surface.is_none() && pushes.is_empty() {
        let who = if source.surface.is_some() { "and no ground asks" } else { "asks" };
        omitted.push(format!("velocities of links: no spring between points {who} for them"));
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

/// Operations of one evaluation of hybrid dynamics of `figure` with so many springs between points, and spheres on the ground.
fn cost(source: &Source, figure: &Figure, acting: (usize, usize), roles: &[Role], q: &[f64]) -> Operations {
    // A figure or a state that the dynamics refuse will be refused where it counts; here it costs what it cost until then.
    Counted::measure(|| evaluate(source, figure, acting, roles, q).ok()).1
}

fn evaluate(
    source: &Source,
    figure: &Figure,
    (springs, contact_points): (usize, usize),
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
    let external = vec![(0, none); 2 * springs + contact_points];
    let mut evaluate = || {
        if springs + contact_points > 0 {
            velocities(&tree, &mut workspace, &q, &v)?;
        }
        hybrid_dynamics(&tree, &mut workspace, &q, &v, &prescribed, &external, &mut a, &mut tau)
    };
    evaluate()
}
