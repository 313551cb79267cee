//! Text and tables in HTML.

use std::fmt::Write as _;

/// `text` with its marks of HTML made harmless.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A cell of a table.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum HtmlCell {
    /// Words, to the left.
    Words(String),
    /// A number, to the right.
    Number(String),
    /// What went wrong, over as many columns.
    Wrong(String, usize),
}

impl HtmlCell {
    /// Returns a cell with these words.
    pub fn words(text: &str) -> Self {
        Self::Words(text.to_owned())
    }

    /// A number, or nothing.
    pub(super) fn maybe(value: Option<f64>, write: impl Fn(f64) -> String) -> Self {
        Self::Number(value.map(write).unwrap_or_default())
    }
}

/// A table that can be scrolled sideways on its own.
pub fn table(header: &[&str], rows: &[Vec<HtmlCell>]) -> String {
    let mut text = "<div class=\"wide\"><table>\n<tr>".to_owned();
    for title in header {
        // Writing to a String cannot fail.
        let _written = write!(text, "<th>{}</th>", escape(title));
    }
    text += "</tr>\n";
    for row in rows {
        text += "<tr>";
        for cell in row {
            let _written = match cell {
                HtmlCell::Words(words) => write!(text, "<td>{}</td>", escape(words)),
                HtmlCell::Number(number) => write!(text, "<td class=\"n\">{}</td>", escape(number)),
                HtmlCell::Wrong(what, columns) => {
                    write!(text, "<td class=\"wrong\" colspan=\"{columns}\">{}</td>", escape(what))
                }
            };
        }
        text += "</tr>\n";
    }
    text + "</table></div>\n"
}

/// `body` behind a line that opens it.
pub(super) fn folded(title: &str, body: &str) -> String {
    format!("<details><summary>{}</summary>\n{body}</details>\n", escape(title))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_in_text_stay_text() {
        assert_eq!(escape("a<b & \"c\">"), "a&lt;b &amp; &quot;c&quot;&gt;");
        let text = table(
            &["<x>"],
            &[vec![HtmlCell::words("<script>"), HtmlCell::maybe(None, |_| String::new())]],
        );
        assert!(!text.contains("<script>") && text.contains("&lt;x&gt;"), "{text}");
    }
}
