//! Film strips: a motion as twelve still pictures, each with the ground that the figure is on.

mod ground;
mod outline;

use crate::camera::Bounds;
use crate::chart::{LETTERS, MARGIN, Picture, Point, WIDTH};
use crate::data::check_contacts;
use crate::draw::{self, Drawn, Side};
use crate::error::ViewError;
use crate::frames::Frames;
use crate::skin::{self, Skin};
use crate::world::World;
use glam::{DMat3, DQuat, DVec3};
use ground::Ground;
use outline::Solid;
use solaris_model::{Figure, Motion};

/// What a film strip shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FilmOptions {
    /// What stands above it, plain text.
    pub title: String,
    /// From when to when (s); the whole motion where nothing is said.
    pub between: Option<(f64, f64)>,
    /// From where it is seen.
    pub seen: Seen,
}

/// From where a figure is seen, in parallel light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Seen {
    /// From its right, at a right angle to the way forward; all figures of a row over one height.
    #[default]
    Side,
    /// From the right, in front and above.
    Corner,
    /// From above, the way forward to the right.
    Above,
}

/// Pictures in a row, and rows.
const COLUMNS: usize = 6;
const ROWS: usize = 2;
/// The greatest height of a row (px).
const TALLEST: f64 = 330.0;
/// What is free at both sides of a figure, between pictures, and below the lowest ground (px).
const BESIDE: f64 = 4.0;
const BETWEEN: f64 = 3.0;
const BELOW: f64 = 20.0;
/// Height of a line of text (px).
const LINE: f64 = 17.0;
/// What is said of dots, where there are any.
const DOTS: &str = " A dot: the ground bears the foot there.";
/// A foot bears where its force is more than this share of the weight.
const LEAST: f64 = 0.01;

/// A part that is drawn, at one instant: how far it is towards the viewer (m), its class, and where it is.
type Shape = (f64, &'static str, Solid);

/// One instant, as the viewer's eye has it: x to the right, y up, z towards the eye (m).
struct Still {
    time: f64,
    shapes: Vec<Shape>,
    bounds: Bounds,
    /// Where the ground bears which side.
    borne: Vec<(Side, DVec3)>,
}

/// Where the stills of a strip go.
struct Sheet {
    /// Pixels a metre.
    scale: f64,
    /// From the page's world to the eye's.
    eye: DQuat,
    seen: Seen,
}

/// How a still comes onto the sheet.
struct Lens {
    scale: f64,
    /// What of the eye's plane (m) comes to `place` (px).
    from: Point,
    place: Point,
}

impl Lens {
    fn point(&self, at: DVec3) -> Point {
        let along = |from: f64, at: f64| (at - from) * self.scale;
        (self.place.0 + along(self.from.0, at.x), self.place.1 - along(self.from.1, at.y))
    }
}

/// The film strip of a motion, as an SVG: twelve instants, equally far apart, or one where it begins and ends at the same instant, the figure in the shapes of its links, the left in blue, the
/// right in orange, with the ground at its true height, a mark each metre of the way, and a dot where the ground bears a foot.
///
/// Every picture goes along with the figure. The same motion gives the same text, byte for byte.
///
/// # Errors
///
/// [`ViewError`]: as [`crate::page`], and a span that is none or not within the motion.
pub fn film(figure: &Figure, motion: &Motion, options: &FilmOptions) -> Result<String, ViewError> {
    motion.check_figure(figure)?;
    check_contacts(figure, motion)?;
    let samples = instants(figure, motion, options.between)?;
    let world = World::new(&motion.info.gravity, None);
    let eye = options.seen.eye();
    let mut stills = stills(figure, motion, &samples, &world, eye)?;
    let ground = Ground::of(motion, &world);
    if ground.is_none() {
        // Forces are then of links on each other, where they touch or are held together.
        for still in &mut stills {
            still.borne.clear();
        }
    }
    let cell = (WIDTH - 2.0 * MARGIN) / COLUMNS.min(stills.len()) as f64;
    let most =
        |edge: fn(DVec3) -> f64| stills.iter().map(|still| edge(still.bounds.edges())).fold(1e-6, f64::max);
    let free = cell - BETWEEN - 2.0 * BESIDE;
    let mut scale = (free / most(|edges| edges.x)).min(TALLEST / most(|edges| edges.y));
    let mut picture = Picture::new(&options.title);
    let dots = if stills.iter().all(|still| still.borne.is_empty()) { "" } else { DOTS };
    picture.remark(&format!("Blue: left. Orange: right.{dots}"), 1);
    for row in stills.chunks(COLUMNS) {
        let (low, high) = options.seen.heights(row);
        scale = scale.min(TALLEST / (high - low));
    }
    let sheet = Sheet { scale, eye, seen: options.seen };
    for row in stills.chunks(COLUMNS) {
        sheet.row(&mut picture, row, ground.as_ref(), cell);
    }
    Ok(picture.finish())
}

/// The samples that are nearest to instants that are equally far apart.
fn instants(figure: &Figure, motion: &Motion, between: Option<(f64, f64)>) -> Result<Vec<usize>, ViewError> {
    let time = motion.time();
    let (Some(&first), Some(&last)) = (time.first(), time.last()) else {
        return Err(ViewError::Empty { figure: figure.name().to_owned() });
    };
    let (from, to) = between.unwrap_or((first, last));
    let slack = 0.5 / motion.info.rate;
    if !(from <= to && from >= first - slack && to <= last + slack) {
        return Err(ViewError::Span { from, to, first, last });
    }
    // Of an instant there is one picture.
    let count = if to - from < slack { 1 } else { COLUMNS * ROWS };
    let nearest = |i: usize| {
        let at = from + (to - from) * i as f64 / (count - 1).max(1) as f64;
        let after = time.partition_point(|time| *time < at).min(time.len() - 1);
        let before = after.saturating_sub(1);
        if at - time[before] < time[after] - at { before } else { after }
    };
    Ok((0..count).map(nearest).collect())
}

fn stills(
    figure: &Figure,
    motion: &Motion,
    samples: &[usize],
    world: &World,
    eye: DQuat,
) -> Result<Vec<Still>, ViewError> {
    let links = draw::links(figure);
    let skins = skin::skins(figure);
    let frames = Frames::new(figure, motion, samples, world, &links)?;
    let least = LEAST * figure.mass() * motion.info.gravity.norm();
    let still = |(frame, &sample): (usize, &usize)| {
        let poses = |link: usize| {
            let at = frame * links.len() + link;
            (eye * (frames.root[frame] + frames.positions[at]), (eye * frames.turns[at]).normalize())
        };
        let borne = motion.contacts.iter().filter(|track| track.samples[sample].force.norm() > least);
        Still {
            time: motion.time()[sample],
            shapes: shapes(&links, &skins, &poses),
            bounds: bounds(&links, &poses),
            borne: borne
                .map(|track| (Side::split(&track.link).0, eye * world.vector(&track.samples[sample].cop)))
                .collect(),
        }
    };
    Ok(samples.iter().enumerate().map(still).collect())
}

/// All that is drawn of the figure, what is farther away first.
fn shapes(links: &[Drawn], skins: &[Skin], poses: &dyn Fn(usize) -> (DVec3, DQuat)) -> Vec<Shape> {
    let solid = |link: usize, part: usize| {
        let (place, turn) = poses(link);
        Solid::of(&links[link].parts[part], place, turn)
    };
    let mut shapes: Vec<Shape> = Vec::new();
    for (i, link) in links.iter().enumerate() {
        for part in 0..link.parts.len() {
            let solid = solid(i, part);
            shapes.push((solid.depth(), class(link.side), solid));
        }
    }
    for skin in skins {
        let skin_of = Solid::between(&solid(skin.parent, 0), &solid(skin.child, 0));
        shapes.extend(skin_of.map(|solid| (solid.depth(), class(links[skin.child].side), solid)));
    }
    shapes.sort_by(|a, b| a.0.total_cmp(&b.0));
    shapes
}

fn bounds(links: &[Drawn], poses: &dyn Fn(usize) -> (DVec3, DQuat)) -> Bounds {
    let of_link = |(i, link): (usize, &Drawn)| {
        let (place, turn) = poses(i);
        link.bounds(place, turn)
    };
    let nothing = || Bounds { low: poses(0).0, high: poses(0).0 };
    links.iter().enumerate().filter_map(of_link).reduce(Bounds::union).unwrap_or_else(nothing)
}

fn class(side: Side) -> &'static str {
    match side {
        Side::Left => "left",
        Side::Right => "right",
        Side::Middle => "trunk",
    }
}

impl Seen {
    /// From the page's world (x left, y up, z forward) to the eye's (x right, y up, z towards it).
    fn eye(self) -> DQuat {
        let (azimuth, elevation) = match self {
            Self::Side => (0.0, 0.0),
            Self::Corner => (40_f64.to_radians(), 25_f64.to_radians()),
            Self::Above => (0.0, std::f64::consts::FRAC_PI_2),
        };
        let (out, rise) = (f64::cos(elevation), f64::sin(elevation));
        let towards = DVec3::new(-out * f64::cos(azimuth), rise, out * f64::sin(azimuth));
        let right = DVec3::new(f64::sin(azimuth), 0.0, f64::cos(azimuth));
        DQuat::from_mat3(&DMat3::from_cols(right, towards.cross(right), towards).transpose())
    }

    /// What comes to a row's lower edge of a still, and its highest point above that (m): heights are kept from the side only.
    fn foot(self, still: &Still) -> f64 {
        if self == Self::Side { 0.0 } else { still.bounds.low.y }
    }

    fn heights(self, row: &[Still]) -> (f64, f64) {
        row.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), still| {
            let foot = self.foot(still);
            (low.min(still.bounds.low.y - foot), high.max(still.bounds.high.y - foot))
        })
    }
}

impl Sheet {
    /// A row of stills with their times above.
    fn row(&self, picture: &mut Picture, row: &[Still], ground: Option<&Ground>, cell: f64) {
        let wide = cell - BETWEEN;
        let reach = 0.5 * wide / self.scale;
        let (mut low, high) = self.seen.heights(row);
        if let (Seen::Side, Some(ground)) = (self.seen, ground) {
            let lowest = row.iter().map(|still| ground.lowest(middle(still), reach));
            low = lowest.fold(low, f64::min);
        }
        let names = picture.take(LINE) + LETTERS;
        let tall = (high - low) * self.scale + BELOW;
        let top = picture.take(tall + 6.0);
        for (i, still) in row.iter().enumerate() {
            let left = MARGIN + i as f64 * cell + 0.5 * BETWEEN;
            let centre = left + 0.5 * wide;
            picture.text("bold middle", (centre, names), &format!("{:.2} s", still.time).replace('-', "−"));
            let lens = Lens {
                scale: self.scale,
                from: (middle(still), self.seen.foot(still) + low),
                place: (centre, top + tall - BELOW),
            };
            picture.clipped((left, top), (wide, tall), |picture| {
                if let Some(ground) = ground {
                    match self.seen {
                        Seen::Side => ground.section(picture, &lens, reach, top + tall),
                        _ => ground.grid(picture, &lens, self.eye, still),
                    }
                }
                for (_, class, solid) in &still.shapes {
                    picture.path(class, &solid.outline(&lens));
                }
                for (side, at) in &still.borne {
                    let class = match side {
                        Side::Left => "f0 mark",
                        Side::Right => "f1 mark",
                        Side::Middle => "ink",
                    };
                    picture.circle(class, lens.point(*at), 3.4);
                }
            });
        }
    }
}

/// The middle of a still from left to right (m).
fn middle(still: &Still) -> f64 {
    0.5 * (still.bounds.low.x + still.bounds.high.x)
}
