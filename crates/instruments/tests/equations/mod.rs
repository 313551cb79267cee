//! Models from tables with functions written by hand, against closed forms.

mod model;
mod swing;
