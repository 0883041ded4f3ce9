//! Reports of runs as JSON: the keys carry the units, the values are the fields'.

use serde_json::{Value, json};
use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
use solaris_modes::{
    ContactReport, Drive, Energy, Landing, Law, LimitLaw, LinkContact, Method, Remark, Rule, Run, Settings,
    Simulation, Target,
};

/// The keys of an object, sorted.
fn keys(value: &Value) -> Vec<&str> {
    let mut keys: Vec<&str> = value.as_object().expect("an object").keys().map(String::as_str).collect();
    keys.sort_unstable();
    keys
}

/// A sled that is thrown against its hard limit, and on it an arm that is driven past its target.
fn run() -> Run {
    let figure = FigureBuilder::new("sled")
        .link(LinkSpec::root("sled", Joint::new("slide").tx().limited(-1.0, 0.1)).mass(2.0))
        .link(LinkSpec::child("arm", "sled", Joint::new("hinge").rz()).mass(1.0).com(Vector3::y() * -0.5))
        .build()
        .expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    simulation.set_start(&[0.0, 0.0], &[1.0, 0.0]).expect("valid");
    simulation.set_limits(LimitLaw::Hard { restitution: 0.5 }).expect("valid");
    let drive = Drive::Intensive { target: Target::at(0.785), duration: 1.0, law: Law::Literal, limit: None };
    simulation.drive("hinge", [drive]).expect("valid");
    let method = Method::Fixed { rule: Rule::RungeKutta4, step: 0.01 };
    let settings = Settings { method, estimate: false, ..Settings::new(1.2, 100.0) };
    simulation.run(&settings).expect("runs")
}

#[test]
fn a_run_is_written_with_units_in_its_keys() {
    let report = run().report;
    let written = serde_json::to_value(&report).expect("written");
    assert_eq!(
        keys(&written),
        ["cost", "drives", "energy", "error", "impacts", "method", "phases", "why"],
        "no ground and no remarks"
    );
    assert_eq!(
        written["cost"],
        json!({
            "evaluations": report.cost.counts.evaluations,
            "jacobians": 0,
            "steps": report.cost.counts.steps,
            "rejected_steps": 0,
            "events": report.cost.counts.events,
            "seconds": null,
        })
    );
    let Energy { kinetic, potential, elastic } = report.energy.end;
    assert_eq!(
        written["energy"]["end"],
        json!({
            "kinetic": kinetic,
            "in_gravity": potential,
            "in_springs": elastic,
            "total": kinetic + potential + elastic,
        })
    );
    assert_eq!(
        keys(&written["energy"]),
        ["at_play", "end", "heat", "imbalance", "lost_in_impacts", "moved", "start", "work_of_drives"]
    );
    let (phase, told) = (&report.phases[0], &written["phases"][0]);
    assert!(phase.operations_of_all.total() > 0);
    assert_eq!(told["operations_of_all"], json!(phase.operations_of_all.total()));
    assert_eq!(told["operations"], json!(phase.operations.total()));
    assert_eq!((&told["start_s"], &told["end_s"]), (&json!(phase.start), &json!(phase.end)));
    assert_eq!(told["dropped_links"], json!([]));
}

#[test]
fn drives_and_impacts_are_written_by_the_names_of_what_they_move() {
    let report = run().report;
    let written = serde_json::to_value(&report).expect("written");
    let found = report.outcomes.iter().position(|outcome| outcome.missed_by.is_some());
    let found = found.unwrap_or_else(|| panic!("{:?}", report.outcomes));
    let outcome = &report.outcomes[found];
    let missed_by = outcome.missed_by.unwrap_or_default();
    assert!(missed_by > 0.01 && (missed_by - (outcome.position - 0.785).abs()).abs() < 1e-15);
    assert_eq!(
        written["drives"][found],
        json!({
            "dof": "hinge.rz",
            "drive": outcome.drive,
            "start_s": 0.0,
            "end_s": outcome.end,
            "result": "missed",
            "position": outcome.position,
            "velocity": outcome.velocity,
            "missed_by": missed_by,
            "acceleration": null,
        })
    );
    let impact = &report.impacts[0];
    assert!(impact.velocity_before > 0.0 && impact.velocity_after < 0.0);
    assert_eq!(
        written["impacts"][0],
        json!({
            "time_s": impact.time,
            "dof": "slide.tx",
            "what": "limit",
            "velocity_before": impact.velocity_before,
            "velocity_after": impact.velocity_after,
            "impulse": impact.impulse,
            "loss_j": impact.loss,
        })
    );
}

#[test]
fn what_the_ground_did_and_remarks_are_written_where_there_are_any() {
    let mut report = run().report;
    let link = LinkContact { link: "arm".to_owned(), depth: 0.25, slipping: 2.0, ..LinkContact::default() };
    let landing = Landing { time: 0.5, impulse: [1.0, 2.0, 3.0], loss: 4.0, ..Landing::default() };
    report.ground = Some(ContactReport { damping: 0.125, links: vec![link], ..ContactReport::default() });
    report.remarks.push(Remark::NoEstimate);
    let written = serde_json::to_value(&report).expect("written");
    assert_eq!(written["remarks"], json!([Remark::NoEstimate.to_string()]));
    let contact = &written["contact"];
    assert_eq!(keys(contact), ["damping_j", "friction_j", "impulse_n_s", "links"]);
    assert_eq!(contact["damping_j"], json!(0.125));
    assert_eq!(
        contact["links"][0],
        json!({
            "link": "arm", "touching_s": 0.0, "depth_m": 0.25, "depth_time_s": 0.0, "slip_m_s": 0.0, "slip_time_s": 0.0,
            "friction": 0.0, "friction_time_s": 0.0, "slipping_s": 2.0, "slid_m": 0.0,
        })
    );
    let landed = serde_json::to_value(&landing).expect("written");
    assert_eq!(landed, json!({"time_s": 0.5, "links": [], "impulse_n_s": [1.0, 2.0, 3.0], "loss_j": 4.0}));
}
