#![doc = include_str!("../README.md")]

mod edit;
mod error;
mod expected;
mod finding;
pub mod layout;
mod lex;
mod nearest;
mod node;
mod parse;
mod place;
mod plain;
mod reader;

pub use edit::edit;
pub use error::{Fault, Suggestion, TextError, TextFault};
pub use expected::{Expected, ExpectedKind};
pub use finding::{Finding, FindingKind};
pub use nearest::{did_you_mean, nearest};
pub use node::{Content, Group, Named, Node, Value};
pub use parse::{first_word, parse};
pub use place::Place;
pub use plain::{is_unseen, plain};
pub use reader::{Fields, Reader};
