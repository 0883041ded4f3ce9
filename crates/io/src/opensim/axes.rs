//! Axes of OpenSim's joints, as those of a figure.

use super::coordinate::Coordinate;
use super::couplers::Couplers;
use super::curves::compose;
use solaris_model::{Axis, AxisKind, Curve, Joint, Placement, UnitQuaternion, Vector3};

/// One motion of a joint: along or about an axis of the frame that the motions before it have moved.
#[derive(Clone, Debug)]
pub(super) struct Step {
    pub(super) kind: AxisKind,
    pub(super) direction: Vector3<f64>,
    pub(super) moves: Moves,
}

/// How far a step goes (rad or m).
#[derive(Clone, Debug)]
pub(super) enum Moves {
    /// Always so far.
    By(f64),
    /// As far as the joint's coordinate of this number says.
    With(usize),
    /// A function of that coordinate.
    Along(usize, Curve),
}

impl Step {
    /// As far as a coordinate says.
    pub(super) fn with(kind: AxisKind, direction: Vector3<f64>, coordinate: usize) -> Self {
        Self { kind, direction, moves: Moves::With(coordinate) }
    }

    /// Always so far.
    pub(super) fn by(kind: AxisKind, direction: Vector3<f64>, by: f64) -> Self {
        Self { kind, direction, moves: Moves::By(by) }
    }

    /// A function of a coordinate.
    pub(super) fn along(kind: AxisKind, direction: Vector3<f64>, coordinate: usize, curve: Curve) -> Self {
        Self { kind, direction, moves: Moves::Along(coordinate, curve) }
    }

    fn transform(&self, by: f64) -> Placement {
        match self.kind {
            AxisKind::Translation => {
                Placement::translation(self.direction.x * by, self.direction.y * by, self.direction.z * by)
            }
            AxisKind::Rotation => Placement::rotation(self.direction * by),
        }
    }
}

/// The most axes of one joint of a figure.
const MOST_AXES: usize = 6;

/// A joint of the file as those of a figure.
#[derive(Default)]
pub(super) struct Built {
    /// One or more, from the parent on; between them stand links without mass.
    pub(super) joints: Vec<Joint>,
    /// Where the body's frame stands in the frame that the last one moves.
    pub(super) beyond: Placement,
}

/// A joint that is still steps.
pub(super) struct Chain<'a> {
    pub(super) name: &'a str,
    /// Where the steps begin, in the parent body's frame.
    pub(super) from: Placement,
    pub(super) steps: Vec<Step>,
    /// Where they end, in the child body's frame.
    pub(super) to: Placement,
    pub(super) coordinates: &'a [Coordinate],
}

impl Chain<'_> {
    /// The joints in a row, and where the body's frame stands in the frame that the last one moves.
    ///
    /// What is constant goes to the left, past the steps, which it turns, into the first joint's placement:
    ///
    /// ```text
    /// step(a, x)·K = K·step(R_K⁻¹·a, x)        X_FB⁻¹ = R⁻¹·T(−p)
    /// ```
    ///
    /// so the moved frame has the directions of the body's frame, and stands in it where the joint does. A turn is not passed
    /// by what is moved as well as turned: there, another joint begins.
    pub(super) fn joint(self, couplers: &Couplers) -> Built {
        let mut beyond = Vector3::zeros() - self.to.translation.vector;
        let mut fixed = Placement::from_parts(Vector3::zeros().into(), self.to.rotation.inverse());
        let mut groups = Vec::new();
        let mut moving = Vec::new();
        let mut names = self.names().into_iter().rev();
        for mut step in self.steps.iter().cloned().rev() {
            if let Moves::By(by) = step.moves {
                fixed = if by == 0.0 { fixed } else { step.transform(by) * fixed };
                continue;
            }
            if step.kind == AxisKind::Rotation && fixed.translation.vector != Vector3::zeros() {
                if moving.is_empty() {
                    beyond += fixed.rotation.inverse() * fixed.translation.vector;
                    fixed.translation.vector = Vector3::zeros();
                } else {
                    groups.push((fixed, std::mem::take(&mut moving)));
                    fixed = Placement::identity();
                }
            }
            if fixed.rotation != UnitQuaternion::identity() {
                step.direction = fixed.rotation.inverse() * step.direction;
            }
            moving.push((step, names.next().flatten()));
        }
        groups.push((product(&self.from, &fixed), moving));
        let mut joints = Vec::new();
        for (placement, moving) in groups.into_iter().rev() {
            let mut steps = moving.into_iter().rev().peekable();
            let mut place = Some(placement);
            while let Some(placement) = place.take() {
                let name = match joints.len() {
                    0 => self.name.to_owned(),
                    before => format!("{}_{}", self.name, before + 1),
                };
                let mut joint = Joint::new(name).placed(placement);
                for (step, name) in steps.by_ref().take(MOST_AXES) {
                    joint = self.add(joint, step, couplers);
                    if let Some(name) = name {
                        joint = joint.named(name);
                    }
                }
                joints.push(joint);
                place = steps.peek().is_some().then(Placement::identity);
            }
        }
        Built { joints, beyond: Placement::from_parts(beyond.into(), UnitQuaternion::identity()) }
    }

    /// The names of the moving steps that follow a coordinate, by the file's axes, which constants may turn; nothing for
    /// the others, and where the axis is oblique or not the only one.
    fn names(&self) -> Vec<Option<String>> {
        let moving = || self.steps.iter().filter(|step| !matches!(step.moves, Moves::By(_)));
        let stem = |step: &Step| {
            let letter =
                (0..3).find(|&i| step.direction == Vector3::ith(i, 1.0)).map(|i| ["x", "y", "z"][i])?;
            Some(if step.kind == AxisKind::Rotation { format!("r{letter}") } else { format!("t{letter}") })
        };
        let name = |step: &Step| {
            let stem = stem(step).filter(|_| matches!(step.moves, Moves::Along(..)))?;
            let same = moving().filter(|other| other.kind == step.kind && other.direction == step.direction);
            (same.count() == 1).then(|| format!("{}.{stem}", self.name))
        };
        moving().map(name).collect()
    }

    fn add(&self, joint: Joint, step: Step, couplers: &Couplers) -> Joint {
        let joint = joint.axis(Axis { kind: step.kind, direction: step.direction });
        match step.moves {
            Moves::By(_) => joint,
            Moves::With(i) => {
                let coordinate = &self.coordinates[i];
                let mut joint = joint.named(&coordinate.dof);
                if let Some((lower, upper)) = coordinate.limits {
                    joint = joint.limited(lower, upper);
                }
                match couplers.get(&coordinate.dof) {
                    Some(lead) => joint.following(&lead.leader, lead.curve.clone()),
                    None => joint,
                }
            }
            Moves::Along(i, curve) => {
                let name = &self.coordinates[i].dof;
                let Some(lead) = couplers.get(name) else { return joint.following(name, curve) };
                // The coordinate follows another one itself.
                joint.following(&lead.leader, compose(&curve, &lead.curve))
            }
        }
    }
}

/// `a·b`, to the bit where one of them is the identity.
pub(super) fn product(a: &Placement, b: &Placement) -> Placement {
    let identity = Placement::identity();
    match (*a == identity, *b == identity) {
        (true, _) => *b,
        (_, true) => *a,
        _ => a * b,
    }
}
