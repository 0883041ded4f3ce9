//! Single evaluations: the numbers that other engines hold their own kernels to.

use crate::table::{Cell, Table};
use solaris_dynamics::{Tree, Workspace, forward_kinematics, inverse_dynamics, mass_matrix};
use solaris_model::{EulerOrder, Figure, FigureBuilder, Inertia, Joint, LinkSpec, Placement, Vector3};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_6, PI};
use std::fmt::Display;

pub(super) fn table() -> Result<Table, String> {
    let rows = [spherical()?, arm()?].concat();
    Ok(Table {
        header: vec!["engine: test", "what", "as published", "off"],
        rows: rows
            .into_iter()
            .map(|(test, what, published, off)| {
                vec![
                    Cell::text(test),
                    Cell::text(what),
                    Cell::text(published),
                    Cell::Numbers(vec![off.max(1e-13)]),
                ]
            })
            .collect(),
    })
}

/// Test, quantity, what is published, and how far off it is.
type Row = (&'static str, &'static str, String, f64);

/// The greatest difference.
fn apart(published: &[f64], ours: &[f64]) -> f64 {
    published.iter().zip(ours).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn listed(numbers: &[f64]) -> String {
    numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(", ").replace('-', "−")
}

/// Pinocchio: one body on a joint of three rotations, by `unittest/joint-spherical-ZYX` (1 kg at (0.5, 0, 0), unit inertia).
fn spherical() -> Result<Vec<Row>, String> {
    let body = LinkSpec::root("body", Joint::new("root").rz().ry().rx())
        .mass(1.0)
        .com(Vector3::x() * 0.5)
        .inertia(Inertia::diagonal(1.0, 1.0, 1.0));
    let figure = FigureBuilder::new("body").link(body).build().map_err(said)?;
    let tree = Tree::<f64>::new(&figure, Vector3::z() * -9.81).map_err(said)?;
    let mut workspace = Workspace::new(&tree);
    let mut rows = Vec::new();
    let torques = [
        ([0.0; 3], 0.0, [0.0, -4.905, 0.0], "τ, all zero (N m)"),
        ([1.0; 3], 1.0, [-0.536_116_001_950_85, -0.746_218_326_061_88, -0.381_773_290_676_04], "τ, all one"),
        (
            [3.0, 2.0, 1.0],
            1.0,
            [0.739_344_580_940_49, 2.780_453_084_803_1, 0.506_849_409_721_46],
            "τ at (3, 2, 1)",
        ),
    ];
    for (q, rate, published, what) in torques {
        let mut tau = [0.0; 3];
        inverse_dynamics(&tree, &mut workspace, &q, &[rate; 3], &[rate; 3], &[], &mut tau).map_err(said)?;
        rows.push(("Pinocchio: spherical ZYX, rnea", what, listed(&published), apart(&published, &tau)));
    }
    let matrices = [
        ([1.0; 3], [1.072_981_645_431_6, -0.841_470_984_807_9], "M₁₁, M₁₃, all one (kg m²)"),
        ([3.0, 2.0, 1.0], [1.043_294_547_392, -0.909_297_426_825_68], "M₁₁, M₁₃ at (3, 2, 1)"),
    ];
    for (q, published, what) in matrices {
        let mut matrix = nalgebra::DMatrix::zeros(3, 3);
        mass_matrix(&tree, &mut workspace, &q, &mut matrix).map_err(said)?;
        let ours = [matrix[(0, 0)], matrix[(0, 2)]];
        rows.push(("Pinocchio: spherical ZYX, crba", what, listed(&published), apart(&published, &ours)));
    }
    Ok(rows)
}

/// Drake: an arm of seven hinges, by `benchmarks/kuka_iiwa_robot` (numbers of `MotionGenesis`).
fn arm() -> Result<Vec<Row>, String> {
    let figure = iiwa().map_err(said)?;
    let tree = Tree::<f64>::new(&figure, Vector3::z() * -9.81).map_err(said)?;
    let mut workspace = Workspace::new(&tree);
    let (long, short) = (FRAC_PI_3, FRAC_PI_6);
    forward_kinematics(&tree, &mut workspace, &[long, short, long, short, long, short, long])
        .map_err(said)?;
    let end = *workspace.pose(figure.links().len() - 1);
    let turn = [
        [-0.593_900_295_988_020_4, 0.804_386_908_023_956_5, -0.015_625],
        [-0.804_386_908_023_956_5, -0.593_299_112_035_931_7, 0.030_949_408_023_955_21],
        [0.015_625, 0.030_949_408_023_955_27, 0.999_398_816_047_911_4],
    ];
    let place = [0.297_035_645_189_221_9, 0.172_769_696_466_228_8, 1.154_681_973_689_345];
    let turned: Vec<f64> = (0..9).map(|i| end.rotation[(i / 3, i % 3)]).collect();
    let test = "Drake: iiwa, 30° and 60°";
    let mut tau = [0.0; 7];
    inverse_dynamics(
        &tree,
        &mut workspace,
        &[0.0; 7],
        &[0.0; 7],
        &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1000.0],
        &[],
        &mut tau,
    )
    .map_err(said)?;
    let (second, fifth) = (0.0003 * 6.35 * 9.81, 0.0001 * 3.5 * 9.81);
    let torques = [1.0, second + fifth, 1.0, -fifth, 1.0, 0.0, 1.0];
    Ok(vec![
        (test, "the end's rotation", listed(&turn[0]) + ", …", apart(turn.as_flattened(), &turned)),
        (test, "its place (m)", listed(&place), apart(&place, end.translation.as_slice())),
        (
            "Drake: iiwa, upright, the last at 1000 rad/s²",
            "τ (N m)",
            "1, 0.02212155, 1, −0.0034335, 1, 0, 1".to_owned(),
            apart(&torques, &tau),
        ),
    ])
}

fn iiwa() -> Result<Figure, solaris_model::FigureError> {
    // Mass; centre, moments; where the joint is, and how it is turned (X-Y-Z of fixed axes).
    const LINKS: [(f64, [[f64; 3]; 4]); 7] = [
        (5.76, [[0.0, -0.03, 0.12], [0.033, 0.0333, 0.0123], [0.0, 0.0, 0.1575], [0.0; 3]]),
        (6.35, [[0.0003, 0.059, 0.042], [0.0305, 0.0304, 0.011], [0.0, 0.0, 0.2025], [FRAC_PI_2, 0.0, PI]]),
        (3.5, [[0.0, 0.03, 0.13], [0.025, 0.0238, 0.0076], [0.0, 0.2045, 0.0], [FRAC_PI_2, 0.0, PI]]),
        (3.5, [[0.0, 0.067, 0.034], [0.017, 0.0164, 0.006], [0.0, 0.0, 0.2155], [FRAC_PI_2, 0.0, 0.0]]),
        (3.5, [[0.0001, 0.021, 0.076], [0.01, 0.0087, 0.00449], [0.0, 0.1845, 0.0], [-FRAC_PI_2, PI, 0.0]]),
        (1.8, [[0.0, 0.0006, 0.0004], [0.0049, 0.0047, 0.0036], [0.0, 0.0, 0.2155], [FRAC_PI_2, 0.0, 0.0]]),
        (1.2, [[0.0, 0.0, 0.02], [0.001, 0.001, 0.001], [0.0, 0.081, 0.0], [-FRAC_PI_2, PI, 0.0]]),
    ];
    let mut builder = FigureBuilder::new("iiwa14").link(LinkSpec::root("base", Joint::new("base")));
    let mut parent = "base".to_owned();
    for (i, (mass, [com, [xx, yy, zz], at, [roll, pitch, yaw]])) in LINKS.into_iter().enumerate() {
        let name = format!("link{}", i + 1);
        let joint = Joint::new(format!("joint{}", i + 1))
            .placed(Placement::from_parts(
                Vector3::from(at).into(),
                EulerOrder::Zyx.rotation(&[yaw, pitch, roll]),
            ))
            .rz();
        let link = LinkSpec::child(name.clone(), parent, joint);
        builder =
            builder.link(link.mass(mass).com(Vector3::from(com)).inertia(Inertia::diagonal(xx, yy, zz)));
        parent = name;
    }
    builder.build()
}

fn said(error: impl Display) -> String {
    error.to_string()
}
