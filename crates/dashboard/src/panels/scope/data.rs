//! Points, epochs and events of a scope's plots.

use egui_plot::PlotBounds;
use telemetry::event::Kind;

use crate::store::Store;
use crate::store::trace::OWN;
use crate::{names, number, unit};

/// Most epochs drawn in a plot: more would be a grey area.
const EPOCHS: usize = 160;

/// Width for which ends, smallest and largest value are drawn (points).
const BUCKET: f64 = 3.0;

pub(super) struct PlotTrace {
    name: String,
    key: u8,
    /// Index of the key among the scope's: its own is the first.
    pub(super) place: usize,
    pub(super) points: Vec<[f64; 2]>,
    gain: f64,
    pub(super) unit: String,
}

/// A stretch of one mode, ready to be drawn (s).
pub(super) struct Shade {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) mode: u8,
}

impl PlotTrace {
    /// Returns the name, and the gain relative to the first trace.
    pub(super) fn title(&self) -> String {
        let name = unit::named(&self.name, &self.unit);
        if (self.gain - 1.0).abs() < 1e-9 {
            name
        } else {
            format!("{name} × {}", unit::digits(self.gain))
        }
    }

    pub(super) fn title_with_key(&self) -> String {
        format!("{} {}", names::name(self.key), self.title())
    }
}

/// Returns the channels' points in the view, key by key, all in the scale of the first.
pub(super) fn traces(
    store: &Store,
    keys: &[u8],
    channels: &[String],
    view: (f64, f64),
    width: f32,
) -> Vec<PlotTrace> {
    let of_key = |(place, key): (usize, &u8)| {
        let traces = channels.iter().filter_map(|name| trace(store, *key, name, view, width));
        traces.map(|trace| PlotTrace { place, ..trace }).collect::<Vec<_>>()
    };
    let mut traces: Vec<PlotTrace> = keys.iter().enumerate().flat_map(of_key).collect();
    let Some((unit, size)) = traces.first().map(|it| (it.unit.clone(), size(&it.points))) else {
        return traces;
    };
    for i in 0..traces.len() {
        let gain = gain(&traces[i], &traces[..i], &unit, size);
        let trace = &mut traces[i];
        trace.gain = gain;
        trace.points.iter_mut().for_each(|point| point[1] *= gain);
    }
    traces
}

/// Returns the gain of a trace relative to the first with `unit` and `size`. The same channel of an
/// earlier key keeps its gain, so that keys are comparable.
fn gain(trace: &PlotTrace, before: &[PlotTrace], unit: &str, size: f64) -> f64 {
    let same = before.iter().find(|it| it.name == trace.name && it.unit == trace.unit);
    match same {
        _ if trace.unit == unit => 1.0,
        Some(same) => same.gain,
        None => number::round(size / self::size(&trace.points)),
    }
}

/// Returns the largest magnitude of a value.
fn size(points: &[[f64; 2]]) -> f64 {
    let sizes = points.iter().map(|point| point[1].abs()).filter(|it| it.is_finite());
    sizes.fold(0.0, f64::max)
}

fn trace(store: &Store, key: u8, name: &str, view: (f64, f64), width: f32) -> Option<PlotTrace> {
    let (column, unit) = store.channel(key, name)?;
    let (from, to) = (store.tick(view.0.max(0.0)), store.tick(view.1.max(0.0)));
    let buckets = number::index(f64::from(width.max(64.0)) / BUCKET);
    let mut points = store.trace(key)?.points(column, from, to, buckets);
    // Samples are of the tick's beginning, signals of its end.
    let shift = if OWN.len() <= column { 1.0 } else { 0.0 };
    let shown = unit::shown(unit);
    let factor = shown.map_or(1.0, |it| it.factor);
    let period = store.period();
    for point in &mut points {
        *point = [(point[0] + shift) * period, point[1] * factor];
    }
    points.retain(|point| point[1].is_finite());
    // A key that has not moved since keeps its value.
    if let Some([at, value]) = points.last().copied()
        && at < view.1
    {
        points.push([view.1, value]);
    }
    let unit = shown.map_or(unit, |it| it.unit).to_owned();
    Some(PlotTrace { name: name.to_owned(), key, place: 0, points, gain: 1.0, unit })
}

/// Returns the bounds of a plot: the view across; up the chosen range, else all values and zero.
pub(super) fn bounds(
    traces: &[PlotTrace],
    view: (f64, f64),
    chosen: Option<(f64, f64)>,
) -> PlotBounds {
    let (low, high) = chosen.unwrap_or_else(|| range(traces));
    PlotBounds::from_min_max([view.0, low], [view.1, high])
}

fn range(traces: &[PlotTrace]) -> (f64, f64) {
    let values = traces.iter().flat_map(|it| &it.points).map(|point| point[1]);
    let finite = values.filter(|value| value.is_finite());
    let (low, high) = finite.fold((0.0_f64, 0.0_f64), |(a, b), y| (a.min(y), b.max(y)));
    let room = if high - low < 1e-9 { 1.0 } else { 0.08 * (high - low) };
    (low - room, high + room)
}

/// Returns the modes in the view, from one switch to the next.
pub(super) fn shades(store: &Store, key: u8, view: (f64, f64)) -> Vec<Shade> {
    let Some(trace) = store.trace(key) else { return Vec::new() };
    let epochs = trace.epochs();
    let first = epochs.partition_point(|it| store.seconds(it.tick) <= view.0).saturating_sub(1);
    let last = epochs.partition_point(|it| store.seconds(it.tick) < view.1);
    if last <= first || EPOCHS < last - first {
        return Vec::new();
    }
    let switches = events(store, key, Kind::Switch, (view.0 - 1.0, view.1));
    let exact = |tick: u64| {
        let (from, to) = (store.seconds(tick), store.seconds(tick.saturating_add(1)));
        let within = switches.iter().copied().filter(|at| from <= *at && *at <= to);
        within.fold(from, f64::max)
    };
    let shade = |i: usize| {
        let end = epochs.get(i + 1).map_or(view.1, |next| exact(next.tick));
        Shade { from: exact(epochs[i].tick).max(view.0), to: end.min(view.1), mode: epochs[i].mode }
    };
    (first..last).map(shade).filter(|shade| shade.from < shade.to).collect()
}

/// Returns the times of a key's events in the view (s).
pub(super) fn events(store: &Store, key: u8, kind: Kind, view: (f64, f64)) -> Vec<f64> {
    // Newest last: what is before the view needs no check.
    let recent = store.events.iter().rev().take_while(|it| view.0 <= store.when(it) + 1.0);
    let of_kind = recent.filter(|it| it.key == u32::from(key) && it.kind() == kind);
    let mut times: Vec<f64> =
        of_kind.map(|it| store.when(it)).filter(|at| view.0 <= *at && *at <= view.1).collect();
    times.reverse();
    times
}
