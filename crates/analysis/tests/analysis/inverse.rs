//! From records to joint forces: laws, closed forms, and measured data where it is present.

mod complete;
mod inverse;
mod loads;
mod measured;
mod passive;
mod support;
