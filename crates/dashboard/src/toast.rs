//! Messages over the panels. They move no panel, and the log keeps them.

use std::{collections::VecDeque, time::Duration};

use eframe::egui::{self, Align2, Area, Context, Frame, Id, Label, RichText, Sense, Ui, vec2};
use telemetry::log::Level;

use crate::theme;

/// Maximum number of messages at once; the oldest goes first.
const MAX_SHOWN: usize = 5;

/// Largest width of a message (points).
const WIDTH: f32 = 380.0;

#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Toast {
    pub(crate) text: String,
    pub(crate) level: Level,
    /// Texts and actions of its buttons; a message with buttons stays until it is clicked.
    pub(crate) actions: Vec<(String, ToastAction)>,
}

#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum ToastAction {
    /// Brings the panel with links and boards to the front.
    ShowLinks,
}

/// The messages in the corner, with the times at which they began (ns since 1970).
#[derive(Clone, Debug, Default)]
pub(crate) struct Toasts(VecDeque<(Toast, u64)>);

impl Toast {
    /// Returns how long it is shown (ns).
    const fn duration(&self) -> u64 {
        const SECOND: u64 = 1_000_000_000;
        match self.level {
            _ if !self.actions.is_empty() => u64::MAX,
            Level::Info => 5 * SECOND,
            Level::Warning => 10 * SECOND,
            Level::Error => 20 * SECOND,
        }
    }
}

impl Toasts {
    /// Shows `toast` from `now` on, also instead of an equal one.
    pub(crate) fn push(&mut self, toast: Toast, now: u64) {
        self.end(&toast.text);
        if self.0.len() == MAX_SHOWN {
            self.0.pop_front();
        }
        self.0.push_back((toast, now));
    }

    /// Removes the message with this text, which no longer holds.
    pub(crate) fn end(&mut self, text: &str) {
        self.0.retain(|(shown, _)| shown.text != text);
    }

    pub(crate) fn ui(&mut self, ctx: &Context, now: u64) -> Option<ToastAction> {
        self.0.retain(|(toast, since)| now.saturating_sub(*since) < toast.duration());
        if self.0.is_empty() {
            return None;
        }
        let mut clicked = None;
        let area = Area::new(Id::unique("toasts")).order(egui::Order::Foreground);
        area.anchor(Align2::RIGHT_BOTTOM, vec2(-12.0, -12.0)).show(ctx, |ui| {
            ui.set_max_width(WIDTH);
            for (i, (toast, _)) in self.0.iter().enumerate() {
                match toast_ui(ui, toast) {
                    ToastClick::None => {}
                    ToastClick::Dismissed => clicked = Some((i, None)),
                    ToastClick::Button(action) => clicked = Some((i, Some(action))),
                }
            }
        });
        let ends = self.0.iter().map(|(toast, since)| since.saturating_add(toast.duration()));
        if let Some(end) = ends.min().filter(|end| *end < u64::MAX) {
            ctx.request_repaint_after(Duration::from_nanos(end.saturating_sub(now)));
        }
        let (i, action) = clicked?;
        self.0.remove(i);
        action
    }
}

enum ToastClick {
    None,
    Dismissed,
    Button(ToastAction),
}

fn toast_ui(ui: &mut Ui, toast: &Toast) -> ToastClick {
    let color = match toast.level {
        Level::Info => ui.visuals().text_color(),
        Level::Warning => theme::warning(ui),
        Level::Error => theme::fault(ui),
    };
    let frame = Frame::popup(ui.style());
    let shown = frame.show(ui, |ui| {
        let text = Label::new(RichText::new(&toast.text).color(color)).wrap();
        let is_dismissed = ui.add(text.sense(Sense::click())).clicked();
        let mut clicked = if is_dismissed { ToastClick::Dismissed } else { ToastClick::None };
        ui.horizontal(|ui| {
            for (text, action) in &toast.actions {
                if ui.button(text).clicked() {
                    clicked = ToastClick::Button(action.clone());
                }
            }
        });
        clicked
    });
    shown.inner
}
