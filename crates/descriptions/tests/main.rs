//! Models that are registered while the program runs, against models that are part of it.

mod ball;
mod catalogue;
mod contact;
mod files;
mod flight;
