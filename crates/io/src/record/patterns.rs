//! What columns of measured forces are called in files for OpenSim.

use crate::table::Table;
use std::collections::HashSet;

/// How the nine columns of a force are called: `{}` stands for its name, and the axis (`x`, `y`, `z`) comes last.
pub(super) struct Pattern {
    force: &'static str,
    point: &'static str,
    /// The torque about the point, as the first of these that is there.
    torques: &'static [&'static str],
    /// Whether a column of points must be there for a column of forces to be one.
    needs_point: bool,
}

/// All of them, the most telling first.
pub(super) const PATTERNS: [Pattern; 5] = [
    // OpenSim's examples: ground_force_vx, 1_ground_force_vx, l_ground_force_vx, R_ground_force_vx.
    Pattern {
        force: "{}ground_force_v",
        point: "{}ground_force_p",
        torques: &["{}ground_torque_", "{}ground_moment_", "{}ground_moment_m"],
        needs_point: false,
    },
    // Rajagopal's model, Moco: ground_force_r_vx, ground_torque_r_x; others have ground_force_1_mx or ground_moment_1_mx.
    Pattern {
        force: "ground_force_{}_v",
        point: "ground_force_{}_p",
        torques: &[
            "ground_torque_{}_",
            "ground_force_{}_m",
            "ground_moment_{}_m",
            "ground_moment_{}_",
            "ground_torque_{}_m",
        ],
        needs_point: false,
    },
    // ground_force1_vx, ground_torque1_x.
    Pattern {
        force: "ground_force{}_v",
        point: "ground_force{}_p",
        torques: &["ground_torque{}_", "ground_moment{}_", "ground_moment{}_m", "ground_force{}_m"],
        needs_point: false,
    },
    // OpenSim's tutorials: right_foot_force_vx, right_foot_torque_x.
    Pattern {
        force: "{}_force_v",
        point: "{}_force_p",
        torques: &["{}_torque_", "{}_moment_", "{}_force_m"],
        needs_point: true,
    },
    // OpenSim's tests: head_vx, head_px.
    Pattern {
        force: "{}_v",
        point: "{}_p",
        torques: &["{}_torque_", "{}_moment_", "{}_m"],
        needs_point: true,
    },
];

impl Pattern {
    /// Headings of force, point and torque of the force `name`, where its forces are in the table.
    pub(super) fn columns(&self, table: &Table, name: &str) -> Option<[String; 9]> {
        let heading = |pattern: &str, axis: char| pattern.replace("{}", name) + &axis.to_string();
        let is_there = |pattern: &str| table.column(&heading(pattern, 'x')).is_some();
        if !is_there(self.force) || (self.needs_point && !is_there(self.point)) {
            return None;
        }
        let torque = self.torques.iter().find(|torque| is_there(torque)).unwrap_or(&self.torques[0]);
        let all = [self.force, self.point, torque];
        Some(std::array::from_fn(|i| heading(all[i / 3], ['x', 'y', 'z'][i % 3])))
    }

    /// The name of the force whose first column this heading is, in a table of all `headings`.
    fn name<'a>(&self, headings: &HashSet<&str>, heading: &'a str) -> Option<&'a str> {
        let (before, after) = self.force.split_once("{}")?;
        let name = heading.strip_suffix('x')?.strip_suffix(after)?.strip_prefix(before)?;
        // A name between two words is one; before them it may be empty.
        let is_named = !name.is_empty() || before.is_empty() && !after.starts_with('_');
        let point = || self.point.replace("{}", name) + "x";
        (is_named && (!self.needs_point || headings.contains(&*point()))).then_some(name)
    }
}

/// The headings of the force that is asked for as `name`: what stands for it in one of the patterns, with or without the
/// underscore after it.
pub(super) fn find(table: &Table, name: &str) -> Option<[String; 9]> {
    let bare = name.trim_end_matches('_');
    let names = [name.to_owned(), format!("{bare}_"), bare.to_owned()];
    PATTERNS.iter().find_map(|pattern| names.iter().find_map(|name| pattern.columns(table, name)))
}

/// The name of the force whose first column this heading is, in a table of all `headings`.
pub(super) fn name_of<'a>(headings: &HashSet<&str>, heading: &'a str) -> Option<&'a str> {
    PATTERNS.iter().find_map(|pattern| pattern.name(headings, heading))
}
