//! What the limits of joints do: bounces, rest, release.

use approx::assert_abs_diff_eq;
use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
use solaris_modes::{
    Drive, EndCondition, LimitLaw, Method, OutcomeKind, Rule, Run, Settings, Simulation, Step,
};
use solaris_profiles::Profile;

const G: f64 = 9.81;

/// A block of 2 kg above a floor at height 0.
fn block(height: f64, velocity: f64) -> Simulation {
    let joint = Joint::new("slide").ty().limited(0.0, 100.0);
    let figure = FigureBuilder::new("block").link(LinkSpec::root("block", joint).mass(2.0));
    let mut simulation = Simulation::new(&figure.build().expect("valid"), Vector3::new(0.0, -G, 0.0));
    simulation.set_start(&[height], &[velocity]).expect("valid");
    simulation
}

fn settings(duration: f64) -> Settings {
    let method = Method::Fixed { rule: Rule::RungeKutta4, step: 0.01 };
    Settings { method, estimate: false, ..Settings::new(duration, 100.0) }
}

fn run(simulation: &Simulation, duration: f64) -> Run {
    simulation.run(&settings(duration)).expect("runs")
}

#[test]
fn a_block_bounces_at_the_times_and_heights_of_the_parabola() {
    // From 1 m with e = 0.7: the first fall takes √(2h/g), each flight 2·v/g, each bounce leaves 0.7 of v.
    let mut simulation = block(1.0, 0.0);
    simulation.set_limits(LimitLaw::Hard { restitution: 0.7 }).expect("valid");
    let found = run(&simulation, 2.0);
    let (mut time, mut speed) = ((2.0 / G).sqrt(), (2.0 * G).sqrt());
    let impacts = &found.report.impacts;
    assert_eq!(impacts.len(), 4);
    for impact in impacts {
        assert_abs_diff_eq!(impact.time, time, epsilon = 1e-12);
        assert_abs_diff_eq!(impact.velocity_before, -speed, epsilon = 1e-12);
        assert_abs_diff_eq!(impact.velocity_after, 0.7 * speed, epsilon = 1e-12);
        assert_abs_diff_eq!(impact.impulse, 2.0 * 1.7 * speed, epsilon = 1e-11);
        assert_abs_diff_eq!(impact.loss, 0.51 * speed * speed, epsilon = 1e-11);
        assert_eq!((impact.what, impact.dof), ("limit", 0));
        speed *= 0.7;
        time += 2.0 * speed / G;
    }
    for (frame, t) in found.motion.time().iter().enumerate() {
        let last = impacts.iter().rev().find(|impact| impact.time <= *t);
        let height = last.map_or(1.0 - 0.5 * G * t * t, |impact| {
            let s = t - impact.time;
            s * (impact.velocity_after - 0.5 * G * s)
        });
        assert_abs_diff_eq!(found.motion.q(frame)[0], height, epsilon = 1e-11);
    }
    assert!(found.report.energy.imbalance < 1e-10, "{:?}", found.report.energy);
}

#[test]
fn without_loss_it_bounces_for_ever_and_keeps_its_height() {
    let mut simulation = block(1.0, 0.0);
    simulation.set_limits(LimitLaw::Hard { restitution: 1.0 }).expect("valid");
    let found = run(&simulation, 100.0);
    let energy = |frame: usize| G * found.motion.q(frame)[0] + 0.5 * found.motion.v(frame)[0].powi(2);
    let worst = (0..found.motion.len()).map(|frame| (energy(frame) - G).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-9, "{worst:e}");
    // One bounce each 2·√(2h/g).
    assert_eq!(found.report.impacts.len(), 111);
}

#[test]
fn ever_shorter_bounces_end_at_rest() {
    // e = 0.5: all flights together take 2·v/g·(1/2 + 1/4 + …) = 2·v/g.
    let mut simulation = block(1.0, 0.0);
    simulation.set_limits(LimitLaw::Hard { restitution: 0.5 }).expect("valid");
    let found = run(&simulation, 2.0);
    let rest = 3.0 * (2.0 / G).sqrt();
    let last = found.report.impacts.last().expect("bounced");
    // A flight that rises less than 1e-9 m, at 1.4e-4 m/s, is none; with all after it that would be 6e-5 s.
    assert_abs_diff_eq!(last.time, rest, epsilon = 6e-5);
    assert!(found.report.impacts.len() < 30, "{}", found.report.impacts.len());
    for (frame, _) in found.motion.time().iter().enumerate().filter(|(_, t)| **t > rest + 1e-3) {
        assert_abs_diff_eq!(found.motion.q(frame)[0], 0.0, epsilon = 1e-12);
        assert_abs_diff_eq!(found.motion.v(frame)[0], 0.0, epsilon = 1e-12);
        assert_abs_diff_eq!(found.motion.a(frame)[0], 0.0, epsilon = 1e-9);
    }
    assert_eq!(found.report.outcomes[0].result, OutcomeKind::LimitHit);
}

#[test]
fn what_rests_is_released_when_the_drive_is_stronger_than_the_weight() {
    // The force rises by 40 N/s; the weight of 2·9.81 N is passed at 0.4905 s.
    let mut simulation = block(0.0, 0.0);
    let force = Profile::Line { from: 0.0, to: 80.0, duration: 2.0 };
    simulation.drive("slide", [Drive::Torque(force)]).expect("valid");
    let found = run(&simulation, 1.0);
    let release = 2.0 * G / 40.0;
    for (frame, t) in found.motion.time().iter().enumerate() {
        // m·v̇ = 40·(t − t₀): v = 10·(t − t₀)², x = 10/3·(t − t₀)³.
        let s = (t - release).max(0.0);
        assert_abs_diff_eq!(found.motion.v(frame)[0], 10.0 * s * s, epsilon = 1e-10);
        assert_abs_diff_eq!(found.motion.q(frame)[0], 10.0 / 3.0 * s * s * s, epsilon = 1e-10);
    }
    assert!(found.report.impacts.is_empty());
}

#[test]
fn what_rests_is_thrown_up_by_a_drive_that_begins_stronger_than_the_weight() {
    // Nothing for half a second, then 3·m·g.
    let mut simulation = block(0.0, 0.0);
    let force = |force| Drive::Torque(Profile::Line { from: force, to: force, duration: 0.5 });
    simulation.drive("slide", [force(0.0), force(6.0 * G)]).expect("valid");
    let found = run(&simulation, 0.9);
    assert_abs_diff_eq!(found.motion.q(50)[0], 0.0, epsilon = 1e-12);
    assert_abs_diff_eq!(found.motion.q(90)[0], G * 0.4 * 0.4, epsilon = 1e-10);
    assert_abs_diff_eq!(found.motion.v(90)[0], 2.0 * G * 0.4, epsilon = 1e-10);
}

#[test]
fn a_block_with_no_restitution_stays_where_it_fell() {
    let simulation = block(0.5, 1.0);
    let found = run(&simulation, 2.0);
    let hit = (1.0 + (1.0 + G).sqrt()) / G;
    assert_eq!(found.report.impacts.len(), 1);
    assert_abs_diff_eq!(found.report.impacts[0].time, hit, epsilon = 1e-12);
    assert_abs_diff_eq!(found.report.impacts[0].velocity_after, 0.0, epsilon = 0.0);
    assert_abs_diff_eq!(found.motion.q(200)[0], 0.0, epsilon = 1e-12);
}

#[test]
fn a_limit_that_is_ignored_is_fallen_through() {
    let mut simulation = block(1.0, 0.0);
    simulation.set_limits(LimitLaw::Ignore).expect("valid");
    let found = run(&simulation, 1.0);
    assert_abs_diff_eq!(found.motion.q(100)[0], 1.0 - 0.5 * G, epsilon = 1e-11);
    assert!(found.report.impacts.is_empty());
}

#[test]
fn a_soft_limit_throws_back_by_half_a_period_of_its_spring() {
    // Without gravity: at −1 m/s into k = 200 N/m, ω = 10 1/s; out again after π/ω, no deeper than 0.1 m.
    let joint = Joint::new("slide").ty().limited(0.0, 100.0);
    let figure = FigureBuilder::new("block").link(LinkSpec::root("block", joint).mass(2.0));
    let mut simulation = Simulation::new(&figure.build().expect("valid"), Vector3::zeros());
    simulation.set_start(&[0.5], &[-1.0]).expect("valid");
    simulation.set_limits(LimitLaw::Spring { stiffness: 200.0, damping: 0.0 }).expect("valid");
    let method = Method::Fixed { rule: Rule::RungeKutta4, step: 1e-3 };
    let found = simulation.run(&Settings { method, ..settings(1.5) }).expect("runs");
    for (frame, t) in found.motion.time().iter().enumerate() {
        let s = t - 0.5;
        let position = match s {
            s if s <= 0.0 => -s,
            s if s <= std::f64::consts::PI / 10.0 => -0.1 * (10.0 * s).sin(),
            s => s - std::f64::consts::PI / 10.0,
        };
        assert_abs_diff_eq!(found.motion.q(frame)[0], position, epsilon = 1e-9);
    }
}

#[test]
fn a_soft_limit_with_a_damper_is_entered_and_left_as_the_closed_form_says() {
    // At −1 m/s into k = 200 N/m, c = 8 N s/m: x = −v/ω·exp(−γs)·sin ωs with γ = c/2m and ω² = k/m − γ², until the damper
    // would pull, x″ = 0: tan ωs = 2γω/(γ² − ω²). From there on it flies.
    let joint = Joint::new("slide").ty().limited(0.0, 100.0);
    let figure = FigureBuilder::new("block").link(LinkSpec::root("block", joint).mass(2.0));
    let mut simulation = Simulation::new(&figure.build().expect("valid"), Vector3::zeros());
    simulation.set_start(&[0.5], &[-1.0]).expect("valid");
    simulation.set_limits(LimitLaw::Spring { stiffness: 200.0, damping: 8.0 }).expect("valid");
    let gamma = 2.0_f64;
    let omega = (100.0 - gamma * gamma).sqrt();
    let leaves = (2.0 * gamma * omega).atan2(gamma * gamma - omega * omega) / omega;
    let within = |s: f64| {
        let (decay, (sin, cos)) = ((-gamma * s).exp(), (omega * s).sin_cos());
        [-decay * sin / omega, -decay * (cos - gamma * sin / omega)]
    };
    let worst = |step: f64| {
        let method = Method::Fixed { rule: Rule::RungeKutta4, step };
        let settings = Settings { method, ..settings(1.2) };
        let found = simulation.run(&settings).expect("runs");
        let error = found.motion.time().iter().enumerate().map(|(frame, t)| {
            let s = t - 0.5;
            let expected = match s {
                s if s <= 0.0 => -s,
                s if s <= leaves => within(s)[0],
                s => within(leaves)[0] + (s - leaves) * within(leaves)[1],
            };
            (found.motion.q(frame)[0] - expected).abs()
        });
        error.fold(0.0, f64::max)
    };
    // Steps that do not end at the touch by chance.
    let (coarse, fine) = (worst(0.01 / 3.0), worst(0.01 / 9.0));
    assert!(fine < 1e-10, "{fine:e}");
    assert!(coarse > 50.0 * fine, "{coarse:e} and {fine:e}: order four divides by 81");
    // With gravity it comes to rest within: energy is accounted for.
    let figure = simulation.figure().clone();
    let mut heavy = Simulation::new(&figure, Vector3::new(0.0, -G, 0.0));
    heavy.set_start(&[0.5], &[-1.0]).expect("valid");
    heavy.set_limits(LimitLaw::Spring { stiffness: 200.0, damping: 8.0 }).expect("valid");
    let found = run(&heavy, 4.0);
    assert!(found.report.energy.imbalance < 1e-6 * found.report.energy.scale, "{:?}", found.report.energy);
}

/// Two blocks of 1 kg and 3 kg on a rail, the second's place told from the first, with a gap of 0 to 2 m.
fn pair(velocities: [f64; 2], restitution: f64) -> Run {
    let second = Joint::new("gap").tx().limited(0.0, 2.0);
    let figure = FigureBuilder::new("pair")
        .link(LinkSpec::root("first", Joint::new("rail").tx()).mass(1.0))
        .link(LinkSpec::child("second", "first", second).mass(3.0))
        .build()
        .expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    simulation.set_start(&[0.0, 1.0], &[velocities[0], velocities[1] - velocities[0]]).expect("valid");
    simulation.set_limits(LimitLaw::Hard { restitution }).expect("valid");
    run(&simulation, 1.0)
}

#[test]
fn a_collision_keeps_the_momentum() {
    // 2 m/s and 0 m/s meet after 0.5 s; the relative velocity turns round with e = 0.4.
    let found = pair([2.0, 0.0], 0.4);
    let after = [found.motion.v(100)[0], found.motion.v(100)[0] + found.motion.v(100)[1]];
    assert_abs_diff_eq!(found.report.impacts[0].time, 0.5, epsilon = 1e-12);
    assert_abs_diff_eq!(after[0] + 3.0 * after[1], 2.0, epsilon = 1e-12);
    assert_abs_diff_eq!(after[1] - after[0], 0.8, epsilon = 1e-12);
    // ½·μ·(1 − e²)·Δv² with μ = 3/4 kg.
    assert_abs_diff_eq!(found.report.impacts[0].loss, 0.5 * 0.75 * 0.84 * 4.0, epsilon = 1e-12);
}

#[test]
fn blocks_that_stick_together_go_on_together() {
    let found = pair([2.0, 0.0], 0.0);
    assert_abs_diff_eq!(found.motion.v(100)[0], 0.5, epsilon = 1e-12);
    assert_abs_diff_eq!(found.motion.v(100)[1], 0.0, epsilon = 1e-12);
    assert_abs_diff_eq!(found.motion.q(100)[1], 0.0, epsilon = 1e-12);
}

/// What begins to stand still while it moves, a latch, does so by an impulse: momentum is kept, and what is lost is ½·μ·Δv².
#[test]
fn what_latches_goes_on_with_the_momentum_of_both() {
    let figure = FigureBuilder::new("pair")
        .link(LinkSpec::root("first", Joint::new("rail").tx()).mass(1.0))
        .link(LinkSpec::child("second", "first", Joint::new("gap").tx()).mass(3.0))
        .build()
        .expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    simulation.set_start(&[0.0, 1.0], &[2.0, -2.0]).expect("valid");
    let drives: [Step; 2] = [
        Step { drive: Drive::Free, until: EndCondition::Time(0.25) },
        Step { drive: Drive::Frozen, until: EndCondition::Done },
    ];
    simulation.drive("rail.tx", [Drive::Free]).expect("valid");
    simulation.drive("gap.tx", drives).expect("valid");
    for (method, exact) in [
        (Method::Fixed { rule: Rule::RungeKutta4, step: 0.01 }, 1e-12),
        (Method::Adaptive { tolerance: 1e-9 }, 1e-12),
        (Method::Impulses { step: 1e-3 }, 1e-9),
    ] {
        let found = simulation.run(&Settings { method, ..settings(1.0) }).expect("runs");
        let last = found.motion.v(100);
        assert_abs_diff_eq!(last[0], 0.5, epsilon = exact);
        assert_abs_diff_eq!(last[1], 0.0, epsilon = exact);
        assert_abs_diff_eq!(found.motion.q(100)[1], 0.5, epsilon = 1e-9);
        let energy = &found.report.energy;
        assert_abs_diff_eq!(energy.impacts, 0.5 * 0.75 * 4.0, epsilon = 1e-9);
        assert!(energy.imbalance < 1e-9 * energy.scale, "{method:?}: {energy:?}");
    }
}

#[test]
fn a_row_of_resting_blocks_moves_off_one_after_the_other() {
    // Each at its least distance from the one before, gravity along the rail pressing them together; the first is pulled back
    // against the row by more and more, then let go: nothing passes a limit at any time.
    let mut builder = FigureBuilder::new("row");
    builder = builder.link(LinkSpec::root("b0", Joint::new("j0").ty().limited(0.0, 9.0)).mass(1.0));
    for k in 1..4 {
        let joint = Joint::new(format!("j{k}")).ty().limited(0.1, 9.0);
        builder = builder.link(LinkSpec::child(format!("b{k}"), format!("b{}", k - 1), joint).mass(1.0));
    }
    let mut simulation = Simulation::new(&builder.build().expect("valid"), Vector3::new(0.0, -G, 0.0));
    simulation.set_start(&[0.0, 0.1, 0.1, 0.1], &[3.0, 0.0, 0.0, 0.0]).expect("valid");
    simulation.set_limits(LimitLaw::Hard { restitution: 0.0 }).expect("valid");
    let found = run(&simulation, 1.5);
    for frame in 0..found.motion.len() {
        let q = found.motion.q(frame);
        assert!(q[0] >= -1e-12 && q[1..].iter().all(|gap| *gap >= 0.1 - 1e-12), "{frame}: {q:?}");
    }
    // Thrown up together at 3 m/s, they are together all the time and fall back at 2·v/g.
    assert_abs_diff_eq!(found.motion.q(30)[0], 0.3 * (3.0 - 0.5 * G * 0.3), epsilon = 1e-10);
    assert_abs_diff_eq!(found.motion.q(30)[1..], [0.1; 3][..], epsilon = 1e-10);
    assert_abs_diff_eq!(found.motion.q(150)[0], 0.0, epsilon = 1e-12);
}

#[test]
fn elastic_blocks_hand_their_velocity_through_a_row() {
    // Equal blocks that touch: the last one flies off with the velocity of the first, in one instant.
    let mut builder = FigureBuilder::new("cradle");
    builder = builder.link(LinkSpec::root("b0", Joint::new("j0").tx()).mass(1.0));
    for k in 1..5 {
        let joint = Joint::new(format!("j{k}")).tx().limited(0.1, 9.0);
        builder = builder.link(LinkSpec::child(format!("b{k}"), format!("b{}", k - 1), joint).mass(1.0));
    }
    let mut simulation = Simulation::new(&builder.build().expect("valid"), Vector3::zeros());
    simulation.set_start(&[0.0, 0.6, 0.1, 0.1, 0.1], &[2.0, -2.0, 0.0, 0.0, 0.0]).expect("valid");
    simulation.set_limits(LimitLaw::Hard { restitution: 1.0 }).expect("valid");
    let found = run(&simulation, 1.0);
    let mut v = 0.0;
    for (found, expected) in found.motion.v(100).iter().zip([0.0, 0.0, 0.0, 0.0, 2.0]) {
        v += found;
        assert_abs_diff_eq!(v, expected, epsilon = 1e-12);
    }
    assert_eq!(found.report.impacts.len(), 4);
    assert!(found.report.impacts.iter().all(|impact| (impact.time - 0.25).abs() < 1e-12));
}

#[test]
fn a_knee_that_snaps_straight_takes_the_thigh_along() {
    // Two rods with point masses swing freely; the lower hinge stops at 0. What the impact takes is all that is lost.
    let com = Vector3::new(0.0, -0.4, 0.0);
    let figure = FigureBuilder::new("leg")
        .link(LinkSpec::root("thigh", Joint::new("hip").rx()).mass(2.0).com(com))
        .link(
            LinkSpec::child("shank", "thigh", Joint::new("knee").rx().at(com).limited(0.0, 2.4))
                .mass(1.0)
                .com(com),
        )
        .build()
        .expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, -G, 0.0));
    simulation.set_start(&[-0.9, 1.4], &[0.0, 0.0]).expect("valid");
    let found = simulation.run(&Settings { rate: 1000.0, ..settings(1.5) }).expect("runs");
    let first = &found.report.impacts[0];
    assert_eq!(first.dof, 1);
    // M·Δv by hand: m₁l² + m₂·(2l)², coupling m₂·l·2l, m₂l² with the knee straight; no impulse on the hip.
    let l2 = 0.16;
    let jump = first.velocity_after - first.velocity_before;
    let (m11, m12, m22) = ((2.0 + 4.0) * l2, 2.0 * l2, l2);
    assert_abs_diff_eq!(first.impulse, (m22 - m12 * m12 / m11) * jump, epsilon = 1e-12);
    assert_abs_diff_eq!(first.loss, 0.5 * first.impulse * first.velocity_before.abs(), epsilon = 1e-12);
    assert!(found.motion.q(0).len() == 2 && found.motion.time().len() == 1501);
    let lowest = (0..found.motion.len()).map(|frame| found.motion.q(frame)[1]).fold(f64::MAX, f64::min);
    assert!(lowest >= -1e-9, "{lowest:e}");
    let energy = &found.report.energy;
    assert!(energy.imbalance < 1e-7, "{energy:?}");
    assert!(energy.impacts >= first.loss && first.loss > 0.01, "{energy:?}");
}

/// Springs without dampers take nothing, however often they are met, and are met at the same instants by all methods: a pendulum between two of them for a minute and a half, with
/// thousands of touches, of which each is located a rounding inside of the limit or outside of it.
#[test]
fn springs_without_dampers_push_at_every_touch() {
    let hinge = Joint::new("hinge").rx().limited(-0.3, 0.4);
    let rod = LinkSpec::root("rod", hinge).mass(1.0).com(Vector3::y() * -0.3);
    let figure = FigureBuilder::new("pendulum").link(rod).build().expect("valid");
    for stiffness in [50.0, 4000.0] {
        let mut simulation = Simulation::new(&figure, Vector3::y() * -9.81);
        simulation.set_start(&[0.0], &[4.0]).expect("valid");
        simulation.set_limits(LimitLaw::Spring { stiffness, damping: 0.0 }).expect("valid");
        for (method, lost) in [
            (Method::Adaptive { tolerance: 1e-6 }, 1e-2),
            (Method::Adaptive { tolerance: 1e-9 }, 1e-5),
            (Method::Fixed { rule: Rule::RungeKutta4, step: 1e-3 }, 2e-2),
        ] {
            let settings = Settings { method, estimate: false, ..Settings::new(90.0, 100.0) };
            let run = simulation.run(&settings).expect("runs");
            let out = (0..run.motion.len()).map(|k| {
                let q = run.motion.q(k)[0];
                (-0.3 - q).max(q - 0.4)
            });
            // From energy: ½·m·l²·ω² = ½·k·x² + m·g·l·(1 − cos q), x no more than without gravity.
            let deepest = 4.0 * 0.3 / f64::sqrt(stiffness);
            let out = out.fold(0.0, f64::max);
            assert!(out < deepest, "{stiffness} {method:?}: {out} m beyond, of {deepest}");
            assert!(run.report.cost.counts.events > 500, "{:?}", run.report.cost);
            assert!(run.report.energy.imbalance < lost * run.report.energy.scale, "{:?}", run.report.energy);
        }
    }
}
