//! From an expression as people write it to one that exmex reads alike.
//!
//! exmex takes −t^2 for (−t)^2, 2^3^2 for (2^3)^2 and does not know 1e-3; here it is
//! mathematics as usual. The expression is read by its grammar and written out with all
//! its parentheses:
//!
//! ```text
//! sum     = product (("+" | "-") product)*
//! product = signed (("*" | "/") signed)*
//! signed  = ("+" | "-") signed | power
//! power   = atom ("^" signed)?
//! atom    = number | constant | "t" | function "(" sum ")" | "(" sum ")"
//! ```

use std::iter::Peekable;
use std::str::CharIndices;

use diagnostics::nearest;

/// Functions of one argument, as exmex calls them.
const FUNCTIONS: &[&str] = &[
    "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh",
    "exp", "ln", "log", "log2", "log10", "sqrt", "cbrt", "abs", "signum", "floor", "ceil", "round",
    "trunc", "fract",
];

/// Constants, and what exmex calls them.
const CONSTANTS: &[(&str, &str)] = &[
    ("pi", "PI"),
    ("PI", "PI"),
    ("π", "PI"),
    ("tau", "TAU"),
    ("TAU", "TAU"),
    ("τ", "TAU"),
    ("e", "E"),
    ("E", "E"),
];

/// Parentheses, signs and powers inside one another.
const MOST_DEPTH: usize = 100;
/// Operators and functions in all: forty bells or so; more is a job for a table.
const MOST_OPERATIONS: usize = 250;

/// What is wrong, and at which byte of the text.
#[derive(Debug)]
pub(super) struct Misspelt {
    pub(super) at: usize,
    pub(super) problem: String,
}

/// `text` with all its parentheses.
pub(super) fn spelt_out(text: &str) -> Result<String, Misspelt> {
    let mut reader =
        ExpressionReader { text, rest: text.char_indices().peekable(), depth: 0, operations: 0 };
    let sum = reader.sum()?;
    match reader.peek() {
        None => Ok(sum),
        Some((at, _)) => {
            Err(Misspelt { at, problem: format!("expected an operator, not `{}`", reader.word()) })
        }
    }
}

struct ExpressionReader<'a> {
    text: &'a str,
    rest: Peekable<CharIndices<'a>>,
    depth: usize,
    operations: usize,
}

impl<'a> ExpressionReader<'a> {
    /// The next character that is not a space, with its byte.
    fn peek(&mut self) -> Option<(usize, char)> {
        while self.rest.next_if(|(_, c)| c.is_whitespace()).is_some() {}
        self.rest.peek().copied()
    }

    /// Where reading has come to, in bytes.
    fn at(&mut self) -> usize {
        self.peek().map_or(self.text.len(), |(at, _)| at)
    }

    fn take(&mut self, wanted: &[char]) -> Option<char> {
        self.peek()?;
        self.rest.next_if(|(_, c)| wanted.contains(c)).map(|(_, c)| c)
    }

    /// Takes the longest run of characters that `belong`.
    fn run(&mut self, belong: impl Fn(char) -> bool) -> &'a str {
        let start = self.at();
        let mut end = start;
        while let Some((at, c)) = self.rest.next_if(|(_, c)| belong(*c)) {
            end = at + c.len_utf8();
        }
        &self.text[start..end]
    }

    /// The next word, number or sign, for a message.
    fn word(&mut self) -> String {
        let word = self.run(|c| c.is_alphanumeric() || c == '_' || c == '.');
        match self.rest.peek() {
            Some((_, c)) if word.is_empty() => c.to_string(),
            _ => word.to_owned(),
        }
    }

    fn sum(&mut self) -> Result<String, Misspelt> {
        self.chain(&['+', '-'], Self::product)
    }

    fn product(&mut self) -> Result<String, Misspelt> {
        self.chain(&['*', '/'], Self::signed)
    }

    /// Operands with operators of one rank between them, from left to right.
    fn chain(
        &mut self,
        operators: &[char],
        operand: fn(&mut Self) -> Result<String, Misspelt>,
    ) -> Result<String, Misspelt> {
        let mut left = operand(self)?;
        while let Some(operator) = self.take(operators) {
            self.count()?;
            let right = operand(self)?;
            left = format!("({left}{operator}{right})");
        }
        Ok(left)
    }

    fn signed(&mut self) -> Result<String, Misspelt> {
        self.deeper(|reader| match reader.take(&['+', '-']) {
            Some('-') => {
                reader.count()?;
                Ok(format!("(-{})", reader.signed()?))
            }
            Some(_) => reader.signed(),
            None => reader.power(),
        })
    }

    fn power(&mut self) -> Result<String, Misspelt> {
        let base = self.atom()?;
        match self.take(&['^']) {
            Some(_) => {
                self.count()?;
                Ok(format!("({base}^{})", self.signed()?))
            }
            None => Ok(base),
        }
    }

    fn atom(&mut self) -> Result<String, Misspelt> {
        let at = self.at();
        match self.peek() {
            Some((_, '(')) => self.parentheses(),
            Some((_, c)) if c.is_ascii_digit() || c == '.' => self.number(),
            Some((_, c)) if c.is_alphabetic() || c == '_' => self.name(),
            Some((_, c)) => Err(Misspelt { at, problem: format!("expected a value, not `{c}`") }),
            None => Err(Misspelt { at, problem: "expected a value, and here is the end".into() }),
        }
    }

    fn parentheses(&mut self) -> Result<String, Misspelt> {
        let at = self.at();
        if self.take(&['(']).is_none() {
            return Err(Misspelt { at, problem: "expected `(`".into() });
        }
        let sum = self.sum()?;
        if self.take(&[')']).is_none() {
            return Err(Misspelt { at, problem: "this `(` is not closed".into() });
        }
        Ok(format!("({sum})"))
    }

    /// A number, written out without an exponent and to its last bit.
    fn number(&mut self) -> Result<String, Misspelt> {
        let at = self.at();
        self.run(|c| c.is_ascii_digit() || c == '.');
        let mut ahead = self.rest.clone();
        if ahead.next_if(|(_, c)| matches!(c, 'e' | 'E')).is_some() {
            ahead.next_if(|(_, c)| matches!(c, '+' | '-'));
            if ahead.peek().is_some_and(|(_, c)| c.is_ascii_digit()) {
                self.rest = ahead;
                self.run(|c| c.is_ascii_digit());
            }
        }
        let end = self.rest.peek().map_or(self.text.len(), |(at, _)| *at);
        let text = &self.text[at..end];
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(format!("{number}")),
            _ => Err(Misspelt { at, problem: format!("`{text}` is not a number") }),
        }
    }

    fn name(&mut self) -> Result<String, Misspelt> {
        let at = self.at();
        let name = self.run(|c| c.is_alphanumeric() || c == '_');
        if name == "t" {
            return Ok("t".into());
        }
        if let Some((_, constant)) = CONSTANTS.iter().find(|(known, _)| *known == name) {
            return Ok((*constant).into());
        }
        if FUNCTIONS.contains(&name) {
            self.count()?;
            return match self.peek() {
                Some((_, '(')) => Ok(format!("({name}{})", self.parentheses()?)),
                _ => Err(Misspelt { at, problem: format!("write {name}(…), with parentheses") }),
            };
        }
        let near = nearest(name, FUNCTIONS);
        let hint = near.map_or_else(
            || "the variable is t, and there are pi, e, tau and functions such as sin".into(),
            |near| format!("did you mean `{near}`?"),
        );
        Err(Misspelt { at, problem: format!("there is no `{name}`; {hint}") })
    }

    fn count(&mut self) -> Result<(), Misspelt> {
        self.operations += 1;
        if self.operations > MOST_OPERATIONS {
            let problem = format!("more than {MOST_OPERATIONS} operations: give a CSV file");
            return Err(Misspelt { at: self.at(), problem });
        }
        Ok(())
    }

    fn deeper(
        &mut self,
        read: impl FnOnce(&mut Self) -> Result<String, Misspelt>,
    ) -> Result<String, Misspelt> {
        if self.depth == MOST_DEPTH {
            return Err(Misspelt { at: self.at(), problem: "too many parentheses".into() });
        }
        self.depth += 1;
        let text = read(self);
        self.depth -= 1;
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(text: &str, expected: &str) {
        assert_eq!(spelt_out(text).expect("an expression"), expected);
    }

    #[track_caller]
    fn check_misspelt(text: &str, at: usize, expected: &str) {
        let misspelt = spelt_out(text).expect_err("a mistake");
        assert_eq!((misspelt.at, misspelt.problem.as_str()), (at, expected));
    }

    #[test]
    fn signs_and_powers_bind_as_in_mathematics() {
        check("-t^2", "(-(t^2))");
        check("2^-t^2", "(2^(-(t^2)))");
        check("2^3^2", "(2^(3^2))");
        check("2*-t", "(2*(-t))");
        check("1-2+3", "((1-2)+3)");
        check("1/2*3", "((1/2)*3)");
        check("+exp ( t )", "(exp(t))");
    }

    #[test]
    fn numbers_keep_their_last_bit() {
        check("1e-3*t", "(0.001*t)");
        check(".5", "0.5");
        check("1.5E+2", "150");
        let text = spelt_out("1.2345678901234567e-300").expect("a number");
        assert_eq!(text.parse(), Ok(1.234_567_890_123_456_7e-300));
    }

    #[test]
    fn what_cannot_be_read_is_named_with_its_place() {
        check_misspelt("", 0, "expected a value, and here is the end");
        check_misspelt("2t", 1, "expected an operator, not `t`");
        check_misspelt("(t+1", 0, "this `(` is not closed");
        check_misspelt("t+1)", 3, "expected an operator, not `)`");
        check_misspelt("2**t", 2, "expected a value, not `*`");
        check_misspelt("1.2.3", 0, "`1.2.3` is not a number");
        check_misspelt("1e999", 0, "`1e999` is not a number");
        check_misspelt("sni(t)", 0, "there is no `sni`; did you mean `sin`?");
        check_misspelt("sin t", 0, "write sin(…), with parentheses");
        check_misspelt(
            "2*xylophone",
            2,
            "there is no `xylophone`; the variable is t, and there are pi, e, tau and functions \
             such as sin",
        );
    }
}
