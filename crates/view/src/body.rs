//! The skin of a person, as a page holds it.

use crate::PagePerson;
use crate::pack::{Packed, bytes, floats, ranged, words};
use serde::Serialize;
use solaris_model::Figure;
use solaris_skin::{Detail, Influence, PALETTE, parts, person};

/// The most people who have skins, and the most who have fine ones.
const MOST: usize = 12;
const FEW: usize = 2;

/// A skin that goes with the links.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Body {
    /// m, three a vertex.
    points: Packed,
    /// Place in the palette, in steps of 1/255, one a vertex.
    colours: Packed,
    /// Four links a vertex, and their shares in steps of 1/255, 255 together.
    links: Packed,
    shares: Packed,
    /// Three vertices a triangle.
    triangles: Packed,
    /// Where the links are when vertices are at their points: m, three a link; quaternions, four a link.
    places: Packed,
    turns: Packed,
    /// Red, green and blue of the palette's colours, from 0 to 255.
    palette: Vec<[u8; 3]>,
}

impl Body {
    /// As it stands in the page.
    pub(crate) fn to_json(&self) -> String {
        serde_json::to_string(self).expect("plain data of finite numbers and text is always JSON")
    }
}

/// The skin of one of several people.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct OneBody {
    /// The first of that person's links.
    first: usize,
    #[serde(flatten)]
    body: Body,
}

/// The skins of several people; of more than [`MOST`] none, for a page has to be loaded.
pub(crate) fn bodies(people: &[PagePerson]) -> Vec<OneBody> {
    // What else is there has no parts of a body, and counts for nothing.
    let people: Vec<&PagePerson> = people.iter().filter(|one| !parts(&one.figure).is_empty()).collect();
    if people.len() > MOST {
        return Vec::new();
    }
    let detail = if people.len() > FEW { Detail::Rough } else { Detail::Coarse };
    people
        .into_iter()
        .filter_map(|one| Some(OneBody { first: one.first, body: with_detail(&one.figure, detail)? }))
        .collect()
}

/// The skin of a person of our making; none of anything else.
pub(crate) fn body(figure: &Figure) -> Option<Body> {
    with_detail(figure, Detail::Coarse)
}

fn with_detail(figure: &Figure, detail: Detail) -> Option<Body> {
    let skin = person(figure, detail)?;
    // What numbers of 16 and of 8 bits can name.
    if skin.points.len() > 65_535 || figure.links().len() > 256 {
        return None;
    }
    let points: Vec<f64> = skin.points.iter().flat_map(|p| [p.x, p.y, p.z]).collect();
    Some(Body {
        points: ranged(&points),
        colours: bytes(skin.colours.iter().map(|place| (place * 255.0).round() as u8)),
        links: bytes(skin.influences.iter().flatten().map(|i| i.link as u8)),
        shares: bytes(skin.influences.iter().flat_map(shares)),
        triangles: words(skin.triangles.iter().flatten().map(|i| *i as u16)),
        places: floats(
            skin.bind.iter().flat_map(|place| place.translation.vector.iter().copied().collect::<Vec<_>>()),
        ),
        turns: floats(
            skin.bind.iter().flat_map(|place| place.rotation.coords.iter().copied().collect::<Vec<_>>()),
        ),
        palette: PALETTE.to_vec(),
    })
}

/// Shares in steps that are 255 together: the greatest takes what rounding leaves.
fn shares(influences: &[Influence; 4]) -> [u8; 4] {
    let mut steps = influences.map(|i| (i.share * 255.0).round() as u8);
    let others: u16 = steps[1..].iter().map(|x| u16::from(*x)).sum();
    steps[0] = (255 - others) as u8;
    steps
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris_model::{FigureBuilder, Joint, LinkSpec, human};

    #[test]
    fn a_person_has_one_of_some_quarter_of_a_megabyte_and_a_pendulum_none() {
        let man = body(&human(1.75, 73.0).expect("a person")).expect("a body");
        let size = serde_json::to_string(&man).expect("JSON").len();
        assert!((150_000..350_000).contains(&size), "{size} bytes");
        let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(1.0);
        assert!(body(&FigureBuilder::new("pendulum").link(bob).build().expect("a figure")).is_none());
    }

    #[test]
    fn each_of_several_has_one_unless_there_are_many() {
        let of = |first| PagePerson { first, figure: human(1.75, 73.0).expect("a person") };
        let two = bodies(&[of(1), of(22)]);
        assert_eq!(two.iter().map(|one| one.first).collect::<Vec<_>>(), [1, 22]);
        assert_eq!(two[0].body, body(&of(1).figure).expect("a body"));
        assert_eq!(bodies(&vec![of(1); MOST]).len(), MOST);
        assert!(bodies(&vec![of(1); MOST + 1]).is_empty());
        // One among many boxes is one person, as fine as alone.
        let link = LinkSpec::root("box", Joint::free("flight")).mass(1.0);
        let figure = FigureBuilder::new("box").link(link).build().expect("a figure");
        let boxes = (0..2 * MOST).map(|i| PagePerson { first: 22 + i, figure: figure.clone() });
        let among: Vec<PagePerson> = std::iter::once(of(1)).chain(boxes).collect();
        assert_eq!(bodies(&among), bodies(&[of(1)]));
        assert_eq!(bodies(&among).len(), 1);
    }

    #[test]
    fn shares_are_the_whole_to_the_last_step() {
        for parts in [[1.0, 0.0, 0.0, 0.0], [0.25; 4], [0.4, 0.3, 0.2, 0.1], [0.334, 0.333, 0.333, 0.0]] {
            let steps = shares(&parts.map(|share| Influence { link: 0, share }));
            assert_eq!(steps.iter().map(|x| u16::from(*x)).sum::<u16>(), 255, "{parts:?}");
        }
    }
}
