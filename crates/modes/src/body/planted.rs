//! Rigid contact and closed loops: wrenches that hold what stands on the ground, and links together.

use super::closures::Closure;
use super::touching::{GroundElement, Lowest};
use crate::contact::{CALM, ContactPatch};
use nalgebra::Vector3;
use solaris_dynamics::{ContactConstraint, Contacts, Scalar, Tree, Workspace, Wrench};
use solaris_profiles::Elementary;

/// Footholds, and after them closed loops, as conditions on the accelerations of links.
#[derive(Clone, Debug)]
pub(super) struct Planted<T> {
    contacts: Contacts<T>,
    holds: Vec<Hold>,
    closures: Vec<Closure<T>>,
}

/// A contact patch: its corners, by the indices of the contact points, and its first condition.
#[derive(Clone, Debug)]
struct Hold {
    corners: Vec<usize>,
    whole: bool,
    first: usize,
    /// Numbers in each condition.
    rows: usize,
}

impl Hold {
    /// How many conditions it is.
    fn len(&self) -> usize {
        if self.whole { 1 } else { self.corners.len() }
    }
}

impl<T: Elementary> Planted<T> {
    /// Those on this ground, and these loops; none where there are neither.
    pub(super) fn new(
        tree: &Tree<T>,
        ground: Option<&GroundElement<T>>,
        patches: &[ContactPatch],
        closures: Vec<Closure<T>>,
    ) -> Option<Self> {
        let (mut holds, mut list) = (Vec::with_capacity(patches.len()), Vec::new());
        let on_ground =
            ground.into_iter().flat_map(|ground| patches.iter().map(move |patch| (ground, patch)));
        for (ground, patch) in on_ground {
            let rows = match (patch.is_whole(), patch.slides) {
                (true, _) => 6,
                (false, false) => 3,
                (false, true) => 1,
            };
            let (corners, whole) = (patch.corners.clone(), patch.is_whole());
            let hold = Hold { corners, whole, first: list.len(), rows };
            for corner in &hold.corners[..hold.len()] {
                let link = ground.spheres()[*corner].link;
                list.push(match (hold.whole, patch.slides) {
                    (true, _) => ContactConstraint::fixed(link, Vector3::zeros()),
                    (false, false) => ContactConstraint::point(link, Vector3::zeros()),
                    (false, true) => ContactConstraint::along(link, Vector3::zeros(), *ground.up()),
                });
            }
            holds.push(hold);
        }
        list.extend(closures.iter().map(Closure::condition));
        (!list.is_empty()).then(|| Self { contacts: Contacts::new(tree, list), holds, closures })
    }

    /// Whether anything stands on the ground.
    pub(super) fn has_footholds(&self) -> bool {
        !self.holds.is_empty()
    }

    /// The loops, for others to take them over.
    pub(super) fn into_closures(self) -> Vec<Closure<T>> {
        self.closures
    }

    /// Asks for the accelerations of what stays, at the poses and velocities in `workspace`: none, or those of a sphere that
    /// rolls. What velocity is left dies out,
    ///
    /// ```text
    /// a = ω × (ω × d) − v/T
    /// ```
    ///
    /// and of what loops hold together also what positions are apart, `a = −2v/T − x/T²`.
    pub(super) fn hold(&mut self, ground: Option<&GroundElement<T>>, workspace: &Workspace<T>) {
        let calm = T::from_f64(CALM.recip());
        if let Some(ground) = ground {
            self.ask(ground, workspace, calm, T::from_f64(1.0));
        }
        self.close(workspace, T::from_f64(2.0) * calm, calm * calm);
    }

    /// Asks for the jumps of the velocities after which it stands, `Δv = −v`.
    pub(super) fn stop(&mut self, ground: Option<&GroundElement<T>>, workspace: &Workspace<T>) {
        if let Some(ground) = ground {
            self.ask(ground, workspace, T::from_f64(1.0), T::zero());
        }
        self.close(workspace, T::from_f64(1.0), T::zero());
    }

    fn close(&mut self, workspace: &Workspace<T>, damping: T, stiffness: T) {
        let conditions = self.contacts.contacts_mut();
        let first = conditions.len() - self.closures.len();
        for (closure, condition) in self.closures.iter_mut().zip(&mut conditions[first..]) {
            closure.ask(workspace, condition, damping, stiffness);
        }
    }

    fn ask(&mut self, ground: &GroundElement<T>, workspace: &Workspace<T>, calm: T, rolling: T) {
        for hold in &self.holds {
            let conditions = &mut self.contacts.contacts_mut()[hold.first..];
            let materials = hold.corners.iter().map(|corner| ground.spheres()[*corner].material(workspace));
            if hold.whole {
                // What neither moves nor turns does not roll.
                let share = T::from_f64((hold.corners.len() as f64).recip());
                let (mut point, mut velocity) = (Vector3::zeros(), Vector3::zeros());
                for material in materials {
                    point += material.point * share;
                    velocity += material.velocity * share;
                }
                let condition = &mut conditions[0];
                condition.point = local(workspace, condition.link, &point);
                condition.acceleration = -velocity * calm;
                condition.angular = Some(-workspace.velocity(condition.link).angular * calm);
            } else {
                for (condition, Lowest { point, velocity, rolling: own }) in
                    conditions.iter_mut().zip(materials)
                {
                    condition.point = local(workspace, condition.link, &point);
                    condition.acceleration = own * rolling - velocity * calm;
                }
            }
        }
    }

    /// The conditions.
    pub(super) fn contacts(&mut self) -> &mut Contacts<T> {
        &mut self.contacts
    }

    /// What the ground does to each contact patch, about the world's origin, as was found last.
    pub(super) fn wrenches(&self) -> impl Iterator<Item = Wrench<T>> {
        self.holds.iter().map(|hold| {
            let found = &self.contacts.wrenches()[hold.first..][..hold.len()];
            let none = Wrench { force: Vector3::zeros(), moment: Vector3::zeros() };
            found.iter().fold(none, |sum, (_, wrench)| Wrench {
                force: sum.force + wrench.force,
                moment: sum.moment + wrench.moment,
            })
        })
    }

    /// The contact patch of which most is missing of what was asked for in the last call, by its index, and how much.
    pub(super) fn most_missing(&self) -> (usize, f64) {
        let (mut most, mut rest) = ((0, 0.0), self.contacts.residuals());
        for (index, hold) in self.holds.iter().enumerate() {
            let rows = hold.len() * hold.rows;
            let (own, others) = rest.split_at(rows);
            rest = others;
            let missing = own.iter().fold(0.0, |most: f64, left| most.max(left.value().abs()));
            if missing > most.1 {
                most = (index, missing);
            }
        }
        most
    }

    /// The force of the ground on all of them (N).
    pub(super) fn force(&self) -> Vector3<T> {
        self.wrenches().fold(Vector3::zeros(), |sum, wrench| sum + wrench.force)
    }

    /// What each loop does to the link that it holds, about the world's origin, as was found last.
    pub(super) fn closing(&self) -> &[(usize, Wrench<T>)] {
        let all = self.contacts.wrenches();
        &all[all.len() - self.closures.len()..]
    }
}

/// A point of the world in a link's frame.
fn local<T: Scalar>(workspace: &Workspace<T>, link: usize, point: &Vector3<T>) -> Vector3<T> {
    let pose = workspace.pose(link);
    pose.rotation.tr_mul(&(point - pose.translation))
}
