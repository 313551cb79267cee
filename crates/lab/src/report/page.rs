//! A self-contained HTML page, and the files beside it.

use std::{fmt::Write as _, path::Path};

use super::{DiskError, PAGE, write_file};
use figures::{digits::rounded, plot::picture::Picture};

const STYLE: &str = include_str!("style.css");

/// A report of a study.
#[derive(Clone, Debug)]
pub struct Report {
    title: String,
    body: String,
    files: Vec<(String, String)>,
}

/// A table for the page, for CSV, or both.
#[derive(Clone, PartialEq, Debug)]
pub struct Table {
    /// CSV name of each column, and its title on the page; empty if it is not shown there.
    columns: Vec<(String, String)>,
    pub rows: Vec<Vec<TableCell>>,
}

/// A cell of a table.
#[derive(Clone, PartialEq, Debug)]
pub enum TableCell {
    Words(String),
    /// Number: all digits in CSV, four on the page.
    Number(f64),
    Missing,
    WrongWords(String),
    WrongNumber(f64),
}

impl TableCell {
    pub fn words(words: impl Into<String>) -> Self {
        Self::Words(words.into())
    }

    pub fn maybe(number: Option<f64>) -> Self {
        number.map_or(Self::Missing, Self::Number)
    }

    fn text(&self, number: impl Fn(f64) -> String) -> String {
        match self {
            Self::Words(words) | Self::WrongWords(words) => words.clone(),
            Self::Number(it) | Self::WrongNumber(it) => number(*it),
            Self::Missing => String::new(),
        }
    }

    const fn class(&self) -> &'static str {
        match self {
            Self::Words(_) | Self::Missing => "",
            Self::Number(_) => " class=\"n\"",
            Self::WrongWords(_) | Self::WrongNumber(_) => " class=\"wrong\"",
        }
    }
}

impl Table {
    /// Returns a table without rows; columns are pairs of a CSV name and a title on the page.
    pub fn new<N: Into<String>, T: Into<String>>(
        columns: impl IntoIterator<Item = (N, T)>,
    ) -> Self {
        let columns = columns.into_iter().map(|(name, title)| (name.into(), title.into()));
        Self { columns: columns.collect(), rows: Vec::new() }
    }

    #[must_use]
    pub fn with<R: Into<Vec<TableCell>>>(mut self, rows: impl IntoIterator<Item = R>) -> Self {
        self.rows.extend(rows.into_iter().map(Into::into));
        self
    }

    /// Returns the columns whose CSV name is one to `keep`.
    #[must_use]
    pub fn columns(&self, keep: impl Fn(&str) -> bool) -> Self {
        let kept: Vec<_> =
            (0..self.columns.len()).filter(|it| keep(&self.columns[*it].0)).collect();
        let row = |row: &Vec<TableCell>| kept.iter().map(|it| row[*it].clone()).collect::<Vec<_>>();
        Self::new(kept.iter().map(|it| self.columns[*it].clone())).with(self.rows.iter().map(row))
    }

    fn csv(&self) -> String {
        let names = self.columns.iter().map(|(name, _)| name.clone()).collect();
        let rows = self.rows.iter().map(|row| row.iter().map(|it| it.text(|it| format!("{it:?}"))));
        let lines = std::iter::once(names).chain(rows.map(Iterator::collect::<Vec<_>>));
        lines
            .map(|fields| fields.iter().map(|it| field(it)).collect::<Vec<_>>().join(",") + "\n")
            .collect()
    }

    fn html(&self) -> String {
        let mut text = "<div class=\"wide\"><table>\n<tr>".to_owned();
        let is_shown = |it: &usize| !self.columns[*it].1.is_empty();
        let shown: Vec<_> = (0..self.columns.len()).filter(is_shown).collect();
        for column in &shown {
            let _written = write!(text, "<th>{}</th>", escape(&self.columns[*column].1));
        }
        text += "</tr>\n";
        for row in &self.rows {
            text += "<tr>";
            for cell in shown.iter().map(|column| &row[*column]) {
                let words = escape(&cell.text(rounded));
                let _written = write!(text, "<td{}>{words}</td>", cell.class());
            }
            text += "</tr>\n";
        }
        text + "</table></div>\n"
    }
}

impl Report {
    pub fn new(title: impl Into<String>) -> Self {
        Self { title: title.into(), body: String::new(), files: Vec::new() }
    }

    pub fn introduce(&mut self, text: &str) {
        self.html("p class=\"read\"", text);
    }

    pub fn heading(&mut self, text: &str) {
        self.html("h2", text);
    }

    /// Adds a paragraph of plain text; HTML is escaped.
    pub fn text(&mut self, text: &str) {
        self.html("p", text);
    }

    fn html(&mut self, tag: &str, text: &str) {
        let end = tag.split(' ').next().unwrap_or(tag);
        let _written = writeln!(self.body, "<{tag}>{}</{end}>", escape(text));
    }

    pub(super) fn marked_up(&mut self, html: &str) {
        self.body += html;
    }

    pub fn table(&mut self, table: &Table) {
        if !table.rows.is_empty() {
            self.body += &table.html();
        }
    }

    /// Adds a table that is folded under `title`.
    pub fn folded(&mut self, title: &str, table: &Table) {
        let (title, html) = (escape(title), table.html());
        self.body +=
            &["<details><summary>", &title, "</summary>\n", &html, "</details>\n"].concat();
    }

    pub fn picture(&mut self, name: &str, picture: &Picture) {
        self.drawing(name, picture.svg());
    }

    pub fn drawing(&mut self, name: &str, svg: String) {
        self.body += &["<figure>\n", &svg, "</figure>\n"].concat();
        self.file(format!("{name}.svg"), svg);
    }

    pub fn csv(&mut self, name: &str, table: &Table) {
        self.file(format!("{name}.csv"), table.csv());
    }

    pub fn file(&mut self, name: impl Into<String>, text: String) {
        self.files.push((name.into(), text));
    }

    /// Writes the files, and the page last, into `folder`.
    ///
    /// # Errors
    /// If a file cannot be written; files written before are complete.
    pub fn write(&self, folder: &Path) -> Result<(), DiskError> {
        for (name, text) in &self.files {
            write_file(&folder.join(name), text)?;
        }
        write_file(&folder.join(PAGE), &self.page())
    }

    fn page(&self) -> String {
        let (title, body) = (escape(&self.title), &self.body);
        format!(
            "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>Letoff: {title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
             <h1>{title}</h1>\n{body}</body>\n</html>\n"
        )
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

fn field(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        return format!("\"{}\"", text.replace('"', "\"\""));
    }
    text.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_the_same_on_the_page_and_as_csv() {
        let source = || TableCell::words("long");
        let table = Table::new([("name", "the <name>"), ("value", "value [1]"), ("source", "")])
            .with([
                [TableCell::words("a, \"b\""), TableCell::Number(1.0 / 3.0), source()],
                [TableCell::words("<script>"), TableCell::Missing, source()],
                [TableCell::words("c"), TableCell::WrongNumber(2.0), source()],
            ]);
        assert_eq!(
            table.csv(),
            "name,value,source\n\"a, \"\"b\"\"\",0.3333333333333333,long\n<script>,,long\nc,2.0,long\n"
        );
        let mut report = Report::new("A & B");
        report.table(&table);
        let page = report.page();
        assert!(!page.contains("<script>") && page.contains("<th>the &lt;name&gt;</th>"), "{page}");
        assert!(
            page.contains("<td class=\"n\">0.3333</td>") && page.contains("A &amp; B"),
            "{page}"
        );
        assert!(page.contains("<td class=\"wrong\">2</td>") && !page.contains("long"), "{page}");
    }
}
