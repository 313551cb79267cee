//! The report: the figure in both readings, how wrong the step was, and the same for programs.

use std::fmt::Write as _;
use std::path::Path;

use super::closed_loop::{ClosedLoop, RigRow};
use super::hand;
use super::judge::StepErrors;
use super::model_run::{ModelRun, RunRow};
use super::outcome::{EventTimes, Figure6, event_times};
use super::picture;
use crate::digits::trimmed;
use crate::piano::SHEET;
use crate::plot::chart::{Chart, ChartCurve, CurveLook, Scales};
use crate::plot::color::{CURVES, Stroke};
use crate::report::page::{HtmlCell, STYLE, escape, table};
use crate::report::text::duration;
use crate::report::{DiskError, write_file};

/// What a reader must know before looking at the figure.
const HOW: &str = "A hand that grips the handle of a simulated rig throws and catches the hammer of \
    model B: hand, encoder, model, motor, handle, and the hand again. The model is stepped as the \
    paper's was: RK4 over 2 ms, the input sampled once and held, guards looked at once at the end \
    of a step. The paper's servo took 7 ms for each step, so the hand worked in slow motion; below \
    it the same gesture with model time that is the hand's.";

/// What the table of errors compares.
const ERRORS: &str = "The stroke of the reference, without a hand in a loop, against the events and \
    states of an independent program: how wrong is each way to step it with RK4 at 2 ms? Forces and \
    stored energies are compared every 10 ms, where no event is within 5 ms. Energy made is what \
    nobody had put in, or what was lost, at its largest.";

/// What the chart of the loop compares.
const BESIDE: &str = "The first figure's gesture once more: the force under the samples as they were \
    taken, against that under the way of the handle between them. What both have in common is the \
    encoder, whose line is 0.3 N, and the input that is held.";

/// What the paper's text says of its figure.
const STORY: &str = "The paper's text: held still for 0.3 s, thrown, free, caught at 0.9 s, thrown \
    harder so that the string was hit, landed at 1.5 s, bounced several times.";

/// Writes the page, the figure in both readings, the errors as charts, and all of it as CSV and
/// JSON into `folder`.
///
/// # Errors
/// When a file cannot be written; those that could are complete.
pub fn write_figure6(folder: &Path, figure: &Figure6) -> Result<(), DiskError> {
    let put = |name: &str, text: &str| write_file(&folder.join(name), text);
    let drawn = readings(figure).map(|(name, it)| (name, draw(figure, it)));
    for (name, svg) in &drawn {
        put(&format!("{name}.svg"), svg)?;
    }
    for (name, it) in readings(figure) {
        put(&format!("{name}.csv"), &trajectory(it))?;
    }
    let charts = charts(figure);
    for (name, chart) in &charts {
        put(&format!("{name}.svg"), &chart.svg())?;
    }
    put("events.csv", &events(figure))?;
    put("errors.csv", &errors(figure))?;
    let json = serde_json::to_string_pretty(&figure.summary()).unwrap_or_default();
    put("figure6.json", &(json + "\n"))?;
    put(SHEET, &page(figure, &drawn, &charts))
}

/// Both readings with the names of their files.
fn readings(figure: &Figure6) -> [(&'static str, &ClosedLoop); 2] {
    [("figure6", &figure.slow_motion), ("figure6-real-time", &figure.real_time)]
}

fn draw(figure: &Figure6, it: &ClosedLoop) -> String {
    let title = format!("Simulation using model B: {}", pace(it));
    picture::svg(&title, &it.paper, figure.string)
}

/// How model time goes by, in words.
fn pace(it: &ClosedLoop) -> String {
    let servo = duration(it.pace.servo());
    format!("steps of 2 ms of model time, each in {servo} of the hand's")
}

fn page(
    figure: &Figure6,
    drawn: &[(&'static str, String); 2],
    charts: &[(&'static str, Chart); 3],
) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <title>Letoff: figure 6</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
         <h1>Figure 6: simulation using model B</h1>\n<p class=\"read\">{HOW}</p>\n"
    );
    for ((_, it), (_, svg)) in readings(figure).into_iter().zip(drawn) {
        let title = format!("{} model seconds a second: {}", short(it.pace.time_scale()), pace(it));
        page += &["<h2>", &escape(&title), "</h2>\n<figure>\n", svg, "</figure>\n"].concat();
        page += &times(it);
    }
    page += &["<p>", STORY, "</p>\n<h2>How wrong the step is</h2>\n<p>", ERRORS, "</p>\n"].concat();
    page += &error_table(figure);
    let [beside, errors @ ..] = charts;
    for (_, chart) in errors {
        page += &["<figure>\n", &chart.svg(), "</figure>\n"].concat();
    }
    page += &["<h2>In the loop</h2>\n<p class=\"read\">", BESIDE, "</p>\n<figure>\n"].concat();
    page += &[&beside.1.svg(), "</figure>\n<h2>Rig and hand</h2>\n"].concat();
    page += &rig_table();
    page + "</body>\n</html>\n"
}

/// When the events of a reading come: as the paper's step saw them, and as they were.
fn times(it: &ClosedLoop) -> String {
    let header = [
        "event",
        "to",
        "paper's step [s]",
        "same samples, located [s]",
        "handle's own way, located [s]",
    ];
    let time = |t: Option<f64>| {
        HtmlCell::Number(t.map_or_else(|| "in another order".to_owned(), |t| format!("{t:.4}")))
    };
    let row = |event: &EventTimes<'_>| {
        let EventTimes { guard, to, paper, located, exact, .. } = *event;
        let numbers = [Some(paper), located, exact].map(time);
        [HtmlCell::words(guard), HtmlCell::words(to)].into_iter().chain(numbers).collect()
    };
    table(&header, &event_times(it).iter().map(row).collect::<Vec<_>>())
}

fn error_table(figure: &Figure6) -> String {
    let header = [
        "step",
        "events",
        "time of an event [s]",
        "force, largest [N]",
        "force, r.m.s. [N]",
        "stored energy [J]",
        "energy made [J]",
    ];
    let row = |it: &StepErrors| {
        let StepErrors { event_largest, force_largest, force_rms, .. } = *it;
        let count = if it.is_whole {
            HtmlCell::Number(format!("all {}", it.events.len()))
        } else {
            HtmlCell::Wrong(format!("{} in order", it.events.len()), 1)
        };
        let numbers = [event_largest, force_largest, force_rms, it.energy_largest, it.energy_made];
        let numbers = numbers.map(|it| HtmlCell::Number(format!("{it:.1e}")));
        [HtmlCell::words(it.kind.title()), count].into_iter().chain(numbers).collect()
    };
    let rows: Vec<_> = figure.errors.iter().map(row).collect();
    let truth = &figure.truth;
    table(&header, &rows)
        + &format!(
            "<p>The largest force on the hand is {:.1} N, the largest stored energy {:.0} mJ.</p>\n",
            truth.force_largest,
            1e3 * truth.energy_largest
        )
}

fn rig_table() -> String {
    let row = |it: &hand::RigValue| {
        let words = [it.title, it.source].map(HtmlCell::words);
        let [title, source] = words;
        vec![title, HtmlCell::Number(format!("{} {}", short(it.value), it.unit)), source]
    };
    table(&["what", "value", "source"], &hand::values().iter().map(row).collect::<Vec<_>>())
}

/// Four digits, as short as can be.
fn short(value: f64) -> String {
    trimmed(&format!("{value:.4}")).to_owned()
}

fn trajectory(it: &ClosedLoop) -> String {
    let mut text = "t,mode,s,theta_k,theta_h,F_KU,F_KH,gap,energy,true_s,motor,hand\n".to_owned();
    for (row, rig) in it.paper.rows.iter().zip(&it.rig) {
        let RunRow { t, mode, s, key, hammer, f_ku, f_kh, gap, energy } = row;
        let RigRow { angle, motor, hand, .. } = rig;
        // Writing to a String cannot fail.
        let _written = writeln!(
            text,
            "{t:.3},{mode},{s},{key},{hammer},{f_ku},{f_kh},{gap},{energy},{angle},{motor},{hand}"
        );
    }
    text
}

fn events(figure: &Figure6) -> String {
    let mut text = "reading,guard,from,to,paper,located,exact\n".to_owned();
    for (name, it) in readings(figure) {
        for event in event_times(it) {
            let EventTimes { guard, from, to, paper, located, exact } = event;
            let [located, exact] =
                [located, exact].map(|t| t.map_or_else(String::new, |t| t.to_string()));
            let _written =
                writeln!(text, "{name},{guard},{from},{to},{paper:.3},{located},{exact}");
        }
    }
    text
}

fn errors(figure: &Figure6) -> String {
    let mut text =
        "step,is_whole,event_largest,force_largest,force_rms,energy_largest,energy_made\n"
            .to_owned();
    for it in &figure.errors {
        let StepErrors { is_whole, event_largest, force_largest, force_rms, .. } = it;
        let _written = writeln!(
            text,
            "{},{is_whole},{event_largest},{force_largest},{force_rms},{},{}",
            it.kind.name(),
            it.energy_largest,
            it.energy_made
        );
    }
    text
}

/// The gesture in three ways, and errors of event times and of forces over time.
fn charts(figure: &Figure6) -> [(&'static str, Chart); 3] {
    let truth = &figure.truth.events;
    let event_errors = |it: &StepErrors| {
        it.events.iter().zip(truth).map(|(error, (t, _))| (*t, error.abs())).collect()
    };
    let force_errors = |it: &StepErrors| {
        let errors = it.forces.iter().map(|(t, error)| (*t, error.abs()));
        // The zero of a start at rest has no logarithm.
        errors.filter(|it| it.1 > LEAST).collect()
    };
    [
        ("figure6-beside", beside(&figure.slow_motion)),
        (
            "event-errors",
            chart(
                "Error of each event's time",
                "error [s]",
                CurveLook::Marked,
                figure,
                event_errors,
            ),
        ),
        (
            "force-errors",
            chart(
                "Error of the force on the hand",
                "error [N]",
                CurveLook::Line,
                figure,
                force_errors,
            ),
        ),
    ]
}

/// The force on the hand, less that under the handle's own way with located events.
fn beside(it: &ClosedLoop) -> Chart {
    let ways = [("the paper's step", &it.paper), ("same samples, located", &it.located)];
    let curve = |(index, (name, run)): (usize, (&str, &ModelRun))| {
        let pairs = run.rows.iter().zip(&it.exact.rows);
        ChartCurve {
            name: name.to_owned(),
            stroke: Stroke::new(CURVES[(index + 1) % CURVES.len()], 1.2),
            look: CurveLook::Line,
            points: pairs.map(|(row, exact)| (row.t, row.f_ku - exact.f_ku)).collect(),
        }
    };
    Chart {
        title: "Force on the hand, less that of the handle's own way",
        x_title: "model time t [s]",
        y_title: "difference [N]",
        scales: Scales::Linear,
        curves: ways.into_iter().enumerate().map(curve).collect(),
    }
}

/// Smallest error of a force that is drawn (N).
const LEAST: f64 = 1e-9;

fn chart(
    title: &'static str,
    y_title: &'static str,
    look: CurveLook,
    figure: &Figure6,
    points: impl Fn(&StepErrors) -> Vec<(f64, f64)>,
) -> Chart {
    let curve = |(index, it): (usize, &StepErrors)| ChartCurve {
        name: it.kind.short().to_owned(),
        stroke: Stroke::new(CURVES[(index + 1) % CURVES.len()], 1.6),
        look,
        points: points(it),
    };
    Chart {
        title,
        x_title: "model time t [s]",
        y_title,
        scales: Scales::LogarithmicUp,
        curves: figure.errors.iter().enumerate().map(curve).collect(),
    }
}
