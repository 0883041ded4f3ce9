//! The legs that feet are on.

use crate::ground::Sole;
use solaris_model::Figure;

/// By foot, the topmost link of its leg: the last one on the way to the root that carries no other foot.
pub(super) fn hips(figure: &Figure, soles: &[Sole]) -> Vec<usize> {
    let links = figure.links();
    let way = |from: usize| std::iter::successors(Some(from), |link| links[*link].parent());
    let carries = |link: usize, foot: usize| {
        soles.iter().enumerate().any(|(other, sole)| other != foot && way(sole.foot).any(|up| up == link))
    };
    let hip = |(foot, sole): (usize, &Sole)| {
        way(sole.foot).take_while(|link| !carries(*link, foot)).last().unwrap_or(sole.foot)
    };
    soles.iter().enumerate().map(hip).collect()
}
