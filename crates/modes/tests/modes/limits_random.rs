//! Chains and trees that nobody chose, falling into the limits of their joints.

use solaris_dynamics::{Tree, Workspace, kinetic_energy, potential_energy};
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, Vector3};
use solaris_modes::{Guard, LimitLaw, Method, Rule, Settings, Simulation};

/// `SplitMix64`.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / 9_007_199_254_740_992.0
    }

    fn between(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * self.next()
    }
}

/// A chain or a tree of three to nine rods on hinges, each with limits of its own, swinging in any plane.
fn figure(random: &mut Random) -> Figure {
    let links = 3 + (6.0 * random.next()) as usize;
    let tree = random.next() < 0.5;
    let mut builder = FigureBuilder::new("random");
    for i in 0..links {
        let axes = random.next();
        let joint = Joint::new(format!("j{i}"));
        let joint = if axes < 0.5 {
            joint.rx()
        } else if axes < 0.8 {
            joint.rz()
        } else {
            joint.ry()
        };
        let joint = joint.limited(-random.between(0.05, 2.0), random.between(0.05, 2.0));
        let (name, length) = (format!("l{i}"), random.between(0.1, 0.6));
        let parent = if tree { (random.next() * i as f64) as usize } else { i.saturating_sub(1) };
        let link = if i == 0 {
            LinkSpec::root(name, joint)
        } else {
            LinkSpec::child(name, format!("l{parent}"), joint.at(Vector3::new(0.0, -length, 0.0)))
        };
        // A rod of a finite thickness, so that it turns about its own length too.
        let (mass, across) = (random.between(0.2, 5.0), 0.03);
        let inertia = Inertia::diagonal(
            mass * (length * length + across * across) / 12.0,
            mass * across * across / 6.0,
            mass * (length * length + across * across) / 12.0,
        );
        builder = builder.link(link.mass(mass).com(Vector3::new(0.02, -0.5 * length, 0.01)).inertia(inertia));
    }
    builder.build().expect("valid")
}

#[test]
fn whatever_falls_into_its_limits_comes_to_an_end_and_gains_no_energy() {
    falls(0..60);
}

#[test]
#[ignore = "a thousand figures: cargo xtask nightly"]
fn a_thousand_figures_fall_into_their_limits() {
    falls(0..1000);
}

fn falls(scenes: std::ops::Range<u64>) {
    let count = scenes.end - scenes.start;
    let mut faults = Vec::new();
    for seed in scenes {
        let random = &mut Random(seed);
        let figure = figure(random);
        let gravity = Vector3::new(0.0, -9.81, 0.0);
        let mut simulation = Simulation::new(&figure, gravity);
        let restitution = [0.0, 0.3, 0.7][seed as usize % 3];
        simulation.set_limits(LimitLaw::Hard { restitution }).expect("valid");
        let q: Vec<f64> = (0..figure.layout().nv())
            .map(|dof| {
                let limits = figure.links()[dof].joint().kind().axes()[0].limits.expect("limited");
                random.between(limits.lower, limits.upper)
            })
            .collect();
        let v: Vec<f64> = (0..q.len()).map(|_| random.between(-3.0, 3.0)).collect();
        simulation.set_start(&q, &v).expect("valid");
        // Some thirty times as many evaluations as without limits.
        let guard = Guard { evaluations: 300_000, ..Guard::default() };
        let settings = |step| {
            let method = Method::Fixed { rule: Rule::RungeKutta4, step };
            Settings { method, estimate: false, guard, ..Settings::new(2.0, 100.0) }
        };
        let run = match simulation.run(&settings(1e-3)) {
            Ok(run) => run,
            Err(error) => {
                faults.push(format!("{seed} (e = {restitution}): {error}"));
                continue;
            }
        };
        let energy = &run.report.energy;
        let share = energy.imbalance / energy.scale;
        if share > 2e-5 {
            // Links that whirl: an error of the steps falls with them, another does not.
            let guard = Guard { evaluations: 3_000_000, ..guard };
            let finer = simulation.run(&Settings { guard, ..settings(1e-4) }).expect("runs");
            let finer = finer.report.energy.imbalance / finer.report.energy.scale;
            if finer > 1e-2 * share {
                faults.push(format!(
                    "{seed} (e = {restitution}): {share:e} of the energy, {finer:e} with finer steps"
                ));
            }
        }
        if run.report.impacts.iter().map(|impact| impact.loss).sum::<f64>() < -1e-12 * energy.scale {
            faults.push(format!("{seed} (e = {restitution}): impacts give energy"));
        }
        // Nothing drives anything: what a frame has no later one has more of, but by what the steps do to energy.
        let tree = Tree::<f64>::new(&figure, gravity).expect("a tree");
        let mut workspace = Workspace::new(&tree);
        let (mut least, mut grown) = (f64::INFINITY, 0.0_f64);
        for frame in 0..run.motion.len() {
            let (q, v) = (run.motion.q(frame), run.motion.v(frame));
            let kinetic = kinetic_energy(&tree, &mut workspace, q, v).expect("finite");
            let all = kinetic + potential_energy(&tree, &mut workspace, q).expect("finite");
            grown = grown.max(all - least);
            least = least.min(all);
        }
        if grown > 2.0 * energy.imbalance + 1e-12 * energy.scale {
            faults
                .push(format!("{seed} (e = {restitution}): the energy grows by {:e}", grown / energy.scale));
        }
        for frame in 0..run.motion.len() {
            let beyond = figure.limit_excess(run.motion.q(frame)).into_iter().map(|excess| excess.by);
            let beyond = beyond.fold(0.0, f64::max);
            if beyond > 1e-8 {
                faults.push(format!("{seed} (e = {restitution}): {beyond:e} beyond at frame {frame}"));
                break;
            }
        }
    }
    assert!(faults.is_empty(), "{} of {count}:\n{}", faults.len(), faults.join("\n"));
}
