//! MIDI program changes, which switch instruments while the keys play.

use std::{sync::Arc, sync::mpsc, thread};

use keyboard::KeyRange;
use midi::{ProgramChange, ProgramInput, Unavailable};
use scene::{Instrument, MidiInput, Scene};
use telemetry::Request;

use super::RequestHandler;

/// A listener for program changes on the scene's port, until it is dropped.
#[derive(Debug)]
pub struct ProgramListener {
    _input: ProgramInput,
}

impl ProgramListener {
    /// Listens for the host of `handler`; `None` if its scene names no port.
    ///
    /// A separate thread reads and builds instruments, one change after the other. The error is a
    /// sentence.
    pub fn start(handler: &Arc<RequestHandler>) -> Result<Option<Self>, String> {
        let (changes, queue) = mpsc::channel::<ProgramChange>();
        // A listener that has ended needs no more changes.
        let heard = move |change| _ = changes.send(change);
        let input = match &handler.scene.midi.input {
            MidiInput::None => return Ok(None),
            MidiInput::Virtual => ProgramInput::create(heard),
            MidiInput::Port(name) => ProgramInput::connect(name, heard),
        };
        let input = input.map_err(|error: Unavailable| error.to_string())?;
        let handler = Arc::clone(handler);
        let switch = move || queue.iter().for_each(|change| handler.change_program(change));
        let started = thread::Builder::new().name("letoff-programs".into()).spawn(switch);
        started.map_err(|error| format!("no thread for program changes: {error}"))?;
        Ok(Some(Self { _input: input }))
    }
}

impl RequestHandler {
    fn change_program(&self, change: ProgramChange) {
        let ProgramChange { channel, program } = change;
        let who = format!("program change {program} on channel {channel}");
        let done = wanted(&self.scene, change).and_then(|(keys, instrument)| {
            let request = Request::UseInstrument { instrument, keys: Some(typed(keys)) };
            self.answer(&request, &who).map(drop)
        });
        if let Err(why) = done {
            self.run.log(format!("{who} changes nothing: {why}"));
        }
    }
}

/// Returns the keys and the new instrument of `change`. A channel is the number of a range in the
/// scene's file; a channel for all means the only range.
fn wanted(scene: &Scene, change: ProgramChange) -> Result<(KeyRange, String), String> {
    let ProgramChange { channel, program } = change;
    let keys = match scene.ranges.as_slice() {
        [only] => Some(only),
        ranges => ranges.get(usize::from(channel) - 1),
    };
    let n = scene.ranges.len();
    let keys =
        *keys.ok_or_else(|| format!("the scene has {n} key ranges, one for each channel"))?;
    let programs = &scene.midi.programs;
    let instrument = if programs.is_empty() {
        Instrument::of_program(program).map(str::to_owned).ok_or_else(|| {
            "no instrument has this number of General MIDI; list the scene's own under \
             [midi] programs"
                .to_owned()
        })
    } else {
        let known = programs.get(usize::from(program) - 1).cloned();
        known.ok_or_else(|| format!("the scene lists {} programs", programs.len()))
    };
    Ok((keys, instrument?))
}

fn typed(keys: KeyRange) -> String {
    format!("{}..{}", keys.first().midi(), keys.last().midi())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(ranges: &[&str], programs: &str) -> Scene {
        let keys = ranges
            .iter()
            .map(|it| format!("[[keys]]\nrange = \"{it}\"\ninstrument = \"grand-springs\"\n"));
        let text = format!("{}[midi]\n{programs}\n", keys.collect::<String>());
        Scene::from_text(&scene::Library::default(), "programs", text).expect("a good scene")
    }

    fn switched(scene: &Scene, channel: u8, program: u8) -> Result<(String, String), String> {
        let wanted = wanted(scene, ProgramChange { channel, program });
        wanted.map(|(keys, instrument)| (typed(keys), instrument))
    }

    #[test]
    fn every_channel_is_the_only_range_and_programs_are_general_midi_s() {
        let whole = scene(&["A0..C8"], "");
        for channel in [1, 2, 16] {
            let expected = Ok(("21..108".to_owned(), "harpsichord".to_owned()));
            assert_eq!(switched(&whole, channel, 7), expected);
        }
        assert!(switched(&whole, 1, 128).is_err_and(|why| why.contains("General MIDI")));
    }

    #[test]
    fn a_split_has_a_channel_for_each_range_and_programs_of_its_own() {
        let split = scene(&["A0..B3", "C4..C8"], "programs = [\"celesta\", \"spring-wall\"]");
        let got = |keys: &str, name: &str| Ok((keys.to_owned(), name.to_owned()));
        assert_eq!(switched(&split, 1, 1), got("21..59", "celesta"));
        assert_eq!(switched(&split, 2, 2), got("60..108", "spring-wall"));
        assert!(switched(&split, 3, 1).is_err_and(|why| why.contains("2 key ranges")));
        assert!(switched(&split, 1, 3).is_err_and(|why| why.contains("2 programs")));
    }
}
