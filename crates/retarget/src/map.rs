//! A map of roles to bones, for skeletons whose names say nothing.

use crate::roles::ROLES;
use solaris_text::{Reader, TextError, parse};

/// Which bone has which role, as somebody wrote it down; roles that it does not name are found by the bones' names.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct BoneMap {
    /// Roles, which are names of a human's links, and bones.
    pub bones: Vec<(&'static str, String)>,
}

impl BoneMap {
    /// Reads a map: a group of roles, which are the names of a human's links, each with the name of a bone.
    ///
    /// # Errors
    ///
    /// Every fault of the text with its place: unknown roles, roles twice, values that are no text.
    ///
    /// ```
    /// let map = solaris_retarget::BoneMap::read("Bones(pelvis: \"Root_M\", left_thigh: \"Hip_L\")")?;
    /// assert_eq!(map.bone("left_thigh"), Some("Hip_L"));
    /// # Ok::<(), solaris_model::TextError>(())
    /// ```
    pub fn read(text: &str) -> Result<Self, TextError> {
        let tree = parse(text, "map of bones", "Bones(pelvis: \"Hips\", left_thigh: \"LeftUpLeg\")")?;
        let mut reader = Reader::default();
        let mut map = Self::default();
        if let Some(fields) = reader.fields(&tree, &["Bones"], &ROLES) {
            for role in ROLES {
                let Some(node) = fields.get(role) else { continue };
                if let Some(name) = reader.text(node, role) {
                    map.bones.push((role, name.to_owned()));
                }
            }
        }
        reader.finish(text)?;
        Ok(map)
    }

    /// The bone of a role.
    pub fn bone(&self, role: &str) -> Option<&str> {
        self.bones.iter().find(|(known, _)| *known == role).map(|(_, bone)| bone.as_str())
    }
}
