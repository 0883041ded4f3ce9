//! Whatever is dropped, as what it is: files of the fixtures, alone and together.

use solaris_analysis::Filter;
use solaris_files::{AskedGround, External, Given, MomentOptions, OpenOptions, Opened, Source, open};
use std::fs;
use std::path::Path;

fn fixture(path: &str) -> Vec<u8> {
    fs::read(Path::new("../../fixtures").join(path)).expect("a fixture")
}

/// Fixtures by their last names.
fn given(paths: &[&str]) -> Given {
    let name = |path: &str| path.rsplit('/').next().unwrap_or_default().to_owned();
    Given::new(paths.iter().map(|path| (name(path), fixture(path))))
}

fn opened(paths: &[&str]) -> Opened {
    open(&given(paths), OpenOptions::default())
}

fn what<'o>(opened: &'o Opened, name: &str) -> (&'o str, bool) {
    let file = opened.files.iter().find(|file| file.name == name).expect("a file");
    (&file.what, file.is_used)
}

#[test]
fn a_model_alone_is_a_figure_with_its_gravity() {
    let arm = opened(&["figures/arm.urdf"]);
    let body = arm.body.as_ref().expect("a figure");
    assert_eq!((body.figure.links().len(), body.gravity.z), (3, -9.80665));
    assert!(arm.motion.is_none() && arm.faults.is_empty(), "{:?}", arm.faults);
    assert_eq!(what(&arm, "arm.urdf"), ("the figure 'arm' (URDF)", true));
    // A file whose name says too little is known by what it holds.
    let text = open(&Given::new([("dropped.xml", fixture("figures/arm.urdf"))]), OpenOptions::default());
    assert!(text.body.is_some());
}

/// Who says nothing gets what the description of loads says: of each plate the foot that stands on it.
#[test]
fn plates_of_a_table_find_the_feet_that_stand_on_them() {
    let filter = Some(Filter { cutoff: 6.0, order: 2 });
    let options = MomentOptions { filter, ..MomentOptions::default() };
    let all = [
        "subject/walk.mot",
        "subject/subject.osim",
        "subject/soles.ron",
        "subject/grf.mot",
        "subject/loads.xml",
    ];
    let told = opened(&all).moments(&options).expect("moments");
    let found = opened(&all[..4]);
    assert_eq!(what(&found, "grf.mot"), ("2 force plates; the feet on them are found by the soles", true));
    let found = found.moments(&options).expect("moments");
    assert!(found.external.starts_with("plate 1: right from 0 to 1.175, "), "{}", found.external);
    assert!(found.external.contains("; plate 2 ('1_'): left from "), "{}", found.external);
    let scale = told.forces.tau.iter().fold(0.0_f64, |most, tau| most.max(tau.abs()));
    for (one, other) in found.forces.tau.iter().zip(&told.forces.tau) {
        assert!((one - other).abs() < 1e-9 * scale, "{one} {other}");
    }
    // Without soles it is said, and nothing pushes.
    let blind = opened(&[all[0], all[1], all[3]]).moments(&options).expect("moments");
    assert!(blind.external.contains("the feet on them are not known"), "{}", blind.external);
    assert!(blind.motion.contacts.is_empty());
}

#[test]
fn a_model_with_motion_loads_and_the_table_they_name_gives_moments() {
    let paths = [
        "subject/grf.mot",
        "subject/loads.xml",
        "subject/walk.mot",
        "subject/subject.osim",
        "subject/soles.ron",
    ];
    let subject = opened(&paths);
    assert!(subject.faults.is_empty(), "{:?}", subject.faults);
    assert_eq!(what(&subject, "grf.mot"), ("named by loads.xml", true));
    assert_eq!(what(&subject, "walk.mot"), ("a motion of 'subject'", true));
    assert_eq!(subject.unused().count(), 0, "{:?}", subject.files);
    let filter = Some(Filter { cutoff: 6.0, order: 2 });
    let measured = subject.moments(&MomentOptions { filter, ..MomentOptions::default() }).expect("moments");
    assert_eq!(measured.external, "grf.mot: calcn_r by 'calcn_r', calcn_l by 'calcn_l'".replace('\'', ""));
    assert!(measured.motion.taus().is_some() && measured.motion.contacts.len() == 2);
    assert!(
        measured.findings.iter().any(|line| line.starts_with("left over at the root")),
        "{:?}",
        measured.findings
    );
    // Predicted forces differ from measured ones, and both from none.
    let find =
        |ground| subject.moments(&MomentOptions { filter, ground, passive: true }).expect("moments").forces;
    let [predicted, none] = [AskedGround::Predicted, AskedGround::None].map(find);
    assert!(
        none.residual.force > 500.0 && measured.forces.residual.force < 300.0,
        "{:?}",
        measured.forces.residual
    );
    assert!(predicted.residual.force < none.residual.force && predicted.tau != measured.forces.tau);
}

#[test]
fn markers_are_fitted_to_a_model_and_alone_are_points() {
    let leg = opened(&["markers/leg.osim", "markers/swing.trc"]);
    assert!(leg.faults.is_empty(), "{:?}", leg.faults);
    let fit = leg.fit.as_ref().expect("fitted");
    // The leg is not brought to the size of who wore them.
    assert!(fit.found.rms() < 0.03, "{}", fit.found.rms());
    assert_eq!(leg.motion.as_ref().expect("a motion").motion.len(), fit.recording.markers.len());
    let alone = opened(&["clips/walk.c3d"]);
    let (body, motion) = (alone.body.as_ref().expect("points"), alone.motion.as_ref().expect("their motion"));
    assert_eq!((body.figure.links().len(), motion.motion.len(), alone.is_cloud), (10, 60, true));
    assert!(motion.findings.iter().any(|finding| finding.message.contains("hidden in 7 of 60 frames")));
    assert_eq!(alone.recording.as_ref().expect("a recording").plates.len(), 2);
    assert!(alone.moments(&MomentOptions::default()).is_err());
    // Of a figure that is open and has none of these markers, they are not.
    let figure = Source::disk().body(Path::new("../../fixtures/figures/arm.urdf")).ok();
    let other = open(&given(&["clips/walk.c3d"]), OpenOptions { figure, ..OpenOptions::default() });
    assert!(other.is_cloud);
}

#[test]
fn a_motion_is_of_the_figure_that_is_open() {
    let figure = Source::disk().body(Path::new("../../fixtures/clips/dancer.ron")).ok();
    let dance = open(&given(&["clips/dance.csv"]), OpenOptions { figure, ..OpenOptions::default() });
    assert_eq!(dance.motion.as_ref().expect("a motion").motion.len(), 101);
    assert!(dance.soles.is_some());
    let alone = opened(&["clips/dance.csv"]);
    assert_eq!(
        what(&alone, "dance.csv"),
        ("a motion without a figure: open its figure, or drop it with it", false)
    );
}

#[test]
fn a_scene_finds_the_files_that_it_names_by_their_last_names() {
    let clip = opened(&["scenes/files/box.ron", "scenes/files/box.urdf", "subject/soles.ron"]);
    assert!(clip.scene.as_ref().expect("a scene").held.is_some(), "{:?}", clip.faults);
    assert_eq!(what(&clip, "box.urdf"), ("named by box.ron", true));
    assert!(!what(&clip, "soles.ron").1);
    // Whichever comes first, the one that includes the other is the scene.
    for paths in [
        ["scenes/parts/bystanders.ron", "scenes/crowd.ron"],
        ["scenes/crowd.ron", "scenes/parts/bystanders.ron"],
    ] {
        let crowd = opened(&paths);
        assert!(crowd.faults.is_empty(), "{:?}", crowd.faults);
        assert_eq!(crowd.scene.expect("a scene").path, Path::new("crowd.ron"));
    }
}

#[test]
fn a_model_of_several_files_is_the_one_that_names_the_others() {
    let main = "<mujoco><include file=\"parts/leg.xml\"/><asset><mesh name=\"m\" file=\"Foot.STL\"/></asset>\
                <worldbody><body name=\"b\"><freejoint/><geom type=\"mesh\" mesh=\"m\"/></body></worldbody></mujoco>";
    // A tetrahedron of 10 cm.
    let corners = [[0.0_f32, 0.0, 0.0], [0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.1]];
    let mut mesh = vec![0_u8; 80];
    mesh.extend(4_u32.to_le_bytes());
    for face in [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] {
        mesh.extend([0_u8; 12]);
        for corner in face {
            mesh.extend(corners[corner].iter().flat_map(|x: &f32| x.to_le_bytes()));
        }
        mesh.extend([0_u8; 2]);
    }
    let files = Given::new([
        ("leg.xml", b"<mujoco><option gravity=\"0 0 -1\"/></mujoco>".to_vec()),
        ("robot.xml", main.as_bytes().to_vec()),
        ("foot.stl", mesh),
        ("notes.md", b"# notes".to_vec()),
    ]);
    let robot = open(&files, OpenOptions::default());
    assert!(robot.faults.is_empty(), "{:?}", robot.faults);
    let body = robot.body.as_ref().expect("a figure");
    assert!((body.gravity.z + 1.0).abs() < 1e-15 && body.figure.mass() > 0.0);
    assert_eq!(what(&robot, "leg.xml"), ("named by robot.xml", true));
    assert_eq!(what(&robot, "foot.stl"), ("named by robot.xml", true));
    let unused: Vec<&str> = robot.unused().map(|file| file.name.as_str()).collect();
    assert_eq!(unused, ["notes.md"]);
}

#[test]
fn a_file_at_fault_is_told_with_its_place_and_the_others_are_open() {
    let files = Given::new([
        ("arm.urdf", fixture("figures/arm.urdf")),
        ("bad.ron", b"Scene(\n  version: 1,\n  drivs: {},\n)".to_vec()),
        (
            "page.html",
            b"<html><script type=\"application/json\" id=\"data\">{\"a\": 1}</script></html>".to_vec(),
        ),
        ("line.ron", b"Line(from: 0, to: 1, duration: 2)".to_vec()),
        ("other.html", b"<html></html>".to_vec()),
    ]);
    let opened = open(&files, OpenOptions::default());
    let faults: Vec<String> = opened.faults.iter().map(ToString::to_string).collect();
    assert_eq!(faults.len(), 2, "{faults:?}");
    assert!(
        faults[0].starts_with("bad.ron")
            && faults[0].contains("line 3, column 3: Scene has no field 'drivs'"),
        "{faults:?}"
    );
    assert!(faults[1].contains("none of this program"), "{faults:?}");
    assert!(opened.body.is_some() && opened.profile.as_ref().is_some_and(|profile| profile.held.is_some()));
    assert_eq!(opened.page.expect("a page").text, "{\"a\": 1}");
    assert!(opened.scene.expect("its text").held.is_none());
    assert!(matches!(opened.external, External::None));
}

#[test]
fn plates_of_a_recording_push_the_feet_on_them() {
    let alone = opened(&["clips/walk.c3d"]);
    let recording = alone.recording.as_ref().expect("a recording");
    let (trial, plates) = (&recording.markers, &recording.plates);
    let seen = |frame: &usize| trial.frame(*frame).iter().all(|point| !point.x.is_nan());
    // A block that wears the markers as they are when the first plate bears most, with a foot on that plate.
    let middle = (trial.len() / 4..trial.len()).find(seen).expect("a frame with all markers");
    let frames: Vec<String> = (trial.names().iter().zip(trial.frame(middle)))
        .map(|(name, at)| format!("\"{name}\": Frame(at: ({}, {}, {}))", at.x, at.y, at.z))
        .collect();
    let figure = format!(
        "Figure(version: 1, name: \"block\", links: [Link(name: \"block\", joint: Free(name: \"root\"), mass: 70.0, \
         solid: Box(size: (0.3, 1.0, 0.3)), frames: {{{}}})])",
        frames.join(", ")
    );
    let corners = plates[0].corners.iter();
    let centre = corners.fold(solaris_model::Vector3::zeros(), |sum, corner| sum + corner / 4.0);
    let at = |along: f64| format!("({}, {}, {})", centre.x + along, centre.y, centre.z);
    let soles = format!(
        "Soles(version: 1, soles: [Sole(name: \"right\", foot: \"block\", heel: {}, ball: {}, tip: {}, width: 0.1)])",
        at(-0.1),
        at(0.05),
        at(0.1)
    );
    let files = Given::new([
        ("walk.c3d", fixture("clips/walk.c3d")),
        ("block.ron", figure.into_bytes()),
        ("soles.txt", soles.into_bytes()),
    ]);
    let block = open(&files, OpenOptions::default());
    assert!(block.faults.is_empty() && block.unused().count() == 0, "{:?} {:?}", block.files, block.faults);
    let moments = block.moments(&MomentOptions::default()).expect("moments");
    assert!(moments.external.contains("plate 1: right from"), "{}", moments.external);
    assert!(
        moments.motion.contacts.iter().any(|track| track.samples.iter().any(|one| one.force.norm() > 100.0))
    );
}
