//! Simulations, step by step.

use crate::error::{Failure, Status, guard};
use crate::figure::Figure;
use crate::given::{free, give, handle, handle_mut, numbers, numbers_mut, words};
use solaris::files::{self, Body};
use solaris::modes::Running;
use solaris::scene::{NoFiles, Scene, read};
use std::ffi::c_char;
use std::path::Path;

/// A scene on its way.
pub struct Simulation(Running);

/// Begins a scene of a file (`.ron`), by its own method; where it leaves that open in steps of a millisecond, by impulses over ground or
/// where links touch or are held together, else by Runge and Kutta's rule.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_simulation_read(path: *const c_char, out: *mut *mut Simulation) -> Status {
    guard(|| {
        let path = unsafe { words("path", path) }?;
        let scene = files::scene(Path::new(path)).map_err(Failure::unreadable)?.scene;
        unsafe { give("out", out, begin(&scene)?) }
    })
}

/// Begins a scene of a text, which names no files.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_simulation_from_text(
    source: *const c_char,
    out: *mut *mut Simulation,
) -> Status {
    guard(|| {
        let source = unsafe { words("source", source) }?;
        let scene = read(source, &mut NoFiles).map_err(Failure::unreadable)?;
        unsafe { give("out", out, begin(&scene)?) }
    })
}

fn begin(scene: &Scene) -> Result<Simulation, Failure> {
    let simulation = scene.simulation();
    simulation
        .start(simulation.stepping_for(scene.settings().method))
        .map(Simulation)
        .map_err(Failure::refused)
}

/// Frees it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_simulation_free(simulation: *mut Simulation) {
    unsafe { free(simulation) }
}

/// Another one that goes on from here, to the same bits.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_simulation_copy(
    simulation: *const Simulation,
    out: *mut *mut Simulation,
) -> Status {
    guard(|| {
        let simulation = unsafe { handle("simulation", simulation) }?;
        unsafe { give("out", out, Simulation(simulation.0.clone())) }
    })
}

/// The figure of it, which is the caller's to free.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_simulation_figure(
    simulation: *const Simulation,
    out: *mut *mut Figure,
) -> Status {
    guard(|| {
        let Simulation(running) = unsafe { handle("simulation", simulation) }?;
        let mut body = Body::own(running.simulation().figure().clone());
        body.gravity = *running.simulation().gravity();
        unsafe { give("out", out, Figure::new(body)) }
    })
}

/// On by `dt` (s).
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_simulation_step(simulation: *mut Simulation, dt: f64) -> Status {
    guard(|| unsafe { handle_mut("simulation", simulation) }?.0.step(dt).map_err(Failure::refused))
}

/// How long it has run (s); 0 of `NULL`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_simulation_time(simulation: *const Simulation) -> f64 {
    unsafe { simulation.as_ref() }.map_or(0.0, |simulation| simulation.0.time())
}

/// Writes positions and velocities.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_simulation_state(
    simulation: *const Simulation,
    q: *mut f64,
    nq: usize,
    v: *mut f64,
    nv: usize,
) -> Status {
    guard(|| {
        let Simulation(running) = unsafe { handle("simulation", simulation) }?;
        let q = unsafe { numbers_mut("q", q, nq, running.q().len(), &[]) }?;
        let v = unsafe { numbers_mut("v", v, nv, running.v().len(), &[q]) }?;
        q.copy_from_slice(running.q());
        v.copy_from_slice(running.v());
        Ok(())
    })
}

/// Puts the figure somewhere else.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_simulation_set_state(
    simulation: *mut Simulation,
    q: *const f64,
    nq: usize,
    v: *const f64,
    nv: usize,
) -> Status {
    guard(|| {
        let Simulation(running) = unsafe { handle_mut("simulation", simulation) }?;
        let q = unsafe { numbers("q", q, nq, running.q().len()) }?;
        let v = unsafe { numbers("v", v, nv, running.v().len()) }?;
        running.set_state(q, v).map_err(Failure::refused)
    })
}

/// Another constant force (N m, N) on a degree of freedom that is free, until something else is said.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn solaris_simulation_set_force(
    simulation: *mut Simulation,
    dof: usize,
    force: f64,
) -> Status {
    guard(|| {
        unsafe { handle_mut("simulation", simulation) }?.0.set_force(dof, force).map_err(Failure::refused)
    })
}
