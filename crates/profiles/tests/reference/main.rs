//! Against numbers of 60 digits (`fixtures/reference/profiles.json`). A binary of its own: it is built without the standard library too.

#![allow(clippy::print_stdout, reason = "`--nocapture` shows how much of the tolerance is used")]

mod acceleration;
mod blends;
mod displacement;
mod harness;
mod keys;
mod polynomial;
mod velocity;

#[test]
fn no_case_of_the_file_is_left_out() {
    let mut profiles: Vec<&str> =
        harness::list("cases").iter().map(|case| case["profile"].as_str().expect("a name")).collect();
    assert_eq!(profiles.len(), 77);
    profiles.dedup();
    let known = [
        "disp_trig",
        "disp_trig_vel",
        "disp_pow",
        "disp_exp_s",
        "disp_exp_vel",
        "disp_sinh",
        "disp_sinh_vel_thesis",
        "disp_tension",
        "disp_line",
        "acc_const",
        "acc_trig",
        "acc_ellipse_quarter",
        "acc_ellipse_semi",
        "vel_line",
        "vel_circle",
        "vel_fairing",
        "quintic",
    ];
    assert_eq!(profiles, known);
}
