//! Positions of panels, at first and when one is opened or closed.

use eframe::egui;
use egui_tiles::{Linear, LinearDir, TileId, Tiles, Tree};

use crate::panels::Pane;

pub(crate) type Layout = Tree<Pane>;

/// Panels above the others.
const ABOVE: &[Pane] = &[Pane::Overview];
/// Panels in the largest tile.
const MIDDLE: &[Pane] = &[
    Pane::Scope(0),
    Pane::Passivity,
    Pane::Descriptions,
    Pane::Deadlines,
    Pane::Links,
    Pane::Timeline,
];
const LEFT: &[Pane] = &[Pane::Mechanism, Pane::Phase, Pane::Keyboard];
const RIGHT: &[Pane] = &[Pane::Tuning, Pane::Instruments];
/// Panels at the lower left; panels in no list go behind them.
const BELOW_LEFT: &[Pane] = &[Pane::Faults, Pane::Midi, Pane::Log];

pub(crate) fn first() -> Layout {
    let named = [ABOVE, MIDDLE, LEFT, RIGHT, BELOW_LEFT].concat();
    let others = Pane::ALL.iter().copied().filter(|pane| !named.contains(pane));
    let below_left: Vec<Pane> = BELOW_LEFT.iter().copied().chain(others).collect();
    let mut tiles = Tiles::default();
    let above = tabs(&mut tiles, ABOVE);
    let middle = tabs(&mut tiles, MIDDLE);
    let left = tabs(&mut tiles, LEFT);
    let right = tabs(&mut tiles, RIGHT);
    let below_left = tabs(&mut tiles, &below_left);
    let left = pair(&mut tiles, LinearDir::Vertical, [left, below_left], 0.62);
    let right = pair(&mut tiles, LinearDir::Horizontal, [middle, right], 0.6);
    let below = pair(&mut tiles, LinearDir::Horizontal, [left, right], 0.29);
    let root = pair(&mut tiles, LinearDir::Vertical, [above, below], 0.25);
    Tree::new(egui::Id::unique("panels"), root, tiles)
}

fn tabs(tiles: &mut Tiles<Pane>, panes: &[Pane]) -> TileId {
    let panes: Vec<TileId> = panes.iter().map(|pane| tiles.insert_pane(*pane)).collect();
    tiles.insert_tab_tile(panes)
}

fn pair(tiles: &mut Tiles<Pane>, dir: LinearDir, pair: [TileId; 2], share: f32) -> TileId {
    tiles.insert_container(Linear::new_binary(dir, pair, share))
}

/// Brings a panel to the front, or opens it beside the others.
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

fn beside(layout: &Layout, root: TileId) -> TileId {
    let scope = layout.tiles.find_pane(&Pane::Scope(0));
    scope.and_then(|scope| layout.tiles.parent_of(scope)).unwrap_or(root)
}

pub(crate) fn close(layout: &mut Layout, pane: Pane) {
    if let Some(tile) = layout.tiles.find_pane(&pane) {
        layout.remove_recursively(tile);
    }
}

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
            assert!(is_open(&layout, *pane), "{pane:?}");
        }
    }
}
