//! The report on contact in a run, as numbers and in words.

use super::energy::digits;
use serde::Serialize;
use solaris::modes::{ContactReport, Landing, LinkContact};

/// The most links that are named.
const MANY: usize = 3;

/// What the ground did to what dynamics move.
#[derive(Debug, Serialize)]
pub(super) struct Contact {
    /// Along the world's axes.
    pub(super) impulse_n_s: [f64; 3],
    pub(super) damping_j: f64,
    pub(super) friction_j: f64,
    pub(super) links: Vec<Touched>,
    /// What came down on a ground that plants what touches it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) landings: Vec<Landed>,
    #[serde(skip)]
    report: ContactReport,
}

/// How one link touched it.
#[derive(Debug, Serialize)]
pub(super) struct Touched {
    pub(super) link: String,
    pub(super) touching_s: f64,
    pub(super) depth_m: f64,
    pub(super) depth_time_s: f64,
    pub(super) slip_m_s: f64,
    pub(super) slip_time_s: f64,
    /// The force along the ground as a part of that out of it, at most.
    pub(super) friction: f64,
    pub(super) friction_time_s: f64,
    /// How long it took more friction than there is.
    pub(super) slipping_s: f64,
    pub(super) slid_m: f64,
}

/// What came down.
#[derive(Debug, Serialize)]
pub(super) struct Landed {
    pub(super) time_s: f64,
    pub(super) links: Vec<String>,
    pub(super) impulse_n_s: [f64; 3],
    pub(super) loss_j: f64,
}

impl Contact {
    pub(super) fn of(report: ContactReport) -> Self {
        let ContactReport { impulse, damping, friction, links, landings, .. } = report.clone();
        Self {
            impulse_n_s: impulse,
            damping_j: damping,
            friction_j: friction,
            links: links.into_iter().map(Touched::of).collect(),
            landings: landings.into_iter().map(Landed::of).collect(),
            report,
        }
    }

    /// Label, value and note.
    pub(super) fn rows(&self) -> Vec<[String; 3]> {
        let row = |label: &str, value: String, note: String| [label.to_owned(), value, note];
        let report = &self.report;
        let (Some(deepest), Some(fastest), Some(farthest)) =
            (report.deepest(), report.fastest(), report.farthest())
        else {
            return vec![row("touched the ground", "nothing".to_owned(), String::new())];
        };
        let names: Vec<&str> = self.links.iter().take(MANY).map(|link| &*link.link).collect();
        let more = self.links.len().saturating_sub(MANY);
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        let [x, y, z] = self.impulse_n_s.map(|impulse| digits(settled(impulse, self.impulse_n_s)));
        let at = |link: &str, time: f64| format!("{link}, at {time:.3} s");
        let mut rows = vec![
            row("touched the ground", self.links.len().to_string(), format!("{}{more}", names.join(", "))),
            row(
                "deepest",
                format!("{} mm", digits(1e3 * deepest.depth)),
                at(&deepest.link, deepest.depth_time),
            ),
            row(
                "fastest slip",
                format!("{} m/s", digits(fastest.slip)),
                at(&fastest.link, fastest.slip_time),
            ),
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
            rows.push(row(
                "lost in contact",
                format!("{} J", digits(self.damping_j)),
                "to damping".to_owned(),
            ));
            rows.push(row("", format!("{} J", digits(self.friction_j)), "to friction".to_owned()));
        }
        rows
    }
}

/// Zero where it is rounding beside the others.
fn settled(one: f64, all: [f64; 3]) -> f64 {
    let greatest = all.iter().fold(0.0_f64, |most, other| most.max(other.abs()));
    if one.abs() > 1e-9 * greatest { one } else { 0.0 }
}

impl Landed {
    fn of(landing: Landing) -> Self {
        let Landing { time, links, impulse, loss } = landing;
        Self { time_s: time, links, impulse_n_s: impulse, loss_j: loss }
    }
}

impl Touched {
    fn of(contact: LinkContact) -> Self {
        let LinkContact { link, touching, depth, depth_time, slip, slip_time, .. } = contact;
        let LinkContact { friction, friction_time, slipping, slid, .. } = contact;
        Self {
            link,
            touching_s: touching,
            depth_m: depth,
            depth_time_s: depth_time,
            slip_m_s: slip,
            slip_time_s: slip_time,
            friction,
            friction_time_s: friction_time,
            slipping_s: slipping,
            slid_m: slid,
        }
    }
}
