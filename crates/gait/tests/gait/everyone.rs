//! Everyone walks: random people, populations, manners and seeds, held against Newton, soles, friction, ranges and planted points.

use crate::posed::Posed;
use crate::random::Random;
use solaris_analysis::ground_reactions;
use solaris_gait::{
    Change, Extent, FEET, FRICTION, MANNERS, Population, SHEET_NUMBERS, SIDE_MANNERS, StyleSheet,
    Variability, WALK_RATIO, WalkPlan, WalkRequest, manner, measure, sheet_of, side_sheet_of, walk,
    walk_in_part,
};
use solaris_model::{EventKind, Figure, Motion, Trajectory, Vector3, human};

fn person(height: f64, index: f64) -> Figure {
    human(height, index * height * height).expect("a person")
}

fn request(population: Population, sheet: StyleSheet, variability: Option<Variability>) -> WalkRequest {
    WalkRequest { population, sheet, variability, ..WalkRequest::default() }
}

/// Newton's law of the whole body by finite differences of the positions of its links: how far the ground's force is from mass times
/// acceleration less weight, over the weight: the greatest, and what 9 of 10 samples keep. Where a joint's rate jumps as a foot lands, as
/// it does in every walk, a difference over 4 ms is not an acceleration.
fn newton(figure: &Figure, plan: &WalkPlan, motion: &Motion) -> (f64, f64) {
    let mut posed = Posed::new(figure, plan);
    let mut com = |t: f64| {
        posed.pose(t);
        let links = figure.links().iter().enumerate();
        let sum = links.map(|(i, link)| posed.at(i, link.com()) * link.mass());
        sum.sum::<Vector3<f64>>() / figure.mass()
    };
    let (h, weight) = (2e-3, figure.mass() * 9.80665);
    let mut all = Vec::new();
    for sample in (30..motion.len() - 30).step_by(7) {
        let t = motion.time()[sample];
        let acceleration = (com(t - h) - com(t) * 2.0 + com(t + h)) / (h * h);
        let needed = (acceleration + Vector3::y() * 9.80665) * figure.mass();
        let ground: Vector3<f64> = motion.contacts.iter().map(|track| track.samples[sample].force).sum();
        all.push((needed - ground).norm() / weight);
    }
    all.sort_by(f64::total_cmp);
    (all[all.len() - 1], all[all.len() * 9 / 10])
}

#[test]
fn random_people_in_random_manners_obey_the_laws() {
    let mut random = Random(2027);
    let (mut parts, mut refused, mut newtons) = (Vec::new(), 0, (0.0, 0.0));
    for number in 0..48 {
        let population = Population::ALL[number % 4];
        let height =
            if population == Population::Child { random.within(1.1, 1.5) } else { random.within(1.5, 1.95) };
        let figure = person(height, random.within(18.5, 36.0));
        let blend = |random: &mut Random| manner(MANNERS[random.pick(MANNERS.len())].name).expect("it ships");
        let mut sheet = blend(&mut random).scaled(random.within(0.0, 1.0));
        sheet = sheet.plus(&blend(&mut random).scaled(random.within(0.0, 0.6)));
        let variability = Variability { scale: random.within(0.0, 1.2), seed: number as u64 };
        let tempo = population.tempo(height);
        let mut sides = [StyleSheet::default(), StyleSheet::default()];
        if number % 6 == 5 {
            let one = SIDE_MANNERS[random.pick(SIDE_MANNERS.len())].name;
            sides[random.pick(2)] = side_sheet_of(one).expect("it ships").scaled(random.next());
        }
        let asked = WalkRequest {
            step_frequency: (number % 3 > 0).then(|| tempo * random.within(75.0, 118.0)),
            extent: Extent::Steps(3 + random.pick(8)),
            left_first: number % 5 == 0,
            sides,
            ..request(population, sheet, (number % 4 != 1).then_some(variability))
        };
        let of = format!("{number}, {height:.3} m, {:.1} kg: {asked:?}", figure.mass());
        let (plan, part) = match walk_in_part(&figure, &asked) {
            Ok(walked) => walked,
            Err(error) => {
                println!("{error}; {of}");
                refused += 1;
                continue;
            }
        };
        parts.push(part);
        let rate = [120.0, 60.0, 240.0][number % 3];
        let mut motion = plan.motion(&figure, rate).expect("sampled");
        let report = ground_reactions(&figure, &mut motion, FEET, &plan)
            .unwrap_or_else(|error| panic!("{error}; {of}"));
        let prescribed = report.from_prescribed.expect("prescribed").value / plan.weight();
        let extremes = measure(&figure, &motion).expect("measured").extremes;
        assert!(prescribed < 0.15, "{prescribed}; {of}");
        let (worst, most) = newton(&figure, &plan, &motion);
        newtons = (worst.max(newtons.0), most.max(newtons.1));
        assert!(worst < 1.5 && most < 0.02, "{worst} {most}; {of}");
        assert!(extremes.friction.value <= FRICTION.0 && extremes.foot_friction.value <= FRICTION.1, "{of}");
        assert!(extremes.slide.value < 1e-9 && extremes.sink.value < 1e-4, "{of}");
        assert!(extremes.cop_outside.value < 1e-3, "{} m; {of}", extremes.cop_outside.value);
        assert!(extremes.clearance.value > 0.002 && extremes.least_knee.value > -0.0175, "{of}");
        for sample in 0..motion.len() {
            for beyond in figure.limit_excess(motion.q(sample)) {
                let name = &figure.layout().v_names()[beyond.dof];
                assert!(beyond.by.to_degrees() < 0.6, "{name} by {}°; {of}", beyond.by.to_degrees());
            }
        }
    }
    let whole = parts.iter().filter(|part| **part > 1.0 - 1e-12).count();
    println!(
        "{whole} of {} walked as asked, others in part: {parts:?}; {refused} refused; Newton {newtons:?}",
        parts.len()
    );
    assert!(refused <= 4 && whole * 10 > parts.len() * 7, "{whole} {refused}");
}

#[test]
fn every_manner_holds_on_an_average_person_and_shows() {
    let figure = person(1.75, 23.8);
    let plain = walk(&figure, &WalkRequest::default()).expect("a walk");
    for shipped in MANNERS {
        let sheet = manner(shipped.name).expect("it ships");
        let (plan, part) =
            walk_in_part(&figure, &request(Population::Adult, sheet.clone(), None)).expect("it walks");
        let why = walk(&figure, &request(Population::Adult, sheet.clone(), None)).err();
        println!(
            "{}: {part} of it holds{}",
            shipped.name,
            why.map_or(String::new(), |why| format!(": {why}"))
        );
        assert!(part > 0.9, "{}: {part}", shipped.name);
        let style = plan.style();
        let frequency = sheet.get("cadence").factor * part + 1.0 - part;
        assert!((style.step_frequency / plain.style().step_frequency - frequency).abs() < 1e-9);
        // A manner that is none at all changes nothing, to the bit.
        let none = walk(&figure, &request(Population::Adult, sheet.scaled(0.0), None)).expect("a walk");
        assert_eq!(none.style(), plain.style());
        let (mut a, mut b) = (vec![0.0; figure.layout().nq()], vec![0.0; figure.layout().nq()]);
        none.configuration(1.3, &mut a);
        plain.configuration(1.3, &mut b);
        assert_eq!(a, b);
    }
}

#[test]
fn step_lengths_are_those_of_the_population() {
    let figure = person(1.75, 23.8);
    let of = |population: Population, pace: [Option<f64>; 3]| {
        let [step_frequency, step_length, speed] = pace;
        let asked = WalkRequest {
            step_frequency,
            step_length,
            speed,
            ..request(population, StyleSheet::default(), None)
        };
        let style = *walk(&figure, &asked).expect("a walk").style();
        (style.step_frequency, style.step_length)
    };
    for population in Population::ALL {
        let ratio = population.walk_ratio(1.75) * 1.75;
        for pace in [
            [Some(100.0), None, None],
            [None, Some(ratio * 100.0), None],
            [None, None, Some(ratio * 1e4 / 60.0)],
        ] {
            let (frequency, length) = of(population, pace);
            assert!(
                (frequency - 100.0).abs() < 1e-9 && (length - 100.0 * ratio).abs() < 1e-12,
                "{population:?}"
            );
        }
    }
    let (frequency, length) = of(Population::Adult, [None; 3]);
    assert!((frequency - 110.0).abs() < 1e-12 && (length - 110.0 * WALK_RATIO * 1.75).abs() < 1e-12);
    // A small child's steps are quick and short, and such as no adult would be let take.
    let child = person(1.15, 16.0);
    let plan = walk(&child, &request(Population::Child, StyleSheet::default(), None)).expect("a child walks");
    let style = plan.style();
    assert!(
        (130.0..140.0).contains(&style.step_frequency) && (0.44..0.50).contains(&style.step_length),
        "{style:?}"
    );
}

#[test]
fn heavy_bodies_walk_wider_slower_and_longer_on_both_feet() {
    let of = |index: f64| *walk(&person(1.75, index), &WalkRequest::default()).expect("a walk").style();
    let usual = of(18.5);
    for index in [20.0, 22.0, 23.8, 25.0] {
        assert_eq!(of(index), usual, "nothing changes up to 25 kg/m²");
    }
    let mut before = usual;
    for index in [27.0, 30.0, 33.0, 35.0] {
        let style = of(index);
        assert!(
            style.step_width > before.step_width && style.step_frequency < before.step_frequency,
            "{index}"
        );
        assert!(style.double_support > before.double_support, "{index}");
        before = style;
    }
    assert!((before.step_width - usual.step_width - 0.035).abs() < 0.003, "{}", before.step_width);
}

/// Each step's length, time, width and toe-out from the planted feet alone.
fn steps_of(figure: &Figure, plan: &WalkPlan) -> Vec<[f64; 4]> {
    let mut posed = Posed::new(figure, plan);
    let mut landed = Vec::new();
    for event in plan.events() {
        if let EventKind::TouchDown { link } = &event.kind {
            // A little later the foot is flat.
            posed.pose(event.time + 0.17);
            let foot = figure.link_index(link).expect("a foot");
            let heel = posed.at(foot, &Vector3::zeros());
            let toward = posed.at(foot, &Vector3::z()) - heel;
            landed.push((event.time, heel, toward.x.atan2(toward.z)));
        }
    }
    landed
        .windows(2)
        .map(|w| [w[1].1.z - w[0].1.z, w[1].0 - w[0].0, (w[1].1.x - w[0].1.x).abs(), w[1].2])
        .collect()
}

#[test]
fn steps_differ_as_peoples_do() {
    let figure = person(1.75, 23.8);
    let mut all = [const { Vec::new() }; 3];
    for seed in 0..6 {
        let variability = Some(Variability { scale: 1.0, seed });
        let asked = WalkRequest {
            extent: Extent::Steps(26),
            ..request(Population::Adult, StyleSheet::default(), variability)
        };
        // Where a step asks too much of a joint, what is left of the differences is nearly all.
        let (plan, part) = walk_in_part(&figure, &asked).expect("a walk");
        assert!(part > 0.95, "{seed}: {part}");
        let steps = steps_of(&figure, &plan);
        for step in &steps[3..steps.len() - 4] {
            for (values, value) in all.iter_mut().zip(step) {
                values.push(*value);
            }
        }
    }
    let [length, time, width] = all.map(|values| {
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        let sd = (values.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / values.len() as f64).sqrt();
        (mean, sd)
    });
    println!("length {length:?}, time {time:?}, width {width:?}");
    assert!((0.015..0.04).contains(&(length.1 / length.0)) && (0.01..0.035).contains(&(time.1 / time.0)));
    assert!((0.012..0.024).contains(&width.1), "{width:?}");
}

#[test]
fn one_seed_is_one_walk_and_others_are_others() {
    let figure = person(1.7, 23.0);
    let of = |seed: u64, left_first: bool| {
        let variability = Some(Variability { scale: 1.0, seed });
        let asked =
            WalkRequest { left_first, ..request(Population::Adult, StyleSheet::default(), variability) };
        let plan = walk(&figure, &asked).expect("a walk");
        let mut all = Vec::new();
        for i in 0..40 {
            let mut q = vec![0.0; figure.layout().nq()];
            plan.configuration(0.2 * f64::from(i), &mut q);
            all.extend(q);
        }
        all
    };
    assert_eq!(of(3, false), of(3, false));
    assert_ne!(of(3, false), of(4, false));
    // Arms are no mirror images of each other any more.
    let plan = |scale: f64| {
        let variability = Some(Variability { scale, seed: 3 });
        walk(&figure, &request(Population::Adult, StyleSheet::default(), variability)).expect("a walk")
    };
    let swing = |plan: &WalkPlan, name: &str| {
        let k = figure.layout().q_names().iter().position(|q| q == name).expect("a coordinate");
        let angles: Vec<f64> = (0..200)
            .map(|i| {
                let mut q = vec![0.0; figure.layout().nq()];
                plan.configuration(2.0 + 0.02 * f64::from(i) * 0.55, &mut q);
                q[k]
            })
            .collect();
        angles.iter().fold(f64::MIN, |a, b| a.max(*b)) - angles.iter().fold(f64::MAX, |a, b| a.min(*b))
    };
    let (varied, even) = (plan(1.0), plan(0.0));
    let differ =
        |plan: &WalkPlan| (swing(plan, "left_shoulder.rx") / swing(plan, "right_shoulder.rx") - 1.0).abs();
    assert!(differ(&varied) > 0.01 && differ(&even) < 0.01, "{} {}", differ(&varied), differ(&even));
}

#[test]
fn a_distance_is_met_whatever_the_steps() {
    let figure = person(1.75, 23.8);
    for seed in 0..3 {
        let variability = Some(Variability { scale: 1.0, seed });
        let asked = WalkRequest {
            extent: Extent::Distance(5.0),
            ..request(Population::Adult, StyleSheet::default(), variability)
        };
        let plan = walk(&figure, &asked).expect("a walk");
        assert!((plan.prints().last().expect("prints") - 5.0).abs() < 1e-12);
        let (place, heading) = plan.destination();
        assert!((place - Vector3::z() * 5.0).norm() < 1e-12 && heading.abs() < 1e-12);
    }
}

#[test]
fn what_cannot_be_is_refused_with_how_much_of_it_holds() {
    let figure = person(1.75, 23.8);
    let change =
        |name: &'static str, factor: f64, add: f64| StyleSheet::default().with(name, Change { factor, add });
    let refusal = |sheet: StyleSheet| {
        walk(&figure, &request(Population::Adult, sheet, None)).err().expect("a refusal").to_string()
    };
    let arms = refusal(change("arm_swing", 3.0, 0.0));
    assert!(
        arms.contains("arm_swing") && arms.contains("0 to 45°") && arms.contains("of it holds"),
        "{arms}"
    );
    let unknown = refusal(change("arm_swnig", 3.0, 0.0));
    assert!(unknown.contains("arm_swnig") && unknown.contains("arm_swing"), "{unknown}");
    let nothing = refusal(change("bounce", f64::NAN, 0.0));
    assert!(nothing.contains("bounce"), "{nothing}");
    let much = Some(Variability { scale: 3.0, seed: 1 });
    let much =
        walk(&figure, &request(Population::Adult, StyleSheet::default(), much)).err().expect("a refusal");
    assert!(much.to_string().contains("0 to 2"), "{much}");
    assert!(sheet_of("sda").expect_err("a name").to_string().contains("did you mean 'sad'?"));
    // Whatever is changed alone, by much or little: a walk, or a refusal that says what.
    for number in SHEET_NUMBERS {
        for factor in [0.0, 0.5, 2.0, 5.0] {
            let asked = request(Population::Adult, change(number.name, factor, 0.0), None);
            let asked = WalkRequest { extent: Extent::Steps(2), ..asked };
            if let Err(error) = walk(&figure, &asked) {
                let said = error.to_string();
                assert!(!said.contains("NaN"), "{} {factor}: {said}", number.name);
            }
        }
    }
}

#[test]
fn one_side_differs_and_the_mean_pace_stays() {
    let figure = person(1.75, 23.8);
    let plain = walk(&figure, &WalkRequest::default()).expect("a walk");
    for shipped in SIDE_MANNERS {
        for side in 0..2 {
            let mut sides = [StyleSheet::default(), StyleSheet::default()];
            sides[side] = side_sheet_of(shipped.name).expect("it ships");
            let asked = WalkRequest { sides, extent: Extent::Steps(14), ..WalkRequest::default() };
            let (plan, part) = walk_in_part(&figure, &asked).expect("it walks");
            let why = walk(&figure, &asked).err();
            println!("{} {side}: {part} {}", shipped.name, why.map_or(String::new(), |why| why.to_string()));
            let mut motion = plan.motion(&figure, 120.0).expect("sampled");
            ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
            let extremes = measure(&figure, &motion).expect("measured").extremes;
            assert!(extremes.cop_outside.value < 2e-3 && extremes.slide.value < 1e-9, "{}", shipped.name);
            assert!(extremes.friction.value < FRICTION.0 && extremes.sink.value < 1e-4, "{}", shipped.name);
            let steps = steps_of(&figure, &plan);
            let middle = &steps[4..10];
            let mean = |which: usize, odd: usize| {
                let of = middle.iter().enumerate().filter(|(i, _)| i % 2 == odd).map(|(_, step)| step[which]);
                of.sum::<f64>() / 3.0
            };
            let [length, time] = [0, 1].map(|which| (mean(which, 0), mean(which, 1)));
            println!("  {length:?} m, {time:?} s");
            let style = plain.style();
            assert!((0.5 * (length.0 + length.1) / style.step_length - 1.0).abs() < 0.01, "{length:?}");
            assert!((0.5 * (time.0 + time.1) / (60.0 / style.step_frequency) - 1.0).abs() < 0.02, "{time:?}");
            if shipped.name == "limp" {
                assert!(
                    (length.0 / length.1 - 1.0).abs() > 0.05 * part
                        && (time.0 / time.1 - 1.0).abs() > 0.02 * part
                );
            }
        }
    }
}

/// The laws of treadmills and of older people, out of the data that they are from, where that is at hand.
#[test]
fn laws_are_those_of_the_thirty_people() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/spatiotemporal/h2a_treadmill.csv");
    let Ok(text) = std::fs::read_to_string(path) else {
        println!("skipped: there is no {path}");
        return;
    };
    let mut lines = text.lines().map(|line| line.split(',').map(str::trim).collect::<Vec<_>>());
    let heads = lines.next().expect("headings");
    let at = |name: &str| heads.iter().position(|head| *head == name).expect("a heading");
    let (group, height, length, cadence) = (at("AgeGroup"), at("Height"), at("StepLength"), at("Cadence"));
    let rows: Vec<(bool, f64)> = lines
        .filter(|row| row.len() == heads.len())
        .map(|row| {
            let number = |column: usize| row[column].parse::<f64>().expect("a number");
            (row[group] == "Older", number(length) / (number(height) * number(cadence)))
        })
        .collect();
    let mean = |which: &dyn Fn(bool) -> bool| {
        let some: Vec<f64> =
            rows.iter().filter(|(older, _)| which(*older)).map(|(_, ratio)| *ratio).collect();
        some.iter().sum::<f64>() / some.len() as f64
    };
    let (all, older, young) = (mean(&|_| true), mean(&|older| older), mean(&|older| !older));
    println!("{all} {older} {young}");
    assert_eq!(rows.len(), 180);
    assert!((all - Population::Treadmill.walk_ratio(1.75)).abs() < 5e-5);
    let law = Population::Older.walk_ratio(1.75) / Population::Adult.walk_ratio(1.75);
    assert!((older / young - law).abs() < 0.005);
}
