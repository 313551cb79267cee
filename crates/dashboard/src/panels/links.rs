//! Boards and links: the plan beside the measurement, and lights to identify boards.

use std::borrow::Cow;

use eframe::egui::{Button, Color32, Grid, Label, RichText, ScrollArea, Ui};
use serde::{Deserialize, Serialize};
use telemetry::{Board, Line, Links, Severity};

use super::{nothing_ui, share_ui};
use crate::app_state::{AppState, LightState};
use crate::{names, number, theme, unit};

/// Share of a line above which it has no room left for retries.
const FULL: f64 = 0.85;

/// Ratio of measured to planned load above which it is marked.
const MORE: f64 = 1.1;

/// A column: name, unit, and text under the pointer.
type ColumnHeader = (&'static str, &'static str, &'static str);

const LINES: [ColumnHeader; 7] = [
    ("line", "", "A serial port or CAN interface."),
    ("planned", "%", "Load by the plan, as a share of what the line can carry."),
    ("seen", "%", "Load in the last second, as a share of what the line can carry."),
    ("corrupt", "count", "What came and was no frame, since the start."),
    ("foreign", "frames", "Of no board that is known, or none that boards send, since the start."),
    ("dropped", "frames", "Found no room on the line, since the start."),
    ("state", "", "What became of the line."),
];

const BOARDS: [ColumnHeader; 10] = [
    ("board", "", "Its number."),
    ("state", "", "What the board says of itself."),
    ("light", "", "Lets the board show its light; beside it what the host answered."),
    ("keys", "", "The keys that it moves."),
    ("line", "", "Where it is connected."),
    ("round trip", "µs", "From a request to its answer."),
    ("samples", "frames", "Frames of samples that came, since the start."),
    ("gaps", "times", "The numbers of its samples jumped, since the start."),
    ("refused", "frames", "Frames of a wrong length or content, since the start."),
    ("armed", "times", "It is armed once; more often if it was lost in between."),
];

#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(super) struct View;

impl super::View for View {
    fn ui(&mut self, ui: &mut Ui, state: &mut AppState) {
        let Some(links) = &state.store.links else {
            nothing_ui(ui, state, "This host has simulated keys: there are no lines and boards.");
            return;
        };
        let area = ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
            troubles_ui(ui, links);
            ScrollArea::horizontal().show(ui, |ui| tables_ui(ui, state, links)).inner
        });
        if let Some(board) = area.inner {
            let (line, board) = (board.line, board.id);
            state.identify(line, board);
        }
    }
}

fn troubles_ui(ui: &mut Ui, links: &Links) {
    for board in links.boards.iter().filter(|it| it.severity() != Severity::Well) {
        let line = line_name(links, board.line);
        let text = format!("board {} on {line}, {}: {}", board.id, keys(board), board.state);
        let color = theme::severity(board.severity(), ui);
        ui.add(Label::new(RichText::new(text).color(color)).wrap());
    }
}

fn tables_ui<'a>(ui: &mut Ui, state: &AppState, links: &'a Links) -> Option<&'a Board> {
    ui.strong("Lines");
    table("lines", &LINES).show(ui, |ui| {
        header_ui(ui, &LINES);
        for line in &links.lines {
            line_ui(ui, line);
            ui.end_row();
        }
    });
    ui.add_space(8.0);
    ui.strong("Boards");
    table("boards", &BOARDS).show(ui, |ui| boards_ui(ui, state, links)).inner
}

fn boards_ui<'a>(ui: &mut Ui, state: &AppState, links: &'a Links) -> Option<&'a Board> {
    header_ui(ui, &BOARDS);
    let mut asked = None;
    for board in &links.boards {
        if board_ui(ui, state, links, board) {
            asked = Some(board);
        }
        ui.end_row();
    }
    asked
}

fn table(name: &str, columns: &[ColumnHeader]) -> Grid {
    Grid::new(name).num_columns(columns.len()).striped(true).spacing([10.0, 4.0])
}

fn header_ui(ui: &mut Ui, columns: &[ColumnHeader]) {
    for (name, unit, what) in columns {
        // The unit below the name keeps the columns narrow.
        ui.weak(format!("{name}\n{}", unit::bracketed(unit))).on_hover_text(*what);
    }
    ui.end_row();
}

fn line_ui(ui: &mut Ui, line: &Line) {
    ui.label(&line.name);
    share_ui(ui, line.planned, theme::BLUE);
    share_ui(ui, line.seen, load_color(line));
    for count in [line.corrupt, line.foreign, line.dropped] {
        count_ui(ui, count, 0);
    }
    ui.label(&line.state);
}

fn load_color(line: &Line) -> Color32 {
    if FULL < line.seen {
        theme::VERMILLION
    } else if MORE * line.planned < line.seen {
        theme::ORANGE
    } else {
        theme::GREEN
    }
}

fn board_ui(ui: &mut Ui, state: &AppState, links: &Links, board: &Board) -> bool {
    let line = line_name(links, board.line);
    ui.label(board.id.to_string());
    // The whole state is above the table.
    let state_name = board.state.split([';', ':']).next().unwrap_or_default();
    ui.colored_label(theme::severity(board.severity(), ui), state_name);
    let is_asked = light_ui(ui, state, board, &line);
    ui.label(keys(board));
    ui.label(&*line);
    let is_known = board.round_trip.is_finite() && 0.0 < board.round_trip;
    ui.label(if is_known { format!("{:.0}", board.round_trip) } else { "–".to_owned() });
    ui.label(board.samples.to_string());
    count_ui(ui, board.gaps, 0);
    count_ui(ui, board.refused, 0);
    count_ui(ui, board.armings, 1);
    is_asked
}

fn line_name(links: &Links, line: u32) -> Cow<'_, str> {
    let named = usize::try_from(line).ok().and_then(|line| links.lines.get(line));
    named.map_or_else(|| line.to_string().into(), |line| line.name.as_str().into())
}

fn light_ui(ui: &mut Ui, state: &AppState, board: &Board, line: &str) -> bool {
    ui.horizontal(|ui| {
        let button = ui.add_enabled(state.may_change(), Button::new("Identify").small());
        let button = button.accessible_name(format!("Identify board {} of {line}", board.id));
        match state.light(board.line, board.id) {
            None => {}
            Some(LightState::Asked) => {
                ui.weak("…");
            }
            Some(LightState::Answered(Ok(text))) => {
                ui.label(RichText::new(text).small());
            }
            Some(LightState::Answered(Err(text))) => {
                ui.label(RichText::new(text).small().color(theme::fault(ui)));
            }
        }
        button.clicked()
    })
    .inner
}

fn keys(board: &Board) -> String {
    let last = board.first_key.checked_add(board.keys).and_then(|end| end.checked_sub(1));
    let last = last.filter(|last| board.first_key <= *last).and_then(number::key);
    let range = number::key(board.first_key).zip(last);
    range.map_or_else(|| "–".to_owned(), |(low, high)| names::range_name(&(low..=high)))
}

fn count_ui(ui: &mut Ui, count: u64, most: u64) {
    let text = RichText::new(count.to_string());
    ui.label(if most < count { text.color(theme::fault(ui)) } else { text.weak() });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_board_of_foreign_numbers_has_no_keys() {
        let board = |first_key, keys| Board { first_key, keys, ..Board::default() };
        assert_eq!(keys(&board(0, 12)), "A0..G#1");
        assert_eq!(keys(&board(87, 1)), "C8");
        for foreign in [board(0, 0), board(80, 12), board(u32::MAX, 1), board(5, u32::MAX)] {
            assert_eq!(keys(&foreign), "–");
        }
    }
}
