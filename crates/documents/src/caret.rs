//! Mistakes with their lines, and a caret under each position.

use std::fmt::Write as _;

use crate::{Diagnostics, is_unprintable};

/// Longest line that is shown whole (characters).
const WIDEST: usize = 120;

/// Returns all mistakes, each with its line and a caret; `text_of` returns the text of a file.
pub fn rendered(mistakes: &Diagnostics, text_of: &dyn Fn(&str) -> Option<String>) -> String {
    let mut out = String::new();
    let mut texts: Vec<(&str, Option<String>)> = Vec::new();
    for mistake in mistakes.as_slice() {
        let _infallible = writeln!(out, "{mistake}");
        let (Some(line), Some(column)) = (mistake.line, mistake.column) else { continue };
        let name = mistake.file.as_str();
        if texts.iter().all(|(known, _text)| *known != name) {
            texts.push((name, text_of(name)));
        }
        let text = texts.iter().find(|(known, _text)| *known == name);
        if let Some((_, Some(text))) = text {
            point(&mut out, text, line, column);
        }
    }
    out
}

fn point(out: &mut String, text: &str, line: usize, column: usize) {
    let Some(text) = text.lines().nth(line.saturating_sub(1)) else { return };
    let before = column.saturating_sub(1);
    // Show the stretch of a long line around the position.
    let first = if before < WIDEST { 0 } else { before - WIDEST / 2 };
    let shown: String = text.chars().skip(first).take(WIDEST).map(untabbed).collect();
    let _infallible = writeln!(out, "  {shown}\n  {}^", " ".repeat(before - first));
}

fn untabbed(character: char) -> char {
    if is_unprintable(character) { ' ' } else { character }
}
