#![doc = include_str!("../README.md")]

mod error;
mod finding;
pub mod layout;
mod lex;
mod nearest;
mod node;
mod parse;
mod place;
mod plain;
mod reader;

pub use error::{TextError, TextFault};
pub use finding::{Finding, FindingKind};
pub use nearest::{did_you_mean, nearest};
pub use node::{Content, Group, Named, Node, Value};
pub use parse::{first_word, parse};
pub use place::Place;
pub use plain::{is_unseen, plain};
pub use reader::{Fields, Reader};
