//! Random people over all grounds, along all ways, in all manners: what is not refused obeys the laws, judged by code that knows
//! nothing of the plan but its request.

use crate::random::Random;
use nalgebra::Vector3;
use solaris_analysis::ground_reactions;
use solaris_gait::{
    Extent, FEET, FRICTION, GaitError, MANNERS, PARAMETERS, PlanError, Population, SIDE_MANNERS, Stairs,
    StyleSheet, Variability, WalkGround, WalkPart, WalkPath, WalkPlan, WalkRequest, manner, measure,
    side_sheet_of, walk_in_part,
};
use solaris_model::{Figure, Human, LimitExcess, Motion, Relief, RootOrder};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

const G: f64 = 9.80665;

/// What is asked of whom.
struct Asked {
    figure: Figure,
    height: f64,
    request: WalkRequest,
    /// On which ground, or along which way.
    over: &'static str,
}

impl Asked {
    /// The one of this number, the same in every run.
    fn of(number: u64) -> Self {
        let mut random = Random(number.wrapping_mul(0x2545_f491_4f6c_dd1d) ^ 0x1991);
        // The first numbers of neighbouring seeds are alike.
        for _ in 0..8 {
            random.next();
        }
        let population = Population::ALL[random.pick(4)];
        let height =
            if population == Population::Child { random.within(1.1, 1.5) } else { random.within(1.45, 2.0) };
        let mass = random.within(18.0, 35.0) * height * height;
        let figure = Human::new(height, mass).root(RootOrder::Yzx).build().expect("a person");
        let tempo = population.tempo(height);
        let step_frequency = random.often(0.7).then(|| tempo * random.within(62.0, 128.0));
        let mut request = WalkRequest {
            step_frequency,
            extent: Extent::Steps(3 + random.pick(9)),
            left_first: random.often(0.5),
            population,
            ..WalkRequest::default()
        };
        if random.often(0.3) {
            request.sheet = blend(&mut random);
        }
        let over = match random.pick(9) {
            0 | 1 => unevenly(&mut random, &mut request, number),
            2 => with_options(&mut random, &mut request),
            3 => with_changes(&mut random, &mut request, height),
            4 => round_a_bend(&mut random, &mut request),
            5 => along_a_path(&mut random, &mut request),
            6 => {
                request.ground = WalkGround::Slope(random.within(-15.0, 15.0).to_radians());
                "slope"
            }
            7 => on_stairs(&mut random, &mut request),
            _ => over_a_relief(&mut random, &mut request),
        };
        Self { figure, height, request, over }
    }

    /// The same backward; where that is not walked yet, without its path, its changes and its relief.
    fn backward(number: u64) -> Self {
        let asked = Self::of(number);
        let level = matches!(asked.request.ground, WalkGround::Relief(_));
        let ground = if level { WalkGround::Level } else { asked.request.ground.clone() };
        let request = WalkRequest { backward: true, path: None, then: Vec::new(), ground, ..asked.request };
        Self { request, ..asked }
    }
}

/// A manner and a part of another.
fn blend(random: &mut Random) -> StyleSheet {
    let mut one = |most: f64| {
        let sheet = manner(MANNERS[random.pick(MANNERS.len())].name).expect("it ships");
        sheet.scaled(random.within(0.0, most))
    };
    let first = one(1.0);
    first.plus(&one(0.5))
}

fn unevenly(random: &mut Random, request: &mut WalkRequest, seed: u64) -> &'static str {
    if random.often(0.6) {
        request.variability = Some(Variability { scale: random.within(0.0, 1.5), seed });
    }
    if random.often(0.4) {
        let one = SIDE_MANNERS[random.pick(SIDE_MANNERS.len())].name;
        request.sides[random.pick(2)] = side_sheet_of(one).expect("it ships").scaled(random.next());
    }
    "straight on"
}

fn with_options(random: &mut Random, request: &mut WalkRequest) -> &'static str {
    for _ in 0..=random.pick(3) {
        let parameter = &PARAMETERS[random.pick(PARAMETERS.len())];
        if request.parameters.iter().all(|(name, _)| *name != parameter.name) {
            let value = random.within(parameter.range.0, parameter.range.1);
            request.parameters.push((parameter.name, value));
        }
    }
    "with options"
}

fn with_changes(random: &mut Random, request: &mut WalkRequest, height: f64) -> &'static str {
    let tempo = request.population.tempo(height);
    let mut step_frequency = random.within(65.0, 115.0);
    request.step_frequency = Some(tempo * step_frequency);
    for _ in 0..=random.pick(3) {
        step_frequency = (step_frequency + random.within(-20.0, 20.0)).clamp(62.0, 125.0);
        request.then.push(WalkPart {
            steps: 1 + random.pick(4),
            step_frequency: Some(tempo * step_frequency),
            turn: if random.often(0.4) { random.within(-25.0, 25.0).to_radians() } else { 0.0 },
            ..WalkPart::default()
        });
    }
    "with changes"
}

fn round_a_bend(random: &mut Random, request: &mut WalkRequest) -> &'static str {
    request.turn = random.within(-25.0, 25.0).to_radians();
    request.step_frequency = Some(random.within(65.0, 110.0));
    request.population = Population::Adult;
    "round a bend"
}

fn along_a_path(random: &mut Random, request: &mut WalkRequest) -> &'static str {
    let (mut at, mut heading) = ([0.0, 0.0], 0.0);
    let points: Vec<[f64; 2]> = (0..=random.pick(4))
        .map(|_| {
            let length = random.within(0.8, 5.0);
            at = [at[0] + length * f64::sin(heading), at[1] + length * f64::cos(heading)];
            heading += random.within(-2.2, 2.2);
            at
        })
        .collect();
    request.path = Some(WalkPath::through(&points).expect("a path"));
    request.extent = Extent::Steps(10);
    request.step_frequency = Some(random.within(70.0, 110.0));
    request.population = Population::Adult;
    "along a path"
}

fn on_stairs(random: &mut Random, request: &mut WalkRequest) -> &'static str {
    let rise = random.within(0.10, 0.20);
    let (up, count) = (random.often(0.5), 1 + random.pick(8));
    let tread = random.within(0.25, 0.35);
    request.ground = WalkGround::Stairs(Stairs { count, rise: if up { rise } else { -rise }, tread });
    request.step_frequency = random.often(0.5).then(|| random.within(70.0, 110.0));
    if up { "stairs up" } else { "stairs down" }
}

/// Level ground, slopes and kerbs in any order.
fn over_a_relief(random: &mut Random, request: &mut WalkRequest) -> &'static str {
    let mut at = [random.within(1.2, 2.0), 0.0];
    let mut points = vec![at];
    for _ in 0..=random.pick(4) {
        match random.pick(3) {
            0 => at[1] += random.within(-0.12, 0.12),
            1 => {
                let length = random.within(1.0, 4.0);
                at = [at[0] + length, at[1] + length * random.within(-10.0, 10.0).to_radians().tan()];
            }
            _ => at[0] += random.within(0.8, 3.0),
        }
        points.push(at);
    }
    request.ground = WalkGround::Relief(Relief::new(points).expect("a relief"));
    request.step_frequency = random.often(0.7).then(|| random.within(75.0, 110.0));
    "relief"
}

/// What a walk does that no body can do; nothing if it keeps all laws.
fn faults(asked: &Asked, plan: &WalkPlan, motion: &mut Motion) -> Vec<String> {
    let Asked { figure, height, request, .. } = asked;
    let report = match ground_reactions(figure, motion, FEET, plan) {
        Ok(report) => report,
        Err(error) => return vec![format!("it has no forces: {error}")],
    };
    let found = measure(figure, motion).expect("measured").extremes;
    let weight = figure.mass() * G;
    let mut faults = Vec::new();
    let mut at_most = |what: &str, value: f64, limit: f64| {
        if value.is_nan() || value > limit {
            faults.push(format!("{what} {value:.4}, not within {limit}"));
        }
    };
    at_most("slides by (m)", found.slide.value, 1e-4);
    at_most("sinks by (m)", found.sink.value, 1e-3);
    at_most("is pressed beside a sole by (m)", found.cop_outside.value, 5e-3);
    at_most("hyperextends a knee by (°)", -found.least_knee.value.to_degrees(), 1.0);
    at_most("presses by (% of the weight)", found.vertical.value, 200.0);
    // What is left at the root is rounding, and the force is the law's but where a rate jumps between samples.
    at_most("leaves at the root (weights)", report.root_force / weight, 1e-8);
    let beside = report.from_prescribed.map_or(f64::NAN, |peak| peak.value / weight);
    at_most("needs another force than the law's (weights)", beside, 0.15);
    at_most("rubs by", friction(motion, weight), FRICTION.1 + 1e-3);
    if request.ground == WalkGround::Level {
        at_most("rubs with both feet by", found.friction.value, FRICTION.0 + 1e-3);
        at_most("trips: clears the ground by less than 2 mm (m)", 0.002 - found.clearance.value, 0.0);
    }
    let beyond = (0..motion.len()).flat_map(|sample| {
        let time = motion.time()[sample];
        let of = move |beyond: LimitExcess| (beyond.by.abs().to_degrees(), beyond.dof, time);
        figure.limit_excess(motion.q(sample)).into_iter().map(of)
    });
    if let Some((by, dof, time)) = beyond.max_by(|a, b| a.0.total_cmp(&b.0)) {
        let name = &figure.layout().v_names()[dof];
        // An ankle under a bent leg gives way farther, and so it does with options and in the first step at another pace.
        let is_plain = request.then.is_empty()
            && request.turn == 0.0
            && request.path.is_none()
            && request.parameters.is_empty();
        let limit = match (&request.ground, is_plain) {
            (WalkGround::Level, true) => 3.0,
            (WalkGround::Level, false) => 25.0,
            _ => 20.0,
        };
        at_most(&format!("has {name} beyond its range at {time:.2} s by (°)"), by, limit);
    }
    // Who is small is quick: rates go with √(g/H).
    at_most("turns a joint too fast (rad/s)", fastest(motion) / (1.75 / height).sqrt(), 40.0);
    faults
}

/// The greatest rate of a joint (rad/s), by differences of samples.
fn fastest(motion: &Motion) -> f64 {
    // Of the root's six coordinates three are m.
    let root = 6;
    let mut fastest = 0.0_f64;
    for sample in 1..motion.len() {
        let dt = motion.time()[sample] - motion.time()[sample - 1];
        let rates =
            motion.q(sample).iter().zip(motion.q(sample - 1)).skip(root).map(|(b, a)| (b - a).abs() / dt);
        fastest =
            rates.fold(fastest, |fastest, rate| if rate > fastest || rate.is_nan() { rate } else { fastest });
    }
    fastest
}

/// The greatest friction of a foot that bears more than 5 % of the weight, about the normal of what it stands on.
fn friction(motion: &Motion, weight: f64) -> f64 {
    let mut greatest = 0.0_f64;
    for contact in motion.contacts.iter().flat_map(|track| &track.samples) {
        if contact.force.y < 0.05 * weight {
            continue;
        }
        let free = contact.moment - contact.cop.cross(&contact.force);
        let normal = normal_under(motion, contact.cop.z, &free);
        let pressed = contact.force.dot(&normal);
        let friction = (contact.force - normal * pressed).norm() / pressed;
        if friction > greatest || friction.is_nan() {
            greatest = friction;
        }
    }
    greatest
}

/// The ground's normal at a place along z; under a sole that bridges a bend that of its free moment.
pub(crate) fn normal_under(motion: &Motion, z: f64, free: &Vector3<f64>) -> Vector3<f64> {
    let Some(relief) = &motion.relief else { return Vector3::y() };
    let slope = (relief.height(z + 1e-4) - relief.height(z - 1e-4)) / 2e-4;
    if slope.abs() < 0.3 {
        return Vector3::new(0.0, 1.0, -slope).normalize();
    }
    free.try_normalize(1e-9).map_or_else(Vector3::y, |normal| normal * normal.y.signum())
}

/// What became of requests over one ground.
#[derive(Default)]
struct Count {
    whole: usize,
    in_part: usize,
    refused: BTreeMap<String, usize>,
}

impl Count {
    fn all(&self) -> usize {
        self.whole + self.in_part + self.refused.values().sum::<usize>()
    }
}

/// Why a walk was refused, without its numbers.
fn kind(error: &GaitError) -> String {
    let GaitError::Plan(error) = error else {
        return format!("{error:?}").chars().take_while(|c| !"{ ".contains(*c)).collect();
    };
    let what = match error {
        PlanError::NotWalkable { what, .. }
        | PlanError::Options { what, .. }
        | PlanError::AbruptChange { what, .. }
        | PlanError::OnPath { what, .. }
        | PlanError::TooSteep { what, .. } => what.clone(),
        other => other.to_string(),
    };
    what.chars().filter(|c| !c.is_ascii_digit()).take(60).collect()
}

/// Requests of these numbers, on all cores: what became of them by ground, and the faults of walks that were planned.
fn walked(
    numbers: Range<u64>,
    asked: impl Fn(u64) -> Asked + Sync,
) -> (BTreeMap<&'static str, Count>, Vec<String>) {
    let next = AtomicU64::new(numbers.start);
    let found = Mutex::new((BTreeMap::<&'static str, Count>::new(), Vec::new()));
    let worker = || {
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= numbers.end {
                return;
            }
            let asked = asked(number);
            let Asked { figure, height, request, over } = &asked;
            let outcome = walk_in_part(figure, request);
            let wrong = outcome.as_ref().map_or_else(
                |error| {
                    let said = error.to_string();
                    if said.contains("NaN") { vec![format!("is refused by {said}")] } else { Vec::new() }
                },
                |(plan, _)| {
                    let level = request.ground == WalkGround::Level;
                    let rates = if level { [60.0, 120.0, 240.0] } else { [60.0, 240.0, 960.0] };
                    let rate = rates[number as usize % 3];
                    let mut motion = plan.motion(figure, rate).expect("sampled");
                    faults(&asked, plan, &mut motion)
                },
            );
            let (counts, all) = &mut *found.lock().expect("nobody panics");
            let count = counts.entry(over).or_default();
            match outcome {
                Ok((_, part)) if part < 1.0 => count.in_part += 1,
                Ok(_) => count.whole += 1,
                Err(error) => *count.refused.entry(kind(&error)).or_default() += 1,
            }
            if !wrong.is_empty() {
                let (wrong, mass) = (wrong.join("; "), figure.mass());
                all.push(format!("{wrong}; request {number}, {height:.3} m, {mass:.1} kg: {request:?}"));
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(worker);
        }
    });
    found.into_inner().expect("nobody panics")
}

/// Prints what became of them, and holds what was walked against the laws.
fn obey(numbers: Range<u64>, asked: impl Fn(u64) -> Asked + Sync) {
    let count = numbers.end - numbers.start;
    let (counts, faults) = walked(numbers, asked);
    for (over, count) in &counts {
        println!("{over}: {} asked, {} walked, {} in part", count.all(), count.whole, count.in_part);
        for (why, refused) in &count.refused {
            println!("  {refused} refused: {why}");
        }
    }
    for fault in &faults {
        println!("{fault}");
    }
    assert!(faults.is_empty(), "{} of {count} walks break a law", faults.len());
}

#[test]
fn whatever_is_walked_obeys() {
    obey(0..120, Asked::of);
}

#[test]
fn whatever_is_walked_backward_obeys() {
    obey(0..60, Asked::backward);
}

/// What a larger number found: with options it pressed 7.6 mm beside a sole between the samples that it was judged at.
#[test]
fn what_broke_a_law_once_obeys() {
    obey(103_037..103_038, Asked::of);
}

/// `cargo lab gaits --walks N --from M`: N of them in place of 3000, from another one than the first.
#[test]
#[ignore = "long: cargo xtask nightly"]
fn thousands_of_walks_obey() {
    let number = |name: &str, or: u64| {
        let said = std::env::var(name).ok();
        said.map_or(or, |n| n.parse().unwrap_or_else(|_| panic!("{name}={n}: it must be a whole number")))
    };
    let (count, from) = (number("SOLARIS_WALKS", 3000), number("SOLARIS_WALKS_FROM", 0));
    obey(from..from + count, Asked::of);
    obey(from..from + count / 5, Asked::backward);
}
