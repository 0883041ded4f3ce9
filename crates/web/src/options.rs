//! Plain objects of JavaScript, field by field: what is asked of walks and runs.

use crate::failed;
use crate::figure::HumanOptions;
use crate::walk::WalkOptions;
use js_sys::{Array, Reflect};
#[cfg(feature = "usual")]
use solaris::gait::RunWalkOptions;
use solaris::gait::{GaitKind, GaitOptions, PartOptions, Repeats, RunEndOptions, StairOptions};
use solaris::model::{Human, nearest};
use std::collections::BTreeMap;
use wasm_bindgen::{JsError, JsValue};

/// The greatest whole number of which JavaScript knows each before it.
const MOST_SEED: u64 = (1 << 53) - 1;

/// Options of a walk or a run.
pub(crate) fn gait_options(given: Option<WalkOptions>) -> Result<GaitOptions, JsError> {
    let Some(given) = given else { return Ok(GaitOptions::default()) };
    let mut fields = Fields::new(&given, "")?;
    let options = GaitOptions {
        gait: fields.one_of("gait", [("walk", GaitKind::Walk), ("run", GaitKind::Run)])?.unwrap_or_default(),
        determinants: fields.count("determinants")?,
        step_frequency: fields.number("stepFrequency")?,
        step_length: fields.number("stepLength")?,
        speed: fields.number("speed")?,
        steps: fields.count("steps")?,
        distance: fields.number("distance")?,
        turn: fields.number("turn")?.unwrap_or_default(),
        backward: fields.flag("backward")?.unwrap_or_default(),
        path: fields.list("path", |at, point| pair(at, "x, z", point))?,
        then: fields.list("then", part)?.unwrap_or_default(),
        slope: fields.number("slope")?,
        stairs: fields.get("stairs", stairs)?,
        ground: fields.list("ground", |at, point| pair(at, "z, height", point))?,
        footholds: fields.list("footholds", numbers)?,
        population: fields.text("population")?,
        manner: fields.text("manner")?,
        left: fields.text("left")?,
        right: fields.text("right")?,
        variability: fields.number("variability")?,
        seed: fields.whole("seed", MOST_SEED)?.unwrap_or_default(),
        style: fields.get("style", named)?.unwrap_or_default(),
        left_first: fields.flag("leftFirst")?,
        cane_load: cane_load(&mut fields)?,
        forefoot: fields.flag("forefoot")?.unwrap_or_default(),
        give: fields.number("give")?,
        from: run_end(&mut fields, ["fromStanding", "fromWalking"])?,
        to: run_end(&mut fields, ["toStanding", "toWalking"])?,
        repeats: fields.one_of("loop", [("moving", Repeats::Moving), ("in_place", Repeats::InPlace)])?,
        rate: fields.number("rate")?,
    };
    fields.end()?;
    Ok(options)
}

fn part(at: &str, given: JsValue) -> Result<PartOptions, JsError> {
    let mut fields = Fields::new(&given, at)?;
    let part = PartOptions {
        steps: fields.count("steps")?,
        distance: fields.number("distance")?,
        stand: fields.number("stand")?,
        step_frequency: fields.number("stepFrequency")?,
        step_length: fields.number("stepLength")?,
        speed: fields.number("speed")?,
        turn: fields.number("turn")?.unwrap_or_default(),
        backward: fields.flag("backward")?.unwrap_or_default(),
    };
    fields.end()?;
    Ok(part)
}

fn stairs(at: &str, given: JsValue) -> Result<StairOptions, JsError> {
    let mut fields = Fields::new(&given, at)?;
    let stairs = StairOptions {
        count: fields.count("count")?,
        rise: fields.number("rise")?,
        tread: fields.number("tread")?,
    };
    fields.end()?;
    Ok(stairs)
}

/// How a run begins or ends, by the names of its two options.
#[cfg(feature = "usual")]
fn run_end(
    fields: &mut Fields<'_>,
    [standing, walking]: [&'static str; 2],
) -> Result<RunEndOptions, JsError> {
    match (fields.flag(standing)?.unwrap_or_default(), fields.get(walking, run_walk)?) {
        (true, Some(_)) => Err(JsError::new(&format!("{standing} and {walking} are both given; drop one"))),
        (true, None) => Ok(RunEndOptions::Standing),
        (false, Some(walk)) => Ok(RunEndOptions::Walking(walk)),
        (false, None) => Ok(RunEndOptions::Running),
    }
}

/// Without runs nothing is said of them.
#[cfg(not(feature = "usual"))]
#[allow(clippy::unnecessary_wraps, reason = "as with runs")]
fn run_end(_: &mut Fields<'_>, _: [&'static str; 2]) -> Result<RunEndOptions, JsError> {
    Ok(RunEndOptions::Running)
}

#[cfg(feature = "usual")]
fn run_walk(at: &str, given: JsValue) -> Result<RunWalkOptions, JsError> {
    let mut fields = Fields::new(&given, at)?;
    let walk = RunWalkOptions { steps: fields.count("steps")?, speed: fields.number("speed")? };
    fields.end()?;
    Ok(walk)
}

/// What a cane bears; the smallest entry has none.
fn cane_load(fields: &mut Fields<'_>) -> Result<Option<f64>, JsError> {
    if cfg!(feature = "usual") { fields.number("caneLoad") } else { Ok(None) }
}

/// A person with what hands carry and hold, and with a shorter leg.
pub(crate) fn human_options(human: Human, given: Option<HumanOptions>) -> Result<Human, JsError> {
    let Some(given) = given else { return Ok(human) };
    let mut fields = Fields::new(&given, "")?;
    let loads = fields.get("load", named)?.unwrap_or_default();
    let shorter = fields.get("shorterLeg", named)?.unwrap_or_default();
    #[cfg(feature = "usual")]
    let human = match fields.text("cane")? {
        Some(hand) => human.cane(hand),
        None => human,
    };
    fields.end()?;
    let human = loads.into_iter().fold(human, |human, (hand, load)| human.load(hand, load));
    Ok(shorter.into_iter().fold(human, |human, (leg, by)| human.shorter_leg(leg, by)))
}

/// Numbers by their names, such as those of the style: `armSwing` there is `arm_swing` here.
fn named(at: &str, given: JsValue) -> Result<BTreeMap<String, f64>, JsError> {
    let mut numbers = BTreeMap::new();
    for key in keys(at, &given)? {
        let at = format!("{at}.{key}");
        let value = value(&at, &given, &key)?;
        if !value.is_undefined() {
            numbers.insert(snaked(&key), number(&at, value)?);
        }
    }
    Ok(numbers)
}

fn number(at: &str, given: JsValue) -> Result<f64, JsError> {
    given.as_f64().ok_or_else(|| wrong(at, "a number", &given))
}

fn numbers(at: &str, given: JsValue) -> Result<Vec<f64>, JsError> {
    let one = |(i, item)| number(&format!("{at}[{i}]"), item);
    items(at, &given)?.iter().enumerate().map(one).collect()
}

fn pair(at: &str, of: &str, given: JsValue) -> Result<[f64; 2], JsError> {
    let pair = numbers(at, given)?;
    <[f64; 2]>::try_from(pair.as_slice())
        .map_err(|_| failed(format!("{at} has {} numbers; it must have 2: {of}", pair.len())))
}

fn items(at: &str, given: &JsValue) -> Result<Array, JsError> {
    if Array::is_array(given) { Ok(Array::from(given)) } else { Err(wrong(at, "an array", given)) }
}

fn keys(at: &str, given: &JsValue) -> Result<Vec<String>, JsError> {
    let own = given.is_object().then(|| Reflect::own_keys(given).map_err(|_| unreadable(at))).transpose()?;
    let own = own.filter(|_| !Array::is_array(given)).ok_or_else(|| wrong(at, "a plain object", given))?;
    Ok(own.iter().filter_map(|key| key.as_string()).collect())
}

/// A field of an object, undefined where there is none.
fn value(at: &str, of: &JsValue, key: &str) -> Result<JsValue, JsError> {
    Reflect::get(of, &key.into()).map_err(|_| unreadable(at))
}

fn unreadable(at: &str) -> JsError {
    failed(format!("{at} cannot be read"))
}

fn wrong(at: &str, kind: &str, given: &JsValue) -> JsError {
    let given = match (given.as_string(), given.as_f64(), given.as_bool()) {
        (Some(text), ..) => format!("'{text}'"),
        (_, Some(number), _) => number.to_string(),
        (.., Some(flag)) => flag.to_string(),
        _ if Array::is_array(given) => "an array".to_owned(),
        _ if given.is_null() || given.is_undefined() => "nothing".to_owned(),
        _ => "something else".to_owned(),
    };
    failed(format!("{at} must be {kind}; it is {given}"))
}

/// The fields of an object, each looked for by its name, `stepFrequency` or `step_frequency`; what is null or undefined is not there.
struct Fields<'a> {
    of: &'a JsValue,
    /// What the object is called within the options; they themselves by no name.
    name: &'a str,
    /// Its fields.
    given: Vec<String>,
    /// Which were looked for.
    known: Vec<&'static str>,
}

impl<'a> Fields<'a> {
    fn new(of: &'a JsValue, name: &'a str) -> Result<Self, JsError> {
        let given = keys(if name.is_empty() { "the options" } else { name }, of)?;
        Ok(Self { of, name, given, known: Vec::new() })
    }

    fn get<T>(
        &mut self,
        name: &'static str,
        read: impl FnOnce(&str, JsValue) -> Result<T, JsError>,
    ) -> Result<Option<T>, JsError> {
        self.known.push(name);
        let at = if self.name.is_empty() { name.to_owned() } else { format!("{}.{name}", self.name) };
        for key in [name, &snaked(name)] {
            let value = value(&at, self.of, key)?;
            if !value.is_null() && !value.is_undefined() {
                return read(&at, value).map(Some);
            }
        }
        Ok(None)
    }

    fn number(&mut self, name: &'static str) -> Result<Option<f64>, JsError> {
        self.get(name, number)
    }

    /// A whole number up to one that is told.
    fn whole(&mut self, name: &'static str, most: u64) -> Result<Option<u64>, JsError> {
        self.get(name, |at, value| match value.as_f64() {
            Some(whole) if (0.0..=most as f64).contains(&whole) && whole.fract() == 0.0 => Ok(whole as u64),
            _ => Err(wrong(at, &format!("a whole number from 0 to {most}"), &value)),
        })
    }

    fn count(&mut self, name: &'static str) -> Result<Option<usize>, JsError> {
        Ok(self.whole(name, u32::MAX.into())?.map(|count| count as usize))
    }

    fn flag(&mut self, name: &'static str) -> Result<Option<bool>, JsError> {
        self.get(name, |at, value| value.as_bool().ok_or_else(|| wrong(at, "true or false", &value)))
    }

    fn text(&mut self, name: &'static str) -> Result<Option<String>, JsError> {
        self.get(name, |at, value| value.as_string().ok_or_else(|| wrong(at, "a text", &value)))
    }

    fn one_of<T: Copy>(&mut self, name: &'static str, known: [(&str, T); 2]) -> Result<Option<T>, JsError> {
        self.get(name, |at, value| {
            let said = value.as_string();
            let found = known.iter().find(|(word, _)| said.as_deref() == Some(word));
            let [(one, _), (other, _)] = known;
            found.map(|(_, found)| *found).ok_or_else(|| wrong(at, &format!("'{one}' or '{other}'"), &value))
        })
    }

    fn list<T>(
        &mut self,
        name: &'static str,
        read: impl Fn(&str, JsValue) -> Result<T, JsError>,
    ) -> Result<Option<Vec<T>>, JsError> {
        self.get(name, |at, value| {
            let one = |(i, item)| read(&format!("{at}[{i}]"), item);
            items(at, &value)?.iter().enumerate().map(one).collect()
        })
    }

    /// Refuses a field that nobody looked for.
    fn end(self) -> Result<(), JsError> {
        let is_known = |key: &str| self.known.iter().any(|known| *known == key || snaked(known) == key);
        let at = if self.name.is_empty() { "the options" } else { self.name };
        for other in self.given.iter().filter(|key| !is_known(key)) {
            if !value(other, self.of, other)?.is_undefined() {
                let near = nearest(other, self.known.iter().copied());
                let near = near.map_or_else(String::new, |near| format!("did you mean '{near}'? "));
                let known = self.known.join(", ");
                return Err(failed(format!("{at}: there is no '{other}'; {near}known are {known}")));
            }
        }
        Ok(())
    }
}

/// A name with `_` where a capital letter was.
fn snaked(key: &str) -> String {
    let mut found = String::with_capacity(key.len() + 2);
    for letter in key.chars() {
        if letter.is_ascii_uppercase() {
            found.push('_');
        }
        found.push(letter.to_ascii_lowercase());
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn capital_letters_are_words() {
        assert_eq!(snaked("armSwing"), "arm_swing");
        assert_eq!(snaked("arm-swing"), "arm-swing");
    }
}
