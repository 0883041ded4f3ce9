//! A subject of our own: an OpenSim model, a motion and force plates, made of a walk of `solaris-gait`.
//!
//! Everything that a measured subject has, in the same file formats, free of other people's licences. The figure is the
//! human whose joints only bend in the plane of walking, each knee with a centre that moves as it bends; the walk loses its
//! sideways part. What inverse dynamics finds of it is therefore plausible, and the residual at the pelvis is not zero.

use crate::workspace;
use nalgebra::{Matrix3, Vector3};
use solaris_analysis::ground_reactions;
use solaris_gait::{Extent, FEET, WalkRequest, walk};
use solaris_io::{Table, sto};
use solaris_model::{Contact, Figure, Fused, Link, human};
use std::fmt::Write as _;
use std::fs;

/// Frames a second of the motion and of the force plates.
const RATES: (usize, usize) = (60, 120);

/// A degree of freedom that is kept: its name, OpenSim's, and its range in degrees or m.
const KEPT: [(&str, &str, f64, f64); 10] = [
    ("root.rx", "pelvis_tilt", -45.0, 45.0),
    ("root.tz", "pelvis_tx", -2.0, 20.0),
    ("root.ty", "pelvis_ty", 0.0, 2.0),
    ("right_hip.rx", "hip_flexion_r", -40.0, 120.0),
    ("right_knee.rx", "knee_angle_r", -120.0, 10.0),
    ("right_ankle.rx", "ankle_angle_r", -60.0, 40.0),
    ("left_hip.rx", "hip_flexion_l", -40.0, 120.0),
    ("left_knee.rx", "knee_angle_l", -120.0, 10.0),
    ("left_ankle.rx", "ankle_angle_l", -60.0, 40.0),
    ("lumbar.rx", "lumbar_extension", -60.0, 30.0),
];

/// A body: its name, the link that it is, its joint, the body before it, the coordinate.
const BODIES: [(&str, &str, &str, &str, &str); 7] = [
    ("femur_r", "right_thigh", "hip_r", "pelvis", "hip_flexion_r"),
    ("tibia_r", "right_shank", "knee_r", "femur_r", "knee_angle_r"),
    ("calcn_r", "right_foot", "ankle_r", "tibia_r", "ankle_angle_r"),
    ("femur_l", "left_thigh", "hip_l", "pelvis", "hip_flexion_l"),
    ("tibia_l", "left_shank", "knee_l", "femur_l", "knee_angle_l"),
    ("calcn_l", "left_foot", "ankle_l", "tibia_l", "ankle_angle_l"),
    ("torso", "abdomen", "back", "pelvis", "lumbar_extension"),
];

/// Writes the three files and the description of the forces to `fixtures/subject`.
pub(crate) fn run() -> Result<(), String> {
    let folder = workspace::root().join("fixtures/subject");
    fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    let show = |error: &dyn std::fmt::Display| error.to_string();
    let ann = human(1.75, 73.0).map_err(|error| show(&error))?;
    let request = WalkRequest { extent: Extent::Steps(4), ..WalkRequest::default() };
    let plan = walk(&ann, &request).map_err(|error| show(&error))?;
    let mut motion = plan.motion(&ann, RATES.1 as f64).map_err(|error| show(&error))?;
    ground_reactions(&ann, &mut motion, FEET, &plan).map_err(|error| show(&error))?;

    let planar = planar(&ann)?;
    let text = model(planar.figure())?;
    let every = RATES.1 / RATES.0;
    let rows = (0..motion.len()).step_by(every);
    let coordinates = rows.map(|i| (motion.time()[i], coordinates(&ann, motion.q(i)))).collect::<Vec<_>>();
    let plates = (0..motion.len()).map(|i| {
        let foot = |name: &str| motion.contact(name).map(|track| track.samples[i]).unwrap_or_default();
        (motion.time()[i], [foot(FEET[1]), foot(FEET[0])])
    });
    let files = [
        ("subject.osim", text.into_bytes()),
        ("walk.mot", table("walk", &motion_headings(), &coordinates, true)?),
        ("grf.mot", plates_table(&plates.collect::<Vec<_>>())?),
        ("loads.xml", loads().into_bytes()),
    ];
    for (name, bytes) in files {
        fs::write(folder.join(name), bytes).map_err(|error| format!("{name}: {error}"))?;
        println!("wrote fixtures/subject/{name}");
    }
    Ok(())
}

/// The human with all but the kept degrees of freedom fused where they are zero.
fn planar(ann: &Figure) -> Result<Fused, String> {
    let names = ann.layout().v_names().iter();
    let still: Vec<(&str, f64)> = names
        .filter(|name| KEPT.iter().all(|kept| kept.0 != *name))
        .map(|name| (name.as_str(), 0.0))
        .collect();
    ann.fuse_named(&still).map_err(|error| error.to_string())
}

/// From our frame (x left, y up, z forward) to OpenSim's (x forward, y up, z right).
fn turned(v: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(v.z, v.y, -v.x)
}

/// Our flexion about x is OpenSim's about −z.
fn coordinates(ann: &Figure, q: &[f64]) -> Vec<f64> {
    KEPT.iter()
        .map(|(name, ..)| {
            let value = ann.layout().dof_index(name).map_or(f64::NAN, |dof| q[dof]);
            if name.contains(".r") { -value.to_degrees() } else { value }
        })
        .collect()
}

fn motion_headings() -> Vec<String> {
    KEPT.iter().map(|kept| kept.1.to_owned()).collect()
}

/// A table with so many digits as a laboratory's.
fn table(
    title: &str,
    headings: &[String],
    rows: &[(f64, Vec<f64>)],
    in_degrees: bool,
) -> Result<Vec<u8>, String> {
    // Adding zero takes the sign off a zero.
    let digits = |value: &f64| (value * 1e6).round() / 1e6 + 0.0;
    let columns: Vec<String> = std::iter::once("time".to_owned()).chain(headings.iter().cloned()).collect();
    let values = rows.iter().flat_map(|(time, row)| std::iter::once(time).chain(row)).map(digits).collect();
    let lines = (0..rows.len() as u64).collect();
    let in_degrees = Some(in_degrees);
    let table = Table {
        title: title.to_owned(),
        in_degrees,
        columns,
        values,
        lines,
        header_line: 0,
        ..Table::default()
    };
    let mut text = Vec::new();
    sto::write(&table, &mut text).map_err(|error| error.to_string())?;
    Ok(text)
}

/// Forces, centres of pressure and free moments of both plates; the left foot's headings begin with `1_`.
fn plates_table(rows: &[(f64, [Contact; 2])]) -> Result<Vec<u8>, String> {
    let mut headings = Vec::new();
    for prefix in ["", "1_"] {
        for (what, letter) in [("force", "v"), ("force", "p"), ("torque", "")] {
            headings.extend(["x", "y", "z"].map(|axis| format!("{prefix}ground_{what}_{letter}{axis}")));
        }
    }
    let numbers = |contact: &Contact| {
        let (force, point) = (turned(&contact.force), turned(&contact.cop));
        let free = turned(&contact.moment) - point.cross(&force);
        [force, point, free].iter().flat_map(|v| v.iter().copied().collect::<Vec<_>>()).collect::<Vec<_>>()
    };
    let rows: Vec<(f64, Vec<f64>)> =
        rows.iter().map(|(time, feet)| (*time, feet.iter().flat_map(numbers).collect())).collect();
    table("force plates", &headings, &rows, false)
}

/// OpenSim's description of the forces.
fn loads() -> String {
    let force = |body: &str, prefix: &str| {
        format!(
            "\t\t\t<ExternalForce name=\"{body}\">\n\
             \t\t\t\t<applied_to_body>{body}</applied_to_body>\n\
             \t\t\t\t<force_expressed_in_body>ground</force_expressed_in_body>\n\
             \t\t\t\t<point_expressed_in_body>ground</point_expressed_in_body>\n\
             \t\t\t\t<force_identifier>{prefix}ground_force_v</force_identifier>\n\
             \t\t\t\t<point_identifier>{prefix}ground_force_p</point_identifier>\n\
             \t\t\t\t<torque_identifier>{prefix}ground_torque_</torque_identifier>\n\
             \t\t\t</ExternalForce>\n"
        )
    };
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<OpenSimDocument Version=\"40000\">\n\
         \t<ExternalLoads name=\"plates\">\n\t\t<objects>\n{}{}\t\t</objects>\n\
         \t\t<datafile>grf.mot</datafile>\n\t</ExternalLoads>\n</OpenSimDocument>\n",
        force("calcn_r", ""),
        force("calcn_l", "1_")
    )
}

/// The planar figure as an OpenSim model.
fn model(figure: &Figure) -> Result<String, String> {
    let find = |name: &str| figure.link(name).ok_or_else(|| format!("the planar human has no link '{name}'"));
    let mut bodies = body("pelvis", find("pelvis")?);
    let mut joints = ground_joint();
    for (name, link, joint, parent, coordinate) in BODIES {
        let link = find(link)?;
        bodies += &body(name, link);
        let at = turned(&link.joint().placement().translation.vector);
        joints += &hinge(joint, parent, name, coordinate, &at);
    }
    Ok(format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <!-- A human of 1.75 m and 73 kg in the plane of walking, by `cargo lab subject`. Segment masses: de Leva (1996). -->\n\
         <OpenSimDocument Version=\"40000\">\n\t<Model name=\"subject\">\n\t\t<gravity>0 -9.80665 0</gravity>\n\
         \t\t<length_units>meters</length_units>\n\t\t<force_units>N</force_units>\n\
         \t\t<BodySet name=\"bodyset\">\n\t\t\t<objects>\n{bodies}\t\t\t</objects>\n\t\t</BodySet>\n\
         \t\t<JointSet name=\"jointset\">\n\t\t\t<objects>\n{joints}\t\t\t</objects>\n\t\t</JointSet>\n\
         \t</Model>\n</OpenSimDocument>\n"
    ))
}

fn body(name: &str, link: &Link) -> String {
    #[rustfmt::skip]
    let turn = Matrix3::new(
         0.0, 0.0, 1.0,
         0.0, 1.0, 0.0,
        -1.0, 0.0, 0.0,
    );
    let (com, i) = (turned(link.com()), turn * link.inertia() * turn.transpose());
    let inertia = [i[(0, 0)], i[(1, 1)], i[(2, 2)], i[(0, 1)], i[(0, 2)], i[(1, 2)]];
    format!(
        "\t\t\t\t<Body name=\"{name}\">\n\t\t\t\t\t<mass>{}</mass>\n\t\t\t\t\t<mass_center>{}</mass_center>\n\
         \t\t\t\t\t<inertia>{}</inertia>\n\t\t\t\t</Body>\n",
        link.mass(),
        spaced(com.as_slice()),
        spaced(&inertia)
    )
}

fn spaced(numbers: &[f64]) -> String {
    // Adding zero takes the sign off a zero.
    numbers.iter().map(|x| (x + 0.0).to_string()).collect::<Vec<_>>().join(" ")
}

fn coordinate(name: &str) -> String {
    let (.., lower, upper) = KEPT.iter().find(|kept| kept.1 == name).copied().unwrap_or(("", "", 0.0, 0.0));
    let slides = name.starts_with("pelvis_t") && name != "pelvis_tilt";
    let [lower, upper] = [lower, upper].map(|x| if slides { x } else { x.to_radians() });
    format!(
        "\t\t\t\t\t\t<Coordinate name=\"{name}\">\n\t\t\t\t\t\t\t<range>{lower} {upper}</range>\n\
         \t\t\t\t\t\t</Coordinate>\n"
    )
}

/// One axis of a joint; a function of the coordinate, or zero.
fn axis(name: &str, along: &str, coordinate: &str, function: &str) -> String {
    format!(
        "\t\t\t\t\t\t<TransformAxis name=\"{name}\">\n\t\t\t\t\t\t\t<coordinates>{coordinate}</coordinates>\n\
         \t\t\t\t\t\t\t<axis>{along}</axis>\n\t\t\t\t\t\t\t{function}\n\t\t\t\t\t\t</TransformAxis>\n"
    )
}

const LINE: &str = "<LinearFunction><coefficients>1 0</coefficients></LinearFunction>";
const NOTHING: &str = "<Constant><value>0</value></Constant>";

fn ground_joint() -> String {
    let coordinates: String = ["pelvis_tilt", "pelvis_tx", "pelvis_ty"].map(coordinate).concat();
    let axes = [
        axis("rotation1", "0 0 1", "pelvis_tilt", LINE),
        axis("rotation2", "1 0 0", "", NOTHING),
        axis("rotation3", "0 1 0", "", NOTHING),
        axis("translation1", "1 0 0", "pelvis_tx", LINE),
        axis("translation2", "0 1 0", "pelvis_ty", LINE),
        axis("translation3", "0 0 1", "", NOTHING),
    ];
    custom("ground_pelvis", "/ground", "/bodyset/pelvis", "", &coordinates, &axes.concat())
}

fn custom(name: &str, parent: &str, child: &str, frames: &str, coordinates: &str, axes: &str) -> String {
    format!(
        "\t\t\t\t<CustomJoint name=\"{name}\">\n\t\t\t\t\t<socket_parent_frame>{parent}</socket_parent_frame>\n\
         \t\t\t\t\t<socket_child_frame>{child}</socket_child_frame>\n\
         \t\t\t\t\t<coordinates>\n{coordinates}\t\t\t\t\t</coordinates>\n{frames}\
         \t\t\t\t\t<SpatialTransform>\n{axes}\t\t\t\t\t</SpatialTransform>\n\t\t\t\t</CustomJoint>\n"
    )
}

/// A joint that bends about z at `at` in its parent; a knee's centre moves as it bends.
fn hinge(name: &str, parent: &str, child: &str, angle: &str, at: &Vector3<f64>) -> String {
    let frames = format!(
        "\t\t\t\t\t<frames>\n\t\t\t\t\t\t<PhysicalOffsetFrame name=\"{parent}_offset\">\n\
         \t\t\t\t\t\t\t<socket_parent>/bodyset/{parent}</socket_parent>\n\
         \t\t\t\t\t\t\t<translation>{}</translation>\n\t\t\t\t\t\t\t<orientation>0 0 0</orientation>\n\
         \t\t\t\t\t\t</PhysicalOffsetFrame>\n\t\t\t\t\t</frames>\n",
        spaced(at.as_slice())
    );
    let (parent, child) = (format!("{parent}_offset"), format!("/bodyset/{child}"));
    if !name.starts_with("knee") {
        return format!(
            "\t\t\t\t<PinJoint name=\"{name}\">\n\t\t\t\t\t<socket_parent_frame>{parent}</socket_parent_frame>\n\
             \t\t\t\t\t<socket_child_frame>{child}</socket_child_frame>\n\
             \t\t\t\t\t<coordinates>\n{}\t\t\t\t\t</coordinates>\n{frames}\t\t\t\t</PinJoint>\n",
            coordinate(angle)
        );
    }
    // The condyles roll back and rise as the knee bends: some millimetres, of a round shape.
    let axes = [
        axis("rotation1", "0 0 1", angle, LINE),
        axis("rotation2", "0 1 0", "", NOTHING),
        axis("rotation3", "1 0 0", "", NOTHING),
        axis("translation1", "1 0 0", angle, &spline(|bend| -0.006 * (1.0 - bend.cos()))),
        axis("translation2", "0 1 0", angle, &spline(|bend| 0.004 * bend.sin().powi(2))),
        axis("translation3", "0 0 1", "", NOTHING),
    ];
    custom(name, &parent, &child, &frames, &coordinate(angle), &axes.concat())
}

fn spline(shift: impl Fn(f64) -> f64) -> String {
    let (mut x, mut y) = (String::new(), String::new());
    for k in -12..=1 {
        let bend = f64::from(k) * 0.2;
        let (_, _) = (write!(x, " {bend:.1}"), write!(y, " {:.5}", shift(bend)));
    }
    format!("<SimmSpline><x>{x}</x><y>{y}</y></SimmSpline>")
}
