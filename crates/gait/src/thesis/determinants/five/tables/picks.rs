//! Rules by which the thesis chooses β, ω and ψ out of inequalities, and what they choose.

use super::super::super::proportions::Proportions;
use super::super::super::table::{Cell, GaitTable};
use super::super::closed::{FiveAngles, close};
use super::super::parameters::FiveParameters;
use super::super::presets::Family;

/// The presets at the step frequencies that they were found at, with their postures.
fn presets() -> (Proportions, Vec<FiveAngles>) {
    let body = Proportions::drillis_contini(1.75);
    let all = Family::ALL.iter().flat_map(|family| {
        [80.0, 95.0, 110.0, 120.0, 130.0].map(|frequency| FiveParameters::preset(*family, 1.75, frequency))
    });
    let closed = all.flatten().filter_map(|q| close(&body, &q).ok()).collect();
    (body, closed)
}

/// Roots of `(A² + B²) sin²x − 2BC sin x + C² − A² = 0`, the lesser first.
fn roots(a: f64, b: f64, c: f64) -> [f64; 2] {
    let square = a * a + b * b;
    let half = a * (square - c * c).sqrt();
    [((b * c - half) / square).asin(), ((b * c + half) / square).asin()]
}

/// The four bounds of (8.16) and (8.17) for β.
fn bounds(p: &Proportions, angles: &FiveAngles) -> [f64; 4] {
    let (q, a) = (&angles.parameters, p.leg());
    let (sin, cos) = q.heel_strike_angle.sin_cos();
    let drop = p.hips * q.tilt.sin();
    let c = a * (a * cos + p.ball_ahead * sin) - a * (p.shank + q.landing_height) - p.thigh * drop;
    let [b1, b2] = roots(p.thigh * a, p.ball_ahead * p.thigh, c);
    let [b3, b4] = roots(a, p.ball_ahead, a - drop);
    [b1, b2, b3, b4]
}

#[rustfmt::skip]
pub(super) fn beta() -> GaitTable {
    let mut table = GaitTable::corrected(("8.4", "how β is chosen, and ω"), &["β₁", "β₂", "β₃", "β₄", "condition", "solution"], 0, &[
        &["+", "+", "+", "+", "β₃ ≤ β₁", "β₃/2"],
        &["+", "+", "+", "+", "β₁ < β₃ < β₂", "β₁/2"],
        &["+", "+", "+", "+", "β₃ = β₂", "β₂"],
        &["+", "+", "+", "+", "β₃ > β₂", "β₁/2"],
        &["−", "+", "+", "+", "β₂ < β₃", "β₂+(β₃−β₂)/2"],
        &["−", "+", "+", "+", "β₂ = β₃", "β₃"],
        &["−", "+", "+", "+", "β₃ < β₂ ≤ β₄", "β₄"],
        &["−", "+", "+", "+", "β₂ > β₄", "β₂"],
        &["+", "+", "−", "+", "β₄ < β₁", "β₄+(β₁−β₄)/2"],
        &["+", "+", "−", "+", "β₄ = β₁", "β₁"],
        &["+", "+", "−", "+", "β₁ < β₄ ≤ β₂|β₁ < β₁ ≤ β₂", "β₂"],
        &["+", "+", "−", "+", "β₄ > β₂", "β₄"],
        &["−", "+", "−|+", "+", "β₄ ≤ β₂", "β₂"],
        &["−", "+", "−|+", "+", "β₄ > β₂", "β₄"],
    ], &[
        "The model does not use it. β follows from (8.4) and (8.5) with a given τ, ω from (8.8) and the toes' tip that stays.",
        "The eighth row is not printed.",
    ]);
    for cell in &mut table.rows[7] {
        *cell = Cell::plain(cell.computed.clone());
    }
    let (body, sets) = presets();
    let tilted: Vec<_> = sets.iter().filter(|angles| angles.parameters.tilt > 0.0).collect();
    let picked = tilted.iter().filter(|angles| {
        let [b1, b2, b3, b4] = bounds(&body, angles);
        b1 < 0.0 && b2 > 0.0 && b3 < 0.0 && b4 > 0.0 && b4 <= b2
    });
    // What β = β₂ makes of (8.24), against χ.
    let same = tilted.iter().filter(|angles| {
        let b2 = bounds(&body, angles)[1];
        let q = &angles.parameters;
        let cos = b2.cos() + (body.ball_ahead * b2.sin() + body.hips * q.tilt.sin()) / body.leg();
        (cos.acos() - angles.chi).abs() < 1e-9
    });
    table.notes.push(format!(
        "Of the presets, {} have a tilt. Of these the signs are (−, +, −, +) and β₄ ≤ β₂ in {}, so that the rule picks β₂; in {} \
         this makes α = χ to 1e-9 rad, which condition (i), from which the rule comes, excludes.",
        tilted.len(),
        picked.count(),
        same.count(),
    ));
    table
}

#[rustfmt::skip]
pub(super) fn psi() -> GaitTable {
    let mut table = GaitTable::corrected(("8.5", "how ψ is chosen"), &["ψ least", "ψ greatest", "solution"], 0, &[
        &["+", "+", "ψ least + (ψ greatest − ψ least)/2"],
        &["−", "+", "(ψ greatest)/2"],
        &["+", "−", "none"],
        &["−", "−", "none"],
    ], &[
        "The model does not use it. Clearance and κ are given, so (8.11) is an equation for ψ.",
        "(8.22) and (8.23) are the wrong way round: the hip sinks as ψ grows, so ψ is less than what M gives and more than what \
         K gives.",
    ]);
    let (body, sets) = presets();
    let misses: Vec<f64> = sets.iter().filter_map(|angles| miss(&body, angles)).collect();
    let greatest = misses.iter().copied().fold(0.0, f64::max);
    table.notes.push(format!(
        "K has the swinging thigh upright, often out of the standing leg's reach: both bounds exist for {} of the {} presets. With the middle between them the foot \
         misses its clearance by up to {:.1} mm.",
        misses.len(),
        sets.len(),
        1000.0 * greatest,
    ));
    table
}

/// By how much the clearance is missed with ψ in the middle of its bounds.
fn miss(p: &Proportions, angles: &FiveAngles) -> Option<f64> {
    let q = &angles.parameters;
    let swing = p.forefoot() * angles.epsilon.sin().max(0.0) + p.shank * angles.epsilon.cos() + q.clearance;
    let (sin, cos) = q.heel_strike_angle.sin_cos();
    let m = p.leg() * cos + p.ball_ahead * sin - p.shank - q.landing_height + swing;
    let k = p.thigh + swing;
    let bound = |x: f64| {
        let cos = (x * x + p.shank * p.shank - p.thigh * p.thigh) / (2.0 * x * p.shank);
        (cos.abs() <= 1.0).then(|| cos.acos())
    };
    let psi = 0.5 * (bound(m)? + bound(k)?);
    let mu = (p.shank * psi.sin() / p.thigh).asin();
    let hip = p.thigh * mu.cos() + p.shank * psi.cos();
    Some((hip - p.thigh * q.thigh_swing.cos() - swing).abs())
}
