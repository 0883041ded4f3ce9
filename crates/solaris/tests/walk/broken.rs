//! The judges can say no: every criterion is broken once, and found.

use crate::cases::{RATE, person, steps, walked};
use crate::criteria::{self, judge};
use crate::derivatives::{self, derivatives, stride};
use crate::newton::{self, newton};
use crate::torques::{self, Loaded, torques};
use crate::worst::Worst;
use solaris::gait::WalkPlan;
use solaris::model::{Figure, Motion, Vector3};

/// A good walk to be spoilt.
struct Good {
    figure: Figure,
    plan: WalkPlan,
    motion: Motion,
}

/// The columns of a motion.
struct Columns {
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    tau: Vec<f64>,
}

impl Good {
    fn new() -> Self {
        let figure = person(1.75);
        let (plan, motion) = walked(&figure, &steps(110.0, 10), RATE);
        assert!(judge(&figure, &plan, &motion).broken().is_empty());
        Self { figure, plan, motion }
    }

    /// Number of a coordinate at a sample in the columns.
    fn entry(&self, dof: &str, sample: usize) -> usize {
        sample * self.figure.layout().nv() + self.figure.layout().dof_index(dof).expect("a coordinate")
    }

    fn with_columns(&self, spoil: impl Fn(&mut Columns)) -> Motion {
        let old = &self.motion;
        let gather = |row: &dyn Fn(usize) -> Vec<f64>| (0..old.len()).flat_map(row).collect::<Vec<_>>();
        let mut columns = Columns {
            q: gather(&|i| old.q(i).to_vec()),
            v: gather(&|i| old.v(i).to_vec()),
            a: gather(&|i| old.a(i).to_vec()),
            tau: gather(&|i| old.tau(i).expect("forces").to_vec()),
        };
        spoil(&mut columns);
        let Columns { q, v, a, tau } = columns;
        let mut new =
            Motion::new(&self.figure, old.info.clone(), old.time().to_vec(), [q, v, a]).expect("finite");
        new.set_tau(tau).expect("finite");
        (new.events, new.planted) = (old.events.clone(), old.planted.clone());
        new.contacts.clone_from(&old.contacts);
        new
    }

    fn with(&self, spoil: impl Fn(&mut Motion)) -> Motion {
        let mut motion = self.motion.clone();
        spoil(&mut motion);
        motion
    }

    fn judged(&self, motion: &Motion) -> Worst {
        judge(&self.figure, &self.plan, motion)
    }

    /// A sample at which the left foot stands alone and flat, and the right knee bends: a fifth into a single support from the middle.
    fn single(&self) -> usize {
        let [left, right] =
            ["left_foot", "right_foot"].map(|foot| self.motion.contact(foot).expect("a track"));
        let alone = |i: &usize| left.samples[*i].force.y > 0.0 && right.samples[*i].force.y <= 0.0;
        let alone: Vec<usize> = (0..self.motion.len()).filter(alone).collect();
        let supports: Vec<&[usize]> = alone.chunk_by(|a, b| a + 1 == *b).collect();
        let support = supports[supports.len() / 2];
        support[support.len() / 5]
    }
}

fn assert_broken(worst: &Worst, criteria: &[&str]) {
    for criterion in criteria {
        assert!(worst.breaks(criterion), "'{criterion}' was not seen to break");
    }
}

#[test]
fn a_bent_knee_a_sunken_body_and_a_wrong_place_are_seen() {
    let good = Good::new();
    let sample = good.single();
    let knee = good.entry("left_knee.rx", sample);
    let bent = good.with_columns(|columns| columns.q[knee] += 1e-3);
    assert_broken(&good.judged(&bent), &[criteria::SLIDE, criteria::PRINTS]);
    let sunken = good.with_columns(|columns| columns.q[good.entry("root.ty", sample)] -= 2e-3);
    assert_broken(&good.judged(&sunken), &[criteria::SINK]);
    let end = good.entry("root.tz", good.motion.len() - 1);
    let further = good.with_columns(|columns| {
        columns.q[end] += 1e-3;
        columns.v[end] += 1e-3;
        columns.a[end] += 1e-2;
    });
    assert_broken(&good.judged(&further), &[criteria::FAR, criteria::REST, criteria::REST_A]);
    let turned = good.with_columns(|columns| columns.q[good.entry("root.ry", 0)] += 1e-3);
    assert_broken(&good.judged(&turned), &[criteria::FEET_APART]);
    let unplanted = good.with(|motion| motion.planted.clear());
    assert_broken(&good.judged(&unplanted), &[criteria::UNPLANTED, criteria::PRINTS]);
    let other = walked(&good.figure, &steps(109.0, 10), RATE).0;
    assert_broken(&judge(&good.figure, &other, &good.motion), &[criteria::PRINTS, criteria::FAR]);
}

#[test]
fn wrong_forces_are_seen() {
    let good = Good::new();
    let sample = good.single();
    let pulled = good.with(|motion| motion.contacts[0].samples[sample].force.y *= -1.0);
    assert_broken(&good.judged(&pulled), &[criteria::PULL, criteria::FOOT_PULL, criteria::IMPULSE]);
    let slipping = good.with(|motion| motion.contacts[0].samples[sample].force.x += 600.0);
    assert_broken(&good.judged(&slipping), &[criteria::FRICTION, criteria::FOOT_FRICTION]);
    let airborne = good.with(|motion| motion.contacts[1].samples[sample].force.y = 1e-9);
    assert_broken(&good.judged(&airborne), &[criteria::AIRBORNE]);
    let heavy = good.with(|motion| {
        motion.contacts.iter_mut().flat_map(|track| &mut track.samples).for_each(|c| c.force *= 1.02);
    });
    assert_broken(&good.judged(&heavy), &[criteria::MEAN, criteria::IMPULSE]);
    assert_broken(&newton(&good.figure, &heavy), &[newton::FORCE]);
    let twisted =
        good.with(|motion| motion.contacts[0].samples[sample].moment += Vector3::new(0.0, 1e-5, 0.0));
    assert_broken(&newton(&good.figure, &twisted), &[newton::MOMENT]);
    let lost = good.with(|motion| motion.contacts[0].samples[sample].moment.x = f64::NAN);
    assert_broken(&good.judged(&lost), &[criteria::NOT_FINITE]);
}

#[test]
fn wrong_derivatives_and_joint_forces_are_seen() {
    let good = Good::new();
    let (sample, step) = (good.single() / 7 * 7, stride(&good.plan, RATE));
    let knee = good.entry("right_knee.rx", sample);
    let fast = good.with_columns(|columns| columns.v[knee] *= 1.03);
    assert_broken(&derivatives(&good.figure, &fast, step), &[derivatives::VELOCITY, derivatives::SUM]);
    let jerky = good.with_columns(|columns| columns.a[knee] += 20.0);
    assert_broken(&derivatives(&good.figure, &jerky, step), &[derivatives::ACCELERATION, derivatives::SUM_A]);
    assert_broken(&newton(&good.figure, &jerky), &[newton::FORCE, newton::MOMENT]);
    let pushed = good.with_columns(|columns| columns.a[good.entry("root.ty", sample)] += 0.5);
    assert_broken(&derivatives(&good.figure, &pushed, step), &[derivatives::ROOT]);
    let strong = good.with_columns(|columns| columns.tau[knee] += 1e-5);
    assert_broken(&torques(&good.figure, &strong, 7, &mut Loaded::default()), &[torques::TAU]);
}
