#![doc = include_str!("../README.md")]

pub use solaris_analysis as analysis;
#[cfg(feature = "collide")]
pub use solaris_collision as collision;
pub use solaris_dynamics as dynamics;
#[cfg(feature = "files")]
pub use solaris_files as files;
pub use solaris_gait as gait;
#[cfg(feature = "io")]
pub use solaris_io as io;
pub use solaris_model as model;
pub use solaris_modes as modes;
pub use solaris_profiles as profiles;
#[cfg(feature = "glb")]
pub use solaris_retarget as retarget;
#[cfg(feature = "text")]
pub use solaris_scene as scene;
#[cfg(feature = "glb")]
pub use solaris_skin as skin;
#[cfg(feature = "drawn")]
pub use solaris_view as view;

/// What a first program needs.
pub mod prelude {
    pub use solaris_analysis::ground::{GroundOptions, ground_forces, soles};
    pub use solaris_analysis::{
        Filter, InverseOptions, Loads, PreparedMotion, differentiate, ground_reactions, inverse_motion,
    };
    pub use solaris_dynamics::{
        ContactConstraint, Contacts, DMatrix, Derivatives, DynamicsError, Formulation, Frame,
        InverseDynamics, JacobianAxes, RootView, Tree, Workspace, Wrench, bias_forces, center_of_mass,
        contact_dynamics, coriolis_matrix, forward_dynamics, forward_kinematics, hybrid_dynamics,
        inverse_dynamics, inverse_mass_matrix, jacobian, mass_matrix, velocities,
    };
    pub use solaris_gait::{Command, Extent, StrideLoop, WalkPlan, WalkRequest, Walker, measure, walk};
    pub use solaris_model::{
        Figure, FigureBuilder, Human, Inertia, Joint, Known, LinkSpec, Motion, MotionInfo, Placement, RootAt,
        RootOrder, Trajectory, Vector3, human,
    };
    pub use solaris_modes::{
        Collisions, ContactLaw, Course, Drive, GroundPlane, LimitLaw, Loop, LoopKind, Method, PointSpring,
        Rule, Run, Settings, Simulation, Step, Target,
    };
}

/// The project's pages: their Rust blocks are run as tests.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/bodies.md")]
struct Bodies;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/dynamics.md")]
struct Dynamics;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/profiles.md")]
struct Profiles;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/drives.md")]
struct Drives;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/ground.md")]
struct Ground;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/live.md")]
struct Live;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/learn/game.md")]
struct LearnGame;

#[cfg(doctest)]
#[doc = include_str!("../../../docs/learn/robotics.md")]
struct LearnRobotics;
