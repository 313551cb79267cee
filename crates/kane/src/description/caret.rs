//! Mistakes with the line they are about and a caret under the place.

use std::fmt::Write as _;

use diagnostics::Diagnostics;

use super::source::DescriptionSource;

/// Widest line that is shown whole (characters).
const WIDEST: usize = 120;

/// Returns all mistakes, each with its line and a caret, as a terminal shows them.
pub fn rendered(mistakes: &Diagnostics, sources: &[DescriptionSource]) -> String {
    let mut out = String::new();
    for mistake in mistakes.as_slice() {
        let _infallible = writeln!(out, "{mistake}");
        let source = sources.iter().find(|source| source.name == mistake.file);
        if let (Some(line), Some(column), Some(source)) = (mistake.line, mistake.column, source) {
            point(&mut out, source, line, column);
        }
    }
    out
}

fn point(out: &mut String, source: &DescriptionSource, line: usize, column: usize) {
    let Some(text) = source.text.lines().nth(line.saturating_sub(1)) else { return };
    let before = column.saturating_sub(1);
    // Of a long line the part about the place.
    let first = if before < WIDEST { 0 } else { before - WIDEST / 2 };
    let shown: String = text.chars().skip(first).take(WIDEST).map(untabbed).collect();
    let _infallible = writeln!(out, "  {shown}\n  {}^", " ".repeat(before - first));
}

fn untabbed(character: char) -> char {
    if character.is_control() { ' ' } else { character }
}
