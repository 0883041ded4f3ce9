//! Joint reactions: the wrenches that joints transmit.

use crate::error::DynamicsError;
use crate::inverse::inverse_dynamics;
use crate::kinematics::place;
use crate::scalar::Scalar;
use crate::spatial::Wrench;
use crate::spatial::direction::apply;
use crate::tree::Tree;
use crate::workspace::{Workspace, check_result};

/// [`inverse_dynamics`], which also keeps what every joint transmits: afterwards [`Workspace::reaction`] tells the whole
/// wrench that a link's parent (the world, for the root) exerts on the link through its joint, in world axes about the
/// world's origin.
///
/// That is what bearings and motors do together: for every link
///
/// ```text
/// reaction − Σ reactions of its children + gravity + external wrenches = rate of its momentum
/// ```
///
/// The component of a reaction along a degree of freedom is its `tau`, less what accelerates its armature. See
/// [`Wrench::moment_about`] and [`Wrench::seen_from`] for another point and other axes. Also places the links.
///
/// # Errors
///
/// As for [`inverse_dynamics`].
///
/// # Examples
///
/// A lamp of 2 kg on a bracket of half a metre that is welded to the wall: the wall carries its weight and 9.81 N m.
///
/// ```
/// use solaris_dynamics::{Tree, Workspace, joint_reactions};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let lamp = LinkSpec::root("lamp", Joint::new("wall")).mass(2.0).com(Vector3::new(0.5, 0.0, 0.0));
/// let figure = FigureBuilder::new("lamp").link(lamp).build()?;
/// let tree = Tree::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0))?;
/// let mut workspace = Workspace::new(&tree);
/// joint_reactions(&tree, &mut workspace, &[], &[], &[], &[], &mut [])?;
/// assert_eq!(workspace.reaction(0).force, Vector3::new(0.0, 19.62, 0.0));
/// assert_eq!(workspace.reaction(0).moment, Vector3::new(0.0, 0.0, 9.81));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "joint reaction")]
#[doc(alias = "joint contact force")]
#[doc(alias = "constraint force")]
#[doc(alias = "cfrc_int")]
pub fn joint_reactions<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    v: &[T],
    a: &[T],
    external: &[(usize, Wrench<T>)],
    tau: &mut [T],
) -> Result<(), DynamicsError> {
    inverse_dynamics(tree, workspace, q, v, a, external, tau)?;
    // External wrenches have placed the links already.
    if external.is_empty() {
        place(tree, workspace)?;
    }
    let ws = workspace;
    for (link, (load, pose)) in ws.loads.iter().zip(&ws.poses).enumerate() {
        let (force, moment) = (apply(&pose.rotation, &load.force), apply(&pose.rotation, &load.moment));
        let reaction = Wrench::at(&pose.translation, force, moment);
        check_result("the force of a joint", reaction.force.as_slice())?;
        check_result("the moment of a joint", reaction.moment.as_slice())?;
        ws.reactions[link] = reaction;
    }
    Ok(())
}
