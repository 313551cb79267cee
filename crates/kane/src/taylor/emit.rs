//! A recursion as Rust: one function for each mode.

use std::fmt::Write as _;

use super::lanes::{Factor, Lane, lanes};
use super::recursion::Recursion;
use super::rules::Rule;
use crate::graph::{BinaryFunction, UnaryFunction};
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
/// It asks for `pode::series::{Expansion, INPUT_TERMS}`, for all of `pode::series::rows`, for
/// `pode::{math, Motion}` and for `equations::functions`, as far as they occur.
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
    lanes: Vec<Lane>,
    text: String,
}

impl<'a> Writing<'a> {
    fn new(recursion: &'a Recursion) -> Self {
        let is_live = recursion.live(&recursion.tape.outputs);
        let lanes = lanes(recursion, &is_live);
        Self { recursion, is_live, lanes, text: String::new() }
    }

    fn line(&mut self, depth: usize, line: &str) {
        let _ = writeln!(self.text, "{}{line}", "    ".repeat(depth));
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
        self.recursion.rules.iter().any(|rule| matches!(rule, Rule::Input(_)))
    }

    fn reads_constants(&self) -> bool {
        let is_read = |it: &Instruction| matches!(it, Instruction::Argument(Argument::Constant(_)));
        self.recursion.tape.instructions.iter().any(is_read)
    }

    /// Values at the start, the rows that begin with them, and the first rates.
    fn start(&mut self) {
        self.line(1, "let x = out.terms[0];");
        if self.recursion.rules.iter().any(|rule| matches!(rule, Rule::Input(1..))) {
            self.line(1, "let per_scale = 1.0 / out.scale;");
        }
        let is_read = self.is_read_at_start();
        let mut is_written = vec![false; is_read.len()];
        for at in (0..is_read.len()).filter(|at| is_read[*at]) {
            if !std::mem::replace(&mut is_written[at], true) {
                self.value(at, &mut is_written);
            }
        }
        for at in 0..is_read.len() {
            self.prepare(at);
        }
        for (group, lanes) in self.groups().into_iter().enumerate() {
            let line =
                format!("let mut lanes{group} = Lanes::<{}>::ZERO;", lanes.len().div_ceil(2));
            self.line(1, &line);
        }
        self.outputs(1, "0", "1");
    }

    /// What is made of what at the start: outputs, rows, and all that these are made of.
    fn is_read_at_start(&self) -> Vec<bool> {
        let mut is_read: Vec<bool> = self.is_live.clone();
        for slot in &self.recursion.tape.outputs {
            is_read[slot.index()] = true;
        }
        for (at, rule) in
            self.recursion.rules.iter().enumerate().filter(|(at, _)| self.is_live[*at])
        {
            if let Rule::Scale(by, _) | Rule::Power(_, by) | Rule::Over(_, by) = *rule {
                is_read[by.index()] = true;
            }
            if let Rule::Choice(condition, ..) = *rule {
                is_read[condition.index()] = true;
            }
            let _ = at;
        }
        for at in (0..is_read.len()).rev().filter(|at| is_read[*at]).collect::<Vec<_>>() {
            operands(&self.recursion.tape.instructions[at], |slot| is_read[slot.index()] = true);
        }
        // An operand may have been found behind the place where the pass was.
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
    fn prepare(&mut self, at: usize) {
        if !self.is_live[at] {
            return;
        }
        match self.recursion.rules[at] {
            Rule::Quotient(_, y) | Rule::Over(_, y) => {
                self.line(1, &format!("let per{at} = 1.0 / v{};", y.0));
            }
            Rule::Power(x, _) => self.line(1, &format!("let per{at} = 1.0 / v{};", x.0)),
            Rule::Root(_) => self.line(1, &format!("let per{at} = 0.5 / v{at};")),
            Rule::Magnitude(x) => {
                self.line(1, &format!("let sign{at} = functions::sign(v{});", x.0));
            }
            Rule::Choice(condition, ..) => {
                self.line(1, &format!("let is{at} = v{} > 0.0;", condition.0));
            }
            _ => {}
        }
    }

    /// The outputs' coefficients of order `k`.
    fn outputs(&mut self, depth: usize, k: &str, next: &str) {
        let (entries, _) = self.recursion.outputs();
        let rates: Vec<_> =
            entries.iter().map(|slot| format!("by * {}", self.now(*slot, k))).collect();
        let rates = rates.join(", ");
        self.line(depth, &format!("let by = out.scale * PER_ORDER[{next}];"));
        self.line(depth, &format!("out.terms[{next}] = [{rates}];"));
        self.guards(depth, k);
    }

    fn guards(&mut self, depth: usize, k: &str) {
        let (_, guards) = self.recursion.outputs();
        for (index, slot) in guards.to_vec().into_iter().enumerate() {
            let value = self.now(slot, k);
            self.line(depth, &format!("out.guards[{index}][{k}] = {value};"));
        }
    }

    /// The coefficient of order `k` of a value.
    fn now(&self, slot: Slot, k: &str) -> String {
        match k {
            "0" => format!("v{}", slot.0),
            _ if self.recursion.is_constant(slot) => "0.0".into(),
            _ => format!("w{}", slot.0),
        }
    }

    fn orders(&mut self) {
        self.line(1, "for k in 1..out.order {");
        self.terms(2, &self.is_live.clone());
        self.outputs(2, "k", "k + 1");
        self.enter(2);
        self.line(1, "}");
    }

    /// The guards go as far as the state; of all else nobody asks for the last coefficient.
    fn last_guards(&mut self) {
        let (_, guards) = self.recursion.outputs();
        let guards = guards.to_vec();
        self.line(1, &format!("out.known_guards = {};", guards.len()));
        if guards.is_empty() {
            return;
        }
        self.line(1, "let k = out.order;");
        self.terms(1, &self.recursion.last(&guards));
        self.guards(1, "k");
    }

    /// The coefficients of order k of the values in `wanted`.
    fn terms(&mut self, depth: usize, wanted: &[bool]) {
        let reads_state = (0..wanted.len())
            .any(|at| wanted[at] && matches!(self.recursion.rules[at], Rule::State(_)));
        if reads_state {
            self.line(depth, "let x = out.terms[k];");
        }
        for group in 0..self.groups().len() {
            self.line(depth, &format!("let e{group} = lanes{group}.inner(k);"));
        }
        let wanted: Vec<_> = (0..wanted.len()).filter(|at| wanted[*at]).collect();
        self.line(depth, "let per_k = PER_ORDER[k];");
        for at in wanted {
            let Some(term) = self.term(at) else { continue };
            self.line(depth, &format!("let w{at} = {term};"));
        }
    }

    /// As many lanes at a time as fit into the registers of a common processor.
    fn groups(&self) -> Vec<Vec<Lane>> {
        const MOST: usize = 14;
        let count = self.lanes.len().div_ceil(MOST).max(1);
        let size = self.lanes.len().div_ceil(count).max(1);
        self.lanes.chunks(size).map(<[Lane]>::to_vec).collect()
    }

    /// What the orders before k add to a value's coefficient: the lane of that number.
    fn sum(&self, at: usize, number: usize) -> String {
        let groups = self.groups();
        let mut places = groups.iter().enumerate().flat_map(|(group, lanes)| {
            lanes.iter().enumerate().map(move |(lane, it)| (group, lane, it.of))
        });
        let place = places.by_ref().filter(|it| it.2.index() == at).nth(number);
        place.map_or_else(
            || "0.0".into(),
            |(group, lane, _)| format!("e{group}[{}].both()[{}]", lane / 2, lane % 2),
        )
    }

    /// Enters this order into the lanes.
    fn enter(&mut self, depth: usize) {
        for (group, lanes) in self.groups().into_iter().enumerate() {
            let list = |of: fn(&Lane) -> Factor| {
                let list: Vec<_> = lanes.iter().map(|lane| of(lane).text()).collect();
                let pair = |pair: &[String]| match pair {
                    [one, other] => format!("Pair::new({one}, {other})"),
                    rest => format!("Pair::new({}, 0.0)", rest.concat()),
                };
                list.chunks(2).map(pair).collect::<Vec<_>>().join(", ")
            };
            let (first, second) = (list(|lane| lane.first), list(|lane| lane.second));
            self.line(depth, &format!("lanes{group}.enter(k, [{first}], [{second}]);"));
        }
    }

    fn term(&self, at: usize) -> Option<String> {
        let now = |slot: Slot| self.now(slot, "k");
        let e = self.sum(at, 0);
        let is_constant = |slot: Slot| self.recursion.is_constant(slot);
        Some(match self.recursion.rules[at] {
            Rule::Constant => return None,
            Rule::State(index) => format!("x[{index}]"),
            Rule::Input(rate) => input_of(rate),
            Rule::Add(x, y) if is_constant(x) => now(y),
            Rule::Add(x, y) if is_constant(y) => now(x),
            Rule::Add(x, y) => format!("{} + {}", now(x), now(y)),
            Rule::Subtract(x, y) if is_constant(x) => format!("-{}", now(y)),
            Rule::Subtract(x, y) if is_constant(y) => now(x),
            Rule::Subtract(x, y) => format!("{} - {}", now(x), now(y)),
            Rule::Negate(x) => format!("-{}", now(x)),
            Rule::Scale(by, x) => format!("v{} * {}", by.0, now(x)),
            Rule::Product(x, y) => format!("{e} + v{0} * w{1} + w{0} * v{1}", x.0, y.0),
            Rule::Square(x) => format!("{e} + 2.0 * v{0} * w{0}", x.0),
            Rule::Quotient(x, y) => {
                format!("({} - {e} - v{at} * w{}) * per{at}", now(x), y.0)
            }
            Rule::Over(x, _) => format!("{} * per{at}", now(x)),
            Rule::Driven { slope, of } => {
                let (slope, is_negative) = self.recursion.slope(slope);
                let (open, close) = if is_negative { ("-(", ")") } else { ("", "") };
                format!("{open}{e} * per_k + w{} * v{}{close}", of.0, slope.0)
            }
            Rule::Root(x) => format!("({} - {e}) * per{at}", now(x)),
            Rule::Power(x, by) => format!(
                "((v{0} + 1.0) * {2} * per_k - {e} \
                 + v{0} * v{at} * w{1}) * per{at}",
                by.0,
                x.0,
                self.sum(at, 1)
            ),
            Rule::Magnitude(x) => format!("sign{at} * {}", now(x)),
            Rule::Choice(_, x, y) => format!("if is{at} {{ {} }} else {{ {} }}", now(x), now(y)),
        })
    }
}

/// The coefficient k of the input or a rate of it.
fn input_of(rate: u8) -> String {
    let factors: String = (1..=rate).map(|n| format!(" * (k + {n}) as f64 * per_scale")).collect();
    format!("s[k + {rate}].position{factors}").replace(" + 0", "")
}

/// A value at the start of a step.
fn start_of(instruction: &Instruction) -> String {
    match *instruction {
        Instruction::Number(number) => format!("{number:?}_f64"),
        Instruction::Argument(Argument::Constant(index)) => format!("c[{index}]"),
        Instruction::Argument(Argument::State(index)) => format!("x[{index}]"),
        Instruction::Argument(Argument::Input(0)) => "s[0].position".into(),
        Instruction::Argument(Argument::Input(rate)) => {
            let factors: String = (1..=rate).map(|n| format!(" * {n}.0 * per_scale")).collect();
            format!("s[{rate}].position{factors}")
        }
        // No derivative has any.
        Instruction::Argument(Argument::Extra(_)) => "f64::NAN".into(),
        Instruction::Add(x, y) => format!("v{} + v{}", x.0, y.0),
        Instruction::Subtract(x, y) => format!("v{} - v{}", x.0, y.0),
        Instruction::Multiply(x, y) => format!("v{} * v{}", x.0, y.0),
        Instruction::Divide(x, y) => format!("v{} / v{}", x.0, y.0),
        Instruction::Negate(x) => format!("-v{}", x.0),
        Instruction::Unary(function, x) => of_one(function, x),
        Instruction::Binary(function, x, y) => of_two(function, x, y),
        Instruction::Select(condition, x, y) => {
            format!("if v{} > 0.0 {{ v{} }} else {{ v{} }}", condition.0, x.0, y.0)
        }
    }
}

fn of_one(function: UnaryFunction, x: Slot) -> String {
    let x = format!("v{}", x.0);
    match function {
        UnaryFunction::Sin => format!("math::sin({x})"),
        UnaryFunction::Cos => format!("math::cos({x})"),
        UnaryFunction::Tanh => format!("math::tanh({x})"),
        UnaryFunction::Exp => format!("math::exp({x})"),
        UnaryFunction::Ln => format!("math::ln({x})"),
        UnaryFunction::Sqrt => format!("math::sqrt({x})"),
        UnaryFunction::Abs => format!("{x}.abs()"),
        UnaryFunction::Sign => format!("functions::sign({x})"),
        UnaryFunction::Softplus => format!("functions::softplus({x})"),
        UnaryFunction::Logistic => format!("functions::logistic({x})"),
        UnaryFunction::SoftplusArea => format!("functions::softplus_area({x})"),
        UnaryFunction::SoftplusSquareArea => format!("functions::softplus_square_area({x})"),
        UnaryFunction::Asin => format!("{x}.asin()"),
        UnaryFunction::Acos => format!("{x}.acos()"),
    }
}

fn of_two(function: BinaryFunction, x: Slot, y: Slot) -> String {
    let (x, y) = (format!("v{}", x.0), format!("v{}", y.0));
    match function {
        BinaryFunction::Atan2 => format!("math::atan2({x}, {y})"),
        BinaryFunction::Hypot => format!("math::hypot({x}, {y})"),
        BinaryFunction::Power => format!("math::powf({x}, {y})"),
        BinaryFunction::Min => format!("{x}.min({y})"),
        BinaryFunction::Max => format!("{x}.max({y})"),
    }
}

/// Shows each operand of an instruction.
fn operands(instruction: &Instruction, mut see: impl FnMut(Slot)) {
    match *instruction {
        Instruction::Number(_) | Instruction::Argument(_) => {}
        Instruction::Negate(x) | Instruction::Unary(_, x) => see(x),
        Instruction::Add(x, y)
        | Instruction::Subtract(x, y)
        | Instruction::Multiply(x, y)
        | Instruction::Divide(x, y)
        | Instruction::Binary(_, x, y) => [x, y].into_iter().for_each(see),
        Instruction::Select(x, y, z) => [x, y, z].into_iter().for_each(see),
    }
}
