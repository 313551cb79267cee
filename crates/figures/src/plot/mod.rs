//! Pictures as SVG text.
//!
//! Studies build a [`picture`] of panels of curves, areas and rules, with a legend. It uses
//! [`axis`], [`edge`], [`level`], [`marker`], [`color`] and [`canvas`].

pub mod axis;
pub mod canvas;
pub mod color;
pub mod edge;
pub mod level;
pub mod marker;
pub mod picture;
