//! One parameter: name, slider, value to type, reset, lock.

use eframe::egui::text::{CCursor, CCursorRange};
use eframe::egui::text_edit::TextEditState;
use eframe::egui::{
    Align, Button, Event, Key, Label, Layout, Modifiers, MouseWheelUnit, Response, RichText,
    Slider, SliderClamping, Stroke, StrokeKind, TextEdit, Ui, Vec2, accesskit, vec2,
};
use telemetry::Parameter;

use crate::{names, number, theme, tune::Tuner, unit};

/// Steps from the usual value to each end of a slider: on the shortest slider one point is less
/// than a step, and 2.5 mm of let-off or a quarter of a stiffness is more than a hand wants. Other
/// values can be typed.
const REACH: f64 = 25.0;

/// Part of a step that keys, wheel and slider move with Shift.
const FINE: f64 = 0.1;

/// Points of a smooth wheel for one step.
const POINTS: f64 = 40.0;

/// Widths of a parameter's name in one line and in two (points); a longer one is cut.
const NAMES: (f32, f32) = (110.0, 70.0);

/// Width of everything beside the slider in one line (points).
const BESIDE: f32 = 332.0;

/// Width of the shortest slider (points).
const SHORTEST: f32 = 54.0;

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
        names::title(self.parameter)
    }
}

/// Draws a parameter and its usual value in one or two lines; returns a moved value.
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
        moved = moved.or(number_ui(ui, key, &row)).or(reset_ui(ui, &row));
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

/// Draws the slider; returns the new value if it was moved. A drag moves the value from where it
/// is, so that a click moves nothing.
fn slider_ui(ui: &mut Ui, row: &ParameterRow<'_>, width: f32) -> Option<f64> {
    let reading = unit::of(row.parameter);
    let fine = if ui.input(|input| input.modifiers.shift) { FINE } else { 1.0 };
    let around = reading.around(row.usual.unwrap_or(row.value), REACH);
    let width = width.clamp(SHORTEST, 260.0);
    ui.spacing_mut().slider_width = width;
    let (shown, mut asked) = (reading.number(row.value), None);
    // Keys and screen readers ask for numbers; the pointer's position is not used.
    let slider = Slider::from_get_set(around.clone(), |number| {
        asked = number.or(asked);
        shown
    });
    let slider = slider.show_value(false).step_by(fine * reading.step());
    let slider = slider.smart_aim(false).clamping(SliderClamping::Edits);
    let slid = ui.add_enabled(!row.is_locked, slider).accessible_name(row.label());
    let moved = if slid.interact_pointer_pos().is_some() {
        let per_point = (around.end() - around.start()) / f64::from(width);
        let way = fine * per_point * f64::from(slid.drag_delta().x) / reading.step();
        let id = slid.id.with("way");
        // Parts of a step add up over the frames of a drag.
        let sum = way + ui.data(|data| data.get_temp::<f64>(id)).unwrap_or(0.0);
        let whole = (sum / fine).round() * fine;
        let rest = if slid.drag_stopped() { 0.0 } else { sum - whole };
        ui.data_mut(|data| data.insert_temp(id, rest));
        let [low, high] = [around.start(), around.end()].map(|it| (it - shown) / reading.step());
        Some(whole.clamp(low.min(0.0), high.max(0.0)))
    } else {
        asked.map(|it| (it - shown) / reading.step())
    };
    let moved = moved.filter(|it| *it != 0.0).map(|it| reading.moved(row.value, it));
    moved.filter(|it| it.to_bits() != row.value.to_bits())
}

#[derive(Clone, Debug, Default)]
struct TypedText {
    text: Option<String>,
    refusal: Option<String>,
    is_new: bool,
}

/// Draws the value as a number to type; returns a change. A refused text stays, with the reason.
fn number_ui(ui: &mut Ui, key: u8, row: &ParameterRow<'_>) -> Option<f64> {
    let reading = unit::of(row.parameter);
    let id = ui.make_persistent_id((&row.parameter.name, key));
    let mut typed: TypedText = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let shown = reading.text(row.value);
    let has_focus = ui.memory(|memory| memory.has_focus(id));
    let steps = if has_focus { arrow_steps(ui) } else { 0.0 };
    let mut text = typed.text.clone().unwrap_or_else(|| shown.clone());
    let edit = TextEdit::singleline(&mut text)
        .id(id)
        .text_color_opt(typed.refusal.as_ref().map(|_| theme::fault(ui)));
    let field = ui.add_enabled_ui(!row.is_locked, |ui| ui.add_sized([92.0, 18.0], edit)).inner;
    let field = field.accessible_name(format!("{} value", row.label()));
    select_all(ui, &field, &mut typed, text.chars().count());
    if field.changed() {
        typed = TypedText { text: Some(text), ..typed };
        typed.refusal = None;
    }
    let wheel = if has_focus && field.hovered() { wheel_steps(ui) } else { 0.0 };
    let mut moved = None;
    if steps + wheel != 0.0 {
        typed = TypedText::default();
        moved = Some(reading.moved(row.value, steps + wheel));
    } else if field.lost_focus() {
        let is_restored = ui.input(|input| input.key_pressed(Key::Escape));
        let text = typed.text.take().filter(|it| !is_restored && it.trim() != shown);
        (moved, typed) = match text.map(|text| (reading.parse(&text), text)) {
            None => (None, TypedText::default()),
            Some((Ok(value), _)) => (Some(value), TypedText::default()),
            Some((Err(why), text)) => {
                (None, TypedText { text: Some(text), refusal: Some(why), is_new: false })
            }
        };
    }
    if let Some(why) = &typed.refusal {
        let stroke = Stroke::new(1.0, theme::fault(ui));
        ui.painter().rect_stroke(field.rect, 2.0, stroke, StrokeKind::Outside);
        ui.ctx().accesskit_node_builder(id, |node| {
            node.set_description(why.as_str());
            node.set_invalid(accesskit::Invalid::True);
        });
        field.on_hover_text(why);
    }
    ui.data_mut(|data| data.insert_temp(id, typed));
    // An untouched field does not round the value to the digits that it shows.
    moved.filter(|it| it.to_bits() != row.value.to_bits())
}

/// Selects the text of a field that got the focus, so that typing replaces it.
fn select_all(ui: &Ui, field: &Response, typed: &mut TypedText, len: usize) {
    typed.is_new |= field.gained_focus();
    let is_held = ui.input(|input| input.pointer.any_down());
    if typed.is_new && !is_held {
        typed.is_new = false;
        if let Some(mut state) = TextEditState::load(ui.ctx(), field.id) {
            let all = CCursorRange::two(CCursor::new(0), CCursor::new(len));
            state.cursor.set_char_range(Some(all));
            state.store(ui.ctx(), field.id);
        }
    }
}

/// Returns the steps of the pressed arrow keys, which no other widget sees.
fn arrow_steps(ui: &Ui) -> f64 {
    ui.input_mut(|input| {
        let mut count = |key| number::f64(input.count_and_consume_key(Modifiers::NONE, key));
        let steps = count(Key::ArrowUp) - count(Key::ArrowDown);
        if input.modifiers.shift { FINE * steps } else { steps }
    })
}

/// Returns the steps of the mouse wheel, which scrolls nothing then.
fn wheel_steps(ui: &Ui) -> f64 {
    ui.input_mut(|input| {
        let lines = |event: &Event| {
            let Event::MouseWheel { unit, delta, .. } = event else { return 0.0 };
            // With Shift, a wheel may turn sideways.
            let turned = f64::from(delta.x + delta.y);
            if *unit == MouseWheelUnit::Point { turned / POINTS } else { turned }
        };
        let steps: f64 = input.events.iter().map(lines).sum();
        input.smooth_scroll_delta = Vec2::ZERO;
        if input.modifiers.shift { FINE * steps } else { steps }
    })
}

fn reset_ui(ui: &mut Ui, row: &ParameterRow<'_>) -> Option<f64> {
    let can_go_back = row.is_changed && !row.is_locked;
    let reset = ui.add_enabled(can_go_back, Button::new("Reset").small());
    let reset = reset.accessible_name(format!("reset {}", row.label()));
    let hint = row.usual.map(|it| unit::of(row.parameter).text(it)).unwrap_or_default();
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
