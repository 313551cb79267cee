use std::path::{Path, PathBuf};

use super::*;

const STEP: Duration = Duration::from_micros(500);

/// Starts a Python program in lockstep that behaves as `how` says, with its report, if possible.
fn start(how: &str) -> Option<(Lockstep, HostClock, PathBuf)> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/links/lockstep/program.py");
    let report = std::env::temp_dir().join(format!("letoff-{}-{how}", std::process::id()));
    let command = format!("python3 -B {} {how} {}", source.display(), report.display());
    let clock = HostClock::virtual_time();
    match Lockstep::start(&command, &clock) {
        Ok(link) => Some((link, clock, report)),
        Err(error) => {
            println!("SKIPPED: a program in lockstep: {error}");
            None
        }
    }
}

#[test]
fn an_exchange_is_made_when_time_has_passed_and_the_last_bytes_arrive_too() {
    let Some((mut link, clock, report)) = start("serves") else { return };
    let (mut buffer, frames) = ([0; 8], [b"one", b"two"]);
    for frame in frames {
        link.try_send(frame).unwrap();
        assert_eq!(link.try_recv(&mut buffer), Ok(None));
        clock.pause(STEP);
        assert_eq!(link.try_recv(&mut buffer), Ok(Some(3)));
        assert_eq!(&buffer[..3], frame);
        assert_eq!(link.try_recv(&mut buffer), Ok(None));
    }
    link.try_send_damaged(b"three").unwrap().unwrap();
    drop(link);
    let told = std::fs::read_to_string(&report).unwrap();
    std::fs::remove_file(report).unwrap();
    // Each frame adds two bytes of checksum, one of stuffing and the closing zero.
    assert_eq!(told, format!("2000 us, {} bytes", 3 * 4 + 3 + 3 + 5));
}

#[track_caller]
fn check_fault(how: &str, words: &str) {
    let Some((mut link, clock, _report)) = start(how) else { return };
    if how == "silent" {
        // The program reads and never answers, so waiting changes nothing.
        link.program.patience_s = 0;
    }
    let mut buffer = [0; 8];
    let mut is_up = |link: &mut Lockstep| {
        clock.pause(STEP);
        link.try_recv(&mut buffer) == Ok(None)
    };
    let n_exchanges = (0..10).take_while(|_| is_up(&mut link)).count();
    assert!(n_exchanges < 2, "{how}");
    assert_eq!(link.try_send(b"x"), Err(SendError::Down));
    let said = link.fault().unwrap().to_string();
    assert!(said.contains(&format!(" {how} ")) && said.contains(words), "{said}");
}

#[test]
fn a_program_that_breaks_the_exchange_takes_its_link_down_and_the_fault_says_how() {
    check_fault("exits", "it ended (exit status: 3)");
    check_fault("silent", "0 of 2 bytes");
    check_fault("chatty", "it wrote more than an answer");
}

#[test]
fn what_cannot_be_started_is_refused() {
    let refusal = |command: &str, clock| Lockstep::start(command, &clock).unwrap_err().to_string();
    let said = refusal("/no/such/rig --lockstep", HostClock::virtual_time());
    assert!(said.contains("`/no/such/rig --lockstep`") && said.contains("started"), "{said}");
    let said = refusal("true", HostClock::Monotonic(|| 0));
    assert!(said.contains("lives in virtual time only"), "{said}");
}
