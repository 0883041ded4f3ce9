//! Motions to write: a moving human and small figures.

use solaris_model::{Contact, ContactTrack, Figure, Motion, MotionInfo, Trajectory, Vector3, human};
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
