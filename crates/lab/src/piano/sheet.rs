//! The report: one page with figures and charts, and the same for programs.

use std::path::Path;

use super::drive::StrokeTouch;
use super::figure::Figure;
use super::gather::Examination;
use super::grands::{StrokeTime, speeds};
use super::slope::ForceCurve;
use super::stroke::Stroke as PlayedStroke;
use crate::plot::chart::{Chart, ChartCurve, CurveLook, Scales};
use crate::plot::color::{CURVES, Color, Stroke};
use crate::report::page::{HtmlCell, STYLE, escape, table};
use crate::report::{DiskError, write_file};

/// Name of the page's file.
pub const SHEET: &str = "index.html";
/// Names of the three grands, as they are drawn.
const GRANDS: [&str; 3] =
    ["Steinway C, measured", "Yamaha Disklavier, measured", "Bösendorfer, measured"];
/// Colour of what was measured on grands.
const MEASURED: Color = Color(120, 120, 120);

/// Writes the page, its charts, and the figures as JSON into `folder`, of one instrument or several
/// beside one another.
///
/// # Errors
/// When a file cannot be written; those that could are complete.
pub fn write_sheet(folder: &Path, examined: &[Examination]) -> Result<(), DiskError> {
    let charts = charts(examined);
    for (name, chart) in &charts {
        write_file(&folder.join(format!("{name}.svg")), &chart.svg())?;
    }
    write_file(&folder.join("figures.csv"), &csv(examined))?;
    write_file(&folder.join(SHEET), &page(examined, &charts))
}

fn page(examined: &[Examination], charts: &[(&'static str, Chart)]) -> String {
    let names: Vec<_> = examined.iter().map(|it| escape(&it.name)).collect();
    let title = names.join(" and ");
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <title>Letoff: {title}, measured</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <h1>{title}</h1>\n<p class=\"read\">{HOW}</p>\n"
    );
    page += &figures(examined);
    for (_, chart) in charts {
        page += &["<figure>\n", &chart.svg(), "</figure>\n"].concat();
    }
    page + "</body>\n</html>\n"
}

/// What a reader must know before looking at a figure.
const HOW: &str = "The front of C4 is driven by position, and its force is what comes out. A stroke \
    follows a power of time; its exponent falls with the stroke's duration as the travel times of \
    measured grands with an ideal lever of 5.2 : 1 have it, for a pressed and for a struck touch. \
    Travel begins with the finger. What is beside the limits of an instrument is red; an instrument \
    without limits for a figure has none.";

/// A table of all figures that any of the instruments has.
fn figures(examined: &[Examination]) -> String {
    let mut header = vec!["figure".to_owned()];
    for it in examined {
        header.extend([it.name.clone(), "limits".to_owned()]);
    }
    let header: Vec<_> = header.iter().map(String::as_str).collect();
    let Some(first) = examined.first() else { return String::new() };
    let has = |row: usize| {
        let figures = || examined.iter().filter_map(move |it| it.figures.get(row));
        figures().any(|it| it.value.is_some() || it.pass.is_some())
    };
    let rows = first.figures.iter().enumerate().filter(|(row, _)| has(*row));
    let rows = rows.map(|(row, figure)| {
        let cells = examined.iter().filter_map(|it| it.figures.get(row)).flat_map(cells);
        [HtmlCell::words(figure.title)].into_iter().chain(cells).collect()
    });
    table(&header, &rows.collect::<Vec<_>>())
}

fn cells(figure: &Figure) -> [HtmlCell; 2] {
    let value = figure.value.map_or_else(|| "—".to_owned(), number);
    let value = if figure.pass == Some(false) {
        HtmlCell::Wrong(value, 1)
    } else {
        HtmlCell::Number(value)
    };
    [value, HtmlCell::Number(limits(figure))]
}

/// Where a figure should lie, in words.
fn limits(figure: &Figure) -> String {
    match (figure.low, figure.high) {
        (Some(low), Some(high)) if low.is_finite() && high.is_finite() => {
            format!("{} to {}", number(low), number(high))
        }
        (Some(low), _) if low.is_finite() => format!("at least {}", number(low)),
        (_, Some(high)) if high.is_finite() => format!("at most {}", number(high)),
        _ => String::new(),
    }
}

/// Three digits are more than a hand feels.
fn number(value: f64) -> String {
    let digits = if value.abs() >= 100.0 {
        0
    } else if value.abs() >= 10.0 {
        1
    } else {
        2
    };
    if value.abs() > 0.0 && value.abs() < 0.005 {
        return format!("{value:.1e}");
    }
    format!("{value:.digits$}")
}

fn csv(examined: &[Examination]) -> String {
    let mut text = "instrument,name,value,low,high,pass\n".to_owned();
    for it in examined {
        for Figure { name, value, low, high, pass, .. } in &it.figures {
            let number = |it: &Option<f64>| it.map_or_else(String::new, |it| it.to_string());
            let [value, low, high] = [value, low, high].map(number);
            let pass = pass.map_or_else(String::new, |it| it.to_string());
            text += &[it.name.as_str(), name, &value, &low, &high, &pass].join(",");
            text += "\n";
        }
    }
    text
}

fn charts(examined: &[Examination]) -> Vec<(&'static str, Chart)> {
    let mut charts = vec![("force", forces(examined))];
    for (what, name) in StrokeTime::ALL.into_iter().zip(["travel", "key-bottom", "free-flight"]) {
        charts.push((name, times(what, examined)));
    }
    charts.push(("check", checks(examined)));
    charts.retain(|(_, chart)| chart.curves.iter().any(|curve| !curve.points.is_empty()));
    charts
}

/// A colour for each instrument and each of its curves.
fn color(instrument: usize, curve: usize) -> Color {
    CURVES[(3 * instrument + curve) % CURVES.len()]
}

/// Force against travel, down and back, of the slow speeds.
fn forces(examined: &[Examination]) -> Chart {
    /// Faster keys feel their inertia.
    const SLOW: f64 = 0.02;
    let mut curves = Vec::new();
    for (instrument, it) in examined.iter().enumerate() {
        let slow = it.slopes.iter().filter(|curve| curve.speed < SLOW).enumerate();
        for (index, ForceCurve { speed, down, up, .. }) in slow {
            let stroke = Stroke::new(color(instrument, index), 1.4);
            for (way, name, is_dashed) in [(down, "down", false), (up, "up", true)] {
                curves.push(ChartCurve {
                    name: format!("{}, {} mm/s {name}", it.name, 1e3 * speed),
                    stroke: Stroke { is_dashed, ..stroke },
                    look: CurveLook::Line,
                    points: thinned(way),
                });
            }
        }
    }
    Chart {
        title: "Force against travel",
        x_title: "travel of the key's front [mm]",
        y_title: "force at the front [N]",
        scales: Scales::Linear,
        curves,
    }
}

/// A curve in mm and N with as many points as a picture shows; what is on the bed is cut off.
fn thinned(way: &[(f64, f64)]) -> Vec<(f64, f64)> {
    const POINTS: usize = 600;
    const HIGHEST: f64 = 3.0;
    let shown = way.iter().filter(|it| it.1 < HIGHEST).map(|it| (1e3 * it.0, it.1));
    let step = way.len().div_ceil(POINTS).max(1);
    shown.step_by(step).collect()
}

/// A time against hammer speed, with the three grands.
fn times(what: StrokeTime, examined: &[Examination]) -> Chart {
    let mut curves = Vec::new();
    for touch in StrokeTouch::ALL {
        let (low, high) = speeds(touch);
        let places = || super::stroke::durations((low, high), 40);
        for (grand, name) in GRANDS.into_iter().enumerate() {
            let measured = |speed: f64| (speed, 1e3 * what.measured(touch, speed)[grand]);
            let stroke = Stroke::new(MEASURED, 1.0 + 0.5 * grand as f64).faint(0.6);
            curves.push(ChartCurve {
                name: format!("{name}, {}", touch.name()),
                stroke: Stroke { is_dashed: touch == StrokeTouch::Struck, ..stroke },
                look: CurveLook::Line,
                points: places().map(measured).collect(),
            });
        }
        for (instrument, it) in examined.iter().enumerate() {
            let point = |it: &PlayedStroke| Some((it.speed, 1e3 * it.timed(what)?));
            let strokes = it.strokes_of(touch);
            let within = strokes.iter().filter(|it| (0.7 * low..=1.2 * high).contains(&it.speed));
            let stroke =
                Stroke::new(color(instrument, usize::from(touch == StrokeTouch::Struck)), 1.6);
            curves.push(ChartCurve {
                name: format!("{}, {}", it.name, touch.name()),
                stroke,
                look: CurveLook::Marked,
                points: within.filter_map(point).collect(),
            });
        }
    }
    let (title, y_title, scales) = match what {
        StrokeTime::Travel => {
            ("Travel: from the key's start to the string", "time [ms]", Scales::Logarithmic)
        }
        StrokeTime::KeyBottom => {
            ("Key bottom, after the string", "time [ms]", Scales::SemiLogarithmic)
        }
        StrokeTime::FreeFlight => ("Free flight of the hammer", "time [ms]", Scales::Logarithmic),
    };
    // A hammer that is carried to the string has no flight, and a logarithm no place for it.
    if scales == Scales::Logarithmic {
        for curve in &mut curves {
            curve.points.retain(|point| point.1 > 0.01);
        }
    }
    Chart { title, x_title: "hammer speed at the string [m/s]", y_title, scales, curves }
}

/// Where the hammer is held after strokes above 1 m/s, on all keys.
fn checks(examined: &[Examination]) -> Chart {
    let mut curves = Vec::new();
    for (instrument, it) in examined.iter().enumerate() {
        let caught = it.sweep.iter().flat_map(|(key, strokes)| {
            let loud = strokes.iter().filter(|it| it.speed > 1.0);
            loud.filter_map(|it| Some((f64::from(*key), 1e3 * it.checked?)))
        });
        curves.push(ChartCurve {
            name: it.name.clone(),
            stroke: Stroke::new(color(instrument, 0), 1.0),
            look: CurveLook::Marks,
            points: caught.collect(),
        });
    }
    Chart {
        title: "Hammer with the key held, strokes above 1 m/s",
        x_title: "key, 0 is A0 and 87 is C8",
        y_title: "below the string [mm]",
        scales: Scales::Linear,
        curves,
    }
}
