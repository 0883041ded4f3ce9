//! Names of bones and a rest pose, as somebody wrote them down.

use super::axes::Axes;
use super::{Along, BETWEEN, NAMES, Rest, Rig, TWISTS};
use solaris_text::{Reader, TextError, nearest, parse};

/// What a text shows where it is none.
const EXAMPLE: &str = "Rig(rest: T, bones: {\"pelvis\": \"Hips\", \"left_thigh\": \"LeftUpLeg\"})";

/// What the bones of a person are called, and how they stand at rest: those of a [`Rig`], or one's own.
///
/// ```
/// use solaris_io::rig::{RigMap, Rigged};
/// let map = RigMap::read("Rig(rest: A, bones: {\"pelvis\": \"Root_M\", \"left_thigh\": \"Hip_L\"})")?;
/// let on = Rigged::new(&solaris_model::human(1.65, 58.0)?, &map)?;
/// assert!(on.figure.link("Hip_L").is_some() && on.figure.link("left_shank").is_some());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RigMap {
    rig: Option<Rig>,
    rest: Rest,
    has_own_axes: bool,
    /// The bone of every link of a human.
    bones: Vec<(&'static str, String)>,
}

impl RigMap {
    /// Reads `Rig(rest: T, bones: {"pelvis": "Hips", …})`: the names of a human's links, each with that of its bone. Links that it
    /// leaves out keep their names, and `rest` is `T` (without it, too), `A` or `own`.
    ///
    /// # Errors
    ///
    /// Every fault of the text with its place: unknown links, links and bones twice, names that are empty.
    pub fn read(text: &str) -> Result<Self, TextError> {
        let tree = parse(text, "map of a rig", EXAMPLE)?;
        let mut reader = Reader::default();
        let mut map = Self { rig: None, rest: Rest::T, has_own_axes: false, bones: Vec::new() };
        if let Some(fields) = reader.fields(&tree, &["Rig"], &["rest", "bones"]) {
            map.rest = match fields.get("rest").and_then(|node| reader.word(node, &["T", "A", "own"])) {
                Some("A") => Rest::A,
                Some("own") => Rest::Own,
                _ => Rest::T,
            };
            let bones = reader.required(&fields, "bones", "{\"pelvis\": \"Hips\"}");
            let entries = bones.and_then(|node| reader.entries(node, "bones", "{\"pelvis\": \"Hips\"}"));
            let mut places = Vec::new();
            for (key, value) in entries.unwrap_or_default() {
                let Some(name) = reader.name(key, "the name of a link") else { continue };
                let Some(link) = links().find(|link| *link == name) else {
                    let hint = match nearest(name, links()) {
                        Some(near) => format!("did you mean '{near}'?"),
                        None => format!("its links are {}", links().collect::<Vec<_>>().join(", ")),
                    };
                    reader.fault(key.span.clone(), format!("a human figure has no link '{name}'; {hint}"));
                    continue;
                };
                if map.bones.iter().any(|(known, _)| *known == link) {
                    reader.fault(key.span.clone(), format!("link '{link}' is given twice; keep one of them"));
                }
                let Some(bone) = reader.name(value, format_args!("the bone of '{link}'")) else { continue };
                map.bones.push((link, bone.to_owned()));
                places.push(value.span.clone());
            }
            // Against the names that stay, too: a bone may have that of a link only if the link has another one.
            let stay = links().filter(|link| map.bone(link).is_none());
            let stay: Vec<(&str, String)> = stay.map(|link| (link, link.to_owned())).collect();
            for (i, place) in places.into_iter().enumerate() {
                let (link, bone) = &map.bones[i];
                let others = map.bones[..i].iter().chain(&stay);
                if let Some((other, _)) = others.into_iter().find(|(of, name)| name == bone && of != link) {
                    let message = format!(
                        "the bones of '{other}' and '{link}' are both called '{bone}'; give each a name of its own"
                    );
                    reader.fault(place, message);
                }
            }
            map.bones.extend(stay);
        }
        reader.finish(text)?;
        Ok(map)
    }

    /// With bones' axes at rest as the rig's own characters have them, where those are not the world's: Mixamo's y along the bone, Unreal's x. Files
    /// whose bones have a rotation at rest, glTF and USD, can say so; BVH cannot.
    ///
    /// ```
    /// use solaris_io::rig::{Rig, RigMap, Rigged};
    /// let ann = solaris_model::human(1.65, 58.0)?;
    /// let on = Rigged::new(&ann, RigMap::from(Rig::Mixamo).with_own_axes())?;
    /// let arm = on.figure.link("mixamorig:LeftForeArm").ok_or("no forearm")?;
    /// assert!((arm.joint().placement().translation.y - 0.267).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn with_own_axes(self) -> Self {
        Self { has_own_axes: true, ..self }
    }

    /// The rig, where it is one of those that are known.
    pub fn rig(&self) -> Option<Rig> {
        self.rig
    }

    /// How it stands at rest.
    pub fn rest(&self) -> Rest {
        self.rest
    }

    /// What it calls a human's link.
    pub fn bone(&self, link: &str) -> Option<&str> {
        self.bones.iter().find(|(known, _)| *known == link).map(|(_, bone)| bone.as_str())
    }

    /// What it calls a part of a human's skin, where it has a bone for it.
    pub(super) fn part(&self, part: &str) -> Option<&'static str> {
        self.rig?.part(part)
    }

    /// The bone that it calls [`Rig::root`].
    pub(super) fn root(&self) -> Option<&'static str> {
        self.rig?.root()
    }

    /// The bone by which it hangs a link on what is above it, see [`Rig::hook`].
    pub(super) fn hook(&self, link: &str) -> Option<&'static str> {
        self.rig?.hook(link)
    }

    /// How the axes of a link's bone lie at rest, if not along the world's.
    pub(super) fn axes(&self, link: &str) -> Option<Axes> {
        Axes::find(self.rig.filter(|_| self.has_own_axes)?, link)
    }

    /// What a message calls it.
    pub(super) fn name(&self) -> &'static str {
        self.rig.map_or("custom", Rig::name)
    }

    /// The bones between a human's links, which never turn.
    pub(super) fn between(&self) -> impl Iterator<Item = Along> {
        self.rig.into_iter().flat_map(|rig| rig.along(BETWEEN))
    }

    /// The bones that share out how a limb turns about its own axis.
    pub(super) fn twists(&self) -> impl Iterator<Item = Along> {
        self.rig.into_iter().flat_map(|rig| rig.along(TWISTS))
    }
}

impl From<Rig> for RigMap {
    fn from(rig: Rig) -> Self {
        let bones = links().filter_map(|link| Some((link, rig.bone(link)?.to_owned()))).collect();
        Self { rig: Some(rig), rest: rig.rest(), has_own_axes: false, bones }
    }
}

impl From<&Self> for RigMap {
    fn from(map: &Self) -> Self {
        map.clone()
    }
}

/// The names of a human's links.
fn links() -> impl Iterator<Item = &'static str> {
    NAMES.lines().skip(1).filter_map(|row| row.split(',').next())
}
