//! Motions to write: a moving human and small figures.

use solaris_model::{
    Contact, ContactTrack, EulerOrder, Figure, FigureBuilder, Joint, LinkSpec, Motion, MotionInfo,
    Trajectory, Vector3, human,
};
use std::io::{Error, Write};

/// Every coordinate swings with an amplitude, a frequency and a phase of its own about a middle that drifts.
pub(crate) struct Swing {
    pub(crate) nq: usize,
    /// Drift of every coordinate (1/s).
    pub(crate) drift: f64,
}

impl Trajectory for Swing {
    fn duration(&self) -> f64 {
        1.0
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        assert_eq!(q.len(), self.nq);
        for (i, q) in q.iter_mut().enumerate() {
            let i = i as f64;
            *q = self.drift * t + (0.3 + 0.01 * i) * ((2.0 + 0.1 * i) * t + i).sin();
        }
    }
}

pub(crate) fn info(figure: &Figure, rate: f64) -> MotionInfo {
    let gravity = Vector3::new(0.0, -9.80665, 0.0);
    MotionInfo { fingerprint: figure.fingerprint(), gravity, ground: None, rate }
}

pub(crate) fn swing(figure: &Figure, rate: f64, drift: f64) -> Motion {
    let trajectory = Swing { nq: figure.layout().nq(), drift };
    Motion::sample(figure, &trajectory, info(figure, rate)).expect("a finite motion")
}

/// A human that moves every joint, with forces and the contacts of both feet.
pub(crate) fn full_human() -> (Figure, Motion) {
    let figure = human(1.75, 73.0).expect("an ordinary human");
    let mut motion = swing(&figure, 30.0, 0.1);
    let tau = (0..motion.len() * figure.layout().nv()).map(|i| 100.0 * (i as f64).sin()).collect();
    motion.set_tau(tau).expect("nv a sample");
    motion.contacts = ["left_foot", "right_foot"].map(|link| track(link, motion.len())).to_vec();
    (figure, motion)
}

pub(crate) fn track(link: &str, samples: usize) -> ContactTrack {
    let vector = |i: usize| Vector3::new(i as f64, 1.0, 3.0).map(|x| (x / 7.0).exp() - 1.0);
    let contact = |i| Contact { force: vector(i), moment: -vector(i + 1), cop: vector(i) / 3.0 };
    ContactTrack { link: link.to_owned(), samples: (0..samples).map(contact).collect() }
}

/// A writer that is full after some bytes.
pub(crate) struct Full {
    pub(crate) left: usize,
}

impl Write for Full {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        if self.left == 0 && !bytes.is_empty() {
            return Err(Error::other("no space left"));
        }
        let taken = bytes.len().min(self.left);
        self.left -= taken;
        Ok(taken)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

/// A free root, a ball joint below it and a hinge below that.
pub(crate) fn thrown_figure() -> Figure {
    let at = |y: f64| Vector3::new(0.1, y, 0.2);
    FigureBuilder::new("thrown")
        .link(LinkSpec::root("trunk", Joint::free("root").at(at(0.9))).mass(9.0))
        .link(LinkSpec::child("arm", "trunk", Joint::ball("shoulder").at(at(0.3))).mass(2.0))
        .link(LinkSpec::child("hand", "arm", Joint::new("elbow").at(at(-0.3)).rx()).mass(1.0).tip(at(-0.2)))
        .build()
        .expect("valid")
}

/// The angles of the root and of the shoulder (rad, Z-Y-X) in a motion of [`thrown_figure`].
pub(crate) fn thrown_angles(t: f64) -> [[f64; 3]; 2] {
    [[7.0 * t, 0.4 * (3.0 * t).sin(), 0.3 - t], [0.5 * t, (2.0 * t).cos() - 0.2, -9.0 * t]]
}

/// Moves [`thrown_figure`] through more than a whole turn of root and arm.
pub(crate) fn thrown(rate: f64) -> (Figure, Motion) {
    struct Thrown;
    impl Trajectory for Thrown {
        fn duration(&self) -> f64 {
            1.0
        }

        fn configuration(&self, t: f64, q: &mut [f64]) {
            let [root, arm] = thrown_angles(t).map(|angles| EulerOrder::Zyx.rotation(&angles));
            q[..3].copy_from_slice(&[t, 3.0 * t - 4.9 * t * t, -0.3]);
            q[3..7].copy_from_slice(root.coords.as_slice());
            q[7..11].copy_from_slice(arm.coords.as_slice());
            q[11] = t.sin();
        }
    }
    let figure = thrown_figure();
    let motion = Motion::sample(&figure, &Thrown, info(&figure, rate)).expect("a finite motion");
    (figure, motion)
}
