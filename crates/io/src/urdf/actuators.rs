//! `effort` of `<limit>`: how strong the motors of joints are.

use super::DEEPEST;
use crate::xml::{self, Reader, element, elements_called};
use solaris_model::{Actuator, ActuatorLaw, TextError};

/// The motors of a URDF: of every joint that moves and whose `<limit>` has an `effort` of more than zero, that as the greatest force (N m
/// or N); joints that mimic others have none. `velocity` is not read.
///
/// # Errors
///
/// [`TextError`] for what is no XML, and numbers that are none.
///
/// # Examples
///
/// ```
/// let text = r#"<robot name="r"><link name="a"/><link name="b"/><joint name="knee" type="revolute"><parent link="a"/><child link="b"/>
///     <limit lower="-1" upper="1" effort="30" velocity="6"/></joint></robot>"#;
/// let found = solaris_io::urdf::actuators(text)?;
/// assert_eq!((found[0].dof.as_str(), found[0].limit), ("knee", Some(30.0)));
/// # Ok::<(), solaris_model::TextError>(())
/// ```
pub fn actuators(text: &str) -> Result<Vec<Actuator>, TextError> {
    let document = xml::parse(text, DEEPEST)?;
    let mut reader = Reader::new(text);
    let mut found = Vec::new();
    for joint in elements_called(document.root_element(), "joint") {
        let moves = matches!(joint.attribute("type"), Some("revolute" | "continuous" | "prismatic"));
        let (Some(name), Some(limit)) = (joint.attribute("name"), element(joint, "limit")) else { continue };
        let effort = reader.number(limit, "effort").filter(|effort| *effort > 0.0 && effort.is_finite());
        if moves && element(joint, "mimic").is_none() && effort.is_some() {
            let name = name.to_owned();
            found.push(Actuator { dof: name.clone(), name, law: ActuatorLaw::Force, limit: effort });
        }
    }
    reader.error().map_or(Ok(found), Err)
}
