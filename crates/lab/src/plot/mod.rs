//! Pictures as SVG text, for every study that draws one.
//!
//! [`canvas`] lines, areas and text at places in pixels, [`color`] the colours that they share,
//! [`chart`] curves over one pair of axes,
//! [`axis`] linear and logarithmic axes with their round numbers, [`edge`] how an axis is drawn
//! at a side of its panel, [`legend`] which curve is what. What is drawn stands in `report` and
//! `simulate`.

pub mod axis;
pub mod canvas;
pub mod chart;
pub mod color;
pub mod edge;
pub mod legend;
