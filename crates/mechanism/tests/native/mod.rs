//! Machine code against the tapes that it was made of.

mod bits;
