//! Contents of a body, through all `<frame>`s.

use crate::mjcf::compiler::Compiler;
use crate::mjcf::defaults::SPECIFIERS;
use crate::mjcf::defaults::{Defaults, Resolved};
use crate::mjcf::orientation::placement;
use crate::xml::{Node, Reader, elements, tag};
use solaris_model::Placement;

/// An element, the frame it stands in (in the body's frame), and the class of defaults around it.
type Item<'a> = (Node<'a>, Placement, usize);

/// The elements of a body, each in the order of the file.
#[derive(Default)]
pub(super) struct Contents<'a> {
    pub(super) joints: Vec<Item<'a>>,
    pub(super) geoms: Vec<Item<'a>>,
    pub(super) sites: Vec<Item<'a>>,
    pub(super) inertials: Vec<Item<'a>>,
    pub(super) bodies: Vec<Item<'a>>,
}

impl<'a> Contents<'a> {
    /// Of a body whose elements have the defaults of `class`.
    pub(super) fn of(
        reader: &mut Reader,
        body: Node<'a>,
        class: usize,
        defaults: &Defaults<'a>,
        compiler: &Compiler,
    ) -> Self {
        let mut contents = Self::default();
        // Frames that are open, innermost last, with what is left of them.
        let mut open = vec![(elements(body), Placement::identity(), class)];
        while let Some((children, frame, class)) = open.last_mut() {
            let (frame, class) = (*frame, *class);
            let Some(node) = children.next() else {
                open.pop();
                continue;
            };
            let item = (node, frame, class);
            match node.tag_name().name() {
                "joint" | "freejoint" => contents.joints.push(item),
                "geom" => contents.geoms.push(item),
                "site" => contents.sites.push(item),
                "inertial" => contents.inertials.push(item),
                "body" => contents.bodies.push(item),
                "frame" => {
                    let mut known = vec!["name", "pos", "childclass"];
                    known.extend(SPECIFIERS);
                    reader.check_attributes(node, &known);
                    let at = frame * placement(reader, &Resolved::plain(node), compiler);
                    let class = defaults.class(reader, node, "childclass").unwrap_or(class);
                    open.push((elements(node), at, class));
                }
                "camera" | "light" => reader.aside(format!("<{}>", node.tag_name().name()), tag(node)),
                _ => reader.unread_element(node),
            }
        }
        contents
    }
}
