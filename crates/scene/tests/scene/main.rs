//! Scenes as texts: what they come to, and what is refused and how.

mod apart;
mod completion;
mod faults;
mod faults_words;
mod fixtures;
mod grammar;
mod limits;
mod looks;
mod motors;
mod runs;
mod several;
mod soles;
mod ties;
mod walkers;
mod walks;
mod words;
