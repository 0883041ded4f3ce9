//! Table 7.4: the rule that chooses θ₃, beside what is exact.

use crate::thesis::determinants::three::bounds::chi_range;
use crate::thesis::determinants::three::chain::LiftingLeg;
use crate::thesis::determinants::three::printed::{Choice, GridPoint, ROWS, grid};
use crate::thesis::determinants::{Cell, GaitTable, Proportions, thesis_step_length};

/// How the rule's answers stand to the exact ones.
#[derive(Clone, Copy, Debug, Default)]
struct Count {
    table: usize,
    exact: usize,
    wrongly_accepted: usize,
    wrongly_rejected: usize,
}

impl Count {
    fn of(answers: impl Iterator<Item = (bool, bool)>) -> Self {
        answers.fold(Self::default(), |count, (table, exact)| Self {
            table: count.table + usize::from(table),
            exact: count.exact + usize::from(exact),
            wrongly_accepted: count.wrongly_accepted + usize::from(table && !exact),
            wrongly_rejected: count.wrongly_rejected + usize::from(exact && !table),
        })
    }

    fn text(&self, what: &str) -> String {
        let Self { table, exact, wrongly_accepted, wrongly_rejected } = self;
        format!(
            "{what}: {table} by the rule, {exact} exactly; {wrongly_accepted} wrongly accepted, {wrongly_rejected} wrongly rejected"
        )
    }
}

pub(super) fn choice() -> GaitTable {
    let p = Proportions::FIT;
    let points = grid(&p);
    let reached = |row: usize, of: fn(&GridPoint) -> Choice| {
        points.iter().filter(|point| of(point).row == Some(row)).count().to_string()
    };
    let rows = ROWS.iter().enumerate().map(|(i, row)| {
        let signs = row.positive.map(|positive| if positive { "+" } else { "−" }).join(" ");
        // The third block prints one condition twice.
        let condition = if i == 12 {
            Cell::beside("3 > 2", row.condition, false)
        } else {
            Cell::beside(row.condition, row.condition, true)
        };
        vec![
            Cell::plain(signs),
            condition,
            Cell::plain(row.solution),
            Cell::plain(reached(i, |point| point.theta3)),
            Cell::plain(reached(i, |point| point.phi)),
        ]
    });
    let columns =
        ["Signs of roots 1 to 4", "Condition", "Solution", "Grid points for θ₃", "Grid points for φ"];
    GaitTable {
        number: "7.4",
        title: "choice of θ₃ and φ between the roots of two inequalities",
        columns: columns.map(str::to_owned).to_vec(),
        rows: rows.collect(),
        notes: notes(&p, &points),
    }
}

fn notes(p: &Proportions, points: &[GridPoint]) -> Vec<String> {
    let leg = LiftingLeg::of(p);
    // (ii) of some θ₃; (iv) of some φ can always be.
    let theta3_exists = |point: &GridPoint| point.height > leg.lowest(point.alpha);
    let system_exists: Vec<bool> = points
        .iter()
        .map(|point| {
            let step_length = thesis_step_length(p.height, f64::from(point.step_frequency));
            let flexion = f64::from(point.flexion).to_radians();
            chi_range(p, step_length, point.tilt.to_radians())
                .is_some_and(|[least, most]| flexion >= least && flexion < most)
        })
        .collect();
    let theta3 = Count::of(points.iter().map(|point| (point.theta3.angle.is_some(), theta3_exists(point))));
    let phi = Count::of(points.iter().map(|point| (point.phi.angle.is_some(), true)));
    let system = points.iter().zip(&system_exists);
    let by_7_4 = Count::of(system.clone().map(|(point, exists)| (point.solvable, *exists)));
    let by_7_8 = Count::of(system.map(|(point, exists)| (solvable_as_type_5(point), *exists)));
    let lost = |real: bool| {
        let here = |point: &&GridPoint| point.theta3.angle.is_none() && point.theta3.real == real;
        points.iter().filter(here).filter(|point| theta3_exists(point)).count()
    };
    // (7.5), and what (iii) and (iv) leave for some φ.
    let too_far_ahead = |point: &&GridPoint| {
        let omega = point.phi.angle.map(|phi| leg.thigh_for(point.height, phi));
        omega.is_some_and(|omega| omega <= point.alpha && point.height < leg.highest(point.alpha))
    };
    let too_far_ahead = points.iter().filter(too_far_ahead).count();
    vec![
        format!(
            "Of {} points of the thesis's grid (step frequency, δ, χ) the rule reaches three rows.",
            points.len()
        ),
        format!(
            "{}: {} where a root is of a negative number, though the inequality holds for every θ₃, and {} where asin turns a root \
             past 90° back.",
            theta3.text("θ₃ that keeps (ii)"),
            lost(false),
            lost(true)
        ),
        format!("{}.", phi.text("φ that keeps (iv)")),
        format!(
            "(7.15) asks for cos ω < 1 only, where (iii) asks for ω > α: at {too_far_ahead} points the rule's φ breaks (iii), though \
             another would keep it."
        ),
        format!("{}.", by_7_4.text("All four constraints")),
        format!("{}.", by_7_8.text("All four, with θ₃ of the last block alone, as table 7.8 seems to do")),
        "Condition 3 = 2 is printed twice; the second time 3 > 2 must be meant. The rows with four positive roots lack \
         1 < 2 < 3 < 4, and the first is wrong where 4 < 1. It does not matter: root 3 is always negative."
            .to_owned(),
        "Walks are planned with the exact intervals instead: L₃ + L₁ cos α < D < L₁ cos α + g(max(α, γ)), χ < α, and the \
         thighs' angles as the choice."
            .to_owned(),
    ]
}

/// What table 7.8 counts.
pub(super) fn solvable_as_type_5(point: &GridPoint) -> bool {
    point.solvable && point.theta3.is_type_5()
}
