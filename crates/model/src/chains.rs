//! The chains of a figure: one from the root to each end-effector.

use crate::figure::Figure;
use crate::link::Link;
use std::fmt;

/// The decomposition of a figure into chains without branches.
///
/// Links that are welded together are one body, and an end-effector is a body without bodies after it. There is one chain
/// for each, from the root to it, in the order of the figure. What a chain shares with earlier ones always stands at its
/// beginning, and is to be counted once.
///
/// ```
/// use solaris_model::{Chains, human};
/// let chains = Chains::of(&human(1.75, 73.0)?);
/// let ends: Vec<_> = chains.iter().map(|chain| chain.end_effector_name()).collect();
/// assert_eq!(ends, ["head", "left_hand", "left_toes", "right_hand", "right_toes"]);
/// assert_eq!((chains.dof_count(), chains.dofs_with_repeats()), (66, 102));
/// # Ok::<(), solaris_model::HumanError>(())
/// ```
///
/// # Source
///
/// Vasilonikolidakis (1991), §4.2 to §4.6. There the root counts as an end-effector where it has one child; such a root
/// begins the one chain here, and ends none.
#[doc(alias = "kinematic chain")]
#[doc(alias = "serial chain")]
#[derive(Clone, Debug)]
pub struct Chains {
    figure: String,
    all: Vec<Chain>,
    link_count: usize,
    dof_count: usize,
}

/// A chain from the root to an end-effector.
#[doc(alias = "kinematic chain")]
#[doc(alias = "serial chain")]
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chain {
    /// Index of its last link that moves against the one before it.
    pub end_effector: usize,
    /// Its links from the root on, with those welded to them.
    pub links: Vec<usize>,
    /// Its degrees of freedom, as indices in `v`.
    pub dofs: Vec<usize>,
    /// How many of the first `links` an earlier chain has as well.
    pub shared_links: usize,
    /// How many of the first `dofs` an earlier chain has as well.
    pub shared_dofs: usize,
    name: String,
}

impl Chain {
    /// Name of the end-effector.
    pub fn end_effector_name(&self) -> &str {
        &self.name
    }
}

impl Chains {
    /// The chains of `figure`.
    pub fn of(figure: &Figure) -> Self {
        let links = figure.links();
        let bodies = bodies(links);
        let mut members = vec![Vec::new(); links.len()];
        for (link, body) in bodies.iter().enumerate() {
            members[*body].push(link);
        }
        let mut seen = vec![false; links.len()];
        let ends = ends(links, &bodies).into_iter();
        let all = ends.map(|end| chain(figure, &bodies, &members, end, &mut seen)).collect();
        Self {
            figure: figure.name().to_owned(),
            all,
            link_count: links.len(),
            dof_count: figure.layout().nv(),
        }
    }

    /// How many chains `figure` has. They may share so much that all of them together are far greater than the figure;
    /// their number is found without them.
    pub fn count(figure: &Figure) -> usize {
        ends(figure.links(), &bodies(figure.links())).len()
    }

    /// The chains, in the order of their end-effectors in the figure.
    pub fn iter(&self) -> std::slice::Iter<'_, Chain> {
        self.all.iter()
    }

    /// Number of chains.
    pub fn len(&self) -> usize {
        self.all.len()
    }

    /// Never: a figure has a root.
    pub fn is_empty(&self) -> bool {
        self.all.is_empty()
    }

    /// Degrees of freedom of the figure.
    pub fn dof_count(&self) -> usize {
        self.dof_count
    }

    /// Degrees of freedom of all chains, those counted again that several of them have.
    pub fn dofs_with_repeats(&self) -> usize {
        self.all.iter().map(|chain| chain.dofs.len()).sum()
    }
}

impl<'a> IntoIterator for &'a Chains {
    type Item = &'a Chain;
    type IntoIter = std::slice::Iter<'a, Chain>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// By link, the link that carries its body: the one of the links welded together that moves against the body before, or the
/// root.
fn bodies(links: &[Link]) -> Vec<usize> {
    let mut bodies: Vec<usize> = Vec::with_capacity(links.len());
    for (i, link) in links.iter().enumerate() {
        bodies.push(match link.parent() {
            Some(parent) if link.joint().kind().nv() == 0 => bodies[parent],
            _ => i,
        });
    }
    bodies
}

/// The bodies without bodies after them.
fn ends(links: &[Link], bodies: &[usize]) -> Vec<usize> {
    let mut has_more = vec![false; links.len()];
    for (link, body) in links.iter().zip(bodies) {
        match link.parent() {
            Some(parent) if bodies[parent] != *body => has_more[bodies[parent]] = true,
            _ => {}
        }
    }
    (0..links.len()).filter(|i| bodies[*i] == *i && !has_more[*i]).collect()
}

/// The chain to the body `end`, with the `members` of each body; marks its bodies as seen.
fn chain(figure: &Figure, bodies: &[usize], members: &[Vec<usize>], end: usize, seen: &mut [bool]) -> Chain {
    let before = |body: &usize| figure.links()[*body].parent().map(|parent| bodies[parent]);
    let mut path: Vec<usize> = std::iter::successors(Some(end), before).collect();
    path.reverse();
    let mut chain = Chain {
        end_effector: end,
        links: Vec::new(),
        dofs: Vec::new(),
        shared_links: 0,
        shared_dofs: 0,
        name: figure.links()[end].name().to_owned(),
    };
    for body in path {
        let joint = figure.layout().joints()[body];
        chain.links.extend(&members[body]);
        chain.dofs.extend(joint.v..joint.v + joint.nv);
        if std::mem::replace(&mut seen[body], true) {
            (chain.shared_links, chain.shared_dofs) = (chain.links.len(), chain.dofs.len());
        }
    }
    chain
}

/// A table: one row a chain, with what earlier chains have as well and its share of the chain's dofs, and the sums.
impl fmt::Display for Chains {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = self.all.iter().map(|chain| chain.name.chars().count()).max().unwrap_or(0).max(12);
        let count = |n: usize, noun: &str| format!("{n} {noun}{}", if n == 1 { "" } else { "s" });
        let (links, dofs) = (count(self.link_count, "link"), count(self.dof_count, "dof"));
        writeln!(f, "{}: {links}, {dofs}, {}", self.figure, count(self.len(), "chain"))?;
        writeln!(f, "{:width$}                       of these in an earlier chain", "")?;
        writeln!(f, "chain  {:<width$}  links   dofs  links   dofs", "end-effector")?;
        let mut row = |number: &str, name: &str, [links, dofs, shared_links, shared_dofs]: [usize; 4]| {
            let percent = 100.0 * shared_dofs as f64 / dofs.max(1) as f64;
            writeln!(
                f,
                "{number:>5}  {name:<width$}  {links:>5}  {dofs:>5}  {shared_links:>5}  {shared_dofs:>5}  {percent:>3.0} %"
            )
        };
        let mut sums = [0; 4];
        for (i, chain) in self.iter().enumerate() {
            let counts = [chain.links.len(), chain.dofs.len(), chain.shared_links, chain.shared_dofs];
            sums = std::array::from_fn(|i| sums[i] + counts[i]);
            row(&(i + 1).to_string(), &chain.name, counts)?;
        }
        row("sum", "", sums)
    }
}
