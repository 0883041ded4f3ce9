//! What a second of simulated time costs by impulses, at a step of 1 ms: a second or less is real time.

use divan::Bencher;
use solaris_model::{Human, Vector3};
use solaris_modes::{ContactLaw, GroundPlane, Method, Settings, Simulation, contact_points};

fn main() {
    divan::main();
}

/// A limp person of 66 degrees of freedom who falls from half a metre, turning, and comes to lie; or who lies already.
fn limp(falls: bool) -> Simulation {
    let figure = Human::new(1.75, 73.0).limp().build().expect("within range");
    let mut simulation = Simulation::new(&figure, Vector3::y() * -9.81);
    let (mut q, mut v) = (simulation.state().0.to_vec(), vec![0.0; figure.layout().nv()]);
    q[1] = 1.2;
    (v[3], v[4]) = (2.0, 4.0);
    simulation.set_start(&q, &v).expect("valid");
    let plane = GroundPlane::under(&figure, simulation.gravity(), 0.8).expect("valid");
    let plane = GroundPlane { law: ContactLaw::Rigid, ..plane };
    simulation.set_ground(plane, contact_points(&figure)).expect("valid");
    if !falls {
        let run = simulation.run(&settings(3.0)).expect("never refused").motion;
        simulation.set_start(run.q(run.len() - 1), run.v(run.len() - 1)).expect("valid");
    }
    simulation
}

fn settings(duration: f64) -> Settings {
    let method = Method::Impulses { step: 1e-3 };
    Settings { method, estimate: false, forces: false, ..Settings::new(duration, 60.0) }
}

#[divan::bench(args = [true, false], sample_count = 5, sample_size = 1)]
fn limp_person(bencher: Bencher<'_, '_>, falls: bool) {
    let simulation = limp(falls);
    bencher.bench_local(|| simulation.run(&settings(1.0)).expect("never refused"));
}
