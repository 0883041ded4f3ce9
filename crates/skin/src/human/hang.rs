//! Fingers brought to where they hang, and what of the hand goes with which of their bones.

use super::digits::{Digit, digits};
use super::sizes::Sizes;
use super::{ARMS, SIDES, Side};
use crate::mesh::{Influence, Skin};
use crate::weights::{evened, greatest};
use nalgebra::{Matrix3, Point3, Vector3};

/// Columns of shares: what is of no digit, and three bones a digit.
const COLUMNS: usize = 16;
/// Half the length (m) over which a digit's first bone, and the others, take over from the one before.
const HALF: [f64; 3] = [0.012, 0.008, 0.006];

/// How a bone moves what goes with it alone: `p ↦ at + turn·p`, and normals by `normal`.
struct Move {
    turn: Matrix3<f64>,
    at: Vector3<f64>,
    normal: Matrix3<f64>,
}

/// Lets the fingers of a skin hang, and tells what goes with their bones, which are the first of its parts. `groups` are the vertices' groups of solids.
pub(super) fn hang(skin: &mut Skin, groups: &[usize], neighbours: &[Vec<u32>], sizes: &Sizes<'_>) {
    for (i, (side, arm)) in SIDES.into_iter().zip(ARMS).enumerate() {
        let link = sizes.index(&side.name("hand"));
        let of = |i: &Influence| usize::from(i.link) == link && i.share > 0.0;
        let in_hand = |i: &usize| groups[*i] == arm && skin.influences[*i].iter().any(of);
        let own: Vec<usize> = (0..skin.points.len()).filter(in_hand).collect();
        one(skin, &own, neighbours, sizes, side, i * (COLUMNS - 1));
    }
}

/// `first` is the index of the hand's first part.
fn one(skin: &mut Skin, own: &[usize], neighbours: &[Vec<u32>], sizes: &Sizes<'_>, side: Side, first: usize) {
    let digits = digits(sizes, side);
    let link = sizes.index(&side.name("hand"));
    let place = skin.bind[link];
    let scale = sizes.long(&side.name("hand"));
    let local: Vec<Vector3<f64>> =
        own.iter().map(|i| place.inverse_transform_point(&Point3::from(skin.points[*i])).coords).collect();
    let mut shares: Vec<f32> = local.iter().flat_map(|p| row(&digits, p, scale)).collect();
    let mut at = vec![u32::MAX; skin.points.len()];
    for (i, vertex) in own.iter().enumerate() {
        at[*vertex] = i as u32;
    }
    let among = |vertex: &usize| {
        let around = neighbours[*vertex].iter().map(|j| at[*j as usize]);
        around.filter(|j| *j != u32::MAX).collect::<Vec<_>>()
    };
    let around: Vec<Vec<u32>> = own.iter().map(among).collect();
    for _ in 0..ROUNDS {
        shares = evened(&shares, COLUMNS, &around);
    }
    let moves = moves(&digits);
    for ((p, row), vertex) in local.iter().zip(shares.chunks(COLUMNS)).zip(own) {
        let (mut point, mut normal) = (Vector3::zeros(), Vector3::zeros());
        let own = place.rotation.inverse() * skin.normals[*vertex];
        for (share, by) in row.iter().zip(&moves).filter(|(share, _)| **share > 0.0) {
            point += (by.turn * p + by.at) * f64::from(*share);
            normal += by.normal * own * f64::from(*share);
        }
        skin.points[*vertex] = (place * Point3::from(point)).coords;
        let normal = normal.try_normalize(1e-9).unwrap_or(own);
        skin.normals[*vertex] = place.rotation * normal;
    }
    let first = skin.bind.len() + first;
    for (row, vertex) in shares.chunks(COLUMNS).zip(own) {
        let with = skin.influences[*vertex];
        let fine = split(&with, row, link, first);
        if fine != with {
            skin.fine.push((*vertex as u32, fine));
        }
    }
}

/// Times that shares are evened out over neighbours.
const ROUNDS: usize = 3;

/// The influences of a vertex, the hand's share of them shared out to the digits by `row`, whose bones are counted from `first` on.
fn split(with: &[Influence; 4], row: &[f32], link: usize, first: usize) -> [Influence; 4] {
    let mut whole = Vec::with_capacity(8);
    for i in with.iter().filter(|i| i.share > 0.0) {
        if usize::from(i.link) != link {
            whole.push(*i);
            continue;
        }
        for (column, share) in row.iter().enumerate() {
            let link = if column == 0 { link } else { first + column - 1 };
            whole.push(Influence { link: link as u16, share: i.share * share });
        }
    }
    greatest(whole)
}

/// The shares of a point of the hand.
fn row(digits: &[Digit], p: &Vector3<f64>, scale: f64) -> [f32; COLUMNS] {
    let mut row = [0.0; COLUMNS];
    let distances = digits.iter().map(|digit| digit.distance(p));
    let near = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).map_or(0, |(i, _)| i);
    let passed = digits[near].passed(p, HALF.map(|half| half * scale), scale);
    // Each bone hands on a share to the next one.
    let mut left = 1.0;
    row[0] = (1.0 - passed[0]) as f32;
    for k in 0..3 {
        left *= passed[k];
        let on = passed.get(k + 1).copied().unwrap_or(0.0);
        row[1 + 3 * near + k] = (left * (1.0 - on)) as f32;
    }
    row
}

fn moves(digits: &[Digit]) -> Vec<Move> {
    let still = || Move { turn: Matrix3::identity(), at: Vector3::zeros(), normal: Matrix3::identity() };
    let mut moves = vec![still()];
    for digit in digits {
        let of = |(turn, at, normal)| Move { turn, at, normal };
        moves.extend(digit.moves().map(|by| by.map_or_else(still, of)));
    }
    moves
}
