//! Joint forces of a figure whose loops are closed.

use nalgebra::{DMatrix, DVector, Vector3};
use solaris_dynamics::{DynamicsError, Frame, JacobianAxes, Tree, Workspace, inverse_dynamics, jacobian};
use solaris_model::{Figure, Tie, TieLaw};

/// Joint forces with loops closed.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedForces {
    /// The forces of the drives (length `nv`; N m or N), zero where nothing drives.
    pub tau: Vec<f64>,
    /// Of each tie, the force (N) on its first end and the moment (N m) about it, along the world's axes; the second end has the opposite.
    pub held: Vec<[Vector3<f64>; 2]>,
}

/// Why there are no joint forces with loops closed.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ClosedError {
    /// What the kernel refuses.
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
    /// A list of another length than the velocities.
    #[error("{found} flags say what is driven; the figure has {expected} velocities")]
    Driven {
        /// Flags that were given.
        found: usize,
        /// Velocities of the figure.
        expected: usize,
    },
    /// A tie to a link that there is not.
    #[error("the tie '{tie}' holds a link '{link}', which the figure does not have")]
    UnknownLink {
        /// What the tie is called.
        tie: String,
        /// The link.
        link: String,
    },
    /// A tie that holds no points.
    #[error("the tie '{tie}' is {what}, not two points that are held together: leave it out")]
    NotPoints {
        /// What the tie is called.
        tie: String,
        /// What it is.
        what: String,
    },
    /// A motion that pulls a loop open.
    #[error("the ends of '{tie}' move apart at {speed:.1e} m/s: give a motion that keeps them together")]
    Opens {
        /// What the tie is called.
        tie: String,
        /// How fast (m/s, rad/s).
        speed: f64,
    },
    /// A motion for which too little is driven.
    #[error(
        "the motion needs {force:.1e} N m or N at '{dof}', which nothing drives: drive it, or another that moves the same loop"
    )]
    Undriven {
        /// The degree of freedom.
        dof: String,
        /// What it needs.
        force: f64,
    },
}

/// How fast the ends of a tie may move apart, beside the greatest speed of a degree of freedom.
const OPENS: f64 = 1e-6;
/// What may be left of forces where nothing drives, and singular values that count as zero, beside the greatest.
const ROUNDING: f64 = 1e-9;

/// The joint forces that a motion needs at `q`, `v`, `a` (of the tree, loops kept) where `ties` close loops and only what is `driven` bears
/// a force: by the inverse dynamics of the open tree, and the forces in the loops that take away what nothing drives.
///
/// ```text
/// τ = τ₀ − Jᵀ·λ        τ = 0 where nothing drives        |τ|² least where that leaves a choice
/// ```
///
/// with `J` how fast the first end of each tie moves away from the second. How joints share what the loops leave open is no fact of mechanics: with more
/// drives than the mechanism has freedoms, any share moves it alike. This is the one with the least sum of squares (N m and N as they are); of forces in loops
/// that no `τ` tells apart, such as those across a plane linkage, those with the least sum of squares. Each call allocates.
///
/// # Errors
///
/// [`ClosedError`]: links, lengths, motions that open a loop, and too few drives.
pub fn closed_forces(
    figure: &Figure,
    gravity: Vector3<f64>,
    ties: &[Tie],
    driven: &[bool],
    [q, v, a]: [&[f64]; 3],
) -> Result<ClosedForces, ClosedError> {
    let nv = figure.layout().nv();
    if driven.len() != nv {
        return Err(ClosedError::Driven { found: driven.len(), expected: nv });
    }
    let tree = Tree::<f64>::new(figure, gravity)?;
    let mut workspace = Workspace::new(&tree);
    let mut free = vec![0.0; nv];
    inverse_dynamics(&tree, &mut workspace, q, v, a, &[], &mut free)?;
    let (j, rows) = conditions(figure, &tree, &mut workspace, ties, q)?;
    let speeds = &j * DVector::from_column_slice(v);
    let fastest = v.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (tie, rows) in ties.iter().zip(&rows) {
        let speed = speeds.rows(rows.start, rows.len()).norm();
        if speed > OPENS * fastest {
            return Err(ClosedError::Opens { tie: tie.name.clone(), speed });
        }
    }
    let part = |is_driven: bool| {
        let of: Vec<usize> = (0..nv).filter(|dof| driven[*dof] == is_driven).collect();
        (j.select_columns(&of).transpose(), DVector::from_iterator(of.len(), of.iter().map(|dof| free[*dof])))
    };
    let ((idle, needed), (moved, wanted)) = (part(false), part(true));
    let first = least_squares(&idle, &needed);
    let choice = null_space(&idle);
    let lambda = &first + &choice * least_squares(&(&moved * &choice), &(wanted - &moved * &first));
    let loops = j.tr_mul(&lambda);
    let scale = free.iter().chain(loops.iter()).fold(0.0_f64, |most, x| most.max(x.abs()));
    let mut tau: Vec<f64> = free.iter().zip(loops.iter()).map(|(free, held)| free - held).collect();
    for (dof, tau) in tau.iter_mut().enumerate().filter(|(dof, _)| !driven[*dof]) {
        if tau.abs() > ROUNDING.sqrt() * scale {
            return Err(ClosedError::Undriven { dof: figure.layout().v_names()[dof].clone(), force: *tau });
        }
        *tau = 0.0;
    }
    let vector = |from: usize| Vector3::new(lambda[from], lambda[from + 1], lambda[from + 2]);
    let held = rows.iter().map(|rows| {
        [vector(rows.start), if rows.len() > 3 { vector(rows.start + 3) } else { Vector3::zeros() }]
    });
    Ok(ClosedForces { tau, held: held.collect() })
}

/// How fast first ends move away from second ones, and which rows are whose.
fn conditions(
    figure: &Figure,
    tree: &Tree<f64>,
    workspace: &mut Workspace<f64>,
    ties: &[Tie],
    q: &[f64],
) -> Result<(DMatrix<f64>, Vec<std::ops::Range<usize>>), ClosedError> {
    let nv = figure.layout().nv();
    let (mut rows, mut count) = (Vec::new(), 0);
    for tie in ties {
        let own = match &tie.law {
            TieLaw::Points => 3,
            TieLaw::Axes => 6,
            TieLaw::Other(what) => {
                return Err(ClosedError::NotPoints { tie: tie.name.clone(), what: what.clone() });
            }
            _ => return Err(ClosedError::NotPoints { tie: tie.name.clone(), what: "unknown".to_owned() }),
        };
        rows.push(count..count + own);
        count += own;
    }
    let (mut j, mut one) = (DMatrix::zeros(count, nv), DMatrix::zeros(6, nv));
    for (tie, rows) in ties.iter().zip(&rows) {
        for (end, sign) in tie.between.iter().zip([1.0, -1.0]) {
            let Some(name) = &end.link else { continue };
            let link = figure
                .link_index(name)
                .ok_or_else(|| ClosedError::UnknownLink { tie: tie.name.clone(), link: name.clone() })?;
            let frame = Frame::at(link, end.point);
            jacobian(tree, workspace, q, &frame, JacobianAxes::World, &mut one)?;
            let mut own = j.rows_mut(rows.start, rows.len());
            own += sign * one.rows(0, rows.len());
        }
    }
    Ok((j, rows))
}

/// The shortest of the vectors that bring `a·x` nearest to `b`.
fn least_squares(a: &DMatrix<f64>, b: &DVector<f64>) -> DVector<f64> {
    if a.is_empty() {
        return DVector::zeros(a.ncols());
    }
    let svd = a.clone().svd(true, true);
    let least = ROUNDING * svd.singular_values.max();
    // It is refused without vectors only.
    svd.solve(b, least).unwrap_or_else(|_| DVector::zeros(a.ncols()))
}

/// Columns that span what `a` brings to zero.
fn null_space(a: &DMatrix<f64>) -> DMatrix<f64> {
    let n = a.ncols();
    if a.is_empty() {
        return DMatrix::identity(n, n);
    }
    let eigen = a.tr_mul(a).symmetric_eigen();
    let most = eigen.eigenvalues.max();
    // Squares of singular values.
    let flat: Vec<usize> = (0..n).filter(|i| eigen.eigenvalues[*i] <= ROUNDING * most).collect();
    eigen.eigenvectors.select_columns(&flat)
}
