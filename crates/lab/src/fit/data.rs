//! Reads measured strokes from CSV files, and reports every mistake in them.

use std::{fmt, path::Path};

use csv::{ReaderBuilder, StringRecord, Trim};
use documents::{choice, quoted, shown};

/// Allowed columns; the first is optional.
const COLUMNS: [&str; 3] = ["time_s", "travel_m", "force_n"];
const MOST_MISTAKES: usize = 10;
const FEWEST_ROWS: usize = 5;
/// Gap without rows, in median intervals.
const GAP: f64 = 10.0;
/// Gap of a static curve, as a fraction of its travel.
const TRAVEL_GAP: f64 = 0.34;
/// Noise of the travel above the key's rest that is accepted (m).
const ABOVE_REST: f64 = 0.5e-3;
/// Least and largest travel of a stroke (m).
const TRAVELS: (f64, f64) = (0.3e-3, 0.2);
/// Fraction of its travel by which a static curve may reverse.
const BACK: f64 = 0.05;
/// Shortest distance of two rows of a static curve (m).
const SHORTEST_WAY: f64 = 1e-6;

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct StrokeRow {
    /// Time (s).
    pub(super) t: f64,
    /// Travel of the key's front (m), down positive.
    pub(super) travel: f64,
    /// Force of the key on the finger (N), up positive.
    pub(super) force: f64,
}

/// A stroke from a file.
#[derive(Clone, PartialEq, Debug)]
pub struct MeasuredStroke {
    pub name: String,
    /// `true` if the file has no times: the key goes down and up at a constant speed.
    pub is_static: bool,
    pub(super) rows: Vec<StrokeRow>,
}

impl MeasuredStroke {
    pub const fn len(&self) -> usize {
        self.rows.len()
    }

    /// Returns `true` if it has no rows, which a stroke from a file always has.
    pub const fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

/// A mistake in a file of data.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct DataMistake {
    file: String,
    line: Option<u64>,
    what: String,
}

impl fmt::Display for DataMistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let line = self.line.map_or_else(String::new, |line| format!(", line {line}"));
        write!(f, "{}{line}: {}", self.file, self.what)
    }
}

/// Reads a stroke, or its mistakes; a file without times is a static curve at `speed` (m/s).
pub fn read_stroke(path: &Path, speed: f64) -> Result<MeasuredStroke, Vec<DataMistake>> {
    let file = shown(path);
    let mut scan = StrokeScan { file, places: [None; 3], rows: Vec::new(), mistakes: Vec::new() };
    let mut reader = ReaderBuilder::new();
    let reader = reader.has_headers(false).flexible(true).trim(Trim::All);
    match documents::open_input(path) {
        Ok(file) => scan.read(reader.from_reader(file)),
        Err(error) => scan.say(None, format!("cannot be read: {error}")),
    }
    if scan.mistakes.is_empty() {
        scan.check();
    }
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    scan.finish(name, speed)
}

struct StrokeScan {
    file: String,
    places: [Option<usize>; 3],
    rows: Vec<(u64, [f64; 3])>,
    mistakes: Vec<DataMistake>,
}

impl StrokeScan {
    fn say(&mut self, line: Option<u64>, what: String) {
        self.mistakes.push(DataMistake { file: self.file.clone(), line, what });
    }

    fn read(&mut self, mut reader: csv::Reader<std::fs::File>) {
        for (row, record) in reader.records().enumerate() {
            match record {
                Err(error) => return self.say(None, format!("cannot be read: {error}")),
                Ok(record) if row == 0 => self.header(&record),
                // Rows are skipped until all required columns are known.
                Ok(record) if self.places[1..].iter().all(Option::is_some) => self.row(&record),
                Ok(_row) => {}
            }
        }
    }

    fn header(&mut self, record: &StringRecord) {
        for (place, name) in record.iter().enumerate() {
            let name = name.trim_start_matches('\u{feff}');
            match COLUMNS.iter().position(|it| *it == name) {
                Some(column) if self.places[column].is_some() => {
                    self.say(Some(1), format!("{name} is there twice; remove one of the columns"));
                }
                Some(column) => self.places[column] = Some(place),
                None => {
                    let help = choice(name, COLUMNS);
                    self.say(Some(1), format!("there is no column {}: {help}", quoted(name)));
                }
            }
        }
        for column in [1, 2] {
            if self.places[column].is_none() {
                let what = format!(
                    "the column {} is missing; the first line names the columns {}",
                    COLUMNS[column],
                    COLUMNS.join(",")
                );
                self.say(Some(1), what);
            }
        }
    }

    fn row(&mut self, record: &StringRecord) {
        let line = record.position().map_or(0, csv::Position::line);
        let width = self.places.iter().flatten().count();
        if record.len() > width {
            let what =
                format!("{} cells for {width} columns; remove what is too much", record.len());
            return self.say(Some(line), what);
        }
        let cells = [0, 1, 2].map(|column| self.number(record, line, column));
        let [Some(t), Some(travel), Some(force)] = cells else { return };
        let last = self.rows.last().map(|row| row.1[0]);
        if let Some(last) = last.filter(|last| self.places[0].is_some() && t <= *last) {
            let what = format!(
                "time_s = {t} is not after {last}: time goes on; give each stroke a file of its own"
            );
            return self.say(Some(line), what);
        }
        self.rows.push((line, [t, travel, force]));
    }

    fn number(&mut self, record: &StringRecord, line: u64, column: usize) -> Option<f64> {
        let Some(place) = self.places[column] else { return Some(0.0) };
        let (name, text) = (COLUMNS[column], record.get(place).unwrap_or_default());
        if text.is_empty() {
            self.say(Some(line), format!("{name} is empty; give a number, or remove the line"));
            return None;
        }
        let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
        if number.is_none() {
            let what = format!("{name} = {} is not a finite number; remove the line", quoted(text));
            self.say(Some(line), what);
        }
        number
    }

    fn check(&mut self) {
        if self.rows.len() < FEWEST_ROWS {
            let what =
                format!("{} rows are no stroke; give {FEWEST_ROWS} or more", self.rows.len());
            return self.say(None, what);
        }
        let travels = || self.rows.iter().map(|row| row.1[1]);
        let least = travels().fold(f64::INFINITY, f64::min);
        let most = travels().fold(f64::NEG_INFINITY, f64::max);
        if least < -ABOVE_REST {
            let what = format!(
                "travel_m goes down to {:.1} mm: down is positive, from the key at \
                rest; change its sign or its zero",
                1e3 * least
            );
            return self.say(None, what);
        }
        if !(TRAVELS.0..=TRAVELS.1).contains(&most) {
            let what = format!(
                "travel_m goes to {:.3} mm at most: it is in metres, and a key \
                travels some 0.01 m",
                1e3 * most
            );
            return self.say(None, what);
        }
        if self.places[0].is_some() {
            self.check_times();
        } else {
            self.check_ways(most);
        }
        self.check_force();
    }

    fn check_times(&mut self) {
        let steps = self.rows.windows(2).map(|pair| (pair[1].0, pair[1].1[0] - pair[0].1[0]));
        let steps: Vec<_> = steps.collect();
        let usual = median(steps.iter().map(|step| step.1).collect());
        for (line, step) in steps.into_iter().filter(|step| step.1 > GAP * usual) {
            let what = format!(
                "{step:.4} s after the row before, where {usual:.4} s is usual: rows are missing; \
                 give the parts as strokes of their own that begin at rest"
            );
            self.say(Some(line), what);
        }
    }

    fn check_ways(&mut self, most: f64) {
        let top = self.top();
        for (index, pair) in self.rows.clone().windows(2).enumerate() {
            let (line, way) = (pair[1].0, pair[1].1[1] - pair[0].1[1]);
            let (back, side) = [(way, "down on the way up"), (-way, "up on the way down")]
                [usize::from(index < top)];
            let what = if back > BACK * most {
                format!(
                    "without time_s the rows go down and then up, and here the key goes {:.2} mm \
                     {side}; sort them, or give time_s",
                    1e3 * back
                )
            } else if way.abs() > TRAVEL_GAP * most {
                format!(
                    "{:.1} mm from the row before: rows are missing; measure them, or leave this \
                     way out",
                    1e3 * way.abs()
                )
            } else {
                continue;
            };
            self.say(Some(line), what);
        }
    }

    fn top(&self) -> usize {
        let deeper = |a: &usize, b: &usize| self.rows[*a].1[1].total_cmp(&self.rows[*b].1[1]);
        (0..self.rows.len()).max_by(deeper).unwrap_or(0)
    }

    fn check_force(&mut self) {
        let down = &self.rows[..=self.top()];
        let mean = down.iter().map(|row| row.1[2]).sum::<f64>() / down.len() as f64;
        if mean < 0.0 {
            let what = format!(
                "force_n is {mean:.3} N in the mean on the way down: the key's \
                force on the finger is positive up; change its sign"
            );
            self.say(None, what);
        }
    }

    fn finish(mut self, name: String, speed: f64) -> Result<MeasuredStroke, Vec<DataMistake>> {
        if self.mistakes.len() > MOST_MISTAKES {
            let more = self.mistakes.len() - MOST_MISTAKES;
            self.mistakes.truncate(MOST_MISTAKES);
            self.say(None, format!("{more} more mistakes; mend these first"));
        }
        if !self.mistakes.is_empty() {
            return Err(self.mistakes);
        }
        let is_static = self.places[0].is_none();
        let rows = self.rows.iter().map(|(_, [t, travel, force])| StrokeRow {
            t: *t,
            travel: *travel,
            force: *force,
        });
        let mut rows = rows.collect::<Vec<_>>();
        if is_static {
            pace(&mut rows, self.top(), speed);
        }
        Ok(MeasuredStroke { name, is_static, rows })
    }
}

/// Sets the times of a static curve at `speed` (m/s): down to the row `top`, and up again.
fn pace(rows: &mut [StrokeRow], top: usize, speed: f64) {
    let (mut t, mut at) = (0.0, rows[0].travel);
    let lowest = rows[top].travel;
    for row in &mut rows[..=top] {
        row.travel = row.travel.max(at);
        t += (row.travel - at).max(SHORTEST_WAY) / speed;
        (row.t, at) = (t, row.travel);
    }
    at = lowest;
    for row in &mut rows[top + 1..] {
        row.travel = row.travel.min(at);
        t += (at - row.travel).max(SHORTEST_WAY) / speed;
        (row.t, at) = (t, row.travel);
    }
}

pub(super) fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
