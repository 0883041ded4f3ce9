//! The examples run, and come to what they assert.

#[path = "../../examples/driven_walk.rs"]
mod driven_walk;
#[path = "../../examples/free_arm.rs"]
mod free_arm;
#[path = "../../examples/game_walk.rs"]
mod game_walk;
#[path = "../../examples/getting_up.rs"]
mod getting_up;
#[path = "../../examples/robot_torques.rs"]
mod robot_torques;
#[path = "../../examples/scene_text.rs"]
mod scene_text;
#[path = "../../examples/subject_moments.rs"]
mod subject_moments;

#[test]
fn all_examples_run() {
    for (name, run) in [
        ("driven_walk", driven_walk::main as fn() -> _),
        ("free_arm", free_arm::main),
        ("game_walk", game_walk::main),
        ("getting_up", getting_up::main),
        ("robot_torques", robot_torques::main),
        ("scene_text", scene_text::main),
        ("subject_moments", subject_moments::main),
    ] {
        let done: Result<(), Box<dyn std::error::Error>> = run();
        done.unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}
