use std::io::{IsTerminal as _, Write as _, stderr};
use std::thread;
use std::time::Duration;

use indicatif::{HumanDuration, ProgressBar, ProgressStyle};

/// Returns a bar of `runs`, on stderr at a terminal.
pub fn bar(runs: usize) -> ProgressBar {
    const TEMPLATE: &str = "{msg:14} {wide_bar} {pos}/{len} runs {eta}";
    // Our template is valid; otherwise use the plain bar.
    let style = ProgressStyle::with_template(TEMPLATE);
    let style = style.unwrap_or_else(|_broken| ProgressStyle::default_bar());
    ProgressBar::new(runs as u64).with_style(style)
}

/// Prints a line of progress every 10 s while `bar` runs, where stderr is no terminal.
pub fn print_lines(bar: &ProgressBar) {
    const LINES: Duration = Duration::from_secs(10);
    if stderr().is_terminal() {
        return;
    }
    let bar = bar.downgrade();
    thread::spawn(move || {
        loop {
            thread::sleep(LINES);
            let Some(bar) = bar.upgrade().filter(|bar| !bar.is_finished()) else { return };
            let (at, of) = (bar.position(), bar.length().unwrap_or(0));
            let left = HumanDuration(bar.eta());
            let _closed = writeln!(stderr(), "{}: {at} of {of} runs, {left} left", bar.message());
        }
    });
}

/// Returns a counter of an unknown number of runs.
pub fn counter() -> ProgressBar {
    const TEMPLATE: &str = "{msg:14} {spinner} {pos} runs {elapsed}";
    let style = ProgressStyle::with_template(TEMPLATE);
    let style = style.unwrap_or_else(|_broken| ProgressStyle::default_spinner());
    ProgressBar::new_spinner().with_style(style)
}
