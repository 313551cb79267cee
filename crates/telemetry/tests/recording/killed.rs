//! A killed host loses one second at most.

use std::env;
use std::io::{BufRead as _, BufReader, Write as _};
use std::process::{Command, Stdio};

use telemetry::recording::{Recorder, Recording};

use crate::common::{at, performance, read, settings};

/// Variable with the path for [`it_records_until_it_is_killed`].
const TO: &str = "LETOFF_TEST_RECORD_TO";

#[test]
fn it_records_until_it_is_killed() {
    let Some(path) = env::var_os(TO) else { return };
    let mut recorder = Recorder::create(settings(path.as_ref())).expect("a new file");
    for (when, update) in performance(100_000) {
        recorder.write(when, &update).expect("written");
        // Not by a macro, whose output a test captures.
        writeln!(std::io::stdout(), "told {when}").expect("somebody listens");
    }
}

#[test]
fn a_killed_host_loses_a_second_at_most() {
    let folder = tempfile::tempdir().expect("a folder");
    for seconds in [1, 3, 10] {
        let path = folder.path().join(format!("{seconds}.mcap"));
        let mut host = Command::new(env::current_exe().expect("this program"))
            .args(["--exact", "recording::killed::it_records_until_it_is_killed", "--nocapture"])
            .env(TO, &path)
            .stdout(Stdio::piped())
            .spawn()
            .expect("a host");
        let lines = BufReader::new(host.stdout.take().expect("its words")).lines();
        let times = |line: String| line.strip_prefix("told ")?.parse().ok();
        let mut told = lines.map_while(Result::ok).filter_map(times);
        let last: u64 = told.find(|told| at(seconds * 1000) <= *told).expect("so far");
        host.kill().expect("killed");
        host.wait().expect("dead");
        // Until now, or it would have ended by itself because the receiver is gone.
        drop(told);
        let recording = Recording::open(&path).expect("a recording");
        let tear = recording.tear().expect("no summary").to_string();
        assert!(tear.contains(" breaks off at byte "), "{tear}");
        let (found, wrong) = read(&recording);
        assert!(wrong.is_empty(), "{wrong:?}");
        assert_eq!(found[..], performance(100_000)[..found.len()]);
        let newest = found.last().expect("messages").0;
        assert!(last <= newest + 1_000_000_000, "{} ns are lost", last - newest);
    }
}
