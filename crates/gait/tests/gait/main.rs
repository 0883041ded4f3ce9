//! What walks are held against: closed forms, golden numbers, the thesis's tables, and laws that every walk keeps.
#![allow(clippy::print_stdout, reason = "tests print what they measured")]

mod anywhere;
mod asked;
mod changes;
mod changes_random;
mod comparison;
mod curves;
mod driven;
mod everyone;
mod five_determinants;
mod five_determinants_automatic;
mod five_determinants_closure;
mod five_determinants_tables;
mod flexion;
mod footfall;
mod footholds;
mod froude;
mod golden;
mod golden_slopes;
mod golden_stride;
mod golden_walk;
mod ground;
mod initiation;
mod isolated_peaks;
mod layers;
mod leg_closed_forms;
mod live;
mod live_random;

mod long_walk;
mod manners;
mod metrics;
mod mirror;
mod options;
mod people;
mod posed;
mod random;
mod refusals;
#[cfg(feature = "serde")]
mod reports;
mod running;
mod running_changes;
mod sequence;
mod smooth_laws;
mod stride_loop;
mod support;
mod sweep;
mod terrain;
mod terrain_random;
mod thesis;
mod thesis_random;
mod thesis_refusals;
mod thesis_requests;
mod three_determinants;
mod three_determinants_closure;
mod three_determinants_laws;
