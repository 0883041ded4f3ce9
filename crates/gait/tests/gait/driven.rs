//! A walker that is driven, looked at frame by frame: by products of matrices and differences, without its plan.

use crate::support::Walked;
use nalgebra::{Rotation3, Vector3};
use solaris_gait::{Command, Walker};
use solaris_model::{Figure, Human, RootOrder, SolePart};

/// A point that is so near to the ground touches it, and does so until it is so far above (m).
const TOUCHES: (f64, f64) = (1e-6, 3e-4);

/// For so long a point that touches is coming down (s).
const LANDS: f64 = 0.01;

pub(crate) fn person(height: f64) -> Figure {
    Human::new(height, 23.8 * height * height).root(RootOrder::Yzx).build().expect("a person")
}

/// What a driven walk came to: the worst of all frames, and when.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    /// Of a point of a sole, from where it touched, while it touches (m).
    pub(crate) slide: (f64, f64),
    pub(crate) sink: f64,
    /// Knees: least and most flexion (rad).
    pub(crate) knees: [f64; 2],
    /// Least distance of the lines of both feet (m).
    pub(crate) feet: (f64, f64),
    /// Greatest velocity and acceleration by differences of frames (rad/s, rad/s²), when, and whose.
    pub(crate) rate: (f64, f64, String),
    pub(crate) change: (f64, f64, String),
    /// The greatest acceleration of the root's place (m/s²).
    pub(crate) root_change: f64,
}

/// Drives a walker and looks at every frame.
pub(crate) struct Driver<'a> {
    figure: &'a Figure,
    pub(crate) walker: Walker,
    rate: f64,
    frame: usize,
    soles: Vec<(usize, Vector3<f64>)>,
    /// Where a point came to touch, and when.
    anchors: Vec<Option<(Vector3<f64>, f64)>>,
    last: Vec<f64>,
    rates: Vec<f64>,
    poses: Vec<Vec<(Vector3<f64>, Rotation3<f64>)>>,
    planned: Vec<[f64; 2]>,
    /// Whether poses are kept for [`Driver::pressures`].
    keeps: bool,
    pub(crate) found: Found,
}

impl<'a> Driver<'a> {
    pub(crate) fn new(figure: &'a Figure, rate: f64) -> Self {
        let point = |name: String, part| {
            let link = figure.link_index(&name).expect("a link");
            (link, *figure.links()[link].sole_point(part).expect("a point"))
        };
        let soles = ["left_", "right_"].into_iter().flat_map(|side| {
            [
                ("foot", SolePart::Heel),
                ("foot", SolePart::Ball),
                ("toes", SolePart::Ball),
                ("toes", SolePart::ToeTip),
            ]
            .map(|(name, part)| point(format!("{side}{name}"), part))
        });
        Self {
            figure,
            walker: Walker::new(figure).expect("a walker"),
            rate,
            frame: 0,
            soles: soles.collect(),
            anchors: vec![None; 8],
            last: Vec::new(),
            rates: Vec::new(),
            poses: Vec::new(),
            planned: Vec::new(),
            keeps: false,
            found: Found {
                slide: (0.0, 0.0),
                sink: 0.0,
                knees: [f64::MAX, f64::MIN],
                feet: (f64::MAX, 0.0),
                rate: (0.0, 0.0, String::new()),
                change: (0.0, 0.0, String::new()),
                root_change: 0.0,
            },
        }
    }

    pub(crate) fn keeping(self) -> Self {
        Self { keeps: true, ..self }
    }

    pub(crate) fn time(&self) -> f64 {
        self.frame as f64 / self.rate
    }

    /// Goes on under a command for a time (s).
    pub(crate) fn go(&mut self, command: &Command, time: f64) -> &mut Self {
        for _ in 0..(time * self.rate).round() as usize {
            self.walker.step(1.0 / self.rate, command).expect("a frame");
            self.look();
        }
        self
    }

    pub(crate) fn look(&mut self) {
        let q = self.walker.configuration();
        let time = self.frame as f64 / self.rate;
        assert!(q.iter().all(|x| x.is_finite()), "{time} s: {q:?}");
        let poses = Walked::poses(self.figure, q);
        let points: Vec<Vector3<f64>> =
            self.soles.iter().map(|(link, point)| poses[*link].0 + poses[*link].1 * point).collect();
        let found = &mut self.found;
        for (i, (anchor, point)) in self.anchors.iter_mut().zip(&points).enumerate() {
            found.sink = found.sink.max(-point.y);
            // Under the joint of the ball the foot turns: it rolls there as its heel rises.
            if i % 4 == 1 && points[i - 1].y > TOUCHES.0 {
                *anchor = None;
                continue;
            }
            match anchor {
                // One that only just comes down, or passes by, has not been set down yet.
                Some((at, since)) if point.y < TOUCHES.1 && time - *since < LANDS => *at = *point,
                Some((at, _)) if point.y < TOUCHES.1 => {
                    let slid = (point - *at).xz().norm();
                    if slid > found.slide.0 && point.y < TOUCHES.0 {
                        found.slide = (slid, time);
                    }
                }
                _ => *anchor = (point.y < TOUCHES.0).then_some((*point, time)),
            }
        }
        for (own, other) in [(0, 4), (4, 0)] {
            let (heel, tip) = (points[own], points[own + 3]);
            let along = (tip - heel).normalize();
            for point in [points[other], points[other + 1], points[other + 3]] {
                let way = (point - heel).dot(&along).clamp(0.0, (tip - heel).norm());
                let apart = (heel + along * way - point).norm();
                if apart < found.feet.0 {
                    found.feet = (apart, time);
                }
            }
        }
        let names = self.figure.layout().q_names();
        let rates: Vec<f64> = self.last.iter().zip(q).map(|(a, b)| (b - a) * self.rate).collect();
        for (i, rate) in rates.iter().enumerate() {
            let change = self.rates.get(i).map_or(0.0, |before| (rate - before).abs() * self.rate);
            if names[i].starts_with("root.t") {
                found.root_change = found.root_change.max(change);
                continue;
            }
            if rate.abs() > found.rate.0 {
                found.rate = (rate.abs(), time, names[i].clone());
            }
            if change > found.change.0 {
                found.change = (change, time, names[i].clone());
            }
        }
        for (i, _) in names.iter().enumerate().filter(|(_, name)| name.ends_with("_knee.rx")) {
            found.knees = [found.knees[0].min(q[i]), found.knees[1].max(q[i])];
        }
        self.last = q.to_vec();
        self.rates = rates;
        self.frame += 1;
        if self.keeps {
            self.poses.push(poses);
            self.planned.push(self.walker.pressure());
        }
    }

    fn com(&self, frame: usize) -> Vector3<f64> {
        let links = self.figure.links().iter().zip(&self.poses[frame]);
        links.map(|(link, (place, turn))| (place + turn * link.com()) * link.mass()).sum::<Vector3<f64>>()
            / self.figure.mass()
    }

    /// The angular momentum about the centre of mass between a frame and the next.
    fn momentum(&self, frame: usize) -> Vector3<f64> {
        let (a, b) = (&self.poses[frame], &self.poses[frame + 1]);
        let (from, to) = (self.com(frame), self.com(frame + 1));
        let (middle, velocity) = (0.5 * (from + to), (to - from) * self.rate);
        let mut sum = Vector3::zeros();
        for (link, ((place, turn), (place_then, turn_then))) in
            self.figure.links().iter().zip(a.iter().zip(b))
        {
            let turned = (turn_then * turn.inverse()).into_inner();
            let twice = |i: usize, j: usize| turned[(i, j)] - turned[(j, i)];
            let spin = Vector3::new(twice(2, 1), twice(0, 2), twice(1, 0)) * (0.5 * self.rate);
            let half = Rotation3::from_scaled_axis(spin * (0.5 / self.rate)) * turn;
            let inertia = half.matrix() * link.inertia() * half.matrix().transpose();
            let (x, y) = (place + turn * link.com(), place_then + turn_then * link.com());
            sum += inertia * spin
                + (0.5 * (x + y) - middle).cross(&((y - x) * self.rate - velocity)) * link.mass();
        }
        sum
    }

    /// By Newton and Euler: the time, the force over the weight, and how far the centre of pressure is from where the plan has it (m).
    ///
    /// ```text
    /// F = m (c̈ + g)      (P − c) × F = Ḣ      P on the ground
    /// ```
    pub(crate) fn pressures(&self) -> Vec<(f64, Vector3<f64>, f64)> {
        let g = 9.80665;
        let mass = self.figure.mass();
        (1..self.poses.len() - 1)
            .map(|i| {
                let [before, at, after] = [i - 1, i, i + 1].map(|i| self.com(i));
                let force = ((after - 2.0 * at + before) * self.rate * self.rate + Vector3::y() * g) * mass;
                let rate = (self.momentum(i) - self.momentum(i - 1)) * self.rate;
                let x = at.x + (rate.z - at.y * force.x) / force.y;
                let z = at.z + (-at.y * force.z - rate.x) / force.y;
                let planned = self.planned[i];
                (i as f64 / self.rate, force / (mass * g), (x - planned[0]).hypot(z - planned[1]))
            })
            .collect()
    }
}
