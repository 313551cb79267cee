//! The window with the recorded take, at a time that the test chooses.

#![expect(clippy::expect_used, clippy::panic, reason = "helpers of tests, outside #[test]")]
#![allow(dead_code, reason = "no test file uses all of it")]

mod host;
pub(crate) mod raster;
pub(crate) mod snapshot;

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use dashboard::{App, Pane, SavedWindow, WallClock};
use eframe::egui;
use eframe::egui::accesskit::{Role, Toggled};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use host::{RequestLog, TakeHost};
use telemetry::{Catalogue, Description, DescriptionFile, Request, Source, Update, Voice};

/// Start time of every test (ns since 1970).
const BEGAN: u64 = 1_800_000_000_000_000_000;

#[derive(Clone, Debug, Default)]
pub(crate) struct TestClock(Arc<AtomicU64>);

impl TestClock {
    pub(crate) fn set(&self, seconds: f64) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a few seconds"
        )]
        let nanos = (seconds * 1e9) as u64;
        self.0.store(nanos, Ordering::Relaxed);
    }

    pub(crate) fn clock(&self) -> WallClock {
        let time = Arc::clone(&self.0);
        Arc::new(move || BEGAN + time.load(Ordering::Relaxed))
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum Behind {
    Live,
    Recording,
    /// A host that plays, and disconnects when it is asked to stop.
    Vanishing,
}

pub(crate) struct TestWindow {
    pub(crate) harness: Harness<'static, App>,
    pub(crate) time: TestClock,
    asked: RequestLog,
}

pub(crate) fn open(pane: Pane, behind: Behind) -> TestWindow {
    let mut window = open_with(behind, None, move |app| app.show_only(pane));
    if pane == Pane::Tuning {
        // High enough for all parameters.
        window.harness.set_size(egui::vec2(900.0, 1100.0));
    }
    window.play(3.0);
    window
}

#[expect(clippy::large_stack_frames, reason = "a window, once")]
pub(crate) fn open_with(
    behind: Behind,
    memory: Option<SavedWindow>,
    set: impl FnOnce(&mut App),
) -> TestWindow {
    let time = TestClock::default();
    let (source, asked) = source(&time, behind);
    let ctx = egui::Context::default();
    let mut app = App::new(source, time.clock(), memory, &ctx);
    set(&mut app);
    let builder =
        Harness::builder().with_size([900.0, 640.0]).with_step_dt(1.0 / 60.0).with_max_steps(40);
    let harness = builder.build_ui_state(|ui, app: &mut App| app.draw(ui), app);
    TestWindow { harness, time, asked }
}

pub(crate) fn source(time: &TestClock, behind: Behind) -> (Box<dyn Source>, RequestLog) {
    let host = TakeHost::new(time.clock(), behind);
    let asked = host.asked();
    (Box::new(host), asked)
}

impl TestWindow {
    pub(crate) fn play(&mut self, seconds: f64) {
        self.play_on(0.0, seconds);
    }

    pub(crate) fn play_on(&mut self, from: f64, seconds: f64) {
        let mut at = from;
        while at < seconds {
            at = f64::min(at + 0.1, seconds);
            self.time.set(at);
            self.harness.step();
        }
        self.settle();
    }

    pub(crate) fn settle(&mut self) {
        self.harness.run_steps(4);
    }

    #[track_caller]
    pub(crate) fn click(&mut self, label: &str) {
        self.harness.get_by_label(label).click();
        self.settle();
    }

    #[track_caller]
    pub(crate) fn click_role(&mut self, role: Role, label: &str) {
        self.harness.get_by_role_and_label(role, label).click();
        self.settle();
    }

    #[track_caller]
    pub(crate) fn click_any(&mut self, part: &str) {
        self.harness.get_by_label_contains(part).click();
        self.settle();
    }

    pub(crate) fn press(&mut self, modifiers: egui::Modifiers, key: egui::Key) {
        self.harness.key_press_modifiers(modifiers, key);
        self.settle();
    }

    pub(crate) fn hold(&mut self, key: egui::Key) {
        self.harness.key_down(key);
        self.settle();
    }

    pub(crate) fn type_in(&mut self, text: impl Into<String>) {
        self.harness.event(egui::Event::Text(text.into()));
        self.settle();
    }

    #[track_caller]
    pub(crate) fn is_on(&self, label: &str) -> bool {
        let node = self.harness.get_by_label(label);
        node.accesskit_node().toggled() == Some(Toggled::True)
    }

    #[track_caller]
    pub(crate) fn number(&self, label: &str) -> f64 {
        let node = self.harness.get_by_label(label);
        node.accesskit_node().numeric_value().unwrap_or_default()
    }

    #[track_caller]
    pub(crate) fn press_at(&mut self, at: egui::Pos2) {
        self.harness.hover_at(at);
        self.harness.drag_at(at);
        self.harness.step();
    }

    pub(crate) fn drag(&mut self, from: egui::Pos2, to: egui::Pos2, button: egui::PointerButton) {
        let push = |pressed, pos| egui::Event::PointerButton {
            pos,
            button,
            pressed,
            modifiers: egui::Modifiers::NONE,
        };
        self.harness.event(egui::Event::PointerMoved(from));
        self.harness.step();
        self.harness.event(push(true, from));
        self.harness.step();
        for i in 1..=8 {
            let at = from.lerp(to, (i as f32) / 8.0);
            self.harness.event(egui::Event::PointerMoved(at));
            self.harness.step();
        }
        self.harness.event(push(false, to));
        self.settle();
    }

    #[track_caller]
    pub(crate) fn rect(&self, label: &str) -> egui::Rect {
        self.harness.get_by_label(label).rect()
    }

    pub(crate) fn has(&self, label: &str) -> bool {
        self.harness.query_by_label(label).is_some()
    }

    pub(crate) fn says(&self, text: &str) -> bool {
        self.harness.query_all_by_label_contains(text).next().is_some()
            || self.harness.query_all_by_value(text).next().is_some()
    }

    /// Returns all requests but those for figures, which follow each change by themselves.
    pub(crate) fn asked(&self) -> Vec<Request> {
        let asked = self.asked.lock().expect("nobody panics with it");
        let is_own = |it: &&Request| !matches!(it, Request::Figures { .. });
        asked.iter().filter(is_own).cloned().collect()
    }

    pub(crate) fn set(&self, key: u8, parameter: &str) -> Vec<f64> {
        let changes = self.asked().into_iter().filter_map(|request| match request {
            Request::Set { changes } => Some(changes),
            Request::UseInstrument { .. }
            | Request::Stop {}
            | Request::Press { .. }
            | Request::Grip { .. }
            | Request::Identify { .. }
            | Request::Load { .. }
            | Request::Render { .. }
            | Request::FollowBase { .. }
            | Request::SaveInstrument { .. }
            | Request::Margin { .. }
            | Request::Figures { .. }
            | Request::Scene {}
            | Request::Status {}
            | Request::Where {}
            | Request::Record { .. } => None,
        });
        changes
            .flatten()
            .filter(|change| change.key == key && change.parameter == parameter)
            .map(|change| change.value)
            .collect()
    }
}

/// Returns catalogue and voice for two versions of a description; the file is now invalid.
pub(crate) fn wrong_description() -> [Update; 2] {
    const WRONG: &str = "\
/home/me/feel.toml:6:25: there is no \"kk\"; use \"k\", the nearest of base, k, m, s, y, y', y'' and \
pi
  key = { stretch = \"s - kk*y\", stiffness = \"k\", damping = \"1 N*s/m\" } # far more than a line takes
                          ^
/home/me/feel.toml:9:1: there is no key \"zero\" here; remove it
  zero = 1
  ^";
    let file = DescriptionFile { path: "/home/me/feel.toml".to_owned(), text: String::new() };
    let playing = Description {
        version: 2,
        model: "feel".to_owned(),
        files: vec![file],
        since: 3_000_000_000,
        watched: true,
        mistakes: WRONG.to_owned(),
    };
    let before = Description { version: 1, mistakes: String::new(), ..playing.clone() };
    let descriptions = vec![before, playing];
    let catalogue = Catalogue { descriptions, tick_hz: 1000, ..Catalogue::default() };
    let voice = Voice { key: 39, model: "feel".to_owned(), version: 2, ..Voice::default() };
    [Update::Catalogue(catalogue), Update::Voice(voice)]
}
