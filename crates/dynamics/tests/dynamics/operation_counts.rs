//! The table of `docs/operations.md`, counted by running the code over a scalar that counts.

use crate::support::chain::chain;
use nalgebra::Vector3;
use solaris_dynamics::lagrange::{Lagrangian, LagrangianWorkspace, Products, chain_wise, tree_wise};
use solaris_dynamics::scalar::{Counted, Operations};
use solaris_dynamics::{Formulation, InverseDynamics, Tree, Workspace, forward_dynamics, inverse_dynamics};
use solaris_model::{Figure, human};

const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);

/// Multiplications and additions.
type Cost = (f64, f64);

/// A figure of the table, with the lengths of its chains.
struct Column {
    name: &'static str,
    figure: Figure,
    lagrangian: Lagrangian<Counted>,
    chains: Vec<f64>,
}

fn columns() -> Vec<Column> {
    let person = human(1.75, 73.0).expect("within range");
    let stiff = ["neck.rz", "neck.ry", "neck.rx"].map(|dof| (dof, 0.0));
    let fused = person.fuse_named(&stiff).expect("dofs of the human").figure().clone();
    let figures = [
        ("human, 66", person),
        ("human, 63", fused),
        ("chain of 10", chain(10)),
        ("chain of 30", chain(30)),
        ("chain of 100", chain(100)),
    ];
    figures
        .into_iter()
        .map(|(name, figure)| {
            let lagrangian = Lagrangian::new(&figure, GRAVITY).expect("finite constants");
            let chains = lagrangian.chain_lengths().map(|n| n as f64).collect();
            Column { name, figure, lagrangian, chains }
        })
        .collect()
}

/// Uicker's count for one chain of `n`, §3.9.
fn uicker(n: f64) -> Cost {
    let polynomial = |c: [f64; 5]| c.iter().fold(0.0, |sum, c| sum * n + c);
    (polynomial([32.0, 86.0, 171.0, 53.0, -128.0]), polynomial([25.0, 66.0, 129.0, 42.0, -96.0]))
}

/// Hollerbach's count for one chain of `n`, §3.9.
fn hollerbach(n: f64) -> Cost {
    (830.0 * n - 592.0, 675.0 * n - 464.0)
}

/// The totals of §4.6 for one chain of `n`, as printed.
fn printed(n: f64) -> Cost {
    ((810.0 + 2.0 / 3.0) * (n - 1.0) - (546.0 + 2.0 / 3.0), 574.0 * (n - 1.0) - 412.0)
}

/// The sum of the steps of §4.6 for one chain of `n`: 624, 102⅔ and 84 multiplications; 432, 76 and 66 additions.
fn summed(n: f64) -> Cost {
    let steps = |[three, four, five]: [f64; 3], [at_root_three, at_root_four]: [f64; 2]| {
        three * (n - 1.0) + at_root_three + four * (n - 1.0) + at_root_four + five * n
    };
    (steps([624.0, 102.0 + 2.0 / 3.0, 84.0], [112.0, 68.0]), steps([432.0, 76.0, 66.0], [48.0, 48.0]))
}

/// The same with the thesis's 3×3 routines: 270, 82⅔ and 63; 162, 61 and 51.
fn summed_short(n: f64) -> Cost {
    let rest = n - 1.0;
    (
        270.0 * rest + 54.0 + (82.0 + 2.0 / 3.0) * rest + 68.0 + 63.0 * n,
        162.0 * rest + 18.0 + 61.0 * rest + 48.0 + 51.0 * n,
    )
}

fn over(chains: &[f64], count: fn(f64) -> Cost) -> Cost {
    chains.iter().map(|n| count(*n)).fold((0.0, 0.0), |sum, count| (sum.0 + count.0, sum.1 + count.1))
}

fn cost(operations: Operations) -> Cost {
    assert_eq!(operations.divisions, 0);
    (operations.multiplications as f64, operations.additions as f64)
}

/// Any state will do: no operation depends on a value.
fn states(n: usize) -> [Vec<Counted>; 3] {
    [0.7, 1.1, 1.9].map(|step| (0..n).map(|i| Counted::new((step * (i + 1) as f64).sin())).collect())
}

fn lagrangian<P: Products>(lagrangian: &Lagrangian<Counted, P>, by_chains: bool) -> Operations {
    let mut workspace = LagrangianWorkspace::new(lagrangian);
    let [q, v, a] = states(lagrangian.nv());
    let mut tau = vec![Counted::new(0.0); lagrangian.nv()];
    let formulation = if by_chains { chain_wise } else { tree_wise };
    let (result, operations) =
        Counted::measure(|| formulation(lagrangian, &mut workspace, &q, &v, &a, &[], &mut tau));
    assert_eq!(result, Ok(()));
    operations
}

fn newton_euler(figure: &Figure) -> Operations {
    let tree = Tree::<Counted>::new(figure, GRAVITY).expect("finite constants");
    let mut workspace = Workspace::new(&tree);
    let [q, v, a] = states(tree.nv());
    let mut tau = vec![Counted::new(0.0); tree.nv()];
    let (result, operations) =
        Counted::measure(|| inverse_dynamics(&tree, &mut workspace, &q, &v, &a, &[], &mut tau));
    assert_eq!(result, Ok(()));
    operations
}

type Row = (&'static str, fn(&Column) -> Cost);

const ROWS: [Row; 12] = [
    ("Uicker §3.9, one chain of all dofs", |column| uicker(column.lagrangian.nv() as f64)),
    ("Uicker §3.9, sum over chains", |column| over(&column.chains, uicker)),
    ("Hollerbach §3.9, sum over chains", |column| over(&column.chains, hollerbach)),
    ("thesis §4.6, total as printed", |column| over(&column.chains, printed)),
    ("thesis §4.6, sum of its steps", |column| over(&column.chains, summed)),
    ("thesis §4.6, sum of its steps, 3×3", |column| over(&column.chains, summed_short)),
    ("**chain-wise**, full products", |column| {
        cost(lagrangian(&column.lagrangian.clone().with_full_products(), true))
    }),
    ("**tree-wise**, full products", |column| {
        cost(lagrangian(&column.lagrangian.clone().with_full_products(), false))
    }),
    ("**chain-wise**", |column| cost(lagrangian(&column.lagrangian, true))),
    ("**tree-wise**", |column| cost(lagrangian(&column.lagrangian, false))),
    ("**Newton-Euler**", |column| cost(newton_euler(&column.figure))),
    ("sines with cosines, each", |column| {
        let counts = [
            lagrangian(&column.lagrangian, true).sines,
            lagrangian(&column.lagrangian, false).sines,
            newton_euler(&column.figure).sines,
        ];
        assert!(counts.iter().all(|count| *count == counts[0]));
        (counts[0] as f64, 0.0)
    }),
];

/// The table in Markdown.
fn table(columns: &[Column]) -> String {
    let names: Vec<String> = columns.iter().map(|column| format!(" {} |", column.name)).collect();
    let mut lines = vec![
        format!("| multiplications + additions |{}", names.concat()),
        "|---".to_owned() + &"|--:".repeat(5) + "|",
    ];
    for (name, count) in ROWS {
        let cells = columns.iter().map(|column| {
            let (multiplications, additions) = count(column);
            if additions > 0.0 {
                format!(" {} + {} |", thousands(multiplications), thousands(additions))
            } else {
                format!(" {} |", thousands(multiplications))
            }
        });
        lines.push(format!("| {name} |{}", cells.collect::<String>()));
    }
    lines.join("\n")
}

fn thousands(x: f64) -> String {
    if x >= 1e7 {
        return format!("{x:.2e}").replace('e', "·10^");
    }
    let digits = format!("{x:.0}");
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(' ');
        }
        out.push(digit);
    }
    out
}

#[test]
fn the_page_holds_what_is_counted() {
    let page = include_str!("../../../../docs/operations.md");
    let (_, rest) =
        page.split_once("<!-- table: printed by the test operation_counts -->\n").expect("a table");
    let (found, _) = rest.split_once("\n<!-- end of table -->").expect("an end of the table");
    let counted = table(&columns());
    assert!(found == counted, "docs/operations.md should say\n\n{counted}\n");
}

/// The printed totals are not the sums of the printed steps: slip 23 of `docs/sources.md`.
/// All of them answer alike, so that only the cost tells which one ran.
#[test]
fn the_formulation_that_is_chosen_is_the_one_that_runs() {
    let figure = human(1.75, 73.0).expect("within range");
    let equations = Lagrangian::new(&figure, GRAVITY).expect("finite constants");
    for (formulation, expected) in [
        (Formulation::ChainWise, lagrangian(&equations, true)),
        (Formulation::TreeWise, lagrangian(&equations, false)),
        (Formulation::NewtonEuler, newton_euler(&figure)),
    ] {
        let mut dynamics = InverseDynamics::<Counted>::new(&figure, GRAVITY, formulation).expect("finite");
        let [q, v, a] = states(equations.nv());
        let mut tau = vec![Counted::new(0.0); equations.nv()];
        let (result, operations) = Counted::measure(|| dynamics.solve(&q, &v, &a, &[], &mut tau));
        assert_eq!(result, Ok(()));
        assert_eq!(operations, expected, "{formulation:?}");
    }
}

#[test]
fn the_printed_totals_are_off() {
    for n in [1.0, 12.0, 66.0] {
        let (multiplications, additions) = summed(n);
        assert!((multiplications - ((810.0 + 2.0 / 3.0) * n - (546.0 + 2.0 / 3.0))).abs() < 1e-9);
        assert!((additions - (574.0 * n - 412.0)).abs() < 1e-9);
        let (multiplications, additions) = summed_short(n);
        assert!((multiplications - ((415.0 + 2.0 / 3.0) * n - (230.0 + 2.0 / 3.0))).abs() < 1e-9);
        assert!((additions - (274.0 * n - 157.0)).abs() < 1e-9);
        assert!((summed(n).0 - printed(n).0 - (810.0 + 2.0 / 3.0)).abs() < 1e-9);
    }
}

/// Every further link of a chain costs the same.
#[test]
fn the_recursions_are_linear() {
    let period = |start: usize| {
        let count = |links: usize| {
            let lagrangian_of = Lagrangian::<Counted>::new(&chain(links), GRAVITY).expect("finite constants");
            lagrangian(&lagrangian_of, true)
        };
        let (short, long) = (count(start), count(start + 30));
        (long.multiplications - short.multiplications, long.additions - short.additions)
    };
    assert_eq!(period(30), period(90));
}

/// Thirty links more cost the same wherever they are added: the fast forms grow with the number of links, and not faster.
#[test]
fn inverse_and_forward_dynamics_are_linear() {
    let period = |start: usize| {
        let count = |links: usize| {
            let tree = Tree::<Counted>::new(&chain(links), GRAVITY).expect("finite constants");
            let (mut ws, state, mut out) =
                (Workspace::new(&tree), vec![Counted::new(0.3); links], vec![Counted::new(0.0); links]);
            let (done, inverse) =
                Counted::measure(|| inverse_dynamics(&tree, &mut ws, &state, &state, &state, &[], &mut out));
            let (solved, forward) =
                Counted::measure(|| forward_dynamics(&tree, &mut ws, &state, &state, &state, &[], &mut out));
            assert_eq!((done, solved), (Ok(()), Ok(())));
            [inverse, forward].map(|o| [o.multiplications, o.additions, o.divisions])
        };
        let (short, long) = (count(start), count(start + 30));
        [0, 1].map(|i| [0, 1, 2].map(|j| long[i][j] - short[i][j]))
    };
    assert_eq!(period(30), period(270));
}

/// One of Uicker's sums over a chain of one: 32 + 86 + 171 + 53 − 128.
#[test]
fn the_polynomials_are_those_of_the_page() {
    assert!((uicker(1.0).0 - 214.0).abs() < 1e-9 && (uicker(1.0).1 - 166.0).abs() < 1e-9);
    assert!((uicker(63.0).0 / 5.26e8 - 1.0).abs() < 1e-3, "to the three digits of an independent sum");
    assert!((hollerbach(10.0).0 - 7708.0).abs() < 1e-9);
}
