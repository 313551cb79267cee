//! The models of the program against what every model promises.

mod conformance;
mod drawing;
mod drawing_to_scale;
mod equations;
mod every_model;
mod random;
mod sketch;
mod stroke;
