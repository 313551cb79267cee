use serde::Serialize;

/// A measured figure with its expected range.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct Figure {
    pub name: &'static str,
    pub title: &'static str,
    /// Value; `None` if it does not apply to the instrument.
    pub value: Option<f64>,
    pub low: Option<f64>,
    pub high: Option<f64>,
    /// `true` if the value exists and is in range; `None` if nothing is expected.
    pub pass: Option<bool>,
}

pub(super) const NAMES: [(&str, &str); 35] = [
    ("down_weight_0.5mm_s", "down weight at 0.5 mm/s [gf]"),
    ("down_weight_2mm_s", "down weight at 2 mm/s [gf]"),
    ("down_weight_5mm_s", "down weight at 5 mm/s [gf]"),
    ("down_weight_17mm_s", "down weight at 17 mm/s [gf]"),
    ("up_weight_0.5mm_s", "up weight at 0.5 mm/s [gf]"),
    ("up_weight_2mm_s", "up weight at 2 mm/s [gf]"),
    ("up_weight_5mm_s", "up weight at 5 mm/s [gf]"),
    ("up_weight_17mm_s", "up weight at 17 mm/s [gf]"),
    ("hump_0.5mm_s", "let-off hump at 0.5 mm/s [N]"),
    ("hump_2mm_s", "let-off hump at 2 mm/s [N]"),
    ("hump_5mm_s", "let-off hump at 5 mm/s [N]"),
    ("hump_17mm_s", "let-off hump at 17 mm/s [N]"),
    ("hump_place", "travel at the let-off hump, at 2 mm/s [mm]"),
    ("hump_masked", "hump above what is before it, at 0.5 m/s [N]"),
    ("aftertouch", "travel after the let-off hump, at 2 mm/s [mm]"),
    ("let_off", "let-off: hammer below the string in a slow press [mm]"),
    ("damper_lift", "damper is lifted, of the dip [%]"),
    ("travel_pressed", "travel time, pressed: most outside of the grands, of what is allowed"),
    ("travel_struck", "travel time, struck: the same"),
    ("key_bottom_pressed", "key bottom, pressed: the same"),
    ("key_bottom_struck", "key bottom, struck: the same"),
    ("free_flight_pressed", "free flight, pressed: the same"),
    ("free_flight_struck", "free flight, struck: the same"),
    ("key_bottom_zero", "hammer speed at which key bottom and string come together [m/s]"),
    ("pitch", "travel time at 1 m/s, largest over smallest of the keys [1]"),
    ("gap_soft", "gap of free flight at 0.5 m/s [mm]"),
    ("gap_loud", "gap of free flight at 5 m/s [mm]"),
    ("softest", "softest tone: fastest that the slowest hammer is that reaches the string [m/s]"),
    ("loudest", "loudest tone [m/s]"),
    ("check_lowest", "hammer in check, lowest below the string [mm]"),
    ("check_highest", "hammer in check, highest below the string [mm]"),
    ("second_strikes", "strokes with a second strike, of all keys"),
    ("repetition_third", "quickest repetition from a third of the travel [1/s]"),
    ("repetition_full", "quickest repetition with the key up [1/s]"),
    ("return", "return of the key to 1 mm [ms]"),
];

pub(super) const ENERGY: [(&str, &str); 2] = [
    ("cycle_work", "least work of the finger over a closed cycle [mJ]"),
    ("energy_residual", "energy made by the integration, of the work [1]"),
];

#[derive(Clone, Debug, Default)]
pub(super) struct MeasuredFigures {
    values: Vec<(&'static str, f64)>,
}

impl MeasuredFigures {
    pub(super) fn set(&mut self, name: &'static str, value: f64) {
        self.values.push((name, value));
    }

    pub(super) fn maybe(&mut self, name: &'static str, value: Option<f64>) {
        if let Some(value) = value {
            self.set(name, value);
        }
    }

    pub(super) fn figures(&self, expected: &[(String, (f64, f64))]) -> Vec<Figure> {
        let figure = |(name, title): (&'static str, &'static str)| {
            let value = self.values.iter().find(|it| it.0 == name).map(|it| it.1);
            let limits = expected.iter().find(|it| it.0 == name).map(|it| it.1);
            let within = |(low, high): (f64, f64)| value.is_some_and(|it| low <= it && it <= high);
            Figure {
                name,
                title,
                value,
                low: limits.map(|it| it.0),
                high: limits.map(|it| it.1),
                pass: limits.map(within),
            }
        };
        NAMES.into_iter().chain(ENERGY).map(figure).collect()
    }
}

pub fn figure_names() -> impl Iterator<Item = &'static str> + Clone {
    NAMES.into_iter().chain(ENERGY).map(|(name, _)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_figure_passes_within_its_limits_and_not_without_a_value() {
        let mut measured = MeasuredFigures::default();
        measured.set("softest", 0.21);
        let expected =
            [("softest".to_owned(), (0.15, 0.2)), ("loudest".to_owned(), (6.0, f64::INFINITY))];
        let figures = measured.figures(&expected);
        let of = |name| figures.iter().find(|it| it.name == name).cloned().expect("a figure");
        assert_eq!((of("softest").pass, of("softest").low), (Some(false), Some(0.15)));
        assert_eq!((of("loudest").pass, of("loudest").value), (Some(false), None));
        assert_eq!(of("return").pass, None);
        assert_eq!(figures.len(), figure_names().count());
    }
}
