use super::quantity::{FINGERS, LoopQuantity, LoopValues};

/// Ratio of the ends from which an axis is logarithmic.
const DECADE: f64 = 10.0;

/// Variable of an axis.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum AxisTarget {
    Quantity(LoopQuantity),
    Parameter(usize),
}

/// An axis: its variable, with its ends.
#[derive(Clone, PartialEq, Debug)]
pub struct MapAxis {
    pub target: AxisTarget,
    pub name: String,
    pub title: String,
    pub unit: String,
    /// Unit in pictures, and its number per unit of the values.
    pub shown: (String, f64),
    pub ends: (f64, f64),
}

impl MapAxis {
    /// Returns the axis of a quantity, between values (SI).
    pub fn of_quantity(quantity: LoopQuantity, ends: (f64, f64)) -> Self {
        let entry = quantity.entry();
        let (unit, per) = entry.shown;
        Self {
            target: AxisTarget::Quantity(quantity),
            name: entry.name.to_owned(),
            title: entry.title.to_owned(),
            unit: entry.unit.to_owned(),
            shown: (unit.to_owned(), per),
            ends,
        }
    }

    /// Returns the names of its values, if they are not numbers.
    pub fn names(&self) -> Option<&'static [&'static str]> {
        (self.target == AxisTarget::Quantity(LoopQuantity::Finger)).then_some(&FINGERS)
    }

    /// Returns `true` if it is logarithmic: between ends of one sign, a decade apart.
    pub fn is_logarithmic(&self) -> bool {
        self.ends.0 > 0.0 && self.ends.1 / self.ends.0 >= DECADE
    }

    /// Returns its number of cells if `wanted` are asked for.
    pub fn cells(&self, wanted: usize) -> usize {
        self.names().map_or(wanted, <[_]>::len)
    }

    pub fn value(&self, part: f64) -> f64 {
        let (low, high) = self.ends;
        if let Some(names) = self.names() {
            let last = names.len() as f64 - 1.0;
            return (part * names.len() as f64 - 0.5).round().clamp(0.0, last);
        }
        if self.is_logarithmic() {
            low * (high / low).powf(part)
        } else {
            low + part * (high - low)
        }
    }

    pub fn part(&self, value: f64) -> f64 {
        let (low, high) = self.ends;
        if let Some(names) = self.names() {
            return (value + 0.5) / names.len() as f64;
        }
        if self.is_logarithmic() {
            (value / low).ln() / (high / low).ln()
        } else {
            (value - low) / (high - low)
        }
    }

    pub fn mistake(&self) -> Option<String> {
        let (low, high) = self.ends;
        let is_range = low.is_finite() && high.is_finite() && low < high;
        let (name, unit) = (&self.name, &self.unit);
        let range = format!("{low} to {high} {unit}");
        (!is_range && self.names().is_none()).then(|| {
            format!(
                "{name} goes from {}, which is no range; give the smaller value first",
                range.trim()
            )
        })
    }
}

/// Values of a loop and of its model: a point of a map.
#[derive(Clone, PartialEq, Debug)]
pub struct LoopPoint {
    pub values: LoopValues,
    /// One value per parameter of the model; empty for a wall.
    pub parameters: Vec<f64>,
}

impl LoopPoint {
    /// Returns this point with another value along `axis`.
    #[must_use]
    pub fn with(mut self, axis: &MapAxis, value: f64) -> Self {
        match axis.target {
            AxisTarget::Quantity(quantity) => self.values.set(quantity, value),
            AxisTarget::Parameter(place) => {
                if let Some(parameter) = self.parameters.get_mut(place) {
                    *parameter = value;
                }
            }
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_over_a_decade_of_one_sign_is_logarithmic() {
        let axis = |ends| MapAxis::of_quantity(LoopQuantity::Stiffness, ends);
        assert!((axis((10.0, 1000.0)).value(0.5) - 100.0).abs() < 1e-9);
        assert!((axis((0.0, 1000.0)).value(0.5) - 500.0).abs() < 1e-9);
        assert!((axis((500.0, 1000.0)).value(0.5) - 750.0).abs() < 1e-9);
        for ends in [(10.0, 1000.0), (-5.0, 1000.0)] {
            let axis = axis(ends);
            assert!((axis.part(axis.value(0.3)) - 0.3).abs() < 1e-12);
        }
        assert!(axis((3.0, 2.0)).mistake().unwrap().contains("3 to 2 N/m"));
        assert!(axis((2.0, 2.0)).mistake().is_some() && axis((1.0, 2.0)).mistake().is_none());
    }

    #[test]
    fn the_axis_of_fingers_has_a_cell_for_each() {
        let axis = MapAxis::of_quantity(LoopQuantity::Finger, (0.0, 3.0));
        let cells = axis.cells(40);
        let value = |cell: usize| axis.value((cell as f64 + 0.5) / cells as f64);
        assert_eq!((cells, [0, 1, 2, 3].map(value)), (4, [0.0, 1.0, 2.0, 3.0]));
        assert!((axis.part(2.0) - 0.625).abs() < 1e-12);
        assert!(axis.value(0.0).abs() < 1e-12 && (axis.value(1.0) - 3.0).abs() < 1e-12);
    }
}
