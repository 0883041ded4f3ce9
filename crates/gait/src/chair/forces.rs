//! What ground and seat do to somebody: the whole wrench is the motion's own, and is shared between them.

use super::laws::Hips;
use super::sitter::Sitter;
use solaris_analysis::{FootSupport, Support, SupportLaw};
use solaris_dynamics::{DynamicsError, Tree, Workspace, Wrench, inverse_dynamics};
use solaris_model::{Contact, Motion, Vector3};
use solaris_profiles::step;

/// Where the feet are pressed in sitting, as a part of their length from the heel.
pub(super) const SEATED_PRESSURE: f64 = 0.30;
/// How near the whole pressure comes to that before the feet's goes with it (m, at a height of 1.75 m).
const NEAR: f64 = 0.07;
/// The part of the time after which the seat bears nothing, wherever the pressure is.
const LEFT: f64 = 0.5;
/// Height of the point that the feet's forces point at, over that of the centre of mass: far up, they push nearly straight up.
const PIVOT: f64 = 3.0;

/// The wrench that the world does to the body at every frame, about the world's origin.
pub(super) fn totals(tree: &Tree<f64>, motion: &Motion) -> Result<Vec<Wrench<f64>>, DynamicsError> {
    let (mut workspace, mut tau) = (Workspace::new(tree), vec![0.0; tree.nv()]);
    (0..motion.len())
        .map(|i| {
            inverse_dynamics(tree, &mut workspace, motion.q(i), motion.v(i), motion.a(i), &[], &mut tau)?;
            Ok(workspace.base_wrench())
        })
        .collect()
}

/// Where a wrench presses on the ground, along z (m).
pub(super) fn pressed(total: &Wrench<f64>) -> f64 {
    -total.moment.x / total.force.y
}

/// The same along x.
fn pressed_aside(total: &Wrench<f64>) -> f64 {
    total.moment.z / total.force.y
}

/// The seat's part of the whole wrench at a part of the time, and where the feet are pressed along z (m).
///
/// The seat bears `s` of the whole force at `z`, `h` over the ground, the feet the rest at `P`. As the whole pressure `P_t` comes near to where feet are
/// pressed in sitting, `P₀`, the feet's goes to it, and the seat bears nothing any more:
///
/// ```text
/// P = P_t + x S₅(x/δ)   x = P₀ − P_t > 0          M_x + P F_y = s (h F_z − z F_y + P F_y)
/// ```
fn on_seat(sitter: &Sitter, seated: &Hips, total: &Wrench<f64>, u: f64) -> (Contact, f64) {
    let (force, whole) = (total.force, pressed(total));
    let ahead = sitter.sole(SEATED_PRESSURE) - whole;
    if u > LEFT || ahead <= 0.0 {
        return (Contact::default(), whole);
    }
    let feet = whole + ahead * step::quintic(ahead / sitter.scaled(NEAR)).position;
    let at = sitter.on_seat(seated);
    let part = (total.moment.x + feet * force.y) / (sitter.seat * force.z - at * force.y + feet * force.y);
    let cop = Vector3::new(pressed_aside(total), sitter.seat, at);
    let force = force * part;
    (Contact { force, moment: cop.cross(&force), cop }, feet)
}

/// What the seat does frame by frame, and what is known of the feet.
pub(super) struct Shared {
    pub(super) seat: Vec<Contact>,
    feet: Vec<[FootSupport; 2]>,
    rate: f64,
}

impl Shared {
    /// Of the whole wrenches of frames, `rate` a second, at these parts of the time.
    pub(super) fn new(
        sitter: &Sitter,
        seated: &Hips,
        totals: &[Wrench<f64>],
        rate: f64,
        part: impl Fn(usize) -> f64,
    ) -> Self {
        let (mut seat, mut supports) = (Vec::new(), Vec::new());
        for (i, total) in totals.iter().enumerate() {
            let (contact, pressed) = on_seat(sitter, seated, total, part(i));
            let feet = sitter.foot(sitter.part_of_sole(pressed));
            // What is heavier on one side presses more there.
            let left = (pressed_aside(total) - feet[1].x) / (feet[0].x - feet[1].x);
            seat.push(contact);
            supports.push([FootSupport::level(left, feet[0]), FootSupport::level(1.0 - left, feet[1])]);
        }
        Self { seat, feet: supports, rate }
    }
}

impl SupportLaw for Shared {
    fn support(&self, t: f64) -> Support {
        let frame = ((t * self.rate).round() as usize).min(self.feet.len() - 1);
        Support { feet: self.feet[frame], pivot: PIVOT, force: None }
    }
}
