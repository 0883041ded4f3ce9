//! A number as a register with one lane, for machines whose vector instructions are not known here.

use super::{Register, Token};

/// No instructions but those that the program was built for.
#[derive(Clone, Copy)]
pub(in crate::batch) struct Plain(());

impl Token for Plain {
    fn new() -> Option<Self> {
        Some(Self(()))
    }

    fn run<A>(self, f: impl FnOnce() -> A) -> A {
        f()
    }
}

/// One precision.
macro_rules! one_lane {
    ($lane:ident) => {
        impl Register for $lane {
            type Token = Plain;
            type Lane = Self;

            const LANES: usize = 1;

            fn lanes(&self) -> &[Self] {
                std::slice::from_ref(self)
            }

            fn lanes_mut(&mut self) -> &mut [Self] {
                std::slice::from_mut(self)
            }

            fn transposed(square: &[Self]) -> impl AsRef<[Self]> + use<> {
                [square[0]]
            }
        }
    };
}
one_lane!(f64);
one_lane!(f32);
