//! dynibo's kernel on a URDF of hinges and slides: see lab/peers/timing.h for what is read, written and said.

use dynibo::Robot;
use std::fs;
use std::hint::black_box;
use std::time::Instant;

fn rows(path: &str) -> Vec<f64> {
    let bytes = fs::read(path).unwrap_or_else(|error| panic!("{path}: {error}"));
    bytes.as_chunks::<8>().0.iter().map(|number| f64::from_le_bytes(*number)).collect()
}

fn write(path: &str, rows: &[f64]) {
    let bytes: Vec<u8> = rows.iter().flat_map(|number| number.to_le_bytes()).collect();
    fs::write(path, bytes).unwrap_or_else(|error| panic!("{path}: {error}"));
}

/// The kernel with states in its own order of joints, and room for a result.
struct Case {
    robot: Robot,
    states: [Vec<f64>; 4],
    out: Vec<f64>,
    n: usize,
}

type Operation = fn(&mut Case, usize);

const OPERATIONS: [(&str, Operation); 3] = [
    ("rnea", |case, i| {
        let Case { robot, states: [q, v, a, _], out, n } = case;
        let at = i * *n..(i + 1) * *n;
        robot.inverse_dynamics(&q[at.clone()], &v[at.clone()], &a[at], &[], &mut out[..*n]).expect("a state");
    }),
    ("aba", |case, i| {
        let Case { robot, states: [q, v, _, tau], out, n } = case;
        let at = i * *n..(i + 1) * *n;
        robot.forward_dynamics(&q[at.clone()], &v[at.clone()], &tau[at], &[], &mut out[..*n]).expect("a state");
    }),
    ("crba", |case, i| {
        let Case { robot, states: [q, ..], out, n } = case;
        robot.mass_matrix(&q[i * *n..(i + 1) * *n], out).expect("a state");
    }),
];

fn time(case: &mut Case, operation: Operation, states: usize, repeats: usize) -> f64 {
    let start = Instant::now();
    for i in 0..repeats {
        operation(case, i % states);
        black_box(&mut case.out);
    }
    start.elapsed().as_secs_f64() * 1e9
}

fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, model, states, out, block, rounds] = &arguments[..] else { panic!("MODEL STATES OUT BLOCK_MS ROUNDS") };
    let (block, rounds): (f64, usize) = (block.parse().expect("ms"), rounds.parse().expect("a number"));
    let robot = Robot::from_urdf(model).expect("a model");
    let n = robot.generalized_count();
    // The joints of the file are called by their column.
    let columns: Vec<usize> = (0..n)
        .map(|k| robot.joint_name(k).expect("a joint").trim_start_matches("dof").parse().expect("a column"))
        .collect();
    let states = ["q", "v", "a", "tau"].map(|what| {
        let rows = rows(&format!("{states}_{what}.f64"));
        rows.chunks_exact(n).flat_map(|row| columns.iter().map(|&k| row[k])).collect::<Vec<_>>()
    });
    let count = states[0].len() / n;
    let mut case = Case { robot, states, out: vec![0.0; n * n], n };
    for (name, operation) in &OPERATIONS[..2] {
        let mut found = vec![0.0; count * n];
        for i in 0..count {
            operation(&mut case, i);
            columns.iter().enumerate().for_each(|(k, &column)| found[i * n + column] = case.out[k]);
        }
        write(&format!("{out}_{name}.f64"), &found);
    }
    let timed = count.min(1024);
    let repeats = OPERATIONS.map(|(_, operation)| {
        let mut repeats = 1;
        loop {
            let taken = time(&mut case, operation, timed, repeats);
            if taken > block * 5e5 {
                break ((repeats as f64 * block * 1e6 / taken) as usize).max(1);
            }
            repeats *= 2;
        }
    });
    let mut times = [const { Vec::new() }; 3];
    for _ in 0..rounds {
        for ((times, (_, operation)), repeats) in times.iter_mut().zip(OPERATIONS).zip(repeats) {
            times.push(time(&mut case, operation, timed, repeats) / repeats as f64);
        }
    }
    for (times, (name, _)) in times.iter_mut().zip(OPERATIONS) {
        times.sort_by(f64::total_cmp);
        println!("RESULT\t{name}\t{:.2}\t{:.2}", times[times.len() / 2], times[0]);
    }
}
