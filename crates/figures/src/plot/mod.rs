//! Pictures as SVG text, for every study that draws one.
//!
//! [`picture`] is what studies make: panels of curves, areas and rules, with a legend. Below it,
//! [`axis`] has linear and logarithmic axes with their round numbers, [`edge`] an axis at a side of
//! its panel, [`level`] two axes with one zero, [`marker`] marks of points, [`color`] the colours
//! that pictures share, and [`canvas`] lines, areas and text at places in pixels.

pub mod axis;
pub mod canvas;
pub mod color;
pub mod edge;
pub mod level;
pub mod marker;
pub mod picture;
