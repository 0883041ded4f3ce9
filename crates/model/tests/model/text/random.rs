//! Random figures with everything in them.

use solaris_model::{
    Axis, Curve, Figure, FigureBuilder, Inertia, Joint, LinkSpec, Matrix3, Passive, Placement, Shape,
    ShapeKind, SolePart, UnitQuaternion, Vector3,
};

/// Numbers from a seed.
pub(crate) struct Dice(u64);

impl Dice {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    fn word(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    pub(crate) fn below(&mut self, bound: usize) -> usize {
        (self.word() >> 33) as usize % bound
    }

    fn often(&mut self) -> bool {
        self.below(3) > 0
    }

    /// From -2 to 2, with all bits, or with few, or tiny, or zero of either sign.
    fn number(&mut self) -> f64 {
        let any = (self.word() >> 11) as f64 / (1_u64 << 51) as f64 - 2.0;
        match self.below(8) {
            0 => (any * 8.0).round() / 8.0,
            1 => any * 1e-9,
            2 => 0.0 * any.signum(),
            _ => any,
        }
    }

    fn positive(&mut self) -> f64 {
        self.number().abs() + 1e-3
    }

    fn angle(&mut self) -> f64 {
        let any = self.number();
        if self.often() { (any * 60.0).round().to_radians() } else { any }
    }

    fn vector(&mut self) -> Vector3<f64> {
        Vector3::new(self.number(), self.number(), self.number())
    }

    fn direction(&mut self) -> Vector3<f64> {
        let any = self.vector();
        if any.norm() > 0.1 { any } else { Vector3::new(-1.0, -0.0, 0.0) }
    }

    fn rotation(&mut self) -> UnitQuaternion<f64> {
        match self.below(5) {
            0 => UnitQuaternion::identity(),
            1 => UnitQuaternion::from_axis_angle(&Vector3::y_axis(), self.angle()),
            2 => UnitQuaternion::from_euler_angles(self.angle(), self.angle(), self.angle()),
            3 => UnitQuaternion::new(self.vector()) * UnitQuaternion::new(self.vector()),
            _ => UnitQuaternion::new(self.vector()),
        }
    }

    fn placement(&mut self) -> Placement {
        Placement::from_parts(self.vector().into(), self.rotation())
    }

    fn passive(&mut self, spring: bool, rest: bool) -> Passive {
        let none = Passive::default();
        if !self.often() {
            return none;
        }
        Passive {
            stiffness: if spring { self.number() } else { 0.0 },
            rest: if rest { self.angle() } else { 0.0 },
            damping: self.positive(),
            friction: self.positive(),
        }
    }

    fn shape(&mut self) -> Shape {
        let (radius, length) = (self.positive(), self.positive());
        let lengths = Vector3::new(self.positive(), radius, length);
        let kind = match self.below(5) {
            0 => ShapeKind::Box { size: lengths },
            1 => ShapeKind::Ellipsoid { radii: lengths },
            2 => ShapeKind::Sphere { radius },
            3 => ShapeKind::Cylinder { radius, length },
            _ => ShapeKind::Capsule { radius, length },
        };
        Shape { kind, placement: self.placement() }
    }

    fn curve(&mut self) -> Curve {
        if self.below(8) == 0 {
            return Curve::Chain((0..self.below(4)).map(|_| self.plain_curve()).collect());
        }
        self.plain_curve()
    }

    fn plain_curve(&mut self) -> Curve {
        let count = self.below(4);
        if self.often() {
            return Curve::Polynomial((0..count).map(|_| self.number()).collect());
        }
        let knots = (0..=count + 1).map(|knot| knot as f64 * 0.7 - 1.0).collect();
        match self.below(3) {
            0 => {
                let pieces = (0..=count).map(|_| [(); 4].map(|()| self.number())).collect();
                Curve::Cubics { knots, pieces }
            }
            1 => {
                let pieces = (0..=count).map(|_| [(); 6].map(|()| self.number())).collect();
                Curve::Quintics { knots, pieces }
            }
            _ => {
                let [amplitude, frequency, phase, offset] = [(); 4].map(|()| self.number());
                Curve::Sine { amplitude, frequency, phase, offset }
            }
        }
    }

    fn name(&mut self, stem: &str, index: usize) -> String {
        let odd = ["", " ", "\"", "\\", "é", "e\u{301}", "膝", "-", "\n", "\u{7}", "//", "'", "\u{200b}"];
        format!("{}{stem}{}{index}", odd[self.below(odd.len())], odd[self.below(odd.len())])
    }

    fn joint(&mut self, index: usize, leader: Option<&str>) -> Joint {
        let name = self.name("joint", index);
        let placement = self.placement();
        let mut joint = match self.below(8) {
            0 => Joint::ball(name).armature(self.positive()).passive(self.passive(true, false)),
            1 => Joint::free(name).passive(self.passive(false, false)),
            _ => Joint::new(name),
        }
        .placed(placement);
        if joint.kind().nv() > 0 {
            return joint;
        }
        for number in 0..self.below(7) {
            joint = match self.below(5) {
                0 => joint.rx(),
                1 => joint.ty(),
                2 => joint.axis(Axis::translation(self.direction())),
                3 => joint.axis(Axis::rotation(-Vector3::z())),
                _ => joint.axis(Axis::rotation(self.direction())),
            };
            if self.below(3) == 0 {
                let lower = if self.often() { self.angle() } else { f64::NEG_INFINITY };
                joint = joint.limited(lower, lower.max(-2.0) + self.positive());
            }
            if self.below(3) == 0 {
                joint = joint.armature(self.positive());
            }
            joint = joint.passive(self.passive(true, true));
            if self.below(3) == 0 {
                joint = joint.named(self.name("dof", 10 * index + number));
            }
            if let Some(leader) = leader.filter(|_| self.below(4) == 0) {
                joint = joint.following(leader, self.curve());
            }
        }
        joint
    }

    fn link(&mut self, index: usize, parent: Option<&str>, leader: Option<&str>) -> (String, LinkSpec) {
        let (name, joint) = (self.name("link", index), self.joint(index, leader));
        let mut link = match parent {
            Some(parent) => LinkSpec::child(&name, parent, joint),
            None => LinkSpec::root(&name, Joint::new("first").rx().rz().placed(self.placement())),
        };
        link = link.mass(self.positive()).com(self.vector());
        if self.often() {
            link = link.shape(self.shape());
        }
        link = match self.below(4) {
            0 => link,
            1 => link.inertia(Inertia::Uniform(self.shape())),
            2 => link.inertia(Inertia::diagonal(0.2, 0.3, 0.1 + self.positive().min(0.3))),
            _ => {
                let turn: Matrix3<f64> = self.rotation().to_rotation_matrix().into_inner();
                let moments = Matrix3::from_diagonal(&Vector3::new(0.2, 0.3, 0.4));
                link.inertia(Inertia::Tensor(turn * moments * turn.transpose()))
            }
        };
        for part in [SolePart::Ball, SolePart::Heel, SolePart::ToeTip, SolePart::Heel] {
            if self.below(4) == 0 {
                link = link.sole(part, self.vector());
            }
        }
        if self.often() {
            link = link.tip(self.vector());
        }
        for number in 0..self.below(3) {
            link = link.frame(self.name("frame", 10 * index + number), self.placement());
        }
        (name, link)
    }
}

/// A figure of one to twelve links.
pub(crate) fn figure(seed: u64) -> Figure {
    let dice = &mut Dice::new(seed);
    let mut builder = FigureBuilder::new(dice.name("figure", 0));
    if dice.often() {
        builder = builder.stature(dice.positive());
    }
    if dice.often() {
        builder = builder.gravity(dice.vector());
    }
    let mut names: Vec<String> = Vec::new();
    for index in 0..=dice.below(12) {
        let parent = (index > 0).then(|| names[dice.below(index)].clone());
        let (name, link) = dice.link(index, parent.as_deref(), Some("first.rx"));
        names.push(name);
        builder = builder.link(link);
    }
    for (number, dof) in ["first.rx", "first.rz"].into_iter().enumerate() {
        if dice.often() {
            builder = builder.angle(dice.name("angle", number), dof, dice.often());
        }
    }
    builder.build().expect("a random figure is one")
}
