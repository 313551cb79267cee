//! What is plotted: forces, guards, coordinates and the input.

use models::Described;
use pode::{Motion, State as _};

use super::track::{Columns, Track};
use super::unit;

/// The panels, from above.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Panel {
    /// Forces and torques.
    Forces,
    /// Guards, each over its peak.
    Guards,
    /// Coordinates and the input.
    Coordinates,
}

/// Where a curve's values come from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Source {
    /// The input s.
    Input,
    /// An entry of the state.
    State(usize),
    /// An output.
    Output(usize),
    /// The guard of this name, in the modes that have it.
    Guard(&'static str),
}

/// One curve.
#[derive(Debug)]
pub(super) struct Curve {
    pub(super) source: Source,
    pub(super) name: &'static str,
    pub(super) unit: &'static str,
    pub(super) panel: Panel,
    pub(super) track: Track,
}

impl Curve {
    /// A value of it, if the mode has one.
    fn value<M: Described>(&self, model: &M, now: &Now<'_, M>) -> Option<f64> {
        match self.source {
            Source::Input => Some(now.input.position),
            Source::State(index) => now.state.entries().get(index).copied(),
            Source::Output(index) => now.outputs.get(index).copied(),
            Source::Guard(name) => {
                let spec = model.guards(now.mode).iter().find(|spec| spec.name == name)?;
                Some(model.guard(now.mode, spec.id, now.state, now.input).value)
            }
        }
    }

    /// Goes on to where the model is now.
    pub(super) fn add<M: Described>(&mut self, model: &M, now: &Now<'_, M>) {
        let value = self.value(model, now);
        self.track.add(now.t, value);
    }
}

/// A model at an instant.
pub(super) struct Now<'a, M: Described> {
    /// When [s].
    pub(super) t: f64,
    pub(super) mode: M::Mode,
    pub(super) state: &'a M::State,
    pub(super) input: &'a Motion,
    pub(super) outputs: &'a [f64],
}

/// All curves of a model.
///
/// Speeds and other outputs than forces are left out: the figure is about contact.
pub(super) fn all<M: Described>(guards: &[&'static str], axis: Columns) -> Vec<Curve> {
    let indexed = |names: &'static [&'static str], source: fn(usize) -> Source| {
        names.iter().enumerate().map(move |(index, name)| (*name, source(index)))
    };
    let sources = [("s", Source::Input)].into_iter();
    let sources = sources.chain(indexed(M::STATES, Source::State));
    let sources = sources.chain(indexed(M::OUTPUTS, Source::Output));
    let sources = sources.chain(guards.iter().map(|name| (*name, Source::Guard(name))));
    let curve = |(name, source): (&'static str, Source)| {
        let unit = unit::of(M::NAME, name)?;
        let panel = panel(source, unit)?;
        Some(Curve { source, name, unit, panel, track: Track::new(axis) })
    };
    sources.filter_map(curve).collect()
}

/// Where a curve belongs, if anywhere.
fn panel(source: Source, unit: &str) -> Option<Panel> {
    match (source, unit) {
        (Source::Guard(_), _) => Some(Panel::Guards),
        (Source::Output(_), "N" | "N·m") => Some(Panel::Forces),
        (Source::Input | Source::State(_), "m" | "rad") => Some(Panel::Coordinates),
        (Source::Output(_) | Source::Input | Source::State(_), _) => None,
    }
}
