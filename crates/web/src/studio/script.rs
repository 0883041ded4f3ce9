//! A scene's text, while it is written: its faults, what it says, what may stand there, and what comes of it.

use super::{Alive, Posed, Shown, joints};
use crate::failed;
use crate::figure::Figure;
use js_sys::Function;
use serde_json::{Map, Value, json};
use solaris::files::{Given, Source};
use solaris::model::text::{Content, Node, parse};
use solaris::model::{Ground, TextError};
use solaris::modes::study::{StudyOptions, study};
use solaris::modes::{EndCondition, Method, Observer, RunPass, Simulation, Step};
use solaris::scene::{Scene, complete};
use solaris::view::PagePerson;
use solaris::view::precision::{page, report};
use std::path::Path;
use wasm_bindgen::prelude::*;

const NOUN: &str = "scene";
const BEGINS: &str = "Scene(version: 1, …)";

/// Files that scenes and models may name.
#[wasm_bindgen]
#[derive(Default)]
pub struct Shelf {
    pub(crate) files: Given,
}

#[wasm_bindgen]
impl Shelf {
    /// Without any.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Shelf {
        Self::default()
    }

    /// One file more; it takes the place of one of the same name.
    pub fn add(&mut self, name: String, bytes: Vec<u8>) {
        self.files.add(name, bytes);
    }

    /// Their names.
    #[wasm_bindgen(getter)]
    pub fn names(&self) -> Vec<String> {
        self.files.names().map(str::to_owned).collect()
    }
}

/// A scene's text.
#[wasm_bindgen]
pub struct Script {
    text: String,
    scene: Result<Scene, TextError>,
}

#[wasm_bindgen]
impl Script {
    /// Reads a text; what is wrong with it is told by `faults`.
    #[wasm_bindgen(constructor)]
    pub fn new(text: String, shelf: &Shelf) -> Script {
        let mut loader = Source::new(&shelf.files).loader(Path::new(""));
        let scene = solaris::scene::read(&text, &mut loader);
        Self { text, scene }
    }

    /// Everything that is wrong with it, as JSON: from and to (places of the text as JavaScript counts them), the message, and what to write
    /// instead where that is known.
    pub fn faults(&self) -> String {
        let Err(error) = &self.scene else { return "[]".to_owned() };
        let units = |at: usize| utf16(&self.text, at);
        let fault = |fault: &solaris::model::text::TextFault| {
            json!({
                "from": units(fault.place.span.start),
                "to": units(fault.place.span.end),
                "line": fault.place.line,
                "column": fault.place.column,
                "message": fault.message,
                "instead": fault.suggestion().map(|meant| meant.replacement),
            })
        };
        Value::Array(error.faults.iter().map(fault).collect()).to_string()
    }

    /// Whether it is a scene.
    #[wasm_bindgen(getter, js_name = isWhole)]
    pub fn is_whole(&self) -> bool {
        self.scene.is_ok()
    }

    /// What it says, as JSON: the figure with its joints, where each degree of freedom begins and what drives it, how long, by which
    /// method, with or without ground and walk, and remarks.
    pub fn outline(&self) -> Result<String, JsError> {
        let scene = self.scene()?;
        let (simulation, settings) = (scene.simulation(), scene.settings());
        let layout = scene.figure().layout();
        let written = self.written();
        let (q, v) = simulation.state();
        let drives: Vec<Value> = (0..layout.nv())
            .map(|dof| {
                json!({
                    "steps": simulation.driven_by(dof).iter().map(step).collect::<Vec<_>>(),
                    "written": written.get(&layout.v_names()[dof]),
                })
            })
            .collect();
        Ok(json!({
            "name": scene.name(),
            "figure": scene.figure().name(),
            "duration": settings.duration,
            "rate": settings.rate,
            "method": method(scene.simulation(), &settings.method),
            "ground": simulation.grounded().is_some(),
            "walk": scene.walk().is_some(),
            "walked": scene.walked(),
            "joints": joints(&self.figure()?),
            "drives": drives,
            "q": q,
            "v": v,
            "notes": scene.notes(),
        })
        .to_string())
    }

    /// The figure as it begins.
    pub fn posed(&self) -> Result<Posed, JsError> {
        Posed::at(self.figure()?, self.scene()?.simulation().state().0.to_vec(), self.ground()?)
    }

    /// The figure; of several, all of them as one.
    pub fn figure(&self) -> Result<Figure, JsError> {
        let scene = self.scene()?;
        let mut figure = Figure::own(scene.figure().clone());
        figure.gravity = *scene.simulation().gravity();
        let part =
            |(first, alone): (usize, &solaris::model::Figure)| PagePerson { first, figure: alone.clone() };
        figure.parts = scene.parts().map(part).collect();
        Ok(figure)
    }

    /// Runs it; `tell` is called now and then with how far it has come (0 to 1, or nothing where that is not known) and in which words.
    pub fn run(&self, tell: &Function) -> Result<Ran, JsError> {
        let mut scene = self.scene()?.clone();
        scene.settings_mut().forces = true;
        let done = scene.simulate(&mut Telling { tell }).map_err(failed)?;
        let report = serde_json::to_string(&done.report).map_err(failed)?;
        let remarks = done.report.remarks.iter().map(ToString::to_string).collect();
        let shown = Shown::new(self.figure()?, done.motion, scene.name().to_owned());
        Ok(Ran { shown: Some(shown), report, remarks })
    }

    /// Runs it by every method and gives the page that says which comes how near in which time. `now` gives seconds; `tell` as for `run`;
    /// `so_far` gets the page of what there is so far.
    pub fn study(&self, now: &Function, tell: &Function, so_far: &Function) -> Result<String, JsError> {
        let scene = self.scene()?;
        let settings = scene.settings();
        let wanted = match settings.method {
            Method::Automatic { tolerance } => tolerance,
            _ => StudyOptions::default().wanted,
        };
        let options = StudyOptions { wanted, repeats: 1, ..StudyOptions::default() };
        let title = format!("{}: precision against work", scene.name());
        let pages = |study: &solaris::modes::study::Study| {
            page(&report(study, &title, settings.duration, settings.rate))
        };
        let found = study(scene.simulation(), settings, &options, &mut Timed { now, tell }, &mut |study| {
            let _ = so_far.call1(&JsValue::NULL, &pages(study).into());
        });
        Ok(pages(&found.map_err(failed)?))
    }

    /// Its simulation, to go on while it is looked at.
    pub fn alive(&self) -> Result<Alive, JsError> {
        let scene = self.scene()?;
        let simulation = scene.simulation();
        let stepping = simulation.stepping_for(scene.settings().method);
        Alive::new(self.figure()?, simulation.start(stepping).map_err(failed)?, self.ground()?)
    }

    /// The text with another value at a path of fields and keys, or without it; a key of a map stands in quotes.
    pub fn edit(&self, path: Vec<String>, value: Option<String>) -> Result<String, JsError> {
        let path: Vec<&str> = path.iter().map(String::as_str).collect();
        solaris::model::text::edit(&self.text, NOUN, BEGINS, &path, value.as_deref()).map_err(failed)
    }
}

/// What may stand at a place of a scene's text (as JavaScript counts), as JSON.
#[wasm_bindgen(js_name = completeScene)]
pub fn complete_scene(text: &str, at: usize, shelf: &Shelf) -> String {
    let mut loader = Source::new(&shelf.files).loader(Path::new(""));
    let found = complete(text, byte(text, at), &mut loader);
    let items: Vec<Value> = found
        .items
        .iter()
        .map(|item| json!({ "label": item.label, "insert": item.insert, "detail": item.detail }))
        .collect();
    json!({ "from": utf16(text, found.from), "to": utf16(text, found.to), "items": items }).to_string()
}

/// What came of a scene.
#[wasm_bindgen]
pub struct Ran {
    shown: Option<Shown>,
    report: String,
    remarks: Vec<String>,
}

#[wasm_bindgen]
impl Ran {
    /// Its motion; it can be taken once.
    pub fn shown(&mut self) -> Result<Shown, JsError> {
        self.shown.take().ok_or_else(|| failed("the motion was taken before"))
    }

    /// How it was found, as JSON.
    #[wasm_bindgen(getter)]
    pub fn report(&self) -> String {
        self.report.clone()
    }

    /// What is worth knowing though nothing failed.
    #[wasm_bindgen(getter)]
    pub fn remarks(&self) -> Vec<String> {
        self.remarks.clone()
    }
}

impl Script {
    fn scene(&self) -> Result<&Scene, JsError> {
        self.scene.as_ref().map_err(|error| failed(error.to_string()))
    }

    /// The ground, as a picture has it.
    fn ground(&self) -> Result<Option<Ground>, JsError> {
        let scene = self.scene()?;
        let (plane, walks) = (scene.simulation().grounded(), scene.walk().is_some());
        let level = walks.then_some(Ground { height: 0.0, friction: None });
        Ok(plane.map(|(plane, _)| Ground { height: plane.height, friction: Some(plane.friction) }).or(level))
    }

    /// What the text says of degrees of freedom and joints by their own names.
    fn written(&self) -> Map<String, Value> {
        let Ok(tree) = parse(&self.text, NOUN, BEGINS) else { return Map::new() };
        let Some(Content::Fields(fields)) = tree.group().map(|group| &group.content) else {
            return Map::new();
        };
        let drives = fields.iter().find(|(field, _)| field.name == "drives").map(|(_, node)| node);
        let entries = drives.and_then(Node::entries).unwrap_or_default();
        entries
            .iter()
            .filter_map(|(key, value)| match &key.value {
                solaris::model::text::Value::Text(name) => {
                    Some((name.to_string(), self.text[value.span.clone()].into()))
                }
                _ => None,
            })
            .collect()
    }
}

/// A drive, in words and numbers.
fn step(step: &Step) -> Value {
    let until = match &step.until {
        EndCondition::Time(time) => json!({ "at": time }),
        EndCondition::Lasting(time) => json!({ "lasting": time }),
        EndCondition::Position { dof, value } => json!({ "passes": dof, "value": value }),
        EndCondition::Velocity { dof, value } => json!({ "passesSpeed": dof, "value": value }),
        EndCondition::TouchDown { link } => json!({ "touches": link }),
        EndCondition::LiftOff { link } => json!({ "leaves": link }),
        _ => Value::Null,
    };
    json!({ "drive": step.drive.name(), "until": until })
}

fn method(simulation: &Simulation, method: &Method) -> String {
    match method {
        Method::Usual => self::method(simulation, &simulation.usual_method()),
        Method::Automatic { tolerance } => format!("automatic, to {tolerance:e}"),
        Method::Fixed { rule, step } => format!("{rule:?}, steps of {step:e} s"),
        Method::Impulses { step } => format!("impulses, steps of {step:e} s"),
        other => format!("{other:?}"),
    }
}

/// A place of a text as JavaScript counts it: pairs of bytes of UTF-16.
fn utf16(text: &str, byte: usize) -> usize {
    text.char_indices().take_while(|(at, _)| *at < byte).map(|(_, letter)| letter.len_utf16()).sum()
}

/// The byte at a place as JavaScript counts it.
fn byte(text: &str, units: usize) -> usize {
    let mut left = units;
    for (at, letter) in text.char_indices() {
        if left < letter.len_utf16() {
            return at;
        }
        left -= letter.len_utf16();
    }
    text.len()
}

/// Tells a function how far a run has come.
struct Telling<'a> {
    tell: &'a Function,
}

impl Observer for Telling<'_> {
    fn progress(&mut self, share: f64) {
        let _ = self.tell.call2(&JsValue::NULL, &share.into(), &JsValue::NULL);
    }

    fn pass(&mut self, pass: &RunPass<'_>) {
        let words = format!("pass {}, {}", pass.number, pass.method);
        let share = if pass.duration > 0.0 { pass.time / pass.duration } else { 0.0 };
        let _ = self.tell.call2(&JsValue::NULL, &share.into(), &words.into());
    }
}

/// The same with a clock.
struct Timed<'a> {
    now: &'a Function,
    tell: &'a Function,
}

impl Observer for Timed<'_> {
    fn now(&self) -> Option<f64> {
        self.now.call0(&JsValue::NULL).ok().and_then(|now| now.as_f64())
    }

    fn progress(&mut self, share: f64) {
        let _ = self.tell.call2(&JsValue::NULL, &share.into(), &JsValue::NULL);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted_as_javascript_counts() {
        let text = "aé😀b";
        let ends: Vec<usize> = [0, 1, 3, 7, 8].iter().map(|at| utf16(text, *at)).collect();
        assert_eq!(ends, [0, 1, 2, 4, 5]);
        for (units, at) in [(0, 0), (1, 1), (2, 3), (3, 3), (4, 7), (5, 8), (9, 8)] {
            assert_eq!(byte(text, units), at, "{units}");
        }
    }
}
