//! Which markers of a figure a trial has.

use solaris_model::{Marker, MarkerTrial};

/// How the markers of a figure and those of a trial go together, by their names.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Matched {
    /// Those that both have: index among the figure's, index in the trial.
    pub pairs: Vec<(usize, usize)>,
    /// The figure's that the trial does not have, by name.
    pub unseen: Vec<String>,
    /// The trial's that the figure does not have, by name.
    pub unknown: Vec<String>,
}

impl Matched {
    /// Finds which markers have the same name; where none is just the same, capitals, spaces and what stands before a colon
    /// (a subject's name, as `Ann:LASI`) do not count.
    pub fn of(markers: &[Marker], trial: &MarkerTrial) -> Self {
        let mut matched = Self::default();
        let mut taken = vec![false; trial.names().len()];
        let plain: Vec<String> = trial.names().iter().map(|name| plain(name)).collect();
        for (i, marker) in markers.iter().enumerate() {
            let exact = trial.marker(&marker.name);
            let found = exact.or_else(|| {
                let wanted = self::plain(&marker.name);
                let mut alike = plain.iter().enumerate().filter(|(_, name)| **name == wanted);
                // Two that look alike are told apart by nobody.
                alike.next().filter(|_| alike.next().is_none()).map(|(j, _)| j)
            });
            match found.filter(|j| !taken[*j]) {
                Some(j) => {
                    taken[j] = true;
                    matched.pairs.push((i, j));
                }
                None => matched.unseen.push(marker.name.clone()),
            }
        }
        let left = trial.names().iter().zip(&taken).filter(|(_, taken)| !**taken);
        matched.unknown = left.map(|(name, _)| name.clone()).collect();
        matched
    }
}

/// A name without what differs between programs.
fn plain(name: &str) -> String {
    let name = name.rsplit(':').next().unwrap_or(name);
    name.chars().filter(|c| !c.is_whitespace()).flat_map(char::to_lowercase).collect()
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used)]
    use super::*;
    use solaris_model::Vector3;

    #[test]
    fn names_match_without_a_subject_s_name() {
        let marker =
            |name: &str| Marker { name: name.into(), link: 0, position: Vector3::zeros(), is_fixed: false };
        let names = ["Ann:LASI", "r asi", "C7", "c7", "extra"].map(str::to_owned).to_vec();
        let trial = MarkerTrial::new(names, vec![], vec![]).unwrap();
        let markers = ["LASI", "R ASI", "C7", "heel"].map(marker);
        let matched = Matched::of(&markers, &trial);
        assert_eq!(matched.pairs, [(0, 0), (1, 1), (2, 2)]);
        assert_eq!(
            (matched.unseen, matched.unknown),
            (vec!["heel".to_owned()], vec!["c7".into(), "extra".into()])
        );
    }
}
