//! Limbs that hang loose from a figure that moves by itself.

mod loose;
mod pull;

use crate::failure::SetupError;
use crate::range::{check_finite, check_not_negative, check_positive};
use loose::Loose;
use nalgebra::Vector3;
use pull::Pull;
use solaris_dynamics::Wrench;
use solaris_model::{Figure, nearest};
use std::ops::Range;
use std::sync::Arc;

/// The longest step in which a limb is moved (s), and the longest one that may be asked for.
const STEP: f64 = 1.0 / 120.0;
const LONGEST: f64 = 1.0;
/// What of a limb's velocity is lost in a second where nothing else is said (1/s): about what limp tissue takes of a swinging arm.
const DAMPING: f64 = 2.0;
/// The fastest that a degree of freedom gets (rad/s or m/s), and its greatest acceleration (1/s² of these).
const FASTEST: f64 = 20.0;
const HARDEST: f64 = 1500.0;

/// Limbs of a figure that hang loose from the rest of it, which has a motion of its own: an arm, a forearm, a head.
///
/// Everything but what was [loosened](Self::loosen) is prescribed, with positions, velocities and accelerations that the caller gives frame by frame; what is
/// loose swings from it by gravity, inertia, its joints' springs, dampers and friction, a damping of its own, and limits that hold softly: by hybrid
/// dynamics of the whole figure. What limbs do to the rest has no effect, since that is prescribed.
///
/// It is made for frames of a game: steps of 1/120 s at most, by the rule of the midpoint, with dampers and limits implicit, so that nothing
/// that is prescribed makes it grow without bound; no degree of freedom gets faster than 20 rad/s or quicker there than by 1500 rad/s², and none is NaN. Frames do not allocate.
///
/// ```
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
/// use solaris_modes::Hanging;
///
/// let cart = LinkSpec::root("cart", Joint::new("rail").tx()).mass(2.0);
/// let rod = LinkSpec::child("rod", "cart", Joint::new("hinge").rz()).mass(1.0).com(Vector3::new(0.0, -0.5, 0.0));
/// let figure = FigureBuilder::new("crane").link(cart).link(rod).build()?;
/// let mut hanging = Hanging::new(&figure, Vector3::new(0.0, -9.80665, 0.0))?;
/// hanging.loosen("hinge", &[0.0, 0.0], &[0.0, 0.0])?;
/// let (mut q, mut v) = ([0.0, 0.0], [0.0, 0.0]);
/// for _ in 0..30 {
///     // The cart speeds up along x, and the rod stays behind.
///     (q[0], v[0]) = (q[0] + v[0] / 60.0 + 2.0 / 7200.0, v[0] + 2.0 / 60.0);
///     hanging.step(1.0 / 60.0, &mut q, &mut v, &[2.0, 0.0])?;
/// }
/// assert!(q[1] < -0.05);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "ragdoll")]
#[doc(alias = "jiggle")]
#[doc(alias = "secondary motion")]
#[derive(Clone, Debug)]
pub struct Hanging {
    figure: Arc<Figure>,
    pull: Pull,
    damping: f64,
    /// What is loose, in the order of the degrees of freedom.
    loose: Vec<Loose>,
    /// The figure within a frame: configuration, velocities, accelerations, and ways back from the end of the frame.
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    back: Vec<f64>,
}

impl Hanging {
    /// Of a figure of which nothing is loose yet, under a gravity (m/s², world axes).
    ///
    /// # Errors
    ///
    /// A figure or a gravity that the dynamics do not take.
    pub fn new(figure: &Figure, gravity: Vector3<f64>) -> Result<Self, SetupError> {
        let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
        Ok(Self {
            pull: Pull::new(figure, gravity)?,
            figure: Arc::new(figure.clone()),
            damping: DAMPING,
            loose: Vec::with_capacity(nv),
            q: vec![0.0; nq],
            v: vec![0.0; nv],
            a: vec![0.0; nv],
            back: vec![0.0; nv],
        })
    }

    /// How much of a limb's velocity is lost in a second besides what its joints take (1/s): 2 where nothing is said, 0 for none.
    ///
    /// # Errors
    ///
    /// [`SetupError::Range`].
    pub fn set_damping(&mut self, damping: f64) -> Result<(), SetupError> {
        check_not_negative(|| "the damping of what hangs loose".to_owned(), damping)?;
        self.damping = damping;
        Ok(())
    }

    /// From now on a degree of freedom, or all of a joint, is loose, from where it is in a state (`q` of length `nq`, `v` of length `nv`). What is loose
    /// already starts from there anew.
    ///
    /// # Errors
    ///
    /// [`SetupError::UnknownDof`]; [`SetupError::NotLoose`] for a ball or free joint and for what follows another degree of freedom;
    /// [`SetupError::Range`] for a state of another length and numbers that are not finite.
    pub fn loosen(&mut self, name: &str, q: &[f64], v: &[f64]) -> Result<(), SetupError> {
        self.check_state(q, v)?;
        let dofs = self.dofs(name)?;
        for dof in dofs.clone() {
            let Some(coordinate) = self.figure.layout().coordinate(dof).filter(|_| !self.figure.follows(dof))
            else {
                return Err(SetupError::NotLoose { dof: self.figure.layout().v_names()[dof].clone() });
            };
            check_finite(|| format!("the position of '{name}'"), q[coordinate])?;
            check_finite(|| format!("the velocity of '{name}'"), v[dof])?;
        }
        for dof in dofs {
            self.loose.retain(|loose| loose.dof != dof);
            self.loose.extend(Loose::of(&self.figure, dof, q, v, FASTEST));
        }
        self.loose.sort_by_key(|loose| loose.dof);
        self.pull.make_room(self.loose.len());
        Ok(())
    }

    /// From now on a degree of freedom, or all of a joint, is prescribed again. That it does not jump is the caller's.
    ///
    /// # Errors
    ///
    /// [`SetupError::UnknownDof`].
    pub fn tighten(&mut self, name: &str) -> Result<(), SetupError> {
        let dofs = self.dofs(name)?;
        self.loose.retain(|loose| !dofs.contains(&loose.dof));
        Ok(())
    }

    /// From now on a force and a moment about the world's origin push a link (N, N m, world axes), or nothing does; what is loose feels it.
    ///
    /// # Errors
    ///
    /// [`SetupError::Range`] for a link that the figure has not, and numbers that are not finite: what pushed before goes on.
    pub fn push(&mut self, pushed: Option<(usize, Wrench<f64>)>) -> Result<(), SetupError> {
        if let Some((link, wrench)) = &pushed {
            if *link >= self.figure.links().len() {
                let what = "the link that is pushed".to_owned();
                return Err(SetupError::Range { what, value: *link as f64, range: "a link of the figure" });
            }
            for x in wrench.force.iter().chain(&wrench.moment) {
                check_finite(|| "a push on what hangs loose".to_owned(), *x)?;
            }
        }
        self.pull.pushed = pushed;
        Ok(())
    }

    /// What is loose: indices in `v`, rising.
    pub fn loose(&self) -> impl Iterator<Item = usize> + '_ {
        self.loose.iter().map(|loose| loose.dof)
    }

    /// Whether a degree of freedom (index in `v`) is loose.
    pub fn is_loose(&self, dof: usize) -> bool {
        self.loose.iter().any(|loose| loose.dof == dof)
    }

    /// Goes on by a frame of `dt` (s). `q` (length `nq`), `v` and `a` (length `nv`) are what is prescribed at its end; of what is loose nothing is read, and its positions
    /// and velocities are written into `q` and `v`.
    ///
    /// Within the frame what is prescribed is taken to have had this acceleration all along.
    ///
    /// # Errors
    ///
    /// [`SetupError::Range`] for a time that is none or longer than a second, for slices of another length and numbers that are not finite: nothing has changed.
    pub fn step(&mut self, dt: f64, q: &mut [f64], v: &mut [f64], a: &[f64]) -> Result<(), SetupError> {
        check_positive(|| "the frame of what hangs loose".to_owned(), dt)?;
        if dt > LONGEST {
            let what = "the frame of what hangs loose".to_owned();
            return Err(SetupError::Range { what, value: dt, range: "at most 1 s" });
        }
        self.check_state(q, v)?;
        check_length("accelerations", a.len(), v.len())?;
        if self.loose.is_empty() {
            return Ok(());
        }
        for loose in &self.loose {
            // Of these nothing is read.
            (q[loose.coordinate], v[loose.dof]) = (loose.position, loose.velocity);
        }
        for (what, numbers) in [("position", &*q), ("velocity", &*v)] {
            numbers.iter().try_for_each(|x| check_finite(|| format!("a prescribed {what}"), *x))?;
        }
        for (dof, x) in a.iter().enumerate() {
            if !self.is_loose(dof) {
                check_finite(|| "a prescribed acceleration".to_owned(), *x)?;
            }
        }
        let steps = (dt / STEP - 1e-9).ceil().max(1.0);
        let h = dt / steps;
        for step in 0..steps as usize {
            self.substep(h, dt - h * step as f64, (q, v, a));
        }
        for loose in &self.loose {
            (q[loose.coordinate], v[loose.dof]) = (loose.position, loose.velocity);
        }
        Ok(())
    }

    /// On by `h` (s), `left` (s) before the end of the frame, where this is prescribed: by the rule of the midpoint.
    fn substep(&mut self, h: f64, left: f64, end: (&[f64], &[f64], &[f64])) {
        let half = 0.5 * h;
        // To the middle, for the forces there.
        self.place(left, end, (0.0, false));
        let Self { pull, loose, q, v, a, .. } = self;
        pull.solve((q, v, a), loose, self.damping, (half, 1.0));
        self.place(left - half, end, (half, true));
        let Self { pull, loose, q, v, a, .. } = self;
        pull.solve((q, v, a), loose, self.damping, (h, 0.5));
        for (loose, change) in self.loose.iter_mut().zip(self.pull.changes()) {
            loose.go_on(h, *change, h * HARDEST, FASTEST);
        }
    }

    /// The whole figure `left` (s) before the end of a frame, and what is loose a time after where it is, with the change of velocity that was found last or without.
    fn place(&mut self, left: f64, (q, v, a): (&[f64], &[f64], &[f64]), (after, changed): (f64, bool)) {
        for (k, back) in self.back.iter_mut().enumerate() {
            *back = -left * (v[k] - 0.5 * left * a[k]);
            self.v[k] = v[k] - left * a[k];
            self.a[k] = a[k];
        }
        for loose in &self.loose {
            (self.back[loose.dof], self.a[loose.dof]) = (0.0, 0.0);
        }
        // What cannot be gone back by is taken as at the end: the inertia of what hangs hardly feels it.
        if self.figure.integrate(q, &self.back, &mut self.q).is_err() {
            self.q.copy_from_slice(q);
        }
        for (loose, change) in self.loose.iter().zip(self.pull.changes()) {
            let change = if changed { *change } else { 0.0 };
            self.q[loose.coordinate] = loose.position + after * loose.velocity;
            self.v[loose.dof] = (loose.velocity + change).clamp(-FASTEST, FASTEST);
        }
    }

    fn check_state(&self, q: &[f64], v: &[f64]) -> Result<(), SetupError> {
        check_length("positions", q.len(), self.q.len())?;
        check_length("velocities", v.len(), self.v.len())
    }

    /// The degrees of freedom of a name: one, or all of a joint.
    fn dofs(&self, name: &str) -> Result<Range<usize>, SetupError> {
        let layout = self.figure.layout();
        // One degree of freedom answers to its joint's name, too.
        if let Some(joint) = self.figure.joint_index(name) {
            let at = layout.joints()[joint];
            return Ok(at.v..at.v + at.nv);
        }
        layout.dof_index(name).map(|dof| dof..dof + 1).ok_or_else(|| {
            let joints = self.figure.links().iter().map(|link| link.joint().name());
            let nearest = nearest(name, layout.v_names().iter().map(String::as_str).chain(joints));
            SetupError::UnknownDof { figure: self.figure.name().to_owned(), name: name.to_owned(), nearest }
        })
    }
}

fn check_length(what: &'static str, given: usize, wanted: usize) -> Result<(), SetupError> {
    if given == wanted {
        return Ok(());
    }
    let what = format!("the number of {what} of what hangs loose, of {wanted},");
    Err(SetupError::Range { what, value: given as f64, range: "as many as the figure has" })
}
