//! `--plot`: the run as a picture, in the manner of `[GC93]` figure 6.
//!
//! In the order of a run: `curve` with its `unit`; `track`, `mark` and `epoch` keep the visible
//! part of a run; `run_picture` all of it; `draw` the SVG. Memory is bounded by the picture's
//! width, not by the run.

mod curve;
mod draw;
mod epoch;
mod mark;
mod run_picture;
mod source;
mod track;
mod unit;

use std::fs::File;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use instruments::Described;
use pode::{Event, Motion, Piece, Signal};

use self::curve::ModelInstant;
use self::epoch::Epochs;
use self::mark::EventMarks;
use self::run_picture::RunPicture;
use self::track::Columns;
use super::args::SimulateArgs;
use super::check::Start;
use super::error::{SimulateError, SimulateMistake};
use super::mode::mode_index;

/// A picture of a run with its file.
#[derive(Debug)]
pub(super) struct Plot {
    path: PathBuf,
    file: File,
    picture: RunPicture,
    outputs: Vec<f64>,
}

impl Plot {
    pub(super) fn create<M: Described>(
        path: &Path,
        args: &SimulateArgs,
        start: &Start<M>,
        guards: &[&'static str],
    ) -> Result<Self, SimulateMistake> {
        let fail = |cause| SimulateMistake::Create { path: path.to_owned(), cause };
        let file = File::create(path).map_err(fail)?;
        let axis = Columns { n: draw::COLUMNS, until: args.until };
        let model = &start.model;
        let entry = model.entry();
        let picture = RunPicture {
            title: [
                entry.name.to_owned(),
                args.method.clone(),
                format!("ticks of {} s", args.step),
            ],
            axis,
            modes: entry.modes.iter().map(|mode| mode.name).collect(),
            curves: curve::all(entry, guards, axis),
            epochs: Epochs::new(axis, mode_index(model, start.mode)),
            marks: EventMarks::new(axis),
        };
        let outputs = vec![0.0; entry.outputs.len()];
        Ok(Self { path: path.to_owned(), file, picture, outputs })
    }

    /// Follows a piece from `start` to `end` (s), by its dense output.
    pub(super) fn piece<M: Described, S: Signal<Motion>>(
        &mut self,
        model: &M,
        (start, end): (f64, f64),
        piece: &Piece<'_, M, S>,
    ) {
        let Self { picture, outputs, .. } = self;
        let n = picture.axis.samples(end - start);
        for sample in 0..=n {
            let part = sample as f64 / n as f64;
            let (state, input) = piece.at(part);
            let (state, mode) = (&model.constrain(piece.mode, &state, &input), piece.mode);
            model.outputs(mode, state, &input, outputs);
            let t = start + part * (end - start);
            let now = ModelInstant { t, mode, state, input: &input, outputs };
            picture.curves.iter_mut().for_each(|curve| curve.add(model, &now));
        }
        picture.epochs.last_until(end);
    }

    /// Marks an event at `t` (s).
    pub(super) fn event<M: Described>(&mut self, model: &M, t: f64, event: &Event<'_, M>) {
        self.picture.marks.add(t, event.cause.name());
        let [before, after] = [event.before.0, event.after.0].map(|mode| mode_index(model, mode));
        if before != after {
            self.picture.epochs.begin(t, after);
        }
    }

    pub(super) fn finish(mut self) -> Result<(), SimulateError> {
        let written = self.write();
        written.map_err(|cause| SimulateError::Write { path: self.path, cause: cause.into() })
    }

    fn write(&mut self) -> io::Result<()> {
        self.file.write_all(draw::svg(&self.picture).as_bytes())
    }
}
