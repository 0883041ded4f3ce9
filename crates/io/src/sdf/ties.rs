//! Joints that close a loop, as what holds links together.

use super::joint::Kind;
use solaris_model::{Figure, Placement, Tie, TieEnd, TieLaw, Vector3};

/// A joint that closes a loop.
pub(super) struct Closing {
    pub(super) name: String,
    pub(super) kind: Kind,
    /// Of its parent and its child the bodies, by name, none for the world, and where the joint stands in them.
    pub(super) ends: [(Option<String>, Placement); 2],
    /// Of its first axis, in the joint's frame.
    pub(super) axis: Option<Vector3<f64>>,
}

impl Closing {
    /// What holds its links together as it does, in the pose of the file: for a hinge two points of its axis, a metre apart.
    pub(super) fn ties(self, figure: &Figure) -> Vec<Tie> {
        let at = |point: &Vector3<f64>| self.ends.clone().map(|end| place(figure, end, point));
        let tie =
            |name: &str, point: &Vector3<f64>, law| Tie { name: name.to_owned(), between: at(point), law };
        let origin = Vector3::zeros();
        match (self.kind, self.axis) {
            (Kind::Ball, _) => vec![tie(&self.name, &origin, TieLaw::Points)],
            (Kind::Fixed, _) => vec![tie(&self.name, &origin, TieLaw::Axes)],
            (Kind::Revolute | Kind::Continuous, Some(axis)) => vec![
                tie(&self.name, &origin, TieLaw::Points),
                tie(&format!("{}, its axis", self.name), &axis.normalize(), TieLaw::Points),
            ],
            _ => {
                vec![tie(&self.name, &origin, TieLaw::Other("a joint that slides or turns twice".to_owned()))]
            }
        }
    }
}

/// A point of a joint in the link of the figure that a body is, or is a part of.
fn place(figure: &Figure, (body, joint): (Option<String>, Placement), point: &Vector3<f64>) -> TieEnd {
    let point = moved(&joint, point);
    let Some(body) = body else { return TieEnd { link: None, point } };
    for link in figure.links() {
        // Of what is fixed to a link, and of what does not stand where its joint does, the frame is kept by its name.
        if let Some(frame) = link.frames().iter().find(|frame| frame.name == body) {
            return TieEnd { link: Some(link.name().to_owned()), point: moved(&frame.placement, &point) };
        }
    }
    TieEnd { link: Some(body), point }
}

fn moved(frame: &Placement, point: &Vector3<f64>) -> Vector3<f64> {
    frame.rotation * point + frame.translation.vector
}
