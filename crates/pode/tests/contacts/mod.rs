//! Contacts against closed forms, an independent program and the laws of mechanics.

mod automata;
mod cradle;
mod restitution;
