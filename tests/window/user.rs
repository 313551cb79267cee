//! A window with its user: real mouse and key events, and the texts on the screen.
#![allow(dead_code, reason = "tests of other panels use the rest")]

use std::sync::Arc;
use std::time::{Duration, Instant};

use dashboard::open::{WindowTarget, open};
use dashboard::{App, RepaintWaker, wall_clock};
use eframe::egui::accesskit::Role;
use eframe::egui::{self, Event, Modifiers, PointerButton, Pos2, Rect};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

use super::program::PATIENCE;

const FRAME: Duration = Duration::from_millis(30);

/// A window on a real source.
pub(crate) struct UserWindow {
    harness: Harness<'static, App>,
}

impl UserWindow {
    #[expect(clippy::large_stack_frames, reason = "a window, once")]
    pub(crate) fn open(target: &WindowTarget) -> Self {
        let test = std::thread::current();
        let wake: RepaintWaker = Arc::new(move |_soon| test.unpark());
        let source = open(target, &wake).expect("a source");
        let app = App::new(source, wall_clock(), None, &egui::Context::default());
        let builder = Harness::builder().with_size([1280.0, 800.0]).with_step_dt(1.0 / 60.0);
        Self { harness: builder.build_ui_state(|ui, app: &mut App| app.draw(ui), app) }
    }

    pub(crate) fn app(&mut self) -> &mut App {
        self.harness.state_mut()
    }

    /// Draws frames until `is_reached` returns `true`; panics with all texts after two minutes.
    #[track_caller]
    pub(crate) fn wait(&mut self, what: &str, mut is_reached: impl FnMut(&Self) -> bool) {
        let begun = Instant::now();
        self.harness.step();
        while !is_reached(self) {
            assert!(begun.elapsed() < PATIENCE, "no {what}; shown: {:#?}", self.texts());
            std::thread::park_timeout(FRAME);
            self.harness.step();
        }
    }

    pub(crate) fn settle(&mut self) {
        self.harness.run_steps(4);
    }

    pub(crate) fn press(&mut self, at: Pos2) {
        self.harness.event(Event::PointerMoved(at));
        self.harness.step();
        self.button(at, true);
    }

    #[track_caller]
    pub(crate) fn scroll_to(&mut self, role: Role, label: &str) {
        for _turn in 0..100 {
            let rect = self.rect_of(role, label);
            if rect.bottom() < 780.0 {
                return;
            }
            let at = Pos2::new(rect.center().x, 600.0);
            let (unit, delta) = (egui::MouseWheelUnit::Line, egui::vec2(0.0, -3.0));
            let (modifiers, phase) = (Modifiers::NONE, egui::TouchPhase::Move);
            let source = egui::MouseWheelSource::Unknown;
            self.harness.event(Event::PointerMoved(at));
            self.harness.event(Event::MouseWheel { unit, delta, phase, source, modifiers });
            self.harness.run_steps(20);
        }
        panic!("{label} is not within reach");
    }

    pub(crate) fn move_to(&mut self, at: Pos2) {
        self.harness.event(Event::PointerMoved(at));
        self.harness.step();
    }

    pub(crate) fn release(&mut self, at: Pos2) {
        self.button(at, false);
        self.settle();
    }

    pub(crate) fn click_at(&mut self, at: Pos2) {
        self.press(at);
        self.release(at);
    }

    pub(crate) fn shift_click_at(&mut self, at: Pos2) {
        let modifiers = Modifiers::SHIFT;
        self.harness.event(Event::ModifiersChanged(modifiers));
        self.harness.event(Event::PointerMoved(at));
        for pressed in [true, false] {
            let button = PointerButton::Primary;
            self.harness.event(Event::PointerButton { pos: at, button, pressed, modifiers });
            self.harness.step();
        }
        self.harness.event(Event::ModifiersChanged(Modifiers::NONE));
        self.settle();
    }

    #[track_caller]
    pub(crate) fn click(&mut self, label: &str) {
        self.click_at(self.rect(label).center());
    }

    #[track_caller]
    pub(crate) fn click_role(&mut self, role: Role, label: &str) {
        let at = self.harness.get_by_role_and_label(role, label).rect().center();
        self.click_at(at);
    }

    pub(crate) fn drag(&mut self, from: Pos2, to: Pos2) {
        self.press(from);
        for i in 1..=8 {
            self.harness.event(Event::PointerMoved(from.lerp(to, (i as f32) / 8.0)));
            self.harness.step();
        }
        self.release(to);
    }

    pub(crate) fn key(&mut self, modifiers: Modifiers, key: egui::Key) {
        self.harness.key_press_modifiers(modifiers, key);
        self.settle();
    }

    pub(crate) fn type_in(&mut self, text: &str) {
        self.harness.event(Event::Text(text.to_owned()));
        self.settle();
    }

    #[expect(clippy::fn_params_excessive_bools, reason = "the field of the event")]
    fn button(&mut self, pos: Pos2, pressed: bool) {
        let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
        self.harness.event(Event::PointerButton { pos, button, pressed, modifiers });
        self.harness.step();
    }

    #[track_caller]
    pub(crate) fn rect(&self, label: &str) -> Rect {
        self.harness.get_by_label(label).rect()
    }

    #[track_caller]
    pub(crate) fn rect_of(&self, role: Role, label: &str) -> Rect {
        self.harness.get_by_role_and_label(role, label).rect()
    }

    #[track_caller]
    pub(crate) fn is_disabled(&self, role: Role, label: &str) -> bool {
        self.harness.get_by_role_and_label(role, label).accesskit_node().is_disabled()
    }

    #[track_caller]
    pub(crate) fn number(&self, role: Role, label: &str) -> f64 {
        let node = self.harness.get_by_role_and_label(role, label);
        node.accesskit_node().numeric_value().expect("a number")
    }

    #[track_caller]
    pub(crate) fn value(&self, role: Role, label: &str) -> String {
        let node = self.harness.get_by_role_and_label(role, label);
        node.accesskit_node().value().expect("a text")
    }

    pub(crate) fn has(&self, label: &str) -> bool {
        self.harness.query_all_by_label(label).next().is_some()
    }

    pub(crate) fn text_with(&self, part: &str) -> Option<String> {
        self.texts().into_iter().find(|text| text.contains(part))
    }

    pub(crate) fn says(&self, part: &str) -> bool {
        self.text_with(part).is_some()
    }

    /// Returns the labels and values of all elements, from top to bottom.
    pub(crate) fn texts(&self) -> Vec<String> {
        let all = self.harness.root().children_recursive();
        let texts = all.flat_map(|node| {
            let node = node.accesskit_node();
            [node.label(), node.value()]
        });
        texts.flatten().filter(|text| !text.is_empty()).collect()
    }
}
