//! The walker that is steered while it walks.

use crate::error::{Failure, Status, guard};
use crate::figure::Figure;
use crate::given::{free, give, handle, handle_mut, numbers_mut, vector, words};
use solaris::analysis::Goal;
use solaris::gait;
use solaris::model::Vector3;
use std::ffi::c_char;

/// To come to a stand, or to stay.
pub const GO_STOP: u32 = 0;
/// To walk with the velocity (`x`, `z`) in the world (m/s).
pub const GO_VELOCITY: u32 = 1;
/// To walk with the velocity (`x` to the left, `z` forward) of the way it faces (m/s).
pub const GO_OWN_VELOCITY: u32 = 2;
/// To walk to the point (`x`, `z`) (m) with `speed` (m/s), and to stop there.
pub const GO_TO_POINT: u32 = 3;

/// To face where it goes.
pub const FACE_WAY: u32 = 0;
/// To face `heading` (rad, to the left of z).
pub const FACE_HEADING: u32 = 1;
/// To face the point (`face_x`, `face_z`) (m).
pub const FACE_POINT: u32 = 2;

/// What a walker is to do from now on. All of it is level: x to the left and z forward of the world. All zeros is to stand.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct Command {
    /// One of `SOLARIS_GO_…`.
    pub go: u32,
    /// One of `SOLARIS_FACE_…`.
    pub face: u32,
    /// See `go`.
    pub x: f64,
    /// See `go`.
    pub z: f64,
    /// See `go`.
    pub speed: f64,
    /// See `face`.
    pub heading: f64,
    /// See `face`.
    pub face_x: f64,
    /// See `face`.
    pub face_z: f64,
}

impl Command {
    fn read(&self) -> Result<gait::Command, Failure> {
        let unknown = |what: &str, found: u32| {
            Err(Failure::argument(format!(
                "{what} is {found}; it must be one of SOLARIS_{}_…",
                what.to_uppercase()
            )))
        };
        let command = match self.go {
            GO_STOP => gait::Command::stop(),
            GO_VELOCITY => gait::Command::velocity(self.x, self.z),
            GO_OWN_VELOCITY => gait::Command::own_velocity(self.x, self.z),
            GO_TO_POINT => gait::Command::to_point(self.x, self.z, self.speed),
            other => return unknown("go", other),
        };
        match self.face {
            FACE_WAY => Ok(command),
            FACE_HEADING => Ok(command.facing(self.heading)),
            FACE_POINT => Ok(command.facing_point(self.face_x, self.face_z)),
            other => unknown("face", other),
        }
    }
}

/// A figure that walks as it is told while it walks. Frames allocate nothing but in errors.
pub struct Walker(gait::Walker);

/// Makes a walker that stands at the origin and faces along z; it plans for some dozens of milliseconds.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_new(figure: *const Figure, out: *mut *mut Walker) -> Status {
    guard(|| {
        let figure = &unsafe { handle("figure", figure) }?.body.figure;
        let walker = gait::Walker::new(figure).map_err(Failure::refused)?;
        unsafe { give("out", out, Walker(walker)) }
    })
}

/// Another walker that goes on from where this one is, to the same bits under the same commands; plans are shared.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_copy(walker: *const Walker, out: *mut *mut Walker) -> Status {
    guard(|| {
        let walker = unsafe { handle("walker", walker) }?;
        unsafe { give("out", out, Walker(walker.0.clone())) }
    })
}

/// Frees a walker.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_free(walker: *mut Walker) {
    unsafe { free(walker) }
}

/// Goes on by `dt` (s, up to a quarter) under a command, and writes the configuration there.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_step(
    walker: *mut Walker,
    dt: f64,
    command: *const Command,
    q: *mut f64,
    nq: usize,
) -> Status {
    guard(|| {
        let Walker(walker) = unsafe { handle_mut("walker", walker) }?;
        let command = unsafe { handle("command", command) }?.read()?;
        let q = unsafe { numbers_mut("q", q, nq, walker.configuration().len(), &[]) }?;
        q.copy_from_slice(walker.step(dt, &command).map_err(Failure::refused)?);
        Ok(())
    })
}

/// Where a walker is.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct Whereabouts {
    /// The middle between its feet's coming prints (m).
    pub x: f64,
    /// The same.
    pub z: f64,
    /// Which way it faces (rad, to the left of z, not wrapped).
    pub heading: f64,
    /// The velocity that the present step makes (m/s).
    pub velocity_x: f64,
    /// The same.
    pub velocity_z: f64,
    /// Whether both feet stand and no step has begun.
    pub is_standing: bool,
}

/// Where it is, which way it faces, how fast it goes.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_whereabouts(walker: *const Walker, out: *mut Whereabouts) -> Status {
    guard(|| {
        let Walker(walker) = unsafe { handle("walker", walker) }?;
        let out = unsafe { handle_mut("out", out) }?;
        let ([x, z], [velocity_x, velocity_z]) = (walker.place(), walker.velocity());
        let (heading, is_standing) = (walker.heading(), walker.is_standing());
        *out = Whereabouts { x, z, heading, velocity_x, velocity_z, is_standing };
        Ok(())
    })
}

/// Gives a coordinate of trunk, head or arms (`left_elbow.rx`) a value (rad) from now on, beside the walk. It goes over to it within 0.3 s; one that moves smoothly is
/// followed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_set(
    walker: *mut Walker,
    coordinate: *const c_char,
    value: f64,
) -> Status {
    guard(|| {
        let Walker(walker) = unsafe { handle_mut("walker", walker) }?;
        let coordinate = unsafe { words("coordinate", coordinate) }?;
        walker.set_freed(coordinate, value).map_err(Failure::refused)?;
        walker.free(coordinate).map_err(Failure::refused)
    })
}

/// Takes a coordinate back into the walk, within 0.3 s.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_hold(walker: *mut Walker, coordinate: *const c_char) -> Status {
    guard(|| {
        let Walker(walker) = unsafe { handle_mut("walker", walker) }?;
        walker.hold(unsafe { words("coordinate", coordinate) }?).map_err(Failure::refused)
    })
}

/// A point of a link (three numbers, m, in its frame) reaches for a place (three numbers, m, in the world) from now on, by the joints of its arm, or of neck and head. What moves is
/// told anew each frame.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_reach(
    walker: *mut Walker,
    link: *const c_char,
    point: *const f64,
    place: *const f64,
) -> Status {
    guard(|| {
        let place = unsafe { vector("place", place) }?;
        unsafe { reach(walker, link, point, Goal::Place(place)) }
    })
}

/// The z axis of a link, which is forward, turns towards a place (three numbers, m, in the world) as it is seen from a point of the link (m, in its frame), by the same joints.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_look(
    walker: *mut Walker,
    link: *const c_char,
    point: *const f64,
    place: *const f64,
) -> Status {
    guard(|| {
        let at = unsafe { vector("place", place) }?;
        unsafe { reach(walker, link, point, Goal::Look { axis: Vector3::z_axis(), at }) }
    })
}

unsafe fn reach(
    walker: *mut Walker,
    link: *const c_char,
    point: *const f64,
    goal: Goal,
) -> Result<(), Failure> {
    let Walker(walker) = unsafe { handle_mut("walker", walker) }?;
    let (link, point) = unsafe { (words("link", link)?, vector("point", point)?) };
    walker.reach(link, point, &[], goal).map_err(Failure::refused)
}

/// A link that reaches or looks comes back into the walk, within 0.3 s.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_withdraw(walker: *mut Walker, link: *const c_char) -> Status {
    guard(|| {
        let Walker(walker) = unsafe { handle_mut("walker", walker) }?;
        walker.withdraw(unsafe { words("link", link) }?).map_err(Failure::refused)
    })
}

/// Lets a joint of trunk, head or arms hang loose, or takes it back.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_loosen(
    walker: *mut Walker,
    joint: *const c_char,
    loose: bool,
) -> Status {
    guard(|| {
        let Walker(walker) = unsafe { handle_mut("walker", walker) }?;
        let joint = unsafe { words("joint", joint) }?;
        if loose { walker.loosen(joint) } else { walker.tighten(joint) }.map_err(Failure::refused)
    })
}

/// Pushes a point of a link (three numbers, m, in its frame) with a force (three numbers, N, of the world) from now on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_push(
    walker: *mut Walker,
    link: *const c_char,
    point: *const f64,
    force: *const f64,
) -> Status {
    guard(|| {
        let Walker(walker) = unsafe { handle_mut("walker", walker) }?;
        let (link, point) = unsafe { (words("link", link)?, vector("point", point)?) };
        walker.push(link, point, unsafe { vector("force", force) }?).map_err(Failure::refused)
    })
}

/// Pushes no more.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_let_go(walker: *mut Walker) -> Status {
    guard(|| {
        unsafe { handle_mut("walker", walker) }?.0.let_go();
        Ok(())
    })
}

/// What the ground does to a foot, in the axes of the world.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct Contact {
    /// N.
    pub force: [f64; 3],
    /// About the world's origin (N m).
    pub moment: [f64; 3],
    /// Where it is pressed (m).
    pub center: [f64; 3],
}

/// What the last frame asks of the ground under the left and the right foot (two of them in `feet`) and of the joints (`nv` forces in `tau`, N m and N).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_walker_forces(
    walker: *mut Walker,
    feet: *mut Contact,
    tau: *mut f64,
    nv: usize,
) -> Status {
    guard(|| {
        let Walker(walker) = unsafe { handle_mut("walker", walker) }?;
        let feet = unsafe { handle_mut("feet", feet.cast::<[Contact; 2]>()) }?;
        let tau = unsafe { numbers_mut("tau", tau, nv, walker.configuration().len(), &[]) }?;
        let found = walker.forces(tau).map_err(Failure::refused)?;
        *feet = found.map(|foot| Contact {
            force: foot.force.into(),
            moment: foot.moment.into(),
            center: foot.cop.into(),
        });
        Ok(())
    })
}
