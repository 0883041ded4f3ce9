//! Figures with followers obey Lagrange's equation.

use crate::opensim::{axis, body, document, joint, read};
use solaris_dynamics::{Tree, Workspace, inverse_dynamics, kinetic_energy, potential_energy};
use solaris_io::Import;

/// A leg of which the knee's centre and a second turn follow its angle, a patella its coordinate, which follows the knee
/// along a bent function, and a fabella all of whose axes are functions of its own coordinate.
fn leg() -> Import {
    let spline =
        |y: &str| format!("<SimmSpline name=\"function\"><x>-2 -1.2 -0.5 0.1 0.8</x><y>{y}</y></SimmSpline>");
    let knee = axis("rotation1", "knee", "0 0 1", "")
        + &axis("rotation2", "knee", "0 1 0", &spline("0.3 0.2 0 -0.02 0.05"))
        + &axis("translation1", "knee", "1 0 0", &spline("-0.03 0.02 0.04 0 -0.02"))
        + &axis("translation2", "knee", "0 1 0", &spline("-0.42 -0.41 -0.4 -0.39 -0.4"));
    let patella = axis(
        "rotation1",
        "glide",
        "0 0 1",
        "<LinearFunction name=\"function\"><coefficients>-1 0.4</coefficients></LinearFunction>",
    ) + &axis("translation1", "glide", "1 0 0", &spline("0.05 0.04 0.06 0.05 0.02"));
    let bent = |c: &str| {
        format!("<PolynomialFunction name=\"function\"><coefficients>{c}</coefficients></PolynomialFunction>")
    };
    let fabella = axis("rotation1", "roll", "0 0.6 0.8", &bent("0.3 0.4 0.1"))
        + &axis("rotation2", "roll", "1 0 0", &bent("-0.2 0.1 0 0.3"))
        + &axis("translation1", "roll", "1 0 0", &bent("0.02 -0.05 0.01"));
    let transform = |axes: &str| format!("<SpatialTransform>{axes}</SpatialTransform>");
    let joints = joint("PlanarJoint", "root", ["/ground", "/bodyset/pelvis"], &["tilt", "x", "y"], "")
        + &joint("BallJoint", "hip", ["/bodyset/pelvis", "/bodyset/femur"], &["ha", "hb", "hc"], "")
        + &joint("CustomJoint", "knee", ["/bodyset/femur", "/bodyset/tibia"], &["knee"], &transform(&knee))
        + &joint(
            "CustomJoint",
            "patella",
            ["/bodyset/femur", "/bodyset/patella"],
            &["glide"],
            &transform(&patella),
        )
        + &joint(
            "CustomJoint",
            "fabella",
            ["/bodyset/femur", "/bodyset/fabella"],
            &["roll"],
            &transform(&fabella),
        );
    let coupler = "<ConstraintSet><objects><CoordinateCouplerConstraint name=\"glide_of_knee\">\
        <coupled_coordinates_function><PolynomialFunction><coefficients>0.1 0.5 0.1</coefficients></PolynomialFunction></coupled_coordinates_function>\
        <independent_coordinate_names>knee</independent_coordinate_names>\
        <dependent_coordinate_name>glide</dependent_coordinate_name><scale_factor>-1.2</scale_factor>\
        </CoordinateCouplerConstraint></objects></ConstraintSet>";
    let bodies = body("pelvis", 11.0) + &body("femur", 9.0) + &body("tibia", 4.0) + &body("patella", 0.3);
    let bodies = bodies + &body("fabella", 0.2);
    read(&document(&bodies, &joints, coupler))
}

/// The figure with its followers where they belong.
struct System {
    import: Import,
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    free: Vec<usize>,
}

impl System {
    fn new(import: Import) -> Self {
        let tree = Tree::new(&import.figure, import.gravity).expect("a figure");
        let workspace = Workspace::new(&tree);
        let free = (0..tree.nv()).filter(|&dof| !import.figure.follows(dof)).collect();
        Self { import, tree, workspace, free }
    }

    /// All of `q`, `v`, `a` from those of the free degrees of freedom.
    fn whole(&self, x: &[f64], dx: &[f64], ddx: &[f64]) -> [Vec<f64>; 3] {
        let mut state = [x, dx, ddx].map(|part| {
            let mut whole = vec![0.0; self.tree.nv()];
            self.free.iter().zip(part).for_each(|(&dof, value)| whole[dof] = *value);
            whole
        });
        let [q, v, a] = &mut state;
        self.import.figure.follow(q, v, a);
        state
    }

    fn lagrangian(&mut self, x: &[f64], dx: &[f64]) -> f64 {
        let [q, v, _] = self.whole(x, dx, &vec![0.0; x.len()]);
        let kinetic = kinetic_energy(&self.tree, &mut self.workspace, &q, &v).expect("a state");
        kinetic - potential_energy(&self.tree, &mut self.workspace, &q).expect("a state")
    }

    fn forces(&mut self, x: &[f64], dx: &[f64], ddx: &[f64]) -> Vec<f64> {
        let [q, v, a] = self.whole(x, dx, ddx);
        let mut tau = vec![0.0; v.len()];
        inverse_dynamics(&self.tree, &mut self.workspace, &q, &v, &a, &[], &mut tau).expect("a state");
        self.import.figure.fold_forces(&q, &mut tau);
        self.free.iter().map(|&dof| tau[dof]).collect()
    }
}

/// The derivative of `f` at 0, to the sixth order of `h`.
fn derivative(h: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let mut pair = |k: f64| f(k * h) - f(-k * h);
    (45.0 * pair(1.0) - 9.0 * pair(2.0) + pair(3.0)) / (60.0 * h)
}

fn shifted(x: &[f64], i: usize, by: f64) -> Vec<f64> {
    let mut x = x.to_vec();
    x[i] += by;
    x
}

/// `τ = d/dt(∂L/∂ẋ) − ∂L/∂x` along `x + ẋ·t + ½ẍ·t²`, by differences of the energies.
#[test]
fn forces_are_those_of_the_energies() {
    let mut leg = System::new(leg());
    assert_eq!((leg.tree.nv(), leg.free.len()), (16, 8));
    let mut seed = 7_u64;
    let mut random = |size: f64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        size * ((seed >> 11) as f64 / 2f64.powi(52) - 1.0)
    };
    for _ in 0..8 {
        let mut part = |size: f64| (0..8).map(|_| random(size)).collect::<Vec<f64>>();
        let (mut x, dx, ddx) = (part(0.9), part(2.0), part(10.0));
        // Off the spline's knots, where its third derivative jumps.
        let knee = leg.import.figure.layout().dof_index("knee").expect("the knee");
        let knee = leg.free.iter().position(|&dof| dof == knee).expect("free");
        x[knee] = [-1.7, -0.8, -0.2, 0.4][(x[0].to_bits() % 4) as usize];
        let tau = leg.forces(&x, &dx, &ddx);
        for i in 0..8 {
            let along = |t: f64| {
                let x: Vec<f64> = (0..8).map(|k| x[k] + t * dx[k] + t * t * ddx[k] / 2.0).collect();
                let dx: Vec<f64> = (0..8).map(|k| dx[k] + t * ddx[k]).collect();
                (x, dx)
            };
            // The energy is quadratic in ẋ, so that a central difference of any width is exact.
            let mut momentum = |t: f64| {
                let (x, dx) = along(t);
                (leg.lagrangian(&x, &shifted(&dx, i, 1.0)) - leg.lagrangian(&x, &shifted(&dx, i, -1.0))) / 2.0
            };
            let rate = derivative(2e-3, &mut momentum);
            let slope = derivative(2e-3, |by| leg.lagrangian(&shifted(&x, i, by), &dx));
            let expected = rate - slope;
            assert!(
                (tau[i] - expected).abs() < 1e-7 * (1.0 + tau.iter().fold(0.0, |m: f64, t| m.max(t.abs()))),
                "dof {i}: {} {expected}",
                tau[i]
            );
        }
    }
}

/// A coupled coordinate and what it drives in turn, all from the one that leads.
#[test]
fn couplers_reach_through() {
    let leg = leg();
    let names = leg.figure.layout().v_names();
    let leaders: Vec<_> =
        leg.figure.followers().iter().map(|f| (names[f.dof].as_str(), names[f.leader].as_str())).collect();
    assert_eq!(
        leaders,
        [
            ("knee.tx", "knee"),
            ("knee.ty", "knee"),
            ("knee.ry", "knee"),
            ("patella.tx", "knee"),
            ("glide", "knee"),
            ("fabella.tx", "roll"),
            ("fabella.r2", "roll"),
            ("fabella.rx", "roll")
        ]
    );
    let glide = leg.figure.followers().iter().find(|f| names[f.dof] == "glide").expect("it follows");
    // −1.2·(0.1·x² + 0.5·x + 0.1)
    let [value, slope, _] = glide.curve.at(1.0);
    assert!((value + 0.84).abs() < 1e-15 && (slope + 0.84).abs() < 1e-15);
}
