//! A skeleton: bones with their places at rest.

use solaris_model::{Figure, Placement, Vector3};

/// A bone at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Bone {
    /// What it is called.
    pub name: String,
    /// The bone that it hangs on, which comes before it.
    pub parent: Option<usize>,
    /// Its frame in the world (m).
    pub rest: Placement,
    /// Whether it may have a role: what is above a skeleton, or only hangs on it, has none.
    pub is_bone: bool,
    /// Its role, where its file says one: the name of a human's link.
    pub role: Option<&'static str>,
}

/// A skeleton at rest, in a world of any axes: which way is up and forward is seen from hips and feet.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skeleton {
    /// Whose it is.
    pub name: String,
    /// Parents before children.
    pub bones: Vec<Bone>,
    /// Points of its surface at rest (m, world), each with the bone that it goes with: what soles are found from, where there are any.
    pub surface: Vec<(usize, Vector3<f64>)>,
}

impl Skeleton {
    /// The links of a figure, with all joints at zero.
    pub fn of(figure: &Figure) -> Self {
        let mut q = vec![0.0; figure.layout().nq()];
        // The length is the figure's own.
        let _ = figure.neutral(&mut q);
        let places = figure.places(&q);
        let mut skeleton = Self { name: figure.name().to_owned(), ..Self::default() };
        for (i, (link, rest)) in figure.links().iter().zip(places).enumerate() {
            let (name, parent) = (link.name().to_owned(), link.parent());
            let points = link.sole().iter().map(|point| (i, rest * nalgebra::Point3::from(point.position)));
            skeleton.surface.extend(points.map(|(i, point)| (i, point.coords)));
            skeleton.bones.push(Bone { name, parent, rest, is_bone: true, role: None });
        }
        skeleton
    }

    /// The bones from `bone` up to where there is no more above, itself first.
    pub(crate) fn above(&self, bone: usize) -> impl Iterator<Item = usize> + '_ {
        std::iter::successors(Some(bone), |at| self.bones[*at].parent)
    }

    pub(crate) fn is_below(&self, bone: usize, above: usize) -> bool {
        self.above(bone).any(|at| at == above)
    }

    /// For each bone, whether it is this one or below it.
    pub(crate) fn below(&self, bone: usize) -> Vec<bool> {
        let mut below = vec![false; self.bones.len()];
        for i in bone..self.bones.len() {
            below[i] = i == bone || self.bones[i].parent.is_some_and(|parent| below[parent]);
        }
        below
    }

    /// The lowest bone that is above both, or is one of them.
    pub(crate) fn common(&self, one: usize, other: usize) -> Option<usize> {
        let mut is_above = vec![false; self.bones.len()];
        for at in self.above(other) {
            is_above[at] = true;
        }
        self.above(one).find(|at| is_above[*at])
    }

    /// The bones between two, from above down, without them; where the upper one is not above, from the lowest one that is.
    pub(crate) fn between(&self, upper: usize, lower: usize) -> Vec<usize> {
        let top = self.common(upper, lower);
        let mut path: Vec<usize> =
            self.above(lower).skip(1).take_while(|at| Some(*at) != top && *at != upper).collect();
        path.reverse();
        path
    }

    /// Names of its bones, for a message.
    pub(crate) fn names(&self) -> String {
        const SHOWN: usize = 100;
        let names: Vec<&str> =
            self.bones.iter().filter(|bone| bone.is_bone).map(|bone| bone.name.as_str()).collect();
        let more = names.len().saturating_sub(SHOWN);
        let shown = names[..names.len() - more].join(", ");
        if more > 0 { format!("{shown} and {more} more") } else { shown }
    }
}
