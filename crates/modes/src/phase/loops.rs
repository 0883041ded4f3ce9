//! Closed loops of the small figure: points and axes that are held together.

use super::reduction::Source;
use super::rows::{Rows, Sought, WORLD};
use crate::between::{Between, Kind};
use crate::body::{Body, Closure};
use crate::convex::Convex;
use crate::element::{Anchor, LoopKind};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use solaris_model::LinkPlace;
use solaris_profiles::Elementary;

/// Loops of which dynamics move a part.
#[derive(Clone)]
pub(super) struct Loops(Vec<Closed>);

#[derive(Clone)]
struct Closed {
    /// Its index in the simulation.
    index: usize,
    ends: [End; 2],
    /// Whether axes are held together as well, and how the second's stand in the first's, once that is known.
    is_weld: bool,
    turn: Option<Matrix3<f64>>,
    /// How far its points, and its axes (a rotation vector), may still be apart, for they began there (m, rad; world axes).
    allowed: [Vector3<f64>; 2],
    /// Where its points are (m), and how far the first is off the second, as `allowed`.
    points: [Vector3<f64>; 2],
    apart: [Vector3<f64>; 2],
}

/// A point of a link of the full figure and of the small one, or of the world.
#[derive(Clone, Copy)]
struct End {
    link: Option<(usize, usize)>,
    /// In the frame of the small figure's link (m).
    point: Vector3<f64>,
}

impl Loops {
    /// Those with an end on a link that is `moved`; `place` says which link of the small figure carries one of the full figure, and where.
    pub(super) fn of(source: &Source, moved: &[bool], place: impl Fn(usize) -> Option<LinkPlace>) -> Self {
        let end = |Anchor { link, point }: Anchor| {
            let Some(full) = link else { return Some(End { link: None, point }) };
            let LinkPlace { link, placement } = place(full)?;
            Some(End { link: Some((full, link)), point: placement.transform_point(&point.into()).coords })
        };
        let all = source.closed.iter().filter_map(|&(index, closed)| {
            if !closed.between.iter().any(|anchor| anchor.link.is_some_and(|link| moved[link])) {
                return None;
            }
            let [first, second] = closed.between.map(end);
            let (zeros, is_weld) = ([Vector3::zeros(); 2], closed.kind == LoopKind::Weld);
            let ends = [first?, second?];
            Some(Closed { index, ends, is_weld, turn: None, allowed: zeros, points: zeros, apart: zeros })
        });
        Self(all.collect())
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The same as conditions on the accelerations of links of the small figure.
    pub(super) fn closures<T: Elementary>(&self) -> Vec<Closure<T>> {
        let of = |closed: &Closed| {
            Closure::new(closed.ends.map(|end| (end.link.map(|(_, small)| small), end.point)), closed.is_weld)
        };
        self.0.iter().filter(|closed| closed.is_open()).filter_map(of).collect()
    }

    /// What [closures](Self::closures) do to links, as `body` found it last.
    pub(super) fn closing(&mut self, body: &Body<f64>, mut visit: impl FnMut(Between)) {
        let mut found = body.closing().iter();
        for closed in self.0.iter_mut().filter(|closed| closed.is_open()) {
            let Some((_, wrench)) = found.next() else { return };
            closed.place(body, true);
            // The first link is held to the second, or to the world; where the first end is the world's, the second to that.
            let first = usize::from(closed.ends[0].link.is_none());
            let sign = if first == 0 { 1.0 } else { -1.0 };
            visit(Between {
                links: closed.ends.map(|end| end.link.map(|link| link.0)),
                points: closed.points,
                force: wrench.force * sign,
                moment: wrench.moment_about(&closed.points[first]) * sign,
                kind: Kind::Loop { index: closed.index, apart: closed.apart[0].norm() },
            });
        }
    }

    /// How many conditions they have.
    pub(super) fn conditions(&self) -> usize {
        self.0.iter().map(|closed| if closed.is_weld { 2 } else { 1 }).sum()
    }

    /// Adds their conditions at the poses, velocities and accelerations that `body` has, for a step of `h` (s); the accelerations are
    /// those without any of the joints. What is apart comes together `within` a time `T`.
    ///
    /// ```text
    /// u = J₁·v − J₂·v        û = −(x₁ − x₂)/T − h·(J̇₁·v − J̇₂·v)/2
    /// ```
    ///
    /// Points go along arcs: what these are off their tangents in the step is foreseen.
    pub(super) fn hold(
        &mut self,
        body: &Body<f64>,
        rows: &mut Rows,
        sought: Sought<'_>,
        convex: &mut Convex,
        (begun, h, within): (bool, f64, f64),
    ) {
        for closed in &mut self.0 {
            closed.place(body, begun);
            let arcs = closed.arcs(body);
            let targets =
                [0, 1].map(|i| (closed.allowed[i] - closed.apart[i]) / within - arcs[i] * (0.5 * h));
            for (end, (point, sign)) in closed.ends.iter().zip(closed.points.iter().zip([1.0, -1.0])) {
                if let Some((_, link)) = end.link {
                    rows.add_point(body, (link, point), &WORLD, sign);
                }
            }
            let bias = rows.begin(convex, sought);
            convex.hold(bias, targets[0].into());
            if closed.is_weld {
                for (end, sign) in closed.ends.iter().zip([1.0, -1.0]) {
                    if let Some((_, link)) = end.link {
                        rows.add_turn(body, link, sign);
                    }
                }
                let bias = rows.begin(convex, sought);
                convex.hold(bias, targets[1].into());
            }
        }
    }

    /// What began apart comes together, by `way` (m or rad).
    pub(super) fn draw(&mut self, way: f64) {
        for allowed in self.0.iter_mut().flat_map(|closed| &mut closed.allowed) {
            *allowed *= (1.0 - way / allowed.norm().max(way)).max(0.0);
        }
    }

    /// What they do to links, `impulses` being those of their conditions in a step of `h` (s).
    pub(super) fn forces(
        &self,
        mut impulses: impl Iterator<Item = [f64; 3]>,
        h: f64,
        mut visit: impl FnMut([Option<usize>; 2], Between),
    ) {
        for closed in &self.0 {
            let mut next = || impulses.next().map_or_else(Vector3::zeros, |part| Vector3::from(part) / h);
            let force = next();
            let moment = if closed.is_weld { next() } else { Vector3::zeros() };
            let kind = Kind::Loop { index: closed.index, apart: closed.apart[0].norm() };
            let links = closed.ends.map(|end| end.link.map(|link| link.0));
            let small = closed.ends.map(|end| end.link.map(|link| link.1));
            visit(small, Between { links, points: closed.points, force, moment, kind });
        }
    }
}

impl Closed {
    /// Whether its ends are on two links: what stands still in between makes one of them.
    fn is_open(&self) -> bool {
        let [first, second] = self.ends.map(|end| end.link.map(|(_, small)| small));
        first != second
    }

    /// The acceleration of the first point relative to the second, and of the first link's turning.
    fn arcs(&self, body: &Body<f64>) -> [Vector3<f64>; 2] {
        let [first, second] = [0, 1].map(|i| {
            let link = self.ends[i].link;
            link.map_or([Vector3::zeros(); 2], |(_, link)| {
                let at = body.acceleration_at(link, &self.points[i]);
                [at.linear, at.angular]
            })
        });
        [first[0] - second[0], first[1] - second[1]]
    }

    fn place(&mut self, body: &Body<f64>, begun: bool) {
        let point = |end: &End| end.link.map_or(end.point, |(_, link)| body.pose(link).transform(&end.point));
        self.points = [point(&self.ends[0]), point(&self.ends[1])];
        self.apart[0] = self.points[0] - self.points[1];
        if self.is_weld {
            let axes =
                |end: &End| end.link.map_or_else(Matrix3::identity, |(_, link)| body.pose(link).rotation);
            let [first, second] = [axes(&self.ends[0]), axes(&self.ends[1])];
            let turn = *self.turn.get_or_insert_with(|| first.tr_mul(&second));
            // By way of a quaternion: the cosine of a matrix that is one but for rounding may be above 1.
            let off = Rotation3::from_matrix_unchecked(first * turn * second.transpose());
            self.apart[1] = UnitQuaternion::from_rotation_matrix(&off).scaled_axis();
        }
        if !begun {
            self.allowed = self.apart;
        }
    }
}
