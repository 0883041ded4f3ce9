//! Velocities at the beginning.

use super::SceneReader;
use super::names::{Meant, in_order};
use solaris_model::JointKind;
use solaris_model::text::{Fields, Node, ReadSpatial as _};

const EXAMPLE: &str = "{\"elbow.rx\": 6.28, \"hip\": (0, 1, 0)}";

impl SceneReader<'_> {
    /// Puts the velocities that the scene says into `v`.
    pub(super) fn velocities(&mut self, fields: &Fields<'_, '_>, v: &mut [f64]) {
        let entries = self.map(fields, "velocities", EXAMPLE);
        let mut found = Vec::new();
        for (key, value) in entries {
            if let Some(velocity) = self.velocity(key, value) {
                found.push(velocity);
            }
        }
        self.twice(entries, &found);
        for (meant, values) in in_order(found) {
            for (i, dof) in meant.dofs.iter().enumerate() {
                v[*dof] = values[i % values.len()];
            }
        }
    }

    /// The three velocities of a ball joint, the six of a free one, or one for all that is meant.
    fn velocity(&mut self, key: &Node<'_>, value: &Node<'_>) -> Option<(Meant, Vec<f64>)> {
        let meant = self.meant(key)?;
        let kind = meant.joint.and_then(|joint| Some(self.figure()?.links()[joint].joint().kind().clone()));
        let values = match kind {
            Some(JointKind::Ball { .. }) => {
                self.reader.vector(value, "the angular velocity")?.as_slice().to_vec()
            }
            Some(JointKind::Free { .. }) => {
                let fields = self.reader.fields(value, &["Motion"], &["moving", "turning"])?;
                let mut vector = |field| {
                    let node = fields.get(field);
                    node.map_or(Some(nalgebra::Vector3::zeros()), |node| self.reader.vector(node, field))
                };
                let (moving, turning) = (vector("moving")?, vector("turning")?);
                moving.iter().chain(turning.iter()).copied().collect()
            }
            _ => {
                let turns = self.names.turn(Some(&meant));
                vec![self.reader.coordinate(value, turns, "the velocity")?]
            }
        };
        Some((meant, values))
    }
}
