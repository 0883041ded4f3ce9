//! `solaris gait map`: where postures exist.

use super::picture::Picture;
use super::postures::{Asked, value};
use crate::args::MapArgs;
use crate::error::{CliError, UsageError};
use crate::print::{print, write_json};
use serde::Serialize;
use solaris::gait::determinants::KeyParameter;
use solaris::gait::{FeasibleMap, MapCondition};
use solaris::view::{Regions, regions};

pub(super) fn run(args: &MapArgs) -> Result<(), CliError> {
    let files = Picture::asked(&args.outputs)?;
    let asked = Asked::of(&args.postures)?;
    let axis = |option: &str, wanted: &str| {
        let index = asked.parameters.iter().position(|parameter| parameter.name == wanted);
        index.ok_or_else(|| {
            let names: Vec<&str> = asked.parameters.iter().map(|parameter| parameter.name).collect();
            let count = asked.determinants.count();
            let why = format!("{count} determinants have no such parameter; they have {}", names.join(", "));
            CliError::option(option, wanted, why)
        })
    };
    let axes = [axis("x", &args.x)?, axis("y", &args.y)?];
    if axes[0] == axes[1] {
        return Err(UsageError::SameAxes.into());
    }
    let span = |span: Option<(f64, f64)>, axis: usize| span.unwrap_or(asked.parameters[axis].range);
    let spans = [span(args.x_span, axes[0]), span(args.y_span, axes[1])];
    let conditions =
        |values: &[f64]| asked.determinants.conditions(&asked.proportions, values).unwrap_or_default();
    let map =
        FeasibleMap::new(&asked.parameters, &asked.choice.values, axes, spans, [args.places; 2], conditions);
    let map = map.map_err(|error| CliError::of_gait(error.into(), &args.postures))?;
    let mark = axes.map(|axis| asked.choice.values[axis]);
    let title = asked.title();
    files.write(&title, || regions(&picture(&map, mark, asked.unit), &title))?;
    if args.json {
        return print(|out| write_json(out, &Said::of(&map)));
    }
    let marked = asked.determinants.conditions(&asked.proportions, &asked.choice.values);
    let marked = marked.map_err(|error| CliError::of_gait(error, &args.postures))?;
    print(|out| {
        writeln!(out, "{title}: {} over {}\n", map.axes[1].name, map.axes[0].name)?;
        writeln!(out, "  {:5.1} % of the map hold all inequalities", 100.0 * map.feasible())?;
        for (index, condition) in map.conditions.iter().enumerate() {
            let places = map.fails.iter().filter(|fails| **fails == Some(index)).count();
            let share = 100.0 * places as f64 / map.fails.len() as f64;
            writeln!(out, "  {share:5.1} % fail {}", inequality(*condition))?;
        }
        writeln!(out, "\nThe other parameters:\n")?;
        let others = (0..asked.parameters.len()).filter(|index| !axes.contains(index));
        for index in others {
            writeln!(out, "  {}", value(&asked.parameters[index], asked.choice.values[index]))?;
        }
        writeln!(out, "\nThe point that is marked:\n")?;
        for axis in axes {
            writeln!(out, "  {}", value(&asked.parameters[axis], asked.choice.values[axis]))?;
        }
        for failing in marked.iter().filter(|condition| !condition.holds()) {
            writeln!(out, "  fails {failing}")?;
        }
        write!(out, "{}", asked.note())?;
        files.tell(out, "-o map.svg to see it")
    })
}

fn inequality(condition: MapCondition) -> String {
    format!("{} {}", condition.name, condition.text)
}

fn picture<'a>(map: &'a FeasibleMap, mark: [f64; 2], length: &str) -> Regions<'a> {
    let label = |axis: &KeyParameter| {
        let unit = if axis.unit == " m" { length } else { axis.unit };
        format!("{} {} ({unit})", axis.name, axis.symbol)
    };
    let inside = (0..2).all(|axis| (map.spans[axis].0..=map.spans[axis].1).contains(&mark[axis]));
    Regions {
        axes: [label(&map.axes[0]), label(&map.axes[1])],
        spans: map.spans,
        places: map.places,
        conditions: map.conditions.iter().map(|condition| inequality(*condition)).collect(),
        fails: &map.fails,
        edges: map.edges.iter().map(|edge| (edge.ends, edge.condition)).collect(),
        mark: inside.then_some(mark),
    }
}

/// A map for other programs.
#[derive(Serialize)]
struct Said {
    x: Axis,
    y: Axis,
    conditions: Vec<String>,
    /// Rows from below: which condition fails, or none.
    fails: Vec<Option<usize>>,
    boundary: Vec<Piece>,
}

#[derive(Serialize)]
struct Axis {
    parameter: &'static str,
    unit: &'static str,
    from: f64,
    to: f64,
    places: usize,
}

#[derive(Serialize)]
struct Piece {
    ends: [[f64; 2]; 2],
    condition: usize,
}

impl Said {
    fn of(map: &FeasibleMap) -> Self {
        let axis = |i: usize| Axis {
            parameter: map.axes[i].name,
            unit: map.axes[i].unit.trim(),
            from: map.spans[i].0,
            to: map.spans[i].1,
            places: map.places[i],
        };
        Self {
            x: axis(0),
            y: axis(1),
            conditions: map.conditions.iter().map(|condition| inequality(*condition)).collect(),
            fails: map.fails.clone(),
            boundary: map.edges.iter().map(|e| Piece { ends: e.ends, condition: e.condition }).collect(),
        }
    }
}
