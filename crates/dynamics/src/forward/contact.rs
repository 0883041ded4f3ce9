//! Contacts, with the world or between links, whose acceleration is prescribed and whose wrench is sought.

mod least_norm;

use crate::error::DynamicsError;
use crate::forward::propagation::{accelerate, gather, gather_loads, no_velocity_terms};
use crate::forward::{check_accelerations, check_given, set_state, those};
use crate::inverse::apply_external;
use crate::kinematics::{is_finite, place};
use crate::scalar::Scalar;
use crate::spatial::Wrench;
use crate::spatial::direction::{apply, apply_transposed, cross};
use crate::spatial::load::Load;
use crate::tree::Tree;
use crate::workspace::{Workspace, check_length, check_result};
use least_norm::LeastNorm;
use nalgebra::Vector3;

/// A point of a link, or the link as a whole, held to an acceleration by an unknown force.
#[doc(alias = "RigidConstraintModel")]
#[doc(alias = "constraint")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactConstraint<T> {
    /// The link.
    pub link: usize,
    /// Where it is held, in the link's frame (m).
    pub point: Vector3<T>,
    /// The acceleration of that point (m/s², world axes): zero for one that stays where it is.
    pub acceleration: Vector3<T>,
    /// The angular acceleration of the link (rad/s², world axes) where it is held as well, and so a moment is sought
    /// besides the force; `None` for a contact that hands on a force alone.
    pub angular: Option<Vector3<T>>,
    /// The direction (of length 1, world axes) along which alone the point is held, and the force acts: it slides across it
    /// without friction. `None` for a point that is held in all directions; a link that is held as a whole always is.
    pub along: Option<Vector3<T>>,
    /// Another link, and the point of it (m, its frame), that it is held to: a closed loop. The accelerations are then those relative to
    /// that link, in world axes as ever, and the opposite of the wrench acts there. `None` for what is held to the world.
    pub other: Option<(usize, Vector3<T>)>,
}

impl<T: Scalar> ContactConstraint<T> {
    /// A point of a link (m, link's frame) that stays where it is.
    pub fn point(link: usize, point: Vector3<T>) -> Self {
        Self { link, point, acceleration: Vector3::zeros(), angular: None, along: None, other: None }
    }

    /// A point of a link (m, link's frame) that does not move along a direction (of length 1, world axes).
    pub fn along(link: usize, point: Vector3<T>, direction: Vector3<T>) -> Self {
        Self { along: Some(direction), ..Self::point(link, point) }
    }

    /// A link that neither moves nor turns; the force is said to act at `point` (m, link's frame).
    pub fn fixed(link: usize, point: Vector3<T>) -> Self {
        Self { angular: Some(Vector3::zeros()), ..Self::point(link, point) }
    }

    /// The same where a point of `other` (m, its frame) is what it is held to, instead of the world.
    #[must_use]
    pub fn to(self, other: usize, point: Vector3<T>) -> Self {
        Self { other: Some((other, point)), ..self }
    }

    /// The direction along which alone the point is held.
    fn only(&self) -> Option<&Vector3<T>> {
        self.along.as_ref().filter(|_| self.angular.is_none())
    }

    /// How many numbers are prescribed.
    fn conditions(&self) -> usize {
        match (self.angular, self.along) {
            (Some(_), _) => 6,
            (None, None) => 3,
            (None, Some(_)) => 1,
        }
    }
}

/// The contacts of a figure, with the memory to solve for them: made once, then no call allocates.
#[doc(alias = "constraints")]
#[doc(alias = "constraint solver")]
#[derive(Clone, Debug)]
pub struct Contacts<T> {
    list: Vec<ContactConstraint<T>>,
    solver: LeastNorm<T>,
    /// What is prescribed, less what there is without contact; afterwards what is left of it.
    right: Vec<T>,
    /// Contact accelerations of the last pass.
    found: Vec<T>,
    wrenches: Vec<(usize, Wrench<T>)>,
    /// Accelerations and forces under a unit of one contact force.
    response: Vec<T>,
    response_forces: Vec<T>,
}

/// One scalar condition: a direction of a contact, in world axes.
#[derive(Clone, Copy)]
struct Row<T> {
    contact: ContactConstraint<T>,
    axis: Vector3<T>,
    turns: bool,
}

impl<T: Scalar> Row<T> {
    /// What a unit along `axis` (world axes) at a point of a link is for it, in its frame.
    fn load(&self, ws: &Workspace<T>, link: usize, point: &Vector3<T>, axis: Vector3<T>) -> Load<T> {
        let axis = apply_transposed(&ws.poses[link].rotation, &axis);
        if self.turns {
            Load { force: Vector3::zeros(), moment: axis }
        } else {
            Load { force: axis, moment: cross(point, &axis) }
        }
    }
}

impl<T: Scalar> Contacts<T> {
    /// Contacts of a figure.
    pub fn new(tree: &Tree<T>, contacts: Vec<ContactConstraint<T>>) -> Self {
        let rows = contacts.iter().map(ContactConstraint::conditions).sum();
        let nothing = Wrench { force: Vector3::zeros(), moment: Vector3::zeros() };
        Self {
            wrenches: contacts.iter().map(|contact| (contact.link, nothing)).collect(),
            list: contacts,
            solver: LeastNorm::new(rows),
            right: vec![T::zero(); rows],
            found: vec![T::zero(); rows],
            response: vec![T::zero(); tree.nv()],
            response_forces: vec![T::zero(); tree.nv()],
        }
    }

    /// The contacts, to change what is prescribed between calls. Another number of conditions than before is refused.
    pub fn contacts_mut(&mut self) -> &mut [ContactConstraint<T>] {
        &mut self.list
    }

    /// Link and wrench that acts on it (world axes, about the world's origin), by contact, as the last call found them. What it is
    /// held to bears the opposite, at the point that it is held by.
    pub fn wrenches(&self) -> &[(usize, Wrench<T>)] {
        &self.wrenches
    }

    /// What the last call left of the prescribed accelerations, by contact and axis (three linear, then three angular
    /// where there are such; one for a point that is held along a direction): rounding, unless the contacts ask for what they cannot have together.
    pub fn residuals(&self) -> &[T] {
        &self.right
    }

    fn rows(&self) -> impl Iterator<Item = Row<T>> + '_ {
        self.list.iter().flat_map(|&contact| {
            (0..contact.conditions()).map(move |row| {
                let axis = contact.only().copied().unwrap_or_else(|| Vector3::ith(row % 3, T::one()));
                Row { contact, axis, turns: row >= 3 }
            })
        })
    }
}

/// Hybrid dynamics with contacts and closed loops: finds their wrenches along with the unknown accelerations and forces.
///
/// As [`crate::hybrid_dynamics`], and besides, the contacts' accelerations are prescribed and their wrenches `λ` unknown:
///
/// ```text
/// J_D·M_DD⁻¹·J_Dᵀ·λ = a_c − (J·q̈ + J̇·v) without contact
/// ```
///
/// with one pass each way for each column of the left side. Where contacts share what they hold (four feet of a stiff
/// table), only the sum of their effects is determined: of all `λ` that bring the accelerations about, the one with the
/// **least sum of squares** (N and N m alike) is given. The rows are taken in the order of how much of their own inverse
/// inertia is left once the rows before them hold; one of which less than the root of the precision is left counts as
/// dependent. Where dependent rows contradict each other, or something prescribed does, some have to give in.
///
/// Returns how much is missing: the greatest difference between a prescribed acceleration of a contact and the one found
/// (m/s² and rad/s² alike), rounding unless the contacts cannot have what they ask for. [`Contacts::residuals`] has all.
///
/// The contacts pull as well as push, and do not slip: whether they would is for the caller to see from the wrenches.
/// Also places the links.
///
/// # Errors
///
/// As for [`crate::hybrid_dynamics`], and [`DynamicsError::Contact`] for a contact with a link that does not exist, with itself, or with
/// a number that is not finite.
///
/// # Examples
///
/// A rod on two pins along its length: what each carries along it is not determined, so that each carries half.
///
/// ```
/// use solaris_dynamics::{ContactConstraint, Contacts, Tree, Workspace, contact_dynamics};
/// use solaris_model::{FigureBuilder, Inertia, Joint, LinkSpec, Vector3};
///
/// let rod = LinkSpec::root("rod", Joint::free("root")).mass(2.0).inertia(Inertia::diagonal(0.1, 0.01, 0.1));
/// let figure = FigureBuilder::new("rod").link(rod).build()?;
/// let tree = Tree::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0))?;
/// let mut workspace = Workspace::new(&tree);
/// let pins = [0.5, -0.5].map(|y| ContactConstraint::point(0, Vector3::new(0.0, y, 0.0)));
/// let mut contacts = Contacts::new(&tree, pins.to_vec());
/// let q = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
/// let (mut a, mut tau) = ([0.0; 6], [0.0; 6]);
/// let (v, free) = ([0.0; 6], [false; 6]);
/// let missing = contact_dynamics(&tree, &mut workspace, &mut contacts, &q, &v, &free, &[], &mut a, &mut tau)?;
/// assert!(missing < 1e-12 && a.iter().all(|a| a.abs() < 1e-12));
/// assert!((contacts.wrenches()[0].1.force.y - 9.81).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "constrained forward dynamics")]
#[doc(alias = "constraintDynamics")]
#[doc(alias = "kkt")]
#[expect(
    clippy::too_many_arguments,
    reason = "the state, what is known and what is sought are slices of their own"
)]
pub fn contact_dynamics<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    contacts: &mut Contacts<T>,
    q: &[T],
    v: &[T],
    prescribed: &[bool],
    external: &[(usize, Wrench<T>)],
    a: &mut [T],
    tau: &mut [T],
) -> Result<f64, DynamicsError> {
    check_length("prescribed", prescribed.len(), tree.nv())?;
    check_given("a", a, tree, |k| prescribed[k])?;
    check_given("tau", tau, tree, |k| !prescribed[k])?;
    check_contacts(tree, contacts)?;
    let held = those(prescribed);
    set_state(tree, workspace, q, v, external)?;
    place(tree, workspace)?;
    gather(tree, workspace, held, a, tau);
    accelerate(tree, workspace, &-tree.gravity, held, a, tau);
    check_accelerations(tree, workspace, a)?;
    measure(tree, workspace, contacts, true);
    prescribe(contacts);

    respond(tree, workspace, contacts, held);
    contacts.solver.solve(&contacts.right);
    collect(workspace, contacts);

    set_state(tree, workspace, q, v, external)?;
    apply_external(tree, workspace, &contacts.wrenches)?;
    for contact in 0..contacts.list.len() {
        if let Some(opposite) = opposite(workspace, contacts, contact) {
            apply_external(tree, workspace, &[opposite])?;
        }
    }
    gather(tree, workspace, held, a, tau);
    accelerate(tree, workspace, &-tree.gravity, held, a, tau);
    check_accelerations(tree, workspace, a)?;
    check_result("a force of hybrid dynamics", tau)?;
    measure(tree, workspace, contacts, true);
    prescribe(contacts);
    Ok(contacts.right.iter().fold(0.0, |missing, left| left.greatest().max((-*left).greatest()).max(missing)))
}

fn check_contacts<T: Scalar>(tree: &Tree<T>, contacts: &Contacts<T>) -> Result<(), DynamicsError> {
    if contacts.response.len() != tree.nv() {
        return Err(DynamicsError::Workspace);
    }
    check_length("the conditions of all contacts", contacts.rows().count(), contacts.right.len())?;
    for (index, contact) in contacts.list.iter().enumerate() {
        let or_none = |vector: Option<Vector3<T>>| vector.unwrap_or_else(Vector3::zeros);
        let (angular, along) = (or_none(contact.angular), or_none(contact.along));
        let (other, point) = contact.other.unwrap_or((tree.link_count(), Vector3::zeros()));
        let numbers = [contact.point, contact.acceleration, angular, along, point];
        let exists = contact.link < tree.link_count()
            && contact.other.is_none_or(|_| other < tree.link_count() && other != contact.link);
        if !exists || !numbers.iter().all(is_finite) {
            let (contact, last) = (format!("{contact:?}"), tree.link_count() - 1);
            return Err(DynamicsError::Contact { index, contact, last });
        }
    }
    Ok(())
}

/// The acceleration of a point of a link (link's frame), and of the link's turning, in the last pass, in world axes; `moving` takes in what
/// velocities and the gravity of the world bring.
fn acceleration<T: Scalar>(
    tree: &Tree<T>,
    ws: &Workspace<T>,
    (link, point): (usize, &Vector3<T>),
    moving: bool,
) -> [Vector3<T>; 2] {
    let (motion, rotation) = (&ws.motions[link], &ws.poses[link].rotation);
    let mut linear = motion.acceleration + cross(&motion.angular_acceleration, point);
    if moving {
        linear += cross(&motion.angular, &cross(&motion.angular, point));
    }
    let mut linear = apply(rotation, &linear);
    if moving {
        linear += tree.gravity;
    }
    [linear, apply(rotation, &motion.angular_acceleration)]
}

/// Accelerations of the contacts in the last pass; `moving` as for [`acceleration`].
fn measure<T: Scalar>(tree: &Tree<T>, ws: &Workspace<T>, contacts: &mut Contacts<T>, moving: bool) {
    let mut row = 0;
    for contact in &contacts.list {
        let [mut linear, mut angular] = acceleration(tree, ws, (contact.link, &contact.point), moving);
        if let Some((other, point)) = &contact.other {
            let [away, turning] = acceleration(tree, ws, (*other, point), moving);
            linear -= away;
            angular -= turning;
        }
        if let Some(along) = contact.only() {
            contacts.found[row] = along.dot(&linear);
            row += 1;
            continue;
        }
        contacts.found[row..][..3].copy_from_slice(linear.as_slice());
        row += 3;
        if contact.angular.is_some() {
            contacts.found[row..][..3].copy_from_slice(angular.as_slice());
            row += 3;
        }
    }
}

/// What is prescribed, less what was found.
fn prescribe<T: Scalar>(contacts: &mut Contacts<T>) {
    let mut row = 0;
    for contact in &contacts.list {
        if let Some(along) = contact.only() {
            contacts.right[row] = along.dot(&contact.acceleration) - contacts.found[row];
            row += 1;
            continue;
        }
        for wanted in std::iter::once(contact.acceleration).chain(contact.angular) {
            for axis in 0..3 {
                contacts.right[row] = wanted[axis] - contacts.found[row];
                row += 1;
            }
        }
    }
}

/// Fills the solver's matrix: accelerations of the contacts under a unit of each contact force, everything else at rest
/// and without gravity. The joints stay as the last pass gathered them.
fn respond<T: Scalar>(
    tree: &Tree<T>,
    ws: &mut Workspace<T>,
    contacts: &mut Contacts<T>,
    held: impl Fn(usize) -> bool + Copy,
) {
    no_velocity_terms(ws);
    contacts.response.fill(T::zero());
    // Taken out so that the workspace can be borrowed; an empty vector takes no memory.
    let no_force = std::mem::take(&mut ws.zeros);
    for column in 0..contacts.right.len() {
        let Some(row) = contacts.rows().nth(column) else { continue };
        ws.loads.fill(Load::zero());
        ws.loads[row.contact.link] = row.load(ws, row.contact.link, &row.contact.point, -row.axis);
        if let Some((other, point)) = &row.contact.other {
            ws.loads[*other] = row.load(ws, *other, point, row.axis);
        }
        gather_loads(tree, ws, held, &no_force);
        // What is prescribed has no acceleration of its own here: it stays zero in `response`.
        let (a, tau) = (&mut contacts.response, &mut contacts.response_forces);
        accelerate(tree, ws, &Vector3::zeros(), held, a, tau);
        measure(tree, ws, contacts, false);
        contacts.solver.set_column(column, &contacts.found);
    }
    ws.zeros = no_force;
}

/// Reads the wrenches off the solution.
fn collect<T: Scalar>(ws: &Workspace<T>, contacts: &mut Contacts<T>) {
    let mut solution = contacts.solver.solution();
    let mut next = |count: usize| {
        let (own, rest) = solution.split_at(count);
        solution = rest;
        own
    };
    for (contact, (link, wrench)) in contacts.list.iter().zip(&mut contacts.wrenches) {
        let force = match contact.only() {
            Some(along) => along * next(1)[0],
            None => Vector3::from_column_slice(next(3)),
        };
        let moment = contact.angular.map_or_else(Vector3::zeros, |_| Vector3::from_column_slice(next(3)));
        let point = ws.poses[contact.link].transform(&contact.point);
        (*link, *wrench) = (contact.link, Wrench::at(&point, force, moment));
    }
}

/// What a contact's other link bears, where there is one: the opposite force and moment, at its own point.
fn opposite<T: Scalar>(
    ws: &Workspace<T>,
    contacts: &Contacts<T>,
    contact: usize,
) -> Option<(usize, Wrench<T>)> {
    let held = &contacts.list[contact];
    let (other, point) = held.other.as_ref()?;
    let (_, wrench) = contacts.wrenches[contact];
    let besides = wrench.moment_about(&ws.poses[held.link].transform(&held.point));
    Some((*other, Wrench::at(&ws.poses[*other].transform(point), -wrench.force, -besides)))
}
