//! Walks from outside: what a planned, sampled and loaded motion obeys, found with nothing but the figure's data.
//!
//! Kinematics, momentum and forces are worked out here from products of matrices and their derivatives; no planner,
//! kernel or measure of the library takes part in a judgement. Tables of the worst values: `-- --nocapture`.

mod body;
mod broken;
mod cases;
mod criteria;
mod curves;
mod derivatives;
mod examples;
mod figures;
mod grid;
mod lengths;
mod newton;
mod parameters;
mod repeat;
mod roots;
mod torques;
mod worst;
