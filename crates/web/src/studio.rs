//! What the studio asks beyond the package: pictures, figures that are posed, scenes that are written and run, curves.

mod alive;
mod anatomy;
mod curve;
mod dropped;
mod people;
mod posed;
mod script;
mod shown;
mod steered;

pub use alive::Alive;
pub use curve::curve;
pub use dropped::{Dropped, Moments};
pub use people::people_curves;
pub use posed::Posed;
pub use script::{Ran, Script, Shelf, complete_scene};
pub use shown::Shown;
pub use steered::Steered;

use crate::failed;
use crate::figure::Figure;
use crate::options::gait_options;
use crate::walk::WalkOptions;
use serde_json::{Value, json};
use solaris::model::{AxisKind, Figure as Body, Ground, Motion, MotionInfo};
use solaris::view::{PageOptions, PagePerson, page_data_without_skin, page_skin, page_skins};
use std::cell::RefCell;
use wasm_bindgen::prelude::*;

thread_local! {
    /// What was said as the engine broke.
    static PANIC: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Keeps what is said as the engine breaks: its callers see a trap only.
#[wasm_bindgen(start)]
pub fn keep_panics() {
    std::panic::set_hook(Box::new(|panic| PANIC.set(Some(panic.to_string()))));
}

/// What was said as the engine broke.
#[wasm_bindgen(js_name = lastPanic)]
pub fn last_panic() -> Option<String> {
    PANIC.take()
}

/// Within which values of one number, all else as it is, a walk can be planned: two numbers, or nothing.
#[wasm_bindgen(js_name = walkRange)]
pub fn walk_range(
    figure: &Figure,
    options: Option<WalkOptions>,
    field: &str,
) -> Result<Option<Vec<f64>>, JsError> {
    let options = gait_options(options)?;
    Ok(options.range_of(&figure.figure, field).map_err(failed)?.map(|range| range.to_vec()))
}

thread_local! {
    /// The person who was shown last, and the skin.
    static SKIN: RefCell<Option<(Body, Option<String>)>> = const { RefCell::new(None) };
    /// The same of several people.
    static SKINS: RefCell<Option<(Vec<PagePerson>, String)>> = const { RefCell::new(None) };
}

/// What a page holds of a motion, as JSON; `skinned`: with the skins of people.
pub(crate) fn shown_data(
    figure: &Body,
    motion: &Motion,
    options: &PageOptions,
    skinned: bool,
) -> Result<String, JsError> {
    let data = page_data_without_skin(figure, motion, options).map_err(failed)?;
    let skin = match (skinned, &options.people[..]) {
        (false, _) => None,
        (true, []) => skin_of(figure).map(|skin| format!("\"body\":{skin}")),
        (true, people) => Some(format!("\"bodies\":{}", skins_of(people))),
    };
    Ok(skin.map_or_else(|| data.clone(), |skin| format!("{{{skin},{}", &data[1..])))
}

/// The skin of a person as a page holds it, as JSON; none of other figures.
#[wasm_bindgen(js_name = skinOf)]
pub fn skin(figure: &Figure) -> Option<String> {
    skin_of(&figure.figure)
}

/// The skin of the same person is made once.
fn skin_of(figure: &Body) -> Option<String> {
    SKIN.with_borrow_mut(|last| {
        if last.as_ref().is_none_or(|(who, _)| who != figure) {
            *last = Some((figure.clone(), page_skin(figure)));
        }
        last.as_ref().and_then(|(_, skin)| skin.clone())
    })
}

fn skins_of(people: &[PagePerson]) -> String {
    SKINS.with_borrow_mut(|last| {
        if let Some((who, skins)) = last.as_ref()
            && who == people
        {
            return skins.clone();
        }
        let skins = page_skins(people);
        *last = Some((people.to_vec(), skins.clone()));
        skins
    })
}

/// What a page shows of a figure that stands still, over a `ground` where there is one, to begin a picture with; `skinned`: with the skin of a
/// person.
fn still(figure: &Figure, q: &[f64], ground: Option<Ground>, skinned: bool) -> Result<String, JsError> {
    let nv = figure.figure.layout().nv();
    let info = MotionInfo { gravity: figure.gravity, ground, ..MotionInfo::on_earth(&figure.figure, 60.0) };
    let states = [q.to_vec(), vec![0.0; nv], vec![0.0; nv]];
    let motion = Motion::new(&figure.figure, info, vec![0.0], states).map_err(failed)?;
    let options = PageOptions { people: figure.parts.clone(), ..PageOptions::default() };
    shown_data(&figure.figure, &motion, &options, skinned)
}

/// The joints of a figure with their degrees of freedom.
fn joints(figure: &Figure) -> Value {
    let figure = &figure.figure;
    let layout = figure.layout();
    let joint = |(link, at): (&solaris::model::Link, &solaris::model::JointLayout)| {
        let dofs: Vec<Value> = (at.v..at.v + at.nv)
            .map(|dof| {
                let limits = link.joint().kind().axes().get(dof - at.v).and_then(|axis| axis.limits);
                json!({
                    "name": layout.v_names()[dof],
                    "index": dof,
                    "coordinate": layout.coordinate(dof).filter(|_| !figure.follows(dof)),
                    "turns": layout.axis_kind(dof) == AxisKind::Rotation,
                    "lower": limits.map(|limits| limits.lower),
                    "upper": limits.map(|limits| limits.upper),
                })
            })
            .collect();
        json!({ "name": link.joint().name(), "link": link.name(), "dofs": dofs })
    };
    figure.links().iter().zip(layout.joints()).map(joint).collect()
}
