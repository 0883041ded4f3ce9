//! Drives by the motors of a file, against closed forms, and what is wrong with them.

use solaris_model::text::read as read_figure;
use solaris_model::{Actuator, ActuatorLaw, Figure};
use solaris_scene::{Loader, Scene, read};
use std::fmt::Write;

/// Wheels of 0.5 kg m² on axles without gravity, and their motors.
struct Wheels;

impl Loader for Wheels {
    fn figure(&mut self, _path: &str) -> Result<Figure, String> {
        let wheel = |name: &str| {
            format!(
                "Link(name: \"{name}\", parent: \"post\", joint: Joint(name: \"{name}\", axes: [rz]), mass: 1, inertia: (0.5, 0.5, 0.5))"
            )
        };
        let links: Vec<String> = ["p", "v", "f", "m", "x"].iter().map(|name| wheel(name)).collect();
        let text = format!(
            "Figure(version: 1, name: \"wheels\", links: [Link(name: \"post\", joint: Joint(name: \"floor\")), {}])",
            links.join(", ")
        );
        read_figure(&text).map_err(|error| error.to_string())
    }

    fn actuators(&mut self, path: &str) -> Result<Vec<Actuator>, String> {
        if path == "none.obj" {
            return Err("it has no motors".to_owned());
        }
        let one = |dof: &str, law, limit| Actuator {
            name: format!("motor_{dof}"),
            dof: dof.to_owned(),
            law,
            limit,
        };
        Ok(vec![
            one("p", ActuatorLaw::Position { stiffness: 8.0, damping: 0.0 }, None),
            one("v", ActuatorLaw::Velocity { damping: 0.25 }, None),
            one("f", ActuatorLaw::Force, Some(2.0)),
            one("m", ActuatorLaw::Other("<muscle>".to_owned()), None),
            one("tail", ActuatorLaw::Force, None),
            one("p", ActuatorLaw::Force, None),
        ])
    }
}

fn scene(file: &str, fields: &str) -> Result<Scene, String> {
    let text = format!(
        "Scene(version: 1, duration: 2, rate: 50, gravity: (0, 0, 0), figures: {{\"r\": {file}}}, {fields})"
    );
    read(&text, &mut Wheels).map_err(|error| error.to_string())
}

const ASKED: &str = "File(path: \"wheels.xml\", actuators: true)";

#[test]
fn motors_do_what_their_numbers_say() {
    let drives = "drives: {\"p\": Actuator(to: 0.5), \"v\": Actuator(velocity: 3), \"f\": Servo(to: 100, stiffness: 1000, limit: 9), \"x\": Free}";
    let scene = scene(ASKED, &format!("{drives}, method: RungeKutta4(step: 1e-3)")).expect("a scene");
    assert_eq!(
        scene.notes(),
        [
            "the actuator 'motor_tail' is left out: it drives no degree of freedom of 'r'",
            "the actuator 'motor_p' is left out: 'motor_p' drives the same degree of freedom"
        ]
    );
    let motion = scene.simulate(&mut ()).expect("runs").motion;
    for frame in 0..motion.len() {
        let (t, q, v) = (motion.time()[frame], motion.q(frame), motion.v(frame));
        // ω² = k/I = 16; v* ·(1 − e^(−d·t/I)), d/I = 0.5; 2 N m on 0.5 kg m², and no more.
        assert!((q[0] - 0.5 * (1.0 - (4.0 * t).cos())).abs() < 1e-8, "{t}: {}", q[0]);
        assert!((v[1] - 3.0 * (1.0 - (-0.5 * t).exp())).abs() < 1e-8, "{t}: {}", v[1]);
        assert!((q[2] - 2.0 * t * t).abs() < 1e-8, "{t}: {}", q[2]);
    }
}

#[test]
fn motors_that_nothing_is_said_of_lead_to_zero_and_brake() {
    let fields = "start: {\"p\": 0.3}, velocities: {\"v\": 2, \"f\": 1}, method: RungeKutta4(step: 1e-3)";
    let motion = scene(ASKED, fields).expect("a scene").simulate(&mut ()).expect("runs").motion;
    let last = motion.len() - 1;
    assert!((motion.q(last)[0] - 0.3 * 8_f64.cos()).abs() < 1e-8);
    assert!((motion.v(last)[1] - 2.0 * (-1_f64).exp()).abs() < 1e-8);
    assert!((motion.q(last)[2] - 2.0).abs() < 1e-9);
    // Not asked for they are not there.
    let motion =
        scene("File(\"wheels.xml\")", fields).expect("a scene").simulate(&mut ()).expect("runs").motion;
    assert!((motion.q(last)[0] - 0.3).abs() < 1e-12);
}

#[test]
fn faults_of_motors() {
    let mut said = String::new();
    for (file, fields) in [
        (ASKED, "drives: {\"p\": Actuator(velocity: 1)}"),
        (ASKED, "drives: {\"v\": Actuator(to: 1)}"),
        (ASKED, "drives: {\"f\": Actuator(to: 1)}"),
        (ASKED, "drives: {\"m\": Actuator(to: 1)}"),
        (ASKED, "drives: {\"x\": Actuator(to: 1)}"),
        (ASKED, "drives: {\"p\": Actuator()}"),
        (ASKED, "drives: {\"p\": Actuator(to: 1, velocity: 2, stiffness: 3)}"),
        (ASKED, "drives: {\"p\": Actuatr(to: 1)}"),
        ("File(path: \"wheels.xml\", actuators: yes)", ""),
        ("File(path: \"none.obj\", actuators: true)", ""),
        ("File(path: \"wheels.xml\")", "drives: {\"p\": Actuator(to: 1)}"),
    ] {
        let found = scene(file, fields).map_or_else(|error| error, |_| "no fault".to_owned());
        let _ = write!(said, "{file} {fields}\n{found}\n\n");
    }
    insta::assert_snapshot!(said);
}
