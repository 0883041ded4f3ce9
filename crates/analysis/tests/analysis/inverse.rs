//! From records to joint forces: laws, closed forms, and measured data where it is present.

mod differentiate;
mod forces;
mod loads;
mod measured;
mod passive;
mod support;
