//! The files of one walk hold one motion.

use crate::walk::{names, read, solaris, succeeded};
use serde_json::Value;
use solaris::analysis::{Near, nearness};
use solaris::io::csv;
use solaris::model::{Figure, Motion, MotionInfo, human};
use std::collections::HashMap;
use tempfile::TempDir;

/// A written walk.
struct Walk {
    folder: TempDir,
    figure: Figure,
    motion: Motion,
}

impl Walk {
    /// Ten steps in every format; the motion is read back from the table.
    fn written() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let args = "walk --height 1.8 --mass 80 --rate 100 -o w.csv -o w.bvh -o w.html --report w.json";
        succeeded(&solaris(folder.path(), &args.split(' ').collect::<Vec<_>>()));
        assert_eq!(names(folder.path()), ["w.bvh", "w.csv", "w.html", "w.json"]);
        let figure = human(1.8, 80.0).expect("a person");
        let info = MotionInfo::on_earth(&figure, 100.0);
        let motion =
            csv::read(&figure, &read(&folder.path().join("w.csv")), info).expect("a motion of the figure");
        Self { folder, figure, motion }
    }

    fn text(&self, name: &str) -> String {
        read(&self.folder.path().join(name))
    }

    fn report(&self) -> Value {
        serde_json::from_str(&self.text("w.json")).expect("JSON")
    }
}

/// Channels of a BVH file by link and channel (`left_knee.Xrotation`), in order, and its numbers frame by frame.
fn bvh(text: &str) -> (Vec<String>, f64, Vec<Vec<f64>>) {
    let (hierarchy, motion) = text.split_once("MOTION\n").expect("both parts");
    let (mut link, mut channels) = ("", Vec::new());
    for line in hierarchy.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        match words[..] {
            ["ROOT" | "JOINT", name] => link = name,
            ["CHANNELS", _, ref names @ ..] => {
                channels.extend(names.iter().map(|name| format!("{link}.{name}")));
            }
            _ => {}
        }
    }
    let mut lines = motion.lines();
    let mut field = |name: &str| -> f64 {
        let line = lines.next().expect("a line");
        line.strip_prefix(name).expect(name).trim().parse().expect("a number")
    };
    let (count, time) = (field("Frames:"), field("Frame Time:"));
    let frames: Vec<Vec<f64>> =
        lines.map(|line| line.split(' ').map(|word| word.parse().expect("a number")).collect()).collect();
    assert!((frames.len() as f64 - count).abs() < 0.5);
    (channels, time, frames)
}

#[test]
fn the_table_holds_what_the_animation_holds() {
    let walk = Walk::written();
    let (channels, frame_time, frames) = bvh(&walk.text("w.bvh"));
    assert!((frame_time - 0.01).abs() < 1e-12);
    assert_eq!((frames.len(), channels.len()), (walk.motion.len(), walk.motion.q(0).len()));
    // A link's channels are those of the joint that it hangs on.
    let joints: HashMap<&str, &str> =
        walk.figure.links().iter().map(|link| (link.name(), link.joint().name())).collect();
    let columns: Vec<(usize, f64)> = channels
        .iter()
        .map(|channel| {
            let (link, kind) = channel.split_once('.').expect("a link and a channel");
            let axis = kind[..1].to_lowercase();
            let (letter, scale) =
                if kind.ends_with("position") { ('t', 0.01) } else { ('r', 1f64.to_radians()) };
            let dof = format!("{}.{letter}{axis}", joints[link]);
            let names = walk.figure.layout().q_names();
            (names.iter().position(|name| *name == dof).expect("a degree of freedom"), scale)
        })
        .collect();
    let worst = (0..frames.len())
        .flat_map(|frame| {
            let (q, columns) = (walk.motion.q(frame), &columns);
            frames[frame].iter().zip(columns).map(move |(value, (i, scale))| (value - q[*i] / scale).abs())
        })
        .fold(0.0, f64::max);
    // Six decimals of centimetres and degrees.
    assert!(worst <= 0.501e-6, "{worst:e} cm or degrees");
}

#[test]
fn the_report_holds_what_the_table_holds() {
    let walk = Walk::written();
    let report = walk.report();
    let number = |pointer: &str| report.pointer(pointer).and_then(Value::as_f64).expect(pointer);
    let (motion, weight) = (&walk.motion, 80.0 * 9.806_65);
    assert!((number("/walk/frames") - motion.len() as f64).abs() < 0.5);
    assert!((number("/walk/rate_per_s") - 100.0).abs() < 1e-9);
    let forces = motion.contacts.iter().flat_map(|track| &track.samples).map(|contact| contact.force.y);
    let vertical = 100.0 * forces.fold(0.0, f64::max) / weight;
    assert!((number("/whole_walk/vertical_percent_bw/value") - vertical).abs() < 1e-9, "{vertical} %BW");
    let z =
        walk.figure.layout().q_names().iter().position(|name| name == "root.tz").expect("the root slides");
    let far = motion.q(motion.len() - 1)[z] - motion.q(0)[z];
    assert!((number("/walk/distance_m") - far).abs() < 0.01, "{far} m");
    assert!((walk.figure.mass() - 80.0).abs() < 1e-9);
}

#[test]
fn the_report_tells_which_limbs_were_nearest_at_any_time() {
    let walk = Walk::written();
    let report = walk.report();
    let limbs = &report["whole_walk"]["nearest_limbs"];
    let spells = limbs["spells"].as_array().expect("spells");
    let number = |value: &Value| value.as_f64().expect("a number");
    let found = nearness(&walk.figure, &walk.motion).expect("measured").expect("shapes");
    let (mut frame, mut least) = (0, f64::INFINITY);
    for spell in spells {
        let pair = found.frames[frame].links.map(|link| walk.figure.links()[link].name());
        assert_eq!(spell["links"], serde_json::json!(pair));
        assert!((number(&spell["from_s"]) - walk.motion.time()[frame]).abs() < 1e-9);
        let same = |near: &&Near| near.links == found.frames[frame].links;
        let spell_frames = found.frames[frame..].iter().take_while(same);
        let distances: Vec<f64> = spell_frames.map(|near| near.distance).collect();
        frame += distances.len();
        assert!((number(&spell["to_s"]) - walk.motion.time()[frame - 1]).abs() < 1e-9);
        let nearest = distances.into_iter().fold(f64::INFINITY, f64::min);
        assert!((number(&spell["distance_m"]) - nearest).abs() < 1e-9);
        least = least.min(nearest);
    }
    assert_eq!(frame, walk.motion.len());
    assert!((number(&limbs["distance_m"]) - least).abs() < 1e-9);
    assert!(spells.len() > 1 && 10 * spells.len() < walk.motion.len(), "{} spells", spells.len());
}

#[test]
fn the_page_is_small_and_its_data_can_be_read() {
    let walk = Walk::written();
    let html = walk.text("w.html");
    assert!(html.len() < 1_500_000, "{} bytes", html.len());
    let (_, rest) = html.split_once("<script type=\"application/json\" id=\"data\">").expect("data");
    let (json, _) = rest.split_once("</script>").expect("its end");
    let data: Value = serde_json::from_str(json).expect("JSON");
    assert_eq!(data["links"].as_array().map(Vec::len), Some(walk.figure.links().len()));
    assert_eq!(data["feet"].as_array().map(Vec::len), Some(2));
    assert!(html.contains("A person of 1.8 m and 80 kg walks 10 steps at 110 steps/min"));
    for row in ["Recipe&#39;s bands", "Textbook bands", "textbook range, not cited", "vertical force, peak"] {
        assert!(html.contains(row), "{row}");
    }
}

#[test]
fn a_walk_repeats_bit_for_bit() {
    let folder = tempfile::tempdir().expect("a folder");
    let args = ["walk", "--steps", "3", "-o", "a.csv", "-o", "a.bvh"];
    let twice = [0, 1].map(|_| {
        succeeded(&solaris(folder.path(), &args));
        ["a.csv", "a.bvh"].map(|name| read(&folder.path().join(name)))
    });
    assert!(twice[0] == twice[1]);
}
