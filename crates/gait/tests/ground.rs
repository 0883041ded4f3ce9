//! Ground forces found from planned walks alone, beside the plan's own.

use solaris_gait::{Extent, FEET, WalkPlan, WalkRequest, walk};
use solaris_model::{Figure, Motion, human};
use solaris_modes::ground::{
    GroundForces, GroundOptions, Split, Stances, ground_forces, soles, stances_of_planted,
};
use solaris_modes::{Completed, InverseOptions, ground_reactions, inverse_motion};

struct Walked {
    figure: Figure,
    motion: Motion,
    states: Completed,
    planted: Stances,
}

/// A walk with the plan's own forces in the motion.
fn walked(step_frequency: f64, steps: usize) -> Walked {
    let figure = human(1.75, 73.0).expect("a person");
    let request = WalkRequest {
        step_frequency: Some(step_frequency),
        extent: Extent::Steps(steps),
        ..WalkRequest::default()
    };
    let plan: WalkPlan = walk(&figure, &request).expect("a walk");
    let mut motion = plan.motion(&figure, 120.0).expect("a motion");
    ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
    let rows = |of: &dyn Fn(usize) -> Vec<f64>| (0..motion.len()).flat_map(of).collect::<Vec<_>>();
    let states = Completed {
        time: motion.time().to_vec(),
        q: rows(&|i| motion.q(i).to_vec()),
        v: rows(&|i| motion.v(i).to_vec()),
        a: rows(&|i| motion.a(i).to_vec()),
        ..Completed::default()
    };
    let planted = stances_of_planted(&soles(&figure), &motion.planted, 0.0);
    Walked { figure, motion, states, planted }
}

impl Walked {
    fn ground(&self, split: Split, stances: Option<Stances>) -> GroundForces {
        let options = GroundOptions { split, stances, ..GroundOptions::default() };
        let gravity = self.motion.info.gravity;
        ground_forces(&self.figure, gravity, &self.states, &soles(&self.figure), &options).expect("forces")
    }
}

/// Shown with `--nocapture`.
#[allow(clippy::print_stderr, reason = "numbers for who asks for them")]
fn say(text: &str) {
    eprintln!("{text}");
}

#[test]
fn look() {
    for frequency in [80.0, 95.0, 110.0, 120.0] {
        let walked = walked(frequency, 6);
        let found = walked.ground(Split::Pivot, None);
        say(&format!("{frequency}: belt {:?} level {:e}", found.stances.belt, found.stances.level));
        for (a, b) in found.stances.list.iter().zip(&walked.planted.list) {
            say(&format!(
                "  {} {:.1} {:.1} ms ({:.3} {:.3})",
                a.foot,
                1e3 * (a.start - b.start),
                1e3 * (a.end - b.end),
                b.start,
                b.end
            ));
        }
        assert_eq!(found.stances.list.len(), walked.planted.list.len());
        for split in Split::ALL {
            let ground = walked.ground(split, Some(walked.planted.clone()));
            let weight = ground.report.weight;
            let mut worst = [0.0_f64; 3];
            for (foot, link) in FEET.iter().enumerate() {
                let theirs = walked.motion.contact(link).expect("forces");
                for (a, b) in ground.contacts[foot].samples.iter().zip(&theirs.samples) {
                    for k in 0..3 {
                        worst[k] = worst[k].max((a.force - b.force)[k].abs() / weight);
                    }
                }
            }
            let report = &ground.report;
            say(&format!(
                "  {:<10} from the plan's {:.3?} of the weight; irregular {}",
                split.name(),
                worst,
                report.irregular
            ));
            for foot in &report.feet {
                say(&format!(
                    "     friction {:.3?} outside {:.4?} least {:.1?}",
                    foot.friction.map(|w| (w.value, w.time, w.share)),
                    foot.outside.map(|w| (w.value, w.time, w.share)),
                    foot.least.map(|w| (w.value, w.time, w.share))
                ));
            }
            let inverse = inverse_motion(
                &walked.figure,
                walked.motion.info.gravity,
                &walked.states,
                &ground.records(),
                InverseOptions::default(),
            )
            .expect("torques");
            say(&format!(
                "     residual {:.1e} N {:.1e} N m; unsupported {:?}",
                inverse.residual.force, inverse.residual.moment, report.unsupported
            ));
        }
    }
}
