//! Drives that are forces, in the time of the run.

use super::force::Force;
use super::path::Path;
use super::servo::ServoForce;
use super::{Aim, Drive, Servo};
use solaris_profiles::ProfileError;

/// The force of a drive that begins now, and when it is done by itself: a servo that goes to a place never is.
pub(crate) fn forced(drive: &Drive, now: f64) -> Result<(Force, f64), ProfileError> {
    Ok(match drive {
        Drive::Torque(profile) => {
            let path = Path::profile(profile, now)?;
            let end = path.end();
            (Force::Along(path), end)
        }
        Drive::Servo(Servo { aim, stiffness, damping, limit }) => {
            let aim = match aim {
                Aim::At(position) => Path::Still(*position),
                Aim::Along(profile) => Path::profile(profile, now)?,
            };
            let (end, limit) = (aim.end(), limit.unwrap_or(f64::INFINITY));
            let servo = ServoForce { aim, stiffness: *stiffness, damping: *damping, limit };
            (Force::Servo(Box::new(servo)), end)
        }
        Drive::Sum(drives) => {
            let (mut parts, mut done) = (Vec::new(), f64::NEG_INFINITY);
            for drive in drives {
                let (force, end) = forced(drive, now)?;
                match force {
                    Force::Sum(inner) => parts.extend(inner),
                    force => parts.push(force),
                }
                done = if end.is_finite() { done.max(end) } else { done };
            }
            (Force::Sum(parts), if done.is_finite() { done } else { f64::INFINITY })
        }
        _ => (Force::Constant(0.0), f64::INFINITY),
    })
}
