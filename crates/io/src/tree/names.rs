//! Names that are not taken yet.

use std::collections::HashMap;

/// The names that are in use.
#[derive(Default)]
pub(crate) struct Names {
    /// Each with the number to try next.
    taken: HashMap<String, usize>,
}

impl Names {
    /// These names.
    pub(crate) fn of<'a>(names: impl Iterator<Item = &'a str>) -> Self {
        Self { taken: names.map(|name| (name.to_owned(), 2)).collect() }
    }

    /// Takes `wanted`, or the first of `wanted_2`, `wanted_3` … that is free.
    pub(crate) fn take(&mut self, wanted: &str) -> String {
        let Some(mut number) = self.taken.get(wanted).copied() else {
            self.taken.insert(wanted.to_owned(), 2);
            return wanted.to_owned();
        };
        let mut name = format!("{wanted}_{number}");
        while self.taken.contains_key(&name) {
            number += 1;
            name = format!("{wanted}_{number}");
        }
        self.taken.insert(wanted.to_owned(), number + 1);
        self.taken.insert(name.clone(), 2);
        name
    }
}

#[cfg(test)]
mod tests {
    use super::Names;

    #[test]
    fn a_name_that_is_taken_gets_the_next_number() {
        let mut names = Names::of(["world", "world_2"].into_iter());
        assert_eq!(names.take("world"), "world_3");
        assert_eq!(names.take("world"), "world_4");
        assert_eq!(names.take("root"), "root");
        assert_eq!(names.take("root"), "root_2");
    }
}
