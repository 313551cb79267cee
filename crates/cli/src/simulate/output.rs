//! The files: the trajectory, a row per tick, the events, and the plot.
//!
//! Numbers are the shortest with the same bits; an event's t has 17 digits. A guard's column is
//! `guard_<name>`, so it never equals a state or an output; an output with the name of an earlier
//! column is `output_<name>`.

use std::fmt::Write as _;
use std::fs::File;
use std::path::{Path, PathBuf};

use instruments::{Described, ModelEntry, Playable};
use pode::{EnergyAudit, Event, EventCause, GuardSpec, Motion, Piece, Signal, State as _};

use super::args::SimulateArgs;
use super::check::Start;
use super::error::{SimulateError, SimulateMistake};
use super::mode::mode_name;
use super::plot::Plot;

/// Columns of the readout's slopes by s and by s'.
const SLOPES: [&str; 2] = ["readout_per_s", "readout_per_s_dot"];

/// Columns of the energy audit since the start (J): the increase of the stored energy is supplied
/// − dissipated + jumps + sampling + integration.
const ENERGIES: [&str; 6] =
    ["E_supplied", "E_dissipated", "E_jumps", "E_sampling", "E_integration", "E_stored"];

/// Size of the write buffer (bytes).
const BUFFER: usize = 1 << 16;

/// A guard, or the name of another cause, and when it was reached.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct TimedEvent {
    pub name: &'static str,
    /// Time (s).
    pub t: f64,
}

#[derive(Debug)]
pub(super) struct OutputFiles {
    trajectory: Option<CsvFile>,
    events: Option<CsvFile>,
    plot: Option<Plot>,
    /// All events, if they are listed.
    list: Option<Vec<TimedEvent>>,
    /// Guards of all modes, in the order of their columns.
    guards: Vec<&'static str>,
    outputs: Vec<f64>,
    /// First failure to write an event, which a tick cannot return.
    failure: Option<SimulateError>,
}

impl OutputFiles {
    /// Creates the files, with headers for tables, or returns why each cannot be created.
    pub(super) fn create<M: Playable>(
        args: &SimulateArgs,
        start: &Start<M>,
    ) -> Result<Self, Vec<SimulateMistake>> {
        let guards = guard_names(&start.model);
        let mut mistakes = Vec::new();
        let mut create = |path: Option<&PathBuf>, header: Vec<String>| {
            let sheet = CsvFile::create(path?, &header);
            sheet.map_err(|mistake| mistakes.push(mistake)).ok()
        };
        let trajectory = create(args.output.out.as_ref(), trajectory_header(&start.model, &guards));
        let events = create(args.output.events.as_ref(), event_header(&start.model));
        let plot = args.output.plot.as_ref().map(|path| Plot::create(path, args, start, &guards));
        let plot = plot.transpose().map_err(|mistake| mistakes.push(mistake)).ok().flatten();
        let outputs = vec![0.0; start.model.entry().outputs.len()];
        let list = args.caller.lists_events.then(Vec::new);
        let files = Self { trajectory, events, plot, list, guards, outputs, failure: None };
        if mistakes.is_empty() { Ok(files) } else { Err(mistakes) }
    }

    /// Writes the trajectory's row at `t` (s).
    pub(super) fn row<M: Playable>(
        &mut self,
        model: &M,
        t: f64,
        (mode, state): (M::Mode, &M::State),
        input: &Motion,
        audit: &EnergyAudit,
    ) -> Result<(), SimulateError> {
        let Some(sheet) = &mut self.trajectory else { return Ok(()) };
        sheet.number(t);
        sheet.text(&mode_name(model, mode));
        sheet.numbers(known(model, state));
        if !model.entry().input.is_empty() {
            sheet.number(input.position);
        }
        let specs = model.guards(mode);
        for name in &self.guards {
            match specs.iter().find(|spec| spec.name == *name) {
                Some(spec) => sheet.number(model.guard(mode, spec.id, state, input).value),
                None => sheet.text(""),
            }
        }
        model.outputs(mode, state, input, &mut self.outputs);
        let shown = model.entry().quantities().len();
        sheet.numbers(self.outputs.get(..shown).unwrap_or(&self.outputs));
        let slopes = model.slopes(mode, state, input);
        sheet.numbers(&[slopes.per_position, slopes.per_rate]);
        let EnergyAudit { supplied, dissipated, jumps, sampling, integration, stored, .. } = *audit;
        sheet.numbers(&[supplied, dissipated, jumps, sampling, integration, stored]);
        sheet.end()
    }

    /// Follows a piece from `start` to `end` (s).
    pub(super) fn piece<M: Described, S: Signal<Motion>>(
        &mut self,
        model: &M,
        (start, end): (f64, f64),
        piece: &Piece<'_, M, S>,
    ) {
        if let Some(plot) = &mut self.plot {
            plot.piece(model, (start, end), piece);
        }
    }

    /// Marks an event and writes its row; a failure is kept for [`OutputFiles::check`].
    pub(super) fn event<M: Described>(&mut self, model: &M, t: f64, event: &Event<'_, M>) {
        if let Some(plot) = &mut self.plot {
            plot.event(model, t, event);
        }
        if let Some(list) = &mut self.list {
            list.push(TimedEvent { name: event.cause.name(), t });
        }
        let Some(sheet) = &mut self.events else { return };
        let ((from, before), (to, after)) = (&event.before, &event.after);
        sheet.text(&seventeen_digits(t));
        sheet.text(event.cause.name());
        sheet.text(&mode_name(model, *from));
        sheet.text(&mode_name(model, *to));
        sheet.numbers(known(model, before));
        sheet.numbers(known(model, after));
        sheet.numbers(&[event.impulse, event.error, event.projection]);
        match event.cause {
            EventCause::Guard(_) => sheet.text("1"),
            EventCause::Impacts(n) => sheet.number(n),
            EventCause::Settled => sheet.number(f64::INFINITY),
        }
        if let Err(failure) = sheet.end() {
            self.failure.get_or_insert(failure);
        }
    }

    pub(super) fn check(&mut self) -> Result<(), SimulateError> {
        self.failure.take().map_or(Ok(()), Err)
    }

    /// Completes the files; returns the events, if they are listed.
    pub(super) fn finish(self) -> Result<Vec<TimedEvent>, SimulateError> {
        // Try all: one failure is no reason to lose the others.
        let plotted = self.plot.map_or(Ok(()), Plot::finish);
        let [first, second] =
            [self.trajectory, self.events].map(|sheet| sheet.map(CsvFile::finish));
        first.unwrap_or(Ok(())).and(second.unwrap_or(Ok(()))).and(plotted)?;
        Ok(self.list.unwrap_or_default())
    }
}

/// Returns the named entries of `state`; a described model may have room for more.
fn known<'a, M: Described>(model: &M, state: &'a M::State) -> &'a [f64] {
    let entries = state.entries();
    entries.get(..model.entry().states.len()).unwrap_or(entries)
}

/// Returns the names of all modes' guards, in the order of first use.
fn guard_names<M: Described>(model: &M) -> Vec<&'static str> {
    let mut names = Vec::new();
    for GuardSpec { name, .. } in model.modes().flat_map(|(mode, _)| model.guards(mode)) {
        if !names.contains(name) {
            names.push(*name);
        }
    }
    names
}

fn trajectory_header<M: Described>(model: &M, guards: &[&str]) -> Vec<String> {
    let ModelEntry { states, input, .. } = model.entry();
    let mut header: Vec<String> = ["t", "mode"].map(String::from).to_vec();
    header.extend(states.iter().map(|name| (*name).to_owned()));
    header.extend(Some(*input).filter(|name| !name.is_empty()).map(str::to_owned));
    header.extend(guards.iter().map(|name| format!("guard_{name}")));
    for name in model.entry().quantities() {
        let taken = header.iter().any(|column| column == name);
        header.push(if taken { format!("output_{name}") } else { (*name).to_owned() });
    }
    header.extend(SLOPES.iter().chain(&ENERGIES).map(|name| (*name).to_owned()));
    header
}

fn event_header<M: Described>(model: &M) -> Vec<String> {
    let names = &model.entry().states;
    let states = |when: &'static str| names.iter().map(move |name| format!("{name}_{when}"));
    let mut header: Vec<String> = ["t", "guard", "from", "to"].map(String::from).to_vec();
    header.extend(states("before").chain(states("after")));
    header.extend(["impulse", "error", "projection", "stands_for"].map(String::from));
    header
}

/// Formats `t` (s) without an exponent, with 17 significant digits.
fn seventeen_digits(t: f64) -> String {
    /// Maximum decimals: nothing is located to 1e-30 s.
    const MOST: i32 = 30;
    if t == 0.0 {
        return "0.0".to_owned();
    }
    #[expect(clippy::cast_possible_truncation, reason = "a logarithm of an f64 is below 400")]
    let whole = t.abs().log10().floor() as i32 + 1;
    let decimals = usize::try_from((17 - whole).clamp(1, MOST)).unwrap_or(1);
    format!("{t:.decimals$}")
}

#[derive(Debug)]
struct CsvFile {
    path: PathBuf,
    writer: csv::Writer<File>,
    record: csv::StringRecord,
    digits: String,
}

impl CsvFile {
    fn create(path: &Path, header: &[String]) -> Result<Self, SimulateMistake> {
        let fail = |cause| SimulateMistake::Create { path: path.to_owned(), cause };
        let file = File::create(path).map_err(fail)?;
        let mut writer = csv::WriterBuilder::new().buffer_capacity(BUFFER).from_writer(file);
        writer.write_record(header).map_err(|cause| fail(cause.into()))?;
        let path = path.to_owned();
        Ok(Self { path, writer, record: csv::StringRecord::new(), digits: String::new() })
    }

    fn text(&mut self, text: &str) {
        self.record.push_field(text);
    }

    fn number(&mut self, number: f64) {
        self.digits.clear();
        let _written = write!(self.digits, "{number:?}");
        self.record.push_field(&self.digits);
    }

    fn numbers(&mut self, numbers: &[f64]) {
        for number in numbers {
            self.number(*number);
        }
    }

    fn end(&mut self) -> Result<(), SimulateError> {
        let written = self.writer.write_record(&self.record);
        self.record.clear();
        written.map_err(|cause| SimulateError::Write { path: self.path.clone(), cause })
    }

    fn finish(mut self) -> Result<(), SimulateError> {
        let flushed = self.writer.flush();
        flushed.map_err(|cause| SimulateError::Write { path: self.path, cause: cause.into() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_have_seventeen_digits() {
        assert_eq!(seventeen_digits(0.629_650_783_081_382), "0.62965078308138200");
        assert_eq!(seventeen_digits(1.5), "1.5000000000000000");
        assert_eq!(seventeen_digits(0.001), "0.0010000000000000000");
        assert_eq!(seventeen_digits(123.0), "123.00000000000000");
        assert_eq!(seventeen_digits(0.0), "0.0");
        for t in [1e-7, 0.1 + 0.2, 1.0 / 3.0, 2e5 / 3.0, 1.0 - f64::EPSILON] {
            assert_eq!(seventeen_digits(t).parse(), Ok(t));
        }
    }
}
