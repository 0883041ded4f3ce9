//! One degree of freedom that hangs loose.

use solaris_model::{Figure, Limits, Passive};

/// How quickly a limit pushes back (1/s), with as much damping as keeps it from bouncing, and how far it gives way at most (rad or m).
const STOPS: f64 = 25.0;
const GIVES: f64 = 0.35;
/// How fast (rad/s or m/s) dry friction has most of its magnitude.
const SLIDES: f64 = 0.05;

/// One degree of freedom that hangs loose, and what acts in its joint.
#[derive(Clone, Debug)]
pub(super) struct Loose {
    pub(super) dof: usize,
    pub(super) coordinate: usize,
    pub(super) position: f64,
    pub(super) velocity: f64,
    limits: Option<Limits>,
    passive: Passive,
}

/// Spring and damper that act on a degree of freedom over a step: stiffness, way from rest, damping.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Held {
    pub(super) stiffness: f64,
    /// Stiffness times how far from rest (N m or N).
    pub(super) force: f64,
    pub(super) damping: f64,
}

impl Loose {
    /// In a state, no faster than `fastest`; none for what has no coordinate of its own.
    pub(super) fn of(figure: &Figure, dof: usize, q: &[f64], v: &[f64], fastest: f64) -> Option<Self> {
        let layout = figure.layout();
        let coordinate = layout.coordinate(dof)?;
        let joint = layout.joints().partition_point(|at| at.v + at.nv <= dof);
        let (kind, at) = (figure.links()[joint].joint().kind(), layout.joints()[joint]);
        let limits = kind.axes().get(dof - at.v).and_then(|axis| axis.limits);
        let passive = *kind.passive(dof - at.v);
        let velocity = v[dof].clamp(-fastest, fastest);
        Some(Self { dof, coordinate, position: q[coordinate], velocity, limits, passive })
    }

    /// How far beyond a limit a position is, with its sign; nothing inside.
    fn beyond(&self, position: f64) -> f64 {
        self.limits.map_or(0.0, |limits| position - position.clamp(limits.lower, limits.upper))
    }

    /// What its joint does, looked at `ahead` (s), where it has this inertia, is pushed by so much (N m or N) and loses so much of its velocity (1/s).
    pub(super) fn held(&self, ahead: f64, inertia: f64, pushed: f64, damping: f64) -> Held {
        let Passive { stiffness, rest, damping: own, friction } = self.passive;
        let mut held = Held {
            stiffness,
            force: stiffness * (self.position - rest),
            damping: damping * inertia + own + friction / self.velocity.hypot(SLIDES),
        };
        // A limit that is passed by then acts all along.
        let beyond = self.beyond(self.position + ahead * self.velocity);
        if beyond != 0.0 {
            // Stiff enough for a push to be held half way to where it gives no more.
            let stop = inertia * STOPS * STOPS + pushed.abs() / (0.5 * GIVES);
            let limit = self.position + ahead * self.velocity - beyond;
            held.stiffness += stop;
            held.force += stop * (self.position - limit);
            held.damping += 2.0 * (inertia * stop).sqrt();
        }
        held
    }

    /// On by `h` (s) with a change of velocity, of at most `most`.
    pub(super) fn go_on(&mut self, h: f64, change: f64, most: f64, fastest: f64) {
        let change = if change.is_finite() { change.clamp(-most, most) } else { -self.velocity };
        let mut velocity = (self.velocity + change).clamp(-fastest, fastest);
        // Limits are soft, and not endlessly so: beyond that it is braked as hard as may be.
        let beyond = self.beyond(self.position);
        if beyond.abs() > GIVES && velocity * beyond > 0.0 {
            let outward = (self.velocity.abs() - most).max(0.0);
            velocity = if self.velocity * beyond > 0.0 { outward.copysign(beyond) } else { 0.0 };
        }
        self.position += 0.5 * h * (self.velocity + velocity);
        self.velocity = velocity;
    }
}
