//! Which of the things that are asked is found before which.

use super::asked::Asked;
use super::beforehand::carriers;
use solaris_model::Figure;

/// The order in which they are found, as indices; what moves a link, or what it follows, comes before what is asked of that link, and of
/// two that move the same joint the one that begins earlier.
///
/// # Errors
///
/// The index of one that waits for another that waits for it, and why.
pub(super) fn of(figure: &Figure, asked: &[Asked]) -> Result<Vec<usize>, (usize, String)> {
    let needs: Vec<Vec<usize>> = asked
        .iter()
        .map(|one| {
            let mut dofs = carriers(figure, one.link);
            dofs.extend(one.what.followed().into_iter().flat_map(|link| carriers(figure, link)));
            dofs
        })
        .collect();
    let comes_before = |i: usize, j: usize| {
        if asked[i].by.iter().any(|dof| asked[j].by.contains(dof)) {
            return i < j;
        }
        asked[i].by.iter().any(|dof| needs[j].contains(dof))
    };
    let (mut left, mut order): (Vec<usize>, Vec<usize>) = ((0..asked.len()).collect(), Vec::new());
    while !left.is_empty() {
        let next = left.iter().position(|j| !left.iter().any(|i| i != j && comes_before(*i, *j)));
        let Some(next) = next else {
            let (i, one) = (left[0], &asked[left[0]]);
            let other = left.iter().find(|j| **j != i && comes_before(**j, i)).map_or(one, |j| &asked[*j]);
            let message = format!(
                "'{}' has to wait for where '{}' is, and that for this; give one of them a place, or joints that do not move the other",
                one.name, other.name
            );
            return Err((i, message));
        };
        order.push(left.remove(next));
    }
    Ok(order)
}
