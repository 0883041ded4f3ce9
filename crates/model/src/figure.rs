//! The figure: an immutable tree of links.

use crate::anatomy::AnatomicalAngle;
use crate::fault::{Fault, FigureError};
use crate::follower::Follower;
use crate::joint::{JointKind, Placement};
use crate::layout::StateLayout;
use crate::link::Link;
use nalgebra::Vector3;
use std::collections::HashMap;

/// An articulated figure, valid by construction (see [`crate::FigureBuilder`]).
///
/// Links are ordered so that every parent comes before its children; link 0 is the root.
#[doc(alias = "Model")]
#[doc(alias = "robot")]
#[doc(alias = "skeleton")]
#[doc(alias = "multibody")]
#[doc(alias = "articulated body")]
#[doc(alias = "urdf")]
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    pub(crate) name: String,
    pub(crate) links: Vec<Link>,
    pub(crate) layout: StateLayout,
    pub(crate) angles: Vec<AnatomicalAngle>,
    pub(crate) followers: Vec<Follower>,
    pub(crate) by_name: HashMap<String, usize>,
    pub(crate) stature: Option<f64>,
    pub(crate) gravity: Option<Vector3<f64>>,
}

impl Figure {
    /// The most that anything of a link measures, or is away from its origin along an axis (m). What follows from lengths, such as volumes,
    /// inertias and the places of a long chain's links, then is finite.
    pub const LONGEST: f64 = 1e9;

    /// The most mass of a link (kg).
    pub const HEAVIEST: f64 = 1e20;

    /// The figure's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The links, parents first.
    pub fn links(&self) -> &[Link] {
        &self.links
    }

    /// Index of the link called `name`.
    #[doc(alias = "body id")]
    #[doc(alias = "getBodyId")]
    pub fn link_index(&self, name: &str) -> Option<usize> {
        self.by_name.get(name).copied()
    }

    /// The link called `name`.
    pub fn link(&self, name: &str) -> Option<&Link> {
        self.link_index(name).map(|index| &self.links[index])
    }

    /// Where a body of the figure is: the link that carries the frame called `name` and where in the link's frame it stands, or,
    /// if no frame is, the link called so, at its origin. Bodies that cannot move against each other are one link; one whose
    /// joint is not at its origin has a frame of its own name.
    #[doc(alias = "getFrameId")]
    pub fn locate(&self, name: &str) -> Option<(usize, Placement)> {
        let frames = self.links.iter().map(|link| link.frames.iter().find(|frame| frame.name == name));
        let frame = frames.enumerate().find_map(|(link, frame)| Some((link, frame?.placement)));
        frame.or_else(|| self.link_index(name).map(|link| (link, Placement::identity())))
    }

    /// Index of the link that the joint called `name` moves.
    #[doc(alias = "getJointId")]
    pub fn joint_index(&self, name: &str) -> Option<usize> {
        self.links.iter().position(|link| link.joint.name == name)
    }

    /// Sizes and names of the state vectors.
    pub fn layout(&self) -> &StateLayout {
        &self.layout
    }

    /// Named anatomical angles; empty for a figure that has none.
    pub fn anatomical_angles(&self) -> &[AnatomicalAngle] {
        &self.angles
    }

    /// The anatomical angle called `name`.
    pub fn anatomical_angle(&self, name: &str) -> Option<&AnatomicalAngle> {
        self.angles.iter().find(|angle| angle.name == name)
    }

    /// Total mass (kg).
    #[doc(alias = "total mass")]
    pub fn mass(&self) -> f64 {
        self.links.iter().map(Link::mass).sum()
    }

    /// The standing height that the figure was made for (m), if it was said.
    pub fn stature(&self) -> Option<f64> {
        self.stature
    }

    /// The gravity of the world that the figure was made in (m/s²), if it was said: against it is up. Whoever computes is
    /// free to take another.
    pub fn gravity(&self) -> Option<&Vector3<f64>> {
        self.gravity.as_ref()
    }

    /// The figure in a world with this gravity (m/s²).
    ///
    /// # Errors
    ///
    /// [`Fault::Gravity`] for one that is not finite.
    pub fn with_gravity(mut self, gravity: Vector3<f64>) -> Result<Self, FigureError> {
        if let Some(fault) = Fault::of_gravity(&gravity) {
            return Err(FigureError { figure: self.name, faults: vec![fault] });
        }
        self.gravity = Some(gravity);
        Ok(self)
    }

    /// A number that changes with anything that changes the figure's motion: names, tree, axes, placements and masses
    /// (not springs, dampers and friction).
    pub fn fingerprint(&self) -> u64 {
        let mut hash = Fnv(0xcbf2_9ce4_8422_2325);
        for link in &self.links {
            hash.text(&link.name);
            hash.text(link.joint.name());
            hash.word(link.parent.map_or(u64::MAX, |parent| parent as u64));
            let placement = link.joint.placement();
            hash.numbers(placement.rotation.coords.iter().chain(placement.translation.vector.iter()));
            for dof in link.joint.kind().axes() {
                hash.text(dof.axis.stem());
                hash.numbers(dof.axis.direction.iter());
                dof.name.iter().for_each(|name| hash.text(name));
                hash.numbers([dof.armature].iter().filter(|armature| **armature != 0.0));
                if let Some(follow) = &dof.follows {
                    hash.text(&follow.dof);
                    hash.numbers(follow.curve.numbers().iter());
                }
            }
            match link.joint.kind() {
                JointKind::Axes(_) => {}
                JointKind::Ball { armature, .. } => hash.numbers([4.0, *armature].iter()),
                JointKind::Free { armature, .. } => hash.numbers([7.0, *armature].iter()),
            }
            hash.numbers([link.mass].iter().chain(link.com.iter()).chain(link.inertia.iter()));
        }
        hash.0
    }
}

/// The 64-bit FNV-1a hash: the same on every machine.
struct Fnv(u64);

impl Fnv {
    fn bytes(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    fn word(&mut self, word: u64) {
        self.bytes(&word.to_le_bytes());
    }

    fn text(&mut self, text: &str) {
        self.bytes(text.as_bytes());
        self.bytes(&[0]);
    }

    fn numbers<'a>(&mut self, numbers: impl Iterator<Item = &'a f64>) {
        numbers.for_each(|number| self.word(number.to_bits()));
    }
}
