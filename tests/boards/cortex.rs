//! The reference firmware on emulated Cortex-M3 processors, behind pseudo-terminals.

use std::io::{BufRead as _, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use serde_json::Value;

use crate::letoff;
use crate::machine_time::{Task, WaitWatch, judged_with_time, say};
use crate::rig::{
    count, had_emulated_time, had_host_time, machine, number, print_figures, report, run,
    run_watched,
};

const TOOLS: [&str; 2] = ["arm-none-eabi-gcc", "qemu-system-arm"];

pub(crate) fn has_tools() -> bool {
    if std::env::var_os("LETOFF_MACHINES").is_some_and(|it| it == "none") {
        say("SKIPPED: boards under QEMU are tested by cargo xtask test --machines");
        return false;
    }
    let answers = |tool: &&&str| Command::new(tool).arg("--version").output().is_ok();
    let missing: Vec<_> = TOOLS.iter().filter(|tool| !answers(tool)).collect();
    if !missing.is_empty() {
        say(&format!("SKIPPED: boards under QEMU: not installed: {missing:?}"));
    }
    missing.is_empty()
}

pub(crate) fn build(folder: &Path, board: usize) -> PathBuf {
    let c = Path::new(env!("CARGO_MANIFEST_DIR")).join("firmware-protocol/c");
    let elf = folder.join(format!("board{board}.elf"));
    let sources = std::fs::read_dir(c.join("firmware")).expect("the firmware");
    let mut sources: Vec<_> = sources.map(|file| file.expect("a file").path()).collect();
    sources.retain(|path| path.extension().is_some_and(|end| end == "c"));
    let mut gcc = Command::new("arm-none-eabi-gcc");
    gcc.args(["-mcpu=cortex-m3", "-mthumb", "-O2", "-ffreestanding", "-ffunction-sections"]);
    gcc.args(["-std=c99", "-nostartfiles", "-Wl,--gc-sections"]);
    gcc.arg(format!("-DBOARD={board}")).arg(format!("-DFIRST_KEY={}", 11 * board));
    gcc.arg("-T").arg(c.join("firmware/link.ld")).args(sources).arg(c.join("letoff_codec.c"));
    gcc.args(["--specs=nano.specs", "--specs=nosys.specs", "-lc", "-lgcc", "-o"]).arg(&elf);
    assert!(gcc.status().expect("the compiler").success(), "the firmware cannot be built");
    elf
}

pub(crate) struct Processor {
    qemu: Child,
    pub(crate) port: String,
}

impl Processor {
    pub(crate) fn start(elf: &Path) -> Self {
        let mut command = Command::new("qemu-system-arm");
        command.args(["-M", "lm3s6965evb", "-display", "none", "-monitor", "none"]);
        command.args(["-serial", "pty", "-kernel"]).arg(elf);
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut qemu = command.spawn().expect("QEMU starts");
        let out = qemu.stdout.take().expect("its output");
        // "char device redirected to /dev/pts/3 (label serial0)"
        let mut lines = BufReader::new(out).lines().map_while(Result::ok);
        let named = lines.find_map(|line| {
            let port = line.split(' ').find(|word| word.starts_with("/dev/pts/"))?;
            Some(port.to_owned())
        });
        Self { qemu, port: named.expect("QEMU names its port") }
    }
}

impl Processor {
    pub(crate) fn task(&self) -> Task {
        Task::process(&self.qemu)
    }
}

impl Drop for Processor {
    fn drop(&mut self) {
        let _gone = self.qemu.kill();
        let _status = self.qemu.wait();
    }
}

/// Runs the host; returns the report if `has_time` finds enough time and no board fell silent.
fn drive(
    watch: &WaitWatch,
    folder: &Path,
    elfs: &[PathBuf],
    more: &[&str],
    has_time: fn(&Value) -> bool,
) -> Option<Value> {
    let boards: Vec<_> = elfs.iter().map(|elf| Processor::start(elf)).collect();
    for board in &boards {
        watch.add(board.task());
    }
    let links: Vec<_> = boards
        .iter()
        .flat_map(|board| ["--link".to_owned(), format!("serial:{}", board.port)])
        .collect();
    let report = run(watch, folder, &links, more);
    let is_alive = |board: &Value| count(board, "/rearmed") == 0;
    let boards = report["boards"].as_array().cloned().unwrap_or_default();
    (has_time(&report) && boards.iter().all(is_alive)).then_some(report)
}

#[track_caller]
fn check(what: &str, report: &Value, valid_ms: f64) {
    print_figures(what, report);
    assert_eq!(count(report, "/links/gaps"), 0, "{report}");
    assert_eq!(count(report, "/faults"), 0, "{report}");
    for board in report["boards"].as_array().expect("boards") {
        assert!(number(board, "/counted/oldest_ms") <= valid_ms, "{board}");
        assert_eq!(count(board, "/counted/corrupt"), 0, "{board}");
    }
}

#[test]
fn a_piece_is_played_on_one_cortex_m3() {
    if !has_tools() {
        return;
    }
    let _machine = machine();
    let folder = letoff::folder("boards-cortex");
    let elf = build(&folder, 3);
    let more = ["--duration", "10", "--set", "tick_hz=1000", "--set", "links.valid=0.1"];
    let elfs = [elf];
    judged_with_time("one Cortex-M3", |watch| {
        let report = drive(watch, &folder, &elfs, &more, had_emulated_time)?;
        check("one Cortex-M3 under QEMU, 11 keys at 1 kHz", &report, 101.0);
        let played = count(&report, "/notes/played");
        assert!(2 < played, "{report}");
        assert_eq!(count(&report, "/notes/struck"), played, "{report}");
        Some(())
    });
}

/// The rate is half the default: the instrument is played as written or refused.
#[test]
fn the_default_instrument_at_500_hz_is_played_without_an_extra_strike_or_refused() {
    if !has_tools() {
        return;
    }
    let _machine = machine();
    let folder = letoff::folder("boards-cortex-default");
    let processor = Processor::start(&build(&folder, 3));
    let link = format!("serial:{}", processor.port);
    let run = ["run", "default", "--json", "--link", &link, "--duration", "10"];
    let slow = ["--set", "tick_hz=500", "--set", "links.valid=0.1"];
    let arguments = [run.as_slice(), &slow].concat();
    judged_with_time("the default instrument on a Cortex-M3 at 500 Hz", |watch| {
        watch.add(processor.task());
        let said = run_watched(watch, &folder, &arguments);
        if said.err.contains("with the delay of these links") {
            assert_eq!(said.code, Some(1), "{said:?}");
            letoff::check_words(&said, &["with grand", "at 500 Hz"]);
            say(&format!("refused: {}", said.err));
            return Some(());
        }
        let report = report(&said);
        if !had_emulated_time(&report) {
            return None;
        }
        check("one Cortex-M3 under QEMU, 11 keys of a grand at 500 Hz", &report, 101.0);
        assert_eq!(count(&report, "/notes/extra"), 0, "{report}");
        Some(())
    });
}

/// Two cores can just run eight emulated processors and a host, so no pianist plays.
#[test]
fn eight_cortex_m3_exchange_without_a_gap() {
    if !has_tools() {
        return;
    }
    let _machine = machine();
    let folder = letoff::folder("boards-cortex-8");
    let elfs: Vec<_> = (0..8).map(|board| build(&folder, board)).collect();
    let more = ["--duration", "5", "--set", "tick_hz=250", "--set", "links.valid=0.1"];
    // Forces below stiction: keys that swing would cost the emulators too much.
    let calm = ["--performance", "none", "--set", "render.force_limit=0.1"];
    // A grand's action is unstable at that rate.
    let more = more.into_iter().chain(["--set", "keys.instrument=spring-wall"]);
    let more: Vec<_> = more.chain(calm).collect();
    judged_with_time("eight Cortex-M3", |watch| {
        let report = drive(watch, &folder, &elfs, &more, had_host_time)?;
        check("eight Cortex-M3 under QEMU, 88 keys at 250 Hz", &report, 101.0);
        assert_eq!(report["boards"].as_array().map(Vec::len), Some(8), "{report}");
        Some(())
    });
}
