//! Small cases against a dense quadratic programme by another method.

use crate::consistency::support::{GRAVITY, balance, random, rectangle, say};
use nalgebra::{DMatrix, DVector, Vector3};
use solaris_analysis::ground::{
    BalanceFrame, ConsistencyError, ConsistencyOptions, ConsistencyOutcome, consistent,
};

/// What stands: a rectangle's centre, half sizes and turn.
type Foot = (Vector3<f64>, [f64; 2], f64);

/// The least `½ xᵀHx` with `Cx ≤ d`, by Hildreth: coordinates of the dual in turn, `λ ≥ 0` and `x = −H⁻¹Cᵀλ`.
fn hildreth(h: &DMatrix<f64>, c: &DMatrix<f64>, d: &DVector<f64>) -> DVector<f64> {
    let back = h.clone().cholesky().expect("positive").solve(&c.transpose());
    let dual = c * &back;
    let mut force = DVector::zeros(d.len());
    for _ in 0..200_000 {
        let mut moved = 0.0_f64;
        for i in 0..d.len() {
            let slope = d[i] + dual.row(i).dot(&force.transpose());
            let new = (force[i] - slope / dual[(i, i)]).max(0.0);
            moved = moved.max((new - force[i]).abs());
            force[i] = new;
        }
        if moved < 1e-14 {
            break;
        }
    }
    -back * force
}

/// The whole problem, written out: unknowns are the places of frames −1 … n, x and z in turn.
fn reference(
    rate: f64,
    mass: f64,
    frames: &[BalanceFrame],
    feet: &[Option<Foot>],
    options: &ConsistencyOptions,
) -> Vec<Vector3<f64>> {
    let count = frames.len();
    let smooth = (options.smoothing * rate).powi(4);
    let second = |frame: usize, axis: usize, axes: usize, row: &mut DVector<f64>, factor: f64| {
        for (k, w) in [1.0, -2.0, 1.0].into_iter().enumerate() {
            row[(frame + k) * axes + axis] += w * factor;
        }
    };
    let hessian = |axes: usize| {
        let mut h = DMatrix::zeros((count + 2) * axes, (count + 2) * axes);
        for frame in 0..count {
            for axis in 0..axes {
                let at = (frame + 1) * axes + axis;
                h[(at, at)] += 1.0;
                let mut row = DVector::zeros((count + 2) * axes);
                second(frame, axis, axes, &mut row, 1.0);
                h += &row * row.transpose() * smooth;
            }
        }
        h
    };
    let standing: Vec<_> =
        feet.iter().enumerate().filter_map(|(frame, foot)| Some((frame, (*foot)?))).collect();
    let programme = |axes: usize, rows: Vec<(DVector<f64>, f64)>| {
        let c = DMatrix::from_fn(rows.len(), (count + 2) * axes, |i, j| rows[i].0[j]);
        hildreth(&hessian(axes), &c, &DVector::from_iterator(rows.len(), rows.iter().map(|row| row.1)))
    };
    // Upwards: m(g + y″) ≥ f m g, as m/s².
    let rows = standing.iter().map(|(frame, _)| {
        let mut row = DVector::zeros(count + 2);
        second(*frame, 0, 1, &mut row, -rate * rate);
        (row, frames[*frame].force.y / mass - options.least_force * 9.81)
    });
    let y = programme(1, rows.collect());
    // Across: the moment of all forces about the corner's edge decides, (P' − δ − p)·out ≤ −margin, with P' from
    // P'_x = (M_z − …)/F_y written for a ground at y = 0: M = P × F + τ ŷ gives M_z = P_x F_y and M_x = −P_z F_y.
    let mut rows = vec![];
    for (frame, (centre, half, turn)) in standing {
        let BalanceFrame { force, moment, com, .. } = frames[frame];
        let lift = y[frame + 1];
        let rise = (y[frame + 2] - 2.0 * lift + y[frame]) * rate * rate;
        let spin = moment - com.cross(&force);
        let normal = force.y + mass * rise;
        let height = com.y + lift;
        let place = Vector3::new(
            (spin.z + com.x * normal - height * force.x) / normal,
            0.0,
            (-spin.x + com.z * normal - height * force.z) / normal,
        );
        for k in 0..4 {
            let angle = turn + std::f64::consts::FRAC_PI_2 * f64::from(k);
            let (out, reach) = (Vector3::new(angle.cos(), 0.0, -angle.sin()), half[k as usize % 2]);
            let mut row = DVector::zeros((count + 2) * 2);
            for (axis, out) in [out.x, out.z].into_iter().enumerate() {
                second(frame, axis, 2, &mut row, -out * height * mass * rate * rate / normal);
            }
            rows.push((row, reach - options.margin - out.dot(&(place - centre))));
        }
    }
    let across = programme(2, rows);
    (1..=count).map(|k| Vector3::new(across[2 * k], y[k], across[2 * k + 1])).collect()
}

#[test]
fn small_cases_are_those_of_a_dense_programme() {
    let mut seed = 11;
    let mut worst = 0.0_f64;
    for case in 0..40 {
        let (rate, mass, count) = (if case % 2 == 0 { 20.0 } else { 100.0 }, 60.0, 3 + case % 10);
        let smoothing = if case % 3 == 0 { 0.3 } else { 0.05 };
        let options = ConsistencyOptions {
            limit: f64::INFINITY,
            margin: 0.01,
            smoothing,
            tolerance: 1e-9,
            ..Default::default()
        };
        let mut vector =
            |scale: f64| Vector3::new(random(&mut seed), random(&mut seed), random(&mut seed)) * scale;
        let frames: Vec<BalanceFrame> = (0..count)
            .map(|_| balance(mass, Vector3::new(0.1, 0.9, -0.2) + vector(0.05), vector(11.0), vector(20.0)))
            .collect();
        let feet: Vec<_> = (0..count)
            .map(|_| {
                let some = vector(1.0);
                let centre = Vector3::new(0.1 + 0.05 * some.x, 0.0, -0.2 + 0.05 * some.z);
                (some.y > -0.6).then_some((centre, [0.12, 0.05], some.x + some.z))
            })
            .collect();
        let outlines: Vec<Vec<Vector3<f64>>> = feet
            .iter()
            .map(|foot| foot.map_or(vec![], |(centre, half, turn)| rectangle(centre, half, turn)))
            .collect();
        let found = consistent(rate, mass, &GRAVITY, 0.0, &frames, &outlines, &options);
        if outlines.iter().all(Vec::is_empty) {
            assert_eq!(found, Err(ConsistencyError::NothingStands), "case {case}");
            continue;
        }
        let found = found.expect("solved");
        assert_eq!((found.outcome, found.after.frames), (ConsistencyOutcome::Reached, 0), "case {case}");
        for (found, dense) in found.shift.iter().zip(reference(rate, mass, &frames, &feet, &options)) {
            worst = worst.max((found - dense).norm());
        }
    }
    say(&format!("40 small cases: {worst:.1e} m from the dense programme"));
    assert!(worst < 1e-8, "{worst}");
}
