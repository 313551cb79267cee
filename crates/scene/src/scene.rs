//! A scene: which keys, models, parameters, rate, links and MIDI.

use mechanism::Library;
use std::fs;
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::slice;

use keyboard::KeyRange;
use midi::VelocityCurve;
use pianist::{ChosenParts, Score, read_parts};

use super::embedded::{PERFORMANCES, SCENES};
use super::fidelity::{FidelityChoice, FidelityLevel, known_instrument, read_budget};
use super::keys::{self, KeyReading, KeyVoice, ReadKeys};
use super::links::{self, LinksConfig, Rate};
use super::needs::LoopSettings;
use super::overload;
use super::overrides;
use super::quantity::Quantity;
use super::read::{self, TableReader};
use super::realtime::{self, LaneCount, ThreadRules};
use super::render::{self, Render, TICK_HZ};
use super::rig::{self, Rig};
use super::source::{Override, SourceError, SourceText, no_file, refuse};
use super::voicing::Voicing;
use documents::toml::{FindingList, SourcePlace, TomlKind};
use documents::{Diagnostics, shown};
use documents::{choice, quoted};
use scheduler::overload::OverloadRules;

/// The tick's rate on hardware (Hz).
const DEFAULT_TICK_HZ: u32 = 1000;

/// Tracks that the header of a file can announce.
const MAX_TRACK: u16 = u16::MAX;

const MAX_CHANNEL: u16 = 16;

const LANES: Quantity = Quantity { unit: "1", range: (1.0, 16.0) };

/// A scene whose values were checked.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Reads descriptions, and knows those that the scene's keys play.
    pub library: Library,
    /// The embedded scene's name, or the file's without its ending.
    pub name: String,
    /// A description in a few words.
    pub title: String,
    /// Ticks in a second, 100 ..= 10000 (Hz).
    pub tick_hz: u32,
    /// Threads of the tick.
    pub realtime: ThreadRules,
    /// What is simplified while a tick has more work than time.
    pub overload: OverloadRules,
    /// Settings by which voices are computed.
    pub render: Render,
    pub rig: Rig,
    /// The voice of each of the 88 keys; none where it is silent.
    pub keys: Vec<Option<KeyVoice>>,
    pub voicings: Vec<Option<Voicing>>,
    /// The key ranges, in the order of the file: MIDI's channels from 1 on.
    pub ranges: Vec<KeyRange>,
    pub fidelity: FidelityChoice,
    pub links: LinksConfig,
    pub midi: Midi,
    /// The pieces of the virtual pianist, if there are any.
    pub play_list: Option<PlayList>,
}

/// The output of strikes, and their velocities; and what program changes switch to.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Midi {
    pub output: MidiOutput,
    pub curve: VelocityCurve,
    pub input: MidiInput,
    /// The instruments of the programs from 1 on, names or paths; those of General MIDI if empty.
    pub programs: Vec<String>,
    pub sound: SoundConfig,
}

/// Sound and pictures of what is played, beside the MIDI output.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct SoundConfig {
    /// `true` if the default sound device plays.
    pub is_live: bool,
    pub wav: Option<PathBuf>,
    /// SVG file with a picture of the notes.
    pub picture: Option<PathBuf>,
    /// SoundFont; an installed one if there is none.
    pub font: Option<PathBuf>,
}

/// A MIDI port to listen to.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub enum MidiInput {
    #[default]
    None,
    /// A port of our own, to which other programs connect.
    Virtual,
    /// The first port whose name contains this.
    Port(String),
}

/// A MIDI port or file.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub enum MidiOutput {
    #[default]
    None,
    /// A port of our own, to which other programs connect.
    Virtual,
    /// The first port whose name contains this.
    Port(String),
    /// A Standard MIDI File to be written, relative to the working directory.
    File(PathBuf),
    /// A MIDI device file or a FIFO, which takes the bytes of a cable.
    Raw(PathBuf),
}

/// What stands before the path of a MIDI device file.
pub(crate) const RAW: &str = "raw:";

/// What the virtual pianist plays, one piece after the other.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct PlayList {
    /// The pieces in their order, of which there is one at least.
    pub pieces: Vec<PerformanceSource>,
    /// Whether it begins again after the last, for ever.
    pub repeat: bool,
    /// Tracks and channels of every piece that are played.
    pub parts: ChosenParts,
}

/// A performance for the virtual pianist.
#[derive(Clone, PartialEq, Eq)]
pub enum PerformanceSource {
    /// An embedded one: its name and the MIDI file.
    Embedded(&'static str, &'static [u8]),
    Path(PathBuf),
}

impl std::fmt::Debug for PerformanceSource {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Embedded(name, _bytes) => f.debug_tuple("Embedded").field(name).finish(),
            Self::Path(path) => f.debug_tuple("Path").field(path).finish(),
        }
    }
}

/// Returns `true` if the file at `path` begins like a MIDI file.
pub fn is_midi_file(path: &Path) -> bool {
    let mut start = [0; 4];
    let read = || fs::File::open(path).and_then(|mut file| file.read_exact(&mut start));
    path.is_file() && { read }().is_ok() && matches!(&start, b"MThd" | b"RIFF")
}

impl PerformanceSource {
    /// Returns the name for messages.
    pub fn name(&self) -> String {
        match self {
            Self::Embedded(name, _bytes) => (*name).to_owned(),
            Self::Path(path) => shown(path),
        }
    }

    /// Reads the chosen `parts`.
    ///
    /// # Errors
    /// A sentence: the file cannot be read or played.
    pub fn score(&self, parts: &ChosenParts) -> Result<Score, String> {
        let read = |bytes: &[u8]| read_parts(bytes, parts).map_err(|error| error.to_string());
        match self {
            Self::Embedded(_name, bytes) => read(bytes),
            Self::Path(path) => read(&fs::read(path).map_err(|error| error.to_string())?),
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Stability {
    /// Hands and motors are in the loop.
    Required,
    /// It has run before, and is looked at again.
    Recorded,
}

impl Scene {
    /// Loads the embedded scene of that name, or the file at that path, with `overrides`.
    ///
    /// An override is a dotted path and its value: `tick_hz` and `4000`, `keys.0.instrument` and
    /// `grand-reduced`, `keys.parameters.restitution` and `0.2` (of all key ranges).
    ///
    /// # Errors
    ///
    /// All that is wrong with the scene and with the overrides.
    pub fn load(
        library: &Library,
        name_or_path: &str,
        overrides: &[(String, String)],
    ) -> Result<Self, Diagnostics> {
        let overrides: Vec<_> = overrides.iter().cloned().map(Override::from).collect();
        Self::load_as_typed(library, name_or_path, &overrides)
    }

    /// Loads a scene as [`Scene::load`] does; messages quote overrides as they were typed.
    ///
    /// # Errors
    ///
    /// All that is wrong with the scene and with the overrides.
    pub fn load_as_typed(
        library: &Library,
        name_or_path: &str,
        overrides: &[Override],
    ) -> Result<Self, Diagnostics> {
        let source = SourceText::find(&SCENES, name_or_path, Path::new(""));
        let source = source.map_err(|missing| match missing {
            SourceError::Unknown((message, help)) => {
                refuse(Path::new(name_or_path), None, message, help)
            }
            SourceError::Unreadable(diagnostics) => diagnostics,
        })?;
        Self::check(library, &source, overrides)
    }

    /// Returns the text of the file at `path`, for [`Scene::from_file_text`].
    ///
    /// # Errors
    ///
    /// If it cannot be read, or is no text.
    pub fn file_text(path: &Path) -> Result<String, Diagnostics> {
        SourceText::read(path).map(|source| source.text)
    }

    /// Loads the scene whose file at `path` had this `text`, as [`Scene::load_as_typed`] does.
    ///
    /// # Errors
    ///
    /// All that is wrong with the scene and with the overrides.
    pub fn from_file_text(
        library: &Library,
        path: &Path,
        text: String,
        overrides: &[Override],
    ) -> Result<Self, Diagnostics> {
        Self::check(library, &SourceText::from_bytes(path, text.into_bytes())?, overrides)
    }

    /// Returns the recorded scene of `text`, called `name`, whether it is stable or not; relative
    /// paths are to the working directory.
    ///
    /// # Errors
    ///
    /// All that is wrong with it.
    pub fn from_text(library: &Library, name: &str, text: String) -> Result<Self, Diagnostics> {
        let source = SourceText::from_bytes(Path::new(name), text.into_bytes())?;
        Self::read_from(library, &source, &[], Stability::Recorded)
    }

    pub(super) fn check(
        library: &Library,
        source: &SourceText,
        overrides: &[Override],
    ) -> Result<Self, Diagnostics> {
        Self::read_from(library, source, overrides, Stability::Required)
    }

    fn read_from(
        library: &Library,
        source: &SourceText,
        overrides: &[Override],
        stability: Stability,
    ) -> Result<Self, Diagnostics> {
        let (mut report, root) = source.parsed(overrides);
        let read = root.and_then(|mut root| {
            for (index, change) in overrides.iter().enumerate() {
                overrides::apply(&mut report, &mut root, index, change);
            }
            let mut reader = TableReader::new(&mut report, &source.name, &root)?;
            let scene = Self::read(&mut report, &mut reader, (&source.name, library), stability);
            reader.finish(&mut report);
            Some(scene)
        });
        report.verdict(read)
    }

    fn read(
        report: &mut FindingList,
        reader: &mut TableReader<'_>,
        (name, library): (&str, &Library),
        stability: Stability,
    ) -> Self {
        let name = name.to_owned();
        let title = reader.text(report, "title").map_or_else(|| name.clone(), |(title, _)| title);
        let rate = read_tick_hz(report, reader);
        let tick_hz = rate.map_or(DEFAULT_TICK_HZ, |rate| rate.hz);
        let lanes = read_lanes(report, reader).unwrap_or(LaneCount::Auto);
        let realtime = realtime::read(report, reader, lanes);
        let overload = overload::read(report, reader);
        let render = render::read(report, reader, tick_hz);
        let rig = rig::read(report, reader);
        let in_loop = match stability {
            Stability::Required => Some(LoopSettings { tick_hz, render: &render }),
            Stability::Recorded => None,
        };
        let budget = read_budget(report, reader);
        let reading = KeyReading { library, in_loop };
        let ReadKeys { voicings, ranges, auto } = keys::read(report, reader, reading);
        let voice = |(key, voicing): (u8, &Option<Voicing>)| {
            voicing.as_ref().map(|voicing| KeyVoice::new(voicing, key))
        };
        let keys = (0..).zip(&voicings).map(voice).collect();
        let links = links::read(report, reader, rate);
        let midi = read_midi(report, reader);
        let play_list = read_pianist(report, reader);
        Self {
            library: library.clone(),
            name,
            title,
            tick_hz,
            realtime,
            overload,
            render,
            rig,
            keys,
            voicings,
            ranges,
            fidelity: FidelityChoice { ranges: auto, budget },
            links,
            midi,
            play_list,
        }
    }

    /// Gives the keys of `range` one of its levels; a key without a voice stays so.
    pub fn set_fidelity(&mut self, range: KeyRange, level: &FidelityLevel) {
        for key in range.numbers() {
            let index = usize::from(key);
            self.voicings[index] = Some(level.voicing.clone());
            if let Some(voice) = &mut self.keys[index] {
                *voice = KeyVoice::new(&level.voicing, key);
            }
        }
    }
}

fn read_tick_hz(report: &mut FindingList, reader: &mut TableReader<'_>) -> Option<Rate> {
    let node = &reader.take("tick_hz")?.node;
    let hz = read::whole(report, "tick_hz", node, TICK_HZ)?;
    Some(Rate { hz, place: node.place })
}

fn read_lanes(report: &mut FindingList, reader: &mut TableReader<'_>) -> Option<LaneCount> {
    let node = &reader.take("lanes")?.node;
    if let TomlKind::Text(text, _) = &node.kind {
        if text == "auto" {
            return Some(LaneCount::Auto);
        }
        let message = format!("\"lanes\" is {}", quoted(text));
        report.say(node.place, message, "give \"auto\" or a number, 1 to 16");
        return None;
    }
    let count = read::whole(report, "lanes", node, LANES)?;
    Some(LaneCount::Count(usize::try_from(count).unwrap_or(1)))
}

fn read_midi(report: &mut FindingList, scene: &mut TableReader<'_>) -> Midi {
    let mut midi = Midi::default();
    let Some(mut reader) = scene.table(report, "midi") else { return midi };
    if let Some((output, place)) = reader.text(report, "output") {
        if let Some(mistake) = mistaken_output(&output) {
            report.say(place, format!("{} {mistake}", quoted(&output)), OUTPUTS);
        }
        midi.output = midi_output(output);
    }
    let curves = VelocityCurve::ALL.map(|curve| (curve.name(), curve));
    if let Some(curve) = reader.choice(report, "curve", "there is no velocity curve", &curves) {
        midi.curve = curve;
    }
    if let Some((input, _)) = reader.text(report, "input") {
        midi.input = match input.as_str() {
            "none" => MidiInput::None,
            "virtual" => MidiInput::Virtual,
            _ => MidiInput::Port(input),
        };
    }
    midi.programs = read_programs(report, &mut reader);
    let help = "give true to play through the default sound device";
    midi.sound.is_live = read_truth(report, &mut reader, "sound", help);
    let SoundConfig { wav, picture, font, .. } = &mut midi.sound;
    for (name, path) in [("wav", wav), ("picture", picture), ("font", font)] {
        *path = reader.text(report, name).map(|(path, _)| path.into());
    }
    reader.finish(report);
    midi
}

fn read_programs(report: &mut FindingList, midi: &mut TableReader<'_>) -> Vec<String> {
    let Some(entry) = midi.take("programs") else { return Vec::new() };
    let TomlKind::List(nodes) = &entry.node.kind else {
        let help = "write the instruments of the programs from 1 on, as [\"grand\", \"organ\"]";
        read::wrong_kind(report, "programs", &entry.node, "a list", help);
        return Vec::new();
    };
    let mut programs = Vec::new();
    for node in nodes {
        let name = read::text(report, "programs", node);
        programs.extend(name.and_then(|name| known_instrument(report, node.place, &name)));
    }
    programs
}

const OUTPUTS: &str = "give one of: a file that ends in .mid, raw: and a device, part of a port's name, virtual, none";

/// Returns the output with the name `output`, as a scene has it.
pub fn midi_output(output: String) -> MidiOutput {
    if output == "none" {
        MidiOutput::None
    } else if output == "virtual" {
        MidiOutput::Virtual
    } else if let Some(path) = output.strip_prefix(RAW) {
        MidiOutput::Raw(path.into())
    } else if ends_in(&output, &["mid", "midi"]) {
        MidiOutput::File(output.into())
    } else {
        MidiOutput::Port(output)
    }
}

/// Returns the reason why `output` is neither a file nor a port, if it is meant as a file.
fn mistaken_output(output: &str) -> Option<&'static str> {
    const FILES: &str = "smf midi2 mid2 kar rmi wav flac ogg mp3 mcap csv json toml txt sf2";
    let is_midi = |part| ends_in(part, &["mid", "midi"]);
    if output.contains(',') && output.split(',').any(is_midi) {
        return Some("is a list, and there is one MIDI output");
    }
    if !matches!(midi_output(output.to_owned()), MidiOutput::Port(_)) {
        return None;
    }
    if FILES.split(' ').any(|ending| ends_in(output, &[ending])) {
        return Some("has the ending of another kind of file");
    }
    output.contains('/').then_some("is a path of no MIDI file, and no port")
}

fn ends_in(name: &str, endings: &[&str]) -> bool {
    let ending = Path::new(name.trim()).extension();
    ending.is_some_and(|it| endings.iter().any(|known| it.eq_ignore_ascii_case(known)))
}

fn read_pianist(report: &mut FindingList, scene: &mut TableReader<'_>) -> Option<PlayList> {
    let mut reader = scene.table(report, "pianist")?;
    let tracks = read_numbers(report, &mut reader, ("track", MAX_TRACK));
    let channels = read_numbers(report, &mut reader, ("channel", MAX_CHANNEL));
    let parts = ChosenParts {
        tracks: tracks.into_iter().filter_map(|it| it.try_into().ok()).collect(),
        channels: channels.into_iter().filter_map(|it| it.try_into().ok()).collect(),
    };
    let pieces = read_pieces(report, &mut reader, &parts);
    let help = "give true to begin again after the last piece, without an end";
    let repeat = read_truth(report, &mut reader, "repeat", help);
    reader.finish(report);
    (!pieces.is_empty()).then_some(PlayList { pieces, repeat, parts })
}

/// Reads a number from 1 to `most`, or a list of them; an empty list if there is none.
fn read_numbers(
    report: &mut FindingList,
    pianist: &mut TableReader<'_>,
    (name, most): (&'static str, u16),
) -> Vec<u32> {
    let Some(entry) = pianist.take(name) else { return Vec::new() };
    let node = &entry.node;
    let nodes = if let TomlKind::List(nodes) = &node.kind { nodes } else { slice::from_ref(node) };
    let number = Quantity { unit: "1", range: (1.0, most.into()) };
    nodes.iter().filter_map(|node| read::whole(report, name, node, number)).collect()
}

fn read_pieces(
    report: &mut FindingList,
    pianist: &mut TableReader<'_>,
    parts: &ChosenParts,
) -> Vec<PerformanceSource> {
    let Some(entry) = pianist.take("performance") else {
        let help = "add performance = \"…\", or leave the table out";
        report.miss(pianist.place, "the pianist has no performance", help);
        return Vec::new();
    };
    let node = &entry.node;
    let nodes = if let TomlKind::List(nodes) = &node.kind { nodes } else { slice::from_ref(node) };
    if nodes.is_empty() {
        report.say(node.place, "\"performance\" is empty", "name a piece, or give \"none\"");
    }
    let mut pieces = Vec::new();
    for node in nodes {
        let Some(wanted) = read::text(report, "performance", node) else { continue };
        if wanted != "none" {
            pieces.extend(find_performance(report, node.place, &wanted, parts));
        } else if 1 < nodes.len() {
            let message = "\"none\" is no piece of a list";
            report.say(node.place, message, "leave it out, or give performance = \"none\" alone");
        }
    }
    pieces
}

fn read_truth(
    report: &mut FindingList,
    table: &mut TableReader<'_>,
    name: &'static str,
    help: &str,
) -> bool {
    let Some(entry) = table.take(name) else { return false };
    if let TomlKind::Truth(is_set) = entry.node.kind {
        return is_set;
    }
    read::wrong_kind(report, name, &entry.node, "true or false", help);
    false
}

fn find_performance(
    report: &mut FindingList,
    place: SourcePlace,
    wanted: &str,
    parts: &ChosenParts,
) -> Option<PerformanceSource> {
    let embedded = PERFORMANCES.iter().find(|(name, _)| *name == wanted);
    let path = report.folder(place).join(wanted);
    let source = match embedded {
        Some((name, bytes)) => Some(PerformanceSource::Embedded(name, bytes)),
        None => path.is_file().then(|| PerformanceSource::Path(path.clone())),
    };
    if let Some(source) = source {
        let read = source.score(parts);
        if let Err(why) = &read {
            let message = format!("the performance {} cannot be played: {why}", source.name());
            report.say(place, message, "give another MIDI file");
        }
        return read.is_ok().then_some(source);
    }
    let (message, help) = if Path::new(wanted).extension().is_some() {
        no_file(&path)
    } else {
        let known = PERFORMANCES.iter().map(|(name, _)| *name).chain(["none"]);
        let help = format!("{}, or a path to a MIDI file of yours", choice(wanted, known));
        (format!("there is no performance {}", quoted(wanted)), help)
    };
    report.say(place, message, help);
    None
}
