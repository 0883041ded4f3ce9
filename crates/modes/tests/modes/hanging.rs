//! Limbs that hang loose: a pendulum by its closed form, energy, limits, and a driver that does anything.

use solaris_dynamics::{Tree, Workspace, Wrench, kinetic_energy, potential_energy};
use solaris_model::{Figure, FigureBuilder, Human, Joint, LinkSpec, RootOrder, Vector3};
use solaris_modes::{Hanging, SetupError};

const RATE: f64 = 60.0;

fn down() -> Vector3<f64> {
    Vector3::new(0.0, -9.80665, 0.0)
}

/// A block on rails, from which two rods hang.
fn crane() -> Figure {
    let rod = |name: &str, parent: &str, at: f64| {
        let joint = Joint::new(format!("{name}_joint")).rx().limited(-2.0, 2.0);
        let joint = joint.at(Vector3::new(0.0, at, 0.0));
        LinkSpec::child(name, parent, joint).mass(1.0).com(Vector3::new(0.0, -0.25, 0.0))
    };
    let block = LinkSpec::root("block", Joint::new("rails").tz().ty()).mass(5.0);
    let builder = FigureBuilder::new("crane").link(block).link(rod("upper", "block", 0.0));
    builder.link(rod("lower", "upper", -0.5)).build().expect("valid")
}

/// Energy (J) of a state.
fn energy(figure: &Figure, q: &[f64], v: &[f64]) -> f64 {
    let tree: Tree<f64> = Tree::new(figure, down()).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    kinetic_energy(&tree, &mut workspace, q, v).expect("a state")
        + potential_energy(&tree, &mut workspace, q).expect("a state")
}

#[test]
fn one_rod_swings_as_a_pendulum_does() {
    let figure = crane();
    let mut hanging = Hanging::new(&figure, down()).expect("a figure");
    hanging.set_damping(0.0).expect("none");
    // The lower rod stands still against the upper one: two points of 1 kg at 0.25 and 0.75 m.
    let (mut q, mut v) = ([0.0, 0.0, 0.05, 0.0], [0.0; 4]);
    hanging.loosen("upper_joint", &q, &v).expect("a joint");
    let rate = (9.80665_f64 * (0.25 + 0.75) / (0.25 * 0.25 + 0.75 * 0.75)).sqrt();
    for frame in 1..=600 {
        hanging.step(1.0 / RATE, &mut q, &mut v, &[0.0; 4]).expect("a frame");
        let t = f64::from(frame) / RATE;
        // Swings of 0.05 rad are slower by θ²/16.
        let expected = 0.05 * (rate * (1.0 - 0.05 * 0.05 / 16.0) * t).cos();
        assert!((q[2] - expected).abs() < 2e-3, "{t}: {} and {expected}", q[2]);
        assert_eq!((q[0], q[1], q[3]), (0.0, 0.0, 0.0));
    }
}

/// What has been tightened leaves nothing behind: the other rod moves as if it had hung alone from the beginning, to the bit.
#[test]
fn what_is_tightened_leaves_the_rest_as_if_it_had_never_hung() {
    let figure = crane();
    for (kept, other) in [("upper_joint", "lower_joint"), ("lower_joint", "upper_joint")] {
        let begin = ([0.0, 0.0, 0.7, 0.3], [0.0; 4]);
        let swung = |loose: &[&str], tight: Option<&str>| {
            let mut hanging = Hanging::new(&figure, down()).expect("a figure");
            let (mut q, mut v) = begin;
            for joint in loose {
                hanging.loosen(joint, &q, &v).expect("a joint");
            }
            if let Some(joint) = tight {
                hanging.tighten(joint).expect("a joint");
            }
            for _ in 0..120 {
                hanging.step(1.0 / RATE, &mut q, &mut v, &[0.0; 4]).expect("a frame");
            }
            q.map(f64::to_bits)
        };
        let alone = swung(&[kept], None);
        assert_eq!(swung(&[kept, other], Some(other)), alone, "{kept}");
        assert_ne!(swung(&[kept, other], None), alone);
    }
}

#[test]
fn energy_stays_without_damping_and_falls_with_it() {
    let figure = crane();
    for damping in [0.0, 0.5, 2.0] {
        let mut hanging = Hanging::new(&figure, down()).expect("a figure");
        hanging.set_damping(damping).expect("a rate");
        let (mut q, mut v) = ([0.0, 0.0, 0.7, 0.3], [0.0; 4]);
        hanging.loosen("upper_joint", &q, &v).expect("a joint");
        hanging.loosen("lower_joint", &q, &v).expect("a joint");
        let (rest, start) = (energy(&figure, &[0.0; 4], &[0.0; 4]), energy(&figure, &q, &v));
        let (mut least, mut off) = (start, 0.0_f64);
        for frame in 0..1200 {
            hanging.step(1.0 / RATE, &mut q, &mut v, &[0.0; 4]).expect("a frame");
            let now = energy(&figure, &q, &v);
            if damping == 0.0 {
                off = off.max((now - start).abs());
            } else {
                assert!(now < least + 0.01 * (start - rest), "{frame}: {now} after {least}");
                least = least.min(now);
            }
        }
        println!("damping {damping}: {:.4} of {:.2} J lost or won on the way", off, start - rest);
        assert!(off < 0.02 * (start - rest), "{off} of {start}");
        assert!(damping == 0.0 || least - rest < 0.02 * (start - rest), "{damping}: {least} of {rest}");
    }
}

#[test]
fn what_is_carried_along_leans_as_inertia_has_it() {
    // Speeding up with 3 m/s² a rod comes to hang back by atan(3/g).
    let figure = crane();
    let mut hanging = Hanging::new(&figure, down()).expect("a figure");
    hanging.set_damping(3.0).expect("a rate");
    let (mut q, mut v) = ([0.0; 4], [0.0; 4]);
    hanging.loosen("upper_joint", &q, &v).expect("a joint");
    for frame in 1..=900 {
        let t = f64::from(frame) / RATE;
        (q[0], v[0]) = (1.5 * t * t, 3.0 * t);
        hanging.step(1.0 / RATE, &mut q, &mut v, &[3.0, 0.0, 0.0, 0.0]).expect("a frame");
    }
    let expected = (3.0_f64 / 9.80665).atan();
    assert!((q[2].abs() - expected).abs() < 1e-3 && v[2].abs() < 1e-3, "{} and {expected}", q[2]);
}

#[test]
fn limits_hold_softly() {
    let figure = crane();
    let mut hanging = Hanging::new(&figure, down()).expect("a figure");
    let (mut q, mut v) = ([0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 0.0, 19.0]);
    hanging.loosen("upper_joint", &q, &v).expect("a joint");
    hanging.loosen("lower_joint", &q, &v).expect("a joint");
    let (mut most, mut last) = (0.0_f64, q[3]);
    for _ in 0..120 {
        hanging.step(1.0 / RATE, &mut q, &mut v, &[0.0; 4]).expect("a frame");
        most = most.max(q[3]);
        assert!((q[3] - last).abs() < 25.0 / RATE, "{last} to {}", q[3]);
        last = q[3];
    }
    assert!(most > 1.8 && most < 2.25, "{most}");
}

/// The smallest of generators (Knuth's multiplier).
struct Random(u64);

impl Random {
    fn within(&mut self, lower: f64, upper: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        lower + (upper - lower) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Somebody is thrown about by motions that nobody makes, arms, neck and head loose or not, from states in which axes coincide.
#[test]
fn nothing_is_ever_no_number_whatever_is_prescribed() {
    let figure = Human::new(1.75, 73.0).root(RootOrder::Yzx).build().expect("within range");
    let nv = figure.layout().nv();
    let joints = ["left_shoulder", "left_elbow", "left_wrist", "right_shoulder", "neck", "head", "left_hip"];
    let mut random = Random(11);
    let mut hanging = Hanging::new(&figure, down()).expect("a figure");
    let (mut q, mut v, mut a) = (vec![0.0; nv], vec![0.0; nv], vec![0.0; nv]);
    for frame in 0..6000 {
        // Locked shoulders, and velocities up to the violent.
        let wild = if frame % 500 < 20 { 1e4 } else { 5.0 };
        for k in 0..nv {
            q[k] = random.within(-1.6, 1.6);
            v[k] = random.within(-wild, wild);
            a[k] = random.within(-20.0 * wild, 20.0 * wild);
        }
        if frame % 37 == 0 {
            let joint = joints[(random.within(0.0, 7.0) as usize).min(6)];
            if random.within(0.0, 1.0) < 0.7 {
                let ry = figure.layout().dof_index(&format!("{joint}.ry")).expect("a dof");
                q[ry] = std::f64::consts::FRAC_PI_2;
                hanging.loosen(joint, &q, &v).expect("a joint");
            } else {
                hanging.tighten(joint).expect("a joint");
            }
        }
        let dt = random.within(1e-4, 0.1);
        hanging.step(dt, &mut q, &mut v, &a).expect("a frame");
        for dof in hanging.loose() {
            assert!(q[dof].is_finite() && v[dof].abs() <= 20.0, "{frame}, {dof}: {} {}", q[dof], v[dof]);
            assert!(q[dof].abs() < 4.0, "{frame}, {dof}: {}", q[dof]);
        }
    }
}

/// Pushed sideways for long, a pendulum hangs where weight and push are in balance: at the point of its mass, `tan θ = F/(m g)`.
#[test]
fn what_is_pushed_hangs_where_weight_and_push_are_in_balance() {
    let figure = crane();
    let mut hanging = Hanging::new(&figure, down()).expect("a figure");
    let (mut q, mut v) = ([0.0; 4], [0.0; 4]);
    hanging.loosen("lower_joint", &q, &v).expect("a joint");
    let force = Vector3::new(0.0, 0.0, 5.0);
    let mut settle = |hanging: &mut Hanging| {
        for _ in 0..1200 {
            let (sin, cos) = q[3].sin_cos();
            // Where its mass is: below the lower joint, which is half a metre below the rails.
            let at = Vector3::new(0.0, -0.5 - 0.25 * cos, -0.25 * sin);
            hanging.push(Some((2, Wrench::at(&at, force, Vector3::zeros())))).expect("a push");
            hanging.step(1.0 / RATE, &mut q, &mut v, &[0.0; 4]).expect("a frame");
        }
        q[3]
    };
    let angle = settle(&mut hanging);
    assert!((angle.tan() + 5.0 / 9.80665).abs() < 1e-3, "{angle}");
    for (link, wrench) in [
        (3, Wrench::zero()),
        (1, Wrench { force: Vector3::new(f64::NAN, 0.0, 0.0), moment: Vector3::zeros() }),
    ] {
        assert!(hanging.push(Some((link, wrench))).is_err());
    }
}

#[test]
fn what_is_no_frame_and_no_joint_is_refused_and_changes_nothing() {
    let figure = crane();
    let mut hanging = Hanging::new(&figure, down()).expect("a figure");
    let (mut q, mut v) = ([0.0, 0.0, 0.5, 0.0], [0.0; 4]);
    let error = hanging.loosen("uper_joint", &q, &v).expect_err("no joint").to_string();
    assert!(error.contains("upper_joint"), "{error}");
    hanging.loosen("upper_joint", &q, &v).expect("a joint");
    for dt in [0.0, -1.0, 2.0, f64::NAN] {
        assert!(hanging.step(dt, &mut q, &mut v, &[0.0; 4]).is_err());
    }
    assert!(hanging.step(0.01, &mut q, &mut v, &[0.0; 3]).is_err());
    assert!(hanging.step(0.01, &mut q, &mut v, &[f64::NAN, 0.0, 0.0, 0.0]).is_err());
    assert!(hanging.set_damping(-1.0).is_err());
    assert_eq!((q, v), ([0.0, 0.0, 0.5, 0.0], [0.0; 4]));
    let limp = Human::new(1.75, 73.0).limp().build().expect("within range");
    let mut other = Hanging::new(&limp, down()).expect("a figure");
    let (q, v) = (vec![0.0; limp.layout().nq()], vec![0.0; limp.layout().nv()]);
    let error = other.loosen("left_shoulder", &q, &v).expect_err("a ball joint");
    assert!(matches!(error, SetupError::NotLoose { .. }), "{error}");
}
