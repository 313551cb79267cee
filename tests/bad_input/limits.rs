//! System limits below a run's needs, and pipes without a writer or reader.

use std::process::Command;

use crate::letoff::{self, Said, check, check_words, folder, run_after, run_as_nobody};

const RUN: [&str; 6] = ["run", "springs", "--performance", "none", "--duration", "0.1"];

#[track_caller]
fn check_refused(said: &Said) {
    assert_eq!((said.code, said.lines().len()), (Some(1), 1), "{said:?}");
    check_words(said, &["the system refused", "see `ulimit -a`"]);
}

#[test]
fn too_few_descriptors_are_said_in_a_sentence() {
    let folder = folder("descriptors");
    // Descriptors that the caller left open would take the places.
    let closed = "exec 3>&- 4>&- 5>&- 6>&- 7>&- 8>&- 9>&-";
    for most in 5..16 {
        check_refused(&run_after(&format!("{closed}; ulimit -n {most}"), &folder, &RUN));
    }
}

#[test]
fn too_few_threads_are_said_in_a_sentence() {
    for most in 2..5 {
        // `-u` in bash, `-p` in dash.
        let first = format!("ulimit -u {most} 2>/dev/null || ulimit -p {most}");
        if let Some(said) = run_as_nobody(&first, &RUN) {
            check_refused(&said);
        }
    }
}

#[test]
fn pipes_that_nobody_writes_or_reads_are_not_waited_for() {
    let folder = folder("pipes");
    for pipe in ["input", "played.mid"] {
        let made = Command::new("mkfifo").arg(folder.join(pipe)).output();
        assert!(made.is_ok() && folder.join(pipe).exists(), "{made:?}");
    }
    let simulate = ["simulate", "bouncing-ball", "--until", "0.01", "--step", "1e-3"];
    let simulate = [&simulate[..], &["--input", "input"]].concat();
    check(&folder, &simulate, 2, &["input has 0 rows"]);
    let said = run_after("printf 't,s\\n0,0\\n1,0\\n' > input &", &folder, &simulate);
    assert_eq!(said.code, Some(0), "{said:?}");
    let run = ["run", "--virtual-time", "--duration", "1", "--midi", "played.mid"];
    check(&folder, &run, 2, &["played.mid is a pipe", "raw:played.mid"]);
    let checked = letoff::run(&folder, &["check", "input"]);
    assert_eq!(checked.code, Some(2), "{checked:?}");
    check_words(&checked, &["input:1:1: this is neither a scene nor"]);
    check(&folder, &["instruments", "./input"], 2, &["input"]);
    check(&folder, &["replay", "input"], 2, &["input cannot be read: it is a folder, a pipe or"]);
    check(&folder, &["recover", "input"], 2, &["input cannot be read: it is a folder, a pipe or"]);
    let stream = ["run", "--duration", "1", "--listen", "127.0.0.1:0"];
    let tokens = [&stream[..], &["--tokens", "input"]].concat();
    check(&folder, &tokens, 2, &["input"]);
    let tls = [&tokens[..5], &["--tls", "input,input"]].concat();
    check(&folder, &tls, 2, &["input cannot be read: it is a folder, a pipe or"]);
}
