//! What a system has that no model can have.

use std::fmt;

use crate::kane::graph::{Place, WorkEnd};

/// Why a system is no program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum AssemblyError {
    /// An expression of a mode, by its name, reads what is no parameter, state or input.
    UnknownSymbol(String, Place),
    TooManyStates(usize),
    TooManyModes(usize),
    TooManyGuards(usize),
    TooManyFunctions(usize),
    GivenUp(WorkEnd),
}

impl fmt::Display for AssemblyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnknownSymbol(mode, place) => {
                write!(f, "an expression of {mode} reads {place:?}, which is not known there")
            }
            Self::TooManyStates(found) => write!(f, "the state has {found} entries, too many"),
            Self::TooManyModes(found) => write!(f, "there are {found} modes, too many"),
            Self::TooManyGuards(found) => write!(f, "there are {found} guards, too many"),
            Self::GivenUp(end) => end.fmt(f),
            Self::TooManyFunctions(found) => {
                write!(f, "there are {found} functions or constants, too many")
            }
        }
    }
}

impl std::error::Error for AssemblyError {}
