//! The whole window beside a real host: tests start `letoff run` and use the mouse in the window.

mod program;
mod states;
mod tuning;
mod user;

use dashboard::Pane;
use eframe::egui::vec2;

use program::HostProgram;
use user::UserWindow;

fn shown_position(window: &UserWindow) -> Option<f64> {
    let words = window.text_with(" mm, ")?;
    words.split(" mm, ").next()?.parse().ok()
}

#[test]
fn a_window_connected_to_a_host_shows_the_key_that_is_pressed() {
    let host = HostProgram::start("window-press", &["--performance", "none"]);
    let mut window = UserWindow::open(&host.target());
    window.app().show_grid(vec![Pane::Overview, Pane::Keyboard]);
    window.wait("the key to press", |window| window.has("press C4"));
    let front = window.rect("press C4").center_bottom() - vec2(0.0, 6.0);
    window.press(front);
    window.wait("the key to go down", |window| shown_position(window).is_some_and(|it| 5.0 < it));
    window.release(front);
    window.wait("the key to come up", |window| shown_position(window).is_some_and(|it| it < 2.0));
}
