//! Parses lexemes to an expression, by binding powers.
//!
//! Long sums and products are one part each; nesting is counted, so that no pass recurses deeply.
#![expect(
    clippy::wildcard_enum_match_arm,
    reason = "a language has many pieces, and each place takes few of them"
)]

use std::ops::Range;

use documents::{choice, quoted};

use super::expression::{ExpressionPart, Form, ParsedExpression, PartShape};
use super::functions::{FUNCTIONS, Function, function};
use super::lexer::{Lexeme, LexemeKind, lex};
use super::units::{UnitPlace, UnitReader, named, unit_help};
use super::{Dimension, TextError};

/// Deepest nesting of parentheses, functions, signs and powers.
pub const DEEPEST: usize = 200;

pub const MOST_PARTS: usize = 2_000;

/// Reads `text` as a value or a condition.
///
/// # Errors
/// The first syntax error.
pub fn parse(text: &str, form: Form) -> Result<ParsedExpression, TextError> {
    let lexemes = lex(text)?;
    let mut parser = Parser { text, lexemes, at: 0, depth: 0, parts: Vec::new() };
    match form {
        Form::Value => parser.binding(BindingPower::Sum)?,
        Form::Condition => parser.condition()?,
    };
    parser.expect_end()?;
    Ok(ParsedExpression { text: text.to_owned(), parts: parser.parts })
}

/// Binding powers, the weakest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum BindingPower {
    Sum,
    Product,
    Sign,
}

struct Parser<'a> {
    text: &'a str,
    lexemes: Vec<Lexeme>,
    at: usize,
    depth: usize,
    parts: Vec<ExpressionPart>,
}

type Parsed = Result<usize, TextError>;

impl Parser<'_> {
    fn kind(&self) -> &LexemeKind {
        self.lexemes.get(self.at).map_or(&LexemeKind::End, |it| &it.kind)
    }

    fn span(&self) -> Range<usize> {
        self.lexemes.get(self.at).map_or(self.text.len()..self.text.len(), |it| it.span.clone())
    }

    fn span_of(&self, part: usize) -> Range<usize> {
        self.parts.get(part).map_or(0..0, |it| it.span.clone())
    }

    fn push(&mut self, shape: PartShape, span: Range<usize>) -> Parsed {
        if self.parts.len() >= MOST_PARTS {
            let help = "shorten it, or give parts of it names";
            return Err(TextError::new(span, "the expression is too long", help));
        }
        self.parts.push(ExpressionPart { shape, span });
        Ok(self.parts.len() - 1)
    }

    fn deeper(&mut self, inner: impl FnOnce(&mut Self) -> Parsed) -> Parsed {
        if self.depth >= DEEPEST {
            let message = format!("the expression nests more than {DEEPEST} deep");
            let help = "shorten it, or give parts of it names";
            return Err(TextError::new(self.span(), message, help));
        }
        self.depth += 1;
        let part = inner(self);
        self.depth -= 1;
        part
    }

    fn condition(&mut self) -> Parsed {
        let left = self.binding(BindingPower::Sum)?;
        let sign = self.kind().clone();
        if !matches!(sign, LexemeKind::Greater | LexemeKind::Less) {
            let help = "compare two values, as a > b";
            return Err(TextError::new(self.span(), "a comparison is missing", help));
        }
        self.at += 1;
        let right = self.binding(BindingPower::Sum)?;
        if matches!(self.kind(), LexemeKind::Greater | LexemeKind::Less) {
            let help = "compare two values only; write two conditions";
            return Err(TextError::new(self.span(), "a second comparison", help));
        }
        let span = self.span_of(left).start..self.span_of(right).end;
        let (large, small) =
            if sign == LexemeKind::Greater { (left, right) } else { (right, left) };
        self.push(PartShape::Greater(large, small), span)
    }

    fn binding(&mut self, power: BindingPower) -> Parsed {
        match power {
            BindingPower::Sum => self.chain(
                BindingPower::Product,
                (LexemeKind::Plus, LexemeKind::Minus),
                PartShape::Sum,
            ),
            BindingPower::Product => self.chain(
                BindingPower::Sign,
                (LexemeKind::Star, LexemeKind::Slash),
                PartShape::Product,
            ),
            BindingPower::Sign => self.signed(),
        }
    }

    fn chain(
        &mut self,
        tighter: BindingPower,
        (plain, inverse): (LexemeKind, LexemeKind),
        shape: fn(Vec<(usize, bool)>) -> PartShape,
    ) -> Parsed {
        let first = self.binding(tighter)?;
        let mut all = vec![(first, false)];
        while *self.kind() == plain || *self.kind() == inverse {
            let is_inverse = *self.kind() == inverse;
            self.at += 1;
            all.push((self.binding(tighter)?, is_inverse));
        }
        if all.len() == 1 {
            return Ok(first);
        }
        let last = all.last().map_or(first, |(part, _)| *part);
        let span = self.span_of(first).start..self.span_of(last).end;
        self.push(shape(all), span)
    }

    fn signed(&mut self) -> Parsed {
        let start = self.span().start;
        match self.kind() {
            LexemeKind::Minus => {
                self.at += 1;
                let inner = self.deeper(Self::signed)?;
                let span = start..self.span_of(inner).end;
                self.push(PartShape::Negative(inner), span)
            }
            LexemeKind::Plus => {
                self.at += 1;
                self.deeper(Self::signed)
            }
            _ => self.power(),
        }
    }

    /// Parses a power, which binds to the right and tighter than a sign: −x^−y is −(x^(−y)).
    fn power(&mut self) -> Parsed {
        let base = self.atom()?;
        if *self.kind() != LexemeKind::Caret {
            return Ok(base);
        }
        self.at += 1;
        let exponent = self.deeper(Self::signed)?;
        let span = self.span_of(base).start..self.span_of(exponent).end;
        self.push(PartShape::Power(base, exponent), span)
    }

    fn atom(&mut self) -> Parsed {
        let span = self.span();
        match self.kind().clone() {
            LexemeKind::Number(number) => {
                self.at += 1;
                self.number(number, span)
            }
            LexemeKind::Name(name, primes) => {
                self.at += 1;
                if *self.kind() == LexemeKind::Open {
                    return self.call(&name, primes, span);
                }
                self.push(PartShape::Name { name, primes }, span)
            }
            LexemeKind::Open => {
                self.at += 1;
                let inner = self.deeper(Self::value)?;
                self.close(&span)?;
                Ok(inner)
            }
            LexemeKind::End => {
                let help = "write a number, a name or a function";
                Err(TextError::new(span, "the expression ends too early", help))
            }
            _ => {
                let message = format!("{} stands where a value should", self.written(&span));
                Err(TextError::new(span, message, "write a number, a name or a function"))
            }
        }
    }

    fn written(&self, span: &Range<usize>) -> String {
        quoted(self.text.get(span.clone()).unwrap_or(""))
    }

    fn number(&mut self, number: f64, span: Range<usize>) -> Parsed {
        let LexemeKind::Name(name, primes) = self.kind() else {
            let plain = PartShape::Number { value: number, dimension: Dimension::NONE, unit: None };
            return self.push(plain, span);
        };
        if named(name).is_none() || *primes > 0 {
            let message = format!("{} is no unit", quoted(name));
            let help = format!("{}, or write * before a name", unit_help(name));
            return Err(TextError::new(self.span(), message, help));
        }
        let mut reader =
            UnitReader { lexemes: &self.lexemes, at: self.at, within: UnitPlace::Expression };
        let unit = reader.read()?;
        self.at = reader.at;
        let end = self.lexemes.get(self.at.saturating_sub(1)).map_or(span.end, |it| it.span.end);
        let value = unit.to_si(number);
        let shape = PartShape::Number { value, dimension: unit.dimension, unit: Some(unit.si) };
        self.push(shape, span.start..end)
    }

    fn call(&mut self, name: &str, primes: u8, span: Range<usize>) -> Parsed {
        let Some(function) = function(name).filter(|_| primes == 0) else {
            let message = format!("there is no function {}", quoted(name));
            return Err(TextError::new(span, message, choice(name, FUNCTIONS)));
        };
        let open = self.span();
        self.at += 1;
        let (shape, count) = if matches!(function, Function::Named(_)) {
            let names = self.names(name)?;
            let count = names.len();
            (PartShape::Named { function: name.to_owned(), names }, count)
        } else {
            let arguments = self.arguments(function)?;
            let count = arguments.len();
            (PartShape::Call { function: name.to_owned(), arguments }, count)
        };
        let end = self.span().end;
        self.close(&open)?;
        if count != function.arguments() {
            let message = format!("{name} has {count} arguments");
            let help = format!("it takes {}", function.arguments());
            return Err(TextError::new(span.start..end, message, help));
        }
        self.push(shape, span.start..end)
    }

    fn value(&mut self) -> Parsed {
        self.binding(BindingPower::Sum)
    }

    fn arguments(&mut self, function: Function) -> Result<Vec<usize>, TextError> {
        let mut arguments = Vec::new();
        loop {
            let is_condition = matches!(function, Function::If) && arguments.is_empty();
            let argument = if is_condition { Self::condition } else { Self::value };
            arguments.push(self.deeper(argument)?);
            if *self.kind() != LexemeKind::Comma {
                return Ok(arguments);
            }
            self.at += 1;
        }
    }

    fn names(&mut self, function: &str) -> Result<Vec<(String, Range<usize>)>, TextError> {
        let mut names = Vec::new();
        loop {
            let span = self.span();
            let LexemeKind::Name(name, 0) = self.kind().clone() else {
                let message = format!("{function} takes a name, not {}", self.written(&span));
                return Err(TextError::new(span, message, "write the name alone, as x(P)"));
            };
            self.at += 1;
            names.push((name, span));
            if *self.kind() != LexemeKind::Comma {
                return Ok(names);
            }
            self.at += 1;
        }
    }

    fn close(&mut self, open: &Range<usize>) -> Result<(), TextError> {
        if *self.kind() == LexemeKind::Close {
            self.at += 1;
            return Ok(());
        }
        if *self.kind() == LexemeKind::End {
            return Err(TextError::new(open.clone(), "this ( is not closed", "write )"));
        }
        self.expect_end()
    }

    fn expect_end(&self) -> Result<(), TextError> {
        let span = self.span();
        let help = match self.kind() {
            LexemeKind::End => return Ok(()),
            LexemeKind::Greater | LexemeKind::Less => {
                "a comparison stands only in requires, in when and first in if(…)"
            }
            LexemeKind::Close => "remove it, or open a ( before",
            LexemeKind::Comma => "remove it; arguments stand in the ( ) of a function",
            _ => "write a sign between the two, as *",
        };
        Err(TextError::new(span.clone(), format!("{} is too much here", self.written(&span)), help))
    }
}
