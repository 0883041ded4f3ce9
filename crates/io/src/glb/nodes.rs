//! The nodes of a file: trees of places with turns and scales.

use super::document::{At, Document};
use super::fault::GlbError;
use solaris_model::{Matrix3, Rotation3, UnitQuaternion, Vector3};

/// Where a node is in its parent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Local {
    pub(super) translation: Vector3<f64>,
    pub(super) rotation: UnitQuaternion<f64>,
    pub(super) scale: Vector3<f64>,
}

impl Local {
    fn matrix(&self) -> Matrix3<f64> {
        self.rotation.to_rotation_matrix().matrix() * Matrix3::from_diagonal(&self.scale)
    }
}

/// A place in the world: `x ↦ matrix·x + origin`; its turn is that of all turns above, scales left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct World {
    pub(super) matrix: Matrix3<f64>,
    pub(super) origin: Vector3<f64>,
    pub(super) rotation: UnitQuaternion<f64>,
}

impl World {
    pub(super) fn identity() -> Self {
        Self { matrix: Matrix3::identity(), origin: Vector3::zeros(), rotation: UnitQuaternion::identity() }
    }

    /// The place of what is at `local` in this one.
    pub(super) fn then(&self, local: &Local) -> Self {
        Self {
            matrix: self.matrix * local.matrix(),
            origin: self.matrix * local.translation + self.origin,
            rotation: self.rotation * local.rotation,
        }
    }
}

#[derive(Clone, Debug)]
pub(super) struct Node {
    pub(super) name: String,
    pub(super) parent: Option<usize>,
    pub(super) local: Local,
    /// Whether it says its place by a matrix, which no animation may move.
    pub(super) is_matrix: bool,
}

/// The nodes, and their order in which parents come before children.
#[derive(Debug)]
pub(super) struct Nodes {
    pub(super) nodes: Vec<Node>,
    pub(super) order: Vec<usize>,
}

impl Nodes {
    /// All nodes of a file.
    pub(super) fn of(document: &Document) -> Result<Self, GlbError> {
        let list = document.list("nodes")?;
        let mut nodes = list.iter().map(node).collect::<Result<Vec<_>, _>>()?;
        let mut children = vec![Vec::new(); nodes.len()];
        for (i, at) in list.iter().enumerate() {
            for child in at.get("children").map_or_else(|| Ok(Vec::new()), |list| list.each())? {
                let index = child.index("nodes", nodes.len())?;
                if nodes[index].parent.replace(i).is_some() {
                    let place = format!("nodes[{index}]");
                    return Err(GlbError::Tree { place, why: "is the child of two nodes" });
                }
                children[i].push(index);
            }
        }
        let mut order: Vec<usize> = (0..nodes.len()).filter(|i| nodes[*i].parent.is_none()).collect();
        let mut next = 0;
        while let Some(node) = order.get(next) {
            order.extend(&children[*node]);
            next += 1;
        }
        // Whatever no root leads to stands in a ring.
        if order.len() < nodes.len() {
            let mut found = vec![false; nodes.len()];
            for i in &order {
                found[*i] = true;
            }
            let lost = found.iter().position(|found| !found).unwrap_or(0);
            let place = format!("nodes[{lost}]");
            return Err(GlbError::Tree { place, why: "is below itself, or below one that is" });
        }
        Ok(Self { nodes, order })
    }

    /// Where all nodes are in the world with these places in their parents.
    pub(super) fn worlds(&self, locals: impl Fn(usize) -> Local) -> Vec<World> {
        let mut worlds = vec![World::identity(); self.nodes.len()];
        for i in &self.order {
            let above = self.nodes[*i].parent.map_or_else(World::identity, |parent| worlds[parent]);
            worlds[*i] = above.then(&locals(*i));
        }
        worlds
    }

    /// Where they are while no animation moves them.
    pub(super) fn rest(&self) -> Vec<World> {
        self.worlds(|i| self.nodes[i].local)
    }
}

fn node(at: &At) -> Result<Node, GlbError> {
    let name = at.get("name").and_then(|name| name.text().ok()).unwrap_or_default().to_owned();
    let matrix = at.numbers::<16>("matrix")?;
    let local = if let Some(matrix) = &matrix {
        decomposed(matrix)
    } else {
        let [x, y, z, w] = at.numbers("rotation")?.unwrap_or([0.0, 0.0, 0.0, 1.0]);
        Local {
            translation: at.numbers("translation")?.unwrap_or([0.0; 3]).into(),
            rotation: turn([x, y, z, w]).ok_or_else(|| at.wrong("a node whose rotation has a length"))?,
            scale: at.numbers("scale")?.unwrap_or([1.0; 3]).into(),
        }
    };
    Ok(Node { name, parent: None, local, is_matrix: matrix.is_some() })
}

/// The unit quaternion along these numbers, if they have a direction.
pub(super) fn turn([x, y, z, w]: [f64; 4]) -> Option<UnitQuaternion<f64>> {
    let length = x.hypot(y).hypot(z.hypot(w));
    (length.is_finite() && length > 1e-6)
        .then(|| UnitQuaternion::from_quaternion([x / length, y / length, z / length, w / length].into()))
}

/// Turn and scale of a matrix, column by column; a shear is left out, and what turns a body inside out is a scale along x.
pub(super) fn decomposed(numbers: &[f64; 16]) -> Local {
    let column = |k: usize| Vector3::new(numbers[4 * k], numbers[4 * k + 1], numbers[4 * k + 2]);
    let mut columns = [column(0), column(1), column(2)];
    let mut scale = Vector3::new(columns[0].norm(), columns[1].norm(), columns[2].norm());
    if columns[0].cross(&columns[1]).dot(&columns[2]) < 0.0 {
        scale.x = -scale.x;
        columns[0] = -columns[0];
    }
    let y = columns[1].try_normalize(1e-300).unwrap_or_else(Vector3::y);
    let x = columns[0] - y * columns[0].dot(&y);
    let x = x.try_normalize(1e-300).unwrap_or_else(|| {
        let other = if y.x.abs() < 0.9 { Vector3::x() } else { Vector3::z() };
        (other - y * other.dot(&y)).normalize()
    });
    let axes = Matrix3::from_columns(&[x, y, x.cross(&y)]);
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(axes));
    Local { translation: column(3), rotation, scale }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_is_its_turn_and_its_scale() {
        let turn = UnitQuaternion::from_euler_angles(0.3, -1.1, 2.0);
        for scale in [Vector3::new(0.01, 0.01, 0.01), Vector3::new(-2.0, 3.0, 0.5)] {
            let local = Local { translation: Vector3::new(1.0, 2.0, 3.0), rotation: turn, scale };
            let mut numbers = [0.0; 16];
            for k in 0..3 {
                numbers[4 * k..4 * k + 3].copy_from_slice(local.matrix().column(k).as_slice());
            }
            numbers[12..15].copy_from_slice(local.translation.as_slice());
            let found = decomposed(&numbers);
            assert!((found.matrix() - local.matrix()).amax() < 1e-14, "{found:?}");
            assert!(found.rotation.angle_to(&turn) < 1e-7 && (found.scale - scale).norm() < 1e-14);
        }
    }
}
