//! Walks through key postures: what is planted stays, nothing sinks, every posture is met.

use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_gait::determinants::{Cycle, DoubleSupport, KeyPhase, Proportions, five};
use solaris_gait::{InBetween, KeyScript, KeyedOptions, KeyedWalk, ScriptCycle};
use solaris_model::{Figure, SolePart, Trajectory, Vector3, human};

fn script(figure: &Figure, step_frequency: f64, steps: usize) -> KeyScript {
    let p = Proportions::of(figure).expect("a person");
    let step_length = 0.004 * p.height * step_frequency;
    let parameters = five::FiveParameters::automatic(&p, step_frequency, step_length).expect("automatic");
    let angles = five::solve(&p, &parameters).expect("it closes");
    let upper = five::Upper::automatic(&angles, step_length * step_frequency / 60.0);
    let parts = five::Timing::DoubleSupport(DoubleSupport::Thesis).parts(&p, &angles, step_frequency);
    let cycle = |cycle: Cycle| {
        let phases: Vec<KeyPhase> = five::phases(&angles, &upper, cycle);
        let parts = phases.iter().map(|phase| parts[phase.number - 1]).collect();
        ScriptCycle { phases, parts }
    };
    KeyScript {
        cycles: [Cycle::Starting, Cycle::Intermediate, Cycle::Finishing].map(cycle),
        steps,
        step_length,
        step_time: 60.0 / step_frequency,
    }
}

/// A figure posed by a walk.
struct Stage<'a> {
    walk: &'a KeyedWalk,
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    q: Vec<f64>,
}

impl<'a> Stage<'a> {
    fn new(figure: &Figure, walk: &'a KeyedWalk) -> Self {
        let tree = Tree::<f64>::new(figure, Vector3::zeros()).expect("a tree");
        Self { walk, workspace: Workspace::new(&tree), tree, q: vec![0.0; figure.layout().nq()] }
    }

    fn pose(&mut self, t: f64) {
        self.walk.configuration(t, &mut self.q);
        forward_kinematics(&self.tree, &mut self.workspace, &self.q).expect("a configuration");
    }

    /// World position of a link's point.
    fn at(&self, link: usize, point: &Vector3<f64>) -> Vector3<f64> {
        self.workspace.pose(link).transform(point)
    }
}

#[test]
fn what_is_planted_stays_and_nothing_sinks() {
    for (height, mass) in [(1.75, 73.0), (1.2, 25.0), (2.0, 95.0)] {
        let figure = human(height, mass).expect("a person");
        for step_frequency in [80.0, 110.0, 125.0] {
            for in_between in [InBetween::Rest, InBetween::Linear] {
                let options = KeyedOptions { in_between, ..KeyedOptions::default() };
                let walk =
                    KeyedWalk::new(&figure, &script(&figure, step_frequency, 4), options).expect("a walk");
                let mut stage = Stage::new(&figure, &walk);
                for interval in walk.planted(&figure) {
                    stage.pose(interval.start);
                    let place = stage.at(interval.link, &interval.point);
                    for k in 0..=40 {
                        let t = interval.start + (interval.end - interval.start) * f64::from(k) / 40.0;
                        stage.pose(t);
                        let off = (stage.at(interval.link, &interval.point) - place).norm();
                        assert!(
                            off < 1e-6,
                            "{height} {step_frequency} {in_between:?} {interval:?} {t}: {off:e}"
                        );
                    }
                }
                let lowest = lowest(&figure, &walk);
                assert!(lowest.0 > -1e-6, "{height} {step_frequency} {in_between:?}: {lowest:?}");
            }
        }
    }
}

/// The lowest point of both soles over a walk (m), and when.
fn lowest(figure: &Figure, walk: &KeyedWalk) -> (f64, f64) {
    let frames = (walk.duration() * 400.0) as usize;
    let (mut lowest, mut stage) = ((f64::INFINITY, 0.0), Stage::new(figure, walk));
    for frame in 0..frames {
        let t = frame as f64 / 400.0;
        stage.pose(t);
        for name in ["left_foot", "right_foot", "left_toes", "right_toes"] {
            let link = figure.link_index(name).expect("a foot");
            for part in [SolePart::Heel, SolePart::Ball, SolePart::ToeTip] {
                let Some(&point) = figure.links()[link].sole_point(part) else { continue };
                let y = stage.at(link, &point).y;
                if y < lowest.0 {
                    lowest = (y, t);
                }
            }
        }
    }
    lowest
}
