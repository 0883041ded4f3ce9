//! The Denavit-Hartenberg frames of a figure, derived from its axes.

use super::step::{Line, Step, distance};
use super::{Base, Carried, DenavitHartenberg, Rationalized};
use crate::error::DynamicsError;
use nalgebra::{IsometryMatrix3, Matrix3, Rotation3, Translation3, Vector3};
use solaris_model::{AxisKind, Figure, JointKind, Link};

/// One degree of freedom as the figure has it: `place` leads from what the one before moves to what this one moves, at zero.
struct Dof {
    parent: Option<usize>,
    joint: usize,
    coordinate: Option<usize>,
    axis: Vector3<f64>,
    slides: bool,
    place: IsometryMatrix3<f64>,
    /// The first of a ball or free joint has its state.
    state: Option<State>,
    children: Vec<usize>,
}

/// A frame that is found, with what the degree of freedom moves standing in it at zero.
#[derive(Clone, Copy)]
struct Stand {
    moved: IsometryMatrix3<f64>,
    /// Columns: the frame's axes in the world, at zero.
    frame: Matrix3<f64>,
    scale: f64,
}

pub(super) fn derive(figure: &Figure) -> Result<DenavitHartenberg, DynamicsError> {
    let (dofs, riders) = dofs(figure)?;
    let world = Stand { moved: IsometryMatrix3::identity(), frame: Matrix3::identity(), scale: 0.0 };
    let mut stands: Vec<Stand> = Vec::with_capacity(dofs.len());
    let mut links: Vec<Rationalized> = Vec::with_capacity(dofs.len());
    // Which child's axis the frame's z was laid on.
    let mut heirs: Vec<Option<usize>> = Vec::with_capacity(dofs.len());
    for (k, dof) in dofs.iter().enumerate() {
        let before = dof.parent.map_or(world, |parent| stands[parent]);
        let is_heir = dof.parent.is_some_and(|parent| heirs[parent] == Some(k));
        let (base, at_axis) = base(dof, &before, is_heir);
        let (heir, step) = choose(&dofs, k, &at_axis);
        let link = Rationalized {
            parent: dof.parent,
            joint: dof.joint,
            coordinate: dof.coordinate,
            slides: dof.slides,
            base,
            alpha: step.row.alpha,
            theta: step.row.theta,
            a: step.a,
            s: step.s,
            carried: Vec::new(),
        };
        let a = link.transform(0.0);
        let frame = *(Rotation3::from_matrix_unchecked(at_axis.frame) * a.rotation).matrix();
        stands.push(Stand { moved: orthonormal(&between(&a, &at_axis.moved)), frame, scale: at_axis.scale });
        heirs.push(heir);
        links.push(link);
    }
    let grounded = carry(riders, &stands, &mut links);
    let layout = figure.layout();
    Ok(DenavitHartenberg {
        links,
        grounded,
        nq: layout.nq(),
        q_names: layout.q_names().to_vec(),
        v_names: layout.v_names().to_vec(),
        link_names: figure.links().iter().map(|link| link.name().to_owned()).collect(),
    })
}

/// Hangs the figure's links on the frames that carry them; those that are left do not move.
fn carry(riders: Vec<Rider>, stands: &[Stand], links: &mut [Rationalized]) -> Vec<Carried> {
    let mut grounded = Vec::new();
    for (link, (carrier, place)) in riders.into_iter().enumerate() {
        match carrier {
            Some(k) => {
                let placement = stands[k].moved * place;
                links[k].carried.push(Carried { link, placement });
            }
            None => grounded.push(Carried { link, placement: place }),
        }
    }
    grounded
}

/// What stands between the frame before and the axis of `dof`, and the stand of what it moves in the frame at the axis.
fn base(dof: &Dof, before: &Stand, is_heir: bool) -> (Base, Stand) {
    let place = before.moved * dof.place;
    let apart = distance(&dof.place.translation.vector);
    let scale = match dof.parent {
        None => 0.0,
        Some(_) if apart > 0.0 => apart,
        Some(_) => before.scale,
    };
    let stand = |moved, turn: Rotation3<f64>| Stand { moved, frame: before.frame * turn.matrix(), scale };
    // Turned into the frame at the joint's centre: its translation is zero, without rounding.
    let centred = |turn: &Rotation3<f64>| {
        IsometryMatrix3::from_parts(Translation3::identity(), turn.inverse() * place.rotation)
    };
    if let Some((quaternion, position)) = dof.state {
        let own = Line { point: Vector3::zeros(), axis: dof.axis, slides: dof.slides, scale };
        let after = own.base(&(before.frame * place.rotation.matrix()));
        let moved = IsometryMatrix3::from_parts(Translation3::identity(), after.rotation.inverse());
        let base = Base::Moved { before: place, quaternion, position, after };
        return (base, stand(moved, place.rotation * after.rotation));
    }
    let line =
        Line { point: place.translation.vector, axis: place.rotation * dof.axis, slides: dof.slides, scale };
    // The origin of the world stays the origin only where the root has its centre there: a figure far away from it is
    // described from its own root.
    let stays = dof.parent.is_some() || line.point == Vector3::zeros();
    if is_heir || (stays && line.is_z()) {
        return (Base::Identity, stand(place, Rotation3::identity()));
    }
    let base = line.base(&before.frame);
    (Base::Constant(base), stand(centred(&base.rotation), base.rotation))
}

/// The frame behind degree of freedom `k`: z along the axis of that child which leaves the fewest of the others without.
fn choose(dofs: &[Dof], k: usize, at_axis: &Stand) -> (Option<usize>, Step) {
    let seen = |child: &usize| {
        let dof = &dofs[*child];
        let place = at_axis.moved * dof.place;
        let apart = distance(&dof.place.translation.vector);
        let scale = if apart > 0.0 { apart } else { at_axis.scale };
        Line { point: place.translation.vector, axis: place.rotation * dof.axis, slides: dof.slides, scale }
    };
    let lines: Vec<(usize, Line)> = dofs[k]
        .children
        .iter()
        .filter(|child| dofs[**child].state.is_none())
        .map(|child| (*child, seen(child)))
        .collect();
    let mut best: Option<(usize, usize, Step)> = None;
    for (child, line) in &lines {
        let Some(step) = line.step(&at_axis.frame) else { continue };
        let served = lines.iter().filter(|(_, other)| line.serves(other)).count();
        if best.as_ref().is_none_or(|(most, ..)| served > *most) {
            best = Some((served, *child, step));
        }
    }
    if let Some((_, child, step)) = best {
        return (Some(child), step);
    }
    let own = Line {
        point: at_axis.moved.translation.vector,
        axis: Vector3::z(),
        slides: dofs[k].slides,
        scale: at_axis.scale,
    };
    (None, own.last(&at_axis.frame))
}

/// `a⁻¹·b`, with the difference of the origins taken before it is turned.
fn between(a: &IsometryMatrix3<f64>, b: &IsometryMatrix3<f64>) -> IsometryMatrix3<f64> {
    let apart = b.translation.vector - a.translation.vector;
    let turn = a.rotation.inverse();
    IsometryMatrix3::from_parts(Translation3::from(turn * apart), turn * b.rotation)
}

/// One step of `R ← R·(3 − Rᵀ·R)/2`, which leaves an exact rotation as it is.
fn orthonormal(x: &IsometryMatrix3<f64>) -> IsometryMatrix3<f64> {
    let r = x.rotation.matrix();
    let r = r * (Matrix3::identity() * 3.0 - r.transpose() * r) * 0.5;
    IsometryMatrix3::from_parts(x.translation, Rotation3::from_matrix_unchecked(r))
}

/// What carries a link: the last degree of freedom before it, and the link's place in what that one moves.
type Rider = (Option<usize>, IsometryMatrix3<f64>);

/// The degrees of freedom in the order of `v`, and what carries every link.
fn dofs(figure: &Figure) -> Result<(Vec<Dof>, Vec<Rider>), DynamicsError> {
    let mut dofs: Vec<Dof> = Vec::with_capacity(figure.layout().nv());
    let mut riders: Vec<Rider> = Vec::with_capacity(figure.links().len());
    for (i, (link, joint)) in figure.links().iter().zip(figure.layout().joints()).enumerate() {
        let (mut carrier, mut place) =
            link.parent().map_or((None, IsometryMatrix3::identity()), |parent| riders[parent]);
        place *= placement(link);
        let (axes, state) = axes(link, joint.q)?;
        for (j, (kind, axis)) in axes.into_iter().enumerate() {
            let k = dofs.len();
            if let Some(parent) = carrier {
                dofs[parent].children.push(k);
            }
            dofs.push(Dof {
                parent: carrier,
                joint: i,
                coordinate: state.is_none().then_some(joint.q + j),
                axis,
                slides: kind == AxisKind::Translation,
                place,
                state: state.filter(|_| j == 0),
                children: Vec::new(),
            });
            (carrier, place) = (Some(k), IsometryMatrix3::identity());
        }
        riders.push((carrier, place));
    }
    Ok((dofs, riders))
}

fn placement(link: &Link) -> IsometryMatrix3<f64> {
    let placement = link.joint().placement();
    let mut rotation = placement.rotation;
    rotation.renormalize();
    IsometryMatrix3::from_parts(placement.translation, rotation.to_rotation_matrix())
}

type Axes = Vec<(AxisKind, Vector3<f64>)>;

/// Where in `q` the quaternion of a ball or free joint and the position of a free joint are.
type State = (usize, Option<usize>);

/// The axes of a joint whose coordinates begin at `q`, and of a ball or free joint where its state is.
fn axes(link: &Link, q: usize) -> Result<(Axes, Option<State>), DynamicsError> {
    let three = |kind| [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| (kind, axis));
    let (turns, slides) = (three(AxisKind::Rotation), three(AxisKind::Translation));
    match link.joint().kind() {
        JointKind::Axes(dofs) => {
            Ok((dofs.iter().map(|dof| (dof.axis.kind, dof.axis.direction)).collect(), None))
        }
        JointKind::Ball { .. } => Ok((turns.to_vec(), Some((q, None)))),
        JointKind::Free { .. } => Ok(([slides, turns].concat(), Some((q + 3, Some(q))))),
        _ => Err(DynamicsError::Joint { joint: link.joint().name().to_owned() }),
    }
}
