//! Figures as text, for people: names instead of indices, degrees where people think in degrees, shapes instead of inertia
//! numbers, comments.
//!
//! The text is [RON](https://docs.rs/ron). [`read`] finds everything that is wrong with it at once, each fault with its
//! place and with what to do; [`write()`] gives a text from which [`read`] makes the same figure, bit for bit.
//!
//! ```
//! let text = r#"
//! Figure(
//!     version: 1,
//!     name: "crane",
//!     links: [
//!         Link(
//!             name: "tower",
//!             joint: Joint(name: "root", axes: [ry(limits: (deg(-170), deg(170)))]),
//!             mass: 12.0,
//!             solid: Box(size: (0.4, 3.0, 0.4), at: (0.0, 1.5, 0.0)),
//!         ),
//!         Link(
//!             name: "jib",
//!             parent: "tower",
//!             joint: Joint(name: "luff", at: (0.0, 3.0, 0.0), axes: [rz(damping: 4.0)]),
//!             mass: 3.0,
//!             com: (1.0, 0.0, 0.0),
//!             inertia: (0.01, 1.0, 1.0),
//!             tip: (2.0, 0.0, 0.0),
//!         ),
//!     ],
//! )"#;
//! let crane = solaris_model::text::read(text)?;
//! assert_eq!(crane.layout().v_names(), ["root.ry", "luff.rz"]);
//! assert_eq!(solaris_model::text::read(&solaris_model::text::write(&crane))?, crane);
//!
//! let error = solaris_model::text::read(&text.replace("parent: \"tower\"", "parent: \"towr\"")).unwrap_err();
//! assert!(error.to_string().starts_with("line 14, column 21: "));
//! assert!(error.to_string().ends_with("did you mean 'tower'?"));
//! # Ok::<(), solaris_model::TextError>(())
//! ```
//!
//! # Grammar
//!
//! Units are m, kg, s, N; an angle is a number in rad or `deg(30)`. What is not required may be left out.
//!
//! | | fields |
//! |---|---|
//! | `Figure` | `version` (required, 1), `name`, `stature` (m), `gravity: (x, y, z)` (m/s²; of the world that the figure is made in, (0, −9.80665, 0) without it), then `links: [Link(…), …]` and `angles: {"NAME": "DOF", …}` (`"-DOF"`: taken negative), or `body: Human(…)` alone |
//! | `Human` | `height`, `mass` (both required), `age` (years, 6 to 18: a child's proportions), `segments: {"left_thigh": 0.45, …}` (lengths in m), `joints: Angles` or `Limp`, `root: Zyx` or `Yzx` (the order in which the root turns), `limits: {"left_elbow.rx": (deg(-150), deg(0)), …}`: [`crate::Human`]. It brings its own name and stature unless they are given |
//! | `Link` | `name`, `joint` (both required), `parent` (all but the root have one), `mass`, `com: (x, y, z)`, `inertia: (xx, yy, zz)` or `(xx, yy, zz, xy, xz, yz)`, or instead of these two `solid: SHAPE`; `shape: SHAPE`, `tip: (x, y, z)`, `sole: [Heel(x, y, z), Ball(…), ToeTip(…)]`, `frames: {"NAME": (PLACE), …}` |
//! | `Joint` | `name` (required), PLACE, `axes: [AXIS, …]`, the first nearest to the parent; none is a weld |
//! | `Ball`, `Free` | a joint with any rotation, or any motion: `name` (required), PLACE, ACTING |
//! | AXIS | `rx ry rz` turn, `tx ty tz` slide; with fields as `rx(…)`; about or along any other direction `Turn(axis: (x, y, z), …)`, `Slide(axis: (x, y, z), …)`. Fields: `name`, `limits: (lower, upper)` (`-inf` or `inf` where there is none), `follows`, ACTING |
//! | ACTING | `armature`, `stiffness`, `rest`, `damping`, `friction`: [`crate::Passive`] |
//! | `follows` | `Follow(dof: "NAME", along: CURVE)` with `Line(slope: 2, offset: 0)`, `Polynomial([c0, c1, …])`, `Cubics(knots: […], pieces: [(c0, c1, c2, c3), …])`, `Quintics(…)` with six numbers a piece, `Sine(amplitude: 1, frequency: 2, phase: 0, offset: 0)` or `Chain([CURVE, …])`, one after the other: [`crate::Follower`], [`crate::Curve`] |
//! | PLACE | `at: (x, y, z)`, `turned: ROTATION`, in the parent link's frame (of a joint) or in the link's own |
//! | ROTATION | `About(axis: (x, y, z), angle: …)`, `Quaternion(x, y, z, w)`, or three angles about the axes in order: `Zyx(deg(90), 0, 0)` and the other five of [`crate::EulerOrder`] |
//! | SHAPE | `Box(size: (x, y, z))`, `Ellipsoid(radii: (x, y, z))`, `Cylinder(radius: …, length: …)` and `Capsule(…)` along y, `Sphere(radius: …)`, each with a PLACE: [`crate::ShapeKind`] |
//!
//! `inertia` is about the centre of mass, along the link's axes, its products those of the tensor (`xy` is −∫xy dm). A
//! `solid` has the link's mass, spread evenly, and gives centre of mass and inertia; without any of these the mass is a
//! point. A `shape` is only what the link looks like; a solid is drawn where there is none.
//!
//! Of RON there is all that this needs: comments (`//`, `/* */`), commas at the end, `Some(…)` and `None` around fields,
//! raw texts, names left out where only one can be meant. Texts end on the line on which they begin.

mod read;
mod spatial;
mod write;

pub use solaris_text::{
    Content, Expected, ExpectedKind, Fault, Fields, Group, Named, Node, Reader, TextFault, Value, edit,
    first_word, layout, parse,
};
pub use spatial::ReadSpatial;

use crate::figure::Figure;
use solaris_text::TextError;

/// The figure that a text describes.
///
/// # Errors
///
/// [`TextError`] with every fault, in the order of the text: the one place where it is no RON, or else everything that is
/// unknown, missing, of the wrong kind, or not possible in a figure. Where a link could not be read, nothing is said
/// about what needs it. Time and memory grow in proportion to a text without faults; brackets in each other are refused
/// beyond 64, and links beyond 131 072.
pub fn read(text: &str) -> Result<Figure, TextError> {
    read::read(text)
}

/// The figure of a node `Figure(…)` inside of another text, which need not say its version, or of `Human(…)`; nothing where
/// it has faults, which `reader` then knows.
pub fn read_node(reader: &mut Reader, node: &Node<'_>) -> Option<Figure> {
    match node.head() {
        Some(head) if head.name == "Human" => read::read_human(reader, node),
        _ => read::read_tree(reader, node, false),
    }
}

/// A text that describes the figure.
///
/// [`read`] makes the same figure of it: numbers have as many digits as that takes, and angles stand in degrees only where
/// these give the same bits.
pub fn write(figure: &Figure) -> String {
    write::write(figure)
}
