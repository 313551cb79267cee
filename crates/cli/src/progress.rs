use indicatif::{ProgressBar, ProgressStyle};

/// Returns a bar of `runs`, on stderr at a terminal.
pub fn bar(runs: usize) -> ProgressBar {
    const TEMPLATE: &str = "{msg:14} {wide_bar} {pos}/{len} runs {eta}";
    // Our template is valid; otherwise use the plain bar.
    let style = ProgressStyle::with_template(TEMPLATE);
    let style = style.unwrap_or_else(|_broken| ProgressStyle::default_bar());
    ProgressBar::new(runs as u64).with_style(style)
}

/// Returns a counter of an unknown number of runs.
pub fn counter() -> ProgressBar {
    const TEMPLATE: &str = "{msg:14} {spinner} {pos} runs {elapsed}";
    let style = ProgressStyle::with_template(TEMPLATE);
    let style = style.unwrap_or_else(|_broken| ProgressStyle::default_spinner());
    ProgressBar::new_spinner().with_style(style)
}
