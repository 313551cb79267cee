//! Points, epochs and events of a scope's plots.

use egui_plot::PlotBounds;
use telemetry::event::Kind;

use crate::{
    names, number, scope::Scope, scope::heights::Heights, store::Store, store::trace::OWN, unit,
};

/// Most epochs drawn in a plot: more would be a grey area.
const EPOCHS: usize = 160;

/// Width for which ends, smallest and largest value are drawn (points).
const BUCKET: f64 = 3.0;

pub(super) struct PlotTrace {
    pub(super) name: String,
    pub(super) key: u8,
    /// Index of the key among the scope's: its own is the first.
    pub(super) place: usize,
    /// Points of the curve, which breaks where there are no values.
    pub(super) segments: Vec<Vec<[f64; 2]>>,
    gain: f64,
    pub(super) unit: String,
    pub(super) is_hidden: bool,
}

/// A stretch of one mode, ready to be drawn (s).
pub(super) struct Shade {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) mode: u8,
    /// `true` if it begins with a switch of the mode.
    pub(super) is_switch: bool,
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

    fn values(&self) -> impl Iterator<Item = f64> {
        self.segments.iter().flatten().map(|point| point[1])
    }

    /// Returns the largest magnitude of a value, at least the smallest that its unit shows.
    fn size(&self) -> f64 {
        self.values().map(f64::abs).fold(least_span(&self.unit), f64::max)
    }
}

/// Returns the smallest range that fills a plot, so that noise at rest stays small: 0.5 N moves a
/// key down, 0.1 mm is 1 % of its dip, 1 mrad its turn by that; a soft stroke has 0.1 m/s.
fn least_span(unit: &str) -> f64 {
    match unit {
        "N" => 0.5,
        "mm" | "rad/s" => 0.1,
        "mrad" => 1.0,
        "m/s" => 0.01,
        _ => 0.0,
    }
}

/// Returns the curves of the plot `lane` in the view, key by key, all in the scale of the first.
pub(super) fn traces(
    store: &Store,
    keys: &[u8],
    (lane, channels): (usize, &[String]),
    scope: &mut Scope,
    (view, width): ((f64, f64), f32),
) -> Vec<PlotTrace> {
    let hidden = &scope.hidden;
    let of_key = |(place, key): (usize, &u8)| {
        let traces = channels.iter().filter_map(|name| trace(store, *key, name, view, width));
        let is_hidden = |it: &PlotTrace| hidden.contains(&(it.key, it.name.clone()));
        let traces = traces.map(|it| PlotTrace { place, is_hidden: is_hidden(&it), ..it });
        traces.collect::<Vec<_>>()
    };
    let mut traces: Vec<PlotTrace> = keys.iter().enumerate().flat_map(of_key).collect();
    let Some((unit, size)) = traces.first().map(|it| (it.unit.clone(), it.size())) else {
        return traces;
    };
    for i in 0..traces.len() {
        let (before, trace) = traces.split_at_mut(i);
        let trace = &mut trace[0];
        // The same channel of an earlier key keeps its gain, so that keys are comparable.
        let same = before.iter().find(|it| it.name == trace.name && it.unit == trace.unit);
        trace.gain = match same {
            _ if trace.unit == unit => 1.0,
            Some(same) => same.gain,
            None => scope.heights.gain(lane, &trace.name, size / trace.size()),
        };
        let gain = trace.gain;
        trace.segments.iter_mut().flatten().for_each(|point| point[1] *= gain);
    }
    traces
}

fn trace(store: &Store, key: u8, name: &str, view: (f64, f64), width: f32) -> Option<PlotTrace> {
    let (column, unit) = store.channel(key, name)?;
    let (from, to) = (store.tick(view.0.max(0.0)), store.tick(view.1.max(0.0)));
    let buckets = number::index(f64::from(width.max(64.0)) / BUCKET);
    let trace = store.trace(key)?;
    let mut segments = trace.segments(column, from, to, buckets);
    // Samples are of the tick's beginning, signals of its end.
    let shift = if OWN.len() <= column { 1.0 } else { 0.0 };
    let shown = unit::shown(unit);
    let factor = shown.map_or(1.0, |it| it.factor);
    let period = store.period();
    for point in segments.iter_mut().flatten() {
        *point = [(point[0] + shift) * period, point[1] * factor];
    }
    // A key that rests since its last row keeps its value.
    let end = view.1.min(store.newest());
    let is_last = trace.rests() && trace.ticks().last().is_some_and(|last| *last <= to);
    let has_value = trace.values(column).last().is_some_and(|it| it.is_finite());
    if let Some(last) = segments.last_mut().filter(|_| is_last && has_value)
        && let Some([at, value]) = last.last().copied()
        && at < end
    {
        last.push([end, value]);
    }
    let unit = shown.map_or(unit, |it| it.unit).to_owned();
    let (name, place, gain, is_hidden) = (name.to_owned(), 0, 1.0, false);
    Some(PlotTrace { name, key, place, segments, gain, unit, is_hidden })
}

/// Returns the bounds of the plot `lane`: the view across; up the chosen range, else all values and
/// zero.
pub(super) fn bounds(
    traces: &[PlotTrace],
    view: (f64, f64),
    heights: &mut Heights,
    lane: usize,
) -> PlotBounds {
    let (low, high) = heights.of(lane).unwrap_or_else(|| heights.automatic(lane, range(traces)));
    PlotBounds::from_min_max([view.0, low], [view.1, high])
}

fn range(traces: &[PlotTrace]) -> (f64, f64) {
    let values = traces.iter().filter(|it| !it.is_hidden).flat_map(PlotTrace::values);
    let (low, high) = values.fold((0.0_f64, 0.0_f64), |(a, b), y| (a.min(y), b.max(y)));
    let least = traces.first().map_or(0.0, |it| least_span(&it.unit));
    let least = if high - low < 1e-9 { least.max(2.0) } else { least };
    let missing = (least - (high - low)).max(0.0) / 2.0;
    (low - missing, high + missing)
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
    let mut shades = Vec::new();
    for i in first..last {
        let end = epochs.get(i + 1).map_or(view.1, |next| exact(next.tick)).min(view.1);
        let mut from = exact(epochs[i].tick).max(view.0);
        let mut is_switch = first < i;
        // The mode is unknown in a gap.
        let gaps = trace.gaps(store.tick(from), store.tick(end).saturating_add(1));
        for gap in gaps.iter().take(EPOCHS) {
            let to = store.seconds(gap.last.saturating_add(1));
            shades.push(Shade { from, to: to.min(end), mode: epochs[i].mode, is_switch });
            (from, is_switch) = (store.seconds(gap.next).max(from), false);
        }
        shades.push(Shade { from, to: end, mode: epochs[i].mode, is_switch });
    }
    shades.retain(|shade| shade.from < shade.to);
    shades
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
