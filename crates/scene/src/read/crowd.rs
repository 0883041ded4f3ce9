//! A crowd: people by chance, in rows.

use super::SceneReader;
use solaris_gait::crowd::{Somebody, seed_of};
use solaris_model::text::{Fields, Node};
use solaris_model::{Figure, Human, Placement};

/// The most people of one crowd.
const MOST: f64 = 200.0;

const FIELDS: [&str; 6] = ["count", "seed", "age", "joints", "columns", "apart"];

impl SceneReader<'_> {
    /// `Crowd(count: 12, seed: 7, columns: 4, apart: 0.9, age: 30, joints: Limp)`: each person, and where in the crowd; the first one in front and
    /// on the right, the rows behind each other.
    pub(super) fn crowd(&mut self, node: &Node<'_>) -> Option<Vec<(Figure, Placement)>> {
        let before = self.reader.count();
        let fields = self.reader.fields(node, &["Crowd"], &FIELDS)?;
        self.reader.required(&fields, "count", "12");
        let count = self.whole(&fields, "count", 1.0, 1.0, MOST);
        let seed = self.whole(&fields, "seed", 0.0, 0.0, 2f64.powi(53));
        let across = count.map_or(1.0, |count| count.sqrt().ceil());
        let columns = self.whole(&fields, "columns", across, 1.0, MOST);
        let apart = fields
            .get("apart")
            .map_or(Some(0.9), |node| self.reader.positive(node, "the distance apart", "m"));
        let age = fields.get("age").map(|node| (node, self.reader.number(node, "the age")));
        let joints = self.reader.choice(&fields, "joints", &["Angles", "Limp"]);
        if self.reader.count() > before {
            return None;
        }
        let (count, seed, columns, apart) = (count? as u64, seed? as u64, columns? as u64, apart?);
        let age = age.and_then(|(_, age)| age);
        let mut people = Vec::new();
        for index in 0..count {
            let somebody = Somebody::drawn(seed_of(seed, index), age);
            let human = Human::new(somebody.height, somebody.mass);
            let human = if let Some(age) = age.filter(|age| *age < 18.0) { human.age(age) } else { human };
            let human = if joints? == "Limp" { human.limp() } else { human };
            let figure = human.build().map_err(|error| {
                let place = fields.get("age").map_or(node.place(), |node| node.span.clone());
                self.reader.fault(place, error.to_string());
            });
            let (row, column) = (index / columns, index % columns);
            let x = apart * (column as f64 - 0.5 * (columns.min(count) - 1) as f64);
            people.push((figure.ok()?, Placement::translation(x, 0.0, -apart * row as f64)));
        }
        Some(people)
    }

    /// A whole number within bounds.
    pub(super) fn whole(
        &mut self,
        fields: &Fields<'_, '_>,
        name: &str,
        without: f64,
        least: f64,
        most: f64,
    ) -> Option<f64> {
        let Some(node) = fields.get(name) else { return Some(without) };
        let number = self.reader.number(node, name)?;
        if number.fract() == 0.0 && (least..=most).contains(&number) {
            return Some(number);
        }
        let message = format!("{name} is {number}; it must be a whole number, {least} to {most}");
        self.reader.fault(node.span.clone(), message);
        None
    }
}
