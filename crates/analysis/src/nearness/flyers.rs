//! What flies apart: the links of a scene's figures, which nothing holds together.

use solaris_model::Figure;

/// The links of a figure by what flies with them.
pub(super) struct Flyers {
    /// Links with a shape of each, and of what does not fly.
    groups: Vec<Vec<usize>>,
    /// Pairs of two groups that are not measured, the smaller link first.
    joined: Vec<[usize; 2]>,
}

impl Flyers {
    /// Those of a figure without these pairs of links.
    pub(super) fn of(figure: &Figure, joined: &[[usize; 2]]) -> Self {
        let (mut groups, mut known) = (Vec::<Vec<usize>>::new(), Vec::new());
        let mut of = vec![None; figure.links().len()];
        for (link, flyer) in figure.flyers().into_iter().enumerate() {
            if figure.links()[link].shape().is_none() {
                continue;
            }
            let group = known.iter().rposition(|other| *other == flyer).unwrap_or_else(|| {
                known.push(flyer);
                groups.push(Vec::new());
                known.len() - 1
            });
            groups[group].push(link);
            of[link] = Some(group);
        }
        let mut joined: Vec<[usize; 2]> = joined.iter().map(|[a, b]| [*a.min(b), *a.max(b)]).collect();
        joined.retain(|[a, b]| of[*a].is_some() && of[*b].is_some() && of[*a] != of[*b]);
        joined.sort_unstable();
        joined.dedup();
        Self { groups, joined }
    }

    /// The links of each.
    pub(super) fn groups(&self) -> impl ExactSizeIterator<Item = &[usize]> {
        self.groups.iter().map(Vec::as_slice)
    }

    /// How many pairs are of two of them.
    pub(super) fn pairs(&self) -> usize {
        let (mut pairs, mut links) = (0, 0);
        for group in &self.groups {
            pairs += links * group.len();
            links += group.len();
        }
        pairs - self.joined.len()
    }

    /// The links of one.
    pub(super) fn links(&self, group: usize) -> &[usize] {
        &self.groups[group]
    }

    /// Whether two links of two groups are not measured.
    pub(super) fn are_joined(&self, pair: [usize; 2]) -> bool {
        self.joined.binary_search(&pair).is_ok()
    }
}
