//! The flat model text of the driver, as a figure.
//!
//! ```text
//! NAME joints nq nv gx gy gz
//! name type parent  R (9, by rows: parent ← joint)  p (3)  axis (3)  mass  com (3)  Ixx Ixy Ixz Iyy Iyz Izz (about com)
//! ```
//!
//! with a line for each joint, after its parent's; the parent is the number of a line from 0, or −1 for the world. Types:
//! `RX RY RZ RU PX PY PZ PU` turn or slide about x, y, z or `axis`, `SZYX` turns about z, y, x, `T3` slides along x, y, z,
//! `FF` is free.

use solaris_model::{
    Axis, Figure, FigureBuilder, Inertia, Isometry3, Joint, LinkSpec, Matrix3, Rotation3, Vector3,
};

/// A figure and the gravity that it is under.
#[derive(Debug)]
pub(crate) struct Model {
    pub(crate) name: String,
    pub(crate) figure: Figure,
    /// World axes (m/s²).
    pub(crate) gravity: Vector3<f64>,
}

/// Reads a model.
///
/// Joints without a mass between them that stand at one place become one joint, as far as a joint may have as many
/// degrees of freedom: the text needs massless bodies where a figure does not. The state vectors stay as they are.
pub(crate) fn parse(text: &str) -> Result<Model, String> {
    let mut lines = text.lines();
    let head: Vec<&str> = lines.next().unwrap_or_default().split_whitespace().collect();
    let [name, count, nq, nv, gx, gy, gz] = head[..] else {
        return Err("line 1 must be NAME joints nq nv gx gy gz".to_owned());
    };
    let size = |text: &str| text.parse::<usize>().map_err(|_| format!("line 1: '{text}' is no count"));
    let gravity = numbers(&[gx, gy, gz]).map_err(|error| format!("line 1: {error}"))?;
    let rows = lines
        .take(size(count)?)
        .enumerate()
        .map(|(index, line)| Row::parse(line, index).map_err(|error| format!("line {}: {error}", index + 2)))
        .collect::<Result<Vec<_>, _>>()?;
    if rows.len() != size(count)? {
        return Err(format!("{count} joints are announced, but there are {} lines of them", rows.len()));
    }
    let figure = figure(name, rows)?;
    let found = (figure.layout().nq(), figure.layout().nv());
    if found != (size(nq)?, size(nv)?) {
        return Err(format!(
            "nq, nv are said to be {nq}, {nv}, but the joints have {}, {}",
            found.0, found.1
        ));
    }
    Ok(Model { name: name.to_owned(), figure, gravity: Vector3::from_row_slice(&gravity) })
}

/// A joint and the body that it moves.
struct Row {
    name: String,
    kind: Kind,
    parent: Option<usize>,
    placement: Isometry3<f64>,
    mass: f64,
    com: Vector3<f64>,
    inertia: Matrix3<f64>,
}

enum Kind {
    Axes(Vec<Axis>),
    Free,
}

impl Row {
    fn parse(line: &str, index: usize) -> Result<Self, String> {
        let words: Vec<&str> = line.split_whitespace().collect();
        let [name, kind, parent, values @ ..] = &words[..] else {
            return Err("a joint has a name, a type, a parent and 25 numbers".to_owned());
        };
        let x = numbers(values)?;
        if x.len() != 25 {
            return Err(format!("joint '{name}' has {} numbers; there must be 25", x.len()));
        }
        let parent = match *parent {
            "-1" => None,
            text => Some(text.parse().ok().filter(|parent| *parent < index).ok_or_else(|| {
                format!(
                    "joint '{name}' has the parent '{text}'; it must be -1 or the number of a joint before"
                )
            })?),
        };
        let rotation = Matrix3::from_row_slice(&x[..9]);
        if (rotation * rotation.transpose() - Matrix3::identity()).amax() > 1e-9
            || rotation.determinant() < 0.0
        {
            return Err(format!("the rotation of joint '{name}' is none"));
        }
        let [mass, i_xx, i_xy, i_xz, i_yy, i_yz, i_zz] = [x[15], x[19], x[20], x[21], x[22], x[23], x[24]];
        Ok(Self {
            name: (*name).to_owned(),
            kind: kind_of(kind, Vector3::from_row_slice(&x[12..15]))
                .ok_or_else(|| format!("joint '{name}' has the unknown type '{kind}'"))?,
            parent,
            placement: Isometry3::from_parts(
                Vector3::from_row_slice(&x[9..12]).into(),
                Rotation3::from_matrix_unchecked(rotation).into(),
            ),
            mass,
            com: Vector3::from_row_slice(&x[16..19]),
            #[rustfmt::skip]
            inertia: Matrix3::new(
                i_xx, i_xy, i_xz,
                i_xy, i_yy, i_yz,
                i_xz, i_yz, i_zz,
            ),
        })
    }

    /// How many degrees of freedom it could share a joint with; none for a free one.
    fn axes(&self) -> Option<usize> {
        match &self.kind {
            Kind::Axes(axes) => Some(axes.len()),
            Kind::Free => None,
        }
    }

    fn is_massless(&self) -> bool {
        self.mass <= 0.0 && self.inertia.iter().all(|entry| entry.abs() <= 0.0)
    }
}

fn kind_of(name: &str, axis: Vector3<f64>) -> Option<Kind> {
    let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
    let axes = match name {
        "RX" => vec![Axis::rotation(x)],
        "RY" => vec![Axis::rotation(y)],
        "RZ" => vec![Axis::rotation(z)],
        "RU" => vec![Axis::rotation(axis)],
        "PX" => vec![Axis::translation(x)],
        "PY" => vec![Axis::translation(y)],
        "PZ" => vec![Axis::translation(z)],
        "PU" => vec![Axis::translation(axis)],
        "SZYX" => [z, y, x].map(Axis::rotation).to_vec(),
        "T3" => [x, y, z].map(Axis::translation).to_vec(),
        "FF" => return Some(Kind::Free),
        _ => return None,
    };
    Some(Kind::Axes(axes))
}

fn numbers(words: &[&str]) -> Result<Vec<f64>, String> {
    words.iter().map(|word| word.parse().map_err(|_| format!("'{word}' is no number"))).collect()
}

fn figure(name: &str, rows: Vec<Row>) -> Result<Figure, String> {
    let ends = ends_of_groups(&rows);
    let names: Vec<String> = rows.iter().map(|row| row.name.clone()).collect();
    let (mut builder, mut rows, mut first) = (FigureBuilder::new(name), rows.into_iter(), 0);
    while first < names.len() {
        let group: Vec<Row> = rows.by_ref().take(ends[first] - first).collect();
        // A parent is always the last of its own group: the others have one child, which is in the group.
        builder = builder.link(link(group, &names));
        first = ends[first];
    }
    builder.build().map_err(|error| error.to_string())
}

/// For each row the end of the group of rows, one after another, that become one joint.
fn ends_of_groups(rows: &[Row]) -> Vec<usize> {
    let mut children = vec![0; rows.len()];
    rows.iter().filter_map(|row| row.parent).for_each(|parent| children[parent] += 1);
    let mut ends = Vec::with_capacity(rows.len());
    while ends.len() < rows.len() {
        let mut end = ends.len() + 1;
        let mut dofs = rows[end - 1].axes();
        while let Some(next) = rows.get(end)
            && next.parent == Some(end - 1)
            && children[end - 1] == 1
            && rows[end - 1].is_massless()
            && next.placement == Isometry3::identity()
            && let Some(sum) = dofs.zip(next.axes()).map(|(a, b)| a + b).filter(|sum| *sum <= 6)
        {
            dofs = Some(sum);
            end += 1;
        }
        ends.resize(end, end);
    }
    ends
}

/// The link of a group: placed as its first joint, with the body of its last.
fn link(group: Vec<Row>, names: &[String]) -> LinkSpec {
    let (parent, placement) = (group[0].parent, group[0].placement);
    let last = &group[group.len() - 1];
    let (name, mass, com, inertia) = (last.name.clone(), last.mass, last.com, last.inertia);
    let free = matches!(group[0].kind, Kind::Free);
    let mut joint = if free { Joint::free(&name) } else { Joint::new(&name) }.placed(placement);
    for row in group {
        if let Kind::Axes(axes) = row.kind {
            let own_name = (axes.len() == 1).then_some(row.name);
            for axis in axes {
                joint = joint.axis(axis);
                joint = own_name.iter().fold(joint, Joint::named);
            }
        }
    }
    let spec = match parent {
        None => LinkSpec::root(name, joint),
        Some(parent) => LinkSpec::child(name, &names[parent], joint),
    };
    spec.mass(mass).com(com).inertia(Inertia::Tensor(inertia))
}

#[cfg(test)]
mod tests {
    use super::*;

    const HERE: &str = "1 0 0 0 1 0 0 0 1  0 0 0  0 0 0";
    const BODY: &str = "2  0 0.1 0  0.02 0.001 0 0.02 0 0.01";
    const NOTHING: &str = "0  0 0 0  0 0 0 0 0 0";

    /// A model of these joints: name, type, parent, place, body.
    fn model(sizes: &str, joints: &[(&str, &str, &str)]) -> String {
        let lines = joints.iter().map(|(joint, place, body)| format!("{joint} {place} {body}\n"));
        format!("toy {} {sizes} 0 0 -9.81\n{}", joints.len(), lines.collect::<String>())
    }

    #[test]
    fn massless_joints_at_one_place_become_one() {
        let aside = "0 -1 0 1 0 0 0 0 1  0 0.5 0  0 3 4";
        let text = model(
            "11 11",
            &[
                ("slides T3 -1", HERE, NOTHING),
                ("trunk SZYX 0", HERE, BODY),
                ("shoulder_y RY 1", aside, NOTHING),
                ("shoulder_u RU 2", "1 0 0 0 1 0 0 0 1  0 0 0  1 1 0", NOTHING),
                ("arm PU 3", aside, BODY),
                ("head RX 1", HERE, BODY),
                ("jaw RY 5", HERE, BODY),
            ],
        );
        let model = parse(&text).expect("well-formed");
        let links = model.figure.links().iter().map(|link| {
            let axes = link.joint().kind().axes().iter().map(|dof| dof.axis.direction);
            let axes = axes.map(|e| format!("{:?}", e.as_slice())).collect::<Vec<_>>().join(" ");
            format!("{} of {:?}: {} kg, {axes}", link.name(), link.parent(), link.mass())
        });
        let names = model.figure.layout().v_names().join(" ");
        insta::assert_snapshot!(links.chain([names]).collect::<Vec<_>>().join("\n"), @"
        trunk of None: 2 kg, [1.0, 0.0, 0.0] [0.0, 1.0, 0.0] [0.0, 0.0, 1.0] [0.0, 0.0, 1.0] [0.0, 1.0, 0.0] [1.0, 0.0, 0.0]
        shoulder_u of Some(0): 0 kg, [0.0, 1.0, 0.0] [0.7071067811865475, 0.7071067811865475, 0.0]
        arm of Some(1): 2 kg, [0.0, 0.6, 0.8]
        head of Some(0): 2 kg, [1.0, 0.0, 0.0]
        jaw of Some(3): 2 kg, [0.0, 1.0, 0.0]
        trunk.tx trunk.ty trunk.tz trunk.rz trunk.ry trunk.rx shoulder_y shoulder_u arm head jaw
        ");
        let shoulder = model.figure.links()[1].joint().placement();
        assert!((shoulder * Vector3::x() - Vector3::y()).norm() < 1e-15);
    }

    #[test]
    fn a_joint_takes_no_more_than_six() {
        let text =
            model("7 7", &[("a T3 -1", HERE, NOTHING), ("b SZYX 0", HERE, NOTHING), ("c RX 1", HERE, BODY)]);
        assert_eq!(parse(&text).expect("well-formed").figure.links().len(), 2);
    }

    #[test]
    fn a_fork_without_mass_stays_a_link() {
        let joints = [("a RX -1", HERE, NOTHING), ("b RY 0", HERE, BODY), ("c RZ 0", HERE, BODY)];
        assert_eq!(parse(&model("3 3", &joints)).expect("well-formed").figure.links().len(), 3);
    }

    #[test]
    fn a_free_joint_stays_alone() {
        let text = model("8 7", &[("base FF -1", HERE, NOTHING), ("arm RX 0", HERE, BODY)]);
        assert_eq!(parse(&text).expect("well-formed").figure.links().len(), 2);
    }

    #[test]
    fn mistakes_are_answered() {
        let one = |joint: &str, place: &str, sizes: &str| {
            parse(&model(sizes, &[(joint, place, BODY)])).expect_err("a mistake")
        };
        let answers = [
            parse("").expect_err("a mistake"),
            parse("toy 2 1 1 0 0 -9.81\n").expect_err("a mistake"),
            one("a RX", HERE, "1 1"),
            one("a RX 0", HERE, "1 1"),
            one("a RW -1", HERE, "1 1"),
            one("a RX -1", HERE, "2 2"),
            one("a RX -1", &HERE.replacen('1', "2", 1), "1 1"),
            one("a RX -1", &HERE.replacen('1', "one", 1), "1 1"),
            one("a RX -1", "", "1 1"),
        ];
        insta::assert_snapshot!(answers.join("\n"), @r"
        line 1 must be NAME joints nq nv gx gy gz
        2 joints are announced, but there are 0 lines of them
        line 2: joint 'a' has 24 numbers; there must be 25
        line 2: joint 'a' has the parent '0'; it must be -1 or the number of a joint before
        line 2: joint 'a' has the unknown type 'RW'
        nq, nv are said to be 2, 2, but the joints have 1, 1
        line 2: the rotation of joint 'a' is none
        line 2: 'one' is no number
        line 2: joint 'a' has 10 numbers; there must be 25
        ");
    }
}
