//! Pictures as SVG text.
//!
//! Studies build a [`picture`]: panels of curves, areas and rules, with a legend. It uses [`axis`]
//! for round numbers, [`edge`] for an axis at a side of its panel, [`level`] for two axes with one
//! zero, [`marker`], [`color`] and [`canvas`].

pub mod axis;
pub mod canvas;
pub mod color;
pub mod edge;
pub mod level;
pub mod marker;
pub mod picture;
