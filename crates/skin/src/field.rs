//! A solid body as a field: below zero inside, above outside, put together from solids that flow into each other.

mod cone;
mod loft;

pub(crate) use cone::Cone;
pub(crate) use loft::{Loft, Section};

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

/// A value and its gradient.
pub(crate) type Sample = (f64, Vector3<f64>);

/// A box along the axes: least and greatest corner (m).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounds(pub(crate) Vector3<f64>, pub(crate) Vector3<f64>);

impl Bounds {
    pub(crate) fn around(points: impl IntoIterator<Item = Vector3<f64>>, margin: f64) -> Self {
        let start = Self(Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
        let found = points.into_iter().fold(start, |b, p| Self(b.0.inf(&p), b.1.sup(&p)));
        Self(found.0.add_scalar(-margin), found.1.add_scalar(margin))
    }

    fn holds(&self, p: &Vector3<f64>) -> bool {
        (0..3).all(|k| self.0[k] <= p[k] && p[k] <= self.1[k])
    }

    /// How far two boxes are apart, at most along one axis (m); negative where they overlap.
    pub(crate) fn apart(&self, other: &Self) -> f64 {
        (self.0 - other.1).sup(&(other.0 - self.1)).max()
    }
}

/// What one solid looks like in its own axes.
#[derive(Clone, Debug)]
pub(crate) enum Form {
    Cone(Cone),
    Loft(Loft),
}

/// Whether a solid is put on or taken away.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Act {
    Add,
    Carve,
}

/// A solid of a body.
#[derive(Clone, Debug)]
pub(crate) struct Solid {
    form: Form,
    /// Its axes in the world, and where they begin.
    turn: Matrix3<f64>,
    origin: Vector3<f64>,
    act: Act,
    /// Over what distance it flows into what is there (m).
    blend: f64,
    /// What of it is kept: a point of a plane and the direction in which it ends.
    cut: Option<(Vector3<f64>, Vector3<f64>)>,
    /// Around it; in a field, around all that it has a say on.
    bounds: Bounds,
}

/// Rounding of an edge that is cut (m).
const EDGE: f64 = 0.006;

impl Solid {
    pub(crate) fn new(form: Form, turn: UnitQuaternion<f64>, origin: Vector3<f64>, blend: f64) -> Self {
        let turn = turn.to_rotation_matrix().into_inner();
        let mut solid = Self {
            form,
            turn,
            origin,
            act: Act::Add,
            blend,
            cut: None,
            bounds: Bounds::around([origin], 0.0),
        };
        solid.bounds = solid.within(0.0);
        solid
    }

    /// The box around all points whose values are not above `value` (m).
    fn within(&self, value: f64) -> Bounds {
        let own = match &self.form {
            Form::Cone(cone) => cone.within(value),
            Form::Loft(loft) => loft.within(value),
        };
        let corner = |i: usize| {
            let pick = |k: usize| if i >> k & 1 == 0 { own.0[k] } else { own.1[k] };
            self.origin + self.turn * Vector3::new(pick(0), pick(1), pick(2))
        };
        Bounds::around((0..8).map(corner), 0.0)
    }

    pub(crate) fn carve(mut self) -> Self {
        self.act = Act::Carve;
        self
    }

    pub(crate) fn cut(mut self, point: Vector3<f64>, towards: Vector3<f64>) -> Self {
        self.cut = Some((point, towards.normalize()));
        self
    }

    /// Whether it has a say at a place.
    fn says(&self, p: &Vector3<f64>) -> bool {
        self.bounds.holds(p)
    }

    fn sample(&self, p: &Vector3<f64>) -> Sample {
        let local = self.turn.tr_mul(&(p - self.origin));
        let (value, gradient) = match &self.form {
            Form::Cone(cone) => cone.sample(&local),
            Form::Loft(loft) => loft.sample(&local),
        };
        let sample = (value, self.turn * gradient);
        match &self.cut {
            None => sample,
            Some((point, towards)) => smooth_max(sample, (towards.dot(&(p - point)), *towards), EDGE),
        }
    }
}

/// Solids that flow into each other first, and then as one into those before.
#[derive(Clone, Debug, Default)]
pub(crate) struct Group {
    pub(crate) solids: Vec<Solid>,
    pub(crate) blend: f64,
}

/// A body.
#[derive(Clone, Debug)]
pub(crate) struct Field {
    groups: Vec<Group>,
    bounds: Bounds,
}

/// The solids that matter somewhere, by group and place in it.
pub(crate) type Near = Vec<(u8, u16)>;

/// Boxes so near (m) touch.
const TOUCH: f64 = 1e-9;

/// Far away.
const FAR: Sample = (1e3, Vector3::new(0.0, 0.0, 0.0));

impl Field {
    /// A solid has a say where its value `d` is below `5/4 k + K`, `K` being its group's blend. Beyond, it would change what it flows into
    /// only where that is over `K`, and so not where the surface is:
    ///
    /// ```text
    /// f ≤ d − k ⇒ smin(f, d, k) = f;   f > d − k ⇒ f, smin(f, d, k) > min(f, d) − k/4 ≥ K
    /// ```
    pub(crate) fn new(mut groups: Vec<Group>) -> Self {
        let added = groups.iter().flat_map(|group| &group.solids).filter(|solid| solid.act == Act::Add);
        let corners: Vec<Vector3<f64>> = added.flat_map(|solid| [solid.bounds.0, solid.bounds.1]).collect();
        for group in &mut groups {
            for solid in &mut group.solids {
                solid.bounds = solid.within(1.25 * solid.blend + group.blend);
            }
        }
        Self { groups, bounds: Bounds::around(corners, 0.0) }
    }

    pub(crate) fn all(&self) -> Near {
        let of = |(g, group): (usize, &Group)| (0..group.solids.len()).map(move |i| (g as u8, i as u16));
        self.groups.iter().enumerate().flat_map(of).collect()
    }

    /// Those of `near` that have a say in a box.
    pub(crate) fn near(&self, near: &Near, place: &Bounds) -> Near {
        let matters =
            |(g, i): &(u8, u16)| self.groups[*g as usize].solids[*i as usize].bounds.apart(place) <= TOUCH;
        near.iter().copied().filter(matters).collect()
    }

    /// The field, of the solids `near`.
    pub(crate) fn sample(&self, p: &Vector3<f64>, near: &Near) -> Sample {
        self.whole(p, near, Solid::says)
    }

    /// About how far the surface is from a place, of the solids `near`: even of those that have no say there.
    pub(crate) fn distance(&self, p: &Vector3<f64>, near: &Near) -> f64 {
        self.whole(p, near, |_, _| true).0
    }

    fn whole(&self, p: &Vector3<f64>, near: &Near, says: fn(&Solid, &Vector3<f64>) -> bool) -> Sample {
        let (mut whole, mut at) = (FAR, 0);
        while let Some(&(group, _)) = near.get(at) {
            let (part, next) = self.part(p, near, at, says);
            let blend = self.groups[group as usize].blend;
            (whole, at) = (smooth_min(whole, part, blend), next);
        }
        whole
    }

    /// The box around all that is added.
    pub(crate) fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// The group that is nearest to a point.
    pub(crate) fn nearest(&self, p: &Vector3<f64>, near: &Near) -> usize {
        let (mut best, mut at) = ((f64::INFINITY, 0), 0);
        while let Some(&(group, _)) = near.get(at) {
            let (part, next) = self.part(p, near, at, Solid::says);
            if part.0 < best.0 {
                best = (part.0, group as usize);
            }
            at = next;
        }
        best.1
    }

    /// The value of the group that begins at `at`, and where the next one does.
    fn part(
        &self,
        p: &Vector3<f64>,
        near: &Near,
        mut at: usize,
        says: fn(&Solid, &Vector3<f64>) -> bool,
    ) -> (Sample, usize) {
        let (group, mut part) = (near[at].0, FAR);
        while let Some(&(_, i)) = near.get(at).filter(|(g, _)| *g == group) {
            let solid = &self.groups[group as usize].solids[i as usize];
            at += 1;
            // Whether a solid has a say is a matter of the place alone: whoever asks hears the same, to the bit.
            if !says(solid, p) {
                continue;
            }
            let (value, gradient) = solid.sample(p);
            part = match solid.act {
                Act::Add => smooth_min(part, (value, gradient), solid.blend),
                Act::Carve => smooth_max(part, (-value, -gradient), solid.blend),
            };
        }
        (part, at)
    }
}

/// The smaller of two values, rounded where they are nearer than `k`:
///
/// ```text
/// smin(a, b, k) = b + h·(a − b) − k·h·(1 − h),  h = clamp(½ + ½(b − a)/k, 0, 1)
/// ```
///
/// whose gradient is `∇b + h·(∇a − ∇b)`.
fn smooth_min(a: Sample, b: Sample, k: f64) -> Sample {
    // To the bit, so that a solid out of reach may as well not be there.
    if b.0 - a.0 >= k {
        return a;
    }
    if a.0 - b.0 >= k {
        return b;
    }
    let h = 0.5 + 0.5 * (b.0 - a.0) / k;
    (b.0 + h * (a.0 - b.0) - k * h * (1.0 - h), b.1 + (a.1 - b.1) * h)
}

fn smooth_max(a: Sample, b: Sample, k: f64) -> Sample {
    let (value, gradient) = smooth_min((-a.0, -a.1), (-b.0, -b.1), k);
    (-value, -gradient)
}
