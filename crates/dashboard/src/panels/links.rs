//! Boards and links: what was planned beside what is seen.

use eframe::egui::{Grid, ScrollArea, Ui};
use telemetry::{Board, Line, Request};

use super::{nothing_ui, share_ui};
use crate::desk::Desk;
use crate::{look, names, number};

/// Above this a line has no room for what goes wrong.
const FULL: f64 = 0.85;

/// Draws the panel.
pub(super) fn links_ui(ui: &mut Ui, desk: &mut Desk) {
    let Some(links) = desk.store.links.clone() else {
        nothing_ui(ui, "Nothing is known of links yet.");
        return;
    };
    ScrollArea::both().auto_shrink(false).show(ui, |ui| {
        ui.strong("Lines");
        Grid::new("lines").num_columns(7).striped(true).spacing([14.0, 4.0]).show(ui, |ui| {
            for head in ["line", "planned", "seen", "corrupt", "foreign", "dropped", "state"] {
                ui.weak(head);
            }
            ui.end_row();
            for line in &links.lines {
                line_ui(ui, line);
                ui.end_row();
            }
        });
        ui.add_space(8.0);
        ui.strong("Boards");
        Grid::new("boards").num_columns(9).striped(true).spacing([14.0, 4.0]).show(ui, |ui| {
            for head in
                ["board", "line", "keys", "", "gaps", "refused", "armings", "round trip", "state"]
            {
                ui.weak(head);
            }
            ui.end_row();
            for board in &links.boards {
                board_ui(ui, desk, board);
                ui.end_row();
            }
        });
    });
}

fn line_ui(ui: &mut Ui, line: &Line) {
    ui.label(&line.name);
    share_ui(ui, line.planned, look::BLUE);
    share_ui(ui, line.seen, if FULL < line.seen { look::VERMILLION } else { look::GREEN });
    for count in [line.corrupt, line.foreign, line.dropped] {
        count_ui(ui, count);
    }
    ui.label(&line.state);
}

fn board_ui(ui: &mut Ui, desk: &mut Desk, board: &Board) {
    ui.label(board.id.to_string());
    ui.label(board.line.to_string());
    ui.label(keys(board));
    if ui.small_button(format!("Identify {}", board.id)).clicked() {
        desk.ask(Request::Identify { line: board.line, board: board.id });
    }
    count_ui(ui, board.gaps);
    count_ui(ui, board.refused);
    if 1 < board.armings {
        ui.colored_label(look::fault(ui), board.armings.to_string());
    } else {
        ui.label(board.armings.to_string());
    }
    ui.label(format!("{:.0} µs", board.round_trip));
    ui.label(&board.state);
}

fn keys(board: &Board) -> String {
    let last = (board.first_key + board.keys).checked_sub(1);
    let range = number::key(board.first_key).zip(last.and_then(number::key));
    range.map_or_else(|| "–".to_owned(), |(low, high)| names::range_name(&(low..=high)))
}

/// A number that should be none.
fn count_ui(ui: &mut Ui, count: u64) {
    if count == 0 {
        ui.weak("0");
    } else {
        ui.colored_label(look::fault(ui), count.to_string());
    }
}
