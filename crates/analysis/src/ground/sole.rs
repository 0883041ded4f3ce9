//! Feet as the ground meets them.

use crate::ground::GroundError;
use nalgebra::Vector3;
use solaris_model::{Figure, Link, SolePart};

/// Breadth of a sole over its length, where nobody says it: in Drillis and Contini's table (1966, as printed by Winter
/// 2009, figure 4.1) a foot is 0.055 body heights broad and 0.152 long.
pub const SOLE_BREADTH: f64 = 0.055 / 0.152;

/// A foot as the ground meets it: three points along the middle of its sole.
#[derive(Clone, Debug, PartialEq)]
pub struct Sole {
    /// What its columns are called; the link's name by default.
    pub name: String,
    /// Index of the link that carries heel and ball.
    pub foot: usize,
    /// Index of the link that carries what presses beyond the ball, if it is another.
    pub toes: Option<usize>,
    /// Hindmost point (m), in the foot's frame.
    pub heel: Vector3<f64>,
    /// Below the joint between foot and toes (m), in the foot's frame.
    pub ball: Vector3<f64>,
    /// Foremost point (m), in the toes' frame, or the foot's where there are no toes.
    pub tip: Vector3<f64>,
    /// Breadth (m); where it is `None` the centre of pressure is not judged.
    pub width: Option<f64>,
}

impl Sole {
    /// What draws it: from heel to ball to tip, and from the ankle to heel and ball, each line (m) in the frame of a link.
    pub fn lines(&self) -> [(usize, [Vector3<f64>; 2]); 4] {
        // The tip of toes is told in their own frame, which begins at their joint.
        let (front, begin) = self.toes.map_or((self.foot, self.ball), |toes| (toes, Vector3::zeros()));
        let ankle = Vector3::zeros();
        [
            (self.foot, [self.heel, self.ball]),
            (self.foot, [ankle, self.heel]),
            (self.foot, [ankle, self.ball]),
            (front, [begin, self.tip]),
        ]
    }

    pub(crate) fn check(&self, figure: &Figure) -> Result<(), GroundError> {
        let links = figure.links().len();
        let fault = |what, value: String, remedy| {
            Err(GroundError::Sole { sole: self.name.clone(), what, value, remedy })
        };
        if let Some(link) = [Some(self.foot), self.toes].into_iter().flatten().find(|link| *link >= links) {
            return fault("a link's index", link.to_string(), "it must be that of a link of the figure");
        }
        if self.toes == Some(self.foot) {
            return fault(
                "the toes' link",
                self.foot.to_string(),
                "it must be another than the foot's, or none",
            );
        }
        for (what, point) in [("the heel", self.heel), ("the ball", self.ball), ("the tip", self.tip)] {
            if !point.iter().all(|x| x.is_finite()) {
                return fault(
                    what,
                    format!("{} {} {}", point.x, point.y, point.z),
                    "it must be finite numbers of m",
                );
            }
        }
        match self.width {
            Some(width) if !(width.is_finite() && width > 0.0) => fault(
                "the breadth",
                width.to_string(),
                "it must be a finite length of more than 0 m, or none",
            ),
            _ => Ok(()),
        }
    }
}

/// The soles that the figure itself has, in the order of its links: each link with sole points, with the first of its
/// children that has sole points as its toes.
///
/// A point that is not there is at the one before it (a paw with one point has all three there). The breadth is
/// [`SOLE_BREADTH`] times the length; points alone have none.
pub fn soles(figure: &Figure) -> Vec<Sole> {
    let links = figure.links();
    let toes_of = |foot: usize| {
        (foot + 1..links.len()).find(|i| links[*i].parent() == Some(foot) && !links[*i].sole().is_empty())
    };
    let mut taken = vec![false; links.len()];
    let mut out = Vec::new();
    for (foot, link) in links.iter().enumerate() {
        if link.sole().is_empty() || taken[foot] {
            continue;
        }
        let toes = toes_of(foot).filter(|toes| links[*toes].sole_point(SolePart::ToeTip).is_some());
        if let Some(toes) = toes {
            taken[toes] = true;
        }
        out.extend(sole(link, foot, toes.map(|i| (i, &links[i]))));
    }
    out
}

fn sole(link: &Link, foot: usize, toes: Option<(usize, &Link)>) -> Option<Sole> {
    let own = |part| link.sole_point(part).copied();
    let (heel, ball, tip) = (own(SolePart::Heel), own(SolePart::Ball), own(SolePart::ToeTip));
    let heel = heel.or(ball).or(tip)?;
    let ball = ball.unwrap_or(heel);
    let (tip, beyond) = match toes {
        None => {
            let tip = tip.unwrap_or(ball);
            (tip, (tip - ball).norm())
        }
        Some((_, toes)) => {
            let tip = toes.sole_point(SolePart::ToeTip).copied()?;
            let from = toes.sole_point(SolePart::Ball).copied().unwrap_or_default();
            (tip, (tip - from).norm())
        }
    };
    let length = (ball - heel).norm() + beyond;
    let width = (length > 0.0).then_some(SOLE_BREADTH * length);
    Some(Sole { name: link.name().to_owned(), foot, toes: toes.map(|(i, _)| i), heel, ball, tip, width })
}
