//! The golden vectors beside the crate: comments, then lines `name = value`.

use std::path::{Path, PathBuf};

pub(crate) struct Vector {
    pub(crate) name: String,
    lines: Vec<(String, String)>,
}

impl Vector {
    pub(crate) fn text(&self, name: &str) -> &str {
        let line = self.lines.iter().find(|(key, _)| key == name);
        line.map_or_else(|| panic!("{}: no {name}", self.name), |(_, value)| value.as_str())
    }

    pub(crate) fn numbers<T: TryFrom<i128>>(&self, name: &str) -> Vec<T> {
        let number = |item: &str| T::try_from(item.parse::<i128>().ok()?).ok();
        let numbers = self.text(name).split_whitespace().map(number).collect::<Option<Vec<T>>>();
        numbers.unwrap_or_else(|| panic!("{}: {name} out of range", self.name))
    }

    pub(crate) fn number<T: TryFrom<i128>>(&self, name: &str) -> T {
        let numbers = self.numbers(name);
        <[T; 1]>::try_from(numbers).ok().map(|[number]| number).expect("one number")
    }

    pub(crate) fn bytes(&self, name: &str) -> Vec<Vec<u8>> {
        self.text(name).split_whitespace().map(hex).collect()
    }

    pub(crate) fn frame(&self) -> Vec<u8> {
        self.bytes("frame").concat()
    }

    /// Returns the record's fields: those between `last` and the bytes.
    pub(crate) fn fields_after(&self, last: &str) -> impl Iterator<Item = (&str, &str)> {
        let behind = self.lines.iter().skip_while(move |(key, _)| key != last).skip(1);
        behind.take_while(|(key, _)| key != "frame").map(|(key, value)| (&**key, &**value))
    }
}

fn hex(digits: &str) -> Vec<u8> {
    let byte = |i| u8::from_str_radix(&digits[i..i + 2], 16).expect("two hex digits");
    (0..digits.len()).step_by(2).map(byte).collect()
}

pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("vectors")
}

pub(crate) fn all() -> Vec<Vector> {
    let files = std::fs::read_dir(folder()).expect("the folder of vectors");
    let mut paths: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|end| end == "hex"));
    paths.sort();
    paths.iter().map(|path| read(path)).collect()
}

fn read(path: &Path) -> Vector {
    let text = std::fs::read_to_string(path).expect("a vector");
    let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
    let lines = text.lines().filter(|line| !line.starts_with('#')).map(|line| {
        let (key, value) = line.split_once(" =").expect("name = value");
        (key.to_owned(), value.trim().to_owned())
    });
    Vector { lines: lines.collect(), name }
}
