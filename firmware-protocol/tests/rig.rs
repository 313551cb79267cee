//! Each fault of the rig in `c/rig` has its documented effect, on the wire and in the report.

use std::collections::BTreeSet;
use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::path::Path;
use std::process::{Child, Command, Stdio};

use firmware_protocol::acyclic::health::{
    BoardHealth, KeyHealth, MuteKey, ReadKeyHealth, key_fault,
};
use firmware_protocol::acyclic::log::{LogLine, ReadLog};
use firmware_protocol::acyclic::ping::Pong;
use firmware_protocol::acyclic::{Operation, Status};
use firmware_protocol::frame::FrameKind;
use firmware_protocol::frame::broadcast::{self, Broadcast};
use firmware_protocol::frame::hello::{Hello, Introduction, feature, safe_reason};
use firmware_protocol::frame::key_samples::KeySamples;
use firmware_protocol::sequence::FrameOrder;
use firmware_protocol::serial::{self, Deframer};
use firmware_protocol::version::PROTOCOL_VERSION;
use firmware_protocol::{Nothing, Record as _};

use crate::rig_host::{
    Arrival, KEYS, Law, Report, Rig, START_US, TICK_US, build, first_key, new_report, program,
    readme,
};
use crate::tools::{run, scratch};

const BOTTOM: i32 = 10_160;
/// Spring constant of the host (N/m).
const SPRING: f64 = 150.0;
/// Duration of each gesture of the script `mixed` (ms).
const CYCLE: u32 = 6_000;

/// Renders a spring, and a damper of 2 N s/m.
fn spring(samples: &KeySamples) -> [i32; KEYS] {
    let (positions, velocities) = (samples.positions.as_slice(), samples.velocities.as_slice());
    let speed = |slot: usize| i32::from(velocities[slot].get());
    core::array::from_fn(|slot| positions[slot].get() * 150 / 1_000 + speed(slot) * 4 / 10)
}

fn nothing(_: &KeySamples) -> [i32; KEYS] {
    [0; KEYS]
}

fn down(_: &KeySamples) -> [i32; KEYS] {
    [-2_000; KEYS]
}

fn played(fault: &str, law: Law) -> Option<Rig> {
    let mut rig = Rig::start(&["--fault", fault])?;
    rig.play(law, CYCLE);
    Some(rig)
}

/// Returns a rig without fingers, 300 ms after the host began to press its keys.
fn pressed(fault: &[&str]) -> Option<Rig> {
    let mut rig = Rig::start(&[&["--finger", "none"], fault].concat())?;
    rig.play(down, 300);
    Some(rig)
}

/// Returns the position of the key in slot 0 in the newest samples (um).
fn place(rig: &Rig) -> i32 {
    first_key(&rig.samples().last().expect("samples").1).0
}

fn missing(rig: &Rig) -> usize {
    let samples = rig.samples();
    let gap = |pair: &[(u64, KeySamples)]| {
        let order = pair[1].1.header.sequence.after(pair[0].1.header.sequence);
        if let FrameOrder::Newer { missing } = order { usize::from(missing) } else { 0 }
    };
    samples.windows(2).map(gap).sum()
}

#[track_caller]
fn check_share(part: f64, whole: f64, share: f64) {
    assert!((part / whole - share).abs() < 0.03, "{part} of {whole}");
}

#[test]
fn without_faults_the_rig_takes_every_force_and_hands_out_what_the_spring_stores() {
    let Some(mut rig) = Rig::start(&[]) else { return };
    rig.play(spring, CYCLE);
    assert_eq!((rig.corrupt, missing(&rig)), (0, 0));
    let hello = rig.hellos()[0];
    assert_eq!((hello.uid, hello.reset_reason), (*b"RIG\0\0\0", 1));
    assert_eq!((usize::from(hello.n_keys), hello.first_key), (KEYS, 39));
    let health: BoardHealth = rig.get(Operation::BoardHealth, &Nothing);
    assert_eq!(health, BoardHealth { boots: 1, homed: 0b1111, faults: 0, muted: 0 });
    let (sent, report) = (rig.sent, rig.end());
    assert!(sent as f64 - report.number("forces") < 3.0);
    for counter in ["refused", "stale", "unsent", "trips", "restarts", "muted"] {
        assert_eq!(report.text(counter), "0", "{counter}");
    }
    assert_eq!((report.text("faults"), report.text("armings")), ("[]", "1"));
    assert_eq!(
        (report.text("force_after_fault_s"), report.text("last_force_s")),
        ("0.0000", "null")
    );
    let stored = 0.5 * SPRING * f64::from(BOTTOM + 1_000).powi(2) * 1e-9;
    let handed_out = report.number("handed_out_mj");
    assert!((1.0..stored).contains(&handed_out), "{handed_out} mJ, {stored} mJ are stored");
    assert!(report.number("work_mj") < 0.0, "the damper takes work");
}

#[test]
fn runs_with_one_seed_are_alike_bit_by_bit_and_others_are_not() {
    let faults = ["--fault", "noise", "--fault", "drop", "--fault", "jitter", "--seed"];
    let bytes = |seed: &str| {
        let mut rig = Rig::start(&[&faults[..], &[seed]].concat())?;
        rig.play(spring, 2_000);
        Some(std::mem::take(&mut rig.bytes))
    };
    let (Some(first), Some(again), Some(other)) = (bytes("5"), bytes("5"), bytes("6")) else {
        return;
    };
    assert!(first == again, "one seed, two runs");
    assert!(first != other, "two seeds, one run");
}

#[test]
fn the_sanitizers_find_nothing() {
    let flags = "-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all";
    let Some(program) = build("sanitized", flags) else { return };
    for fault in names(&run(Command::new(&program).arg("--faults")).stdout) {
        let mut rig = Rig::start_program(&program, &["--fault", &fault, "--from", "0.1"]);
        rig.play(spring, 400);
        let _report = rig.end();
    }
}

#[test]
fn a_killed_rig_leaves_a_report() {
    let Some(mut rig) = Rig::start(&[]) else { return };
    rig.play(spring, 2_500);
    let report = rig.kill();
    assert!((1.5..2.6).contains(&report.number("since_first_arm_s")));
}

fn names(table: &[u8]) -> Vec<String> {
    let table = String::from_utf8_lossy(table);
    table.lines().filter_map(|line| line.split('`').nth(1)).map(str::to_owned).collect()
}

#[test]
fn every_fault_is_in_the_readme_and_in_these_tests() {
    let Some(program) = program() else { return };
    let table = run(Command::new(program).arg("--faults")).stdout;
    let readme = readme();
    let (_, rows) =
        readme.split_once("| fault | value | meaning |\n|---|---|---|\n").expect("rows");
    let (rows, _) = rows.split_once("\n\n").expect("their end");
    assert_eq!(
        String::from_utf8_lossy(&table).trim_end(),
        rows,
        "paste the output of `rig --faults`"
    );
    let tests = include_str!("rig.rs");
    for name in names(&table) {
        let is_tested =
            tests.contains(&format!("\"{name}\"")) || tests.contains(&format!("\"{name}="));
        assert!(is_tested, "{name}");
    }
}

#[test]
fn unknown_faults_and_impossible_values_are_rejected() {
    let Some(program) = program() else { return };
    for fault in ["haf", "half=1", "half=x", "half=nan", "echo=1", ""] {
        let output = Command::new(program).args(["--fault", fault]).output().expect("it starts");
        assert_eq!(output.status.code(), Some(2), "{fault}");
        assert!(!output.stderr.is_empty(), "{fault}");
    }
}

#[test]
fn behind_a_terminal_hosts_come_and_go_until_the_rig_is_stopped() {
    let Some(program) = program() else { return };
    let link = scratch(&format!("rig_link_{}", std::process::id()));
    let report = new_report();
    let mut command = Command::new(program);
    command.arg("--link").arg(&link).arg("--report").arg(&report).stdout(Stdio::piped());
    let mut rig = Running(command.spawn().expect("it starts"));
    let mut path = String::new();
    let stdout = rig.0.stdout.take().expect("piped");
    BufReader::new(stdout).read_line(&mut path).expect("a line");
    assert_eq!(std::fs::read_link(&link).expect("a link"), Path::new(path.trim()));
    for _ in 0..2 {
        check_hello(&link);
    }
    run(Command::new("kill").arg(rig.0.id().to_string()));
    assert!(rig.0.wait().expect("it ends").success());
    assert!(!link.exists());
    assert_eq!(Report::read(&report).text("since_first_arm_s"), "null");
}

struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _already_ended = self.0.kill();
        let _status = self.0.wait();
    }
}

#[track_caller]
fn check_hello(path: &Path) {
    let terminal = std::fs::OpenOptions::new().read(true).write(true).open(path);
    let mut terminal = terminal.expect("a terminal");
    let mut frame = [0; broadcast::MAX_LEN];
    let len = Broadcast::WhoIsThere { version: PROTOCOL_VERSION }.encode(&mut frame);
    let mut wire = [0; serial::MAX_WIRE];
    let len = serial::encode(&frame[..len], &mut wire).expect("a frame");
    terminal.write_all(&wire[..len]).expect("it reads");
    let mut deframer = Deframer::default();
    let hello = BufReader::new(terminal).bytes().find_map(|byte| {
        let frame = deframer.push(byte.expect("it answers"))?;
        Some(Introduction::decode(frame.expect("a whole frame")).expect("a hello"))
    });
    assert_eq!(hello.map(|it| it.hello.uid), Some(*b"RIG\0\0\0"));
}

#[test]
fn half_sends_every_second_frame_without_a_gap_in_the_numbers() {
    let Some(rig) = played("half", spring) else { return };
    let samples = rig.samples();
    let stamps = samples
        .windows(2)
        .map(|pair| pair[1].1.header.stamp_us.wrapping_sub(pair[0].1.header.stamp_us));
    assert!(stamps.skip(1).all(|it| it == 2_000));
    assert_eq!(missing(&rig), 0);
    let report = rig.end();
    check_share(samples.len() as f64, CYCLE.into(), 0.5);
    assert!(2_990.0 < report.number("forces") && report.text("stale") == "0");
    let Some(rig) = played("half=5", spring) else { return };
    check_share(rig.samples().len() as f64, CYCLE.into(), 0.2);
}

#[test]
fn burst_holds_bytes_back_and_sends_them_at_once() {
    let Some(rig) = played("burst=16", spring) else { return };
    let samples = rig.samples();
    let mut times: Vec<_> = samples.iter().map(|(at_us, _)| *at_us).collect();
    times.dedup();
    assert!(times.iter().all(|at_us| at_us % 16_000 == 0));
    check_share(times.len() as f64, samples.len() as f64, 1.0 / 16.0);
}

#[test]
fn latency_and_jitter_delay_bytes_both_ways() {
    for (arguments, ticks) in
        [(["--latency", "0"], 1), (["--latency", "2000"], 4), (["--fault", "latency"], 4)]
    {
        let Some(mut rig) = Rig::start(&arguments) else { return };
        let asked_us = rig.now_us;
        let _pong: Pong = rig.get(Operation::Ping, &Nothing);
        assert_eq!(rig.now_us - asked_us, ticks * TICK_US, "{arguments:?}");
    }
    let Some(rig) = played("latency=3000", spring) else { return };
    assert!(rig.samples().iter().all(|it| age_us(it) == 3_000));
    let Some(rig) = played("jitter", spring) else { return };
    let ages: BTreeSet<_> = rig.samples().iter().map(age_us).collect();
    assert!(ages.iter().all(|it| [0, 1_000, 2_000].contains(it)), "{ages:?}");
    assert!(ages.contains(&1_000) && ages.contains(&2_000), "{ages:?}");
}

/// Returns the time from reading samples to their arrival (us), by the board's clock at power on.
fn age_us((at_us, samples): &(u64, KeySamples)) -> u64 {
    let clock_us = at_us - START_US;
    (clock_us + 0x1_0000 - u64::from(samples.header.stamp_us)) % 0x1_0000
}

#[test]
fn drop_and_dropdown_lose_their_share_of_the_frames() {
    let Some(rig) = played("drop", spring) else { return };
    check_share(missing(&rig) as f64, CYCLE.into(), 0.3);
    assert_eq!(rig.corrupt, 0);
    let Some(rig) = played("dropdown=0.1", spring) else { return };
    assert_eq!(missing(&rig), 0);
    let (sent, report) = (rig.sent, rig.end());
    check_share(report.number("forces"), sent as f64, 0.9);
}

#[test]
fn corrupt_inverts_bits_both_ways() {
    let Some(rig) = played("corrupt", spring) else { return };
    let (corrupt, sent) = (rig.corrupt, rig.sent);
    // 28 bytes with samples of four keys, 16 bytes with their forces; 1 bit in 2000 is inverted.
    let whole = |bytes: i32| (1.0_f64 - 5e-4).powi(8 * bytes);
    check_share(corrupt as f64, CYCLE.into(), 1.0 - whole(28));
    check_share(rig.end().number("forces"), sent as f64, whole(16));
}

#[test]
fn echo_returns_the_host_s_own_bytes() {
    let Some(rig) = played("echo", spring) else { return };
    let own = |it: &&Arrival| FrameKind::of(&it.frame) == Some(FrameKind::KeyForces);
    let echoed = rig.arrivals.iter().filter(own).count();
    assert!(rig.sent - echoed <= 1, "{echoed} of {}", rig.sent);
    assert_eq!(rig.end().text("refused"), "0");
}

#[test]
fn text_and_boottext_stand_in_front_of_frames() {
    let Some(rig) = played("text", spring) else { return };
    assert_eq!(rig.corrupt, (rig.arrivals.len() + rig.corrupt) / 16);
    let Some(mut rig) = Rig::start(&["--fault", "boottext"]) else { return };
    rig.run(10);
    assert!(rig.bytes.starts_with(b"ets Jul"));
    assert_eq!((rig.corrupt, rig.hellos().len()), (1, 0));
    rig.play(spring, 100);
    assert_eq!(rig.corrupt, 1);
}

#[test]
fn repeat_sends_each_frame_twice() {
    let Some(rig) = played("repeat", spring) else { return };
    let samples = rig.samples();
    assert!(samples.chunks_exact(2).all(|pair| pair[0] == pair[1]));
    assert!(2 * CYCLE as usize <= samples.len());
}

#[test]
fn wronglen_and_stale_take_no_forces_and_count_them() {
    for (fault, counter, other) in [("wronglen", "refused", "stale"), ("stale", "stale", "refused")]
    {
        let Some(rig) = played(fault, spring) else { return };
        let (sent, report) = (rig.sent, rig.end());
        assert!(sent as f64 - report.number(counter) < 3.0, "{fault}");
        assert_eq!((report.text("forces"), report.text(other)), ("0", "0"));
        assert_eq!(report.text("largest_force_n"), "0.000000", "{fault}");
    }
}

#[test]
fn drift_makes_the_clock_too_fast() {
    let Some(mut rig) = Rig::start(&["--fault", "drift=-4000"]) else { return };
    let first: Pong = rig.get(Operation::Ping, &Nothing);
    rig.run(9_999);
    let last: Pong = rig.get(Operation::Ping, &Nothing);
    assert!((last.board_us - first.board_us).abs_diff(9_960_000) <= 1);
}

#[test]
fn oldminor_knows_nothing_of_2_2() {
    let Some(mut rig) = Rig::start(&["--fault", "oldminor"]) else { return };
    let hello = rig.hellos()[0];
    assert_eq!((hello.major, hello.minor, hello.features & feature::HEALTH), (2, 0, 0));
    assert_eq!(rig.ask(Operation::BoardHealth, &Nothing), (Status::Unknown, Vec::new()));
    let mute = MuteKey { slot: 0, muted: 1 };
    assert_eq!(rig.ask(Operation::MuteKey, &mute).0, Status::Unknown);
    rig.play(spring, 100);
}

#[test]
fn a_motor_that_is_turned_dead_weak_or_stuck_does_as_it_is_called() {
    let Some(honest) = pressed(&[]) else { return };
    assert!((place(&honest) - BOTTOM - 28).abs() < 5, "2 N press the felt");
    assert!((honest.end().number("largest_force_n") - 2.0).abs() < 0.01);
    let turned = pressed(&["--fault", "motorsign"]).expect("a compiler");
    assert!((place(&turned) + 33).abs() < 5, "2 N up press the upper felt");
    let dead = pressed(&["--fault", "deadmotor"]).expect("a compiler");
    assert_eq!((place(&dead), dead.end().text("largest_force_n")), (0, "0.000000"));
    let weak = pressed(&["--fault", "weak"]).expect("a compiler");
    assert!((weak.end().number("largest_force_n") - 1.0).abs() < 0.01);
    let mut stuck =
        Rig::start(&["--finger", "none", "--fault", "stuck", "--from", "1"]).expect("a compiler");
    stuck.play(nothing, 990);
    assert_eq!(place(&stuck), 0);
    stuck.run(1_010);
    assert!((place(&stuck) - BOTTOM - 128).abs() < 5, "8 N press the felt");
    let report = stuck.end();
    assert_eq!(
        (report.text("largest_force_n"), report.text("largest_step_n")),
        ("8.000000", "0.000000")
    );
    assert!((report.number("force_after_fault_s") - 1.0).abs() < 0.01);
    assert!((report.number("last_force_s") - 1.0).abs() < 0.01);
    assert!(report.number("handed_out_mj") > 75.0, "8 N over 10 mm");
}

#[test]
fn slowmotor_follows_with_its_bandwidth() {
    let risen = |fault: &[&str]| {
        let mut rig = Rig::start(&[&["--finger", "hold"], fault].concat())?;
        assert_eq!(rig.arm(|_| [500; KEYS]), Status::Done);
        rig.run(4);
        let health: KeyHealth = rig.get(Operation::KeyHealth, &ReadKeyHealth { slot: 0 });
        Some(f64::from(health.current) / 1_000.0 * 3.0 / 0.5)
    };
    let (Some(honest), Some(slow)) = (risen(&[]), risen(&["--fault", "slowmotor"])) else { return };
    assert!((honest - 1.0).abs() < 0.01, "{honest}");
    // 30 Hz corresponds to a time constant of 5.3 ms.
    assert!((0.4..0.75).contains(&slow), "{slow}");
}

#[test]
fn cogging_depends_on_the_place() {
    let Some(mut rig) = Rig::start(&["--finger", "slow", "--fault", "cogging"]) else { return };
    rig.play(nothing, 2_000);
    let report = rig.end();
    assert!((report.number("largest_force_n") - 0.15).abs() < 0.001);
    // Over half of a period, 2/π of the amplitude: never more, since that is conservative.
    let most = 0.15 * 1.2 / std::f64::consts::PI;
    assert!((report.number("handed_out_mj") - most).abs() < 0.1 * most);
}

#[test]
fn mutelies_says_that_a_key_is_muted_and_renders_on() {
    for (faults, is_pressed) in [(&[][..], false), (&["--fault", "mutelies"], true)] {
        let Some(mut rig) = Rig::start(&[&["--finger", "none"], faults].concat()) else { return };
        let _done: Nothing = rig.get(Operation::MuteKey, &MuteKey { slot: 0, muted: 1 });
        let health: BoardHealth = rig.get(Operation::BoardHealth, &Nothing);
        assert_eq!(health.muted, 1);
        rig.play(down, 300);
        assert_eq!(BOTTOM < place(&rig), is_pressed);
        assert_eq!(rig.end().text("muted"), "1");
    }
}

/// Returns positions and velocities of slot 0 in every frame. The host renders nothing, so the
/// finger moves the key along the same path for every encoder.
fn readings(arguments: &[&str]) -> Option<Vec<(i32, i32)>> {
    let mut rig = Rig::start(arguments)?;
    rig.play(nothing, CYCLE);
    Some(rig.samples().iter().map(|(_, samples)| first_key(samples)).collect())
}

fn pairs(fault: &str) -> Option<Vec<[(i32, i32); 2]>> {
    let (honest, faulty) = (readings(&[])?, readings(&["--fault", fault])?);
    assert_eq!(honest.len(), faulty.len());
    Some(honest.into_iter().zip(faulty).map(|(honest, faulty)| [honest, faulty]).collect())
}

#[test]
fn an_encoder_that_is_turned_or_wrongly_scaled_reads_multiples_and_velocities_may_be_so_alone() {
    // Factors of position and velocity, and their error: both are rounded separately.
    for (fault, place, velocity, error) in [
        ("encsign", -1, -1, (2, 2)),
        ("scale", 2, 2, (2, 2)),
        ("scale=-3", -3, -3, (2, 2)),
        ("velsign", 1, -1, (0, 1)),
        ("velzero", 1, 0, (0, 1)),
        ("velscale", 1, 2, (0, 1)),
    ] {
        let Some(pairs) = pairs(fault) else { return };
        assert!(pairs.iter().any(|[honest, _]| 1_000 < honest.1));
        for [honest, faulty] in pairs {
            let found = (faulty.0 - place * honest.0, faulty.1 - velocity * honest.1);
            let is_near = found.0.abs() <= error.0 && found.1.abs() <= error.1;
            assert!(is_near, "{fault}: {found:?}");
        }
    }
}

#[test]
fn spikes_hit_one_sample_in_fifty() {
    for (fault, um) in [("spike", 300), ("bigspike", 2_000), ("spike=-70", -70)] {
        let Some(pairs) = pairs(fault) else { return };
        let hit = pairs.iter().filter(|[honest, faulty]| honest.0 != faulty.0).count();
        assert!(pairs.iter().all(|[honest, faulty]| [0, um].contains(&(faulty.0 - honest.0))));
        assert!((80..160).contains(&hit), "{hit} of {}", pairs.len());
    }
}

#[test]
fn noise_stays_within_its_bounds() {
    let Some(pairs) = pairs("noise") else { return };
    let differences: Vec<_> = pairs.iter().map(|[honest, faulty]| faulty.0 - honest.0).collect();
    assert!(differences.iter().all(|it| it.abs() <= 21));
    assert!(differences.contains(&19) && differences.contains(&-19));
}

#[test]
fn shift_slips_once_when_it_begins() {
    let (Some(honest), Some(faulty)) =
        (readings(&[]), readings(&["--fault", "shift", "--from", "2"]))
    else {
        return;
    };
    let begins = honest.iter().zip(&faulty).position(|(honest, faulty)| honest != faulty);
    let begins = begins.expect("a slip");
    assert!(begins.abs_diff(2_000) < 5, "{begins}");
    assert!((begins..honest.len()).all(|i| faulty[i].0 - honest[i].0 == 1_000));
}

#[test]
fn frozen_and_jumpy_stay_where_the_fault_began() {
    // The finger moves the key 2.2 s after the start.
    let Some(frozen) = readings(&["--fault", "frozen", "--from", "2.2"]) else { return };
    let last = frozen[frozen.len() - 1];
    let begins = frozen.iter().position(|it| it.0 == last.0).expect("a place");
    assert!(begins.abs_diff(2_200) < 10 && (2_000..9_000).contains(&last.0), "{begins}");
    assert!(frozen[begins + 1..].iter().all(|it| *it == (last.0, 0)));
    let jumpy = readings(&["--fault", "jumpy", "--from", "2.2"]).expect("a compiler");
    let jumps = jumpy[2_300..].windows(2).map(|pair| (pair[1].0 - pair[0].0).abs());
    assert!(jumps.into_iter().all(|it| it == 2_000));
}

fn health(rig: &mut Rig) -> (BoardHealth, KeyHealth) {
    let board = rig.get(Operation::BoardHealth, &Nothing);
    (board, rig.get(Operation::KeyHealth, &ReadKeyHealth { slot: 0 }))
}

#[test]
fn a_hot_key_is_reported_and_driven() {
    let Some(mut rig) = Rig::start(&["--fault", "hot"]) else { return };
    rig.play(spring, CYCLE);
    let (board, key) = health(&mut rig);
    assert_eq!((board.faults, key.fault, key.temperature), (1, key_fault::TOO_HOT, 3_250));
    assert!(1.0 < rig.end().number("largest_force_n"));
}

#[test]
fn overheat_begins_in_the_run() {
    let Some(mut rig) = Rig::start(&["--fault", "overheat", "--from", "1"]) else { return };
    rig.play(spring, 900);
    let (board, key) = health(&mut rig);
    assert_eq!((board.faults, key.fault), (0, key_fault::NONE));
    assert!((200..250).contains(&key.temperature));
    rig.run(200);
    let (board, early) = health(&mut rig);
    assert_eq!((board.faults, early.fault), (1, key_fault::TOO_HOT));
    rig.run(5_000);
    let (_, late) = health(&mut rig);
    assert!(early.temperature < 600 && 1_450 < late.temperature, "{early:?} {late:?}");
}

#[test]
fn keyfault_latches_and_is_in_the_log() {
    let Some(mut rig) = Rig::start(&["--fault", "keyfault", "--from", "1"]) else { return };
    rig.play(spring, 1_100);
    assert_eq!(rig.ask(Operation::Disarm, &Nothing).0, Status::WrongState);
    let (_, record) = rig.ask(Operation::Hello, &Nothing);
    let hello = Hello::take(&record).expect("a hello");
    assert_eq!(hello.safe_reason, safe_reason::KEY_FAULT);
    let first: LogLine = rig.get(Operation::ReadLog, &ReadLog { line: 0 });
    let last: LogLine = rig.get(Operation::ReadLog, &ReadLog { line: first.lines - 1 });
    assert!(last.text.starts_with(b"key 0: too hot\0"));
    let (board, key) = health(&mut rig);
    assert_eq!((board.faults, key.fault), (1, key_fault::TOO_HOT));
}

#[test]
fn nothomed_is_reported() {
    let Some(mut rig) = Rig::start(&["--fault", "nothomed"]) else { return };
    assert_eq!(health(&mut rig).0.homed, 0b1110);
}

fn longest_silence(rig: &Rig) -> u64 {
    let samples = rig.samples();
    samples.windows(2).map(|pair| pair[1].0 - pair[0].0).max().expect("samples")
}

#[test]
fn brown_gives_way_under_the_forces_of_all_keys() {
    let Some(mut rig) = pressed(&["--fault", "brown"]) else { return };
    rig.run(100);
    let hello = *rig.hellos().last().expect("hellos");
    assert_eq!((rig.hellos().len(), hello.reset_reason), (2, 2));
    assert_eq!((hello.safe_reason, health(&mut rig).0.boots), (safe_reason::NEVER_ARMED, 2));
    rig.play(nothing, 100);
    assert!((300_000..420_000).contains(&longest_silence(&rig)));
    let report = rig.end();
    assert_eq!((report.text("restarts"), report.text("armings")), ("1", "2"));
    assert!(report.number("largest_force_n") < 2.0);
}

#[test]
fn restart_bites_again_and_again() {
    let Some(mut rig) = Rig::start(&["--fault", "restart=1"]) else { return };
    rig.run(3_500);
    let hellos = rig.hellos();
    assert_eq!(hellos.iter().map(|it| it.reset_reason).collect::<Vec<_>>(), [1, 3, 3, 3]);
    assert_eq!(health(&mut rig).0.boots, 4);
    assert_eq!(rig.end().text("restarts"), "3");
}

#[test]
fn a_loop_that_hangs_lets_forces_expire_and_goes_on() {
    let Some(mut rig) = Rig::start(&["--finger", "none", "--fault", "hang", "--from", "0.1"])
    else {
        return;
    };
    rig.play(down, 3_500);
    assert!((500_000..510_000).contains(&longest_silence(&rig)));
    assert!(rig.samples().last().expect("samples").1.header.flag);
    assert!(place(&rig).abs() <= 5, "friction holds the key at {} um", place(&rig));
    let report = rig.end();
    assert_eq!((report.text("trips"), report.text("restarts")), ("1", "0"));
    // The loop stops 1.5 s after the fault began; forces end 20 and 10 ms later.
    assert!((report.number("last_force_s") - 1.53).abs() < 0.02);
}
