use super::island::SAME_BOUND;
use super::*;
use approx::assert_abs_diff_eq;

const RIGID: (f64, f64) = (f64::INFINITY, 0.0);

/// A block of mass `m` on a plane: its three velocities are the contact's own.
fn block(m: f64, free: [f64; 3], friction: f64, gap: f64) -> ([f64; 3], [f64; 3]) {
    let mut convex = Convex::new(Envelope::full(3), vec![0; 3], 1, 3);
    convex.begin(&DMatrix::from_diagonal_element(3, 3, m), &[0, 1, 2], &free, [0.0; 3].into_iter(), |_| {
        (0.0, 0.0)
    });
    convex.condition();
    for i in 0..3 {
        let mut rows = [0.0; 3];
        rows[i] = 1.0;
        convex.entry(i, rows);
    }
    convex.contact([0.0; 3], friction, gap, RIGID, 0.0, 1e-3);
    assert!(convex.solve() < 10);
    let impulse = convex.impulses(&free).next().expect("one").0;
    ([convex.v[0], convex.v[1], convex.v[2]], impulse)
}

#[test]
fn a_block_sticks_within_the_cone_slides_at_it_and_parts() {
    for mass in [1e-6, 1.0, 1e6] {
        // Down at 1, aside at 0.3 with friction 0.5: it stays, but for the compliance.
        let (v, impulse) = block(mass, [0.3, 0.0, -1.0], 0.5, 0.0);
        assert!(v[0].abs() < 4e-4 && v[2].abs() < 0.03, "{v:?}");
        assert_abs_diff_eq!(impulse[0] / mass, -0.3, epsilon = 4e-4);
        // Aside at 2: friction takes half of what the ground pushes.
        let (v, impulse) = block(mass, [0.0, 2.0, -1.0], 0.5, 0.0);
        assert_abs_diff_eq!(impulse[1], -0.5 * impulse[2], epsilon = 1e-9 * mass);
        assert_abs_diff_eq!(v[1], 2.0 + impulse[1] / mass, epsilon = 1e-9);
        // Away, or not near enough to be reached within the step.
        let is_free = |(_, impulse): ([f64; 3], [f64; 3])| impulse.iter().all(|part| part.abs() < 1e-300);
        assert!(is_free(block(mass, [3.0, 0.0, 0.1], 0.5, 0.0)));
        assert!(is_free(block(mass, [0.0, 0.0, -1.0], 0.5, 1.1e-3)));
        // Without friction, and without anything to rub, nothing pulls.
        assert!(is_free(block(mass, [0.0, 0.0, 1.0], 0.0, 0.0)));
        assert!(is_free(block(mass, [0.0, 0.0, -1.0], 0.0, 1.1e-3)));
    }
}

/// The gradient vanishes, whoever computes it, and no other velocity has a smaller value.
#[test]
fn random_problems_are_at_their_minimum() {
    let random = &mut crate::body::random::Random(7);
    let (mut not_met, mut far_off) = (0, 0);
    for _ in 0..200 {
        let (n, count) = (2 + random.below(10), 1 + random.below(8));
        let root = DMatrix::from_fn(n, n, |_, _| random.between(-1.0, 1.0));
        let mass = &root * root.transpose() + DMatrix::identity(n, n) * 0.05;
        let free = random.numbers(n, 3.0);
        let all: Vec<usize> = (0..n).collect();
        let mut convex = Convex::new(Envelope::full(n), vec![0; n], count, n);
        convex.begin(&mass, &all, &free, std::iter::repeat(0.0), |_| (0.0, 0.0));
        for _ in 0..count {
            convex.condition();
            for column in 0..n {
                if random.chance(0.7) {
                    convex.entry(column, random.vector(1.0).into());
                }
            }
            if random.chance(0.7) {
                let (friction, gap) = (random.between(0.0, 1.5), random.between(-1e-3, 1e-3));
                convex.contact(random.vector(0.5).into(), friction, gap, RIGID, 0.0, 1e-3);
            } else {
                convex.limit(random.between(-1e-3, 1e-3), [0.0; 2], 1e-3);
            }
        }
        let steps = convex.solve();
        assert!(steps < 1000, "{steps}");
        // M·(v − v*) = Jᵀγ.
        let off = nalgebra::DVector::from_iterator(n, convex.v.iter().zip(&free).map(|(v, free)| v - free));
        let mut left = &mass * off;
        let scale = 1.0 + left.amax();
        for condition in &convex.conditions {
            for (column, rows) in &convex.entries[condition.first..][..condition.count] {
                left[*column] -= (0..3).map(|i| rows[i] * condition.pushed.impulse[i]).sum::<f64>();
            }
        }
        assert!(left.amax() < 1e-8 * scale, "{} of {scale}", left.amax());
        let greatest =
            convex.conditions.iter().map(|condition| condition.pushed.impulse[2]).fold(0.0, f64::max);
        let off = convex.conditions.iter().map(|condition| condition.law.off_bound(&condition.pushed));
        let off = off.fold(0.0, f64::max) / greatest.max(f64::MIN_POSITIVE);
        not_met += usize::from(off > SAME_BOUND);
        far_off += usize::from(off > 0.1);
        for condition in &convex.conditions {
            let [x, y, z] = condition.pushed.impulse;
            let Law::Bound { most, .. } = condition.law else { continue };
            assert!(z >= 0.0 && x.hypot(y) <= most * (1.0 + 1e-12), "{condition:?}");
        }
    }
    // Rows that no figure has couple friction and push so that the bound is not always found.
    assert!(not_met < 35 && far_off < 5, "{not_met} and {far_off} of 200");
}

/// `G` is how the impulse falls with the velocity.
#[test]
fn the_stiffness_is_the_slope_of_the_impulse() {
    let random = &mut crate::body::random::Random(3);
    for _ in 0..500 {
        let lightness = [random.between(0.1, 2.0), random.between(0.1, 2.0)];
        let law = Law::contact(lightness, random.between(0.0, 1.2), random.between(-1e-2, 1e-2), RIGID, 1e-2);
        // Both laws, the second with the bound of the first at another velocity.
        let other = law.push(random.vector(0.7).into());
        let law = if random.chance(0.5) { law } else { law.nearer_to(other.impulse[2], 1.0) };
        let u: [f64; 3] = random.vector(0.7).into();
        let Some(stiffness) = law.push(u).stiffness else { continue };
        for j in 0..3 {
            let at = |by: f64| {
                let mut u = u;
                u[j] += by;
                law.push(u).impulse
            };
            let (before, after) = (at(-1e-7), at(1e-7));
            for i in 0..3 {
                let slope = (before[i] - after[i]) / 2e-7;
                let scale = 1.0 + stiffness.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
                assert_abs_diff_eq!(slope, stiffness[i][j], epsilon = 1e-5 * scale);
            }
        }
    }
}

/// A problem of `n` velocities and `count` contacts, each number from `random`, written to the velocities `of` of a greater one.
fn add_problem(
    (mass, free): (&mut DMatrix<f64>, &mut [f64]),
    of: &[usize],
    random: &mut crate::body::random::Random,
) -> Vec<Vec<(usize, [f64; 3])>> {
    let n = of.len();
    let root = DMatrix::from_fn(n, n, |_, _| random.between(-1.0, 1.0));
    let own = &root * root.transpose() + DMatrix::identity(n, n) * 0.05;
    for i in 0..n {
        for j in 0..n {
            mass[(of[i], of[j])] = own[(i, j)];
        }
        free[of[i]] = random.between(-3.0, 3.0);
    }
    (0..=random.below(4)).map(|_| of.iter().map(|row| (*row, random.vector(1.0).into())).collect()).collect()
}

/// The velocities of problems, each a tree of its own, with these contacts.
fn solved(
    (mass, free): (&DMatrix<f64>, &[f64]),
    trees: &[usize],
    contacts: &[Vec<(usize, [f64; 3])>],
) -> Vec<f64> {
    let n = free.len();
    let first = |row: usize| trees.iter().position(|tree| *tree == trees[row]).unwrap_or(0);
    let envelope = Envelope::new((0..n).map(first).collect());
    let mut convex = Convex::new(envelope, trees.to_vec(), contacts.len(), n);
    let all: Vec<usize> = (0..n).collect();
    convex.begin(mass, &all, free, std::iter::repeat(0.0), |_| (0.0, 0.0));
    for contact in contacts {
        convex.condition();
        for (column, rows) in contact {
            convex.entry(*column, *rows);
        }
        convex.contact([0.0; 3], 0.7, 1e-4, RIGID, 0.0, 1e-3);
    }
    convex.solve();
    convex.v.clone()
}

/// What nothing joins moves as it would alone, to the bit, however its velocities lie between those of others; what a condition
/// joins balances together.
#[test]
fn islands_are_as_they_are_alone() {
    let random = &mut crate::body::random::Random(19);
    for _ in 0..50 {
        let trees: Vec<usize> = (0..12).map(|_| random.below(3)).collect();
        let (mut mass, mut free) = (DMatrix::zeros(12, 12), vec![0.0; 12]);
        let mut contacts = Vec::new();
        let of = |tree: usize| (0..12).filter(|row| trees[*row] == tree).collect::<Vec<usize>>();
        for tree in 0..3 {
            let found = add_problem((&mut mass, &mut free), &of(tree), random);
            // The third one touches nothing.
            contacts.extend(found.into_iter().filter(|contact| tree < 2 && !contact.is_empty()));
        }
        let together = solved((&mass, &free), &trees, &contacts);
        for tree in 0..3 {
            let rows = of(tree);
            let place = |row: usize| rows.iter().position(|own| *own == row);
            let own: Vec<Vec<(usize, [f64; 3])>> = contacts
                .iter()
                .map(|contact| {
                    contact.iter().filter_map(|(row, entry)| Some((place(*row)?, *entry))).collect()
                })
                .filter(|contact: &Vec<_>| !contact.is_empty())
                .collect();
            let own_mass = DMatrix::from_fn(rows.len(), rows.len(), |i, j| mass[(rows[i], rows[j])]);
            let own_free: Vec<f64> = rows.iter().map(|row| free[*row]).collect();
            let alone = solved((&own_mass, &own_free), &vec![0; rows.len()], &own);
            let bits = |x: f64| x.to_bits();
            let found = rows.iter().map(|row| bits(together[*row]));
            assert!(found.eq(alone.into_iter().map(bits)), "tree {tree} of {trees:?}");
        }
        // Joined, they balance as one that is full.
        let all = (0..12).filter(|row| trees[*row] < 2).map(|row| (row, random.vector(1.0).into())).collect();
        contacts.push(all);
        let (islands, one) =
            (solved((&mass, &free), &trees, &contacts), solved((&mass, &free), &[0; 12], &contacts));
        for (a, b) in islands.iter().zip(&one) {
            assert_abs_diff_eq!(*a, *b, epsilon = 1e-6);
        }
    }
}
