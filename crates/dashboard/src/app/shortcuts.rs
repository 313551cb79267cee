//! What the keyboard does, once for heeding it and once for the help.

use eframe::egui::{Context, Key, KeyboardShortcut, Modifiers};

use super::App;
use crate::layout::{self, Pane};

/// What a shortcut does.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Deed {
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

/// Takes all forces away: what aborts a run in other programs for measuring and control.
const STOP: KeyboardShortcut = ctrl(Key::Period);

/// Every shortcut; the longer ones first, as one with Shift is also one without.
const ALL: [(KeyboardShortcut, Deed, &str); 21] = [
    (STOP, Deed::Stop, "STOP: no force on any key, also while somebody types"),
    (KeyboardShortcut::new(CTRL.plus(Modifiers::SHIFT), Key::Z), Deed::Redo, "redo"),
    (ctrl(Key::Z), Deed::Undo, "undo"),
    (ctrl(Key::Y), Deed::Redo, "redo"),
    (plain(Key::Space), Deed::Freeze, "freeze, go on"),
    (plain(Key::F), Deed::Follow, "follow what comes"),
    (plain(Key::C), Deed::Cursors, "cursors of the scope"),
    (plain(Key::R), Deed::Rearm, "arm the trigger again"),
    (plain(Key::ArrowLeft), Deed::Previous, "select the key below"),
    (plain(Key::ArrowRight), Deed::Next, "select the key above"),
    (ctrl(Key::K), Deed::Clear, "clear what was recorded here"),
    (plain(Key::F1), Deed::Help, "this help"),
    (ctrl(Key::Num1), Deed::Open(Pane::Overview), "keys"),
    (ctrl(Key::Num2), Deed::Open(Pane::Scope(0)), "scope"),
    (ctrl(Key::Num3), Deed::Open(Pane::Mechanism), "mechanism"),
    (ctrl(Key::Num4), Deed::Open(Pane::Phase), "force and travel"),
    (ctrl(Key::Num5), Deed::Open(Pane::Tuning), "tuning"),
    (ctrl(Key::Num6), Deed::Open(Pane::Instruments), "instruments"),
    (ctrl(Key::Num7), Deed::Open(Pane::Deadlines), "deadlines"),
    (ctrl(Key::Num8), Deed::Open(Pane::Links), "links"),
    (ctrl(Key::Num9), Deed::Open(Pane::Keyboard), "keyboard"),
];

/// Shortcuts and what they do, for people.
pub(super) fn list(ctx: &Context) -> Vec<(String, &'static str)> {
    ALL.iter().map(|(shortcut, _, text)| (ctx.format_shortcut(shortcut), *text)).collect()
}

/// The shortcut of Stop, for people.
pub(super) fn stop(ctx: &Context) -> String {
    ctx.format_shortcut(&STOP)
}

/// Does what the keyboard says; nothing but Stop while somebody types.
pub(super) fn heed(ctx: &Context, app: &mut App) {
    let types = ctx.egui_wants_keyboard_input();
    for (shortcut, deed, _) in ALL {
        let is_plain = shortcut.modifiers == Modifiers::NONE;
        // The computer keyboard plays notes while it is a piano.
        let is_taken = is_plain && app.desk.views.keyboard.plays && shortcut.logical_key != Key::F1;
        let is_heard = deed == Deed::Stop || (!types && !is_taken);
        if is_heard && ctx.input_mut(|input| input.consume_shortcut(&shortcut)) {
            do_it(deed, app);
        }
    }
}

fn do_it(deed: Deed, app: &mut App) {
    let desk = &mut app.desk;
    let selected = desk.views.selected;
    match deed {
        Deed::Stop => desk.stop(),
        Deed::Freeze => desk.toggle_freeze(),
        Deed::Follow => desk.follow(),
        Deed::Undo => desk.tuner.undo(),
        Deed::Redo => desk.tuner.redo(),
        Deed::Clear => desk.store.clear(),
        Deed::Help => desk.views.shows_help = !desk.views.shows_help,
        Deed::Previous => desk.select(selected.saturating_sub(1)),
        Deed::Next => desk.select(selected.saturating_add(1)),
        Deed::Open(pane) => layout::open(&mut app.layout, pane),
        Deed::Rearm => desk.views.scopes.values_mut().for_each(|scope| scope.armed.rearm()),
        Deed::Cursors => {
            let now = desk.now();
            for scope in desk.views.scopes.values_mut() {
                scope.has_cursors = !scope.has_cursors;
                scope.place_cursors(now);
            }
        }
    }
}
