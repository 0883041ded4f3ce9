//! What a vertex of a body goes with.

use crate::mesh::Influence;
use nalgebra::Vector3;

/// A joint as the skin bends about it.
#[derive(Clone, Debug)]
pub(crate) struct Bend {
    /// The link that it moves, and that link's parent.
    pub(crate) link: usize,
    pub(crate) parent: usize,
    /// Where it is (m), and which way the link lies.
    pub(crate) at: Vector3<f64>,
    pub(crate) towards: Vector3<f64>,
    /// Half the length over which the skin goes from one link to the other (m).
    pub(crate) half: f64,
    /// Which groups of the body have vertices that may go with it, and which go with it or what is beyond it alone.
    pub(crate) groups: Vec<usize>,
    pub(crate) beyond: Vec<usize>,
    /// Of group 0, the trunk, only what is beyond a border: a point on it, the way inwards, half its width (m).
    pub(crate) beside: Option<(Vector3<f64>, Vector3<f64>, f64)>,
}

/// Goes from 0 at −1 to 1 at 1 without a kink.
pub(crate) fn ramp(x: f64) -> f64 {
    let t = (0.5 + 0.5 * x).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Times that shares are evened out over neighbours.
const ROUNDS: usize = 5;

/// The influences of vertices at `points` in these `groups`. From the root outwards each joint hands on a share to its link:
///
/// ```text
/// w(link) = Π s(joints up to it) · (1 − Σ s(joints beyond it)),  s = ramp(n·(p − joint)/half)
/// ```
///
/// then shares are evened out along edges, the four greatest are kept, and are made 1 together.
pub(crate) fn influences(
    points: &[Vector3<f64>],
    groups: &[usize],
    bends: &[Bend],
    links: usize,
    neighbours: &[Vec<u32>],
) -> Vec<[Influence; 4]> {
    let mut shares: Vec<f32> = vec![0.0; points.len() * links];
    for ((p, group), row) in points.iter().zip(groups).zip(shares.chunks_mut(links)) {
        let bend = |bend: &Bend| {
            if bend.beyond.contains(group) {
                return 1.0;
            }
            if !bend.groups.contains(group) {
                return 0.0;
            }
            let inside = bend
                .beside
                .filter(|_| *group == 0)
                .map_or(1.0, |(at, inwards, half)| ramp(inwards.dot(&(p - at)) / half));
            ramp(bend.towards.dot(&(p - bend.at)) / bend.half) * inside
        };
        let passed: Vec<f64> = bends.iter().map(bend).collect();
        let mut whole = vec![0.0; links];
        whole[0] = 1.0;
        // Parents come before children, and so do their joints.
        for link in 0..links {
            let on: f64 = bends.iter().zip(&passed).filter(|(b, _)| b.parent == link).map(|(_, s)| s).sum();
            let least = on.max(1.0);
            for (b, s) in bends.iter().zip(&passed).filter(|(b, _)| b.parent == link) {
                whole[b.link] = whole[link] * s / least;
            }
            row[link] = (whole[link] * (1.0 - on / least)) as f32;
        }
    }
    for _ in 0..ROUNDS {
        shares = evened(&shares, links, neighbours);
    }
    let of = |row: &[f32]| {
        let own = row.iter().zip(0_u16..).map(|(share, link)| Influence { link, share: *share });
        greatest(own.collect())
    };
    shares.chunks(links).map(of).collect()
}

pub(crate) fn evened(shares: &[f32], links: usize, neighbours: &[Vec<u32>]) -> Vec<f32> {
    let mut out = shares.to_vec();
    for (row, around) in out.chunks_mut(links).zip(neighbours) {
        let part = 0.5 / around.len() as f32;
        for share in row.iter_mut() {
            *share *= 0.5;
        }
        for j in around {
            let from = *j as usize * links;
            for (share, other) in row.iter_mut().zip(&shares[from..from + links]) {
                *share += part * other;
            }
        }
    }
    out
}

/// Shares that do not matter.
const LEAST: f32 = 0.004;

/// The four greatest shares, made 1 together.
pub(crate) fn greatest(mut order: Vec<Influence>) -> [Influence; 4] {
    order.retain(|i| i.share > LEAST);
    order.sort_by(|a, b| b.share.total_cmp(&a.share));
    order.truncate(4);
    let total: f32 = order.iter().map(|i| i.share).sum();
    std::array::from_fn(|k| {
        order.get(k).map_or(Influence::default(), |i| Influence { link: i.link, share: i.share / total })
    })
}
