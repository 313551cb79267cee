//! Bars and counts for long work.

use indicatif::{ProgressBar, ProgressStyle};

/// Returns a bar for so many runs, on stderr where a person sees it.
pub fn bar(runs: usize) -> ProgressBar {
    const TEMPLATE: &str = "{msg:14} {wide_bar} {pos}/{len} runs {eta}";
    // A template of ours cannot be wrong; if it were, the plain bar will do.
    let style = ProgressStyle::with_template(TEMPLATE);
    let style = style.unwrap_or_else(|_broken| ProgressStyle::default_bar());
    ProgressBar::new(runs as u64).with_style(style)
}

/// Returns a count of runs of which nobody knows how many there will be.
pub fn counter() -> ProgressBar {
    const TEMPLATE: &str = "{msg:14} {spinner} {pos} runs {elapsed}";
    let style = ProgressStyle::with_template(TEMPLATE);
    let style = style.unwrap_or_else(|_broken| ProgressStyle::default_spinner());
    ProgressBar::new_spinner().with_style(style)
}
