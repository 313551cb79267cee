//! `letoff instruments`: lists instruments and models.

use std::io::Write;
use std::path::Path;

use clap::{Args, Subcommand};
use instruments::ModelEntry;
use mechanism::kane::mechanism::{InstrumentSpec, Mechanism, MechanismParameter, MechanismPreset};
use mechanism::{describe, model_names};
use serde::Serialize;

use super::{Failure, ask, print_json};
use host::control::Request;
use scene::{InstrumentHead, Library, instruments};

/// What `letoff instruments` takes.
#[derive(Clone, Debug, Args)]
#[command(
    args_conflicts_with_subcommands = true,
    after_help = "Examples:
  letoff instruments key-hammer-springs          its modes, parameters and presets
  letoff instruments use spring-wall --keys C4..B4   on the host that is running"
)]
pub struct InstrumentsArgs {
    /// What to do besides listing.
    #[command(subcommand)]
    pub action: Option<Action>,
    /// A model or the path of its description, to see modes and guards, parameters and presets.
    pub model: Option<String>,
    /// Prints the list as JSON.
    #[arg(long)]
    pub json: bool,
}

/// What can be done with instruments.
#[derive(Clone, Debug, Subcommand)]
pub enum Action {
    /// Gives keys of the running host another instrument, without a force step.
    Use {
        /// An instrument's name or file.
        instrument: String,
        /// Which keys, as `C4..B5` or `60..83`; all without.
        #[arg(long)]
        keys: Option<String>,
    },
}

#[derive(Serialize)]
struct InstrumentListing<M> {
    instruments: Vec<InstrumentHead>,
    models: M,
}

/// What the description of a model states by itself.
#[derive(Serialize)]
struct ModelHead {
    name: String,
    summary: String,
    parameters: Vec<ParameterInfo>,
    presets: Vec<PresetInfo>,
}

/// A model with what follows from its equations.
#[derive(Serialize)]
struct ModelInfo {
    #[serde(flatten)]
    head: ModelHead,
    /// File of its description; null for a built-in one.
    file: Option<String>,
    input: SignalInfo,
    states: Vec<SignalInfo>,
    outputs: Vec<SignalInfo>,
    modes: Vec<ModeInfo>,
}

#[derive(Serialize)]
struct SignalInfo {
    name: &'static str,
    unit: &'static str,
}

/// Degrees of freedom in the paper's letters: n coordinates, m constraints, p = n − m.
#[derive(Serialize)]
struct ModeInfo {
    name: &'static str,
    n: u8,
    m: u8,
    p: u8,
    guards: Vec<GuardInfo>,
}

#[derive(Serialize)]
struct GuardInfo {
    name: &'static str,
    unit: &'static str,
    to: Vec<&'static str>,
}

#[derive(Serialize)]
struct ParameterInfo {
    name: String,
    title: String,
    unit: String,
    range: (f64, f64),
    default: f64,
    doc: String,
}

#[derive(Serialize)]
struct PresetInfo {
    name: String,
    doc: String,
}

impl From<Mechanism> for ModelHead {
    fn from(mechanism: Mechanism) -> Self {
        let defaults = mechanism.default_values(0);
        let parameter = |(it, default): (MechanismParameter, f64)| {
            let MechanismParameter { name, title, unit, range, doc, .. } = it;
            ParameterInfo { name, title, unit, range, default, doc }
        };
        let InstrumentSpec { summary, presets, .. } = mechanism.instrument;
        let preset = |MechanismPreset { name, doc, .. }| PresetInfo { name, doc };
        Self {
            name: mechanism.name,
            summary,
            parameters: mechanism.parameters.into_iter().zip(defaults).map(parameter).collect(),
            presets: presets.into_iter().map(preset).collect(),
        }
    }
}

impl ModelInfo {
    fn new(head: ModelHead, entry: &ModelEntry) -> Self {
        Self {
            head,
            file: entry.file().map(str::to_owned),
            input: SignalInfo { name: entry.input, unit: entry.input_unit },
            states: signals(&entry.states, &entry.state_units),
            outputs: signals(&entry.outputs, &entry.output_units),
            modes: entry.modes.iter().map(ModeInfo::from).collect(),
        }
    }
}

fn signals(names: &[&'static str], units: &[&'static str]) -> Vec<SignalInfo> {
    names.iter().zip(units).map(|(name, unit)| SignalInfo { name, unit }).collect()
}

impl From<&instruments::ModeEntry> for ModeInfo {
    fn from(mode: &instruments::ModeEntry) -> Self {
        let guard = |it: &instruments::GuardEntry| GuardInfo {
            name: it.name,
            unit: it.unit,
            to: it.to.clone(),
        };
        let instruments::ModeEntry { name, n, m, p, ref guards } = *mode;
        Self { name, n, m, p, guards: guards.iter().map(guard).collect() }
    }
}

pub(super) fn run(args: &InstrumentsArgs, out: &mut dyn Write) -> Result<(), Failure> {
    if let Some(Action::Use { instrument, keys }) = &args.action {
        return switch(instrument, keys.clone(), out);
    }
    let instruments = instruments();
    if let Some(name) = &args.model {
        let model = Library::default().find(name, Path::new(""));
        let model = model.map_err(|missing| Failure::Usage(missing.rendered()))?;
        let model = ModelInfo::new(head(name)?, &model);
        if args.json {
            return print_json(&InstrumentListing { instruments, models: [model] }, out);
        }
        return print_model(&model, out);
    }
    let models = model_names().map(head).collect::<Result<Vec<_>, _>>()?;
    if args.json {
        return print_json(&InstrumentListing { instruments, models }, out);
    }
    writeln!(out, "Instruments (a scene's `instrument = \"…\"`):")?;
    for it in &instruments {
        writeln!(out, "  {:16} {} ({}, {})", it.name, it.title, it.model, it.preset)?;
        if let Some(needs) = &it.needs {
            writeln!(out, "  {:16} needs {needs}", "")?;
        }
    }
    writeln!(out, "\nModels (`letoff instruments MODEL` shows parameters):")?;
    models.iter().try_for_each(|model| print_head(model, out))
}

fn head(model: &str) -> Result<ModelHead, Failure> {
    let description = describe(model).map_err(|missing| Failure::Usage(missing.rendered()))?;
    Ok(description.mechanism.into())
}

fn switch(instrument: &str, keys: Option<String>, out: &mut dyn Write) -> Result<(), Failure> {
    // The host may have another working folder.
    let path = std::fs::canonicalize(instrument).map(|path| path.to_string_lossy().into_owned());
    let instrument = path.unwrap_or_else(|_no_file| instrument.to_owned());
    ask::ask(&Request::UseInstrument { instrument, keys }, Failure::Usage, out)
}

fn print_head(model: &ModelHead, out: &mut dyn Write) -> Result<(), Failure> {
    Ok(writeln!(out, "  {:20} {}", model.name, model.summary)?)
}

fn print_model(model: &ModelInfo, out: &mut dyn Write) -> Result<(), Failure> {
    print_head(&model.head, out)?;
    for mode in &model.modes {
        print_mode(mode, out)?;
    }
    for preset in &model.head.presets {
        writeln!(out, "    preset {:12} {}", preset.name, preset.doc)?;
    }
    for it in &model.head.parameters {
        let (lo, hi) = it.range;
        writeln!(
            out,
            "    {:14} {:>12} {:12} {lo} ..= {hi}  {}",
            it.name, it.default, it.unit, it.doc
        )?;
    }
    Ok(())
}

fn print_mode(mode: &ModeInfo, out: &mut dyn Write) -> Result<(), Failure> {
    let ModeInfo { name, n, m, p, guards } = mode;
    let degrees = counted(*p, "degree of freedom", "degrees of freedom");
    let coordinates = counted(*n, "coordinate", "coordinates");
    let constraints = counted(*m, "constraint", "constraints");
    writeln!(
        out,
        "    mode {name:10} {degrees} (p = {p}; {coordinates}, n = {n}; {constraints}, m = {m})"
    )?;
    for guard in guards {
        writeln!(out, "      guard {:14} leads to {}", guard.name, guard.to.join(" or "))?;
    }
    Ok(())
}

fn counted(n: u8, one: &str, many: &str) -> String {
    match n {
        0 => format!("no {many}"),
        1 => format!("1 {one}"),
        _ => format!("{n} {many}"),
    }
}

#[cfg(test)]
mod tests {
    use mechanism::native::compiled_functions;

    use super::*;

    #[test]
    fn the_list_compiles_no_model() {
        let compiled = |model: Option<&str>, json| {
            let before = compiled_functions();
            let args = InstrumentsArgs { action: None, model: model.map(str::to_owned), json };
            let mut out = Vec::new();
            assert!(run(&args, &mut out).is_ok());
            (compiled_functions() - before, String::from_utf8(out).expect("a text"))
        };
        for json in [false, true] {
            let (count, text) = compiled(None, json);
            assert_eq!(count, 0);
            assert!(text.contains("Concert grand, whole action"), "{text}");
            assert!(model_names().all(|name| text.contains(name)), "{text}");
        }
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../configs/models/spring.toml");
        assert!(compiled(Some(file), false).0 > 0);
    }
}
