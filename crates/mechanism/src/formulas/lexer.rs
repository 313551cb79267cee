//! Splits text into numbers, names and signs.

use std::ops::Range;

use documents::quoted;

use super::TextError;

#[derive(Clone, PartialEq, Debug)]
pub(super) struct Lexeme {
    pub(super) kind: LexemeKind,
    pub(super) span: Range<usize>,
    pub(super) is_after_space: bool,
}

#[derive(Clone, PartialEq, Debug)]
pub(super) enum LexemeKind {
    Number(f64),
    /// Name without its primes, and their number.
    Name(String, u8),
    Plus,
    Minus,
    Star,
    Slash,
    Caret,
    Open,
    Close,
    Comma,
    Greater,
    Less,
    End,
}

/// Most primes of a name, as the input has three rates.
const MOST_PRIMES: usize = 3;

/// Splits `text`; the last lexeme marks its end.
pub(super) fn lex(text: &str) -> Result<Vec<Lexeme>, TextError> {
    let mut lexer = Lexer { text, at: 0, lexemes: Vec::new(), is_after_space: false };
    while lexer.one()? {}
    Ok(lexer.lexemes)
}

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    lexemes: Vec<Lexeme>,
    is_after_space: bool,
}

impl Lexer<'_> {
    fn rest(&self) -> &str {
        self.text.get(self.at..).unwrap_or("")
    }

    /// Reads one lexeme; returns `false` at the end.
    fn one(&mut self) -> Result<bool, TextError> {
        let rest = self.rest();
        let trimmed = rest.trim_start();
        let spaces = rest.len() - trimmed.len();
        self.at += spaces;
        self.is_after_space = spaces > 0;
        let Some(first) = self.rest().chars().next() else {
            self.push(LexemeKind::End, 0);
            return Ok(false);
        };
        if first.is_ascii_digit() || first == '.' {
            return self.number().map(|()| true);
        }
        if first.is_alphabetic() || first == '_' {
            return self.name().map(|()| true);
        }
        if let Some(power) = [('²', 2.0), ('³', 3.0)].iter().find(|(it, _)| *it == first) {
            self.push(LexemeKind::Caret, 0);
            self.push(LexemeKind::Number(power.1), first.len_utf8());
            return Ok(true);
        }
        let kind = sign(first).ok_or_else(|| self.strange(first))?;
        self.push(kind, first.len_utf8());
        Ok(true)
    }

    fn push(&mut self, kind: LexemeKind, len: usize) {
        let span = self.at..self.at + len;
        self.at += len;
        let is_after_space = std::mem::take(&mut self.is_after_space);
        self.lexemes.push(Lexeme { kind, span, is_after_space });
    }

    fn strange(&self, first: char) -> TextError {
        let span = self.at..self.at + first.len_utf8();
        let message = format!("{} means nothing here", quoted(&first.to_string()));
        let help = match first {
            '=' => "write > or <; a condition on the motion is a constraint",
            '\'' => "write the prime right after a name, as theta'",
            '%' => "write percent",
            _ => "remove it",
        };
        TextError::new(span, message, help)
    }

    fn number(&mut self) -> Result<(), TextError> {
        let rest = self.rest();
        let bytes = rest.as_bytes();
        let digits = |from: usize| {
            let tail = bytes.get(from..).unwrap_or(&[]);
            from + tail.iter().take_while(|it| it.is_ascii_digit()).count()
        };
        let mut end = digits(0);
        if bytes.get(end) == Some(&b'.') {
            end = digits(end + 1);
        }
        if matches!(bytes.get(end), Some(b'e' | b'E')) {
            let signed = end + 1 + usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
            let after = digits(signed);
            // Without digits, `e` begins a unit or name.
            if after > signed {
                end = after;
            }
        }
        let written = rest.get(..end).unwrap_or("");
        match written.parse::<f64>() {
            Ok(number) if number.is_finite() => {
                self.push(LexemeKind::Number(number), end);
                Ok(())
            }
            _ => {
                let span = self.at..self.at + end;
                let message = format!("{} is no number", quoted(written));
                Err(TextError::new(span, message, "write it as 1.5 or 2e-3"))
            }
        }
    }

    fn name(&mut self) -> Result<(), TextError> {
        let rest = self.rest();
        let is_inside = |it: char| (it.is_alphanumeric() && !"²³".contains(it)) || it == '_';
        let len = rest.find(|it| !is_inside(it)).unwrap_or(rest.len());
        let name = rest.get(..len).unwrap_or("").to_owned();
        let primes = rest.get(len..).unwrap_or("").bytes().take_while(|it| *it == b'\'').count();
        if primes > MOST_PRIMES {
            let span = self.at..self.at + len + primes;
            let help = format!("there are {MOST_PRIMES} at most");
            return Err(TextError::new(span, format!("{primes} primes"), help));
        }
        let count = u8::try_from(primes).unwrap_or(u8::MAX);
        self.push(LexemeKind::Name(name, count), len + primes);
        Ok(())
    }
}

const fn sign(first: char) -> Option<LexemeKind> {
    Some(match first {
        '+' => LexemeKind::Plus,
        '-' | '−' => LexemeKind::Minus,
        '*' | '·' => LexemeKind::Star,
        '/' => LexemeKind::Slash,
        '^' => LexemeKind::Caret,
        '(' => LexemeKind::Open,
        ')' => LexemeKind::Close,
        ',' => LexemeKind::Comma,
        '>' => LexemeKind::Greater,
        '<' => LexemeKind::Less,
        _ => return None,
    })
}
