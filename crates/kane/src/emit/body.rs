//! One function: a straight line of `let`s.

use std::collections::{BTreeMap, HashMap};

use super::expression::{Binding, RustExpression};
use super::number;
use super::scope::ArgumentNames;
use crate::graph::{BinaryFunction, UnaryFunction};
use crate::tape::{AngleGroup, AngleValues, Argument, Instruction, Tape, TapeSlot};

/// The widest expression that is written into the one that uses it.
const WIDEST: usize = 48;
/// The widest expression of a statement.
const LINE: usize = 80;
/// The widest statement that is written on one line.
const STATEMENT: usize = 96;

/// A function's statements while they are written.
pub(super) struct FunctionBody<'a> {
    tape: &'a Tape,
    uses: Vec<u32>,
    values: HashMap<TapeSlot, RustExpression>,
    names: ArgumentNames,
    lines: Vec<String>,
    unnamed: usize,
}

impl<'a> FunctionBody<'a> {
    /// Returns the statements that read arguments and compute all but the outputs.
    pub(super) fn new(tape: &'a Tape, names: &ArgumentNames) -> Self {
        let mut body = Self {
            tape,
            uses: tape.uses(),
            values: HashMap::new(),
            names: names.clone(),
            lines: Vec::new(),
            unnamed: 0,
        };
        body.arguments();
        let groups: BTreeMap<usize, AngleGroup> = tape.angle_groups().into_iter().collect();
        for (at, instruction) in tape.instructions.iter().enumerate() {
            if let Some(group) = groups.get(&at) {
                body.group(group);
            }
            if body.uses[at] > 0 {
                body.instruction(TapeSlot(u32::try_from(at).unwrap_or(u32::MAX)), *instruction);
            }
        }
        body
    }

    /// Returns the statements with those that write the outputs.
    pub(super) fn finish(mut self) -> Vec<String> {
        let outputs = &self.tape.outputs;
        if outputs.is_empty() {
            return self.lines;
        }
        self.lines.push(format!("let out = out.first_chunk_mut::<{}>()?;", outputs.len()));
        let mut together = Vec::new();
        for (at, slot) in outputs.iter().enumerate() {
            let value = self.value(*slot).text;
            if !fits(&together, at, &value) {
                self.lines.extend(assignment(&together));
                together.clear();
            }
            together.push((at, value));
        }
        self.lines.extend(assignment(&together));
        self.lines
    }

    /// Whether any argument is read.
    pub(super) fn reads_arguments(tape: &Tape) -> bool {
        tape.instructions.iter().any(|it| matches!(it, Instruction::Argument(_)))
    }

    /// Reads each argument once, in order; those without names of their own stand where they are used.
    fn arguments(&mut self) {
        let counts = self.tape.argument_counts();
        let lists =
            [("constants", counts.constants), ("state", counts.state), ("extra", counts.extra)];
        for (list, count) in lists {
            if count > 0 {
                self.lines.push(format!("let {list} = given.{list}.first_chunk::<{count}>()?;"));
            }
        }
        if counts.input > 0 {
            self.lines.push("let input = given.input;".to_owned());
        }
        let mut reads: BTreeMap<Argument, Vec<TapeSlot>> = BTreeMap::new();
        for (at, instruction) in (0..).zip(&self.tape.instructions) {
            if let Instruction::Argument(argument) = instruction {
                reads.entry(*argument).or_default().push(TapeSlot(at));
            }
        }
        for (argument, slots) in reads {
            let (name, read) = self.names.of(argument);
            if name != read {
                self.lines.push(format!("let {name} = {read};"));
            }
            self.values.extend(slots.iter().map(|it| (*it, RustExpression::atom(name.clone()))));
        }
    }

    fn value(&self, slot: TapeSlot) -> RustExpression {
        self.values
            .get(&slot)
            .cloned()
            .unwrap_or_else(|| RustExpression::atom("f64::NAN".to_owned()))
    }

    fn instruction(&mut self, slot: TapeSlot, instruction: Instruction) {
        let infix = |body: &mut Self, x, operator, y| {
            let (x, y) = body.fitting(x, y);
            RustExpression::infix(&x, operator, &y)
        };
        let value = match instruction {
            Instruction::Argument(_)
            | Instruction::Unary(UnaryFunction::Sin | UnaryFunction::Cos, _) => return,
            Instruction::Number(number) => RustExpression::number(number::literal(number)),
            Instruction::Add(x, y) => infix(self, x, "+", y),
            Instruction::Subtract(x, y) => infix(self, x, "-", y),
            Instruction::Multiply(x, y) => infix(self, x, "*", y),
            Instruction::Divide(x, y) => infix(self, x, "/", y),
            Instruction::Negate(x) => RustExpression::negated(&self.value(x)),
            Instruction::Unary(UnaryFunction::Abs, x) => {
                RustExpression::atom(format!("{}.abs()", self.value(x).within(Binding::Atom)))
            }
            Instruction::Unary(function, x) => {
                RustExpression::call(unary(function), &[&self.value(x)])
            }
            Instruction::Binary(function, x, y) => {
                let (x, y) = self.fitting(x, y);
                RustExpression::call(binary(function), &[&x, &y])
            }
            Instruction::Select(condition, positive, other) => {
                let [condition, positive, other] =
                    [condition, positive, other].map(|it| self.short(it).text);
                let text = format!("if {condition} > 0.0 {{ {positive} }} else {{ {other} }}");
                self.bind(slot, &text);
                return;
            }
        };
        let is_number = matches!(instruction, Instruction::Number(_));
        let is_short = value.text.len() <= WIDEST && self.uses[slot.index()] == 1;
        if is_number || is_short {
            self.values.insert(slot, value);
        } else {
            self.bind(slot, &value.text);
        }
    }

    /// Two operands; the longer gets a name first where both would not fit on one line.
    fn fitting(&mut self, x: TapeSlot, y: TapeSlot) -> (RustExpression, RustExpression) {
        let width = |body: &Self, slot| body.value(slot).text.len();
        if width(self, x) + width(self, y) > LINE {
            let longer = if width(self, x) >= width(self, y) { x } else { y };
            let text = self.value(longer).text;
            self.bind(longer, &text);
        }
        (self.value(x), self.value(y))
    }

    /// An operand that is a name or a short expression.
    fn short(&mut self, slot: TapeSlot) -> RustExpression {
        const SHORT: usize = 24;
        let value = self.value(slot);
        if value.text.len() > SHORT {
            self.bind(slot, &value.text);
        }
        self.value(slot)
    }

    fn bind(&mut self, slot: TapeSlot, text: &str) {
        let name = format!("v{}", self.unnamed);
        self.unnamed += 1;
        self.lines.push(format!("let {name} = {text};"));
        self.values.insert(slot, RustExpression::atom(name));
    }

    /// Sines and cosines that are computed together.
    fn group(&mut self, group: &AngleGroup) {
        match group {
            AngleGroup::One(angle) => self.one_angle(angle),
            AngleGroup::Two([first, second]) => {
                let (x, y) = (self.short(first.angle).text, self.short(second.angle).text);
                let [a, b] = [first, second].map(|it| self.name_both(it));
                let names = format!("let ([{}, {}], [{}, {}]) =", a.0, b.0, a.1, b.1);
                let value = format!("math::sin_cos_of_two([{x}, {y}]);");
                if names.len() + 1 + value.len() <= STATEMENT {
                    self.lines.push(format!("{names} {value}"));
                } else {
                    self.lines.push(names);
                    self.lines.push(format!("    {value}"));
                }
            }
        }
    }

    fn one_angle(&mut self, values: &AngleValues) {
        let angle = self.short(values.angle).text;
        let (sine, cosine) = self.name_both(values);
        let statement = match (values.sine, values.cosine) {
            (Some(_), None) => format!("let {sine} = math::sin_cos({angle}).0;"),
            (None, Some(_)) => format!("let {cosine} = math::sin_cos({angle}).1;"),
            _ => format!("let ({sine}, {cosine}) = math::sin_cos({angle});"),
        };
        self.lines.push(statement);
    }

    /// Names of sine and cosine; `_` of one that nobody uses.
    fn name_both(&mut self, values: &AngleValues) -> (String, String) {
        let angle = self.value(values.angle).text;
        let mut name = |function: &str, function_of: UnaryFunction, slot: Option<TapeSlot>| {
            if slot.is_none() {
                return "_".to_owned();
            }
            let name = self.names.taken.take_long(&format!("{function}_{angle}"), 28);
            let all = (0..).map(TapeSlot).zip(&self.tape.instructions);
            let wanted = Instruction::Unary(function_of, values.angle);
            for (slot, _) in all.filter(|(_, it)| **it == wanted) {
                self.values.insert(slot, RustExpression::atom(name.clone()));
            }
            name
        };
        let sine = name("sin", UnaryFunction::Sin, values.sine);
        (sine, name("cos", UnaryFunction::Cos, values.cosine))
    }
}

/// Whether a value is written to `out[at]` together with others on one line: all must be short.
fn fits(others: &[(usize, String)], at: usize, value: &str) -> bool {
    const SHORT: usize = 12;
    let is_short = others.iter().all(|it| it.1.len() <= SHORT) && value.len() <= SHORT;
    let more = [others, &[(at, value.to_owned())]].concat();
    is_short && assignment(&more).is_some_and(|line| line.len() <= STATEMENT)
}

/// The statement that writes values to their places.
fn assignment(all: &[(usize, String)]) -> Option<String> {
    let places: Vec<_> = all.iter().map(|(at, _)| format!("out[{at}]")).collect();
    let values: Vec<_> = all.iter().map(|(_, value)| value.as_str()).collect();
    match all {
        [] => None,
        [(at, value)] => Some(format!("out[{at}] = {value};")),
        _ => Some(format!("[{}] = [{}];", places.join(", "), values.join(", "))),
    }
}

/// The path of a function; sine, cosine and magnitude are written otherwise.
const fn unary(function: UnaryFunction) -> &'static str {
    match function {
        UnaryFunction::Sin => "math::sin",
        UnaryFunction::Cos => "math::cos",
        UnaryFunction::Abs => "f64::abs",
        UnaryFunction::Tanh => "math::tanh",
        UnaryFunction::Exp => "math::exp",
        UnaryFunction::Ln => "math::ln",
        UnaryFunction::Sqrt => "math::sqrt",
        UnaryFunction::Asin => "math::asin",
        UnaryFunction::Acos => "math::acos",
        UnaryFunction::Sign => "functions::sign",
        UnaryFunction::Softplus => "functions::softplus",
        UnaryFunction::Logistic => "functions::logistic",
        UnaryFunction::SoftplusArea => "functions::softplus_area",
        UnaryFunction::SoftplusSquareArea => "functions::softplus_square_area",
    }
}

const fn binary(function: BinaryFunction) -> &'static str {
    match function {
        BinaryFunction::Atan2 => "math::atan2",
        BinaryFunction::Hypot => "math::hypot",
        BinaryFunction::Power => "math::powf",
        BinaryFunction::Min => "functions::smaller",
        BinaryFunction::Max => "functions::larger",
    }
}
