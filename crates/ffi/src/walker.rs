//! The walker that is steered while it walks.

use crate::error::{Failure, Status, guard};
use crate::figure::Figure;
use crate::given::{free, give, handle, handle_mut, numbers_mut};
use solaris::gait;

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
