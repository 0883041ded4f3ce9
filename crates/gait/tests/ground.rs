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
    for frequency in [80.0, 95.0, 110.0, 118.0] {
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
            let mut worst = [(0.0_f64, 0.0); 3];
            for (foot, link) in FEET.iter().enumerate() {
                let theirs = walked.motion.contact(link).expect("forces");
                for (a, b) in ground.contacts[foot].samples.iter().zip(&theirs.samples) {
                    for k in 0..3 {
                        let d = (a.force - b.force)[k].abs() / weight;
                        let t = ground.total
                            [ground.contacts[foot].samples.iter().position(|x| x == a).unwrap()]
                        .time;
                        let end = walked.states.time.last().unwrap();
                        if t > 1.2 * 110.0 / frequency && t < end - 1.7 * 110.0 / frequency && d > worst[k].0
                        {
                            worst[k] = (
                                d,
                                ground.total
                                    [ground.contacts[foot].samples.iter().position(|x| x == a).unwrap()]
                                .time,
                            )
                        }
                    }
                }
            }
            if frequency == 110.0 && split == Split::Pivot {
                for (i, frame) in ground
                    .total
                    .iter()
                    .enumerate()
                    .filter(|(i, f)| i % 4 == 0 && (f.time < 1.3 || f.time > 4.0))
                {
                    let f = |g: f64| g / weight;
                    say(&format!(
                        "   t {:.3} ours {:.3} theirs {:.3} L, ours {:.3} theirs {:.3} R cop L {:.3?} {:.3?}",
                        frame.time,
                        f(ground.contacts[0].samples[i].force.y),
                        f(walked.motion.contact(FEET[0]).unwrap().samples[i].force.y),
                        f(ground.contacts[1].samples[i].force.y),
                        f(walked.motion.contact(FEET[1]).unwrap().samples[i].force.y),
                        ground.contacts[0].samples[i].cop.as_slice(),
                        walked.motion.contact(FEET[0]).unwrap().samples[i].cop.as_slice()
                    ));
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

#[test]
fn grid() {
    let walks: Vec<Walked> = [70.0, 95.0, 110.0].iter().map(|f| walked(*f, 6)).collect();
    for height in [0.001, 0.003, 0.005, 0.01] {
        for speed in [0.03, 0.05, 0.1, 0.2] {
            let mut line = format!("h {height} v {speed}:");
            for walked in &walks {
                let stance = solaris_modes::ground::StanceOptions { height, speed, ..Default::default() };
                let found = solaris_modes::ground::find_stances(
                    &walked.figure,
                    walked.motion.info.gravity,
                    &walked.states,
                    &soles(&walked.figure),
                    &stance,
                )
                .unwrap();
                let n = found.list.len();
                if n != walked.planted.list.len() {
                    line += &format!("  {n} stances");
                    continue;
                }
                let (mut s, mut e) = (vec![], vec![]);
                for (a, b) in found.list.iter().zip(&walked.planted.list) {
                    s.push(1e3 * (a.start - b.start));
                    e.push(1e3 * (a.end - b.end));
                }
                let range = |x: &[f64]| {
                    (x.iter().copied().fold(0.0, f64::min), x.iter().copied().fold(0.0, f64::max))
                };
                line += &format!("  {:.0?} {:.0?}", range(&s), range(&e));
            }
            say(&line);
        }
    }
}
