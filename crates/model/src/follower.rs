//! Followers: degrees of freedom whose coordinates are functions of others.

use crate::curve::Curve;
use crate::layout::StateLayout;
use crate::link::Link;

/// A degree of freedom whose coordinate is a function of another's: it has a place in `q`, `v`, `a` and `tau`, and no
/// freedom of its own.
///
/// The centre of a knee that moves as the knee bends is a slide that follows the angle.
#[doc(alias = "mimic")]
#[doc(alias = "coupled coordinate")]
#[derive(Clone, Debug, PartialEq)]
pub struct Follower {
    /// Its index in `v`.
    pub dof: usize,
    /// Its coordinate's index in `q`.
    pub coordinate: usize,
    /// Index in `v` of the degree of freedom that it follows, which follows none itself.
    pub leader: usize,
    /// That one's coordinate's index in `q`.
    pub leader_coordinate: usize,
    /// Its coordinate over that of its leader (rad or m).
    pub curve: Curve,
}

/// The followers among the degrees of freedom of `links` whose leaders are there.
pub(crate) fn followers(links: &[Link], layout: &StateLayout) -> Vec<Follower> {
    let mut found = Vec::new();
    for (link, at) in links.iter().zip(layout.joints()) {
        for (i, dof) in link.joint.kind().axes().iter().enumerate() {
            let Some(follow) = &dof.follows else { continue };
            let Some(leader) = layout.dof_index(&follow.dof) else { continue };
            let Some(leader_coordinate) = layout.coordinate(leader) else { continue };
            let (dof, coordinate, curve) = (at.v + i, at.q + i, follow.curve.clone());
            found.push(Follower { dof, coordinate, leader, leader_coordinate, curve });
        }
    }
    found
}
