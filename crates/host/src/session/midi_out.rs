use std::os::unix::fs::FileTypeExt as _;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use documents::shown;
use midi::{Message, MidiSendError, Output, ScoreTiming, Smf};

use crate::control::RunHandle;
use crate::guardian::{GuardedOutput, GuardedPort, GuardianReport, GuardianTrouble};
use crate::midi_thread::{AnyOutput, PlaybackSummary};
use crate::report::{MidiReport, Quantiles};
use crate::session::{SessionError, patiently};
use midi::sound::SoundCounters;
use scene::{Midi, MidiOutput};

#[derive(Clone, Copy, Debug)]
struct Nowhere;

impl Output for Nowhere {
    fn send(&mut self, _at: f64, _message: Message) -> Result<(), MidiSendError> {
        Ok(())
    }

    fn finish(&mut self) -> Result<(), MidiSendError> {
        Ok(())
    }
}

pub(crate) fn nowhere() -> AnyOutput {
    Box::new(Nowhere)
}

#[derive(Clone, Debug)]
pub(super) struct OpenedOutput {
    pub(super) report: MidiReport,
    guardian: Arc<Mutex<GuardianReport>>,
    sound: Option<Arc<SoundCounters>>,
}

impl OpenedOutput {
    fn new(output: String, trouble: Option<String>) -> Self {
        let report = MidiReport { output, trouble, ..MidiReport::default() };
        Self { report, guardian: Arc::default(), sound: None }
    }

    pub(super) fn hear(&mut self, sound: String, counters: Option<Arc<SoundCounters>>) {
        (self.report.sound, self.sound) = (Some(sound), counters);
    }

    /// Returns its part of the report after the run, by this process and by the guardian.
    pub(super) fn report(&self, played: PlaybackSummary) -> MidiReport {
        let guardian = self.guardian.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let trouble = played.trouble.or(guardian.trouble);
        MidiReport {
            handover_us: played.handover.as_ref().map(Quantiles::of),
            passed_on_us: guardian.passed_on,
            interruptions: guardian.n_interruptions,
            failed: played.n_troubles + guardian.n_lost,
            trouble: trouble.or_else(|| self.report.trouble.clone()),
            callbacks: self.sound.as_ref().map(|counters| counters.report()),
            ..self.report.clone()
        }
    }
}

/// Opens the output, ports behind the guardian of `handle`; a file has the bars of `timing`.
///
/// A machine without MIDI is no error: the run continues, and the report names the remedy.
pub(super) fn open(
    midi: &Midi,
    timing: Option<&ScoreTiming>,
    handle: &Arc<RunHandle>,
) -> Result<(AnyOutput, OpenedOutput), SessionError> {
    let (port, name) = match &midi.output {
        MidiOutput::None => return Ok((nowhere(), OpenedOutput::new("none".into(), None))),
        MidiOutput::File(path) => {
            refuse_without_folder(path)?;
            refuse_pipe(path)?;
            let opened = OpenedOutput::new(shown(path), None);
            let file = Smf::new(path).with_timing(timing.cloned().unwrap_or_default());
            return Ok((Box::new(file), opened));
        }
        MidiOutput::Virtual => (GuardedPort::Virtual, "virtual port \"letoff\"".into()),
        MidiOutput::Port(name) => (GuardedPort::Named(name.clone()), format!("port \"{name}\"")),
        MidiOutput::Raw(path) => {
            refuse_file(path)?;
            let name = format!("device {}", shown(path));
            // The guardian may run in another directory.
            (GuardedPort::Raw(std::path::absolute(path)?), name)
        }
    };
    // A synthesizer may start at the same time.
    patiently(|| open_now(&port, &name, handle))
}

fn open_now(
    port: &GuardedPort,
    name: &str,
    handle: &Arc<RunHandle>,
) -> Result<(AnyOutput, OpenedOutput), SessionError> {
    let name = name.to_owned();
    match open_port(port, handle) {
        Ok((output, guardian)) => {
            Ok((output, OpenedOutput { guardian, ..OpenedOutput::new(name, None) }))
        }
        // It plays without a guardian, like a host without a folder for its sockets.
        Err(why @ GuardianTrouble::NoGuardian { .. }) => {
            match port.open().map_err(GuardianTrouble::from) {
                Ok((output, trouble)) => {
                    Ok((output, OpenedOutput::new(format!("{name}, unguarded: {why}"), trouble)))
                }
                Err(trouble) => without_port(name, &trouble),
            }
        }
        Err(trouble) => without_port(name, &trouble),
    }
}

fn without_port(
    name: String,
    trouble: &GuardianTrouble,
) -> Result<(AnyOutput, OpenedOutput), SessionError> {
    let why = trouble.to_string();
    match trouble {
        GuardianTrouble::Missing(_) => Ok((nowhere(), OpenedOutput::new(name, Some(why)))),
        GuardianTrouble::Refused(_) | GuardianTrouble::NoGuardian { .. } => {
            Err(SessionError::MidiPort(why))
        }
    }
}

fn open_port(
    port: &GuardedPort,
    handle: &Arc<RunHandle>,
) -> Result<(AnyOutput, Arc<Mutex<GuardianReport>>), GuardianTrouble> {
    let Some(path) = handle.guardian() else {
        let (output, trouble) = port.open()?;
        if let Some(trouble) = trouble {
            handle.log(trouble);
        }
        return Ok((output, Arc::default()));
    };
    let its = Arc::clone(handle);
    let output = GuardedOutput::open(path, port.clone(), Box::new(move |text| its.log(text)))?;
    let report = output.report();
    Ok((Box::new(output), report))
}

/// Rejects a file in a missing folder before the run, since it is written at the end.
pub(super) fn refuse_without_folder(path: &Path) -> Result<(), SessionError> {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() && !folder.is_dir() => {
            Err(SessionError::NoFolder { path: shown(path), folder: shown(folder) })
        }
        Some(_) | None => Ok(()),
    }
}

fn refuse_file(path: &Path) -> Result<(), SessionError> {
    if path.metadata().is_ok_and(|there| there.is_file() || there.is_dir()) {
        return Err(SessionError::Midi(format!(
            "{} is neither a device nor a FIFO; a name that ends in .mid writes a file",
            shown(path)
        )));
    }
    Ok(())
}

/// Rejects a FIFO, since opening one without a reader blocks for ever.
fn refuse_pipe(path: &Path) -> Result<(), SessionError> {
    if path.metadata().is_ok_and(|there| there.file_type().is_fifo()) {
        return Err(SessionError::Midi(format!(
            "{0} is a pipe, and a MIDI file is written whole at the end: give another name, or \
             raw:{0} to send the bytes of a cable",
            shown(path)
        )));
    }
    Ok(())
}
