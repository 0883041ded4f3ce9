//! Stances that somebody knows, from a small table: foot, from, to.

use crate::error::CliError;
use crate::input;
use solaris::analysis::ground::{Sole, Stance};
use solaris::model::nearest;
use std::path::Path;

/// The stances of a file, a line for each: the sole's name, from when and until when (s). A heading `foot,from,to` may come first; empty
/// lines and what follows a `#` count for nothing.
pub(super) fn read(path: &Path, soles: &[Sole]) -> Result<Vec<Stance>, CliError> {
    let text = input::text(path)?;
    let fault = |line: usize, why: String| CliError::input(path, &format!("line {line}: {why}"));
    let mut list: Vec<Stance> = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let (number, content) = (index + 1, line.split('#').next().unwrap_or_default());
        let cells: Vec<&str> = content.split([',', ';', '\t']).map(str::trim).collect();
        if cells.iter().all(|cell| cell.is_empty()) || cells == ["foot", "from", "to"] {
            continue;
        }
        let [name, from, to] = cells[..] else {
            let why = format!(
                "it has {} cells; a stance has three: foot, from, to, such as right,0.52,1.18",
                cells.len()
            );
            return Err(fault(number, why));
        };
        let Some(foot) = soles.iter().position(|sole| sole.name == name) else {
            let names: Vec<&str> = soles.iter().map(|sole| &*sole.name).collect();
            let hint = nearest(name, names.iter().copied())
                .map_or_else(String::new, |near| format!("; did you mean '{near}'?"));
            return Err(fault(number, format!("no sole is called '{name}', but {}{hint}", names.join(", "))));
        };
        let time = |text: &str| {
            let time = text.parse::<f64>().ok().filter(|time| time.is_finite());
            time.ok_or_else(|| fault(number, format!("'{text}' is no time in s")))
        };
        let (start, end) = (time(from)?, time(to)?);
        if start >= end {
            return Err(fault(
                number,
                format!("the stance begins at {from} s and ends at {to} s; it must last"),
            ));
        }
        if let Some(other) =
            list.iter().find(|other| other.foot == foot && other.start < end && start < other.end)
        {
            let (from, to) = (other.start, other.end);
            return Err(fault(
                number,
                format!("{name} stands already from {from} to {to} s; let each stance stand once"),
            ));
        }
        list.push(Stance { foot, start, end });
    }
    if list.is_empty() {
        return Err(CliError::input(
            path,
            &"it has no stance; a line for each says foot, from, to, such as right,0.52,1.18",
        ));
    }
    list.sort_by(|a, b| a.foot.cmp(&b.foot).then(a.start.total_cmp(&b.start)));
    Ok(list)
}
