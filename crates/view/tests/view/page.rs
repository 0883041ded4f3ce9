//! The page as a whole: what it holds, how large it is, and what it must refuse.

use base64::{Engine as _, engine::general_purpose::STANDARD};
use serde_json::Value;
use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_model::{
    Contact, ContactTrack, Figure, FigureBuilder, Ground, Joint, LinkSpec, Motion, MotionInfo, Relief,
    Trajectory, Vector3, human,
};
use solaris_view::{PageOptions, TableRow, ViewError, page};

/// Everything moves; the root goes forward at `speed` (m/s).
struct Wave {
    duration: f64,
    speed: f64,
    start: f64,
}

impl Trajectory for Wave {
    fn duration(&self) -> f64 {
        self.duration
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        for (i, q) in q.iter_mut().enumerate() {
            *q = 0.4 * (3.0 * t + i as f64).sin();
        }
        q[2] = self.start + self.speed * t;
    }
}

const WALK: Wave = Wave { duration: 9.0, speed: 1.3, start: 0.0 };
const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.80665, 0.0);

fn sampled(wave: &Wave) -> (Figure, Motion) {
    let figure = human(1.75, 73.0).expect("a person");
    let ground = Some(Ground { height: 0.0, friction: None });
    let info = MotionInfo { fingerprint: figure.fingerprint(), gravity: GRAVITY, ground, rate: 120.0 };
    let motion = Motion::sample(&figure, wave, info).expect("a smooth motion");
    (figure, motion)
}

/// With contacts and moments, as a walk has them.
fn walk() -> (Figure, Motion) {
    let (figure, mut motion) = sampled(&WALK);
    for (link, sign) in [("left_foot", 1.0), ("right_foot", -1.0)] {
        let contact = |&t: &f64| {
            let force = Vector3::new(20.0, 400.0 * (1.0 + sign * (5.0 * t).sin()), -30.0 * sign);
            Contact { force, moment: Vector3::zeros(), cop: Vector3::new(0.1 * sign, 0.0, 1.3 * t) }
        };
        let samples = motion.time().iter().map(contact).collect();
        motion.contacts.push(ContactTrack { link: link.to_owned(), samples });
    }
    let tau = (0..motion.len()).flat_map(|sample| motion.a(sample).to_vec()).collect();
    motion.set_tau(tau).expect("as many as accelerations");
    (figure, motion)
}

fn options() -> PageOptions {
    let table = (0..12).map(|i| TableRow::new(format!("Row {i}"), "1.234", "m/s", "as asked for")).collect();
    PageOptions { title: "A walk".to_owned(), table, ..PageOptions::default() }
}

/// The object that the page holds.
fn data(html: &str) -> Value {
    let (_, rest) =
        html.split_once(r#"<script type="application/json" id="data">"#).expect("an element for the data");
    let (json, _) = rest.split_once("</script>").expect("its end");
    serde_json::from_str(json).expect("JSON")
}

/// The numbers of an array, as the page reads them.
fn numbers(packed: &Value) -> Vec<f64> {
    let decode = |text: &Value| STANDARD.decode(text.as_str().expect("text")).expect("base64");
    if let Some(text) = packed.get("f32") {
        let bytes = decode(text);
        return bytes.as_chunks::<4>().0.iter().map(|b| f64::from(f32::from_le_bytes(*b))).collect();
    }
    let number = |key: &str| packed[key].as_f64().expect("a number");
    let (scale, offset) = (number("scale"), number("offset"));
    let bytes = decode(&packed["i16"]);
    bytes.as_chunks::<2>().0.iter().map(|b| offset + scale * f64::from(i16::from_le_bytes(*b))).collect()
}

/// A point of the page's data.
fn point(values: &[f64], at: usize) -> Vector3<f64> {
    Vector3::from_column_slice(&values[3 * at..3 * at + 3])
}

#[test]
fn a_walk_of_nine_seconds_stays_under_one_and_a_half_megabytes() {
    let (figure, motion) = walk();
    let size = page(&figure, &motion, &options()).expect("a page").len();
    assert!((900_000..1_500_000).contains(&size), "{size} bytes");
}

#[test]
fn nothing_is_fetched_from_anywhere() {
    let (figure, motion) = walk();
    let html = page(&figure, &motion, &options()).expect("a page");
    assert!(html.contains("default-src 'none'"));
    let (head, _) = html.split_once("<script>").expect("the viewer");
    for attribute in ["src=\"", "href=\"", "url("] {
        let outside = head.split(attribute).skip(1).filter(|rest| !rest.starts_with("data:")).count();
        assert_eq!(outside, 0, "{attribute}");
    }
}

#[test]
fn pictures_fetch_nothing_and_hold_no_markup_of_names() {
    let name = "<image href=\"https://example.org/x\"/>\u{1b}[31m\u{202e}]]>\"'";
    let effort =
        solaris_view::Effort { name: name.into(), unit: name.into(), values: vec![1.0, 2.0], spread: None };
    let picture = solaris_view::efforts(&[0.0, 0.1], &[effort], &[], &[], name);
    let whole = solaris_view::picture_page(name, &picture);
    for text in [&picture, &whole] {
        assert!(!text.contains("<image") && !text.contains("href=\"http"), "{text}");
        assert!(!text.contains(|c: char| (c.is_control() && c != '\n') || c == '\u{202e}'), "{text}");
        let outside = text.replace("http://www.w3.org/2000/svg", "").replace("https://example.org/x", "");
        assert!(!outside.contains("://"), "{text}");
    }
    let (figure, motion) = walk();
    let title = "</script><script src=//example.org>".to_owned();
    let html = page(&figure, &motion, &PageOptions { title, ..options() }).expect("a page");
    assert!(!html.contains("<script src"), "markup out of a title");
}

#[test]
fn the_same_motion_gives_the_same_page() {
    let make = || {
        let (figure, motion) = walk();
        page(&figure, &motion, &options()).expect("a page")
    };
    assert!(make() == make());
}

#[test]
fn text_cannot_become_markup() {
    let evil = "</script><img src=x onerror=alert(1)> {{data}} & \"q\" 'a'";
    let link = LinkSpec::root(evil, Joint::new(evil).rx()).mass(1.0);
    let figure = FigureBuilder::new(evil).link(link).build().expect("names are free");
    let info = MotionInfo { fingerprint: figure.fingerprint(), gravity: GRAVITY, ground: None, rate: 50.0 };
    let motion =
        Motion::new(&figure, info, vec![0.0], [vec![0.1], vec![0.0], vec![0.0]]).expect("one sample");
    let table = vec![TableRow::new(evil, evil, evil, evil)];
    let options = PageOptions { title: evil.to_owned(), table, ..PageOptions::default() };
    let html = page(&figure, &motion, &options).expect("a page");
    assert!(!html.contains("<img"), "markup from text");
    let escaped =
        "&lt;/script&gt;&lt;img src=x onerror=alert(1)&gt; {{data}} &amp; &quot;q&quot; &#39;a&#39;";
    assert_eq!(html.matches(escaped).count(), 2 + 4, "title, heading and four cells");
    assert_eq!(html.matches("</script>").count(), 2, "one end for the data, one for the viewer");
    assert_eq!(data(&html)["links"][0]["name"], evil);
}

#[test]
fn positions_and_turns_come_back_within_the_resolution_however_far_away() {
    let (figure, motion) = sampled(&Wave { duration: 2.0, speed: 1.3, start: 900.0 });
    let data = data(&page(&figure, &motion, &options()).expect("a page"));
    let [root, positions, turns] = ["root", "positions", "turns"].map(|key| numbers(&data[key]));
    let start = Vector3::from_iterator((0..3).map(|i| data["origin"][i].as_f64().expect("metres")));
    let tree = Tree::<f64>::new(&figure, GRAVITY).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    let links = figure.links().len();
    let (mut worst, mut worst_point) = (0.0_f64, 0.0_f64);
    for frame in 0..root.len() / 3 {
        forward_kinematics(&tree, &mut workspace, motion.q(2 * frame)).expect("poses");
        let origin = workspace.pose(0).translation;
        // Of 32-bit floats, which would be off by 3e-5 m were they not told from a point near the figure.
        assert!((point(&root, frame) + start - origin).norm() < 1e-6);
        for link in 0..links {
            let pose = workspace.pose(link);
            let at = frame * links + link;
            let back = point(&positions, at);
            worst = worst.max((back - (pose.translation - origin)).amax());
            let [x, y, z, w] = [0, 1, 2, 3].map(|i| turns[4 * at + i]);
            let turn = nalgebra::UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(w, x, y, z));
            let arm = Vector3::new(0.3, -0.3, 0.26);
            worst_point = worst_point.max((turn * arm + back - (pose.transform(&arm) - origin)).norm());
        }
    }
    assert!(worst < 2e-5, "{worst} m");
    assert!(worst_point < 1e-4, "{worst_point} m at half a metre from a link's origin");
    assert!(worst > 1e-7, "a test of integers, not of floats: {worst}");
}

#[test]
fn the_ground_s_heights_are_told_from_where_everything_is_told() {
    let (figure, mut motion) = sampled(&Wave { duration: 1.0, speed: 1.3, start: 900.0 });
    let page_of = |motion: &Motion| data(&page(&figure, motion, &options()).expect("a page"));
    assert!(page_of(&motion)["ground"].get("relief").is_none(), "a floor is a plane");
    let kerb = [[-3.0, 0.25], [901.5, 0.25], [901.5, 0.4]];
    motion.relief = Some(Relief::new(kerb.to_vec()).expect("a relief"));
    let data = page_of(&motion);
    let [_, up, ahead] = [0, 1, 2].map(|i| data["origin"][i].as_f64().expect("metres"));
    assert!(ahead > 890.0, "{ahead}");
    for (point, [z, height]) in data["ground"]["relief"].as_array().expect("points").iter().zip(kerb) {
        let [at, above] = [0, 1].map(|i| point[i].as_f64().expect("metres"));
        assert!((at + ahead - z).abs() < 1e-12 && (above + up - height).abs() < 1e-12, "{point}");
    }
    // A profile along z says nothing of a world whose forward is another one.
    let options = PageOptions { forward: Some(Vector3::x()), ..options() };
    let html = page(&figure, &motion, &options).expect("a page");
    assert!(self::data(&html)["ground"].get("relief").is_none());
}

/// Two turns and a bit about x in a second.
struct Wheel;

impl Trajectory for Wheel {
    fn duration(&self) -> f64 {
        1.0
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        q[0] = 13.0 * t;
    }
}

#[test]
fn every_link_is_in_the_camera_s_box_at_any_time() {
    let (figure, motion) = sampled(&Wave { duration: 9.0, speed: 1.3, start: 900.0 });
    let data = data(&page(&figure, &motion, &options()).expect("a page"));
    let [root, positions, aim] = [&data["root"], &data["positions"], &data["camera"]["aim"]].map(numbers);
    let half = Vector3::from_iterator((0..3).map(|i| data["camera"]["half"][i].as_f64().expect("m")));
    let links = figure.links().len();
    for at in 0..positions.len() / 3 {
        let frame = at / links;
        let seen = point(&positions, at) + point(&root, frame) - point(&aim, frame);
        assert!((half - seen.abs()).min() > 0.0, "link {} leaves it in frame {frame}: {seen}", at % links);
    }
    assert!(half.z < 1.0, "it goes along with the figure, which goes 11.7 m: {half}");
}

#[test]
fn turns_never_change_their_sign_between_frames() {
    let link = LinkSpec::root("wheel", Joint::new("axle").rx()).mass(1.0);
    let figure = FigureBuilder::new("wheel").link(link).build().expect("valid");
    let info = MotionInfo { fingerprint: figure.fingerprint(), gravity: GRAVITY, ground: None, rate: 60.0 };
    let motion = Motion::sample(&figure, &Wheel, info).expect("smooth");
    let turns = numbers(&data(&page(&figure, &motion, &options()).expect("a page"))["turns"]);
    for at in (0..turns.len() - 4).step_by(4) {
        let dot: f64 = (at..at + 4).map(|i| turns[i] * turns[i + 4]).sum();
        assert!(dot > 0.99, "{dot} at {at}");
    }
}

#[test]
fn frames_are_at_most_sixty_a_second_and_keep_their_times() {
    let (figure, motion) = sampled(&Wave { duration: 1.0, speed: 1.0, start: 0.0 });
    let time = numbers(&data(&page(&figure, &motion, &options()).expect("a page"))["time"]);
    assert_eq!(time.len(), 61);
    assert!((time[1] - 1.0 / 60.0).abs() < 1e-7 && (time[60] - 1.0).abs() < 1e-7);
}

#[test]
fn forces_are_shares_of_the_body_s_weight() {
    let (figure, motion) = walk();
    let data = data(&page(&figure, &motion, &options()).expect("a page"));
    let vertical = &data["forces"][0];
    assert_eq!((&vertical["label"], &vertical["unit"]), (&"Vertical force".into(), &"% BW".into()));
    let expected = 100.0 * 400.0 / (73.0 * 9.80665);
    assert!((numbers(&vertical["lines"][0]["values"])[0] - expected).abs() < 0.01);
    assert_eq!(data["feet"][1]["side"], "right");
}

#[test]
fn a_motion_without_contacts_and_moments_has_a_page_without_them() {
    let (figure, motion) = sampled(&WALK);
    let data = data(&page(&figure, &motion, &PageOptions::default()).expect("a page"));
    assert_eq!(
        (data["feet"].as_array().map(Vec::len), data["forces"].as_array().map(Vec::len)),
        (Some(0), Some(0))
    );
    assert!(data["joints"][0].get("effort").is_none());
    assert_eq!(data["joints"][0]["label"], "Hip flexion");
}

#[test]
fn bands_stand_beside_their_curves_and_are_told_in_the_caller_s_words() {
    let (figure, motion) = walk();
    let nv = figure.layout().nv();
    let bands = |width: f64| Some(vec![width; nv * motion.len()]);
    let told = "</script> two standard errors";
    let options = PageOptions {
        angle_bands: bands(0.05),
        moment_bands: bands(7.3),
        bands: told.to_owned(),
        ..PageOptions::default()
    };
    let data = data(&page(&figure, &motion, &options).expect("a page"));
    assert_eq!(data["bands"], told);
    for joint in data["joints"].as_array().expect("joints") {
        for (plot, expected) in [("position", 0.05_f64.to_degrees()), ("effort", 0.1)] {
            for line in joint.get(plot).and_then(|plot| plot["lines"].as_array()).into_iter().flatten() {
                let (spread, values) = (numbers(&line["spread"]), numbers(&line["values"]));
                assert_eq!(spread.len(), values.len());
                assert!(spread.iter().all(|half| (half - expected).abs() < 1e-9), "{joint}");
            }
        }
        for line in joint.get("power").and_then(|plot| plot["lines"].as_array()).into_iter().flatten() {
            assert!(line.get("spread").is_none());
        }
    }
    let wrong = PageOptions { angle_bands: Some(vec![0.0; 3]), ..PageOptions::default() };
    let error = page(&figure, &motion, &wrong).expect_err("refused");
    assert!(matches!(error, ViewError::BandLength { what: "angle", found: 3, .. }), "{error}");
}

#[test]
fn what_does_not_fit_is_refused_by_name() {
    let (figure, motion) = walk();
    let refused = |figure: &Figure, motion: &Motion| page(figure, motion, &options()).expect_err("refused");

    let other = human(1.6, 60.0).expect("a person");
    assert!(matches!(refused(&other, &motion), ViewError::Motion(_)));

    let empty =
        Motion::new(&figure, motion.info.clone(), Vec::new(), [const { Vec::new() }; 3]).expect("no samples");
    assert_eq!(
        refused(&figure, &empty).to_string(),
        "the motion of 'human' has no samples; a page needs at least one"
    );

    let mut broken = motion.clone();
    broken.contacts[0].link = "left_paw".to_owned();
    assert!(refused(&figure, &broken).to_string().contains("'left_paw'"));

    let mut broken = motion.clone();
    broken.contacts[1].samples.pop();
    assert!(
        refused(&figure, &broken)
            .to_string()
            .starts_with("the contact track of 'right_foot' has 1080 samples, the motion 1081")
    );

    let mut broken = motion.clone();
    broken.contacts[0].samples[12].force.y = f64::NAN;
    assert_eq!(
        refused(&figure, &broken).to_string(),
        "the force on 'left_foot' at 0.1 s is NaN; it must be a finite number"
    );
}

/// The small part of the data, and the kinds of what is large.
#[test]
fn the_head_of_the_data_is_as_it_was() {
    let (figure, motion) = walk();
    let mut data = data(&page(&figure, &motion, &options()).expect("a page"));
    let object = data.as_object_mut().expect("an object");
    let links = object["links"].as_array().expect("links").len();
    let labels = |list: &Value| {
        list.as_array().expect("a list").iter().map(|entry| entry["label"].clone()).collect::<Vec<_>>()
    };
    let (joints, forces) = (labels(&object["joints"]), labels(&object["forces"]));
    let first = object["links"][9].clone();
    for key in ["time", "root", "positions", "turns", "com"] {
        object[key] = numbers(&object[key]).len().into();
    }
    object["feet"].as_array_mut().expect("feet").iter_mut().for_each(|foot| {
        for key in ["force", "cop"] {
            foot[key] = numbers(&foot[key]).len().into();
        }
    });
    // Its numbers are the skin's own business.
    for (_, array) in object["body"].as_object_mut().expect("a body").iter_mut() {
        *array = array.as_object().map(|packed| packed.keys().cloned().collect::<Vec<_>>().join(" ")).into();
    }
    object["links"] = serde_json::json!({ "count": links, "tenth": first });
    object["joints"] = joints.into();
    object["forces"] = forces.into();
    object["camera"]["aim"] = numbers(&object["camera"]["aim"]).len().into();
    let rounded = |value: &Value| ((value.as_f64().expect("a number") * 1e3).round() / 1e3).into();
    for key in ["size", "weight"] {
        object[key] = rounded(&object[key]);
    }
    for axis in 0..3 {
        object["camera"]["half"][axis] = rounded(&object["camera"]["half"][axis]);
    }
    insta::assert_snapshot!(serde_json::to_string_pretty(&data).expect("JSON"));
}

/// The page's skin, unpacked and posed as the page does it, against that of the crate in the motion's own world.
#[test]
fn a_person_s_skin_is_where_the_links_are() {
    let (figure, motion) = walk();
    let data = data(&page(&figure, &motion, &options()).expect("a page"));
    let body = &data["body"];
    let bytes = |packed: &Value| STANDARD.decode(packed["u8"].as_str().expect("text")).expect("base64");
    let (points, links, shares) = (numbers(&body["points"]), bytes(&body["links"]), bytes(&body["shares"]));
    let [places, turns, root] = ["places", "turns"]
        .map(|key| numbers(&body[key]))
        .into_iter()
        .chain([numbers(&data["root"])])
        .collect::<Vec<_>>()
        .try_into()
        .expect("three");
    let (positions, poses) = (numbers(&data["positions"]), numbers(&data["turns"]));
    let count = figure.links().len();
    let isometry = |at: &[f64], turn: &[f64]| {
        let turn = nalgebra::Quaternion::new(turn[3], turn[0], turn[1], turn[2]);
        nalgebra::Isometry3::from_parts(
            nalgebra::Translation3::new(at[0], at[1], at[2]),
            nalgebra::UnitQuaternion::from_quaternion(turn),
        )
    };
    let skin = solaris_skin::person(&figure, solaris_skin::Detail::Coarse).expect("a person");
    let origin: Vec<f64> =
        data["origin"].as_array().expect("three").iter().map(|x| x.as_f64().expect("a number")).collect();
    for (frame, sample) in [(0, 0), (30, 30 * motion.len() / (root.len() / 3))] {
        // Frames are samples of 60 a second.
        let time = numbers(&data["time"])[frame];
        let sample = motion.time().iter().position(|t| (t - time).abs() < 1e-4).unwrap_or(sample);
        let expected = skin.posed(&figure.places(motion.q(sample)));
        let mut worst: f64 = 0.0;
        for (vertex, wanted) in expected.iter().enumerate() {
            let point =
                nalgebra::Point3::new(points[3 * vertex], points[3 * vertex + 1], points[3 * vertex + 2]);
            let mut found = nalgebra::Vector3::zeros();
            for k in 0..4 {
                let (link, share) =
                    (usize::from(links[4 * vertex + k]), f64::from(shares[4 * vertex + k]) / 255.0);
                let bind = isometry(&places[3 * link..], &turns[4 * link..]);
                let at = frame * count + link;
                let mut now = isometry(&positions[3 * at..], &poses[4 * at..]);
                now.translation.vector +=
                    nalgebra::Vector3::new(root[3 * frame], root[3 * frame + 1], root[3 * frame + 2]);
                found += (now * (bind.inverse() * point)).coords * share;
            }
            found += nalgebra::Vector3::new(origin[0], origin[1], origin[2]);
            worst = worst.max((found - wanted).norm());
        }
        assert!(worst < 2e-3, "frame {frame}: {worst} m");
    }
}
