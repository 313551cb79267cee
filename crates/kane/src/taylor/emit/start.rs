//! The values where a series begins, and what its orders keep of them.

use super::Writing;
use super::values::{operands, start_of};
use crate::graph::UnaryFunction;
use crate::tape::Instruction;
use crate::taylor::rules::TermRule;

impl Writing<'_> {
    /// Values at the start, the rows that begin with them, and the first rates.
    pub(super) fn start(&mut self) {
        self.line(1, "let x = out.terms[0];");
        if self.recursion.rules.iter().any(|rule| matches!(rule, TermRule::Input(1..))) {
            self.line(1, "let per_scale = 1.0 / out.scale;");
        }
        let is_read = self.is_read_at_start();
        let mut is_written = vec![false; is_read.len()];
        for at in (0..is_read.len()).filter(|at| is_read[*at]) {
            if !std::mem::replace(&mut is_written[at], true) {
                self.value(at, &mut is_written);
            }
        }
        for at in self.live() {
            self.prepare(at);
        }
        for (group, lanes) in self.groups().into_iter().enumerate() {
            let line = format!(
                "let mut lanes{group} = ProductLanes::<{}>::ZERO;",
                lanes.len().div_ceil(2)
            );
            self.line(1, &line);
        }
        self.outputs(1, "0", "1");
    }

    /// What is read at the start: outputs, what goes on, what rules keep of the start, and all
    /// that these are made of.
    #[expect(clippy::wildcard_enum_match_arm, reason = "all other rules keep nothing of the start")]
    fn is_read_at_start(&self) -> Vec<bool> {
        let mut is_read = self.is_live.clone();
        for slot in self.outputs_with_series() {
            is_read[slot.index()] = true;
        }
        for at in self.live() {
            let kept = match self.recursion.rules[at] {
                TermRule::Scale(by, _) | TermRule::Power(_, by) | TermRule::Over(_, by) => by,
                TermRule::Choice(condition, ..) => condition,
                _ => continue,
            };
            is_read[kept.index()] = true;
        }
        // Operands stand before what is made of them.
        for at in (0..is_read.len()).rev() {
            if is_read[at] {
                operands(&self.recursion.tape.instructions[at], |it| is_read[it.index()] = true);
            }
        }
        is_read
    }

    /// One value at the start; sine and cosine of one angle together.
    fn value(&mut self, at: usize, is_written: &mut [bool]) {
        use UnaryFunction::{Cos, Sin};
        let instructions = &self.recursion.tape.instructions;
        if let Instruction::Unary(Sin, x) = instructions[at] {
            let cosine = instructions.iter().position(|it| *it == Instruction::Unary(Cos, x));
            if let Some(cosine) = cosine {
                is_written[cosine] = true;
                let line = format!("let (v{at}, v{cosine}) = math::sin_cos(v{});", x.0);
                return self.line(1, &line);
            }
        }
        let value = start_of(&instructions[at]);
        self.line(1, &format!("let v{at} = {value};"));
    }

    /// What a rule makes of its operands' values at the start, once.
    #[expect(clippy::wildcard_enum_match_arm, reason = "all other rules keep nothing of the start")]
    fn prepare(&mut self, at: usize) {
        match self.recursion.rules[at] {
            TermRule::Quotient(_, y) | TermRule::Over(_, y) => {
                self.line(1, &format!("let per{at} = 1.0 / v{};", y.0));
            }
            TermRule::Power(x, _) => self.line(1, &format!("let per{at} = 1.0 / v{};", x.0)),
            TermRule::Root(_) => self.line(1, &format!("let per{at} = 0.5 / v{at};")),
            TermRule::Magnitude(x) => {
                self.line(1, &format!("let sign{at} = functions::sign(v{});", x.0));
            }
            TermRule::Choice(condition, ..) => {
                self.line(1, &format!("let is{at} = v{} > 0.0;", condition.0));
            }
            _ => {}
        }
    }
}
