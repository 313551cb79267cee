//! Which panels there are, and how they stand at first.

use eframe::egui;
use egui_tiles::{Linear, LinearDir, TileId, Tiles, Tree};
use serde::{Deserialize, Serialize};

/// A panel.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Serialize, Deserialize)]
pub enum Pane {
    /// All keys at a glance.
    Overview,
    /// A key's mechanism, to scale.
    Mechanism,
    /// A scope, by its number.
    Scope(u8),
    Phase,
    Tuning,
    /// Which instrument plays which keys.
    Instruments,
    /// When ticks were done.
    Deadlines,
    Links,
    /// What was sent to a synthesizer.
    Midi,
    /// What went wrong, and what to do.
    Faults,
    /// Where a recording is.
    Timeline,
    Keyboard,
    /// What people should read.
    Log,
}

impl Pane {
    /// Every panel; scopes beyond the first are opened from the menu.
    pub const ALL: [Self; 13] = [
        Self::Overview,
        Self::Mechanism,
        Self::Scope(0),
        Self::Phase,
        Self::Tuning,
        Self::Instruments,
        Self::Deadlines,
        Self::Links,
        Self::Midi,
        Self::Faults,
        Self::Timeline,
        Self::Keyboard,
        Self::Log,
    ];

    /// Its title.
    pub fn title(self) -> String {
        let title = match self {
            Self::Overview => "Keys",
            Self::Mechanism => "Mechanism",
            Self::Scope(0) => "Scope",
            Self::Scope(number) => return format!("Scope {}", number + 1),
            Self::Phase => "Force and travel",
            Self::Tuning => "Tuning",
            Self::Instruments => "Instruments",
            Self::Deadlines => "Deadlines",
            Self::Links => "Links",
            Self::Midi => "MIDI",
            Self::Faults => "Faults",
            Self::Timeline => "Timeline",
            Self::Keyboard => "Keyboard",
            Self::Log => "Log",
        };
        title.to_owned()
    }
}

/// How panels stand.
pub(crate) type Layout = Tree<Pane>;

/// How they stand at first: keys above, scope and tuning below, the rest in tabs.
pub(crate) fn first() -> Layout {
    let mut tiles = Tiles::default();
    let keys = tabs(&mut tiles, &[Pane::Overview]);
    let scope = tabs(&mut tiles, &[Pane::Scope(0), Pane::Deadlines, Pane::Links, Pane::Timeline]);
    let mechanism = tabs(&mut tiles, &[Pane::Mechanism, Pane::Phase, Pane::Keyboard]);
    let tuning = tabs(&mut tiles, &[Pane::Tuning, Pane::Instruments]);
    let messages = tabs(&mut tiles, &[Pane::Faults, Pane::Midi, Pane::Log]);
    let left = pair(&mut tiles, LinearDir::Vertical, [mechanism, messages], 0.62);
    let right = pair(&mut tiles, LinearDir::Horizontal, [scope, tuning], 0.6);
    let below = pair(&mut tiles, LinearDir::Horizontal, [left, right], 0.29);
    let root = pair(&mut tiles, LinearDir::Vertical, [keys, below], 0.25);
    Tree::new(egui::Id::unique("panels"), root, tiles)
}

fn tabs(tiles: &mut Tiles<Pane>, panes: &[Pane]) -> TileId {
    let panes: Vec<TileId> = panes.iter().map(|pane| tiles.insert_pane(*pane)).collect();
    tiles.insert_tab_tile(panes)
}

fn pair(tiles: &mut Tiles<Pane>, dir: LinearDir, pair: [TileId; 2], share: f32) -> TileId {
    tiles.insert_container(Linear::new_binary(dir, pair, share))
}

/// Shows a panel: brings it to the front, or opens it beside the others.
pub(crate) fn open(layout: &mut Layout, pane: Pane) {
    let found = layout.tiles.find_pane(&pane);
    let tile = found.unwrap_or_else(|| layout.tiles.insert_pane(pane));
    match layout.root().filter(|_| found.is_none()) {
        Some(root) => {
            let tabs = beside(layout, root);
            layout.move_tile_to_container(tile, tabs, usize::MAX, false);
        }
        None if found.is_none() => layout.root = Some(tile),
        None => {}
    }
    layout.make_active(|id, _| id == tile);
}

/// The tabs in which a new panel stands: the largest, where the scope usually is.
fn beside(layout: &Layout, root: TileId) -> TileId {
    let scope = layout.tiles.find_pane(&Pane::Scope(0));
    scope.and_then(|scope| layout.tiles.parent_of(scope)).unwrap_or(root)
}

/// Closes a panel.
pub(crate) fn close(layout: &mut Layout, pane: Pane) {
    if let Some(tile) = layout.tiles.find_pane(&pane) {
        layout.remove_recursively(tile);
    }
}

/// Whether a panel is open.
pub(crate) fn is_open(layout: &Layout, pane: Pane) -> bool {
    layout.tiles.find_pane(&pane).is_some()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_panel_stands_somewhere_at_first() {
        let layout = first();
        for pane in Pane::ALL {
            assert!(is_open(&layout, pane), "{pane:?}");
        }
    }

    #[test]
    fn a_panel_is_closed_and_opened_again() {
        let mut layout = first();
        close(&mut layout, Pane::Midi);
        assert!(!is_open(&layout, Pane::Midi));
        open(&mut layout, Pane::Midi);
        open(&mut layout, Pane::Scope(3));
        assert!(is_open(&layout, Pane::Midi) && is_open(&layout, Pane::Scope(3)));
    }

    #[test]
    fn a_layout_survives_a_restart() {
        let text = serde_json::to_string(&first()).expect("JSON");
        let back: Layout = serde_json::from_str(&text).expect("a layout");
        assert!(is_open(&back, Pane::Tuning));
    }
}
