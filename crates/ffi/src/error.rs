//! What a call came to, and why.

use std::cell::RefCell;
use std::ffi::{CString, c_char};
use std::fmt::Display;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// What a call came to.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// It is done.
    Ok = 0,
    /// An argument is `NULL`, of the wrong length, or not one of those that are known; nothing has changed.
    BadArgument = 1,
    /// What was asked cannot be, and `solaris_last_error` says why and what can; nothing has changed.
    Refused = 2,
    /// A file or text cannot be read.
    Unreadable = 3,
    /// A fault of the library itself.
    Panic = 4,
}

thread_local! {
    static LAST: RefCell<CString> = RefCell::default();
}

/// Why the last call on this thread failed; empty where none has. It stays valid until the next failure on this thread.
#[unsafe(no_mangle)]
pub extern "C" fn solaris_last_error() -> *const c_char {
    LAST.with_borrow(|text| text.as_ptr())
}

/// A failure with its words.
pub(crate) struct Failure(Status, String);

impl Failure {
    pub(crate) fn argument(why: impl Display) -> Self {
        Self(Status::BadArgument, why.to_string())
    }

    pub(crate) fn refused(why: impl Display) -> Self {
        Self(Status::Refused, why.to_string())
    }

    pub(crate) fn unreadable(why: impl Display) -> Self {
        Self(Status::Unreadable, why.to_string())
    }
}

/// Words as C has them: no zero inside.
pub(crate) fn text(words: &str) -> CString {
    CString::new(words.replace('\0', "\u{fffd}")).unwrap_or_default()
}

/// Does what a call asks; what fails is kept for `solaris_last_error`, and no panic goes on.
pub(crate) fn guard(run: impl FnOnce() -> Result<(), Failure>) -> Status {
    let failure = match catch_unwind(AssertUnwindSafe(run)) {
        Ok(Ok(())) => return Status::Ok,
        Ok(Err(failure)) => failure,
        Err(panic) => {
            let words = panic.downcast_ref::<String>().map(String::as_str);
            let words = words.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("no reason");
            Failure(Status::Panic, format!("a fault of the library: {words}"))
        }
    };
    LAST.with_borrow_mut(|last| *last = text(&failure.1));
    failure.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ffi::CStr;
    use std::panic::panic_any;

    #[test]
    fn a_panic_becomes_a_status_with_its_words() {
        let last = || {
            // SAFETY: it is a text that ends, and lives until this thread's next call.
            unsafe { CStr::from_ptr(solaris_last_error()) }.to_str().expect("UTF-8").to_owned()
        };
        assert_eq!(guard(|| panic!("link {} is gone", 7)), Status::Panic);
        assert_eq!(last(), "a fault of the library: link 7 is gone");
        assert_eq!(guard(|| panic!("gone")), Status::Panic);
        assert_eq!(last(), "a fault of the library: gone");
        assert_eq!(guard(|| panic_any(3)), Status::Panic);
        assert_eq!(last(), "a fault of the library: no reason");
        assert_eq!(guard(|| Ok(())), Status::Ok);
    }
}
