//! The skin of people of all sizes, by laws that any closed surface obeys; of machines, by their shapes' own volumes.

mod hands;
mod links;
mod motion;
mod people;
