//! Time of one call of the recursions: for a human, and for chains of growing length, whose time must grow no faster
//! than their length. `cargo bench -p solaris-dynamics`; the growth exponents come last.

#[path = "../tests/support/chain.rs"]
mod chain;

use chain::chain;
use divan::{Bencher, black_box};
use nalgebra::{DMatrix, Vector3};
use solaris_dynamics::{
    Derivatives, Formulation, InverseDynamics, Scalar, Tree, Workspace, forward_dynamics, forward_kinematics,
    inverse_dynamics, inverse_mass_matrix, mass_matrix,
};
use solaris_model::{Figure, human};
use std::time::{Duration, Instant};

const CHAINS: [usize; 4] = [10, 100, 300, 1000];

type Operation = fn(&mut Case<f64>);

fn main() {
    divan::main();
    // `cargo test --benches` runs every benchmark once, to see that it works; then there is nothing to fit.
    if std::env::args().any(|argument| argument == "--bench") {
        report_growth();
    }
}

/// A tree with a state that exercises every term.
struct Case<T> {
    tree: Tree<T>,
    workspace: Workspace<T>,
    q: Vec<T>,
    v: Vec<T>,
    a: Vec<T>,
    tau: Vec<T>,
    matrix: DMatrix<T>,
}

impl<T: Scalar> Case<T> {
    fn new(figure: &Figure) -> Self {
        let tree = Tree::new(figure, Vector3::new(0.0, -9.806_65, 0.0)).expect("finite constants");
        let n = tree.nv();
        let series = |scale: f64, step: f64| {
            (0..n).map(|i| T::from_f64(scale * (step * (i + 1) as f64).sin())).collect()
        };
        Self {
            workspace: Workspace::new(&tree),
            q: series(1.3, 0.7),
            v: series(2.0, 1.1),
            a: series(10.0, 1.9),
            tau: vec![T::zero(); n],
            matrix: DMatrix::zeros(n, n),
            tree,
        }
    }

    fn human() -> Self {
        Self::new(&human(1.75, 73.0).expect("within range"))
    }

    fn chain(links: usize) -> Self {
        Self::new(&chain(links))
    }

    fn inverse(&mut self) {
        let Self { tree, workspace, q, v, a, tau, .. } = self;
        inverse_dynamics(tree, workspace, black_box(q), v, a, &[], tau).expect("a valid state");
        black_box(tau);
    }

    fn forward(&mut self) {
        let Self { tree, workspace, q, v, a, tau, .. } = self;
        forward_dynamics(tree, workspace, black_box(q), v, tau, &[], a).expect("a valid state");
        black_box(a);
    }

    fn inverse_mass_matrix(&mut self) {
        inverse_mass_matrix(&self.tree, &mut self.workspace, black_box(&self.q), &mut self.matrix)
            .expect("a valid state");
        black_box(&mut self.matrix);
    }

    fn kinematics(&mut self) {
        forward_kinematics(&self.tree, &mut self.workspace, black_box(&self.q)).expect("a valid state");
        black_box(&mut self.workspace);
    }

    fn mass_matrix(&mut self) {
        mass_matrix(&self.tree, &mut self.workspace, black_box(&self.q), &mut self.matrix)
            .expect("a valid state");
        black_box(&mut self.matrix);
    }
}

#[divan::bench(types = [f64, f32])]
fn human_inverse_dynamics<T: Scalar>(bencher: Bencher) {
    let mut case = Case::<T>::human();
    bencher.bench_local(|| case.inverse());
}

#[divan::bench(args = Formulation::ALL)]
fn human_by_formulation(bencher: Bencher, formulation: Formulation) {
    let figure = human(1.75, 73.0).expect("within range");
    let mut dynamics = InverseDynamics::<f64>::new(&figure, Vector3::new(0.0, -9.806_65, 0.0), formulation)
        .expect("finite constants");
    let Case { q, v, a, mut tau, .. } = Case::human();
    bencher.bench_local(|| {
        dynamics.solve(black_box(&q), &v, &a, &[], &mut tau).expect("a valid state");
        black_box(&mut tau);
    });
}

#[divan::bench(types = [f64, f32])]
fn human_forward_dynamics<T: Scalar>(bencher: Bencher) {
    let mut case = Case::<T>::human();
    bencher.bench_local(|| case.forward());
}

#[divan::bench]
fn human_inverse_mass_matrix(bencher: Bencher) {
    let mut case = Case::<f64>::human();
    bencher.bench_local(|| case.inverse_mass_matrix());
}

#[divan::bench(types = [f64, f32])]
fn human_forward_kinematics<T: Scalar>(bencher: Bencher) {
    let mut case = Case::<T>::human();
    bencher.bench_local(|| case.kinematics());
}

#[divan::bench(types = [f64, f32])]
fn human_mass_matrix<T: Scalar>(bencher: Bencher) {
    let mut case = Case::<T>::human();
    bencher.bench_local(|| case.mass_matrix());
}

/// The derivatives by `q`, `v` and `a`, all 66 columns of each.
#[divan::bench]
fn human_inverse_dynamics_derivatives(bencher: Bencher) {
    let figure = human(1.75, 73.0).expect("within range");
    let mut derivatives =
        Derivatives::new(&figure, Vector3::new(0.0, -9.806_65, 0.0)).expect("finite constants");
    let Case { q, v, a, .. } = Case::<f64>::human();
    bencher.bench_local(|| {
        black_box(derivatives.inverse_dynamics(black_box(&q), &v, &a, &[]).expect("a valid state"));
    });
}

#[divan::bench(args = CHAINS)]
fn chain_inverse_dynamics(bencher: Bencher, links: usize) {
    let mut case = Case::<f64>::chain(links);
    bencher.bench_local(|| case.inverse());
}

#[divan::bench(args = CHAINS)]
fn chain_forward_dynamics(bencher: Bencher, links: usize) {
    let mut case = Case::<f64>::chain(links);
    bencher.bench_local(|| case.forward());
}

#[divan::bench(args = CHAINS)]
fn chain_forward_kinematics(bencher: Bencher, links: usize) {
    let mut case = Case::<f64>::chain(links);
    bencher.bench_local(|| case.kinematics());
}

#[divan::bench(args = CHAINS)]
fn chain_mass_matrix(bencher: Bencher, links: usize) {
    let mut case = Case::<f64>::chain(links);
    bencher.bench_local(|| case.mass_matrix());
}

/// Prints the exponents `p` of `time ∝ linksᵖ` between chains of 10 and 300 links.
#[allow(clippy::print_stdout, reason = "a benchmark's result is what it prints")]
fn report_growth() {
    let operations: [(&str, Operation); 4] = [
        ("inverse_dynamics", Case::inverse),
        ("forward_dynamics", Case::forward),
        ("forward_kinematics", Case::kinematics),
        ("mass_matrix", Case::mass_matrix),
    ];
    println!("\ngrowth exponents, chains of 10 to 300 links");
    for (name, operation) in operations {
        let (short, long) = (best_time(10, operation), best_time(300, operation));
        let exponent = (long / short).ln() / 30_f64.ln();
        println!("{name:20} {exponent:.3}   ({:.0} ns, {:.0} ns)", short * 1e9, long * 1e9);
    }
}

/// The least mean time of a call (s) over rounds of 5 ms.
fn best_time(links: usize, operation: Operation) -> f64 {
    let mut case = Case::chain(links);
    let mut best = f64::INFINITY;
    for _ in 0..60 {
        let (start, mut calls) = (Instant::now(), 0_u32);
        while start.elapsed() < Duration::from_millis(5) {
            for _ in 0..8 {
                operation(&mut case);
            }
            calls += 8;
        }
        best = best.min(start.elapsed().as_secs_f64() / f64::from(calls));
    }
    best
}
