//! Constant expressions laid out as rustfmt does.

/// The width of a line.
pub(super) const WIDTH: usize = 100;
/// Elements of an array up to this width stand side by side.
const SHORT: usize = 10;

/// A constant expression of Rust.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Literal {
    Word(String),
    /// A text, quoted; may be broken where it is long.
    Text(String),
    Struct(&'static str, Vec<(&'static str, Self)>),
    Slice(Vec<Self>),
    Tuple(Vec<Self>),
    Some(Box<Self>),
}

impl Literal {
    /// Returns the text after `before` characters of a line that is indented by `indent`; `after`
    /// more characters follow it.
    pub(super) fn print(&self, indent: usize, before: usize, after: usize) -> String {
        let flat = self.flat();
        if before + flat.chars().count() + after <= WIDTH && !flat.contains('\n') {
            return flat;
        }
        match self {
            Self::Word(word) => word.clone(),
            Self::Text(text) => broken_text(text, indent),
            Self::Struct(name, fields) => {
                let open = format!("{name} {{");
                let lines = fields.iter().map(|(field, value)| {
                    let prefix = format!("{field}: ");
                    let before = indent + 4 + prefix.len();
                    format!("{prefix}{}", value.print(indent + 4, before, 1))
                });
                block(&open, lines, "}", indent)
            }
            Self::Slice(elements) => slice(elements, indent, before, after),
            Self::Tuple(elements) => {
                let lines = elements.iter().map(|it| it.print(indent + 4, indent + 4, 1));
                block("(", lines, ")", indent)
            }
            Self::Some(value) => format!("Some({})", value.print(indent, before + 5, after + 1)),
        }
    }

    /// The text on one line.
    fn flat(&self) -> String {
        let list = |all: &[Self]| all.iter().map(Self::flat).collect::<Vec<_>>().join(", ");
        match self {
            Self::Word(word) => word.clone(),
            Self::Text(text) => quoted(text),
            Self::Struct(name, fields) => {
                let fields: Vec<_> = fields
                    .iter()
                    .map(|(name, value)| format!("{name}: {}", value.flat()))
                    .collect();
                format!("{name} {{ {} }}", fields.join(", "))
            }
            Self::Slice(elements) => format!("&[{}]", list(elements)),
            Self::Tuple(elements) => format!("({})", list(elements)),
            Self::Some(value) => format!("Some({})", value.flat()),
        }
    }
}

fn slice(elements: &[Literal], indent: usize, before: usize, after: usize) -> String {
    if let [only] = elements {
        return format!("&[{}]", only.print(indent, before + 2, after + 1));
    }
    let flat: Vec<String> = elements.iter().map(Literal::flat).collect();
    if flat.iter().all(|it| it.chars().count() <= SHORT) {
        return block("&[", filled(&flat, indent + 4).into_iter(), "]", indent);
    }
    let lines = elements.iter().map(|it| it.print(indent + 4, indent + 4, 1));
    block("&[", lines, "]", indent)
}

/// As many elements on each line as it takes; the last of each line without its comma.
pub(super) fn filled(elements: &[String], indent: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for element in elements {
        match lines.last_mut() {
            Some(line) if indent + line.len() + 2 + element.len() + 1 < WIDTH => {
                line.push_str(", ");
                line.push_str(element);
            }
            _ => lines.push(element.clone()),
        }
    }
    lines
}

fn block(open: &str, lines: impl Iterator<Item = String>, close: &str, indent: usize) -> String {
    let inner = " ".repeat(indent + 4);
    let mut text = format!("{open}\n");
    for line in lines {
        text.push_str(&inner);
        text.push_str(&line);
        text.push_str(",\n");
    }
    text.push_str(&" ".repeat(indent));
    text.push_str(close);
    text
}

fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for character in text.chars() {
        quoted.push_str(&escaped(character));
    }
    quoted.push('"');
    quoted
}

fn escaped(character: char) -> String {
    match character {
        // Quotes of the other kind need no escape.
        '\'' => "'".to_owned(),
        '"' | '\\' => format!("\\{character}"),
        ' ' => " ".to_owned(),
        _ if character.is_whitespace() || character.is_control() || is_invisible(character) => {
            character.escape_default().to_string()
        }
        _ => character.to_string(),
    }
}

/// Whether a character has no width of its own, or turns the direction of writing.
const fn is_invisible(character: char) -> bool {
    matches!(character, '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}')
        || matches!(character, '\u{2060}'..='\u{206f}' | '\u{feff}')
}

/// A text over several lines: a backslash at the end of a line takes in the blanks that follow.
fn broken_text(text: &str, indent: usize) -> String {
    let inner = " ".repeat(indent + 4);
    let mut lines = vec![String::new()];
    for word in text.split_inclusive(' ') {
        let word: String = word.chars().map(escaped).collect();
        let width = WIDTH.saturating_sub(indent + 4 + 2);
        // Blanks at the start of a line would be lost.
        let is_full = !word.starts_with(' ')
            && lines.last().is_some_and(|line| {
                !line.is_empty() && line.chars().count() + word.chars().count() > width
            });
        if is_full {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            line.push_str(&word);
        }
    }
    format!("\"{}\"", lines.join(&format!("\\\n{inner}")))
}
