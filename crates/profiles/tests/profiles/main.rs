//! Curves: their laws, their hard cases, and what stands in between.

mod acceleration_laws;
mod blend_hard;
mod blend_laws;
mod blend_nested;
mod butterworth;
mod clip_laws;
mod curve_laws;
mod cyclic;
mod displacement_hard;
mod displacement_laws;
mod feasible_laws;
mod limited_laws;
mod limits;
mod natural_laws;
mod polynomial_laws;
mod profile;
mod rotation_laws;
mod spline_hard;
mod spline_laws;
mod velocity_hard;
mod velocity_laws;
