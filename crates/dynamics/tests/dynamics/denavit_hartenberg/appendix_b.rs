//! The 36 tables of the thesis's appendix B: what is printed, and what the rule gives.

use EulerOrder::{Xyz, Xzy, Yxz, Yzx, Zxy, Zyx};
use nalgebra::Matrix3;
use solaris_dynamics::denavit_hartenberg::{DenavitHartenberg, Row, heterogeneous, homogeneous};
use solaris_model::{EulerOrder, FigureBuilder, Joint, LinkSpec, Vector3};
use std::fmt::Write;

/// α and θ (degrees) as printed.
type Printed<const N: usize> = [(i32, i32); N];

/// B.1.
#[rustfmt::skip]
const HOMOGENEOUS: [(EulerOrder, Printed<6>); 6] = [
    (Xyz, [(90, 90), (90, 90), (90, 90), (90, 90), (90, 90), (90, 90)]),
    (Xzy, [(90, 90), (90, 0), (-90, -90), (-90, -90), (-90, -90), (-90, -90)]),
    (Yxz, [(-90, 0), (-90, -90), (-90, -90), (-90, -90), (-90, -90), (-90, -90)]),
    (Yzx, [(-90, 0), (90, 0), (90, 90), (90, 90), (90, 90), (90, 90)]),
    (Zxy, [(0, 0), (90, 90), (90, 90), (90, 90), (90, 90), (90, 90)]),
    (Zyx, [(0, 0), (-90, 0), (90, 90), (-90, 90), (-90, -90), (-90, -90)]),
];

/// B.2.
const HETEROGENEOUS: [(EulerOrder, EulerOrder, Printed<3>); 30] = [
    (Xyz, Xzy, [(90, 90), (-90, 0), (-90, -90)]),
    (Xyz, Yxz, [(-90, 0), (-90, -90), (-90, -90)]),
    (Xyz, Yzx, [(-90, 0), (90, 0), (90, 90)]),
    (Xyz, Zxy, [(0, 0), (90, 90), (90, 90)]),
    (Xyz, Zyx, [(0, 0), (-90, 0), (-90, -90)]),
    (Xzy, Xyz, [(-90, -90), (90, 0), (90, 90)]),
    (Xzy, Yxz, [(0, 0), (-90, -90), (-90, -90)]),
    (Xzy, Yzx, [(0, 0), (90, 0), (90, 90)]),
    (Xzy, Zxy, [(90, 0), (90, 0), (90, 90)]),
    (Xzy, Zyx, [(90, 0), (-90, 0), (-90, -90)]),
    (Yxz, Xyz, [(90, 0), (90, 90), (90, 90)]),
    (Yxz, Xzy, [(90, 0), (-90, 0), (-90, -90)]),
    (Yxz, Yzx, [(-90, -90), (90, 0), (90, 90)]),
    (Yxz, Zxy, [(0, -90), (90, 90), (90, 90)]),
    (Yxz, Zyx, [(0, -90), (-90, 0), (-90, -90)]),
    (Yzx, Xyz, [(0, 0), (90, 90), (-90, 90)]),
    (Yzx, Xzy, [(0, 0), (-90, 0), (-90, -90)]),
    (Yzx, Yxz, [(90, 90), (-90, 0), (-90, -90)]),
    (Yzx, Zxy, [(90, 0), (90, 90), (90, 90)]),
    (Yzx, Zyx, [(-90, 0), (90, 0), (90, 90)]),
    (Zxy, Xyz, [(-90, 0), (90, 0), (90, 90)]),
    (Zxy, Xzy, [(90, 0), (-90, -90), (-90, -90)]),
    (Zxy, Yxz, [(0, 90), (90, -90), (90, -90)]),
    (Zxy, Yzx, [(0, 90), (90, 0), (90, -90)]),
    (Zxy, Zyx, [(90, 90), (-90, 0), (-90, -90)]),
    (Zyx, Xyz, [(0, 90), (90, 90), (90, 90)]),
    (Zyx, Xzy, [(0, 90), (-90, 0), (-90, -90)]),
    (Zyx, Yxz, [(90, 180), (-90, 0), (-90, -90)]),
    (Zyx, Yzx, [(90, 180), (90, 90), (90, 90)]),
    (Zyx, Zxy, [(-90, 90), (90, 0), (90, 90)]),
];

/// One table: its name, its frame before, the axes that it is for, the printed and the derived rows.
struct Table {
    name: String,
    start: Matrix3<f64>,
    axes: Vec<usize>,
    printed: Vec<(i32, i32)>,
    derived: Vec<(i32, i32)>,
}

fn tables() -> Vec<Table> {
    let homogeneous = HOMOGENEOUS.iter().map(|(order, printed)| Table {
        name: format!("{order}"),
        start: Matrix3::identity(),
        axes: [order.axes(), order.axes()].concat(),
        printed: printed.to_vec(),
        derived: homogeneous(*order).map(|row| in_degrees(&row)).to_vec(),
    });
    let heterogeneous = HETEROGENEOUS.iter().map(|(from, to, printed)| {
        // Every right table ends with x along the first and z along the last axis of its joint.
        let [x, _, z] = from.axes().map(|axis| Vector3::ith(axis, 1.0));
        Table {
            name: format!("{from} to {to}"),
            start: Matrix3::from_columns(&[x, z.cross(&x), z]),
            axes: to.axes().to_vec(),
            printed: printed.to_vec(),
            derived: heterogeneous(*from, *to).map(|row| in_degrees(&row)).to_vec(),
        }
    });
    homogeneous.chain(heterogeneous).collect()
}

fn in_degrees(row: &Row) -> (i32, i32) {
    let degrees = [row.alpha, row.theta].map(|angle| {
        let degrees = angle.to_degrees();
        assert!((degrees - degrees.round()).abs() < 1e-12, "{row:?} is no multiple of 90°");
        degrees.round() as i32
    });
    (degrees[0], degrees[1])
}

/// z of each frame, by multiplying out `A = Rz(θ)·Rx(α)`.
fn z_axes(start: &Matrix3<f64>, rows: &[(i32, i32)]) -> Vec<Vector3<f64>> {
    let mut frame = *start;
    rows.iter()
        .map(|&(alpha, theta)| {
            let (alpha, theta) = (f64::from(alpha).to_radians(), f64::from(theta).to_radians());
            frame *= *nalgebra::Rotation3::from_axis_angle(&Vector3::z_axis(), theta).matrix();
            frame *= *nalgebra::Rotation3::from_axis_angle(&Vector3::x_axis(), alpha).matrix();
            frame.column(2).into_owned()
        })
        .collect()
}

impl Table {
    fn is_right(&self, rows: &[(i32, i32)]) -> bool {
        let wanted = self.axes.iter().map(|axis| Vector3::ith(*axis, 1.0));
        z_axes(&self.start, rows).into_iter().zip(wanted).all(|(z, axis)| (z - axis).norm() < 1e-12)
    }

    fn row(&self, rows: &[(i32, i32)]) -> String {
        let signed = |v: &Vector3<f64>| {
            let axis = v.iamax();
            format!("{}{}", if v[axis] > 0.0 { '+' } else { '-' }, ['X', 'Y', 'Z'][axis])
        };
        let axes: Vec<String> = z_axes(&self.start, rows).iter().map(signed).collect();
        let rows: Vec<String> = rows.iter().map(|(alpha, theta)| format!("({alpha},{theta})")).collect();
        format!("{:<58} {:<18}", rows.join(" "), axes.join(" "))
    }
}

/// Of 36 tables 13 are wrong, and the rule agrees with all the others but B.1.vi, which has other rows for the same axes.
#[test]
fn the_rule_gives_the_tables_and_finds_those_that_are_wrong() {
    let tables = tables();
    let mut text = String::new();
    let (mut wrong, mut other_rows) = (0, 0);
    for table in &tables {
        assert!(table.is_right(&table.derived), "the rule is wrong for {}", table.name);
        let verdict = match (table.is_right(&table.printed), table.printed == table.derived) {
            (true, true) => "right",
            (true, false) => {
                other_rows += 1;
                "right, by other rows"
            }
            (false, _) => {
                wrong += 1;
                "WRONG"
            }
        };
        writeln!(text, "{:<15} printed {}  {verdict}", table.name, table.row(&table.printed)).expect("text");
        if table.printed != table.derived {
            writeln!(text, "{:<15} derived {}", "", table.row(&table.derived).trim_end()).expect("text");
        }
    }
    assert_eq!((tables.len(), wrong, other_rows), (36, 13, 1));
    insta::assert_snapshot!(text);
}

/// The rows, shifted by one, are the constants of a figure: row 1 is the base, and row i + 1 that of rationalised link i.
#[test]
fn the_frames_of_two_joints_have_the_rows_of_their_table() {
    for from in EulerOrder::ALL {
        for to in EulerOrder::ALL {
            let joint = |name: &str, order: EulerOrder| {
                order.axes().into_iter().fold(Joint::new(name), |joint, axis| match axis {
                    0 => joint.rx(),
                    1 => joint.ry(),
                    _ => joint.rz(),
                })
            };
            let figure = FigureBuilder::new("two")
                .link(LinkSpec::root("a", joint("a", from)).mass(1.0))
                .link(LinkSpec::child("b", "a", joint("b", to)).mass(1.0))
                .build()
                .expect("valid");
            let links = DenavitHartenberg::of(&figure).expect("known joints").links;
            let found: Vec<Row> =
                links[..5].iter().map(|link| Row { alpha: link.alpha, theta: link.theta }).collect();
            let rows: Vec<Row> = [&homogeneous(from)[1..3], &heterogeneous(from, to)[..]].concat();
            assert_eq!(found, rows, "{from} to {to}");
            assert_eq!(heterogeneous(from, from).as_slice(), &homogeneous(from)[3..]);
        }
    }
}
