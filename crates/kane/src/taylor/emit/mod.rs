//! A recursion as Rust: one function for each mode.

mod orders;
mod start;
mod values;

use pode::series::MOST_GUARDS;

use super::lanes::{ProductLane, lanes};
use super::recursion::Recursion;
use super::rules::TermRule;
use crate::tape::{Argument, Instruction, Slot};

/// The names in an emitted series.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SeriesNames<'a> {
    /// Name of the function.
    pub function: &'a str,
    /// What it is, as its documentation.
    pub doc: &'a str,
    /// How many constants it is given.
    pub constants: usize,
}

/// Returns the function that expands `recursion`, as Rust.
///
/// It asks for `pode::series::{Expansion, INPUT_TERMS}`, `pode::series::lanes::{LanePair, ProductLanes}`,
/// `pode::series::rows::PER_ORDER`, `pode::{math, Motion}` and `equations::functions`, as far as
/// they occur. Of the guards the first [`MOST_GUARDS`] have their series.
pub fn emit(recursion: &Recursion, names: &SeriesNames<'_>) -> String {
    let mut writing = Writing::new(recursion);
    writing.head(names);
    writing.start();
    writing.orders();
    writing.last_guards();
    writing.text.push_str("}\n");
    writing.text
}

struct Writing<'a> {
    recursion: &'a Recursion,
    is_live: Vec<bool>,
    lanes: Vec<ProductLane>,
    text: String,
}

impl<'a> Writing<'a> {
    fn new(recursion: &'a Recursion) -> Self {
        let mut writing =
            Self { recursion, is_live: Vec::new(), lanes: Vec::new(), text: String::new() };
        writing.is_live = recursion.live(&writing.outputs_with_series());
        writing.lanes = lanes(recursion, &writing.is_live);
        writing
    }

    fn line(&mut self, depth: usize, line: &str) {
        self.text.extend(std::iter::repeat_n("    ", depth).chain([line, "\n"]));
    }

    fn head(&mut self, names: &SeriesNames<'_>) {
        let (entries, _) = self.recursion.outputs();
        let input = if self.reads_input() { "s" } else { "_s" };
        let constants = if self.reads_constants() { "c" } else { "_c" };
        let SeriesNames { function, doc, constants: count } = names;
        self.line(0, &format!("/// {doc}"));
        self.line(0, "#[rustfmt::skip]");
        self.line(0, &format!("pub(super) fn {function}("));
        self.line(1, &format!("{constants}: &[f64; {count}],"));
        self.line(1, &format!("{input}: &[Motion; INPUT_TERMS],"));
        self.line(1, &format!("out: &mut Expansion<[f64; {}]>,", entries.len()));
        self.line(0, ") {");
    }

    fn reads_input(&self) -> bool {
        self.recursion.rules.iter().any(|rule| matches!(rule, TermRule::Input(_)))
    }

    fn reads_constants(&self) -> bool {
        let is_read = |it: &Instruction| matches!(it, Instruction::Argument(Argument::Constant(_)));
        self.recursion.tape.instructions.iter().any(is_read)
    }

    /// The guards that have a series.
    fn guard_slots(&self) -> &'a [Slot] {
        let (_, guards) = self.recursion.outputs();
        guards.get(..MOST_GUARDS).unwrap_or(guards)
    }

    /// The derivative's entries, and those guards.
    fn outputs_with_series(&self) -> Vec<Slot> {
        [self.recursion.outputs().0, self.guard_slots()].concat()
    }

    /// The values that go on.
    fn live(&self) -> Vec<usize> {
        (0..self.is_live.len()).filter(|at| self.is_live[*at]).collect()
    }
}
