//! Plotted curves: forces, guards, coordinates and the input.

use instruments::{Described, ModelEntry};
use pode::{Motion, State as _};

use super::source::CurveSource;
use super::track::{Columns, DecimatedCurve};
use super::unit;

/// Panels of the picture, from above.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum PanelKind {
    Forces,
    /// Guards, each over its peak.
    Guards,
    Coordinates,
}

/// A curve of the picture, with its values so far.
#[derive(Debug)]
pub(super) struct SignalCurve {
    pub(super) source: CurveSource,
    pub(super) name: &'static str,
    pub(super) unit: &'static str,
    pub(super) panel: PanelKind,
    pub(super) track: DecimatedCurve,
}

impl SignalCurve {
    fn value<M: Described>(&self, model: &M, now: &ModelInstant<'_, M>) -> Option<f64> {
        match self.source {
            CurveSource::Input => Some(now.input.position),
            CurveSource::State(index) => now.state.entries().get(index).copied(),
            CurveSource::Output(index) => now.outputs.get(index).copied(),
            CurveSource::Guard(name) => {
                let spec = model.guards(now.mode).iter().find(|spec| spec.name == name)?;
                Some(model.guard(now.mode, spec.id, now.state, now.input).value)
            }
        }
    }

    pub(super) fn add<M: Described>(&mut self, model: &M, now: &ModelInstant<'_, M>) {
        let value = self.value(model, now);
        self.track.add(now.t, value);
    }
}

pub(super) struct ModelInstant<'a, M: Described> {
    /// Model time (s).
    pub(super) t: f64,
    pub(super) mode: M::Mode,
    pub(super) state: &'a M::State,
    pub(super) input: &'a Motion,
    pub(super) outputs: &'a [f64],
}

/// Returns all curves: only forces of the outputs and no speeds, since the figure shows contact.
pub(super) fn all(entry: &ModelEntry, guards: &[&'static str], axis: Columns) -> Vec<SignalCurve> {
    let sources = [(entry.input, CurveSource::Input)].into_iter();
    let sources = sources.chain(indexed(&entry.states, CurveSource::State));
    let sources = sources.chain(indexed(&entry.outputs, CurveSource::Output));
    let sources = sources.chain(guards.iter().map(|name| (*name, CurveSource::Guard(name))));
    let curve = |(name, source): (&'static str, CurveSource)| {
        let unit = unit::of(entry, source)?;
        let panel = panel(source, unit)?;
        Some(SignalCurve { source, name, unit, panel, track: DecimatedCurve::new(axis) })
    };
    sources.filter_map(curve).collect()
}

fn indexed(
    names: &[&'static str],
    source: fn(usize) -> CurveSource,
) -> impl Iterator<Item = (&'static str, CurveSource)> {
    names.iter().enumerate().map(move |(index, name)| (*name, source(index)))
}

fn panel(source: CurveSource, unit: &str) -> Option<PanelKind> {
    match (source, unit) {
        (CurveSource::Guard(_), _) => Some(PanelKind::Guards),
        (CurveSource::Output(_), "N" | "N·m") => Some(PanelKind::Forces),
        (CurveSource::Input | CurveSource::State(_), "m" | "rad") => Some(PanelKind::Coordinates),
        (CurveSource::Output(_) | CurveSource::Input | CurveSource::State(_), _) => None,
    }
}
