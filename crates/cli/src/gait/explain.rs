//! `solaris gait explain`: key postures, and how much room they have.

use super::picture::Picture;
use super::postures::{Asked, value};
use crate::args::ExplainArgs;
use crate::error::CliError;
use crate::print::{print, write_json};
use serde::Serialize;
use solaris::gait::determinants::{Condition, KeyPosture, KeySolution, Proportions};
use solaris::gait::stick_figures;
use solaris::view::{Room, Stick, StickLine, StickPart, postures};

pub(super) fn run(args: &ExplainArgs) -> Result<(), CliError> {
    let picture = Picture::asked(&args.outputs)?;
    let asked = Asked::of(&args.postures)?;
    let refuse = |error| CliError::of_gait(error, &args.postures);
    let values = &asked.choice.values;
    let solution = asked.solution().map_err(refuse)?;
    let conditions = asked.determinants.conditions(&asked.proportions, values).map_err(refuse)?;
    let title = format!("Key postures of {}", asked.title().to_lowercase());
    let svg = || postures(&sticks(&asked.proportions, &solution), &rooms(&conditions), &title);
    picture.write(&title, svg)?;
    if args.json {
        let said = Said::of(&asked, &solution, &conditions);
        return print(|out| write_json(out, &said));
    }
    print(|out| {
        writeln!(out, "{title}\n\nParameters\n")?;
        for (parameter, number) in asked.parameters.iter().zip(values) {
            writeln!(out, "  {}", value(parameter, *number))?;
        }
        writeln!(out, "\nSpeed\n\n  {}", asked.pace())?;
        writeln!(out, "\nAngles\n")?;
        for (symbol, what, angle) in &solution.angles {
            writeln!(out, "  {symbol:<3} {:>7.2}°  {what}", angle.to_degrees())?;
        }
        writeln!(out, "\nRoom that the inequalities leave\n")?;
        let texts: Vec<String> = conditions.iter().map(|c| format!("{} {}", c.name, c.text)).collect();
        let width = texts.iter().map(|text| text.chars().count()).max().unwrap_or(0);
        for (condition, text) in conditions.iter().zip(&texts) {
            let (sides, room) = sides(condition);
            writeln!(out, "  {text:<width$}  {sides:<21} {room:>9}")?;
        }
        for remark in solution.remarks.iter().filter(|remark| !remark.holds()) {
            writeln!(out, "\nnote: the thesis asks for {remark}; nothing breaks without")?;
        }
        write!(out, "{}", asked.note())?;
        picture.tell(out, "-o postures.svg to see them")
    })
}

/// The postures as they are drawn.
fn sticks(p: &Proportions, solution: &KeySolution) -> Vec<Stick> {
    let part = |index: usize| {
        [
            StickPart::SwingArm,
            StickPart::Swing,
            StickPart::Trunk,
            StickPart::Head,
            StickPart::Stance,
            StickPart::StanceArm,
        ][index]
    };
    let stick = |(posture, lines): (KeyPosture, Vec<Vec<[f64; 2]>>)| Stick {
        name: posture.name.to_owned(),
        lines: lines.into_iter().enumerate().map(|(i, points)| StickLine { part: part(i), points }).collect(),
        angles: angles(&posture),
    };
    stick_figures(p, solution).into_iter().map(stick).collect()
}

/// What a posture's parts are at.
fn angles(posture: &KeyPosture) -> Vec<(String, String)> {
    let degrees = |angle: f64| format!("{:.1}°", angle.to_degrees() + 0.0).replace("-0.0°", "0.0°");
    let [stance, swing] = posture.legs;
    let named = [
        ("stance thigh", stance.thigh),
        ("stance shank", stance.shank),
        ("stance foot", stance.foot),
        ("swing thigh", swing.thigh),
        ("swing shank", swing.shank),
        ("swing foot", swing.foot),
        ("pelvic tilt", posture.pelvis.tilt),
        ("rotation", posture.pelvis.rotation),
    ];
    named.into_iter().map(|(name, angle)| (name.to_owned(), degrees(angle))).collect()
}

/// How an inequality and its room are written.
fn sides(condition: &Condition) -> (String, String) {
    let decimals = if condition.symbol == "°" { 2 } else { 4 };
    let [lesser, greater] = condition.sides;
    let unit = condition.symbol;
    let sign = if condition.holds() { "<" } else { "≥" };
    (
        format!("{lesser:.decimals$}{unit} {sign} {greater:.decimals$}{unit}"),
        format!("{:.decimals$}{unit}", condition.room()),
    )
}

/// Rooms as bars: angles against 30°, lengths against a fifth, cosines against 1.
fn rooms(conditions: &[Condition]) -> Vec<Room> {
    let room = |condition: &Condition| {
        let (sides, room) = sides(condition);
        let whole = match condition.symbol {
            "°" => 30.0,
            "" => 1.0,
            _ => 0.2 * condition.sides[0].abs().max(condition.sides[1].abs()),
        };
        let text = format!("{} {}", condition.name, condition.text);
        Room { text, sides, room, share: condition.room() / whole }
    };
    conditions.iter().map(room).collect()
}

/// Postures for other programs.
#[derive(Serialize)]
struct Said {
    determinants: usize,
    step_frequency_per_min: f64,
    /// What lengths are in.
    length_unit: &'static str,
    step_length: f64,
    /// In the unit of length a second.
    speed: f64,
    speed_m_s: f64,
    parameters: Vec<Parameter>,
    angles_deg: Vec<(&'static str, f64, &'static str)>,
    conditions: Vec<Inequality>,
    remarks: Vec<Inequality>,
}

#[derive(Serialize)]
struct Parameter {
    name: &'static str,
    symbol: &'static str,
    value: f64,
    unit: &'static str,
}

#[derive(Serialize)]
struct Inequality {
    name: &'static str,
    text: &'static str,
    sides: [f64; 2],
    unit: &'static str,
    room: f64,
}

impl Said {
    fn of(asked: &Asked, solution: &KeySolution, conditions: &[Condition]) -> Self {
        let unit = |unit: &'static str| if unit == " m" { asked.unit } else { unit.trim() };
        let inequality = |c: &Condition| Inequality {
            name: c.name,
            text: c.text,
            sides: c.sides,
            unit: unit(c.symbol),
            room: c.room(),
        };
        let parameters = asked.parameters.iter().zip(&asked.choice.values).map(|(p, value)| Parameter {
            name: p.name,
            symbol: p.symbol,
            value: *value,
            unit: unit(p.unit),
        });
        Self {
            determinants: asked.determinants.count(),
            step_frequency_per_min: asked.choice.step_frequency,
            length_unit: asked.unit,
            step_length: asked.choice.step_length,
            speed: asked.speed(),
            speed_m_s: asked.metres_per_second(),
            parameters: parameters.collect(),
            angles_deg: solution
                .angles
                .iter()
                .map(|(s, what, angle)| (*s, angle.to_degrees(), *what))
                .collect(),
            conditions: conditions.iter().map(inequality).collect(),
            remarks: solution.remarks.iter().map(inequality).collect(),
        }
    }
}
