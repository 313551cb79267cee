//! Models from tables whose functions are written by hand, against closed forms.

mod model;
mod swing;
