//! Boards and links: what was planned beside what is seen, and which board is which.

use std::collections::BTreeMap;

use eframe::egui::{Color32, Grid, RichText, ScrollArea, Ui};
use telemetry::{Board, Line, Links};

use super::{nothing_ui, share_ui};
use crate::desk::AppState;
use crate::{look, names, number, unit};

/// Above this a line has no room for what goes wrong.
const FULL: f64 = 0.85;

/// So many times what was planned is worth a look.
const MORE: f64 = 1.1;

/// A column: its name, its unit, and what somebody is told who points at it.
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
    ("light", "", "Lets the board show its light; beside it what the host answered."),
    ("keys", "", "The keys that it moves."),
    ("line", "", "Where it is connected."),
    ("round trip", "µs", "From a request to its answer."),
    ("samples", "frames", "Frames of samples that came, since the start."),
    ("gaps", "times", "The numbers of its samples jumped, since the start."),
    ("refused", "frames", "Frames of a wrong length or content, since the start."),
    ("armed", "times", "It is armed once; more often if it was lost in between."),
    ("state", "", "What the board says of itself."),
];

/// What became of a board's light.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum Light {
    /// It was asked for, and nobody has answered yet.
    Asked,
    /// What the host answered, in a sentence.
    Answered(Result<String, String>),
}

/// What the panel remembers.
#[derive(Clone, Debug, Default)]
pub(crate) struct View {
    /// Lights that somebody asked for, by line and board.
    pub(crate) lights: BTreeMap<(u32, u32), Light>,
}

/// Draws the panel.
pub(super) fn links_ui(ui: &mut Ui, desk: &mut AppState) {
    let Some(links) = desk.store.links.clone() else {
        nothing_ui(ui, "Lines and boards are told once a second, where there are any.");
        return;
    };
    ScrollArea::both().auto_shrink(false).show(ui, |ui| {
        ui.strong("Lines");
        table("lines", &LINES).show(ui, |ui| {
            heads_ui(ui, &LINES);
            for line in &links.lines {
                line_ui(ui, line);
                ui.end_row();
            }
        });
        ui.add_space(8.0);
        ui.strong("Boards");
        table("boards", &BOARDS).show(ui, |ui| {
            heads_ui(ui, &BOARDS);
            for board in &links.boards {
                board_ui(ui, desk, &links, board);
                ui.end_row();
            }
        });
    });
}

fn table(name: &str, columns: &[ColumnHeader]) -> Grid {
    Grid::new(name).num_columns(columns.len()).striped(true).spacing([10.0, 4.0])
}

fn heads_ui(ui: &mut Ui, columns: &[ColumnHeader]) {
    for (name, unit, what) in columns {
        // The unit below the name keeps the columns narrow.
        ui.weak(format!("{name}\n{}", unit::bracketed(unit))).on_hover_text(*what);
    }
    ui.end_row();
}

fn line_ui(ui: &mut Ui, line: &Line) {
    ui.label(&line.name);
    share_ui(ui, line.planned, look::BLUE);
    share_ui(ui, line.seen, load_color(line));
    for count in [line.corrupt, line.foreign, line.dropped] {
        count_ui(ui, count, 0);
    }
    ui.label(&line.state);
}

fn load_color(line: &Line) -> Color32 {
    if FULL < line.seen {
        look::VERMILLION
    } else if MORE * line.planned < line.seen {
        look::ORANGE
    } else {
        look::GREEN
    }
}

fn board_ui(ui: &mut Ui, desk: &mut AppState, links: &Links, board: &Board) {
    let line = line_name(links, board.line);
    ui.label(board.id.to_string());
    light_ui(ui, desk, board, &line);
    ui.label(keys(board));
    ui.label(&line);
    let is_known = board.round_trip.is_finite() && 0.0 < board.round_trip;
    ui.label(if is_known { format!("{:.0}", board.round_trip) } else { "–".to_owned() });
    ui.label(board.samples.to_string());
    count_ui(ui, board.gaps, 0);
    count_ui(ui, board.refused, 0);
    count_ui(ui, board.armings, 1);
    ui.label(&board.state);
}

/// The line's name; its number where it has none.
fn line_name(links: &Links, line: u32) -> String {
    let named = usize::try_from(line).ok().and_then(|line| links.lines.get(line));
    named.map_or_else(|| line.to_string(), |line| line.name.clone())
}

/// Which board is it? Its light says so, and the host's answer stands beside.
fn light_ui(ui: &mut Ui, desk: &mut AppState, board: &Board, line: &str) {
    ui.horizontal(|ui| {
        let button = ui.small_button("Identify");
        let button = button.accessible_name(format!("Identify board {} of {line}", board.id));
        if button.clicked() {
            desk.identify(board.line, board.id);
        }
        match desk.views.links.lights.get(&(board.line, board.id)) {
            None => {}
            Some(Light::Asked) => {
                ui.weak("…");
            }
            Some(Light::Answered(Ok(text))) => {
                ui.label(RichText::new(text).small());
            }
            Some(Light::Answered(Err(text))) => {
                ui.label(RichText::new(text).small().color(look::fault(ui)));
            }
        }
    });
}

fn keys(board: &Board) -> String {
    let last = board.first_key.checked_add(board.keys).and_then(|end| end.checked_sub(1));
    let last = last.filter(|last| board.first_key <= *last).and_then(number::key);
    let range = number::key(board.first_key).zip(last);
    range.map_or_else(|| "–".to_owned(), |(low, high)| names::range_name(&(low..=high)))
}

/// A number that should be no more than `most`.
fn count_ui(ui: &mut Ui, count: u64, most: u64) {
    let text = RichText::new(count.to_string());
    ui.label(if most < count { text.color(look::fault(ui)) } else { text.weak() });
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
