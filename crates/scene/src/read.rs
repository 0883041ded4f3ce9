//! The reader of scenes, with every fault on the way.

mod actuators;
mod apart;
mod carries;
mod clips;
mod collisions;
mod crowd;
mod drive;
mod drives;
mod figures;
mod forces;
mod ground;
mod include;
mod limits;
mod loops;
mod names;
mod parts;
mod places;
mod pushes;
mod reaches;
mod repeat;
mod segments;
mod settings;
mod springs;
mod start;
mod velocities;
mod walk;
mod words;

use crate::loader::Loader;
use crate::member::Member;
use crate::scene::Scene;
use crate::spelled;
use include::Gathering;
use nalgebra::Vector3;
use names::Names;
use solaris_model::text::{Expected, ExpectedKind, Fields, Node, ReadSpatial as _, Reader, Value, parse};
use solaris_model::{Figure, TextError};
use solaris_modes::{Settings, SetupError, Simulation};
use solaris_profiles::Profile;
use std::ops::Range;

/// The version of the grammar.
const VERSION: u32 = 1;

/// Gravity where neither the scene nor its figure says one (m/s²): y is up.
pub(crate) const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);

const FIELDS: [&str; 24] = [
    "version",
    "include",
    "figures",
    "places",
    "gravity",
    "rate",
    "duration",
    "tolerance",
    "method",
    "guard",
    "start",
    "velocities",
    "drives",
    "sequence",
    "reaches",
    "clip",
    "springs",
    "loops",
    "pushes",
    "carries",
    "limits",
    "ground",
    "collisions",
    "walk",
];

/// What is gathered while the tree of a scene is read.
struct SceneReader<'l> {
    reader: Reader,
    loader: &'l mut dyn Loader,
    /// The simulation, once there is a figure; the rest is read without one too, for its faults.
    simulation: Option<Simulation>,
    names: Names,
    /// How long the scene takes (s), where it says so.
    lasts: Option<f64>,
    /// Degrees of freedom whose drives are given by more than a pattern.
    named: parts::Named,
    sequenced: parts::Sequenced,
    /// How many drives repeats and patterns have made so far.
    made: usize,
    motors: actuators::Motors,
    ties: loops::Asked,
    /// The figures, where there are several.
    members: Vec<Member>,
    /// The scene's, once its figures are known.
    gravity: Vector3<f64>,
    /// Of whom it is to be said that they were stood up.
    stood: Vec<String>,
    /// Where the names stand of links whose touches are waited for.
    awaited: Vec<(String, Range<usize>)>,
}

/// The scene that `text` describes.
pub(crate) fn read(text: &str, loader: &mut dyn Loader) -> Result<Scene, TextError> {
    let mut tree = parse(text, "scene", "Scene(version: 1, …)")?;
    let mut gathering = Gathering::new(loader, text.len());
    gathering.gather(&tree, None);
    let (included, mut reader) = gathering.finish();
    if reader.count() > 0 {
        // Without it most of the rest would seem to be at fault.
        include::finish(reader, text, &included)?;
        reader = Reader::default();
    }
    // The last is the nearest to what the scene says itself.
    for one in included.iter().rev() {
        include::put_before(&mut tree, one.tree()?, &mut reader);
    }
    let mut reader = SceneReader::new(reader, loader);
    let scene = reader.scene(&tree);
    include::finish(reader.reader, text, &included)?;
    // Where there is no scene there is a fault.
    scene.ok_or_else(|| TextError::one(text, tree.span, "this scene cannot be used"))
}

/// What may stand at byte `at` of a text, as its readers know it; nothing where none of them comes there.
pub(crate) fn expected(text: &str, at: usize, loader: &mut dyn Loader) -> Vec<Expected> {
    let Ok(mut tree) = parse(text, "scene", "Scene(version: 1, …)") else { return Vec::new() };
    let mut gathering = Gathering::new(loader, text.len());
    gathering.gather(&tree, None);
    // What cannot be fetched is left out: its faults are said elsewhere.
    let (included, _) = gathering.finish();
    let own: Vec<&str> = include::own_fields(&tree).collect();
    let left: Vec<String> =
        FIELDS.iter().filter(|field| !own.contains(field)).map(|field| (*field).to_owned()).collect();
    for one in included.iter().rev() {
        if let Ok(one) = one.tree() {
            include::put_before(&mut tree, one, &mut Reader::default());
        }
    }
    let mut reader = SceneReader::new(Reader::asked_at(at), loader);
    reader.scene(&tree);
    let mut expected = reader.reader.into_expected();
    // What an included text says, the scene may say too.
    for field in expected.iter_mut().filter(|one| one.kind == ExpectedKind::Field && one.of == "Scene") {
        field.names.clone_from(&left);
    }
    expected
}

impl<'l> SceneReader<'l> {
    fn new(mut reader: Reader, loader: &'l mut dyn Loader) -> Self {
        reader.explain(&words::OF_OTHERS);
        Self {
            reader,
            loader,
            simulation: None,
            names: Names::default(),
            lasts: None,
            named: parts::Named::new(),
            sequenced: parts::Sequenced::default(),
            made: 0,
            motors: actuators::Motors::default(),
            ties: loops::Asked::new(),
            members: Vec::new(),
            gravity: GRAVITY,
            stood: Vec::new(),
            awaited: Vec::new(),
        }
    }
}

impl SceneReader<'_> {
    fn scene(&mut self, tree: &Node<'_>) -> Option<Scene> {
        let fields = self.reader.fields(tree, &["Scene"], &[])?;
        // A later version may mean anything by the rest.
        if self.reader.is_later(&fields, "scene", VERSION, true) {
            return None;
        }
        self.reader.only_known(&fields, &FIELDS);
        // What is wrong with it is said where settings are read.
        self.lasts = fields.get("duration").and_then(|node| match node.value {
            Value::Number(seconds) if seconds > 0.0 => Some(seconds),
            _ => None,
        });
        let gravity = fields.get("gravity").and_then(|node| self.reader.vector(node, "gravity"));
        let found = self.figures(&fields, gravity);
        let (name, figure) = found.unzip();
        if let Some(figure) = &figure {
            self.simulation = Some(Simulation::new(figure, self.gravity));
            self.names = Names::of(figure);
        }
        let figure = self.carries(&fields, figure);
        let left_out = self.place_actuators();
        let mut given = self.drives(&fields);
        self.sequence_of_parts(&fields, &mut given);
        self.idle_motors(&mut given);
        let terrain = self.terrain(&fields);
        let walk = self.walk(&fields, name.as_deref().zip(figure.as_ref()), &given, terrain.as_ref());
        self.start(&fields, &given, walk.as_ref());
        let clipped = self.clip(&fields, &mut given);
        self.springs(&fields);
        self.loops(&fields);
        let open = self.place_ties();
        self.pushes(&fields);
        self.limits(&fields);
        let (friction, mut said) = self.ground(&fields, terrain.as_ref());
        self.collisions(&fields);
        let walked = walk.as_ref().map(walk::Planned::duration);
        let (notes, reaching) = self.reaches(&fields, walked);
        said.append(&mut self.stood);
        said.extend(left_out);
        said.extend(open);
        said.extend(notes);
        said.extend(clipped);
        let settings = self.settings(&fields, walked);
        if let Some(settings) = &settings {
            self.check(&fields, settings);
        }
        said.extend(self.idle_blows());
        said.extend(settings.as_ref().and_then(settings::cut));
        said.extend(walk.is_none().then(|| self.begins_below()).flatten());
        said.extend(settings.as_ref().into_iter().flat_map(|settings| self.late_pushes(settings.duration)));
        let simulation = self.simulation.take()?;
        Some(Scene {
            name: name?,
            simulation,
            settings: settings?,
            notes: said,
            walks: walk.map_or_else(Vec::new, |walk| walk.into_walked(&reaching)),
            members: std::mem::take(&mut self.members),
            friction,
        })
    }

    /// Refuses what can be told without beginning to run, where it stands.
    fn check(&mut self, fields: &Fields<'_, '_>, settings: &Settings) {
        let Some(simulation) = self.simulation.as_ref().filter(|_| self.reader.count() == 0) else { return };
        let Err(error) = simulation.check_setup(settings) else { return };
        let place = match &error {
            SetupError::NothingTouches { link } => {
                self.awaited.iter().find(|(name, _)| name == link).map(|(_, place)| place.clone())
            }
            SetupError::OpenLoop { .. } => fields.get("loops").map(Node::place),
            SetupError::Range { what, .. } if what == "the rate of the run" => {
                fields.get("rate").map(Node::place)
            }
            SetupError::Range { what, .. } if what.starts_with("the number of frames") => {
                fields.get("rate").or(fields.get("duration")).map(Node::place)
            }
            _ => None,
        };
        let method = fields.get("method").or(fields.get("tolerance")).map(Node::place);
        let place = place.or(method).unwrap_or_else(|| fields.at.clone());
        self.setup::<()>(&place, Err(error));
    }

    /// Adds what the simulation has to say about what stands at `span`.
    fn setup<T>(&mut self, span: &Range<usize>, result: Result<T, SetupError>) -> Option<T> {
        result.map_err(|error| self.reader.fault(span.clone(), spelled::setup(&error))).ok()
    }

    /// The figure, if there is one.
    fn figure(&self) -> Option<&Figure> {
        self.simulation.as_ref().map(Simulation::figure)
    }

    /// A curve of degrees of freedom that turn, or of others.
    fn profile(&mut self, node: &Node<'_>, turns: bool) -> Option<Profile> {
        solaris_profiles::text::read_node_within(&mut self.reader, node, turns, self.lasts)
    }

    /// The entries of a field that is a map.
    fn map<'n, 'a>(
        &mut self,
        fields: &Fields<'n, 'a>,
        field: &str,
        example: &str,
    ) -> &'n [(Node<'a>, Node<'a>)] {
        let node = fields.get(field);
        node.and_then(|node| self.reader.entries(node, field, example)).unwrap_or_default()
    }
}
