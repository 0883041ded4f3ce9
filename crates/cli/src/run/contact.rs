//! The report on contact in a run, in words.

use super::energy::digits;
use solaris::modes::{ContactReport, LinkCollision, LinkContact, LoopReport};

/// The most links that are named.
const MANY: usize = 3;

/// Label, value and note.
pub(super) fn rows(report: &ContactReport) -> Vec<[String; 3]> {
    let row = |label: &str, value: String, note: String| [label.to_owned(), value, note];
    let (Some(deepest), Some(fastest), Some(farthest)) =
        (report.deepest(), report.fastest(), report.farthest())
    else {
        return vec![row("touched the ground", "nothing".to_owned(), String::new())];
    };
    let names: Vec<&str> = report.links.iter().take(MANY).map(|link| &*link.link).collect();
    let more = report.links.len().saturating_sub(MANY);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    let [x, y, z] = report.impulse.map(|impulse| digits(settled(impulse, report.impulse)));
    let at = |link: &str, time: f64| format!("{link}, at {time:.3} s");
    let mut rows = vec![
        row("touched the ground", report.links.len().to_string(), format!("{}{more}", names.join(", "))),
        row("deepest", format!("{} mm", digits(1e3 * deepest.depth)), at(&deepest.link, deepest.depth_time)),
        row("fastest slip", format!("{} m/s", digits(fastest.slip)), at(&fastest.link, fastest.slip_time)),
        row("slid farthest", format!("{} m", digits(farthest.slid)), farthest.link.clone()),
        row("impulse of the ground", format!("({x}, {y}, {z}) N s"), String::new()),
    ];
    if let Some(roughest) = report.roughest().filter(|_| report.planted) {
        let LinkContact { link, friction, friction_time, slipping, .. } = roughest;
        let more = if *slipping > 0.0 {
            format!("; for {} s more than there is: it ought to slip", digits(*slipping))
        } else {
            String::new()
        };
        rows.push(row(
            "friction that it took",
            digits(*friction),
            format!("{}{more}", at(link, *friction_time)),
        ));
        rows.extend(report.landings.first().map(|first| {
            let times = report.landings.len();
            let value = if times == 1 { "once".to_owned() } else { format!("{times} times") };
            row("came down", value, at(&first.links.join(", "), first.time))
        }));
    } else {
        rows.push(row("lost in contact", format!("{} J", digits(report.damping)), "to damping".to_owned()));
        rows.push(row("", format!("{} J", digits(report.friction)), "to friction".to_owned()));
    }
    rows
}

/// The rows of links that touched each other, none where none did.
pub(super) fn collisions(pairs: &[LinkCollision]) -> Vec<[String; 3]> {
    let greatest = |of: fn(&LinkCollision) -> f64| pairs.iter().max_by(|a, b| of(a).total_cmp(&of(b)));
    let (Some(deepest), Some(hardest)) = (greatest(|pair| pair.depth), greatest(|pair| pair.force)) else {
        return Vec::new();
    };
    let row = |label: &str, value: String, note: String| [label.to_owned(), value, note];
    let name = |pair: &LinkCollision| pair.links.join(" and ");
    let names: Vec<String> = pairs.iter().take(MANY).map(name).collect();
    let more = pairs.len().saturating_sub(MANY);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    let at = |pair: &LinkCollision, time: f64| format!("{}, at {time:.3} s", name(pair));
    vec![
        row("links touched each other", pairs.len().to_string(), format!("{}{more}", names.join(", "))),
        row("hardest", format!("{} N", digits(hardest.force)), at(hardest, hardest.force_time)),
        row("deepest in each other", format!("{} mm", digits(1e3 * deepest.depth)), at(deepest, deepest.depth_time)),
    ]
}

/// The rows of closed loops, none where there are none.
pub(super) fn loops(all: &[LoopReport]) -> Vec<[String; 3]> {
    let greatest = |of: fn(&LoopReport) -> f64| all.iter().max_by(|a, b| of(a).total_cmp(&of(b)));
    let (Some(loosest), Some(hardest)) = (greatest(|one| one.apart), greatest(|one| one.force)) else {
        return Vec::new();
    };
    let row = |label: &str, value: String, one: &LoopReport, time: f64| {
        [label.to_owned(), value, format!("{}, at {time:.3} s", one.links.join(" and "))]
    };
    vec![
        row("loops come apart by", format!("{} mm", digits(1e3 * loosest.apart)), loosest, loosest.apart_time),
        row("and take at most", format!("{} N", digits(hardest.force)), hardest, hardest.force_time),
    ]
}

/// Zero where it is rounding beside the others.
fn settled(one: f64, all: [f64; 3]) -> f64 {
    let greatest = all.iter().fold(0.0_f64, |most, other| most.max(other.abs()));
    if one.abs() > 1e-9 * greatest { one } else { 0.0 }
}
