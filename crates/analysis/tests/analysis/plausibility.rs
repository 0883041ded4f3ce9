//! Plates, angles and residuals that do not fit, on the project's subject and on a measured one.

use crate::pinned::{file, say};
use solaris_analysis::ground::{PlacedFeet, Sole, Stance, StanceOptions, find_stances, guessed_soles, soles};
use solaris_analysis::plausibility::{
    FarCause, MotionFinding, PlateReport, ResidualCheck, check_angles, check_plates, check_residual,
    soles_of_plates,
};
use solaris_analysis::{Filter, InverseOptions, Loads, PreparedMotion, differentiate, inverse_motion};
use solaris_io::{Import, Table, opensim, record, sto};
use solaris_model::{Contact, Figure, Link, MeasuredForce, Motion, MotionInfo, Vector3, human};

/// A figure, its motion and the plates under its feet.
struct Trial {
    name: &'static str,
    import: Import,
    motion: Table,
    plates: Vec<MeasuredForce>,
    soles: Vec<Sole>,
    /// What its motion is filtered with (Hz).
    cutoff: f64,
}

/// The project's subject, and the measured ones where they are at hand.
fn trials() -> Vec<Trial> {
    let own = |name: &str| {
        let path = format!("{}/../../fixtures/subject/{name}", env!("CARGO_MANIFEST_DIR"));
        std::fs::read_to_string(path).expect("a fixture")
    };
    let trial = |name, model: &str, motion: &str, (plates, sides): (&str, [&str; 2]), cutoff| {
        let plates = sto::read(plates).expect("a table");
        let import = opensim::read(model).expect("a model");
        let plate = |body: &str, prefix| {
            let (link, _) = import.figure.locate(body).expect("a foot");
            let link = import.figure.links()[link].name().to_owned();
            record::forces(&plates, &[link], prefix).expect("its columns")
        };
        let plates = vec![plate("calcn_r", sides[0]), plate("calcn_l", sides[1])];
        let soles = match guessed_soles(&import.figure) {
            none if none.is_empty() => soles_of_plates(&import.figure, &plates),
            soles => soles,
        };
        Trial { name, motion: sto::read(motion).expect("a table"), plates, soles, import, cutoff }
    };
    let grf = own("grf.mot");
    let mut trials = vec![trial("project", &own("subject.osim"), &own("walk.mot"), (&grf, ["", "1_"]), 6.0)];
    let mut measured = |name, files: [&str; 3], sides, cutoff| {
        if let [Some(model), Some(motion), Some(plates)] = files.map(file) {
            trials.push(trial(name, &model, &motion, (&plates, sides), cutoff));
        }
    };
    let walk = ["gait10dof18musc_subject01.osim", "subject01_walk_ik_planar10.mot", "subject01_walk_grf.mot"];
    measured("walks", walk, ["", "1_"], 6.0);
    let run = ["opensim46/subject_scaled_run.osim", "opensim46/ik_output_run.mot", "inputs/grf_run.mot"];
    let run = run.map(|name| format!("../markers/rajagopal_run/{name}"));
    measured("runs", run.each_ref().map(String::as_str), ["R", "L"], 15.0);
    trials
}

impl Trial {
    fn check(&self) -> (PlateReport, ResidualCheck, Option<MotionFinding>) {
        self.check_with(|_| ())
    }

    /// With stances that are changed after they were found.
    fn check_with(
        &self,
        change: impl Fn(&mut Stance),
    ) -> (PlateReport, ResidualCheck, Option<MotionFinding>) {
        let Import { figure, gravity, .. } = &self.import;
        let recorded = record::read(figure, *gravity, &self.motion).expect("a motion").motion;
        let filter = Some(Filter { cutoff: self.cutoff, order: 3 });
        let found = differentiate(figure, &recorded, filter).expect("differentiated");
        let (motion, unsettled) = (found.motion, found.unsettled);
        let prepared = PreparedMotion::new(figure, &motion).expect("ready");
        let feet = PlacedFeet::new(&prepared, &*self.soles).expect("placed");
        let mut stances = find_stances(&feet, &StanceOptions::default()).expect("stances");
        stances.list.iter_mut().for_each(change);
        let report = check_plates(&prepared, Some((&feet, &stances)), &self.plates).expect("checked");
        let loads = Loads::at_times(figure, &self.plates, motion.time()).expect("loads");
        let forces = inverse_motion(&prepared, &loads, InverseOptions::default()).expect("forces");
        let residual = check_residual(&prepared, &forces, &self.plates, stances.level, unsettled);
        let residual = residual.expect("checked").expect("forces");
        let angles = check_angles(figure, &motion, self.motion.in_degrees);
        say(&format!(
            "{}: borne {:?} in {} frames, {:.3?}",
            self.name, report.borne, report.complete, report.plates
        ));
        report.findings.iter().for_each(|finding| say(&format!("    {finding}")));
        say(&format!("    {residual:.2?} {}", residual.cause()));
        (report, residual, angles)
    }

    fn findings(&self) -> Vec<MotionFinding> {
        self.check().0.findings
    }

    /// Gives each plate to the other foot.
    fn swap(&mut self) {
        let links: Vec<_> = self.plates.iter().rev().map(|plate| plate.links.clone()).collect();
        self.plates.iter_mut().zip(links).for_each(|(plate, links)| plate.links = links);
    }
}

/// A person who stands still for half a second, this much (m) above where the root is at zero.
fn standing(lifted: f64) -> (Figure, Motion) {
    let figure = human(1.75, 73.0).expect("a person");
    let (nv, frames) = (figure.layout().nv(), 51);
    let mut q = vec![0.0; frames * figure.layout().nq()];
    let height = figure.layout().dof_index("root.ty").expect("a free root");
    q.iter_mut().skip(height).step_by(figure.layout().nq()).for_each(|height| *height = lifted);
    let time = (0..frames).map(|i| i as f64 / 100.0).collect();
    let still = vec![0.0; frames * nv];
    let motion = Motion::new(&figure, MotionInfo::on_earth(&figure, 100.0), time, [q, still.clone(), still])
        .expect("a motion");
    (figure, motion)
}

/// A force straight up (N) on a link, by frame at a point (m) or not at all.
fn upward(link: &str, time: &[f64], force: f64, at: impl Fn(usize) -> Option<Vector3<f64>>) -> MeasuredForce {
    let force = Vector3::y() * force;
    let sample = |frame| {
        at(frame).map_or_else(Contact::default, |cop| Contact { force, moment: cop.cross(&force), cop })
    };
    let samples = (0..time.len()).map(sample).collect();
    MeasuredForce { links: vec![link.to_owned()], ball_and_tip: None, time: time.to_vec(), samples }
}

/// Who stands on a stage stands higher by as much.
#[test]
fn the_ground_is_as_high_as_the_feet_stand() {
    let level = |lifted: f64| {
        let (figure, motion) = standing(lifted);
        let mass: f64 = figure.links().iter().map(Link::mass).sum();
        let prepared = PreparedMotion::new(&figure, &motion).expect("ready");
        let feet = PlacedFeet::new(&prepared, soles(&figure)).expect("placed");
        let stances = find_stances(&feet, &StanceOptions::default()).expect("stances");
        let plate = |foot: usize| {
            let [heel, _, tip] = feet.frame(0)[foot].points;
            let weight = mass * motion.info.gravity.norm() / 2.0;
            upward(&feet.soles()[foot].name, motion.time(), weight, |_| Some((heel + tip) * 0.5))
        };
        let report =
            check_plates(&prepared, Some((&feet, &stances)), &[plate(0), plate(1)]).expect("checked");
        assert_eq!((report.findings, report.complete), (Vec::new(), 51));
        assert!((report.borne.expect("frames") - 1.0).abs() < 1e-9);
        assert!((report.level - feet.frame(0)[0].points[0].y).abs() < 1e-9, "{}", report.level);
        report.level
    };
    assert!((level(2.0) - level(0.5) - 1.5).abs() < 1e-12);
}

/// One plate is 3 cm beside its foot's edge, 7 cm in one frame, and bears for 40 frames; one is under its foot; one never bears; and
/// one is pressed by a link that has no sole.
#[test]
fn each_plate_is_told_with_its_foot_and_how_far_it_is_from_it() {
    let (figure, motion) = standing(0.0);
    let prepared = PreparedMotion::new(&figure, &motion).expect("ready");
    let feet = PlacedFeet::new(&prepared, soles(&figure)).expect("placed");
    let stances = find_stances(&feet, &StanceOptions::default()).expect("stances");
    let middle = |foot: usize| {
        let [heel, _, tip] = feet.frame(0)[foot].points;
        (heel + tip) * 0.5
    };
    let [heel, _, tip] = feet.frame(0)[0].points;
    let side = Vector3::y().cross(&(tip - heel)).normalize();
    let edge = 0.5 * feet.soles()[0].width.expect("a breadth");
    let beside = |frame: usize| {
        let far = if frame == 20 { 0.07 } else { 0.03 };
        (frame < 40).then(|| middle(0) + side * (edge + far))
    };
    let (left, right) = (&*feet.soles()[0].name, &*feet.soles()[1].name);
    let trunk = figure.links()[0].name();
    let time = motion.time();
    let plates = [
        upward(left, time, 350.0, beside),
        upward(right, time, 350.0, |_| Some(middle(1))),
        upward(right, time, 350.0, |_| None),
        upward(trunk, time, 350.0, |_| Some(Vector3::zeros())),
    ];
    let report = check_plates(&prepared, Some((&feet, &stances)), &plates).expect("checked");
    let told: Vec<(&str, usize)> = report.plates.iter().map(|plate| (&*plate.foot, plate.loaded)).collect();
    assert_eq!(told, [(left, 40), (right, 51), (right, 0), (trunk, 51)]);
    let [first, under, never, pressed] = &report.plates[..] else { unreachable!("four were told") };
    assert!((first.mean_distance.expect("it bears") - 0.031).abs() < 1e-9, "{first:?}");
    let (greatest, when) = first.greatest_distance.expect("it bears");
    assert!((greatest - 0.07).abs() < 1e-9 && (when - 0.2).abs() < 1e-12, "{first:?}");
    assert_eq!((under.mean_distance, under.greatest_distance.map(|(far, _)| far)), (Some(0.0), Some(0.0)));
    for plate in [never, pressed] {
        assert_eq!((plate.mean_distance, plate.greatest_distance), (None, None), "{plate:?}");
    }
}

/// What is told beside a finding: its value, past its threshold, in its unit.
#[test]
fn a_finding_tells_its_value_beside_its_threshold() {
    let small = MotionFinding::RadiansAsDegrees { greatest: 1.2 };
    assert_eq!((small.value_and_threshold(), small.unit()), ((1.2, 2.5), "°"));
    for mut trial in trials() {
        trial.swap();
        for found in trial.findings() {
            let (value, threshold) = found.value_and_threshold();
            assert!(value > threshold && threshold > 0.0, "{}: {found}: {value}, {threshold}", trial.name);
        }
    }
}

#[test]
fn right_plates_raise_nothing() {
    for trial in trials() {
        let (report, residual, angles) = trial.check();
        assert_eq!(report.findings, [], "{}", trial.name);
        assert_eq!(angles, None, "{}", trial.name);
        assert!((report.borne.expect("frames") - 1.0).abs() < 0.03 && report.complete > 50, "{report:?}");
        assert!(!residual.cause().contains("another"), "{residual:?}");
    }
}

/// As of who lands and leaves fast: feet that are found late and lost early over their own force were said to swing.
#[test]
fn stances_that_are_found_short_are_no_swings() {
    for mut trial in trials() {
        let found = trial.check_with(shorten).0.findings;
        assert_eq!(found, [], "{}", trial.name);
        trial.swap();
        let found = trial.check_with(shorten).0.findings;
        assert!(found.iter().filter(is_swap).count() == 2, "{}: {found:?}", trial.name);
    }
}

/// By a sixth of it at either end, which is more than a foot may swing of the frames in which it bears.
fn shorten(stance: &mut Stance) {
    let by = (stance.end - stance.start) / 6.0;
    *stance = Stance { start: stance.start + by, end: stance.end - by, ..*stance };
}

#[test]
fn swapped_feet_are_named_as_such() {
    for mut trial in trials() {
        trial.swap();
        let found = trial.findings();
        assert!(found.iter().filter(is_swap).count() == 2, "{}: {found:?}", trial.name);
    }
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "a filter's argument")]
fn is_swap(finding: &&MotionFinding) -> bool {
    matches!(
        finding,
        MotionFinding::Far { cause: FarCause::Swapped { .. }, .. }
            | MotionFinding::Airborne { cause: FarCause::Swapped { .. }, .. }
    )
}

/// The same plates a third of a stride later: feet stand where nothing bears.
#[test]
fn plates_of_another_time_are_caught() {
    for mut trial in trials() {
        for plate in &mut trial.plates {
            let by = plate.samples.len() / 7;
            plate.samples.rotate_left(by);
        }
        let (report, residual, _) = trial.check();
        assert!(report.findings.len() >= 2, "{}: {:?}", trial.name, report.findings);
        assert!(!residual.is_met() && residual.cause().contains("another trial"), "{residual:?}");
    }
}

/// Another trial of the same body: faster, and elsewhere on the ground.
#[test]
fn plates_of_another_trial_are_caught() {
    for mut trial in trials() {
        for plate in &mut trial.plates {
            let begin = plate.time[0];
            plate.time.iter_mut().for_each(|time| *time = begin + (*time - begin) * 1.25);
        }
        let found = trial.findings();
        let is_other = |finding: &MotionFinding| {
            matches!(finding, MotionFinding::Airborne { .. } | MotionFinding::Far { .. })
        };
        assert!(found.iter().any(is_other), "{}: {found:?}", trial.name);
    }
}

/// A lab whose origin is elsewhere.
#[test]
fn a_shifted_origin_is_named_as_such() {
    for mut trial in trials() {
        let by = Vector3::new(0.3, 0.0, 0.1);
        for contact in trial.plates.iter_mut().flat_map(|plate| &mut plate.samples) {
            contact.cop += by;
            contact.moment += by.cross(&contact.force);
        }
        let found = trial.findings();
        let shifted = |finding: &MotionFinding| matches!(finding, MotionFinding::Far { cause: FarCause::Shifted { by }, .. } if by[0] > 0.15);
        assert!(found.iter().any(shifted), "{}: {found:?}", trial.name);
    }
}

#[test]
fn plates_of_another_body_are_weighed() {
    for mut trial in trials() {
        for contact in trial.plates.iter_mut().flat_map(|plate| &mut plate.samples) {
            contact.force *= 1.2;
            contact.moment *= 1.2;
        }
        let found = trial.findings();
        let heavy = |finding: &MotionFinding| matches!(finding, MotionFinding::Mass { borne, .. } if (borne - 1.2).abs() < 0.03);
        assert!(found.iter().any(heavy), "{}: {found:?}", trial.name);
    }
}

#[test]
fn units_and_signs_of_forces_are_named() {
    for (factor, word) in [(1e-3, "kN"), (-1.0, "signs"), (1.0 / 9.81, "kg instead of N")] {
        for mut trial in trials() {
            for contact in trial.plates.iter_mut().flat_map(|plate| &mut plate.samples) {
                contact.force *= factor;
                contact.moment *= factor;
            }
            let said: Vec<String> = trial.findings().iter().map(ToString::to_string).collect();
            assert!(said.iter().any(|said| said.contains(word)), "{}: {said:?}", trial.name);
        }
    }
}

#[test]
fn a_foot_without_a_plate_is_named_with_its_time() {
    for mut trial in trials() {
        let left = trial.plates.pop().expect("two");
        let found = trial.findings();
        let bare = |finding: &&MotionFinding| matches!(finding, MotionFinding::NoPlate { foot, has_plate: false, missing, .. } if foot == "calcn_l" && *missing > 0.5);
        assert_eq!(found.iter().filter(bare).count(), 1, "{}: {found:?}", trial.name);
        // A plate that was off is no plate.
        let samples = left.samples.iter().map(|_| solaris_model::Contact::default()).collect();
        trial.plates.push(MeasuredForce { samples, ..left });
        let found = trial.findings();
        let bare = |finding: &&MotionFinding| matches!(finding, MotionFinding::NoPlate { foot, has_plate: true, .. } if foot == "calcn_l");
        assert_eq!(found.iter().filter(bare).count(), 1, "{}: {found:?}", trial.name);
    }
}

/// A foot that comes down in the last frames, where a filter spoils the accelerations, was said to stand on no plate.
#[test]
fn scraps_of_stances_at_the_ends_need_no_plate() {
    let mut trial = trials().swap_remove(0);
    trial.plates.pop().expect("two");
    let time = trial.motion.column("time").expect("times");
    let last = trial.motion.values_of(time).last().expect("rows");
    let bare = |lasts: f64| {
        let found = trial.check_with(|stance| (stance.start, stance.end) = (last - lasts, last)).0.findings;
        found.iter().any(|found| matches!(found, MotionFinding::NoPlate { foot, .. } if foot == "calcn_l"))
    };
    assert!(bare(0.15) && !bare(0.05));
}

/// The numbers stay, the header says the other unit.
#[test]
fn degrees_and_radians_that_are_swapped_are_caught() {
    for mut trial in trials() {
        assert_eq!(trial.motion.in_degrees, Some(true), "{}", trial.name);
        trial.motion.in_degrees = Some(false);
        let (_, _, angles) = trial.check();
        assert!(matches!(angles, Some(MotionFinding::DegreesAsRadians { .. })), "{}: {angles:?}", trial.name);
        let slides = ["time", "pelvis_tx", "pelvis_ty", "pelvis_tz"];
        let slides: Vec<bool> =
            trial.motion.columns.iter().map(|name| slides.contains(&name.as_str())).collect();
        for (i, value) in trial.motion.values.iter_mut().enumerate() {
            if !slides[i % slides.len()] {
                *value = value.to_radians();
            }
        }
        let (_, _, angles) = trial.check();
        assert_eq!(angles, None, "{}: in radians, as it says", trial.name);
        trial.motion.in_degrees = Some(true);
        let (_, _, angles) = trial.check();
        assert!(matches!(angles, Some(MotionFinding::RadiansAsDegrees { .. })), "{}: {angles:?}", trial.name);
    }
}
