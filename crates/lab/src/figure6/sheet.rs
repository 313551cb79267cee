//! The report: the figure in both readings, the step's errors, and all of it for programs.

use std::path::Path;

use super::closed_loop::{ClosedLoop, RigRow};
use super::outcome::{EventTimes, Figure6, event_times};
use super::{hand, judge::StepErrors, model_run::RunRow, picture::picture};
use crate::report::{DiskError, Report, Table, TableCell, text::duration};
use figures::plot::color::{CURVES, Stroke};
use figures::plot::picture::{CurveLook, Picture, PictureAxis, PictureCurve, PicturePanel};
use figures::{digits::trimmed, plot::marker::MarkerShape::Circle};

const HOW: &str = "A hand that grips the handle of a simulated rig throws and catches the hammer of \
    model B: hand, encoder, model, motor, handle, and the hand again. The model is stepped as the \
    paper's was: RK4 over 2 ms, the input sampled once and held, guards looked at once at the end \
    of a step. The paper's servo took 7 ms for each step, so the hand worked in slow motion; below \
    it the same gesture with model time that is the hand's.";

const ERRORS: &str = "The stroke of the reference, without a hand in a loop, against the events and \
    states of an independent program: how wrong is each way to step it with RK4 at 2 ms? Forces and \
    stored energies are compared every 10 ms, where no event is within 5 ms. Energy made is what \
    nobody had put in, or what was lost, at its largest.";

const BESIDE: &str = "The first figure's gesture once more: the force under the samples as they were \
    taken, against that under the way of the handle between them. What both have in common is the \
    encoder, whose line is 0.3 N, and the input that is held.";

const STORY: &str = "The paper's text: held still for 0.3 s, thrown, free, caught at 0.9 s, thrown \
    harder so that the string was hit, landed at 1.5 s, bounced several times.";

/// Writes the page, both figures, the errors as charts, and CSV and JSON into `folder`.
///
/// # Errors
/// If a file cannot be written; files written before are complete.
pub fn write_figure6(folder: &Path, figure: &Figure6) -> Result<(), DiskError> {
    let readings = [("figure6", &figure.slow_motion), ("figure6-real-time", &figure.real_time)];
    let mut report = Report::new("Figure 6: simulation using model B");
    report.introduce(HOW);
    let mut all = events();
    for (name, it) in readings {
        let servo = duration(it.pace.servo());
        let pace = format!("steps of 2 ms of model time, each in {servo} of the hand's");
        report.heading(&format!("{} model seconds a second: {pace}", short(it.pace.time_scale())));
        let title = format!("Simulation using model B: {pace}");
        report.picture(name, &picture(&title, &it.paper, figure.string));
        report.csv(name, &trajectory(it));
        let events = events().with(event_rows(name, it));
        report.table(&events);
        all.rows.extend(events.rows);
    }
    report.csv("events", &all);
    report.text(STORY);
    report.heading("How wrong the step is");
    report.text(ERRORS);
    let errors = errors(figure);
    report.table(&errors);
    report.csv("errors", &errors);
    report.text(&format!(
        "The largest force on the hand is {:.1} N, the largest stored energy {:.0} mJ.",
        figure.truth.force_largest,
        1e3 * figure.truth.energy_largest
    ));
    let [event_errors, force_errors] = error_pictures(figure);
    report.picture("event-errors", &event_errors);
    report.picture("force-errors", &force_errors);
    report.heading("In the loop");
    report.text(BESIDE);
    report.picture("figure6-beside", &beside(&figure.slow_motion));
    report.heading("Rig and hand");
    report.table(&rig_table());
    let json = serde_json::to_string_pretty(&figure.summary()).unwrap_or_default();
    report.file("figure6.json", json + "\n");
    report.write(folder)
}

fn events() -> Table {
    Table::new([
        ("reading", "reading"),
        ("guard", "event"),
        ("from", "from"),
        ("to", "to"),
        ("paper", "paper's step [s]"),
        ("located", "same samples, located [s]; none if in another order"),
        ("exact", "handle's own way, located [s]"),
    ])
}

fn event_rows(name: &str, it: &ClosedLoop) -> Vec<Vec<TableCell>> {
    let row = |event: &EventTimes<'_>| {
        let words = [name, event.guard, event.from, event.to].map(TableCell::words);
        // The clock of the steps has a resolution of 1 ms.
        let paper = (1e3 * event.paper).round() / 1e3;
        let times = [Some(paper), event.located, event.exact].map(TableCell::maybe);
        words.into_iter().chain(times).collect()
    };
    event_times(it).iter().map(row).collect()
}

fn errors(figure: &Figure6) -> Table {
    let columns = [
        ("step", "name"),
        ("title", "step"),
        ("is_whole", "all events"),
        ("events", "events in order"),
        ("event_largest", "time of an event [s]"),
        ("force_largest", "force, largest [N]"),
        ("force_rms", "force, r.m.s. [N]"),
        ("energy_largest", "stored energy [J]"),
        ("energy_made", "energy made [J]"),
    ];
    let row = |it: &StepErrors| {
        let StepErrors { event_largest, force_largest, force_rms, .. } = *it;
        let (whole, words) = (it.is_whole.to_string(), [it.kind.name(), it.kind.title()]);
        let whole = if it.is_whole { TableCell::Words } else { TableCell::WrongWords }(whole);
        let events = TableCell::words(it.events.len().to_string());
        let numbers = [event_largest, force_largest, force_rms, it.energy_largest, it.energy_made];
        let first = words.map(TableCell::words).into_iter().chain([whole, events]);
        first.chain(numbers.map(TableCell::Number)).collect::<Vec<_>>()
    };
    Table::new(columns).with(figure.errors.iter().map(row))
}

fn rig_table() -> Table {
    let row = |it: &hand::RigValue| {
        let value = format!("{} {}", short(it.value), it.unit);
        [it.title, &value, it.source].map(TableCell::words)
    };
    let columns = ["what", "value", "source"].map(|it| (it, it));
    Table::new(columns).with(hand::values().iter().map(row))
}

fn short(value: f64) -> String {
    trimmed(&format!("{value:.4}")).to_owned()
}

fn trajectory(it: &ClosedLoop) -> Table {
    let columns = [
        "t", "mode", "s", "theta_k", "theta_h", "F_KU", "F_KH", "gap", "energy", "true_s", "motor",
        "hand",
    ];
    let row = |(row, rig): (&RunRow, &RigRow)| {
        let first = [TableCell::words(format!("{:.3}", row.t)), TableCell::words(row.mode)];
        let run = [row.s, row.key, row.hammer, row.f_ku, row.f_kh, row.gap, row.energy];
        let numbers = run.into_iter().chain([rig.angle, rig.motor, rig.hand]);
        first.into_iter().chain(numbers.map(TableCell::Number)).collect::<Vec<_>>()
    };
    Table::new(columns.map(|it| (it, it))).with(it.paper.rows.iter().zip(&it.rig).map(row))
}

fn beside(it: &ClosedLoop) -> Picture {
    let ways = [("the paper's step", &it.paper), ("same samples, located", &it.located)];
    let curves = ways.iter().zip(&CURVES[1..]).map(|((name, run), color)| {
        let pairs = run.rows.iter().zip(&it.exact.rows);
        let points = pairs.map(|(row, exact)| (row.t, row.f_ku - exact.f_ku)).collect();
        PictureCurve::new(*name, Stroke::new(*color, 1.2), CurveLook::Line, points)
    });
    let title = "Force on the hand, less that of the handle's own way";
    over_time(title, PictureAxis::linear("difference [N]"), curves.collect())
}

/// Smallest drawn error of a force (N).
const LEAST: f64 = 1e-9;

fn error_pictures(figure: &Figure6) -> [Picture; 2] {
    let truth = &figure.truth.events;
    let picture = |title, unit: &str, look, points: &dyn Fn(&StepErrors) -> Vec<(f64, f64)>| {
        let curves = figure.errors.iter().zip(CURVES.iter().cycle().skip(1)).map(|(it, color)| {
            PictureCurve::new(it.kind.short(), Stroke::new(*color, 1.6), look, points(it))
        });
        over_time(title, PictureAxis::logarithmic(unit), curves.collect())
    };
    let (marked, line) = (CurveLook::Marked(Circle), CurveLook::Line);
    [
        picture("Error of each event's time", "error [s]", marked, &|it| {
            it.events.iter().zip(truth).map(|(error, (t, _))| (*t, error.abs())).collect()
        }),
        picture("Error of the force on the hand", "error [N]", line, &|it| {
            let errors = it.forces.iter().map(|(t, error)| (*t, error.abs()));
            // The zero at the start, at rest, has no logarithm.
            errors.filter(|it| it.1 > LEAST).collect()
        }),
    ]
}

fn over_time(title: &str, y: PictureAxis, curves: Vec<PictureCurve>) -> Picture {
    let (x, y) = (PictureAxis::linear("model time t [s]"), vec![y]);
    Picture::of_panel(title, PicturePanel { x, y, curves, ..Default::default() })
}
