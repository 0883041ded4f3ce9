//! How a figure differs from the one whose body is drawn.

use super::SIDES;
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};
use solaris_model::{Figure, Link, SolePart, human};

/// How far arms and legs are from the body in the pose in which a skin is made (rad): between hanging and raised, and so that
/// thighs of usual girth are apart.
const ARM: f64 = 0.60;
const LEG: f64 = 0.09;
/// The most that legs of greater girth are.
const WIDEST: f64 = 0.40;
/// The most that a neck is thicker than chest and head are larger.
const NECK: f64 = 1.1;

pub(super) struct Sizes<'a> {
    figure: &'a Figure,
    reference: Figure,
    /// Where the links are in the pose in which the skin is made.
    pub(super) bind: Vec<Isometry3<f64>>,
    /// From soles to vertex (m), and over that of the reference.
    pub(super) stature: f64,
    pub(super) tall: f64,
}

impl<'a> Sizes<'a> {
    /// None of a figure that lacks a link of a person's.
    pub(super) fn of(figure: &'a Figure) -> Option<Self> {
        let reference = human(1.741, 73.0).ok()?;
        let parent =
            |figure: &Figure, link: &Link| link.parent().map(|p| figure.links()[p].name().to_owned());
        let same = |link: &Link| {
            let own = figure.link(link.name())?;
            (parent(figure, own) == parent(&reference, link) && is_straight(own)).then_some(())
        };
        if reference.links().iter().any(|link| same(link).is_none()) {
            return None;
        }
        let (stature, standard) = (stature(figure)?, stature(&reference)?);
        let mut sizes = Self { figure, reference, bind: Vec::new(), stature, tall: stature / standard };
        sizes.bind = sizes.pose();
        Some(sizes)
    }

    fn pose(&self) -> Vec<Isometry3<f64>> {
        let hip =
            self.figure.link("left_thigh").map_or(0.085, |link| link.joint().placement().translation.x.abs());
        // The inside of the thigh a third of the way down, and a finger's breadth.
        let inside = 0.088 * self.thick("left_thigh").0 + 0.004;
        let leg = LEG.max(((inside - hip) / (0.3 * self.length("left_thigh"))).min(1.0).asin()).min(WIDEST);
        let mut places: Vec<Isometry3<f64>> = Vec::new();
        for link in self.figure.links() {
            let side = SIDES.iter().find(|side| link.name().starts_with(side.prefix));
            let angle = match side.map(|side| (side.out, &link.name()[side.prefix.len()..])) {
                Some((out, "upper_arm")) => out * ARM,
                Some((out, "thigh")) => out * leg,
                Some((out, "foot")) => -out * leg,
                _ => 0.0,
            };
            let turn = UnitQuaternion::from_scaled_axis(Vector3::z() * angle);
            let own = link.joint().placement() * Isometry3::from_parts(Translation3::identity(), turn);
            places.push(link.parent().map_or_else(Isometry3::identity, |parent| places[parent] * own));
        }
        places
    }

    /// The links that are none of a person's, such as a cane.
    pub(super) fn others(&self) -> impl Iterator<Item = (u16, &Link)> {
        let links = (0_u16..).zip(self.figure.links());
        links.filter(|(_, link)| self.reference.link(link.name()).is_none())
    }

    pub(super) fn index(&self, link: &str) -> usize {
        self.figure.link_index(link).unwrap_or(0)
    }

    pub(super) fn parent(&self, link: &str) -> usize {
        self.figure.link(link).and_then(Link::parent).unwrap_or(0)
    }

    /// Where a link is in the pose in which the skin is made.
    pub(super) fn place(&self, link: &str) -> Isometry3<f64> {
        self.bind[self.index(link)]
    }

    /// Where its joint is there (m).
    pub(super) fn joint(&self, link: &str) -> Vector3<f64> {
        self.place(link).translation.vector
    }

    /// Breadth and depth of a link's shape over the reference's; as tall as the figure is where it has no shape.
    pub(super) fn thick(&self, link: &str) -> (f64, f64) {
        let (breadth, depth) = self.shape(link);
        if link != "neck" {
            return (breadth, depth);
        }
        // What is known of children's heads has the neck in it, whose share is not known: it is between chest and head.
        let most = NECK * (self.shape("thorax").0 + self.head().x) / 2.0;
        (breadth.min(most), depth.min(most))
    }

    fn shape(&self, link: &str) -> (f64, f64) {
        let reach =
            |figure: &Figure, along: Vector3<f64>| Some(figure.link(link)?.shape()?.kind.reach(&along));
        let ratio = |along| Some(reach(self.figure, along)? / reach(&self.reference, along)?);
        (ratio(Vector3::x()).unwrap_or(self.tall), ratio(Vector3::z()).unwrap_or(self.tall))
    }

    /// Length of a link over the reference's.
    pub(super) fn long(&self, link: &str) -> f64 {
        self.length(link) / length(&self.reference, link)
    }

    /// The head's size over the reference's: heads differ less in breadth and depth than in height (children's of 6 years are 0.92 as broad as adults',
    /// 0.85 as high: Snyder et al. 1977).
    pub(super) fn head(&self) -> Vector3<f64> {
        let long = self.long("head");
        Vector3::new(long.sqrt(), long, long.sqrt())
    }

    /// Length of a link (m).
    pub(super) fn length(&self, link: &str) -> f64 {
        length(self.figure, link)
    }

    /// The height of the sole under a foot's or the toes' joint (m): negative.
    pub(super) fn sole(&self, link: &str) -> f64 {
        let own = |figure: &Figure| Some(figure.link(link)?.sole_point(SolePart::Ball)?.y);
        own(self.figure).unwrap_or_else(|| own(&self.reference).unwrap_or(-0.078) * self.tall)
    }

    /// A height in the trunk of the reference (m, from the pelvis' origin) in this figure's.
    pub(super) fn height(&self, y: f64) -> f64 {
        let links = ["left_thigh", "pelvis", "abdomen", "thorax", "neck", "head"];
        let marks: Vec<[f64; 2]> =
            links.iter().map(|link| [origin(&self.reference, link).y, self.joint(link).y]).collect();
        let above = marks.partition_point(|mark| mark[0] < y);
        match above {
            0 => marks[0][1] + (y - marks[0][0]) * self.tall,
            i if i == marks.len() => marks[i - 1][1] + (y - marks[i - 1][0]) * self.long("head"),
            i => {
                let ([a, b], [c, d]) = (marks[i - 1], marks[i]);
                b + (y - a) / (c - a) * (d - b)
            }
        }
    }
}

/// Whether a joint's frame is not turned.
fn is_straight(link: &Link) -> bool {
    link.joint().placement().rotation.angle() < 1e-9
}

/// Where a link's joint is in the zero posture, from the root's (m).
fn origin(figure: &Figure, link: &str) -> Vector3<f64> {
    let mut at = Vector3::zeros();
    let mut index = figure.link_index(link);
    while let Some(i) = index {
        let link = &figure.links()[i];
        if link.parent().is_some() {
            at += link.joint().placement().translation.vector;
        }
        index = link.parent();
    }
    at
}

/// From the soles to the vertex in the zero posture (m).
fn stature(figure: &Figure) -> Option<f64> {
    let top = origin(figure, "head").y + figure.link("head")?.tip().map_or(0.177, |tip| tip.y);
    let ankle = origin(figure, "left_foot").y;
    let sole = figure.link("left_foot")?.sole_point(SolePart::Heel).map_or(-0.078, |heel| heel.y);
    Some(top - ankle - sole).filter(|stature| *stature > 0.0)
}

/// From a link's joint to the next one's, or to its tip (m).
fn length(figure: &Figure, link: &str) -> f64 {
    let next = match link.trim_start_matches("left_").trim_start_matches("right_") {
        "thigh" => "shank",
        "shank" => "foot",
        "foot" => "toes",
        "upper_arm" => "forearm",
        "forearm" => "hand",
        _ => "",
    };
    let side = link.split_inclusive('_').next().unwrap_or_default();
    let joint =
        figure.link(&format!("{side}{next}")).map(|next| next.joint().placement().translation.vector.norm());
    let tip = || figure.link(link).and_then(|link| link.tip().map(Vector3::norm));
    joint.or_else(tip).filter(|length| *length > 0.0).unwrap_or(1.0)
}
