//! The tree among the joints of a model, which need not form one: which of them hold what, and which close loops.

use std::collections::{BTreeSet, VecDeque};

/// A joint between two links; no link is the world.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) parent: Option<usize>,
    pub(super) child: Option<usize>,
}

/// What holds a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Held {
    /// Nothing.
    Free,
    /// This edge, by its parent.
    By(usize),
    /// This edge, whose parent the link is: it hangs on what the file calls the child.
    Reversed(usize),
}

/// What holds each link, and the edges that are left over: they close loops.
///
/// The first edge of which a link is the child holds it. Where nothing holds a link so, another edge does: one of which it is
/// the child though the world holds neither, or one of which it is the parent and whose child is held already.
pub(super) fn tree(links: usize, edges: &[Edge]) -> (Vec<Held>, Vec<usize>) {
    let mut search = Search::new(links, edges);
    search.reach(None);
    search.spread();
    // Links that no joint holds come first; on what is left, all links hang on each other.
    let heads = (0..links).filter(|link| search.first[*link].is_none());
    for link in heads.chain(0..links).collect::<Vec<_>>() {
        if search.held[link].is_none() {
            search.held[link] = Some(Held::Free);
            search.reach(Some(link));
            search.spread();
        }
    }
    let loops = (0..edges.len()).filter(|edge| !search.used[*edge]).collect();
    (search.held.into_iter().map(|held| held.unwrap_or(Held::Free)).collect(), loops)
}

struct Search<'e> {
    edges: &'e [Edge],
    /// Of each link, the first edge of which it is the child.
    first: Vec<Option<usize>>,
    /// The edges of each link; last, those of the world.
    of: Vec<Vec<usize>>,
    held: Vec<Option<Held>>,
    used: Vec<bool>,
    /// Edges from what is held to the link that they are the first of.
    ahead: VecDeque<usize>,
    /// Other edges of what is held.
    others: BTreeSet<usize>,
}

impl<'e> Search<'e> {
    fn new(links: usize, edges: &'e [Edge]) -> Self {
        let mut first = vec![None; links];
        let mut of = vec![Vec::new(); links + 1];
        for (i, Edge { parent, child }) in edges.iter().enumerate() {
            if let Some(child) = child {
                first[*child] = first[*child].or(Some(i));
            }
            for end in [parent, child] {
                of[end.unwrap_or(links)].push(i);
            }
        }
        let (held, used) = (vec![None; links], vec![false; edges.len()]);
        Self { edges, first, of, held, used, ahead: VecDeque::new(), others: BTreeSet::new() }
    }

    /// Looks at the edges of a link that is held, or of the world.
    fn reach(&mut self, link: Option<usize>) {
        let at = link.unwrap_or(self.held.len());
        for &i in &self.of[at] {
            let Edge { parent, child } = self.edges[i];
            if parent == link && child.is_some_and(|child| self.first[child] == Some(i)) {
                self.ahead.push_back(i);
            } else {
                self.others.insert(i);
            }
        }
    }

    /// Holds all that hangs on what is held.
    fn spread(&mut self) {
        while let Some(i) = self.ahead.pop_front().or_else(|| self.others.pop_first()) {
            let Edge { parent, child } = self.edges[i];
            let is_held =
                |search: &Self, link: Option<usize>| link.is_none_or(|link| search.held[link].is_some());
            let (link, how) = match (is_held(self, parent), is_held(self, child)) {
                (true, false) => (child, Held::By(i)),
                (false, true) => (parent, Held::Reversed(i)),
                _ => continue,
            };
            let Some(link) = link else { continue };
            self.held[link] = Some(how);
            self.used[i] = true;
            self.reach(Some(link));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn edge(parent: usize, child: usize) -> Edge {
        // 9 is the world.
        let link = |link: usize| Some(link).filter(|link| *link != 9);
        Edge { parent: link(parent), child: link(child) }
    }

    #[test]
    fn a_loop_is_opened_at_its_second_joint() {
        let edges = [edge(9, 0), edge(0, 1), edge(0, 2), edge(1, 3), edge(2, 3)];
        let (held, loops) = tree(4, &edges);
        assert_eq!((held, loops), (vec![Held::By(0), Held::By(1), Held::By(2), Held::By(3)], vec![4]));
    }

    #[test]
    fn a_parent_may_hang_on_its_child() {
        // 2 is the parent of 1, which hangs on 0 already; 3 holds the world.
        let (held, loops) = tree(4, &[edge(0, 1), edge(2, 1), edge(3, 9)]);
        assert_eq!(held, [Held::Free, Held::By(0), Held::Reversed(1), Held::Reversed(2)]);
        assert_eq!(loops, [0; 0]);
    }

    #[test]
    fn links_in_a_circle_begin_somewhere() {
        let (held, loops) = tree(3, &[edge(0, 1), edge(1, 2), edge(2, 0)]);
        assert_eq!((held, loops), (vec![Held::Free, Held::By(0), Held::By(1)], vec![2]));
    }
}
