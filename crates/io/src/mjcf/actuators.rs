//! `<actuator>`: the motors of joints, as numbers at their degrees of freedom.

use super::DEEPEST;
use super::assembly::Assembly;
use super::defaults::Resolved;
use super::model::Model;
use crate::loader::{FilesError, Loader};
use crate::xml::{self, Node, Reader, elements, elements_called};
use solaris_model::{Actuator, ActuatorLaw, TextError};

/// The actuators of the joints of an MJCF model, in the order of the file; those of models that it attaches are not among them.
///
/// `position` and `velocity`, and what is `general` with their laws, have gains; of `motor` and the like only the greatest force is taken,
/// from `forcerange`, or `ctrlrange` and gear. `gear` is in all numbers: a motor of `gear` g has `g²` of its gains and `g` of its force at the
/// joint. Anything else is [`ActuatorLaw::Other`], so is what a range that is not the same both ways bounds.
///
/// # Errors
///
/// [`FilesError`] as [`read_with`](super::read_with), and for numbers that are none.
///
/// # Examples
///
/// ```
/// use solaris_io::{NoFiles, mjcf};
/// use solaris_model::ActuatorLaw;
///
/// let text = r#"<mujoco><worldbody><body><joint name="knee"/><geom size="0.1"/></body></worldbody>
///     <actuator><position name="m" joint="knee" kp="20" kv="1.5" gear="2" forcerange="-30 30"/></actuator></mujoco>"#;
/// let found = mjcf::actuators(text, &mut NoFiles)?;
/// assert_eq!(found[0].law, ActuatorLaw::Position { stiffness: 80.0, damping: 6.0 });
/// assert_eq!((found[0].dof.as_str(), found[0].limit), ("knee", Some(60.0)));
/// # Ok::<(), solaris_io::FilesError>(())
/// ```
pub fn actuators(text: &str, loader: &mut dyn Loader) -> Result<Vec<Actuator>, FilesError> {
    let assembly = Assembly::of(text, loader)?;
    read(&assembly).map_err(|error| assembly.error(error))
}

fn read(assembly: &Assembly) -> Result<Vec<Actuator>, TextError> {
    let document = xml::parse(assembly.text.as_ref(), DEEPEST)?;
    let root = document.root_element();
    let mut reader = Reader::new(assembly.text.as_ref());
    let models = Model::all(&mut reader, root, assembly);
    let mut found = Vec::new();
    if let Some(model) = models.first() {
        for node in elements_called(model.root, "actuator").flat_map(elements) {
            let element = node.tag_name().name();
            let said = [element, "general"].map(|kind| model.defaults.resolve_as(&mut reader, node, 0, kind));
            found.extend(actuator(&mut reader, node, &Said(said)));
        }
    }
    reader.error().map_or(Ok(found), Err)
}

/// An element with the defaults of its own kind and of all actuators.
struct Said<'a>([Resolved<'a>; 2]);

impl Said<'_> {
    fn text(&self, name: &str) -> Option<&str> {
        self.0.iter().find_map(|said| said.text(name))
    }

    fn list(&self, reader: &mut Reader, name: &str) -> Option<Vec<f64>> {
        let said = self.0.iter().find(|said| said.text(name).is_some())?;
        let text = said.text(name)?;
        reader.parse_numbers(text, &said.span(name), &format!("'{name}'"), 1..=100)
    }

    fn number(&self, reader: &mut Reader, name: &str, without: f64) -> f64 {
        self.list(reader, name).and_then(|list| list.first().copied()).unwrap_or(without)
    }

    /// The greatest force of a range that is the same both ways; without a range none.
    fn both_ways(&self, reader: &mut Reader, range: &str, limited: &str) -> Result<Option<f64>, String> {
        if self.text(limited) == Some("false") {
            return Ok(None);
        }
        match self.list(reader, range).as_deref() {
            Some([lower, upper]) if (lower + upper).abs() <= 1e-9 * upper.abs() && *upper > 0.0 => {
                Ok(Some(*upper))
            }
            Some([lower, upper]) if lower < upper => {
                Err(format!("{range} {lower} to {upper}, which is not the same both ways"))
            }
            _ => Ok(None),
        }
    }
}

fn actuator(reader: &mut Reader, node: Node, said: &Said<'_>) -> Option<Actuator> {
    let joint = said.text("joint").or_else(|| said.text("jointinparent"));
    let name = node.attribute("name").or(joint)?.to_owned();
    let element = node.tag_name().name();
    let other = |why: String| Some(ActuatorLaw::Other(why));
    let gear = said.number(reader, "gear", 1.0);
    let range = said.both_ways(reader, "forcerange", "forcelimited");
    let mut limit = range.clone().unwrap_or_default();
    let law = match (joint, element) {
        (None, _) => other(format!("<{element}> without a joint")),
        (_, "position" | "velocity" | "general" | "motor") if range.is_err() => range.err().and_then(other),
        (_, "position") if said.text("dampratio").is_some() => {
            other("<position> with a dampratio; give it a kv".to_owned())
        }
        (_, "position") => {
            let (stiffness, damping) = (said.number(reader, "kp", 1.0), said.number(reader, "kv", 0.0));
            Some(ActuatorLaw::Position { stiffness, damping })
        }
        (_, "velocity") => Some(ActuatorLaw::Velocity { damping: said.number(reader, "kv", 1.0) }),
        (_, "general") => Some(general(reader, said)),
        (_, "motor") => Some(ActuatorLaw::Force),
        _ => other(format!("<{element}>")),
    }?;
    if law == ActuatorLaw::Force && limit.is_none() {
        let scale = if element == "general" { said.number(reader, "gainprm", 1.0) } else { 1.0 };
        limit =
            said.both_ways(reader, "ctrlrange", "ctrllimited").ok().flatten().map(|most| most * scale.abs());
    }
    let square = gear * gear;
    let law = match law {
        ActuatorLaw::Position { stiffness, damping } => {
            ActuatorLaw::Position { stiffness: stiffness * square, damping: damping * square }
        }
        ActuatorLaw::Velocity { damping } => ActuatorLaw::Velocity { damping: damping * square },
        law => law,
    };
    Some(Actuator {
        name,
        dof: joint.unwrap_or_default().to_owned(),
        law,
        limit: limit.map(|limit| limit * gear.abs()),
    })
}

/// What gains and biases come to: `gain·ctrl + b₀ + b₁·q + b₂·q̇`.
fn general(reader: &mut Reader, said: &Said<'_>) -> ActuatorLaw {
    let fixed = |name: &str, word: &str| said.text(name).is_none_or(|kind| kind == word);
    let gain = said.number(reader, "gainprm", 1.0);
    let bias = said.list(reader, "biasprm").unwrap_or_default();
    let bias = [0, 1, 2].map(|i| bias.get(i).copied().unwrap_or(0.0));
    let same = |a: f64, b: f64| (a - b).abs() <= 1e-9 * a.abs().max(b.abs());
    let plain = fixed("gaintype", "fixed") && fixed("dyntype", "none");
    match (plain, said.text("biastype"), bias) {
        (true, None | Some("none"), _) => ActuatorLaw::Force,
        (true, Some("affine"), [b0, b1, b2])
            if b0.abs() <= 0.0 && b2 <= 0.0 && gain > 0.0 && same(gain, -b1) =>
        {
            ActuatorLaw::Position { stiffness: gain, damping: -b2 }
        }
        (true, Some("affine"), [b0, b1, b2])
            if b0.abs() <= 0.0 && b1.abs() <= 0.0 && gain > 0.0 && same(gain, -b2) =>
        {
            ActuatorLaw::Velocity { damping: gain }
        }
        _ => ActuatorLaw::Other("<general> of another law".to_owned()),
    }
}
