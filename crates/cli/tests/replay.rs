//! Records a run, and replays it bit by bit.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use host::control::{Folders, Reply, Request, RequestHandler, follow_load};
use host::observe::RecordingHandle as Recorded;
use host::replay::{ReplayError, Replayed, replay};
use host::session::{RunOptions, RunSession};
use scene::Scene;
use telemetry::Update;
use telemetry::recording::{Recording, RecordingLimits, Selection, export_csv, marks};
use telemetry::request::{Change, RenderSetting};

use crate::common::{SILENT, run_while, scene, session};
use crate::typed::eventually;

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("letoff-replay-{}-{name}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn ode_to_joy() -> Scene {
    scene("mixed", &[("pianist.performance", "beethoven-ode-to-joy")])
}

fn begin(session: &RunSession, file: &Path) -> Recorded {
    session.handle().record_run(file, RecordingLimits::default()).expect("a new file")
}

fn record(scene: &Scene, options: RunOptions, file: &Path) {
    let session = RunSession::prepare(scene, options, &|_| {}).expect("a session");
    let recording = begin(&session, file);
    session.run(&AtomicBool::new(false)).expect("a report");
    assert_eq!(recording.report().trouble, None);
}

/// Returns all messages of the recording.
fn messages(file: &Path) -> Vec<Result<Update, String>> {
    let recording = Recording::open(file).expect("a recording");
    assert!(recording.tear().is_none());
    recording.messages().map(|it| it.map(|it| it.1).map_err(|error| error.to_string())).collect()
}

fn again(file: &Path) -> Result<Replayed, ReplayError> {
    replay(messages(file).into_iter(), |_| {})
}

/// Length of a run, with a piece from 2 s on.
const FOUR_SECONDS: RunOptions = RunOptions { duration: Some(4.0), virtual_time: true };

#[test]
fn a_piece_on_five_models_comes_out_the_same() {
    let file = folder("piece").join("a.mcap");
    record(&ode_to_joy(), RunOptions { duration: Some(6.0), ..FOUR_SECONDS }, &file);
    let replayed = again(&file).expect("a replay");
    assert_eq!(replayed.first_difference, None);
    assert_eq!((replayed.ticks, replayed.different), (24_000, 0), "six seconds at 4 kHz");
    assert!(0 < replayed.strikes && 1000 < replayed.compared, "{replayed:?}");
}

/// Half a second of C4 under a pedal that is never lifted.
const PIECE: &[u8] = b"MThd\0\0\0\x06\0\0\0\x01\x01\xf4MTrk\0\0\0\x11\
    \0\xb0\x40\x7f\0\x90\x3c\x40\x83\x74\x80\x3c\x40\0\xff\x2f\0";

#[test]
fn a_piece_that_repeats_comes_out_the_same_with_its_pedal() {
    let folder = folder("repeated");
    std::fs::write(folder.join("piece.mid"), PIECE).expect("a file");
    let piece = folder.join("piece.mid").display().to_string();
    let set = [("pianist.performance", piece.as_str()), ("pianist.repeat", "true")];
    let scene = scene("mixed", &set);
    let file = folder.join("a.mcap");
    // A pass of two and a half seconds.
    record(&scene, FOUR_SECONDS, &file);
    let replayed = again(&file).expect("a replay");
    assert_eq!((replayed.first_difference, replayed.strikes), (None, 2));
    let midi = messages(&file).into_iter().filter_map(|message| match message {
        Ok(Update::Midi(midi)) if midi.bytes.starts_with(&[0xb0, 0x40]) => Some(midi.bytes[2]),
        Ok(_) | Err(_) => None,
    });
    assert_eq!(midi.collect::<Vec<_>>(), [127, 0, 127, 0]);
}

#[test]
fn a_recording_that_breaks_off_is_the_same_as_far_as_it_goes() {
    let file = folder("torn").join("a.mcap");
    record(&ode_to_joy(), FOUR_SECONDS, &file);
    let all = messages(&file);
    let mut noticed = 0;
    for cut in [5, 6, 7].into_iter().flat_map(|part| (0..4).map(move |more| (part, more))) {
        let (part, more) = cut;
        let rest = all.iter().take(all.len() * part / 8 + more).cloned();
        let replayed = replay(rest, |_| {}).expect("a replay");
        assert_eq!(replayed.first_difference, None, "{cut:?}");
        assert!((1_000..16_000).contains(&replayed.ticks), "{cut:?}: {replayed:?}");
        noticed += u32::from(replayed.incomplete_from == Some(replayed.ticks));
    }
    assert!(6 < noticed, "most cuts are between rows and their ticks, but {noticed} of 12 were");
}

#[test]
fn a_replay_ends_at_a_hole_which_is_no_difference() {
    let file = folder("hole").join("a.mcap");
    record(&ode_to_joy(), FOUR_SECONDS, &file);
    let all = messages(&file);
    for (part, more) in [3, 5, 7].into_iter().flat_map(|part| (0..4).map(move |it| (part, it))) {
        let from = all.len() * part / 8 + more;
        let mut rest = all.clone();
        // A quarter of a second, like a damaged chunk.
        rest.splice(from..from + all.len() / 16, [Err("it is damaged".to_owned())]);
        let replayed = replay(rest.into_iter(), |_| {}).expect("a replay");
        assert_eq!(replayed.first_difference, None, "{part}, {more}");
        assert!((1_000..16_000).contains(&replayed.ticks), "{replayed:?}");
        assert_eq!(replayed.damage.as_deref(), Some("it is damaged"));
        assert_eq!(replayed.incomplete_from, Some(replayed.ticks));
        assert_eq!(replayed.recorded, replayed.ticks, "nothing behind the hole is read");
    }
    // Damage after the last tick removes nothing.
    let end = all.into_iter().chain([Err("it is damaged".to_owned())]);
    let replayed = replay(end, |_| {}).expect("a replay");
    assert_eq!((replayed.first_difference, replayed.incomplete_from), (None, None));
    assert_eq!((replayed.damage, replayed.ticks), (None, 16_000));
}

#[test]
fn a_changed_bit_is_found_where_it_is() {
    let file = folder("bit").join("a.mcap");
    record(&ode_to_joy(), FOUR_SECONDS, &file);
    let mut messages = messages(&file);
    let mut blocks = messages.iter_mut().filter_map(|message| match message {
        Ok(Update::Block(block)) if block.position.iter().any(|it| 0.0 < *it) => Some(block),
        Ok(_) | Err(_) => None,
    });
    let block = blocks.next().expect("a key that moves");
    let (row, sent) = (block.sent.len() / 2, block.sent[block.sent.len() / 2]);
    block.sent[row] = f64::from_bits(sent.to_bits() ^ 1);
    let tick = block.tick + u64::from(block.after[row]);
    drop(blocks);
    let replayed = replay(messages.into_iter(), |_| {}).expect("a replay");
    let first = replayed.first_difference.expect("a difference");
    assert_eq!((first.tick, replayed.different), (tick, 1), "{first}");
    assert!(first.text.contains("sent force"), "{first}");
}

/// A key whose first turn needs a thousand steps: this machine's speed decides the cut.
#[test]
fn a_turn_that_was_cut_off_is_cut_off_at_the_same_place_again() {
    let file = folder("cut-off").join("a.mcap");
    let parameters = "g=100 front=0.5 drop=0.015 shank=0.16 ms=0.0005 leads=0 t_lever=0 \
                      k_knuckle=1e7 k_lever_pad=0 wind_k=1e-6 b_jack=1";
    let of_key = parameters.split(' ').map(|it| format!("keys.0.parameters.{it}"));
    let of_key: Vec<_> = of_key.collect();
    let mut set: Vec<_> = of_key.iter().filter_map(|it| it.split_once('=')).collect();
    set.extend([("keys.0.range", "C4..C4"), ("render.stepper", "rk4"), SILENT]);
    let scene = scene("default", &set);
    record(&scene, RunOptions { duration: Some(0.5), virtual_time: false }, &file);
    let limits = messages(&file).into_iter().filter_map(|message| match message {
        Ok(Update::Block(block)) => Some(block.limit),
        Ok(_) | Err(_) => None,
    });
    let limits: Vec<_> = limits.flatten().filter(|limit| 0 < *limit).collect();
    assert!(!limits.is_empty() && limits.iter().all(|limit| *limit < 2000), "{limits:?}");
    assert_eq!(again(&file).expect("a replay").first_difference, None);
}

#[test]
fn values_and_instruments_that_change_in_a_run_change_in_its_replay() {
    let file = folder("tuned").join("a.mcap");
    let scene = scene("springs", &[SILENT]);
    tuned(&scene, RunOptions { duration: Some(2.0), virtual_time: false }, &file);
    let messages = messages(&file);
    let is_kept = |message: &&Result<Update, String>| matches!(message, Ok(Update::Voice(voice)) if voice.kept);
    assert_eq!(messages.iter().filter(is_kept).count(), 20);
    let replayed = replay(messages.into_iter(), |_| {}).expect("a replay");
    assert_eq!(replayed.first_difference, None);
    check_changes(&file);
}

/// Checks that each change of [`tuned`] is a mark and a row of the exported events.
#[track_caller]
fn check_changes(file: &Path) {
    let recording = Recording::open(file).expect("a recording");
    let sets = (1..20).map(|n| format!("test: C4 k2 {} -> {} N/m", 799 + n, 800 + n));
    let expected: Vec<_> = sets.chain(["test: 5 keys are now spring-wall".to_owned()]).collect();
    let texts: Vec<_> = marks(&recording).map(|it| it.text).collect();
    let found: Vec<_> = texts.iter().filter(|it| it.starts_with("test: ")).cloned().collect();
    // The first one replaces the value of the scene.
    assert!(found[0].starts_with("test: C4 k2 ") && found[0].ends_with(" -> 800 N/m"), "{found:?}");
    assert_eq!(found[1..], expected);
    let table = file.with_extension("tables");
    std::fs::create_dir_all(&table).expect("a folder");
    export_csv(&recording, &table, &Selection::default()).expect("tables");
    let events = std::fs::read_to_string(table.join("events.csv")).expect("events");
    let rows: Vec<_> = events.lines().filter(|row| row.contains(",change,")).collect();
    assert_eq!(rows.len(), found.len(), "{rows:?}");
    let ticks = rows.iter().map(|row| row.split(',').nth(1).and_then(|it| it.parse().ok()));
    let ticks: Vec<u64> = ticks.map(|tick| tick.expect("a tick")).collect();
    assert!(ticks.is_sorted() && 0 < ticks[20], "{ticks:?}");
    for (row, text) in rows.iter().zip(&found) {
        assert!(row.ends_with(text), "{row} is not {text}");
    }
    assert!(rows[..20].iter().all(|row| row.contains(",39,change,")), "{rows:?}");
}

/// Asks until the host runs.
fn ask_running(requests: &RequestHandler, request: &Request) -> Result<Reply, String> {
    loop {
        match requests.answer(request, "test") {
            Err(why) if why.contains("not running yet") => std::thread::yield_now(),
            answer => return answer,
        }
    }
}

/// Records a run in real time in which keys are pressed, retuned and replaced.
fn tuned(scene: &Scene, options: RunOptions, file: &Path) {
    let session = RunSession::prepare(scene, options, &|_| {}).expect("a session");
    let _recording = begin(&session, file);
    let requests = RequestHandler::new(scene.clone(), session.handle(), Folders::default());
    let ask = |request: Request| ask_running(&requests, &request).expect("done");
    std::thread::scope(|scope| {
        let run = scope.spawn(|| session.run(&AtomicBool::new(false)));
        let mass = |value| Request::Set {
            changes: vec![Change { key: 39, parameter: "k2".into(), value }],
        };
        for n in 0..20 {
            ask(mass(800.0 + f64::from(n)));
            ask(Request::Press { key: 39, newtons: f64::from(n % 5) * 2.0 });
            std::thread::sleep(std::time::Duration::from_millis(20));
        }
        ask(Request::UseInstrument {
            instrument: "spring-wall".into(),
            keys: Some("C4..E4".into()),
        });
        run.join().expect("no panic").expect("a report");
    });
}

const HELD: std::ops::Range<u8> = 39..44;

/// Records a run in real time, without a pianist, whose settings change while keys are held.
fn changed_settings(scene: &Scene, file: &Path) {
    let session = session(scene);
    let _recording = begin(&session, file);
    let requests = RequestHandler::new(scene.clone(), session.handle(), Folders::default());
    let ask = |request: &Request| ask_running(&requests, request);
    let set = |settings: &[(&str, &str)]| {
        let setting = |it: &(&str, &str)| RenderSetting { name: it.0.into(), value: it.1.into() };
        ask(&Request::Render { settings: settings.iter().map(setting).collect() })
    };
    let written = || match ask(&Request::Scene {}) {
        Ok(Reply::Scene { toml }) => toml,
        other => unreachable!("{other:?}"),
    };
    let report = run_while(session, || {
        for key in HELD {
            ask(&Request::Press { key, newtons: 6.0 }).expect("pressed");
        }
        // Long after the strikes; a slow host strikes later, and rows count from then on.
        std::thread::sleep(std::time::Duration::from_millis(700));
        let margin = |key| match ask(&Request::Margin { key }) {
            Ok(Reply::Done { text }) => text,
            other => format!("{other:?}"),
        };
        assert!(margin(39).contains("stable, up to "), "{}", margin(39));
        assert!(margin(88).contains("there is no key 88"), "{}", margin(88));
        set(&[("render.passivity", "control")]).expect("stable");
        set(&[("render.coupling_stiffness", "\"2 kN/m\""), ("render.coupling_damping", "4")])
            .expect("stable");
        set(&[("render.estimator", "filtered-difference")]).expect("stable");
        let scene = written();
        let said = ["\"control\"", "\"filtered-difference\"", "coupling_stiffness = 2000.0"];
        assert!(said.iter().all(|it| scene.contains(it)), "{scene}");
        let wrong = set(&[("render.lead", "\"1 ms\""), ("render.leads", "1"), ("lanes", "2")]);
        let wrong = wrong.expect_err("wrong names");
        assert!(wrong.contains("\"leads\"") && wrong.contains("\"lanes\" does not"), "{wrong}");
        let unstable = set(&[("render.passivity", "observe"), ("render.force_gain", "50")]);
        let unstable = unstable.expect_err("not stable");
        assert!(unstable.contains("finger at 1000 Hz"), "{unstable}");
        assert_eq!(written(), scene, "what is refused changes nothing");
        set(&[("render.coupling_stiffness", "0"), ("render.passivity", "observe")])
            .expect("stable");
        std::thread::sleep(std::time::Duration::from_millis(300));
    });
    assert_eq!(report.totals.faults, 0);
}

#[test]
fn settings_that_change_while_keys_are_held_sound_no_note_and_make_no_step_of_force() {
    let file = folder("settings").join("a.mcap");
    let scene = scene("springs", &[SILENT]);
    changed_settings(&scene, &file);
    let messages = messages(&file);
    let strike = |it: &Result<Update, String>| match it {
        Ok(Update::Event(it)) if it.kind() == telemetry::event::Kind::Strike => Some(it.tick),
        Ok(_) | Err(_) => None,
    };
    let strikes: Vec<_> = messages.iter().filter_map(strike).collect();
    assert_eq!(strikes.len(), HELD.len(), "each key was struck once");
    // From then on a finger holds each key: changes are blended in over 20 ms.
    let held = strikes.into_iter().max().expect("a strike") + 500;
    let mut last = [None::<f64>; 88];
    let mut voices = std::collections::BTreeSet::new();
    for message in &messages {
        let Ok(Update::Block(block)) = message else { continue };
        let last = &mut last[usize::try_from(block.key).expect("a key")];
        let ticks = block.after.iter().map(|after| block.tick + u64::from(*after));
        let rows = ticks.zip(&block.sent).zip(&block.revision);
        for ((_tick, force), voice) in rows.filter(|((tick, _), _)| held <= *tick) {
            let step = last.replace(*force).map_or(0.0, |last| (force - last).abs());
            assert!(step < 1.0, "key {} at {force} N steps by {step} N", block.key);
            voices.insert((block.key, *voice));
        }
    }
    let n_voices = voices.iter().filter(|(key, _)| *key == u32::from(HELD.start)).count();
    assert!(2 < n_voices, "{n_voices} voices were heard on a held key");
    let replayed = replay(messages.into_iter(), |_| {}).expect("a replay");
    assert_eq!(replayed.first_difference, None);
}

/// Played keys of a run whose ticks may take as long as some of them need.
const PLAYED: std::ops::Range<u8> = 30..50;

#[test]
fn keys_at_rest_get_a_lower_fidelity_under_overload_and_it_is_undone_when_the_load_falls() {
    let file = folder("overload").join("a.mcap");
    let scene = scene("default", &[SILENT, ("overload.evaluations", "150")]);
    let session = session(&scene);
    let recording = begin(&session, &file);
    let requests = RequestHandler::new(scene.clone(), session.handle(), Folders::default());
    let requests = std::sync::Arc::new(requests);
    let ask = |request: &Request| requests.answer(request, "test");
    let lowered = || {
        let Ok(Reply::Scene { toml }) = ask(&Request::Scene {}) else { return Vec::new() };
        let now = Scene::from_text(&scene::Library::default(), "now", toml).expect("as it plays");
        let models = now.keys.iter().zip(&scene.keys).enumerate();
        let is_other = |(now, first): &(&Option<_>, &Option<scene::KeyVoice>)| {
            let model = |voice: &Option<scene::KeyVoice>| voice.as_ref().map(|it| it.model.name);
            model(now) != model(first)
        };
        models.filter(|(_key, pair)| is_other(pair)).map(|(key, _pair)| key).collect()
    };
    let press = |newtons: f64| {
        PLAYED.map(|key| ask(&Request::Press { key, newtons })).all(|answer| answer.is_ok())
    };
    let report = run_while(session, || {
        let _load = follow_load(requests.clone()).expect("a thread");
        let mut newtons = 12.0;
        eventually("60 keys with a lower fidelity", || {
            newtons = 12.0 - newtons;
            // The host may not be running yet.
            let _early = press(newtons);
            std::thread::sleep(std::time::Duration::from_millis(25));
            (60 <= lowered().len()).then_some(())
        });
        assert!(press(0.0), "all are let go");
        eventually("every fidelity", || lowered().is_empty().then_some(()));
    });
    // A voice that had to wait for its lane may be cut off, which its replay repeats.
    let is_in_time = report.deadline.missed == 0;
    assert!(!is_in_time || report.totals.faults == 0, "{} faults", report.totals.faults);
    assert_eq!(recording.report().trouble, None);
    let left_out: Vec<_> = report.overload.left_out.iter().map(|it| it.what).collect();
    assert_eq!(left_out, ["telemetry", "slopes", "rest", "steps", "fidelity"]);
    let replayed = again(&file).expect("a replay");
    assert_eq!(replayed.first_difference, None);
    assert!(0 < replayed.strikes && 0 < replayed.compared, "{replayed:?}");
}

#[test]
fn what_is_no_recording_of_a_whole_run_is_refused_in_a_sentence() {
    let nothing = replay(std::iter::empty(), |_| {}).expect_err("nothing");
    assert!(nothing.to_string().contains("no catalogue"));
    let file = folder("middle").join("a.mcap");
    record(&ode_to_joy(), FOUR_SECONDS, &file);
    // Without its first second it begins in the middle of a run.
    let is_late = |message: &Result<Update, String>| match message {
        Ok(Update::Block(block)) => 1000 <= block.tick,
        Ok(Update::Ticks(ticks)) => 1000 <= ticks.tick,
        Ok(Update::Event(event)) => 1000 <= event.tick,
        Ok(_) | Err(_) => true,
    };
    let middle = replay(messages(&file).into_iter().filter(is_late), |_| {}).expect_err("middle");
    assert!(matches!(middle, ReplayError::Middle(_)), "{middle}");
}
