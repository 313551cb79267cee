//! The report: one page with figures and charts, and the figures for programs.

use std::path::Path;

use crate::report::{DiskError, Report, Table, TableCell};
use figures::action::{
    Examination, Figure, ForceCurve, PlayedStroke, StrokeTime, StrokeTouch, durations, speeds,
};
use figures::plot::color::{CURVES, Color, Stroke};
use figures::plot::picture::{CurveLook, Picture, PictureAxis, PictureCurve, PicturePanel};
use figures::plot::{axis::AxisScale, marker::MarkerShape::Circle};

const GRANDS: [&str; 3] =
    ["Steinway C, measured", "Yamaha Disklavier, measured", "Bösendorfer, measured"];
const MEASURED: Color = Color(120, 120, 120);

const HOW: &str = "The front of C4 is driven by position, and its force is what comes out. A stroke \
    follows a power of time; its exponent falls with the stroke's duration as the travel times of \
    measured grands with an ideal lever of 5.2 : 1 have it, for a pressed and for a struck touch. \
    Travel begins with the finger. What is beside the limits of an instrument is red; an instrument \
    without limits for a figure has none.";

/// Writes the page, its charts, and the figures as CSV for one or more instruments into `folder`.
///
/// # Errors
/// If a file cannot be written; files written before are complete.
pub fn write_sheet(folder: &Path, examined: &[Examination]) -> Result<(), DiskError> {
    let names: Vec<_> = examined.iter().map(|it| it.name.as_str()).collect();
    let mut report = Report::new(format!("{}, measured", names.join(" and ")));
    report.introduce(HOW);
    let mut figures = figures(examined);
    report.csv("figures", &figures);
    figures.rows.retain(|row| row[3..].iter().any(|it| *it != TableCell::Missing));
    report.table(&figures);
    for (name, picture) in pictures(examined) {
        report.picture(name, &picture);
    }
    report.write(folder)
}

fn figures(examined: &[Examination]) -> Table {
    let columns = [
        ("instrument", "instrument"),
        ("name", "name"),
        ("title", "figure"),
        ("value", "value"),
        ("low", "at least"),
        ("high", "at most"),
        ("pass", "within"),
    ];
    let row = |instrument: &str, figure: &Figure| {
        let Figure { name, title, value, low, high, pass } = figure;
        let value = match (value, pass) {
            (Some(value), Some(false)) => TableCell::WrongNumber(*value),
            (None, Some(false)) => TableCell::WrongWords("none".to_owned()),
            _ => TableCell::maybe(*value),
        };
        let pass = pass.map_or(TableCell::Missing, |it| TableCell::words(it.to_string()));
        let words = [instrument, name, title].map(TableCell::words);
        let numbers = [value, TableCell::maybe(*low), TableCell::maybe(*high), pass];
        words.into_iter().chain(numbers).collect::<Vec<_>>()
    };
    let rows = examined.iter().flat_map(|it| it.figures.iter().map(|figure| row(&it.name, figure)));
    Table::new(columns).with(rows)
}

fn pictures(examined: &[Examination]) -> Vec<(&'static str, Picture)> {
    let mut pictures = vec![("force", forces(examined))];
    for (what, name) in StrokeTime::ALL.into_iter().zip(["travel", "key-bottom", "free-flight"]) {
        pictures.push((name, times(what, examined)));
    }
    pictures.push(("check", checks(examined)));
    pictures.retain(|(_, picture)| picture.has_points());
    pictures
}

fn color(instrument: usize, curve: usize) -> Color {
    CURVES[(3 * instrument + curve) % CURVES.len()]
}

fn forces(examined: &[Examination]) -> Picture {
    /// Fastest shown speed (m/s): above it the key's inertia counts.
    const SLOW: f64 = 0.02;
    let mut curves = Vec::new();
    for (instrument, it) in examined.iter().enumerate() {
        let slow = it.slopes.iter().filter(|curve| curve.speed < SLOW).enumerate();
        for (index, ForceCurve { speed, down, up, .. }) in slow {
            let stroke = Stroke::new(color(instrument, index), 1.4);
            for (way, name, is_dashed) in [(down, "down", false), (up, "up", true)] {
                let name = format!("{}, {} mm/s {name}", it.name, 1e3 * speed);
                let stroke = Stroke { is_dashed, ..stroke };
                curves.push(PictureCurve::new(name, stroke, CurveLook::Line, thinned(way)));
            }
        }
    }
    let x = PictureAxis::linear("travel of the key's front [mm]");
    let y = vec![PictureAxis::linear("force at the front [N]")];
    Picture::of_panel("Force against travel", PicturePanel { x, y, curves, ..Default::default() })
}

/// Reduces a curve in mm and N to the points of a picture, without the part on the bed.
fn thinned(way: &[(f64, f64)]) -> Vec<(f64, f64)> {
    const POINTS: usize = 600;
    const HIGHEST: f64 = 3.0;
    let shown = way.iter().filter(|it| it.1 < HIGHEST).map(|it| (1e3 * it.0, it.1));
    let step = way.len().div_ceil(POINTS).max(1);
    shown.step_by(step).collect()
}

fn times(what: StrokeTime, examined: &[Examination]) -> Picture {
    let mut curves = Vec::new();
    for touch in StrokeTouch::ALL {
        let (low, high) = speeds(touch);
        let places = || durations((low, high), 40);
        for (grand, name) in GRANDS.into_iter().enumerate() {
            let measured = |speed: f64| (speed, 1e3 * what.measured(touch, speed)[grand]);
            let stroke = Stroke::new(MEASURED, 1.0 + 0.5 * grand as f64).faint(0.6);
            let name = format!("{name}, {}", touch.name());
            let stroke = Stroke { is_dashed: touch == StrokeTouch::Struck, ..stroke };
            let points = places().map(measured).collect();
            curves.push(PictureCurve::new(name, stroke, CurveLook::Line, points));
        }
        for (instrument, it) in examined.iter().enumerate() {
            let point = |it: &PlayedStroke| Some((it.speed, 1e3 * it.timed(what)?));
            let strokes = it.strokes_of(touch);
            let within = strokes.iter().filter(|it| (0.7 * low..=1.2 * high).contains(&it.speed));
            let stroke =
                Stroke::new(color(instrument, usize::from(touch == StrokeTouch::Struck)), 1.6);
            let name = format!("{}, {}", it.name, touch.name());
            let points = within.filter_map(point).collect();
            curves.push(PictureCurve::new(name, stroke, CurveLook::Marked(Circle), points));
        }
    }
    let (title, time) = match what {
        StrokeTime::Travel => {
            ("Travel: from the key's start to the string", PictureAxis::logarithmic("time [ms]"))
        }
        StrokeTime::KeyBottom => ("Key bottom, after the string", PictureAxis::linear("time [ms]")),
        StrokeTime::FreeFlight => {
            ("Free flight of the hammer", PictureAxis::logarithmic("time [ms]"))
        }
    };
    // A hammer that is carried to the string has no flight, which a logarithmic axis cannot show.
    if time.scale == AxisScale::Logarithmic {
        for stretch in curves.iter_mut().flat_map(|it| &mut it.stretches) {
            stretch.retain(|point| point.1 > 0.01);
        }
    }
    let x = PictureAxis::logarithmic("hammer speed at the string [m/s]");
    Picture::of_panel(title, PicturePanel { x, y: vec![time], curves, ..Default::default() })
}

fn checks(examined: &[Examination]) -> Picture {
    let mut curves = Vec::new();
    for (instrument, it) in examined.iter().enumerate() {
        let caught = it.sweep.iter().flat_map(|(key, strokes)| {
            let loud = strokes.iter().filter(|it| it.speed > 1.0);
            loud.filter_map(|it| Some((f64::from(*key), 1e3 * it.checked?)))
        });
        let stroke = Stroke::new(color(instrument, 0), 1.0);
        let (look, points) = (CurveLook::Marks(Circle), caught.collect());
        curves.push(PictureCurve::new(it.name.clone(), stroke, look, points));
    }
    let x = PictureAxis::linear("key, 0 is A0 and 87 is C8");
    let y = vec![PictureAxis::linear("below the string [mm]")];
    let title = "Hammer with the key held, strokes above 1 m/s";
    Picture::of_panel(title, PicturePanel { x, y, curves, ..Default::default() })
}
