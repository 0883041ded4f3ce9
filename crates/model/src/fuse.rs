//! Fused figures, in which some degrees of freedom are locked: smaller, for a motion in which they stand still.

mod assemble;
pub(crate) mod carried;
mod error;
mod joint;

pub(crate) use assemble::{name_dofs, with_links};
pub use carried::LinkPlace;
pub use error::FuseError;

use crate::figure::Figure;
use solaris_text::nearest;

/// A figure in which some degrees of freedom stand still for good, with the maps between it and the full figure.
///
/// The thesis freezes a degree of freedom by prescribing no motion for it; here it leaves the figure. A link whose joint
/// has no degree of freedom left becomes part of the link that carries it: masses add up, and with `d` the way from the
/// one centre of mass to the other,
///
/// ```text
/// m = m₁ + m₂      c = (m₁·c₁ + m₂·c₂) / m      I = I₁ + R·I₂·Rᵀ + (m₁·m₂/m)·(d·d 1 − d·dᵀ)
/// ```
///
/// Its named frames, its tip and the points of its sole move along, and its own frame stays as a named frame with the
/// link's name, unless a frame has that name already. The carrying link keeps its own shape and tip; where it has none it
/// takes the first that it is given, and any further tip stays as a frame `LINK.tip`.
///
/// Of a joint that keeps some of its axes, a turn `C` that stands still passes to the left of those before it,
///
/// ```text
/// E(e, q)·C = C·E(Cᵀ·e, q)
/// ```
///
/// so that the link keeps its frame; only the axes change. A slide that stands still away from zero displaces the axes of
/// the turns before it: where turns follow, the joint is split, with a link without mass between (`shank~1`, moved by
/// `knee~1`); where none follow, the link's origin moves, and [`links`](Self::links) says how far. Degrees of freedom
/// keep their full names throughout, so that columns mean the same in both figures.
///
/// States: `q`, `v`, `a` of the small figure are those of the full one without the entries that stand still; these have
/// the fused value, zero and zero. Forces: with the fused degrees of freedom at rest, `tau` of the small figure is that
/// of the full one without the fused entries. Wrenches in world axes keep their numbers; only the index of their link
/// changes.
#[doc(alias = "buildReducedModel")]
#[doc(alias = "reduced model")]
#[derive(Clone, Debug)]
pub struct Fused {
    figure: Figure,
    links: Vec<LinkPlace>,
    kept_q: Vec<usize>,
    kept_v: Vec<usize>,
    dofs: Vec<Option<usize>>,
    rest: Vec<f64>,
}

impl Figure {
    /// The figure with degrees of freedom fused: pairs of an index in `v` and the value of its coordinate (rad or m).
    ///
    /// Limits are not looked at. For ball and free joints use [`fuse_at`](Self::fuse_at).
    ///
    /// # Errors
    ///
    /// [`FuseError`] for an index that does not exist or is named twice, one of a ball or free joint, and a value that is
    /// not finite.
    ///
    /// # Examples
    ///
    /// ```
    /// let ann = solaris_model::human(1.65, 58.0)?;
    /// let elbow = ann.layout().dof_index("left_elbow.rx").expect("a dof of the human");
    /// let fused = ann.fuse(&[(elbow, -0.5)])?;
    /// assert_eq!(fused.figure().layout().nv(), 65);
    /// assert_eq!(fused.figure().layout().v_names()[elbow], ann.layout().v_names()[elbow + 1]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "buildReducedModel")]
    #[doc(alias = "lock joints")]
    #[doc(alias = "weld")]
    #[doc(alias = "reduced model")]
    pub fn fuse(&self, dofs: &[(usize, f64)]) -> Result<Fused, FuseError> {
        let mut held = vec![None; self.layout.nq()];
        for &(dof, value) in dofs {
            let name = self.dof_name(dof)?;
            let Some(coordinate) = self.layout.coordinate(dof) else {
                return Err(FuseError::NoCoordinate { joint: self.joint_of(dof).to_owned(), dof: name });
            };
            if !value.is_finite() {
                return Err(FuseError::NotFinite { name, value });
            }
            if held[coordinate].replace(value).is_some() {
                return Err(FuseError::Twice { dof: name });
            }
        }
        self.hold_followers(&mut held)?;
        Ok(assemble::assemble(self, &held))
    }

    /// The figure with degrees of freedom fused, by name: see [`fuse`](Self::fuse).
    ///
    /// # Errors
    ///
    /// As for [`fuse`](Self::fuse); a name that is none comes with the nearest that is one.
    ///
    /// # Examples
    ///
    /// ```
    /// # let ann = solaris_model::human(1.65, 58.0)?;
    /// let error = ann.fuse_named(&[("left_elbow.rq", 0.0)]).unwrap_err();
    /// assert!(error.to_string().contains("did you mean 'left_elbow.rx'?"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "lock joints")]
    pub fn fuse_named(&self, dofs: &[(&str, f64)]) -> Result<Fused, FuseError> {
        let mut indices = Vec::with_capacity(dofs.len());
        for &(name, value) in dofs {
            let Some(dof) = self.layout.dof_index(name) else {
                let nearest = nearest(name, self.layout.v_names().iter().map(String::as_str));
                return Err(FuseError::UnknownDof { name: name.to_owned(), nearest });
            };
            indices.push((dof, value));
        }
        self.fuse(&indices)
    }

    /// The figure with degrees of freedom, named by their indices in `v`, fused where they stand in the configuration `q`
    /// (length `nq`).
    ///
    /// A ball or free joint can be fused only as a whole, with all of its degrees of freedom; its quaternion may have any
    /// length but zero.
    ///
    /// # Errors
    ///
    /// [`FuseError`] for a `q` of the wrong length, an index that does not exist or is named twice, part of a ball or free
    /// joint, and a coordinate to be fused that is not finite.
    #[doc(alias = "lock joints")]
    pub fn fuse_at(&self, dofs: &[usize], q: &[f64]) -> Result<Fused, FuseError> {
        error::check_length("q", q.len(), self.layout.nq())?;
        let mut still = vec![false; self.layout.nv()];
        for &dof in dofs {
            let dof_name = self.dof_name(dof)?;
            if std::mem::replace(&mut still[dof], true) {
                return Err(FuseError::Twice { dof: dof_name });
            }
        }
        let mut held = vec![None; self.layout.nq()];
        for (link, at) in self.links.iter().zip(self.layout.joints()) {
            let still = &still[at.v..at.v + at.nv];
            let Some(quaternion) = link.joint.kind().quaternion() else {
                for (i, _) in still.iter().enumerate().filter(|(_, still)| **still) {
                    held[at.q + i] = Some(q[at.q + i]);
                }
                continue;
            };
            let count = still.iter().filter(|still| **still).count();
            if count == 0 {
                continue;
            }
            if count < at.nv {
                let joint = link.joint.name().to_owned();
                return Err(FuseError::PartOfJoint { joint, count, all: at.nv });
            }
            let values = &q[at.q..at.q + at.nq];
            let length = values[quaternion..].iter().map(|x| x * x).sum::<f64>().sqrt();
            // An entry that is not finite has its own message below.
            if length < 1e-9 {
                return Err(FuseError::NoRotation { joint: link.joint.name().to_owned(), length });
            }
            for (i, value) in values.iter().enumerate() {
                held[at.q + i] = Some(if i < quaternion { *value } else { value / length });
            }
        }
        let bad = (0..q.len()).find(|&i| held[i].is_some() && !q[i].is_finite());
        if let Some(bad) = bad {
            return Err(FuseError::NotFinite { name: self.layout.q_names()[bad].clone(), value: q[bad] });
        }
        self.hold_followers(&mut held)?;
        Ok(assemble::assemble(self, &held))
    }

    /// What follows a held degree of freedom is held where that one puts it; a follower cannot be held alone.
    fn hold_followers(&self, held: &mut [Option<f64>]) -> Result<(), FuseError> {
        for follower in &self.followers {
            let leader = held[follower.leader_coordinate];
            if leader.is_none() && held[follower.coordinate].is_some() {
                let [dof, leader] =
                    [follower.dof, follower.leader].map(|dof| self.layout.v_names()[dof].clone());
                return Err(FuseError::Follower { dof, leader });
            }
            held[follower.coordinate] = leader.map(|leader| follower.curve.at(leader)[0]);
        }
        Ok(())
    }

    fn dof_name(&self, dof: usize) -> Result<String, FuseError> {
        let names = self.layout.v_names();
        names.get(dof).cloned().ok_or(FuseError::NoSuchDof { dof, count: names.len() })
    }

    fn joint_of(&self, dof: usize) -> &str {
        let joints = self.layout.joints();
        let link = joints.iter().position(|at| (at.v..at.v + at.nv).contains(&dof)).unwrap_or_default();
        self.links[link].joint.name()
    }
}

impl Fused {
    /// The small figure.
    pub fn figure(&self) -> &Figure {
        &self.figure
    }

    /// For each link of the full figure, the link of the small one that carries it, and where its frame stands there.
    pub fn links(&self) -> &[LinkPlace] {
        &self.links
    }

    /// Index in the small figure's `v` of the full figure's degree of freedom `dof`; `None` where it is fused.
    ///
    /// # Panics
    ///
    /// Where the full figure has no such degree of freedom.
    pub fn dof(&self, dof: usize) -> Option<usize> {
        self.dofs[dof]
    }

    /// For each entry of the small figure's `q`, its index in the full figure's; increasing.
    pub fn kept_q(&self) -> &[usize] {
        &self.kept_q
    }

    /// For each entry of the small figure's `v`, `a` and `tau`, its index in the full figure's; increasing.
    pub fn kept_v(&self) -> &[usize] {
        &self.kept_v
    }

    /// The full figure's `q` with the fused values in place, and the others zero or without a turn.
    pub fn rest(&self) -> &[f64] {
        &self.rest
    }

    /// Length of the full figure's `q`.
    pub fn full_nq(&self) -> usize {
        self.rest.len()
    }

    /// Length of the full figure's `v`, `a` and `tau`.
    pub fn full_nv(&self) -> usize {
        self.dofs.len()
    }

    /// Writes the small figure's `q` from the full one's, whose fused entries are not looked at.
    ///
    /// # Errors
    ///
    /// [`FuseError::Length`].
    pub fn q_to_small(&self, full: &[f64], small: &mut [f64]) -> Result<(), FuseError> {
        select("q", full, self.full_nq(), &self.kept_q, small)
    }

    /// Writes the full figure's `q` from the small one's; the fused entries get their values.
    ///
    /// # Errors
    ///
    /// [`FuseError::Length`].
    pub fn q_to_full(&self, small: &[f64], full: &mut [f64]) -> Result<(), FuseError> {
        error::check_length("the full figure's q", full.len(), self.full_nq())?;
        full.copy_from_slice(&self.rest);
        scatter("q", small, &self.kept_q, full)
    }

    /// Writes the small figure's `v`, `a` or `tau` from the full one's, whose fused entries are not looked at.
    ///
    /// # Errors
    ///
    /// [`FuseError::Length`].
    pub fn v_to_small(&self, full: &[f64], small: &mut [f64]) -> Result<(), FuseError> {
        select("v", full, self.full_nv(), &self.kept_v, small)
    }

    /// Writes the full figure's `v` or `a` from the small one's; the fused entries get zero.
    ///
    /// A `tau` has other numbers there: the dynamics of the full figure tells them.
    ///
    /// # Errors
    ///
    /// [`FuseError::Length`].
    pub fn v_to_full(&self, small: &[f64], full: &mut [f64]) -> Result<(), FuseError> {
        error::check_length("the full figure's v", full.len(), self.full_nv())?;
        full.fill(0.0);
        scatter("v", small, &self.kept_v, full)
    }
}

fn select(
    what: &'static str,
    full: &[f64],
    full_length: usize,
    kept: &[usize],
    small: &mut [f64],
) -> Result<(), FuseError> {
    error::check_length(what, full.len(), full_length)?;
    error::check_length(what, small.len(), kept.len())?;
    for (entry, &index) in small.iter_mut().zip(kept) {
        *entry = full[index];
    }
    Ok(())
}

fn scatter(what: &'static str, small: &[f64], kept: &[usize], full: &mut [f64]) -> Result<(), FuseError> {
    error::check_length(what, small.len(), kept.len())?;
    for (entry, &index) in small.iter().zip(kept) {
        full[index] = *entry;
    }
    Ok(())
}
