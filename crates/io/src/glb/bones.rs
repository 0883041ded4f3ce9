//! Which nodes of a file are bones of its figure.

use super::curves::Animation;
use super::document::Document;
use super::fault::GlbError;
use super::nodes::Nodes;

/// The bones of one figure: nodes, parents before children; bone 0 is above all others.
pub(super) struct Bones {
    pub(super) nodes: Vec<usize>,
    pub(super) parents: Vec<Option<usize>>,
    /// Names of the tops of other trees in the file that have bones, too.
    pub(super) others: Vec<String>,
}

/// The joints of all skins of a file.
pub(super) fn joints(document: &Document, nodes: &Nodes) -> Result<Vec<bool>, GlbError> {
    let mut joints = vec![false; nodes.nodes.len()];
    for skin in document.list("skins")? {
        for joint in skin.need("joints")?.each()? {
            let node = joint.index("nodes", nodes.nodes.len())?;
            joints[node] = true;
        }
    }
    Ok(joints)
}

impl Bones {
    /// The bones of the tree that has most of them: from the lowest node that is above all joints of skins, or where there are none above
    /// all nodes that turn or move, down to each joint and each node that moves.
    pub(super) fn of(
        document: &Document,
        nodes: &Nodes,
        animation: Option<&Animation>,
    ) -> Result<Self, GlbError> {
        let count = nodes.nodes.len();
        let joints = joints(document, nodes)?;
        let moves =
            |i: usize| animation.is_some_and(|a| a.translations[i].is_some() || a.rotations[i].is_some());
        let has_skin = joints.contains(&true);
        let mark = |i: usize| if has_skin { joints[i] } else { moves(i) };
        // How many there are in each node and below, and the top of each node's tree.
        let (mut marks, mut all) = (vec![0_usize; count], vec![0_usize; count]);
        let mut top: Vec<usize> = (0..count).collect();
        for &i in &nodes.order {
            if let Some(parent) = nodes.nodes[i].parent {
                top[i] = top[parent];
            }
        }
        for &i in nodes.order.iter().rev() {
            marks[i] += usize::from(mark(i));
            all[i] += usize::from(mark(i) || moves(i));
            if let Some(parent) = nodes.nodes[i].parent {
                (marks[parent], all[parent]) = (marks[parent] + marks[i], all[parent] + all[i]);
            }
        }
        let tops: Vec<usize> = (0..count).filter(|i| top[*i] == *i && marks[*i] > 0).collect();
        // Of equals the first.
        let most = tops.iter().copied().reduce(|best, i| if marks[i] > marks[best] { i } else { best });
        let most = most.ok_or(GlbError::NoBones)?;
        let of_tree = |i: &usize| top[*i] == most && marks[*i] == marks[most];
        let first = nodes.order.iter().copied().rfind(of_tree).unwrap_or(most);
        let mut place = vec![None; count];
        let mut bones = Self { nodes: Vec::new(), parents: Vec::new(), others: Vec::new() };
        for &i in &nodes.order {
            let parent = nodes.nodes[i].parent.and_then(|parent| place[parent]);
            if i == first || (parent.is_some() && all[i] > 0) {
                place[i] = Some(bones.nodes.len());
                bones.nodes.push(i);
                bones.parents.push(if i == first { None } else { parent });
            }
        }
        bones.others = tops.iter().filter(|i| **i != most).map(|i| nodes.nodes[*i].name.clone()).collect();
        Ok(bones)
    }
}
