//! The crate against closed forms and other programs.

mod taylor;
