//! One parameter: name, slider, value to type, reset, lock.

use std::ops::RangeInclusive;

use eframe::egui::{
    Align, Button, DragValue, Label, Layout, RichText, Slider, SliderClamping, Ui, vec2,
};
use telemetry::Parameter;

use crate::store::Store;
use crate::tune::Tuner;
use crate::{theme, unit};

/// Ratio of the range's ends above which the slider is logarithmic.
const DECADES: f64 = 30.0;

/// Ratio between the slider's ends and the usual value.
const REACH: f64 = 8.0;

/// Widths of a parameter's name in one line and in two (points); a longer one is cut.
const NAMES: (f32, f32) = (110.0, 70.0);

/// Width of everything beside the slider in one line (points).
const BESIDE: f32 = 332.0;

/// Width of the shortest slider (points).
const SHORTEST: f32 = 54.0;

/// A parameter of the selected key, as it is shown.
struct ParameterRow<'a> {
    parameter: &'a Parameter,
    value: f64,
    usual: Option<f64>,
    is_changed: bool,
    is_locked: bool,
}

impl<'a> ParameterRow<'a> {
    fn new(
        tuner: &Tuner,
        key: u8,
        (parameter, usual): (&'a Parameter, Option<f64>),
    ) -> Option<Self> {
        let value = tuner.value(key, &parameter.name)?;
        let is_changed = usual.is_some_and(|it| 1e-9 * it.abs().max(1e-9) < (it - value).abs());
        let is_locked = tuner.is_locked(&parameter.name);
        Some(Self { parameter, value, usual, is_changed, is_locked })
    }

    fn label(&self) -> &'a str {
        label(self.parameter)
    }

    fn travel(&self) -> RangeInclusive<f64> {
        travel(self.parameter, self.usual.unwrap_or(self.value))
    }
}

/// Draws a parameter with its usual value in one line, or in two if there is no room; returns the
/// new value if it was moved.
pub(super) fn parameter_ui(
    ui: &mut Ui,
    tuner: &mut Tuner,
    key: u8,
    parameter: (&Parameter, Option<f64>),
) -> Option<f64> {
    let row = ParameterRow::new(tuner, key, parameter)?;
    let room = ui.available_width();
    let is_narrow = room < BESIDE + SHORTEST;
    let mut moved = None;
    ui.horizontal(|ui| {
        name_ui(ui, &row, if is_narrow { NAMES.1 } else { NAMES.0 });
        if !is_narrow {
            moved = moved.or(slider_ui(ui, &row, room - BESIDE));
        }
        moved = moved.or(number_ui(ui, &row)).or(reset_ui(ui, &row));
        if !is_narrow {
            lock_ui(ui, tuner, key, &row);
        }
    });
    if is_narrow {
        ui.horizontal(|ui| {
            moved = moved.or(slider_ui(ui, &row, room - 70.0));
            lock_ui(ui, tuner, key, &row);
        });
    }
    moved
}

fn name_ui(ui: &mut Ui, row: &ParameterRow<'_>, width: f32) {
    let mark = if row.is_changed { theme::ORANGE } else { ui.visuals().text_color() };
    let name = RichText::new(row.label()).color(mark).strong();
    let layout = Layout::left_to_right(Align::Center);
    let name = ui.allocate_ui_with_layout(vec2(width, 18.0), layout, |ui| {
        ui.set_min_width(width);
        ui.add(Label::new(name).truncate())
    });
    let Parameter { name: symbol, doc, .. } = row.parameter;
    name.inner.on_hover_text(format!("{symbol}: {doc}"));
}

fn slider_ui(ui: &mut Ui, row: &ParameterRow<'_>, width: f32) -> Option<f64> {
    let mut value = row.value;
    let travel = row.travel();
    let is_wide = 0.0 < *travel.start() && DECADES < travel.end() / travel.start();
    ui.spacing_mut().slider_width = width.clamp(SHORTEST, 260.0);
    let slider = Slider::new(&mut value, travel).show_value(false).logarithmic(is_wide);
    // A value typed beyond the slider's end stays.
    let slider = slider.clamping(SliderClamping::Edits);
    let slid = ui.add_enabled(!row.is_locked, slider).accessible_name(row.label());
    slid.changed().then_some(value)
}

/// Draws the value as a number to type; returns it if it was changed.
fn number_ui(ui: &mut Ui, row: &ParameterRow<'_>) -> Option<f64> {
    let Parameter { unit, min, max, .. } = row.parameter;
    let mut value = row.value;
    let travel = row.travel();
    let speed = (travel.end() - travel.start()) / 500.0;
    let drag = DragValue::new(&mut value).range(*min..=*max).speed(speed);
    let drag = drag.custom_formatter(|value, _| unit::exact(value)).suffix(unit::suffix(unit));
    let drag = drag.update_while_editing(false);
    let typed = ui.add_enabled_ui(!row.is_locked, |ui| ui.add_sized([92.0, 18.0], drag)).inner;
    let is_changed = typed.accessible_name(format!("{} value", row.label())).changed();
    // An untouched field does not round the value to the digits that it shows.
    (is_changed && unit::exact(value) != unit::exact(row.value)).then_some(value)
}

/// Draws the button that resets the value; returns the instrument's value if clicked.
fn reset_ui(ui: &mut Ui, row: &ParameterRow<'_>) -> Option<f64> {
    let can_go_back = row.is_changed && !row.is_locked;
    let reset = ui.add_enabled(can_go_back, Button::new("Reset").small());
    let reset = reset.accessible_name(format!("reset {}", row.label()));
    let hint = row.usual.map(|it| unit::text(it, &row.parameter.unit)).unwrap_or_default();
    let reset = reset.on_hover_text(format!("As the instrument has it: {hint}"));
    if reset.clicked() { row.usual } else { None }
}

fn lock_ui(ui: &mut Ui, tuner: &mut Tuner, key: u8, row: &ParameterRow<'_>) {
    let name = &row.parameter.name;
    let mut locked = tuner.is_locked(name);
    let lock = ui
        .checkbox(&mut locked, RichText::new("lock").small())
        .accessible_name(format!("lock {}", row.label()));
    if lock.on_hover_text("Locked: nothing changes it.").clicked() {
        tuner.toggle_lock(name);
    }
    if tuner.is_asked(key, name) {
        ui.weak("…");
    }
}

/// Returns the technician's term of a parameter, or else its name.
pub(super) fn label(parameter: &Parameter) -> &str {
    if parameter.title.is_empty() { &parameter.name } else { &parameter.title }
}

/// Returns the range of a slider, near the usual value: a model bears far more than a hand wants.
/// Any value of the parameter's own range can be typed.
fn travel(parameter: &Parameter, usual: f64) -> RangeInclusive<f64> {
    let Parameter { min, max, .. } = *parameter;
    if usual == 0.0 || !usual.is_finite() {
        return min.max(-1.0)..=max.min(1.0).max(min);
    }
    let (near, far) = (usual / REACH, usual * REACH);
    // Ratios have near ends of their own.
    let low = if max <= 1.0 && 0.0 <= min { min } else { near.min(far).max(min) };
    low..=near.max(far).min(max)
}

pub(super) fn usual(store: &Store, key: u8, name: &str) -> Option<f64> {
    let voice = store.voice(key)?;
    let values = store.instrument_values(&voice.instrument, key)?;
    let i = store.parameters(key).iter().position(|it| it.name == name)?;
    values.get(i).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slider_stays_near_what_is_usual() {
        let parameter = |min: f64, max: f64| Parameter { min, max, ..Parameter::default() };
        let is = |(min, max): (f64, f64), usual: f64, wanted: (f64, f64)| {
            let travel = travel(&parameter(min, max), usual);
            let is_near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs();
            let is_it = is_near(*travel.start(), wanted.0) && is_near(*travel.end(), wanted.1);
            assert!(is_it, "{min}..{max} around {usual}: {travel:?}");
        };
        is((-100.0, 100.0), 0.125, (0.125 / 8.0, 1.0));
        is((-100.0, 100.0), -0.5, (-4.0, -0.0625));
        is((0.0, 10.0), 5.0, (0.625, 10.0));
        is((0.0, 1.0), 0.1, (0.0, 0.8));
        is((-100.0, 100.0), 0.0, (-1.0, 1.0));
    }
}
