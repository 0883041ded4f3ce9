//! One leg in closed form: on the ground, as the hip passes over it, and in the air.

pub(crate) mod jet;
pub(crate) mod midstance;
pub(crate) mod numbers;
pub(crate) mod path;
pub(crate) mod push;
pub(crate) mod sole;
pub(crate) mod stance;
pub(crate) mod swing;
