//! `letoff calibrate --range`: the range of values that a rig can render.

use std::f64::consts::TAU;
use std::io::Write;
use std::path::Path;

use boards::calibrate::range::MOST_FORCE;
use boards::calibrate::{
    Bench, CalibrationFault, RangeEnd, RangeFound, RangeMeasurement, RangeTerms, RangedObject,
    Travelled,
};
use boards::refusal::Refusal;
use firmware_protocol::key::KeyIndex;
use haptics::SampledWall;
use scene::{Library, Scene};
use serde::Serialize;

use super::bring_up::{self, ReadyKey};
use super::measure::again;
use super::{CalibrateArgs, Endings, attended};
use crate::{Failure, print_report};

#[derive(Debug, Serialize)]
struct RangeReport {
    key: String,
    board: String,
    tick_hz: u32,
    estimator: &'static str,
    travel_mm: f64,
    friction_n: f64,
    objects: Vec<ObjectRow>,
    /// Rig of the theory: the scene's values, and the measured link (N s/m, ms).
    damping: f64,
    delay_ms: f64,
    model_b: Vec<ModelRow>,
}

#[derive(Debug, Serialize)]
struct ObjectRow {
    object: &'static str,
    unit: &'static str,
    /// Largest value with which the key came to rest, if any.
    renders: Option<f64>,
    /// Motion of the key with the next value.
    then: &'static str,
    at: Option<f64>,
    /// Largest passive value by the theory.
    passive: f64,
}

#[derive(Debug, Serialize)]
struct ModelRow {
    parameter: &'static str,
    unit: &'static str,
    has: f64,
    /// Largest stiffness that the rig renders.
    renders: Option<f64>,
}

/// Raises the objects on the key that `args` select, and prints the results.
pub(super) fn run(args: &CalibrateArgs, out: &mut dyn Write) -> Result<(), Failure> {
    let (target, only, folder) = (args.target.clone(), args.board, args.folder.clone());
    let key = args.key;
    let report = attended(move || bring_up::find_key(&target, only, folder, key), measure)?;
    if args.json { print_report(&report, out) } else { print(&report, out) }
}

fn measure(ready: ReadyKey, endings: &Endings) -> Result<RangeReport, Failure> {
    let ReadyKey { scene, found, name, key, keybed } = ready;
    let mut bench = bring_up::arm(keybed, scene.tick_hz, endings)?;
    let period = 1.0 / f64::from(scene.tick_hz);
    let terms = RangeTerms {
        period,
        limit: MOST_FORCE.min(scene.render.force_limit),
        estimator: scene.render.estimator(period, found.nominal().quantum),
    };
    let outcome = self::key(&mut bench, key, &terms);
    let board = bench.keybed().board_reports().into_iter().next();
    let trip = board
        .and_then(|it| it.condition.round_trips_us)
        .map_or(0.0, |[median, ..]| 1e-6 * f64::from(median));
    let _disarmed = bench.release();
    let (travelled, ranges) = outcome.map_err(|fault| {
        let board = name.clone();
        Failure::Running(Refusal::Key { board, key, fault }.to_string())
    })?;
    let mut report = report(&scene, trip, key, &ranges);
    report.board = name.to_string();
    (report.travel_mm, report.friction_n) = (1e3 * travelled.0, travelled.1.friction);
    Ok(report)
}

/// Measures one key: its travel (m), its trip, and its range.
fn key(
    bench: &mut Bench,
    key: KeyIndex,
    terms: &RangeTerms,
) -> Result<((f64, Travelled), Vec<RangeFound>), CalibrationFault> {
    let rested = again(|| bench.rests(&[key]).pop().unwrap_or(Err(CalibrationFault::Stopped)))?;
    let travelled = again(|| bench.trip(key, &rested))?;
    let mut ranges = Vec::new();
    for object in RangedObject::ALL {
        // Discard the results of an interrupted measurement.
        ranges.push(again(|| {
            bench.range(key, RangeMeasurement::new(object, *terms, &rested, &travelled))
        })?);
    }
    Ok(((travelled.bottom - rested.position, travelled), ranges))
}

/// Returns results and theory of the scene's rig, behind a link with this round `trip` (s).
fn report(scene: &Scene, trip: f64, key: KeyIndex, ranges: &[RangeFound]) -> RangeReport {
    let rig = &scene.rig;
    let period = 1.0 / f64::from(scene.tick_hz);
    let delay = trip + rig.delay + 1.0 / (TAU * rig.motor_bandwidth);
    let none = SampledWall { stiffness: 0.0, damping: 0.0, period, delay };
    let spring = ranges.iter().find(|it| it.object == RangedObject::Spring);
    let row = |it: &RangeFound| {
        let (then, at) = match it.end {
            RangeEnd::Shook(at) => ("shook", Some(at)),
            RangeEnd::ForceLimit(at) => ("asked for more than the largest force", Some(at)),
            RangeEnd::Highest => ("is the largest that is tried", None),
        };
        let passive = match it.object {
            RangedObject::Spring => none.passive_stiffness(rig.damping),
            RangedObject::Dashpot => rig.damping,
            RangedObject::Mass => SampledWall::passive_mass(rig.damping, period),
        };
        let (object, unit) = (it.object.name(), it.object.unit());
        ObjectRow { object, unit, renders: it.good, then, at, passive }
    };
    RangeReport {
        key: key.to_string(),
        board: String::new(),
        tick_hz: scene.tick_hz,
        estimator: scene.render.estimator.name(),
        travel_mm: 0.0,
        friction_n: 0.0,
        objects: ranges.iter().map(row).collect(),
        damping: rig.damping,
        delay_ms: 1e3 * delay,
        model_b: model_b(key, spring.and_then(|it| it.good)),
    }
}

/// Returns the largest stiffness of model B's springs for a front of stiffness `front` (N/m): each
/// with the other spring and the key between them rigid, the stiffest case.
fn model_b(key: KeyIndex, front: Option<f64>) -> Vec<ModelRow> {
    let Ok(model) = Library::default().find("key-hammer-springs", Path::new("")) else {
        return Vec::new();
    };
    let Some(preset) = model.presets.iter().find(|it| it.name == "playable") else {
        return Vec::new();
    };
    let value = |name: &str| {
        let index = model.parameters.iter().position(|it| it.name == name);
        index.map_or(f64::NAN, |index| preset.value(index, key.number()))
    };
    let (lever, slider) = (value("r"), value("L1"));
    let row = |parameter, unit, per_front: f64| ModelRow {
        parameter,
        unit,
        has: value(parameter),
        renders: front.map(|it| it * per_front),
    };
    let torsion = lever * lever;
    vec![row("k1", "N·m/rad", torsion), row("k2", "N/m", torsion / (slider * slider))]
}

fn print(report: &RangeReport, out: &mut dyn Write) -> Result<(), Failure> {
    let RangeReport { key, board, tick_hz, estimator, travel_mm, friction_n, .. } = report;
    writeln!(
        out,
        "{key} of {board} at {tick_hz} Hz, {estimator}: travel {travel_mm:.2} mm, friction \
         {friction_n:.3} N"
    )?;
    writeln!(out, "  {:8} {:>16} {:>16}  then", "object", "renders up to", "passive up to")?;
    for ObjectRow { object, unit, renders, then, at, passive } in &report.objects {
        let renders = shown(*renders, unit);
        let at = at.map_or_else(String::new, |at| format!("{} ", shown(Some(at), unit)));
        let passive = shown(Some(*passive), unit);
        writeln!(out, "  {object:8} {renders:>16} {passive:>16}  {at}{then}")?;
    }
    writeln!(
        out,
        "renders: with nobody at the key; passive: by the theory, in any hand, with {} N·s/m and \
         {:.2} ms of delay, as the scene's [rig] and the link's round trips say",
        report.damping, report.delay_ms
    )?;
    writeln!(out, "the paper's rig: springs up to 100 N/m, dashpots up to 1 N·s/m, no masses")?;
    for ModelRow { parameter, unit, has, renders } in &report.model_b {
        let renders = shown(*renders, unit);
        let has = shown(Some(*has), unit);
        writeln!(
            out,
            "model B: {parameter} up to {renders}, all else rigid; grand-springs has {has}"
        )?;
    }
    Ok(writeln!(
        out,
        "its bodies give way, so that more may be stable: `letoff check` tries a scene"
    )?)
}

fn shown(value: Option<f64>, unit: &str) -> String {
    let Some(value) = value else { return "none".to_owned() };
    let (value, unit) = if unit == "kg" { (1e3 * value, "g") } else { (value, unit) };
    let digits = usize::from(value < 10.0) + usize::from(value < 100.0);
    format!("{value:.digits$} {unit}")
}
