//! What all targets share: what is done with whatever a reader lets in, and what must hold then.
//!
//! A target is a file of `fuzz_targets`: it reads, and hands what was read to [`import`], [`figure`] or [`table`], which do
//! what `solaris check` and `solaris inverse` do with it.

mod chosen;
mod figure;
mod files;
mod mutate;
mod recording;
mod table;

pub use chosen::Chosen;
pub use figure::{figure, import};
pub use files::Files;
pub use libfuzzer_sys;
pub use mutate::mutate;
pub use recording::recording;
pub use table::table;

/// A target, of what it does with the bytes.
#[macro_export]
macro_rules! target {
    ($body:expr) => {
        $crate::libfuzzer_sys::fuzz_target!(|bytes: &[u8]| $body(bytes));
        $crate::libfuzzer_sys::fuzz_mutator!(|data: &mut [u8], size: usize, most: usize, seed: u32| {
            $crate::mutate(data, size, most, seed)
        });
    };
}

/// The text that the program makes of a file's bytes; nothing where it refuses them.
pub fn text(bytes: &[u8]) -> Option<String> {
    solaris_io::decode(bytes.to_vec()).ok().map(|(text, _)| text)
}

/// A refusal, which can be shown; it may well name a number that is none.
pub fn refused(error: &dyn std::error::Error) {
    assert!(!error.to_string().is_empty());
}

/// Panics where what is said of something that was let in shows a number that is none, which the file did not have.
pub fn said(text: &str, message: &str) {
    let asked = text.to_lowercase().contains("nan");
    assert!(asked || !has_number(message, "NaN"), "NaN out of nowhere: {message}");
}

/// Whether a word stands in a message by itself. Names stand between quotes, and may be put together of any pieces.
fn has_number(message: &str, word: &str) -> bool {
    let joins = |c: char| c.is_alphanumeric() || "'\"_./".contains(c);
    message.match_indices(word).any(|(at, _)| {
        let (before, after) = (&message[..at], &message[at + word.len()..]);
        !before.ends_with(joins) && !after.starts_with(joins)
    })
}
