//! Keyboard shortcuts, for handling and for the help.

use eframe::egui::{Context, Key, KeyboardShortcut, Modifiers};

use super::App;
use crate::{layout, panels::Pane};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum ShortcutAction {
    Stop,
    Freeze,
    Follow,
    Undo,
    Redo,
    Clear,
    Cursors,
    Rearm,
    Help,
    Previous,
    Next,
    Open(Pane),
}

const CTRL: Modifiers = Modifiers::COMMAND;

const fn plain(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::NONE, key)
}

const fn ctrl(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(CTRL, key)
}

/// Removes all forces: the usual abort key of programs for measurement and control.
const STOP: KeyboardShortcut = ctrl(Key::Period);

/// All shortcuts; those with Shift come first, as they also match without it.
const ALL: [(KeyboardShortcut, ShortcutAction, &str); 21] = [
    (STOP, ShortcutAction::Stop, "STOP: no force on any key, also while somebody types"),
    (KeyboardShortcut::new(CTRL.plus(Modifiers::SHIFT), Key::Z), ShortcutAction::Redo, "redo"),
    (ctrl(Key::Z), ShortcutAction::Undo, "undo"),
    (ctrl(Key::Y), ShortcutAction::Redo, "redo"),
    (plain(Key::Space), ShortcutAction::Freeze, "freeze, go on"),
    (plain(Key::F), ShortcutAction::Follow, "follow what comes"),
    (plain(Key::C), ShortcutAction::Cursors, "cursors of the scope"),
    (plain(Key::R), ShortcutAction::Rearm, "arm the trigger again"),
    (plain(Key::ArrowLeft), ShortcutAction::Previous, "select the key below"),
    (plain(Key::ArrowRight), ShortcutAction::Next, "select the key above"),
    (ctrl(Key::K), ShortcutAction::Clear, "clear what was recorded here"),
    (plain(Key::F1), ShortcutAction::Help, "this help"),
    (ctrl(Key::Num1), ShortcutAction::Open(Pane::Overview), "keys"),
    (ctrl(Key::Num2), ShortcutAction::Open(Pane::Scope(0)), "scope"),
    (ctrl(Key::Num3), ShortcutAction::Open(Pane::Mechanism), "mechanism"),
    (ctrl(Key::Num4), ShortcutAction::Open(Pane::Phase), "force and travel"),
    (ctrl(Key::Num5), ShortcutAction::Open(Pane::Tuning), "tuning"),
    (ctrl(Key::Num6), ShortcutAction::Open(Pane::Instruments), "instruments"),
    (ctrl(Key::Num7), ShortcutAction::Open(Pane::Deadlines), "deadlines"),
    (ctrl(Key::Num8), ShortcutAction::Open(Pane::Links), "links"),
    (ctrl(Key::Num9), ShortcutAction::Open(Pane::Keyboard), "keyboard"),
];

pub(super) fn list(ctx: &Context) -> Vec<(String, &'static str)> {
    ALL.iter().map(|(shortcut, _, text)| (ctx.format_shortcut(shortcut), *text)).collect()
}

pub(super) fn stop(ctx: &Context) -> String {
    ctx.format_shortcut(&STOP)
}

/// Performs the pressed shortcuts; only Stop while a text is typed.
pub(super) fn handle(ctx: &Context, app: &mut App) {
    let types = ctx.egui_wants_keyboard_input();
    for (shortcut, action, _) in ALL {
        let is_plain = shortcut.modifiers == Modifiers::NONE;
        // The computer keyboard plays notes while it is a piano.
        let is_taken = is_plain && app.panels.takes_letters() && shortcut.logical_key != Key::F1;
        let is_heard = action == ShortcutAction::Stop || (!types && !is_taken);
        if is_heard && ctx.input_mut(|input| input.consume_shortcut(&shortcut)) {
            perform(action, app);
        }
    }
}

fn perform(action: ShortcutAction, app: &mut App) {
    let state = &mut app.state;
    let selected = state.view.selected;
    match action {
        ShortcutAction::Stop => state.stop(),
        ShortcutAction::Freeze => state.toggle_freeze(),
        ShortcutAction::Follow => state.follow(),
        ShortcutAction::Undo => state.undo(),
        ShortcutAction::Redo => state.redo(),
        ShortcutAction::Clear => state.store.clear(),
        ShortcutAction::Help => state.view.shows_help = !state.view.shows_help,
        ShortcutAction::Previous => state.select(selected.saturating_sub(1)),
        ShortcutAction::Next => state.select(selected.saturating_add(1)),
        ShortcutAction::Open(pane) => layout::open(&mut app.layout, pane),
        ShortcutAction::Rearm => {
            state.view.scopes.values_mut().for_each(|scope| scope.armed.rearm());
        }
        ShortcutAction::Cursors => {
            let now = state.now();
            for scope in state.view.scopes.values_mut() {
                scope.has_cursors = !scope.has_cursors;
                scope.place_cursors(now);
            }
        }
    }
}
